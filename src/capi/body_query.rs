//! Rays, moving solids and distances against the shapes of one body.

use super::access::read_body;
use super::def::mvQueryFilter;
use super::distance::{mvShapeProxy, no_encroaching};
use super::guard::{Neutral, needed, neutral};
use super::id::{mvBodyId, mvShapeId};
use super::math::{ORIGIN, ZERO3, mvPos, mvVec3, mvWorldTransform};
use super::{Flag, mvFloat};
use crate::world::ShapeHit;
use core::ffi::c_int;

/// Where a ray or a moving solid hits a body.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvBodyCastResult {
    /// The shape that was hit.
    pub shape_id: mvShapeId,
    /// The point on its surface [m].
    pub point: mvPos,
    /// The outward normal of the surface at the point, of length 1.
    pub normal: mvVec3,
    /// The fraction of the translation travelled.
    pub fraction: mvFloat,
    /// The user material of the shape.
    pub user_material_id: u64,
    /// The number of iterations used; 0 where the answer is a closed form.
    pub iterations: c_int,
    /// Whether there was a hit. If not, everything else is zero.
    pub hit: bool,
}

neutral! {
    mvBodyCastResult = mvBodyCastResult {
        shape_id: mvShapeId::NEUTRAL,
        point: ORIGIN,
        normal: ZERO3,
        fraction: 0.0,
        user_material_id: 0,
        iterations: 0,
        hit: false,
    };
}

/// Get the point of a body's shapes closest to a target.
/// @param bodyId the body
/// @param result where to write the point, in the world; the target itself where that is inside, the body's origin when
/// it has no shapes; may be null
/// @param target the target, in the world [m]
/// @return the distance [m]; 0 for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetClosestPoint(
    body_id: mvBodyId,
    result: Option<&mut mvVec3>,
    target: mvVec3,
) -> mvFloat {
    read_body(body_id, |b| {
        let (point, distance) = b.closest_point(target.point("target")?);
        result.into_iter().for_each(|r| *r = point.into());
        Ok(distance)
    })
}

/// Cast a ray at a body as if it were somewhere. A ray that starts inside a shape does not hit that shape.
/// @param bodyId the body
/// @param origin where the ray starts [m]
/// @param translation from the start to the end of the ray [m]
/// @param filter which shapes the ray sees
/// @param maxFraction the greatest fraction of the translation to consider, 0 to 1
/// @param bodyTransform where to think the body is
/// @return the first hit; no hit for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_CastRay(
    body_id: mvBodyId,
    origin: mvPos,
    translation: mvVec3,
    filter: mvQueryFilter,
    max_fraction: mvFloat,
    body_transform: mvWorldTransform,
) -> mvBodyCastResult {
    read_body(body_id, |b| {
        let at = body_transform.pose("bodyTransform")?;
        let hit = b.ray_cast(origin.raw(), translation.raw(), filter.raw(), max_fraction, &at)?;
        Ok(hit.map_or(mvBodyCastResult::NEUTRAL, Into::into))
    })
}

/// Move a solid against a body as if that were somewhere. A shape that it overlaps from the start is hit at fraction 0
/// with a zero normal.
/// @param bodyId the body
/// @param origin what the points of the proxy are counted from [m]
/// @param proxy the solid
/// @param translation from the start to the end of the motion [m]
/// @param filter which shapes the solid sees
/// @param maxFraction the greatest fraction of the translation to consider, 0 to 1
/// @param canEncroach whether touching solids may come a little closer; only false is built yet
/// @param bodyTransform where to think the body is
/// @return the first hit; no hit for bad arguments
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvBody_CastShape(
    body_id: mvBodyId,
    origin: mvPos,
    proxy: Option<&mvShapeProxy>,
    translation: mvVec3,
    filter: mvQueryFilter,
    max_fraction: mvFloat,
    can_encroach: Flag,
    body_transform: mvWorldTransform,
) -> mvBodyCastResult {
    read_body(body_id, |b| {
        // Sound: the caller passes a proxy with as many points as it says.
        let cloud = unsafe { needed("The proxy", proxy)?.copied() }?;
        no_encroaching(can_encroach)?;
        let (solid, at) = (cloud.proxy()?, body_transform.pose("bodyTransform")?);
        let hit = b.shape_cast(&solid, origin.raw(), translation.raw(), filter.raw(), max_fraction, &at)?;
        Ok(hit.map_or(mvBodyCastResult::NEUTRAL, Into::into))
    })
}

/// Does a solid touch or overlap a body as if that were somewhere?
/// @param bodyId the body
/// @param origin what the points of the proxy are counted from [m]
/// @param proxy the solid
/// @param filter which shapes the solid sees
/// @param bodyTransform where to think the body is
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvBody_OverlapShape(
    body_id: mvBodyId,
    origin: mvPos,
    proxy: Option<&mvShapeProxy>,
    filter: mvQueryFilter,
    body_transform: mvWorldTransform,
) -> bool {
    read_body(body_id, |b| {
        // Sound: the caller passes a proxy with as many points as it says.
        let cloud = unsafe { needed("The proxy", proxy)?.copied() }?;
        b.overlap_shape(&cloud.proxy()?, origin.raw(), filter.raw(), &body_transform.pose("bodyTransform")?)
    })
}

impl From<ShapeHit> for mvBodyCastResult {
    fn from(h: ShapeHit) -> Self {
        Self {
            shape_id: h.shape.into(),
            point: h.point.into(),
            normal: h.normal.into(),
            fraction: h.fraction,
            user_material_id: h.user_material_id,
            iterations: 0,
            hit: true,
        }
    }
}
