//! A body that no torque acts on: its rotation by integration of Euler's equations and of its quaternion.

use super::extrapolation::Flow;
use crate::vector::{Q4, V3, times, unit};

/// The rotations at the given times, which grow from 0; `spin` is in the body's frame.
pub fn rotations(inertia: V3, spin: V3, start: Q4, ends: &[f64]) -> Vec<Q4> {
    let mut flow = flow(inertia, spin, start);
    ends.iter()
        .map(|&t| {
            flow.advance(t);
            unit([flow.y[3], flow.y[4], flow.y[5], flow.y[6]])
        })
        .collect()
}

/// When a component of the body's own angular velocity changes its sign, up to a number of times \[s\].
pub fn sign_changes(inertia: V3, spin: V3, component: usize, count: usize, until: f64) -> Vec<f64> {
    let mut flow = flow(inertia, spin, crate::vector::STILL);
    let (mut found, pace) = (Vec::new(), 0.02);
    while found.len() < count && flow.t < until {
        let (t, y) = (flow.t, flow.y.clone());
        flow.advance(t + pace);
        if y[component] * flow.y[component] >= 0.0 {
            continue;
        }
        // Bisection, from the state before.
        let (mut low, mut high) = (0.0, pace);
        for _ in 0..46 {
            let middle = 0.5 * (low + high);
            let mut probe = self::flow(inertia, [y[0], y[1], y[2]], crate::vector::STILL);
            probe.advance(middle);
            if probe.y[component] * y[component] > 0.0 { low = middle } else { high = middle }
        }
        found.push(t + 0.5 * (low + high));
    }
    found
}

fn flow(inertia: V3, spin: V3, q: Q4) -> Flow<impl Fn(&[f64], &mut [f64])> {
    let slope = move |y: &[f64], d: &mut [f64]| {
        for k in 0..3 {
            let (a, b) = ((k + 1) % 3, (k + 2) % 3);
            d[k] = (inertia[a] - inertia[b]) * y[a] * y[b] / inertia[k];
        }
        let turning = times([y[3], y[4], y[5], y[6]], [y[0], y[1], y[2], 0.0]);
        for k in 0..4 {
            d[3 + k] = 0.5 * turning[k];
        }
    };
    Flow::new(slope, vec![spin[0], spin[1], spin[2], q[0], q[1], q[2], q[3]], 1e-14)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::references::elliptic::tumbling_period;
    use crate::vector::{STILL, norm, rotate, sub};

    const INERTIA: V3 = [10.0 / 12.0 * 0.97, 10.0 / 12.0 * 0.82, 10.0 / 12.0 * 0.17];

    /// Two ways to one answer: half the period of the elliptic functions lies between changes of sign. The second spin
    /// is so near the separatrix that the rounding of L² − 2 E J in double precision moves the period by 4e-8.
    #[test]
    fn flips_come_with_the_period_of_the_closed_form() {
        for (spin, bound) in [([0.1, 5.0, 0.1], 1e-10), ([1e-3, 5.0, 1e-3], 1e-7)] {
            let flips = sign_changes(INERTIA, spin, 1, 3, 60.0);
            let period = tumbling_period(INERTIA, spin);
            assert!((flips[2] - flips[0] - period).abs() < bound * period, "{flips:?} {period}");
        }
    }

    /// L in the world stays where it is.
    #[test]
    fn angular_momentum_stays() {
        let spin = [0.1, 5.0, 0.1];
        let q = rotations(INERTIA, spin, STILL, &[10.0])[0];
        let mut flow = flow(INERTIA, spin, STILL);
        flow.advance(10.0);
        let l = |w: &[f64]| [0, 1, 2].map(|k| INERTIA[k] * w[k]);
        assert!(norm(sub(rotate(q, l(&flow.y)), l(&spin))) < 1e-11);
    }
}
