//! Contact points of two shapes without a world.

use super::distance::mvSimplexCache;
use super::guard::{Neutral, call, needed, neutral, room};
use super::hull_data::{mvHullData, solid};
use super::math::{ZERO3, mvTransform, mvVec3};
use super::shape_data::{mvCapsule, mvSphere};
use super::{Flag, mvFloat};
use crate::error::Result;
use crate::math::{Pose, tolerance::CONTACT_MARGIN};
use crate::narrow_phase::{self, Cache, Manifold, Methods};
use crate::shape::Shape;
use core::ffi::c_int;

/// A point of contact, in the frame of the first shape.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvLocalManifoldPoint {
    /// The middle between the two surfaces [m].
    pub point: mvVec3,
    /// The gap along the normal, negative where the shapes overlap [m].
    pub separation: mvFloat,
    /// Which features of the shapes meet; the same number again means the same features.
    pub feature_id: u32,
}

/// The points of contact of two shapes, in the frame of the first.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvLocalManifold {
    /// From the first shape to the second, of length 1; zero where there is no point.
    pub normal: mvVec3,
    /// Where to write the points: set by the caller; may be null.
    pub points: *mut mvLocalManifoldPoint,
    /// How many points were written, 0 to 4.
    pub point_count: c_int,
}

/// What was found out about a pair of hulls. All zero is a good start.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvSATCache {
    /// The gap along the axis that was found, negative where the hulls overlap [m].
    pub separation: mvFloat,
    /// Whether the hulls have contact points.
    pub hit: Flag,
}

neutral! {
    mvLocalManifoldPoint = mvLocalManifoldPoint { point: ZERO3, separation: 0.0, feature_id: 0 };
}

/// Find the contact point of two spheres, if they touch or nearly do.
///
/// @param manifold filled; its points are where the caller wants the points written
/// @param capacity the room for points, >= 0
/// @param sphereA the first sphere
/// @param sphereB the second sphere
/// @param transformBtoA where the second is, seen from the first
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate. The manifold is then empty.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvCollideSpheres(
    manifold: Option<&mut mvLocalManifold>,
    capacity: c_int,
    sphere_a: Option<&mvSphere>,
    sphere_b: Option<&mvSphere>,
    transform_bto_a: mvTransform,
) {
    call(|| {
        let shapes = || Ok((sphere("sphereA", sphere_a)?, sphere("sphereB", sphere_b)?));
        // Sound: the caller passes that much room.
        unsafe { collide(manifold, capacity, transform_bto_a, shapes) }.map(|_| ())
    });
}

/// Find the contact point of a capsule and a sphere, if they touch or nearly do.
///
/// @param manifold filled; its points are where the caller wants the points written
/// @param capacity the room for points, >= 0
/// @param capsuleA the capsule
/// @param sphereB the sphere
/// @param transformBtoA where the sphere is, seen from the capsule
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate. The manifold is then empty.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvCollideCapsuleAndSphere(
    manifold: Option<&mut mvLocalManifold>,
    capacity: c_int,
    capsule_a: Option<&mvCapsule>,
    sphere_b: Option<&mvSphere>,
    transform_bto_a: mvTransform,
) {
    call(|| {
        let shapes = || Ok((capsule("capsuleA", capsule_a)?, sphere("sphereB", sphere_b)?));
        // Sound: the caller passes that much room.
        unsafe { collide(manifold, capacity, transform_bto_a, shapes) }.map(|_| ())
    });
}

/// Find the contact points of two capsules, if they touch or nearly do.
///
/// @param manifold filled; its points are where the caller wants the points written
/// @param capacity the room for points, >= 0
/// @param capsuleA the first capsule
/// @param capsuleB the second capsule
/// @param transformBtoA where the second is, seen from the first
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate. The manifold is then empty.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvCollideCapsules(
    manifold: Option<&mut mvLocalManifold>,
    capacity: c_int,
    capsule_a: Option<&mvCapsule>,
    capsule_b: Option<&mvCapsule>,
    transform_bto_a: mvTransform,
) {
    call(|| {
        let shapes = || Ok((capsule("capsuleA", capsule_a)?, capsule("capsuleB", capsule_b)?));
        // Sound: the caller passes that much room.
        unsafe { collide(manifold, capacity, transform_bto_a, shapes) }.map(|_| ())
    });
}

/// Find the contact point of a hull and a sphere, if they touch or nearly do.
///
/// @param manifold filled; its points are where the caller wants the points written
/// @param capacity the room for points, >= 0
/// @param hullA the hull
/// @param sphereB the sphere
/// @param transformBtoA where the sphere is, seen from the hull
/// @param cache may be null; set to empty, since this pair needs none
/// @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate. The manifold
/// is then empty.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvCollideHullAndSphere(
    manifold: Option<&mut mvLocalManifold>,
    capacity: c_int,
    hull_a: *const mvHullData,
    sphere_b: Option<&mvSphere>,
    transform_bto_a: mvTransform,
    cache: Option<&mut mvSimplexCache>,
) {
    call(|| {
        // Sound: the caller passes a hull.
        let shapes = || Ok((unsafe { solid(hull_a) }?, sphere("sphereB", sphere_b)?));
        cache.into_iter().for_each(|c| c.count = 0);
        // Sound: the caller passes that much room.
        unsafe { collide(manifold, capacity, transform_bto_a, shapes) }.map(|_| ())
    });
}

/// Find the contact points of a hull and a capsule, if they touch or nearly do.
///
/// @param manifold filled; its points are where the caller wants the points written
/// @param capacity the room for points, >= 0
/// @param hullA the hull
/// @param capsuleB the capsule
/// @param transformBtoA where the capsule is, seen from the hull
/// @param cache may be null; set to empty, since this pair needs none
/// @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate. The manifold
/// is then empty.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvCollideHullAndCapsule(
    manifold: Option<&mut mvLocalManifold>,
    capacity: c_int,
    hull_a: *const mvHullData,
    capsule_b: Option<&mvCapsule>,
    transform_bto_a: mvTransform,
    cache: Option<&mut mvSimplexCache>,
) {
    call(|| {
        // Sound: the caller passes a hull.
        let shapes = || Ok((unsafe { solid(hull_a) }?, capsule("capsuleB", capsule_b)?));
        cache.into_iter().for_each(|c| c.count = 0);
        // Sound: the caller passes that much room.
        unsafe { collide(manifold, capacity, transform_bto_a, shapes) }.map(|_| ())
    });
}

/// Find the contact points of two hulls, if they touch or nearly do.
///
/// @param manifold filled; its points are where the caller wants the points written
/// @param capacity the room for points, >= 0
/// @param hullA the first hull
/// @param hullB the second hull
/// @param transformBtoA where the second is, seen from the first
/// @param cache written: how the pair stands; may be null
/// @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate. The manifold
/// is then empty.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvCollideHulls(
    manifold: Option<&mut mvLocalManifold>,
    capacity: c_int,
    hull_a: *const mvHullData,
    hull_b: *const mvHullData,
    transform_bto_a: mvTransform,
    cache: Option<&mut mvSATCache>,
) {
    call(|| {
        // Sound: the caller passes hulls.
        let shapes = || unsafe { Ok((solid(hull_a)?, solid(hull_b)?)) };
        // Sound: the caller passes that much room.
        let found = unsafe { collide(manifold, capacity, transform_bto_a, shapes) }?;
        if let Some(cache) = cache {
            let least = found.points().iter().map(|p| p.separation).fold(mvFloat::MAX, mvFloat::min);
            *cache = mvSATCache { separation: least, hit: Flag::from(found.count > 0) };
        }
        Ok(())
    });
}

type Placed = (Shape, Pose);

fn sphere(name: &str, s: Option<&mvSphere>) -> Result<Placed> {
    Ok((Shape::Sphere(needed(name, s)?.solid()?), Pose::IDENTITY))
}

fn capsule(name: &str, c: Option<&mvCapsule>) -> Result<Placed> {
    Ok((Shape::Capsule(needed(name, c)?.solid()?), Pose::IDENTITY))
}

/// # Safety
/// The manifold's points are null or room for `capacity` points.
unsafe fn collide(
    manifold: Option<&mut mvLocalManifold>,
    capacity: c_int,
    b_to_a: mvTransform,
    shapes: impl FnOnce() -> Result<(Placed, Placed)>,
) -> Result<Manifold> {
    let out = needed("The manifold", manifold)?;
    (out.normal, out.point_count) = (mvVec3::NEUTRAL, 0);
    // Sound: by this function's contract.
    let room = unsafe { room("points", out.points, capacity) }?;
    let ((a, a_local), (b, b_local)) = shapes()?;
    let b_in_a = b_to_a.pose("transformBtoA")?.then(&b_local);
    let margin = CONTACT_MARGIN * a.inner_radius().min(b.inner_radius());
    let mut found = Manifold::default();
    let pose = a_local.back_to(&b_in_a);
    narrow_phase::collide(&a, &b, &pose, margin, Methods::default(), &mut Cache::default(), &mut found);
    if found.count > 0 {
        out.normal = a_local.vector(found.normal).into();
    }
    for (place, p) in room.iter_mut().zip(found.points()) {
        place.write(mvLocalManifoldPoint {
            point: a_local.point(p.point).into(),
            separation: p.separation,
            feature_id: p.feature,
        });
        out.point_count += 1;
    }
    Ok(found)
}
