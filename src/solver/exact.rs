//! The exact solvers in the engine: every island of contacts is one dense problem in double precision
//! ([`super::contact_problem`]), handed to [`lemke`], [`dantzig`] or [`proximal_admm`].
//!
//! Islands with more points than a method is meant for, and problems that a method leaves without a usable solution,
//! are done by [`FALLBACK_SWEEPS`] sweeps of projected Gauss–Seidel instead: both are counted in the
//! [`SolveReport`](super::SolveReport). Joints are no part of the problem: in worlds that have any, joints and contacts
//! are solved in turn, [`JOINT_ROUNDS`] times.

use super::bodies::Bodies;
use super::contact_problem::{ContactProblem, IMMOVABLE, Mass, Outcome, PointArms, Status, V, three};
use super::dantzig::Dantzig;
use super::lemke::Lemke;
use super::points::{Point, apply, impulse, relative};
use super::proximal_admm::{Options, ProximalAdmm};
use super::rigid::Rigid;
use super::rows::Rows;
use super::{Settings, SolverKind};
use crate::math::Vec3;
use crate::math::scalar::{double, single};
use std::ops::Range;

/// Sweeps over an island that its solver did not solve.
pub const FALLBACK_SWEEPS: u32 = 64;

/// Rounds of joints and contacts in turn, where the world has joints.
const JOINT_ROUNDS: u32 = 8;

/// More points than any of the methods takes: the matrix is not even made.
const GREATEST_COUNT: usize = 1000;

/// What ADMM aims at, as a share of the greatest free velocity, in so many iterations.
const ADMM: Options = Options { iterations: 1000, tolerance: 1e-7, corrected: true };

/// The same where that failed.
const ADMM_AGAIN: Options = Options { iterations: 3000, ..ADMM };

/// Memory that is kept between steps.
#[derive(Debug, Default)]
pub struct Workspace {
    problem: ContactProblem,
    arms: Vec<PointArms>,
    masses: Vec<Mass>,
    lambda: Vec<f64>,
    lemke: Lemke,
    dantzig: Dantzig,
    admm: ProximalAdmm,
}

impl Workspace {
    /// Bytes held by the matrices of the problem.
    #[must_use]
    pub fn byte_count(&self) -> usize {
        self.problem.w.capacity() * 8 + self.arms.capacity() * size_of::<PointArms>()
    }

    /// Takes every batch through its sub-steps.
    pub fn solve(&mut self, step: &mut Rigid<'_>) {
        step.run(true, |step, batch| {
            let rounds = if step.joint_rows.is_empty() { 1 } else { JOINT_ROUNDS };
            for round in 0..rounds {
                if rounds > 1 {
                    step.sweep_joints(batch);
                }
                for place in step.rows.batches[batch].islands.clone() {
                    self.solve_contacts(step, place, round > 0, round + 1 == rounds);
                }
            }
        });
    }

    /// All contacts of an island; `again` in further rounds, where the impulses of the last one are taken back first.
    fn solve_contacts(&mut self, step: &mut Rigid<'_>, place: usize, again: bool, last: bool) {
        let island = step.points.of_island[place].clone();
        if island.is_empty() {
            return;
        }
        if again {
            for p in &step.points.points[island.clone()] {
                apply(&mut step.rows.rows, p, impulse(p, p.lambda.map(|l| -l)));
            }
        }
        let outcome = self.solve_island(&step.points.points[island.clone()], step.rows, place, step.settings);
        if last {
            step.report.count(outcome.status);
        }
        if outcome.status.is_usable() {
            for (k, p) in step.points.points[island].iter_mut().enumerate() {
                let (l, axes) = (three(&self.lambda, k), &self.arms[k].axes);
                let whole = axes[0] * l.x + axes[1] * l.y + axes[2] * l.z;
                p.lambda = p.axes.map(|axis| single(whole.dot(&wide(axis))));
                p.lambda[0] = p.lambda[0].max(0.0);
                apply(&mut step.rows.rows, p, impulse(p, p.lambda));
            }
        } else {
            step.points.warm_start(step.rows, island.clone(), step.settings.warm_starting);
            for _ in 0..FALLBACK_SWEEPS {
                step.points.sweep(step.rows, island.clone());
            }
        }
    }

    /// States the problem of one island and solves it; impulses are left in `lambda`.
    fn solve_island(
        &mut self,
        points: &[Point],
        rows: &Bodies,
        place: usize,
        settings: &Settings,
    ) -> Outcome {
        if points.len() > GREATEST_COUNT {
            return Outcome::refused(Status::TooLarge);
        }
        let own = rows.islands[place].rows.clone();
        self.masses.clear();
        self.masses.extend(own.clone().map(|i| {
            let [[xx, xy, xz, yy], [yz, zz, ..]] = rows.rows.inertia[i].0;
            Mass {
                inv_mass: double(rows.rows.row[i].inv_mass()),
                inv_inertia: [xx, xy, xz, yy, yz, zz].map(double),
            }
        }));
        self.arms.clear();
        self.arms.extend(points.iter().map(|p| arms_of(p, &own, &rows.rows)));
        self.problem.assemble(&self.arms, &self.masses);
        self.lambda.clear();
        for (k, p) in points.iter().enumerate() {
            let v = wide(relative(&rows.rows, p) - impulse(p, p.target));
            let keep = if settings.warm_starting && !p.bounces { 1.0 } else { 0.0 };
            let last = wide(impulse(p, p.lambda)) * keep;
            for (i, axis) in self.arms[k].axes.iter().enumerate() {
                self.problem.b[3 * k + i] = v.dot(axis);
                self.lambda.push(last.dot(axis));
            }
            self.problem.mu[k] = double(p.coefficient());
        }
        let facets = settings.friction_facets as usize;
        match settings.solver {
            SolverKind::Lemke => self.lemke.solve(&self.problem, facets, &mut self.lambda),
            SolverKind::Dantzig => self.dantzig.solve(&self.problem, facets, &mut self.lambda),
            _ => {
                let warm = self.admm.solve(&self.problem, &ADMM, &mut self.lambda);
                if warm.status.is_usable()
                    || warm.status == Status::NotFinite
                    || warm.status == Status::TooLarge
                {
                    return warm;
                }
                // At great mass ratios the last impulses are a worse start than none.
                self.lambda.fill(0.0);
                self.admm.solve(&self.problem, &ADMM_AGAIN, &mut self.lambda)
            }
        }
    }
}

fn wide(v: Vec3) -> V {
    V::new(double(v.x), double(v.y), double(v.z))
}

/// A point in double precision, with its bodies' places in the island. Its first tangent goes along the slip that there
/// would be without contact impulses, so that a friction pyramid has a corner where it matters most.
fn arms_of(p: &Point, island: &Range<usize>, rows: &Rows) -> PointArms {
    let n = wide(p.axes[0]).normalize();
    let slip = wide(relative(rows, p) - impulse(p, p.target));
    let slip = slip - n * n.dot(&slip);
    let given = wide(p.axes[1]);
    let t = if slip.norm_squared() > 0.0 { slip.normalize() } else { given };
    let t = (t - n * n.dot(&t)).normalize();
    PointArms {
        bodies: p.rows.map(|r| {
            let r = r as usize;
            if island.contains(&r) { r - island.start } else { IMMOVABLE }
        }),
        axes: [n, t, n.cross(&t)],
        arms: p.arms.map(wide),
    }
}
