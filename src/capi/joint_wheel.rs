//! Wheel joints: suspension, spin and steering.

use super::def::cookie;
use super::def_check::{check_cookie, flag as check};
use super::guard::needed;
use super::id::{mvJointId, mvWorldId};
use super::joint::{create, get, set};
use super::joint_def::{default_base, mv_wheelJoint, mvJointDef};
use super::{Flag, mvFloat};
use crate::constraint::joint::{Drive, JointKind, Limit, Motor, Spring, WheelJoint};
use crate::math::Float;

/// A wheel joint: A is the chassis, B the wheel. The wheel travels along x of frame A, spins about z of frame B and
/// may steer about x of frame A.
/// Made by mvDefaultWheelJointDef().
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvWheelJointDef {
    /// Shows that the definition was made by its function. Leave it alone.
    pub internal_value: i32,
    /// What all joints have.
    pub base: mvJointDef,
    /// Whether the suspension has a spring; default true.
    pub enable_suspension_spring: Flag,
    /// Its frequency [Hz], >= 0; default 1.
    pub suspension_hertz: mvFloat,
    /// Its damping ratio, >= 0; default 0.7.
    pub suspension_damping_ratio: mvFloat,
    /// The travel at which it rests [m]; default 0.
    pub target_suspension: mvFloat,
    /// Its greatest force [N], >= 0; default infinity.
    pub max_suspension_force: mvFloat,
    /// Whether the travel is limited; default false.
    pub enable_suspension_limit: Flag,
    /// The least travel [m]; default 0.
    pub lower_suspension_limit: mvFloat,
    /// The greatest travel [m], not below the least; default 0.
    pub upper_suspension_limit: mvFloat,
    /// Whether a motor spins the wheel; default false.
    pub enable_spin_motor: Flag,
    /// Its greatest torque [N m], >= 0; default 0.
    pub max_spin_torque: mvFloat,
    /// The speed that it wants [rad/s]; default 0.
    pub spin_speed: mvFloat,
    /// The torque of dry friction in the bearing [N m], >= 0; default 0.
    pub spin_friction: mvFloat,
    /// Whether the wheel steers; default false.
    pub enable_steering: Flag,
    /// The frequency of the spring that steers [Hz], >= 0; default 1.
    pub steering_hertz: mvFloat,
    /// Its damping ratio, >= 0; default 0.7.
    pub steering_damping_ratio: mvFloat,
    /// The angle that it steers to [rad]; default 0.
    pub target_steering_angle: mvFloat,
    /// Its greatest torque [N m], >= 0; default 0.
    pub max_steering_torque: mvFloat,
    /// Whether the steering angle is limited; default false.
    pub enable_steering_limit: Flag,
    /// The least steering angle [rad]; default 0.
    pub lower_steering_limit: mvFloat,
    /// The greatest steering angle [rad], not below the least; default 0.
    pub upper_steering_limit: mvFloat,
}

const COOKIE: i32 = cookie::<mvWheelJointDef>(10 + mv_wheelJoint as u32);

/// Get the definition of a wheel joint with the default values.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultWheelJointDef() -> mvWheelJointDef {
    mvWheelJointDef {
        internal_value: COOKIE,
        base: default_base(),
        enable_suspension_spring: 1,
        suspension_hertz: 1.0,
        suspension_damping_ratio: 0.7,
        target_suspension: 0.0,
        max_suspension_force: Float::INFINITY,
        enable_suspension_limit: 0,
        lower_suspension_limit: 0.0,
        upper_suspension_limit: 0.0,
        enable_spin_motor: 0,
        max_spin_torque: 0.0,
        spin_speed: 0.0,
        spin_friction: 0.0,
        enable_steering: 0,
        steering_hertz: 1.0,
        steering_damping_ratio: 0.7,
        target_steering_angle: 0.0,
        max_steering_torque: 0.0,
        enable_steering_limit: 0,
        lower_steering_limit: 0.0,
        upper_steering_limit: 0.0,
    }
}

/// Create a wheel joint. Its bodies wake.
///
/// @param worldId the world that both bodies live in
/// @param def the definition, from mvDefaultWheelJointDef()
/// @return the joint; null for bad arguments
/// @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
/// has no joints.
#[unsafe(no_mangle)]
pub extern "C" fn mvCreateWheelJoint(world_id: mvWorldId, def: Option<&mvWheelJointDef>) -> mvJointId {
    create(world_id, |_| {
        let d = needed("The definition", def)?;
        check_cookie("WheelJoint", d.internal_value, COOKIE)?;
        let suspension = Drive {
            spring: Spring {
                enable: check("enableSuspensionSpring", d.enable_suspension_spring)?,
                hertz: d.suspension_hertz,
                damping_ratio: d.suspension_damping_ratio,
                max_force: d.max_suspension_force,
            },
            target: d.target_suspension,
            limit: Limit {
                enable: check("enableSuspensionLimit", d.enable_suspension_limit)?,
                lower: d.lower_suspension_limit,
                upper: d.upper_suspension_limit,
            },
            ..Drive::default()
        };
        let steering = Drive {
            spring: Spring {
                enable: true,
                hertz: d.steering_hertz,
                damping_ratio: d.steering_damping_ratio,
                max_force: d.max_steering_torque,
            },
            target: d.target_steering_angle,
            limit: Limit {
                enable: check("enableSteeringLimit", d.enable_steering_limit)?,
                lower: d.lower_steering_limit,
                upper: d.upper_steering_limit,
            },
            ..Drive::default()
        };
        let kind = WheelJoint {
            suspension,
            spin: Motor {
                enable: check("enableSpinMotor", d.enable_spin_motor)?,
                speed: d.spin_speed,
                max_force: d.max_spin_torque,
            },
            spin_friction: d.spin_friction,
            enable_steering: check("enableSteering", d.enable_steering)?,
            steering,
        };
        Ok((d.base, JointKind::Wheel(kind)))
    })
}

/// Turn the spring of the suspension on or off.
/// @param jointId a wheel joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_EnableSuspension(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut WheelJoint| {
        j.suspension.spring.enable = check("flag", flag)?;
        Ok(())
    });
}

/// Is the spring of the suspension on?
/// @param jointId a wheel joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_IsSuspensionEnabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &WheelJoint, _| Ok(j.suspension.spring.enable))
}

/// Set the frequency of the suspension.
/// @param jointId a wheel joint
/// @param hertz the value [Hz], >= 0; 0 has no effect
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_SetSuspensionHertz(joint_id: mvJointId, hertz: mvFloat) {
    set(joint_id, |j: &mut WheelJoint| {
        j.suspension.spring.hertz = hertz;
        Ok(())
    });
}

/// Get the frequency of the suspension.
/// @param jointId a wheel joint
/// @return the value [Hz]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetSuspensionHertz(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &WheelJoint, _| Ok(j.suspension.spring.hertz))
}

/// Set the damping ratio of the suspension.
/// @param jointId a wheel joint
/// @param dampingRatio the value >= 0; 1 is critical
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_SetSuspensionDampingRatio(joint_id: mvJointId, damping_ratio: mvFloat) {
    set(joint_id, |j: &mut WheelJoint| {
        j.suspension.spring.damping_ratio = damping_ratio;
        Ok(())
    });
}

/// Get the damping ratio of the suspension.
/// @param jointId a wheel joint
/// @return the value; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetSuspensionDampingRatio(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &WheelJoint, _| Ok(j.suspension.spring.damping_ratio))
}

/// Set the travel at which the suspension rests.
/// @param jointId a wheel joint
/// @param travel the value [m]
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_SetTargetSuspension(joint_id: mvJointId, travel: mvFloat) {
    set(joint_id, |j: &mut WheelJoint| {
        j.suspension.target = travel;
        Ok(())
    });
}

/// Get the travel at which the suspension rests.
/// @param jointId a wheel joint
/// @return the value [m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetTargetSuspension(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &WheelJoint, _| Ok(j.suspension.target))
}

/// Set the greatest force of the suspension.
/// @param jointId a wheel joint
/// @param force the value [N], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_SetMaxSuspensionForce(joint_id: mvJointId, force: mvFloat) {
    set(joint_id, |j: &mut WheelJoint| {
        j.suspension.spring.max_force = force;
        Ok(())
    });
}

/// Get the greatest force of the suspension.
/// @param jointId a wheel joint
/// @return the value [N]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetMaxSuspensionForce(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &WheelJoint, _| Ok(j.suspension.spring.max_force))
}

/// Get how far the wheel is along x of frame A.
/// @param jointId a wheel joint
/// @return the travel [m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetSuspensionTravel(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |_: &WheelJoint, r| Ok(r.suspension()))
}

/// Turn the limit of the travel on or off.
/// @param jointId a wheel joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_EnableSuspensionLimit(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut WheelJoint| {
        j.suspension.limit.enable = check("flag", flag)?;
        Ok(())
    });
}

/// Is the limit of the travel on?
/// @param jointId a wheel joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_IsSuspensionLimitEnabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &WheelJoint, _| Ok(j.suspension.limit.enable))
}

/// Set the limits of the travel.
/// @param jointId a wheel joint
/// @param lower the least [m]
/// @param upper the greatest [m], not below the least
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_SetSuspensionLimits(joint_id: mvJointId, lower: mvFloat, upper: mvFloat) {
    set(joint_id, |j: &mut WheelJoint| {
        (j.suspension.limit.lower, j.suspension.limit.upper) = (lower, upper);
        Ok(())
    });
}

/// Get the limits of the travel: the least.
/// @param jointId a wheel joint
/// @return the least [m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetLowerSuspensionLimit(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &WheelJoint, _| Ok(j.suspension.limit.lower))
}

/// Get the limits of the travel: the greatest.
/// @param jointId a wheel joint
/// @return the greatest [m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetUpperSuspensionLimit(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &WheelJoint, _| Ok(j.suspension.limit.upper))
}

/// Turn the motor that spins the wheel on or off.
/// @param jointId a wheel joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_EnableSpinMotor(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut WheelJoint| {
        j.spin.enable = check("flag", flag)?;
        Ok(())
    });
}

/// Is the motor that spins the wheel on?
/// @param jointId a wheel joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_IsSpinMotorEnabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &WheelJoint, _| Ok(j.spin.enable))
}

/// Set the speed that the motor wants.
/// @param jointId a wheel joint
/// @param speed the value [rad/s]
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_SetSpinMotorSpeed(joint_id: mvJointId, speed: mvFloat) {
    set(joint_id, |j: &mut WheelJoint| {
        j.spin.speed = speed;
        Ok(())
    });
}

/// Get the speed that the motor wants.
/// @param jointId a wheel joint
/// @return the value [rad/s]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetSpinMotorSpeed(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &WheelJoint, _| Ok(j.spin.speed))
}

/// Set the greatest torque of the motor.
/// @param jointId a wheel joint
/// @param torque the value [N m], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_SetMaxSpinTorque(joint_id: mvJointId, torque: mvFloat) {
    set(joint_id, |j: &mut WheelJoint| {
        j.spin.max_force = torque;
        Ok(())
    });
}

/// Get the greatest torque of the motor.
/// @param jointId a wheel joint
/// @return the value [N m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetMaxSpinTorque(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &WheelJoint, _| Ok(j.spin.max_force))
}

/// Set the torque of dry friction in the bearing.
/// @param jointId a wheel joint
/// @param torque the value [N m], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_SetSpinFriction(joint_id: mvJointId, torque: mvFloat) {
    set(joint_id, |j: &mut WheelJoint| {
        j.spin_friction = torque;
        Ok(())
    });
}

/// Get the torque of dry friction in the bearing.
/// @param jointId a wheel joint
/// @return the value [N m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetSpinFriction(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &WheelJoint, _| Ok(j.spin_friction))
}

/// Get how fast the wheel spins against the chassis.
/// @param jointId a wheel joint
/// @return the speed [rad/s]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetSpinSpeed(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |_: &WheelJoint, r| Ok(r.speed()))
}

/// Get how far the wheel has turned, counting whole turns.
/// @param jointId a wheel joint
/// @return the angle [rad]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetSpinAngle(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |_: &WheelJoint, r| Ok(r.coordinate()))
}

/// Get the torque of the motor that spins the wheel.
/// @param jointId a wheel joint
/// @return the mean over the last sub-step [N m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetSpinTorque(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |_: &WheelJoint, r| Ok(r.motor_force().x))
}

/// Turn steering on or off.
/// @param jointId a wheel joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_EnableSteering(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut WheelJoint| {
        j.enable_steering = check("flag", flag)?;
        Ok(())
    });
}

/// Is steering on?
/// @param jointId a wheel joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_IsSteeringEnabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &WheelJoint, _| Ok(j.enable_steering))
}

/// Set the frequency of the spring that steers.
/// @param jointId a wheel joint
/// @param hertz the value [Hz], >= 0; 0 has no effect
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_SetSteeringHertz(joint_id: mvJointId, hertz: mvFloat) {
    set(joint_id, |j: &mut WheelJoint| {
        j.steering.spring.hertz = hertz;
        Ok(())
    });
}

/// Get the frequency of the spring that steers.
/// @param jointId a wheel joint
/// @return the value [Hz]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetSteeringHertz(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &WheelJoint, _| Ok(j.steering.spring.hertz))
}

/// Set the damping ratio of the spring that steers.
/// @param jointId a wheel joint
/// @param dampingRatio the value >= 0; 1 is critical
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_SetSteeringDampingRatio(joint_id: mvJointId, damping_ratio: mvFloat) {
    set(joint_id, |j: &mut WheelJoint| {
        j.steering.spring.damping_ratio = damping_ratio;
        Ok(())
    });
}

/// Get the damping ratio of the spring that steers.
/// @param jointId a wheel joint
/// @return the value; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetSteeringDampingRatio(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &WheelJoint, _| Ok(j.steering.spring.damping_ratio))
}

/// Set the greatest torque of the spring that steers.
/// @param jointId a wheel joint
/// @param torque the value [N m], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_SetMaxSteeringTorque(joint_id: mvJointId, torque: mvFloat) {
    set(joint_id, |j: &mut WheelJoint| {
        j.steering.spring.max_force = torque;
        Ok(())
    });
}

/// Get the greatest torque of the spring that steers.
/// @param jointId a wheel joint
/// @return the value [N m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetMaxSteeringTorque(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &WheelJoint, _| Ok(j.steering.spring.max_force))
}

/// Turn the limit of the steering angle on or off.
/// @param jointId a wheel joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_EnableSteeringLimit(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut WheelJoint| {
        j.steering.limit.enable = check("flag", flag)?;
        Ok(())
    });
}

/// Is the limit of the steering angle on?
/// @param jointId a wheel joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_IsSteeringLimitEnabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &WheelJoint, _| Ok(j.steering.limit.enable))
}

/// Set the limits of the steering angle.
/// @param jointId a wheel joint
/// @param lower the least [rad]
/// @param upper the greatest [rad], not below the least
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_SetSteeringLimits(joint_id: mvJointId, lower: mvFloat, upper: mvFloat) {
    set(joint_id, |j: &mut WheelJoint| {
        (j.steering.limit.lower, j.steering.limit.upper) = (lower, upper);
        Ok(())
    });
}

/// Get the limits of the steering angle: the least.
/// @param jointId a wheel joint
/// @return the least [rad]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetLowerSteeringLimit(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &WheelJoint, _| Ok(j.steering.limit.lower))
}

/// Get the limits of the steering angle: the greatest.
/// @param jointId a wheel joint
/// @return the greatest [rad]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetUpperSteeringLimit(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &WheelJoint, _| Ok(j.steering.limit.upper))
}

/// Set the angle that the spring steers to.
/// @param jointId a wheel joint
/// @param angle the value [rad]
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_SetTargetSteeringAngle(joint_id: mvJointId, angle: mvFloat) {
    set(joint_id, |j: &mut WheelJoint| {
        j.steering.target = angle;
        Ok(())
    });
}

/// Get the angle that the spring steers to.
/// @param jointId a wheel joint
/// @return the value [rad]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetTargetSteeringAngle(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &WheelJoint, _| Ok(j.steering.target))
}

/// Get the steering angle about x of frame A.
/// @param jointId a wheel joint
/// @return the angle [rad]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetSteeringAngle(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |_: &WheelJoint, r| Ok(r.steering()))
}

/// Get the torque that steers the wheel, spring and limits together.
/// @param jointId a wheel joint
/// @return the mean over the last sub-step [N m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWheelJoint_GetSteeringTorque(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |_: &WheelJoint, r| Ok(r.steering_torque()))
}
