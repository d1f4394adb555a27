//! The sub-step of the rigid solvers, around what makes them differ: how velocities are solved.
//!
//! Joints are swept between the contacts, as in soft_step: a solve is repeated with theirs where an island has both.

use super::bodies::Bodies;
use super::points::Points;
use super::{Settings, SolveReport, SubStep, joints};
use crate::body::BodyStore;
use crate::constraint::JointStore;

/// Sweeps that push overlap out, at least.
const PUSH_SWEEPS: u32 = 4;

/// A step of a rigid solver, and all that it works on.
pub struct Rigid<'a> {
    /// Contact points.
    pub points: &'a mut Points,
    /// Solver rows of the bodies.
    pub rows: &'a mut Bodies,
    /// Joints.
    pub joint_rows: &'a mut joints::Workspace,
    /// The bodies themselves.
    pub bodies: &'a BodyStore,
    /// The joints themselves.
    pub joints: &'a JointStore,
    /// What the solver is told.
    pub settings: &'a Settings,
    /// How it fares.
    pub report: &'a mut SolveReport,
    /// What sub-steps need to know.
    pub sub: SubStep,
}

impl Rigid<'_> {
    /// Takes every batch through its sub-steps; `velocities` solves those of a batch. With `push_out`, overlap is pushed
    /// out by velocities that are forgotten.
    pub fn run(&mut self, push_out: bool, mut velocities: impl FnMut(&mut Self, usize)) {
        for batch in 0..self.rows.batches.len() {
            let range = self.points.range(self.rows, batch);
            for k in 0..self.settings.sub_steps {
                self.points.begin(self.rows, batch, &self.sub, self.settings);
                self.joint_rows.begin_sub_step(batch, self.rows, self.settings);
                self.rows.apply_forces(batch, true, &self.sub, self.settings);
                self.joint_rows.warm_start(batch, &mut self.rows.rows);
                velocities(self, batch);
                // Joints have the last word: a contact that is left open shows less.
                self.sweep_joints(batch);
                if k + 1 == self.settings.sub_steps {
                    self.report.measure(self.points.residual(self.rows, range.clone()));
                }
                self.rows.keep_angular_momentum(batch, false);
                self.rows.move_bodies(batch, self.bodies, &self.sub);
                self.joint_rows.relax(batch, self.rows, self.joints, &self.sub);
                if push_out {
                    let sweeps = self.settings.iterations.max(PUSH_SWEEPS);
                    self.points.push_out(self.rows, self.bodies, batch, sweeps, &self.sub, self.settings);
                }
                self.rows.carry_over(batch, self.bodies);
                self.points.close(range.clone());
                self.rows.keep_angular_momentum(batch, true);
            }
        }
    }

    /// One pass over the joints of a batch.
    pub fn sweep_joints(&mut self, batch: usize) {
        if self.joint_rows.is_empty() {
            return;
        }
        self.joint_rows.solve(batch, self.rows, self.joints, &self.sub);
    }
}
