//! Rack and pinion: a turn in step with a slide.

use super::def::cookie;
use super::def_check::check_cookie;
use super::guard::needed;
use super::id::{mvJointId, mvWorldId};
use super::joint::{RackPinion, create, get, set};
use super::joint_def::{default_base, mv_rackPinionJoint, mvJointDef};
use super::mvFloat;
use crate::constraint::joint::{GearJoint, JointKind};

/// A rack and pinion: the angle of a revolute joint stays in step with the translation of a prismatic joint: the
/// angle plus ratio times the translation does not change. The bodies and frames in base are not used: those of the
/// two joints count. It is destroyed with either of them.
/// Made by mvDefaultRackPinionJointDef().
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvRackPinionJointDef {
    /// Shows that the definition was made by its function. Leave it alone.
    pub internal_value: i32,
    /// What all joints have.
    pub base: mvJointDef,
    /// The pinion: a revolute joint.
    pub joint_id_a: mvJointId,
    /// The rack: a prismatic joint.
    pub joint_id_b: mvJointId,
    /// How far the angle goes back when the rack goes on by 1 m [rad/m], not 0: 1 divided by the radius of the
    /// pinion, or minus that; default 1.
    pub ratio: mvFloat,
}

const COOKIE: i32 = cookie::<mvRackPinionJointDef>(10 + mv_rackPinionJoint as u32);

/// Get the definition of a rack-and-pinion joint with the default values.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultRackPinionJointDef() -> mvRackPinionJointDef {
    mvRackPinionJointDef {
        internal_value: COOKIE,
        base: default_base(),
        joint_id_a: super::guard::Neutral::NEUTRAL,
        joint_id_b: super::guard::Neutral::NEUTRAL,
        ratio: 1.0,
    }
}

/// Create a rack-and-pinion joint. Its bodies wake.
///
/// @param worldId the world that both bodies live in
/// @param def the definition, from mvDefaultRackPinionJointDef()
/// @return the joint; null for bad arguments
/// @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
/// has no joints.
#[unsafe(no_mangle)]
pub extern "C" fn mvCreateRackPinionJoint(
    world_id: mvWorldId,
    def: Option<&mvRackPinionJointDef>,
) -> mvJointId {
    create(world_id, |w| {
        let d = needed("The definition", def)?;
        check_cookie("RackPinionJoint", d.internal_value, COOKIE)?;
        let (a, b) = (d.joint_id_a.into(), d.joint_id_b.into());
        let gear = GearJoint::between(w, a, b, d.ratio)?;
        Ok((d.base.between(w.joint(a)?.body_a(), w.joint(b)?.body_b()), JointKind::RackPinion(gear)))
    })
}

/// Set the ratio: how far the angle goes back when the rack goes on by 1 m.
/// @param jointId a rack-and-pinion joint
/// @param ratio the value [rad/m], not 0
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvRackPinionJoint_SetRatio(joint_id: mvJointId, ratio: mvFloat) {
    set(joint_id, |j: &mut RackPinion| {
        j.0.ratio = ratio;
        Ok(())
    });
}

/// Get the ratio: how far the angle goes back when the rack goes on by 1 m.
/// @param jointId a rack-and-pinion joint
/// @return the value [rad/m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvRackPinionJoint_GetRatio(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &RackPinion, _| Ok(j.0.ratio))
}
