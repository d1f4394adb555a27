//! Bodies, shapes and contacts as a user sees them.

mod body_mut;
mod body_ref;
mod joint;
mod shape;

pub use joint::{JointMut, JointRef};

use super::{BodyDef, BodyId, BodyType, ContactId, ShapeId, World};
use crate::body::SetId;
use crate::constraint::contact::flags;
use crate::error::Result;
use crate::math::{Float, Pose, Vec3};
use crate::shape::Shape;

/// A body, to be read.
#[derive(Clone, Copy, Debug)]
pub struct BodyRef<'w> {
    pub(crate) world: &'w World,
    pub(crate) index: usize,
}

/// A body, to be changed. Setters check what they are given and change nothing when they refuse it.
#[derive(Debug)]
pub struct BodyMut<'w> {
    pub(crate) world: &'w mut World,
    pub(crate) index: usize,
}

/// An attached shape, to be read.
#[derive(Clone, Copy, Debug)]
pub struct ColliderRef<'w> {
    pub(crate) world: &'w World,
    pub(crate) index: usize,
}

/// An attached shape, to be changed.
#[derive(Debug)]
pub struct ColliderMut<'w> {
    pub(crate) world: &'w mut World,
    pub(crate) index: usize,
}

/// A touching contact, as of the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactData {
    /// The contact.
    pub contact: ContactId,
    /// The shape with the lower slot.
    pub shape_a: ShapeId,
    /// The other.
    pub shape_b: ShapeId,
    /// Unit normal from A to B.
    pub normal: Vec3,
    /// Number of points.
    pub count: usize,
    /// The points, the first `count` of them.
    pub points: [ContactDataPoint; 4],
    /// Sum of the friction impulses on B over the last step \[N s\].
    pub friction_impulse: Vec3,
}

/// A point of a [`ContactData`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactDataPoint {
    /// Where, in the world, at the start of the last step \[m\].
    pub point: Vec3,
    /// From the centre of mass of A \[m\].
    pub anchor_a: Vec3,
    /// From the centre of mass of B \[m\].
    pub anchor_b: Vec3,
    /// Gap at the start of the last step \[m\].
    pub separation: Float,
    /// Normal impulse of the last sub-step \[N s\].
    pub normal_impulse: Float,
    /// Sum of the normal impulses over the last step \[N s\].
    pub total_normal_impulse: Float,
    /// Normal velocity at the start of the last step, negative when approaching \[m/s\].
    pub normal_velocity: Float,
    /// Which features of the shapes meet here.
    pub feature: u32,
}

impl World {
    /// Takes a body out of the world, keeping its state.
    pub(crate) fn disable_body(&mut self, index: usize) {
        if self.bodies.bodies[index].set == SetId::DISABLED {
            return;
        }
        self.wake_touching(index);
        for k in 0..self.bodies.bodies[index].shapes.len() {
            let shape = self.bodies.bodies[index].shapes[k] as usize;
            self.leave_broad_phase(shape);
        }
        for k in 0..self.bodies.bodies[index].joints.len() {
            let joint = self.bodies.bodies[index].joints[k] as usize;
            self.deactivate_joint(joint);
        }
        self.islands.leave(index as u32, &mut self.bodies.bodies);
        self.bodies.transfer(index, SetId::DISABLED);
        let (set, row) = self.bodies.at_mut(index);
        (set.drive[row].force, set.drive[row].torque) = (Vec3::zeros(), Vec3::zeros());
    }

    /// Puts a body back into the world, awake.
    pub(crate) fn enable_body(&mut self, index: usize) {
        if self.bodies.bodies[index].set != SetId::DISABLED {
            return;
        }
        let body_type = self.bodies.bodies[index].body_type;
        let set = if body_type == BodyType::Static { SetId::STATIC } else { SetId::AWAKE };
        self.bodies.transfer(index, set);
        self.bodies.bodies[index].quarantined = false;
        if body_type == BodyType::Dynamic {
            self.islands.open(index as u32, &mut self.bodies.bodies);
        }
        let (rows, row) = self.bodies.at_mut(index);
        rows.slow_time[row] = 0.0;
        let origin = rows.origin(row);
        for k in 0..self.bodies.bodies[index].shapes.len() {
            let shape = self.bodies.bodies[index].shapes[k] as usize;
            self.colliders[shape].fat = self.first_box(&self.colliders[shape], &origin, index);
            self.enter_broad_phase(shape);
        }
        for k in 0..self.bodies.bodies[index].joints.len() {
            let joint = self.bodies.bodies[index].joints[k] as usize;
            self.activate_joint(joint);
        }
    }

    /// The data of a contact, where it touches.
    pub(crate) fn contact_data(&self, index: usize) -> Option<ContactData> {
        let contact = &self.contacts.contacts[index];
        if !contact.is(flags::TOUCHING) {
            return None;
        }
        let x = |side: usize| {
            let (set, row) = self.bodies.at(contact.body[side] as usize);
            set.motion[row].x
        };
        let (xa, xb) = (x(0), x(1));
        let mut points = [ContactDataPoint::default(); 4];
        for (out, p) in points.iter_mut().zip(contact.points()) {
            *out = ContactDataPoint {
                point: xa + p.anchor,
                anchor_a: p.anchor,
                anchor_b: p.anchor + (xa - xb),
                separation: p.separation,
                normal_impulse: p.impulse,
                total_normal_impulse: p.total,
                normal_velocity: p.approach,
                feature: p.feature,
            };
        }
        Some(ContactData {
            contact: self.contact_id(index),
            shape_a: self.shape_id(contact.shape[0] as usize),
            shape_b: self.shape_id(contact.shape[1] as usize),
            normal: contact.normal,
            count: contact.count as usize,
            points,
            friction_impulse: contact.total_friction,
        })
    }

    /// A body with one shape, in one call.
    ///
    /// # Errors
    /// As of [`create_body`](Self::create_body) and [`create_shape`](Self::create_shape); nothing is left behind.
    pub fn create_body_with_shape(
        &mut self,
        body: &BodyDef,
        def: &super::ShapeDef,
        shape: Shape,
    ) -> Result<(BodyId, ShapeId)> {
        let id = self.create_body(body)?;
        match self.create_shape(id, def, shape, Pose::IDENTITY) {
            Ok(shape) => Ok((id, shape)),
            Err(e) => {
                self.destroy_body(id)?;
                Err(e)
            }
        }
    }
}
