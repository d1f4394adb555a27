//! Trees that grow box by box \[Guttman 1984\]: insertion, overflow, removal. How a tree chooses and parts is its
//! [`Growth`].

use super::super::boxes::ABSENT;
use super::super::slab::Sweep;
use super::super::structure::Structure;
use super::{FAN, NONE, Node, Nodes};
use crate::math::{Aabb, Float};
use std::fmt::Debug;

/// Children of a node below the root, at least: 40 %, what Beckmann et al. found best, for Guttman's tree too.
pub(in super::super) const LEAST: usize = FAN * 2 / 5;

/// A child on its way into a node.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Entry {
    pub aabb: Aabb,
    pub child: u32,
}

/// How a tree grows.
pub(in super::super) trait Growth: Clone + Debug + Default + Send + Sync + 'static {
    /// How many children an overflowing node gives back to the tree, once a level and insertion, before it is
    /// parted; 0 for never.
    const REINSERTED: usize;

    /// The child of a node above the leaves that is to take a box in.
    fn choose(node: &Node, aabb: &Aabb) -> usize;

    /// Arranges the children of a full node and one more in two groups; returns the size of the first. Both hold
    /// [`LEAST`] or more.
    fn part(entries: &mut [Entry; FAN + 1]) -> usize;
}

/// A tree that is patched box by box.
#[derive(Clone, Debug, Default)]
pub(in super::super) struct Grown<G> {
    nodes: Nodes,
    /// By proxy: its node of level 0, or [`ABSENT`].
    places: Vec<u32>,
    len: usize,
    /// Entries that wait to be inserted, each at its level. Empty between calls.
    queue: Vec<(Entry, u32)>,
    growth: std::marker::PhantomData<G>,
}

impl<G: Growth> Grown<G> {
    fn set_child(&mut self, at: u32, entry: &Entry) {
        let node = self.nodes.node_mut(at);
        node.push(entry.child, &entry.aabb);
        self.link(entry.child, node_level(&self.nodes, at), at);
    }

    /// Tells a child of a node of this level where it is.
    fn link(&mut self, child: u32, level: u32, at: u32) {
        match level {
            0 => self.places[child as usize] = at,
            _ => self.nodes.node_mut(child).parent = at,
        }
    }

    /// Inserts what waits. `done` has a bit for each level at which this call has reinserted already.
    fn drain(&mut self) {
        let mut done = 0u32;
        while let Some((entry, level)) = self.queue.pop() {
            self.insert_at(&entry, level, &mut done);
        }
    }

    fn insert_at(&mut self, entry: &Entry, level: u32, done: &mut u32) {
        let mut at = match self.nodes.root {
            Some(root) => root,
            None => {
                let root = self.nodes.take(level);
                self.nodes.root = Some(root);
                root
            }
        };
        while self.nodes.node(at).level > level {
            let node = self.nodes.node_mut(at);
            let slot = G::choose(node, &entry.aabb);
            let grown = node.aabb(slot).union(&entry.aabb);
            node.set_aabb(slot, &grown);
            at = node.children[slot];
        }
        let mut entry = *entry;
        loop {
            if self.nodes.node(at).len() < FAN {
                self.set_child(at, &entry);
                self.tighten(at);
                return;
            }
            let Some(sibling) = self.overflow(at, &entry, done) else { return };
            let aabb = self.nodes.node(sibling).bounds();
            let level = self.nodes.node(at).level;
            let parent = self.nodes.node(at).parent;
            if parent == NONE {
                let root = self.nodes.take(level + 1);
                self.nodes.root = Some(root);
                let first = Entry { aabb: self.nodes.node(at).bounds(), child: at };
                self.set_child(root, &first);
                self.set_child(root, &Entry { aabb, child: sibling });
                return;
            }
            self.tighten_once(at);
            entry = Entry { aabb, child: sibling };
            at = parent;
        }
    }

    /// Makes room in a full node for one more: gives some children back to the queue (`None`), or parts the node
    /// and returns the new sibling.
    fn overflow(&mut self, at: u32, more: &Entry, done: &mut u32) -> Option<u32> {
        let node = self.nodes.node(at);
        let (level, is_root) = (node.level, node.parent == NONE);
        let mut entries: [Entry; FAN + 1] = std::array::from_fn(|slot| match slot {
            FAN => *more,
            _ => Entry { aabb: node.aabb(slot), child: node.children[slot] },
        });
        if G::REINSERTED > 0 && !is_root && *done >> level & 1 == 0 {
            *done |= 1 << level;
            let center = node.bounds().union(&more.aabb).center();
            let far = |e: &Entry| (e.aabb.center() - center).norm_squared();
            entries.sort_by(|a, b| far(a).total_cmp(&far(b)));
            let (kept, given) = entries.split_at(FAN + 1 - G::REINSERTED);
            self.refill(at, kept);
            self.tighten(at);
            // The nearest is popped first.
            self.queue.extend(given.iter().rev().map(|&entry| (entry, level)));
            return None;
        }
        let middle = G::part(&mut entries);
        let sibling = self.nodes.take(level);
        self.refill(at, &entries[..middle]);
        entries[middle..].iter().for_each(|entry| self.set_child(sibling, entry));
        Some(sibling)
    }

    /// Gives a node other children; it stays where it is.
    fn refill(&mut self, at: u32, entries: &[Entry]) {
        let node = self.nodes.node_mut(at);
        *node = Node { parent: node.parent, ..Node::new(node.level) };
        entries.iter().for_each(|entry| self.set_child(at, entry));
    }

    /// Makes the box of a node in its parent tight; returns the parent if that changed it.
    fn tighten_once(&mut self, at: u32) -> Option<u32> {
        let node = self.nodes.node(at);
        let (parent, bounds) = (node.parent, node.bounds());
        if parent == NONE {
            return None;
        }
        let above = self.nodes.node_mut(parent);
        let slot = above.slot_of(at);
        if above.aabb(slot) == bounds {
            return None;
        }
        above.set_aabb(slot, &bounds);
        Some(parent)
    }

    /// Makes the boxes above a node tight.
    fn tighten(&mut self, mut at: u32) {
        while let Some(above) = self.tighten_once(at) {
            at = above;
        }
    }

    /// Takes a slot out of a node, and dissolves nodes that hold too little; what they held waits in the queue.
    fn take_out(&mut self, mut at: u32, mut slot: usize) {
        loop {
            let node = self.nodes.node_mut(at);
            node.swap_remove(slot);
            let (parent, level, len) = (node.parent, node.level, node.len());
            if parent == NONE {
                if len == 0 {
                    self.nodes.free.push(at);
                    self.nodes.root = None;
                }
                break;
            }
            if len >= LEAST {
                self.tighten(at);
                break;
            }
            let node = *node;
            let rest = (0..len).map(|k| (Entry { aabb: node.aabb(k), child: node.children[k] }, level));
            self.queue.extend(rest);
            self.nodes.free.push(at);
            slot = self.nodes.node(parent).slot_of(at);
            at = parent;
        }
    }

    /// A root of one child gives way to it.
    fn lower_root(&mut self) {
        while let Some(root) = self.nodes.root
            && let node = self.nodes.node(root)
            && node.level > 0
            && node.len() == 1
        {
            let child = node.children[0];
            self.nodes.free.push(root);
            self.nodes.node_mut(child).parent = NONE;
            self.nodes.root = Some(child);
        }
    }

    #[cfg(test)]
    pub fn validate(&self) {
        assert_eq!(self.nodes.validate(true), self.len);
        assert_eq!(self.places.iter().filter(|&&p| p != ABSENT).count(), self.len);
    }
}

fn node_level(nodes: &Nodes, at: u32) -> u32 {
    nodes.node(at).level
}

impl<G: Growth> Structure for Grown<G> {
    const JOIN_SHARE: usize = 4;

    fn contains(&self, proxy: u32) -> bool {
        self.places.get(proxy as usize).is_some_and(|&place| place != ABSENT)
    }

    fn aabb(&self, proxy: u32) -> Aabb {
        let node = self.nodes.node(self.places[proxy as usize]);
        node.aabb(node.slot_of(proxy))
    }

    fn len(&self) -> usize {
        self.len
    }

    fn insert(&mut self, proxy: u32, aabb: &Aabb) {
        debug_assert!(aabb.is_valid() && proxy < 1 << 31 && !self.contains(proxy));
        let at = proxy as usize;
        if at >= self.places.len() {
            self.places.resize(at + 1, ABSENT);
        }
        self.len += 1;
        self.queue.push((Entry { aabb: *aabb, child: proxy }, 0));
        self.drain();
    }

    fn remove(&mut self, proxy: u32) {
        assert!(self.contains(proxy), "the proxy was inserted");
        let at = std::mem::replace(&mut self.places[proxy as usize], ABSENT);
        self.len -= 1;
        self.take_out(at, self.nodes.node(at).slot_of(proxy));
        // What hung in a dissolved node goes in again before the root may sink below its level, highest first.
        self.queue.sort_unstable_by_key(|&(_, level)| level);
        self.drain();
        self.lower_root();
    }

    /// A box that stays within its node is replaced there; another goes through the root again.
    fn update(&mut self, proxy: u32, aabb: &Aabb) {
        debug_assert!(aabb.is_valid());
        assert!(self.contains(proxy), "the proxy was inserted");
        let at = self.places[proxy as usize];
        let node = self.nodes.node(at);
        let parent = node.parent;
        let stays = parent == NONE || {
            let above = self.nodes.node(parent);
            above.aabb(above.slot_of(at)).contains(aabb)
        };
        if stays {
            let node = self.nodes.node_mut(at);
            let slot = node.slot_of(proxy);
            node.set_aabb(slot, aabb);
            self.tighten(at);
        } else {
            self.remove(proxy);
            self.insert(proxy, aabb);
        }
    }

    fn refresh(&mut self) {}

    /// Puts every box in anew.
    fn rebuild(&mut self) {
        let mut entries = std::mem::take(&mut self.queue);
        for (proxy, &at) in self.places.iter().enumerate().filter(|&(_, &at)| at != ABSENT) {
            let node = self.nodes.node(at);
            let aabb = node.aabb(node.slot_of(proxy as u32));
            entries.push((Entry { aabb, child: proxy as u32 }, 0));
        }
        self.nodes.clear();
        for entry in &entries {
            self.queue.push(*entry);
            self.drain();
        }
    }

    fn within(&mut self, meet: &mut impl FnMut(u32, u32)) {
        self.nodes.within(meet);
    }

    fn between(&mut self, other: &mut Self, meet: &mut impl FnMut(u32, u32)) {
        self.nodes.between(&other.nodes, meet);
    }

    fn query(&self, aabb: &Aabb, visit: &mut impl FnMut(u32) -> bool) -> bool {
        self.nodes.query(aabb, visit)
    }

    fn cast(&self, sweep: &Sweep, max: Float, visit: &mut dyn FnMut(u32, Float) -> Float) -> Float {
        self.nodes.cast(sweep, max, visit)
    }

    fn bounds(&self) -> Aabb {
        self.nodes.root.map_or(Aabb::EMPTY, |root| self.nodes.node(root).bounds())
    }

    fn nodes_and_height(&self) -> (usize, usize) {
        self.nodes.nodes_and_height()
    }

    fn byte_count(&self) -> usize {
        self.nodes.byte_count()
            + self.places.capacity() * size_of::<u32>()
            + self.queue.capacity() * size_of::<(Entry, u32)>()
    }
}
