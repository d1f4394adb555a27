//! A prism that rolls on its corners over a floor: it turns about the corner it stands on, as a pendulum upside down,
//! until the next one strikes, where the angular momentum about the new corner stays [McGeer 1990, the rimless wheel].

use super::extrapolation::Flow;

/// A prism of mass 1.
#[derive(Clone, Copy, Debug)]
pub struct Wheel {
    pub sides: usize,
    /// To a corner \[m\].
    pub radius: f64,
    /// Moment of inertia about its axis over mass \[m²\].
    pub moment: f64,
    pub g: f64,
}

impl Wheel {
    /// Half the angle between corners.
    pub fn half_angle(&self) -> f64 {
        std::f64::consts::PI / self.sides as f64
    }

    /// What is left of the speed of turning after a corner strikes.
    pub fn kept(&self) -> f64 {
        let square = self.radius * self.radius;
        (self.moment + square * libm::cos(2.0 * self.half_angle())) / (self.moment + square)
    }

    /// Where its centre is along the floor at the given times, which grow from 0; fewer if it stops on a face, or leaves
    /// the floor, before. It begins on a face, turning about the corner ahead by `spin`.
    pub fn ways(&self, spin: f64, ends: &[f64]) -> Vec<f64> {
        let alpha = self.half_angle();
        let pace = self.g * self.radius / (self.moment + self.radius * self.radius);
        let slope = move |y: &[f64], d: &mut [f64]| (d[0], d[1]) = (y[1], pace * libm::sin(y[0]));
        let side = 2.0 * self.radius * libm::sin(alpha);
        let (mut t, mut corner, mut now) = (0.0, 0.5 * side, [-alpha, spin]);
        let advance = |from: [f64; 2], time: f64| {
            let mut flow = Flow::new(slope, from.to_vec(), 1e-13);
            flow.advance(time);
            [flow.y[0], flow.y[1]]
        };
        let mut found = Vec::new();
        for &end in ends {
            while t < end {
                let step = (end - t).min(2e-3);
                let next = advance(now, step);
                if next[1] <= 0.0 || next[1] * next[1] * self.radius > self.g * libm::cos(next[0]) {
                    return found;
                }
                if next[0] < alpha {
                    (now, t) = (next, if step < 2e-3 { end } else { t + step });
                    continue;
                }
                let (mut low, mut high) = (0.0, step);
                for _ in 0..50 {
                    let middle = 0.5 * (low + high);
                    if advance(now, middle)[0] < alpha { low = middle } else { high = middle }
                }
                let speed = advance(now, high)[1];
                (now, t, corner) = ([-alpha, speed * self.kept()], t + high, corner + side);
            }
            found.push(corner + self.radius * libm::sin(now[0]));
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// On level ground a corner is left as fast as it was reached, so that the speed after n strikes is known, and the
    /// time between two is an integral of energy's law: by Simpson's rule.
    #[test]
    fn strikes_come_when_they_should() {
        let wheel = Wheel { sides: 32, radius: 0.5, moment: 0.125, g: 9.81 };
        let alpha = wheel.half_angle();
        let side = 2.0 * wheel.radius * libm::sin(alpha);
        let pace = wheel.g * wheel.radius / (wheel.moment + wheel.radius * wheel.radius);
        let (mut ends, mut speed, mut t) = (Vec::new(), 3.0, 0.0);
        for _ in 0..15 {
            let rest = |k: usize| {
                let angle = alpha * (k as f64 / 100.0 - 1.0);
                1.0 / f64::sqrt(speed * speed + 2.0 * pace * (libm::cos(alpha) - libm::cos(angle)))
            };
            let weight = |k: usize| if k == 0 || k == 200 { 1.0 } else { 2.0 + 2.0 * (k % 2) as f64 };
            t += (0..=200).map(|k| weight(k) * rest(k)).sum::<f64>() * alpha / 300.0;
            ends.push(t);
            speed *= wheel.kept();
        }
        let ways = wheel.ways(3.0, &ends);
        assert_eq!(ways.len(), ends.len());
        for (k, x) in ways.iter().enumerate() {
            let off = x / side - (k + 1) as f64;
            assert!(off.abs() < 1e-8, "{k}: {off}");
        }
        assert!(wheel.ways(5.0, &[1.0]).is_empty(), "it leaves the floor");
        assert!(wheel.ways(0.3, &[9.0]).is_empty(), "it stops");
    }
}
