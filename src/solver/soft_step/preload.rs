//! First impulses of contacts that begin at rest. A stack put down as it is to stand carries its weight from the
//! first sub-step: weights are handed down the constraint graph, from the bodies farthest from the ground to it,
//! each body's load shared by what supports it. Only contacts without impulses take the estimate, and only where
//! nothing moves faster than a body dropped a moment ago; the solver corrects the rest.

use crate::body::BodyStore;
use crate::constraint::{Contact, ContactStore, contact::flags};
use crate::island::IslandStore;
use crate::math::{Float, Vec3, length, length_squared};
use crate::solver::Settings;

/// Supports lean by up to 84° from the vertical.
const LEAST_COSINE: Float = 0.1;

/// Scratch of the estimate.
#[derive(Debug, Default)]
pub struct Preload {
    /// Places of bodies in the island, deepest first.
    order: Vec<(u32, u32)>,
    /// Mass that each body carries, its own included.
    carried: Vec<Float>,
    supports: Vec<(u32, Float)>,
}

impl Preload {
    /// Gives the new resting contacts of an island that was measured just now the impulses of their load.
    pub fn run(
        &mut self,
        island: u32,
        islands: &IslandStore,
        bodies: &BodyStore,
        contacts: &mut ContactStore,
        settings: &Settings,
    ) {
        let g = length(settings.gravity);
        if g == 0.0 {
            return;
        }
        let up = settings.gravity / -g;
        // What a body gains, and falls, in two steps.
        let (slow, near) = (2.0 * g * settings.dt, 2.0 * g * settings.dt * settings.dt);
        let members = &islands.islands[island as usize].bodies;
        let depths = islands.depths();
        let is_new = |c: &Contact| {
            c.is(flags::CONSTRAINT)
                && c.points().iter().all(|p| p.impulse == 0.0 && p.memory == 0.0 && p.approach > -slow)
                && c.points().iter().any(|p| p.separation < near)
                // What will bounce does not rest.
                && (c.restitution == 0.0 || c.points().iter().all(|p| p.approach >= -settings.restitution_threshold))
        };
        let any = members.iter().any(|&b| {
            bodies.bodies[b as usize].contacts.iter().any(|&c| is_new(&contacts.contacts[c as usize]))
        });
        if !any {
            return;
        }
        self.order.clear();
        self.order.extend(depths.iter().enumerate().map(|(place, &d)| (d, place as u32)));
        self.order.sort_unstable_by(|a, b| b.cmp(a));
        self.carried.clear();
        self.carried.extend(members.iter().map(|&b| {
            let (set, row) = bodies.at(b as usize);
            let rests = length_squared(set.velocity(row)) < slow * slow;
            if rests { set.mass[row].mass * set.drive[row].gravity_scale.max(0.0) } else { 0.0 }
        }));
        let h = settings.dt / settings.sub_steps as Float;
        for &(depth, place) in &self.order {
            let body = members[place as usize];
            self.supports.clear();
            let mut total = 0.0;
            for &c in &bodies.bodies[body as usize].contacts {
                let contact = &contacts.contacts[c as usize];
                if !contact.is(flags::CONSTRAINT) || contact.points().iter().all(|p| p.separation >= near) {
                    continue;
                }
                let is_b = contact.body[1] == body;
                let other = &bodies.bodies[contact.body[usize::from(!is_b)] as usize];
                let lower = other.island != island || depths[other.island_place as usize] < depth;
                let push: Vec3 = if is_b { contact.normal } else { -contact.normal };
                let cosine = push.dot(&up);
                if lower && cosine > LEAST_COSINE {
                    self.supports.push((c, cosine));
                    total += cosine;
                }
            }
            for &(c, cosine) in &self.supports {
                let share = self.carried[place as usize] * cosine / total;
                let contact = &mut contacts.contacts[c as usize];
                if is_new(contact) {
                    let each = share * g * h / Float::from(contact.count);
                    for p in &mut contact.points[..contact.count as usize] {
                        (p.impulse, p.memory) = (each, each);
                    }
                }
                let other = &bodies.bodies[contact.body[usize::from(contact.body[0] == body)] as usize];
                if other.island == island {
                    self.carried[other.island_place as usize] += share;
                }
            }
        }
    }
}
