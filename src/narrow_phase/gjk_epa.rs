//! Pairs by GJK while they are apart and by the expanding polytope ([`epa`](super::epa)) where they overlap. A search for the
//! depth that ends without success is helped out by the best face of either shape.

use super::contact::Manifold;
use super::{Cache, Methods, axis, depth, epa};
use crate::math::{Float, Pose};
use crate::shape::Shape;

/// How the depth is found.
pub(super) const DEPTH: depth::Method = epa::depth;

pub(super) fn collide(
    a: &Shape,
    b: &Shape,
    pose: &Pose,
    margin: Float,
    methods: Methods,
    cache: &mut Cache,
    out: &mut Manifold,
) {
    axis::collide(a, b, pose, margin, methods, cache, out);
}
