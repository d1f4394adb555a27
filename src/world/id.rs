//! Generational ids. Zero is null; a stale or foreign id is always detected.

use crate::error::{Error, ErrorCode, Result};

macro_rules! id_type {
    ($(#[$doc:meta])* $name:ident, $generation:ty, $word:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub struct $name {
            /// The slot, counted from 1; 0 is null.
            pub index1: u32,
            /// The tag of the world it belongs to.
            pub world: u16,
            /// How often the slot has been used.
            pub generation: $generation,
        }

        impl $name {
            /// The id that names nothing.
            pub const NULL: $name = $name { index1: 0, world: 0, generation: 0 };

            /// Whether the id names nothing.
            #[must_use]
            pub fn is_null(self) -> bool {
                self.index1 == 0
            }

            pub(crate) fn look_up(self, tag: u16, pool: &IdPool) -> Result<usize> {
                if self.is_null() {
                    return Err(Error::new(ErrorCode::Null, concat!("The ", $word, " id is null.")));
                }
                if self.world != tag {
                    return Err(Error::new(
                        ErrorCode::Foreign,
                        concat!("The ", $word, " belongs to another world."),
                    ));
                }
                let index = (self.index1 - 1) as usize;
                if pool.is_live(index, u32::from(self.generation)) {
                    Ok(index)
                } else {
                    Err(Error::new(ErrorCode::Stale, concat!("The ", $word, " was destroyed.")))
                }
            }
        }
    };
}

id_type! {
    /// A body of a world.
    BodyId, u16, "body"
}
id_type! {
    /// A shape attached to a body.
    ShapeId, u16, "shape"
}
id_type! {
    /// A contact between two shapes: from the step in which their boxes meet to the one in which they part.
    ContactId, u32, "contact"
}

id_type! {
    /// A joint between bodies.
    JointId, u16, "joint"
}

/// Hands out slots with a generation each. A slot whose generations are used up is never handed out again.
#[derive(Clone, Debug)]
pub struct IdPool {
    slots: Vec<Slot>,
    free: Vec<u32>,
    last_generation: u32,
    live: usize,
}

#[derive(Clone, Copy, Debug)]
struct Slot {
    /// Of the present or last use.
    generation: u32,
    /// The highest generation ever given out, which a restored snapshot does not take back.
    highest: u32,
    live: bool,
}

impl IdPool {
    /// An empty pool whose generations run from 1 to `last_generation`.
    #[must_use]
    pub fn new(last_generation: u32) -> Self {
        Self { slots: Vec::new(), free: Vec::new(), last_generation, live: 0 }
    }

    /// Takes a slot: its index (from 0) and generation.
    pub fn allocate(&mut self) -> (usize, u32) {
        self.live += 1;
        if let Some(index) = self.free.pop() {
            let slot = &mut self.slots[index as usize];
            slot.highest += 1;
            slot.generation = slot.highest;
            slot.live = true;
            (index as usize, slot.generation)
        } else {
            crate::memory::make_room(&mut self.slots, 1);
            self.slots.push(Slot { generation: 1, highest: 1, live: true });
            (self.slots.len() - 1, 1)
        }
    }

    /// Gives a slot back.
    pub fn release(&mut self, index: usize) {
        let slot = &mut self.slots[index];
        debug_assert!(slot.live);
        slot.live = false;
        self.live -= 1;
        if slot.highest < self.last_generation {
            self.free.push(index as u32);
        }
    }

    /// Goes back to an earlier state of this pool, but for generations: ids given out since stay stale.
    pub fn restore(&mut self, earlier: &IdPool) {
        let mut slots = earlier.slots.clone();
        for (old, new) in self.slots.iter().zip(&mut slots) {
            new.highest = new.highest.max(old.highest);
        }
        // Slots that did not exist then are taken last and in order, as if they were made anew.
        let later = slots.len().min(self.slots.len())..self.slots.len();
        self.free = later.clone().rev().map(|i| i as u32).collect();
        slots.extend(self.slots[later].iter().map(|s| Slot { live: false, ..*s }));
        self.free.extend_from_slice(&earlier.free);
        let (last, usable) = (self.last_generation, &slots);
        self.free.retain(|&i| usable[i as usize].highest < last);
        self.slots = slots;
        self.live = earlier.live;
    }

    /// Whether this slot is taken, in this generation.
    #[must_use]
    pub fn is_live(&self, index: usize, generation: u32) -> bool {
        self.slots.get(index).is_some_and(|s| s.live && s.generation == generation)
    }

    /// The generation of a slot, 0 for one that was never handed out.
    #[must_use]
    pub fn generation_of(&self, index: usize) -> u32 {
        self.slots.get(index).map_or(0, |s| s.generation)
    }

    /// The generation of a taken slot.
    #[must_use]
    pub fn generation(&self, index: usize) -> u32 {
        self.slots[index].generation
    }

    /// How many slots are taken.
    #[must_use]
    pub fn live(&self) -> usize {
        self.live
    }

    /// How many slots there are, taken or not.
    #[must_use]
    pub fn slots(&self) -> usize {
        self.slots.len()
    }

    /// Bytes held.
    #[must_use]
    pub fn byte_count(&self) -> usize {
        self.slots.capacity() * size_of::<Slot>() + self.free.capacity() * 4
    }

    /// The same pool with everything given back, lowest slots first out: for the next world in the same place.
    #[must_use]
    pub fn emptied(mut self) -> Self {
        for index in 0..self.slots.len() {
            if self.slots[index].live {
                self.release(index);
            }
        }
        self.free.sort_unstable_by(|a, b| b.cmp(a));
        self
    }
}

/// What tells the ids of one world from those of any other, past or present.
#[derive(Clone, Debug)]
pub struct Identity {
    /// The tag that every id of the world carries.
    pub tag: u16,
    pub(crate) bodies: IdPool,
    pub(crate) shapes: IdPool,
    pub(crate) contacts: IdPool,
    pub(crate) joints: IdPool,
}

impl Identity {
    /// A fresh identity.
    #[must_use]
    pub fn new(tag: u16) -> Self {
        Self {
            tag,
            bodies: IdPool::new(u32::from(u16::MAX)),
            shapes: IdPool::new(u32::from(u16::MAX)),
            contacts: IdPool::new(u32::MAX),
            joints: IdPool::new(u32::from(u16::MAX)),
        }
    }

    /// Goes back to an earlier state, but for generations.
    pub(crate) fn restore(&mut self, earlier: &Identity) {
        self.bodies.restore(&earlier.bodies);
        self.shapes.restore(&earlier.shapes);
        self.contacts.restore(&earlier.contacts);
        self.joints.restore(&earlier.joints);
    }

    /// The identity for a next world with the same tag: no id of the old world is valid in it.
    #[must_use]
    pub fn successor(self) -> Self {
        Self {
            tag: self.tag,
            bodies: self.bodies.emptied(),
            shapes: self.shapes.emptied(),
            contacts: self.contacts.emptied(),
            joints: self.joints.emptied(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_released_slot_is_stale_and_a_used_up_one_retires() {
        let mut pool = IdPool::new(2);
        let (i, g) = pool.allocate();
        pool.release(i);
        assert!(!pool.is_live(i, g));
        let (j, g2) = pool.allocate();
        assert_eq!((j, g2), (i, 2));
        pool.release(j);
        assert_eq!(pool.allocate(), (1, 1), "slot 0 has used its two generations");
    }

    #[test]
    fn a_restored_pool_gives_the_same_slots_but_new_generations() {
        let mut pool = IdPool::new(100);
        pool.allocate();
        let (b, _) = pool.allocate();
        pool.release(b);
        let saved = pool.clone();
        let after = [pool.allocate(), pool.allocate(), pool.allocate()];
        pool.restore(&saved);
        assert!(after.iter().all(|&(i, g)| !pool.is_live(i, g)));
        let again = [pool.allocate(), pool.allocate(), pool.allocate()];
        assert_eq!(after.map(|a| a.0), again.map(|a| a.0));
        assert!(after.iter().zip(&again).all(|(x, y)| x.1 < y.1));
    }

    #[test]
    fn a_successor_knows_no_id_of_its_ancestor() {
        let mut identity = Identity::new(7);
        let (i, g) = identity.bodies.allocate();
        let next = identity.successor();
        assert!(!next.bodies.is_live(i, g));
        assert_eq!(next.bodies.live(), 0);
    }
}
