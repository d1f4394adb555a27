//! Motor joints: what drives one body against another.

use super::def::cookie;
use super::def_check::check_cookie;
use super::guard::needed;
use super::id::{mvJointId, mvWorldId};
use super::joint::{create, get, set};
use super::joint_def::{default_base, mv_motorJoint, mvJointDef};
use super::math::{ZERO3, mvVec3};
use super::mvFloat;
use crate::constraint::joint::{JointKind, MotorJoint};

/// A motor joint: drives frame B against frame A towards a velocity, and by springs towards the place of frame A.
/// Vectors are in the axes of frame A.
/// Made by mvDefaultMotorJointDef().
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvMotorJointDef {
    /// Shows that the definition was made by its function. Leave it alone.
    pub internal_value: i32,
    /// What all joints have.
    pub base: mvJointDef,
    /// The velocity of B that is wanted [m/s]; default 0.
    pub linear_velocity: mvVec3,
    /// The greatest force for it, along each axis [N], >= 0; default 0.
    pub max_velocity_force: mvFloat,
    /// The angular velocity of B that is wanted [rad/s]; default 0.
    pub angular_velocity: mvVec3,
    /// The greatest torque for it, about each axis [N m], >= 0; default 0.
    pub max_velocity_torque: mvFloat,
    /// The frequency of the spring that brings the origins together [Hz], >= 0; default 0: none.
    pub linear_hertz: mvFloat,
    /// Its damping ratio, >= 0; default 1.
    pub linear_damping_ratio: mvFloat,
    /// Its greatest force, along each axis [N], >= 0; default 0.
    pub max_spring_force: mvFloat,
    /// The frequency of the spring that turns the axes along each other [Hz], >= 0; default 0: none.
    pub angular_hertz: mvFloat,
    /// Its damping ratio, >= 0; default 1.
    pub angular_damping_ratio: mvFloat,
    /// Its greatest torque, about each axis [N m], >= 0; default 0.
    pub max_spring_torque: mvFloat,
}

const COOKIE: i32 = cookie::<mvMotorJointDef>(10 + mv_motorJoint as u32);

/// Get the definition of a motor joint with the default values.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultMotorJointDef() -> mvMotorJointDef {
    mvMotorJointDef {
        internal_value: COOKIE,
        base: default_base(),
        linear_velocity: ZERO3,
        max_velocity_force: 0.0,
        angular_velocity: ZERO3,
        max_velocity_torque: 0.0,
        linear_hertz: 0.0,
        linear_damping_ratio: 1.0,
        max_spring_force: 0.0,
        angular_hertz: 0.0,
        angular_damping_ratio: 1.0,
        max_spring_torque: 0.0,
    }
}

/// Create a motor joint. Its bodies wake.
///
/// @param worldId the world that both bodies live in
/// @param def the definition, from mvDefaultMotorJointDef()
/// @return the joint; null for bad arguments
/// @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
/// has no joints.
#[unsafe(no_mangle)]
pub extern "C" fn mvCreateMotorJoint(world_id: mvWorldId, def: Option<&mvMotorJointDef>) -> mvJointId {
    create(world_id, |_| {
        let d = needed("The definition", def)?;
        check_cookie("MotorJoint", d.internal_value, COOKIE)?;
        let kind = MotorJoint {
            linear_velocity: d.linear_velocity.raw(),
            max_velocity_force: d.max_velocity_force,
            angular_velocity: d.angular_velocity.raw(),
            max_velocity_torque: d.max_velocity_torque,
            linear_hertz: d.linear_hertz,
            linear_damping_ratio: d.linear_damping_ratio,
            max_spring_force: d.max_spring_force,
            angular_hertz: d.angular_hertz,
            angular_damping_ratio: d.angular_damping_ratio,
            max_spring_torque: d.max_spring_torque,
        };
        Ok((d.base, JointKind::Motor(kind)))
    })
}

/// Set the velocity that is wanted, in the axes of frame A.
/// @param jointId a motor joint
/// @param velocity the value [m/s]
/// @note Errors: mv_errorNotFinite; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvMotorJoint_SetLinearVelocity(joint_id: mvJointId, velocity: mvVec3) {
    set(joint_id, |j: &mut MotorJoint| {
        j.linear_velocity = velocity.raw();
        Ok(())
    });
}

/// Get the velocity that is wanted, in the axes of frame A.
/// @param jointId a motor joint
/// @return the value [m/s]; zero for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvMotorJoint_GetLinearVelocity(joint_id: mvJointId) -> mvVec3 {
    get(joint_id, |j: &MotorJoint, _| Ok(j.linear_velocity.into()))
}

/// Set the angular velocity that is wanted, in the axes of frame A.
/// @param jointId a motor joint
/// @param velocity the value [rad/s]
/// @note Errors: mv_errorNotFinite; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvMotorJoint_SetAngularVelocity(joint_id: mvJointId, velocity: mvVec3) {
    set(joint_id, |j: &mut MotorJoint| {
        j.angular_velocity = velocity.raw();
        Ok(())
    });
}

/// Get the angular velocity that is wanted, in the axes of frame A.
/// @param jointId a motor joint
/// @return the value [rad/s]; zero for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvMotorJoint_GetAngularVelocity(joint_id: mvJointId) -> mvVec3 {
    get(joint_id, |j: &MotorJoint, _| Ok(j.angular_velocity.into()))
}

/// Set the greatest force for the velocity, along each axis.
/// @param jointId a motor joint
/// @param maxForce the value [N], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvMotorJoint_SetMaxVelocityForce(joint_id: mvJointId, max_force: mvFloat) {
    set(joint_id, |j: &mut MotorJoint| {
        j.max_velocity_force = max_force;
        Ok(())
    });
}

/// Get the greatest force for the velocity, along each axis.
/// @param jointId a motor joint
/// @return the value [N]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvMotorJoint_GetMaxVelocityForce(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &MotorJoint, _| Ok(j.max_velocity_force))
}

/// Set the greatest torque for the angular velocity, about each axis.
/// @param jointId a motor joint
/// @param maxTorque the value [N m], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvMotorJoint_SetMaxVelocityTorque(joint_id: mvJointId, max_torque: mvFloat) {
    set(joint_id, |j: &mut MotorJoint| {
        j.max_velocity_torque = max_torque;
        Ok(())
    });
}

/// Get the greatest torque for the angular velocity, about each axis.
/// @param jointId a motor joint
/// @return the value [N m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvMotorJoint_GetMaxVelocityTorque(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &MotorJoint, _| Ok(j.max_velocity_torque))
}

/// Set the frequency of the spring between the origins.
/// @param jointId a motor joint
/// @param hertz the value [Hz], >= 0; 0 has no effect
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvMotorJoint_SetLinearHertz(joint_id: mvJointId, hertz: mvFloat) {
    set(joint_id, |j: &mut MotorJoint| {
        j.linear_hertz = hertz;
        Ok(())
    });
}

/// Get the frequency of the spring between the origins.
/// @param jointId a motor joint
/// @return the value [Hz]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvMotorJoint_GetLinearHertz(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &MotorJoint, _| Ok(j.linear_hertz))
}

/// Set the damping ratio of the spring between the origins.
/// @param jointId a motor joint
/// @param damping the value >= 0; 1 is critical
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvMotorJoint_SetLinearDampingRatio(joint_id: mvJointId, damping: mvFloat) {
    set(joint_id, |j: &mut MotorJoint| {
        j.linear_damping_ratio = damping;
        Ok(())
    });
}

/// Get the damping ratio of the spring between the origins.
/// @param jointId a motor joint
/// @return the value; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvMotorJoint_GetLinearDampingRatio(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &MotorJoint, _| Ok(j.linear_damping_ratio))
}

/// Set the frequency of the spring between the axes.
/// @param jointId a motor joint
/// @param hertz the value [Hz], >= 0; 0 has no effect
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvMotorJoint_SetAngularHertz(joint_id: mvJointId, hertz: mvFloat) {
    set(joint_id, |j: &mut MotorJoint| {
        j.angular_hertz = hertz;
        Ok(())
    });
}

/// Get the frequency of the spring between the axes.
/// @param jointId a motor joint
/// @return the value [Hz]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvMotorJoint_GetAngularHertz(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &MotorJoint, _| Ok(j.angular_hertz))
}

/// Set the damping ratio of the spring between the axes.
/// @param jointId a motor joint
/// @param damping the value >= 0; 1 is critical
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvMotorJoint_SetAngularDampingRatio(joint_id: mvJointId, damping: mvFloat) {
    set(joint_id, |j: &mut MotorJoint| {
        j.angular_damping_ratio = damping;
        Ok(())
    });
}

/// Get the damping ratio of the spring between the axes.
/// @param jointId a motor joint
/// @return the value; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvMotorJoint_GetAngularDampingRatio(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &MotorJoint, _| Ok(j.angular_damping_ratio))
}

/// Set the greatest force of the spring between the origins, along each axis.
/// @param jointId a motor joint
/// @param maxForce the value [N], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvMotorJoint_SetMaxSpringForce(joint_id: mvJointId, max_force: mvFloat) {
    set(joint_id, |j: &mut MotorJoint| {
        j.max_spring_force = max_force;
        Ok(())
    });
}

/// Get the greatest force of the spring between the origins, along each axis.
/// @param jointId a motor joint
/// @return the value [N]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvMotorJoint_GetMaxSpringForce(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &MotorJoint, _| Ok(j.max_spring_force))
}

/// Set the greatest torque of the spring between the axes, about each axis.
/// @param jointId a motor joint
/// @param maxTorque the value [N m], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvMotorJoint_SetMaxSpringTorque(joint_id: mvJointId, max_torque: mvFloat) {
    set(joint_id, |j: &mut MotorJoint| {
        j.max_spring_torque = max_torque;
        Ok(())
    });
}

/// Get the greatest torque of the spring between the axes, about each axis.
/// @param jointId a motor joint
/// @return the value [N m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvMotorJoint_GetMaxSpringTorque(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &MotorJoint, _| Ok(j.max_spring_torque))
}
