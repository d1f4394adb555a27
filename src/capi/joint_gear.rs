//! Gear joints: two joints in step.

use super::def::cookie;
use super::def_check::check_cookie;
use super::guard::needed;
use super::id::{mvJointId, mvWorldId};
use super::joint::{Gear, create, get, set};
use super::joint_def::{default_base, mv_gearJoint, mvJointDef};
use super::mvFloat;
use crate::constraint::joint::{GearJoint, JointKind};

/// A gear joint: the coordinates of two joints, each revolute or prismatic, stay in step: that of the first plus
/// ratio times that of the second does not change. The bodies and frames in base are not used: those of the two
/// joints count. It is destroyed with either of them.
/// Made by mvDefaultGearJointDef().
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvGearJointDef {
    /// Shows that the definition was made by its function. Leave it alone.
    pub internal_value: i32,
    /// What all joints have.
    pub base: mvJointDef,
    /// The first joint, revolute or prismatic.
    pub joint_id_a: mvJointId,
    /// The second joint, revolute or prismatic.
    pub joint_id_b: mvJointId,
    /// How far the first coordinate goes back when the second goes on by 1, not 0; default 1.
    pub ratio: mvFloat,
}

const COOKIE: i32 = cookie::<mvGearJointDef>(10 + mv_gearJoint as u32);

/// Get the definition of a gear joint with the default values.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultGearJointDef() -> mvGearJointDef {
    mvGearJointDef {
        internal_value: COOKIE,
        base: default_base(),
        joint_id_a: super::guard::Neutral::NEUTRAL,
        joint_id_b: super::guard::Neutral::NEUTRAL,
        ratio: 1.0,
    }
}

/// Create a gear joint. Its bodies wake.
///
/// @param worldId the world that both bodies live in
/// @param def the definition, from mvDefaultGearJointDef()
/// @return the joint; null for bad arguments
/// @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
/// has no joints.
#[unsafe(no_mangle)]
pub extern "C" fn mvCreateGearJoint(world_id: mvWorldId, def: Option<&mvGearJointDef>) -> mvJointId {
    create(world_id, |w| {
        let d = needed("The definition", def)?;
        check_cookie("GearJoint", d.internal_value, COOKIE)?;
        let (a, b) = (d.joint_id_a.into(), d.joint_id_b.into());
        let gear = GearJoint::between(w, a, b, d.ratio)?;
        Ok((d.base.between(w.joint(a)?.body_a(), w.joint(b)?.body_b()), JointKind::Gear(gear)))
    })
}

/// Set the ratio: how far the first coordinate goes back when the second goes on by 1.
/// @param jointId a gear joint
/// @param ratio the value , not 0
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvGearJoint_SetRatio(joint_id: mvJointId, ratio: mvFloat) {
    set(joint_id, |j: &mut Gear| {
        j.0.ratio = ratio;
        Ok(())
    });
}

/// Get the ratio: how far the first coordinate goes back when the second goes on by 1.
/// @param jointId a gear joint
/// @return the value; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvGearJoint_GetRatio(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &Gear, _| Ok(j.0.ratio))
}
