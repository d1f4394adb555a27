//! Two boxes: the hottest pair of all. The fifteen axes of Gottschalk, Lin & Manocha (OBBTree, SIGGRAPH 1996),
//! with signed gaps; then one clipped face or one pair of edges.
//!
//! All in the frame of A, relative to its centre: the gaps are sums of terms of the boxes' own size, right to a few
//! of their ulps wherever the pair is in the world.

use super::analytic::closest_of_segments;
use super::contact::{Manifold, feature};
use super::frame::Frame;
use super::manifold::reduce::{Candidate, reduce};
use super::manifold::{FLUSH, ManifoldKind};
use super::polytopes::{by_gjk, from_face, inner, preferences};
use super::{Cache, CachedAxis, Methods};
use crate::math::tolerance::PARALLEL_SINE;
use crate::math::{Float, Pose, Vec3};
use crate::shape::cuboid::{LOOP_EDGES, LOOPS, SIDES};
use crate::shape::{Cuboid, Polytope};

/// The pair as the axes see it.
struct Axes {
    frame: Frame,
    /// The rotation by element: `r[i][j]` is axis j of B along axis i of A; and its absolute values.
    r: [[Float; 3]; 3],
    abs_r: [[Float; 3]; 3],
    half_a: [Float; 3],
    half_b: [Float; 3],
    /// The centre of B along the axes of A, and along those of B.
    t: [Float; 3],
    t_b: [Float; 3],
}

pub(super) fn collide(
    a: &Cuboid,
    b: &Cuboid,
    pose: &Pose,
    margin: Float,
    methods: Methods,
    cache: &mut Cache,
    out: &mut Manifold,
) {
    let axes = Axes::new(a, b, pose);
    if axes.cached_gap(cache.axis) > margin {
        return;
    }
    let (gap_a, axis_a) = greatest([axes.gap_a(0), axes.gap_a(1), axes.gap_a(2)]);
    let (gap_b, axis_b) = greatest([axes.gap_b(0), axes.gap_b(1), axes.gap_b(2)]);
    if gap_a.max(gap_b) > margin {
        cache.axis =
            if gap_a > gap_b { CachedAxis::FaceA(axis_a as u16) } else { CachedAxis::FaceB(axis_b as u16) };
        return;
    }
    let (face_preference, edge_preference) =
        preferences(a.inner_radius(), b.inner_radius(), gap_a.max(gap_b));
    let b_is_reference = gap_b > gap_a + face_preference;
    let face_gap = if b_is_reference { gap_b } else { gap_a };
    if let Some((gap, i, j)) = axes.best_edges(face_gap + edge_preference) {
        cache.axis = CachedAxis::Edges(i as u16, j as u16);
        if gap > margin || axes.touch_edges(gap, i, j, out) {
            return;
        }
        return by_gjk(a, b, pose, margin, methods, cache, out);
    }
    if methods.manifold == ManifoldKind::Clipper2 {
        cache.axis =
            if b_is_reference { CachedAxis::FaceB(axis_b as u16) } else { CachedAxis::FaceA(axis_a as u16) };
        axes.touch_any(a, b, pose, b_is_reference, [axis_a, axis_b], margin, methods.manifold, out);
    } else if b_is_reference {
        cache.axis = CachedAxis::FaceB(axis_b as u16);
        axes.of_b().touch_faces(axis_b, margin, feature::mirrored, out);
        out.normal = -axes.frame.vector(out.normal);
        for p in &mut out.points[..out.count] {
            p.point = axes.frame.point(p.point);
        }
    } else {
        cache.axis = CachedAxis::FaceA(axis_a as u16);
        axes.of_a().touch_faces(axis_a, margin, |f| f, out);
    }
    // The faces may pass each other sideways: a corner near a corner. Then the distance decides.
    if out.count == 0 {
        by_gjk(a, b, pose, margin, methods, cache, out);
    }
}

#[inline(always)]
fn abs3([x, y, z]: [Float; 3]) -> [Float; 3] {
    [x.abs(), y.abs(), z.abs()]
}

#[inline(always)]
fn greatest(x: [Float; 3]) -> (Float, usize) {
    let k = if x[0] >= x[1] && x[0] >= x[2] {
        0
    } else if x[1] >= x[2] {
        1
    } else {
        2
    };
    (x[k], k)
}

impl Axes {
    #[inline(always)]
    fn new(a: &Cuboid, b: &Cuboid, pose: &Pose) -> Self {
        let frame = Frame::new(pose);
        // Written out: `array::map` is not inlined here.
        let row = |i: usize| [frame.r[(i, 0)], frame.r[(i, 1)], frame.r[(i, 2)]];
        let r = [row(0), row(1), row(2)];
        let t_b = frame.vector_back(frame.p);
        Self {
            frame,
            r,
            abs_r: [abs3(r[0]), abs3(r[1]), abs3(r[2])],
            half_a: a.half().into(),
            half_b: b.half().into(),
            t: frame.p.into(),
            t_b: t_b.into(),
        }
    }

    /// The gap along axis `i` of A.
    #[inline(always)]
    fn gap_a(&self, i: usize) -> Float {
        let (r, h) = (&self.abs_r[i], &self.half_b);
        self.t[i].abs() - self.half_a[i] - (r[0] * h[0] + r[1] * h[1] + r[2] * h[2])
    }

    /// The gap along axis `j` of B.
    #[inline(always)]
    fn gap_b(&self, j: usize) -> Float {
        let (r, h) = (&self.abs_r, &self.half_a);
        self.t_b[j].abs() - self.half_b[j] - (r[0][j] * h[0] + r[1][j] * h[1] + r[2][j] * h[2])
    }

    /// The gap along axis i of A × axis j of B, not yet divided by the length of that product, and the square of
    /// this length (the sum of two squares: 1 − r² would cancel).
    #[inline(always)]
    fn gap_edges(&self, i: usize, j: usize) -> (Float, Float) {
        let (i1, i2, j1, j2) = ((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
        let (r, abs_r, t) = (&self.r, &self.abs_r, &self.t);
        let reach_a = self.half_a[i1] * abs_r[i2][j] + self.half_a[i2] * abs_r[i1][j];
        let reach_b = self.half_b[j1] * abs_r[i][j2] + self.half_b[j2] * abs_r[i][j1];
        let apart = (t[i2] * r[i1][j] - t[i1] * r[i2][j]).abs();
        (apart - reach_a - reach_b, r[i1][j] * r[i1][j] + r[i2][j] * r[i2][j])
    }

    /// The best edge axis, if its gap is more than `must_beat`.
    #[inline(always)]
    fn best_edges(&self, must_beat: Float) -> Option<(Float, usize, usize)> {
        let mut best = (must_beat, 3, 3);
        for i in 0..3 {
            for j in 0..3 {
                let (scaled, l2) = self.gap_edges(i, j);
                // Dividing by a length below 1 only lowers a negative gap: most axes end here, without a root.
                if scaled < 0.0 && scaled <= best.0 || l2 <= PARALLEL_SINE * PARALLEL_SINE {
                    continue;
                }
                let gap = scaled / l2.sqrt();
                if gap > best.0 {
                    best = (gap, i, j);
                }
            }
        }
        (best.1 < 3).then_some(best)
    }

    /// The gap along the axis that decided last time.
    #[inline(always)]
    fn cached_gap(&self, axis: CachedAxis) -> Float {
        match axis {
            CachedAxis::FaceA(i) if i < 3 => self.gap_a(i as usize),
            CachedAxis::FaceB(j) if j < 3 => self.gap_b(j as usize),
            CachedAxis::Edges(i, j) if i < 3 && j < 3 => {
                let (scaled, l2) = self.gap_edges(i as usize, j as usize);
                if l2 > PARALLEL_SINE * PARALLEL_SINE { scaled / l2.sqrt() } else { -Float::MAX }
            }
            _ => -Float::MAX,
        }
    }

    /// The contact of two faces by any kind of manifold: along axis k\[0\] of A, or k\[1\] of B where that is the
    /// reference.
    #[cold]
    #[allow(clippy::too_many_arguments)]
    fn touch_any(
        &self,
        a: &Cuboid,
        b: &Cuboid,
        pose: &Pose,
        b_is_reference: bool,
        k: [usize; 2],
        margin: Float,
        kind: ManifoldKind,
        out: &mut Manifold,
    ) {
        let face = if b_is_reference {
            Err(2 * k[1] + usize::from(self.t_b[k[1]] <= 0.0))
        } else {
            Ok(2 * k[0] + usize::from(self.t[k[0]] >= 0.0))
        };
        from_face(kind, a, b, pose, &self.frame, &self.frame.inverse(), face, margin, out);
    }

    /// The contact of an edge of A along its axis `i` with an edge of B along its axis `j`; `false` where they are
    /// apart and pass each other beyond their ends.
    fn touch_edges(&self, gap: Float, i: usize, j: usize, out: &mut Manifold) -> bool {
        let mut n = Vec3::zeros();
        let (i1, i2) = ((i + 1) % 3, (i + 2) % 3);
        (n[i1], n[i2]) = (-self.r[i2][j], self.r[i1][j]);
        let n = n / crate::math::length(n);
        let n = if n.dot(&self.frame.p) < 0.0 { -n } else { n };
        let edge_a = edge_towards(&self.half_a, i, n);
        let edge_b = edge_towards(&self.half_b, j, -self.frame.vector_back(n));
        let on_b = edge_b.1.map(|v| self.frame.point(v));
        let (s, t) = closest_of_segments(edge_a.1, on_b);
        if gap > 0.0 && !(inner(s) && inner(t)) {
            return false;
        }
        let on_a = edge_a.1;
        out.normal = n;
        let point = (on_a[0] + (on_a[1] - on_a[0]) * s + on_b[0] + (on_b[1] - on_b[0]) * t) * 0.5;
        out.push(point, gap, feature::edges(edge_a.0, edge_b.0));
        true
    }
}

/// One box as the reference, the other placed in its frame.
struct Side {
    half: [Float; 3],
    other_half: [Float; 3],
    /// The centre of the other box, and its axes: `r[i][j]` is component i of axis j.
    c: [Float; 3],
    r: [[Float; 3]; 3],
}

/// A corner of the clipped face: its place, and the label of the edge that leaves it (see [`sutherland_hodgman`](super::manifold::sutherland_hodgman)).
type Corner = ([Float; 3], u8);

/// Set in the labels of edges on a side of the reference face.
const REFERENCE: u8 = 4;

impl Axes {
    #[inline(always)]
    fn of_a(&self) -> Side {
        Side { half: self.half_a, other_half: self.half_b, c: self.t, r: self.r }
    }

    #[inline(always)]
    fn of_b(&self) -> Side {
        let row = |j: usize| [self.r[0][j], self.r[1][j], self.r[2][j]];
        let [x, y, z] = self.t_b;
        Side { half: self.half_b, other_half: self.half_a, c: [-x, -y, -z], r: [row(0), row(1), row(2)] }
    }
}

impl Side {
    /// Clips the face of the other box that looks at this box's face along axis `k`: [`faces`](super::manifold::faces) for boxes, where
    /// sides are coordinate planes. The result is in the frame of this box, with this box as A.
    #[inline(always)]
    fn touch_faces(&self, k: usize, margin: Float, number: impl Fn(u32) -> u32, out: &mut Manifold) {
        let (c, r, half, h) = (&self.c, &self.r, &self.half, &self.other_half);
        let up = c[k] >= 0.0;
        let sign = if up { 1.0 } else { -1.0 };
        let face = 2 * k + usize::from(up);
        let (_, j) = greatest(abs3(r[k]));
        let incident = 2 * j + usize::from(sign * r[k][j] < 0.0);
        let mut polygon: [Corner; 8] = [([0.0; 3], 0); 8];
        for (i, corner) in polygon[..4].iter_mut().enumerate() {
            let v = LOOPS[incident][i];
            let at = |m: usize| if v >> m & 1 == 1 { h[m] } else { -h[m] };
            let (x, y, z) = (at(0), at(1), at(2));
            let place = |i: usize| c[i] + (r[i][0] * x + r[i][1] * y + r[i][2] * z);
            *corner = ([place(0), place(1), place(2)], i as u8);
        }
        let mut n = 4;
        let flush = FLUSH * half[0].min(half[1]).min(half[2]).min(h[0].min(h[1]).min(h[2]));
        for (i, &(axis, positive)) in SIDES[face].iter().enumerate() {
            n = cut(
                &mut polygon,
                n,
                axis as usize,
                positive,
                half[axis as usize],
                flush,
                i as u8 | REFERENCE,
            );
        }
        let mut candidates = [Candidate::default(); 8];
        let mut count = 0;
        for i in 0..n {
            let (x, after) = polygon[i];
            let separation = sign * x[k] - half[k];
            if separation <= margin {
                let before = polygon[if i == 0 { n - 1 } else { i - 1 }].1;
                let mut point = Vec3::from(x);
                point[k] -= sign * (0.5 * separation);
                candidates[count] = Candidate {
                    point,
                    separation,
                    feature: number(corner_feature(face, incident, before, after)),
                };
                count += 1;
            }
        }
        out.normal = Vec3::zeros();
        out.normal[k] = sign;
        reduce(&candidates[..count], out);
    }
}

/// Cuts a polygon of `n` corners at ±x\[axis\] = `half`; returns the number of corners left. The rules are those of
/// [`sutherland_hodgman`](super::manifold::sutherland_hodgman): corners within `flush` of the plane stay.
#[inline(always)]
fn cut(
    polygon: &mut [Corner; 8],
    n: usize,
    axis: usize,
    positive: bool,
    half: Float,
    flush: Float,
    label: u8,
) -> usize {
    let mut heights = [0.0; 8];
    let mut beyond = false;
    for i in 0..n {
        let x = polygon[i].0[axis];
        heights[i] = if positive { x - half } else { -x - half };
        beyond |= heights[i] > flush;
    }
    if !beyond {
        return n;
    }
    let old = *polygon;
    let mut left = 0;
    let mut push = |corner: Corner| {
        // A quadrilateral cut by four planes has at most eight corners.
        polygon[left & 7] = corner;
        left += 1;
    };
    for i in 0..n {
        let k = if i + 1 == n { 0 } else { i + 1 };
        let (here, next) = (heights[i], heights[k]);
        let crossing = || {
            let (p, q, t) = (&old[i].0, &old[k].0, here / (here - next));
            [p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t, p[2] + (q[2] - p[2]) * t]
        };
        match (here <= flush, next <= flush) {
            (true, true) => push(old[i]),
            (true, false) if here >= -flush => push((old[i].0, label)),
            (true, false) => {
                push(old[i]);
                push((crossing(), label));
            }
            (false, true) if next < -flush => push((crossing(), old[i].1)),
            (false, _) => {}
        }
    }
    left.min(8)
}

/// The features that meet in a corner between two labelled edges, as in [`sutherland_hodgman`](super::manifold::sutherland_hodgman).
#[inline(always)]
fn corner_feature(face: usize, incident: usize, before: u8, after: u8) -> u32 {
    let (i, j) = ((before & 3) as usize, (after & 3) as usize);
    match (before & REFERENCE != 0, after & REFERENCE != 0) {
        (false, false) => feature::vertex_b(LOOPS[incident][j] as usize),
        (false, true) => feature::edges(LOOP_EDGES[face][j] as usize, LOOP_EDGES[incident][i] as usize),
        (true, false) => feature::edges(LOOP_EDGES[face][i] as usize, LOOP_EDGES[incident][j] as usize),
        (true, true) if i == (j + 1) & 3 => feature::vertex_a(LOOPS[face][i] as usize),
        (true, true) if j == (i + 1) & 3 => feature::vertex_a(LOOPS[face][j] as usize),
        (true, true) => feature::sliver(i, j),
    }
}

/// The edge along axis `k` that lies farthest along `d`: its number and its ends.
fn edge_towards(half: &[Float; 3], k: usize, d: Vec3) -> (usize, [Vec3; 2]) {
    let mut v = Vec3::zeros();
    let (mut number, mut bit) = (4 * k, 1);
    for m in (0..3).filter(|&m| m != k) {
        v[m] = if d[m] >= 0.0 { half[m] } else { -half[m] };
        number += if d[m] >= 0.0 { bit } else { 0 };
        bit <<= 1;
    }
    let (mut p, mut q) = (v, v);
    (p[k], q[k]) = (-half[k], half[k]);
    (number, [p, q])
}
