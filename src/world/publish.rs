//! Stage 10 of a step: events.

use super::collide::CONTACTS_AHEAD;
use super::{BodyMoveEvent, BodyType, ContactBeginEvent, ContactEndEvent, ContactHitEvent, World};
use crate::constraint::contact::flags;
use crate::constraint::{Contact, ContactPoint};
use crate::math::tolerance::TOUCH_MARGIN;
use crate::math::{Float, Vec3};

impl World {
    /// Stage 10: who moved, what began to touch, ceased to, or hit.
    pub(super) fn publish_events(&mut self, dt: Float) {
        self.publish_touches();
        let stepped = dt > 0.0;
        if stepped {
            for row in 0..self.bodies.awake().len() {
                let index = self.bodies.awake().index[row] as usize;
                self.publish_move(index, false);
            }
            for k in 0..self.scratch.fell_asleep.len() {
                let index = self.scratch.fell_asleep[k] as usize;
                self.publish_move(index, true);
            }
            self.events.moved.sort_unstable_by_key(|e| e.body.index1);
            self.publish_joints();
        }
    }

    fn publish_move(&mut self, index: usize, fell_asleep: bool) {
        let (set, row) = self.bodies.at(index);
        let event = BodyMoveEvent {
            body: self.body_id(index),
            transform: set.origin(row),
            user_data: self.bodies.bodies[index].user_data,
            fell_asleep,
        };
        self.events.moved.push(event);
    }

    fn publish_touches(&mut self) {
        for k in 0..self.contacts.awake.len() {
            let index = self.contacts.awake[k] as usize;
            self.contacts.prefetch_at(self.contacts.awake.get(k + CONTACTS_AHEAD).copied());
            let contact = &self.contacts.contacts[index];
            let was = contact.is(flags::TOUCHING);
            // Beginning takes a force or an overlap; having begun, it takes a visible gap to end.
            let is = contact.points().iter().any(|p| p.total > 0.0 || p.separation <= 0.0)
                || was && {
                    let size = contact.shape.iter().map(|&s| self.colliders[s as usize].inner_radius);
                    let slack = TOUCH_MARGIN * size.fold(Float::MAX, Float::min);
                    contact.points().iter().any(|p| p.separation <= slack)
                };
            if contact.is(flags::EVENTS) && is != was {
                let (a, b) =
                    (self.shape_id(contact.shape[0] as usize), self.shape_id(contact.shape[1] as usize));
                let id = self.contact_id(index);
                if is {
                    self.events.begin.push(ContactBeginEvent { shape_a: a, shape_b: b, contact: id });
                } else {
                    self.events.end.push(ContactEndEvent { shape_a: a, shape_b: b, contact: id });
                }
            }
            if contact.is(flags::HIT_EVENTS) {
                self.publish_hit(index);
            }
            self.contacts.contacts[index].set(flags::TOUCHING, is);
        }
        self.events.begin.sort_unstable_by_key(|e| e.contact.index1);
        self.events.end[self.events.announced..].sort_unstable_by_key(|e| e.contact.index1);
        self.events.hit.sort_unstable_by_key(|e| e.contact.index1);
    }

    fn publish_hit(&mut self, index: usize) {
        let contact = &self.contacts.contacts[index];
        let fastest = contact
            .points()
            .iter()
            .filter(|p| p.total > 0.0 && -p.approach > self.def.hit_event_threshold)
            .fold(None, |best: Option<&crate::constraint::ContactPoint>, p| match best {
                Some(b) if b.approach <= p.approach => Some(b),
                _ => Some(p),
            });
        if let Some(p) = fastest {
            let (set, row) = self.bodies.at(contact.body[0] as usize);
            let materials = contact.shape.map(|s| self.colliders[s as usize].material.user_material_id);
            let event = ContactHitEvent {
                shape_a: self.shape_id(contact.shape[0] as usize),
                shape_b: self.shape_id(contact.shape[1] as usize),
                contact: self.contact_id(index),
                point: set.motion[row].x + p.anchor,
                normal: contact.normal,
                approach_speed: self.impact_speed(contact, p),
                materials,
            };
            self.events.hit.push(event);
        }
    }

    /// The approach speed when the gap closed: the one when the step began, and what gravity added on the way.
    fn impact_speed(&self, contact: &Contact, p: &ContactPoint) -> Float {
        let fall = |side: usize| {
            let body = contact.body[side] as usize;
            let (set, row) = self.bodies.at(body);
            let falls = self.bodies.bodies[body].body_type == BodyType::Dynamic;
            if falls { self.def.gravity * set.drive[row].gravity_scale } else { Vec3::zeros() }
        };
        let accel = contact.normal.dot(&(fall(1) - fall(0)));
        (p.approach * p.approach - 2.0 * accel * p.separation.max(0.0)).max(0.0).sqrt()
    }
}
