//! How the solver fared in a step.

use super::SolverKind;
use super::contact_problem::Status;
use crate::math::Float;

/// How the solver fared in the last step, and what it counts over the world's life.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SolveReport {
    /// The solver that was used; never `Auto` after a step.
    pub solver: SolverKind,
    /// The greatest natural-map error of any contact point when the last sub-step was solved \[m/s\], against the true
    /// friction cone; soft_step does not measure it and leaves 0.
    pub residual: Float,
    /// Islands that an exact solver was asked to solve, all sub-steps taken together.
    pub solves: u32,
    /// Those of them that were too large for it, and swept instead.
    pub too_large: u32,
    /// Those that it left without a usable solution, and that were swept instead.
    pub failed: u32,
    /// How the last of these failures ended; `Solved` where there was none.
    pub failure: Status,
    /// Islands swept instead of solved since the world began.
    pub fallbacks: u64,
}

impl SolveReport {
    /// Forgets the last step.
    pub(super) fn begin_step(&mut self, solver: SolverKind) {
        *self = Self { solver: solver.resolved(), fallbacks: self.fallbacks, ..Self::default() };
    }

    /// Takes in the residual of a batch.
    pub(super) fn measure(&mut self, residual: Float) {
        self.residual = if residual.is_nan() { Float::INFINITY } else { self.residual.max(residual) };
    }

    /// Counts how an exact solver ended.
    pub(super) fn count(&mut self, status: Status) {
        self.solves += 1;
        if status.is_usable() {
            return;
        }
        self.failure = status;
        self.fallbacks += 1;
        if status == Status::TooLarge {
            self.too_large += 1;
        } else {
            self.failed += 1;
        }
    }
}
