//! The exact motion of a damped spring through a sub-step, as two velocities.
//!
//! A spring of angular frequency ω and damping ratio ζ moves its coordinate x, under another constant acceleration a,
//! by ẍ = −ω² x − 2ζω ẋ + a. Over the time h that gives a place x₁ and a velocity v₁, linear in x, v and a. The first
//! pass of a sub-step gives the coordinate the mean velocity (x₁ − x)/h, which leads to x₁; the relax pass the
//! velocity v₁. So frequency and damping are what was asked for at any h.

use crate::math::Float;
use crate::math::scalar::{PI, double, single};

/// The mean velocity is `mean · (x, v, a)`, the velocity at the end `end · (x, v, a)`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Oscillator {
    /// Of the mean velocity over the sub-step.
    pub mean: [Float; 3],
    /// Of the velocity at its end.
    pub end: [Float; 3],
}

impl Oscillator {
    /// For this frequency \[Hz\] and damping ratio over the time `h` \[s\].
    #[must_use]
    pub fn new(hertz: Float, damping_ratio: Float, h: Float) -> Self {
        let (w, z, h) = (2.0 * double(PI) * double(hertz), double(damping_ratio), double(h));
        // Beyond this the exponentials underflow, and long before it the spring is as good as rigid.
        let wh = (w * h).min(1e4);
        if wh < 1e-7 {
            return Self { mean: [0.0, 1.0, single(0.5 * h)], end: [0.0, 1.0, single(h)] };
        }
        let w = wh / h;
        // x(h) = A x + B v and v(h) = C x + D v without the force.
        let (a, b) = homogeneous(w, z, h);
        let (c, d) = (-w * w * b, a - 2.0 * z * w * b);
        // With it, about the place of rest a/ω².
        let inv = 1.0 / (w * w);
        let part = |x: f64| single(if x.is_finite() { x } else { 0.0 });
        Self {
            mean: [part((a - 1.0) / h), part(b / h), part((1.0 - a) * inv / h)],
            end: [part(c), part(d), part(-c * inv)],
        }
    }
}

/// The place at time h from place 1 and velocity 0, and from place 0 and velocity 1.
fn homogeneous(w: f64, z: f64, h: f64) -> (f64, f64) {
    let wh = w * h;
    let decay = libm::exp(-z * wh);
    let disc = z * z - 1.0;
    // sin(√−disc ωh)/(√−disc ω) and its companion, through the critical case.
    let (cos, sinc) = if disc.abs() * wh * wh < 1e-6 {
        let y = disc * wh * wh;
        (decay * (1.0 + y / 2.0), decay * h * (1.0 + y / 6.0))
    } else if disc < 0.0 {
        let wd = (-disc).sqrt() * w;
        (decay * libm::cos(wd * h), decay * libm::sin(wd * h) / wd)
    } else {
        // The exponentials joined to the decay, so that nothing overflows.
        let root = disc.sqrt();
        let (slow, fast) = (libm::exp(-wh / (z + root)), libm::exp(-wh * (z + root)));
        (0.5 * (slow + fast), 0.5 * (slow - fast) / (root * w))
    };
    (cos + z * w * sinc, sinc)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_motion_of_a_fine_integration() {
        for (hertz, zeta, h) in [
            (1.0, 0.0, 1.0 / 60.0),
            (5.0, 0.1, 1.0 / 240.0),
            (60.0, 1.0, 1.0 / 240.0),
            (20.0, 0.7, 1.0 / 60.0),
            (3.0, 4.0, 1.0 / 60.0),
            (10.0, 1.000_01, 0.01),
        ] {
            let o = Oscillator::new(hertz, zeta, h);
            for start in [[0.3, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, -10.0], [0.1, -1.0, 3.0]] {
                let [x0, v0, a] = start.map(double);
                let (w, z) = (2.0 * std::f64::consts::PI * double(hertz), double(zeta));
                let (mut x, mut v, n) = (x0, v0, 20_000);
                let dt = double(h) / f64::from(n);
                for _ in 0..n {
                    // Midpoint rule.
                    let acc = |x: f64, v: f64| -w * w * x - 2.0 * z * w * v + a;
                    let (xm, vm) = (x + 0.5 * dt * v, v + 0.5 * dt * acc(x, v));
                    x += dt * vm;
                    v += dt * acc(xm, vm);
                }
                let times = |row: [Float; 3]| (0..3).map(|k| double(row[k]) * double(start[k])).sum::<f64>();
                let scale = v0.abs() + w * x0.abs() + a.abs() / w;
                assert!((times(o.mean) - (x - x0) / double(h)).abs() < 2e-6 * scale, "{hertz} {zeta} {h}");
                assert!((times(o.end) - v).abs() < 2e-6 * scale, "{hertz} {zeta} {h}");
            }
        }
    }

    #[test]
    fn extremes_are_finite() {
        for hertz in [0.0, 1e-6, 1e3, 1e6, Float::MAX] {
            for zeta in [0.0, 1.0, 1e3, 1e10] {
                let o = Oscillator::new(hertz, zeta, 1.0 / 240.0);
                assert!(o.mean.iter().chain(&o.end).all(|x| x.is_finite()), "{hertz} {zeta}: {o:?}");
            }
        }
    }
}
