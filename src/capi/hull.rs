//! Making, copying and destroying hulls.

use super::guard::{call, slice};
use super::hull_data::*;
use super::math::{mvTransform, mvVec3};
use super::mvFloat;
use crate::error::{Error, ErrorCode, Result, check};
use crate::math::{Float, Pose, Vec3, scalar, vec3};
use crate::shape::{Cuboid, Hull};
use core::ffi::c_int;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};

/// Create the convex hull of a cloud of points.
///
/// Points inside, doubled points and points within rounding of a face vanish.
/// @param points the points [m]
/// @param pointCount their number, at least 4
/// @param maxVertexCount the most vertices the hull may have, at least 4; more than MV_MAX_HULL_VERTICES counts
/// as that. Where the true hull has more, the farthest points are kept.
/// @return the hull, to be destroyed by mvDestroyHull(); null for bad arguments
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate for fewer than 4 points or
/// points that lie on one plane.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvCreateHull(
    points: *const mvVec3,
    point_count: c_int,
    max_vertex_count: c_int,
) -> *mut mvHullData {
    call(|| {
        // Sound: the caller passes that many points.
        let points = unsafe { slice("points", points, point_count) }?;
        let points: Vec<Vec3> = points.iter().map(|p| p.raw()).collect();
        give(&build(&points, max_vertex_count)?)
    })
}

/// Create a hull in the form of a cylinder along the y axis.
///
/// @param height the distance of the end faces [m], > 0
/// @param radius the distance of the side edges from the axis [m], > 0
/// @param yOffset where the lower end face is [m]
/// @param sides the number of side faces, 3 to 127
/// @return the hull, to be destroyed by mvDestroyHull(); null for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub extern "C" fn mvCreateCylinder(
    height: mvFloat,
    radius: mvFloat,
    y_offset: mvFloat,
    sides: c_int,
) -> *mut mvHullData {
    call(|| {
        check::positive("height", height)?;
        check::positive("radius", radius)?;
        check::finite("yOffset", y_offset)?;
        let sides = side_count(sides)?;
        let mut points = ring(radius, y_offset, sides);
        points.extend(ring(radius, y_offset + height, sides));
        give(&Hull::new(&points)?)
    })
}

/// Create a hull in the form of a cone or truncated cone along the y axis, its first end face at y = 0.
///
/// @param height the distance of the ends [m], > 0
/// @param radius1 the radius at y = 0 [m], > 0
/// @param radius2 the radius at y = height [m]; 0 for a tip
/// @param slices the number of side faces, 3 to 127
/// @return the hull, to be destroyed by mvDestroyHull(); null for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub extern "C" fn mvCreateCone(
    height: mvFloat,
    radius1: mvFloat,
    radius2: mvFloat,
    slices: c_int,
) -> *mut mvHullData {
    call(|| {
        check::positive("height", height)?;
        check::positive("radius1", radius1)?;
        check::not_negative("radius2", radius2)?;
        let sides = side_count(slices)?;
        let mut points = ring(radius1, 0.0, sides);
        if radius2 > 0.0 {
            points.extend(ring(radius2, height, sides));
        } else {
            points.push(vec3(0.0, height, 0.0));
        }
        give(&Hull::new(&points)?)
    })
}

/// Copy a hull.
///
/// @param hull a hull, or the base of a box hull
/// @return the copy, to be destroyed by mvDestroyHull(); null for a bad hull
/// @note Errors: mv_errorNull, mv_errorDefinition for a hull that was changed or is of another version.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvCloneHull(hull: *const mvHullData) -> *mut mvHullData {
    call(|| {
        // Sound: the caller passes a hull.
        let (head, words) = unsafe { checked(hull) }?;
        if head.box_half_widths.x > 0.0 {
            let (half, pose) = (head.box_half_widths.raw(), head.box_transform.pose("The box's transform")?);
            return Ok(keep(Tables::of_box(Cuboid::new(half)?, &pose).block()));
        }
        give(&build(&points(head, words)?, head.vertex_count)?)
    })
}

/// Copy a hull, scale the copy along the axes of its frame, and place it.
///
/// @param original a hull, or the base of a box hull
/// @param transform where to place the scaled hull
/// @param scale the scale along x, y and z, which may be negative but not zero
/// @return the new hull, to be destroyed by mvDestroyHull(); null for bad arguments
/// @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvCloneAndTransformHull(
    original: *const mvHullData,
    transform: mvTransform,
    scale: mvVec3,
) -> *mut mvHullData {
    call(|| {
        // Sound: the caller passes a hull.
        let (head, words) = unsafe { checked(original) }?;
        give(&transformed(&points(head, words)?, transform, scale)?)
    })
}

/// Destroy a hull that mvCreateHull(), mvCloneHull() or a function like them made. Shapes made from it stay.
///
/// @param hull the hull
/// @note Errors: mv_errorNull, mv_errorStale for a pointer that is no such hull, or not any more.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvDestroyHull(hull: *mut mvHullData) {
    call(|| {
        if hull.is_null() {
            return Err(Error::new(ErrorCode::Null, "The hull is null."));
        }
        let Some(words) = owned().remove(&hull.addr()) else {
            return Err(Error::new(ErrorCode::Stale, "There is no hull to destroy at this address."));
        };
        // Sound: the table says that the address came from into_raw, and it was just struck off.
        drop(unsafe { Block::from_raw(hull, words) });
        Ok(())
    });
}

/// Make a cube as a hull.
///
/// @param halfWidth half the side length [m], > 0
/// @return the box; one that no function accepts for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub extern "C" fn mvMakeCubeHull(half_width: mvFloat) -> mvBoxHull {
    call(|| make_box(half_width, half_width, half_width, Pose::IDENTITY))
}

/// Make a box as a hull, centred on the origin.
///
/// @param hx half the side length along x [m], > 0
/// @param hy half the side length along y [m], > 0
/// @param hz half the side length along z [m], > 0
/// @return the box; one that no function accepts for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub extern "C" fn mvMakeBoxHull(hx: mvFloat, hy: mvFloat, hz: mvFloat) -> mvBoxHull {
    call(|| make_box(hx, hy, hz, Pose::IDENTITY))
}

/// Make a box as a hull, centred on a point.
///
/// @param hx half the side length along x [m], > 0
/// @param hy half the side length along y [m], > 0
/// @param hz half the side length along z [m], > 0
/// @param offset the centre [m]
/// @return the box; one that no function accepts for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub extern "C" fn mvMakeOffsetBoxHull(hx: mvFloat, hy: mvFloat, hz: mvFloat, offset: mvVec3) -> mvBoxHull {
    call(|| make_box(hx, hy, hz, Pose::translation(offset.point("offset")?)))
}

/// Make a placed box as a hull.
///
/// @param hx half the side length along x [m], > 0
/// @param hy half the side length along y [m], > 0
/// @param hz half the side length along z [m], > 0
/// @param transform where the box is
/// @return the box; one that no function accepts for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub extern "C" fn mvMakeTransformedBoxHull(
    hx: mvFloat,
    hy: mvFloat,
    hz: mvFloat,
    transform: mvTransform,
) -> mvBoxHull {
    call(|| make_box(hx, hy, hz, transform.pose("transform")?))
}

fn make_box(hx: Float, hy: Float, hz: Float, pose: Pose) -> Result<mvBoxHull> {
    Ok(Tables::of_box(Cuboid::new(vec3(hx, hy, hz))?, &pose).box_value())
}

fn build(points: &[Vec3], max_vertices: c_int) -> Result<Hull> {
    if max_vertices < 4 {
        let sentence = format!("maxVertexCount is {max_vertices}; it must be at least 4.");
        return Err(Error::new(ErrorCode::Range, sentence));
    }
    Hull::with_max_vertices(points, max_vertices.min(MV_MAX_HULL_VERTICES) as usize)
}

fn side_count(n: c_int) -> Result<usize> {
    if (3..=127).contains(&n) {
        return Ok(n as usize);
    }
    Err(Error::new(ErrorCode::Range, format!("The number of sides is {n}; it must lie between 3 and 127.")))
}

fn ring(radius: Float, y: Float, sides: usize) -> Vec<Vec3> {
    let step = 2.0 * scalar::PI / sides as Float;
    (0..sides)
        .map(|k| {
            let (s, c) = scalar::sin_cos(step * k as Float);
            vec3(radius * c, y, -radius * s)
        })
        .collect()
}

/// The hull of `points`, scaled, then placed.
pub(super) fn transformed(points: &[Vec3], transform: mvTransform, scale: mvVec3) -> Result<Hull> {
    let (pose, scale) = (transform.pose("transform")?, scale.point("scale")?);
    if scale.iter().any(|&s| s == 0.0) {
        return Err(Error::new(ErrorCode::Degenerate, "A component of scale is zero."));
    }
    let points: Vec<Vec3> = points.iter().map(|p| pose.point(p.component_mul(&scale))).collect();
    Hull::new(&points)
}

fn give(hull: &Hull) -> Result<*mut mvHullData> {
    Ok(keep(Tables::of_hull(hull).block()))
}

/// Gives a block away, and remembers it.
fn keep(block: Block) -> *mut mvHullData {
    let (data, words) = block.into_raw();
    owned().insert(data.addr(), words);
    data
}

/// The hulls that callers own: address and number of words.
fn owned() -> MutexGuard<'static, BTreeMap<usize, usize>> {
    static OWNED: Mutex<BTreeMap<usize, usize>> = Mutex::new(BTreeMap::new());
    OWNED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Bytes of the hulls that callers own.
pub(super) fn owned_bytes() -> usize {
    owned().values().sum::<usize>() * 8
}

/// The engine's hull for a block with this hash and these points: all shapes made from equal blocks share one.
pub(super) fn shared(hash: u64, points: Vec<Vec3>) -> Result<Arc<Hull>> {
    type Known = BTreeMap<u64, (Vec<Vec3>, Weak<Hull>)>;
    static KNOWN: Mutex<Known> = Mutex::new(BTreeMap::new());
    let known = || KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((of, hull)) = known().get(&hash)
        && *of == points
        && let Some(hull) = hull.upgrade()
    {
        return Ok(hull);
    }
    let hull = Arc::new(Hull::new(&points)?);
    let mut known = known();
    // Forget the hulls that no shape uses any more, whenever the table would have to grow.
    if known.len().is_power_of_two() {
        known.retain(|_, (_, hull)| hull.strong_count() > 0);
    }
    known.insert(hash, (points, Arc::downgrade(&hull)));
    Ok(hull)
}
