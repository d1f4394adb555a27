//! Revolute joints: hinges.

use super::def::cookie;
use super::def_check::{check_cookie, flag as check};
use super::guard::needed;
use super::id::{mvJointId, mvWorldId};
use super::joint::{create, get, set};
use super::joint_def::{default_base, mv_revoluteJoint, mvJointDef};
use super::{Flag, mvFloat};
use crate::constraint::joint::{Drive, JointKind, Limit, Motor, RevoluteJoint, Spring};
use crate::math::Float;

/// A revolute joint: a hinge about z of both frames. The angle is that of frame B against frame A and counts whole
/// turns.
/// Made by mvDefaultRevoluteJointDef().
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvRevoluteJointDef {
    /// Shows that the definition was made by its function. Leave it alone.
    pub internal_value: i32,
    /// What all joints have.
    pub base: mvJointDef,
    /// Whether a spring acts; default false.
    pub enable_spring: Flag,
    /// The frequency of the spring [Hz], >= 0; default 0: no force.
    pub hertz: mvFloat,
    /// The damping ratio of the spring, >= 0; 1 is critical; default 0.
    pub damping_ratio: mvFloat,
    /// The greatest torque of the spring [N m], >= 0; default infinity.
    pub max_spring_torque: mvFloat,
    /// The angle at which the spring rests [rad]; default 0.
    pub target_angle: mvFloat,
    /// Whether the angle is limited; default false.
    pub enable_limit: Flag,
    /// The least angle [rad]; default 0.
    pub lower_angle: mvFloat,
    /// The greatest angle [rad], not below the least; default 0.
    pub upper_angle: mvFloat,
    /// Whether a motor acts; default false.
    pub enable_motor: Flag,
    /// The greatest torque of the motor [N m], >= 0; default 0.
    pub max_motor_torque: mvFloat,
    /// The speed that the motor wants [rad/s]; default 0.
    pub motor_speed: mvFloat,
    /// The torque of dry friction [N m], >= 0; default 0.
    pub friction: mvFloat,
}

const COOKIE: i32 = cookie::<mvRevoluteJointDef>(10 + mv_revoluteJoint as u32);

/// Get the definition of a revolute joint with the default values.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultRevoluteJointDef() -> mvRevoluteJointDef {
    mvRevoluteJointDef {
        internal_value: COOKIE,
        base: default_base(),
        enable_spring: 0,
        hertz: 0.0,
        damping_ratio: 0.0,
        max_spring_torque: Float::INFINITY,
        target_angle: 0.0,
        enable_limit: 0,
        lower_angle: 0.0,
        upper_angle: 0.0,
        enable_motor: 0,
        max_motor_torque: 0.0,
        motor_speed: 0.0,
        friction: 0.0,
    }
}

/// Create a revolute joint. Its bodies wake.
///
/// @param worldId the world that both bodies live in
/// @param def the definition, from mvDefaultRevoluteJointDef()
/// @return the joint; null for bad arguments
/// @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
/// has no joints.
#[unsafe(no_mangle)]
pub extern "C" fn mvCreateRevoluteJoint(world_id: mvWorldId, def: Option<&mvRevoluteJointDef>) -> mvJointId {
    create(world_id, |_| {
        let d = needed("The definition", def)?;
        check_cookie("RevoluteJoint", d.internal_value, COOKIE)?;
        Ok((
            d.base,
            JointKind::Revolute(RevoluteJoint {
                drive: Drive {
                    spring: Spring {
                        enable: check("enableSpring", d.enable_spring)?,
                        hertz: d.hertz,
                        damping_ratio: d.damping_ratio,
                        max_force: d.max_spring_torque,
                    },
                    target: d.target_angle,
                    limit: Limit {
                        enable: check("enableLimit", d.enable_limit)?,
                        lower: d.lower_angle,
                        upper: d.upper_angle,
                    },
                    motor: Motor {
                        enable: check("enableMotor", d.enable_motor)?,
                        speed: d.motor_speed,
                        max_force: d.max_motor_torque,
                    },
                    friction: d.friction,
                },
            }),
        ))
    })
}

/// Turn the spring on or off.
/// @param jointId a revolute joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_EnableSpring(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut RevoluteJoint| {
        j.drive.spring.enable = check("flag", flag)?;
        Ok(())
    });
}

/// Is the spring on?
/// @param jointId a revolute joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_IsSpringEnabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &RevoluteJoint, _| Ok(j.drive.spring.enable))
}

/// Set the frequency of the spring.
/// @param jointId a revolute joint
/// @param hertz the value [Hz], >= 0; 0 has no effect
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_SetSpringHertz(joint_id: mvJointId, hertz: mvFloat) {
    set(joint_id, |j: &mut RevoluteJoint| {
        j.drive.spring.hertz = hertz;
        Ok(())
    });
}

/// Get the frequency of the spring.
/// @param jointId a revolute joint
/// @return the value [Hz]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_GetSpringHertz(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &RevoluteJoint, _| Ok(j.drive.spring.hertz))
}

/// Set the damping ratio of the spring.
/// @param jointId a revolute joint
/// @param dampingRatio the value >= 0; 1 is critical
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_SetSpringDampingRatio(joint_id: mvJointId, damping_ratio: mvFloat) {
    set(joint_id, |j: &mut RevoluteJoint| {
        j.drive.spring.damping_ratio = damping_ratio;
        Ok(())
    });
}

/// Get the damping ratio of the spring.
/// @param jointId a revolute joint
/// @return the value; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_GetSpringDampingRatio(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &RevoluteJoint, _| Ok(j.drive.spring.damping_ratio))
}

/// Set the greatest torque of the spring.
/// @param jointId a revolute joint
/// @param maxTorque the value [N m], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_SetMaxSpringTorque(joint_id: mvJointId, max_torque: mvFloat) {
    set(joint_id, |j: &mut RevoluteJoint| {
        j.drive.spring.max_force = max_torque;
        Ok(())
    });
}

/// Get the greatest torque of the spring.
/// @param jointId a revolute joint
/// @return the value [N m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_GetMaxSpringTorque(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &RevoluteJoint, _| Ok(j.drive.spring.max_force))
}

/// Set the angle at which the spring rests.
/// @param jointId a revolute joint
/// @param angle the value [rad]
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_SetTargetAngle(joint_id: mvJointId, angle: mvFloat) {
    set(joint_id, |j: &mut RevoluteJoint| {
        j.drive.target = angle;
        Ok(())
    });
}

/// Get the angle at which the spring rests.
/// @param jointId a revolute joint
/// @return the value [rad]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_GetTargetAngle(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &RevoluteJoint, _| Ok(j.drive.target))
}

/// Turn the limit on or off.
/// @param jointId a revolute joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_EnableLimit(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut RevoluteJoint| {
        j.drive.limit.enable = check("flag", flag)?;
        Ok(())
    });
}

/// Is the limit on?
/// @param jointId a revolute joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_IsLimitEnabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &RevoluteJoint, _| Ok(j.drive.limit.enable))
}

/// Set the limits of the angle.
/// @param jointId a revolute joint
/// @param lower the least [rad]
/// @param upper the greatest [rad], not below the least
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_SetLimits(joint_id: mvJointId, lower: mvFloat, upper: mvFloat) {
    set(joint_id, |j: &mut RevoluteJoint| {
        (j.drive.limit.lower, j.drive.limit.upper) = (lower, upper);
        Ok(())
    });
}

/// Get the limits of the angle: the least.
/// @param jointId a revolute joint
/// @return the least [rad]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_GetLowerLimit(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &RevoluteJoint, _| Ok(j.drive.limit.lower))
}

/// Get the limits of the angle: the greatest.
/// @param jointId a revolute joint
/// @return the greatest [rad]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_GetUpperLimit(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &RevoluteJoint, _| Ok(j.drive.limit.upper))
}

/// Turn the motor on or off.
/// @param jointId a revolute joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_EnableMotor(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut RevoluteJoint| {
        j.drive.motor.enable = check("flag", flag)?;
        Ok(())
    });
}

/// Is the motor on?
/// @param jointId a revolute joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_IsMotorEnabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &RevoluteJoint, _| Ok(j.drive.motor.enable))
}

/// Set the speed that the motor wants.
/// @param jointId a revolute joint
/// @param motorSpeed the value [rad/s]
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_SetMotorSpeed(joint_id: mvJointId, motor_speed: mvFloat) {
    set(joint_id, |j: &mut RevoluteJoint| {
        j.drive.motor.speed = motor_speed;
        Ok(())
    });
}

/// Get the speed that the motor wants.
/// @param jointId a revolute joint
/// @return the value [rad/s]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_GetMotorSpeed(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &RevoluteJoint, _| Ok(j.drive.motor.speed))
}

/// Set the greatest torque of the motor.
/// @param jointId a revolute joint
/// @param maxTorque the value [N m], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_SetMaxMotorTorque(joint_id: mvJointId, max_torque: mvFloat) {
    set(joint_id, |j: &mut RevoluteJoint| {
        j.drive.motor.max_force = max_torque;
        Ok(())
    });
}

/// Get the greatest torque of the motor.
/// @param jointId a revolute joint
/// @return the value [N m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_GetMaxMotorTorque(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &RevoluteJoint, _| Ok(j.drive.motor.max_force))
}

/// Get the torque of the motor.
/// @param jointId a revolute joint
/// @return the mean over the last sub-step [N m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_GetMotorTorque(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |_: &RevoluteJoint, r| Ok(r.motor_force().x))
}

/// Set the torque of dry friction.
/// @param jointId a revolute joint
/// @param friction the value [N m], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_SetFriction(joint_id: mvJointId, friction: mvFloat) {
    set(joint_id, |j: &mut RevoluteJoint| {
        j.drive.friction = friction;
        Ok(())
    });
}

/// Get the torque of dry friction.
/// @param jointId a revolute joint
/// @return the value [N m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_GetFriction(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &RevoluteJoint, _| Ok(j.drive.friction))
}

/// Get the angle of frame B against frame A, counting whole turns.
/// @param jointId a revolute joint
/// @return the angle [rad]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_GetAngle(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |_: &RevoluteJoint, r| Ok(r.coordinate()))
}

/// Get how fast the angle changes.
/// @param jointId a revolute joint
/// @return the speed [rad/s]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvRevoluteJoint_GetSpeed(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |_: &RevoluteJoint, r| Ok(r.speed()))
}
