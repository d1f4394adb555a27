//! Solvers: from manifolds and velocities to impulses and new velocities.
//!
//! | variant | idea | paper | cost | pick it when | fails |
//! |---|---|---|---|---|---|
//! | [`soft_step`] | sub-steps instead of iterations: soft contacts with a relax pass, load memory | Catto, "Solver2D" (2024); load memory is our own | two sweeps over the rows a sub-step | always, so far | very tall stacks and load ratios above 1000 settle slowly |

pub mod soft_step;

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
