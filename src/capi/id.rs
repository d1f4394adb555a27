//! Ids as C sees them. Packing them into integers is inline C.

use super::guard::neutral;
use crate::world::{BodyId, ContactId, JointId, ShapeId};

/// A world. Zero is null.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(C)]
pub struct mvWorldId {
    /// The place among the worlds, counted from 1; 0 is null.
    pub index1: u16,
    /// How often that place has been used.
    pub generation: u16,
}

/// A body. Zero is null.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(C)]
pub struct mvBodyId {
    /// The place among the bodies of its world, counted from 1; 0 is null.
    pub index1: i32,
    /// The place of its world among the worlds, counted from 0.
    pub world0: u16,
    /// How often that place has been used.
    pub generation: u16,
}

/// A shape attached to a body. Zero is null.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(C)]
pub struct mvShapeId {
    /// The place among the shapes of its world, counted from 1; 0 is null.
    pub index1: i32,
    /// The place of its world among the worlds, counted from 0.
    pub world0: u16,
    /// How often that place has been used.
    pub generation: u16,
}

/// A joint between bodies. Zero is null.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(C)]
pub struct mvJointId {
    /// The place among the joints of its world, counted from 1; 0 is null.
    pub index1: i32,
    /// The place of its world among the worlds, counted from 0.
    pub world0: u16,
    /// How often that place has been used.
    pub generation: u16,
}

/// A contact of two shapes: from the step in which their boxes meet to the one in which they part. Zero is null.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(C)]
pub struct mvContactId {
    /// The place among the contacts of its world, counted from 1; 0 is null.
    pub index1: i32,
    /// The place of its world among the worlds, counted from 0.
    pub world0: u16,
    /// Zero.
    pub padding: i16,
    /// How often that place has been used.
    pub generation: u32,
}

neutral! {
    mvWorldId = mvWorldId { index1: 0, generation: 0 };
    mvBodyId = mvBodyId { index1: 0, world0: 0, generation: 0 };
    mvShapeId = mvShapeId { index1: 0, world0: 0, generation: 0 };
    mvJointId = mvJointId { index1: 0, world0: 0, generation: 0 };
    mvContactId = mvContactId { index1: 0, world0: 0, padding: 0, generation: 0 };
}

impl From<mvBodyId> for BodyId {
    fn from(id: mvBodyId) -> Self {
        Self { index1: id.index1 as u32, world: id.world0, generation: id.generation }
    }
}

impl From<BodyId> for mvBodyId {
    fn from(id: BodyId) -> Self {
        Self { index1: id.index1 as i32, world0: id.world, generation: id.generation }
    }
}

impl From<mvShapeId> for ShapeId {
    fn from(id: mvShapeId) -> Self {
        Self { index1: id.index1 as u32, world: id.world0, generation: id.generation }
    }
}

impl From<ShapeId> for mvShapeId {
    fn from(id: ShapeId) -> Self {
        Self { index1: id.index1 as i32, world0: id.world, generation: id.generation }
    }
}

impl From<mvJointId> for JointId {
    fn from(id: mvJointId) -> Self {
        Self { index1: id.index1 as u32, world: id.world0, generation: id.generation }
    }
}

impl From<JointId> for mvJointId {
    fn from(id: JointId) -> Self {
        Self { index1: id.index1 as i32, world0: id.world, generation: id.generation }
    }
}

impl From<mvContactId> for ContactId {
    fn from(id: mvContactId) -> Self {
        Self { index1: id.index1 as u32, world: id.world0, generation: id.generation }
    }
}

impl From<ContactId> for mvContactId {
    fn from(id: ContactId) -> Self {
        Self { index1: id.index1 as i32, world0: id.world, padding: 0, generation: id.generation }
    }
}
