//! Dantzig's principal pivoting as Baraff (1994) put it for contacts: a complementarity problem with bounds,
//!   w = A x + b,   lo ≤ x ≤ hi,   w_i ≥ 0 where x_i = lo_i,  w_i ≤ 0 where x_i = hi_i,  w_i = 0 between,
//! for symmetric positive semi-definite A. Rows join one at a time: the new x_i is driven until its w_i is right,
//! while the rows *between* the bounds (C) keep w = 0 by x_C = −A_CC⁻¹ (…) and those *at* a bound (N) stay there; who
//! would violate something on the way changes sets first. \[Cottle, Dantzig 1968; Baraff 1994; the bounds as in Smith's
//! ODE\]
//!
//! A_CC is held as a Cholesky factor that rows are appended to and taken out of (by Givens rotations), n² each.
//! Hyperstatic contacts, such as the four corners of a face, make A singular: its diagonal is raised by the share
//! [`REGULARISATION`] for the pivoting, and the final sets are solved again without it by iterative refinement.
//!
//! Frictionless contact is solved exactly. With friction each point gets F/2 axes around the half circle with limits
//! ±s, s = μ λ_n sin(π/F): the sum of such segments *is* the regular polygon of F corners inscribed in the friction
//! disc, so for given λ_n the bounds are the pyramid of Stewart and Trinkle. λ_n is found by repetition; where that
//! does not settle the status says so.

use super::contact_problem::{ContactProblem, Outcome, ROUGH, Status, dense, put_three, worse};

/// How much the diagonal is raised for pivoting, as a share. Pivots of dependent rows are then this large instead of
/// rounding (1e-16 times the number of rows).
pub const REGULARISATION: f64 = 1e-12;

/// Velocities below this share of the greatest free one, and slopes below this share of a row's own, are rounding.
const NEGLIGIBLE: f64 = 1e-10;

/// Greatest number of rows: about a second.
pub const GREATEST_SIZE: usize = 800;

/// How often friction limits are set anew before they count as unsettled.
const ROUNDS: usize = 60;

/// Friction limits have settled when none moves by more than this share of the greatest.
const SETTLED: f64 = 1e-9;

/// Up to this share they may still move when rounds are over, and the result is rough.
const NEARLY: f64 = 1e-3;

/// Which set a row is in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Set {
    /// Not looked at yet; x = 0.
    Waiting,
    /// w = 0.
    Between,
    /// x = lo.
    Low,
    /// x = hi.
    High,
}

/// Memory that is kept between solves.
#[derive(Clone, Debug, Default)]
pub struct Dantzig {
    n: usize,
    a: Vec<f64>,
    b: Vec<f64>,
    lo: Vec<f64>,
    hi: Vec<f64>,
    x: Vec<f64>,
    w: Vec<f64>,
    set: Vec<Set>,
    /// The greatest |b|.
    size: f64,
    /// Rows of C, in the order of the factor.
    between: Vec<usize>,
    /// Factor of A_CC, raised, in rows of length n.
    factor: Vec<f64>,
    step: Vec<f64>,
    speed: Vec<f64>,
    right: Vec<f64>,
    trial: Vec<f64>,
    kept: Vec<f64>,
    /// Of contact problems: scale of each row, first axis of each point, limits.
    scale: Vec<f64>,
    first_axis: Vec<Option<usize>>,
    limit: Vec<f64>,
}

impl Dantzig {
    /// Solves the problem with bounds for A of n rows, row after row; lo ≤ 0 ≤ hi, which may be infinite. x is left in
    /// [`Dantzig::solution`]. The residual is the greatest violation of w's signs.
    pub fn bounded(&mut self, a: &[f64], b: &[f64], lo: &[f64], hi: &[f64]) -> Outcome {
        self.n = b.len();
        for (own, given) in [(&mut self.a, a), (&mut self.b, b), (&mut self.lo, lo), (&mut self.hi, hi)] {
            own.clear();
            own.extend_from_slice(given);
        }
        self.run()
    }

    /// x of the last solve.
    #[must_use]
    pub fn solution(&self) -> &[f64] {
        &self.x
    }

    /// Solves a contact problem with friction polygons of `facets` corners, made even and at least 4. The residual is
    /// the greatest violation of the velocities' signs, in rows scaled by the root of the mass that resists \[√J\].
    pub fn solve(&mut self, problem: &ContactProblem, facets: usize, lambda: &mut Vec<f64>) -> Outcome {
        lambda.clear();
        lambda.resize(problem.size(), 0.0);
        if let Some(status) = problem.refusal() {
            return Outcome::refused(status);
        }
        let axes = facets.max(3).div_ceil(2);
        let count = problem.count();
        let with_friction = (0..count).filter(|&k| has_friction(problem, k)).count();
        if count + axes * with_friction > GREATEST_SIZE {
            return Outcome::refused(Status::TooLarge);
        }
        self.state(problem, axes);
        let mut outcome = self.run();
        if with_friction > 0 && outcome.status.is_usable() {
            outcome = self.settle(problem, axes, outcome.iterations);
        }
        if outcome.status.is_usable() {
            for k in 0..count {
                let mut l = nalgebra::Vector3::new(self.x[k] * self.scale[k], 0.0, 0.0);
                if let Some(first) = self.first_axis[k] {
                    for j in 0..axes {
                        let (s, c) = direction(j, axes);
                        let value = self.x[first + j] * self.scale[first + j];
                        l.y += c * value;
                        l.z += s * value;
                    }
                }
                put_three(lambda, k, &l);
            }
        }
        outcome
    }

    /// Repeats with the friction limits of the last normal impulses until they agree.
    fn settle(&mut self, problem: &ContactProblem, axes: usize, mut pivots: usize) -> Outcome {
        let mut worst_move = f64::INFINITY;
        for round in 0..ROUNDS {
            let (mut moved, mut greatest): (f64, f64) = (0.0, 0.0);
            for k in 0..problem.count() {
                let Some(first) = self.first_axis[k] else { continue };
                let (s, _) = libm::sincos(core::f64::consts::PI / (2 * axes) as f64);
                let normal = self.x[k] * self.scale[k];
                let wanted = problem.friction(k) * normal * s;
                // Later rounds go half the way, which ends two-step cycles.
                let share = if round < ROUNDS / 3 { 1.0 } else { 0.5 };
                let old = self.limit[k];
                let new = old + share * (wanted - old);
                // Friction that stays within its limits does not care how they move.
                let held = (first..first + axes).all(|j| {
                    self.set[j] == Set::Between && self.x[j].abs() * self.scale[j] <= wanted * (1.0 + SETTLED)
                });
                if !held {
                    moved = moved.max((wanted - old).abs() / self.scale[k]);
                }
                greatest = greatest.max(wanted / self.scale[k]);
                self.limit[k] = new;
                for j in first..first + axes {
                    self.hi[j] = new / self.scale[j];
                    self.lo[j] = -self.hi[j];
                }
            }
            worst_move = if greatest > 0.0 { moved / greatest } else { 0.0 };
            if worst_move <= SETTLED {
                return self.verdict(pivots);
            }
            if !self.sets_still_hold() {
                let outcome = self.run();
                pivots += outcome.iterations;
                if !outcome.status.is_usable() {
                    return Outcome { iterations: pivots, ..outcome };
                }
            }
        }
        let mut outcome = self.verdict(pivots);
        outcome.status = match outcome.status {
            Status::Solved | Status::Rough if worst_move <= NEARLY => Status::Rough,
            Status::Solved | Status::Rough => Status::FrictionUnsettled,
            other => other,
        };
        outcome
    }

    /// Writes the problem with bounds of a contact problem: all normals first, then the axes of each point. Rows are
    /// scaled by 1/√A_ii; the limits of friction are 0 to begin with.
    fn state(&mut self, problem: &ContactProblem, axes: usize) {
        let (count, size) = (problem.count(), problem.size());
        let mut n = count;
        self.first_axis.clear();
        for k in 0..count {
            let friction = has_friction(problem, k);
            self.first_axis.push(friction.then_some(n));
            n += if friction { axes } else { 0 };
        }
        self.n = n;
        self.scale.clear();
        self.scale.resize(n, 1.0);
        self.limit.clear();
        self.limit.resize(count, 0.0);
        let unit = |w: f64| if w > 0.0 { 1.0 / w.sqrt() } else { 1.0 };
        let diagonal = |i: usize| problem.w[i * size + i];
        for k in 0..count {
            self.scale[k] = unit(diagonal(3 * k));
            if let Some(first) = self.first_axis[k] {
                let s = unit(diagonal(3 * k + 1).max(diagonal(3 * k + 2)));
                self.scale[first..first + axes].fill(s);
            }
        }
        self.a.clear();
        self.a.resize(n * n, 0.0);
        self.b.clear();
        self.b.resize(n, 0.0);
        self.lo.clear();
        self.lo.resize(n, 0.0);
        self.hi.clear();
        self.hi.resize(n, 0.0);
        self.hi[..count].fill(f64::INFINITY);
        for i in 0..count {
            for row in (0..=axes).filter(|&r| r == 0 || self.first_axis[i].is_some()) {
                let u = row_of(row, axes);
                let at = if row == 0 { i } else { self.first_axis[i].unwrap_or(0) + row - 1 };
                let dot = |r: usize, c: usize| -> f64 {
                    (0..3).map(|d| u[d] * problem.w[(3 * i + d) * size + r * 3 + c]).sum()
                };
                self.b[at] = self.scale[at] * (0..3).map(|d| u[d] * problem.b[3 * i + d]).sum::<f64>();
                for j in 0..count {
                    let part = [dot(j, 0), dot(j, 1), dot(j, 2)];
                    self.a[at * n + j] = part[0] * self.scale[at] * self.scale[j];
                    let Some(first) = self.first_axis[j] else { continue };
                    for c in 1..=axes {
                        let v = row_of(c, axes);
                        let to = first + c - 1;
                        self.a[at * n + to] =
                            (v[1] * part[1] + v[2] * part[2]) * self.scale[at] * self.scale[to];
                    }
                }
            }
        }
    }

    /// All rows from scratch.
    fn run(&mut self) -> Outcome {
        let n = self.n;
        self.x.clear();
        self.x.resize(n, 0.0);
        let fits = self.a.len() == n * n && self.lo.len() == n && self.hi.len() == n;
        let sane = |lo: &f64, hi: &f64| *lo <= 0.0 && *hi >= 0.0;
        if !fits
            || !self.a.iter().chain(&self.b).all(|v| v.is_finite())
            || !self.lo.iter().zip(&self.hi).all(|(l, h)| sane(l, h))
        {
            return Outcome::refused(Status::NotFinite);
        }
        self.size = self.b.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        self.w.clear();
        self.w.extend_from_slice(&self.b);
        self.set.clear();
        self.set.resize(n, Set::Waiting);
        self.between.clear();
        self.factor.resize(n * n, 0.0);
        let limit = 40 * n + 100;
        let mut pivots = 0;
        for i in 0..n {
            match self.drive(i, limit - pivots.min(limit)) {
                Ok(used) => pivots += used,
                Err((status, used)) => {
                    return Outcome { status, iterations: pivots + used, residual: f64::INFINITY };
                }
            }
        }
        self.refine();
        self.verdict(pivots)
    }

    /// Brings row `i` into a set; how many pivots that took.
    fn drive(&mut self, i: usize, limit: usize) -> Result<usize, (Status, usize)> {
        let n = self.n;
        self.w[i] = self.b[i] + dense::dot(&self.a[i * n..][..n], &self.x);
        if self.is_negligible(i) {
            self.w[i] = 0.0;
        }
        if self.lo[i] == 0.0 && self.w[i] >= 0.0 {
            self.set[i] = Set::Low;
            return Ok(0);
        }
        if self.hi[i] == 0.0 && self.w[i] <= 0.0 {
            self.set[i] = Set::High;
            return Ok(0);
        }
        let mut pivots = 0;
        loop {
            if self.is_negligible(i) {
                self.w[i] = 0.0;
                return if self.append(i) { Ok(pivots) } else { Err((Status::Stalled, pivots)) };
            }
            let direction = if self.w[i] <= 0.0 { 1.0 } else { -1.0 };
            self.response(i, direction);
            // How far until row i is right or at its bound, or another row has to change sets.
            let slope = self.speed[i];
            let mut far = f64::INFINITY;
            let mut who = i;
            let mut into = Set::Waiting;
            // A row that depends on C has no slope of its own.
            if slope * direction > NEGLIGIBLE * self.a[i * n + i] {
                (far, into) = (-self.w[i] / slope, Set::Between);
            }
            let room = if direction > 0.0 { self.hi[i] - self.x[i] } else { self.x[i] - self.lo[i] };
            if room < far {
                (far, into) = (room, if direction > 0.0 { Set::High } else { Set::Low });
            }
            for k in 0..n {
                let least = NEGLIGIBLE * (self.a[i * n + i] * self.a[k * n + k]).sqrt();
                let leaves = match self.set[k] {
                    Set::Low => self.speed[k] < -least && self.lo[k] < self.hi[k],
                    Set::High => self.speed[k] > least && self.lo[k] < self.hi[k],
                    _ => false,
                };
                if leaves {
                    let s = (-self.w[k] / self.speed[k]).max(0.0);
                    if s < far {
                        (far, who, into) = (s, k, Set::Between);
                    }
                }
            }
            for (place, &k) in self.between.iter().enumerate() {
                let v = self.step[place];
                let (bound, set) = if v > 0.0 { (self.hi[k], Set::High) } else { (self.lo[k], Set::Low) };
                if v != 0.0 {
                    let s = ((bound - self.x[k]) / v).max(0.0);
                    if s < far {
                        (far, who, into) = (s, k, set);
                    }
                }
            }
            if !far.is_finite() || far * NEGLIGIBLE * self.a[i * n + i] > self.size {
                // Nothing stops it: no impulse helps this row.
                return Err((Status::Ray, pivots));
            }
            self.go(i, direction, far);
            pivots += 1;
            if who == i {
                match into {
                    Set::Between => {
                        self.w[i] = 0.0;
                        if !self.append(i) {
                            return Err((Status::Stalled, pivots));
                        }
                    }
                    Set::High => (self.x[i], self.set[i]) = (self.hi[i], Set::High),
                    _ => (self.x[i], self.set[i]) = (self.lo[i], Set::Low),
                }
                return Ok(pivots);
            }
            if into == Set::Between {
                self.w[who] = 0.0;
                if !self.append(who) {
                    return Err((Status::Stalled, pivots));
                }
            } else {
                self.x[who] = if into == Set::High { self.hi[who] } else { self.lo[who] };
                self.remove(who);
                self.set[who] = into;
            }
            if pivots >= limit {
                return Err((Status::IterationLimit, pivots));
            }
        }
    }

    /// Whether w_i is rounding, or what the raised diagonal leaves of the rows of C that row `i` may depend on. In C
    /// it is made zero in the end.
    fn is_negligible(&self, i: usize) -> bool {
        let greatest = self.x.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let left = 8.0 * REGULARISATION * self.a[i * self.n + i] * greatest;
        self.w[i].abs() <= NEGLIGIBLE * self.size + left
    }

    /// What a unit step of x_i along `direction` does: `step` to x_C, `speed` to w outside C.
    fn response(&mut self, i: usize, direction: f64) {
        let n = self.n;
        let column = &self.a[i * n..][..n];
        self.step.clear();
        self.step.extend(self.between.iter().map(|&k| -direction * column[k]));
        dense::cholesky_solve(&self.factor, n, &mut self.step);
        self.speed.clear();
        self.speed.extend(column.iter().map(|v| v * direction));
        for (&k, &s) in self.between.iter().zip(&self.step) {
            if s != 0.0 {
                dense::add_scaled(&mut self.speed, s, &self.a[k * n..][..n]);
            }
        }
    }

    fn go(&mut self, i: usize, direction: f64, far: f64) {
        self.x[i] += direction * far;
        for (&k, &s) in self.between.iter().zip(&self.step) {
            self.x[k] += s * far;
        }
        // Rows of C keep w = 0; what rounding and the raised diagonal leave of it is taken out at the end.
        for k in 0..self.n {
            if self.set[k] != Set::Between {
                self.w[k] += self.speed[k] * far;
            }
        }
    }

    /// Row `i` joins C. False where even the raised pivot is not positive.
    fn append(&mut self, i: usize) -> bool {
        let (n, size) = (self.n, self.between.len());
        let (above, row) = self.factor.split_at_mut(size * n);
        for j in 0..size {
            let other = &above[j * n..][..n];
            row[j] = (self.a[i * n + self.between[j]] - dense::dot(&row[..j], &other[..j])) / other[j];
        }
        let diagonal = self.a[i * n + i];
        let raised = diagonal * REGULARISATION;
        // Rounding may have eaten the raise of a dependent row; it gets it in full.
        let pivot = (diagonal + raised - dense::dot(&row[..size], &row[..size])).max(0.5 * raised);
        if pivot.is_nan() || pivot <= 0.0 {
            return false;
        }
        row[size] = pivot.sqrt();
        self.between.push(i);
        self.set[i] = Set::Between;
        true
    }

    /// Takes row `i` out of C: the factor loses a row, and Givens rotations make it triangular again.
    fn remove(&mut self, i: usize) {
        let n = self.n;
        let Some(place) = self.between.iter().position(|&k| k == i) else { return };
        self.between.remove(place);
        let size = self.between.len();
        for row in place..size {
            self.factor.copy_within((row + 1) * n..(row + 1) * n + row + 2, row * n);
        }
        for k in place..size {
            let (a, b) = (self.factor[k * n + k], self.factor[k * n + k + 1]);
            let r = (a * a + b * b).sqrt();
            if r <= 0.0 {
                continue;
            }
            let (c, s) = (a / r, b / r);
            for row in k..size {
                let at = row * n + k;
                let (x, y) = (self.factor[at], self.factor[at + 1]);
                self.factor[at] = c * x + s * y;
                self.factor[at + 1] = c * y - s * x;
            }
        }
    }

    /// With the sets as they are and the bounds as they are now: x_C from A_CC x_C = −b_C − A_CN x_N by refinement
    /// with the raised factor, and w. False where it leaves the bounds or the signs.
    ///
    /// Begun at x_C = 0 it shares a load that several rows can carry between them, and always in the same way, while
    /// pivoting leaves it where it fell; begun at the present x it changes the least.
    fn refine(&mut self) -> bool {
        if self.refine_from(true) && self.error() <= 1e-9 * self.size {
            return true;
        }
        let error = self.error();
        self.kept.clone_from(&self.x);
        let inside = self.refine_from(false);
        if error < self.error() {
            std::mem::swap(&mut self.x, &mut self.kept);
            self.measure();
        }
        inside
    }

    fn refine_from(&mut self, zero: bool) -> bool {
        let n = self.n;
        let mut trial = std::mem::take(&mut self.trial);
        trial.clear();
        trial.extend((0..n).map(|k| match self.set[k] {
            Set::Low => self.lo[k],
            Set::High => self.hi[k],
            _ if zero => 0.0,
            _ => self.x[k],
        }));
        for _ in 0..8 {
            self.right.clear();
            for &k in &self.between {
                self.right.push(-self.b[k] - dense::dot(&self.a[k * n..][..n], &trial));
            }
            let off = self.right.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
            if off <= 1e-13 * self.size {
                break;
            }
            dense::cholesky_solve(&self.factor, n, &mut self.right);
            for (&k, &d) in self.between.iter().zip(&self.right) {
                trial[k] += d;
            }
        }
        let scale = trial.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        let slack = 1e-9 * scale;
        let inside =
            self.between.iter().all(|&k| trial[k] >= self.lo[k] - slack && trial[k] <= self.hi[k] + slack);
        if inside {
            for &k in &self.between {
                trial[k] = trial[k].clamp(self.lo[k], self.hi[k]);
            }
            std::mem::swap(&mut self.x, &mut trial);
        }
        self.trial = trial;
        self.measure();
        inside
    }

    /// w = A x + b.
    fn measure(&mut self) {
        let n = self.n;
        self.w.clear();
        self.w.extend((0..n).map(|k| self.b[k] + dense::dot(&self.a[k * n..][..n], &self.x)));
    }

    /// Whether the sets also hold with the present bounds; x and w are then those of them.
    fn sets_still_hold(&mut self) -> bool {
        self.refine() && self.error() <= 1e-9 * self.size
    }

    /// How far w's signs are violated at most: |x − clamp(x − w)|.
    fn error(&self) -> f64 {
        // As x − w would round w away where x is large.
        let off = |k: usize| {
            let w = self.w[k];
            if w >= 0.0 { w.min(self.x[k] - self.lo[k]) } else { (-w).min(self.hi[k] - self.x[k]) }
        };
        (0..self.n).map(|k| if self.w[k].is_nan() { f64::NAN } else { off(k).abs() }).fold(0.0, worse)
    }

    fn verdict(&self, pivots: usize) -> Outcome {
        let residual = self.error();
        let size = self.size;
        let status = if residual <= 1e-8 * size {
            Status::Solved
        } else if residual <= ROUGH * size {
            Status::Rough
        } else {
            Status::Stalled
        };
        Outcome { status, iterations: pivots, residual }
    }
}

/// Whether a point needs friction rows.
fn has_friction(problem: &ContactProblem, k: usize) -> bool {
    let n = problem.size();
    problem.friction(k) > 0.0 && (3 * k + 1..3 * k + 3).any(|i| problem.w[i * n + i] > 0.0)
}

/// Sine and cosine of axis `j` of `axes` around the half circle, placed so that t₁ points at a corner of the polygon.
fn direction(j: usize, axes: usize) -> (f64, f64) {
    let offset = if axes.is_multiple_of(2) { 0.5 } else { 0.0 };
    libm::sincos(core::f64::consts::PI * (j as f64 + offset) / axes as f64)
}

/// The unit vector of a point's row: the normal, or axis `row` − 1.
fn row_of(row: usize, axes: usize) -> [f64; 3] {
    if row == 0 {
        return [1.0, 0.0, 0.0];
    }
    let (s, c) = direction(row - 1, axes);
    [0.0, c, s]
}

#[cfg(test)]
mod tests;
