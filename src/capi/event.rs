//! Events of the last step.

use super::access::read_world;
use super::guard::{c_count, neutral};
use super::id::{mvBodyId, mvContactId, mvJointId, mvShapeId, mvWorldId};
use super::math::{mvPos, mvVec3, mvWorldTransform};
use super::mvFloat;
use crate::world::World;
use core::ffi::{c_int, c_void};

/// A body moved in the last step, or fell asleep.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvBodyMoveEvent {
    /// The body's user data.
    pub user_data: *mut c_void,
    /// Where the body is now.
    pub transform: mvWorldTransform,
    /// The body.
    pub body_id: mvBodyId,
    /// Whether the body fell asleep in the last step.
    pub fell_asleep: bool,
}

/// The bodies that a step moved.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvBodyEvents {
    /// The events, in order of the bodies' places. Valid until the next step.
    pub move_events: *mut mvBodyMoveEvent,
    /// Their number.
    pub move_count: c_int,
}

/// Two shapes began to touch.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvContactBeginTouchEvent {
    /// The first shape.
    pub shape_id_a: mvShapeId,
    /// The second shape.
    pub shape_id_b: mvShapeId,
    /// The contact.
    pub contact_id: mvContactId,
}

/// Two shapes ceased to touch, or one of them was destroyed; then its id is stale.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvContactEndTouchEvent {
    /// The first shape.
    pub shape_id_a: mvShapeId,
    /// The second shape.
    pub shape_id_b: mvShapeId,
    /// The contact.
    pub contact_id: mvContactId,
}

/// Two shapes hit each other faster than the world's threshold.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvContactHitEvent {
    /// The first shape.
    pub shape_id_a: mvShapeId,
    /// The second shape.
    pub shape_id_b: mvShapeId,
    /// The contact.
    pub contact_id: mvContactId,
    /// Where they hit [m].
    pub point: mvPos,
    /// The normal from shape A to shape B, of length 1.
    pub normal: mvVec3,
    /// How fast they approached [m/s], positive.
    pub approach_speed: mvFloat,
    /// The user material of shape A.
    pub user_material_id_a: u64,
    /// The user material of shape B.
    pub user_material_id_b: u64,
}

/// What happened to contacts in the last step.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvContactEvents {
    /// Contacts that began. Valid until the next step.
    pub begin_events: *mut mvContactBeginTouchEvent,
    /// Contacts that ended, by destruction before the step included. Valid until the next step.
    pub end_events: *mut mvContactEndTouchEvent,
    /// Hits. Valid until the next step.
    pub hit_events: *mut mvContactHitEvent,
    /// The number of contacts that began.
    pub begin_count: c_int,
    /// The number of contacts that ended.
    pub end_count: c_int,
    /// The number of hits.
    pub hit_count: c_int,
}

/// A joint carried more than one of its thresholds in the last step.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvJointEvent {
    /// The joint; stale where it broke.
    pub joint_id: mvJointId,
    /// The joint's user data.
    pub user_data: *mut c_void,
    /// The size of its force on body B, mean over the step [N].
    pub force: mvFloat,
    /// The size of its torque on body B, mean over the step [N m].
    pub torque: mvFloat,
    /// Whether it broke.
    pub broke: bool,
}

/// The joints that carried too much in a step.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvJointEvents {
    /// The events, in order of the joints' places. Valid until the next step.
    pub joint_events: *mut mvJointEvent,
    /// Their number.
    pub count: c_int,
}

neutral! {
    mvJointEvents = mvJointEvents { joint_events: std::ptr::null_mut(), count: 0 };
    mvBodyEvents = mvBodyEvents { move_events: std::ptr::null_mut(), move_count: 0 };
    mvContactEvents = mvContactEvents {
        begin_events: std::ptr::null_mut(),
        end_events: std::ptr::null_mut(),
        hit_events: std::ptr::null_mut(),
        begin_count: 0,
        end_count: 0,
        hit_count: 0,
    };
}

/// The events of a world in C's form: made once a step, when they are first asked for.
#[derive(Default)]
pub(super) struct EventArrays {
    fresh: bool,
    moved: Vec<mvBodyMoveEvent>,
    begin: Vec<mvContactBeginTouchEvent>,
    end: Vec<mvContactEndTouchEvent>,
    hit: Vec<mvContactHitEvent>,
    joint: Vec<mvJointEvent>,
}

impl EventArrays {
    pub(super) fn stale(&mut self) {
        self.fresh = false;
    }

    pub(super) fn fill(&mut self, world: &World) {
        if self.fresh {
            return;
        }
        self.fresh = true;
        self.moved.clear();
        self.moved.extend(world.body_events().iter().map(|e| mvBodyMoveEvent {
            user_data: super::def_check::from_word(e.user_data),
            transform: e.transform.into(),
            body_id: e.body.into(),
            fell_asleep: e.fell_asleep,
        }));
        self.joint.clear();
        self.joint.extend(world.joint_events().iter().map(|e| mvJointEvent {
            joint_id: e.joint.into(),
            user_data: super::def_check::from_word(e.user_data),
            force: e.force,
            torque: e.torque,
            broke: e.broke,
        }));
        self.begin.clear();
        self.begin.extend(world.contact_begin_events().iter().map(|e| mvContactBeginTouchEvent {
            shape_id_a: e.shape_a.into(),
            shape_id_b: e.shape_b.into(),
            contact_id: e.contact.into(),
        }));
        self.end.clear();
        self.end.extend(world.contact_end_events().iter().map(|e| mvContactEndTouchEvent {
            shape_id_a: e.shape_a.into(),
            shape_id_b: e.shape_b.into(),
            contact_id: e.contact.into(),
        }));
        self.hit.clear();
        self.hit.extend(world.contact_hit_events().iter().map(|e| mvContactHitEvent {
            shape_id_a: e.shape_a.into(),
            shape_id_b: e.shape_b.into(),
            contact_id: e.contact.into(),
            point: e.point.into(),
            normal: e.normal.into(),
            approach_speed: e.approach_speed,
            user_material_id_a: e.materials[0],
            user_material_id_b: e.materials[1],
        }));
    }
}

/// Get the bodies that the last step moved or put to sleep.
///
/// @return the events; none for a bad world. Their array stays valid until the next step, whatever else happens
/// to the bodies, or until the world is destroyed.
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_GetBodyEvents(world_id: mvWorldId) -> mvBodyEvents {
    read_world(world_id, |view| {
        Ok(view.side.events(view.world, |e| mvBodyEvents {
            move_events: e.moved.as_mut_ptr(),
            move_count: c_count(e.moved.len()),
        }))
    })
}

/// Get the contacts that began and ended in the last step, and the hits.
///
/// @return the events; none for a bad world. Their arrays stay valid until the next step, whatever else happens
/// to the shapes, or until the world is destroyed.
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_GetContactEvents(world_id: mvWorldId) -> mvContactEvents {
    read_world(world_id, |view| {
        Ok(view.side.events(view.world, |e| mvContactEvents {
            begin_events: e.begin.as_mut_ptr(),
            end_events: e.end.as_mut_ptr(),
            hit_events: e.hit.as_mut_ptr(),
            begin_count: c_count(e.begin.len()),
            end_count: c_count(e.end.len()),
            hit_count: c_count(e.hit.len()),
        }))
    })
}

/// Get the joints that carried more than one of their thresholds in the last step.
///
/// @return the events; none for a bad world. Their array stays valid until the next step, whatever else happens
/// to the joints, or until the world is destroyed.
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_GetJointEvents(world_id: mvWorldId) -> mvJointEvents {
    read_world(world_id, |view| {
        Ok(view.side.events(view.world, |e| mvJointEvents {
            joint_events: e.joint.as_mut_ptr(),
            count: c_count(e.joint.len()),
        }))
    })
}
