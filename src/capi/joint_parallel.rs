//! Parallel joints: a spring keeps two axes along each other.

use super::def::cookie;
use super::def_check::check_cookie;
use super::guard::needed;
use super::id::{mvJointId, mvWorldId};
use super::joint::{create, get, set};
use super::joint_def::{default_base, mv_parallelJoint, mvJointDef};
use super::mvFloat;
use crate::constraint::joint::{JointKind, ParallelJoint};
use crate::math::Float;

/// A parallel joint: a spring keeps z of frame B along z of frame A, so that a body stays upright. All else is
/// free.
/// Made by mvDefaultParallelJointDef().
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvParallelJointDef {
    /// Shows that the definition was made by its function. Leave it alone.
    pub internal_value: i32,
    /// What all joints have.
    pub base: mvJointDef,
    /// The frequency of the spring [Hz], >= 0; default 1.
    pub hertz: mvFloat,
    /// Its damping ratio, >= 0; 1, the default, is critical.
    pub damping_ratio: mvFloat,
    /// Its greatest torque about each axis [N m], >= 0; default infinity.
    pub max_torque: mvFloat,
}

const COOKIE: i32 = cookie::<mvParallelJointDef>(10 + mv_parallelJoint as u32);

/// Get the definition of a parallel joint with the default values.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultParallelJointDef() -> mvParallelJointDef {
    mvParallelJointDef {
        internal_value: COOKIE,
        base: default_base(),
        hertz: 1.0,
        damping_ratio: 1.0,
        max_torque: Float::INFINITY,
    }
}

/// Create a parallel joint. Its bodies wake.
///
/// @param worldId the world that both bodies live in
/// @param def the definition, from mvDefaultParallelJointDef()
/// @return the joint; null for bad arguments
/// @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
/// has no joints.
#[unsafe(no_mangle)]
pub extern "C" fn mvCreateParallelJoint(world_id: mvWorldId, def: Option<&mvParallelJointDef>) -> mvJointId {
    create(world_id, |_| {
        let d = needed("The definition", def)?;
        check_cookie("ParallelJoint", d.internal_value, COOKIE)?;
        Ok((
            d.base,
            JointKind::Parallel(ParallelJoint {
                hertz: d.hertz,
                damping_ratio: d.damping_ratio,
                max_torque: d.max_torque,
            }),
        ))
    })
}

/// Set the frequency of the spring.
/// @param jointId a parallel joint
/// @param hertz the value [Hz], >= 0; 0 has no effect
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvParallelJoint_SetSpringHertz(joint_id: mvJointId, hertz: mvFloat) {
    set(joint_id, |j: &mut ParallelJoint| {
        j.hertz = hertz;
        Ok(())
    });
}

/// Get the frequency of the spring.
/// @param jointId a parallel joint
/// @return the value [Hz]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvParallelJoint_GetSpringHertz(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &ParallelJoint, _| Ok(j.hertz))
}

/// Set the damping ratio of the spring.
/// @param jointId a parallel joint
/// @param dampingRatio the value >= 0; 1 is critical
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvParallelJoint_SetSpringDampingRatio(joint_id: mvJointId, damping_ratio: mvFloat) {
    set(joint_id, |j: &mut ParallelJoint| {
        j.damping_ratio = damping_ratio;
        Ok(())
    });
}

/// Get the damping ratio of the spring.
/// @param jointId a parallel joint
/// @return the value; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvParallelJoint_GetSpringDampingRatio(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &ParallelJoint, _| Ok(j.damping_ratio))
}

/// Set the greatest torque of the spring about each axis.
/// @param jointId a parallel joint
/// @param maxTorque the value [N m], >= 0, may be infinite
/// @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
#[unsafe(no_mangle)]
pub extern "C" fn mvParallelJoint_SetMaxTorque(joint_id: mvJointId, max_torque: mvFloat) {
    set(joint_id, |j: &mut ParallelJoint| {
        j.max_torque = max_torque;
        Ok(())
    });
}

/// Get the greatest torque of the spring about each axis.
/// @param jointId a parallel joint
/// @return the value [N m]; 0 for another joint or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvParallelJoint_GetMaxTorque(joint_id: mvJointId) -> mvFloat {
    get(joint_id, |j: &ParallelJoint, _| Ok(j.max_torque))
}
