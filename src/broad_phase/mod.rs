//! Broad phase: which pairs of shapes are near enough to touch, judged by their boxes alone.
//!
//! A *proxy* is the number of a shape, small and dense from 0. It comes with a fat box: the shape's box grown by
//! a margin, so that a body must move by more than the margin before its proxy is updated. Fat boxes, the list
//! of proxies that moved and the set of known pairs belong to the caller; this room knows boxes only.
//!
//! | variant | idea | from | cost of a step | when | where it fails |
//! |---|---|---|---|---|---|
//! | `brute_force` | every moved box against every box | – | moved × all | oracle of the tests; a few dozen boxes | quadratic |
//! | `dynamic_bvh` | two binary trees of boxes, static and moving, patched where boxes move | \[Catto GDC19\], \[Bittner 2013\], \[Wald 2007\] | (moved + pairs) × log all | many updates, few questions | boxes that all contain each other make it deep |
//! | `dynamic_rtree` | three packed wide trees, patched where boxes move: what stands, rests, moves again and again | \[Guttman 1984\], \[Lee, Lee 2003\], \[Brinkhoff et al. 1993\] | (moved + pairs) × log all | default | everything moves far in every step: `omt` is as good |
//! | `sort_and_sweep` | one list, sorted along the axis of greatest spread | \[Baraff 1992\] | all × window | everything moves; long scenes | boxes in a plane across the axis |
//! | `sort_and_sweep_3` | three sorted lists, overlaps intersected | \[Cohen et al. 1995\] | all × window × 3 | for comparison | large scenes |
//! | `rtree` | wide tree, least growth of volume, quadratic split | \[Guttman 1984\] | (moved + pairs) × log all | for comparison | nodes overlap |
//! | `rstar` | wide tree, least overlap, reinsertion | \[Beckmann et al. 1990\] | as `rtree`, slower to build | many questions, few insertions | much comes and goes |
//! | `str` | wide tree packed in slabs, columns, runs | \[Leutenegger et al. 1997\] | all × log all | everything moves | little moves |
//! | `omt` | wide tree packed top-down in equal parts | \[Lee, Lee 2003\] | all × log all | everything moves | little moves |
//! | `…_split` | the same, what stands in a structure of its own | seed | moving instead of all | most stands | – |
//!
//! Every variant reports the same pairs in the same order: sorted, unique, complete. No list is ever cut short.

mod all_pairs;
mod boxes;
mod brute_force;
mod bvh;
mod dynamic_bvh;
mod dynamic_rtree;
mod node;
mod omt;
mod pair_set;
mod rstar;
mod rtree;
mod slab;
mod sort_and_sweep;
mod sort_and_sweep_3;
mod sorted;
mod split;
// `str` is the name of a type.
#[path = "str.rs"]
mod str_packing;
mod structure;

#[cfg(test)]
mod conformance;
#[cfg(test)]
mod random;

use crate::math::{Aabb, Float, Vec3};
use split::Split;
use std::fmt::Debug;

pub use brute_force::BruteForce;
pub use dynamic_bvh::DynamicBvh;
pub use pair_set::PairSet;

/// Which broad phase a world uses. The numbers are part of the C ABI.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum BroadPhaseKind {
    /// The engine chooses: today [`BroadPhaseKind::DynamicRTree`].
    #[default]
    Auto = 0,
    /// [`BruteForce`].
    BruteForce = 1,
    /// [`DynamicBvh`].
    DynamicBvh = 2,
    /// One sorted list, along the axis of greatest spread.
    SortAndSweep = 3,
    /// Three sorted lists, whose overlaps are intersected.
    SortAndSweep3 = 4,
    /// Guttman's R-tree, grown box by box.
    RTree = 5,
    /// The R*-tree, grown box by box with reinsertion.
    RStar = 6,
    /// An R-tree packed by sort-tile-recursive, built anew as boxes change.
    Str = 7,
    /// An R-tree packed top-down with least overlap, built anew as boxes change.
    Omt = 8,
    /// Every moving box against every box, but no two standing ones.
    BruteForceSplit = 9,
    /// [`BroadPhaseKind::SortAndSweep`] with what stands in a list of its own.
    SortAndSweepSplit = 10,
    /// [`BroadPhaseKind::SortAndSweep3`] with what stands in lists of its own.
    SortAndSweep3Split = 11,
    /// [`BroadPhaseKind::RTree`] with what stands in a tree of its own.
    RTreeSplit = 12,
    /// [`BroadPhaseKind::RStar`] with what stands in a tree of its own.
    RStarSplit = 13,
    /// [`BroadPhaseKind::Str`] with what stands in a tree of its own.
    StrSplit = 14,
    /// [`BroadPhaseKind::Omt`] with what stands in a tree of its own.
    OmtSplit = 15,
    /// R-trees packed by [`BroadPhaseKind::Omt`], patched where boxes move and packed anew when worn out; what stands
    /// has a tree of its own, and so has what moves again and again.
    DynamicRTree = 16,
}

impl BroadPhaseKind {
    /// Every variant that can be built, [`BroadPhaseKind::Auto`] apart.
    #[rustfmt::skip]
    pub const ALL: [BroadPhaseKind; 16] = [
        BroadPhaseKind::BruteForce,
        BroadPhaseKind::DynamicBvh,
        BroadPhaseKind::SortAndSweep,
        BroadPhaseKind::SortAndSweep3,
        BroadPhaseKind::RTree,
        BroadPhaseKind::RStar,
        BroadPhaseKind::Str,
        BroadPhaseKind::Omt,
        BroadPhaseKind::BruteForceSplit,
        BroadPhaseKind::SortAndSweepSplit,
        BroadPhaseKind::SortAndSweep3Split,
        BroadPhaseKind::RTreeSplit,
        BroadPhaseKind::RStarSplit,
        BroadPhaseKind::StrSplit,
        BroadPhaseKind::OmtSplit,
        BroadPhaseKind::DynamicRTree,
    ];

    /// The variant's name, as charts and the C API spell it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            BroadPhaseKind::Auto => "auto",
            BroadPhaseKind::BruteForce => "brute_force",
            BroadPhaseKind::DynamicBvh => "dynamic_bvh",
            BroadPhaseKind::SortAndSweep => "sort_and_sweep",
            BroadPhaseKind::SortAndSweep3 => "sort_and_sweep_3",
            BroadPhaseKind::RTree => "rtree",
            BroadPhaseKind::RStar => "rstar",
            BroadPhaseKind::Str => "str",
            BroadPhaseKind::Omt => "omt",
            BroadPhaseKind::BruteForceSplit => "brute_force_split",
            BroadPhaseKind::SortAndSweepSplit => "sort_and_sweep_split",
            BroadPhaseKind::SortAndSweep3Split => "sort_and_sweep_3_split",
            BroadPhaseKind::RTreeSplit => "rtree_split",
            BroadPhaseKind::RStarSplit => "rstar_split",
            BroadPhaseKind::StrSplit => "str_split",
            BroadPhaseKind::OmtSplit => "omt_split",
            BroadPhaseKind::DynamicRTree => "dynamic_rtree",
        }
    }

    /// An empty broad phase of this kind.
    #[must_use]
    pub fn build(self) -> Box<dyn BroadPhase> {
        match self {
            BroadPhaseKind::BruteForce => Box::new(BruteForce::new()),
            BroadPhaseKind::DynamicBvh => Box::new(DynamicBvh::new()),
            BroadPhaseKind::SortAndSweep => Box::new(sort_and_sweep::SortAndSweep::default()),
            BroadPhaseKind::SortAndSweep3 => Box::new(sort_and_sweep_3::SortAndSweep3::default()),
            BroadPhaseKind::RTree => Box::new(rtree::RTree::default()),
            BroadPhaseKind::RStar => Box::new(rstar::RStar::default()),
            BroadPhaseKind::Str => Box::new(str_packing::Str::default()),
            BroadPhaseKind::Omt => Box::new(omt::Omt::default()),
            BroadPhaseKind::BruteForceSplit => Box::new(Split::<all_pairs::AllPairs>::default()),
            BroadPhaseKind::SortAndSweepSplit => Box::new(Split::<sort_and_sweep::Line>::default()),
            BroadPhaseKind::SortAndSweep3Split => Box::new(Split::<sort_and_sweep_3::Lines>::default()),
            BroadPhaseKind::RTreeSplit => Box::new(Split::<node::Grown<rtree::Quadratic>>::default()),
            BroadPhaseKind::RStarSplit => Box::new(Split::<node::Grown<rstar::Margins>>::default()),
            BroadPhaseKind::StrSplit => Box::new(Split::<node::Packed<str_packing::Tiles>>::default()),
            BroadPhaseKind::OmtSplit => Box::new(Split::<node::Packed<omt::Cuts>>::default()),
            BroadPhaseKind::Auto | BroadPhaseKind::DynamicRTree => {
                Box::new(dynamic_rtree::DynamicRTree::default())
            }
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
