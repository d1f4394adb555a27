//! What the narrow phase asks of a solid with flat faces, be it a box with implicit tables or a hull.

use super::CorePoints;
use crate::math::{Float, Vec3, length, length_squared};

/// An edge between two faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge {
    /// The vertices at its ends.
    pub v: [u8; 2],
    /// The faces beside it: the loop of the first runs from `v[0]` to `v[1]`, that of the second back.
    pub f: [u16; 2],
}

/// An edge with what a separating-axis test needs of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct EdgeRay {
    pub start: Vec3,
    pub along: Vec3,
    /// The normals of the faces beside it, as in [`Edge::f`].
    pub normals: [Vec3; 2],
    /// The cosine of half the angle between them; 0 where rounding may turn an axis far out of the arc between them:
    /// the normals are too close to each other, or not at right angles to the edge.
    pub cosine: Float,
}

/// The least sine between the normals of an edge whose [`EdgeRay::cosine`] says something.
const LEAST_ARC: Float = 0.02;

/// The greatest cosine between such an edge and its normals.
const LEAST_SQUARE: Float = 4e-6;

impl EdgeRay {
    pub fn new(start: Vec3, along: Vec3, normals: [Vec3; 2]) -> Self {
        let across = length_squared(normals[0].cross(&normals[1]));
        let lean = normals.map(|n| n.dot(&along).abs());
        let is_clear =
            across >= LEAST_ARC * LEAST_ARC && lean[0].max(lean[1]) <= LEAST_SQUARE * length(along);
        let cosine = if is_clear { 0.5 * length(normals[0] + normals[1]) } else { 0.0 };
        Self { start, along, normals, cosine }
    }
}

/// A convex solid with flat faces, in its own frame.
pub(crate) trait Polytope {
    fn vertex_count(&self) -> usize;
    fn vertex(&self, i: usize) -> Vec3;
    fn face_count(&self) -> usize;
    /// The outward unit normal n and the offset d of the plane n · x = d.
    fn plane(&self, face: usize) -> (Vec3, Float);
    /// The vertices around a face, counter-clockwise seen from outside.
    fn face_vertices(&self, face: usize) -> &[u8];
    /// The edges around a face: number i runs from vertex i of the loop to the next.
    fn face_edges(&self, face: usize) -> &[u16];
    fn edge_count(&self) -> usize;
    fn edge(&self, i: usize) -> Edge;
    fn edge_ray(&self, i: usize) -> EdgeRay {
        let Edge { v, f } = self.edge(i);
        let start = self.vertex(v[0] as usize);
        let along = self.vertex(v[1] as usize) - start;
        EdgeRay::new(start, along, f.map(|f| self.plane(f as usize).0))
    }
    /// Whether vertices and faces are computed on demand rather than read from tables.
    const IMPLICIT: bool;
    /// The vertex farthest along `d` (any length).
    fn support(&self, d: Vec3) -> usize;
    /// The face whose normal is closest to `d`.
    fn face_along(&self, d: Vec3) -> usize;
    /// A point well inside.
    fn center(&self) -> Vec3;
    /// The least distance from the centre to a face.
    fn inner_radius(&self) -> Float;
    /// The greatest distance from the centre to a vertex.
    fn reach(&self) -> Float;
    /// The vertices as GJK wants them.
    fn core_points(&self) -> CorePoints<'_>;
}

/// Checks the tables of a polytope against each other: used by the tests of boxes and hulls.
#[cfg(test)]
pub(crate) fn assert_consistent(p: &impl Polytope) {
    let (v, e, f) = (p.vertex_count(), p.edge_count(), p.face_count());
    assert_eq!(v + f, e + 2, "Euler's formula: {v} vertices, {e} edges, {f} faces");
    let mut seen = vec![[false; 2]; e];
    for face in 0..f {
        let (vs, es) = (p.face_vertices(face), p.face_edges(face));
        assert!(vs.len() >= 3 && vs.len() == es.len());
        for i in 0..vs.len() {
            let (a, b) = (vs[i], vs[(i + 1) % vs.len()]);
            let edge = p.edge(es[i] as usize);
            let side = usize::from(edge.v != [a, b]);
            assert_eq!(if side == 0 { edge.v } else { [edge.v[1], edge.v[0]] }, [a, b]);
            assert_eq!(edge.f[side] as usize, face);
            assert!(
                !std::mem::replace(&mut seen[es[i] as usize][side], true),
                "a half-edge belongs to one face"
            );
        }
        let (n, _) = p.plane(face);
        assert!((crate::math::length(n) - 1.0).abs() < 1e-5);
        // The loop turns counter-clockwise about the normal.
        let first = p.vertex(vs[0] as usize);
        let area = (1..vs.len() - 1)
            .map(|i| (p.vertex(vs[i] as usize) - first).cross(&(p.vertex(vs[i + 1] as usize) - first)))
            .fold(Vec3::zeros(), |s, x| s + x);
        assert!(area.dot(&n) > 0.0);
    }
    assert!(seen.iter().all(|s| s[0] && s[1]));
}
