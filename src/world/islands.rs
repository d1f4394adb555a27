//! Islands, sleeping and waking, where they meet contacts.

use super::{BodyType, World};
use crate::body::{NONE, SetId};
use crate::constraint::contact::flags;
use crate::island::color::NO_COLOR;
use crate::math::{Float, Vec3, length, tolerance::TIME_TO_SLEEP};

impl World {
    /// A contact becomes a constraint: it joins islands, wakes what sleeps, and gets a colour.
    pub(super) fn begin_constraint(&mut self, index: usize) {
        let [a, b] = self.contacts.contacts[index].body;
        self.contacts.contacts[index].set(flags::CONSTRAINT, true);
        for body in [a, b] {
            self.wake_body(body as usize);
        }
        self.islands.link(a, b, &mut self.bodies.bodies);
        self.take_color(index);
    }

    /// A contact ceases to be a constraint.
    pub(super) fn end_constraint(&mut self, index: usize) {
        if !self.contacts.contacts[index].is(flags::CONSTRAINT) {
            return;
        }
        self.give_color_back(index);
        let contact = &mut self.contacts.contacts[index];
        contact.set(flags::CONSTRAINT, false);
        contact.count = 0;
        contact.clear_impulses();
        let [a, b] = contact.body;
        self.islands.unlink(a, b, &self.bodies.bodies);
    }

    fn take_color(&mut self, index: usize) {
        let contact = &mut self.contacts.contacts[index];
        if contact.color == NO_COLOR {
            let moving = moving(contact.body, &self.bodies.bodies);
            contact.color = self.coloring.assign(moving.as_slice());
        }
    }

    fn give_color_back(&mut self, index: usize) {
        let contact = &mut self.contacts.contacts[index];
        if contact.color != NO_COLOR {
            let moving = moving(contact.body, &self.bodies.bodies);
            self.coloring.release(contact.color, moving.as_slice());
            contact.color = NO_COLOR;
        }
    }

    /// Wakes a body's island.
    pub(crate) fn wake_body(&mut self, body: usize) {
        if self.bodies.bodies[body].set.is_sleeping() {
            self.wake_island(self.bodies.bodies[body].island);
        }
    }

    /// Wakes a body and all that it touches.
    pub(crate) fn wake_touching(&mut self, body: usize) {
        self.wake_body(body);
        for k in 0..self.bodies.bodies[body].contacts.len() {
            let contact = &self.contacts.contacts[self.bodies.bodies[body].contacts[k] as usize];
            if contact.is(flags::CONSTRAINT) {
                let other = contact.body[usize::from(contact.body[0] as usize == body)];
                self.wake_body(other as usize);
            }
        }
        for k in 0..self.bodies.bodies[body].joints.len() {
            let joint = self.bodies.bodies[body].joints[k] as usize;
            if self.joints.joints[joint].active {
                self.wake_joint(joint);
            }
        }
    }

    /// Wakes everything.
    pub(crate) fn wake_all(&mut self) {
        for island in 0..self.islands.islands.len() {
            if let Some(&body) = self.islands.islands[island].bodies.first() {
                self.wake_body(body as usize);
            }
        }
        for time in &mut self.bodies.sets[SetId::AWAKE.0 as usize].slow_time {
            *time = 0.0;
        }
    }

    /// Moves a sleeping island's bodies back among the awake ones.
    fn wake_island(&mut self, island: u32) {
        let first = self.islands.islands[island as usize].bodies[0] as usize;
        let set = self.bodies.bodies[first].set;
        debug_assert!(set.is_sleeping());
        for k in 0..self.islands.islands[island as usize].bodies.len() {
            let body = self.islands.islands[island as usize].bodies[k] as usize;
            self.bodies.transfer(body, SetId::AWAKE);
            let (awake, row) = self.bodies.at_mut(body);
            awake.slow_time[row] = 0.0;
        }
        self.bodies.close_sleeping_set(set);
        for k in 0..self.islands.islands[island as usize].bodies.len() {
            let body = self.islands.islands[island as usize].bodies[k] as usize;
            self.wake_contacts(body);
        }
    }

    /// Enters a body's contacts into the awake list; constraints get a colour again.
    pub(crate) fn wake_contacts(&mut self, body: usize) {
        for c in 0..self.bodies.bodies[body].contacts.len() {
            let contact = self.bodies.bodies[body].contacts[c] as usize;
            self.contacts.set_awake(contact, true);
            if self.contacts.contacts[contact].is(flags::CONSTRAINT) {
                self.take_color(contact);
            }
        }
    }

    /// Moves an island's bodies to a set of their own, which no step touches.
    pub(crate) fn put_to_sleep(&mut self, island: u32) {
        let set = self.bodies.open_sleeping_set();
        for k in 0..self.islands.islands[island as usize].bodies.len() {
            let body = self.islands.islands[island as usize].bodies[k] as usize;
            self.bodies.transfer(body, set);
            // What sleeps is at rest.
            let (rows, row) = self.bodies.at_mut(body);
            (rows.motion[row].p, rows.motion[row].l) = (Vec3::zeros(), Vec3::zeros());
        }
        for k in 0..self.islands.islands[island as usize].bodies.len() {
            let body = self.islands.islands[island as usize].bodies[k] as usize;
            for c in 0..self.bodies.bodies[body].contacts.len() {
                let contact = self.bodies.bodies[body].contacts[c] as usize;
                if !self.deserves_attention(contact) {
                    self.give_color_back(contact);
                    self.contacts.set_awake(contact, false);
                }
            }
        }
    }

    /// Whether a step has to look at a contact: one of its bodies moves.
    pub(super) fn deserves_attention(&self, contact: usize) -> bool {
        self.contacts.contacts[contact].body.iter().any(|&b| {
            let body = &self.bodies.bodies[b as usize];
            match body.body_type {
                BodyType::Dynamic => body.set == SetId::AWAKE,
                BodyType::Kinematic => body.set == SetId::AWAKE && self.is_moving(b as usize),
                BodyType::Static => false,
            }
        })
    }

    pub(super) fn is_moving(&self, body: usize) -> bool {
        let (set, row) = self.bodies.at(body);
        set.motion[row].p != Vec3::zeros() || set.motion[row].l != Vec3::zeros()
    }

    /// Stage 9: counts how long bodies have been slow and puts islands to sleep that were long enough.
    pub(super) fn update_sleep(&mut self, dt: Float) {
        if !self.def.enable_sleep {
            return;
        }
        let mut slow = std::mem::take(&mut self.scratch.slow_time);
        slow.clear();
        slow.resize(self.islands.islands.len(), Float::MAX);
        let awake = &mut self.bodies.sets[SetId::AWAKE.0 as usize];
        for row in 0..awake.len() {
            let island = self.bodies.bodies[awake.index[row] as usize].island;
            if island == NONE {
                continue;
            }
            let drive = &awake.drive[row];
            let speed =
                length(awake.velocity(row)).max(length(awake.angular_velocity(row)) * awake.mass[row].extent);
            let time = if drive.enable_sleep && speed <= drive.sleep_threshold {
                awake.slow_time[row] + dt
            } else {
                0.0
            };
            awake.slow_time[row] = time;
            let least = &mut slow[island as usize];
            *least = least.min(time);
        }
        for (island, &time) in slow.iter().enumerate() {
            if time == Float::MAX || time < TIME_TO_SLEEP {
                continue;
            }
            if self.touches_moving_kinematic(island) {
                continue;
            }
            if self.islands.islands[island].lost > 0 {
                self.islands.split(
                    island as u32,
                    &mut self.bodies.bodies,
                    &self.contacts.contacts,
                    &self.joints.joints,
                );
            } else {
                for k in 0..self.islands.islands[island].bodies.len() {
                    let body = self.islands.islands[island].bodies[k];
                    self.scratch.fell_asleep.push(body);
                }
                self.put_to_sleep(island as u32);
            }
        }
        self.scratch.slow_time = slow;
    }

    pub(super) fn touches_moving_kinematic(&self, island: usize) -> bool {
        self.islands.islands[island].bodies.iter().any(|&b| {
            self.is_driven_by_joints(b as usize)
                || self.bodies.bodies[b as usize].contacts.iter().any(|&c| {
                    let contact = &self.contacts.contacts[c as usize];
                    contact.is(flags::CONSTRAINT)
                        && contact.body.iter().any(|&o| {
                            self.bodies.bodies[o as usize].body_type == BodyType::Kinematic
                                && self.is_moving(o as usize)
                        })
                })
        })
    }
}

/// The one or two bodies of a pair that constraints can move.
struct Moving {
    bodies: [u32; 2],
    count: usize,
}

impl Moving {
    fn as_slice(&self) -> &[u32] {
        &self.bodies[..self.count]
    }
}

fn moving(pair: [u32; 2], bodies: &[crate::body::Body]) -> Moving {
    let mut out = Moving { bodies: [NONE; 2], count: 0 };
    for b in pair {
        if bodies[b as usize].body_type == BodyType::Dynamic {
            out.bodies[out.count] = b;
            out.count += 1;
        }
    }
    out
}
