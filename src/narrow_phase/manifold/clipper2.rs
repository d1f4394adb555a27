//! The common area of two faces by Clipper2, as the thesis has it (5.4): project both faces along the normal to its
//! plane, intersect the polygons, project the corners back along the normal onto either face.
//!
//! The library computes with whole numbers. The grid is 2⁻³⁰ of the smaller face, unless the larger one is so large
//! that its corners would pass 2⁵⁰ steps. Nothing in it is shared between calls, so any number of threads may call it.
//!
//! A face seen from its edge has no area: it counts as the segment, or the point, that it looks like.

use super::FLUSH;
use super::reduce::{Candidate, reduce};
use crate::math::scalar::{double, single};
use crate::math::{Float, any_tangent};
use crate::narrow_phase::contact::{Manifold, feature};
use crate::narrow_phase::frame::Frame;
use crate::shape::{Polytope, Wide, narrow, wide};
use ::clipper2::{FillRule, One, Path, Paths, Point};

/// A place in the plane of the normal.
type Flat = nalgebra::Vector2<f64>;

/// A face with what is asked of it: all relative to the origin of the plane.
struct Face {
    corners: Vec<Flat>,
    /// The height of each corner along the normal.
    heights: Vec<f64>,
    /// Number i of the edges runs from corner i to the next.
    vertices: Vec<usize>,
    edges: Vec<usize>,
    /// How the height grows along the two axes of the plane; `None` for a face seen from its edge.
    slope: Option<Flat>,
}

/// The plane of the normal: an origin and three axes, the third of which is the normal.
struct Plane {
    origin: Wide,
    axes: [Wide; 3],
}

/// See [`faces`](super::faces).
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
    let place_of_b = |v: u8| wide(frame.point(q.vertex(v as usize)));
    // Near the smaller face the numbers have the most digits; its first corner will do.
    let origin = if q.inner_radius() < p.inner_radius() {
        place_of_b(q.face_vertices(incident)[0])
    } else {
        wide(p.vertex(p.face_vertices(face)[0] as usize))
    };
    let (normal, tangent) = (wide(n), wide(any_tangent(n)));
    let plane = Plane { origin, axes: [tangent, normal.cross(&tangent), normal] };
    let m = wide(frame.vector(q.plane(incident).0));
    let a =
        Face::new(&plane, p.face_vertices(face), p.face_edges(face), |v| wide(p.vertex(v as usize)), &normal);
    let b = Face::new(&plane, q.face_vertices(incident), q.face_edges(incident), place_of_b, &m);
    let flush = double(FLUSH * p.inner_radius().min(q.inner_radius()));
    let mut candidates: Vec<Candidate> = Vec::new();
    for x in tidy(common(&a, &b), flush) {
        let (low, high) = (a.height(&x), b.height(&x));
        let separation = single(high - low);
        let id = number(&a, &b, &x, flush);
        // Two corners with one number are one corner that rounding has split.
        if separation > margin || candidates.iter().any(|c| c.feature == id) {
            continue;
        }
        let point =
            plane.origin + plane.axes[0] * x.x + plane.axes[1] * x.y + plane.axes[2] * (0.5 * (low + high));
        candidates.push(Candidate { point: narrow(point), separation, feature: id });
    }
    out.normal = n;
    reduce(&candidates, out);
}

impl Face {
    fn new(plane: &Plane, vertices: &[u8], edges: &[u16], place: impl Fn(u8) -> Wide, normal: &Wide) -> Self {
        let places: Vec<Wide> = vertices.iter().map(|&v| place(v) - plane.origin).collect();
        let [x, y, z] = plane.axes.map(|axis| axis.dot(normal));
        Self {
            corners: places.iter().map(|p| Flat::new(plane.axes[0].dot(p), plane.axes[1].dot(p))).collect(),
            heights: places.iter().map(|p| plane.axes[2].dot(p)).collect(),
            vertices: vertices.iter().map(|&v| v as usize).collect(),
            edges: edges.iter().map(|&e| e as usize).collect(),
            slope: (z.abs() > 1e-3).then(|| Flat::new(-x / z, -y / z)),
        }
    }

    /// Where the line along the normal through `x` meets the face: in its plane, or on its nearest edge where the
    /// plane stands upright.
    fn height(&self, x: &Flat) -> f64 {
        match self.slope {
            Some(slope) => {
                let bounds =
                    self.heights.iter().fold((f64::MAX, f64::MIN), |b, h| (b.0.min(*h), b.1.max(*h)));
                // From the nearest corner: the error of the slope has the least way to grow.
                let k = self.nearest_corner(x).0;
                (self.heights[k] + slope.dot(&(x - self.corners[k]))).clamp(bounds.0, bounds.1)
            }
            None => {
                let (k, _, t) = self.nearest_edge(x);
                let next = (k + 1) % self.heights.len();
                self.heights[k] + (self.heights[next] - self.heights[k]) * t
            }
        }
    }

    /// The nearest corner and its distance.
    fn nearest_corner(&self, x: &Flat) -> (usize, f64) {
        let mut best = (0, f64::MAX);
        for (i, c) in self.corners.iter().enumerate() {
            let d = (x - c).norm();
            if d < best.1 {
                best = (i, d);
            }
        }
        best
    }

    /// The nearest edge, its distance, and where on the edge.
    fn nearest_edge(&self, x: &Flat) -> (usize, f64, f64) {
        let mut best = (0, f64::MAX, 0.0);
        for i in 0..self.corners.len() {
            let (p, q) = (self.corners[i], self.corners[(i + 1) % self.corners.len()]);
            let d = q - p;
            let dd = d.norm_squared();
            let t = if dd > 0.0 { ((x - p).dot(&d) / dd).clamp(0.0, 1.0) } else { 0.0 };
            let away = (x - (p + d * t)).norm();
            if away < best.1 {
                best = (i, away, t);
            }
        }
        best
    }

    /// The greatest distance of two corners along an axis of the plane.
    fn extent(&self) -> f64 {
        let mut b = [(f64::MAX, f64::MIN); 2];
        for c in &self.corners {
            for k in 0..2 {
                b[k] = (b[k].0.min(c[k]), b[k].1.max(c[k]));
            }
        }
        (b[0].1 - b[0].0).max(b[1].1 - b[1].0)
    }

    /// Twice the area.
    fn area(&self) -> f64 {
        let origin = self.corners[0];
        (1..self.corners.len())
            .map(|i| (self.corners[i - 1] - origin).perp(&(self.corners[i] - origin)))
            .sum::<f64>()
            .abs()
    }

    /// The two corners farthest apart, about.
    fn ends(&self) -> [Flat; 2] {
        let far = |from: &Flat| {
            let mut best = (*from, 0.0);
            for c in &self.corners {
                let d = (c - from).norm_squared();
                if d > best.1 {
                    best = (*c, d);
                }
            }
            best.0
        };
        let end = far(&self.corners[0]);
        [far(&end), end]
    }
}

/// A face thinner than this share of its length is a segment.
const THIN: f64 = 1e-9;

/// The corners of the common area; two for a common segment, one for a common point, none where the faces do not
/// meet.
fn common(a: &Face, b: &Face) -> Vec<Flat> {
    let thin = |f: &Face| f.area() <= THIN * f.extent() * f.extent();
    match (thin(a), thin(b)) {
        (false, false) => polygons(a, b),
        (false, true) => segment_in(b.ends(), a),
        (true, false) => segment_in(a.ends(), b),
        (true, true) => {
            let [p, q] = b.ends();
            // What two segments have in common is near the middle of both, or nothing.
            let x = (p + q) * 0.5;
            let (k, away, t) = a.nearest_edge(&x);
            let on_a = a.corners[k] + (a.corners[(k + 1) % a.corners.len()] - a.corners[k]) * t;
            if away <= THIN * (a.extent() + b.extent()) { vec![on_a] } else { Vec::new() }
        }
    }
}

/// The part of a segment over a convex polygon.
fn segment_in([p, q]: [Flat; 2], face: &Face) -> Vec<Flat> {
    let n = face.corners.len();
    let turn: f64 = (0..n)
        .map(|i| (face.corners[i] - face.corners[0]).perp(&(face.corners[(i + 1) % n] - face.corners[0])))
        .sum::<f64>()
        .signum();
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for i in 0..n {
        let (c, d) = (face.corners[i], face.corners[(i + 1) % n]);
        // Positive inside.
        let side = |x: Flat| turn * (d - c).perp(&(x - c));
        let (start, end) = (side(p), side(q));
        if start < 0.0 && end < 0.0 {
            return Vec::new();
        }
        if start < 0.0 {
            from = from.max(start / (start - end));
        } else if end < 0.0 {
            to = to.min(start / (start - end));
        }
    }
    if from > to { Vec::new() } else { vec![p + (q - p) * from, p + (q - p) * to] }
}

/// The common area of two convex polygons, by the library.
fn polygons(a: &Face, b: &Face) -> Vec<Flat> {
    let reach = a.corners.iter().chain(&b.corners).fold(0.0, |r: f64, c| r.max(c.amax()));
    let steps = (f64::from(1 << 30) / a.extent().min(b.extent())).min((1_u64 << 50) as f64 / reach);
    if !steps.is_normal() {
        return Vec::new();
    }
    let path = |f: &Face| {
        let on_grid = |c: &Flat| {
            let [x, y] = [c.x * steps, c.y * steps].map(|x| x.round_ties_even() as i64);
            Point::<One>::from_scaled(x, y)
        };
        Paths::new(vec![Path::new(f.corners.iter().map(on_grid).collect())])
    };
    // An error is the library's word for an inner fault; the pair then has no common area.
    let Ok(found) = ::clipper2::intersect(path(a), path(b), FillRule::NonZero) else { return Vec::new() };
    let back = |p: &Point<One>| Flat::new(p.x_scaled() as f64 / steps, p.y_scaled() as f64 / steps);
    // Convex polygons have one common area; slivers beside it are rounding.
    let mut best: Vec<Flat> = Vec::new();
    let mut most = -1.0;
    for path in found.iter() {
        let corners: Vec<Flat> = path.iter().map(back).collect();
        let area: f64 = (1..corners.len())
            .map(|i| (corners[i - 1] - corners[0]).perp(&(corners[i] - corners[0])))
            .sum::<f64>()
            .abs();
        if area > most {
            (best, most) = (corners, area);
        }
    }
    best
}

/// The corners without those that lie within `flush` of their neighbours or of the line between them: where the sides
/// of two faces all but coincide, rounding makes such corners come and go. Starts at the corner of least coordinates,
/// whatever corner the library began with.
fn tidy(mut corners: Vec<Flat>, flush: f64) -> Vec<Flat> {
    if let Some(first) = (0..corners.len()).min_by(|&i, &j| {
        let (p, q) = (corners[i], corners[j]);
        p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y))
    }) {
        corners.rotate_left(first);
    }
    loop {
        let n = corners.len();
        let idle = (0..n).find(|&i| {
            let (before, here, after) = (corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n]);
            let chord = after - before;
            let away = if n > 2 && chord.norm() > flush {
                chord.perp(&(here - before)).abs() / chord.norm()
            } else {
                (here - before).norm().min((here - after).norm())
            };
            n > 1 && away <= flush
        });
        match idle {
            Some(i) => drop(corners.remove(i)),
            None => return corners,
        }
    }
}

/// The number of the features that make the corner `x`: a vertex of B, of A, or the nearest edges of both. In this
/// order, so that faces which cover each other do not change numbers.
fn number(a: &Face, b: &Face, x: &Flat, flush: f64) -> u32 {
    let near = 4.0 * flush;
    let (corner_a, corner_b) = (a.nearest_corner(x), b.nearest_corner(x));
    if corner_b.1 <= near {
        feature::vertex_b(b.vertices[corner_b.0])
    } else if corner_a.1 <= near {
        feature::vertex_a(a.vertices[corner_a.0])
    } else {
        feature::edges(a.edges[a.nearest_edge(x).0], b.edges[b.nearest_edge(x).0])
    }
}
