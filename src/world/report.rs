//! What can be measured of a world: report, profile, counters, hash.

use super::World;
use crate::body::{NONE, SetId};
use crate::constraint::contact::flags;
use crate::math::{Float, Quat, Vec3, scalar::double};
use crate::solver::SolveReport;

/// Milliseconds of the last step, by stage. Differs from run to run and is no part of the state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Profile {
    /// The whole step.
    pub step: f32,
    /// Boxes.
    pub update_bounds: f32,
    /// Broad phase.
    pub find_pairs: f32,
    /// Narrow phase.
    pub update_contacts: f32,
    /// Islands and colours.
    pub build_islands: f32,
    /// Rehearsals, where an accuracy is to be kept.
    pub rehearse: f32,
    /// Layout of the constraints.
    pub prepare: f32,
    /// Sub-steps.
    pub solve: f32,
    /// Poses.
    pub advance: f32,
    /// Sleep.
    pub update_sleep: f32,
    /// Events.
    pub publish_events: f32,
}

/// How much there is of everything.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Bodies of all types.
    pub bodies: usize,
    /// Awake bodies, kinematic ones included.
    pub awake_bodies: usize,
    /// Shapes.
    pub shapes: usize,
    /// Joints.
    pub joints: usize,
    /// Pairs of shapes whose boxes meet.
    pub contacts: usize,
    /// Contacts that were constraints in the last step.
    pub constraints: usize,
    /// Constraints that found no colour.
    pub overflow: usize,
    /// Islands that are awake.
    pub islands: usize,
    /// Longest way through the broad phase's trees.
    pub tree_height: usize,
    /// Memory held, names and the allocator's own aside \[bytes\].
    pub bytes: usize,
}

/// What the world counts over its life.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Counts {
    pub steps: u64,
    pub quarantined: u64,
}

/// Conserved quantities and errors of the present state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepReport {
    /// Of translation and rotation, dynamic bodies \[J\].
    pub kinetic_energy: f64,
    /// −Σ m g·x, zero at the world origin, dynamic bodies \[J\].
    pub potential_energy: f64,
    /// \[kg m/s\]
    pub linear_momentum: [f64; 3],
    /// About the world origin \[kg m²/s\].
    pub angular_momentum: [f64; 3],
    /// Deepest overlap of any contact, at the present poses \[m\]; 0 for none.
    pub worst_penetration: Float,
    /// Greatest error of what rigid joints hold, at the present poses: of lengths \[m\].
    pub joint_gap: Float,
    /// The same of angles \[rad\].
    pub joint_angle_gap: Float,
    /// Greatest normal approach speed left at a loaded contact point \[m/s\].
    pub residual: Float,
    /// Sub-steps of the last step, as it was asked for.
    pub sub_steps: u32,
    /// The most sub-steps that an island had in the last step: more than that only with an accuracy to keep.
    pub most_sub_steps: u32,
    /// The greatest error that rehearsals of awake islands found last: what a step adds to the motion, as a share of the
    /// way gone in it. 0 without an accuracy.
    pub error: Float,
    /// Steps so far.
    pub steps: u64,
    /// How the solver fared in the last step.
    pub solve: SolveReport,
    /// Bodies put to rest because their state stopped being finite.
    pub quarantined: u64,
    /// How much there is of everything.
    pub counters: Counters,
    /// Milliseconds by stage.
    pub profile: Profile,
}

impl World {
    /// Milliseconds of the last step.
    #[must_use]
    pub fn profile(&self) -> Profile {
        self.profile
    }

    /// How much there is of everything.
    #[must_use]
    pub fn counters(&self) -> Counters {
        Counters {
            bodies: self.identity.bodies.live(),
            awake_bodies: self.bodies.awake().len(),
            shapes: self.identity.shapes.live(),
            joints: self.identity.joints.live(),
            contacts: self.identity.contacts.live(),
            constraints: self.work.bodies.constraints,
            overflow: self.work.soft_step.overflow,
            islands: self.work.bodies.islands.len(),
            tree_height: self.broad_phase.stats().height,
            bytes: self.byte_count(),
        }
    }

    /// Memory held, names and the allocator's own aside \[bytes\].
    #[must_use]
    pub fn byte_count(&self) -> usize {
        size_of::<World>()
            + self.bodies.byte_count()
            + self.colliders.capacity() * size_of::<super::Collider>()
            + self.broad_phase.byte_count()
            + self.pairs.byte_count()
            + self.contacts.byte_count()
            + self.joints.byte_count()
            + self.islands.byte_count()
            + self.coloring.byte_count()
            + self.events.byte_count()
            + self.work.byte_count()
            + self.rehearsal.byte_count()
            + self.identity.bodies.byte_count()
            + self.identity.shapes.byte_count()
            + self.identity.contacts.byte_count()
            + self.scratch.pairs.capacity() * 8
            + self.scratch.sides.byte_count()
    }

    /// Measures the present state. Costs a narrow phase: it is meant for tests, plots and tuning.
    #[must_use]
    pub fn step_report(&self) -> StepReport {
        let (mut kinetic, mut potential) = (0.0, 0.0);
        let (mut p, mut l) = ([0.0; 3], [0.0; 3]);
        let wide = |v: Vec3| [double(v.x), double(v.y), double(v.z)];
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        for (k, set) in self.bodies.sets.iter().enumerate() {
            if k < SetId::AWAKE.0 as usize {
                continue;
            }
            for row in 0..set.len() {
                let mass = &set.mass[row];
                if mass.inv_mass == 0.0 {
                    continue;
                }
                let motion = &set.motion[row];
                let (x, pb, lb) = (wide(motion.x), wide(motion.p), wide(motion.l));
                let m = double(mass.mass);
                kinetic += 0.5 * (dot(pb, pb) / m + dot(lb, wide(set.angular_velocity(row))));
                potential -= m * double(set.drive[row].gravity_scale) * dot(wide(self.def.gravity), x);
                for i in 0..3 {
                    p[i] += pb[i];
                    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                    l[i] += lb[i] + x[j] * pb[k] - x[k] * pb[j];
                }
            }
        }
        let (worst_penetration, residual) = self.contact_errors();
        let (joint_gap, joint_angle_gap) = self.joint_gap();
        let (most_sub_steps, error) = self.pace();
        StepReport {
            kinetic_energy: kinetic,
            potential_energy: potential,
            linear_momentum: p,
            angular_momentum: l,
            worst_penetration,
            joint_gap,
            joint_angle_gap,
            residual,
            sub_steps: self.last_sub_steps,
            most_sub_steps,
            error,
            steps: self.counts.steps,
            solve: SolveReport { solver: self.def.solver.resolved(), ..self.work.report },
            quarantined: self.counts.quarantined,
            counters: self.counters(),
            profile: self.profile,
        }
    }

    /// Deepest overlap at the present poses, and the greatest approach speed at a loaded point.
    fn contact_errors(&self) -> (Float, Float) {
        let (mut deepest, mut residual): (Float, Float) = (0.0, 0.0);
        for index in self.live_contacts() {
            let contact = &self.contacts.contacts[index];
            if !contact.is(flags::CONSTRAINT) {
                continue;
            }
            deepest = deepest.max(self.overlap_now(contact));
            for p in contact.points() {
                if p.impulse > 0.0 {
                    let v = |side: usize| {
                        let body = contact.body[side] as usize;
                        let (set, row) = self.bodies.at(body);
                        if self.bodies.bodies[body].set == SetId::STATIC {
                            return Vec3::zeros();
                        }
                        let arm = if side == 0 {
                            p.anchor
                        } else {
                            let (set_a, row_a) = self.bodies.at(contact.body[0] as usize);
                            p.anchor + set_a.motion[row_a].x - set.motion[row].x
                        };
                        set.velocity(row) + set.angular_velocity(row).cross(&arm)
                    };
                    residual = residual.max(-contact.normal.dot(&(v(1) - v(0))));
                }
            }
        }
        (deepest, residual)
    }

    pub(crate) fn live_contacts(&self) -> impl Iterator<Item = usize> + '_ {
        let pool = &self.identity.contacts;
        (0..pool.slots()).filter(|&i| pool.is_live(i, pool.generation(i)))
    }

    /// A hash of the state of all bodies in order of their slots (poses, momenta, whether they sleep) and of the
    /// impulses of all contacts. Equal states have equal hashes, on every platform, at every width.
    #[must_use]
    pub fn state_hash(&self) -> u64 {
        let mut hash = Hash::default();
        let pool = &self.identity.bodies;
        for index in (0..pool.slots()).filter(|&i| pool.is_live(i, pool.generation(i))) {
            let body = &self.bodies.bodies[index];
            let (set, row) = self.bodies.at(index);
            let m = &set.motion[row];
            hash.word(index as u64);
            hash.vec(m.x);
            hash.vec(m.x_rest);
            hash.quat(&m.q);
            hash.vec(m.p);
            hash.vec(m.l);
            hash.scalar(set.slow_time[row]);
            hash.word(u64::from(body.set.is_sleeping()) | u64::from(body.set == SetId::DISABLED) << 1);
            if self.def.accuracy > 0.0 && body.island != NONE {
                hash.word(self.islands.islands[body.island as usize].pacing.level as u64);
            }
        }
        for index in self.live_contacts() {
            let contact = &self.contacts.contacts[index];
            hash.word(u64::from(contact.shape[0]) << 32 | u64::from(contact.shape[1]));
            for p in contact.points() {
                hash.scalar(p.impulse);
                hash.scalar(p.memory);
                if p.friction != Vec3::zeros() {
                    hash.vec(p.friction);
                }
            }
            hash.vec(contact.friction_impulse);
            hash.scalar(contact.twist_impulse);
            hash.vec(contact.rolling_impulse);
        }
        for &j in &self.joints.live {
            let joint = &self.joints.joints[j as usize];
            hash.word(u64::from(j));
            joint.impulse.iter().for_each(|&p| hash.scalar(p));
        }
        hash.0
    }
}

/// FNV-1a over 64-bit words with a final mix: simple, stable, good enough to tell states apart.
struct Hash(u64);

impl Default for Hash {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Hash {
    fn word(&mut self, w: u64) {
        self.0 = (self.0 ^ w).wrapping_mul(0x0000_0100_0000_01b3);
        self.0 ^= self.0 >> 29;
    }

    #[cfg_attr(feature = "f64", allow(clippy::useless_conversion))]
    fn scalar(&mut self, x: Float) {
        // −0 and 0 are the same state.
        self.word(u64::from((x + 0.0).to_bits()));
    }

    fn vec(&mut self, v: Vec3) {
        self.scalar(v.x);
        self.scalar(v.y);
        self.scalar(v.z);
    }

    fn quat(&mut self, q: &Quat) {
        self.scalar(q.w);
        self.scalar(q.i);
        self.scalar(q.j);
        self.scalar(q.k);
    }
}
