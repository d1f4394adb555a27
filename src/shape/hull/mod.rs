//! Convex hulls of point clouds.
//!
//! Built once by [`quick`] (triangles around the cloud) and [`merge`] (coplanar triangles become one polygon),
//! then read only: flat tables, indices of one or two bytes, shared by all bodies of that shape.

mod build;
mod merge;
mod quick;
#[cfg(test)]
mod tests;

use super::core::first_greatest;
use super::polytope::EdgeRay;
use super::{CorePoints, Edge, MassData, Polytope, RayHit, ray};
use crate::math::scalar::double;
use crate::math::{Aabb, Float, Mat3, Pose, Vec3, length_squared, max, min, rotation_matrix};

/// The most vertices a hull has: indices are bytes.
pub const MAX_HULL_VERTICES: usize = 255;

/// Up to this many vertices a scan beats climbing along edges.
const SCAN: usize = 32;

/// A convex solid with flat polygons for faces.
#[derive(Clone, Debug, PartialEq)]
pub struct Hull {
    vertices: Vec<Vec3>,
    faces: Vec<HullFace>,
    /// The vertices around each face, face after face; and the edge that leaves each.
    loops: Vec<u8>,
    loop_edges: Vec<u16>,
    edges: Vec<Edge>,
    edge_rays: Vec<EdgeRay>,
    /// The neighbours of vertex i: `neighbors[neighbor_start[i]..neighbor_start[i + 1]]`.
    neighbor_start: Vec<u16>,
    neighbors: Vec<u8>,
    /// The edge to each neighbour.
    neighbor_edges: Vec<u16>,
    /// The farthest vertices along −x, +x, −y, +y, −z, +z: where climbing starts.
    extremes: [u8; 6],
    center: Vec3,
    volume: Float,
    /// The inertia about `center` per unit of density.
    unit_inertia: Mat3,
    inner_radius: Float,
    reach: Float,
}

/// A face: its plane `normal · x = offset` and its place in the loops.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HullFace {
    /// The outward unit normal.
    pub normal: Vec3,
    /// The plane's distance from the origin along the normal \[m\].
    pub offset: Float,
    start: u16,
    count: u16,
}

impl Hull {
    /// The vertices \[m\].
    #[must_use]
    #[inline(always)]
    pub fn vertices(&self) -> &[Vec3] {
        &self.vertices
    }

    /// The faces.
    #[must_use]
    #[inline(always)]
    pub fn faces(&self) -> &[HullFace] {
        &self.faces
    }

    /// The vertices around face `i`, counter-clockwise seen from outside.
    #[must_use]
    #[inline(always)]
    pub fn face_loop(&self, i: usize) -> &[u8] {
        let f = &self.faces[i];
        &self.loops[f.start as usize..][..f.count as usize]
    }

    /// The edges.
    #[must_use]
    #[inline(always)]
    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// The centre of mass \[m\].
    #[must_use]
    #[inline(always)]
    pub fn center(&self) -> Vec3 {
        self.center
    }

    pub(super) fn volume(&self) -> Float {
        self.volume
    }

    pub(super) fn mass_data(&self, density: Float) -> MassData {
        MassData { mass: self.volume * density, center: self.center, inertia: self.unit_inertia * density }
    }

    pub(super) fn aabb(&self, pose: &Pose) -> Aabb {
        let r = rotation_matrix(&pose.q);
        let mut b = Aabb { lower: pose.p, upper: pose.p };
        if self.vertices.len() <= SCAN {
            let (mut lower, mut upper) = (Aabb::EMPTY.lower, Aabb::EMPTY.upper);
            for v in &self.vertices {
                let p = r * v;
                lower = min(lower, p);
                upper = max(upper, p);
            }
            return Aabb { lower: lower + pose.p, upper: upper + pose.p };
        }
        for k in 0..3 {
            let axis: Vec3 = r.row(k).transpose();
            b.lower[k] += axis.dot(&self.vertices[self.support(-axis)]);
            b.upper[k] += axis.dot(&self.vertices[self.support(axis)]);
        }
        b
    }

    pub(super) fn outer_radius(&self, from: Vec3) -> Float {
        self.vertices.iter().map(|v| length_squared(v - from)).fold(0.0, Float::max).sqrt()
    }

    pub(super) fn contains(&self, p: Vec3) -> bool {
        self.faces.iter().all(|f| f.normal.dot(&p) <= f.offset)
    }

    /// By visiting every face: slow and sure.
    pub(super) fn closest_point(&self, p: Vec3) -> Vec3 {
        let mut best = (Float::MAX, p);
        for (i, face) in self.faces.iter().enumerate() {
            let height = face.normal.dot(&p) - face.offset;
            if height > 0.0 {
                let q = self.closest_on_face(i, p, p - face.normal * height);
                let d = length_squared(q - p);
                if d < best.0 {
                    best = (d, q);
                }
            }
        }
        best.1
    }

    /// The point of face `i` closest to `p`, whose foot in the face's plane is `foot`.
    fn closest_on_face(&self, i: usize, p: Vec3, foot: Vec3) -> Vec3 {
        let (n, vs) = (self.faces[i].normal, self.face_loop(i));
        let (mut best, mut inside) = ((Float::MAX, foot), true);
        for k in 0..vs.len() {
            let a = self.vertices[vs[k] as usize];
            let e = self.vertices[vs[(k + 1) % vs.len()] as usize] - a;
            if e.cross(&n).dot(&(foot - a)) > 0.0 {
                inside = false;
                let q = a + e * ((p - a).dot(&e) / length_squared(e)).clamp(0.0, 1.0);
                let d = length_squared(q - p);
                if d < best.0 {
                    best = (d, q);
                }
            }
        }
        if inside { foot } else { best.1 }
    }

    pub(super) fn ray_cast(&self, origin: Vec3, translation: Vec3, max_fraction: Float) -> Option<RayHit> {
        if self.contains(origin) {
            return Some(RayHit::inside(origin));
        }
        let (o, d) = (ray::wide(origin), ray::wide(translation));
        let mut t = (0.0, double(max_fraction));
        let mut normal = Vec3::zeros();
        for f in &self.faces {
            let n = ray::wide(f.normal);
            if ray::clip(&mut t, n.dot(&o) - double(f.offset), n.dot(&d)) {
                normal = f.normal;
            }
            // An interval that ends before 0 lies behind the ray.
            if t.0.max(0.0) > t.1 {
                return None;
            }
        }
        RayHit::at(origin, translation, t.0, max_fraction, |_| normal)
    }

    /// The vertex of greatest `height`, which must be linear in the vertex and grow along about `direction`.
    #[inline]
    pub(crate) fn support_by<T: PartialOrd>(
        &self,
        direction: impl Fn() -> Vec3,
        height: impl Fn(usize) -> T,
    ) -> usize {
        if self.vertices.len() <= SCAN {
            return first_greatest(self.vertices.len(), height);
        }
        // Climb from vertex to better neighbour: on a convex body a local best is the best, up to rounding.
        let d = direction();
        let a = crate::math::abs(d);
        let k = if a.x >= a.y && a.x >= a.z {
            0
        } else if a.y >= a.z {
            1
        } else {
            2
        };
        let mut best = self.extremes[2 * k + usize::from(d[k] >= 0.0)] as usize;
        let mut top = height(best);
        loop {
            let here = best;
            let (first, end) = (self.neighbor_start[here] as usize, self.neighbor_start[here + 1] as usize);
            for &n in &self.neighbors[first..end] {
                let h = height(n as usize);
                if h > top {
                    (best, top) = (n as usize, h);
                }
            }
            if best == here {
                return best;
            }
        }
    }
}

impl Polytope for Hull {
    const IMPLICIT: bool = false;

    #[inline(always)]
    fn edge_ray(&self, i: usize) -> EdgeRay {
        self.edge_rays[i]
    }

    #[inline(always)]
    fn vertex_count(&self) -> usize {
        self.vertices.len()
    }

    #[inline(always)]
    fn vertex(&self, i: usize) -> Vec3 {
        self.vertices[i]
    }

    #[inline(always)]
    fn face_count(&self) -> usize {
        self.faces.len()
    }

    #[inline(always)]
    fn plane(&self, face: usize) -> (Vec3, Float) {
        (self.faces[face].normal, self.faces[face].offset)
    }

    #[inline(always)]
    fn face_vertices(&self, face: usize) -> &[u8] {
        self.face_loop(face)
    }

    #[inline(always)]
    fn face_edges(&self, face: usize) -> &[u16] {
        let f = &self.faces[face];
        &self.loop_edges[f.start as usize..][..f.count as usize]
    }

    #[inline(always)]
    fn edge_count(&self) -> usize {
        self.edges.len()
    }

    #[inline(always)]
    fn edge(&self, i: usize) -> Edge {
        self.edges[i]
    }

    #[inline]
    fn support(&self, d: Vec3) -> usize {
        self.support_by(|| d, |i| self.vertices[i].dot(&d))
    }

    #[inline]
    fn face_along(&self, d: Vec3) -> usize {
        if self.faces.len() <= 2 * SCAN {
            return first_greatest(self.faces.len(), |i| self.faces[i].normal.dot(&d));
        }
        // Of many faces, those around the farthest vertex.
        let v = self.support(d);
        let around = self.neighbor_start[v] as usize..self.neighbor_start[v + 1] as usize;
        let mut best = (0, -Float::MAX);
        for &e in &self.neighbor_edges[around] {
            for f in self.edges[e as usize].f {
                let s = self.faces[f as usize].normal.dot(&d);
                // Each face is met twice; ties go to the lower number, whatever the order.
                if s > best.1 || s == best.1 && (f as usize) < best.0 {
                    best = (f as usize, s);
                }
            }
        }
        best.0
    }

    #[inline(always)]
    fn center(&self) -> Vec3 {
        self.center
    }

    #[inline(always)]
    fn inner_radius(&self) -> Float {
        self.inner_radius
    }

    #[inline(always)]
    fn reach(&self) -> Float {
        self.reach
    }

    #[inline(always)]
    fn core_points(&self) -> CorePoints<'_> {
        CorePoints::Hull(self)
    }
}
