//! Bodies: what persists from step to step.
//!
//! The state of a body is its centre of mass x, its rotation q, its momentum p and its angular momentum L about
//! the centre of mass, in world axes. Velocities are derived: v = p/m, ω = I_w⁻¹ L. Static and kinematic bodies
//! and dynamic ones without mass have no momentum; for them the columns p and L hold v and ω themselves.
//!
//! Data are split by who touches them: packed rows of awake bodies are what a step walks over
//! ([`store::BodySet`]); everything else waits in [`Body`], found by a stable index.

pub mod mass;
pub mod store;

pub use mass::MassProps;
pub use store::{BodySet, BodyStore, SetId};

use crate::math::{Float, Pose, Quat, Vec3, is_finite, rotate};
use crate::world::{BodyType, MotionLocks};

/// The moving state of a body. Written by `advance` and by setters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// Centre of mass in the world \[m\].
    pub x: Vec3,
    /// What rounding has left out of `x` so far \[m\]: it is added with the next move, so that slow or far bodies do
    /// not lose their way.
    pub x_rest: Vec3,
    /// World from body.
    pub q: Quat,
    /// Momentum \[kg m/s\]; the velocity \[m/s\] where the body has no mass.
    pub p: Vec3,
    /// Angular momentum about the centre of mass, world axes \[kg m²/s\]; ω \[rad/s\] where there is no inertia.
    pub l: Vec3,
}

impl Motion {
    /// Moves the centre of mass by `d`, compensating rounding (Kahan).
    #[inline(always)]
    pub fn shift(&mut self, d: Vec3) {
        let d = d + self.x_rest;
        let x = self.x + d;
        self.x_rest = d - (x - self.x);
        self.x = x;
    }

    /// Whether every number of it is finite.
    #[inline]
    #[must_use]
    pub fn is_finite(&self) -> bool {
        let q = &self.q;
        is_finite(self.x)
            && is_finite(self.p)
            && is_finite(self.l)
            && [q.w, q.i, q.j, q.k].iter().all(|c| c.is_finite())
    }

    /// Puts the centre of mass to `x`.
    #[inline(always)]
    pub fn place(&mut self, x: Vec3) {
        (self.x, self.x_rest) = (x, Vec3::zeros());
    }
}

/// What drives a body besides contacts. Forces are written by the user and cleared by `end`.
#[derive(Clone, Copy, Debug)]
pub struct Drive {
    /// Sum of the forces for the next step \[N\].
    pub force: Vec3,
    /// Sum of the torques about the centre of mass for the next step, world axes \[N m\].
    pub torque: Vec3,
    /// Factor on gravity.
    pub gravity_scale: Float,
    /// \[1/s\]
    pub linear_damping: Float,
    /// \[1/s\]
    pub angular_damping: Float,
    /// Locked directions.
    pub locks: MotionLocks,
    /// \[m/s\]
    pub sleep_threshold: Float,
    /// Whether the body may sleep.
    pub enable_sleep: bool,
    /// Whether the body is kinematic.
    pub kinematic: bool,
}

/// The part of a body that a step seldom touches.
#[derive(Clone, Debug)]
pub struct Body {
    /// Which set the body's row is in.
    pub set: SetId,
    /// Its row there.
    pub row: u32,
    /// How it moves.
    pub body_type: BodyType,
    /// Its shapes, in order of attachment (indices of colliders).
    pub shapes: Vec<u32>,
    /// Its contacts (indices of contacts), unordered.
    pub contacts: Vec<u32>,
    /// Its joints (indices of joints), unordered.
    pub joints: Vec<u32>,
    /// The island of an awake or sleeping dynamic body, or [`NONE`].
    pub island: u32,
    /// Its place in the island's list of bodies.
    pub island_place: u32,
    /// Whether mass data was given by the user and shapes no longer change it.
    pub mass_override: bool,
    /// Whether the body was put to rest because its state stopped being finite.
    pub quarantined: bool,
    /// A name for people.
    pub name: String,
    /// Anything.
    pub user_data: u64,
}

/// "No index".
pub const NONE: u32 = u32::MAX;

/// The world placement of a body's origin.
#[inline(always)]
#[must_use]
pub fn origin_pose(motion: &Motion, center: Vec3) -> Pose {
    Pose::new(motion.x - rotate(&motion.q, center), motion.q)
}
