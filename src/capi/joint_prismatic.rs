//! Prismatic joints: slides.

use super::def::cookie;
use super::def_check::{check_cookie, flag as check};
use super::guard::needed;
use super::id::{mvJointId, mvWorldId};
use super::joint::{create, get, set};
use super::joint_def::{default_base, mv_prismaticJoint, mvJointDef};
use super::{Flag, mvFloat};
use crate::constraint::joint::{Drive, JointKind, Limit, Motor, PrismaticJoint, Spring};
use crate::math::Float;

/// A prismatic joint: frame B slides along x of frame A and does not turn against it. The translation is that of
/// B's origin along x of frame A.
/// Made by mvDefaultPrismaticJointDef().
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvPrismaticJointDef {
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
    /// The greatest force of the spring [N], >= 0; default infinity.
    pub max_spring_force: mvFloat,
    /// The translation at which the spring rests [m]; default 0.
    pub target_translation: mvFloat,
    /// Whether the translation is limited; default false.
    pub enable_limit: Flag,
    /// The least translation [m]; default 0.
    pub lower_translation: mvFloat,
    /// The greatest translation [m], not below the least; default 0.
    pub upper_translation: mvFloat,
    /// Whether a motor acts; default false.
    pub enable_motor: Flag,
    /// The greatest force of the motor [N], >= 0; default 0.
    pub max_motor_force: mvFloat,
    /// The speed that the motor wants [m/s]; default 0.
    pub motor_speed: mvFloat,
    /// The force of dry friction [N], >= 0; default 0.
    pub friction: mvFloat,
}

const COOKIE: i32 = cookie::<mvPrismaticJointDef>(10 + mv_prismaticJoint as u32);

/// Get the definition of a prismatic joint with the default values.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultPrismaticJointDef() -> mvPrismaticJointDef {
    mvPrismaticJointDef {
        internal_value: COOKIE,
        base: default_base(),
        enable_spring: 0,
        hertz: 0.0,
        damping_ratio: 0.0,
        max_spring_force: Float::INFINITY,
        target_translation: 0.0,
        enable_limit: 0,
        lower_translation: 0.0,
        upper_translation: 0.0,
        enable_motor: 0,
        max_motor_force: 0.0,
        motor_speed: 0.0,
        friction: 0.0,
    }
}

/// Create a prismatic joint. Its bodies wake.
///
/// @param worldId the world that both bodies live in
/// @param def the definition, from mvDefaultPrismaticJointDef()
/// @return the joint; null for bad arguments
/// @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
/// has no joints.
#[unsafe(no_mangle)]
pub extern "C" fn mvCreatePrismaticJoint(
    world_id: mvWorldId,
    def: Option<&mvPrismaticJointDef>,
) -> mvJointId {
    create(world_id, |_| {
        let d = needed("The definition", def)?;
        check_cookie("PrismaticJoint", d.internal_value, COOKIE)?;
        Ok((
            d.base,
            JointKind::Prismatic(PrismaticJoint {
                drive: Drive {
                    spring: Spring {
                        enable: check("enableSpring", d.enable_spring)?,
                        hertz: d.hertz,
                        damping_ratio: d.damping_ratio,
                        max_force: d.max_spring_force,
                    },
                    target: d.target_translation,
                    limit: Limit {
                        enable: check("enableLimit", d.enable_limit)?,
                        lower: d.lower_translation,
                        upper: d.upper_translation,
                    },
                    motor: Motor {
                        enable: check("enableMotor", d.enable_motor)?,
                        speed: d.motor_speed,
                        max_force: d.max_motor_force,
                    },
                    friction: d.friction,
                },
            }),
        ))
    })
}

/// Turn the spring on or off.
/// @param jointId a prismatic joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_EnableSpring(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut PrismaticJoint| {
        j.drive.spring.enable = check("flag", flag)?;
        Ok(())
    });
}

/// Is the spring on?
/// @param jointId a prismatic joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_IsSpringEnabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &PrismaticJoint, _| Ok(j.drive.spring.enable))
}

/// Set the frequency of the spring.
/// @param jointId a prismatic joint
/// @param hertz the value [Hz], >= 0; 0 has no effect
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_SetSpringHertz(joint_id: mvJointId, hertz: mvFloat) {
    set(joint_id, |j: &mut PrismaticJoint| {
        j.drive.spring.hertz = hertz;
        Ok(())
    });
}

/// Get the frequency of the spring.
/// @param jointId a prismatic joint
/// @return the value [Hz]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_GetSpringHertz(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &PrismaticJoint, _| Ok(j.drive.spring.hertz))
}

/// Set the damping ratio of the spring.
/// @param jointId a prismatic joint
/// @param dampingRatio the value >= 0; 1 is critical
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_SetSpringDampingRatio(joint_id: mvJointId, damping_ratio: mvFloat) {
    set(joint_id, |j: &mut PrismaticJoint| {
        j.drive.spring.damping_ratio = damping_ratio;
        Ok(())
    });
}

/// Get the damping ratio of the spring.
/// @param jointId a prismatic joint
/// @return the value; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_GetSpringDampingRatio(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &PrismaticJoint, _| Ok(j.drive.spring.damping_ratio))
}

/// Set the greatest force of the spring.
/// @param jointId a prismatic joint
/// @param maxForce the value [N], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_SetMaxSpringForce(joint_id: mvJointId, max_force: mvFloat) {
    set(joint_id, |j: &mut PrismaticJoint| {
        j.drive.spring.max_force = max_force;
        Ok(())
    });
}

/// Get the greatest force of the spring.
/// @param jointId a prismatic joint
/// @return the value [N]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_GetMaxSpringForce(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &PrismaticJoint, _| Ok(j.drive.spring.max_force))
}

/// Set the translation at which the spring rests.
/// @param jointId a prismatic joint
/// @param targetTranslation the value [m]
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_SetTargetTranslation(joint_id: mvJointId, target_translation: mvFloat) {
    set(joint_id, |j: &mut PrismaticJoint| {
        j.drive.target = target_translation;
        Ok(())
    });
}

/// Get the translation at which the spring rests.
/// @param jointId a prismatic joint
/// @return the value [m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_GetTargetTranslation(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &PrismaticJoint, _| Ok(j.drive.target))
}

/// Turn the limit on or off.
/// @param jointId a prismatic joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_EnableLimit(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut PrismaticJoint| {
        j.drive.limit.enable = check("flag", flag)?;
        Ok(())
    });
}

/// Is the limit on?
/// @param jointId a prismatic joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_IsLimitEnabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &PrismaticJoint, _| Ok(j.drive.limit.enable))
}

/// Set the limits of the translation.
/// @param jointId a prismatic joint
/// @param lower the least [m]
/// @param upper the greatest [m], not below the least
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_SetLimits(joint_id: mvJointId, lower: mvFloat, upper: mvFloat) {
    set(joint_id, |j: &mut PrismaticJoint| {
        (j.drive.limit.lower, j.drive.limit.upper) = (lower, upper);
        Ok(())
    });
}

/// Get the limits of the translation: the least.
/// @param jointId a prismatic joint
/// @return the least [m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_GetLowerLimit(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &PrismaticJoint, _| Ok(j.drive.limit.lower))
}

/// Get the limits of the translation: the greatest.
/// @param jointId a prismatic joint
/// @return the greatest [m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_GetUpperLimit(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &PrismaticJoint, _| Ok(j.drive.limit.upper))
}

/// Turn the motor on or off.
/// @param jointId a prismatic joint
/// @param flag whether it acts
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_EnableMotor(joint_id: mvJointId, flag: Flag) {
    set(joint_id, |j: &mut PrismaticJoint| {
        j.drive.motor.enable = check("flag", flag)?;
        Ok(())
    });
}

/// Is the motor on?
/// @param jointId a prismatic joint; false for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_IsMotorEnabled(joint_id: mvJointId) -> bool {
    get(joint_id, |j: &PrismaticJoint, _| Ok(j.drive.motor.enable))
}

/// Set the speed that the motor wants.
/// @param jointId a prismatic joint
/// @param motorSpeed the value [m/s]
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_SetMotorSpeed(joint_id: mvJointId, motor_speed: mvFloat) {
    set(joint_id, |j: &mut PrismaticJoint| {
        j.drive.motor.speed = motor_speed;
        Ok(())
    });
}

/// Get the speed that the motor wants.
/// @param jointId a prismatic joint
/// @return the value [m/s]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_GetMotorSpeed(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &PrismaticJoint, _| Ok(j.drive.motor.speed))
}

/// Set the greatest force of the motor.
/// @param jointId a prismatic joint
/// @param maxForce the value [N], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_SetMaxMotorForce(joint_id: mvJointId, max_force: mvFloat) {
    set(joint_id, |j: &mut PrismaticJoint| {
        j.drive.motor.max_force = max_force;
        Ok(())
    });
}

/// Get the greatest force of the motor.
/// @param jointId a prismatic joint
/// @return the value [N]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_GetMaxMotorForce(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &PrismaticJoint, _| Ok(j.drive.motor.max_force))
}

/// Get the force of the motor.
/// @param jointId a prismatic joint
/// @return the mean over the last sub-step [N]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_GetMotorForce(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |_: &PrismaticJoint, r| Ok(r.motor_force().x))
}

/// Set the force of dry friction.
/// @param jointId a prismatic joint
/// @param friction the value [N], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_SetFriction(joint_id: mvJointId, friction: mvFloat) {
    set(joint_id, |j: &mut PrismaticJoint| {
        j.drive.friction = friction;
        Ok(())
    });
}

/// Get the force of dry friction.
/// @param jointId a prismatic joint
/// @return the value [N]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_GetFriction(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &PrismaticJoint, _| Ok(j.drive.friction))
}

/// Get how far frame B is along x of frame A.
/// @param jointId a prismatic joint
/// @return the translation [m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_GetTranslation(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |_: &PrismaticJoint, r| Ok(r.coordinate()))
}

/// Get how fast the translation changes.
/// @param jointId a prismatic joint
/// @return the speed [m/s]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPrismaticJoint_GetSpeed(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |_: &PrismaticJoint, r| Ok(r.speed()))
}
