//! Pairs by GJK while they are apart and by portal refinement ([`mpr`](super::mpr)) where they overlap. A search for the
//! depth that ends without success is helped out by the best face of either shape.

use super::contact::Manifold;
use super::{Cache, Methods, axis, depth, mpr};
use crate::math::{Float, Pose};
use crate::shape::Shape;

/// How the depth is found.
pub(super) const DEPTH: depth::Method = mpr::depth;

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
