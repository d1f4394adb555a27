//! Filter joints: two bodies that do not collide.

use super::def::cookie;
use super::def_check::check_cookie;
use super::guard::needed;
use super::id::{mvJointId, mvWorldId};
use super::joint::create;
use super::joint_def::{default_base, mv_filterJoint, mvJointDef};
use crate::constraint::joint::JointKind;

/// A filter joint: the bodies do not collide with each other; nothing else happens to them.
/// Made by mvDefaultFilterJointDef().
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvFilterJointDef {
    /// Shows that the definition was made by its function. Leave it alone.
    pub internal_value: i32,
    /// What all joints have.
    pub base: mvJointDef,
}

const COOKIE: i32 = cookie::<mvFilterJointDef>(10 + mv_filterJoint as u32);

/// Get the definition of a filter joint with the default values.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultFilterJointDef() -> mvFilterJointDef {
    mvFilterJointDef { internal_value: COOKIE, base: default_base() }
}

/// Create a filter joint. Its bodies wake.
///
/// @param worldId the world that both bodies live in
/// @param def the definition, from mvDefaultFilterJointDef()
/// @return the joint; null for bad arguments
/// @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
/// has no joints.
#[unsafe(no_mangle)]
pub extern "C" fn mvCreateFilterJoint(world_id: mvWorldId, def: Option<&mvFilterJointDef>) -> mvJointId {
    create(world_id, |_| {
        let d = needed("The definition", def)?;
        check_cookie("FilterJoint", d.internal_value, COOKIE)?;
        Ok((d.base, JointKind::Filter))
    })
}
