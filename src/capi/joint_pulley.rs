//! Pulley joints: a rope over two fixed points.

use super::def::cookie;
use super::def_check::check_cookie;
use super::guard::needed;
use super::id::{mvJointId, mvWorldId};
use super::joint::{create, get, set};
use super::joint_def::{default_base, mv_pulleyJoint, mvJointDef};
use super::math::{ORIGIN, mvPos};
use super::mvFloat;
use crate::constraint::joint::{JointKind, PulleyJoint};
use crate::error::check::positive;

/// A pulley joint: a rope runs from body A over a fixed point to another and down to body B. Its length, the part
/// at A plus ratio times the part at B, stays within bounds.
/// Made by mvDefaultPulleyJointDef().
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvPulleyJointDef {
    /// Shows that the definition was made by its function. Leave it alone.
    pub internal_value: i32,
    /// What all joints have.
    pub base: mvJointDef,
    /// The fixed point above body A, in the world [m]; default the origin.
    pub ground_anchor_a: mvPos,
    /// The fixed point above body B, in the world [m]; default the origin.
    pub ground_anchor_b: mvPos,
    /// How many lengths of rope hold B for each that holds A, > 0; default 1.
    pub ratio: mvFloat,
    /// The least length [m], >= 0; 0, the default: the rope may be slack.
    pub min_length: mvFloat,
    /// The greatest length [m], >= 0; 0, the default: what it is when the joint is made.
    pub max_length: mvFloat,
}

const COOKIE: i32 = cookie::<mvPulleyJointDef>(10 + mv_pulleyJoint as u32);

/// Get the definition of a pulley joint with the default values.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultPulleyJointDef() -> mvPulleyJointDef {
    mvPulleyJointDef {
        internal_value: COOKIE,
        base: default_base(),
        ground_anchor_a: ORIGIN,
        ground_anchor_b: ORIGIN,
        ratio: 1.0,
        min_length: 0.0,
        max_length: 0.0,
    }
}

/// Create a pulley joint. Its bodies wake.
///
/// @param worldId the world that both bodies live in
/// @param def the definition, from mvDefaultPulleyJointDef()
/// @return the joint; null for bad arguments
/// @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
/// has no joints.
#[unsafe(no_mangle)]
pub extern "C" fn mvCreatePulleyJoint(world_id: mvWorldId, def: Option<&mvPulleyJointDef>) -> mvJointId {
    create(world_id, |_| {
        let d = needed("The definition", def)?;
        check_cookie("PulleyJoint", d.internal_value, COOKIE)?;
        let kind = PulleyJoint {
            ground: [d.ground_anchor_a.raw(), d.ground_anchor_b.raw()],
            ratio: d.ratio,
            min_length: d.min_length,
            max_length: d.max_length,
        };
        Ok((d.base, JointKind::Pulley(kind)))
    })
}

/// Move the fixed point above body A.
/// @param jointId a pulley joint
/// @param anchor the point, in the world [m]
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvPulleyJoint_SetGroundAnchorA(joint_id: mvJointId, anchor: mvPos) {
    set(joint_id, |j: &mut PulleyJoint| {
        j.ground[0] = anchor.raw();
        Ok(())
    });
}

/// Get the fixed point above body A.
/// @param jointId a pulley joint
/// @return the point, in the world [m]; the origin for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPulleyJoint_GetGroundAnchorA(joint_id: mvJointId) -> mvPos {
    get(joint_id, |j: &PulleyJoint, _| Ok(j.ground[0].into()))
}

/// Get the length of the part at body A.
/// @param jointId a pulley joint
/// @return the length [m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPulleyJoint_GetCurrentLengthA(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &PulleyJoint, r| Ok(crate::math::length(j.parts(&r.geometry())[0])))
}

/// Move the fixed point above body B.
/// @param jointId a pulley joint
/// @param anchor the point, in the world [m]
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvPulleyJoint_SetGroundAnchorB(joint_id: mvJointId, anchor: mvPos) {
    set(joint_id, |j: &mut PulleyJoint| {
        j.ground[1] = anchor.raw();
        Ok(())
    });
}

/// Get the fixed point above body B.
/// @param jointId a pulley joint
/// @return the point, in the world [m]; the origin for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPulleyJoint_GetGroundAnchorB(joint_id: mvJointId) -> mvPos {
    get(joint_id, |j: &PulleyJoint, _| Ok(j.ground[1].into()))
}

/// Get the length of the part at body B.
/// @param jointId a pulley joint
/// @return the length [m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPulleyJoint_GetCurrentLengthB(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &PulleyJoint, r| Ok(crate::math::length(j.parts(&r.geometry())[1])))
}

/// Set the ratio: how many lengths of rope hold B for each that holds A.
/// @param jointId a pulley joint
/// @param ratio the value > 0
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvPulleyJoint_SetRatio(joint_id: mvJointId, ratio: mvFloat) {
    set(joint_id, |j: &mut PulleyJoint| {
        j.ratio = ratio;
        Ok(())
    });
}

/// Get the ratio: how many lengths of rope hold B for each that holds A.
/// @param jointId a pulley joint
/// @return the value; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPulleyJoint_GetRatio(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &PulleyJoint, _| Ok(j.ratio))
}

/// Set the limits of the length of the rope.
/// @param jointId a pulley joint
/// @param minLength the least length [m], >= 0; 0: it may be slack
/// @param maxLength the greatest length [m], > 0, not below the least
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvPulleyJoint_SetLengthRange(
    joint_id: mvJointId,
    min_length: mvFloat,
    max_length: mvFloat,
) {
    set(joint_id, |j: &mut PulleyJoint| {
        positive("maxLength", max_length)?;
        (j.min_length, j.max_length) = (min_length, max_length);
        Ok(())
    });
}

/// Get the least length of the rope.
/// @param jointId a pulley joint
/// @return the length [m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPulleyJoint_GetMinLength(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &PulleyJoint, _| Ok(j.min_length))
}

/// Get the greatest length of the rope.
/// @param jointId a pulley joint
/// @return the length [m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPulleyJoint_GetMaxLength(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &PulleyJoint, _| Ok(j.max_length))
}

/// Get the length of the rope: the part at A plus ratio times the part at B.
/// @param jointId a pulley joint
/// @return the length [m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvPulleyJoint_GetCurrentLength(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |_: &PulleyJoint, r| Ok(r.coordinate()))
}
