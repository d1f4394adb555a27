//! The narrow phase: where and how deep two shapes touch. Knows shapes and poses, no bodies.
//!
//! [`collide`] makes manifolds for the solver; [`distance`], [`overlap`] and [`shape_cast`] answer queries. All of
//! them see B from A: they take `a_from_b` and answer in the frame of A, so that nothing depends on how far from
//! the world's origin a pair lies.
//!
//! | kind | idea | paper | cost | when to pick it | where it fails |
//! |---|---|---|---|---|---|
//! | [`Specialised`](NarrowPhaseKind::Specialised) | closed forms and separating axes, a table of pairs | Gottschalk 1996, Gregorius GDC 2013 | least | always: this is `Auto` | large hulls are left to GJK + EPA |
//! | [`GjkEpa`](NarrowPhaseKind::GjkEpa) | distance by GJK, depth by an expanding polytope | the thesis, 5.2–5.3; van den Bergen 2001 | some µs | as a cross-check | deep overlaps of round hulls fill the polytope |
//! | [`GjkMpr`](NarrowPhaseKind::GjkMpr) | distance by GJK, depth along a ray by a portal | Snethen 2008 | less than EPA | shallow overlaps, many vertices | the depth is not the least one |
//!
//! The axis decides the normal; the points come from the faces that meet along it ([`ManifoldKind`]). Below GJK lies a
//! choice of sub-algorithms ([`GjkKind`]). [`Methods`] holds all three choices.

mod analytic;
mod axis;
mod box_box;
mod cast;
mod contact;
mod depth;
mod epa;
mod frame;
mod gjk;
mod gjk_epa;
mod gjk_mpr;
mod manifold;
mod mpr;
mod polytopes;
mod query;
mod sat;
mod segment;
mod specialised;
#[cfg(test)]
mod tests;
mod trace;

use crate::math::{Float, Pose};
use crate::shape::Shape;

pub use cast::{CastHit, cast_proxy, shape_cast, shape_cast_proxy};
pub use contact::{MAX_MANIFOLD_POINTS, Manifold, ManifoldPoint};
pub use depth::DepthStatus;
pub use gjk::GjkKind;
pub use manifold::ManifoldKind;
pub use query::{
    DepthResult, DistanceResult, DistanceStatus, MAX_PROXY_POINTS, Proxy, distance, distance_by,
    distance_proxy, overlap, overlap_proxy, penetration,
};
pub use trace::{MAX_TRACE_STEPS, TraceStep, distance_proxy_traced, distance_traced};

use depth::Depth;
use gjk::{Pair, Simplex};

/// How manifolds between bounded shapes are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum NarrowPhaseKind {
    /// Whatever is best for the pair: today the same as `Specialised`.
    #[default]
    Auto = 0,
    /// Closed forms and separating axes.
    Specialised = 1,
    /// The normal of every pair without a half-space from GJK and EPA: a cross-check by another way.
    GjkEpa = 2,
    /// The same from GJK and MPR: cheaper, but the depth need not be the least.
    GjkMpr = 3,
}

impl NarrowPhaseKind {
    /// All kinds.
    #[rustfmt::skip]
    pub const ALL: [NarrowPhaseKind; 4] = [
        Self::Auto,
        Self::Specialised,
        Self::GjkEpa,
        Self::GjkMpr,
    ];

    /// The name in lists and charts.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::Specialised => "specialised",
            Self::GjkEpa => "gjk_epa",
            Self::GjkMpr => "gjk_mpr",
        }
    }
}

/// The choices of this room; default all auto.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Methods {
    /// How the normal is found.
    pub kind: NarrowPhaseKind,
    /// How GJK, where it is asked, looks at simplices.
    pub gjk: GjkKind,
    /// How the points are found where faces meet. A kind that is not built counts as `Auto`.
    pub manifold: ManifoldKind,
}

impl From<NarrowPhaseKind> for Methods {
    fn from(kind: NarrowPhaseKind) -> Self {
        Self { kind, ..Self::default() }
    }
}

impl Methods {
    /// Whether the depth comes from a search rather than from closed forms and axes.
    #[inline]
    fn searches_depth(self) -> bool {
        matches!(self.kind, NarrowPhaseKind::GjkEpa | NarrowPhaseKind::GjkMpr)
    }

    /// The depth of two cores that overlap, from the simplex in which GJK found the origin.
    #[inline]
    fn depth(self, pair: &Pair, simplex: &Simplex) -> Depth {
        let method: depth::Method =
            if self.kind == NarrowPhaseKind::GjkMpr { gjk_mpr::DEPTH } else { gjk_epa::DEPTH };
        method(pair, simplex)
    }
}

/// What is remembered of a pair from one step to the next: the last axis. It may change how fast the answer comes
/// and which of equal answers it is, nothing else. Start with the default, which remembers nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Cache {
    axis: CachedAxis,
}

/// The features whose axis decided last time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
enum CachedAxis {
    #[default]
    Unknown,
    FaceA(u16),
    FaceB(u16),
    Edges(u16, u16),
}

/// Finds the contact between A and B: points whose gap along the normal is at most `margin` \[m\] (≥ 0 keeps points
/// that are about to touch), at most four, in the frame of A. `out.count` is 0 where there are none.
///
/// The normal is the direction in which B leaves A soonest, up to the preferences in [`crate::math::tolerance`] and to
/// what [`NarrowPhaseKind::GjkMpr`] can find. Two half-spaces never touch.
pub fn collide(
    a: &Shape,
    b: &Shape,
    a_from_b: &Pose,
    margin: Float,
    methods: Methods,
    cache: &mut Cache,
    out: &mut Manifold,
) {
    out.count = 0;
    // The hottest pair goes first.
    if let (Shape::Box(a), Shape::Box(b)) = (a, b)
        && !methods.searches_depth()
    {
        return box_box::collide(a, b, a_from_b, margin, methods, cache, out);
    }
    // A pair below the diagonal of the table is answered by its mirror image.
    if rank(a) > rank(b) {
        let mut mirrored = cache.mirrored();
        ordered(b, a, &a_from_b.inverse(), margin, methods, &mut mirrored, out);
        *cache = mirrored.mirrored();
        out.mirror(a_from_b);
    } else {
        ordered(a, b, a_from_b, margin, methods, cache, out);
    }
}

/// The order of shapes in the table: half-spaces first, then from round to flat.
fn rank(shape: &Shape) -> u8 {
    match shape {
        Shape::HalfSpace(_) => 0,
        Shape::Sphere(_) => 1,
        Shape::Capsule(_) => 2,
        Shape::Box(_) => 3,
        Shape::Hull(_) => 4,
    }
}

/// A pair on or above the diagonal of the table.
fn ordered(
    a: &Shape,
    b: &Shape,
    pose: &Pose,
    margin: Float,
    methods: Methods,
    cache: &mut Cache,
    out: &mut Manifold,
) {
    match methods.kind {
        NarrowPhaseKind::Auto | NarrowPhaseKind::Specialised => {
            specialised::collide(a, b, pose, margin, methods, cache, out);
        }
        NarrowPhaseKind::GjkEpa => gjk_epa::collide(a, b, pose, margin, methods, cache, out),
        NarrowPhaseKind::GjkMpr => gjk_mpr::collide(a, b, pose, margin, methods, cache, out),
    }
}

impl Cache {
    fn mirrored(self) -> Self {
        let axis = match self.axis {
            CachedAxis::FaceA(f) => CachedAxis::FaceB(f),
            CachedAxis::FaceB(f) => CachedAxis::FaceA(f),
            CachedAxis::Edges(a, b) => CachedAxis::Edges(b, a),
            CachedAxis::Unknown => CachedAxis::Unknown,
        };
        Self { axis }
    }
}
