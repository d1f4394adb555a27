//! Distance joints: rods, ropes and springs between two points.

use super::def::cookie;
use super::def_check::{check_cookie, flag as check};
use super::guard::needed;
use super::id::{mvJointId, mvWorldId};
use super::joint::{create, get, set};
use super::joint_def::{default_base, mv_distanceJoint, mvJointDef};
use super::{Flag, mvFloat};
use crate::constraint::joint::{DistanceJoint, JointKind, Limit, Motor};
use crate::math::Float;

/// A length that limits nothing [m].
const HUGE: mvFloat = 1e5;

/// A distance joint: holds the origins of the frames at a distance. Without the spring it is a rigid rod; with it a
/// spring, within limits and with a motor if those are enabled: a rope is an enabled spring of 0 Hz with an upper
/// limit.
/// Made by mvDefaultDistanceJointDef().
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvDistanceJointDef {
    /// Shows that the definition was made by its function. Leave it alone.
    pub internal_value: i32,
    /// What all joints have.
    pub base: mvJointDef,
    /// The length of the rod, or at which the spring rests [m], >= 0; default 1.
    pub length: mvFloat,
    /// Whether it is a spring instead of a rod; default false.
    pub enable_spring: Flag,
    /// How hard the spring may pull: the least force, negative [N]; default minus infinity.
    pub lower_spring_force: mvFloat,
    /// How hard the spring may push: the greatest force [N]; default infinity.
    pub upper_spring_force: mvFloat,
    /// The frequency of the spring [Hz], >= 0; default 0: no force.
    pub hertz: mvFloat,
    /// Its damping ratio, >= 0; 1 is critical; default 0.
    pub damping_ratio: mvFloat,
    /// Whether the length is limited. Acts with the spring only. Default false.
    pub enable_limit: Flag,
    /// The least length [m], >= 0; default 0.
    pub min_length: mvFloat,
    /// The greatest length [m], not below the least; default 100000.
    pub max_length: mvFloat,
    /// Whether a motor changes the length. Acts with the spring only. Default false.
    pub enable_motor: Flag,
    /// The greatest force of the motor [N], >= 0; default 0.
    pub max_motor_force: mvFloat,
    /// The speed at which the motor wants the length to grow [m/s]; default 0.
    pub motor_speed: mvFloat,
}

const COOKIE: i32 = cookie::<mvDistanceJointDef>(10 + mv_distanceJoint as u32);

/// Get the definition of a distance joint with the default values.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultDistanceJointDef() -> mvDistanceJointDef {
    mvDistanceJointDef {
        internal_value: COOKIE,
        base: default_base(),
        length: 1.0,
        enable_spring: 0,
        lower_spring_force: Float::NEG_INFINITY,
        upper_spring_force: Float::INFINITY,
        hertz: 0.0,
        damping_ratio: 0.0,
        enable_limit: 0,
        min_length: 0.0,
        max_length: HUGE,
        enable_motor: 0,
        max_motor_force: 0.0,
        motor_speed: 0.0,
    }
}

/// Create a distance joint. Its bodies wake.
///
/// @param worldId the world that both bodies live in
/// @param def the definition, from mvDefaultDistanceJointDef()
/// @return the joint; null for bad arguments
/// @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
/// has no joints.
#[unsafe(no_mangle)]
pub extern "C" fn mvCreateDistanceJoint(world_id: mvWorldId, def: Option<&mvDistanceJointDef>) -> mvJointId {
    create(world_id, |_| {
        let d = needed("The definition", def)?;
        check_cookie("DistanceJoint", d.internal_value, COOKIE)?;
        let kind = DistanceJoint {
            length: d.length,
            enable_spring: check("enableSpring", d.enable_spring)?,
            hertz: d.hertz,
            damping_ratio: d.damping_ratio,
            spring_force: [d.lower_spring_force, d.upper_spring_force],
            limit: Limit {
                enable: check("enableLimit", d.enable_limit)?,
                lower: d.min_length,
                upper: d.max_length,
            },
            motor: Motor {
                enable: check("enableMotor", d.enable_motor)?,
                speed: d.motor_speed,
                max_force: d.max_motor_force,
            },
        };
        Ok((d.base, JointKind::Distance(kind)))
    })
}

/// Set the length of the rod, or at which the spring rests.
/// @param jointId a distance joint
/// @param length the value [m], >= 0
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_SetLength(joint_id: mvJointId, length: mvFloat) {
    set(joint_id, |j: &mut DistanceJoint| {
        j.length = length;
        Ok(())
    });
}

/// Get the length of the rod, or at which the spring rests.
/// @param jointId a distance joint
/// @return the value [m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_GetLength(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &DistanceJoint, _| Ok(j.length))
}

/// Turn the spring on or off.
/// @param jointId a distance joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_EnableSpring(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut DistanceJoint| {
        j.enable_spring = check("flag", flag)?;
        Ok(())
    });
}

/// Is the spring on?
/// @param jointId a distance joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_IsSpringEnabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &DistanceJoint, _| Ok(j.enable_spring))
}

/// Set the bounds of the force of the spring, which is positive where it pushes.
/// @param jointId a distance joint
/// @param lowerForce the least force [N], negative where it may pull; may be infinite
/// @param upperForce the greatest force [N]; may be infinite
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_SetSpringForceRange(
    joint_id: mvJointId,
    lower_force: mvFloat,
    upper_force: mvFloat,
) {
    set(joint_id, |j: &mut DistanceJoint| {
        j.spring_force = [lower_force, upper_force];
        Ok(())
    });
}

/// Get the bounds of the force of the spring.
/// @param jointId a distance joint
/// @param lowerForce where to write the least force [N]; may be null
/// @param upperForce where to write the greatest force [N]; may be null
/// @note Errors: mv_errorRange for another joint; nothing is written then.
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_GetSpringForceRange(
    joint_id: mvJointId,
    lower_force: Option<&mut mvFloat>,
    upper_force: Option<&mut mvFloat>,
) {
    get(joint_id, |j: &DistanceJoint, _| {
        lower_force.into_iter().for_each(|f| *f = j.spring_force[0]);
        upper_force.into_iter().for_each(|f| *f = j.spring_force[1]);
        Ok(())
    });
}

/// Set the frequency of the spring.
/// @param jointId a distance joint
/// @param hertz the value [Hz], >= 0; 0 has no effect
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_SetSpringHertz(joint_id: mvJointId, hertz: mvFloat) {
    set(joint_id, |j: &mut DistanceJoint| {
        j.hertz = hertz;
        Ok(())
    });
}

/// Get the frequency of the spring.
/// @param jointId a distance joint
/// @return the value [Hz]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_GetSpringHertz(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &DistanceJoint, _| Ok(j.hertz))
}

/// Set the damping ratio of the spring.
/// @param jointId a distance joint
/// @param dampingRatio the value >= 0; 1 is critical
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_SetSpringDampingRatio(joint_id: mvJointId, damping_ratio: mvFloat) {
    set(joint_id, |j: &mut DistanceJoint| {
        j.damping_ratio = damping_ratio;
        Ok(())
    });
}

/// Get the damping ratio of the spring.
/// @param jointId a distance joint
/// @return the value; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_GetSpringDampingRatio(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &DistanceJoint, _| Ok(j.damping_ratio))
}

/// Turn the limit on or off.
/// @param jointId a distance joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_EnableLimit(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut DistanceJoint| {
        j.limit.enable = check("flag", flag)?;
        Ok(())
    });
}

/// Is the limit on?
/// @param jointId a distance joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_IsLimitEnabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &DistanceJoint, _| Ok(j.limit.enable))
}

/// Set the limits of the length.
/// @param jointId a distance joint
/// @param minLength the least [m], >= 0
/// @param maxLength the greatest [m], >= 0, not below the least
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_SetLengthRange(
    joint_id: mvJointId,
    min_length: mvFloat,
    max_length: mvFloat,
) {
    set(joint_id, |j: &mut DistanceJoint| {
        (j.limit.lower, j.limit.upper) = (min_length, max_length);
        Ok(())
    });
}

/// Get the limits of the length: the least.
/// @param jointId a distance joint
/// @return the least [m], >= 0; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_GetMinLength(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &DistanceJoint, _| Ok(j.limit.lower))
}

/// Get the limits of the length: the greatest.
/// @param jointId a distance joint
/// @return the greatest [m], >= 0; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_GetMaxLength(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &DistanceJoint, _| Ok(j.limit.upper))
}

/// Get the distance of the origins of the frames.
/// @param jointId a distance joint
/// @return the length [m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_GetCurrentLength(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |_: &DistanceJoint, r| Ok(r.coordinate()))
}

/// Turn the motor on or off.
/// @param jointId a distance joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_EnableMotor(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut DistanceJoint| {
        j.motor.enable = check("flag", flag)?;
        Ok(())
    });
}

/// Is the motor on?
/// @param jointId a distance joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_IsMotorEnabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &DistanceJoint, _| Ok(j.motor.enable))
}

/// Set the speed at which the motor wants the length to grow.
/// @param jointId a distance joint
/// @param motorSpeed the value [m/s]
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_SetMotorSpeed(joint_id: mvJointId, motor_speed: mvFloat) {
    set(joint_id, |j: &mut DistanceJoint| {
        j.motor.speed = motor_speed;
        Ok(())
    });
}

/// Get the speed at which the motor wants the length to grow.
/// @param jointId a distance joint
/// @return the value [m/s]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_GetMotorSpeed(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &DistanceJoint, _| Ok(j.motor.speed))
}

/// Set the greatest force of the motor.
/// @param jointId a distance joint
/// @param force the value [N], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_SetMaxMotorForce(joint_id: mvJointId, force: mvFloat) {
    set(joint_id, |j: &mut DistanceJoint| {
        j.motor.max_force = force;
        Ok(())
    });
}

/// Get the greatest force of the motor.
/// @param jointId a distance joint
/// @return the value [N]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_GetMaxMotorForce(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &DistanceJoint, _| Ok(j.motor.max_force))
}

/// Get the force of the motor.
/// @param jointId a distance joint
/// @return the mean over the last sub-step [N]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvDistanceJoint_GetMotorForce(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |_: &DistanceJoint, r| Ok(r.motor_force().x))
}
