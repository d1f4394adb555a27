//! Trees that are built at once from all boxes. How they are laid out is their [`Packing`].
//!
//! A packed tree is not patched: the next `find_pairs` after a change builds it anew, in the memory of the last one.
//! Until then a box that came or changed waits in a list that queries look through one by one, and what the tree says
//! of it no longer counts.

use super::super::boxes::{ABSENT, Boxes};
use super::super::slab::Sweep;
use super::super::structure::Structure;
use super::{FAN, Nodes};
use crate::math::{Aabb, Float};
use std::cmp::Ordering;
use std::fmt::Debug;

/// Something to be packed: a box by its centre, or a node of the level below.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Item {
    /// Twice the centre.
    pub center: [Float; 3],
    /// Which box, or which node.
    pub index: u32,
}

impl Item {
    pub(super) fn new(index: u32, aabb: &Aabb) -> Self {
        let c = aabb.lower + aabb.upper;
        Self { center: [c.x, c.y, c.z], index }
    }
}

/// How a tree is laid out.
pub(in super::super) trait Packing: Clone + Debug + Default + Send + Sync + 'static {
    /// Builds the tree over `items` (one at least, in any order) and returns its root.
    fn pack(builder: &mut Builder, items: &mut [Item]) -> u32;
}

/// What a [`Packing`] builds with.
pub(in super::super) struct Builder<'a> {
    pub(super) nodes: &'a mut Nodes,
    pub(super) proxies: &'a [u32],
    pub(super) aabbs: &'a [Aabb],
}

impl Builder<'_> {
    /// A node of level 0 over up to [`FAN`] boxes.
    pub fn leaf(&mut self, items: &[Item]) -> u32 {
        let at = self.nodes.take(0);
        let node = self.nodes.node_mut(at);
        for item in items {
            let slot = item.index as usize;
            node.push(self.proxies[slot], &self.aabbs[slot]);
        }
        at
    }

    /// A node of a higher level, empty yet.
    pub fn inner(&mut self, level: u32) -> u32 {
        self.nodes.take(level)
    }

    /// Hangs a finished node below another.
    pub fn hang(&mut self, at: u32, child: u32) {
        let bounds = self.nodes.node(child).tight_bounds();
        self.nodes.node_mut(at).push(child, &bounds);
    }

    /// A finished node as an item.
    pub fn item(&self, node: u32) -> Item {
        Item::new(node, &self.nodes.node(node).tight_bounds())
    }
}

/// Arranges `items` along an axis so that everything before each of `ends` (ascending) comes before what is after
/// it. Only as much is sorted as that takes.
pub(in super::super) fn cut(items: &mut [Item], axis: usize, ends: &[usize]) {
    match axis {
        0 => cut_along::<0>(items, 0, ends),
        1 => cut_along::<1>(items, 0, ends),
        _ => cut_along::<2>(items, 0, ends),
    }
}

fn cut_along<const AXIS: usize>(items: &mut [Item], from: usize, ends: &[usize]) {
    // The end nearest to the middle first: both sides then halve.
    let ends = match ends.iter().position(|&end| end > from) {
        Some(first) => &ends[first..],
        None => return,
    };
    let inside = ends.partition_point(|&end| end < from + items.len());
    let ends = &ends[..inside];
    if ends.is_empty() {
        return;
    }
    let middle = ends.len() / 2;
    let at = ends[middle] - from;
    items.select_nth_unstable_by(at, |a, b| {
        a.center[AXIS].partial_cmp(&b.center[AXIS]).unwrap_or(Ordering::Equal)
    });
    let (left, right) = items.split_at_mut(at);
    cut_along::<AXIS>(left, from, &ends[..middle]);
    cut_along::<AXIS>(right, from + at, &ends[middle + 1..]);
}

/// A tree that is built at once.
#[derive(Clone, Debug, Default)]
pub(in super::super) struct Packed<P> {
    boxes: Boxes,
    nodes: Nodes,
    /// Proxies that came or changed since the tree was built.
    pending: Vec<u32>,
    /// By proxy: where it waits; [`BUILT`] when the tree is right about it; [`ABSENT`] when it is not there.
    waits: Vec<u32>,
    changed: bool,
    /// Scratch of the builder.
    items: Vec<Item>,
    packing: std::marker::PhantomData<P>,
}

const BUILT: u32 = ABSENT - 1;

impl<P: Packing> Packed<P> {
    fn wait(&mut self, proxy: u32) {
        let at = proxy as usize;
        if at >= self.waits.len() {
            self.waits.resize(at + 1, ABSENT);
        }
        if self.waits[at] >= BUILT {
            self.waits[at] = self.pending.len() as u32;
            self.pending.push(proxy);
        }
        self.changed = true;
    }

    #[cfg(test)]
    pub fn validate(&self) {
        if !self.changed {
            assert_eq!(self.nodes.validate(false, true), self.boxes.len());
        }
    }
}

impl<P: Packing> Structure for Packed<P> {
    const JOIN_SHARE: usize = 4;

    fn contains(&self, proxy: u32) -> bool {
        self.boxes.contains(proxy)
    }

    fn aabb(&self, proxy: u32) -> Aabb {
        self.boxes.aabb(proxy)
    }

    fn len(&self) -> usize {
        self.boxes.len()
    }

    fn insert(&mut self, proxy: u32, aabb: &Aabb) {
        self.boxes.insert(proxy, aabb);
        self.wait(proxy);
    }

    fn remove(&mut self, proxy: u32) {
        self.boxes.remove(proxy);
        let place = std::mem::replace(&mut self.waits[proxy as usize], ABSENT);
        if place < BUILT {
            self.pending.swap_remove(place as usize);
            if let Some(&last) = self.pending.get(place as usize) {
                self.waits[last as usize] = place;
            }
        }
        self.changed = true;
    }

    fn update(&mut self, proxy: u32, aabb: &Aabb) {
        self.boxes.update(proxy, aabb);
        self.wait(proxy);
    }

    fn refresh(&mut self) {
        if self.changed {
            self.rebuild();
        }
    }

    fn rebuild(&mut self) {
        let Self { boxes, nodes, pending, waits, changed, items, .. } = self;
        pending.drain(..).for_each(|proxy| waits[proxy as usize] = BUILT);
        *changed = false;
        items.clear();
        items.extend((0..).zip(&boxes.aabbs).map(|(slot, aabb)| Item::new(slot, aabb)));
        nodes.clear();
        // Nodes are all but full: growing step by step would touch more memory than the tree takes.
        nodes.nodes.reserve(items.len().div_ceil(FAN - 2));
        if !items.is_empty() {
            let mut builder = Builder { nodes: &mut *nodes, proxies: &boxes.proxies, aabbs: &boxes.aabbs };
            let root = P::pack(&mut builder, items);
            nodes.root = Some(root);
        }
    }

    fn within(&mut self, meet: &mut impl FnMut(u32, u32)) {
        self.nodes.within(meet);
    }

    fn between(&mut self, other: &mut Self, meet: &mut impl FnMut(u32, u32)) {
        self.nodes.between(&other.nodes, meet);
    }

    fn query(&self, aabb: &Aabb, visit: &mut impl FnMut(u32) -> bool) -> bool {
        if !self.changed {
            return self.nodes.query(aabb, visit);
        }
        self.nodes.query(aabb, &mut |proxy| self.waits[proxy as usize] != BUILT || visit(proxy))
            && self.pending.iter().all(|&proxy| !self.boxes.aabb(proxy).overlaps(aabb) || visit(proxy))
    }

    fn cast(&self, sweep: &Sweep, max: Float, visit: &mut dyn FnMut(u32, Float) -> Float) -> Float {
        let mut max = max;
        for &proxy in &self.pending {
            if sweep.entry(&self.boxes.aabb(proxy), max).is_some() {
                max = max.min(visit(proxy, max));
                if max <= 0.0 {
                    return 0.0;
                }
            }
        }
        self.nodes.cast(sweep, max, &mut |proxy, max| match self.waits[proxy as usize] {
            BUILT => visit(proxy, max),
            _ => max,
        })
    }

    fn bounds(&self) -> Aabb {
        self.boxes.bounds()
    }

    fn nodes_and_height(&self) -> (usize, usize) {
        self.nodes.nodes_and_height()
    }

    fn byte_count(&self) -> usize {
        self.boxes.byte_count()
            + self.nodes.byte_count()
            + (self.pending.capacity() + self.waits.capacity()) * size_of::<u32>()
            + self.items.capacity() * size_of::<Item>()
    }
}

/// The levels of nodes a tree needs for so many boxes, the lowest of them 0.
pub(in super::super) fn top_level(count: usize) -> u32 {
    let (mut level, mut room) = (0, FAN);
    while room < count {
        room = room.saturating_mul(FAN);
        level += 1;
    }
    level
}

#[cfg(test)]
mod tests {
    use super::super::super::random::Random;
    use super::*;

    #[test]
    fn cuts_part_as_a_full_sort_would() {
        let mut random = Random::new(3);
        for count in [1, 2, 17, 100, 1000] {
            for axis in 0..3 {
                let mut items: Vec<Item> = (0..count)
                    .map(|index| Item { center: [0; 3].map(|_| random.below(50) as Float), index })
                    .collect();
                let mut ends: Vec<usize> = (0..9).map(|_| random.below(count + 1) as usize).collect();
                ends.sort_unstable();
                ends.dedup();
                cut(&mut items, axis, &ends);
                let mut sorted: Vec<_> = items.iter().map(|item| item.center[axis]).collect();
                sorted.sort_by(Float::total_cmp);
                for &end in &ends {
                    let largest = items[..end].iter().map(|i| i.center[axis]).fold(-1.0, Float::max);
                    assert!(end == 0 || largest == sorted[end - 1]);
                }
            }
        }
    }

    #[test]
    fn a_tree_is_as_high_as_it_must_be() {
        for (count, level) in [(1, 0), (FAN, 0), (FAN + 1, 1), (FAN * FAN, 1), (FAN * FAN + 1, 2)] {
            assert_eq!(top_level(count), level);
        }
    }
}
