//! Joints: what holds two bodies to each other, or moves them against each other.
//!
//! A joint sits between a frame fixed in body A and one fixed in body B, both given from the bodies' origins. Each
//! file below writes down what one kind of joint asks of the two frames: a list of rows, each with its error C, its
//! Jacobian and a [`Law`]. Solvers know rows only.
//!
//! | joint | holds | leaves free | axis |
//! |---|---|---|---|
//! | [`distance`] | the distance of two points (rod, rope, spring) | all else | the line between them |
//! | [`revolute`] | points together, axes along each other | a turn | z of both frames |
//! | [`prismatic`] | frames along each other | a slide | x of frame A |
//! | [`spherical`] | points together | all turns, within cone and twist | z of both frames |
//! | [`weld`] | frames together, rigidly or by springs | nothing | – |
//! | [`wheel`] | a wheel on its suspension | slide, spin, steering | x of A: slide and steering; z of B: spin |
//! | [`motor`] | drives frame B to or against frame A | all | – |
//! | [`parallel`] | z axes along each other, by a spring | all else | z |
//! | [`filter`](JointKind::Filter) | nothing: the bodies do not collide | all | – |
//! | [`universal`] | points together, x of A across y of B | two turns | x of A, y of B |
//! | [`six_dof`] | what it is told to | the rest | the axes of frame A |
//! | [`gear`] | the ratio of two joints' coordinates (gears, rack and pinion) | all else | of those joints |
//! | [`pulley`] | a rope over two fixed points | all else | the two lines |
//! | [`screw`] | a slide in step with a turn | that motion | x of both frames |

pub mod distance;
pub mod gear;
pub mod geometry;
pub mod motor;
pub mod parallel;
mod parts;
pub mod prismatic;
pub mod pulley;
pub mod revolute;
pub mod screw;
pub mod six_dof;
pub mod spherical;
pub mod store;
pub mod universal;
pub mod weld;
pub mod wheel;

pub use distance::DistanceJoint;
pub use gear::GearJoint;
pub use geometry::{Angle, Geometry, swing_twist};
pub use motor::MotorJoint;
pub use parallel::ParallelJoint;
pub use parts::{Drive, Limit, Motor, Spring, about as axis_sides};
pub use prismatic::PrismaticJoint;
pub use pulley::PulleyJoint;
pub use revolute::RevoluteJoint;
pub use screw::ScrewJoint;
pub use six_dof::{AxisMode, SixDofJoint};
pub use spherical::SphericalJoint;
pub use store::{Joint, JointStore};
pub use universal::UniversalJoint;
pub use weld::WeldJoint;
pub use wheel::WheelJoint;

use crate::error::Result;
use crate::math::{Float, Vec3};
use parts::along;

/// What is between the two frames, with its parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(clippy::large_enum_variant, reason = "stored once a joint; boxes would only scatter them")]
pub enum JointKind {
    /// See [`distance`].
    Distance(DistanceJoint),
    /// The bodies do not collide, nothing else.
    Filter,
    /// See [`motor`].
    Motor(MotorJoint),
    /// See [`parallel`].
    Parallel(ParallelJoint),
    /// See [`prismatic`].
    Prismatic(PrismaticJoint),
    /// See [`revolute`].
    Revolute(RevoluteJoint),
    /// See [`spherical`].
    Spherical(SphericalJoint),
    /// See [`weld`].
    Weld(WeldJoint),
    /// See [`wheel`].
    Wheel(WheelJoint),
    /// See [`universal`].
    Universal(UniversalJoint),
    /// See [`six_dof`].
    SixDof(SixDofJoint),
    /// See [`gear`].
    Gear(GearJoint),
    /// A [`gear`] between a revolute and a prismatic joint.
    RackPinion(GearJoint),
    /// See [`pulley`].
    Pulley(PulleyJoint),
    /// See [`screw`].
    Screw(ScrewJoint),
}

impl JointKind {
    /// The joint's name, as its file is called.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Distance(_) => "distance",
            Self::Filter => "filter",
            Self::Motor(_) => "motor",
            Self::Parallel(_) => "parallel",
            Self::Prismatic(_) => "prismatic",
            Self::Revolute(_) => "revolute",
            Self::Spherical(_) => "spherical",
            Self::Weld(_) => "weld",
            Self::Wheel(_) => "wheel",
            Self::Universal(_) => "universal",
            Self::SixDof(_) => "six_dof",
            Self::Gear(_) => "gear",
            Self::RackPinion(_) => "rack_pinion",
            Self::Pulley(_) => "pulley",
            Self::Screw(_) => "screw",
        }
    }

    /// Checks every parameter.
    ///
    /// # Errors
    /// NotFinite, Range: which one and what it must be.
    pub fn validate(&self) -> Result<()> {
        match self {
            Self::Distance(j) => j.validate(),
            Self::Filter => Ok(()),
            Self::Motor(j) => j.validate(),
            Self::Parallel(j) => j.validate(),
            Self::Prismatic(j) => j.validate(),
            Self::Revolute(j) => j.validate(),
            Self::Spherical(j) => j.validate(),
            Self::Weld(j) => j.validate(),
            Self::Wheel(j) => j.validate(),
            Self::Universal(j) => j.validate(),
            Self::SixDof(j) => j.validate(),
            Self::Gear(j) | Self::RackPinion(j) => j.validate(),
            Self::Pulley(j) => j.validate(),
            Self::Screw(j) => j.validate(),
        }
    }

    /// The rows of a joint whose frames are at `g`. The same joint gives the same rows in the same order each time.
    pub fn emit(&self, g: &Geometry, rows: &mut impl Rows) {
        match self {
            Self::Distance(j) => j.emit(g, rows),
            Self::Filter | Self::Gear(_) | Self::RackPinion(_) => {}
            Self::Motor(j) => j.emit(g, rows),
            Self::Parallel(j) => j.emit(g, rows),
            Self::Prismatic(j) => j.emit(g, rows),
            Self::Revolute(j) => j.emit(g, rows),
            Self::Spherical(j) => j.emit(g, rows),
            Self::Weld(j) => j.emit(g, rows),
            Self::Wheel(j) => j.emit(g, rows),
            Self::Universal(j) => j.emit(g, rows),
            Self::SixDof(j) => j.emit(g, rows),
            Self::Pulley(j) => j.emit(g, rows),
            Self::Screw(j) => j.emit(g, rows),
        }
    }

    /// The same as a list.
    #[must_use]
    pub fn rows(&self, g: &Geometry) -> Vec<JointRow> {
        let mut rows = Vec::new();
        self.emit(g, &mut |row: JointRow| rows.push(row));
        rows
    }

    /// Whether two kinds are the same joint with maybe other parameters.
    #[must_use]
    pub fn is_same_joint(&self, other: &Self) -> bool {
        std::mem::discriminant(self) == std::mem::discriminant(other)
    }
}

/// What a row does with its error C and its velocity Ċ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
    /// C = 0.
    Equal,
    /// C ≥ 0, by a force that only pushes C up.
    AtLeast,
    /// A spring of this frequency \[Hz\] and damping ratio towards C = 0, its force within these bounds \[N, N m\].
    Spring {
        /// ≥ 0; 0 has no effect.
        hertz: Float,
        /// ≥ 0.
        damping_ratio: Float,
        /// The least and the greatest force.
        force: [Float; 2],
    },
    /// Ċ = `speed`, by a force of at most `max` \[N, N m\]. Dry friction is a motor of speed 0.
    Motor {
        /// \[m/s, rad/s\]
        speed: Float,
        /// ≥ 0.
        max: Float,
    },
}

impl Law {
    /// Whether it puts no bound on the impulse.
    #[must_use]
    pub fn is_unbounded(&self) -> bool {
        match self {
            Law::Equal => true,
            Law::AtLeast | Law::Motor { .. } => false,
            Law::Spring { force, .. } => force[0] == Float::NEG_INFINITY && force[1] == Float::INFINITY,
        }
    }
}

/// One side of a row: what of a body's velocity and angular velocity it sees, and where its impulse acts.
#[derive(Clone, Copy, Debug, Default)]
pub struct Side {
    /// Along which direction, world axes.
    pub linear: Vec3,
    /// About which, world axes.
    pub angular: Vec3,
}

impl Side {
    /// With the opposite sign.
    #[must_use]
    pub fn reversed(self) -> Self {
        Self { linear: -self.linear, angular: -self.angular }
    }

    /// Multiplied by a factor.
    #[must_use]
    pub fn times(self, k: Float) -> Self {
        Self { linear: self.linear * k, angular: self.angular * k }
    }
}

/// A row: Ċ = Σ linear · v + angular · ω over its sides.
#[derive(Clone, Copy, Debug)]
pub struct JointRow {
    /// Of bodies A and B, signs included.
    pub sides: [Side; 2],
    /// Of two bodies more, where the row has four.
    pub more: Option<[Side; 2]>,
    /// The error.
    pub c: Float,
    /// What is done about it.
    pub law: Law,
    /// Whether it counts turns \[rad\] rather than lengths \[m\].
    pub angular: bool,
}

/// The most rows of a joint: six axes with a hard row or two limits, a spring, a motor and friction each.
pub const MAX_ROWS: usize = 36;

/// What takes the rows of a joint, in the joint's own order, as they are written down: any function of a row.
pub trait Rows {
    /// Takes a row.
    fn push(&mut self, row: JointRow);

    /// A row that sees how B's point at `arm_b` moves against A's at `arm_a` along `u` (arms from the centres of
    /// mass).
    #[inline]
    fn linear(&mut self, u: Vec3, arm_a: Vec3, arm_b: Vec3, c: Float, law: Law) {
        self.general(along(u, [arm_a, arm_b]), c, law, false);
    }

    /// A row that sees how B turns against A about `u`.
    #[inline]
    fn angular(&mut self, u: Vec3, c: Float, law: Law) {
        self.general(axis_sides(u), c, law, true);
    }

    /// A row with these sides.
    #[inline]
    fn general(&mut self, sides: [Side; 2], c: Float, law: Law, angular: bool) {
        self.push(JointRow { sides, more: None, c, law, angular });
    }
}

impl<F: FnMut(JointRow)> Rows for F {
    #[inline]
    fn push(&mut self, row: JointRow) {
        self(row);
    }
}
