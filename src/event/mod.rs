//! Events: what happened in the last step. Lists are sorted, and valid until the next step.

use crate::math::{Float, Pose, Vec3};
use crate::world::{BodyId, ContactId, JointId, ShapeId};

/// A body moved, or fell asleep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyMoveEvent {
    /// The body.
    pub body: BodyId,
    /// Its origin after the step.
    pub transform: Pose,
    /// The body's user data.
    pub user_data: u64,
    /// Whether it fell asleep in this step.
    pub fell_asleep: bool,
}

/// Two shapes began to touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactBeginEvent {
    /// The shape with the lower slot.
    pub shape_a: ShapeId,
    /// The other.
    pub shape_b: ShapeId,
    /// The contact.
    pub contact: ContactId,
}

/// Two shapes ceased to touch, or one of them was destroyed (its id is then stale).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactEndEvent {
    /// The shape with the lower slot.
    pub shape_a: ShapeId,
    /// The other.
    pub shape_b: ShapeId,
    /// The contact.
    pub contact: ContactId,
}

/// Two shapes hit each other faster than the world's threshold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactHitEvent {
    /// The shape with the lower slot.
    pub shape_a: ShapeId,
    /// The other.
    pub shape_b: ShapeId,
    /// The contact.
    pub contact: ContactId,
    /// Where \[m\].
    pub point: Vec3,
    /// Unit normal from A to B.
    pub normal: Vec3,
    /// How fast they approached \[m/s\].
    pub approach_speed: Float,
    /// User material ids of A and B.
    pub materials: [u64; 2],
}

/// A joint carried more than its threshold in the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointEvent {
    /// The joint; stale where it broke.
    pub joint: JointId,
    /// Mean force over the step \[N\].
    pub force: Float,
    /// Mean torque over the step \[N m\].
    pub torque: Float,
    /// Whether it broke.
    pub broke: bool,
    /// The joint's user data.
    pub user_data: u64,
}

/// The lists of one step. Written by `publish_events`; ends of destroyed shapes are added when that happens.
#[derive(Clone, Debug, Default)]
pub struct Events {
    /// In order of bodies.
    pub moved: Vec<BodyMoveEvent>,
    /// In order of contacts.
    pub begin: Vec<ContactBeginEvent>,
    /// In order of contacts; those of destroyed shapes first.
    pub end: Vec<ContactEndEvent>,
    /// In order of contacts.
    pub hit: Vec<ContactHitEvent>,
    /// In order of joints.
    pub joint: Vec<JointEvent>,
    /// Ends since the last step.
    pub pending_end: Vec<ContactEndEvent>,
    /// How many of `end` were pending when the step began.
    pub announced: usize,
}

impl Events {
    /// Forgets the last step's events.
    pub fn begin_step(&mut self) {
        self.moved.clear();
        self.begin.clear();
        self.hit.clear();
        self.joint.clear();
        self.end.clear();
        self.end.append(&mut self.pending_end);
        self.announced = self.end.len();
    }

    /// Bytes held.
    #[must_use]
    pub fn byte_count(&self) -> usize {
        self.moved.capacity() * size_of::<BodyMoveEvent>()
            + self.begin.capacity() * size_of::<ContactBeginEvent>()
            + (self.end.capacity() + self.pending_end.capacity()) * size_of::<ContactEndEvent>()
            + self.hit.capacity() * size_of::<ContactHitEvent>()
            + self.joint.capacity() * size_of::<JointEvent>()
    }
}
