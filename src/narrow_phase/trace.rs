//! What a distance search passed through, for callers who want to look inside.

use super::gjk::{GjkKind, Simplex};
use super::query::{DistanceResult, Proxy, core, distance_cores};
use crate::math::scalar::single;
use crate::math::{Float, Pose};
use crate::shape::{Core, Shape};

/// The most steps that a search records.
pub const MAX_TRACE_STEPS: usize = 65;

/// One simplex of a distance search: the vertices of the difference A − B that carry its point closest to the origin.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TraceStep {
    /// The pairs of core points (of A and of B) that make the vertices: the first `count`.
    pub pairs: [(u16, u16); 4],
    /// Their weights in the closest point.
    pub weights: [Float; 4],
    /// How many vertices there are, 1 … 4.
    pub count: usize,
    /// The distance of that point from the origin \[m\].
    pub distance: Float,
}

impl TraceStep {
    fn of(simplex: &Simplex) -> Self {
        let mut step = Self { count: simplex.len(), ..Self::default() };
        let mut point = crate::shape::Wide::zeros();
        for (i, (v, k)) in simplex.vertices().iter().zip(simplex.weights()).enumerate() {
            step.pairs[i] = v.id;
            step.weights[i] = single(*k);
            point += v.w * *k;
        }
        step.distance = single(point.norm());
        step
    }
}

/// Fills a buffer; what finds no room takes the last place, so that the end of the search is always there.
struct Recorder<'b> {
    buffer: &'b mut [TraceStep],
    len: usize,
}

impl Recorder<'_> {
    fn record(&mut self, simplex: &Simplex) {
        let Some(last) = self.buffer.len().checked_sub(1) else { return };
        self.buffer[self.len.min(last)] = TraceStep::of(simplex);
        self.len = (self.len + 1).min(self.buffer.len());
    }
}

fn traced(
    a: &Core,
    b: &Core,
    pose: &Pose,
    gjk: GjkKind,
    buffer: &mut [TraceStep],
) -> (DistanceResult, usize) {
    let mut recorder = Recorder { buffer, len: 0 };
    let result = distance_cores(a, b, pose, gjk, |simplex| recorder.record(simplex));
    (result, recorder.len)
}

/// The distance of two bounded shapes by this sub-algorithm; `buffer` gets the simplices of the search, of which
/// there are at most [`MAX_TRACE_STEPS`]. The second result is how many were written. `None` for half-spaces, which
/// have no core.
#[must_use]
pub fn distance_traced(
    a: &Shape,
    b: &Shape,
    a_from_b: &Pose,
    gjk: GjkKind,
    buffer: &mut [TraceStep],
) -> Option<(DistanceResult, usize)> {
    if a.core().is_none() || b.core().is_none() {
        return None;
    }
    Some(traced(&core(a), &core(b), a_from_b, gjk, buffer))
}

/// The same for proxies.
#[must_use]
pub fn distance_proxy_traced(
    a: &Proxy,
    b: &Proxy,
    a_from_b: &Pose,
    gjk: GjkKind,
    buffer: &mut [TraceStep],
) -> (DistanceResult, usize) {
    traced(a.core(), b.core(), a_from_b, gjk, buffer)
}
