//! Two solids with flat faces: find the axis, then clip the faces that meet along it.

use super::analytic::closest_of_segments;
use super::contact::{Manifold, feature};
use super::depth::{Depth, DepthStatus};
use super::frame::Frame;
use super::gjk::{Pair, Status};
use super::manifold::{self, ManifoldKind};
use super::sat::{best_edges, best_face, edge_gap, face_gap};
use super::{Cache, CachedAxis, Methods};
use crate::math::scalar::single;
use crate::math::tolerance::{DEPTH_PREFERENCE, EDGE_PREFERENCE, FACE_PREFERENCE};
use crate::math::{Float, Pose, Vec3};
use crate::shape::{Polytope, Wide, narrow, wide};

/// Above this many pairs of edges GJK is faster than trying them all.
const MOST_EDGE_PAIRS: usize = 1500;

/// The most edges of a solid in such a pair: every other has at least 6.
pub(super) const MOST_EDGES: usize = MOST_EDGE_PAIRS / 6;

/// The number of a point that no pair of features made.
pub(super) const FREE: u32 = feature::sliver(0x7fff, 0x7fff);

/// Specialised: faces and edges, or GJK where edge pairs are too many.
pub(super) fn collide<P: Polytope, Q: Polytope>(
    p: &P,
    q: &Q,
    pose: &Pose,
    margin: Float,
    methods: Methods,
    cache: &mut Cache,
    out: &mut Manifold,
) {
    if p.edge_count() * q.edge_count() > MOST_EDGE_PAIRS {
        by_gjk(p, q, pose, margin, methods, cache, out);
    } else {
        by_sat(p, q, pose, margin, methods, cache, out);
    }
}

/// By how much face B must beat face A, and an edge axis the better face.
pub(super) fn preferences(inner_a: Float, inner_b: Float, gap: Float) -> (Float, Float) {
    let (size, depth) = (inner_a.min(inner_b), DEPTH_PREFERENCE * gap.abs());
    (FACE_PREFERENCE * size + depth, EDGE_PREFERENCE * size + depth)
}

fn by_sat<P: Polytope, Q: Polytope>(
    p: &P,
    q: &Q,
    pose: &Pose,
    margin: Float,
    methods: Methods,
    cache: &mut Cache,
    out: &mut Manifold,
) {
    let frame = Frame::new(pose);
    let back = frame.inverse();
    let remembered = cached_gap(p, q, &frame, &back, cache.axis).unwrap_or(-Float::MAX);
    if remembered > margin {
        return;
    }
    let [known_a, known_b] = match cache.axis {
        CachedAxis::FaceA(_) => [remembered, -Float::MAX],
        CachedAxis::FaceB(_) => [-Float::MAX, remembered],
        _ => [-Float::MAX; 2],
    };
    let (gap_a, face_a) = best_face(p, q, &frame, margin, known_a);
    cache.axis = CachedAxis::FaceA(face_a as u16);
    if gap_a > margin {
        return;
    }
    let (gap_b, face_b) = best_face(q, p, &back, margin, known_b);
    if gap_b > margin {
        cache.axis = CachedAxis::FaceB(face_b as u16);
        return;
    }
    let (face_preference, edge_preference) =
        preferences(p.inner_radius(), q.inner_radius(), gap_a.max(gap_b));
    let b_is_reference = gap_b > gap_a + face_preference;
    let face_gap = if b_is_reference { gap_b } else { gap_a };
    let must_beat = face_gap + edge_preference;
    if let Some(edges) = best_edges(p, q, &frame, &back, margin, must_beat.min(margin))
        && edges.gap > must_beat
    {
        // Between the slivers of a bent plate, rounding can make two edges seem to face each other that do not.
        let whole = gap_of_all(p, q, &frame, edges.normal);
        if whole < edges.gap - 0.5 * edge_preference {
            return by_gjk(p, q, pose, margin, methods, cache, out);
        }
        cache.axis = CachedAxis::Edges(edges.a as u16, edges.b as u16);
        if whole > margin {
            return;
        }
        let (ea, eb) = (ends(p, edges.a), ends(q, edges.b).map(|v| frame.point(v)));
        let (s, t) = closest_of_segments(ea, eb);
        // Edges that are apart and pass each other beyond their ends say little: there the distance decides.
        if edges.gap > 0.0 && !(inner(s) && inner(t)) {
            return by_gjk(p, q, pose, margin, methods, cache, out);
        }
        out.normal = edges.normal;
        let point = (ea[0] + (ea[1] - ea[0]) * s + eb[0] + (eb[1] - eb[0]) * t) * 0.5;
        out.push(point, edges.gap, feature::edges(edges.a, edges.b));
        return;
    }
    if b_is_reference {
        cache.axis = CachedAxis::FaceB(face_b as u16);
    }
    let face = if b_is_reference { Err(face_b) } else { Ok(face_a) };
    from_face(methods.manifold, p, q, pose, &frame, &back, face, margin, out);
    // The faces may pass each other sideways: a corner near a corner. Then the distance decides.
    if out.count == 0 {
        by_gjk(p, q, pose, margin, methods, cache, out);
    }
}

/// The gap along a remembered axis; `None` where it no longer is one.
fn cached_gap<P: Polytope, Q: Polytope>(
    p: &P,
    q: &Q,
    frame: &Frame,
    back: &Frame,
    axis: CachedAxis,
) -> Option<Float> {
    match axis {
        CachedAxis::FaceA(i) => ((i as usize) < p.face_count()).then(|| face_gap(p, q, frame, i as usize)),
        CachedAxis::FaceB(i) => ((i as usize) < q.face_count()).then(|| face_gap(q, p, back, i as usize)),
        CachedAxis::Edges(i, j) if (i as usize) < p.edge_count() && (j as usize) < q.edge_count() => {
            let ([on_a, end_a], [on_b, end_b]) = (ends(p, i as usize), ends(q, j as usize));
            let (n, _) =
                edge_gap(on_a, end_a - on_a, frame.point(on_b), frame.vector(end_b - on_b), p.center())?;
            // The edges may no longer face each other: measure the whole solids.
            Some(gap_of_all(p, q, frame, n))
        }
        _ => None,
    }
}

/// The gap between the whole solids along the unit normal `n`.
fn gap_of_all<P: Polytope, Q: Polytope>(p: &P, q: &Q, frame: &Frame, n: Vec3) -> Float {
    let low = frame.point(q.vertex(q.support(-frame.vector_back(n))));
    n.dot(&(low - p.vertex(p.support(n))))
}

fn ends<P: Polytope>(p: &P, edge: usize) -> [Vec3; 2] {
    p.edge(edge).v.map(|v| p.vertex(v as usize))
}

/// Whether a parameter lies between the ends of its edge.
pub(super) fn inner(s: Float) -> bool {
    s > 0.0 && s < 1.0
}

/// Clips against a face of A (`Ok`) or of B (`Err`).
#[allow(clippy::too_many_arguments)]
pub(super) fn from_face<P: Polytope, Q: Polytope>(
    kind: ManifoldKind,
    p: &P,
    q: &Q,
    pose: &Pose,
    frame: &Frame,
    back: &Frame,
    face: std::result::Result<usize, usize>,
    margin: Float,
    out: &mut Manifold,
) {
    match face {
        Ok(face) => manifold::faces(kind, p, q, frame, face, margin, out),
        Err(face) => {
            manifold::faces(kind, q, p, back, face, margin, out);
            out.mirror(pose);
        }
    }
}

/// The search for the depth gave up: its normal, or that of a face where this parts the solids sooner. The result is that of `by_gjk`:
/// the normal, the gap, and the points.
#[cold]
fn better_face<P: Polytope, Q: Polytope>(
    p: &P,
    q: &Q,
    pose: &Pose,
    pair: &Pair,
    d: &Depth,
) -> (Wide, f64, Wide, Wide) {
    let frame = Frame::new(pose);
    let (_, face_a) = best_face(p, q, &frame, Float::MAX, -Float::MAX);
    let (_, face_b) = best_face(q, p, &frame.inverse(), Float::MAX, -Float::MAX);
    let mut best = (d.normal, -d.depth);
    for n in [wide(p.plane(face_a).0), wide(-frame.vector(q.plane(face_b).0))] {
        let gap = pair.gap_along(n);
        if gap > best.1 {
            best = (n, gap);
        }
    }
    (best.0, best.1, d.a, d.b)
}

/// The normal from GJK, or from EPA or MPR where the solids overlap; the points from the faces along it.
pub(super) fn by_gjk<P: Polytope, Q: Polytope>(
    p: &P,
    q: &Q,
    pose: &Pose,
    margin: Float,
    methods: Methods,
    cache: &mut Cache,
    out: &mut Manifold,
) {
    let pair = Pair::new(p.core_points(), q.core_points(), pose);
    let remembered = match cache.axis {
        CachedAxis::FaceA(i) if (i as usize) < p.face_count() => Some(p.plane(i as usize).0),
        CachedAxis::FaceB(i) if (i as usize) < q.face_count() => Some(-pose.vector(q.plane(i as usize).0)),
        _ => None,
    };
    if remembered.is_some_and(|n| single(pair.gap_along(wide(n))) > margin) {
        return;
    }
    let close = pair.distance(methods.gjk, margin.max(0.0));
    let (n, gap, on_a, on_b) = match close.status {
        Status::Overlapping => {
            let d = methods.depth(&pair, &close.simplex);
            match d.status {
                DepthStatus::Converged | DepthStatus::Flat => (d.normal, -d.depth, d.a, d.b),
                _ => better_face(p, q, pose, &pair, &d),
            }
        }
        _ => (close.normal, close.distance, close.a, close.b),
    };
    let (frame, normal) = (Frame::new(pose), narrow(n));
    let (face_a, face_b) = (p.face_along(normal), q.face_along(-frame.vector_back(normal)));
    cache.axis = CachedAxis::FaceA(face_a as u16);
    if close.status == Status::Beyond || single(gap) > margin {
        return;
    }
    let gap = single(gap);
    let back = frame.inverse();
    let (gap_a, gap_b) = (face_gap(p, q, &frame, face_a), face_gap(q, p, &back, face_b));
    let (face_preference, edge_preference) = preferences(p.inner_radius(), q.inner_radius(), gap);
    let b_is_reference = gap_b > gap_a + face_preference;
    if b_is_reference {
        cache.axis = CachedAxis::FaceB(face_b as u16);
    }
    if gap_a.max(gap_b) >= gap - edge_preference {
        let face = if b_is_reference { Err(face_b) } else { Ok(face_a) };
        from_face(methods.manifold, p, q, pose, &frame, &back, face, margin, out);
    }
    if out.count == 0 {
        out.normal = normal;
        out.push(narrow((on_a + on_b) * 0.5), gap, FREE);
    }
}
