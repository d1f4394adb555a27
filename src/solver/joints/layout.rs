//! Lays the joints of the awake islands out: components by batch, their rows, and which rows are solved how.

use super::ball::BallSeed;
use super::direct::Factor;
use super::row::SolverRow;
use super::{AT_HOME, Component, MESH, Placed, Workspace, draft, rows_of};
use crate::body::{BodyStore, NONE, SetId};
use crate::constraint::joint::{JointKind, JointStore};
use crate::math::Vec3;
use crate::solver::Settings;
use crate::solver::bodies::Bodies;
use std::ops::Range;

impl Workspace {
    /// Finds the awake joints and the batches they belong to. Bodies are laid out.
    pub fn begin(&mut self, bodies: &Bodies, store: &BodyStore, joints: &JointStore) {
        self.joints.clear();
        self.rows.clear();
        self.solved.clear();
        self.components.clear();
        self.members.clear();
        self.batches.clear();
        self.order.clear();
        self.balls.clear();
        if joints.live.is_empty() {
            return;
        }
        self.groups.update(store, joints);
        for (g, group) in self.groups.list.iter().enumerate() {
            // Each group lies in one island.
            let island = group.joints.iter().chain(group.balls.iter().flatten()).find_map(|&j| {
                let mut members = joints.joints[j as usize].members();
                members.find_map(|b| {
                    let body = &store.bodies[b as usize];
                    (body.island != NONE && body.set == SetId::AWAKE).then_some(body.island)
                })
            });
            if let Some(island) = island.filter(|&island| bodies.is_gathered(island)) {
                self.order.push((bodies.batch_of(island), g as u32));
            }
        }
        self.order.sort_unstable();
    }

    /// Lays the joints of a batch out. Batches come in order, before their contacts.
    pub fn lay_out_batch(
        &mut self,
        batch: usize,
        bodies: &mut Bodies,
        store: &BodyStore,
        joints: &JointStore,
        settings: &Settings,
    ) {
        let first = self.components.len();
        let from = self.order.partition_point(|o| (o.0 as usize) < batch);
        let to = self.order.partition_point(|o| (o.0 as usize) <= batch);
        for k in from..to {
            self.place(self.order[k].1 as usize, batch, bodies, store, joints, settings);
        }
        self.batches.push(first..self.components.len());
    }

    /// After the last batch and its contacts.
    pub fn end(&mut self, bodies: &Bodies) {
        self.joint_count = self.joints.len() + self.balls.joint_count();
        let mut factors = 1;
        for batch in &self.batches {
            let mut next = 1;
            for component in self.components[batch.clone()].iter_mut().filter(|c| c.planned) {
                let mut members = self.members[component.members.clone()].iter();
                component.touched = members.any(|&m| bodies.rows.aux[m as usize].touched);
                if component.touched || component.rigid {
                    component.factor = next;
                    next += 1;
                }
            }
            factors = factors.max(next);
        }
        if self.factors.len() < factors {
            self.factors.resize_with(factors, Factor::default);
        }
        self.ahead.clear();
        self.load.clear();
        self.lead.clear();
        if self.joint_count > 0 {
            self.ahead.resize(bodies.rows.row.len(), AT_HOME);
            self.load.resize(bodies.rows.row.len(), [0.0; 2]);
            self.lead.resize(bodies.rows.row.len(), [Vec3::zeros(); 2]);
        }
    }

    fn place(
        &mut self,
        group: usize,
        batch: usize,
        bodies: &mut Bodies,
        store: &BodyStore,
        joints: &JointStore,
        settings: &Settings,
    ) {
        let (start, first_member) = (self.joints.len(), self.members.len());
        // Impulses are per sub-step.
        let planned = self.groups.list[group].plan.is_some();
        let mesh = (!planned).then_some([MESH[0] / settings.h(), MESH[1]]);
        let scale = match settings.last_h {
            h if h > 0.0 && settings.warm_starting => settings.h() / h,
            _ => 0.0,
        };
        for k in 0..self.groups.list[group].joints.len() {
            let index = self.groups.list[group].joints[k];
            let joint = &joints.joints[index as usize];
            let body =
                joint.bodies.map(|b| if b == NONE { 0 } else { bodies.row_for(store, b, batch, settings) });
            self.members.extend(body.iter().filter(|&&b| b != 0));
            let g = joint.geometry(store);
            let list = &self.groups.list[group].joints;
            let part = |j: u32| (start + list.iter().position(|&o| o == j).unwrap_or(0)) as u32;
            let parts = match joint.kind {
                JointKind::Gear(gear) | JointKind::RackPinion(gear) => gear.joints.map(part),
                _ => [0; 2],
            };
            self.joints.push(Placed {
                joint: index,
                body,
                rows: 0..0,
                offset: g.d - (g.arm[1] - g.arm[0]),
                origin_a: g.origin_a,
                arm: g.arm,
                arm_b: g.arm[1],
                q: g.q,
                turns: joint.turns,
                parts,
                total: Vec3::zeros(),
                total_angular: Vec3::zeros(),
                push: joint.push,
            });
            let place = self.joints.len() - 1;
            let (first, mut impulses) = (self.rows.len(), joint.impulse.iter());
            let rows = &mut self.rows;
            let geometry = self.joints[place].geometry(|_| AT_HOME);
            draft(
                &self.joints,
                place,
                joints,
                &geometry,
                |_| AT_HOME,
                |draft| {
                    let Some(impulse) = impulses.next() else { return };
                    let mut row = SolverRow::new(draft, joint, body, settings.h(), mesh);
                    row.place(draft, &bodies.rows);
                    row.lambda = impulse * scale;
                    rows.push(row);
                },
            );
            self.joints[place].rows = first..self.rows.len();
        }
        let (hard, bounded) = self.sort_rows(group, start);
        let rigid = planned && self.solved[hard.clone()].iter().all(|&k| self.rows[k as usize].is_hard());
        let first_color = self.balls.color_count();
        for color in 0..self.groups.list[group].balls.len() {
            self.seeds.clear();
            for &index in &self.groups.list[group].balls[color] {
                let joint = &joints.joints[index as usize];
                let g = joint.geometry(store);
                let pair = [joint.bodies[0], joint.bodies[1]];
                let pair = pair.map(|b| bodies.row_for(store, b, batch, settings));
                self.members.extend(pair.iter().filter(|&&b| b != 0));
                let [x, y, z, ..] = joint.impulse.map(|p| p * scale);
                self.seeds.push(BallSeed {
                    source: index,
                    bodies: pair,
                    arm: g.arm,
                    offset: g.d - (g.arm[1] - g.arm[0]),
                    lambda: Vec3::new(x, y, z),
                });
            }
            self.balls.push(&self.seeds, settings.wide, &bodies.rows);
        }
        let own = &mut self.members[first_member..];
        own.sort_unstable();
        let mut kept = 0;
        for k in 0..own.len() {
            if kept == 0 || own[k] != own[kept - 1] {
                own[kept] = own[k];
                kept += 1;
            }
        }
        self.members.truncate(first_member + kept);
        for &m in &self.members[first_member..] {
            let aux = &mut bodies.rows.aux[m as usize];
            (aux.jointed, aux.planned) = (true, planned);
        }
        self.components.push(Component {
            joints: start..self.joints.len(),
            group,
            planned,
            colors: first_color..self.balls.color_count(),
            members: first_member..first_member + kept,
            hard,
            bounded,
            damped: false,
            touched: false,
            rigid,
            factor: 0,
            factored: false,
        });
    }

    /// Lists the unbounded rows and those with bounds of a group with a plan, whose joints are the last ones.
    fn sort_rows(&mut self, group: usize, first_joint: usize) -> (Range<usize>, Range<usize>) {
        let Some(plan) = &self.groups.list[group].plan else { return (0..0, 0..0) };
        let (joints, rows) = (&self.joints[first_joint..], &self.rows);
        let hard = self.solved.len();
        for &node in &plan.order {
            let own = joints[node as usize].rows.clone();
            self.solved.extend(own.filter(|&k| rows[k].unbounded).map(|k| k as u32));
        }
        let bounded = self.solved.len();
        self.solved.extend(rows_of(joints).filter(|&k| !rows[k].unbounded).map(|k| k as u32));
        (hard..bounded, bounded..self.solved.len())
    }
}
