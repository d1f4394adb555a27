//! Proximal ADMM on the exact Coulomb cone (Carpentier, Le Lidec, Montaut, "From Compliant to Rigid Contact
//! Simulation", RSS 2024): the nonlinear complementarity problem with De Saxcé's correction, its two hard parts taken
//! in turn, a linear system and a projection to the cones.
//!
//!   λ⁺ = (W + (η + ρ) 1)⁻¹ (η λ + ρ y + z − b − s)
//!   y⁺ = P_K(λ⁺ − z/ρ)              the impulses
//!   z⁺ = z − ρ (λ⁺ − y⁺)            the velocities, corrected
//!   s⁺ = (μ |z_t|, 0, 0)            De Saxcé; left out for the associated (convex) problem
//!
//! W + (η + ρ) 1 is factored once for each ρ. ρ begins at √(L m) (L/m)^⅕ with L the greatest eigenvalue and m = η, and
//! grows or shrinks by (L/m)^¹⁄₂₀ where the one residual exceeds the other by ten: a few factorisations in all. Hyperstatic
//! problems need nothing special, as η makes the system regular and its effect vanishes where the iteration ends.
//! Points are scaled by 1/√w before, all three components alike so that cones stay cones.

use super::contact_problem::{
    ContactProblem, Outcome, ROUGH, Status, V, dense, project, put_three, tangent_length, three,
};

/// η: the proximal term, in scaled units.
const PROXIMAL: f64 = 1e-6;

/// ρ changes when one residual exceeds the other by this factor.
const BALANCE: f64 = 10.0;

/// Greatest number of points: about a second.
pub const GREATEST_COUNT: usize = 256;

/// What the method is told.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Iterations at most.
    pub iterations: usize,
    /// The residual aimed at, as a share of the greatest free velocity.
    pub tolerance: f64,
    /// Whether with De Saxcé's correction: Coulomb's law. Without, the associated problem, whose slip lifts off.
    pub corrected: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { iterations: 2000, tolerance: 1e-7, corrected: true }
    }
}

/// Memory that is kept between solves.
#[derive(Clone, Debug, Default)]
pub struct ProximalAdmm {
    scale: Vec<f64>,
    g: Vec<f64>,
    b: Vec<f64>,
    factor: Vec<f64>,
    x: Vec<f64>,
    last_x: Vec<f64>,
    y: Vec<f64>,
    z: Vec<f64>,
    s: Vec<f64>,
    best: Vec<f64>,
    /// How often W was factored in the last solve.
    pub factorisations: usize,
}

impl ProximalAdmm {
    /// Solves a contact problem from the impulses in `lambda` (zeros where its length does not fit). The residual is the
    /// natural map's \[m/s\].
    pub fn solve(&mut self, problem: &ContactProblem, options: &Options, lambda: &mut Vec<f64>) -> Outcome {
        let (n, count) = (problem.size(), problem.count());
        self.factorisations = 0;
        if let Some(status) = problem.refusal() {
            lambda.clear();
            lambda.resize(n, 0.0);
            return Outcome::refused(status);
        }
        if count > GREATEST_COUNT {
            return Outcome::refused(Status::TooLarge);
        }
        if lambda.len() != n || !lambda.iter().all(|v| v.is_finite()) {
            lambda.clear();
            lambda.resize(n, 0.0);
        }
        let natural = |l: &[f64]| {
            if options.corrected { problem.residual(l) } else { problem.associated_residual(l) }
        };
        let goal = options.tolerance * problem.scale();
        let mut least = natural(lambda);
        if least <= goal {
            return Outcome { status: Status::Solved, iterations: 0, residual: least };
        }
        self.prepare(problem, lambda, options.corrected);
        let largest = self.largest_eigenvalue(n);
        let ratio = (largest / PROXIMAL).max(1.0);
        let growth = libm::pow(ratio, 0.05);
        let mut rho = (largest * PROXIMAL).sqrt() * libm::pow(ratio, 0.2);
        if !self.refactor(n, rho) {
            return Outcome { status: Status::Stalled, iterations: 0, residual: least };
        }
        self.best.clear();
        self.best.extend_from_slice(lambda);
        let scaled_goal = options.tolerance * self.b.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        let mut done = 0;
        let mut since_change = 0;
        while done < options.iterations {
            let (primal, dual) = self.iterate(problem, rho, options.corrected);
            done += 1;
            since_change += 1;
            // ‖λ − y‖ is an impulse; scaled rows have a mobility near 1, so it reads as a velocity, too.
            if (primal <= scaled_goal && dual <= scaled_goal) || done % 32 == 0 || done == options.iterations
            {
                lambda.clear();
                lambda.extend(self.y.iter().enumerate().map(|(i, v)| v * self.scale[i / 3]));
                let error = natural(lambda);
                if error < least {
                    least = error;
                    self.best.copy_from_slice(lambda);
                }
                if least <= goal {
                    break;
                }
                if !error.is_finite() {
                    break;
                }
            }
            if since_change >= 4 {
                let next = if primal > BALANCE * dual {
                    rho * growth
                } else if dual > BALANCE * primal {
                    rho / growth
                } else {
                    rho
                };
                if next != rho {
                    rho = next.clamp(1e-9, 1e9);
                    since_change = 0;
                    if !self.refactor(n, rho) {
                        break;
                    }
                }
            }
        }
        lambda.copy_from_slice(&self.best);
        let status = if least <= goal {
            Status::Solved
        } else if least <= ROUGH * problem.scale() {
            Status::Rough
        } else if done < options.iterations {
            Status::Stalled
        } else {
            Status::IterationLimit
        };
        Outcome { status, iterations: done, residual: least }
    }

    /// The scaled problem, and where the iteration begins.
    fn prepare(&mut self, problem: &ContactProblem, lambda: &[f64], corrected: bool) {
        let (n, count) = (problem.size(), problem.count());
        self.scale.clear();
        self.scale.extend((0..count).map(|k| {
            let w = problem.mobility(k);
            if w > 0.0 { 1.0 / w.sqrt() } else { 1.0 }
        }));
        self.g.clear();
        for i in 0..n {
            let own = self.scale[i / 3];
            self.g
                .extend(problem.w[i * n..][..n].iter().enumerate().map(|(j, w)| w * own * self.scale[j / 3]));
        }
        self.b.clear();
        self.b.extend(problem.b.iter().enumerate().map(|(i, v)| v * self.scale[i / 3]));
        self.x.clear();
        self.x.extend(lambda.iter().enumerate().map(|(i, v)| v / self.scale[i / 3]));
        self.y.clear();
        self.y.resize(n, 0.0);
        self.z.clear();
        self.s.clear();
        self.s.resize(n, 0.0);
        for k in 0..count {
            let start = project(&three(&self.x, k), problem.friction(k));
            put_three(&mut self.y, k, &start);
        }
        self.z.extend((0..n).map(|i| self.b[i] + dense::dot(&self.g[i * n..][..n], &self.y)));
        for k in 0..count {
            let mu = problem.friction(k);
            let mut z: V = three(&self.z, k);
            if corrected {
                self.s[3 * k] = mu * tangent_length(&z);
                z.x += self.s[3 * k];
            }
            // The multiplier starts in the dual cone.
            put_three(&mut self.z, k, &(z + project(&-z, mu)));
        }
        self.x.copy_from_slice(&self.y);
    }

    /// By the power method from a fixed start; the trace is an upper bound.
    fn largest_eigenvalue(&mut self, n: usize) -> f64 {
        let trace: f64 = (0..n).map(|i| self.g[i * n + i]).sum();
        let (v, out) = (&mut self.last_x, &mut self.best);
        v.clear();
        v.extend((0..n).map(|i| 1.0 + 0.1 * (i % 7) as f64));
        let mut value = 0.0;
        for _ in 0..20 {
            let length = dense::dot(v, v).sqrt();
            if length <= 0.0 {
                break;
            }
            v.iter_mut().for_each(|x| *x /= length);
            out.clear();
            out.extend((0..n).map(|i| dense::dot(&self.g[i * n..][..n], v)));
            value = dense::dot(out, v);
            std::mem::swap(v, out);
        }
        value.clamp(PROXIMAL, trace.max(PROXIMAL))
    }

    fn refactor(&mut self, n: usize, rho: f64) -> bool {
        self.factor.clear();
        self.factor.extend_from_slice(&self.g);
        for i in 0..n {
            self.factor[i * n + i] += PROXIMAL + rho;
        }
        self.factorisations += 1;
        dense::cholesky(&mut self.factor, n)
    }

    /// One iteration; the greatest primal and dual residual.
    fn iterate(&mut self, problem: &ContactProblem, rho: f64, corrected: bool) -> (f64, f64) {
        let n = problem.size();
        self.last_x.clear();
        self.last_x.extend_from_slice(&self.x);
        for i in 0..n {
            self.x[i] = PROXIMAL * self.x[i] + rho * self.y[i] + self.z[i] - self.b[i] - self.s[i];
        }
        dense::cholesky_solve(&self.factor, n, &mut self.x);
        let (mut primal, mut dual): (f64, f64) = (0.0, 0.0);
        for k in 0..problem.count() {
            let (x, z, old): (V, V, V) = (three(&self.x, k), three(&self.z, k), three(&self.y, k));
            let mu = problem.friction(k);
            let y = project(&(x - z / rho), mu);
            let z = z - (x - y) * rho;
            primal = primal.max((x - y).amax());
            let mut change = (y - old) * rho + (x - three(&self.last_x, k)) * PROXIMAL;
            if corrected {
                let s = mu * tangent_length(&z);
                change.x += s - self.s[3 * k];
                self.s[3 * k] = s;
            }
            dual = dual.max(change.amax());
            put_three(&mut self.y, k, &y);
            put_three(&mut self.z, k, &z);
        }
        (primal, dual)
    }
}

#[cfg(test)]
mod tests;
