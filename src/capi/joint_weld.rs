//! Weld joints: two bodies as one, or nearly.

use super::def::cookie;
use super::def_check::check_cookie;
use super::guard::needed;
use super::id::{mvJointId, mvWorldId};
use super::joint::{create, get, set};
use super::joint_def::{default_base, mv_weldJoint, mvJointDef};
use super::mvFloat;
use crate::constraint::joint::{JointKind, WeldJoint};

/// A weld joint: holds the frames together, rigidly or by springs.
/// Made by mvDefaultWeldJointDef().
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvWeldJointDef {
    /// Shows that the definition was made by its function. Leave it alone.
    pub internal_value: i32,
    /// What all joints have.
    pub base: mvJointDef,
    /// The stiffness of the place [Hz], >= 0; 0, the default, is rigid.
    pub linear_hertz: mvFloat,
    /// The stiffness of the rotation [Hz], >= 0; 0, the default, is rigid.
    pub angular_hertz: mvFloat,
    /// The damping ratio of the place, >= 0; default 0.
    pub linear_damping_ratio: mvFloat,
    /// The damping ratio of the rotation, >= 0; default 0.
    pub angular_damping_ratio: mvFloat,
}

const COOKIE: i32 = cookie::<mvWeldJointDef>(10 + mv_weldJoint as u32);

/// Get the definition of a weld joint with the default values.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultWeldJointDef() -> mvWeldJointDef {
    mvWeldJointDef {
        internal_value: COOKIE,
        base: default_base(),
        linear_hertz: 0.0,
        angular_hertz: 0.0,
        linear_damping_ratio: 0.0,
        angular_damping_ratio: 0.0,
    }
}

/// Create a weld joint. Its bodies wake.
///
/// @param worldId the world that both bodies live in
/// @param def the definition, from mvDefaultWeldJointDef()
/// @return the joint; null for bad arguments
/// @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
/// has no joints.
#[unsafe(no_mangle)]
pub extern "C" fn mvCreateWeldJoint(world_id: mvWorldId, def: Option<&mvWeldJointDef>) -> mvJointId {
    create(world_id, |_| {
        let d = needed("The definition", def)?;
        check_cookie("WeldJoint", d.internal_value, COOKIE)?;
        let kind = WeldJoint {
            linear_hertz: d.linear_hertz,
            linear_damping_ratio: d.linear_damping_ratio,
            angular_hertz: d.angular_hertz,
            angular_damping_ratio: d.angular_damping_ratio,
        };
        Ok((d.base, JointKind::Weld(kind)))
    })
}

/// Set the stiffness of the place.
/// @param jointId a weld joint
/// @param hertz the value [Hz], >= 0; 0 is rigid
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWeldJoint_SetLinearHertz(joint_id: mvJointId, hertz: mvFloat) {
    set(joint_id, |j: &mut WeldJoint| {
        j.linear_hertz = hertz;
        Ok(())
    });
}

/// Get the stiffness of the place.
/// @param jointId a weld joint
/// @return the value [Hz]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWeldJoint_GetLinearHertz(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &WeldJoint, _| Ok(j.linear_hertz))
}

/// Set the damping ratio of the place.
/// @param jointId a weld joint
/// @param dampingRatio the value >= 0; 1 is critical
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWeldJoint_SetLinearDampingRatio(joint_id: mvJointId, damping_ratio: mvFloat) {
    set(joint_id, |j: &mut WeldJoint| {
        j.linear_damping_ratio = damping_ratio;
        Ok(())
    });
}

/// Get the damping ratio of the place.
/// @param jointId a weld joint
/// @return the value; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWeldJoint_GetLinearDampingRatio(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &WeldJoint, _| Ok(j.linear_damping_ratio))
}

/// Set the stiffness of the rotation.
/// @param jointId a weld joint
/// @param hertz the value [Hz], >= 0; 0 is rigid
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWeldJoint_SetAngularHertz(joint_id: mvJointId, hertz: mvFloat) {
    set(joint_id, |j: &mut WeldJoint| {
        j.angular_hertz = hertz;
        Ok(())
    });
}

/// Get the stiffness of the rotation.
/// @param jointId a weld joint
/// @return the value [Hz]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWeldJoint_GetAngularHertz(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &WeldJoint, _| Ok(j.angular_hertz))
}

/// Set the damping ratio of the rotation.
/// @param jointId a weld joint
/// @param dampingRatio the value >= 0; 1 is critical
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvWeldJoint_SetAngularDampingRatio(joint_id: mvJointId, damping_ratio: mvFloat) {
    set(joint_id, |j: &mut WeldJoint| {
        j.angular_damping_ratio = damping_ratio;
        Ok(())
    });
}

/// Get the damping ratio of the rotation.
/// @param jointId a weld joint
/// @return the value; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvWeldJoint_GetAngularDampingRatio(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &WeldJoint, _| Ok(j.angular_damping_ratio))
}
