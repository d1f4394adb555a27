//! What a structure over boxes must be able to do, for [`Whole`] and [`Split`](super::split::Split) to make a broad
//! phase of it. A structure knows neither layers nor what moved.

use super::slab::Sweep;
use super::{BroadPhase, BroadPhaseStats, Layer};
use crate::math::{Aabb, Float, Vec3};
use std::fmt::Debug;

/// A set of boxes that can be asked what overlaps. All answers are of the boxes as they are now.
pub(super) trait Structure: Clone + Debug + Default + Send + Sync + 'static {
    /// Pairs are found for all boxes at once when more than one in so many moved, otherwise by one query each.
    const JOIN_SHARE: usize;

    fn contains(&self, proxy: u32) -> bool;
    fn aabb(&self, proxy: u32) -> Aabb;
    fn len(&self) -> usize;

    fn insert(&mut self, proxy: u32, aabb: &Aabb);
    fn remove(&mut self, proxy: u32);
    fn update(&mut self, proxy: u32, aabb: &Aabb);

    /// Where a proxy stands: questions asked in this order find in the cache what the last one read.
    fn place_of(&self, proxy: u32) -> u32 {
        proxy
    }

    /// Takes in what changed. `within` and `between` are only called right after it.
    fn refresh(&mut self);
    /// Arranges everything anew.
    fn rebuild(&mut self);

    /// Calls `meet` with the two proxies of every overlapping pair, each pair once.
    fn within(&mut self, meet: &mut impl FnMut(u32, u32));
    /// Calls `meet` with every overlapping pair of one box here and one of `other`.
    fn between(&mut self, other: &mut Self, meet: &mut impl FnMut(u32, u32));

    /// Visits what overlaps `aabb` until told to stop; returns whether it was not.
    fn query(&self, aabb: &Aabb, visit: &mut impl FnMut(u32) -> bool) -> bool;
    /// Visits what `sweep` meets and returns the fraction that the visitor left of it.
    fn cast(&self, sweep: &Sweep, max: Float, visit: &mut dyn FnMut(u32, Float) -> Float) -> Float;

    fn bounds(&self) -> Aabb;
    /// Inner nodes, and those on the longest way down.
    fn nodes_and_height(&self) -> (usize, usize) {
        (0, 0)
    }
    fn byte_count(&self) -> usize;
}

/// What is known of the proxies of a `find_pairs`.
#[derive(Clone, Debug, Default)]
pub(super) struct Marks(Vec<u8>);

const MOVED: u8 = 1;
const STATIC: u8 = 2;

impl Marks {
    pub fn set_layer(&mut self, proxy: u32, layer: Layer) {
        let at = proxy as usize;
        if at >= self.0.len() {
            self.0.resize(at + 1, 0);
        }
        self.0[at] = if layer == Layer::Static { STATIC } else { 0 };
    }

    pub fn mark(&mut self, moved: &[u32]) {
        moved.iter().for_each(|&proxy| self.0[proxy as usize] |= MOVED);
    }

    pub fn unmark(&mut self, moved: &[u32]) {
        moved.iter().for_each(|&proxy| self.0[proxy as usize] &= !MOVED);
    }

    /// Whether a pair of overlapping boxes is to be reported: one moved, and one is not static.
    #[inline(always)]
    pub fn accept(&self, a: u32, b: u32) -> bool {
        let (a, b) = (self.0[a as usize], self.0[b as usize]);
        (a | b) & MOVED != 0 && a & b & STATIC == 0
    }

    /// The same for what a query of the moved `proxy` met: two moved see each other twice, the lower reports it.
    #[inline(always)]
    pub fn accept_met(&self, proxy: u32, met: u32) -> bool {
        let (a, b) = (self.0[proxy as usize], self.0[met as usize]);
        (b & MOVED == 0 || proxy < met) && a & b & STATIC == 0
    }

    pub fn byte_count(&self) -> usize {
        self.0.capacity()
    }
}

#[inline(always)]
pub(super) fn ordered(a: u32, b: u32) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// Brings pairs into order. As one number a pair is compared in one instruction.
pub(super) fn sort_pairs(pairs: &mut [[u32; 2]]) {
    pairs.sort_unstable_by_key(|&[a, b]| u64::from(a) << 32 | u64::from(b));
}

/// A broad phase of one structure that holds what stands and what moves.
#[derive(Clone, Debug, Default)]
pub(super) struct Whole<S> {
    set: S,
    marks: Marks,
    /// Scratch: who moved, after where they stand.
    order: Vec<[u32; 2]>,
}

impl<S: Structure> BroadPhase for Whole<S> {
    fn insert(&mut self, proxy: u32, aabb: &Aabb, layer: Layer) {
        self.set.insert(proxy, aabb);
        self.marks.set_layer(proxy, layer);
    }

    fn remove(&mut self, proxy: u32) {
        self.set.remove(proxy);
    }

    fn update(&mut self, proxy: u32, aabb: &Aabb) {
        self.set.update(proxy, aabb);
    }

    fn set_layer(&mut self, proxy: u32, layer: Layer) {
        assert!(self.set.contains(proxy), "the proxy was inserted");
        self.marks.set_layer(proxy, layer);
    }

    fn find_pairs(&mut self, moved: &[u32], out: &mut Vec<[u32; 2]>) {
        out.clear();
        let Self { set, marks, order } = self;
        set.refresh();
        marks.mark(moved);
        if moved.len() * S::JOIN_SHARE > set.len() {
            set.within(&mut |a, b| {
                if marks.accept(a, b) {
                    out.push(ordered(a, b));
                }
            });
        } else {
            order.clear();
            order.extend(moved.iter().map(|&proxy| [set.place_of(proxy), proxy]));
            order.sort_unstable();
            for &[_, proxy] in &*order {
                set.query(&set.aabb(proxy), &mut |met| {
                    if marks.accept_met(proxy, met) && met != proxy {
                        out.push(ordered(proxy, met));
                    }
                    true
                });
            }
        }
        marks.unmark(moved);
        sort_pairs(out);
    }

    fn query(&self, aabb: &Aabb, visit: &mut dyn FnMut(u32) -> bool) {
        self.set.query(aabb, &mut |proxy| visit(proxy));
    }

    fn cast(
        &self,
        box_half: Vec3,
        origin: Vec3,
        translation: Vec3,
        max_fraction: Float,
        visit: &mut dyn FnMut(u32, Float) -> Float,
    ) {
        let sweep = Sweep::new(box_half, origin, translation, max_fraction);
        self.set.cast(&sweep, max_fraction, visit);
    }

    fn rebuild_static(&mut self) {
        self.set.rebuild();
    }

    fn bounds(&self) -> Aabb {
        self.set.bounds()
    }

    fn stats(&self) -> BroadPhaseStats {
        let (nodes, height) = self.set.nodes_and_height();
        BroadPhaseStats { proxies: self.set.len(), nodes, height }
    }

    fn byte_count(&self) -> usize {
        self.set.byte_count() + self.marks.byte_count() + self.order.capacity() * size_of::<[u32; 2]>()
    }

    fn clone_box(&self) -> Box<dyn BroadPhase> {
        Box::new(self.clone())
    }
}
