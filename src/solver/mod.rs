//! Solvers: from manifolds and velocities to impulses and new velocities.
//!
//! | variant | idea | paper | cost | pick it when | fails |
//! |---|---|---|---|---|---|
//! | [`soft_step`] | sub-steps instead of iterations: soft contacts with a relax pass, load memory | Catto, "Solver2D" (2024); load memory is our own | two sweeps over the rows a sub-step | always, so far | very tall stacks and load ratios above 1000 settle slowly |

pub mod bodies;
pub mod contact_problem;
pub mod dantzig;
pub mod lemke;
mod passes;
pub mod proximal_admm;
pub mod rows;
pub mod soft_step;

use crate::body::BodyStore;
use crate::constraint::ContactStore;
use crate::integrate::IntegratorKind;
use crate::island::IslandStore;
use crate::math::{Float, Vec3};
use bodies::Bodies;

/// Which solver.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[repr(i32)]
pub enum SolverKind {
    /// The engine chooses.
    #[default]
    Auto = 0,
    /// [`soft_step`].
    SoftStep = 1,
}

impl SolverKind {
    /// Every variant, without `Auto`.
    pub const ALL: [SolverKind; 1] = [SolverKind::SoftStep];

    /// The variant's name, as its file is called.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            SolverKind::Auto => "auto",
            SolverKind::SoftStep => "soft_step",
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
}

impl Settings {
    /// Length of a sub-step \[s\].
    #[must_use]
    pub fn h(&self) -> Float {
        self.dt / self.sub_steps as Float
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

/// What solvers work with: it holds nothing that outlives a step but memory.
#[derive(Debug, Default)]
pub struct Work {
    /// The bodies of the step.
    pub bodies: Bodies,
    /// Of [`soft_step`].
    pub soft_step: soft_step::Workspace,
}

impl Clone for Work {
    /// Nothing in it outlives a step, so a copy starts empty.
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl Work {
    /// Lays the awake islands out: bodies and constraints. New resting contacts may get their first impulses.
    pub fn prepare(
        &mut self,
        bodies: &BodyStore,
        contacts: &mut ContactStore,
        islands: &mut IslandStore,
        settings: &Settings,
    ) {
        self.bodies.gather(bodies, contacts, islands);
        match settings.solver {
            SolverKind::Auto | SolverKind::SoftStep => {
                self.soft_step.lay_out(&mut self.bodies, bodies, contacts, islands, settings);
            }
        }
    }

    /// Takes every batch through the step: velocities and moves are left in the rows, impulses in the contacts.
    pub fn solve(&mut self, bodies: &BodyStore, contacts: &mut ContactStore, settings: &Settings) {
        match settings.solver {
            SolverKind::Auto | SolverKind::SoftStep => {
                soft_step::solve(&mut self.soft_step, &mut self.bodies, bodies, contacts, settings);
            }
        }
    }

    /// Bytes held.
    #[must_use]
    pub fn byte_count(&self) -> usize {
        self.bodies.byte_count() + self.soft_step.byte_count()
    }
}
