//! Projected Gauss–Seidel: impulses are accumulated, and what is clamped is their sum.
//!
//! Each sweep visits every point: λ_n ← max(0, λ_n − σ_n/k_n), then λ_t, by the inverse of its 2×2 block where the
//! friction disc |λ_t| ≤ μ λ_n allows it, else straight against the slip and cut to the disc. So a later visit can take
//! back what an earlier one gave too much, which [`super::sequential_impulse`] cannot. Impulses of the last step are
//! the start. Overlap is pushed out by velocities that are forgotten. \[Catto GDC09; Moreau, Jean 1992\]

use super::bodies::Bodies;
use super::points::Points;
use super::{Settings, SolveReport, SubStep};
use crate::body::BodyStore;
use crate::constraint::ContactStore;

/// Takes every batch through its sub-steps.
pub fn solve(
    points: &mut Points,
    rows: &mut Bodies,
    bodies: &BodyStore,
    contacts: &mut ContactStore,
    settings: &Settings,
    report: &mut SolveReport,
) {
    let sub = settings.sub_step();
    for batch in 0..rows.batches.len() {
        for k in 0..settings.sub_steps {
            let last = k + 1 == settings.sub_steps;
            sub_step(points, rows, bodies, batch, last, &sub, settings, report);
        }
    }
    points.store(contacts);
}

#[expect(clippy::too_many_arguments, reason = "what a sub-step is made of")]
fn sub_step(
    points: &mut Points,
    rows: &mut Bodies,
    bodies: &BodyStore,
    batch: usize,
    last: bool,
    sub: &SubStep,
    settings: &Settings,
    report: &mut SolveReport,
) {
    let range = points.range(rows, batch);
    points.begin(rows, batch, sub);
    rows.apply_forces(batch, true, sub, settings);
    points.warm_start(rows, range.clone(), settings.warm_starting);
    for _ in 0..settings.iterations {
        points.sweep(rows, range.clone());
    }
    if last {
        report.measure(points.residual(rows, range.clone()));
    }
    rows.keep_angular_momentum(batch, false);
    rows.move_bodies(batch, bodies, sub);
    points.push_out(rows, bodies, batch, settings.iterations, sub, settings);
    rows.carry_over(batch, bodies);
    points.close(range);
    rows.keep_angular_momentum(batch, true);
}
