//! Islands: sets of dynamic bodies that constraints tie together. They persist; a new constraint joins two,
//! and one that lost a constraint is split only when it could otherwise fall asleep.

pub mod color;
pub mod pacing;

use crate::body::{Body, NONE};
use crate::constraint::{Contact, Joint, contact::flags};
use pacing::Pacing;

/// Dynamic bodies that are solved, and fall asleep, together.
#[derive(Clone, Debug, Default)]
pub struct Island {
    /// Stable indices.
    pub bodies: Vec<u32>,
    /// How many constraints were lost since the island was last known to be connected.
    pub lost: u32,
    /// Whether constraints came or went since [`Island::height`] was measured.
    pub changed: bool,
    /// Longest shortest path of constraints from something immovable (or from the first body), at least 1.
    pub height: u32,
    /// Whether a constraint ties it to a static or kinematic body.
    pub anchored: bool,
    /// How many sub-steps it gets.
    pub pacing: Pacing,
}

/// All islands, awake and asleep.
#[derive(Clone, Debug, Default)]
pub struct IslandStore {
    /// By index; free ones have no body.
    pub islands: Vec<Island>,
    free: Vec<u32>,
    queue: Vec<u32>,
    depth: Vec<u32>,
}

impl IslandStore {
    /// Opens an island with one body.
    pub fn open(&mut self, body: u32, bodies: &mut [Body]) -> u32 {
        let id = self.free.pop().unwrap_or_else(|| {
            self.islands.push(Island::default());
            self.islands.len() as u32 - 1
        });
        let island = &mut self.islands[id as usize];
        debug_assert!(island.bodies.is_empty());
        island.bodies.push(body);
        (island.lost, island.changed, island.height, island.anchored) = (0, true, 1, false);
        island.pacing = Pacing::default();
        let b = &mut bodies[body as usize];
        (b.island, b.island_place) = (id, 0);
        id
    }

    /// Takes a body out of its island.
    pub fn leave(&mut self, body: u32, bodies: &mut [Body]) {
        let (id, place) = (bodies[body as usize].island, bodies[body as usize].island_place as usize);
        if id == NONE {
            return;
        }
        let island = &mut self.islands[id as usize];
        island.bodies.swap_remove(place);
        if let Some(&moved) = island.bodies.get(place) {
            bodies[moved as usize].island_place = place as u32;
        }
        island.lost += 1;
        island.changed = true;
        if island.bodies.is_empty() {
            self.free.push(id);
        }
        (bodies[body as usize].island, bodies[body as usize].island_place) = (NONE, NONE);
    }

    /// A constraint came between two bodies: their islands become one.
    pub fn link(&mut self, a: u32, b: u32, bodies: &mut [Body]) {
        let (ia, ib) = (bodies[a as usize].island, bodies[b as usize].island);
        for i in [ia, ib] {
            if i != NONE {
                self.islands[i as usize].changed = true;
            }
        }
        if ia == ib || ia == NONE || ib == NONE {
            return;
        }
        let larger_a = self.islands[ia as usize].bodies.len() >= self.islands[ib as usize].bodies.len();
        let (into, from) = if larger_a { (ia, ib) } else { (ib, ia) };
        let mut moved = std::mem::take(&mut self.islands[from as usize].bodies);
        let Island { lost, pacing, .. } = self.islands[from as usize];
        let target = &mut self.islands[into as usize];
        for &body in &moved {
            let b = &mut bodies[body as usize];
            (b.island, b.island_place) = (into, target.bodies.len() as u32);
            target.bodies.push(body);
        }
        target.lost += lost;
        target.pacing.join(&pacing);
        moved.clear();
        self.islands[from as usize].bodies = moved;
        self.free.push(from);
    }

    /// A constraint went.
    pub fn unlink(&mut self, a: u32, b: u32, bodies: &[Body]) {
        let (ia, ib) = (bodies[a as usize].island, bodies[b as usize].island);
        for i in [ia, ib] {
            if i != NONE {
                self.islands[i as usize].changed = true;
            }
        }
        // A constraint to something immovable never held the island together.
        if ia == ib && ia != NONE {
            self.islands[ia as usize].lost += 1;
        }
    }

    /// Splits an island into its connected parts. Its own id stays with the first part.
    pub fn split(&mut self, id: u32, bodies: &mut [Body], contacts: &[Contact], joints: &[Joint]) {
        let members = std::mem::take(&mut self.islands[id as usize].bodies);
        let pacing = self.islands[id as usize].pacing;
        for &m in &members {
            bodies[m as usize].island = NONE;
        }
        let mut first = true;
        let mut queue = std::mem::take(&mut self.queue);
        for &seed in &members {
            if bodies[seed as usize].island != NONE {
                continue;
            }
            let part = if first {
                first = false;
                let island = &mut self.islands[id as usize];
                (island.lost, island.changed) = (0, true);
                island.bodies.push(seed);
                (bodies[seed as usize].island, bodies[seed as usize].island_place) = (id, 0);
                id
            } else {
                let part = self.open(seed, bodies);
                self.islands[part as usize].pacing = pacing;
                part
            };
            queue.clear();
            queue.push(seed);
            while let Some(body) = queue.pop() {
                for k in 0..bodies[body as usize].contacts.len() {
                    let contact = &contacts[bodies[body as usize].contacts[k] as usize];
                    if !contact.is(flags::CONSTRAINT) {
                        continue;
                    }
                    let other = contact.body[usize::from(contact.body[0] == body)];
                    self.join(other, part, bodies, &mut queue);
                }
                for k in 0..bodies[body as usize].joints.len() {
                    let joint = &joints[bodies[body as usize].joints[k] as usize];
                    if joint.active && joint.ties() {
                        for other in joint.members() {
                            self.join(other, part, bodies, &mut queue);
                        }
                    }
                }
            }
        }
        self.queue = queue;
    }

    /// Takes a neighbour into a part that is being gathered.
    fn join(&mut self, other: u32, part: u32, bodies: &mut [Body], queue: &mut Vec<u32>) {
        // Only members can be NONE here and dynamic: static and kinematic bodies have no island, and are told apart by
        // their type, disabled ones by their set.
        let o = &mut bodies[other as usize];
        if o.island == NONE
            && o.body_type == crate::world::BodyType::Dynamic
            && o.set != crate::body::SetId::DISABLED
        {
            let list = &mut self.islands[part as usize].bodies;
            (o.island, o.island_place) = (part, list.len() as u32);
            list.push(other);
            queue.push(other);
        }
    }

    /// Measures height and anchorage of an island whose constraints changed: breadth first from the bodies on
    /// something immovable, or from the first body where there is none.
    pub fn measure(&mut self, id: u32, bodies: &[Body], contacts: &[Contact], joints: &[Joint]) {
        let island = &self.islands[id as usize];
        let count = island.bodies.len();
        self.queue.clear();
        self.depth.clear();
        self.depth.resize(count, 0);
        for (place, &body) in island.bodies.iter().enumerate() {
            let anchored = bodies[body as usize].contacts.iter().any(|&c| {
                let contact = &contacts[c as usize];
                contact.is(flags::CONSTRAINT)
                    && contact
                        .body
                        .iter()
                        .any(|&b| bodies[b as usize].body_type != crate::world::BodyType::Dynamic)
            });
            let tied = bodies[body as usize].joints.iter().any(|&j| {
                let joint = &joints[j as usize];
                joint.active
                    && joint.ties()
                    && joint
                        .holds_to_world(|b| bodies[b as usize].body_type != crate::world::BodyType::Dynamic)
            });
            if anchored || tied {
                self.depth[place] = 1;
                self.queue.push(body);
            }
        }
        let anchored = !self.queue.is_empty();
        if !anchored {
            self.depth[0] = 1;
            self.queue.push(island.bodies[0]);
        }
        let mut height = 1;
        let mut head = 0;
        while head < self.queue.len() {
            let body = self.queue[head];
            head += 1;
            let depth = self.depth[bodies[body as usize].island_place as usize];
            height = height.max(depth);
            for &c in &bodies[body as usize].contacts {
                let contact = &contacts[c as usize];
                if !contact.is(flags::CONSTRAINT) {
                    continue;
                }
                let other = &bodies[contact.body[usize::from(contact.body[0] == body)] as usize];
                if other.island == id && self.depth[other.island_place as usize] == 0 {
                    self.depth[other.island_place as usize] = depth + 1;
                    self.queue.push(contact.body[usize::from(contact.body[0] == body)]);
                }
            }
            for &j in &bodies[body as usize].joints {
                let joint = &joints[j as usize];
                for other in joint.members().filter(|_| joint.active && joint.ties()) {
                    let o = &bodies[other as usize];
                    if o.island == id && self.depth[o.island_place as usize] == 0 {
                        self.depth[o.island_place as usize] = depth + 1;
                        self.queue.push(other);
                    }
                }
            }
        }
        let island = &mut self.islands[id as usize];
        (island.height, island.anchored, island.changed) = (height, anchored, false);
    }

    /// The depths of the bodies of the island that was measured last, by their places in it: 1 on something
    /// immovable, 0 where no path leads.
    #[must_use]
    pub fn depths(&self) -> &[u32] {
        &self.depth
    }

    /// Bytes held.
    #[must_use]
    pub fn byte_count(&self) -> usize {
        self.islands.iter().map(|i| i.bodies.capacity() * 4).sum::<usize>()
            + self.islands.capacity() * size_of::<Island>()
            + 4 * (self.free.capacity() + self.queue.capacity() + self.depth.capacity())
    }
}
