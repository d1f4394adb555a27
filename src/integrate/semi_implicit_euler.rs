//! Semi-implicit (symplectic) Euler, what most engines use: velocities first, then place and rotation with the new
//! ones,
//!
//! ```text
//! p ← p + h F    x ← x + h v    L ← L + h τ    q ← normalise(q + ½ h ω q)
//! ```
//!
//! First order: a throw is ahead of its way by ½ h t g, energy oscillates about its value by as much but does not
//! drift. The rotation alone, under constant L, is that of explicit Euler, with its drift.

use super::{Integrator, PrincipalAxes, angular_velocity};
use crate::math::{Float, Quat, Vec3, turn};

/// Semi-implicit Euler.
#[derive(Clone, Copy, Debug)]
pub struct SemiImplicitEuler;

impl Integrator for SemiImplicitEuler {
    const LAG: Float = 0.0;

    #[inline(always)]
    fn turn(q: &Quat, l: Vec3, axes: &PrincipalAxes, h: Float) -> Quat {
        turn(q, angular_velocity(q, l, axes) * h)
    }

    #[inline(always)]
    fn turn_by(q: &Quat, w: Vec3) -> Quat {
        turn(q, w)
    }
}
