//! Explicit Euler, the thesis's integrator (chapter 4.2): place and rotation go on with the velocities that the step
//! began with,
//!
//! ```text
//! x ← x + h v    p ← p + h F    R ← R + h ω* R, made orthonormal again    L ← L + h τ
//! ```
//!
//! The thesis prints the third line without its `R +`; with it, here, the method is first order. A throw is short of
//! its way by ½ h t g, and a tumbling body gains energy without bound. A body that a constraint holds goes on with
//! the velocity after the constraint: the other way a resting block would rise by h² g a step.

use super::{Integrator, PrincipalAxes, angular_velocity};
use crate::math::{Float, Quat, Vec3, turn};

/// Explicit Euler.
#[derive(Clone, Copy, Debug)]
pub struct ExplicitEuler;

impl Integrator for ExplicitEuler {
    const LAG: Float = 1.0;

    #[inline(always)]
    fn turn(q: &Quat, l: Vec3, axes: &PrincipalAxes, h: Float) -> Quat {
        turn(q, angular_velocity(q, l, axes) * h)
    }

    #[inline(always)]
    fn turn_by(q: &Quat, w: Vec3) -> Quat {
        turn(q, w)
    }
}
