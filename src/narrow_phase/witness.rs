//! What a distance search ended with, for callers who want to look inside.

use super::gjk::Pair;
use super::query::Proxy;
use crate::math::{Float, Pose};

/// The one to four pairs of points (indices into A's and B's points) between whose hulls the closest points of two
/// proxies' cores lie: the first `n` of the array.
#[must_use]
pub fn witnesses(a: &Proxy, b: &Proxy, a_from_b: &Pose) -> ([(u16, u16); 4], usize) {
    let close = Pair::new(a.core().points, b.core().points, a_from_b).distance(Float::MAX);
    let mut out = [(0, 0); 4];
    for (o, v) in out.iter_mut().zip(close.simplex.vertices()) {
        *o = v.id;
    }
    (out, close.simplex.len())
}
