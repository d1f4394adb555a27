//! Bodies: making, destroying, naming, switching.

use super::access::{edit_at_body, read_body, view_body, write_body, write_world};
use super::contact::mvContactData;
use super::def::*;
use super::def_check::{body_type, flag, from_word, to_word};
use super::error::text;
use super::guard::{c_count, fill, needed, room};
use super::id::{mvBodyId, mvJointId, mvShapeId, mvWorldId};
use super::math::mvAABB;
use super::registry;
use super::side::Named;
use super::{Flag, mvFloat};
use core::ffi::{c_char, c_int, c_void};

/// Create a body. It has no mass before it has a shape with a density, or mass data of its own.
///
/// @param worldId the world
/// @param def the definition, from mvDefaultBodyDef()
/// @return the body; null for bad arguments
/// @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvCreateBody(world_id: mvWorldId, def: Option<&mvBodyDef>) -> mvBodyId {
    write_world(world_id, |e| {
        // Sound: the caller's name is null or a string.
        let def = unsafe { needed("The definition", def)?.checked() }?;
        e.world.create_body(&def).map(Into::into)
    })
}

/// Destroy a body with its shapes. What it touched wakes up.
/// @param bodyId the body
#[unsafe(no_mangle)]
pub extern "C" fn mvDestroyBody(body_id: mvBodyId) {
    edit_at_body(body_id, |e| e.world.destroy_body(body_id.into()));
}

/// Does this id name a body that lives? Never fails; false also while another thread changes the world.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_IsValid(id: mvBodyId) -> bool {
    super::access::is_body(id)
}

/// Get the world that a body lives in.
/// @param bodyId the body
/// @return the world; null for a bad body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetWorld(body_id: mvBodyId) -> mvWorldId {
    read_body(body_id, |_| Ok(registry::world_id(body_id.world0)))
}

/// Get how a body moves.
/// @param bodyId the body
/// @return mv_staticBody, mv_kinematicBody or mv_dynamicBody; mv_staticBody for a bad body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetType(body_id: mvBodyId) -> mvBodyType {
    read_body(body_id, |b| Ok(b.body_type() as i32))
}

/// Change how a body moves. Its mass becomes that of its shapes again; a static body stands still.
/// @param bodyId the body
/// @param type mv_staticBody, mv_kinematicBody or mv_dynamicBody
/// @note Errors: mv_errorRange, also when a plane would move.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_SetType(body_id: mvBodyId, r#type: mvBodyType) {
    write_body(body_id, |mut b| b.set_type(body_type(r#type)?));
}

/// Set the name of a body.
/// @param bodyId the body
/// @param name UTF-8, copied; null for none
/// @note Errors: mv_errorRange when the name is not UTF-8.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvBody_SetName(body_id: mvBodyId, name: *const c_char) {
    write_body(body_id, |mut b| {
        // Sound: the caller's name is null or a string.
        b.set_name(unsafe { text("The body's name", name) }?);
        Ok(())
    });
}

/// Get the name of a body.
/// @param bodyId the body
/// @return UTF-8, empty for none; null for a bad body. Valid until the name is changed or the body destroyed.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetName(body_id: mvBodyId) -> *const c_char {
    view_body(body_id, |v, b| Ok(v.side.name(Named::Body(b.id().index1), b.name())))
}

/// Set the user data of a body.
/// @param bodyId the body
/// @param userData anything; it is never followed
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_SetUserData(body_id: mvBodyId, user_data: *mut c_void) {
    write_body(body_id, |mut b| {
        b.set_user_data(to_word(user_data));
        Ok(())
    });
}

/// Get the user data of a body.
/// @param bodyId the body
/// @return what was set; null for a bad body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetUserData(body_id: mvBodyId) -> *mut c_void {
    read_body(body_id, |b| Ok(from_word(b.user_data())))
}

/// Does the next step move this body?
/// @param bodyId the body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_IsAwake(body_id: mvBodyId) -> bool {
    read_body(body_id, |b| Ok(b.is_awake()))
}

/// Wake a body and what it touches, or put them to sleep, whatever their speed. Only dynamic bodies sleep.
/// @param bodyId the body
/// @param awake whether to wake or to put to sleep
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_SetAwake(body_id: mvBodyId, awake: Flag) {
    write_body(body_id, |mut b| {
        b.set_awake(flag("awake", awake)?);
        Ok(())
    });
}

/// Let a body fall asleep, or wake it and keep it awake.
/// @param bodyId the body
/// @param enableSleep whether the body may sleep
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_EnableSleep(body_id: mvBodyId, enable_sleep: Flag) {
    write_body(body_id, |mut b| {
        b.enable_sleep(flag("enableSleep", enable_sleep)?);
        Ok(())
    });
}

/// May this body fall asleep?
/// @param bodyId the body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_IsSleepEnabled(body_id: mvBodyId) -> bool {
    read_body(body_id, |b| Ok(b.is_sleep_enabled()))
}

/// Set the speed below which a body may fall asleep.
/// @param bodyId the body
/// @param sleepThreshold the speed [m/s], >= 0
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_SetSleepThreshold(body_id: mvBodyId, sleep_threshold: mvFloat) {
    write_body(body_id, |mut b| b.set_sleep_threshold(sleep_threshold));
}

/// Get the speed below which a body may fall asleep.
/// @param bodyId the body
/// @return the speed [m/s]; 0 for a bad body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetSleepThreshold(body_id: mvBodyId) -> mvFloat {
    read_body(body_id, |b| Ok(b.sleep_threshold()))
}

/// Get the sub-steps that the next step takes for a body: those of the last step, or more where the world has an accuracy
/// to keep, see mvWorldDef.accuracy.
/// @param bodyId the body
/// @return a count; 0 before the first step and for a bad body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetSubStepCount(body_id: mvBodyId) -> c_int {
    read_body(body_id, |b| Ok(c_count(b.sub_steps() as usize)))
}

/// Does this body take part in the world?
/// @param bodyId the body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_IsEnabled(body_id: mvBodyId) -> bool {
    read_body(body_id, |b| Ok(b.is_enabled()))
}

/// Take a body out of the world, keeping its state. What it touched wakes up.
/// @param bodyId the body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_Disable(body_id: mvBodyId) {
    write_body(body_id, |mut b| {
        b.disable();
        Ok(())
    });
}

/// Put a body back into the world, awake.
/// @param bodyId the body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_Enable(body_id: mvBodyId) {
    write_body(body_id, |mut b| {
        b.enable();
        Ok(())
    });
}

/// Set the directions in which a body cannot move; its velocity along them becomes 0. Only dynamic bodies have
/// locks.
/// @param bodyId the body
/// @param locks the directions
/// @note Errors: mv_errorRange for a lock that is neither true nor false.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_SetMotionLocks(body_id: mvBodyId, locks: mvMotionLocks) {
    write_body(body_id, |mut b| {
        b.set_motion_locks(locks.checked()?);
        Ok(())
    });
}

/// Get the directions in which a body cannot move.
/// @param bodyId the body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetMotionLocks(body_id: mvBodyId) -> mvMotionLocks {
    read_body(body_id, |b| Ok(b.motion_locks().into()))
}

/// Make hit events for contacts of all shapes that a body has now, or not.
/// @param bodyId the body
/// @param flag whether to make them
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_EnableHitEvents(body_id: mvBodyId, flag: Flag) {
    edit_at_body(body_id, |e| {
        let on = super::def_check::flag("flag", flag)?;
        let shapes: Vec<_> = e.world.body(body_id.into())?.shapes().collect();
        for shape in shapes {
            e.world.shape_mut(shape)?.enable_hit_events(on);
        }
        Ok(())
    });
}

/// Get the number of shapes of a body.
/// @param bodyId the body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetShapeCount(body_id: mvBodyId) -> c_int {
    read_body(body_id, |b| Ok(c_count(b.shapes().len())))
}

/// Get the shapes of a body, in the order in which they were made.
/// @param bodyId the body
/// @param shapeArray filled with the shapes; may be null
/// @param capacity the room in the array, >= 0
/// @return how many were written
/// @note Errors: mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvBody_GetShapes(
    body_id: mvBodyId,
    shape_array: *mut mvShapeId,
    capacity: c_int,
) -> c_int {
    read_body(body_id, |b| {
        // Sound: the caller passes that much room.
        let room = unsafe { room("shapes", shape_array, capacity) }?;
        let n = c_count(room.len());
        Ok(fill(room, b.shapes().map(Into::into)).min(n))
    })
}

/// Get the number of joints of a body. Gears count at all bodies of their two joints.
/// @param bodyId the body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetJointCount(body_id: mvBodyId) -> c_int {
    read_body(body_id, |b| Ok(c_count(b.joints().len())))
}

/// Get the joints of a body, in no particular order.
/// @param bodyId the body
/// @param jointArray filled with the joints; may be null
/// @param capacity the room in the array, >= 0
/// @return how many were written
/// @note Errors: mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvBody_GetJoints(
    body_id: mvBodyId,
    joint_array: *mut mvJointId,
    capacity: c_int,
) -> c_int {
    read_body(body_id, |b| {
        // Sound: the caller passes that much room.
        let room = unsafe { room("joints", joint_array, capacity) }?;
        let n = c_count(room.len());
        Ok(fill(room, b.joints().map(Into::into)).min(n))
    })
}

/// Get the box around all shapes of a body; around its origin when it has none.
/// @param bodyId the body
/// @return the box; zero for a bad body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_ComputeAABB(body_id: mvBodyId) -> mvAABB {
    read_body(body_id, |b| Ok(b.aabb().into()))
}

/// Get an upper bound for the number of a body's touching contacts.
/// @param bodyId the body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetContactCapacity(body_id: mvBodyId) -> c_int {
    read_body(body_id, |b| Ok(c_count(b.contact_capacity())))
}

/// Get the touching contacts of a body, as of the last step.
/// @param bodyId the body
/// @param contactData filled with the contacts; may be null
/// @param capacity the room in the array, >= 0
/// @return how many were written
/// @note Errors: mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvBody_GetContactData(
    body_id: mvBodyId,
    contact_data: *mut mvContactData,
    capacity: c_int,
) -> c_int {
    view_body(body_id, |v, b| {
        // Sound: the caller passes that much room.
        let room = unsafe { room("contacts", contact_data, capacity) }?;
        let n = room.len();
        Ok(fill(room, b.contacts().iter().take(n).map(|c| super::contact::contact_data(v.side, c))))
    })
}
