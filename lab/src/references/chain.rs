//! A chain of equal thin rods that swings in a plane, hung from a point: in its angles, without any joint.
//!
//! With θ from the downward vertical, M(θ) θ'' = f: for rods i ≠ j, M_ij = m l² c_ij cos(θi − θj) with
//! c_ij = ½ + n − max(i, j) rods below, M_ii = m l² (⅓ + n − i), and f_i = −Σ m l² c_ij sin(θi − θj) θj'² −
//! m g l (½ + n − i) sin θi, counting from 1.

use super::extrapolation::Flow;

/// Where the tip is at the given times, which grow from 0: horizontal and upward \[m\]. The chain starts at rest along
/// the horizontal.
pub fn tips(count: usize, length: f64, g: f64, ends: &[f64]) -> Vec<[f64; 2]> {
    let mut start = vec![std::f64::consts::FRAC_PI_2; count];
    start.extend(vec![0.0; count]);
    let slope = move |y: &[f64], d: &mut [f64]| slopes(count, length, g, y, d);
    let mut flow = Flow::new(slope, start, 1e-13);
    ends.iter()
        .map(|&t| {
            flow.advance(t);
            let tip = |f: fn(f64) -> f64| flow.y[..count].iter().map(|&a| length * f(a)).sum::<f64>();
            [tip(libm::sin), -tip(libm::cos)]
        })
        .collect()
}

fn slopes(n: usize, length: f64, g: f64, y: &[f64], d: &mut [f64]) {
    let (angle, speed) = y.split_at(n);
    let below = |i: usize| (n - 1 - i) as f64;
    let mut matrix = vec![0.0; n * n];
    let mut force = vec![0.0; n];
    for i in 0..n {
        force[i] = -g / length * (0.5 + below(i)) * libm::sin(angle[i]);
        for j in 0..n {
            let c = 0.5 + below(i.max(j));
            let (s, k) = libm::sincos(angle[i] - angle[j]);
            matrix[i * n + j] = if i == j { 1.0 / 3.0 + below(i) } else { c * k };
            if i != j {
                force[i] -= c * s * speed[j] * speed[j];
            }
        }
    }
    solve(n, &mut matrix, &mut force);
    d[..n].copy_from_slice(speed);
    d[n..].copy_from_slice(&force);
}

/// Cholesky's way, in place: the matrix is positive.
fn solve(n: usize, a: &mut [f64], b: &mut [f64]) {
    for i in 0..n {
        for j in 0..=i {
            let sum = a[i * n + j] - (0..j).map(|k| a[i * n + k] * a[j * n + k]).sum::<f64>();
            a[i * n + j] = if i == j { sum.sqrt() } else { sum / a[j * n + j] };
        }
    }
    for i in 0..n {
        b[i] = (b[i] - (0..i).map(|k| a[i * n + k] * b[k]).sum::<f64>()) / a[i * n + i];
    }
    for i in (0..n).rev() {
        b[i] = (b[i] - (i + 1..n).map(|k| a[k * n + i] * b[k]).sum::<f64>()) / a[i * n + i];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(found: &[[f64; 2]], printed: &[[f64; 2]], bound: f64) {
        for (a, b) in found.iter().zip(printed) {
            assert!((a[0] - b[0]).abs() < bound && (a[1] - b[1]).abs() < bound, "{a:?} {b:?}");
        }
    }

    /// The printed figures of the catalogue of scenes: E2.
    #[test]
    fn the_double_pendulum_is_that_of_the_catalogue() {
        let printed = [
            [-1.662_115_14, -1.041_466_64],
            [0.313_524_78, -1.914_746_62],
            [1.330_436_83, -1.398_644_86],
            [1.855_221_94, -0.739_567_93],
        ];
        near(&tips(2, 1.0, 9.81, &[1.0, 2.0, 3.0, 5.0]), &printed, 2e-8);
    }

    /// The same: E3.
    #[test]
    fn chains_are_those_of_the_catalogue() {
        let ten = [[1.296_165_5, -1.229_563], [-1.764_752_5, -0.927_582_9], [-1.746_359_2, -0.321_941_2]];
        near(&tips(10, 0.2, 9.81, &[0.5, 1.0, 1.5]), &ten, 1e-7);
        near(&tips(20, 0.2, 9.81, &[0.5]), &[[3.509_259, -1.226_253]], 1e-7);
    }
}
