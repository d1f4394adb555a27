//! The narrow phase: where and how deep two shapes touch. Knows shapes and poses, no bodies.

use crate::math::{Float, Vec3};

/// The most points a manifold has.
pub const MAX_MANIFOLD_POINTS: usize = 4;

/// One point of contact between shape A and shape B, in the frame of A.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ManifoldPoint {
    /// The middle between the two surfaces along the normal \[m\].
    pub point: Vec3,
    /// The gap along the normal \[m\]: positive apart, negative overlapping.
    pub separation: Float,
    /// Which features of A and B made this point; the same features give the same number in the next step.
    pub feature: u32,
}

/// The contact between two convex shapes: up to four points that share a normal.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Manifold {
    /// The unit normal, from A to B, in the frame of A.
    pub normal: Vec3,
    /// The points, the first `count` of them.
    pub points: [ManifoldPoint; MAX_MANIFOLD_POINTS],
    /// How many points there are, 0 … 4.
    pub count: usize,
}
