//! Spherical joints: ball and socket.

use super::def::cookie;
use super::def_check::{check_cookie, flag as check};
use super::guard::needed;
use super::id::{mvJointId, mvWorldId};
use super::joint::{create, get, set};
use super::joint_def::{default_base, mv_sphericalJoint, mvJointDef};
use super::math::{IDENTITY, ZERO3, mvQuat, mvVec3};
use super::{Flag, mvFloat};
use crate::constraint::joint::{JointKind, Limit, SphericalJoint, Spring};
use crate::math::Float;

/// A spherical joint: the origins of the frames stay together. The turn of frame B against frame A may be limited:
/// its z axis to a cone about that of frame A, and the twist about z.
/// Made by mvDefaultSphericalJointDef().
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvSphericalJointDef {
    /// Shows that the definition was made by its function. Leave it alone.
    pub internal_value: i32,
    /// What all joints have.
    pub base: mvJointDef,
    /// Whether a spring turns B towards targetRotation; default false.
    pub enable_spring: Flag,
    /// The frequency of the spring [Hz], >= 0; default 0: no torque.
    pub hertz: mvFloat,
    /// Its damping ratio, >= 0; 1 is critical; default 0.
    pub damping_ratio: mvFloat,
    /// Its greatest torque about each axis [N m], >= 0; default infinity.
    pub max_spring_torque: mvFloat,
    /// The rotation of frame B in frame A at which the spring rests; default the identity.
    pub target_rotation: mvQuat,
    /// Whether the cone limits; default false.
    pub enable_cone_limit: Flag,
    /// The half-angle of the cone for turns about x of frame A [rad], 0 to pi; default 0.
    pub cone_angle: mvFloat,
    /// The half-angle for turns about y of frame A [rad], at most pi; negative, the default, means that of x: a
    /// round cone.
    pub cone_angle_y: mvFloat,
    /// Whether the twist is limited; default false.
    pub enable_twist_limit: Flag,
    /// The least twist about z [rad]; default 0.
    pub lower_twist_angle: mvFloat,
    /// The greatest twist [rad], not below the least; default 0.
    pub upper_twist_angle: mvFloat,
    /// Whether a motor acts; default false.
    pub enable_motor: Flag,
    /// Its greatest torque about each axis [N m], >= 0; default 0.
    pub max_motor_torque: mvFloat,
    /// The angular velocity of B against A that it wants, in the axes of frame A [rad/s]; default 0.
    pub motor_velocity: mvVec3,
    /// The torque of dry friction about each axis [N m], >= 0; default 0.
    pub friction: mvFloat,
}

const COOKIE: i32 = cookie::<mvSphericalJointDef>(10 + mv_sphericalJoint as u32);

/// Get the definition of a spherical joint with the default values.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultSphericalJointDef() -> mvSphericalJointDef {
    mvSphericalJointDef {
        internal_value: COOKIE,
        base: default_base(),
        enable_spring: 0,
        hertz: 0.0,
        damping_ratio: 0.0,
        max_spring_torque: Float::INFINITY,
        target_rotation: IDENTITY,
        enable_cone_limit: 0,
        cone_angle: 0.0,
        cone_angle_y: -1.0,
        enable_twist_limit: 0,
        lower_twist_angle: 0.0,
        upper_twist_angle: 0.0,
        enable_motor: 0,
        max_motor_torque: 0.0,
        motor_velocity: ZERO3,
        friction: 0.0,
    }
}

/// Create a spherical joint. Its bodies wake.
///
/// @param worldId the world that both bodies live in
/// @param def the definition, from mvDefaultSphericalJointDef()
/// @return the joint; null for bad arguments
/// @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
/// has no joints.
#[unsafe(no_mangle)]
pub extern "C" fn mvCreateSphericalJoint(
    world_id: mvWorldId,
    def: Option<&mvSphericalJointDef>,
) -> mvJointId {
    create(world_id, |_| {
        let d = needed("The definition", def)?;
        check_cookie("SphericalJoint", d.internal_value, COOKIE)?;
        let kind = SphericalJoint {
            enable_cone_limit: check("enableConeLimit", d.enable_cone_limit)?,
            cone_angle: [d.cone_angle, if d.cone_angle_y < 0.0 { d.cone_angle } else { d.cone_angle_y }],
            twist: Limit {
                enable: check("enableTwistLimit", d.enable_twist_limit)?,
                lower: d.lower_twist_angle,
                upper: d.upper_twist_angle,
            },
            spring: Spring {
                enable: check("enableSpring", d.enable_spring)?,
                hertz: d.hertz,
                damping_ratio: d.damping_ratio,
                max_force: d.max_spring_torque,
            },
            target_rotation: d.target_rotation.rotation("targetRotation")?,
            enable_motor: check("enableMotor", d.enable_motor)?,
            motor_velocity: d.motor_velocity.raw(),
            max_motor_torque: d.max_motor_torque,
            friction: d.friction,
        };
        Ok((d.base, JointKind::Spherical(kind)))
    })
}

/// Turn the cone limit on or off.
/// @param jointId a spherical joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_EnableConeLimit(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut SphericalJoint| {
        j.enable_cone_limit = check("flag", flag)?;
        Ok(())
    });
}

/// Is the cone limit on?
/// @param jointId a spherical joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_IsConeLimitEnabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &SphericalJoint, _| Ok(j.enable_cone_limit))
}

/// Get the half-angle of the cone for turns about x of frame A.
/// @param jointId a spherical joint
/// @return the angle [rad]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_GetConeLimit(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &SphericalJoint, _| Ok(j.cone_angle[0]))
}

/// Make the cone round, with this half-angle.
/// @param jointId a spherical joint
/// @param angle the half-angle [rad], 0 to pi
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_SetConeLimit(joint_id: mvJointId, angle: mvFloat) {
    set(joint_id, |j: &mut SphericalJoint| {
        j.cone_angle = [angle; 2];
        Ok(())
    });
}

/// Make the cone elliptical.
/// @param jointId a spherical joint
/// @param angleX the half-angle for turns about x of frame A [rad], 0 to pi
/// @param angleY the half-angle for turns about y of frame A [rad], 0 to pi
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_SetConeLimits(joint_id: mvJointId, angle_x: mvFloat, angle_y: mvFloat) {
    set(joint_id, |j: &mut SphericalJoint| {
        j.cone_angle = [angle_x, angle_y];
        Ok(())
    });
}

/// Get the half-angle of the cone for turns about y of frame A.
/// @param jointId a spherical joint
/// @return the angle [rad]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_GetConeLimitY(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &SphericalJoint, _| Ok(j.cone_angle[1]))
}

/// Get the angle between the z axes of the frames.
/// @param jointId a spherical joint
/// @return the angle [rad], 0 to pi; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_GetConeAngle(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |_: &SphericalJoint, r| Ok(r.swing_and_twist().0))
}

/// Turn the limit of the twist on or off.
/// @param jointId a spherical joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_EnableTwistLimit(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut SphericalJoint| {
        j.twist.enable = check("flag", flag)?;
        Ok(())
    });
}

/// Is the limit of the twist on?
/// @param jointId a spherical joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_IsTwistLimitEnabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &SphericalJoint, _| Ok(j.twist.enable))
}

/// Set the limits of the twist.
/// @param jointId a spherical joint
/// @param lower the least [rad]
/// @param upper the greatest [rad], not below the least
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_SetTwistLimits(joint_id: mvJointId, lower: mvFloat, upper: mvFloat) {
    set(joint_id, |j: &mut SphericalJoint| {
        (j.twist.lower, j.twist.upper) = (lower, upper);
        Ok(())
    });
}

/// Get the limits of the twist: the least.
/// @param jointId a spherical joint
/// @return the least [rad]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_GetLowerTwistLimit(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &SphericalJoint, _| Ok(j.twist.lower))
}

/// Get the limits of the twist: the greatest.
/// @param jointId a spherical joint
/// @return the greatest [rad]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_GetUpperTwistLimit(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &SphericalJoint, _| Ok(j.twist.upper))
}

/// Get the twist of frame B against frame A about z.
/// @param jointId a spherical joint
/// @return the angle [rad], -pi to pi; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_GetTwistAngle(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |_: &SphericalJoint, r| Ok(r.swing_and_twist().1))
}

/// Turn the spring on or off.
/// @param jointId a spherical joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_EnableSpring(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut SphericalJoint| {
        j.spring.enable = check("flag", flag)?;
        Ok(())
    });
}

/// Is the spring on?
/// @param jointId a spherical joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_IsSpringEnabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &SphericalJoint, _| Ok(j.spring.enable))
}

/// Set the frequency of the spring.
/// @param jointId a spherical joint
/// @param hertz the value [Hz], >= 0; 0 has no effect
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_SetSpringHertz(joint_id: mvJointId, hertz: mvFloat) {
    set(joint_id, |j: &mut SphericalJoint| {
        j.spring.hertz = hertz;
        Ok(())
    });
}

/// Get the frequency of the spring.
/// @param jointId a spherical joint
/// @return the value [Hz]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_GetSpringHertz(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &SphericalJoint, _| Ok(j.spring.hertz))
}

/// Set the damping ratio of the spring.
/// @param jointId a spherical joint
/// @param dampingRatio the value >= 0; 1 is critical
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_SetSpringDampingRatio(joint_id: mvJointId, damping_ratio: mvFloat) {
    set(joint_id, |j: &mut SphericalJoint| {
        j.spring.damping_ratio = damping_ratio;
        Ok(())
    });
}

/// Get the damping ratio of the spring.
/// @param jointId a spherical joint
/// @return the value; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_GetSpringDampingRatio(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &SphericalJoint, _| Ok(j.spring.damping_ratio))
}

/// Set the greatest torque of the spring about each axis.
/// @param jointId a spherical joint
/// @param maxTorque the value [N m], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_SetMaxSpringTorque(joint_id: mvJointId, max_torque: mvFloat) {
    set(joint_id, |j: &mut SphericalJoint| {
        j.spring.max_force = max_torque;
        Ok(())
    });
}

/// Get the greatest torque of the spring about each axis.
/// @param jointId a spherical joint
/// @return the value [N m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_GetMaxSpringTorque(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &SphericalJoint, _| Ok(j.spring.max_force))
}

/// Set the rotation of frame B in frame A at which the spring rests.
/// @param jointId a spherical joint
/// @param targetRotation the rotation, of length 1
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_SetTargetRotation(joint_id: mvJointId, target_rotation: mvQuat) {
    set(joint_id, |j: &mut SphericalJoint| {
        j.target_rotation = target_rotation.rotation("targetRotation")?;
        Ok(())
    });
}

/// Get the rotation of frame B in frame A at which the spring rests.
/// @param jointId a spherical joint
/// @return the rotation; the identity for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_GetTargetRotation(joint_id: mvJointId) -> mvQuat {
    get(joint_id, |j: &SphericalJoint, _| Ok(j.target_rotation.into()))
}

/// Turn the motor on or off.
/// @param jointId a spherical joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_EnableMotor(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut SphericalJoint| {
        j.enable_motor = check("flag", flag)?;
        Ok(())
    });
}

/// Is the motor on?
/// @param jointId a spherical joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_IsMotorEnabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &SphericalJoint, _| Ok(j.enable_motor))
}

/// Set the angular velocity that the motor wants, in the axes of frame A.
/// @param jointId a spherical joint
/// @param motorVelocity the value [rad/s]
/// @note Errors: mv_errorNotFinite; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_SetMotorVelocity(joint_id: mvJointId, motor_velocity: mvVec3) {
    set(joint_id, |j: &mut SphericalJoint| {
        j.motor_velocity = motor_velocity.raw();
        Ok(())
    });
}

/// Get the angular velocity that the motor wants, in the axes of frame A.
/// @param jointId a spherical joint
/// @return the value [rad/s]; zero for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_GetMotorVelocity(joint_id: mvJointId) -> mvVec3 {
    get(joint_id, |j: &SphericalJoint, _| Ok(j.motor_velocity.into()))
}

/// Get the torque of the motor about the axes of frame A.
/// @param jointId a spherical joint
/// @return the mean over the last sub-step [N m]; zero for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_GetMotorTorque(joint_id: mvJointId) -> mvVec3 {
    get(joint_id, |_: &SphericalJoint, r| Ok(r.motor_force().into()))
}

/// Set the greatest torque of the motor about each axis.
/// @param jointId a spherical joint
/// @param torque the value [N m], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_SetMaxMotorTorque(joint_id: mvJointId, torque: mvFloat) {
    set(joint_id, |j: &mut SphericalJoint| {
        j.max_motor_torque = torque;
        Ok(())
    });
}

/// Get the greatest torque of the motor about each axis.
/// @param jointId a spherical joint
/// @return the value [N m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_GetMaxMotorTorque(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &SphericalJoint, _| Ok(j.max_motor_torque))
}

/// Set the torque of dry friction about each axis.
/// @param jointId a spherical joint
/// @param friction the value [N m], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_SetFriction(joint_id: mvJointId, friction: mvFloat) {
    set(joint_id, |j: &mut SphericalJoint| {
        j.friction = friction;
        Ok(())
    });
}

/// Get the torque of dry friction about each axis.
/// @param jointId a spherical joint
/// @return the value [N m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvSphericalJoint_GetFriction(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &SphericalJoint, _| Ok(j.friction))
}
