//! Rays, moving solids and distances against the shapes of one body.

use super::def::mvQueryFilter;
use super::distance::{Cloud, moved_against, mvShapeProxy, no_encroaching, touches};
use super::geometry::from_outside;
use super::guard::{Neutral, needed, neutral};
use super::id::{mvBodyId, mvShapeId};
use super::math::{ORIGIN, ZERO3, mvPos, mvVec3, mvWorldTransform};
use super::registry::{View, read_body, view_body};
use super::{Flag, mvFloat};
use crate::error::{Result, check};
use crate::math::{Pose, Vec3};
use crate::world::{BodyRef, ColliderRef};
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
/// @param maxFraction the greatest fraction of the translation to consider, >= 0; usually 1
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
    view_body(body_id, |v, b| {
        let (origin, way) = (origin.point("origin")?, translation.point("translation")?);
        let most = check::not_negative("maxFraction", max_fraction)?;
        let mut best = mvBodyCastResult::NEUTRAL;
        each_shape(v, b, filter, body_transform, |shape, pose| {
            let most = if best.hit { best.fraction } else { most };
            let hit = shape.shape().ray_cast(pose.point_back(origin), pose.vector_back(way), most);
            if let Some(h) = hit.filter(from_outside)
                && (!best.hit || h.fraction < best.fraction)
            {
                best = result(shape, pose.point(h.point), pose.vector(h.normal), h.fraction);
            }
        })?;
        Ok(best)
    })
}

/// Move a solid against a body as if that were somewhere. A solid that overlaps a shape from the start does not hit
/// that shape.
/// @param bodyId the body
/// @param origin what the points of the proxy are counted from [m]
/// @param proxy the solid
/// @param translation from the start to the end of the motion [m]
/// @param filter which shapes the solid sees
/// @param maxFraction the greatest fraction of the translation to consider, >= 0; usually 1
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
    view_body(body_id, |v, b| {
        // Sound: the caller passes a proxy with as many points as it says.
        let cloud = unsafe { at(origin, proxy) }?;
        let way = translation.point("translation")?;
        let most = check::not_negative("maxFraction", max_fraction)?;
        no_encroaching(can_encroach)?;
        let mut best = mvBodyCastResult::NEUTRAL;
        each_shape(v, b, filter, body_transform, |shape, pose| {
            let most = if best.hit { best.fraction } else { most };
            let hit = moved_against(shape.shape(), pose, &cloud, way, most);
            if let Some(h) = hit.filter(|h| h.normal != Vec3::zeros())
                && (!best.hit || h.fraction < best.fraction)
            {
                best = result(shape, h.point, h.normal, h.fraction);
            }
        })?;
        Ok(best)
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
    view_body(body_id, |v, b| {
        // Sound: the caller passes a proxy with as many points as it says.
        let cloud = unsafe { at(origin, proxy) }?;
        let mut any = false;
        each_shape(v, b, filter, body_transform, |shape, pose| any |= touches(shape.shape(), pose, &cloud))?;
        Ok(any)
    })
}

/// The proxy's solid, placed at `origin`.
///
/// # Safety
/// The proxy's points are as many as it says.
pub(super) unsafe fn at(origin: mvPos, proxy: Option<&mvShapeProxy>) -> Result<Cloud> {
    let origin = origin.point("origin")?;
    // Sound: by this function's contract.
    Ok(unsafe { needed("The proxy", proxy)?.checked() }?.shifted(origin))
}

fn each_shape(
    v: View<'_>,
    body: BodyRef<'_>,
    filter: mvQueryFilter,
    transform: mvWorldTransform,
    mut f: impl FnMut(&ColliderRef<'_>, &Pose),
) -> Result<()> {
    let (filter, pose) = (filter.raw(), transform.pose("bodyTransform")?);
    for id in body.shapes() {
        let shape = v.world.shape(id)?;
        if filter.sees(&shape.filter()) {
            f(&shape, &pose.then(&shape.local_pose()));
        }
    }
    Ok(())
}

fn result(shape: &ColliderRef<'_>, point: Vec3, normal: Vec3, fraction: mvFloat) -> mvBodyCastResult {
    mvBodyCastResult {
        shape_id: shape.id().into(),
        point: point.into(),
        normal: normal.into(),
        fraction,
        user_material_id: shape.material().user_material_id,
        iterations: 0,
        hit: true,
    }
}
