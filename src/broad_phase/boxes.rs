//! The boxes of one structure, side by side.

use crate::math::Aabb;

pub(super) const ABSENT: u32 = u32::MAX;

/// Boxes without gaps, in an order of their own (a removal fills the hole with the last), found by proxy.
#[derive(Clone, Debug, Default)]
pub(super) struct Boxes {
    pub proxies: Vec<u32>,
    pub aabbs: Vec<Aabb>,
    /// By proxy: its place in the two lists above, or [`ABSENT`].
    slots: Vec<u32>,
}

impl Boxes {
    pub fn len(&self) -> usize {
        self.proxies.len()
    }

    #[inline]
    pub fn slot(&self, proxy: u32) -> Option<usize> {
        self.slots.get(proxy as usize).filter(|&&slot| slot != ABSENT).map(|&slot| slot as usize)
    }

    #[inline]
    pub fn contains(&self, proxy: u32) -> bool {
        self.slot(proxy).is_some()
    }

    /// The box of a proxy that is there.
    #[inline]
    pub fn aabb(&self, proxy: u32) -> Aabb {
        self.aabbs[self.slots[proxy as usize] as usize]
    }

    pub fn insert(&mut self, proxy: u32, aabb: &Aabb) {
        debug_assert!(aabb.is_valid() && proxy < 1 << 31 && !self.contains(proxy));
        let at = proxy as usize;
        if at >= self.slots.len() {
            self.slots.resize(at + 1, ABSENT);
        }
        self.slots[at] = self.proxies.len() as u32;
        self.proxies.push(proxy);
        self.aabbs.push(*aabb);
    }

    pub fn remove(&mut self, proxy: u32) {
        let slot = self.slot(proxy).expect("the proxy was inserted");
        self.slots[proxy as usize] = ABSENT;
        self.proxies.swap_remove(slot);
        self.aabbs.swap_remove(slot);
        if let Some(&last) = self.proxies.get(slot) {
            self.slots[last as usize] = slot as u32;
        }
    }

    pub fn update(&mut self, proxy: u32, aabb: &Aabb) {
        debug_assert!(aabb.is_valid());
        let slot = self.slot(proxy).expect("the proxy was inserted");
        self.aabbs[slot] = *aabb;
    }

    pub fn iter(&self) -> impl Iterator<Item = (u32, &Aabb)> {
        self.proxies.iter().copied().zip(&self.aabbs)
    }

    pub fn bounds(&self) -> Aabb {
        self.aabbs.iter().fold(Aabb::EMPTY, |all, b| all.union(b))
    }

    pub fn byte_count(&self) -> usize {
        self.aabbs.capacity() * size_of::<Aabb>()
            + (self.proxies.capacity() + self.slots.capacity()) * size_of::<u32>()
    }
}
