//! Broad phase: which pairs of shapes are near enough to touch, judged by their boxes alone.
//!
//! A *proxy* is the number of a shape, small and dense from 0. It comes with a fat box: the shape's box grown by
//! a margin, so that a body must move by more than the margin before its proxy is updated. Fat boxes, the list
//! of proxies that moved and the set of known pairs belong to the caller; this room knows boxes only.
//!
//! | variant | idea | from | cost of a step | when | where it fails |
//! |---|---|---|---|---|---|
//! | [`BruteForce`] | every moved box against every box | – | moved × all | oracle of the tests; a few dozen boxes | quadratic |
//! | [`DynamicBvh`] | two binary trees of boxes, static and moving, patched where boxes move | \[Catto GDC19\], \[Bittner 2013\], \[Wald 2007\] | (moved + pairs) × log all | default | boxes that all contain each other make it deep |
//!
//! Every variant reports the same pairs in the same order: sorted, unique, complete. No list is ever cut short.

mod brute_force;
mod bvh;
mod dynamic_bvh;
mod pair_set;
mod slab;

#[cfg(test)]
mod conformance;
#[cfg(test)]
mod random;

use crate::math::{Aabb, Float, Vec3};
use std::fmt::Debug;

pub use brute_force::BruteForce;
pub use dynamic_bvh::DynamicBvh;
pub use pair_set::PairSet;

/// Which broad phase a world uses. The numbers are part of the C ABI.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum BroadPhaseKind {
    /// The engine chooses: today [`BroadPhaseKind::DynamicBvh`].
    #[default]
    Auto = 0,
    /// [`BruteForce`].
    BruteForce = 1,
    /// [`DynamicBvh`].
    DynamicBvh = 2,
}

impl BroadPhaseKind {
    /// Every variant that can be built, [`BroadPhaseKind::Auto`] apart.
    pub const ALL: [BroadPhaseKind; 2] = [BroadPhaseKind::BruteForce, BroadPhaseKind::DynamicBvh];

    /// The variant's name, as charts and the C API spell it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            BroadPhaseKind::Auto => "auto",
            BroadPhaseKind::BruteForce => "brute_force",
            BroadPhaseKind::DynamicBvh => "dynamic_bvh",
        }
    }

    /// An empty broad phase of this kind.
    #[must_use]
    pub fn build(self) -> Box<dyn BroadPhase> {
        match self {
            BroadPhaseKind::BruteForce => Box::new(BruteForce::new()),
            BroadPhaseKind::Auto | BroadPhaseKind::DynamicBvh => Box::new(DynamicBvh::new()),
        }
    }
}

/// Whether a proxy is expected to move. Two static proxies never make a pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Layer {
    /// Shapes of static bodies.
    Static,
    /// Shapes of dynamic and kinematic bodies, awake or asleep.
    Moving,
}

/// The contract of a broad phase. Boxes are closed (touching is overlapping), in world coordinates \[m\], valid
/// ([`Aabb::is_valid`]) and within ±[`MAX_COORDINATE`](crate::math::tolerance::MAX_COORDINATE): an unbounded
/// shape is given the box of that size.
///
/// `update`, `remove` and `set_layer` expect a proxy that was inserted, and panic on others.
pub trait BroadPhase: Debug + Send + Sync {
    /// Adds `proxy` (< 2³¹ − 1, not in use) with its fat box. It makes pairs from the next
    /// [`find_pairs`](BroadPhase::find_pairs) that lists it, or an overlapping proxy, as moved.
    fn insert(&mut self, proxy: u32, aabb: &Aabb, layer: Layer);

    /// Takes `proxy` out.
    fn remove(&mut self, proxy: u32);

    /// Gives `proxy` a new fat box.
    fn update(&mut self, proxy: u32, aabb: &Aabb);

    /// Moves `proxy` to a layer, maybe its own.
    fn set_layer(&mut self, proxy: u32, layer: Layer);

    /// Fills `out` with every pair `[low, high]` whose boxes overlap, of which one member at least is listed in
    /// `moved` and one at least is not static: sorted, unique, complete. `moved` is sorted and unique and names
    /// proxies in use.
    fn find_pairs(&mut self, moved: &[u32], out: &mut Vec<[u32; 2]>);

    /// Calls `visit` with every proxy whose box overlaps `aabb`, in an order that depends only on the calls made
    /// so far, until it returns false.
    fn query(&self, aabb: &Aabb, visit: &mut dyn FnMut(u32) -> bool);

    /// Sweeps a box of half extents `box_half` (zero for a ray) from `origin` along `translation` and calls
    /// `visit(proxy, max)` with the proxies it may touch up to the fraction `max` of the translation, at first
    /// `max_fraction` (> 0, finite), nearer boxes tending to come first. `visit` returns the new `max`: the one
    /// it was given to go on, less to shorten the sweep, 0 to stop. A box that is touched is never missed; one
    /// that is missed by a rounding error may be visited. A zero translation is an overlap test.
    fn cast(
        &self,
        box_half: Vec3,
        origin: Vec3,
        translation: Vec3,
        max_fraction: Float,
        visit: &mut dyn FnMut(u32, Float) -> Float,
    );

    /// Arranges the static proxies anew, after many were inserted. Changes no answer, only its speed.
    fn rebuild_static(&mut self);

    /// The least box around all proxies; [`Aabb::EMPTY`] for none.
    fn bounds(&self) -> Aabb;

    /// Counters for reports.
    fn stats(&self) -> BroadPhaseStats;

    /// The memory held \[bytes\].
    fn byte_count(&self) -> usize;

    /// A copy, for snapshots of a world.
    fn clone_box(&self) -> Box<dyn BroadPhase>;
}

impl Clone for Box<dyn BroadPhase> {
    fn clone(&self) -> Self {
        self.clone_box()
    }
}

/// Counters of a broad phase.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BroadPhaseStats {
    /// Proxies in use.
    pub proxies: usize,
    /// Inner nodes of the trees; 0 for variants without.
    pub nodes: usize,
    /// Nodes on the longest way from a root to a proxy; 0 for variants without trees.
    pub height: usize,
}

/// Whether proxies of these layers may make a pair.
#[inline]
fn is_candidate(a: Layer, b: Layer) -> bool {
    a == Layer::Moving || b == Layer::Moving
}
