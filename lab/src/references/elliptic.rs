//! Complete elliptic integrals, and what follows from them: the periods of a pendulum and of a tumbling body.

use std::f64::consts::PI;

/// The complete elliptic integral K of the parameter m = k², given 1 − m > 0, by the arithmetic–geometric mean.
pub fn complete(one_minus_m: f64) -> f64 {
    let (mut a, mut b) = (1.0, one_minus_m.sqrt());
    while (a - b).abs() > 4.0 * f64::EPSILON * a {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    PI / (2.0 * a)
}

/// The period of a pendulum of this length that swings by this amplitude \[s\].
pub fn pendulum_period(length: f64, amplitude: f64, g: f64) -> f64 {
    let c = libm::cos(0.5 * amplitude);
    4.0 * (length / g).sqrt() * complete(c * c)
}

/// The period of a body's angular velocity in its own frame \[s\], for principal moments and components in any order.
#[cfg(test)]
pub fn tumbling_period(inertia: [f64; 3], spin: [f64; 3]) -> f64 {
    // L² − 2 E J, summed so that nothing cancels near the separatrix, where J is the middle moment.
    let beyond = |j: f64| (0..3).map(|k| inertia[k] * (inertia[k] - j) * spin[k] * spin[k]).sum::<f64>();
    let mut i = inertia;
    i.sort_by(f64::total_cmp);
    // On the side of the greatest moment; on the other, greatest and least change places.
    let (i1, i2, i3) = if beyond(i[1]) > 0.0 { (i[0], i[1], i[2]) } else { (i[2], i[1], i[0]) };
    let n2 = (i3 - i2) * beyond(i1) / (i1 * i2 * i3);
    4.0 * complete((i3 - i1) * beyond(i2) / ((i3 - i2) * beyond(i1))) / n2.sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The printed figures of the catalogue of scenes: E1 and A3.
    #[test]
    fn periods_are_those_of_the_catalogue() {
        let degrees = PI / 180.0;
        assert!((pendulum_period(1.0, 90.0 * degrees, 9.81) - 2.367_841_9).abs() < 5e-8);
        assert!((pendulum_period(1.0, 170.0 * degrees, 9.81) - 4.893_524_3).abs() < 5e-8);
        let inertia = [10.0 / 12.0 * 0.97, 10.0 / 12.0 * 0.82, 10.0 / 12.0 * 0.17];
        assert!((tumbling_period(inertia, [0.1, 5.0, 0.1]) - 6.056_844_158_021_02).abs() < 1e-10);
    }
}
