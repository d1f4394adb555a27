//! Joints of six axes, each free, locked or limited.

use super::def::cookie;
use super::def_check::{check_cookie, choice, flag as check};
use super::guard::{needed, neutral};
use super::id::{mvJointId, mvWorldId};
use super::joint::{create, get, set};
use super::joint_def::{default_base, mv_sixDofJoint, mvJointDef};
use super::{Flag, mvFloat};
use crate::constraint::joint::six_dof::Axis;
use crate::constraint::joint::{AxisMode, Drive, JointKind, Limit, Motor, SixDofJoint, Spring};
use crate::error::{Error, ErrorCode, Result};
use crate::math::Float;
use core::ffi::c_int;

/// What an axis of a six-axes joint may do: one of mv_axisFree, mv_axisLocked, mv_axisLimited.
pub type mvAxisMode = i32;
/// The axis is free; spring, motor and friction may act.
pub const mv_axisFree: mvAxisMode = 0;
/// The axis is held at 0.
pub const mv_axisLocked: mvAxisMode = 1;
/// The axis is kept within its limits; spring, motor and friction may act.
pub const mv_axisLimited: mvAxisMode = 2;

const _: () = {
    assert!(mv_axisFree == AxisMode::Free as i32);
    assert!(mv_axisLocked == AxisMode::Locked as i32);
    assert!(mv_axisLimited == AxisMode::Limited as i32);
};

/// One axis of a six-axes joint. Lengths [m] and forces [N] for the first three, angles [rad] and torques [N m] for the
/// others.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvSixDofAxis {
    /// What the axis may do; default mv_axisLocked.
    pub mode: mvAxisMode,
    /// Where the spring rests; default 0.
    pub target: mvFloat,
    /// The frequency of the spring [Hz], >= 0; default 0: no force.
    pub hertz: mvFloat,
    /// Its damping ratio, >= 0; 1 is critical; default 0.
    pub damping_ratio: mvFloat,
    /// Its greatest force or torque, >= 0; default infinity.
    pub max_spring_force: mvFloat,
    /// The least value, where the mode is mv_axisLimited; default 0.
    pub lower: mvFloat,
    /// The greatest value, not below the least; default 0.
    pub upper: mvFloat,
    /// The speed that the motor wants [m/s or rad/s]; default 0.
    pub motor_speed: mvFloat,
    /// The greatest force or torque of the motor, >= 0; default 0.
    pub max_motor_force: mvFloat,
    /// The force or torque of dry friction, >= 0; default 0.
    pub friction: mvFloat,
    /// Whether the spring acts; default false.
    pub enable_spring: Flag,
    /// Whether the motor acts; default false.
    pub enable_motor: Flag,
}

const NO_AXIS: mvSixDofAxis = mvSixDofAxis {
    mode: 0,
    target: 0.0,
    hertz: 0.0,
    damping_ratio: 0.0,
    max_spring_force: 0.0,
    lower: 0.0,
    upper: 0.0,
    motor_speed: 0.0,
    max_motor_force: 0.0,
    friction: 0.0,
    enable_spring: 0,
    enable_motor: 0,
};

neutral! {
    mvSixDofAxis = NO_AXIS;
}

fn default_axis() -> mvSixDofAxis {
    mvSixDofAxis { mode: mv_axisLocked, max_spring_force: Float::INFINITY, ..NO_AXIS }
}

impl mvSixDofAxis {
    fn checked(&self) -> Result<Axis> {
        let modes = [AxisMode::Free, AxisMode::Locked, AxisMode::Limited];
        Ok(Axis {
            mode: choice("mode", self.mode, &modes, |m| m as i32)?,
            drive: Drive {
                spring: Spring {
                    enable: check("enableSpring", self.enable_spring)?,
                    hertz: self.hertz,
                    damping_ratio: self.damping_ratio,
                    max_force: self.max_spring_force,
                },
                target: self.target,
                limit: Limit { enable: false, lower: self.lower, upper: self.upper },
                motor: Motor {
                    enable: check("enableMotor", self.enable_motor)?,
                    speed: self.motor_speed,
                    max_force: self.max_motor_force,
                },
                friction: self.friction,
            },
        })
    }
}

impl From<&Axis> for mvSixDofAxis {
    fn from(a: &Axis) -> Self {
        let d = &a.drive;
        Self {
            mode: a.mode as i32,
            target: d.target,
            hertz: d.spring.hertz,
            damping_ratio: d.spring.damping_ratio,
            max_spring_force: d.spring.max_force,
            lower: d.limit.lower,
            upper: d.limit.upper,
            motor_speed: d.motor.speed,
            max_motor_force: d.motor.max_force,
            friction: d.friction,
            enable_spring: d.spring.enable.into(),
            enable_motor: d.motor.enable.into(),
        }
    }
}

/// Which axis, and whether it is one of the turns.
fn place(axis: c_int) -> Result<(bool, usize)> {
    match axis {
        0..=2 => Ok((false, axis as usize)),
        3..=5 => Ok((true, axis as usize - 3)),
        _ => Err(Error::new(ErrorCode::Range, format!("axis is {axis}; it must be 0 to 5."))),
    }
}

/// A joint of six axes, each of them free, locked or limited, with spring, motor and friction. Axes 0 to 2 are the
/// parts along x, y, z of frame A of the way from its origin to that of frame B; axes 3 to 5 the parts of the
/// rotation vector of frame B against frame A.
/// Made by mvDefaultSixDofJointDef(): all locked.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvSixDofJointDef {
    /// Shows that the definition was made by its function. Leave it alone.
    pub internal_value: i32,
    /// What all joints have.
    pub base: mvJointDef,
    /// The axes: along x, y, z [m], then about x, y, z [rad]. All locked by default.
    pub axes: [mvSixDofAxis; 6],
}

const COOKIE: i32 = cookie::<mvSixDofJointDef>(10 + mv_sixDofJoint as u32);

/// Get the definition of a six-axes joint with the default values.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultSixDofJointDef() -> mvSixDofJointDef {
    mvSixDofJointDef { internal_value: COOKIE, base: default_base(), axes: [default_axis(); 6] }
}

/// Create a six-axes joint. Its bodies wake.
///
/// @param worldId the world that both bodies live in
/// @param def the definition, from mvDefaultSixDofJointDef()
/// @return the joint; null for bad arguments
/// @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
/// has no joints.
#[unsafe(no_mangle)]
pub extern "C" fn mvCreateSixDofJoint(world_id: mvWorldId, def: Option<&mvSixDofJointDef>) -> mvJointId {
    create(world_id, |_| {
        let d = needed("The definition", def)?;
        check_cookie("SixDofJoint", d.internal_value, COOKIE)?;
        let axes = |k: usize| Ok([d.axes[k].checked()?, d.axes[k + 1].checked()?, d.axes[k + 2].checked()?]);
        Ok((d.base, JointKind::SixDof(SixDofJoint { linear: axes(0)?, angular: axes(3)? })))
    })
}

/// Set everything about one axis.
/// @param jointId a six-axes joint
/// @param axis which, 0 to 5
/// @param value the axis as it shall be
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvSixDofJoint_SetAxis(joint_id: mvJointId, axis: c_int, value: mvSixDofAxis) {
    set(joint_id, |j: &mut SixDofJoint| {
        let (turns, k) = place(axis)?;
        let axes = if turns { &mut j.angular } else { &mut j.linear };
        axes[k] = value.checked()?;
        Ok(())
    });
}

/// Get everything about one axis.
/// @param jointId a six-axes joint
/// @param axis which, 0 to 5
/// @return the axis; zeros for bad arguments
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvSixDofJoint_GetAxis(joint_id: mvJointId, axis: c_int) -> mvSixDofAxis {
    get(joint_id, |j: &SixDofJoint, _| {
        let (turns, k) = place(axis)?;
        Ok(if turns { &j.angular[k] } else { &j.linear[k] }.into())
    })
}

/// Get where frame B is along or about one axis.
/// @param jointId a six-axes joint
/// @param axis which, 0 to 5
/// @return the part of the way along that axis [m], or of the rotation vector [rad]; 0 for bad arguments
/// @note Errors: mv_errorRange, also for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvSixDofJoint_GetCoordinate(joint_id: mvJointId, axis: c_int) -> mvFloat {
    get(joint_id, |_: &SixDofJoint, r| {
        let (turns, k) = place(axis)?;
        let (way, turn) = r.six_coordinates();
        Ok(if turns { turn[k] } else { way[k] })
    })
}
