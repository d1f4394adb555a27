//! Shapes: attaching, destroying, and what they are made of.

use super::access::{edit_at_shape, read_shape, view_shape, write_shape};
use super::def::*;
use super::def_check::{flag, from_word, to_word};
use super::error::text;
use super::guard::{call, needed};
use super::hull::transformed;
use super::hull_data::{Tables, checked, mvHullData, points, solid};
use super::id::{mvBodyId, mvShapeId, mvWorldId};
use super::math::{mvPlane, mvTransform, mvVec3};
use super::registry;
use super::shape_data::{mvCapsule, mvSphere};
use super::side::Named;
use super::{Flag, mvFloat};
use crate::error::{Error, ErrorCode, Result};
use crate::math::{Pose, vec3};
use crate::shape::{Cuboid, HalfSpace, Shape};
use core::ffi::{c_char, c_void};
use std::sync::Arc;

/// What a shape is: one of the mv_...Shape constants. Boxes are hulls.
pub type mvShapeType = i32;
/// All points within a radius of a segment.
pub const mv_capsuleShape: mvShapeType = 0;
/// A convex solid with flat faces, boxes included.
pub const mv_hullShape: mvShapeType = 3;
/// A ball.
pub const mv_sphereShape: mvShapeType = 5;
/// Everything below a plane.
pub const mv_planeShape: mvShapeType = 6;

/// Attach a sphere to a body.
///
/// @param bodyId the body
/// @param def the definition, from mvDefaultShapeDef()
/// @param sphere the sphere, in the body's frame
/// @return the shape; null for bad arguments
/// @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvCreateSphereShape(
    body_id: mvBodyId,
    def: Option<&mvShapeDef>,
    sphere: Option<&mvSphere>,
) -> mvShapeId {
    attach(body_id, def, || {
        let sphere = needed("The sphere", sphere)?.solid()?;
        Ok((Shape::Sphere(sphere), Pose::IDENTITY))
    })
}

/// Attach a capsule to a body.
///
/// @param bodyId the body
/// @param def the definition, from mvDefaultShapeDef()
/// @param capsule the capsule, in the body's frame
/// @return the shape; null for bad arguments
/// @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvCreateCapsuleShape(
    body_id: mvBodyId,
    def: Option<&mvShapeDef>,
    capsule: Option<&mvCapsule>,
) -> mvShapeId {
    attach(body_id, def, || {
        let capsule = needed("The capsule", capsule)?.solid()?;
        Ok((Shape::Capsule(capsule), Pose::IDENTITY))
    })
}

/// Attach a hull to a body.
///
/// @param bodyId the body
/// @param def the definition, from mvDefaultShapeDef()
/// @param hull the hull, in the body's frame; it may be destroyed right after
/// @return the shape; null for bad arguments
/// @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvCreateHullShape(
    body_id: mvBodyId,
    def: Option<&mvShapeDef>,
    hull: *const mvHullData,
) -> mvShapeId {
    attach(body_id, def, || {
        // Sound: the caller passes a hull.
        unsafe { solid(hull) }
    })
}

/// Attach a scaled and placed copy of a hull to a body.
///
/// @param bodyId the body
/// @param def the definition, from mvDefaultShapeDef()
/// @param hull the hull; it may be destroyed right after
/// @param transform where the scaled hull is in the body's frame
/// @param scale the scale along the hull's x, y and z, which may be negative but not zero
/// @return the shape; null for bad arguments
/// @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvCreateTransformedHullShape(
    body_id: mvBodyId,
    def: Option<&mvShapeDef>,
    hull: *const mvHullData,
    transform: mvTransform,
    scale: mvVec3,
) -> mvShapeId {
    attach(body_id, def, || {
        // Sound: the caller passes a hull.
        let (head, words) = unsafe { checked(hull) }?;
        let hull = transformed(&points(head, words)?, transform, scale)?;
        Ok((Shape::Hull(Arc::new(hull)), Pose::IDENTITY))
    })
}

/// Attach a box to a body, centred on the body's origin.
///
/// @param bodyId the body
/// @param def the definition, from mvDefaultShapeDef()
/// @param hx half the side length along x [m], > 0
/// @param hy half the side length along y [m], > 0
/// @param hz half the side length along z [m], > 0
/// @return the shape; null for bad arguments
/// @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvCreateBoxShape(
    body_id: mvBodyId,
    def: Option<&mvShapeDef>,
    hx: mvFloat,
    hy: mvFloat,
    hz: mvFloat,
) -> mvShapeId {
    attach(body_id, def, || Ok((Shape::Box(Cuboid::new(vec3(hx, hy, hz))?), Pose::IDENTITY)))
}

/// Attach everything below a plane to a static body: a floor without end.
///
/// @param bodyId the body
/// @param def the definition, from mvDefaultShapeDef()
/// @param plane the plane, in the body's frame; its normal may have any length but 0 and is scaled to 1,
/// the offset is along the scaled normal
/// @return the shape; null for bad arguments
/// @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate; mv_errorRange also for a body that is not static.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvCreatePlaneShape(
    body_id: mvBodyId,
    def: Option<&mvShapeDef>,
    plane: Option<&mvPlane>,
) -> mvShapeId {
    attach(body_id, def, || {
        let plane = needed("The plane", plane)?;
        Ok((Shape::HalfSpace(HalfSpace::new(plane.normal.raw(), plane.offset)?), Pose::IDENTITY))
    })
}

/// Looks up, then builds the geometry, then takes the world: a fault in the building breaks no world.
fn attach(
    body_id: mvBodyId,
    def: Option<&mvShapeDef>,
    geometry: impl FnOnce() -> Result<(Shape, Pose)>,
) -> mvShapeId {
    call(|| {
        super::access::look_up_body(body_id)?;
        // Sound: the caller's name is null or a string.
        let def = unsafe { needed("The definition", def)?.checked() }?;
        let (shape, local) = geometry()?;
        super::access::edit_at(body_id, |e| {
            e.world.create_shape(body_id.into(), &def, shape, local).map(Into::into)
        })
    })
}

/// Destroy a shape. What it touched wakes up.
/// @param shapeId the shape
/// @param updateBodyMass whether to update the body's mass; else call mvBody_ApplyMassFromShapes() later
#[unsafe(no_mangle)]
pub extern "C" fn mvDestroyShape(shape_id: mvShapeId, update_body_mass: Flag) {
    edit_at_shape(shape_id, |e| {
        e.world.shape(shape_id.into())?;
        e.world.destroy_shape(shape_id.into(), flag("updateBodyMass", update_body_mass)?)
    });
}

/// Does this id name a shape that lives? Never fails; false also while another thread changes the world.
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_IsValid(id: mvShapeId) -> bool {
    super::access::is_shape(id)
}

/// Get what a shape is.
/// @param shapeId the shape
/// @return one of the mv_...Shape constants; mv_capsuleShape, which is 0, for a bad shape
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_GetType(shape_id: mvShapeId) -> mvShapeType {
    read_shape(shape_id, |s| {
        Ok(match s.shape() {
            Shape::Sphere(_) => mv_sphereShape,
            Shape::Capsule(_) => mv_capsuleShape,
            Shape::Box(_) | Shape::Hull(_) => mv_hullShape,
            Shape::HalfSpace(_) => mv_planeShape,
        })
    })
}

/// Get the body that a shape is attached to.
/// @param shapeId the shape
/// @return the body; null for a bad shape
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_GetBody(shape_id: mvShapeId) -> mvBodyId {
    read_shape(shape_id, |s| Ok(s.body().into()))
}

/// Get the world that a shape lives in.
/// @param shapeId the shape
/// @return the world; null for a bad shape
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_GetWorld(shape_id: mvShapeId) -> mvWorldId {
    read_shape(shape_id, |_| Ok(registry::world_id(shape_id.world0)))
}

/// Set the name of a shape.
/// @param shapeId the shape
/// @param name UTF-8, copied; null for none
/// @note Errors: mv_errorRange when the name is not UTF-8.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvShape_SetName(shape_id: mvShapeId, name: *const c_char) {
    write_shape(shape_id, |mut s| {
        // Sound: the caller's name is null or a string.
        s.set_name(unsafe { text("The shape's name", name) }?);
        Ok(())
    });
}

/// Get the name of a shape.
/// @param shapeId the shape
/// @return UTF-8, empty for none; null for a bad shape. Valid until the name is changed or the shape destroyed.
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_GetName(shape_id: mvShapeId) -> *const c_char {
    view_shape(shape_id, |v, s| Ok(v.side.name(Named::Shape(s.id().index1), s.name())))
}

/// Set the user data of a shape.
/// @param shapeId the shape
/// @param userData anything; it is never followed
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_SetUserData(shape_id: mvShapeId, user_data: *mut c_void) {
    write_shape(shape_id, |mut s| {
        s.set_user_data(to_word(user_data));
        Ok(())
    });
}

/// Get the user data of a shape.
/// @param shapeId the shape
/// @return what was set; null for a bad shape
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_GetUserData(shape_id: mvShapeId) -> *mut c_void {
    read_shape(shape_id, |s| Ok(from_word(s.user_data())))
}

/// Get the sphere of a shape.
/// @param shapeId the shape
/// @return the sphere, in the body's frame; zero for a bad shape
/// @note Errors: mv_errorRange when the shape is no sphere.
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_GetSphere(shape_id: mvShapeId) -> mvSphere {
    read_shape(shape_id, |s| match s.shape() {
        Shape::Sphere(sphere) => Ok((*sphere).into()),
        _ => Err(another("sphere")),
    })
}

/// Get the capsule of a shape.
/// @param shapeId the shape
/// @return the capsule, in the body's frame; zero for a bad shape
/// @note Errors: mv_errorRange when the shape is no capsule.
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_GetCapsule(shape_id: mvShapeId) -> mvCapsule {
    read_shape(shape_id, |s| match s.shape() {
        Shape::Capsule(capsule) => Ok((*capsule).into()),
        _ => Err(another("capsule")),
    })
}

/// Get the hull of a shape.
/// @param shapeId the shape
/// @return the hull, in the body's frame; null for a bad shape. Valid until the shape is changed or destroyed.
/// @note Errors: mv_errorRange when the shape is no hull.
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_GetHull(shape_id: mvShapeId) -> *const mvHullData {
    view_shape(shape_id, |v, s| {
        let tables = match s.shape() {
            Shape::Hull(hull) => Tables::of_hull(hull),
            Shape::Box(cuboid) => Tables::of_box(*cuboid, &s.local_pose()),
            _ => return Err(another("hull")),
        };
        let id = s.id();
        Ok(v.side.hull(id.index1, id.generation, || tables.block()))
    })
}

/// Get the plane of a shape.
/// @param shapeId the shape
/// @return the plane, in the body's frame; zero for a bad shape
/// @note Errors: mv_errorRange when the shape is no plane.
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_GetPlane(shape_id: mvShapeId) -> mvPlane {
    read_shape(shape_id, |s| match s.shape() {
        Shape::HalfSpace(h) => Ok(mvPlane { normal: h.normal().into(), offset: h.offset() }),
        _ => Err(another("plane")),
    })
}

/// Make a shape a sphere. The body's mass stays: call mvBody_ApplyMassFromShapes() to update it.
/// @param shapeId the shape
/// @param sphere the sphere, in the body's frame
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_SetSphere(shape_id: mvShapeId, sphere: Option<&mvSphere>) {
    reshape(shape_id, || Ok((Shape::Sphere(needed("The sphere", sphere)?.solid()?), Pose::IDENTITY)));
}

/// Make a shape a capsule. The body's mass stays: call mvBody_ApplyMassFromShapes() to update it.
/// @param shapeId the shape
/// @param capsule the capsule, in the body's frame
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub extern "C" fn mvShape_SetCapsule(shape_id: mvShapeId, capsule: Option<&mvCapsule>) {
    reshape(shape_id, || Ok((Shape::Capsule(needed("The capsule", capsule)?.solid()?), Pose::IDENTITY)));
}

/// Make a shape a hull. The body's mass stays: call mvBody_ApplyMassFromShapes() to update it.
/// @param shapeId the shape
/// @param hull the hull, in the body's frame; it may be destroyed right after
/// @note Errors: mv_errorNull, mv_errorDefinition, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvShape_SetHull(shape_id: mvShapeId, hull: *const mvHullData) {
    // Sound: the caller passes a hull.
    reshape(shape_id, || unsafe { solid(hull) });
}

fn reshape(shape_id: mvShapeId, geometry: impl FnOnce() -> Result<(Shape, Pose)>) {
    call(|| {
        super::access::look_up_shape(shape_id)?;
        let (shape, local) = geometry()?;
        super::access::edit_shape(shape_id, |e| {
            e.world.shape_mut(shape_id.into())?.set_shape(shape, &local, false)?;
            e.side.forget_hull(shape_id.index1 as u32);
            Ok(())
        })
    });
}

fn another(wanted: &str) -> Error {
    Error::new(ErrorCode::Range, format!("The shape is no {wanted}."))
}
