//! Whether the parts of a world agree with each other. For tests: it costs as much as it pleases.

use super::{BodyType, World};
use crate::body::{NONE, SetId};
use crate::constraint::contact::flags;
use crate::island::color::{COLORS, NO_COLOR, OVERFLOW};
use std::collections::BTreeSet;

impl World {
    /// Panics where lists, sets, places, flags and colours do not say the same.
    #[doc(hidden)]
    pub fn validate(&self) {
        self.validate_bodies();
        self.validate_islands();
        self.validate_shapes();
        self.validate_contacts();
        self.validate_joints();
    }

    fn validate_joints(&self) {
        let pool = &self.identity.joints;
        assert_eq!(pool.live(), self.joints.live.len());
        assert!(self.joints.live.is_sorted_by(|a, b| a < b));
        for &j in &self.joints.live {
            assert!(pool.is_live(j as usize, pool.generation(j as usize)));
            let joint = &self.joints.joints[j as usize];
            for body in joint.members() {
                assert!(self.bodies.bodies[body as usize].joints.contains(&j), "joint {j} of body {body}");
            }
            let enabled = joint.members().all(|b| self.bodies.bodies[b as usize].set != SetId::DISABLED);
            assert_eq!(joint.active, enabled, "joint {j} acts");
            if joint.active && joint.ties() {
                let islands: BTreeSet<u32> = joint
                    .members()
                    .map(|b| self.bodies.bodies[b as usize].island)
                    .filter(|&i| i != NONE)
                    .collect();
                assert!(islands.len() <= 1, "joint {j} lies in one island");
            }
        }
        for body in self.live_bodies() {
            assert!(self.bodies.bodies[body].joints.iter().all(|j| self.joints.live.contains(j)));
        }
    }

    fn live_bodies(&self) -> impl Iterator<Item = usize> + '_ {
        let pool = &self.identity.bodies;
        (0..pool.slots()).filter(|&i| pool.is_live(i, pool.generation(i)))
    }

    fn validate_bodies(&self) {
        let rows: usize = self.bodies.sets.iter().map(|s| s.len()).sum();
        assert_eq!(rows, self.identity.bodies.live(), "each body has one row");
        for index in self.live_bodies() {
            let body = &self.bodies.bodies[index];
            let (set, row) = self.bodies.at(index);
            assert_eq!(set.index[row] as usize, index, "row of body {index}");
            let columns = [set.motion.len(), set.mass.len(), set.inv_inertia.len(), set.drive.len()];
            assert!(columns.iter().chain(&[set.slow_time.len()]).all(|&n| n == set.len()));
            assert_eq!(set.drive[row].kinematic, body.body_type == BodyType::Kinematic);
            assert!(set.motion[row].is_finite(), "body {index} is at {:?}", set.motion[row]);
            let enabled = body.set != SetId::DISABLED;
            match body.body_type {
                BodyType::Static => assert!(!enabled || body.set == SetId::STATIC),
                BodyType::Kinematic => assert!(!enabled || body.set == SetId::AWAKE),
                BodyType::Dynamic => assert!(body.set != SetId::STATIC),
            }
            let has_island = enabled && body.body_type == BodyType::Dynamic;
            assert_eq!(body.island != NONE, has_island, "island of body {index}");
            assert!(enabled || body.contacts.is_empty());
            assert!(!body.quarantined || !enabled);
            for &shape in &body.shapes {
                assert_eq!(self.colliders[shape as usize].body as usize, index);
            }
        }
    }

    fn validate_islands(&self) {
        let mut members = 0;
        for (id, island) in self.islands.islands.iter().enumerate() {
            members += island.bodies.len();
            let Some(&first) = island.bodies.first() else { continue };
            let set = self.bodies.bodies[first as usize].set;
            for (place, &b) in island.bodies.iter().enumerate() {
                let body = &self.bodies.bodies[b as usize];
                assert_eq!((body.island as usize, body.island_place as usize), (id, place));
                assert_eq!(body.set, set, "an island sleeps as a whole");
            }
            if set.is_sleeping() {
                assert_eq!(self.bodies.sets[set.0 as usize].len(), island.bodies.len());
            }
            if island.lost == 0 {
                self.validate_connected(&island.bodies);
            }
        }
        let dynamic = self.live_bodies().filter(|&b| self.bodies.bodies[b].island != NONE).count();
        assert_eq!(members, dynamic);
    }

    fn validate_connected(&self, members: &[u32]) {
        let mut seen = BTreeSet::from([members[0]]);
        let mut queue = vec![members[0]];
        while let Some(body) = queue.pop() {
            for &c in &self.bodies.bodies[body as usize].contacts {
                let contact = &self.contacts.contacts[c as usize];
                for other in contact.body.into_iter().filter(|_| contact.is(flags::CONSTRAINT)) {
                    if self.bodies.bodies[other as usize].island != NONE && seen.insert(other) {
                        queue.push(other);
                    }
                }
            }
            for &j in &self.bodies.bodies[body as usize].joints {
                let joint = &self.joints.joints[j as usize];
                for other in joint.members().filter(|_| joint.active && joint.ties()) {
                    if self.bodies.bodies[other as usize].island != NONE && seen.insert(other) {
                        queue.push(other);
                    }
                }
            }
        }
        assert_eq!(seen.len(), members.len(), "an island that lost nothing is connected");
    }

    fn validate_shapes(&self) {
        let pool = &self.identity.shapes;
        let live = |i: usize| pool.is_live(i, pool.generation(i));
        let (mut attached, mut proxies) = (0, 0);
        for index in self.live_bodies() {
            let body = &self.bodies.bodies[index];
            attached += body.shapes.len();
            for &shape in &body.shapes {
                assert!(live(shape as usize));
                if body.set == SetId::DISABLED {
                    assert!(!self.moved.contains(&shape));
                    continue;
                }
                proxies += 1;
                let collider = &self.colliders[shape as usize];
                let mut found = false;
                self.broad_phase.query(&collider.fat, &mut |s| {
                    found |= s == shape;
                    !found
                });
                assert!(found, "shape {shape} is not in the broad phase");
                let (set, row) = self.bodies.at(index);
                let tight = collider.aabb(&set.origin(row));
                let slack = 1e-4 * (1.0 + tight.lower.amax().max(tight.upper.amax()));
                assert!(collider.fat.grown(slack).contains(&tight), "shape {shape} left its box");
            }
        }
        assert_eq!(attached, pool.live());
        assert_eq!(proxies, self.broad_phase.stats().proxies);
        assert!(self.moved.iter().all(|&m| live(m as usize)));
    }

    fn validate_contacts(&self) {
        let mut colors: [BTreeSet<u32>; COLORS] = std::array::from_fn(|_| BTreeSet::new());
        let (mut count, mut awake) = (0, 0);
        for index in self.live_contacts() {
            count += 1;
            let contact = &self.contacts.contacts[index];
            assert_eq!(self.pairs.get(contact.shape), Some(index as u32));
            let bodies = contact.body.map(|b| &self.bodies.bodies[b as usize]);
            for (side, body) in bodies.iter().enumerate() {
                assert_eq!(body.contacts[contact.place[side] as usize] as usize, index);
                assert_eq!(self.colliders[contact.shape[side] as usize].body, contact.body[side]);
                assert!(body.set != SetId::DISABLED);
            }
            assert!(bodies.iter().any(|b| b.body_type == BodyType::Dynamic));
            let listed = contact.awake_place != NONE;
            assert_eq!(listed, self.deserves_attention(index), "attention to contact {index}");
            if listed {
                awake += 1;
                assert_eq!(self.contacts.awake[contact.awake_place as usize] as usize, index);
            }
            let constraint = contact.is(flags::CONSTRAINT);
            assert_eq!(contact.count > 0, constraint, "points of contact {index}");
            assert_eq!(contact.color != NO_COLOR, constraint && listed, "colour of contact {index}");
            if constraint {
                let islands: BTreeSet<u32> = bodies.iter().map(|b| b.island).filter(|&i| i != NONE).collect();
                assert_eq!(islands.len(), 1, "a constraint lies in one island");
                let asleep = bodies.iter().any(|b| b.set.is_sleeping());
                assert!(!(asleep && listed), "constraint {index} of a sleeping body is solved");
                if listed && contact.color != OVERFLOW {
                    for (body, b) in bodies.iter().zip(contact.body) {
                        if body.body_type == BodyType::Dynamic {
                            assert!(colors[contact.color as usize].insert(b), "a colour has a body once");
                        }
                    }
                }
            }
        }
        assert_eq!((count, awake), (self.pairs.len(), self.contacts.awake.len()));
        let listed: usize = self.live_bodies().map(|b| self.bodies.bodies[b].contacts.len()).sum();
        assert_eq!(listed, 2 * count);
        for (color, known) in colors.iter().enumerate() {
            assert!(self.coloring.holders(color).eq(known.iter().copied()), "bits of colour {color}");
        }
    }
}
