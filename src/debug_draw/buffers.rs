//! The canvas that collects everything in arrays, as graphics hardware and plots want it.

use super::{Canvas, Color, DrawOptions, DrawnShape};
use crate::error::Result;
use crate::math::{Float, Pose, Vec3, vec3};
use crate::shape::Shape;
use crate::world::{ShapeId, World};

/// A line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Its ends \[m\].
    pub points: [Vec3; 2],
    /// Its colour.
    pub color: Color,
}

/// A triangle of a shape's surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// Its corners, counter-clockwise seen from outside \[m\].
    pub points: [Vec3; 3],
    /// The outward unit normal.
    pub normal: Vec3,
    /// Its colour.
    pub color: Color,
    /// Whose it is.
    pub shape: ShapeId,
}

/// What an instance is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InstanceKind {
    /// A ball: `size` is (radius, radius, radius).
    Sphere = 0,
    /// A capsule along y: `size` is (radius, half the length of its segment, radius).
    Capsule = 1,
    /// A box: `size` is its half extents.
    Box = 2,
}

/// A shape that is drawn from a unit mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Instance {
    /// What it is.
    pub kind: InstanceKind,
    /// World from the frame in which it is centred.
    pub pose: Pose,
    /// By kind \[m\].
    pub size: Vec3,
    /// Its colour.
    pub color: Color,
    /// Whose it is.
    pub shape: ShapeId,
}

/// A point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Where \[m\].
    pub position: Vec3,
    /// In pixels.
    pub size: Float,
    /// Its colour.
    pub color: Color,
}

/// A text.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// Where \[m\].
    pub position: Vec3,
    /// What it says.
    pub text: String,
    /// Its colour.
    pub color: Color,
}

/// A drawing in arrays.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DrawBuffers {
    /// Whether balls, capsules and boxes come as triangles rather than as instances; default false.
    pub tessellate: bool,
    /// Edges, joints, boxes, normals, forces, frames.
    pub lines: Vec<Line>,
    /// The surfaces of shapes that are no instances.
    pub triangles: Vec<Triangle>,
    /// Balls, capsules and boxes.
    pub instances: Vec<Instance>,
    /// Contacts, centres of mass, ends of ropes.
    pub points: Vec<Point>,
    /// Names and numbers.
    pub texts: Vec<Text>,
}

impl DrawBuffers {
    /// Fills the arrays anew; they keep their room.
    ///
    /// # Errors
    /// What [`DrawOptions::validate`] says; the arrays are empty then.
    pub fn fill(&mut self, world: &World, options: &DrawOptions) -> Result<()> {
        self.clear();
        world.draw(options, self)
    }

    /// Empties the arrays.
    pub fn clear(&mut self) {
        self.lines.clear();
        self.triangles.clear();
        self.instances.clear();
        self.points.clear();
        self.texts.clear();
    }
}

impl Canvas for DrawBuffers {
    fn shape(&mut self, shape: &DrawnShape<'_>) {
        let instance = if self.tessellate { None } else { instance(shape) };
        match instance {
            Some(instance) => self.instances.push(instance),
            None => shape.triangles(&mut |points, normal| {
                self.triangles.push(Triangle { points, normal, color: shape.color, shape: shape.id });
            }),
        }
    }

    fn segment(&mut self, from: Vec3, to: Vec3, color: Color) {
        self.lines.push(Line { points: [from, to], color });
    }

    fn point(&mut self, position: Vec3, size: Float, color: Color) {
        self.points.push(Point { position, size, color });
    }

    fn text(&mut self, position: Vec3, text: &str, color: Color) {
        self.texts.push(Text { position, text: text.to_owned(), color });
    }
}

/// A shape as an instance, if it is of a kind that has them.
fn instance(shape: &DrawnShape<'_>) -> Option<Instance> {
    let (kind, pose, size) = match shape.shape {
        Shape::Sphere(_) => {
            let (pose, radius, _) = shape.pill();
            (InstanceKind::Sphere, pose, vec3(radius, radius, radius))
        }
        Shape::Capsule(_) => {
            let (pose, radius, half) = shape.pill();
            (InstanceKind::Capsule, pose, vec3(radius, half, radius))
        }
        Shape::Box(b) => (InstanceKind::Box, shape.pose, b.half()),
        Shape::Hull(_) | Shape::HalfSpace(_) => return None,
    };
    Some(Instance { kind, pose, size, color: shape.color, shape: shape.id })
}
