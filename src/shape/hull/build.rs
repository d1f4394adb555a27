//! From a cloud of points to the tables of a [`Hull`].

use super::{Hull, HullFace, MAX_HULL_VERTICES, merge, quick};
use crate::error::{Error, ErrorCode, Result, check};
use crate::math::scalar::{double, single};
use crate::math::tolerance::{HULL_FLATNESS, MIN_SIZE};
use crate::math::{Float, Mat3, Vec3, vec3};
use crate::shape::core::first_greatest;
use crate::shape::polytope::EdgeRay;
use crate::shape::ray::{Wide, narrow, wide};
use crate::shape::{Edge, Polytope, degenerate};

impl Hull {
    /// The convex hull of `points` \[m\]. Points inside, doubled points and points within rounding of a face are
    /// fine and vanish. Where the true hull has more than [`MAX_HULL_VERTICES`] vertices, the most prominent
    /// ones are kept.
    ///
    /// # Errors
    /// Fewer than 4 points, a coordinate not finite or too great, or all points within
    /// 2 × [`MIN_SIZE`] of one point, line or plane.
    pub fn new(points: &[Vec3]) -> Result<Self> {
        Self::with_max_vertices(points, MAX_HULL_VERTICES)
    }

    /// The same with at most `max_vertices` (4 … [`MAX_HULL_VERTICES`]) vertices: the farthest points are kept, so
    /// the result lies inside the true hull and close to it.
    ///
    /// # Errors
    /// As [`Hull::new`]; also a `max_vertices` out of range.
    pub fn with_max_vertices(points: &[Vec3], max_vertices: usize) -> Result<Self> {
        if !(4..=MAX_HULL_VERTICES).contains(&max_vertices) {
            let sentence = format!(
                "A hull of at most {max_vertices} vertices was asked for; the limit must lie between 4 and {MAX_HULL_VERTICES}."
            );
            return Err(Error::new(ErrorCode::Range, sentence));
        }
        if points.len() < 4 {
            return Err(degenerate(format!("A hull needs at least 4 points; there are {}.", points.len())));
        }
        if u32::try_from(points.len()).is_err() {
            return Err(Error::new(ErrorCode::Capacity, "A hull takes fewer than 2³² points."));
        }
        for (i, p) in points.iter().enumerate() {
            // The name is built only for the point that fails.
            if !(crate::math::is_finite(*p) && p.amax() <= crate::math::tolerance::MAX_COORDINATE) {
                check::point(&format!("Point {i} of the hull"), *p)?;
            }
        }
        let cloud = Cloud::new(points)?;
        let triangles = quick::triangles(&cloud.points, cloud.seed, cloud.flat, max_vertices)
            .ok_or_else(|| degenerate("The points of the hull span no volume that can be told from none."))?;
        let loops = [2.0 * cloud.flat, 0.25 * cloud.flat, -1.0]
            .into_iter()
            .find_map(|flat| merge::polygons(&cloud.points, &triangles, flat))
            .ok_or_else(|| Error::new(ErrorCode::Internal, "The hull's faces do not close."))?;
        Ok(tables(points, &loops))
    }
}

/// The points moved to the middle of their box and scaled to size 1.
struct Cloud {
    points: Vec<Wide>,
    /// Four points that span a volume.
    seed: [u32; 4],
    /// How far rounding may lift a point out of the face it lies in.
    flat: f64,
}

impl Cloud {
    fn new(input: &[Vec3]) -> Result<Self> {
        let first = wide(input[0]);
        let (mut lower, mut upper) = (first, first);
        for p in input {
            let p = wide(*p);
            lower = lower.inf(&p);
            upper = upper.sup(&p);
        }
        let (middle, size) = ((lower + upper) * 0.5, (upper - lower).max());
        let least = 2.0 * double(MIN_SIZE);
        if size < least {
            return Err(degenerate(format!("All points of the hull lie within {least:.0e} m of one point.")));
        }
        let scale = 1.0 / size;
        let points: Vec<Wide> = input.iter().map(|p| (wide(*p) - middle) * scale).collect();
        let flat = HULL_FLATNESS * lower.abs().sup(&upper.abs()).sum() * scale;
        let seed = Self::seed(&points, least * scale, flat)?;
        Ok(Self { points, seed, flat })
    }

    /// The two extreme points farthest apart, the point farthest from their line, and the point farthest from
    /// that plane.
    fn seed(points: &[Wide], least: f64, flat: f64) -> Result<[u32; 4]> {
        let best = |score: &dyn Fn(&Wide) -> f64| {
            let mut best = (0, f64::NEG_INFINITY);
            for (i, p) in points.iter().enumerate() {
                let s = score(p);
                if s > best.1 {
                    best = (i, s);
                }
            }
            best
        };
        let mut pair = (0, 0, -1.0);
        for k in 0..3 {
            let (i, j) = (best(&|p| -p[k]).0, best(&|p| p[k]).0);
            let d = (points[i] - points[j]).norm_squared();
            if d > pair.2 {
                pair = (i, j, d);
            }
        }
        let (a, b) = (points[pair.0], points[pair.1]);
        let along = (b - a) / pair.2.sqrt();
        let (c, off_line) = best(&|p| along.cross(&(p - a)).norm_squared());
        if off_line.sqrt() <= least.max(2.0 * flat) {
            return Err(degenerate("All points of the hull lie on one line."));
        }
        let n = along.cross(&(points[c] - a)) / off_line.sqrt();
        let (d, off_plane) = best(&|p| n.dot(&(p - a)).abs());
        if off_plane <= (0.999 * least).max(2.0 * flat) {
            return Err(degenerate("All points of the hull lie in one plane."));
        }
        Ok([pair.0 as u32, pair.1 as u32, c as u32, d as u32])
    }
}

/// Fills the tables from loops over the input points.
fn tables(input: &[Vec3], loops: &[Vec<u32>]) -> Hull {
    // Vertices in the order of the input: the result does not depend on how the hull grew.
    let mut used: Vec<u32> = loops.iter().flatten().copied().collect();
    used.sort_unstable();
    used.dedup();
    let vertices: Vec<Vec3> = used.iter().map(|&i| input[i as usize]).collect();
    let number = |i: u32| used.binary_search(&i).expect("every vertex is used") as u8;
    let mut hull = Hull {
        extremes: [0; 6],
        center: Vec3::zeros(),
        volume: 0.0,
        unit_inertia: Mat3::zeros(),
        inner_radius: 0.0,
        reach: 0.0,
        faces: Vec::with_capacity(loops.len()),
        loops: Vec::new(),
        loop_edges: Vec::new(),
        edges: Vec::new(),
        edge_rays: Vec::new(),
        neighbor_start: Vec::with_capacity(vertices.len() + 1),
        neighbors: Vec::new(),
        neighbor_edges: Vec::new(),
        vertices,
    };
    for l in loops {
        let start = hull.loops.len() as u16;
        hull.loops.extend(l.iter().map(|&i| number(i)));
        let (normal, offset) = plane(&hull.vertices, &hull.loops[start as usize..]);
        hull.faces.push(HullFace { normal, offset, start, count: l.len() as u16 });
    }
    fill_edges(&mut hull);
    fill_neighbors(&mut hull);
    for (k, extreme) in hull.extremes.iter_mut().enumerate() {
        let mut d = Vec3::zeros();
        d[k / 2] = if k % 2 == 1 { 1.0 } else { -1.0 };
        let vertices = &hull.vertices;
        *extreme = first_greatest(vertices.len(), |i| vertices[i].dot(&d)) as u8;
    }
    fill_mass(&mut hull);
    hull
}

/// The plane through a loop: Newell's normal about the loop's own middle (far from the origin the plain sum
/// loses its digits), the mean height of its vertices.
fn plane(vertices: &[Vec3], vs: &[u8]) -> (Vec3, Float) {
    let p = |i: usize| wide(vertices[vs[i % vs.len()] as usize]);
    let middle = (0..vs.len()).fold(Wide::zeros(), |s, i| s + p(i)) / vs.len() as f64;
    let n = (0..vs.len()).fold(Wide::zeros(), |s, i| s + (p(i) - middle).cross(&(p(i + 1) - middle)));
    let normal = narrow(n / n.dot(&n).sqrt());
    (normal, single(wide(normal).dot(&middle)))
}

fn fill_edges(hull: &mut Hull) {
    hull.loop_edges = vec![0; hull.loops.len()];
    for f in 0..hull.faces.len() {
        let (start, n) = (hull.faces[f].start as usize, hull.faces[f].count as usize);
        for i in 0..n {
            let (v, w) = (hull.loops[start + i], hull.loops[start + (i + 1) % n]);
            let known = hull.edges.iter().position(|e| e.v == [w, v]);
            let e = known.unwrap_or(hull.edges.len());
            match known {
                Some(e) => hull.edges[e].f[1] = f as u16,
                None => hull.edges.push(Edge { v: [v, w], f: [f as u16, f as u16] }),
            }
            hull.loop_edges[start + i] = e as u16;
        }
    }
    let rays = hull.edges.iter().map(|e| {
        let [start, end] = e.v.map(|v| hull.vertices[v as usize]);
        EdgeRay::new(start, end - start, e.f.map(|f| hull.faces[f as usize].normal))
    });
    hull.edge_rays = rays.collect();
}

fn fill_neighbors(hull: &mut Hull) {
    for v in 0..hull.vertices.len() as u8 {
        hull.neighbor_start.push(hull.neighbors.len() as u16);
        for (i, e) in hull.edges.iter().enumerate() {
            if e.v.contains(&v) {
                hull.neighbor_edges.push(i as u16);
                hull.neighbors.push(if e.v[0] == v { e.v[1] } else { e.v[0] });
            }
        }
    }
    hull.neighbor_start.push(hull.neighbors.len() as u16);
}

/// Volume, centre and inertia as a sum over the tetrahedra between a middle point and the triangles of the faces.
/// The second moments of a tetrahedron with one corner at the origin are
/// ∫ x xᵀ = det/120 (a aᵀ + b bᵀ + c cᵀ + s sᵀ), s = a + b + c (Tonon 2004, rewritten).
fn fill_mass(hull: &mut Hull) {
    let count = hull.vertices.len() as f64;
    let middle = hull.vertices.iter().fold(Wide::zeros(), |s, v| s + wide(*v)) / count;
    let (mut six_volumes, mut first, mut second) = (0.0, Wide::zeros(), nalgebra::Matrix3::<f64>::zeros());
    for f in 0..hull.faces.len() {
        let vs = hull.face_loop(f);
        let p = |i: usize| wide(hull.vertices[vs[i] as usize]) - middle;
        for i in 1..vs.len() - 1 {
            let (a, b, c) = (p(0), p(i), p(i + 1));
            let (det, s) = (a.dot(&b.cross(&c)), a + b + c);
            six_volumes += det;
            first += s * det;
            second += (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose()) * det;
        }
    }
    let volume = six_volumes / 6.0;
    let center = first / (4.0 * six_volumes);
    let about_center = second / 120.0 - center * center.transpose() * volume;
    let inertia = nalgebra::Matrix3::identity() * about_center.trace() - about_center;
    hull.volume = single(volume);
    hull.center = narrow(middle + center);
    let column = |k: usize| -> Vec3 {
        vec3(single(inertia[(0, k)]), single(inertia[(1, k)]), single(inertia[(2, k)]))
    };
    hull.unit_inertia = Mat3::from_columns(&[column(0), column(1), column(2)]);
    let least = (0..hull.faces.len())
        .map(|f| {
            let (n, d) = hull.plane(f);
            d - n.dot(&hull.center)
        })
        .fold(Float::MAX, Float::min);
    hull.inner_radius = least.max(0.0);
    hull.reach = hull.outer_radius(hull.center);
}
