//! The turn of a body whose angular velocity is constant.

use crate::math::{Float, Quat, Vec3, length_squared, quat, scalar, vec3};

/// Terms of the two series below: enough for a turn of 2 rad at full precision.
const TERMS: usize = if size_of::<Float>() == 4 { 6 } else { 10 };

/// The coefficients of sin(x)/x and cos(x) in powers of x²: (−1)ᵏ / (2k+1)! and (−1)ᵏ / (2k)!.
const SERIES: [(Float, Float); TERMS] = {
    let mut series = [(1.0, 1.0); TERMS];
    let mut k = 1;
    while k < TERMS {
        let n = (2 * k) as Float;
        series[k].1 = -series[k - 1].0 / n;
        series[k].0 = -series[k - 1].0 / (n * (n + 1.0));
        k += 1;
    }
    series
};

/// `q` turned exactly by the rotation vector `w` \[rad\], axis times angle in the world: `exp(w) q`. For a body
/// whose ω is constant, `w = ω h`.
#[inline]
#[must_use]
pub fn turn_by(q: &Quat, w: Vec3) -> Quat {
    // sin(|w|/2) / |w| and cos(|w|/2).
    let half2 = 0.25 * length_squared(w);
    let (sinc, cos) = if half2 <= 1.0 {
        // Horner's scheme.
        let (mut s, mut c) = (0.0, 0.0);
        for (sk, ck) in SERIES.iter().rev() {
            s = s * half2 + sk;
            c = c * half2 + ck;
        }
        (0.5 * s, c)
    } else {
        let half = half2.sqrt();
        let (s, c) = scalar::sin_cos(half);
        (0.5 * s / half, c)
    };
    let (t, v) = (w * sinc, vec3(q.i, q.j, q.k));
    quat(q.w * cos - t.dot(&v), v * cos + t * q.w + t.cross(&v))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{length, quat_about, tolerance::EPSILON};

    const SINGLE: bool = size_of::<Float>() == 4;

    fn angle_between(a: &Quat, b: &Quat) -> Float {
        let d = a.conjugate() * b;
        2.0 * length(vec3(d.i, d.j, d.k))
    }

    #[test]
    fn a_sphere_turns_by_omega_t() {
        let omega = vec3(3.0, -4.0, 12.0);
        let (h, steps) = (1.0 / 256.0, 2560);
        let q = (0..steps).fold(Quat::identity(), |q, _| turn_by(&q, omega * h));
        let exact = quat_about(omega, 130.0);
        assert!(angle_between(&q, &exact) < if SINGLE { 2e-4 } else { 1e-12 });
    }

    #[test]
    fn turns_are_accurate_to_the_last_bits() {
        for i in 0..4000 {
            let angle = 0.002 * i as Float;
            let q = turn_by(&Quat::identity(), vec3(0.0, angle, 0.0));
            let (s, c) = scalar::sin_cos(0.5 * angle);
            assert!((q.j - s).abs() <= 2.0 * EPSILON && (q.w - c).abs() <= 2.0 * EPSILON, "{angle}");
        }
    }
}
