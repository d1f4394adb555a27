//! The exact free rotation, by Jacobi's elliptic functions. In the principal frame, axes sorted so that c is the one
//! that the motion circles about (the largest moment where L² > 2 E I_b, else the smallest), b the middle one,
//!
//! ```text
//! p_a = P_a cn(λt + ε | m)   p_b = P_b sn(λt + ε | m)   p_c = P_c dn(λt + ε | m)
//! λ² = (L² − 2E I_a)(I_c − I_b) / (I_a I_b I_c)
//! m  = (I_b − I_a)(2E I_c − L²) / ((I_c − I_b)(L² − 2E I_a))
//! ```
//!
//! The addition theorems continue them from the given state, so no phase ε is ever looked for. What is left of the
//! rotation is a twist about L: with u = p/|L| in the body's frame, the turn since the start takes u to u₀; it is the
//! smallest such turn followed by one about u₀ by χ, where
//!
//! ```text
//! χ̇ = ω · (u + u₀) / (1 + u · u₀)
//! ```
//!
//! which is smooth as long as u is near u₀; Gauss's rule integrates it to the last bits over a quarter turn. (van Zon
//! & Schofield 2007 take theta functions for the same purpose; Lawden, *Elliptic Functions*, has the theorems.)
//! Double precision in both builds. Costs some microseconds: for free flight and as the oracle of its neighbours.

use super::{Integrator, PrincipalAxes, in_pieces};
use crate::math::scalar::{double, single};
use crate::math::{Float, Quat, Vec3};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// The greatest turn of a piece \[rad\].
const MAX_TURN: Float = 0.5;

/// Gauss–Legendre nodes on (0, 1) and weights.
const NODES: [(f64, f64); 5] = [
    (0.046_910_077_030_668, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_45, 0.239_314_335_249_683_23),
    (0.5, 0.284_444_444_444_444_44),
    (0.769_234_655_052_841_5, 0.239_314_335_249_683_23),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

/// Exact free rotation.
#[derive(Clone, Copy, Debug)]
pub struct ExactRotation;

impl Integrator for ExactRotation {
    const LAG: Float = 0.5;

    fn turn(q: &Quat, l: Vec3, axes: &PrincipalAxes, h: Float) -> Quat {
        let wide = |q: &Quat| {
            UnitQuaternion::new_normalize(Quaternion::new(double(q.w), double(q.i), double(q.j), double(q.k)))
        };
        let principal = wide(&axes.body_from_principal);
        let moments = axes.moments.map(double);
        let l = l.map(double);
        in_pieces(q, single_vec(&l), axes, h, MAX_TURN, |q, h| {
            let from = wide(q) * principal;
            let to = from * exact_turn(from.conjugate() * l, &moments, double(h)) * principal.conjugate();
            Quat::new_unchecked(Quaternion::new(single(to.w), single(to.i), single(to.j), single(to.k)))
        })
    }
}

fn single_vec(v: &Vector3<f64>) -> Vec3 {
    v.map(single)
}

/// The turn in the time `h`, in the principal frame at its start, of a body whose angular momentum is `p` there. It
/// should be less than a quarter turn.
fn exact_turn(p: Vector3<f64>, moments: &Vector3<f64>, h: f64) -> UnitQuaternion<f64> {
    let size = p.norm();
    if size == 0.0 || h == 0.0 || moments.min() <= 0.0 {
        return UnitQuaternion::identity();
    }
    if moments.max() == moments.min() {
        return UnitQuaternion::new(p * (h / moments.x));
    }
    let motion = Elliptic::new(&p, moments);
    let u0 = p / size;
    let mut twist = 0.0;
    for (node, weight) in NODES {
        let at = motion.momentum(node * h);
        let (omega, u) = (at.component_div(moments), at / size);
        twist += weight * omega.dot(&(u + u0)) / (1.0 + u.dot(&u0));
    }
    let u = motion.momentum(h) / size;
    let (s, c) = (libm::sin(0.5 * twist * h), libm::cos(0.5 * twist * h));
    let about = Quaternion::from_parts(c, u0 * s);
    let smallest = Quaternion::from_parts(1.0 + u.dot(&u0), u.cross(&u0));
    UnitQuaternion::new_normalize(about * smallest)
}

/// How the body-frame momentum moves.
struct Elliptic {
    axis: [usize; 3],
    /// P_a, ±P_b, ±P_c.
    amplitude: [f64; 3],
    rate: f64,
    m: f64,
    /// cn, sn, dn at time 0.
    start: [f64; 3],
}

impl Elliptic {
    fn new(p: &Vector3<f64>, moments: &Vector3<f64>) -> Self {
        let mut axis = [0, 1, 2];
        axis.sort_by(|&i, &j| moments[i].total_cmp(&moments[j]));
        let b = axis[1];
        // L² − 2E I, without taking nearly equal numbers from each other.
        let excess = |i: usize| -> f64 {
            (0..3).map(|k| p[k] * p[k] * ((moments[k] - moments[i]) / moments[k])).sum()
        };
        if excess(b) < 0.0 || moments[b] == moments[axis[2]] {
            axis.swap(0, 2);
        }
        let [a, b, c] = axis;
        let (ia, ib, ic) = (moments[a], moments[b], moments[c]);
        let (over_a, under_c) = (excess(a), -excess(c));
        let share = |x: f64, y: f64| if y == 0.0 { 0.0 } else { (x / y).max(0.0) };
        let pa = share(ia * under_c, ic - ia).sqrt();
        let pb = share(ib * under_c, ic - ib).sqrt();
        let pc = share(ic * over_a, ic - ia).sqrt();
        let rate = (over_a * (ic - ib) / (ia * ib * ic)).max(0.0).sqrt();
        let m = share((ib - ia) * under_c, (ic - ib) * over_a).min(1.0);
        // Which way round: the sign of ṗ_b = ±p_c p_a (1/I_a − 1/I_c), by the order of the axes.
        let even = (b + 3 - a) % 3 == 1;
        let forward = even == ((p[c] >= 0.0) == (1.0 / ia >= 1.0 / ic));
        let amplitude = [pa, if forward { pb } else { -pb }, if p[c] < 0.0 { -pc } else { pc }];
        let part = |k: usize| if amplitude[k] == 0.0 { 0.0 } else { p[axis[k]] / amplitude[k] };
        let (cn, sn) = (part(0), part(1));
        let length = (cn * cn + sn * sn).sqrt();
        let start = if length > 0.0 {
            // Not √(1 − m sn²): near the unstable axis that has no digits, and the motion grows from them.
            [cn / length, sn / length, part(2)]
        } else {
            [1.0, 0.0, 1.0]
        };
        Self { axis, amplitude, rate, m, start }
    }

    /// At time `t`, by the addition theorems.
    fn momentum(&self, t: f64) -> Vector3<f64> {
        let [c1, s1, d1] = self.start;
        let [c2, s2, d2] = jacobi(self.rate * t, self.m);
        let below = 1.0 / (1.0 - self.m * s1 * s1 * s2 * s2);
        let cn = (c1 * c2 - s1 * s2 * d1 * d2) * below;
        let sn = (s1 * c2 * d2 + s2 * c1 * d1) * below;
        let dn = (d1 * d2 - self.m * s1 * s2 * c1 * c2) * below;
        let mut p = Vector3::zeros();
        for (k, f) in [cn, sn, dn].into_iter().enumerate() {
            p[self.axis[k]] = self.amplitude[k] * f;
        }
        p
    }
}

/// Jacobi's cn, sn, dn of `u` for the parameter 0 ≤ m ≤ 1, by the arithmetic–geometric mean (Abramowitz & Stegun
/// 16.4); for m = 1 the hyperbolic functions.
fn jacobi(u: f64, m: f64) -> [f64; 3] {
    if m >= 1.0 {
        let sech = 1.0 / libm::cosh(u);
        return [sech, libm::tanh(u), sech];
    }
    const ROUNDS: usize = 12;
    let mut ratio = [0.0; ROUNDS];
    let (mut a, mut b, mut n, mut scale) = (1.0, (1.0 - m).sqrt(), 0, 1.0);
    let mut c = m.sqrt();
    while n < ROUNDS && c.abs() > f64::EPSILON * a {
        (a, b, c) = (0.5 * (a + b), (a * b).sqrt(), 0.5 * (a - b));
        ratio[n] = c / a;
        scale *= 2.0;
        n += 1;
    }
    let mut phi = scale * a * u;
    for r in ratio[..n].iter().rev() {
        phi = 0.5 * (phi + libm::asin((r * libm::sin(phi)).clamp(-1.0, 1.0)));
    }
    let (sn, cn) = (libm::sin(phi), libm::cos(phi));
    [cn, sn, (1.0 - m * sn * sn).max(0.0).sqrt()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn jacobi_functions_agree_with_tables() {
        // Abramowitz & Stegun's examples 16: dn(0.20 | 0.19), cs(0.53601 62 | 0.09), sn of a quarter period.
        let [_, _, dn] = jacobi(0.20, 0.19);
        assert!((dn - 0.996_253).abs() < 1e-6, "{dn}");
        let [cn, sn, _] = jacobi(0.536_016_2, 0.09);
        assert!((cn / sn - 1.691_808_3).abs() < 1e-6, "{}", cn / sn);
        // K(1/2) = 1.854074677301372.
        let [cn, sn, dn] = jacobi(1.854_074_677_301_372, 0.5);
        assert!(cn.abs() < 1e-14 && (sn - 1.0).abs() < 1e-14 && (dn - 0.5_f64.sqrt()).abs() < 1e-14);
        assert_eq!(jacobi(0.7, 0.0), [libm::cos(0.7), libm::sin(0.7), 1.0]);
    }

    #[test]
    fn the_momentum_obeys_eulers_equations() {
        let moments = Vector3::new(0.808_333, 0.683_333, 0.141_667);
        for p in [
            Vector3::new(0.1, 3.0, 0.05),
            Vector3::new(-2.0, 0.1, 0.4),
            Vector3::new(0.3, -0.2, -0.9),
            Vector3::new(0.0, 1.0, 0.0),
            Vector3::new(0.7, 0.0, -0.2),
        ] {
            for moments in [moments, moments.yxz(), moments.zxy(), Vector3::new(1.0, 1.0, 0.4)] {
                let motion = Elliptic::new(&p, &moments);
                assert!((motion.momentum(0.0) - p).norm() < 1e-14);
                for t in [0.0, 0.3, 1.0, -2.0] {
                    let step = 1e-5;
                    let slope = (motion.momentum(t + step) - motion.momentum(t - step)) / (2.0 * step);
                    let at = motion.momentum(t);
                    let want = at.cross(&at.component_div(&moments));
                    assert!((slope - want).norm() < 1e-7 * (1.0 + want.norm()), "{p} {moments} at {t}");
                }
            }
        }
    }
}
