//! Ordinary differential equations to near rounding: the extrapolated midpoint rule of Gragg, Bulirsch and Stoer with
//! a step that follows the error \[Hairer, Nørsett, Wanner, II.9\].

/// The order of the last column is twice this.
const COLUMNS: usize = 8;
/// Even numbers of pieces, growing slowly, so that rounding is not magnified much.
const PIECES: [usize; COLUMNS] = [2, 4, 6, 8, 10, 12, 14, 16];

/// A state of differential equations y' = f(y).
pub struct Flow<F: Fn(&[f64], &mut [f64])> {
    slope: F,
    pub t: f64,
    pub y: Vec<f64>,
    /// Relative to the size of a component, or to 1 where it is smaller.
    tolerance: f64,
    step: f64,
}

impl<F: Fn(&[f64], &mut [f64])> Flow<F> {
    pub fn new(slope: F, y: Vec<f64>, tolerance: f64) -> Self {
        Self { slope, t: 0.0, y, tolerance, step: 1e-2 }
    }

    /// One try of a step: the new state and its error as a multiple of the tolerance.
    fn attempt(&self, h: f64) -> (Vec<f64>, f64) {
        let n = self.y.len();
        let mut table: Vec<Vec<f64>> = Vec::with_capacity(COLUMNS);
        let (mut error, mut best) = (f64::INFINITY, Vec::new());
        let mut first = vec![0.0; n];
        (self.slope)(&self.y, &mut first);
        for k in 0..COLUMNS {
            let mut row = vec![self.midpoint(h, PIECES[k], &first)];
            for j in 1..=k {
                let ratio = PIECES[k] as f64 / PIECES[k - j] as f64;
                let factor = 1.0 / (ratio * ratio - 1.0);
                let next =
                    (0..n).map(|i| row[j - 1][i] + factor * (row[j - 1][i] - table[j - 1][i])).collect();
                row.push(next);
            }
            if k > 0 {
                let (a, b) = (&row[k], &row[k - 1]);
                let worst = (0..n).map(|i| (a[i] - b[i]).abs() / a[i].abs().max(1.0)).fold(0.0, f64::max);
                error = if worst.is_finite() { worst / self.tolerance } else { f64::INFINITY };
            }
            best.clone_from(&row[k]);
            table = row;
            if error <= 1.0 {
                break;
            }
        }
        (best, error)
    }

    /// Gragg's modified midpoint rule with smoothing.
    fn midpoint(&self, h: f64, pieces: usize, first: &[f64]) -> Vec<f64> {
        let n = self.y.len();
        let s = h / pieces as f64;
        let mut a = self.y.clone();
        let mut b: Vec<f64> = (0..n).map(|i| a[i] + s * first[i]).collect();
        let mut slope = vec![0.0; n];
        for _ in 1..pieces {
            (self.slope)(&b, &mut slope);
            for i in 0..n {
                let next = a[i] + 2.0 * s * slope[i];
                (a[i], b[i]) = (b[i], next);
            }
        }
        (self.slope)(&b, &mut slope);
        (0..n).map(|i| 0.5 * (a[i] + b[i] + s * slope[i])).collect()
    }

    /// Moves on to a later time. False: the step became too small, and the state is where it got to.
    pub fn advance(&mut self, end: f64) -> bool {
        while self.t < end {
            let h = self.step.min(end - self.t);
            let (next, error) = self.attempt(h);
            if error <= 1.0 {
                self.y = next;
                self.t = if h == end - self.t { end } else { self.t + h };
                if h == self.step {
                    self.step *= if error < 0.05 { 1.6 } else { 1.1 };
                }
            } else {
                self.step = 0.5 * h;
                if self.step < 1e-10 {
                    return false;
                }
            }
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of an oscillator after a hundred turns, a thousandth of a millionth of a millionth is off.
    #[test]
    fn an_oscillator_comes_back() {
        let mut flow = Flow::new(|y, d| (d[0], d[1]) = (y[1], -y[0]), vec![1.0, 0.0], 1e-14);
        assert!(flow.advance(100.0 * std::f64::consts::TAU));
        assert!((flow.y[0] - 1.0).abs() < 1e-11 && flow.y[1].abs() < 1e-11, "{:?}", flow.y);
    }

    /// The error follows the tolerance: its own check.
    #[test]
    fn a_tighter_tolerance_gives_a_smaller_error() {
        let error = |tolerance| {
            let mut flow = Flow::new(|y, d| d[0] = -2.0 * y[0] * y[0], vec![1.0], tolerance);
            assert!(flow.advance(5.0));
            (flow.y[0] - 1.0 / 11.0).abs()
        };
        assert!(error(1e-6) < 1e-5 && error(1e-13) < 1e-13);
    }

    #[test]
    fn what_runs_away_ends() {
        let mut flow = Flow::new(|y, d| d[0] = y[0] * y[0], vec![1.0], 1e-12);
        assert!(!flow.advance(2.0));
        assert!(flow.t < 1.0 && flow.t > 0.9, "{}", flow.t);
    }
}
