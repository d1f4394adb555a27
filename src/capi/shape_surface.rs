//! Shapes: surface, filter, events, measurements.

use super::access::{read_shape, view_shape, write_shape};
use super::contact::mvContactData;
use super::def::*;
use super::def_check::flag;
use super::geometry::mvWorldCastOutput;
use super::guard::{Neutral, c_count, fill, room};
use super::id::mvShapeId;
use super::math::{mvAABB, mvPos, mvVec3};
use super::shape_data::mvMassData;
use super::{Flag, mvFloat};
use crate::math::Vec3;
use crate::world::SurfaceMaterial;
use core::ffi::c_int;

/// Set the density of a shape.
/// @param shapeId the shape
/// @param density the density [kg/m^3], >= 0
/// @param updateBodyMass whether to update the body's mass; else call mvBody_ApplyMassFromShapes() later
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_SetDensity(shape_id: mvShapeId, density: mvFloat, update_body_mass: Flag) {
    write_shape(shape_id, |mut s| s.set_density(density, flag("updateBodyMass", update_body_mass)?));
}

/// Get the density of a shape.
/// @param shapeId the shape
/// @return the density [kg/m^3]; 0 for a bad shape
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_GetDensity(shape_id: mvShapeId) -> mvFloat {
    read_shape(shape_id, |s| Ok(s.density()))
}

/// Set the coefficient of sliding friction of a shape.
/// @param shapeId the shape
/// @param friction the coefficient, >= 0
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_SetFriction(shape_id: mvShapeId, friction: mvFloat) {
    write_shape(shape_id, |mut s| {
        let material = SurfaceMaterial { friction, ..s.as_ref().material() };
        s.set_material(&material)
    });
}

/// Get the coefficient of sliding friction of a shape.
/// @param shapeId the shape
/// @return the coefficient; 0 for a bad shape
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_GetFriction(shape_id: mvShapeId) -> mvFloat {
    read_shape(shape_id, |s| Ok(s.material().friction))
}

/// Set the coefficient of static friction of a shape.
/// @param shapeId the shape
/// @param staticFriction the coefficient, negative for that of sliding
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_SetStaticFriction(shape_id: mvShapeId, static_friction: mvFloat) {
    write_shape(shape_id, |mut s| {
        let material = SurfaceMaterial { static_friction, ..s.as_ref().material() };
        s.set_material(&material)
    });
}

/// Get the coefficient of static friction of a shape.
/// @param shapeId the shape
/// @return the coefficient, negative for that of sliding; 0 for a bad shape
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_GetStaticFriction(shape_id: mvShapeId) -> mvFloat {
    read_shape(shape_id, |s| Ok(s.material().static_friction))
}

/// Set the coefficient of restitution of a shape.
/// @param shapeId the shape
/// @param restitution the coefficient, 0 to 1
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_SetRestitution(shape_id: mvShapeId, restitution: mvFloat) {
    write_shape(shape_id, |mut s| {
        let material = SurfaceMaterial { restitution, ..s.as_ref().material() };
        s.set_material(&material)
    });
}

/// Get the coefficient of restitution of a shape.
/// @param shapeId the shape
/// @return the coefficient; 0 for a bad shape
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_GetRestitution(shape_id: mvShapeId) -> mvFloat {
    read_shape(shape_id, |s| Ok(s.material().restitution))
}

/// Set the surface of a shape. It takes effect in the next step.
/// @param shapeId the shape
/// @param surfaceMaterial the surface
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_SetSurfaceMaterial(shape_id: mvShapeId, surface_material: mvSurfaceMaterial) {
    write_shape(shape_id, |mut s| s.set_material(&surface_material.raw()));
}

/// Get the surface of a shape.
/// @param shapeId the shape
/// @return the surface; zero for a bad shape
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_GetSurfaceMaterial(shape_id: mvShapeId) -> mvSurfaceMaterial {
    read_shape(shape_id, |s| Ok(s.material().into()))
}

/// Get what a shape collides with.
/// @param shapeId the shape
/// @return the filter; zero for a bad shape
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_GetFilter(shape_id: mvShapeId) -> mvFilter {
    read_shape(shape_id, |s| Ok(s.filter().into()))
}

/// Set what a shape collides with. If that changes anything, its contacts end, and those that the filter allows are
/// found again in the next step.
/// @param shapeId the shape
/// @param filter the filter
/// @param invokeContacts whether contacts are to be found anew; today they always are
/// @note Errors: mv_errorRange for a flag that is neither true nor false.
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_SetFilter(shape_id: mvShapeId, filter: mvFilter, invoke_contacts: Flag) {
    write_shape(shape_id, |mut s| {
        flag("invokeContacts", invoke_contacts)?;
        s.set_filter(filter.raw());
        Ok(())
    });
}

/// Make begin and end events for contacts of a shape, or not. One of the two shapes is enough.
/// @param shapeId the shape
/// @param flag whether to do it
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_EnableContactEvents(shape_id: mvShapeId, flag: Flag) {
    write_shape(shape_id, |mut s| {
        s.enable_contact_events(super::def_check::flag("flag", flag)?);
        Ok(())
    });
}

/// Are there begin and end events for the contacts of a shape?
/// @param shapeId the shape
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_AreContactEventsEnabled(shape_id: mvShapeId) -> bool {
    read_shape(shape_id, |s| Ok(s.are_contact_events_enabled()))
}

/// Ask the pre-solve callback about contacts of a shape, or not. One of the two shapes is enough.
/// @param shapeId the shape
/// @param flag whether to do it
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_EnablePreSolveEvents(shape_id: mvShapeId, flag: Flag) {
    write_shape(shape_id, |mut s| {
        s.enable_pre_solve_events(super::def_check::flag("flag", flag)?);
        Ok(())
    });
}

/// Is the pre-solve callback asked about contacts of a shape?
/// @param shapeId the shape
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_ArePreSolveEventsEnabled(shape_id: mvShapeId) -> bool {
    read_shape(shape_id, |s| Ok(s.are_pre_solve_events_enabled()))
}

/// Make hit events for contacts of a shape, or not. One of the two shapes is enough.
/// @param shapeId the shape
/// @param flag whether to do it
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_EnableHitEvents(shape_id: mvShapeId, flag: Flag) {
    write_shape(shape_id, |mut s| {
        s.enable_hit_events(super::def_check::flag("flag", flag)?);
        Ok(())
    });
}

/// Are there hit events for the contacts of a shape?
/// @param shapeId the shape
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_AreHitEventsEnabled(shape_id: mvShapeId) -> bool {
    read_shape(shape_id, |s| Ok(s.are_hit_events_enabled()))
}

/// Cast a ray at one shape. A ray that starts inside does not hit.
/// @param shapeId the shape
/// @param origin where the ray starts [m]
/// @param translation from the start to the end of the ray [m]
/// @return the hit, in the world; no hit for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_RayCast(
    shape_id: mvShapeId,
    origin: mvPos,
    translation: mvVec3,
) -> mvWorldCastOutput {
    read_shape(shape_id, |s| {
        let hit = s.ray_cast(origin.raw(), translation.raw())?;
        Ok(hit.filter(|h| h.normal != Vec3::zeros()).map_or(mvWorldCastOutput::NEUTRAL, |h| {
            mvWorldCastOutput {
                normal: h.normal.into(),
                point: h.point.into(),
                fraction: h.fraction,
                iterations: 0,
                hit: true,
            }
        }))
    })
}

/// Get the box around a shape, in the world.
/// @param shapeId the shape
/// @return the box; zero for a bad shape
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_GetAABB(shape_id: mvShapeId) -> mvAABB {
    read_shape(shape_id, |s| Ok(s.aabb().into()))
}

/// Get mass, centre of mass and inertia of a shape at its density.
/// @param shapeId the shape
/// @return the figures, in the body's frame; zero for a bad shape
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_ComputeMassData(shape_id: mvShapeId) -> mvMassData {
    read_shape(shape_id, |s| Ok(s.mass_data().into()))
}

/// Get the point of a shape closest to a target.
/// @param shapeId the shape
/// @param target the target, in the world [m]
/// @return the point, in the world; the target itself where that is inside; zero for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_GetClosestPoint(shape_id: mvShapeId, target: mvVec3) -> mvVec3 {
    read_shape(shape_id, |s| Ok(s.closest_point(target.point("target")?).into()))
}

/// Get an upper bound for the number of a shape's touching contacts.
/// @param shapeId the shape
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_GetContactCapacity(shape_id: mvShapeId) -> c_int {
    read_shape(shape_id, |s| Ok(c_count(s.contact_capacity())))
}

/// Get the touching contacts of a shape, as of the last step.
/// @param shapeId the shape
/// @param contactData filled with the contacts; may be null
/// @param capacity the room in the array, >= 0
/// @return how many were written
/// @note Errors: mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvShape_GetContactData(
    shape_id: mvShapeId,
    contact_data: *mut mvContactData,
    capacity: c_int,
) -> c_int {
    view_shape(shape_id, |v, s| {
        // Sound: the caller passes that much room.
        let room = unsafe { room("contacts", contact_data, capacity) }?;
        let n = room.len();
        Ok(fill(room, s.contacts().iter().take(n).map(|c| super::contact::contact_data(v.side, c))))
    })
}
