//! Worlds: making, stepping, destroying.

use super::access::{read_world, write_world};
use super::def::*;
use super::def_check::{from_word, to_word};
use super::guard::{c_count, call, needed};
use super::id::mvWorldId;
use super::math::mvAABB;
use super::mvFloat;
use super::registry;
use crate::error::{Error, ErrorCode};
use crate::math::Aabb;
use core::ffi::{c_int, c_void};

/// Create a world. At least 4096 worlds can live at once; worlds are independent of each other.
///
/// @param def the definition, from mvDefaultWorldDef()
/// @return the world, to be destroyed by mvDestroyWorld(); null for bad arguments
/// @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported,
/// mv_errorCapacity.
#[unsafe(no_mangle)]
pub extern "C" fn mvCreateWorld(def: Option<&mvWorldDef>) -> mvWorldId {
    call(|| {
        let def = needed("The definition", def)?;
        registry::create(&def.checked()?, |world| {
            world.set_friction_mixing(super::callback::friction(def.friction_callback, def.friction_context));
            world.set_restitution_mixing(super::callback::restitution(
                def.restitution_callback,
                def.restitution_context,
            ));
        })
    })
}

/// Destroy a world with everything in it. All ids of it are stale from then on.
///
/// @param worldId the world; a faulted one can be destroyed as well
#[unsafe(no_mangle)]
pub extern "C" fn mvDestroyWorld(world_id: mvWorldId) {
    call(|| registry::destroy(world_id));
}

/// Get the number of worlds that live now.
#[unsafe(no_mangle)]
pub extern "C" fn mvGetWorldCount() -> c_int {
    call(|| Ok(c_count(registry::world_count())))
}

/// Get the number of bytes that the library holds: for all worlds and for hulls that callers own. A world that
/// another thread is changing counts as 0.
#[unsafe(no_mangle)]
pub extern "C" fn mvGetByteCount() -> i64 {
    call(|| {
        let mut bytes = super::hull::owned_bytes();
        registry::for_each_world(|view| bytes += view.world.byte_count());
        Ok(i64::try_from(bytes).unwrap_or(i64::MAX))
    })
}

/// Does this id name a world that lives? Never fails.
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_IsValid(id: mvWorldId) -> bool {
    registry::is_world(id)
}

/// Move the world through time.
///
/// @param worldId the world
/// @param timeStep how far [s], >= 0; keep it the same from step to step, usually 1/60. 0 brings contacts up to
/// date and moves nothing.
/// @param subStepCount into how many sub-steps to divide it, 1 to 1000, usually 4. More is more accurate.
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_Step(world_id: mvWorldId, time_step: mvFloat, sub_step_count: c_int) {
    write_world(world_id, |edit| {
        let sub_steps = u32::try_from(sub_step_count).ok().filter(|&n| n > 0).ok_or_else(|| {
            Error::new(ErrorCode::Range, format!("subStepCount is {sub_step_count}; it must be at least 1."))
        })?;
        crate::error::check::not_negative("timeStep", time_step)?;
        edit.side.begin_step();
        edit.world.try_step(time_step, sub_steps)?;
        // Whatever callbacks asked for was half a step's.
        edit.side.begin_step();
        Ok(())
    });
}

/// Get the box around everything in the world that has bounds, with some room to spare; zero for an empty world.
/// @param worldId the world
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_GetBounds(world_id: mvWorldId) -> mvAABB {
    read_world(world_id, |v| {
        let all = v.world.bodies().try_fold(Aabb::EMPTY, |b, id| {
            let body = v.world.body(id)?;
            Ok::<_, Error>(if body.shapes().len() > 0 { b.union(&body.aabb()) } else { b })
        })?;
        Ok(if all.is_valid() { all.into() } else { super::guard::Neutral::NEUTRAL })
    })
}

/// Arrange the static shapes of a world anew, after many were made. Changes no answer, only how fast it comes.
/// @param worldId the world
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_RebuildStaticTree(world_id: mvWorldId) {
    write_world(world_id, |e| {
        e.world.broad_phase.rebuild_static();
        Ok(())
    });
}

/// Set the user data of a world.
/// @param worldId the world
/// @param userData anything; it is never followed
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_SetUserData(world_id: mvWorldId, user_data: *mut c_void) {
    write_world(world_id, |e| {
        e.world.set_user_data(to_word(user_data));
        Ok(())
    });
}

/// Get the user data of a world.
/// @param worldId the world
/// @return what was set; null for a bad world
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_GetUserData(world_id: mvWorldId) -> *mut c_void {
    read_world(world_id, |v| Ok(from_word(v.world.def().user_data)))
}

/// Set the callback that decides whether shapes may collide.
/// @param worldId the world
/// @param fcn the callback, null for none
/// @param context passed to the callback
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_SetCustomFilterCallback(
    world_id: mvWorldId,
    fcn: mvCustomFilterFcn,
    context: *mut c_void,
) {
    write_world(world_id, |e| {
        e.world.set_custom_filter(super::callback::custom_filter(fcn, context));
        Ok(())
    });
}

/// Set the callback that decides whether contacts act.
/// @param worldId the world
/// @param fcn the callback, null for none
/// @param context passed to the callback
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_SetPreSolveCallback(world_id: mvWorldId, fcn: mvPreSolveFcn, context: *mut c_void) {
    write_world(world_id, |e| {
        e.world.set_pre_solve(super::callback::pre_solve(fcn, context));
        Ok(())
    });
}

/// Set the callback that mixes friction.
/// @param worldId the world
/// @param callback the callback, null for the geometric mean
/// @param context passed to the callback
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_SetFrictionCallback(
    world_id: mvWorldId,
    callback: mvFrictionCallback,
    context: *mut c_void,
) {
    write_world(world_id, |e| {
        e.world.set_friction_mixing(super::callback::friction(callback, context));
        Ok(())
    });
}

/// Set the callback that mixes restitution.
/// @param worldId the world
/// @param callback the callback, null for the greater one
/// @param context passed to the callback
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_SetRestitutionCallback(
    world_id: mvWorldId,
    callback: mvRestitutionCallback,
    context: *mut c_void,
) {
    write_world(world_id, |e| {
        e.world.set_restitution_mixing(super::callback::restitution(callback, context));
        Ok(())
    });
}
