//! What exported functions call: guard → look up a world and take its lock → look up a body or shape → one call.

use super::guard::{Neutral, call, caught};
use super::id::{mvBodyId, mvContactId, mvJointId, mvShapeId, mvWorldId};
use super::registry::{Edit, Target, View, read, write};
use crate::error::Result;
use crate::world::{BodyMut, BodyRef, ColliderMut, ColliderRef, JointMut, JointRef};

pub(super) fn read_world<R: Neutral>(id: mvWorldId, f: impl FnOnce(View<'_>) -> Result<R>) -> R {
    call(|| read(Target::world(id)?, f))
}

pub(super) fn write_world<R: Neutral>(id: mvWorldId, f: impl FnOnce(Edit<'_>) -> Result<R>) -> R {
    call(|| write(Target::world(id)?, f))
}

pub(super) fn read_body<R: Neutral>(id: mvBodyId, f: impl FnOnce(BodyRef<'_>) -> Result<R>) -> R {
    call(|| read(Target::of(id.index1, id.world0, "body")?, |v| f(v.world.body(id.into())?)))
}

pub(super) fn view_body<R: Neutral>(id: mvBodyId, f: impl FnOnce(View<'_>, BodyRef<'_>) -> Result<R>) -> R {
    call(|| read(Target::of(id.index1, id.world0, "body")?, |v| f(v, v.world.body(id.into())?)))
}

pub(super) fn write_body<R: Neutral>(id: mvBodyId, f: impl FnOnce(BodyMut<'_>) -> Result<R>) -> R {
    call(|| write(Target::of(id.index1, id.world0, "body")?, |e| f(e.world.body_mut(id.into())?)))
}

pub(super) fn edit_at_body<R: Neutral>(id: mvBodyId, f: impl FnOnce(Edit<'_>) -> Result<R>) -> R {
    call(|| write(Target::of(id.index1, id.world0, "body")?, f))
}

pub(super) fn read_shape<R: Neutral>(id: mvShapeId, f: impl FnOnce(ColliderRef<'_>) -> Result<R>) -> R {
    call(|| read(Target::of(id.index1, id.world0, "shape")?, |v| f(v.world.shape(id.into())?)))
}

pub(super) fn view_shape<R: Neutral>(
    id: mvShapeId,
    f: impl FnOnce(View<'_>, ColliderRef<'_>) -> Result<R>,
) -> R {
    call(|| read(Target::of(id.index1, id.world0, "shape")?, |v| f(v, v.world.shape(id.into())?)))
}

pub(super) fn write_shape<R: Neutral>(id: mvShapeId, f: impl FnOnce(ColliderMut<'_>) -> Result<R>) -> R {
    call(|| write(Target::of(id.index1, id.world0, "shape")?, |e| f(e.world.shape_mut(id.into())?)))
}

pub(super) fn edit_at_shape<R: Neutral>(id: mvShapeId, f: impl FnOnce(Edit<'_>) -> Result<R>) -> R {
    call(|| write(Target::of(id.index1, id.world0, "shape")?, f))
}

pub(super) fn read_joint<R: Neutral>(id: mvJointId, f: impl FnOnce(JointRef<'_>) -> Result<R>) -> R {
    call(|| read(Target::of(id.index1, id.world0, "joint")?, |v| f(v.world.joint(id.into())?)))
}

pub(super) fn write_joint<R: Neutral>(id: mvJointId, f: impl FnOnce(JointMut<'_>) -> Result<R>) -> R {
    call(|| write(Target::of(id.index1, id.world0, "joint")?, |e| f(e.world.joint_mut(id.into())?)))
}

pub(super) fn edit_at_joint<R: Neutral>(id: mvJointId, f: impl FnOnce(Edit<'_>) -> Result<R>) -> R {
    call(|| write(Target::of(id.index1, id.world0, "joint")?, f))
}

/// Whether the body lives; false also when nobody may look now.
pub(super) fn is_body(id: mvBodyId) -> bool {
    caught(|| look_up_body(id)).is_ok()
}

/// Whether the shape lives; false also when nobody may look now.
pub(super) fn is_shape(id: mvShapeId) -> bool {
    caught(|| look_up_shape(id)).is_ok()
}

/// Whether the joint lives; false also when nobody may look now.
pub(super) fn is_joint(id: mvJointId) -> bool {
    let look_up =
        || read(Target::of(id.index1, id.world0, "joint")?, |v| v.world.joint(id.into()).map(|_| ()));
    caught(look_up).is_ok()
}

/// Whether the contact's world can be read now and says so.
pub(super) fn is_contact(id: mvContactId, f: impl FnOnce(View<'_>) -> bool) -> bool {
    caught(|| read(Target::of(id.index1, id.world0, "contact")?, |v| Ok(f(v)))).unwrap_or(false)
}

// The same in pieces, for calls that have work to do between looking up and writing.

pub(super) fn look_up_body(id: mvBodyId) -> Result<()> {
    read(Target::of(id.index1, id.world0, "body")?, |v| v.world.body(id.into()).map(|_| ()))
}

pub(super) fn look_up_shape(id: mvShapeId) -> Result<()> {
    read(Target::of(id.index1, id.world0, "shape")?, |v| v.world.shape(id.into()).map(|_| ()))
}

pub(super) fn edit_at<R>(id: mvBodyId, f: impl FnOnce(Edit<'_>) -> Result<R>) -> Result<R> {
    write(Target::of(id.index1, id.world0, "body")?, f)
}

pub(super) fn edit_shape<R>(id: mvShapeId, f: impl FnOnce(Edit<'_>) -> Result<R>) -> Result<R> {
    write(Target::of(id.index1, id.world0, "shape")?, f)
}
