//! Joints within a sub-step.
//!
//! A pass over joints is: where the frames are now (rows: errors and Jacobians), what each row wants (its law, as a
//! velocity), impulses. There are two passes. The first wants errors to vanish at the *end* of the sub-step: errors
//! are measured where the bodies will be if nothing changes, and the row corrects what is left,
//!   Ċ + (C_predicted − C)/h − Ċ_now + push · C/h = 0,
//! so that a swinging body stays on its circle instead of leaving it along the tangent. The relax pass, at the new
//! places, takes the velocity along each row away. Together they are RATTLE (Andersen 1983): second order, and the
//! energy of a frictionless linkage does not drift.
//!
//! Joints that hang together have their unbounded rows (hard rows and springs without a bound) solved at once, see
//! [`Elimination`]; rows with bounds (limits, motors, friction) are solved one by one, before. Where a plan would
//! cost too much (a cloth of joints), each joint's own rows are a block and blocks are solved one after another.
//!
//! Impulses of a row act on both bodies at one common point, so momentum and angular momentum stay.

mod elimination;
mod oscillator;
mod row;

use crate::body::{BodyStore, NONE, SetId};
use crate::constraint::joint::store::{coordinate, follow_turns};
use crate::constraint::joint::{Angle, Geometry, JointKind, JointStore, Rows as Drafts};
use crate::integrate::{Integrator, PrincipalAxes, with_integrator};
use crate::math::scalar::double;
use crate::math::{Float, Quat, Vec3, length, rotate};
use crate::solver::bodies::Bodies;
use crate::solver::rows::Rows;
use crate::solver::{Settings, SubStep};
use elimination::Elimination;
use row::{Pass, SolverRow};
use std::ops::Range;

/// A joint of an awake island.
#[derive(Clone, Debug)]
struct Placed {
    joint: u32,
    /// Solver rows of its bodies; 0 for what does not move.
    body: [u32; 4],
    /// Its rows.
    rows: Range<usize>,
    /// From the centre of A to that of B when the step began.
    offset: Vec3,
    /// Origin of frame A when the step began.
    origin_a: Vec3,
    /// Arms and frames when the step began, world axes.
    arm: [Vec3; 2],
    q: [Quat; 2],
    /// From the centre of B to the origin of frame B now.
    arm_b: Vec3,
    turns: [Angle; 2],
    /// For gears: places of the two joints in the list.
    parts: [u32; 2],
    total: Vec3,
    total_angular: Vec3,
    /// At what share of the full speed errors are pushed out.
    push: Float,
}

/// Joints that hang together.
#[derive(Clone, Debug)]
struct Component {
    /// Places in the list of joints.
    joints: Range<usize>,
    /// How its unbounded rows are solved at once.
    plan: Option<u32>,
    /// The solver rows of its bodies, in the list of members.
    members: Range<usize>,
    /// Whether its joints contradicted each other in this sub-step.
    damped: bool,
}

/// The joints of the step; nothing in it but plans outlives a step.
#[derive(Debug, Default)]
pub struct Workspace {
    joints: Vec<Placed>,
    rows: Vec<SolverRow>,
    components: Vec<Component>,
    /// The components of each batch.
    batches: Vec<Range<usize>>,
    /// Joints by component, as indices of the store, for the topology `version`.
    groups: Vec<Vec<u32>>,
    plans: Vec<Elimination>,
    plan_of: Vec<Option<u32>>,
    version: Option<u64>,
    /// Batch and group of the awake ones.
    order: Vec<(u32, u32)>,
    drafts: Drafts,
    /// Where a body would be after the sub-step: displacement and turn, by solver row.
    ahead: Vec<(Vec3, Quat)>,
    /// Solver rows of the bodies that have joints, by component.
    members: Vec<u32>,
    /// |force| · |arm| over a body's joints, by solver row: sum and greatest.
    load: Vec<[Float; 2]>,
    factor: Vec<f64>,
    size: Vec<f64>,
    least: Vec<f64>,
    unknown: Vec<f64>,
    wanted: Vec<f64>,
    /// What unit impulses of bounded rows make the unbounded ones of their component do.
    responses: Vec<f64>,
    /// What the diagonal of the factored system was raised by.
    damping: f64,
    /// How many rows the last step had.
    pub row_count: usize,
    /// How many joints.
    pub joint_count: usize,
}

impl Workspace {
    /// Whether the step has any joint.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.joints.is_empty()
    }

    /// Bytes held.
    #[must_use]
    pub fn byte_count(&self) -> usize {
        self.joints.capacity() * size_of::<Placed>()
            + self.rows.capacity() * size_of::<SolverRow>()
            + (self.factor.capacity() + self.size.capacity() + self.unknown.capacity()) * 8
            + self.ahead.capacity() * size_of::<(Vec3, Quat)>()
    }

    /// Finds the awake joints and the batches they belong to. Bodies are laid out.
    pub fn begin(&mut self, bodies: &Bodies, store: &BodyStore, joints: &JointStore) {
        self.joints.clear();
        self.rows.clear();
        self.components.clear();
        self.members.clear();
        self.batches.clear();
        self.order.clear();
        if joints.live.is_empty() {
            return;
        }
        if self.version != Some(joints.version) {
            self.group(store, joints);
            self.version = Some(joints.version);
        }
        for (g, group) in self.groups.iter().enumerate() {
            // Each group lies in one island.
            let island = group.iter().find_map(|&j| {
                let mut members = joints.joints[j as usize].members();
                members.find_map(|b| {
                    let body = &store.bodies[b as usize];
                    (body.island != NONE && body.set == SetId::AWAKE).then_some(body.island)
                })
            });
            if let Some(island) = island {
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

    /// After the last batch: last step's impulses.
    pub fn end(&mut self, bodies: &Bodies, joints: &JointStore, settings: &Settings) {
        (self.joint_count, self.row_count) = (self.joints.len(), self.rows.len());
        self.ahead.clear();
        if self.joints.is_empty() {
            return;
        }
        self.ahead.resize(bodies.rows.row.len(), (Vec3::zeros(), Quat::identity()));
        self.load.clear();
        self.load.resize(bodies.rows.row.len(), [0.0; 2]);
        let scale = if settings.last_h > 0.0 { settings.h() / settings.last_h } else { 1.0 };
        for placed in &self.joints {
            let joint = &joints.joints[placed.joint as usize];
            for (row, &impulse) in self.rows[placed.rows.clone()].iter_mut().zip(&joint.impulse) {
                row.lambda = impulse * scale;
            }
        }
    }

    /// Finds what hangs together, and plans its elimination.
    fn group(&mut self, store: &BodyStore, joints: &JointStore) {
        use crate::world::BodyType;
        self.groups.clear();
        self.plans.clear();
        self.plan_of.clear();
        let moves = |b: u32| store.bodies[b as usize].body_type == BodyType::Dynamic;
        let mut seen = vec![false; joints.joints.len()];
        for &seed in &joints.live {
            if seen[seed as usize] || !joints.joints[seed as usize].active {
                continue;
            }
            seen[seed as usize] = true;
            let (mut group, mut next) = (vec![seed], 0);
            while next < group.len() {
                let joint = &joints.joints[group[next] as usize];
                next += 1;
                for body in joint.members().filter(|&b| moves(b)) {
                    for &other in &store.bodies[body as usize].joints {
                        if !seen[other as usize] && joints.joints[other as usize].active {
                            seen[other as usize] = true;
                            group.push(other);
                        }
                    }
                }
            }
            group.sort_unstable();
            // Gears come last: their rows are made from those of other joints.
            group.sort_by_key(|&j| {
                matches!(joints.joints[j as usize].kind, JointKind::Gear(_) | JointKind::RackPinion(_))
            });
            let dims: Vec<usize> = group.iter().map(|&j| self.hard_rows(j, store, joints)).collect();
            let place = |j: u32| group.iter().position(|&g| g == j).expect("of this group") as u32;
            let mut edges = Vec::new();
            if group.len() <= 4000 {
                for (i, &j) in group.iter().enumerate() {
                    for body in joints.joints[j as usize].members().filter(|&b| moves(b)) {
                        for &other in &store.bodies[body as usize].joints {
                            if other != j && joints.joints[other as usize].active {
                                edges.push((i as u32, place(other)));
                            }
                        }
                    }
                }
            }
            let plan = if group.len() <= 4000 { Elimination::plan(&dims, &edges) } else { None };
            self.plan_of.push(plan.map(|plan| {
                self.plans.push(plan);
                self.plans.len() as u32 - 1
            }));
            self.groups.push(group);
        }
    }

    /// How many unbounded rows a joint has.
    fn hard_rows(&mut self, index: u32, store: &BodyStore, joints: &JointStore) -> usize {
        let joint = &joints.joints[index as usize];
        if matches!(joint.kind, JointKind::Gear(_) | JointKind::RackPinion(_)) {
            return 1;
        }
        self.drafts.rows.clear();
        joint.kind.emit(&joint.geometry(store), &mut self.drafts);
        self.drafts.rows.iter().filter(|r| row::is_unbounded(&r.law)).count()
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
        let start = self.joints.len();
        for k in 0..self.groups[group].len() {
            let index = self.groups[group][k];
            let joint = &joints.joints[index as usize];
            let body =
                joint.bodies.map(|b| if b == NONE { 0 } else { bodies.row_for(store, b, batch, settings) });
            for &row in body.iter().filter(|&&r| r != 0) {
                bodies.rows.aux[row as usize].jointed = true;
            }
            let g = joint.geometry(store);
            let part =
                |j: u32| start as u32 + self.groups[group].iter().position(|&o| o == j).unwrap_or(0) as u32;
            let parts = match joint.kind {
                JointKind::Gear(gear) | JointKind::RackPinion(gear) => gear.joints.map(part),
                _ => [0; 2],
            };
            let placed = Placed {
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
            };
            self.joints.push(placed);
            let place = self.joints.len() - 1;
            self.write_drafts(place, joints, |_| (Vec3::zeros(), Quat::identity()));
            let first = self.rows.len();
            for draft in &self.drafts.rows {
                let mut row = SolverRow::new(draft, joint, body, settings.h());
                row.place(draft, &bodies.rows);
                self.rows.push(row);
            }
            self.joints[place].rows = first..self.rows.len();
        }
        let first = self.members.len();
        for placed in &self.joints[start..] {
            self.members.extend(placed.body.iter().filter(|&&b| b != 0));
        }
        self.members[first..].sort_unstable();
        let mut last = 0;
        let mut kept = first;
        for k in first..self.members.len() {
            if self.members[k] != last {
                last = self.members[k];
                self.members[kept] = last;
                kept += 1;
            }
        }
        self.members.truncate(kept);
        self.components.push(Component {
            joints: start..self.joints.len(),
            plan: self.plan_of[group],
            members: first..kept,
            damped: false,
        });
    }

    /// Writes the rows of a joint down, with its bodies moved and turned since the step began by what `moves` says.
    fn write_drafts(
        &mut self,
        place: usize,
        joints: &JointStore,
        moves: impl Fn(u32) -> (Vec3, Quat) + Copy,
    ) {
        self.drafts.rows.clear();
        let placed = &self.joints[place];
        let joint = &joints.joints[placed.joint as usize];
        match &joint.kind {
            JointKind::Gear(gear) | JointKind::RackPinion(gear) => {
                let coordinates = [0, 1].map(|k| {
                    let part = &self.joints[placed.parts[k] as usize];
                    let kind = &joints.joints[part.joint as usize].kind;
                    let mut c = coordinate(kind, &part.geometry(moves))?;
                    c.value -= crate::math::scalar::single(joint.start[k]);
                    Some(c)
                });
                if let [Some(first), Some(second)] = &coordinates {
                    gear.emit([first, second], &mut self.drafts);
                }
            }
            kind => kind.emit(&placed.geometry(moves), &mut self.drafts),
        }
    }

    /// Before forces act: springs note how fast they move.
    pub fn begin_sub_step(&mut self, batch: usize, bodies: &mut Bodies, settings: &Settings) {
        for c in self.batches[batch].clone() {
            self.bear_loads(c, bodies, settings.h(), 1.0);
            let planned = self.components[c].plan.is_some();
            let own = &self.joints[self.components[c].joints.clone()];
            let troubled = self.components[c].damped || own.iter().any(|placed| placed.push < 1.0);
            self.components[c].damped = false;
            for placed in &self.joints[self.components[c].joints.clone()] {
                for row in &mut self.rows[placed.rows.clone()] {
                    row.note_start(&bodies.rows);
                    // What is solved at once needs no memory; where joints contradict each other it does harm.
                    let remembers =
                        if planned { !row.unbounded && (!troubled || !row.is_condensed()) } else { true };
                    if !settings.warm_starting || !remembers {
                        row.lambda = 0.0;
                    }
                }
            }
            for &m in &self.members[self.components[c].members.clone()] {
                let aux = &mut bodies.rows.aux[m as usize];
                aux.joint = [Vec3::zeros(); 2];
                aux.joint_middle = Vec3::zeros();
            }
        }
    }

    /// What the bodies of a component bear by the impulses of the last sub-step, see [`Rows::bear`]. A body on one
    /// joint only bears nothing in this sense: turning it moves its weight. Changes count where the load grew `from` times.
    fn bear_loads(&mut self, component: usize, bodies: &mut Bodies, h: Float, from: Float) -> bool {
        let members = self.members[self.components[component].members.clone()].iter();
        for &m in members.clone() {
            self.load[m as usize] = [0.0; 2];
        }
        let joints = self.components[component].joints.clone();
        for placed in &self.joints[joints.clone()] {
            let rows = &self.rows[placed.rows.clone()];
            for (side, arm) in [(0, placed.arm[0]), (1, placed.arm[1])] {
                let p = rows.iter().fold(Vec3::zeros(), |p, row| p + row.impulse_on(side));
                let load = length(p) * length(arm) / h;
                let known = &mut self.load[placed.body[side] as usize];
                *known = [known[0] + load, known[1].max(load)];
            }
        }
        let mut changed = false;
        for &m in members {
            let [sum, most] = self.load[m as usize];
            changed |= bodies.rows.bear(m as usize, 2.0 * (sum - most), h, from);
        }
        if changed {
            for placed in &self.joints[joints] {
                self.rows[placed.rows.clone()].iter_mut().for_each(|row| row.weigh(&bodies.rows));
            }
        }
        changed
    }

    /// Applies the impulses of the last sub-step again.
    pub fn warm_start(&mut self, batch: usize, rows: &mut Rows) {
        for c in self.batches[batch].clone() {
            for place in self.components[c].joints.clone() {
                for row in &self.rows[self.joints[place].rows.clone()] {
                    row.apply(row.lambda, rows);
                }
            }
        }
    }

    /// The first pass.
    pub fn solve(&mut self, batch: usize, bodies: &mut Bodies, joints: &JointStore, sub: &SubStep) {
        let lag = with_integrator!(sub.integrator, I => I::LAG * sub.h);
        for c in self.batches[batch].clone() {
            // With a plan the velocities are brought in order first, at the price of one more back-substitution: what
            // lies ahead is then nearly right, on light bodies, too.
            let planned = self.components[c].plan.is_some();
            if planned {
                for place in self.components[c].joints.clone() {
                    for row in &mut self.rows[self.joints[place].rows.clone()] {
                        row.want(Pass::Guess, &bodies.rows, sub, lag);
                    }
                }
                self.impulses(c, &mut bodies.rows, true, Aim::Push);
            }
            // A load that comes at once, such as the first one, is borne at once.
            let heavier = planned && self.bear_loads(c, bodies, sub.h, 4.0);
            with_integrator!(sub.integrator, I => self.look_ahead::<I>(c, bodies, sub.h));
            for place in self.components[c].joints.clone() {
                let ahead = std::mem::take(&mut self.ahead);
                self.write_drafts(place, joints, |row| ahead[row as usize]);
                self.ahead = ahead;
                let placed = &self.joints[place];
                for (row, draft) in self.rows[placed.rows.clone()].iter_mut().zip(&self.drafts.rows) {
                    row.want(Pass::Solve { predicted: draft.c }, &bodies.rows, sub, lag);
                }
            }
            self.impulses(c, &mut bodies.rows, heavier || !planned, Aim::Bend);
        }
    }

    /// The relax pass, after bodies were moved.
    pub fn relax(&mut self, batch: usize, bodies: &mut Bodies, joints: &JointStore, sub: &SubStep) {
        for c in self.batches[batch].clone() {
            for place in self.components[c].joints.clone() {
                let moved = |row: u32| {
                    let row = &bodies.rows.row[row as usize];
                    (row.dx(), row.dq())
                };
                let placed = &mut self.joints[place];
                let (mut error, mut asked) = (0.0, 0.0);
                for row in &mut self.rows[placed.rows.clone()] {
                    row.add_before_move(&mut placed.total, &mut placed.total_angular, placed.arm_b);
                    let (e, a) = row.error(sub);
                    error += e;
                    asked += a;
                }
                let geometry = placed.geometry(moved);
                placed.arm_b = geometry.arm[1];
                let joint = &joints.joints[placed.joint as usize];
                follow_turns(&joint.kind, &geometry, &mut placed.turns);
                self.write_drafts(place, joints, moved);
                let placed = &mut self.joints[place];
                let mut left = 0.0;
                for (row, draft) in self.rows[placed.rows.clone()].iter_mut().zip(&self.drafts.rows) {
                    row.place(draft, &bodies.rows);
                    row.want(Pass::Relax, &bodies.rows, sub, 0.0);
                    left += row.error(sub).0;
                }
                // Velocities can always be brought in order, places not: joints that contradict each other would be
                // pushed for ever. Where an error does not go, the push does.
                placed.push = if asked > STUBBORN && error - left < 0.3 * asked {
                    0.5 * placed.push
                } else {
                    (1.5 * placed.push).min(1.0)
                };
                for row in &mut self.rows[placed.rows.clone()] {
                    row.share = placed.push;
                }
            }
            self.impulses(c, &mut bodies.rows, true, Aim::Rest);
            for place in self.components[c].joints.clone() {
                let placed = &mut self.joints[place];
                for row in &self.rows[placed.rows.clone()] {
                    row.add_after_move(&mut placed.total, &mut placed.total_angular, placed.arm_b);
                }
            }
        }
    }

    /// Where bodies with joints would be at the end of the sub-step.
    fn look_ahead<I: Integrator>(&mut self, component: usize, bodies: &Bodies, h: Float) {
        for &m in &self.members[self.components[component].members.clone()] {
            let (row, aux) = (&bodies.rows.row[m as usize], &bodies.rows.aux[m as usize]);
            let lag = if aux.lags() { I::LAG * h } else { 0.0 };
            let dx = row.dx() + (row.v() - aux.accel * lag) * h;
            let inertia = &bodies.rows.inertia[m as usize];
            let dq = if aux.spin {
                let change = crate::solver::rows::inertia_times(aux, row.w() - aux.before[1]);
                let axes = PrincipalAxes { moments: aux.moments, body_from_principal: Quat::identity() };
                let q = I::turn(&aux.q[0], aux.l + change - aux.torque * lag, &axes, h);
                q * aux.q[1].conjugate()
            } else {
                let mean = if aux.torque == Vec3::zeros() {
                    row.w()
                } else {
                    row.w() - inertia.times(aux.torque) * lag
                };
                I::turn_by(&row.dq(), mean * h)
            };
            self.ahead[m as usize] = (dx, dq);
        }
    }

    /// The impulses of a pass over a component; without `factor` its system is that of the last call.
    fn impulses(&mut self, component: usize, rows: &mut Rows, factor: bool, aim: Aim) {
        let Component { joints, plan, members, .. } = self.components[component].clone();
        let Some(plan) = plan else {
            for place in joints {
                let range = self.joints[place].rows.clone();
                for row in self.rows[range.clone()].iter_mut().filter(|r| !r.unbounded) {
                    row.solve(rows);
                }
                row::solve_block(&mut self.rows[range], rows);
            }
            return;
        };
        let range = self.joints[joints.start].rows.start..self.joints[joints.end - 1].rows.end;
        if factor {
            self.responses.clear();
            self.rows[range.clone()].iter_mut().for_each(SolverRow::forget_response);
        }
        self.solve_at_once(plan, joints.clone(), members.clone(), rows, factor, aim);
        let energy = energy_within_reach(&self.members[members.clone()], rows, Aim::Push);
        for _ in 0..ROUNDS {
            let (mut moved, mut disturbed) = (false, false);
            for k in range.clone() {
                if self.rows[k].unbounded || !self.rows[k].wants_change(rows) {
                    continue;
                }
                if self.rows[k].is_condensed() {
                    moved |= self.solve_condensed(k, plan, joints.clone(), rows, energy);
                } else {
                    disturbed |= self.rows[k].solve(rows);
                }
            }
            if disturbed {
                self.solve_at_once(plan, joints.clone(), members.clone(), rows, false, aim);
            }
            if !moved && !disturbed {
                break;
            }
        }
        self.components[component].damped |= self.damping > 0.0;
    }

    /// Solves a bounded row together with what its impulse makes the unbounded rows of its component do: these stay
    /// solved. Says whether its impulse changed by more than a little.
    fn solve_condensed(
        &mut self,
        k: usize,
        plan: u32,
        joints: Range<usize>,
        rows: &mut Rows,
        energy: f64,
    ) -> bool {
        let n = self.plans[plan as usize].unknowns();
        if self.rows[k].response.is_none() {
            let plan = &self.plans[plan as usize];
            let list = &self.joints[joints.clone()];
            let row = &self.rows[k];
            let start = self.responses.len();
            let mut y = std::mem::take(&mut self.unknown);
            y.clear();
            y.extend(self.hard_order(plan, list).map(|hard| -hard.coupling(row, rows)));
            let mut coupling = std::mem::take(&mut self.wanted);
            coupling.clear();
            coupling.extend_from_slice(&y);
            plan.solve(&self.factor, &mut y);
            let with: f64 = y.iter().zip(&coupling).map(|(a, b)| a * b).sum();
            self.responses.extend_from_slice(&y);
            (self.unknown, self.wanted) = (y, coupling);
            let mobility = self.rows[k].coupling(&self.rows[k], rows) - with;
            self.rows[k].set_response(start, mobility);
        }
        let start = self.rows[k].response.expect("set above");
        let change = self.rows[k].change(rows, energy);
        if change == 0.0 {
            return false;
        }
        self.rows[k].lambda += change;
        self.rows[k].apply(change, rows);
        let plan = &self.plans[plan as usize];
        let mut y = self.responses[start..start + n].iter();
        for &node in &plan.order {
            let placed = &self.joints[joints.start + node as usize];
            for row in self.rows[placed.rows.clone()].iter_mut().filter(|r| r.unbounded) {
                let also = crate::math::scalar::single(y.next().expect("one for each") * double(change));
                row.lambda += also;
                row.apply(also, rows);
            }
        }
        change.abs() > 1e-4 * self.rows[k].lambda.abs()
    }

    /// The unbounded rows of a component, in the order of its plan.
    fn hard_order<'a>(
        &'a self,
        plan: &'a Elimination,
        list: &'a [Placed],
    ) -> impl Iterator<Item = &'a SolverRow> {
        plan.order
            .iter()
            .flat_map(|&node| self.rows[list[node as usize].rows.clone()].iter().filter(|r| r.unbounded))
    }

    /// Solves the unbounded rows of a component at once.
    fn solve_at_once(
        &mut self,
        plan: u32,
        joints: Range<usize>,
        members: Range<usize>,
        rows: &mut Rows,
        factor: bool,
        aim: Aim,
    ) {
        let plan = &self.plans[plan as usize];
        let list = &self.joints[joints];
        self.wanted.clear();
        for &node in &plan.order {
            let own = self.rows[list[node as usize].rows.clone()].iter().filter(|r| r.unbounded);
            self.wanted.extend(own.map(|row| row.right_side(rows)));
        }
        if factor {
            self.damping = 0.0;
        }
        let mut energy = energy_within_reach(&self.members[members], rows, aim);
        for (row, wanted) in self.hard_order(plan, list).zip(&self.wanted) {
            energy += row.spring_energy(*wanted);
        }
        loop {
            if factor || self.damping > 0.0 {
                self.factor.clear();
                self.factor.resize(plan.values(), 0.0);
                self.size.clear();
                self.size.resize(plan.unknowns(), 0.0);
                self.least.clear();
                self.least.resize(plan.unknowns(), 0.0);
                let [w, size, least] = [&mut self.factor, &mut self.size, &mut self.least];
                assemble(plan, list, &self.rows, rows, self.damping, w, size, least);
                plan.factor(&mut self.factor, &self.size, &self.least);
            }
            self.unknown.clear();
            self.unknown.extend_from_slice(&self.wanted);
            plan.solve(&self.factor, &mut self.unknown);
            // Joints that contradict each other make a system next to singular, whose answer would tear them apart:
            // what hard rows do to velocities takes no more energy than there is.
            let work: f64 = self.wanted.iter().zip(&self.unknown).map(|(a, b)| a * b).sum();
            if work <= energy {
                break;
            }
            if self.damping >= 1.0 {
                self.unknown.iter_mut().for_each(|x| *x *= energy / work);
                break;
            }
            self.damping = if self.damping == 0.0 { 1e-4 } else { self.damping * 100.0 };
        }
        for (position, &node) in plan.order.iter().enumerate() {
            let placed = &list[node as usize];
            let own = self.rows[placed.rows.clone()].iter_mut().filter(|r| r.unbounded);
            for (row, &change) in own.zip(&self.unknown[plan.start(position)..]) {
                let change = crate::math::scalar::single(change);
                row.lambda += change;
                row.apply(change, rows);
            }
        }
    }

    /// Writes impulses, sums and turns back.
    pub fn store(&self, joints: &mut JointStore, dt: Float) {
        for placed in &self.joints {
            let joint = &mut joints.joints[placed.joint as usize];
            for (impulse, row) in joint.impulse.iter_mut().zip(&self.rows[placed.rows.clone()]) {
                *impulse = row.lambda;
            }
            joint.turns = placed.turns;
            joint.push = placed.push;
            (joint.total, joint.total_angular) = (placed.total, placed.total_angular);
            joint.total_dt = dt;
        }
    }
}

impl Placed {
    /// Where the frames are when the bodies have moved and turned since the step began by what `moves` says.
    fn geometry(&self, moves: impl Fn(u32) -> (Vec3, Quat)) -> Geometry {
        let (xa, ta) = moves(self.body[0]);
        let (xb, tb) = moves(self.body[1]);
        let arm = [rotate(&ta, self.arm[0]), rotate(&tb, self.arm[1])];
        Geometry {
            arm,
            d: self.offset + (xb - xa) + (arm[1] - arm[0]),
            q: [ta * self.q[0], tb * self.q[1]],
            origin_a: self.origin_a + xa + (arm[0] - self.arm[0]),
            turns: self.turns,
        }
    }
}

/// How often bounded and unbounded rows of a component are solved in turn, at most: until the bounded ones stay.
const ROUNDS: usize = 4;

/// Errors that a sub-step is to lessen by less than this \[m, rad\] are what is left of rounding and of motion.
const STUBBORN: Float = 1e-4;

/// What hard rows are solved for.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Aim {
    /// To push errors out.
    Push,
    /// To bend the way of bodies to their circles.
    Bend,
    /// To take velocities away.
    Rest,
}

/// How much |Δv|² (by mass) hard rows may do to some bodies: to take velocities away it is at most |v|², to bend a way
/// by a quarter of a radian a sub-step less; pushing adds what its speed makes of the masses.
fn energy_within_reach(members: &[u32], rows: &Rows, aim: Aim) -> f64 {
    let (share, push) = match aim {
        Aim::Push => (2.0, 2.0),
        Aim::Bend => (0.5, 1e-6),
        Aim::Rest => (1.1, 1e-6),
    };
    members.iter().fold(0.0, |sum, &m| {
        let (row, aux) = (&rows.row[m as usize], &rows.aux[m as usize]);
        if row.inv_mass() == 0.0 {
            return sum;
        }
        let (v, w) = (row.v(), row.w());
        let fast = push * row::PUSH_SPEED * row::PUSH_SPEED + share * v.dot(&v);
        let turning = share * w.dot(&w) + push * row::PUSH_SPEED_ANGULAR * row::PUSH_SPEED_ANGULAR;
        sum + double(fast / row.inv_mass()) + double(turning * aux.moments.max())
    })
}

/// Fills W of a component, its diagonal, and the least part of that by one body.
#[allow(clippy::too_many_arguments)]
fn assemble(
    plan: &Elimination,
    list: &[Placed],
    solver_rows: &[SolverRow],
    rows: &Rows,
    damping: f64,
    w: &mut [f64],
    size: &mut [f64],
    least: &mut [f64],
) {
    for (position, &node) in plan.order.iter().enumerate() {
        let placed = &list[node as usize];
        let own = || solver_rows[placed.rows.clone()].iter().filter(|r| r.unbounded);
        let d = own().count();
        let (at, start) = (plan.diagonal(position), plan.start(position));
        for (r, row) in own().enumerate() {
            for (c, other) in own().enumerate().take(r + 1) {
                w[at + r * d + c] = row.coupling(other, rows);
            }
            w[at + r * d + r] = w[at + r * d + r] * (1.0 + damping) + row.compliance();
            size[start + r] = w[at + r * d + r];
            least[start + r] = row.least_share(rows) + row.compliance();
        }
    }
    for (k, l, at) in plan.blocks() {
        let (a, b) = (&list[plan.order[k] as usize], &list[plan.order[l] as usize]);
        let own = |p: &Placed| solver_rows[p.rows.clone()].iter().filter(|r| r.unbounded);
        let d = own(b).count();
        for (r, row) in own(a).enumerate() {
            for (c, other) in own(b).enumerate() {
                w[at + r * d + c] = row.coupling(other, rows);
            }
        }
    }
}
