//! A body without torque: L is constant in the world, p = Rᵀ L its image in the principal frame, ω = I⁻¹ p.
//!
//! The discrete top of Moser and Veselov turns by a rotation whose Cayley vector f = axis · tan(θ/2) solves
//!
//! ```text
//! h p + h p×f + h (p·f) f = 2 I f
//! ```
//!
//! It keeps L by construction and the energy ½ p·I⁻¹ p exactly, for steps of any size. Its path is the true one,
//! walked at a slightly wrong pace: with u = h p / 2, w = I⁻¹ u and γᵢ = (Iⱼ + Iₖ − Iᵢ) / (Iⱼ Iₖ), the tumbling runs
//! ahead by the share Σ (2 + Iᵢ γᵢ) wᵢ² / 3, and after correcting that the whole body lags about L by twice the
//! angle u Σ γᵢ wᵢ² / 3. Both sums depend on energy and |L| alone, so both errors are removed at the price of a
//! few products, and the order rises from two to four. \[McLachlan, Zanna 2005\] prove the change of pace; the sums
//! here were fitted to the exact motion and come out at these fractions to four digits.

use super::{Integrator, PrincipalAxes};
use crate::math::{Float, Quat, Vec3, length_squared, quat, rotate, rotate_back, tolerance::EPSILON, vec3};

/// The engine's own: ballistic translation, discrete Moser–Veselov rotation.
#[derive(Clone, Copy, Debug)]
pub struct MoserVeselov;

impl Integrator for MoserVeselov {
    const LAG: Float = 0.5;

    #[inline(always)]
    fn turn(q: &Quat, l: Vec3, axes: &PrincipalAxes, h: Float) -> Quat {
        moser_veselov(q, l, axes, h)
    }
}

/// The greatest turn of one solve \[rad\].
const MAX_TURN: Float = 0.5;

/// The most solves a call makes. A body that turns by more than some 32 rad in the time asked for is turned by
/// that much only: its energy and L stay right, its angle had no meaning left.
const MAX_SOLVES: usize = 64;

/// Newton steps of a solve: they reach the last bits from a turn of [`MAX_TURN`].
const NEWTON_STEPS: usize = if size_of::<Float>() == 4 { 2 } else { 3 };

/// Up to this turn \[rad\] a Newton step less reaches them.
const SMALL_TURN: Float = 0.1;

/// Turns a free body by the time `h` \[s\]: returns its new world-from-body rotation.
///
/// `q` is the world-from-body rotation, `l` the angular momentum in the world \[kg m²/s\], which stays as it is;
/// ω follows as R I⁻¹ Rᵀ l. Fast bodies are turned in several solves, at most 64.
#[must_use]
pub fn moser_veselov(q: &Quat, l: Vec3, axes: &PrincipalAxes, h: Float) -> Quat {
    // Moments relative to the largest keep every product below within f32's range.
    let scale = 1.0 / axes.moments.max();
    let m = axes.moments.map(|m| (m * scale).max(EPSILON));
    let inv = vec3(m.y * m.z, m.z * m.x, m.x * m.y) * (1.0 / (m.x * m.y * m.z));
    let top = Top { moments: m, inv };
    let half_l = l * (0.5 * scale);
    let (mut q, mut left) = (*q, h);
    for _ in 0..MAX_SOLVES {
        let p = rotate_back(&axes.body_from_principal, rotate_back(&q, half_l));
        let turn = 2.0 * left.abs() * length_squared(p.component_mul(&top.inv)).sqrt();
        if turn <= MAX_TURN {
            let steps = if turn <= SMALL_TURN { NEWTON_STEPS - 1 } else { NEWTON_STEPS };
            return advance(&q, &top, p * left, axes, steps);
        }
        let pieces = (turn / MAX_TURN) as u32 as Float + 1.0;
        let piece = left / pieces;
        q = advance(&q, &top, p * piece, axes, NEWTON_STEPS);
        left -= piece;
    }
    q
}

/// Moments of inertia relative to the largest, and their inverses.
struct Top {
    moments: Vec3,
    inv: Vec3,
}

/// One solve; `u` is half of h p, over the largest moment.
#[inline(always)]
fn advance(q: &Quat, top: &Top, u: Vec3, axes: &PrincipalAxes, steps: usize) -> Quat {
    let (lag, pace) = top.corrections(u);
    let (f, g) = (top.cayley(u * pace, steps), u * lag);
    // (1, g) ∘ (1, f) in the principal frame; the body's frame has the same scalar part.
    let (s, v) = (1.0 - g.dot(&f), rotate(&axes.body_from_principal, f + g + g.cross(&f)));
    let qv = vec3(q.i, q.j, q.k);
    quat(q.w * s - qv.dot(&v), v * q.w + qv * s + qv.cross(&v))
}

impl Top {
    /// What makes the method exact to fourth order: the turn about L per u, and the factor on the time step.
    #[inline(always)]
    fn corrections(&self, u: Vec3) -> (Float, Float) {
        let (m, inv) = (self.moments, self.inv);
        // No solid has a moment greater than the sum of the others; rounding may say so of a thin one.
        let gamma = |i: usize, j: usize, k: usize| (m[j] + m[k] - m[i]).max(0.0) * inv[j] * inv[k];
        let gamma = vec3(gamma(0, 1, 2), gamma(1, 2, 0), gamma(2, 0, 1));
        let w = u.component_mul(&inv);
        let w2 = w.component_mul(&w);
        let ahead = 2.0 * (w2.x + w2.y + w2.z) + w2.dot(&m.component_mul(&gamma));
        (w2.dot(&gamma) * (1.0 / 3.0), 1.0 - ahead * (1.0 / 3.0))
    }

    /// The Cayley vector f of a step: u + u×f + (u·f) f = I f, by Newton's method.
    #[inline(always)]
    fn cayley(&self, u: Vec3, steps: usize) -> Vec3 {
        let m = self.moments;
        let w = u.component_mul(&self.inv);
        // Half of h ω in the middle of the step: right but for third order.
        let mut f = w + u.cross(&w).component_mul(&self.inv);
        for _ in 0..steps {
            let d = u.dot(&f);
            let residual = u + u.cross(&f) + f * d - m.component_mul(&f);
            // The columns of I − d − [u]× − f uᵀ.
            let x = vec3(m.x - d, -u.z, u.y) - f * u.x;
            let y = vec3(u.z, m.y - d, -u.x) - f * u.y;
            let z = vec3(-u.y, u.x, m.z - d) - f * u.z;
            let (yz, zx, xy) = (y.cross(&z), z.cross(&x), x.cross(&y));
            let det = x.dot(&yz);
            if det > 0.0 {
                f += vec3(residual.dot(&yz), residual.dot(&zx), residual.dot(&xy)) / det;
            }
        }
        f
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrate::turn_by;
    use crate::math::{Mat3, length, quat_about, rotation_matrix};

    const SINGLE: bool = size_of::<Float>() == 4;

    /// The tumbling box of docs: 0.1 × 0.4 × 0.9 m, 10 kg.
    fn tumbling_box() -> PrincipalAxes {
        PrincipalAxes::of(&Mat3::from_diagonal(&vec3(9.7 / 12.0, 8.2 / 12.0, 1.7 / 12.0)))
    }

    /// World inertia and its inverse, as an engine would build them.
    fn world_inertia(q: &Quat, axes: &PrincipalAxes) -> (Mat3, Mat3) {
        let r = rotation_matrix(&(q * axes.body_from_principal));
        let inv = axes.moments.map(|m| 1.0 / m);
        (
            r * Mat3::from_diagonal(&axes.moments) * r.transpose(),
            r * Mat3::from_diagonal(&inv) * r.transpose(),
        )
    }

    /// Greatest relative errors of energy and of L, both from the reported ω and q.
    fn drift(q0: &Quat, l: Vec3, axes: &PrincipalAxes, h: Float, steps: usize) -> (Float, Float) {
        let energy = |q: &Quat| {
            let (inertia, inv) = world_inertia(q, axes);
            let omega = inv * l;
            (0.5 * omega.dot(&(inertia * omega)), inertia * omega)
        };
        let (e0, _) = energy(q0);
        let (mut q, mut de, mut dl) = (*q0, 0.0 as Float, 0.0 as Float);
        for _ in 0..steps {
            q = moser_veselov(&q, l, axes, h);
            let (e, found) = energy(&q);
            de = de.max((e - e0).abs() / e0);
            dl = dl.max(length(found - l) / length(l));
            assert!(de.is_finite() && dl.is_finite());
        }
        (de, dl)
    }

    fn angle_between(a: &Quat, b: &Quat) -> Float {
        let d = a.conjugate() * b;
        2.0 * length(vec3(d.i, d.j, d.k))
    }

    #[test]
    fn a_tumbling_box_keeps_energy_and_momentum() {
        let axes = tumbling_box();
        let l = axes.moments.component_mul(&vec3(0.1, 5.0, 0.1));
        for i in 0..20 {
            let q = quat_about(vec3(1.0, 0.3 * i as Float, -0.5), 0.7 * i as Float);
            let (de, dl) = drift(&q, rotate(&q, l), &axes, 1.0 / 240.0, 2400);
            let bound = if SINGLE { 1e-5 } else { 1e-12 };
            assert!(de < bound && dl < bound, "energy {de}, momentum {dl}");
        }
    }

    #[test]
    fn big_steps_keep_energy_and_momentum() {
        let axes = tumbling_box();
        for turn in [0.5, 0.51, 2.0, 6.0, 20.0, 100.0] {
            let l = axes.moments.component_mul(&(vec3(0.1, 5.0, 0.1) * 6.0));
            let h = turn / 30.0;
            let (de, dl) = drift(&Quat::identity(), l, &axes, h, 600);
            let bound = if SINGLE { 3e-5 } else { 1e-11 };
            assert!(de < bound && dl < bound, "|ω|h = {turn}: energy {de}, momentum {dl}");
        }
    }

    /// The time between two crossings of zero in the same direction by the body's ω along its middle axis.
    fn period(q0: &Quat, h: Float, time: Float) -> Float {
        let axes = tumbling_box();
        let l = rotate(q0, axes.moments.component_mul(&vec3(0.1, 5.0, 0.1)));
        let (mut q, mut last, mut first) = (*q0, rotate_back(q0, l).y, None);
        let mut count = 0;
        let mut until = 0.0;
        for step in 1..=(time / h) as usize {
            q = moser_veselov(&q, l, &axes, h);
            let now = rotate_back(&q, l).y;
            if last < 0.0 && now >= 0.0 {
                until = (step as Float - now / (now - last)) * h;
                match first {
                    None => first = Some(until),
                    Some(_) => count += 1,
                }
            }
            last = now;
        }
        (until - first.unwrap()) / count as Float
    }

    #[test]
    fn flips_take_the_time_of_the_elliptic_integral() {
        let exact = 6.056_844_158_021_02_f64 as Float;
        let mut sum = 0.0;
        for i in 0..20 {
            let q = quat_about(vec3(1.0, 0.3 * i as Float, -0.5), 0.7 * i as Float);
            sum += period(&q, 1.0 / 240.0, 20.0) - exact;
        }
        let error = (sum / 20.0).abs();
        assert!(error < if SINGLE { 1e-2 } else { 1e-5 }, "off by {error} s");
    }

    #[test]
    fn the_order_is_four() {
        let axes = PrincipalAxes::of(&Mat3::new(1.0, 0.2, -0.1, 0.2, 1.5, 0.3, -0.1, 0.3, 0.9));
        let q0 = quat_about(vec3(1.0, 2.0, -0.5), 0.7);
        let l = vec3(1.0, -2.0, 1.5);
        let after =
            |steps: usize| (0..steps).fold(q0, |q, _| moser_veselov(&q, l, &axes, 2.0 / steps as Float));
        let exact = after(if SINGLE { 200 } else { 5000 });
        let (coarse, fine) = (angle_between(&after(20), &exact), angle_between(&after(40), &exact));
        assert!(coarse < 1e-2 && fine < coarse / 12.0, "errors {coarse} and {fine} rad");
        // A method of order four agrees with one that knows nothing of Moser and Veselov.
        let h = 1e-3;
        let omega = |q: &Quat| world_inertia(q, &axes).1 * l;
        let reference = (0..2000).fold(q0, |q, _| {
            let middle = turn_by(&q, omega(&q) * (0.5 * h));
            turn_by(&q, omega(&middle) * h)
        });
        let apart = angle_between(&exact, &reference);
        assert!(apart < if SINGLE { 1e-4 } else { 2e-6 }, "{apart} rad from the midpoint rule");
    }

    #[test]
    fn a_full_tensor_turns_like_its_principal_axes() {
        let straight = tumbling_box();
        let tilt = quat_about(vec3(0.2, -1.0, 0.4), 1.1);
        let r = rotation_matrix(&tilt);
        let tilted = PrincipalAxes::of(&(r * Mat3::from_diagonal(&straight.moments) * r.transpose()));
        let l = vec3(0.3, 2.0, 1.0);
        let (mut q, mut qt) = (Quat::identity(), tilt.conjugate());
        for _ in 0..240 {
            q = moser_veselov(&q, l, &straight, 1.0 / 240.0);
            qt = moser_veselov(&qt, l, &tilted, 1.0 / 240.0);
        }
        assert!(angle_between(&q, &(qt * tilt)) < if SINGLE { 2e-4 } else { 1e-11 });
    }

    #[test]
    fn a_spin_about_the_largest_axis_stays() {
        let axes = tumbling_box();
        let l = axes.moments.component_mul(&vec3(20.0, 1e-3, 1e-3));
        let mut q = Quat::identity();
        for _ in 0..24_000 {
            q = moser_veselov(&q, l, &axes, 1.0 / 240.0);
            let omega = rotate_back(&q, l).component_div(&axes.moments);
            assert!((omega.x - 20.0).abs() < 1e-3 && omega.y.abs() < 5e-3 && omega.z.abs() < 5e-3);
        }
    }

    #[test]
    fn rods_and_discs_stay_sane() {
        for moments in [
            vec3(1e-6, 1.0, 1.0),
            vec3(1.0, 1.0, 1e-3),
            vec3(1.0, 0.5, 0.500001),
            vec3(1e-22, 2e-22, 2.5e-22),
            vec3(3e9, 4e9, 1e9),
        ] {
            let axes = PrincipalAxes { moments, body_from_principal: Quat::identity() };
            for omega in [vec3(1.0, 5.0, 0.2), vec3(0.0, 5.0, 0.0), vec3(40.0, 0.1, 3.0)] {
                let l = moments.component_mul(&omega);
                for h in [1.0 / 960.0, 1.0 / 60.0, 0.5] {
                    let (de, dl) = drift(&Quat::identity(), l, &axes, h, 500);
                    // ω = R I⁻¹ Rᵀ L itself loses what the smallest moment blows up.
                    let rounding = 0.2 * EPSILON * moments.max() / moments.min();
                    let bound = rounding + if SINGLE { 2e-4 } else { 1e-10 };
                    assert!(de < bound && dl < bound, "{moments} {omega} {h}: energy {de}, momentum {dl}");
                }
            }
        }
    }

    #[test]
    fn without_momentum_or_time_nothing_turns() {
        let q = quat_about(vec3(1.0, 2.0, -0.5), 0.7);
        let close = |a: Quat| assert!(angle_between(&a, &q) <= 4.0 * EPSILON);
        close(moser_veselov(&q, Vec3::zeros(), &tumbling_box(), 0.1));
        close(moser_veselov(&q, vec3(1.0, 2.0, 3.0), &tumbling_box(), 0.0));
        close(turn_by(&q, Vec3::zeros()));
        let there = moser_veselov(&q, vec3(1.0, 2.0, 3.0), &tumbling_box(), 0.01);
        let back = moser_veselov(&there, vec3(1.0, 2.0, 3.0), &tumbling_box(), -0.01);
        assert!(angle_between(&back, &q) < 1e-6);
    }
}
