//! Projected Gauss–Seidel: impulses are accumulated, and what is clamped is their sum.
//!
//! Each sweep visits every point: λ_n ← max(0, λ_n − σ_n/k_n), then λ_t, by the inverse of its 2×2 block where the
//! friction disc |λ_t| ≤ μ λ_n allows it, else straight against the slip and cut to the disc. So a later visit can take
//! back what an earlier one gave too much, which [`super::sequential_impulse`] cannot. Impulses of the last step are
//! the start. Overlap is pushed out by velocities that are forgotten. \[Catto GDC09; Moreau, Jean 1992\]

use super::rigid::Rigid;

/// Takes every batch through its sub-steps.
pub fn solve(step: &mut Rigid<'_>) {
    step.run(true, |step, batch| {
        let range = step.points.range(step.rows, batch);
        step.points.warm_start(step.rows, range.clone(), step.settings.warm_starting);
        for _ in 0..step.settings.iterations {
            step.sweep_joints(batch);
            step.points.sweep(step.rows, range.clone());
        }
    });
}
