//! Lemke's complementary pivoting: the contact problem as a linear complementarity problem, solved by walking
//! along the edges of a polyhedron.
//!
//! w − M z = q, w ≥ 0, z ≥ 0, wᵀz = 0. One more variable z₀, added to every row, makes any q feasible; from then
//! on the variable whose partner has just left the basis enters it, until z₀ leaves. Which one leaves is decided by
//! the lexicographic ratio test on q perturbed by (ε, ε², …), so that no basis comes twice \[Cottle, Pang, Stone 1992,
//! 4.4 and 4.9\].
//!
//! Friction is the pyramid of Stewart and Trinkle (1996) and Anitescu and Potra (1997): per point λ_n, one βⱼ for
//! each of F directions dⱼ around the circle, and the sliding speed γ:
//!   σ_n ≥ 0 ⊥ λ_n ≥ 0,   dⱼ·σ_t + γ ≥ 0 ⊥ βⱼ ≥ 0,   μ λ_n − Σ βⱼ ≥ 0 ⊥ γ ≥ 0.
//! Its M is copositive, so Lemke ends in a solution wherever bodies are not wedged in (b is in the range of W plus
//! what cones allow); otherwise in a ray. A pyramid with F corners lies inside the cone: friction along a face's
//! middle is cos(π/F) of what it should be, and sliding turns to the nearest corner.
//!
//! The dictionary of n rows and n + 1 columns is pivoted in place, n² a pivot, and about n pivots are needed. At the
//! end the basis is solved once more from the data, by LU with refinement, so that rounding does not add up.

use super::contact_problem::{ContactProblem, Outcome, ROUGH, Status, dense, put_three};

/// Walks from other directions, where rounding led one astray.
const ATTEMPTS: usize = 4;

/// Pivots with a column element below this share of the column's greatest are rounding.
const PIVOT: f64 = 1e-11;

/// Ratios that differ by less than this share are equal, and left to the lexicographic rule.
const TIE: f64 = 1e-12;

/// Below this share of the greatest variable z₀ is zero but for rounding.
const GONE: f64 = 1e-13;

/// The same where the walk cannot go on.
const NEARLY_GONE: f64 = 1e-8;

/// Greatest number of rows of the complementarity problem: about a second.
pub const GREATEST_SIZE: usize = 1000;

/// A basic or nonbasic variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Variable {
    W(usize),
    Z(usize),
    Artificial,
}

/// Memory that is kept between solves.
#[derive(Clone, Debug, Default)]
pub struct Lemke {
    n: usize,
    /// Matrix of the problem, row after row.
    m: Vec<f64>,
    q: Vec<f64>,
    /// The dictionary: basic = constant + Σ column · nonbasic.
    rows: Vec<f64>,
    constant: Vec<f64>,
    basic: Vec<Variable>,
    nonbasic: Vec<Variable>,
    /// Where w_k is: row + 1 if basic, −(column + 1) if not.
    place_of_w: Vec<isize>,
    ties: Vec<usize>,
    pivot_row: Vec<f64>,
    /// The solution z.
    z: Vec<f64>,
    /// Of the final solve: which rows, factors, their order, right side, solution.
    active: Vec<usize>,
    factors: Vec<f64>,
    order: Vec<usize>,
    right: Vec<f64>,
    polished: Vec<f64>,
    correction: Vec<f64>,
    /// Scales of the variables of a contact problem.
    scale: Vec<f64>,
    /// Of each point with friction: its first β row. Of the others: none.
    first_beta: Vec<Option<usize>>,
}

impl Lemke {
    /// Solves w = M z + q with M of n rows, row after row. z is left in [`Lemke::solution`]; the residual is the
    /// greatest |min(z, w)|.
    pub fn complementarity(&mut self, m: &[f64], q: &[f64]) -> Outcome {
        self.n = q.len();
        self.m.clear();
        self.m.extend_from_slice(m);
        self.q.clear();
        self.q.extend_from_slice(q);
        self.run()
    }

    /// z of the last solve.
    #[must_use]
    pub fn solution(&self) -> &[f64] {
        &self.z
    }

    /// Solves a contact problem with friction pyramids of `facets` corners (at least 3). The residual is that of the
    /// scaled complementarity problem: velocities times the root of the mass that resists \[√J\].
    pub fn solve(&mut self, problem: &ContactProblem, facets: usize, lambda: &mut Vec<f64>) -> Outcome {
        lambda.clear();
        lambda.resize(problem.size(), 0.0);
        if let Some(status) = problem.refusal() {
            return Outcome::refused(status);
        }
        let facets = facets.max(3);
        let count = problem.count();
        let with_friction = (0..count).filter(|&k| has_friction(problem, k)).count();
        if count + with_friction * (facets + 1) > GREATEST_SIZE {
            return Outcome::refused(Status::TooLarge);
        }
        self.state(problem, facets);
        let outcome = self.run();
        // Of a failed walk nothing is used.
        if outcome.status.is_usable() {
            for k in 0..count {
                let mut l = nalgebra::Vector3::new(self.z[k] * self.scale[k], 0.0, 0.0);
                if let Some(first) = self.first_beta[k] {
                    for j in 0..facets {
                        let (s, c) = direction(j, facets);
                        let beta = self.z[first + j] * self.scale[first + j];
                        l.y += c * beta;
                        l.z += s * beta;
                    }
                }
                put_three(lambda, k, &l);
            }
        }
        outcome
    }

    /// Writes the complementarity problem of a contact problem. Rows and columns are scaled by 1/√W_ii (the speed γ
    /// by the inverse of its point's), so that light and heavy bodies look alike.
    fn state(&mut self, problem: &ContactProblem, facets: usize) {
        let (count, size) = (problem.count(), problem.size());
        self.first_beta.clear();
        let mut n = count;
        for k in 0..count {
            let friction = has_friction(problem, k);
            self.first_beta.push(friction.then_some(n));
            n += if friction { facets + 1 } else { 0 };
        }
        self.n = n;
        let unit = |w: f64| if w > 0.0 { 1.0 / w.sqrt() } else { 1.0 };
        let diagonal = |i: usize| problem.w[i * size + i];
        self.scale.clear();
        self.scale.resize(n, 1.0);
        for k in 0..count {
            self.scale[k] = unit(diagonal(3 * k));
            if let Some(first) = self.first_beta[k] {
                let s = unit(diagonal(3 * k + 1).max(diagonal(3 * k + 2)));
                self.scale[first..first + facets].fill(s);
                self.scale[first + facets] = 1.0 / s;
            }
        }
        self.m.clear();
        self.m.resize(n * n, 0.0);
        self.q.clear();
        self.q.resize(n, 0.0);
        for i in 0..count {
            self.q[i] = problem.b[3 * i] * self.scale[i];
            for j in 0..count {
                let block = |r: usize, c: usize| problem.w[(3 * i + r) * size + 3 * j + c];
                let mut put = |row: usize, column: usize, value: f64| {
                    self.m[row * n + column] = value * self.scale[row] * self.scale[column];
                };
                put(i, j, block(0, 0));
                if let Some(first) = self.first_beta[j] {
                    for b in 0..facets {
                        let (s, c) = direction(b, facets);
                        put(i, first + b, c * block(0, 1) + s * block(0, 2));
                    }
                }
                let Some(own) = self.first_beta[i] else { continue };
                for a in 0..facets {
                    let (s, c) = direction(a, facets);
                    put(own + a, j, c * block(1, 0) + s * block(2, 0));
                    if let Some(first) = self.first_beta[j] {
                        let along = [c * block(1, 1) + s * block(2, 1), c * block(1, 2) + s * block(2, 2)];
                        for b in 0..facets {
                            let (sb, cb) = direction(b, facets);
                            put(own + a, first + b, cb * along[0] + sb * along[1]);
                        }
                    }
                }
            }
            if let Some(first) = self.first_beta[i] {
                let gamma = first + facets;
                self.m[gamma * n + i] = problem.friction(i) * self.scale[gamma] * self.scale[i];
                for a in 0..facets {
                    let (s, c) = direction(a, facets);
                    let row = first + a;
                    self.q[row] = (c * problem.b[3 * i + 1] + s * problem.b[3 * i + 2]) * self.scale[row];
                    self.m[row * n + gamma] = self.scale[row] * self.scale[gamma];
                    self.m[gamma * n + row] = -self.scale[row] * self.scale[gamma];
                }
            }
        }
    }

    /// Walks, on `m` and `q`, until one arrives.
    fn run(&mut self) -> Outcome {
        let mut outcome = self.walk(0);
        for attempt in 1..ATTEMPTS {
            if outcome.status.is_usable() || outcome.status == Status::NotFinite {
                break;
            }
            let next = self.walk(attempt);
            let worse = next.status == Status::IterationLimit;
            outcome = Outcome {
                iterations: outcome.iterations + next.iterations,
                ..if worse { outcome } else { next }
            };
        }
        outcome
    }

    fn walk(&mut self, attempt: usize) -> Outcome {
        let n = self.n;
        self.z.clear();
        self.z.resize(n, 0.0);
        if self.m.len() != n * n || !self.m.iter().chain(&self.q).all(|v| v.is_finite()) {
            return Outcome::refused(Status::NotFinite);
        }
        let lowest = self.q.iter().copied().fold(0.0, f64::min);
        if lowest >= 0.0 {
            return Outcome { status: Status::Solved, iterations: 0, residual: 0.0 };
        }
        let width = n + 1;
        self.rows.clear();
        self.rows.reserve(n * width);
        for i in 0..n {
            self.rows.extend_from_slice(&self.m[i * n..][..n]);
            self.rows.push(cover(i, attempt));
        }
        self.constant.clear();
        self.constant.extend_from_slice(&self.q);
        self.basic.clear();
        self.basic.extend((0..n).map(Variable::W));
        self.nonbasic.clear();
        self.nonbasic.extend((0..n).map(Variable::Z));
        self.nonbasic.push(Variable::Artificial);
        self.place_of_w.clear();
        self.place_of_w.extend(1..=n as isize);

        // z₀ comes in where q is lowest; of equal ones the last, which is lexicographically the lowest.
        let depth = |i: usize| self.q[i] / cover(i, attempt);
        let first = (0..n).rev().min_by(|&i, &j| depth(i).total_cmp(&depth(j))).unwrap_or(0);
        let mut column = n;
        let mut row = first;
        let limit = 10 * n + 100;
        let mut pivots = 0;
        let status = loop {
            let leaving = self.basic[row];
            self.pivot(row, column);
            pivots += 1;
            let entering = match leaving {
                Variable::Artificial => break Status::Solved,
                Variable::W(k) => Variable::Z(k),
                Variable::Z(k) => Variable::W(k),
            };
            if pivots >= limit {
                break Status::IterationLimit;
            }
            if self.artificial() <= GONE {
                break Status::Solved;
            }
            column = self.nonbasic.iter().position(|&v| v == entering).unwrap_or(n);
            match self.blocking_row(column) {
                Some(r) => row = r,
                None => break Status::Ray,
            }
        };
        // In degenerate problems rounding may leave z₀ in the basis with nothing in it; the residual decides.
        if status != Status::Solved && self.artificial() > NEARLY_GONE {
            return Outcome { status, iterations: pivots, residual: f64::INFINITY };
        }
        for (i, &variable) in self.basic.iter().enumerate() {
            if let Variable::Z(k) = variable {
                self.z[k] = self.constant[i].max(0.0);
            }
        }
        let mut residual = self.error_of(&self.z);
        if self.polish() {
            let better = self.error_of(&self.polished);
            if better <= residual {
                residual = better;
                std::mem::swap(&mut self.z, &mut self.polished);
            }
        }
        let size = -lowest;
        let status = if residual <= 1e-8 * size {
            Status::Solved
        } else if residual <= ROUGH * size {
            Status::Rough
        } else {
            Status::Stalled
        };
        Outcome { status, iterations: pivots, residual }
    }

    /// z₀, as a share of the greatest basic variable.
    fn artificial(&self) -> f64 {
        let scale = self.constant.iter().fold(0.0, |m: f64, c| m.max(c.abs()));
        let at = self.basic.iter().position(|&v| v == Variable::Artificial);
        at.map_or(0.0, |i| self.constant[i].max(0.0) / scale)
    }

    /// Exchanges the basic variable of a row with the nonbasic one of a column.
    fn pivot(&mut self, row: usize, column: usize) {
        let (n, width) = (self.n, self.n + 1);
        let (out, into) = (self.basic[row], self.nonbasic[column]);
        if let Variable::W(k) = out {
            self.place_of_w[k] = -(column as isize + 1);
        }
        if let Variable::W(k) = into {
            self.place_of_w[k] = row as isize + 1;
        }
        (self.basic[row], self.nonbasic[column]) = (into, out);
        // entering = (leaving − constant − Σ other columns) / pivot
        let own = &mut self.rows[row * width..][..width];
        let inverse = 1.0 / own[column];
        own[column] = -1.0;
        for x in own.iter_mut() {
            *x *= -inverse;
        }
        self.constant[row] *= -inverse;
        let constant = self.constant[row];
        self.pivot_row.clear();
        self.pivot_row.extend_from_slice(own);
        for i in (0..n).filter(|&i| i != row) {
            let other = &mut self.rows[i * width..][..width];
            let factor = other[column];
            if factor != 0.0 {
                other[column] = 0.0;
                dense::add_scaled(other, factor, &self.pivot_row);
                self.constant[i] += factor * constant;
            }
        }
    }

    /// Which basic variable is the first to become zero as the column's variable grows; none on a ray.
    fn blocking_row(&mut self, column: usize) -> Option<usize> {
        let (n, width) = (self.n, self.n + 1);
        let greatest = (0..n).map(|i| self.rows[i * width + column].abs()).fold(0.0, f64::max);
        let least = PIVOT * greatest.max(1e-3);
        let ratio = |i: usize| self.constant[i].max(0.0) / -self.rows[i * width + column];
        let falls = |i: usize| self.rows[i * width + column] < -least;
        let best = (0..n).filter(|&i| falls(i)).map(ratio).fold(f64::INFINITY, f64::min);
        if best == f64::INFINITY {
            return None;
        }
        let scale = self.constant.iter().fold(0.0, |m: f64, c| m.max(c.abs()));
        let bound = best * (1.0 + TIE) + TIE * scale;
        let mut ties = std::mem::take(&mut self.ties);
        ties.clear();
        ties.extend((0..n).filter(|&i| falls(i) && ratio(i) <= bound));
        let end = ties.iter().copied().find(|&i| self.basic[i] == Variable::Artificial);
        let row = end.unwrap_or_else(|| self.lexicographic(&mut ties, column));
        self.ties = ties;
        Some(row)
    }

    /// Of rows with equal ratios the one whose perturbed ratio is lowest: coefficients of ε, ε², … in turn.
    fn lexicographic(&self, ties: &mut Vec<usize>, column: usize) -> usize {
        let width = self.n + 1;
        for k in 0..self.n {
            if ties.len() == 1 {
                break;
            }
            let place = self.place_of_w[k];
            // How row i depends on the perturbation of w_k, over the pivot.
            let part = |i: usize| {
                let coefficient = if place > 0 {
                    f64::from(u8::from(i as isize + 1 == place))
                } else {
                    -self.rows[i * width + (-place - 1) as usize]
                };
                coefficient / -self.rows[i * width + column]
            };
            let lowest = ties.iter().map(|&i| part(i)).fold(f64::INFINITY, f64::min);
            let slack = TIE * (1.0 + lowest.abs());
            ties.retain(|&i| part(i) <= lowest + slack);
        }
        ties[0]
    }

    /// Solves for the basic z from the data: M_ZZ z = −q_Z. False where that is singular.
    fn polish(&mut self) -> bool {
        let n = self.n;
        self.active.clear();
        self.active
            .extend(self.basic.iter().filter_map(|v| if let Variable::Z(k) = *v { Some(k) } else { None }));
        self.active.sort_unstable();
        let size = self.active.len();
        self.factors.clear();
        for &i in &self.active {
            self.factors.extend(self.active.iter().map(|&j| self.m[i * n + j]));
        }
        self.right.clear();
        self.right.extend(self.active.iter().map(|&i| -self.q[i]));
        if !dense::lu(&mut self.factors, size, &mut self.order) {
            return false;
        }
        let mut x = std::mem::take(&mut self.correction);
        dense::lu_solve(&self.factors, size, &self.order, &self.right, &mut x);
        self.polished.clear();
        self.polished.resize(n, 0.0);
        for (&i, &v) in self.active.iter().zip(&x) {
            self.polished[i] = v;
        }
        for _ in 0..2 {
            for (place, &i) in self.active.iter().enumerate() {
                self.right[place] = -self.q[i] - dense::dot(&self.m[i * n..][..n], &self.polished);
            }
            dense::lu_solve(&self.factors, size, &self.order, &self.right, &mut x);
            for (&i, &v) in self.active.iter().zip(&x) {
                self.polished[i] += v;
            }
        }
        self.polished.iter_mut().for_each(|v| *v = v.max(0.0));
        self.correction = x;
        true
    }

    /// max |min(z, M z + q)|.
    fn error_of(&self, z: &[f64]) -> f64 {
        let n = self.n;
        (0..n)
            .map(|i| z[i].min(dense::dot(&self.m[i * n..][..n], z) + self.q[i]).abs())
            .fold(0.0, super::contact_problem::worse)
    }
}

/// The column of z₀: all ones at first, other positive numbers in later attempts.
fn cover(i: usize, attempt: usize) -> f64 {
    let golden = 0.618_033_988_749_894_9 * ((i + 1) * attempt) as f64;
    1.0 + 0.5 * (golden - libm::floor(golden))
}

/// Whether a point needs friction rows.
fn has_friction(problem: &ContactProblem, k: usize) -> bool {
    let n = problem.size();
    problem.friction(k) > 0.0 && (3 * k + 1..3 * k + 3).any(|i| problem.w[i * n + i] > 0.0)
}

/// Sine and cosine of direction `j` of `facets` around the circle.
fn direction(j: usize, facets: usize) -> (f64, f64) {
    libm::sincos(core::f64::consts::TAU * j as f64 / facets as f64)
}

#[cfg(test)]
mod tests;
