//! A shape as it is drawn, and its surface in pieces.

use super::{Canvas, Color, colors};
use crate::math::scalar::{PI, sin_cos};
use crate::math::{Aabb, Float, Pose, Vec3, any_tangent, length, normalize_or, quat, vec3};
use crate::shape::{Polytope, Shape};
use crate::world::{BodyId, ShapeId};

/// How many corners a drawn circle has.
const AROUND: usize = 16;
/// How many rings the rounding of a drawn cap has.
const RINGS: usize = 4;

/// A shape that a [`Canvas`] is asked to draw.
#[derive(Clone, Copy, Debug)]
pub struct DrawnShape<'a> {
    /// Which one.
    pub id: ShapeId,
    /// Its body.
    pub body: BodyId,
    /// Its geometry in its own frame.
    pub shape: &'a Shape,
    /// World from the shape's frame.
    pub pose: Pose,
    /// Its own colour, or that of its body's state.
    pub color: Color,
    /// The box in which everything bounded lies: where a half-space, which has no end, is shown.
    pub scene: Aabb,
}

impl DrawnShape<'_> {
    /// Calls `face` with the corners of each flat face, counter-clockwise seen from outside, and its outward normal, in
    /// world coordinates. Of a half-space that is one square under the scene; round shapes have none.
    pub fn faces(&self, face: &mut dyn FnMut(&[Vec3], Vec3)) {
        match self.shape {
            Shape::Sphere(_) | Shape::Capsule(_) => {}
            Shape::Box(b) => faces_of(b, &self.pose, face),
            Shape::Hull(h) => faces_of(&**h, &self.pose, face),
            Shape::HalfSpace(_) => {
                let (corners, normal) = self.patch();
                face(&corners, normal);
            }
        }
    }

    /// Calls `triangle` with the corners of the triangles that make up the surface, counter-clockwise seen from
    /// outside, and their outward normals, in world coordinates. Balls and capsules are approximated from inside.
    pub fn triangles(&self, triangle: &mut dyn FnMut([Vec3; 3], Vec3)) {
        match self.shape {
            Shape::Sphere(_) | Shape::Capsule(_) => {
                let (pose, radius, half) = self.pill();
                round(radius, half, &mut |corners| {
                    let [a, b, c] = corners.map(|p| pose.point(p));
                    triangle([a, b, c], normalize_or((b - a).cross(&(c - a)), Vec3::y()));
                });
            }
            _ => self.faces(&mut |corners, normal| {
                for k in 2..corners.len() {
                    triangle([corners[0], corners[k - 1], corners[k]], normal);
                }
            }),
        }
    }

    /// Where the middle of a ball or capsule is, with y along its axis; its radius and half the length of its segment.
    ///
    /// # Panics
    /// For other shapes.
    #[must_use]
    pub(super) fn pill(&self) -> (Pose, Float, Float) {
        let (p, q, radius) = match self.shape {
            Shape::Sphere(s) => {
                return (Pose { p: self.pose.point(s.center()), ..self.pose }, s.radius(), 0.0);
            }
            Shape::Capsule(c) => (c.center1(), c.center2(), c.radius()),
            _ => unreachable!("a ball or a capsule"),
        };
        let along = normalize_or(q - p, Vec3::y());
        let local = Pose::new((p + q) * 0.5, from_y(along));
        (self.pose.then(&local), radius, 0.5 * length(q - p))
    }

    /// The square of a half-space's surface that lies under the scene, and its normal.
    fn patch(&self) -> ([Vec3; 4], Vec3) {
        let Shape::HalfSpace(h) = self.shape else { unreachable!("a half-space") };
        let n = self.pose.vector(h.normal());
        let on_plane = self.pose.point(h.normal() * h.offset());
        let center = self.scene.center();
        let middle = center - n * n.dot(&(center - on_plane));
        let u = any_tangent(n);
        let v = n.cross(&u);
        let reach = length(self.scene.half());
        let corner = |a: Float, b: Float| middle + (u * a + v * b) * reach;
        ([corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)], n)
    }

    /// Draws the edges: of round shapes some circles, and lines along a capsule.
    pub(super) fn edges(&self, canvas: &mut dyn Canvas) {
        match self.shape {
            Shape::Sphere(_) | Shape::Capsule(_) => {
                let (pose, radius, half) = self.pill();
                let [x, y, z] = [Vec3::x(), Vec3::y(), Vec3::z()].map(|e| pose.vector(e) * radius);
                let [top, bottom] = [half, -half].map(|h| pose.point(vec3(0.0, h, 0.0)));
                for (side, out) in [(x, y), (z, y)] {
                    arc(canvas, top, (side, out), (0.0, PI), colors::EDGE);
                    arc(canvas, bottom, (side, -out), (0.0, PI), colors::EDGE);
                }
                arc(canvas, top, (x, z), (0.0, 2.0 * PI), colors::EDGE);
                if half > 0.0 {
                    arc(canvas, bottom, (x, z), (0.0, 2.0 * PI), colors::EDGE);
                    for side in [x, -x, z, -z] {
                        canvas.segment(bottom + side, top + side, colors::EDGE);
                    }
                }
            }
            Shape::Box(b) => edges_of(b, &self.pose, canvas),
            Shape::Hull(h) => edges_of(&**h, &self.pose, canvas),
            Shape::HalfSpace(_) => {
                let (corners, _) = self.patch();
                for k in 0..4 {
                    canvas.segment(corners[k], corners[(k + 1) % 4], colors::EDGE);
                }
            }
        }
    }
}

fn faces_of(solid: &impl Polytope, pose: &Pose, face: &mut dyn FnMut(&[Vec3], Vec3)) {
    let mut corners = Vec::new();
    for f in 0..solid.face_count() {
        corners.clear();
        corners.extend(solid.face_vertices(f).iter().map(|&v| pose.point(solid.vertex(v as usize))));
        face(&corners, pose.vector(solid.plane(f).0));
    }
}

fn edges_of(solid: &impl Polytope, pose: &Pose, canvas: &mut dyn Canvas) {
    for e in 0..solid.edge_count() {
        let [from, to] = solid.edge(e).v.map(|v| pose.point(solid.vertex(v as usize)));
        canvas.segment(from, to, colors::EDGE);
    }
}

/// The rotation that takes y to this unit vector, the short way.
fn from_y(u: Vec3) -> crate::math::Quat {
    if u.y < -0.9999 {
        return quat(0.0, Vec3::x());
    }
    let (axis, s) = (Vec3::y().cross(&u), 1.0 + u.y);
    let n = (crate::math::length_squared(axis) + s * s).sqrt();
    quat(s / n, axis / n)
}

/// The surface of a capsule along y, or of a ball where `half` is 0.
fn round(radius: Float, half: Float, triangle: &mut dyn FnMut([Vec3; 3])) {
    // From pole to pole: height and radius of each ring.
    let mut rings = Vec::with_capacity(2 * RINGS + 2);
    for (shift, from) in [(-half, 0), (half, RINGS)] {
        for k in from..=from + RINGS {
            // A ball has one equator.
            if half == 0.0 && from > 0 && k == from {
                continue;
            }
            let (sine, cosine) = sin_cos(PI * (k as Float / (2 * RINGS) as Float - 0.5));
            let flat = if k == 0 || k == 2 * RINGS { 0.0 } else { radius * cosine };
            rings.push((shift + radius * sine, flat));
        }
    }
    let at = |(y, r): (Float, Float), k: usize| {
        let (sine, cosine) = sin_cos(2.0 * PI * ((k % AROUND) as Float / AROUND as Float));
        vec3(r * cosine, y, r * sine)
    };
    for pair in rings.windows(2) {
        let (below, above) = (pair[0], pair[1]);
        for k in 0..AROUND {
            let (a, b, c, d) = (at(below, k), at(above, k), at(above, k + 1), at(below, k + 1));
            if above.1 > 0.0 {
                triangle([a, b, c]);
            }
            if below.1 > 0.0 {
                triangle([a, c, d]);
            }
        }
    }
}

/// Draws an arc about `center`: at angle 0 it is at the first of the two axes, a quarter turn later at the second.
pub(super) fn arc(
    canvas: &mut dyn Canvas,
    center: Vec3,
    axes: (Vec3, Vec3),
    span: (Float, Float),
    color: Color,
) {
    let turn = (span.1 - span.0).clamp(0.0, 2.0 * PI);
    let steps = ((turn / (2.0 * PI) * AROUND as Float).ceil() as usize).max(1);
    let at = |k: usize| {
        let (sine, cosine) = sin_cos(span.0 + turn * (k as Float / steps as Float));
        center + axes.0 * cosine + axes.1 * sine
    };
    for k in 0..steps {
        canvas.segment(at(k), at(k + 1), color);
    }
}
