//! The implicit midpoint rule on the rotation group: the step is a turn by h ω with ω taken in the middle of it,
//!
//! ```text
//! R₁ = exp(h ω) R₀,   ω = R_m I⁻¹ R_mᵀ L,   R_m = exp(½ h ω) R₀
//! ```
//!
//! found by fixed-point iteration, which contracts by about |ω|h/2 a round. Second order and time-symmetric, so L is
//! kept and the energy stays within a band of h². Steps that turn by more than [`MAX_TURN`] are taken in pieces.

use super::{Integrator, PrincipalAxes, angular_velocity, in_pieces, turn_by};
use crate::math::{Float, Quat, Vec3, length_squared, tolerance::EPSILON};

/// The greatest turn of a piece \[rad\]: there the iteration converges fast.
const MAX_TURN: Float = 0.5;

/// Rounds of the iteration; a third of them suffices at [`MAX_TURN`] in f32.
const ROUNDS: usize = 40;

/// Implicit Lie midpoint.
#[derive(Clone, Copy, Debug)]
pub struct LieMidpoint;

impl Integrator for LieMidpoint {
    const LAG: Float = 0.5;

    fn turn(q: &Quat, l: Vec3, axes: &PrincipalAxes, h: Float) -> Quat {
        in_pieces(q, l, axes, h, MAX_TURN, |q, h| {
            let mut w = angular_velocity(q, l, axes);
            for _ in 0..ROUNDS {
                let next = angular_velocity(&turn_by(q, w * (0.5 * h)), l, axes);
                let change = length_squared(next - w);
                w = next;
                if change <= EPSILON * EPSILON * length_squared(w) {
                    break;
                }
            }
            turn_by(q, w * h)
        })
    }
}
