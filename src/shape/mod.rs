//! Shapes: geometry in a frame of its own, shared by bodies and by queries without a world.
//!
//! The contract of a shape: validated construction, mass properties, a bounding box, a support function over a
//! core of points with a radius, faces for manifolds. Shapes know nothing of bodies.

mod capsule;
mod cuboid;
mod half_space;
mod hull;
mod sphere;

use crate::math::{Float, Mat3, Vec3};
use std::sync::Arc;

pub use capsule::Capsule;
pub use cuboid::Cuboid;
pub use half_space::HalfSpace;
pub use hull::Hull;
pub use sphere::Sphere;

/// Mass, centre of mass and inertia of a solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassData {
    /// \[kg\]
    pub mass: Float,
    /// The centre of mass in the shape's (or body's) frame \[m\].
    pub center: Vec3,
    /// The inertia tensor about the centre of mass, in the axes of the shape's (or body's) frame \[kg m²\].
    pub inertia: Mat3,
}

/// A solid, placed in a frame of its own. Cheap to clone: a hull's data are shared.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A ball.
    Sphere(Sphere),
    /// All points within a radius of a segment.
    Capsule(Capsule),
    /// A box, centred on the frame's origin with its axes along the frame's.
    Box(Cuboid),
    /// The convex hull of a point cloud.
    Hull(Arc<Hull>),
    /// Everything on one side of a plane. Static bodies only: it has no mass.
    HalfSpace(HalfSpace),
}
