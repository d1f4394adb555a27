//! Soft step: n sub-steps, each with one soft sweep over the rows and one relax sweep without push-out.
//!
//! Bodies of one batch of islands lie next to each other and go through all sub-steps before the next batch
//! begins, so small islands stay in the cache. From the second sub-step on warm starting is a pass over bodies:
//! arms are fixed within a step, so last sub-step's impulses change velocities by just what they changed then.

mod contact_block;
mod impact;
mod kinds;
mod layout;
mod passes;
mod preload;
mod rows;

pub use layout::Workspace;

use crate::body::BodyStore;
use crate::constraint::ContactStore;
use crate::island::IslandStore;
use crate::math::{Float, Vec3, scalar::PI};

/// What a sub-step's kernels need to know.
#[derive(Clone, Copy, Debug, Default)]
pub struct SubStep {
    /// Length \[s\].
    pub h: Float,
    /// 1/h.
    pub inv_h: Float,
    /// Slower approach does not bounce \[m/s\].
    pub restitution_threshold: Float,
}

/// What the solver is told.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
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
    fn sub_step(&self) -> SubStep {
        let h = self.dt / self.sub_steps as Float;
        let inv_h = 1.0 / h;
        SubStep { h, inv_h, restitution_threshold: self.restitution_threshold }
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

/// Lays the awake islands out in `work`: rows, blocks and batches. New resting contacts get their first impulses.
pub fn prepare(
    work: &mut Workspace,
    bodies: &BodyStore,
    contacts: &mut ContactStore,
    islands: &mut IslandStore,
    settings: &Settings,
) {
    work.lay_out(bodies, contacts, islands, settings);
}

/// Takes every batch through its sub-steps: velocities and moves are left in `work`, impulses in the contacts.
pub fn solve(work: &mut Workspace, bodies: &BodyStore, contacts: &mut ContactStore, settings: &Settings) {
    let sub = settings.sub_step();
    for batch in 0..work.batches.len() {
        for k in 0..settings.sub_steps {
            sub_step(work, bodies, batch, k == 0, &sub, settings);
        }
    }
    for width in &mut work.kinds.by_width {
        for kind in width {
            kind.store(&mut contacts.contacts);
        }
    }
}

/// One sub-step of one batch.
fn sub_step(
    work: &mut Workspace,
    bodies: &BodyStore,
    batch: usize,
    first: bool,
    sub: &SubStep,
    settings: &Settings,
) {
    work.each_group(batch, |kind, range, rows| kind.find_impacts(range, rows, sub));
    work.apply_forces(batch, first, sub, settings);
    if first && settings.warm_starting {
        work.each_group(batch, |kind, range, rows| kind.warm_start(range, rows));
    }
    work.each_group(batch, |kind, range, rows| kind.solve(range, rows, sub));
    work.keep_angular_momentum(batch, false);
    work.move_bodies(batch, bodies, sub);
    work.each_group(batch, |kind, range, rows| kind.relax(range, rows, sub));
    work.carry_over(batch, bodies);
    work.each_group(batch, |kind, range, rows| kind.end_impacts(range, rows));
    work.keep_angular_momentum(batch, true);
}
