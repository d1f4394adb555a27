//! Trees that grow box by box \[Guttman 1984\]: insertion, overflow, removal. How a tree chooses and parts is its
//! [`Growth`], which may also pack it anew once it has worn out.

use super::super::boxes::ABSENT;
use super::super::slab::Sweep;
use super::super::structure::Structure;
use super::pack::{Builder, Item, Packing};
use super::{Batch, FAN, NONE, Node, Nodes};
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

    /// Packs a worn tree anew, where a tree has a way to. Such a tree is also more patient with what moves.
    const PACK: Option<fn(&mut Builder, &mut [Item]) -> u32> = None;
}

/// A tree that grows as `G` does and is packed as `P` does when it has worn out.
#[derive(Clone, Debug, Default)]
pub(in super::super) struct Repacked<G, P>(std::marker::PhantomData<(G, P)>);

impl<G: Growth, P: Packing> Growth for Repacked<G, P> {
    const REINSERTED: usize = G::REINSERTED;
    const PACK: Option<fn(&mut Builder, &mut [Item]) -> u32> = Some(P::pack);

    fn choose(node: &Node, aabb: &Aabb) -> usize {
        G::choose(node, aabb)
    }

    fn part(entries: &mut [Entry; FAN + 1]) -> usize {
        G::part(entries)
    }
}

/// A tree that can be packed is, after this many updates a box.
const WEAR_LIMIT: usize = 4;

/// An insertion wears like this many updates: a scene built up box by box is packed in its first step.
const INSERTION_WEAR: usize = WEAR_LIMIT + 1;

/// How large a node may become by boxes that leave the node above, as a part of that one's size.
const SMALLER: Float = 0.75;

/// Boxes of a batch ask their questions together if there is one for so many in the tree they ask.
const BATCH_SHARE: usize = 32;

/// A tree that is patched box by box.
#[derive(Clone, Debug, Default)]
pub(in super::super) struct Grown<G> {
    nodes: Nodes,
    /// By proxy: [`FAN`] times its node of level 0, plus its slot there; or [`ABSENT`].
    places: Vec<u32>,
    /// Nodes of level 0 in which a box was replaced since the last refresh.
    stale: Vec<u32>,
    len: usize,
    /// Entries that wait to be inserted, each at its level. Empty between calls.
    queue: Vec<(Entry, u32)>,
    /// Updates and insertions since the tree was packed.
    wear: usize,
    /// Scratch for packing: boxes and their proxies.
    proxies: Vec<u32>,
    aabbs: Vec<Aabb>,
    items: Vec<Item>,
    growth: std::marker::PhantomData<G>,
}

impl<G: Growth> Grown<G> {
    /// Picks a proxy for the next [`hand_over`](Self::hand_over).
    pub fn pick(&mut self, proxy: u32) {
        let (at, slot) = self.place(proxy);
        self.nodes.pick(at, slot as u32);
    }

    /// Gives a batch the boxes of the picked proxies, and no others.
    pub fn hand_over(&mut self, batch: &mut Batch) {
        batch.clear();
        self.nodes.hand_over(batch);
    }

    /// Calls `meet` with every overlapping pair of one box of a batch and one of this tree.
    pub fn meet(&self, batch: &Batch, meet: &mut impl FnMut(u32, u32)) {
        batch.meet(&self.nodes, BATCH_SHARE, self.len, meet);
    }

    fn set_child(&mut self, at: u32, entry: &Entry) {
        let node = self.nodes.node_mut(at);
        let (level, slot) = (node.level, node.len);
        node.push(entry.child, &entry.aabb);
        node.bounds = node.bounds.union(&entry.aabb);
        self.link(entry.child, level, at, slot);
    }

    /// Tells a child of a node of this level where it is.
    fn link(&mut self, child: u32, level: u32, at: u32, slot: u32) {
        if level == 0 {
            self.places[child as usize] = at * FAN as u32 + slot;
        } else {
            let below = self.nodes.node_mut(child);
            (below.parent, below.slot) = (at, slot);
        }
    }

    /// The node and the slot of a proxy.
    #[inline]
    fn place(&self, proxy: u32) -> (u32, usize) {
        let place = self.places[proxy as usize];
        (place / FAN as u32, place as usize % FAN)
    }

    fn free(&mut self, at: u32) {
        // It may still be listed as stale.
        self.nodes.node_mut(at).stale = false;
        self.nodes.free.push(at);
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
            node.bounds = node.bounds.union(&entry.aabb);
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
            let aabb = self.nodes.node(sibling).bounds;
            let level = self.nodes.node(at).level;
            let parent = self.nodes.node(at).parent;
            if parent == NONE {
                let root = self.nodes.take(level + 1);
                self.nodes.root = Some(root);
                let first = Entry { aabb: self.nodes.node(at).bounds, child: at };
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
            let center = node.tight_bounds().union(&more.aabb).center();
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
        let Node { parent, slot, stale, level, .. } = *node;
        *node = Node { parent, slot, stale, ..Node::new(level) };
        entries.iter().for_each(|entry| self.set_child(at, entry));
    }

    /// Makes the box of a node tight, in its parent, too; returns the parent if that changed anything there.
    fn tighten_once(&mut self, at: u32) -> Option<u32> {
        let node = self.nodes.node_mut(at);
        node.bounds = node.tight_bounds();
        let (parent, slot, bounds) = (node.parent, node.slot as usize, node.bounds);
        if parent == NONE {
            return None;
        }
        let above = self.nodes.node_mut(parent);
        if above.aabb(slot) == bounds {
            return None;
        }
        above.set_aabb(slot, &bounds);
        Some(parent)
    }

    /// Makes the boxes of a node and of all above it tight. It does not stop where nothing changes: a box further up
    /// may be too large since an update that waits for the next refresh.
    fn tighten(&mut self, mut at: u32) {
        while at != NONE {
            self.tighten_once(at);
            at = self.nodes.node(at).parent;
        }
    }

    /// Makes tight whatever is above a replaced box, each node once: all of a level before those above it.
    fn tighten_stale(&mut self) {
        let mut stale = std::mem::take(&mut self.stale);
        let mut next = 0;
        while next < stale.len() {
            let at = stale[next];
            next += 1;
            if std::mem::take(&mut self.nodes.node_mut(at).stale)
                && let Some(above) = self.tighten_once(at)
                && !std::mem::replace(&mut self.nodes.node_mut(above).stale, true)
            {
                stale.push(above);
            }
        }
        stale.clear();
        self.stale = stale;
    }

    /// Takes a slot out of a node, and dissolves nodes that hold too little; what they held waits in the queue.
    fn take_out(&mut self, mut at: u32, mut slot: usize) {
        loop {
            let node = self.nodes.node_mut(at);
            node.swap_remove(slot);
            let (parent, level, len) = (node.parent, node.level, node.len());
            if slot < len {
                let moved = node.children[slot];
                self.link(moved, level, at, slot as u32);
            }
            if len >= LEAST || (parent == NONE && len > 0) {
                self.tighten(at);
                return;
            }
            if parent == NONE {
                self.free(at);
                self.nodes.root = None;
                return;
            }
            let node = *self.nodes.node(at);
            let rest = (0..len).map(|k| (Entry { aabb: node.aabb(k), child: node.children[k] }, level));
            self.queue.extend(rest);
            self.free(at);
            (at, slot) = (parent, node.slot as usize);
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
            self.free(root);
            self.nodes.node_mut(child).parent = NONE;
            self.nodes.root = Some(child);
        }
    }

    /// Lists all proxies and boxes, in the order of the tree, so that neighbours stay together in memory.
    fn list(&mut self) {
        self.proxies.clear();
        self.aabbs.clear();
        let mut stack = std::mem::take(&mut self.queue);
        let blank = |child| (Entry { aabb: Aabb::EMPTY, child }, 0);
        stack.extend(self.nodes.root.map(blank));
        while let Some((Entry { child: at, .. }, _)) = stack.pop() {
            let node = self.nodes.node(at);
            for slot in 0..node.len() {
                if node.level > 0 {
                    stack.push(blank(node.children[slot]));
                } else {
                    self.proxies.push(node.children[slot]);
                    self.aabbs.push(node.aabb(slot));
                }
            }
        }
        self.queue = stack;
    }

    fn pack(&mut self, pack: fn(&mut Builder, &mut [Item]) -> u32) {
        let Self { nodes, proxies, aabbs, items, .. } = self;
        items.clear();
        items.extend((0..).zip(&*aabbs).map(|(slot, aabb)| Item::new(slot, aabb)));
        if !items.is_empty() {
            nodes.root = Some(pack(&mut Builder { nodes, proxies, aabbs }, items));
        }
        for at in 0..self.nodes.nodes.len() as u32 {
            let node = self.nodes.node(at);
            let (level, children, len) = (node.level, node.children, node.len());
            self.nodes.node_mut(at).bounds = self.nodes.node(at).tight_bounds();
            (0..).zip(&children[..len]).for_each(|(slot, &child)| self.link(child, level, at, slot));
        }
    }

    /// Whether a box may take the place of the one in node `at`. Where a worn tree is packed again it may leave its
    /// node, which then grows, but not beyond the node above unless it stays [`SMALLER`] than that. As that grows with
    /// it, the limit is what else is in there.
    fn stays(&self, at: u32, aabb: &Aabb) -> bool {
        let node = self.nodes.node(at);
        if node.parent == NONE || node.bounds.contains(aabb) {
            return true;
        }
        let above = &self.nodes.node(node.parent).bounds;
        let size = |b: &Aabb| (b.upper - b.lower).sum();
        G::PACK.is_some() && (above.contains(aabb) || size(&node.bounds.union(aabb)) <= SMALLER * size(above))
    }

    /// Replaces a box where it is; what is above grows to hold it, and is made tight by the next refresh.
    fn replace(&mut self, mut at: u32, slot: usize, aabb: &Aabb) {
        let node = self.nodes.node_mut(at);
        node.set_aabb(slot, aabb);
        if !std::mem::replace(&mut node.stale, true) {
            self.stale.push(at);
        }
        while at != NONE && !self.nodes.node(at).bounds.contains(aabb) {
            let node = self.nodes.node_mut(at);
            node.bounds = node.bounds.union(aabb);
            let (parent, slot, bounds) = (node.parent, node.slot as usize, node.bounds);
            if parent != NONE {
                self.nodes.node_mut(parent).set_aabb(slot, &bounds);
            }
            at = parent;
        }
    }

    #[cfg(test)]
    pub fn validate(&self) {
        assert!(self.nodes.nodes.iter().all(|node| node.picked == 0));
        assert_eq!(self.nodes.validate(true, self.stale.is_empty()), self.len);
        assert_eq!(self.places.iter().filter(|&&p| p != ABSENT).count(), self.len);
    }
}

impl<G: Growth> Structure for Grown<G> {
    const JOIN_SHARE: usize = 4;

    fn contains(&self, proxy: u32) -> bool {
        self.places.get(proxy as usize).is_some_and(|&place| place != ABSENT)
    }

    fn aabb(&self, proxy: u32) -> Aabb {
        let (at, slot) = self.place(proxy);
        self.nodes.node(at).aabb(slot)
    }

    fn len(&self) -> usize {
        self.len
    }

    fn place_of(&self, proxy: u32) -> u32 {
        self.places[proxy as usize]
    }

    fn insert(&mut self, proxy: u32, aabb: &Aabb) {
        debug_assert!(aabb.is_valid() && proxy < 1 << 31 && !self.contains(proxy));
        let at = proxy as usize;
        if at >= self.places.len() {
            self.places.resize(at + 1, ABSENT);
        }
        self.len += 1;
        self.wear += INSERTION_WEAR;
        self.queue.push((Entry { aabb: *aabb, child: proxy }, 0));
        self.drain();
    }

    fn remove(&mut self, proxy: u32) {
        assert!(self.contains(proxy), "the proxy was inserted");
        let (at, slot) = self.place(proxy);
        self.places[proxy as usize] = ABSENT;
        self.len -= 1;
        self.take_out(at, slot);
        // What hung in a dissolved node goes in again before the root may sink below its level, highest first.
        self.queue.sort_unstable_by_key(|&(_, level)| level);
        self.drain();
        self.lower_root();
    }

    /// A box that stays within its node is replaced there; another goes through the root again.
    fn update(&mut self, proxy: u32, aabb: &Aabb) {
        debug_assert!(aabb.is_valid());
        assert!(self.contains(proxy), "the proxy was inserted");
        let (at, slot) = self.place(proxy);
        self.wear += 1;
        if self.stays(at, aabb) {
            self.replace(at, slot, aabb);
        } else {
            self.remove(proxy);
            self.insert(proxy, aabb);
        }
    }

    fn refresh(&mut self) {
        if G::PACK.is_some() && self.wear > WEAR_LIMIT * self.len {
            self.rebuild();
        } else {
            self.tighten_stale();
        }
    }

    /// Packs the tree, or puts every box in anew.
    fn rebuild(&mut self) {
        self.list();
        self.nodes.clear();
        self.stale.clear();
        self.wear = 0;
        if let Some(pack) = G::PACK {
            self.pack(pack);
            return;
        }
        for k in 0..self.proxies.len() {
            self.queue.push((Entry { aabb: self.aabbs[k], child: self.proxies[k] }, 0));
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
        self.nodes.root.map_or(Aabb::EMPTY, |root| self.nodes.node(root).tight_bounds())
    }

    fn nodes_and_height(&self) -> (usize, usize) {
        self.nodes.nodes_and_height()
    }

    fn byte_count(&self) -> usize {
        self.nodes.byte_count()
            + (self.places.capacity() + self.stale.capacity()) * size_of::<u32>()
            + self.queue.capacity() * size_of::<(Entry, u32)>()
            + self.proxies.capacity() * size_of::<u32>()
            + self.aabbs.capacity() * size_of::<Aabb>()
            + self.items.capacity() * size_of::<Item>()
    }
}
