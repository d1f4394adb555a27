//! Moving bodies forward in time.
//!
//! State is place and rotation, momentum and angular momentum; forces change the momenta in kicks, and between kicks
//! a body moves freely. Translation then has a simple formula. Rotation has not: angular momentum L is constant in
//! the world, but a body whose moments of inertia differ tumbles under it. An integrator says how a body moves
//! through a sub-step, its L being given; constraints and kicks are the same for all.
//!
//! | variant | idea | from | order | cost of a turn | when | where it fails |
//! |---|---|---|---|---|---|---|
//! | [`ExplicitEuler`] | velocities of the start of the step | the thesis, 4.2 | 1 | tiny | to compare | gains energy without bound |
//! | [`SemiImplicitEuler`] | velocities of its end | most engines | 1 | tiny | to compare | ½ g h t off a throw; tumbling gains energy |
//! | [`MoserVeselov`] | the discrete top, pace and lag corrected | \[Moser, Veselov 1991\], \[McLachlan, Zanna 2005\] | 4 | 2–3 Newton steps | default | the angle of bodies that turn by more than 32 rad a step |
//! | [`SymmetricSplitting`] | five exact turns about principal axes | \[Dullweber, Leimkuhler, McLachlan 1997\] | 2 | five sines | a fixed cost is wanted | energy only within a band of h² |
//! | [`LieMidpoint`] | a turn by the ω of its middle | Buss 2000; Hairer, Lubich, Wanner ch. IV | 2 | an iteration | to compare | the same band |
//! | [`Rk4`] | four slopes | Runge, Kutta | 4 | four products with I⁻¹ | short, precise flights | energy drifts in the long run |
//! | [`ExactRotation`] | Jacobi's elliptic functions | \[van Zon, Schofield 2007\] | exact | some µs | free flight, the oracle | torque still comes in kicks |

mod exact_rotation;
mod explicit_euler;
mod lie_midpoint;
mod moser_veselov;
mod principal_axes;
mod rk4;
mod semi_implicit_euler;
mod symmetric_splitting;
#[cfg(test)]
mod tests;
mod turn;

pub use exact_rotation::ExactRotation;
pub use explicit_euler::ExplicitEuler;
pub use lie_midpoint::LieMidpoint;
pub use moser_veselov::{MoserVeselov, moser_veselov};
pub use principal_axes::{ISOTROPY, PrincipalAxes, is_isotropic};
pub use rk4::Rk4;
pub use semi_implicit_euler::SemiImplicitEuler;
pub use symmetric_splitting::SymmetricSplitting;
pub use turn::turn_by;

use crate::math::{Float, Quat, Vec3, length_squared, rotate, rotate_back};

/// The contract: how a body moves through a sub-step.
pub trait Integrator: Copy {
    /// By what share of the sub-step the velocities that move a free body lag behind those at its end: 0 takes those
    /// of the end, 1 those of the start, ½ is exact under a constant force.
    const LAG: Float;

    /// Turns a body by the time `h` \[s\] under the constant angular momentum `l` (world \[kg m²/s\]): returns its
    /// new world-from-body rotation. Moments are positive. Finite input gives finite output, however fast the body.
    fn turn(q: &Quat, l: Vec3, axes: &PrincipalAxes, h: Float) -> Quat;

    /// Turns a body whose angular velocity is constant, such as a sphere, by the rotation vector `w` = ω h \[rad\].
    #[inline(always)]
    #[must_use]
    fn turn_by(q: &Quat, w: Vec3) -> Quat {
        turn_by(q, w)
    }
}

/// Runs an expression with a name for the integrator of a kind: one choice outside of a loop, none inside.
macro_rules! with_integrator {
    ($kind:expr, $name:ident => $run:expr) => {
        match $kind {
            $crate::integrate::IntegratorKind::Auto | $crate::integrate::IntegratorKind::MoserVeselov => {
                type $name = $crate::integrate::MoserVeselov;
                $run
            }
            $crate::integrate::IntegratorKind::ExplicitEuler => {
                type $name = $crate::integrate::ExplicitEuler;
                $run
            }
            $crate::integrate::IntegratorKind::SemiImplicitEuler => {
                type $name = $crate::integrate::SemiImplicitEuler;
                $run
            }
            $crate::integrate::IntegratorKind::SymmetricSplitting => {
                type $name = $crate::integrate::SymmetricSplitting;
                $run
            }
            $crate::integrate::IntegratorKind::LieMidpoint => {
                type $name = $crate::integrate::LieMidpoint;
                $run
            }
            $crate::integrate::IntegratorKind::Rk4 => {
                type $name = $crate::integrate::Rk4;
                $run
            }
            $crate::integrate::IntegratorKind::ExactRotation => {
                type $name = $crate::integrate::ExactRotation;
                $run
            }
        }
    };
}
pub(crate) use with_integrator;

/// Which integrator. The numbers are part of the C ABI.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Hash)]
#[repr(i32)]
pub enum IntegratorKind {
    /// The engine chooses: today [`IntegratorKind::MoserVeselov`].
    #[default]
    Auto = 0,
    /// [`ExplicitEuler`].
    ExplicitEuler = 1,
    /// [`SemiImplicitEuler`].
    SemiImplicitEuler = 2,
    /// [`MoserVeselov`].
    MoserVeselov = 3,
    /// [`SymmetricSplitting`].
    SymmetricSplitting = 4,
    /// [`LieMidpoint`].
    LieMidpoint = 5,
    /// [`Rk4`].
    Rk4 = 6,
    /// [`ExactRotation`].
    ExactRotation = 7,
}

impl IntegratorKind {
    /// Every variant, without `Auto`.
    pub const ALL: [IntegratorKind; 7] = [
        Self::ExplicitEuler,
        Self::SemiImplicitEuler,
        Self::MoserVeselov,
        Self::SymmetricSplitting,
        Self::LieMidpoint,
        Self::Rk4,
        Self::ExactRotation,
    ];

    /// The variant's name, as its file is called.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::ExplicitEuler => "explicit_euler",
            Self::SemiImplicitEuler => "semi_implicit_euler",
            Self::MoserVeselov => "moser_veselov",
            Self::SymmetricSplitting => "symmetric_splitting",
            Self::LieMidpoint => "lie_midpoint",
            Self::Rk4 => "rk4",
            Self::ExactRotation => "exact_rotation",
        }
    }

    /// Turns a body freely by the time `h`: see [`Integrator::turn`].
    #[must_use]
    pub fn turn(self, q: &Quat, l: Vec3, axes: &PrincipalAxes, h: Float) -> Quat {
        with_integrator!(self, I => I::turn(q, l, axes, h))
    }
}

/// ω = R I⁻¹ Rᵀ L.
#[inline(always)]
fn angular_velocity(q: &Quat, l: Vec3, axes: &PrincipalAxes) -> Vec3 {
    let principal = &axes.body_from_principal;
    let p = rotate_back(principal, rotate_back(q, l));
    rotate(q, rotate(principal, p.component_div(&axes.moments)))
}

/// The most pieces of a step. A body that turns by more in the time asked for is turned by that much only: its
/// energy and L stay right, its angle had no meaning left.
const MAX_PIECES: Float = 64.0;

/// Takes a step in equal pieces whose turn is about `most` \[rad\] or less.
fn in_pieces(
    q: &Quat,
    l: Vec3,
    axes: &PrincipalAxes,
    h: Float,
    most: Float,
    step: impl Fn(&Quat, Float) -> Quat,
) -> Quat {
    let speed = length_squared(angular_velocity(q, l, axes)).sqrt();
    let pieces = (speed * h.abs() / most).min(Float::MAX);
    if pieces <= 1.0 {
        return step(q, h);
    }
    let count = (pieces as u32 as Float + 1.0).min(MAX_PIECES);
    let piece = if pieces > MAX_PIECES { h * (MAX_PIECES / pieces) / count } else { h / count };
    (0..count as u32).fold(*q, |q, _| step(&q, piece))
}
