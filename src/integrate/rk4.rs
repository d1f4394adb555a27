//! The classical Runge–Kutta method of fourth order on q̇ = ½ ω(q) q with L constant, the quaternion scaled back to
//! length 1 after the step. The thesis names this family as the better one. L is kept since it is the state; energy
//! drifts by h⁴ per unit of time, slowly but without bound. Steps that turn by more than [`MAX_TURN`] are taken in
//! pieces: far beyond it an explicit method is unstable.

use super::{Integrator, PrincipalAxes, angular_velocity, in_pieces};
use crate::math::{Float, Quat, Vec3, quat, vec3};
use nalgebra::Quaternion;

/// The greatest turn of a piece \[rad\].
const MAX_TURN: Float = 0.5;

/// Runge–Kutta of fourth order.
#[derive(Clone, Copy, Debug)]
pub struct Rk4;

impl Integrator for Rk4 {
    const LAG: Float = 0.5;

    fn turn(q: &Quat, l: Vec3, axes: &PrincipalAxes, h: Float) -> Quat {
        in_pieces(q, l, axes, h, MAX_TURN, |q, h| step(q, h, |q| angular_velocity(q, l, axes)))
    }

    fn turn_by(q: &Quat, w: Vec3) -> Quat {
        step(q, 1.0, |_| w)
    }
}

fn step(q: &Quat, h: Float, omega: impl Fn(&Quat) -> Vec3) -> Quat {
    let q0 = q.into_inner();
    // ½ ω q at a quaternion that may have lost its length.
    let slope = |q: Quaternion<Float>| {
        let w = omega(&quat(q.w, vec3(q.i, q.j, q.k)));
        Quaternion::new(0.0, 0.5 * w.x, 0.5 * w.y, 0.5 * w.z) * q
    };
    let k1 = slope(q0);
    let k2 = slope(q0 + k1 * (0.5 * h));
    let k3 = slope(q0 + k2 * (0.5 * h));
    let k4 = slope(q0 + k3 * h);
    let q1 = q0 + (k1 + (k2 + k3) * 2.0 + k4) * (h / 6.0);
    quat(q1.w, vec3(q1.i, q1.j, q1.k))
}
