//! Solvers: from manifolds and velocities to impulses and new velocities.
//!
//! | variant | idea | paper | cost | pick it when | fails |
//! |---|---|---|---|---|---|
//! | [`soft_step`] | sub-steps instead of iterations: soft contacts with a relax pass, load memory | Catto, "Solver2D" (2024); load memory is our own | two sweeps over the rows a sub-step | always | very tall stacks and load ratios above 1000 settle slowly |
//! | [`sequential_impulse`] | the thesis's: repeat the impulse of a collision, which only pushes | the thesis, 7.2 and 4.3; Mirtich, Canny 1995 | one visit a point and iteration | to compare with the thesis | stacks sink and creep; separation forces add energy |
//! | [`projected_gauss_seidel`] | accumulated impulses, their sum is clamped; warm start | Moreau, Jean 1992; Catto GDC09 | one visit a point and iteration | many small islands, fixed cost | converges slowly for tall stacks and mass ratios |
//! | [`lemke`] | complementary pivoting, friction pyramid | Stewart, Trinkle 1996; Anitescu, Potra 1997 | n³ for n = K (2 + facets) | small scenes, exact to rounding | friction turns to the pyramid's corners; too large above 1000 rows |
//! | [`dantzig`] | principal pivoting with bounds | Cottle, Dantzig 1968; Baraff 1994 | n³ for n = K (1 + facets/2), a few times | as above, no friction or little sliding | friction limits may not settle; too large above 800 rows |
//! | [`proximal_admm`] | exact cone, De Saxcé's correction, splitting | Carpentier, Le Lidec, Montaut 2024 | n³/3 for n = 3 K a few times, n² an iteration | exact Coulomb friction | mass ratios from 1e5; too large above 256 points; slow for coefficients in the thousands |
//!
//! The last three are *exact*: each solves all contacts of an island as one [`contact_problem`], in double precision.
//! Islands that are too large for them, or that they leave unsolved, are swept by projected Gauss–Seidel, and counted.
//! Rolling resistance is the soft_step solver's only. What they have in common lives in [`points`].

pub mod bodies;
pub mod contact_problem;
pub mod dantzig;
mod exact;
pub mod joints;
pub mod lemke;
mod passes;
pub mod points;
pub mod projected_gauss_seidel;
pub mod proximal_admm;
mod report;
mod rigid;
pub mod rows;
pub mod sequential_impulse;
pub mod soft_step;

pub use report::SolveReport;

use crate::body::BodyStore;
use crate::constraint::{ContactStore, JointStore};
use crate::integrate::IntegratorKind;
use crate::island::IslandStore;
use crate::math::{Float, Vec3, scalar::PI};
use bodies::Bodies;
use points::Points;
use rigid::Rigid;

/// Which solver.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[repr(i32)]
pub enum SolverKind {
    /// The engine chooses.
    #[default]
    Auto = 0,
    /// [`soft_step`].
    SoftStep = 1,
    /// [`sequential_impulse`].
    SequentialImpulse = 2,
    /// [`projected_gauss_seidel`].
    ProjectedGaussSeidel = 3,
    /// [`lemke`].
    Lemke = 4,
    /// [`dantzig`].
    Dantzig = 5,
    /// [`proximal_admm`].
    ProximalAdmm = 6,
}

impl SolverKind {
    /// Every variant, without `Auto`.
    pub const ALL: [SolverKind; 6] = [
        SolverKind::SoftStep,
        SolverKind::SequentialImpulse,
        SolverKind::ProjectedGaussSeidel,
        SolverKind::Lemke,
        SolverKind::Dantzig,
        SolverKind::ProximalAdmm,
    ];

    /// What `Auto` stands for; the others stand for themselves.
    #[must_use]
    pub fn resolved(self) -> Self {
        if self == SolverKind::Auto { SolverKind::SoftStep } else { self }
    }

    /// Whether the solver repeats sweeps over the points, so that `solver_iterations` means something to it.
    #[must_use]
    pub fn iterates(self) -> bool {
        matches!(self, SolverKind::SequentialImpulse | SolverKind::ProjectedGaussSeidel)
    }

    /// The variant's name, as its file is called.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            SolverKind::Auto => "auto",
            SolverKind::SoftStep => "soft_step",
            SolverKind::SequentialImpulse => "sequential_impulse",
            SolverKind::ProjectedGaussSeidel => "projected_gauss_seidel",
            SolverKind::Lemke => "lemke",
            SolverKind::Dantzig => "dantzig",
            SolverKind::ProximalAdmm => "proximal_admm",
        }
    }
}

/// How many constraints are solved side by side. Every width gives the same bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[repr(i32)]
pub enum Lanes {
    /// The engine chooses.
    #[default]
    Auto = 0,
    /// One after another: the oracle.
    One = 1,
    /// Four at a time.
    Four = 2,
}

impl Lanes {
    /// Every width, without `Auto`.
    pub const ALL: [Lanes; 2] = [Lanes::One, Lanes::Four];
}

/// What a sub-step's kernels need to know.
#[derive(Clone, Copy, Debug, Default)]
pub struct SubStep {
    /// Length \[s\].
    pub h: Float,
    /// 1/h.
    pub inv_h: Float,
    /// Slower approach does not bounce \[m/s\].
    pub restitution_threshold: Float,
    /// How bodies are moved.
    pub integrator: IntegratorKind,
}

/// What a solver is told.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// Which solver.
    pub solver: SolverKind,
    /// How bodies are moved.
    pub integrator: IntegratorKind,
    /// \[m/s²\]
    pub gravity: Vec3,
    /// Length of the step \[s\].
    pub dt: Float,
    /// Number of sub-steps, ≥ 1.
    pub sub_steps: u32,
    /// Length of a sub-step of the last step \[s\], 0 for none.
    pub last_h: Float,
    /// Stiffness of contacts between moving bodies as a share of the sub-step rate; twice that on static ones.
    pub stiffness: Float,
    /// Damping ratio of overlap recovery.
    pub damping_ratio: Float,
    /// Greatest push-out speed between moving bodies \[m/s\].
    pub push_out_between_moving: Float,
    /// The same against immovable ones.
    pub push_out_on_static: Float,
    /// Slower approach does not bounce \[m/s\].
    pub restitution_threshold: Float,
    /// Greatest speed \[m/s\].
    pub maximum_linear_speed: Float,
    /// Whether to begin with last step's impulses.
    pub warm_starting: bool,
    /// Whether steady loads are remembered.
    pub load_memory: bool,
    /// Whether four constraints are solved at a time.
    pub wide: bool,
    /// Sweeps a sub-step, of the solvers that iterate; ≥ 1.
    pub iterations: u32,
    /// Corners of the friction pyramids of Lemke and Dantzig, ≥ 3.
    pub friction_facets: u32,
    /// Whether sequential impulses visit the points in another order in every iteration.
    pub shuffle: bool,
    /// Whether the first iterations of sequential impulses correct by more than is missing.
    pub over_correct: bool,
    /// The thesis's separation force between moving bodies: share of the usual push-out.
    pub separation_between_moving: Float,
    /// The same against immovable ones.
    pub separation_on_static: Float,
}

impl Settings {
    /// Length of a sub-step \[s\].
    #[must_use]
    pub fn h(&self) -> Float {
        self.dt / self.sub_steps as Float
    }

    /// The same with the sub-steps of an island of this level: two to that power times as many.
    #[must_use]
    pub fn at(&self, level: i32) -> Self {
        let sub_steps =
            if level < 0 { self.sub_steps >> level.unsigned_abs() } else { self.sub_steps << level };
        Self { sub_steps, ..*self }
    }

    /// What a sub-step's kernels need to know.
    #[must_use]
    pub fn sub_step(&self) -> SubStep {
        let h = self.h();
        SubStep {
            h,
            inv_h: 1.0 / h,
            restitution_threshold: self.restitution_threshold,
            integrator: self.integrator,
        }
    }
}

/// A spring of this frequency \[Hz\] and damping ratio as a soft constraint over a step h, integrated implicitly
/// \[Catto GDC11\]: push-out rate, mass scale, impulse scale; and the greatest push-out speed as it is given.
fn soft(hertz: Float, damping_ratio: Float, h: Float, push_out: Float) -> [Float; 4] {
    let w = 2.0 * PI * hertz;
    let a1 = 2.0 * damping_ratio + h * w;
    let a2 = h * w * a1;
    let a3 = 1.0 / (1.0 + a2);
    [w / a1, a2 * a3, a3, push_out]
}

/// What solvers work with: it holds nothing that outlives a step but memory and the report.
#[derive(Debug, Default)]
pub struct Work {
    /// The bodies of the step.
    pub bodies: Bodies,
    /// The joints of the step.
    pub joints: joints::Workspace,
    /// Of [`soft_step`].
    pub soft_step: soft_step::Workspace,
    /// Of the other solvers.
    points: Points,
    /// Of [`sequential_impulse`].
    sequential: sequential_impulse::Workspace,
    /// Of the exact solvers.
    exact: exact::Workspace,
    /// How the last step went.
    pub report: SolveReport,
}

impl Clone for Work {
    /// Nothing in it outlives a step but the report, so a copy starts empty.
    fn clone(&self) -> Self {
        Self { report: self.report, ..Self::default() }
    }
}

impl Work {
    /// Lays the awake islands out: bodies and constraints. New resting contacts may get their first impulses. In a
    /// rehearsal only the islands that are rehearsed are laid out, with that trial's sub-steps.
    pub fn prepare(
        &mut self,
        bodies: &BodyStore,
        contacts: &mut ContactStore,
        joints: &JointStore,
        islands: &mut IslandStore,
        settings: &Settings,
        rehearsal: Option<usize>,
    ) {
        self.bodies.gather(bodies, contacts, joints, islands, settings, rehearsal);
        self.report.begin_step(settings.solver);
        let Self { bodies: rows, joints: joint_rows, soft_step, points, .. } = self;
        match settings.solver.resolved() {
            SolverKind::Auto | SolverKind::SoftStep => {
                soft_step.lay_out(rows, joint_rows, bodies, contacts, joints, islands, settings);
            }
            SolverKind::SequentialImpulse
            | SolverKind::ProjectedGaussSeidel
            | SolverKind::Lemke
            | SolverKind::Dantzig
            | SolverKind::ProximalAdmm => {
                points.lay_out(rows, joint_rows, bodies, contacts, joints, islands, settings);
            }
        }
    }

    /// Takes every batch through the step: velocities and moves are left in the rows, impulses in the contacts.
    pub fn solve(
        &mut self,
        bodies: &BodyStore,
        contacts: &mut ContactStore,
        joints: &mut JointStore,
        settings: &Settings,
    ) {
        let Self { bodies: rows, joints: joint_rows, soft_step, points, sequential, exact, report } = self;
        let solver = settings.solver.resolved();
        if solver == SolverKind::SoftStep {
            soft_step::solve(soft_step, rows, joint_rows, bodies, contacts, joints, settings);
            return;
        }
        let sub = settings.sub_step();
        let mut step = Rigid { points, rows, joint_rows, bodies, joints, settings, report, sub };
        match solver {
            SolverKind::Auto | SolverKind::SoftStep => {}
            SolverKind::SequentialImpulse => sequential.solve(&mut step),
            SolverKind::ProjectedGaussSeidel => projected_gauss_seidel::solve(&mut step),
            SolverKind::Lemke | SolverKind::Dantzig | SolverKind::ProximalAdmm => exact.solve(&mut step),
        }
        points.store(contacts);
        joint_rows.store(joints, settings.dt);
    }

    /// The same as [`Work::solve`] with soft_step, but nothing outlives it: what it did is left in the rows only.
    pub fn rehearse(&mut self, bodies: &BodyStore, joints: &JointStore, settings: &Settings) {
        soft_step::run(&mut self.soft_step, &mut self.bodies, &mut self.joints, bodies, joints, settings);
    }

    /// Bytes held.
    #[must_use]
    pub fn byte_count(&self) -> usize {
        self.bodies.byte_count()
            + self.joints.byte_count()
            + self.soft_step.byte_count()
            + self.points.byte_count()
            + self.sequential.byte_count()
            + self.exact.byte_count()
    }
}
