//! The pairs that are known, each with the number of its contact.

/// A set of pairs `[low, high]` (low < high), each with a `u32`: an open hash table with linear probing.
///
/// 12 bytes a slot, at most three quarters full. Removal shifts the followers back, so there are no tombstones
/// and an old table is as fast as a new one. What a call answers depends on the pairs alone; nothing here walks
/// the table in its own order.
#[derive(Clone, Debug, Default)]
pub struct PairSet {
    slots: Vec<Slot>,
    len: usize,
}

#[derive(Clone, Copy, Debug)]
struct Slot {
    pair: [u32; 2],
    value: u32,
}

/// No pair has two equal members.
const FREE: Slot = Slot { pair: [u32::MAX; 2], value: 0 };

const LEAST_SLOTS: usize = 16;

impl PairSet {
    /// An empty set, without memory of its own.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The number of pairs.
    #[must_use]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The memory held \[bytes\].
    #[must_use]
    pub fn byte_count(&self) -> usize {
        self.slots.capacity() * size_of::<Slot>()
    }

    /// The value of `pair`.
    #[inline]
    #[must_use]
    pub fn get(&self, pair: [u32; 2]) -> Option<u32> {
        if self.len == 0 {
            return None;
        }
        let slot = self.slots[self.find(pair)];
        (slot.pair == pair).then_some(slot.value)
    }

    /// Stores `value` with `pair` and returns the value it replaces. Grows the table when it is full.
    pub fn insert(&mut self, pair: [u32; 2], value: u32) -> Option<u32> {
        debug_assert!(pair[0] < pair[1], "a pair is stored as (low, high)");
        self.reserve(1);
        let at = self.find(pair);
        let slot = &mut self.slots[at];
        if slot.pair == pair {
            return Some(std::mem::replace(&mut slot.value, value));
        }
        *slot = Slot { pair, value };
        self.len += 1;
        None
    }

    /// Takes `pair` out and returns its value.
    pub fn remove(&mut self, pair: [u32; 2]) -> Option<u32> {
        if self.len == 0 {
            return None;
        }
        let mut hole = self.find(pair);
        if self.slots[hole].pair != pair {
            return None;
        }
        let value = self.slots[hole].value;
        let mask = self.slots.len() - 1;
        let mut next = (hole + 1) & mask;
        // A follower may fill the hole unless its home lies after the hole on the way to where it stands.
        while self.slots[next].pair != FREE.pair {
            let home = hash(self.slots[next].pair) as usize & mask;
            if next.wrapping_sub(home) & mask >= next.wrapping_sub(hole) & mask {
                self.slots[hole] = self.slots[next];
                hole = next;
            }
            next = (next + 1) & mask;
        }
        self.slots[hole] = FREE;
        self.len -= 1;
        Some(value)
    }

    /// Takes every pair out and keeps the memory.
    pub fn clear(&mut self) {
        self.slots.fill(FREE);
        self.len = 0;
    }

    /// Makes room for `more` pairs, so that inserting them does not allocate.
    pub fn reserve(&mut self, more: usize) {
        let needed = self.len + more;
        if needed * 4 <= self.slots.len() * 3 {
            return;
        }
        let count = (needed * 4).div_ceil(3).next_power_of_two().max(LEAST_SLOTS);
        let old = std::mem::replace(&mut self.slots, vec![FREE; count]);
        for slot in old {
            if slot.pair != FREE.pair {
                let at = self.find(slot.pair);
                self.slots[at] = slot;
            }
        }
    }

    /// Where `pair` stands, or the free slot where it belongs.
    #[inline]
    fn find(&self, pair: [u32; 2]) -> usize {
        let mask = self.slots.len() - 1;
        let mut at = hash(pair) as usize & mask;
        loop {
            let slot = self.slots[at].pair;
            if slot == pair || slot == FREE.pair {
                return at;
            }
            at = (at + 1) & mask;
        }
    }
}

/// The finaliser of splitmix64 (Steele, Lea, Flood 2014): every bit of the pair reaches every bit of the hash.
#[inline]
fn hash(pair: [u32; 2]) -> u64 {
    let mut x = u64::from(pair[0]) << 32 | u64::from(pair[1]);
    x = (x ^ x >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ x >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ x >> 31
}

#[cfg(test)]
mod tests {
    use super::super::random::Random;
    use super::*;
    use std::collections::BTreeMap;

    #[test]
    fn agrees_with_an_ordered_map() {
        let (mut set, mut map, mut random) = (PairSet::new(), BTreeMap::new(), Random::new(1));
        for round in 0..200_000 {
            let a = random.below(60);
            let pair = [a, a + 1 + random.below(60)];
            if random.below(2) == 0 {
                assert_eq!(set.insert(pair, round), map.insert(pair, round));
            } else {
                assert_eq!(set.remove(pair), map.remove(&pair));
            }
            assert_eq!(set.len(), map.len());
            if round % 10_000 == 0 {
                map.iter().for_each(|(&pair, &value)| assert_eq!(set.get(pair), Some(value)));
            }
        }
        set.clear();
        assert!(set.is_empty() && map.keys().all(|&pair| set.get(pair).is_none()));
    }

    #[test]
    fn takes_millions_of_pairs() {
        let mut set = PairSet::new();
        let pairs = || (0..1500u32).flat_map(|a| (a + 1..1500).map(move |b| [a, b]));
        pairs().for_each(|p| assert_eq!(set.insert(p, p[0] ^ p[1]), None));
        assert_eq!(set.len(), 1_124_250);
        assert!(pairs().all(|p| set.get(p) == Some(p[0] ^ p[1])));
        assert!(set.slots.len() * 3 >= set.len() * 4 && set.byte_count() <= 16 * set.len() * 2);
        pairs().filter(|p| p[1] % 3 != 0).for_each(|p| assert!(set.remove(p).is_some()));
        assert!(pairs().all(|p| set.get(p).is_some() == (p[1] % 3 == 0)));
    }

    #[test]
    fn runs_of_slots_stay_short() {
        // Neighbours on a grid: the keys that a bad mixer would line up.
        let mut set = PairSet::new();
        (0..100_000u32)
            .for_each(|a| [1, 2, 300].iter().for_each(|d| assert_eq!(set.insert([a, a + d], a), None)));
        let mask = set.slots.len() - 1;
        let distance = |(at, s): (usize, &Slot)| at.wrapping_sub(hash(s.pair) as usize) & mask;
        let total: usize =
            set.slots.iter().enumerate().filter(|(_, s)| s.pair != FREE.pair).map(distance).sum();
        assert!(total < 2 * set.len(), "{} probes for {} pairs", total, set.len());
    }
}
