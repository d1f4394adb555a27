//! A ball among fixed pegs, in a plane: it flies along parabolas from one elastic impact to the next, each found to
//! rounding. Chaotic, so that only what many balls do together says something.

/// A peg board, with the distance from a peg at which a ball's centre is turned back \[m\].
#[derive(Clone, Debug)]
pub struct Board {
    pub pegs: Vec<[f64; 2]>,
    pub reach: f64,
    pub g: f64,
}

/// How finely a parabola is looked through for impacts \[s\].
const PACE: f64 = 2e-3;

impl Board {
    /// Where a ball that starts at rest is after a time.
    pub fn end(&self, start: [f64; 2], time: f64) -> [f64; 2] {
        let (mut p, mut v, mut left) = (start, [0.0; 2], time);
        while left > 0.0 {
            let step = PACE.min(left);
            let at = |t: f64| [p[0] + v[0] * t, p[1] + v[1] * t - 0.5 * self.g * t * t];
            let depth = |t: f64, peg: [f64; 2]| {
                let q = at(t);
                self.reach - libm::hypot(q[0] - peg[0], q[1] - peg[1])
            };
            let hit = self.pegs.iter().find(|&&peg| depth(step, peg) > 0.0);
            let Some(&peg) = hit else {
                (p, v[1], left) = (at(step), v[1] - self.g * step, left - step);
                continue;
            };
            let (mut low, mut high) = (0.0, step);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if depth(middle, peg) > 0.0 { high = middle } else { low = middle }
            }
            (p, v[1], left) = (at(low), v[1] - self.g * low, left - low.max(1e-12));
            let n = [(p[0] - peg[0]) / self.reach, (p[1] - peg[1]) / self.reach];
            let approach = v[0] * n[0] + v[1] * n[1];
            if approach < 0.0 {
                v = [v[0] - 2.0 * approach * n[0], v[1] - 2.0 * approach * n[1]];
            }
        }
        p
    }
}

/// The energy distance of two samples over its greatest value, 0 for equal distributions \[Székely, Rizzo 2013\].
pub fn energy_coefficient(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    let mean = |a: &[[f64; 2]], b: &[[f64; 2]]| {
        let sum: f64 =
            a.iter().flat_map(|p| b.iter().map(move |q| libm::hypot(p[0] - q[0], p[1] - q[1]))).sum();
        sum / (a.len() * b.len()) as f64
    };
    let across = 2.0 * mean(a, b);
    if across > 0.0 { 1.0 - (mean(a, a) + mean(b, b)) / across } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// On one peg, straight above it, a ball bounces for ever to where it began.
    #[test]
    fn a_ball_over_a_peg_comes_back() {
        let board = Board { pegs: vec![[0.0, 0.0]], reach: 0.3, g: 9.81 };
        let fall = f64::sqrt(2.0 * 0.7 / 9.81);
        for n in 1..5 {
            let p = board.end([0.0, 1.0], 2.0 * fall * f64::from(n));
            assert!((p[1] - 1.0).abs() < 1e-6 && p[0].abs() < 1e-9, "{n}: {p:?}");
        }
    }

    /// Energy stays: after a time, a ball is where its speed could have brought it, and not inside a peg.
    #[test]
    fn a_ball_is_never_in_a_peg() {
        let board = Board { pegs: vec![[0.0, 0.0], [1.0, 0.0], [0.5, -0.87]], reach: 0.3, g: 9.81 };
        for k in 0..50 {
            let p = board.end([0.02 * f64::from(k), 0.7], 0.6);
            let free = board.pegs.iter().all(|q| libm::hypot(p[0] - q[0], p[1] - q[1]) > 0.3 - 1e-6);
            assert!(free && p[1] < 0.7 + 1e-9, "{k}: {p:?}");
        }
    }

    #[test]
    fn equal_samples_have_no_distance() {
        let a: Vec<[f64; 2]> = (0..20).map(|k| [f64::from(k), 0.0]).collect();
        let b: Vec<[f64; 2]> = a.iter().map(|p| [p[0] + 1000.0, 0.0]).collect();
        assert!(energy_coefficient(&a, &a).abs() < 1e-12);
        assert!(energy_coefficient(&a, &b) > 0.98);
    }
}
