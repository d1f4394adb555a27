//! Clipping the incident face against the sides of the reference face (Sutherland & Hodgman 1974), with labels that
//! tell afterwards which features made each corner.

use super::FLUSH;
use super::reduce::{Candidate, reduce};
use crate::math::{Float, Vec3, length_squared};
use crate::narrow_phase::contact::{Manifold, feature};
use crate::narrow_phase::frame::Frame;
use crate::shape::Polytope;

/// Set in the label of an edge that lies on a side of the reference face; the rest is the number within the loop.
const REFERENCE: u16 = 1 << 15;

/// A convex polygon with a label for the edge that leaves each corner.
struct Polygon<const N: usize> {
    corners: [Vec3; N],
    labels: [u16; N],
    len: usize,
}

impl<const N: usize> Polygon<N> {
    fn empty() -> Self {
        Self { corners: [Vec3::zeros(); N], labels: [0; N], len: 0 }
    }

    #[inline(always)]
    fn push(&mut self, corner: Vec3, label: u16) {
        // A convex polygon gains at most one corner a cut, and N has room for all cuts.
        if self.len < N {
            self.corners[self.len] = corner;
            self.labels[self.len] = label;
            self.len += 1;
        }
    }

    /// Cuts away what lies beyond `side · x = offset` (`side` of any length); `false` where nothing does, and `out` is
    /// left as it was. Corners within `flush` of the plane stay.
    #[inline(always)]
    fn clip(&self, side: Vec3, offset: Float, flush: Float, label: u16, out: &mut Self) -> bool {
        let mut heights = [0.0; N];
        let mut top = 0.0;
        for (h, x) in heights.iter_mut().zip(&self.corners[..self.len]) {
            *h = side.dot(x) - offset;
            top = h.max(top);
        }
        if top <= 0.0 {
            return false;
        }
        let flush = flush * length_squared(side).sqrt();
        out.len = 0;
        for i in 0..self.len {
            let k = if i + 1 == self.len { 0 } else { i + 1 };
            let (here, next) = (heights[i], heights[k]);
            let cut = || self.corners[i] + (self.corners[k] - self.corners[i]) * (here / (here - next));
            match (here <= flush, next <= flush) {
                (true, true) => out.push(self.corners[i], self.labels[i]),
                // A corner that lies on the side already is the cut.
                (true, false) if here >= -flush => out.push(self.corners[i], label),
                (true, false) => {
                    out.push(self.corners[i], self.labels[i]);
                    out.push(cut(), label);
                }
                (false, true) if next < -flush => out.push(cut(), self.labels[i]),
                (false, _) => {}
            }
        }
        true
    }
}

/// See [`faces`](super::faces).
#[inline]
pub(super) fn faces<P: Polytope, Q: Polytope>(
    p: &P,
    q: &Q,
    frame: &Frame,
    face: usize,
    margin: Float,
    out: &mut Manifold,
) {
    let (n, _) = p.plane(face);
    let incident = q.face_along(-frame.vector_back(n));
    let size = p.face_vertices(face).len() + q.face_vertices(incident).len();
    match size {
        0..=16 => fill::<P, Q, 16>(p, q, frame, face, incident, margin, out),
        17..=64 => fill::<P, Q, 64>(p, q, frame, face, incident, margin, out),
        _ => fill::<P, Q, 512>(p, q, frame, face, incident, margin, out),
    }
}

#[inline(always)]
fn fill<P: Polytope, Q: Polytope, const N: usize>(
    p: &P,
    q: &Q,
    frame: &Frame,
    face: usize,
    incident: usize,
    margin: Float,
    out: &mut Manifold,
) {
    let ((n, d), sides) = (p.plane(face), p.face_vertices(face));
    let (mut first, mut second) = (Polygon::<N>::empty(), Polygon::<N>::empty());
    let (mut polygon, mut scratch) = (&mut first, &mut second);
    for (i, &v) in q.face_vertices(incident).iter().enumerate() {
        polygon.push(frame.point(q.vertex(v as usize)), i as u16);
    }
    let flush = FLUSH * p.inner_radius().min(q.inner_radius());
    for i in 0..sides.len() {
        let a = p.vertex(sides[i] as usize);
        let b = p.vertex(sides[if i + 1 == sides.len() { 0 } else { i + 1 }] as usize);
        let side = (b - a).cross(&n);
        if polygon.clip(side, side.dot(&a), flush, i as u16 | REFERENCE, scratch) {
            std::mem::swap(&mut polygon, &mut scratch);
        }
    }
    let mut candidates = [Candidate::default(); N];
    let mut count = 0;
    for i in 0..polygon.len {
        let x = polygon.corners[i];
        let separation = n.dot(&x) - d;
        if separation <= margin {
            let before = polygon.labels[if i == 0 { polygon.len - 1 } else { i - 1 }];
            let feature = corner_feature(p, q, face, incident, before, polygon.labels[i]);
            candidates[count] = Candidate { point: x - n * (0.5 * separation), separation, feature };
            count += 1;
        }
    }
    out.normal = n;
    reduce(&candidates[..count], out);
}

/// The features that meet in the corner between two labelled edges.
#[inline(always)]
fn corner_feature<P: Polytope, Q: Polytope>(
    p: &P,
    q: &Q,
    face: usize,
    incident: usize,
    before: u16,
    after: u16,
) -> u32 {
    let (i, j) = ((before & !REFERENCE) as usize, (after & !REFERENCE) as usize);
    match (before & REFERENCE != 0, after & REFERENCE != 0) {
        (false, false) => feature::vertex_b(q.face_vertices(incident)[j] as usize),
        (false, true) => feature::edges(p.face_edges(face)[j] as usize, q.face_edges(incident)[i] as usize),
        (true, false) => feature::edges(p.face_edges(face)[i] as usize, q.face_edges(incident)[j] as usize),
        (true, true) => {
            // The incident loop turns the other way: the corner is where the earlier side begins.
            let n = p.face_vertices(face).len();
            if i == (j + 1) % n {
                feature::vertex_a(p.face_vertices(face)[i] as usize)
            } else if j == (i + 1) % n {
                feature::vertex_a(p.face_vertices(face)[j] as usize)
            } else {
                feature::sliver(i, j)
            }
        }
    }
}
