//! Universal joints, after Cardan.

use super::def::cookie;
use super::def_check::{check_cookie, flag as check};
use super::guard::needed;
use super::id::{mvJointId, mvWorldId};
use super::joint::{create, get, set};
use super::joint_def::{default_base, mv_universalJoint, mvJointDef};
use super::{Flag, mvFloat};
use crate::constraint::joint::{Drive, JointKind, Limit, Motor, Spring, UniversalJoint};

/// A universal joint: the origins of the frames stay together and x of frame A stays across y of frame B. B turns
/// about x of frame A by the first angle and about its own y by the second.
/// Made by mvDefaultUniversalJointDef().
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvUniversalJointDef {
    /// Shows that the definition was made by its function. Leave it alone.
    pub internal_value: i32,
    /// What all joints have.
    pub base: mvJointDef,
    /// Whether a spring acts on the angle about x of frame A; default false.
    pub enable_spring1: Flag,
    /// Its frequency [Hz], >= 0; default 0: no torque.
    pub hertz1: mvFloat,
    /// Its damping ratio, >= 0; 1 is critical; default 0.
    pub damping_ratio1: mvFloat,
    /// The angle at which it rests [rad]; default 0.
    pub target_angle1: mvFloat,
    /// Whether the angle about x of frame A is limited; default false.
    pub enable_limit1: Flag,
    /// The least angle [rad]; default 0.
    pub lower_angle1: mvFloat,
    /// The greatest angle [rad], not below the least; default 0.
    pub upper_angle1: mvFloat,
    /// Whether a motor turns B about x of frame A; default false.
    pub enable_motor1: Flag,
    /// Its greatest torque [N m], >= 0; default 0.
    pub max_motor_torque1: mvFloat,
    /// The speed that it wants [rad/s]; default 0.
    pub motor_speed1: mvFloat,
    /// The torque of dry friction about x of frame A [N m], >= 0; default 0.
    pub friction1: mvFloat,
    /// Whether a spring acts on the angle about y of frame B; default false.
    pub enable_spring2: Flag,
    /// Its frequency [Hz], >= 0; default 0: no torque.
    pub hertz2: mvFloat,
    /// Its damping ratio, >= 0; 1 is critical; default 0.
    pub damping_ratio2: mvFloat,
    /// The angle at which it rests [rad]; default 0.
    pub target_angle2: mvFloat,
    /// Whether the angle about y of frame B is limited; default false.
    pub enable_limit2: Flag,
    /// The least angle [rad]; default 0.
    pub lower_angle2: mvFloat,
    /// The greatest angle [rad], not below the least; default 0.
    pub upper_angle2: mvFloat,
    /// Whether a motor turns B about y of frame B; default false.
    pub enable_motor2: Flag,
    /// Its greatest torque [N m], >= 0; default 0.
    pub max_motor_torque2: mvFloat,
    /// The speed that it wants [rad/s]; default 0.
    pub motor_speed2: mvFloat,
    /// The torque of dry friction about y of frame B [N m], >= 0; default 0.
    pub friction2: mvFloat,
}

const COOKIE: i32 = cookie::<mvUniversalJointDef>(10 + mv_universalJoint as u32);

/// Get the definition of an universal joint with the default values.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultUniversalJointDef() -> mvUniversalJointDef {
    mvUniversalJointDef {
        internal_value: COOKIE,
        base: default_base(),
        enable_spring1: 0,
        hertz1: 0.0,
        damping_ratio1: 0.0,
        target_angle1: 0.0,
        enable_limit1: 0,
        lower_angle1: 0.0,
        upper_angle1: 0.0,
        enable_motor1: 0,
        max_motor_torque1: 0.0,
        motor_speed1: 0.0,
        friction1: 0.0,
        enable_spring2: 0,
        hertz2: 0.0,
        damping_ratio2: 0.0,
        target_angle2: 0.0,
        enable_limit2: 0,
        lower_angle2: 0.0,
        upper_angle2: 0.0,
        enable_motor2: 0,
        max_motor_torque2: 0.0,
        motor_speed2: 0.0,
        friction2: 0.0,
    }
}

/// Create an universal joint. Its bodies wake.
///
/// @param worldId the world that both bodies live in
/// @param def the definition, from mvDefaultUniversalJointDef()
/// @return the joint; null for bad arguments
/// @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
/// has no joints.
#[unsafe(no_mangle)]
pub extern "C" fn mvCreateUniversalJoint(
    world_id: mvWorldId,
    def: Option<&mvUniversalJointDef>,
) -> mvJointId {
    create(world_id, |_| {
        let d = needed("The definition", def)?;
        check_cookie("UniversalJoint", d.internal_value, COOKIE)?;
        let drives = [
            Drive {
                spring: Spring {
                    enable: check("enableSpring1", d.enable_spring1)?,
                    hertz: d.hertz1,
                    damping_ratio: d.damping_ratio1,
                    ..Spring::default()
                },
                target: d.target_angle1,
                limit: Limit {
                    enable: check("enableLimit1", d.enable_limit1)?,
                    lower: d.lower_angle1,
                    upper: d.upper_angle1,
                },
                motor: Motor {
                    enable: check("enableMotor1", d.enable_motor1)?,
                    speed: d.motor_speed1,
                    max_force: d.max_motor_torque1,
                },
                friction: d.friction1,
            },
            Drive {
                spring: Spring {
                    enable: check("enableSpring2", d.enable_spring2)?,
                    hertz: d.hertz2,
                    damping_ratio: d.damping_ratio2,
                    ..Spring::default()
                },
                target: d.target_angle2,
                limit: Limit {
                    enable: check("enableLimit2", d.enable_limit2)?,
                    lower: d.lower_angle2,
                    upper: d.upper_angle2,
                },
                motor: Motor {
                    enable: check("enableMotor2", d.enable_motor2)?,
                    speed: d.motor_speed2,
                    max_force: d.max_motor_torque2,
                },
                friction: d.friction2,
            },
        ];
        Ok((d.base, JointKind::Universal(UniversalJoint { drives })))
    })
}

/// Get the angle about x of frame A.
/// @param jointId a universal joint
/// @return the angle [rad], -pi to pi; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_GetAngle1(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |_: &UniversalJoint, r| Ok(r.universal_angles()[0]))
}

/// Turn the spring about x of frame A on or off.
/// @param jointId a universal joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_EnableSpring1(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut UniversalJoint| {
        j.drives[0].spring.enable = check("flag", flag)?;
        Ok(())
    });
}

/// Is the spring about x of frame A on?
/// @param jointId a universal joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_IsSpring1Enabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[0].spring.enable))
}

/// Set the frequency of the spring about x of frame A.
/// @param jointId a universal joint
/// @param hertz the value [Hz], >= 0; 0 has no effect
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_SetSpringHertz1(joint_id: mvJointId, hertz: mvFloat) {
    set(joint_id, |j: &mut UniversalJoint| {
        j.drives[0].spring.hertz = hertz;
        Ok(())
    });
}

/// Get the frequency of the spring about x of frame A.
/// @param jointId a universal joint
/// @return the value [Hz]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_GetSpringHertz1(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[0].spring.hertz))
}

/// Set the damping ratio of the spring about x of frame A.
/// @param jointId a universal joint
/// @param dampingRatio the value >= 0; 1 is critical
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_SetSpringDampingRatio1(joint_id: mvJointId, damping_ratio: mvFloat) {
    set(joint_id, |j: &mut UniversalJoint| {
        j.drives[0].spring.damping_ratio = damping_ratio;
        Ok(())
    });
}

/// Get the damping ratio of the spring about x of frame A.
/// @param jointId a universal joint
/// @return the value; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_GetSpringDampingRatio1(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[0].spring.damping_ratio))
}

/// Set the angle about x of frame A at which the spring rests.
/// @param jointId a universal joint
/// @param angle the value [rad]
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_SetTargetAngle1(joint_id: mvJointId, angle: mvFloat) {
    set(joint_id, |j: &mut UniversalJoint| {
        j.drives[0].target = angle;
        Ok(())
    });
}

/// Get the angle about x of frame A at which the spring rests.
/// @param jointId a universal joint
/// @return the value [rad]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_GetTargetAngle1(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[0].target))
}

/// Turn the limit of the angle about x of frame A on or off.
/// @param jointId a universal joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_EnableLimit1(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut UniversalJoint| {
        j.drives[0].limit.enable = check("flag", flag)?;
        Ok(())
    });
}

/// Is the limit of the angle about x of frame A on?
/// @param jointId a universal joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_IsLimit1Enabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[0].limit.enable))
}

/// Set the limits of the angle about x of frame A.
/// @param jointId a universal joint
/// @param lower the least [rad]
/// @param upper the greatest [rad], not below the least
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_SetLimits1(joint_id: mvJointId, lower: mvFloat, upper: mvFloat) {
    set(joint_id, |j: &mut UniversalJoint| {
        (j.drives[0].limit.lower, j.drives[0].limit.upper) = (lower, upper);
        Ok(())
    });
}

/// Get the limits of the angle about x of frame A: the least.
/// @param jointId a universal joint
/// @return the least [rad]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_GetLowerLimit1(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[0].limit.lower))
}

/// Get the limits of the angle about x of frame A: the greatest.
/// @param jointId a universal joint
/// @return the greatest [rad]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_GetUpperLimit1(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[0].limit.upper))
}

/// Turn the motor about x of frame A on or off.
/// @param jointId a universal joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_EnableMotor1(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut UniversalJoint| {
        j.drives[0].motor.enable = check("flag", flag)?;
        Ok(())
    });
}

/// Is the motor about x of frame A on?
/// @param jointId a universal joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_IsMotor1Enabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[0].motor.enable))
}

/// Set the speed that the motor about x of frame A wants.
/// @param jointId a universal joint
/// @param motorSpeed the value [rad/s]
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_SetMotorSpeed1(joint_id: mvJointId, motor_speed: mvFloat) {
    set(joint_id, |j: &mut UniversalJoint| {
        j.drives[0].motor.speed = motor_speed;
        Ok(())
    });
}

/// Get the speed that the motor about x of frame A wants.
/// @param jointId a universal joint
/// @return the value [rad/s]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_GetMotorSpeed1(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[0].motor.speed))
}

/// Set the greatest torque of the motor about x of frame A.
/// @param jointId a universal joint
/// @param torque the value [N m], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_SetMaxMotorTorque1(joint_id: mvJointId, torque: mvFloat) {
    set(joint_id, |j: &mut UniversalJoint| {
        j.drives[0].motor.max_force = torque;
        Ok(())
    });
}

/// Get the greatest torque of the motor about x of frame A.
/// @param jointId a universal joint
/// @return the value [N m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_GetMaxMotorTorque1(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[0].motor.max_force))
}

/// Set the torque of dry friction about x of frame A.
/// @param jointId a universal joint
/// @param torque the value [N m], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_SetFriction1(joint_id: mvJointId, torque: mvFloat) {
    set(joint_id, |j: &mut UniversalJoint| {
        j.drives[0].friction = torque;
        Ok(())
    });
}

/// Get the torque of dry friction about x of frame A.
/// @param jointId a universal joint
/// @return the value [N m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_GetFriction1(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[0].friction))
}

/// Get the angle about y of frame B.
/// @param jointId a universal joint
/// @return the angle [rad], -pi to pi; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_GetAngle2(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |_: &UniversalJoint, r| Ok(r.universal_angles()[1]))
}

/// Turn the spring about y of frame B on or off.
/// @param jointId a universal joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_EnableSpring2(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut UniversalJoint| {
        j.drives[1].spring.enable = check("flag", flag)?;
        Ok(())
    });
}

/// Is the spring about y of frame B on?
/// @param jointId a universal joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_IsSpring2Enabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[1].spring.enable))
}

/// Set the frequency of the spring about y of frame B.
/// @param jointId a universal joint
/// @param hertz the value [Hz], >= 0; 0 has no effect
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_SetSpringHertz2(joint_id: mvJointId, hertz: mvFloat) {
    set(joint_id, |j: &mut UniversalJoint| {
        j.drives[1].spring.hertz = hertz;
        Ok(())
    });
}

/// Get the frequency of the spring about y of frame B.
/// @param jointId a universal joint
/// @return the value [Hz]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_GetSpringHertz2(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[1].spring.hertz))
}

/// Set the damping ratio of the spring about y of frame B.
/// @param jointId a universal joint
/// @param dampingRatio the value >= 0; 1 is critical
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_SetSpringDampingRatio2(joint_id: mvJointId, damping_ratio: mvFloat) {
    set(joint_id, |j: &mut UniversalJoint| {
        j.drives[1].spring.damping_ratio = damping_ratio;
        Ok(())
    });
}

/// Get the damping ratio of the spring about y of frame B.
/// @param jointId a universal joint
/// @return the value; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_GetSpringDampingRatio2(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[1].spring.damping_ratio))
}

/// Set the angle about y of frame B at which the spring rests.
/// @param jointId a universal joint
/// @param angle the value [rad]
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_SetTargetAngle2(joint_id: mvJointId, angle: mvFloat) {
    set(joint_id, |j: &mut UniversalJoint| {
        j.drives[1].target = angle;
        Ok(())
    });
}

/// Get the angle about y of frame B at which the spring rests.
/// @param jointId a universal joint
/// @return the value [rad]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_GetTargetAngle2(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[1].target))
}

/// Turn the limit of the angle about y of frame B on or off.
/// @param jointId a universal joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_EnableLimit2(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut UniversalJoint| {
        j.drives[1].limit.enable = check("flag", flag)?;
        Ok(())
    });
}

/// Is the limit of the angle about y of frame B on?
/// @param jointId a universal joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_IsLimit2Enabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[1].limit.enable))
}

/// Set the limits of the angle about y of frame B.
/// @param jointId a universal joint
/// @param lower the least [rad]
/// @param upper the greatest [rad], not below the least
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_SetLimits2(joint_id: mvJointId, lower: mvFloat, upper: mvFloat) {
    set(joint_id, |j: &mut UniversalJoint| {
        (j.drives[1].limit.lower, j.drives[1].limit.upper) = (lower, upper);
        Ok(())
    });
}

/// Get the limits of the angle about y of frame B: the least.
/// @param jointId a universal joint
/// @return the least [rad]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_GetLowerLimit2(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[1].limit.lower))
}

/// Get the limits of the angle about y of frame B: the greatest.
/// @param jointId a universal joint
/// @return the greatest [rad]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_GetUpperLimit2(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[1].limit.upper))
}

/// Turn the motor about y of frame B on or off.
/// @param jointId a universal joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_EnableMotor2(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut UniversalJoint| {
        j.drives[1].motor.enable = check("flag", flag)?;
        Ok(())
    });
}

/// Is the motor about y of frame B on?
/// @param jointId a universal joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_IsMotor2Enabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[1].motor.enable))
}

/// Set the speed that the motor about y of frame B wants.
/// @param jointId a universal joint
/// @param motorSpeed the value [rad/s]
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_SetMotorSpeed2(joint_id: mvJointId, motor_speed: mvFloat) {
    set(joint_id, |j: &mut UniversalJoint| {
        j.drives[1].motor.speed = motor_speed;
        Ok(())
    });
}

/// Get the speed that the motor about y of frame B wants.
/// @param jointId a universal joint
/// @return the value [rad/s]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_GetMotorSpeed2(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[1].motor.speed))
}

/// Set the greatest torque of the motor about y of frame B.
/// @param jointId a universal joint
/// @param torque the value [N m], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_SetMaxMotorTorque2(joint_id: mvJointId, torque: mvFloat) {
    set(joint_id, |j: &mut UniversalJoint| {
        j.drives[1].motor.max_force = torque;
        Ok(())
    });
}

/// Get the greatest torque of the motor about y of frame B.
/// @param jointId a universal joint
/// @return the value [N m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_GetMaxMotorTorque2(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[1].motor.max_force))
}

/// Set the torque of dry friction about y of frame B.
/// @param jointId a universal joint
/// @param torque the value [N m], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_SetFriction2(joint_id: mvJointId, torque: mvFloat) {
    set(joint_id, |j: &mut UniversalJoint| {
        j.drives[1].friction = torque;
        Ok(())
    });
}

/// Get the torque of dry friction about y of frame B.
/// @param jointId a universal joint
/// @return the value [N m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvUniversalJoint_GetFriction2(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &UniversalJoint, _| Ok(j.drives[1].friction))
}
