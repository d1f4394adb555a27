//! Distance and casts of any two cores, with what the search found: for callers whose shapes are clouds of points.

use super::cast::{CastHit, cast_cores};
use super::gjk::Pair;
use super::query::{DistanceResult, distance_cores};
use crate::math::{Float, Pose, Vec3};
use crate::shape::{Core, narrow};

/// A vertex of the simplex that a distance search ended with, in the frame of A.
#[derive(Clone, Copy, Debug)]
pub struct SimplexVertex {
    /// The point of A's core \[m\].
    pub a: Vec3,
    /// The point of B's core \[m\].
    pub b: Vec3,
    /// The indices of these points in their cores.
    pub index: (u16, u16),
}

/// The distance between two cores, radii included.
#[must_use]
pub fn distance_of_cores(a: &Core, b: &Core, a_from_b: &Pose) -> DistanceResult {
    distance_cores(a, b, a_from_b)
}

/// The simplex that carries the closest points of two cores: the first `n` vertices of the result.
#[must_use]
pub fn simplex_of_cores(a: &Core, b: &Core, a_from_b: &Pose) -> ([SimplexVertex; 4], usize) {
    let close = Pair::new(a.points, b.points, a_from_b).distance(Float::MAX);
    let mut out = [SimplexVertex { a: Vec3::zeros(), b: Vec3::zeros(), index: (0, 0) }; 4];
    for (o, v) in out.iter_mut().zip(close.simplex.vertices()) {
        *o = SimplexVertex { a: narrow(v.a), b: narrow(v.b), index: v.id };
    }
    (out, close.simplex.len())
}

/// Moves core B along `translation` (in the frame of A) until it touches core A.
#[must_use]
pub fn cast_of_cores(
    a: &Core,
    b: &Core,
    a_from_b: &Pose,
    translation: Vec3,
    max_fraction: Float,
) -> Option<CastHit> {
    cast_cores(a, b, a_from_b, translation, max_fraction)
}
