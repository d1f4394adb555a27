//! A sphere or a capsule A against a solid with flat faces B. Everything is computed in the frame of B, where the
//! faces are; the result is turned to the frame of A at the end.

use super::Methods;
use super::analytic::{CROSSING, FLUSH, closest_of_segments};
use super::contact::{Manifold, feature};
use super::gjk::{GjkKind, Pair, Status};
use crate::math::scalar::single;
use crate::math::tolerance::{DEPTH_PREFERENCE, EDGE_PREFERENCE, PARALLEL_SINE};
use crate::math::{Float, Pose, Vec3, length, length_squared};
use crate::shape::{Capsule, CorePoints, Polytope, Sphere, narrow};

/// A capsule lies on a face when its normal leans less than this from the face's (cosine).
const ALONG_FACE: Float = 0.998;

/// The same for a capsule whose segment is inside the solid.
const ALONG_FACE_DEEP: Float = 0.9999;

/// A capsule lies along an edge when the sine between them is below this.
const ALONG_EDGE: Float = 0.1;

pub(super) fn sphere_polytope<P: Polytope>(
    a: &Sphere,
    b: &P,
    pose: &Pose,
    margin: Float,
    gjk: GjkKind,
    out: &mut Manifold,
) {
    let center = pose.point_back(a.center());
    let (mut top, mut face) = (-Float::MAX, 0);
    for i in 0..b.face_count() {
        let (n, d) = b.plane(i);
        let height = n.dot(&center) - d;
        if height > top {
            (top, face) = (height, i);
        }
    }
    if top - a.radius() > margin {
        return;
    }
    let (outward, gap) = if top <= 0.0 || is_over(b, face, center) {
        (b.plane(face).0, top)
    } else {
        let pair = Pair::new(CorePoints::One(center), b.core_points(), &Pose::IDENTITY);
        let close = pair.distance(gjk, a.radius() + margin);
        match close.status {
            Status::Beyond => return,
            Status::Overlapping => (b.plane(face).0, top),
            _ => (-narrow(close.normal), single(close.distance)),
        }
    };
    let separation = gap - a.radius();
    if separation <= margin {
        out.normal = -pose.vector(outward);
        out.push(pose.point(center - outward * (0.5 * (gap + a.radius()))), separation, 0);
    }
}

/// Whether `x` lies over the face: then its foot there is the closest point of the whole solid.
fn is_over<P: Polytope>(b: &P, face: usize, x: Vec3) -> bool {
    let (n, vs) = (b.plane(face).0, b.face_vertices(face));
    (0..vs.len()).all(|i| {
        let v = b.vertex(vs[i] as usize);
        let next = b.vertex(vs[if i + 1 == vs.len() { 0 } else { i + 1 }] as usize);
        (next - v).cross(&n).dot(&(x - v)) <= 0.0
    })
}

/// Where the segment of the capsule and the solid come closest, or how to part them: the outward normal of the
/// solid, the gap along it, and the point on the segment.
struct Axis {
    outward: Vec3,
    gap: Float,
    on_segment: Vec3,
}

pub(super) fn capsule_polytope<P: Polytope>(
    a: &Capsule,
    b: &P,
    pose: &Pose,
    margin: Float,
    methods: Methods,
    out: &mut Manifold,
) {
    let ends = [pose.point_back(a.center1()), pose.point_back(a.center2())];
    let reach = a.radius() + margin;
    let Some(axis) = over_face(ends, b).or_else(|| closest_axis(ends, b, reach, methods)) else { return };
    if axis.gap > reach {
        return;
    }
    out.normal = axis.outward;
    let face = b.face_along(axis.outward);
    // Outside, the closest points guard against a wrong face; a segment that pierces the solid has no such check.
    let least = if axis.gap > 0.0 { ALONG_FACE } else { ALONG_FACE_DEEP };
    let lies_flat = b.plane(face).0.dot(&axis.outward) > least;
    let found = if lies_flat {
        on_face(a, ends, b, face, &axis, margin, out)
    } else {
        on_edge(a, ends, b, &axis, margin, out)
    };
    if !found {
        out.count = 0;
        // Inside, the deepest end may lie beside the solid: what counts is the depth here.
        let top = axis.outward.dot(&b.vertex(b.support(axis.outward)));
        let here = if axis.gap > 0.0 { axis.gap } else { axis.outward.dot(&axis.on_segment) - top };
        add(a.radius(), axis.on_segment, &axis, here, margin, feature::edges(0, 0), out);
    }
    out.normal = -pose.vector(axis.outward);
    for p in &mut out.points[..out.count] {
        p.point = pose.point(p.point);
    }
}

/// A segment whose ends both lie over one face is closest to the solid there, at the lower end.
fn over_face<P: Polytope>(ends: [Vec3; 2], b: &P) -> Option<Axis> {
    let (mut gap, mut face) = (0.0, None);
    for i in 0..b.face_count() {
        let (n, d) = b.plane(i);
        let height = n.dot(&ends[0]).min(n.dot(&ends[1])) - d;
        if height > gap {
            (gap, face) = (height, Some(i));
        }
    }
    let face = face.filter(|&f| is_over(b, f, ends[0]) && is_over(b, f, ends[1]))?;
    let outward = b.plane(face).0;
    let lower = usize::from(outward.dot(&ends[1]) < outward.dot(&ends[0]));
    Some(Axis { outward, gap, on_segment: ends[lower] })
}

/// The axis from GJK; where the segment pierces the solid, from its faces and edges, or from EPA or MPR.
fn closest_axis<P: Polytope>(ends: [Vec3; 2], b: &P, reach: Float, methods: Methods) -> Option<Axis> {
    let pair = Pair::new(CorePoints::Two(ends), b.core_points(), &Pose::IDENTITY);
    let close = pair.distance(methods.gjk, reach);
    Some(match close.status {
        Status::Beyond => return None,
        Status::Overlapping if methods.searches_depth() => {
            let d = methods.depth(&pair, &close.simplex);
            Axis { outward: -narrow(d.normal), gap: single(-d.depth), on_segment: narrow(d.a) }
        }
        Status::Overlapping => deep_axis(ends, b, narrow(close.a)),
        _ => {
            Axis { outward: -narrow(close.normal), gap: single(close.distance), on_segment: narrow(close.a) }
        }
    })
}

/// Adds the point under `on_segment`, where the gap between segment and solid is `gap`.
fn add(radius: Float, on_segment: Vec3, axis: &Axis, gap: Float, margin: Float, id: u32, out: &mut Manifold) {
    if gap - radius <= margin {
        out.push(on_segment - axis.outward * (0.5 * (gap + radius)), gap - radius, id);
    }
}

/// The segment pierces the solid, `common` being a point of both: the best of all faces and edges.
fn deep_axis<P: Polytope>(ends: [Vec3; 2], b: &P, common: Vec3) -> Axis {
    let (mut gap, mut outward) = (-Float::MAX, Vec3::y());
    for i in 0..b.face_count() {
        let (n, d) = b.plane(i);
        let g = n.dot(&ends[0]).min(n.dot(&ends[1])) - d;
        if g > gap {
            (gap, outward) = (g, n);
        }
    }
    let mut best = Axis { outward, gap, on_segment: common };
    let along = ends[1] - ends[0];
    let must_beat = gap + EDGE_PREFERENCE * b.inner_radius() + DEPTH_PREFERENCE * gap.abs();
    let mut best_edge = must_beat;
    for i in 0..b.edge_count() {
        let e = b.edge(i).v.map(|v| b.vertex(v as usize));
        let d = e[1] - e[0];
        let n = along.cross(&d);
        let l2 = length_squared(n);
        if l2 <= PARALLEL_SINE * PARALLEL_SINE * length_squared(along) * length_squared(d) {
            continue;
        }
        let n = n / l2.sqrt();
        let n = if n.dot(&(e[0] - b.center())) < 0.0 { -n } else { n };
        let top = n.dot(&b.vertex(b.support(n)));
        // Only the edge that lies foremost along its axis touches; a parallel one behind it has the same axis.
        if top - n.dot(&e[0]) > 1e-4 * b.inner_radius() {
            continue;
        }
        let gap = n.dot(&ends[0]) - top;
        if gap > best_edge {
            best_edge = gap;
            let (s, _) = closest_of_segments(ends, e);
            best = Axis { outward: n, gap, on_segment: ends[0] + along * s };
        }
    }
    best
}

/// Two points where the segment runs over a face; `false` where the closest place is not on this face.
fn on_face<P: Polytope>(
    a: &Capsule,
    ends: [Vec3; 2],
    b: &P,
    face: usize,
    axis: &Axis,
    margin: Float,
    out: &mut Manifold,
) -> bool {
    let ((n, d), loop_, edges) = (b.plane(face), b.face_vertices(face), b.face_edges(face));
    let along = ends[1] - ends[0];
    let mut t = [(0.0, feature::vertex_a(0)), (1.0, feature::vertex_a(1))];
    for i in 0..loop_.len() {
        let v = b.vertex(loop_[i] as usize);
        let side = (b.vertex(loop_[(i + 1) % loop_.len()] as usize) - v).cross(&n);
        let (start, rate) = (side.dot(&(ends[0] - v)), side.dot(&along));
        // In units of the side's length; a segment along a side must neither divide by rounding nor be cut by it.
        let slack = 1e-4 * b.inner_radius() * length(side);
        if start.max(start + rate) <= slack {
            continue;
        }
        if start.min(start + rate) > slack {
            return false;
        }
        let cut = -start / rate;
        let id = feature::edges(0, edges[i] as usize + 1);
        if rate > 0.0 && cut < t[1].0 {
            t[1] = (cut, id);
        } else if rate < 0.0 && cut > t[0].0 {
            t[0] = (cut, id);
        }
    }
    if t[1].0 - t[0].0 <= 1e-3 {
        // Too short for two points. The closest points know better, unless the segment pierces the solid here.
        if axis.gap > 0.0 || t[1].0 < t[0].0 {
            return false;
        }
        let x = ends[0] + along * (0.5 * (t[0].0 + t[1].0));
        add(a.radius(), x, axis, n.dot(&x) - d, margin, t[0].1, out);
        return true;
    }
    let slant = n.dot(&axis.outward);
    let ends = t.map(|(t, id)| {
        let x = ends[0] + along * t;
        (x, (n.dot(&x) - d) / slant, id)
    });
    let least = ends[0].1.min(ends[1].1);
    // A segment that pierces the solid may have its deepest end beside the face: what lies over the face counts.
    if axis.gap > 0.0 && (least - axis.gap).abs() > 1e-3 * (a.radius() + axis.gap.abs()) {
        return false;
    }
    for (x, gap, id) in ends {
        add(a.radius(), x, axis, gap, margin, id, out);
    }
    true
}

/// Two points where the segment runs along an edge of the solid.
fn on_edge<P: Polytope>(
    a: &Capsule,
    ends: [Vec3; 2],
    b: &P,
    axis: &Axis,
    margin: Float,
    out: &mut Manifold,
) -> bool {
    let along = ends[1] - ends[0];
    let top = axis.outward.dot(&b.vertex(b.support(axis.outward)));
    let near = 1e-2 * a.radius();
    for i in 0..b.edge_count() {
        let e = b.edge(i).v.map(|v| b.vertex(v as usize));
        let d = e[1] - e[0];
        let across = length_squared(along.cross(&d));
        let low = e.map(|v| top - axis.outward.dot(&v));
        if low[0].min(low[1]) > near
            || across > ALONG_EDGE * ALONG_EDGE * length_squared(along) * length_squared(d)
        {
            continue;
        }
        let at = e.map(|v| (v - ends[0]).dot(&along) / length_squared(along));
        let (first, last) = if at[0] < at[1] { (0, 1) } else { (1, 0) };
        let start = if at[first] > FLUSH {
            (at[first], feature::vertex_b(first))
        } else {
            (0.0, feature::vertex_a(0))
        };
        let end = if at[last] < 1.0 - FLUSH {
            (at[last], feature::vertex_b(last))
        } else {
            (1.0, feature::vertex_a(1))
        };
        if end.0 - start.0 <= 1e-3 {
            continue;
        }
        let ends = [start, end].map(|(t, id)| {
            let x = ends[0] + along * t;
            let y =
                e[first] + (e[last] - e[first]) * ((t - at[first]) / (at[last] - at[first])).clamp(0.0, 1.0);
            let gap = axis.outward.dot(&(x - y));
            (x, gap, id, length(x - y - axis.outward * gap))
        });
        // Where the two cross rather than run side by side, one point is right.
        let reach = CROSSING * (a.radius() + axis.gap.abs());
        if ends[0].3.max(ends[1].3) > reach
            || (ends[0].1.min(ends[1].1) - axis.gap).abs() > 1e-2 * (a.radius() + axis.gap.abs())
        {
            continue;
        }
        for (x, gap, id, _) in ends {
            add(a.radius(), x, axis, gap, margin, id, out);
        }
        return true;
    }
    false
}
