//! Contact points as rigid solvers see them: every point of every awake constraint with axes, arms, effective masses
//! and impulses, and what such solvers share around their velocity solve.
//!
//! A sub-step of a rigid solver is
//!   begin (gaps and targets) · forces · *velocities* · move · push out · close.
//!
//! Targets, with v the normal velocity when the sub-step begins, a the normal acceleration by forces, s the gap:
//! - at rest or apart: σ_n ≥ −max(s, 0)/h, so that a gap may close in the sub-step, but no further;
//! - an impact, where v < −threshold and the point lands in this sub-step: Newton's law. The surface is reached with
//!   u = √(v² − 2 a s) and left with e u; at the present height that is v⁺ = √(e² u² + 2 a s), so the energy lost
//!   does not depend on where in the sub-step it falls. The target is v⁺ + a h, as forces go on acting;
//! - tangents: what a conveyor asks for, else 0.
//!
//! Overlap is pushed out by velocities of their own that move bodies and are then forgotten: no momentum comes of it
//! \[split impulses; Guendelman et al. 2003 for the idea\].
//!
//! Legend: n t axes, r arm, σ relative velocity less target, λ impulse, μ friction, k inverse effective mass, h sub-step.

use super::bodies::{Bodies, center};
use super::contact_problem::{V, natural_error, worse};
use super::rows::Rows;
use super::{Settings, SubStep, joints};
use crate::body::store::without;
use crate::body::{BodyStore, NONE};
use crate::constraint::{ContactStore, JointStore, contact::flags};
use crate::integrate::turn_by;
use crate::island::IslandStore;
use crate::math::scalar::double;
use crate::math::{Float, Vec3, any_tangent, length, rotate};
use std::ops::Range;

/// Which share of an overlap is pushed out in a sub-step.
const PUSH_OUT_SHARE: Float = 0.2;

/// Which share of the gap of a point that carried load may close in a sub-step. Equal to the share of an overlap that is
/// pushed out: so the sign of a hair's breadth makes no difference to what rests.
const CLOSING_SHARE: Float = PUSH_OUT_SHARE;

/// Points that slide slower than this share of |g| h when the sub-step begins are held by static friction: one sub-step
/// of weight that was not yet answered in full is no sliding.
const STILL_SHARE: Float = 0.5;

/// The same without gravity \[m/s\].
const STILL: Float = 1e-3;

/// See soft_step: after a far shorter step impulses are not grown in full.
const GREATEST_GROWTH: Float = 8.0;

/// One contact point. Vectors are in world axes.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Index of the contact, and which of its points this is.
    pub source: (u32, u32),
    /// Solver rows of A and B.
    pub rows: [u32; 2],
    /// n from A to B, t₁, t₂.
    pub axes: [Vec3; 3],
    /// From the centres of mass to the point.
    pub arms: [Vec3; 2],
    /// Arms of the cores of rounded shapes, which turn while their touching points stay.
    cores: [Vec3; 2],
    /// Gap when the step began \[m\].
    separation: Float,
    /// Gap when the sub-step began \[m\].
    pub gap: Float,
    /// Least normal velocity, and tangential velocities wanted \[m/s\].
    pub target: [Float; 3],
    /// Whether the target is that of an impact.
    pub bounces: bool,
    /// Whether one side is immovable.
    pub on_static: bool,
    /// Static and sliding friction.
    pub friction: [Float; 2],
    /// Whether it stuck when the sub-step began.
    pub still: bool,
    restitution: Float,
    conveyor: [Float; 2],
    /// n·K n, and the block of the tangents: 11, 12, 22 \[1/kg\].
    pub k: [Float; 4],
    /// Impulses along the axes in this sub-step \[N s\].
    pub lambda: [Float; 3],
    /// Pushing impulse of this sub-step.
    pushed: Float,
    /// Sums over the sub-steps.
    total: [Float; 3],
}

/// All points of a step.
#[derive(Debug, Default)]
pub struct Points {
    /// By batch, island and shapes.
    pub points: Vec<Point>,
    /// The points of each awake island, by its place in [`Bodies::islands`].
    pub of_island: Vec<Range<usize>>,
    keys: Vec<(u32, u32)>,
    /// Pseudo-velocities by solver row.
    push: Vec<[Vec3; 2]>,
}

impl Points {
    #[expect(clippy::too_many_arguments, reason = "all that a step is laid out from")]
    /// Lays bodies, joints and points out. Impulses of the last step are taken over where they are wanted.
    pub fn lay_out(
        &mut self,
        rows: &mut Bodies,
        joint_rows: &mut joints::Workspace,
        bodies: &BodyStore,
        contacts: &ContactStore,
        joints: &JointStore,
        islands: &mut IslandStore,
        settings: &Settings,
    ) {
        for island in &rows.islands {
            if islands.islands[island.id as usize].changed {
                islands.measure(island.id, &bodies.bodies, &contacts.contacts, &joints.joints);
            }
        }
        rows.fill(bodies, islands, settings);
        self.keys.clear();
        for &c in &contacts.awake {
            let contact = &contacts.contacts[c as usize];
            if let Some(island) = rows.island_of(contact.body).filter(|_| contact.is(flags::CONSTRAINT)) {
                self.keys.push((rows.place_of(island), c));
            }
        }
        // Slots of contacts depend on what else is in the world, shapes' order does not.
        self.keys.sort_unstable_by_key(|&(place, c)| {
            let contact = &contacts.contacts[c as usize];
            (place, contact.shape)
        });
        self.points.clear();
        self.of_island.clear();
        joint_rows.begin(rows, bodies, joints);
        let mut at = 0;
        for batch in 0..rows.batches.len() {
            rows.open_batch(batch);
            joint_rows.lay_out_batch(batch, rows, bodies, joints, settings);
            for place in rows.batches[batch].islands.clone() {
                let first = self.points.len();
                while at < self.keys.len() && self.keys[at].0 as usize == place {
                    self.append(self.keys[at].1, batch, rows, bodies, contacts, settings);
                    at += 1;
                }
                self.of_island.push(first..self.points.len());
            }
        }
        debug_assert_eq!(at, self.keys.len());
        joint_rows.end(rows);
        for p in &self.points {
            for row in p.rows {
                let aux = &mut rows.rows.aux[row as usize];
                aux.touched = true;
                aux.supported |= p.lambda[0] > 0.0;
            }
        }
        self.push.clear();
        self.push.resize(rows.rows.row.len(), [Vec3::zeros(); 2]);
    }

    fn append(
        &mut self,
        index: u32,
        batch: usize,
        rows: &mut Bodies,
        bodies: &BodyStore,
        contacts: &ContactStore,
        settings: &Settings,
    ) {
        let contact = &contacts.contacts[index as usize];
        let sides = contact.body.map(|b| rows.row_for(bodies, b, batch, settings));
        let offset = center(bodies, contact.body[0]) - center(bodies, contact.body[1]);
        let n = contact.normal;
        let t = any_tangent(n);
        let axes = [n, t, n.cross(&t)];
        let scale = match (settings.warm_starting, settings.last_h > 0.0) {
            (false, _) => 0.0,
            (true, false) => 1.0,
            (true, true) => (settings.h() / settings.last_h).min(GREATEST_GROWTH),
        };
        for (k, point) in contact.points().iter().enumerate() {
            let arms = [point.anchor, point.anchor + offset];
            let friction = point.friction * scale;
            self.points.push(Point {
                source: (index, k as u32),
                rows: sides,
                axes,
                arms,
                cores: [arms[0] - n * contact.rounding[0], arms[1] + n * contact.rounding[1]],
                separation: point.separation,
                gap: point.separation,
                target: [0.0; 3],
                bounces: false,
                on_static: contact.body.iter().any(|&b| bodies.bodies[b as usize].island == NONE),
                friction: [contact.static_friction.max(contact.friction), contact.friction],
                still: true,
                restitution: contact.restitution,
                conveyor: [contact.conveyor.dot(&axes[1]), contact.conveyor.dot(&axes[2])],
                k: inverse_masses(&rows.rows, sides, &axes, &arms),
                lambda: [point.impulse * scale, friction.dot(&axes[1]), friction.dot(&axes[2])],
                pushed: 0.0,
                total: [0.0; 3],
            });
        }
    }

    /// The points of a batch.
    pub fn range(&self, rows: &Bodies, batch: usize) -> Range<usize> {
        let places = rows.batches[batch].islands.clone();
        if places.is_empty() {
            0..0
        } else {
            self.of_island[places.start].start..self.of_island[places.end - 1].end
        }
    }

    /// Gaps and targets, before forces act.
    pub fn begin(&mut self, rows: &Bodies, batch: usize, sub: &SubStep, settings: &Settings) {
        let range = self.range(rows, batch);
        let still = STILL.max(STILL_SHARE * length(settings.gravity) * sub.h);
        for p in &mut self.points[range] {
            let [a, b] = p.rows.map(|r| r as usize);
            let (row_a, row_b) = (&rows.rows.row[a], &rows.rows.row[b]);
            let moved_a = row_a.dx() + rotate(&row_a.dq(), p.cores[0]) - p.cores[0];
            let moved_b = row_b.dx() + rotate(&row_b.dq(), p.cores[1]) - p.cores[1];
            p.gap = p.separation + p.axes[0].dot(&(moved_b - moved_a));
            let v = relative(&rows.rows, p);
            let slip = [v.dot(&p.axes[1]) + p.conveyor[0], v.dot(&p.axes[2]) + p.conveyor[1]];
            p.still = slip[0] * slip[0] + slip[1] * slip[1] <= still * still;
            // A loaded point closes gently: a full stop in one sub-step would rock what stands on it.
            let share = if p.lambda[0] > 0.0 { CLOSING_SHARE } else { 1.0 };
            p.target = [-p.gap.max(0.0) * share * sub.inv_h, -p.conveyor[0], -p.conveyor[1]];
            let free = |i: usize| {
                if rows.rows.aux[i].supported { Vec3::zeros() } else { rows.rows.aux[i].accel }
            };
            let a_n = p.axes[0].dot(&(free(b) - free(a)));
            let bounce = reflect(p.gap, v.dot(&p.axes[0]), a_n, p.restitution, sub);
            p.bounces = bounce.is_some();
            if let Some(target) = bounce {
                p.target[0] = target;
            }
        }
    }

    /// Gives bodies the impulses that points have, if they are to be kept, but for impacts, which begin from nothing.
    pub fn warm_start(&mut self, rows: &mut Bodies, range: Range<usize>, keep: bool) {
        for p in &mut self.points[range] {
            if p.bounces || !keep {
                p.lambda = [0.0; 3];
            } else {
                apply(&mut rows.rows, p, impulse(p, p.lambda));
            }
        }
    }

    /// One sweep of projected Gauss–Seidel: for each point its normal, then its friction within the disc.
    pub fn sweep(&mut self, rows: &mut Bodies, range: Range<usize>) {
        for p in &mut self.points[range] {
            let [kn, k11, k12, k22] = p.k;
            if kn > 0.0 {
                let v = relative(&rows.rows, p).dot(&p.axes[0]);
                let new = (p.lambda[0] - (v - p.target[0]) / kn).max(0.0);
                let change = new - p.lambda[0];
                p.lambda[0] = new;
                apply(&mut rows.rows, p, p.axes[0] * change);
            }
            if k11 + k22 > 0.0 && p.friction[0] > 0.0 {
                let v = relative(&rows.rows, p);
                let slip = [v.dot(&p.axes[1]) - p.target[1], v.dot(&p.axes[2]) - p.target[2]];
                let old = [p.lambda[1], p.lambda[2]];
                let new = friction_step(old, slip, [k11, k12, k22], p.coefficient() * p.lambda[0]);
                (p.lambda[1], p.lambda[2]) = (new[0], new[1]);
                apply(&mut rows.rows, p, p.axes[1] * (new[0] - old[0]) + p.axes[2] * (new[1] - old[1]));
            }
        }
    }

    /// The greatest natural-map error of the points \[m/s\]: see [`super::contact_problem`].
    pub fn residual(&self, rows: &Bodies, range: Range<usize>) -> Float {
        let mut worst = 0.0;
        for p in &self.points[range] {
            let v = relative(&rows.rows, p);
            let sigma = V::from_fn(|i, _| double(v.dot(&p.axes[i]) - p.target[i]));
            let lambda = V::from_fn(|i, _| double(p.lambda[i]));
            let mobility = double(p.k[0].max(p.k[1]).max(p.k[3]));
            worst = worse(worst, natural_error(&sigma, &lambda, double(p.coefficient()), mobility, true));
        }
        crate::math::scalar::single(worst)
    }

    /// Moves overlapping bodies apart, `sweeps` times over the points, by velocities that are forgotten afterwards.
    pub fn push_out(
        &mut self,
        rows: &mut Bodies,
        bodies: &BodyStore,
        batch: usize,
        sweeps: u32,
        sub: &SubStep,
        settings: &Settings,
    ) {
        let range = self.range(rows, batch);
        // What a body falls in a sub-step may stay: pushing that out, too, would rock what stands.
        let slop = 0.5 * length(settings.gravity) * sub.h * sub.h;
        let speed = |p: &Point| {
            let most =
                if p.on_static { settings.push_out_on_static } else { settings.push_out_between_moving };
            ((-p.gap - slop) * PUSH_OUT_SHARE * sub.inv_h).clamp(0.0, most)
        };
        if !self.points[range.clone()].iter().any(|p| speed(p) > 0.0) {
            return;
        }
        for p in &mut self.points[range.clone()] {
            p.pushed = 0.0;
        }
        for _ in 0..sweeps {
            for p in &mut self.points[range.clone()] {
                let [a, b] = p.rows.map(|r| r as usize);
                // A gap may close by as much as the velocities left of it; they were not asked to leave any.
                let least = speed(p);
                let at = |i: usize, side: usize| self.push[i][0] + self.push[i][1].cross(&p.arms[side]);
                let v = p.axes[0].dot(&(at(b, 1) - at(a, 0)));
                if p.k[0] <= 0.0 {
                    continue;
                }
                let new = (p.pushed - (v - least) / p.k[0]).max(0.0);
                let change = p.axes[0] * (new - p.pushed);
                p.pushed = new;
                for (side, i, sign) in [(0, a, -1.0), (1, b, 1.0)] {
                    if i != 0 {
                        let turn = rows.rows.inertia[i].times(p.arms[side].cross(&change));
                        self.push[i][0] += change * (sign * rows.rows.row[i].inv_mass());
                        self.push[i][1] += turn * sign;
                    }
                }
            }
        }
        self.nudge(rows, bodies, batch, sub);
    }

    /// Moves bodies by the pseudo-velocities and clears them.
    fn nudge(&mut self, rows: &mut Bodies, bodies: &BodyStore, batch: usize, sub: &SubStep) {
        let h = sub.h;
        for i in rows.batches[batch].rows.clone() {
            let [mut v, mut w] = self.push[i];
            let (row, aux) = (&mut rows.rows.row[i], &mut rows.rows.aux[i]);
            if aux.locked {
                let locks = &bodies.awake().drive[aux.awake_row as usize].locks;
                v = without(v, locks.linear);
                w = without(w, locks.angular);
                self.push[i] = [v, w];
            }
            row.set_dx(row.dx() + v * h);
            if w != Vec3::zeros() {
                if aux.spin {
                    aux.q[0] = turn_by(&aux.q[0], w * h);
                    row.set_dq(&(aux.q[0] * aux.q[1].conjugate()));
                } else {
                    row.set_dq(&turn_by(&row.dq(), w * h));
                }
            }
        }
        // A body that is moved by Δx takes its momentum elsewhere: what isolated islands gain by that is given back.
        for range in rows.isolated[rows.batches[batch].isolated.clone()].iter().cloned() {
            let (mut mass, mut p) = (0.0, Vec3::zeros());
            for i in range.clone() {
                mass += rows.rows.aux[i].mass;
                p += rows.rows.row[i].v() * rows.rows.aux[i].mass;
            }
            let mean = if mass > 0.0 { p / mass } else { Vec3::zeros() };
            for i in range {
                let shift = self.push[i][0] * h;
                if shift != Vec3::zeros() {
                    let (row, aux) = (&mut rows.rows.row[i], &mut rows.rows.aux[i]);
                    let lost = shift.cross(&((row.v() - mean) * aux.mass));
                    row.set_w(row.w() - rows.rows.inertia[i].times(lost));
                    if aux.spin {
                        aux.l -= lost;
                        aux.middle[1] = row.w();
                    }
                }
            }
        }
        for i in rows.batches[batch].rows.clone() {
            self.push[i] = [Vec3::zeros(); 2];
        }
        for i in rows.batches[batch].kinematic.clone() {
            self.push[i] = [Vec3::zeros(); 2];
        }
    }

    /// Adds the sub-step's impulses to the sums.
    pub fn close(&mut self, range: Range<usize>) {
        for p in &mut self.points[range] {
            for i in 0..3 {
                p.total[i] += p.lambda[i];
            }
            if p.bounces {
                // An impact happens once.
                p.lambda = [0.0; 3];
            }
        }
    }

    /// Writes impulses to the contacts.
    pub fn store(&self, contacts: &mut ContactStore) {
        for p in &self.points {
            let contact = &mut contacts.contacts[p.source.0 as usize];
            if p.source.1 == 0 {
                contact.friction_impulse = Vec3::zeros();
                contact.total_friction = Vec3::zeros();
                contact.twist_impulse = 0.0;
                contact.rolling_impulse = Vec3::zeros();
            }
            let point = &mut contact.points[p.source.1 as usize];
            (point.impulse, point.memory, point.total) = (p.lambda[0], p.lambda[0], p.total[0]);
            point.friction = p.axes[1] * p.lambda[1] + p.axes[2] * p.lambda[2];
            contact.friction_impulse += point.friction;
            contact.total_friction += p.axes[1] * p.total[1] + p.axes[2] * p.total[2];
        }
    }

    /// Bytes held.
    #[must_use]
    pub fn byte_count(&self) -> usize {
        self.points.capacity() * size_of::<Point>()
            + self.of_island.capacity() * size_of::<Range<usize>>()
            + self.keys.capacity() * 8
            + self.push.capacity() * size_of::<[Vec3; 2]>()
    }
}

impl Point {
    /// The friction coefficient that holds now: static for a point that stuck when the sub-step began.
    #[must_use]
    pub fn coefficient(&self) -> Float {
        self.friction[usize::from(!self.still)]
    }
}

/// Velocity of B against A at a point.
#[inline(always)]
#[must_use]
pub fn relative(rows: &Rows, p: &Point) -> Vec3 {
    let (a, b) = (&rows.row[p.rows[0] as usize], &rows.row[p.rows[1] as usize]);
    b.v() + b.w().cross(&p.arms[1]) - a.v() - a.w().cross(&p.arms[0])
}

/// Gives B an impulse at a point, A the opposite.
#[inline(always)]
pub fn apply(rows: &mut Rows, p: &Point, impulse: Vec3) {
    for (side, sign) in [(0, -1.0), (1, 1.0)] {
        let i = p.rows[side] as usize;
        if i != 0 {
            let turn = rows.inertia[i].times(p.arms[side].cross(&impulse));
            let row = &mut rows.row[i];
            row.set_v(row.v() + impulse * (sign * row.inv_mass()));
            row.set_w(row.w() + turn * sign);
        }
    }
}

/// The impulse with these parts along the axes.
#[inline(always)]
#[must_use]
pub fn impulse(p: &Point, lambda: [Float; 3]) -> Vec3 {
    p.axes[0] * lambda[0] + p.axes[1] * lambda[1] + p.axes[2] * lambda[2]
}

/// n·K n, t₁·K t₁, t₁·K t₂, t₂·K t₂ of a point.
fn inverse_masses(rows: &Rows, sides: [u32; 2], axes: &[Vec3; 3], arms: &[Vec3; 2]) -> [Float; 4] {
    let k = |u: &Vec3, v: &Vec3| -> Float {
        (0..2)
            .map(|side| {
                let i = sides[side] as usize;
                let (ru, rv) = (arms[side].cross(u), arms[side].cross(v));
                rows.row[i].inv_mass() * u.dot(v) + ru.dot(&rows.inertia[i].times(rv))
            })
            .sum()
    };
    [k(&axes[0], &axes[0]), k(&axes[1], &axes[1]), k(&axes[1], &axes[2]), k(&axes[2], &axes[2])]
}

/// The velocity to leave with, where an impact falls into the sub-step: see the module.
fn reflect(gap: Float, v: Float, accel: Float, restitution: Float, sub: &SubStep) -> Option<Float> {
    let lands = gap + (v + accel * sub.h) * sub.h < 0.0;
    if restitution <= 0.0 || v >= -sub.restitution_threshold || !lands {
        return None;
    }
    let s = gap.max(0.0);
    let arrives = v * v - 2.0 * accel * s;
    let leaves = restitution * restitution * arrives + 2.0 * accel * s;
    let target = leaves.max(0.0).sqrt() + accel * sub.h;
    // Slower than the next sub-step's fall: that is rest.
    if leaves > 0.0 && target > 0.0 { Some(target) } else { None }
}

/// New friction from the present one, the slip, the block (11, 12, 22) and the greatest length: by the inverse of the
/// block where the limit allows it, else a step against the slip cut to the limit.
#[inline]
fn friction_step(l: [Float; 2], s: [Float; 2], [k11, k12, k22]: [Float; 3], limit: Float) -> [Float; 2] {
    let det = k11 * k22 - k12 * k12;
    if det > 1e-6 * k11 * k22 {
        let t = [l[0] - (k22 * s[0] - k12 * s[1]) / det, l[1] - (k11 * s[1] - k12 * s[0]) / det];
        if t[0] * t[0] + t[1] * t[1] <= limit * limit {
            return t;
        }
    }
    let half = 0.5 * (k11 - k22);
    let greatest = 0.5 * (k11 + k22) + (half * half + k12 * k12).sqrt();
    let t = [l[0] - s[0] / greatest, l[1] - s[1] / greatest];
    let length = (t[0] * t[0] + t[1] * t[1]).sqrt();
    let cut = if length > limit { limit / length } else { 1.0 };
    [t[0] * cut, t[1] * cut]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sub(h: Float) -> SubStep {
        SubStep { h, inv_h: 1.0 / h, ..SubStep::default() }
    }

    #[test]
    fn an_impact_loses_the_same_share_of_energy_wherever_in_the_sub_step_it_falls() {
        let (h, g, e) = (1.0 / 120.0, 10.0, 0.7);
        for phase in 0..40 {
            let gap = 4.0 * h * (phase as Float + 0.5) / 40.0;
            let target = reflect(gap, -4.0, -g, e, &sub(h)).expect("it lands");
            // Speed when the sub-step begins, at the height of the gap.
            let v = target + g * h;
            let energy = 0.5 * v * v + g * gap;
            let expected = e * e * (0.5 * 16.0 + g * gap);
            assert!((energy / expected - 1.0).abs() < 1e-5, "{energy} instead of {expected}");
        }
    }

    #[test]
    fn what_parts_flies_on_or_is_too_slow_does_not_bounce() {
        let h = 1.0 / 120.0;
        assert!(reflect(0.0, 0.1, -10.0, 0.8, &sub(h)).is_none(), "parting");
        assert!(reflect(1.0, -4.0, -10.0, 0.8, &sub(h)).is_none(), "too far away");
        assert!(reflect(0.0, -0.01, -10.0, 0.8, &sub(h)).is_none(), "would land again at once");
        let threshold = SubStep { restitution_threshold: 1.0, ..sub(h) };
        assert!(reflect(0.0, -0.9, -10.0, 0.8, &threshold).is_none(), "slower than the threshold");
        assert!(reflect(0.0, -1.1, -10.0, 0.8, &threshold).is_some());
    }

    #[test]
    fn friction_sticks_up_to_its_limit_and_slides_at_it() {
        let k = [2.0, 0.5, 1.0];
        let stuck = friction_step([0.0; 2], [0.2, -0.1], k, 1.0);
        assert!((2.0 * stuck[0] + 0.5 * stuck[1] + 0.2).abs() < 1e-6, "velocity 1 is not 0");
        assert!((0.5 * stuck[0] + stuck[1] - 0.1).abs() < 1e-6, "velocity 2 is not 0");
        let slid = friction_step([0.0; 2], [20.0, -10.0], k, 0.5);
        assert!(((slid[0] * slid[0] + slid[1] * slid[1]).sqrt() - 0.5).abs() < 1e-6);
        assert!(slid[0] * -10.0 - slid[1] * 20.0 == 0.0 && slid[0] < 0.0, "straight against the slip");
    }
}
