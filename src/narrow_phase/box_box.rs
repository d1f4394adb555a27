//! Two boxes: the hottest pair of all. The fifteen axes of Gottschalk, Lin & Manocha (OBBTree, SIGGRAPH 1996),
//! with signed gaps; then one clipped face or one pair of edges.
//!
//! All in the frame of A, relative to its centre: the gaps are sums of terms of the boxes' own size, right to a few
//! of their ulps wherever the pair is in the world.

use super::analytic::closest_of_segments;
use super::contact::{Manifold, feature};
use super::frame::Frame;
use super::polytopes::{by_gjk, preferences};
use super::{Cache, CachedAxis, clip};
use crate::math::tolerance::PARALLEL_SINE;
use crate::math::{Float, Pose, Vec3};
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
    cache: &mut Cache,
    out: &mut Manifold,
) {
    let axes = Axes::new(a, b, pose);
    if axes.cached_gap(cache.axis) > margin {
        return;
    }
    let (gap_a, axis_a) = greatest([0, 1, 2].map(|i| axes.gap_a(i)));
    let (gap_b, axis_b) = greatest([0, 1, 2].map(|j| axes.gap_b(j)));
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
        if gap <= margin {
            axes.touch_edges(gap, i, j, out);
        }
        return;
    }
    if b_is_reference {
        cache.axis = CachedAxis::FaceB(axis_b as u16);
        // The face of B that looks at A.
        let face = 2 * axis_b + usize::from(axes.t_b[axis_b] < 0.0);
        clip::faces(b, a, &axes.frame.inverse(), face, margin, out);
        out.mirror(pose);
    } else {
        cache.axis = CachedAxis::FaceA(axis_a as u16);
        let face = 2 * axis_a + usize::from(axes.t[axis_a] >= 0.0);
        clip::faces(a, b, &axes.frame, face, margin, out);
    }
    // The faces may pass each other sideways: a corner near a corner. Then the distance decides.
    if out.count == 0 {
        by_gjk(a, b, pose, margin, cache, out);
    }
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
        let r = [0, 1, 2].map(|i| [0, 1, 2].map(|j| frame.r[(i, j)]));
        let t_b = frame.vector_back(frame.p);
        Self {
            frame,
            r,
            abs_r: r.map(|row| row.map(Float::abs)),
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

    /// The contact of an edge of A along its axis `i` with an edge of B along its axis `j`.
    fn touch_edges(&self, gap: Float, i: usize, j: usize, out: &mut Manifold) {
        let mut n = Vec3::zeros();
        let (i1, i2) = ((i + 1) % 3, (i + 2) % 3);
        (n[i1], n[i2]) = (-self.r[i2][j], self.r[i1][j]);
        let n = n / crate::math::length(n);
        let n = if n.dot(&self.frame.p) < 0.0 { -n } else { n };
        let edge_a = edge_towards(&self.half_a, i, n);
        let edge_b = edge_towards(&self.half_b, j, -self.frame.vector_back(n));
        let on_b = edge_b.1.map(|v| self.frame.point(v));
        let (s, t) = closest_of_segments(edge_a.1, on_b);
        let on_a = edge_a.1;
        out.normal = n;
        let point = (on_a[0] + (on_a[1] - on_a[0]) * s + on_b[0] + (on_b[1] - on_b[0]) * t) * 0.5;
        out.push(point, gap, feature::edges(edge_a.0, edge_b.0));
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
