//! Separating axes of two solids with flat faces: the face normals of both, and the cross products of those edge
//! pairs that form a face of the difference A − B (Gregorius, The Separating Axis Test between Convex Polyhedra,
//! GDC 2013).

use super::frame::Frame;
use crate::math::tolerance::PARALLEL_SINE;
use crate::math::{Float, Vec3, length_squared};
use crate::shape::Polytope;

/// The face of `p` in front of which the whole of `q` lies farthest, and how far that is.
pub(super) fn best_face<P: Polytope, Q: Polytope>(
    p: &P,
    q: &Q,
    p_from_q: &Frame,
    margin: Float,
) -> (Float, usize) {
    let mut best = (-Float::MAX, 0);
    for i in 0..p.face_count() {
        let s = face_gap(p, q, p_from_q, i);
        if s > best.0 {
            best = (s, i);
            if s > margin {
                break;
            }
        }
    }
    best
}

/// The gap between face `i` of `p` and all of `q`.
#[inline]
pub(super) fn face_gap<P: Polytope, Q: Polytope>(p: &P, q: &Q, p_from_q: &Frame, i: usize) -> Float {
    let (n, d) = p.plane(i);
    let deepest = q.vertex(q.support(-p_from_q.vector_back(n)));
    n.dot(&p_from_q.point(deepest)) - d
}

/// An axis from the edges `a` of A and `b` of B.
#[derive(Clone, Copy, Debug)]
pub(super) struct EdgeAxis {
    pub gap: Float,
    pub a: usize,
    pub b: usize,
    /// From A to B, in the frame of A.
    pub normal: Vec3,
}

/// The edge pair with the greatest gap. `frame` is that of `p` from `q`, `back` the other way.
pub(super) fn best_edges<P: Polytope, Q: Polytope>(
    p: &P,
    q: &Q,
    frame: &Frame,
    back: &Frame,
    margin: Float,
) -> Option<EdgeAxis> {
    // The inner loop should read tables.
    if P::IMPLICIT && !Q::IMPLICIT {
        let found = scan_edges(q, p, back, margin)?;
        let EdgeAxis { gap, a, b, normal } = found;
        return Some(EdgeAxis { gap, a: b, b: a, normal: -frame.vector(normal) });
    }
    scan_edges(p, q, frame, margin)
}

fn scan_edges<P: Polytope, Q: Polytope>(p: &P, q: &Q, frame: &Frame, margin: Float) -> Option<EdgeAxis> {
    let mut best: Option<EdgeAxis> = None;
    for j in 0..q.edge_count() {
        let e = q.edge_ray(j);
        let (on_b, along_b) = (frame.point(e.start), frame.vector(e.along));
        let [n0, n1] = e.normals.map(|n| frame.vector(n));
        for i in 0..p.edge_count() {
            let f = p.edge_ray(i);
            // The arcs between the normals of either edge, B's turned round, cross on the sphere: only then do the
            // edges face each other.
            let (a, b) = (f.normals[0].dot(&along_b), f.normals[1].dot(&along_b));
            if a * b >= 0.0 {
                continue;
            }
            let (c, d) = (-n0.dot(&f.along), -n1.dot(&f.along));
            if c * d >= 0.0 || c * b <= 0.0 {
                continue;
            }
            if let Some((normal, gap)) = edge_gap(f.start, f.along, on_b, along_b, p.center())
                && best.is_none_or(|x| gap > x.gap)
            {
                best = Some(EdgeAxis { gap, a: i, b: j, normal });
                if gap > margin {
                    return best;
                }
            }
        }
    }
    best
}

/// The unit normal of two edges, away from the centre of A, and the gap along it; `None` for parallel edges.
#[inline(always)]
pub(super) fn edge_gap(
    on_a: Vec3,
    along_a: Vec3,
    on_b: Vec3,
    along_b: Vec3,
    center: Vec3,
) -> Option<(Vec3, Float)> {
    let n = along_a.cross(&along_b);
    let l2 = length_squared(n);
    if l2 <= PARALLEL_SINE * PARALLEL_SINE * length_squared(along_a) * length_squared(along_b) {
        return None;
    }
    let n = n / l2.sqrt();
    let n = if n.dot(&(on_a - center)) < 0.0 { -n } else { n };
    Some((n, n.dot(&(on_b - on_a))))
}
