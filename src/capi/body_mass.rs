//! Mass, damping and gravity of bodies.

use super::access::{read_body, write_body};
use super::id::mvBodyId;
use super::math::{mvMatrix3, mvPos, mvVec3};
use super::mvFloat;
use super::shape_data::mvMassData;

/// Get the mass of a body.
/// @param bodyId the body
/// @return the mass [kg]; 0 for a body without mass or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetMass(body_id: mvBodyId) -> mvFloat {
    read_body(body_id, |b| Ok(b.mass()))
}

/// Get one divided by the mass of a body.
/// @param bodyId the body
/// @return the inverse mass [1/kg]; 0 for a body without mass or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetInverseMass(body_id: mvBodyId) -> mvFloat {
    read_body(body_id, |b| Ok(b.inverse_mass()))
}

/// Get the inertia of a body about its centre of mass, in the axes of the body.
/// @param bodyId the body
/// @return the inertia [kg m^2]; zero for a body without mass or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetLocalRotationalInertia(body_id: mvBodyId) -> mvMatrix3 {
    read_body(body_id, |b| Ok(b.mass_data().inertia.into()))
}

/// Get the inverse of the inertia of a body about its centre of mass, in world axes. Locked axes count as infinite
/// inertia.
/// @param bodyId the body
/// @return the inverse inertia [1/(kg m^2)]; zero for a body without mass or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetWorldInverseRotationalInertia(body_id: mvBodyId) -> mvMatrix3 {
    read_body(body_id, |b| Ok(b.world_inverse_inertia().into()))
}

/// Get the centre of mass of a body, in the body's frame.
/// @param bodyId the body
/// @return the centre [m]; zero for a bad body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetLocalCenter(body_id: mvBodyId) -> mvVec3 {
    read_body(body_id, |b| Ok(b.local_center().into()))
}

/// Get the centre of mass of a body, in the world.
/// @param bodyId the body
/// @return the centre [m]; zero for a bad body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetWorldCenter(body_id: mvBodyId) -> mvPos {
    read_body(body_id, |b| Ok(b.world_center().into()))
}

/// Give a dynamic body a mass of its own. Shapes no longer change it until mvBody_ApplyMassFromShapes() or
/// mvBody_SetType().
/// @param bodyId the body
/// @param massData mass, centre of mass in the body's frame, inertia about that centre in the body's axes
/// @note Errors: mv_errorNotFinite, mv_errorRange for a body that is not dynamic, a negative mass or an inertia that no
/// solid has, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_SetMassData(body_id: mvBodyId, mass_data: mvMassData) {
    write_body(body_id, |mut b| b.set_mass_data(&mass_data.checked()?));
}

/// Get mass, centre of mass and inertia of a body.
/// @param bodyId the body
/// @return the figures; zero for a body without mass or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetMassData(body_id: mvBodyId) -> mvMassData {
    read_body(body_id, |b| Ok(b.mass_data().into()))
}

/// Make the mass of a body that of its shapes: after mvBody_SetMassData(), or after shapes were made, changed or
/// destroyed without updating it.
/// @param bodyId the body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_ApplyMassFromShapes(body_id: mvBodyId) {
    write_body(body_id, |mut b| {
        b.apply_mass_from_shapes();
        Ok(())
    });
}

/// Set the fraction of a body's velocity lost per second, for small values.
/// @param bodyId the body
/// @param linearDamping the value [1/s], >= 0
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_SetLinearDamping(body_id: mvBodyId, linear_damping: mvFloat) {
    write_body(body_id, |mut b| b.set_linear_damping(linear_damping));
}

/// Get the fraction of a body's velocity lost per second, for small values.
/// @param bodyId the body
/// @return the value [1/s]; 0 for a bad body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetLinearDamping(body_id: mvBodyId) -> mvFloat {
    read_body(body_id, |b| Ok(b.linear_damping()))
}

/// Set the fraction of a body's angular velocity lost per second, for small values.
/// @param bodyId the body
/// @param angularDamping the value [1/s], >= 0
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_SetAngularDamping(body_id: mvBodyId, angular_damping: mvFloat) {
    write_body(body_id, |mut b| b.set_angular_damping(angular_damping));
}

/// Get the fraction of a body's angular velocity lost per second, for small values.
/// @param bodyId the body
/// @return the value [1/s]; 0 for a bad body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetAngularDamping(body_id: mvBodyId) -> mvFloat {
    read_body(body_id, |b| Ok(b.angular_damping()))
}

/// Set the factor on gravity of a body.
/// @param bodyId the body
/// @param gravityScale the value
/// @note Errors: mv_errorNotFinite.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_SetGravityScale(body_id: mvBodyId, gravity_scale: mvFloat) {
    write_body(body_id, |mut b| b.set_gravity_scale(gravity_scale));
}

/// Get the factor on gravity of a body.
/// @param bodyId the body
/// @return the value; 0 for a bad body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetGravityScale(body_id: mvBodyId) -> mvFloat {
    read_body(body_id, |b| Ok(b.gravity_scale()))
}
