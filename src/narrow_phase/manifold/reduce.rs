//! From all points of a clipped face to the four that matter.

use crate::math::tolerance::EQUAL_DEPTH;
use crate::math::{Float, any_tangent, length_squared};
use crate::narrow_phase::contact::{MAX_MANIFOLD_POINTS, Manifold, ManifoldPoint, feature};

/// A point that may enter the manifold.
pub(in crate::narrow_phase) type Candidate = ManifoldPoint;

/// A later candidate must be better by this factor, so that rounding does not choose among equals.
const CLEARLY: Float = 1.001;

/// Fills `out`, whose normal is set, with at most four of `all`: one of the deepest, the farthest from it, and on
/// either side of their line the one that spans the larger triangle. Where several are deepest, the one farthest
/// along a fixed tangent is taken, so that the choice survives the rounding of the next step.
pub(in crate::narrow_phase) fn reduce(all: &[Candidate], out: &mut Manifold) {
    if all.len() <= MAX_MANIFOLD_POINTS {
        out.points[..all.len()].copy_from_slice(all);
        out.count = all.len();
        return tell_twins_apart(out);
    }
    let n = out.normal;
    let deepest = all.iter().map(|c| c.separation).fold(Float::MAX, Float::min);
    let origin = all[0].point;
    let extent = all.iter().map(|c| length_squared(c.point - origin)).fold(0.0, Float::max).sqrt();
    let t = any_tangent(n);
    let enough = deepest + EQUAL_DEPTH * extent;
    // Shifted by the extent: the score of an eligible point is positive.
    let (i, _) =
        best(all, |c| if c.separation <= enough { 2.0 * extent + t.dot(&(c.point - origin)) } else { -1.0 });
    let p = all[i].point;
    let (j, far) = best(all, |c| length_squared(c.point - p));
    let side = n.cross(&(all[j].point - p));
    let (k, left) = best(all, |c| side.dot(&(c.point - p)));
    let (l, right) = best(all, |c| -side.dot(&(c.point - p)));
    out.count = 0;
    let mut keep = |i: usize| out.push(all[i].point, all[i].separation, all[i].feature);
    keep(i);
    // Points in one place add nothing, points in one line only their ends.
    let smallest = 1e-6 * extent * extent;
    if far > smallest {
        keep(j);
        for (m, area) in [(k, left), (l, right)] {
            if area > smallest.min(1e-3 * far) && m != i && m != j {
                keep(m);
            }
        }
    }
    tell_twins_apart(out);
}

/// The candidate of greatest score, and the score; the earliest of those that are about equal.
#[inline(always)]
fn best(all: &[Candidate], score: impl Fn(&Candidate) -> Float) -> (usize, Float) {
    let mut best = (0, score(&all[0]));
    for (i, c) in all.iter().enumerate().skip(1) {
        let s = score(c);
        if s > best.1 * CLEARLY && s > 0.0 || best.1 < 0.0 && s > best.1 {
            best = (i, s);
        }
    }
    best
}

/// An edge that runs along a side, within the slack of clipping, may seem to cross it twice.
#[inline]
fn tell_twins_apart(out: &mut Manifold) {
    for i in 1..out.count {
        if out.points[..i].iter().any(|p| p.feature == out.points[i].feature) {
            out.points[i].feature = feature::twin(out.points[i].feature);
        }
    }
}
