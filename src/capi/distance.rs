//! Distance, overlap and casts of convex point clouds and shapes without a world.

use super::def::mvGjkKind;
use super::def_check::flag;
use super::geometry::{NO_HIT, mvCastOutput};
use super::guard::{call, count, needed, neutral, room, slice};
use super::hull_data::{mvHullData, solid};
use super::math::{ZERO3, mvTransform, mvVec3};
use super::shape_data::{mvCapsule, mvSphere};
use super::{Flag, mvFloat};
use crate::error::{Error, ErrorCode, Result, check};
use crate::math::{Float, Pose, Vec3};
use crate::narrow_phase::{
    CastHit, MAX_PROXY_POINTS, MAX_TRACE_STEPS, Proxy, TraceStep, cast_proxy, distance_proxy_traced,
    overlap_proxy, shape_cast_proxy,
};
use crate::shape::Shape;
use core::ffi::c_int;

/// The most points of an mvShapeProxy.
pub const MV_MAX_SHAPE_CAST_POINTS: i32 = 64;
const _: () = assert!(MV_MAX_SHAPE_CAST_POINTS as usize == MAX_PROXY_POINTS);

/// A convex solid: all points within a radius of the convex hull of some points.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvShapeProxy {
    /// The points [m].
    pub points: *const mvVec3,
    /// Their number, 1 to MV_MAX_SHAPE_CAST_POINTS.
    pub count: c_int,
    /// The radius [m], >= 0.
    pub radius: mvFloat,
}

/// Two solids whose distance is wanted.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvDistanceInput {
    /// The first solid, A.
    pub proxy_a: mvShapeProxy,
    /// The second solid, B.
    pub proxy_b: mvShapeProxy,
    /// Where B is, seen from A.
    pub transform: mvTransform,
    /// Whether the radii count.
    pub use_radii: Flag,
    /// How the search looks at simplices; 0 is mv_gjk_auto.
    pub gjk: mvGjkKind,
}

/// The closest points of two solids, in the frame of A.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvDistanceOutput {
    /// The point of A closest to B; where they overlap, a common point.
    pub point_a: mvVec3,
    /// The point of B closest to A; where they overlap, the same point.
    pub point_b: mvVec3,
    /// From A to B, of length 1; zero where the hulls of the points overlap.
    pub normal: mvVec3,
    /// The distance [m]; 0 where they touch or overlap.
    pub distance: mvFloat,
    /// The number of iterations.
    pub iterations: c_int,
    /// The number of simplexes written.
    pub simplex_count: c_int,
}

/// Which points carried the closest points. Written by mvShapeDistance(); all zero is a good start.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvSimplexCache {
    /// The distance of the hulls of the points.
    pub metric: mvFloat,
    /// The number of points of each solid, 0 to 4.
    pub count: u16,
    /// Which points of A.
    pub index_a: [u8; 4],
    /// Which points of B.
    pub index_b: [u8; 4],
}

/// A pair of points of two solids.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvSimplexVertex {
    /// The point of A.
    pub w_a: mvVec3,
    /// The point of B, in the frame of A.
    pub w_b: mvVec3,
    /// From A to B.
    pub w: mvVec3,
    /// The index of the point of A.
    pub index_a: c_int,
    /// The index of the point of B.
    pub index_b: c_int,
}

/// The pairs of points between which the closest points lie.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvSimplex {
    /// The pairs, the first count of them.
    pub vertices: [mvSimplexVertex; 4],
    /// Their number, 1 to 4.
    pub count: c_int,
}

/// A solid that is moved without turning.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvShapeCastInput {
    /// The solid.
    pub proxy: mvShapeProxy,
    /// From the start to the end of the motion [m].
    pub translation: mvVec3,
    /// The greatest fraction of the translation to consider, >= 0; usually 1.
    pub max_fraction: mvFloat,
    /// Whether solids that touch at the start may come a little closer. Only false is built yet.
    pub can_encroach: Flag,
}

/// Two solids, of which the second is moved without turning.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvShapeCastPairInput {
    /// The solid that stands, A.
    pub proxy_a: mvShapeProxy,
    /// The solid that moves, B.
    pub proxy_b: mvShapeProxy,
    /// Where B starts, seen from A.
    pub transform: mvTransform,
    /// From the start to the end of B's motion, in the frame of A [m].
    pub translation_b: mvVec3,
    /// The greatest fraction of the translation to consider, >= 0; usually 1.
    pub max_fraction: mvFloat,
    /// Whether solids that touch at the start may come a little closer. Only false is built yet.
    pub can_encroach: Flag,
}

const NO_VERTEX: mvSimplexVertex =
    mvSimplexVertex { w_a: ZERO3, w_b: ZERO3, w: ZERO3, index_a: 0, index_b: 0 };

neutral! {
    mvDistanceOutput = mvDistanceOutput {
        point_a: ZERO3,
        point_b: ZERO3,
        normal: ZERO3,
        distance: 0.0,
        iterations: 0,
        simplex_count: 0,
    };
}

/// The points and the radius of a proxy, as the engine takes them.
pub(super) struct Cloud {
    points: Vec<Vec3>,
    radius: Float,
}

impl Cloud {
    pub(super) fn proxy(&self) -> Result<Proxy<'_>> {
        Proxy::new(&self.points, self.radius)
    }
}

impl mvShapeProxy {
    /// # Safety
    /// `points` is null or points to `count` points.
    pub(super) unsafe fn copied(&self) -> Result<Cloud> {
        let n = count("The proxy's number of points", self.count)?;
        if n == 0 || n > MAX_PROXY_POINTS {
            let sentence = format!("A proxy has 1 to {MAX_PROXY_POINTS} points, not {n}.");
            return Err(Error::new(ErrorCode::Range, sentence));
        }
        // Sound: by this function's contract.
        let points = unsafe { slice("the proxy's points", self.points, self.count) }?;
        Ok(Cloud { points: points.iter().map(|p| p.raw()).collect(), radius: self.radius })
    }
}

/// Get the distance of two convex solids.
///
/// @param input the solids
/// @param cache written: which points carry the closest points; may be null. Today's search does not read it.
/// @param simplexes filled with the simplexes of the search in order, the one it ended with always the last; may be null
/// @param simplexCapacity the room in the array, >= 0; 65 is enough for every search
/// @return the closest points, in the frame of A; zero for bad arguments
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvShapeDistance(
    input: Option<&mvDistanceInput>,
    cache: Option<&mut mvSimplexCache>,
    simplexes: *mut mvSimplex,
    simplex_capacity: c_int,
) -> mvDistanceOutput {
    call(|| {
        let input = needed("The input", input)?;
        // Sound: the caller passes proxies with as many points as they say.
        let (mut a, mut b) = unsafe { (input.proxy_a.copied()?, input.proxy_b.copied()?) };
        // Bad radii are told even where they do not count.
        a.proxy().and(b.proxy())?;
        let pose = input.transform.pose("transform")?;
        // Sound: the caller passes that much room.
        let room = unsafe { room("simplexes", simplexes, simplex_capacity) }?;
        if !flag("useRadii", input.use_radii)? {
            (a.radius, b.radius) = (0.0, 0.0);
        }
        let (pa, pb) = (a.proxy()?, b.proxy()?);
        let gjk = super::kind::gjk(input.gjk)?;
        let mut steps = [TraceStep::default(); MAX_TRACE_STEPS];
        // A search that nobody watches records nothing; the cache wants its end.
        let wanted = if cache.is_some() { room.len().max(1) } else { room.len() };
        let steps = &mut steps[..wanted.min(MAX_TRACE_STEPS)];
        let (d, recorded) = distance_proxy_traced(&pa, &pb, &pose, gjk, steps);
        if let (Some(cache), Some(end)) = (cache, recorded.checked_sub(1).map(|i| &steps[i])) {
            let metric = d.distance + if d.distance > 0.0 { a.radius + b.radius } else { 0.0 };
            *cache = mvSimplexCache {
                metric,
                count: end.count as u16,
                index_a: end.pairs.map(|(i, _)| i as u8),
                index_b: end.pairs.map(|(_, j)| j as u8),
            };
        }
        let mut written = 0;
        for (place, step) in room.iter_mut().zip(&steps[..recorded]) {
            let mut vertices = [NO_VERTEX; 4];
            for (v, (i, j)) in vertices.iter_mut().zip(&step.pairs[..step.count]) {
                let (wa, wb) = (a.points[*i as usize], pose.point(b.points[*j as usize]));
                *v = mvSimplexVertex {
                    w_a: wa.into(),
                    w_b: wb.into(),
                    w: (wb - wa).into(),
                    index_a: c_int::from(*i),
                    index_b: c_int::from(*j),
                };
            }
            place.write(mvSimplex { vertices, count: step.count as c_int });
            written += 1;
        }
        Ok(mvDistanceOutput {
            point_a: d.point_a.into(),
            point_b: d.point_b.into(),
            normal: d.normal.into(),
            distance: d.distance,
            iterations: d.iterations as c_int,
            simplex_count: written,
        })
    })
}

/// Move a convex solid until it touches another. Solids that overlap from the start do not hit.
///
/// @param input the solids
/// @return the first hit, in the frame of A; no hit for bad arguments
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvShapeCast(input: Option<&mvShapeCastPairInput>) -> mvCastOutput {
    call(|| {
        let input = needed("The input", input)?;
        // Sound: the caller passes proxies with as many points as they say.
        let (a, b) = unsafe { (input.proxy_a.copied()?, input.proxy_b.copied()?) };
        let pose = input.transform.pose("transform")?;
        let way = input.translation_b.point("translationB")?;
        let most = check::not_negative("maxFraction", input.max_fraction)?;
        no_encroaching(input.can_encroach)?;
        Ok(output(shape_cast_proxy(&a.proxy()?, &b.proxy()?, &pose, way, most)))
    })
}

/// Does a sphere touch or overlap a solid?
///
/// @param shape the sphere
/// @param shapeTransform where the sphere is
/// @param proxy the solid
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvOverlapSphere(
    shape: Option<&mvSphere>,
    shape_transform: mvTransform,
    proxy: Option<&mvShapeProxy>,
) -> bool {
    call(|| {
        let shape = Shape::Sphere(needed("The sphere", shape)?.solid()?);
        // Sound: the caller passes a proxy with as many points as it says.
        unsafe { overlaps(&shape, &Pose::IDENTITY, shape_transform, proxy) }
    })
}

/// Does a capsule touch or overlap a solid?
///
/// @param shape the capsule
/// @param shapeTransform where the capsule is
/// @param proxy the solid
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvOverlapCapsule(
    shape: Option<&mvCapsule>,
    shape_transform: mvTransform,
    proxy: Option<&mvShapeProxy>,
) -> bool {
    call(|| {
        let shape = Shape::Capsule(needed("The capsule", shape)?.solid()?);
        // Sound: the caller passes a proxy with as many points as it says.
        unsafe { overlaps(&shape, &Pose::IDENTITY, shape_transform, proxy) }
    })
}

/// Does a hull touch or overlap a solid?
///
/// @param shape the hull
/// @param shapeTransform where the hull is
/// @param proxy the solid
/// @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvOverlapHull(
    shape: *const mvHullData,
    shape_transform: mvTransform,
    proxy: Option<&mvShapeProxy>,
) -> bool {
    call(|| {
        // Sound: the caller passes a hull, and a proxy with as many points as it says.
        unsafe {
            let (shape, local) = solid(shape)?;
            overlaps(&shape, &local, shape_transform, proxy)
        }
    })
}

/// Move a solid against a sphere. A solid that overlaps from the start does not hit.
///
/// @param shape the sphere
/// @param input the solid and its motion, in the sphere's frame
/// @return the first hit; no hit for bad arguments
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvShapeCastSphere(
    shape: Option<&mvSphere>,
    input: Option<&mvShapeCastInput>,
) -> mvCastOutput {
    call(|| {
        let shape = Shape::Sphere(needed("The sphere", shape)?.solid()?);
        // Sound: the caller passes a proxy with as many points as it says.
        unsafe { cast(&shape, &Pose::IDENTITY, input) }
    })
}

/// Move a solid against a capsule. A solid that overlaps from the start does not hit.
///
/// @param shape the capsule
/// @param input the solid and its motion, in the capsule's frame
/// @return the first hit; no hit for bad arguments
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvShapeCastCapsule(
    shape: Option<&mvCapsule>,
    input: Option<&mvShapeCastInput>,
) -> mvCastOutput {
    call(|| {
        let shape = Shape::Capsule(needed("The capsule", shape)?.solid()?);
        // Sound: the caller passes a proxy with as many points as it says.
        unsafe { cast(&shape, &Pose::IDENTITY, input) }
    })
}

/// Move a solid against a hull. A solid that overlaps from the start does not hit.
///
/// @param shape the hull
/// @param input the solid and its motion, in the hull's frame
/// @return the first hit; no hit for bad arguments
/// @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvShapeCastHull(
    shape: *const mvHullData,
    input: Option<&mvShapeCastInput>,
) -> mvCastOutput {
    call(|| {
        // Sound: the caller passes a hull, and a proxy with as many points as it says.
        unsafe {
            let (shape, local) = solid(shape)?;
            cast(&shape, &local, input)
        }
    })
}

/// # Safety
/// The proxy's points are as many as it says.
unsafe fn overlaps(
    shape: &Shape,
    local: &Pose,
    transform: mvTransform,
    proxy: Option<&mvShapeProxy>,
) -> Result<bool> {
    // Sound: by this function's contract.
    let cloud = unsafe { needed("The proxy", proxy)?.copied() }?;
    Ok(overlap_proxy(shape, &cloud.proxy()?, &transform.pose("shapeTransform")?.then(local).inverse()))
}

/// # Safety
/// The proxy's points are as many as it says.
unsafe fn cast(shape: &Shape, local: &Pose, input: Option<&mvShapeCastInput>) -> Result<mvCastOutput> {
    let input = needed("The input", input)?;
    // Sound: by this function's contract.
    let cloud = unsafe { input.proxy.copied() }?;
    let way = input.translation.point("translation")?;
    let most = check::not_negative("maxFraction", input.max_fraction)?;
    no_encroaching(input.can_encroach)?;
    let hit = cast_proxy(shape, &cloud.proxy()?, &local.inverse(), local.vector_back(way), most);
    Ok(output(hit.map(|h| CastHit { point: local.point(h.point), normal: local.vector(h.normal), ..h })))
}

pub(super) fn no_encroaching(can_encroach: Flag) -> Result<()> {
    if flag("canEncroach", can_encroach)? {
        return Err(Error::new(
            ErrorCode::Unsupported,
            "Encroaching is not built yet: canEncroach must be false.",
        ));
    }
    Ok(())
}

/// A hit for C, unless the solids overlapped from the start.
fn output(hit: Option<CastHit>) -> mvCastOutput {
    hit.filter(|h| h.normal != Vec3::zeros()).map_or(NO_HIT, |h| mvCastOutput {
        normal: h.normal.into(),
        point: h.point.into(),
        fraction: h.fraction,
        iterations: 0,
        hit: true,
    })
}
