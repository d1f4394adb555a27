//! Questions to a world. Each comes with a callback and in a form that fills an array.

use super::access::read_world;
use super::def::mvQueryFilter;
use super::distance::{Cloud, mvShapeProxy};
use super::guard::{Neutral, fill, needed, neutral, room};
use super::id::{mvShapeId, mvWorldId};
use super::math::{ORIGIN, ZERO3, mvAABB, mvPos, mvVec3};
use super::registry::in_callback;
use super::{Flag, mvFloat};
use crate::error::Result;
use crate::math::{Float, Vec3};
use crate::world::ShapeHit;
use core::ffi::{c_int, c_void};

/// What a query looked at.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvTreeStats {
    /// The number of shapes that the callback was told of.
    pub leaf_visits: c_int,
}

/// Where a ray or a moving solid hits a shape.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvRayResult {
    /// The shape that was hit.
    pub shape_id: mvShapeId,
    /// The point on its surface [m].
    pub point: mvPos,
    /// The outward normal of the surface at the point, of length 1; zero where a moving solid overlaps the shape from
    /// the start.
    pub normal: mvVec3,
    /// The user material of the shape.
    pub user_material_id: u64,
    /// The fraction of the translation travelled.
    pub fraction: mvFloat,
    /// Whether there was a hit. If not, everything else is zero.
    pub hit: bool,
}

/// Told of a shape that an overlap query found.
///
/// @return true to go on, false to stop
pub type mvOverlapResultFcn = Option<unsafe extern "C" fn(shapeId: mvShapeId, context: *mut c_void) -> Flag>;

/// Told of a shape that a ray or a moving solid hit, nearest first.
///
/// @param point where, in the world [m]
/// @param normal the outward normal of the surface there
/// @param fraction the fraction of the translation travelled
/// @param userMaterialId the user material of the shape
/// @param triangleIndex -1: shapes of triangles are not built yet
/// @param childIndex -1: compound shapes are not built yet
/// @return -1 to ignore this shape, 0 to stop, a fraction to look no farther than that, 1 to go on
pub type mvCastResultFcn = Option<
    unsafe extern "C" fn(
        shapeId: mvShapeId,
        point: mvPos,
        normal: mvVec3,
        fraction: mvFloat,
        userMaterialId: u64,
        triangleIndex: c_int,
        childIndex: c_int,
        context: *mut c_void,
    ) -> mvFloat,
>;

neutral! {
    mvTreeStats = mvTreeStats { leaf_visits: 0 };
    mvRayResult = mvRayResult {
        shape_id: mvShapeId::NEUTRAL,
        point: ORIGIN,
        normal: ZERO3,
        user_material_id: 0,
        fraction: 0.0,
        hit: false,
    };
}

impl From<ShapeHit> for mvRayResult {
    fn from(h: ShapeHit) -> Self {
        Self {
            shape_id: h.shape.into(),
            point: h.point.into(),
            normal: h.normal.into(),
            user_material_id: h.user_material_id,
            fraction: h.fraction,
            hit: true,
        }
    }
}

/// Find the shapes whose boxes overlap a box. The world may be read but not changed in the callback.
///
/// @param worldId the world
/// @param aabb the box
/// @param filter which shapes the query sees
/// @param fcn told of each shape, in order of their places
/// @param context passed to fcn
/// @return what was looked at; zero for bad arguments
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvWorld_OverlapAABB(
    world_id: mvWorldId,
    aabb: mvAABB,
    filter: mvQueryFilter,
    fcn: mvOverlapResultFcn,
    context: *mut c_void,
) -> mvTreeStats {
    read_world(world_id, |v| {
        let fcn = needed("fcn", fcn)?;
        let found = v.world.overlap_aabb_all(&aabb.raw(), filter.raw())?;
        Ok(tell(found.into_iter().map(Into::into), |id| {
            // Sound: the caller passes a function of this signature that does not unwind.
            in_callback(v.world, || unsafe { fcn(id, context) }) != 0
        }))
    })
}

/// Find the shapes whose boxes overlap a box, into an array.
///
/// @param worldId the world
/// @param aabb the box
/// @param filter which shapes the query sees
/// @param shapeIds filled with the shapes, in order of their places; may be null
/// @param capacity the room in the array, >= 0
/// @return how many were found, which may be more than the capacity; 0 for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvWorld_OverlapAABBAll(
    world_id: mvWorldId,
    aabb: mvAABB,
    filter: mvQueryFilter,
    shape_ids: *mut mvShapeId,
    capacity: c_int,
) -> c_int {
    read_world(world_id, |v| {
        // Sound: the caller passes that much room.
        let room = unsafe { room("shapes", shape_ids, capacity) }?;
        let found = v.world.overlap_aabb_all(&aabb.raw(), filter.raw())?;
        Ok(fill(room, found.into_iter().map(Into::into)))
    })
}

/// Find the shapes that touch or overlap a solid. The world may be read but not changed in the callback.
///
/// @param worldId the world
/// @param origin what the points of the proxy are counted from [m]
/// @param proxy the solid
/// @param filter which shapes the query sees
/// @param fcn told of each shape, in order of their places
/// @param context passed to fcn
/// @return what was looked at; zero for bad arguments
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvWorld_OverlapShape(
    world_id: mvWorldId,
    origin: mvPos,
    proxy: Option<&mvShapeProxy>,
    filter: mvQueryFilter,
    fcn: mvOverlapResultFcn,
    context: *mut c_void,
) -> mvTreeStats {
    read_world(world_id, |v| {
        // Sound: the caller passes a proxy with as many points as it says.
        let cloud = unsafe { given(proxy) }?;
        let fcn = needed("fcn", fcn)?;
        let found = v.world.overlap_shape_all(&cloud.proxy()?, origin.raw(), filter.raw())?;
        Ok(tell(found.into_iter().map(Into::into), |id| {
            // Sound: the caller passes a function of this signature that does not unwind.
            in_callback(v.world, || unsafe { fcn(id, context) }) != 0
        }))
    })
}

/// Find the shapes that touch or overlap a solid, into an array.
///
/// @param worldId the world
/// @param origin what the points of the proxy are counted from [m]
/// @param proxy the solid
/// @param filter which shapes the query sees
/// @param shapeIds filled with the shapes, in order of their places; may be null
/// @param capacity the room in the array, >= 0
/// @return how many were found, which may be more than the capacity; 0 for bad arguments
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvWorld_OverlapShapeAll(
    world_id: mvWorldId,
    origin: mvPos,
    proxy: Option<&mvShapeProxy>,
    filter: mvQueryFilter,
    shape_ids: *mut mvShapeId,
    capacity: c_int,
) -> c_int {
    read_world(world_id, |v| {
        // Sound: the caller passes that much room, and a proxy with as many points as it says.
        let (room, cloud) = unsafe { (room("shapes", shape_ids, capacity)?, given(proxy)?) };
        let found = v.world.overlap_shape_all(&cloud.proxy()?, origin.raw(), filter.raw())?;
        Ok(fill(room, found.into_iter().map(Into::into)))
    })
}

/// Cast a ray and be told of the shapes that it hits, nearest first. Shapes in which it starts are not hit. The world
/// may be read but not changed in the callback.
///
/// @param worldId the world
/// @param origin where the ray starts [m]
/// @param translation from the start to the end of the ray [m]
/// @param filter which shapes the ray sees
/// @param fcn told of each hit
/// @param context passed to fcn
/// @return what was looked at; zero for bad arguments
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvWorld_CastRay(
    world_id: mvWorldId,
    origin: mvPos,
    translation: mvVec3,
    filter: mvQueryFilter,
    fcn: mvCastResultFcn,
    context: *mut c_void,
) -> mvTreeStats {
    read_world(world_id, |v| {
        let fcn = needed("fcn", fcn)?;
        let mut hits = v.world.cast_ray_all(origin.raw(), translation.raw(), filter.raw())?;
        hits.retain(outside);
        Ok(tell_hits(&hits, |h| {
            let (point, normal, material) = (h.point.into(), h.normal.into(), h.user_material_id);
            // Sound: the caller passes a function of this signature that does not unwind.
            in_callback(v.world, || unsafe {
                fcn(h.shape.into(), point, normal, h.fraction, material, -1, -1, context)
            })
        }))
    })
}

/// Cast a ray and get the nearest shape that it hits. Shapes in which it starts are not hit.
///
/// @param worldId the world
/// @param origin where the ray starts [m]
/// @param translation from the start to the end of the ray [m]
/// @param filter which shapes the ray sees
/// @return the nearest hit; of equally near ones that of the shape with the lowest place; no hit for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_CastRayClosest(
    world_id: mvWorldId,
    origin: mvPos,
    translation: mvVec3,
    filter: mvQueryFilter,
) -> mvRayResult {
    read_world(world_id, |v| {
        let hit = v.world.cast_ray_closest(origin.raw(), translation.raw(), filter.raw())?;
        Ok(hit.map_or(mvRayResult::NEUTRAL, Into::into))
    })
}

/// Cast a ray and get the shapes that it hits, nearest first. Shapes in which it starts are not hit.
///
/// @param worldId the world
/// @param origin where the ray starts [m]
/// @param translation from the start to the end of the ray [m]
/// @param filter which shapes the ray sees
/// @param results filled with the hits; may be null
/// @param capacity the room in the array, >= 0
/// @return how many hits there are, which may be more than the capacity; 0 for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvWorld_CastRayAll(
    world_id: mvWorldId,
    origin: mvPos,
    translation: mvVec3,
    filter: mvQueryFilter,
    results: *mut mvRayResult,
    capacity: c_int,
) -> c_int {
    read_world(world_id, |v| {
        // Sound: the caller passes that much room.
        let room = unsafe { room("results", results, capacity) }?;
        let hits = v.world.cast_ray_all(origin.raw(), translation.raw(), filter.raw())?;
        Ok(fill(room, hits.into_iter().filter(outside).map(Into::into)))
    })
}

/// Move a solid without turning and be told of the shapes that it hits, nearest first. A shape that it overlaps from
/// the start is hit at fraction 0 with a zero normal. The world may be read but not changed in the callback.
///
/// @param worldId the world
/// @param origin what the points of the proxy are counted from [m]
/// @param proxy the solid
/// @param translation from the start to the end of the motion [m]
/// @param filter which shapes the solid sees
/// @param fcn told of each hit
/// @param context passed to fcn
/// @return what was looked at; zero for bad arguments
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvWorld_CastShape(
    world_id: mvWorldId,
    origin: mvPos,
    proxy: Option<&mvShapeProxy>,
    translation: mvVec3,
    filter: mvQueryFilter,
    fcn: mvCastResultFcn,
    context: *mut c_void,
) -> mvTreeStats {
    read_world(world_id, |v| {
        // Sound: the caller passes a proxy with as many points as it says.
        let cloud = unsafe { given(proxy) }?;
        let fcn = needed("fcn", fcn)?;
        let hits = v.world.cast_shape_all(&cloud.proxy()?, origin.raw(), translation.raw(), filter.raw())?;
        Ok(tell_hits(&hits, |h| {
            let (point, normal, material) = (h.point.into(), h.normal.into(), h.user_material_id);
            // Sound: the caller passes a function of this signature that does not unwind.
            in_callback(v.world, || unsafe {
                fcn(h.shape.into(), point, normal, h.fraction, material, -1, -1, context)
            })
        }))
    })
}

/// Move a solid without turning and get the nearest shape that it hits. A shape that it overlaps from the start is hit
/// at fraction 0 with a zero normal.
///
/// @param worldId the world
/// @param origin what the points of the proxy are counted from [m]
/// @param proxy the solid
/// @param translation from the start to the end of the motion [m]
/// @param filter which shapes the solid sees
/// @return the nearest hit; of equally near ones that of the shape with the lowest place; no hit for bad arguments
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvWorld_CastShapeClosest(
    world_id: mvWorldId,
    origin: mvPos,
    proxy: Option<&mvShapeProxy>,
    translation: mvVec3,
    filter: mvQueryFilter,
) -> mvRayResult {
    read_world(world_id, |v| {
        // Sound: the caller passes a proxy with as many points as it says.
        let cloud = unsafe { given(proxy) }?;
        let hit =
            v.world.cast_shape_closest(&cloud.proxy()?, origin.raw(), translation.raw(), filter.raw())?;
        Ok(hit.map_or(mvRayResult::NEUTRAL, Into::into))
    })
}

/// Move a solid without turning and get the shapes that it hits, nearest first. A shape that it overlaps from the start
/// is hit at fraction 0 with a zero normal.
///
/// @param worldId the world
/// @param origin what the points of the proxy are counted from [m]
/// @param proxy the solid
/// @param translation from the start to the end of the motion [m]
/// @param filter which shapes the solid sees
/// @param results filled with the hits; may be null
/// @param capacity the room in the array, >= 0
/// @return how many hits there are, which may be more than the capacity; 0 for bad arguments
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvWorld_CastShapeAll(
    world_id: mvWorldId,
    origin: mvPos,
    proxy: Option<&mvShapeProxy>,
    translation: mvVec3,
    filter: mvQueryFilter,
    results: *mut mvRayResult,
    capacity: c_int,
) -> c_int {
    read_world(world_id, |v| {
        // Sound: the caller passes that much room, and a proxy with as many points as it says.
        let (room, cloud) = unsafe { (room("results", results, capacity)?, given(proxy)?) };
        let hits = v.world.cast_shape_all(&cloud.proxy()?, origin.raw(), translation.raw(), filter.raw())?;
        Ok(fill(room, hits.into_iter().map(Into::into)))
    })
}

/// # Safety
/// The proxy's points are as many as it says.
unsafe fn given(proxy: Option<&mvShapeProxy>) -> Result<Cloud> {
    // Sound: by this function's contract.
    unsafe { needed("The proxy", proxy)?.copied() }
}

fn outside(hit: &ShapeHit) -> bool {
    hit.normal != Vec3::zeros()
}

fn tell(found: impl Iterator<Item = mvShapeId>, mut callback: impl FnMut(mvShapeId) -> bool) -> mvTreeStats {
    let mut stats = mvTreeStats::NEUTRAL;
    for id in found {
        stats.leaf_visits += 1;
        if !callback(id) {
            break;
        }
    }
    stats
}

fn tell_hits(hits: &[ShapeHit], mut callback: impl FnMut(&ShapeHit) -> Float) -> mvTreeStats {
    let (mut stats, mut most) = (mvTreeStats::NEUTRAL, 1.0);
    for hit in hits {
        if hit.fraction > most {
            break;
        }
        stats.leaf_visits += 1;
        let answer = callback(hit);
        if answer == 0.0 {
            break;
        }
        // An answer that is negative, or no number, changes nothing.
        if answer > 0.0 {
            most = answer.min(most);
        }
    }
    stats
}
