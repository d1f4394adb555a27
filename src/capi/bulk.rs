//! Many bodies in one call.

use super::access::{edit_at_body, read_world};
use super::guard::{c_count, call, room, slice};
use super::id::{mvBodyId, mvWorldId};
use super::math::{mvVec3, mvWorldTransform};
use crate::error::{Error, ErrorCode};
use core::ffi::c_int;

/// Get placement and velocities of all bodies that the next step moves. An array that is null is skipped.
///
/// @param worldId the world
/// @param ids filled with the bodies, in no particular order
/// @param transforms filled with where their origins are
/// @param linear filled with the velocities of their centres of mass [m/s]
/// @param angular filled with their angular velocities in world axes [rad/s]
/// @param capacity the room in each array, >= 0
/// @return how many such bodies there are, which may be more than the capacity; 0 for bad arguments
/// @note Errors: mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvWorld_GetAwakeBodies(
    world_id: mvWorldId,
    ids: *mut mvBodyId,
    transforms: *mut mvWorldTransform,
    linear: *mut mvVec3,
    angular: *mut mvVec3,
    capacity: c_int,
) -> c_int {
    read_world(world_id, |v| {
        // Sound: the caller passes that much room in every array that is not null.
        let (ids, transforms, linear, angular) = unsafe {
            (
                room("ids", ids, capacity)?,
                room("transforms", transforms, capacity)?,
                room("linear velocities", linear, capacity)?,
                room("angular velocities", angular, capacity)?,
            )
        };
        for (k, id) in v.world.awake_bodies().enumerate().take(usize::try_from(capacity).unwrap_or(0)) {
            let body = v.world.body(id)?;
            ids.get_mut(k).map(|x| x.write(id.into()));
            transforms.get_mut(k).map(|x| x.write(body.transform().into()));
            linear.get_mut(k).map(|x| x.write(body.linear_velocity().into()));
            angular.get_mut(k).map(|x| x.write(body.angular_velocity().into()));
        }
        Ok(c_count(v.world.awake_bodies().len()))
    })
}

/// Move many bodies of one world at once, as mvBody_SetTransform() does with one. If anything is wrong with one of
/// them, none is moved.
///
/// @param ids the bodies, all of one world
/// @param transforms where their origins go
/// @param count how many, >= 0
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvBody_SetTransforms(
    ids: *const mvBodyId,
    transforms: *const mvWorldTransform,
    count: c_int,
) {
    // Sound: the caller passes that many of both.
    let given =
        || unsafe { Ok::<_, Error>((slice("ids", ids, count)?, slice("transforms", transforms, count)?)) };
    let (ids, transforms) = match given() {
        Ok(both) => both,
        Err(e) => return call(|| Err(e)),
    };
    let Some(&first) = ids.first() else { return };
    edit_at_body(first, |e| {
        let mut poses = Vec::with_capacity(ids.len());
        for (k, (&id, transform)) in ids.iter().zip(transforms).enumerate() {
            let at = |e: Error| Error::new(e.code(), format!("Body {k} of the array: {}", e.sentence()));
            if id.index1 == 0 {
                return Err(Error::new(ErrorCode::Null, format!("Body {k} of the array is null.")));
            }
            e.world.body(id.into()).map_err(at)?;
            poses.push(transform.pose("The transform").map_err(at)?);
        }
        for (&id, pose) in ids.iter().zip(&poses) {
            e.world.body_mut(id.into())?.set_transform(pose)?;
        }
        Ok(())
    });
}
