//! Soft step: n sub-steps, each with one soft sweep over the rows and one relax sweep without push-out; where an island
//! has both joints and contacts, two of each.
//!
//! Islands may have different numbers of sub-steps: each batch has its own.
//!
//! Bodies of one batch of islands lie next to each other and go through all sub-steps before the next batch
//! begins, so small islands stay in the cache. From the second sub-step on warm starting is a pass over bodies:
//! arms are fixed within a step, so last sub-step's impulses change velocities by just what they changed then.

mod contact_block;
mod impact;
mod kinds;
mod layout;
mod preload;

pub use layout::Workspace;

use super::bodies::Bodies;
use super::{Settings, SubStep, joints};
use crate::body::BodyStore;
use crate::constraint::{ContactStore, JointStore};
use crate::math::Float;

/// Takes every batch through its sub-steps: velocities and moves are left in `rows`, impulses in the contacts.
pub fn solve(
    work: &mut Workspace,
    rows: &mut Bodies,
    joint_rows: &mut joints::Workspace,
    bodies: &BodyStore,
    contacts: &mut ContactStore,
    joints: &mut JointStore,
    settings: &Settings,
) {
    run(work, rows, joint_rows, bodies, joints, settings);
    joint_rows.store(joints, settings.dt);
    for width in &mut work.kinds.by_width {
        for kind in width {
            kind.store(&mut contacts.contacts);
        }
    }
    for (batch, level) in rows.batches.iter().map(|b| b.level).enumerate().filter(|(_, level)| *level != 0) {
        let factor = sub_step_ratio(level);
        work.scale_stored(batch, contacts, factor);
        joint_rows.scale_stored(batch, joints, factor);
    }
}

/// The same without writing impulses to contacts and joints.
pub fn run(
    work: &mut Workspace,
    rows: &mut Bodies,
    joint_rows: &mut joints::Workspace,
    bodies: &BodyStore,
    joints: &JointStore,
    settings: &Settings,
) {
    for batch in 0..rows.batches.len() {
        let settings = settings.at(rows.batches[batch].level);
        let sub = settings.sub_step();
        for k in 0..settings.sub_steps {
            sub_step(work, rows, joint_rows, bodies, joints, batch, k == 0, &sub, &settings);
        }
    }
}

/// Impulses that outlive a step are those of a sub-step of the world's own number, so that islands of different levels
/// can become one. How many of an island's sub-steps make one of those: a power of two, so that nothing is rounded.
fn sub_step_ratio(level: i32) -> Float {
    let power = (1u32 << level.unsigned_abs()) as Float;
    if level < 0 { 1.0 / power } else { power }
}

/// One sub-step of one batch.
#[allow(clippy::too_many_arguments)]
fn sub_step(
    work: &mut Workspace,
    rows: &mut Bodies,
    joint_rows: &mut joints::Workspace,
    bodies: &BodyStore,
    joints: &JointStore,
    batch: usize,
    first: bool,
    sub: &SubStep,
    settings: &Settings,
) {
    joint_rows.begin_sub_step(batch, rows, settings);
    work.each_group(batch, &mut rows.rows, |kind, range, rows| kind.find_impacts(range, rows, sub));
    rows.apply_forces(batch, first, sub, settings);
    joint_rows.warm_start(batch, &mut rows.rows);
    if first && settings.warm_starting {
        work.each_group(batch, &mut rows.rows, |kind, range, rows| kind.warm_start(range, rows));
    }
    joint_rows.solve(batch, rows, joints, sub);
    work.each_group(batch, &mut rows.rows, |kind, range, rows| kind.solve(range, rows, sub));
    // Where joints and contacts hold the same bodies, each has its say twice: humans in a heap come to rest.
    let twice = rows.batches[batch].mixed;
    if twice {
        joint_rows.again(batch, &mut rows.rows, joints::Aim::Bend);
        work.each_group(batch, &mut rows.rows, |kind, range, rows| kind.solve(range, rows, sub));
    }
    rows.keep_angular_momentum(batch, false);
    rows.move_bodies(batch, bodies, sub);
    joint_rows.relax(batch, rows, joints, sub);
    if twice {
        work.each_group(batch, &mut rows.rows, |kind, range, rows| kind.relax(range, rows, sub, false));
        joint_rows.again(batch, &mut rows.rows, joints::Aim::Rest);
    }
    work.each_group(batch, &mut rows.rows, |kind, range, rows| kind.relax(range, rows, sub, true));
    rows.carry_over(batch, bodies);
    work.each_group(batch, &mut rows.rows, |kind, range, rows| kind.end_impacts(range, rows));
    rows.keep_angular_momentum(batch, true);
}
