//! The narrow phase: where and how deep two shapes touch. Knows shapes and poses, no bodies.
//!
//! [`collide`] makes manifolds for the solver; [`distance`], [`overlap`] and [`shape_cast`] answer queries. All of
//! them see B from A: they take `a_from_b` and answer in the frame of A, so that nothing depends on how far from
//! the world's origin a pair lies.
//!
//! | pair | specialised | GJK + EPA |
//! |---|---|---|
//! | sphere, capsule – sphere, capsule | closed form | axis, then one point or two |
//! | sphere – box | closed form | axis, then one point |
//! | box – box | 15 axes, cached | axis, then faces |
//! | box, hull – hull (small) | faces and edges with Gauss-map pruning | axis, then faces |
//! | hull – hull (large) | as GJK + EPA: edge pairs would be too many | axis, then faces |
//! | sphere, capsule – box, hull | GJK while the core is outside, faces and edges inside | axis |
//! | half-space – all | closed form | closed form |
//!
//! The axis decides the normal; the points come from clipping the faces that meet along it.

mod analytic;
mod box_box;
mod cast;
mod clip;
mod contact;
mod epa;
mod frame;
mod gjk;
mod polytopes;
mod query;
mod reduce;
mod sat;
mod segment;
#[cfg(test)]
mod tests;
mod witness;

use crate::math::{Float, Pose};
use crate::shape::Shape;

pub use cast::{CastHit, cast_proxy, shape_cast, shape_cast_proxy};
pub use contact::{MAX_MANIFOLD_POINTS, Manifold, ManifoldPoint};
pub use query::{
    DistanceResult, DistanceStatus, MAX_PROXY_POINTS, Proxy, distance, distance_proxy, overlap, overlap_proxy,
};
pub use witness::witnesses;

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
}

impl NarrowPhaseKind {
    /// All kinds.
    pub const ALL: [NarrowPhaseKind; 3] = [Self::Auto, Self::Specialised, Self::GjkEpa];

    /// The name in lists and charts.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::Specialised => "specialised",
            Self::GjkEpa => "gjk-epa",
        }
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
/// The normal is the direction in which B leaves A soonest, up to the preferences in [`crate::math::tolerance`].
/// Two half-spaces never touch.
pub fn collide(
    a: &Shape,
    b: &Shape,
    a_from_b: &Pose,
    margin: Float,
    kind: NarrowPhaseKind,
    cache: &mut Cache,
    out: &mut Manifold,
) {
    out.count = 0;
    // The hottest pair goes first.
    if let (Shape::Box(a), Shape::Box(b)) = (a, b)
        && kind != NarrowPhaseKind::GjkEpa
    {
        return box_box::collide(a, b, a_from_b, margin, cache, out);
    }
    // A pair below the diagonal of the table is answered by its mirror image.
    if rank(a) > rank(b) {
        let mut mirrored = cache.mirrored();
        ordered(b, a, &a_from_b.inverse(), margin, kind, &mut mirrored, out);
        *cache = mirrored.mirrored();
        out.mirror(a_from_b);
    } else {
        ordered(a, b, a_from_b, margin, kind, cache, out);
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

/// The upper half of the table.
fn ordered(
    a: &Shape,
    b: &Shape,
    pose: &Pose,
    margin: Float,
    kind: NarrowPhaseKind,
    cache: &mut Cache,
    out: &mut Manifold,
) {
    use Shape::{Box, Capsule, HalfSpace, Hull, Sphere};
    let gjk = kind == NarrowPhaseKind::GjkEpa;
    match (a, b) {
        (HalfSpace(_), HalfSpace(_)) => {}
        (HalfSpace(h), Sphere(s)) => analytic::half_space_sphere(h, s, pose, margin, out),
        (HalfSpace(h), Capsule(c)) => analytic::half_space_capsule(h, c, pose, margin, out),
        (HalfSpace(h), Box(b)) => analytic::half_space_polytope(h, b, pose, margin, out),
        (HalfSpace(h), Hull(b)) => analytic::half_space_polytope(h, b.as_ref(), pose, margin, out),
        (Box(a), Box(b)) => polytopes::by_gjk(a, b, pose, margin, cache, out),
        (Box(a), Hull(b)) => polytopes::collide(a, b.as_ref(), pose, margin, gjk, cache, out),
        (Hull(a), Hull(b)) => polytopes::collide(a.as_ref(), b.as_ref(), pose, margin, gjk, cache, out),
        (Sphere(a), Box(b)) if !gjk => analytic::sphere_box(a, b, pose, margin, out),
        (Sphere(a), Box(b)) => segment::sphere_polytope(a, b, pose, margin, out),
        (Sphere(a), Hull(b)) => segment::sphere_polytope(a, b.as_ref(), pose, margin, out),
        (Capsule(a), Box(b)) => segment::capsule_polytope(a, b, pose, margin, gjk, out),
        (Capsule(a), Hull(b)) => segment::capsule_polytope(a, b.as_ref(), pose, margin, gjk, out),
        (Sphere(a), Sphere(b)) => analytic::sphere_sphere(a, b, pose, margin, out),
        (Sphere(a), Capsule(b)) => analytic::sphere_capsule(a, b, pose, margin, out),
        (Capsule(a), Capsule(b)) => analytic::capsule_capsule(a, b, pose, margin, out),
        _ => unreachable!("the pair is in order"),
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
