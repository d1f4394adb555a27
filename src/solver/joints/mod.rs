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
//! [`direct`]; rows with bounds (limits, motors, friction) come after them, in turn with what they make the others do.
//! Between the relax pass and the first pass of the next sub-step no body moves: without springs, and unless a body comes
//! to bear another load, the factor of the one is that of the other.
//! Where a plan would cost too much (a cloth of joints), each joint's own rows are a block and blocks are solved one
//! after another, softly; plain ball joints then go in lanes, see [`mesh`].
//!
//! Impulses of a row act on both bodies at one common point, so momentum and angular momentum stay.

mod ball;
mod blocks;
mod direct;
mod elimination;
mod groups;
mod layout;
mod mesh;
mod oscillator;
mod row;

use crate::constraint::joint::store::{coordinate, follow_turns};
use crate::constraint::joint::{Angle, Geometry, JointKind, JointRow, JointStore};
use crate::integrate::{Integrator, PrincipalAxes, with_integrator};
use crate::math::{Float, Quat, Vec3, length, rotate};
use crate::simd::Quad;
use crate::solver::bodies::Bodies;
use crate::solver::rows::{Rows, inertia_times};
use crate::solver::{Settings, SubStep, soft};
use ball::BallSeed;
pub use direct::Aim;
use direct::{Direct, Factor, Of};
use groups::Groups;
use mesh::{Balls, BeginRelax, End, Forget, LookAhead, Solve, WarmStart};
use row::{PUSH_SPEED, Pair, Pass, SolverRow};
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
    /// The group it is.
    group: usize,
    /// Whether its unbounded rows are solved at once.
    planned: bool,
    /// Places in the list of colours of ball joints.
    colors: Range<usize>,
    /// The solver rows of its bodies, in the list of members.
    members: Range<usize>,
    /// With a plan: its unbounded rows in the order of the plan, and those with bounds, in the list of solved rows.
    hard: Range<usize>,
    bounded: Range<usize>,
    /// Whether its joints contradicted each other in this sub-step.
    damped: bool,
    /// Whether bodies of it have contacts.
    touched: bool,
    /// Whether its unbounded rows do not give: then W is the same in all passes over rows at the same places.
    rigid: bool,
    /// Which of the factors it uses: one of its own in its batch if it is used again in a later pass, else 0.
    factor: usize,
    /// Whether that is of its rows as they are, though maybe damped.
    factored: bool,
}

/// The joints of the step; nothing in it but how groups are solved outlives a step.
#[derive(Debug, Default)]
pub struct Workspace {
    joints: Vec<Placed>,
    rows: Vec<SolverRow>,
    components: Vec<Component>,
    /// Places in the list of rows of what is solved at once.
    solved: Vec<u32>,
    /// The components of each batch.
    batches: Vec<Range<usize>>,
    groups: Groups,
    balls: Balls,
    /// Batch and group of the awake ones.
    order: Vec<(u32, u32)>,
    /// Where a body would be after the sub-step: displacement and turn, by solver row.
    ahead: Vec<[Quad; 2]>,
    /// Acceleration, and what torque does, of bodies that are moved by less than their velocity, by solver row; else 0.
    lead: Vec<[Vec3; 2]>,
    /// Solver rows of the bodies that have joints, by component.
    members: Vec<u32>,
    /// Velocities of members before a pass.
    before: Vec<[Vec3; 2]>,
    /// |force| · |arm| over a body's joints, by solver row: sum and greatest.
    load: Vec<[Float; 2]>,
    direct: Direct,
    /// The first for all that need theirs for one pass only.
    factors: Vec<Factor>,
    seeds: Vec<BallSeed>,
    /// How many joints the last step had.
    pub joint_count: usize,
}

/// A body that has not moved yet.
const AT_HOME: [Quad; 2] = [[0.0; 4], [0.0, 0.0, 0.0, 1.0]];

impl Workspace {
    /// Whether the step has no joint.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.joint_count == 0
    }

    /// Bytes held.
    #[must_use]
    pub fn byte_count(&self) -> usize {
        self.joints.capacity() * size_of::<Placed>()
            + self.rows.capacity() * size_of::<SolverRow>()
            + self.balls.byte_count()
            + self.ahead.capacity() * size_of::<[Quad; 2]>()
            + self.direct.byte_count()
            + self.factors.iter().map(Factor::byte_count).sum::<usize>()
    }

    /// Before forces act: springs note how fast they move.
    pub fn begin_sub_step(&mut self, batch: usize, bodies: &mut Bodies, settings: &Settings) {
        for c in self.batches[batch].clone() {
            let component = self.components[c].clone();
            if component.planned {
                self.bear_loads(c, bodies, settings.h(), 1.0);
            }
            let own = &self.joints[component.joints.clone()];
            let troubled = component.damped || own.iter().any(|placed| placed.push < 1.0);
            self.components[c].damped = false;
            for row in &mut self.rows[rows_of(own)] {
                row.note_start(&bodies.rows);
                // What is solved at once needs no memory; where joints contradict each other it does harm.
                let forgets = component.planned && (row.unbounded || troubled && row.is_condensed());
                if forgets || !settings.warm_starting {
                    row.lambda = 0.0;
                }
            }
            if !settings.warm_starting {
                self.balls.each(component.colors, &mut bodies.rows, Forget);
            }
            for &m in &self.members[component.members] {
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
            self.components[component].factored = false;
        }
        changed
    }

    /// Applies the impulses of the last sub-step again.
    pub fn warm_start(&mut self, batch: usize, rows: &mut Rows) {
        for c in self.batches[batch].clone() {
            self.note_velocities(c, rows);
            for placed in &self.joints[self.components[c].joints.clone()] {
                let mut pair = Pair::of(placed.body, rows);
                for row in &self.rows[placed.rows.clone()] {
                    pair.apply(row, row.lambda, rows);
                }
                pair.give_back(rows);
            }
            self.balls.each(self.components[c].colors.clone(), rows, WarmStart);
            self.note_momenta(c, rows);
        }
    }

    /// The first pass.
    pub fn solve(&mut self, batch: usize, bodies: &mut Bodies, joints: &JointStore, sub: &SubStep) {
        let lag = with_integrator!(sub.integrator, I => I::LAG * sub.h);
        let soft = soft(MESH[0] / sub.h, MESH[1], sub.h, PUSH_SPEED);
        for c in self.batches[batch].clone() {
            self.note_velocities(c, &bodies.rows);
            let Component { joints: places, planned, colors, .. } = self.components[c].clone();
            // With a plan the velocities are brought in order first, at the price of one more back-substitution: what
            // lies ahead is then nearly right, on light bodies, too.
            self.note_leads(c, &bodies.rows);
            if planned {
                for row in &mut self.rows[rows_of(&self.joints[places.clone()])] {
                    row.want(Pass::Guess, &bodies.rows, sub, &self.lead, lag);
                }
                let Component { factored, factor, .. } = self.components[c];
                let known = factored && self.factors[factor].is_exact();
                let of = if known { Of::SameRows } else { Of::Rows };
                self.impulses(c, &mut bodies.rows, of, Aim::Push);
            }
            // A load that comes at once, such as the first one, is borne at once.
            let heavier = planned && self.bear_loads(c, bodies, sub.h, 4.0);
            if heavier {
                self.note_leads(c, &bodies.rows);
            }
            with_integrator!(sub.integrator, I => self.look_ahead::<I>(c, bodies, sub.h));
            for place in places {
                let mut own = self.rows[self.joints[place].rows.clone()].iter_mut();
                let ahead = |row: u32| self.ahead[row as usize];
                let geometry = self.joints[place].geometry(ahead);
                draft(&self.joints, place, joints, &geometry, ahead, |draft| {
                    if let Some(row) = own.next() {
                        row.want(Pass::Solve { predicted: draft.c }, &bodies.rows, sub, &self.lead, lag);
                    }
                });
            }
            self.balls.each(
                colors.clone(),
                &mut bodies.rows,
                LookAhead { ahead: &self.ahead, rate: soft[0], sub },
            );
            let of = if heavier { Of::Rows } else { Of::LastCall };
            self.impulses(c, &mut bodies.rows, of, Aim::Bend);
            self.balls.each(colors, &mut bodies.rows, Solve { share: soft[1], leak: soft[2] });
            self.note_momenta(c, &mut bodies.rows);
        }
    }

    /// Once more what the last pass was after, where contacts have changed velocities since then.
    pub fn again(&mut self, batch: usize, rows: &mut Rows, aim: Aim) {
        for c in self.batches[batch].clone() {
            if self.components[c].touched {
                self.note_velocities(c, rows);
                self.impulses(c, rows, Of::LastCall, aim);
                self.note_momenta(c, rows);
            }
        }
    }

    /// The relax pass, after bodies were moved.
    pub fn relax(&mut self, batch: usize, bodies: &mut Bodies, joints: &JointStore, sub: &SubStep) {
        for c in self.batches[batch].clone() {
            self.note_velocities(c, &bodies.rows);
            let Component { joints: places, colors, .. } = self.components[c].clone();
            for place in places.clone() {
                self.begin_relax(place, bodies, joints, sub);
            }
            self.balls.each(colors.clone(), &mut bodies.rows, BeginRelax);
            self.impulses(c, &mut bodies.rows, Of::Rows, Aim::Rest);
            self.components[c].factored = self.components[c].rigid;
            self.balls.each(colors.clone(), &mut bodies.rows, Solve { share: 1.0, leak: 0.0 });
            self.balls.each(colors, &mut bodies.rows, End);
            for placed in &mut self.joints[places] {
                for row in &self.rows[placed.rows.clone()] {
                    row.add_after_move(&mut placed.total, &mut placed.total_angular, placed.arm_b);
                }
            }
            self.note_momenta(c, &mut bodies.rows);
        }
    }

    /// Rows of a joint at the new places, and whether pushing its error out has helped.
    fn begin_relax(&mut self, place: usize, bodies: &Bodies, joints: &JointStore, sub: &SubStep) {
        let moved = |row: u32| [bodies.rows.row[row as usize].0[2], bodies.rows.row[row as usize].0[3]];
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
        let geometry = Geometry { turns: placed.turns, ..geometry };
        let mut own = self.rows[placed.rows.clone()].iter_mut();
        let mut left = 0.0;
        draft(&self.joints, place, joints, &geometry, moved, |draft| {
            if let Some(row) = own.next() {
                row.place(draft, &bodies.rows);
                row.want(Pass::Relax, &bodies.rows, sub, &[], 0.0);
                left += row.error(sub).0;
            }
        });
        let placed = &mut self.joints[place];
        // Velocities can always be brought in order, places not: joints that contradict each other would be pushed for
        // ever. Where an error does not go, the push does; what contacts press on is no contradiction, and keeps some.
        let touched = placed.body.iter().any(|&b| b != 0 && bodies.rows.aux[b as usize].touched);
        placed.push = if asked > STUBBORN && error - left < 0.3 * asked {
            0.5 * placed.push
        } else {
            (1.5 * placed.push).min(1.0)
        };
        if touched {
            placed.push = placed.push.max(PRESSED_PUSH);
        }
        for row in &mut self.rows[placed.rows.clone()] {
            row.share = placed.push;
        }
    }

    /// Notes by how much the velocities of members are ahead of their mean motion, per time.
    fn note_leads(&mut self, component: usize, rows: &Rows) {
        for &m in &self.members[self.components[component].members.clone()] {
            let aux = &rows.aux[m as usize];
            self.lead[m as usize] = if aux.lags() {
                [aux.accel, rows.inertia[m as usize].times(aux.torque)]
            } else {
                [Vec3::zeros(); 2]
            };
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
                let change = inertia_times(aux, row.w() - aux.before[1]);
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
            self.ahead[m as usize] = [[dx.x, dx.y, dx.z, 0.0], [dq.i, dq.j, dq.k, dq.w]];
        }
    }

    /// The impulses of a pass over a component, ball joints aside.
    fn impulses(&mut self, component: usize, rows: &mut Rows, of: Of, aim: Aim) {
        let Component { joints, group, members, hard, bounded, factor, .. } =
            self.components[component].clone();
        let list = &self.joints[joints];
        if let Some(plan) = &self.groups.list[group].plan {
            let mut system = direct::System {
                plan,
                list,
                solver_rows: &mut self.rows,
                hard: &self.solved[hard],
                bounded: &self.solved[bounded],
                members: &self.members[members],
                rows,
                work: &mut self.direct,
                factor: &mut self.factors[factor],
            };
            self.components[component].damped |= system.impulses(of, aim);
            return;
        }
        for placed in list {
            for row in self.rows[placed.rows.clone()].iter_mut().filter(|r| !r.unbounded) {
                row.solve(rows);
            }
            row::solve_block(&mut self.rows[placed.rows.clone()], rows);
        }
    }

    /// Notes the velocities of members that have contacts, to tell afterwards what joints did.
    fn note_velocities(&mut self, component: usize, rows: &Rows) {
        self.before.clear();
        for &m in &self.members[self.components[component].members.clone()] {
            if rows.aux[m as usize].touched {
                let row = &rows.row[m as usize];
                self.before.push([row.v(), row.w()]);
            }
        }
    }

    /// Adds what joints have changed since then to what they gave each body.
    fn note_momenta(&mut self, component: usize, rows: &mut Rows) {
        let mut before = self.before.iter();
        for &m in &self.members[self.components[component].members.clone()] {
            let (row, aux) = (&rows.row[m as usize], &mut rows.aux[m as usize]);
            if !aux.touched {
                continue;
            }
            let &[v, w] = before.next().expect("one for each");
            aux.joint[0] += (row.v() - v) * aux.mass;
            let turn = row.w() - w;
            aux.joint[1] += if aux.spin { inertia_times(aux, turn) } else { turn };
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
        self.balls.store(joints, dt);
    }

    /// Multiplies the impulses that were stored for the joints of a batch, sums over the step aside.
    pub fn scale_stored(&self, batch: usize, joints: &mut JointStore, factor: Float) {
        for component in &self.components[self.batches[batch].clone()] {
            let group = &self.groups.list[component.group];
            for &index in group.joints.iter().chain(group.balls.iter().flatten()) {
                joints.joints[index as usize].impulse.iter_mut().for_each(|impulse| *impulse *= factor);
            }
        }
    }
}

/// Hands on the rows of a joint one by one, its frames being where `geometry` says. Its bodies and those of the joints that
/// a gear brings in step have moved and turned since the step began by what `moves` says.
fn draft(
    list: &[Placed],
    place: usize,
    joints: &JointStore,
    geometry: &Geometry,
    moves: impl Fn(u32) -> [Quad; 2] + Copy,
    mut take: impl FnMut(&JointRow),
) {
    let placed = &list[place];
    let joint = &joints.joints[placed.joint as usize];
    let mut take = |row: JointRow| take(&row);
    match &joint.kind {
        JointKind::Gear(gear) | JointKind::RackPinion(gear) => {
            let coordinates = [0, 1].map(|k| {
                let part = &list[placed.parts[k] as usize];
                let kind = &joints.joints[part.joint as usize].kind;
                let mut c = coordinate(kind, &part.geometry(moves))?;
                c.value -= crate::math::scalar::single(joint.start[k]);
                Some(c)
            });
            if let [Some(first), Some(second)] = &coordinates {
                gear.emit([first, second], &mut take);
            }
        }
        kind => kind.emit(geometry, &mut take),
    }
}

/// The rows of joints that follow each other.
fn rows_of(list: &[Placed]) -> Range<usize> {
    match list {
        [] => 0..0,
        [first, ..] => first.rows.start..list[list.len() - 1].rows.end,
    }
}

/// Stiffness of the joints of a mesh, as a share of the sub-step rate, and their damping ratio.
const MESH: [Float; 2] = [0.25, 2.0];

/// The least share of the push where contacts press: an error goes in some tens of sub-steps, without a jerk.
const PRESSED_PUSH: Float = 0.1;

/// Errors that a sub-step is to lessen by less than this \[m, rad\] are what is left of rounding and of motion.
const STUBBORN: Float = 1e-4;

impl Placed {
    /// Where the frames are when the bodies have moved and turned since the step began by what `moves` says.
    fn geometry(&self, moves: impl Fn(u32) -> [Quad; 2]) -> Geometry {
        let read = |row: u32| {
            let [[x, y, z, _], [i, j, k, w]] = moves(row);
            (Vec3::new(x, y, z), Quat::new_unchecked(nalgebra::Quaternion::new(w, i, j, k)))
        };
        let ((xa, ta), (xb, tb)) = (read(self.body[0]), read(self.body[1]));
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
