//! Where bodies live: one packed set each for static, disabled and awake bodies and one per sleeping island.

use super::{Body, Drive, MassProps, Motion, NONE};
use crate::math::{Float, Mat3, Pose, Vec3};
use crate::world::{BodyDef, BodyType, MotionLocks};

/// A set of bodies: [`SetId::STATIC`], [`SetId::DISABLED`], [`SetId::AWAKE`], or a sleeping island's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SetId(pub u32);

impl SetId {
    /// Bodies that never move.
    pub const STATIC: SetId = SetId(0);
    /// Bodies that take no part.
    pub const DISABLED: SetId = SetId(1);
    /// Bodies that a step moves.
    pub const AWAKE: SetId = SetId(2);

    /// Whether this is a sleeping island's set.
    #[must_use]
    pub fn is_sleeping(self) -> bool {
        self.0 > 2
    }
}

/// Packed rows of bodies, a column for each group of data that is used together.
#[derive(Clone, Debug, Default)]
pub struct BodySet {
    /// The stable index of each row's body.
    pub index: Vec<u32>,
    /// State.
    pub motion: Vec<Motion>,
    /// Mass properties.
    pub mass: Vec<MassProps>,
    /// I_w⁻¹ at the current rotation.
    pub inv_inertia: Vec<Mat3>,
    /// Forces, damping, locks.
    pub drive: Vec<Drive>,
    /// How long the body has been slow \[s\].
    pub slow_time: Vec<Float>,
}

impl BodySet {
    /// How many rows there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.index.len()
    }

    /// Whether there is no row.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.index.is_empty()
    }

    fn push_row_of(&mut self, other: &BodySet, row: usize) {
        self.index.push(other.index[row]);
        self.motion.push(other.motion[row]);
        self.mass.push(other.mass[row]);
        self.inv_inertia.push(other.inv_inertia[row]);
        self.drive.push(other.drive[row]);
        self.slow_time.push(other.slow_time[row]);
    }

    fn swap_remove(&mut self, row: usize) {
        self.index.swap_remove(row);
        self.motion.swap_remove(row);
        self.mass.swap_remove(row);
        self.inv_inertia.swap_remove(row);
        self.drive.swap_remove(row);
        self.slow_time.swap_remove(row);
    }

    /// The velocity of the centre of mass \[m/s\].
    #[inline(always)]
    #[must_use]
    pub fn velocity(&self, row: usize) -> Vec3 {
        let m = &self.mass[row];
        if m.inv_mass > 0.0 { self.motion[row].p * m.inv_mass } else { self.motion[row].p }
    }

    /// The angular velocity, world axes \[rad/s\].
    #[inline(always)]
    #[must_use]
    pub fn angular_velocity(&self, row: usize) -> Vec3 {
        if self.mass[row].turns() { self.inv_inertia[row] * self.motion[row].l } else { self.motion[row].l }
    }

    /// Sets the velocity of the centre of mass; locked directions stay 0.
    pub fn set_velocity(&mut self, row: usize, v: Vec3) {
        let v = without(v, self.drive[row].locks.linear);
        let m = self.mass[row].mass;
        self.motion[row].p = if m > 0.0 { v * m } else { v };
    }

    /// Sets the angular velocity; locked directions stay 0.
    pub fn set_angular_velocity(&mut self, row: usize, w: Vec3) {
        let w = without(w, self.drive[row].locks.angular);
        let m = &self.mass[row];
        let q = self.motion[row].q;
        self.motion[row].l = if m.turns() { m.inertia_times(&q, w) } else { w };
    }

    /// Recomputes I_w⁻¹ from the rotation.
    #[inline]
    pub fn refresh_inertia(&mut self, row: usize) {
        self.inv_inertia[row] = self.mass[row].world_inv_inertia(&self.motion[row].q, &self.drive[row].locks);
    }

    /// The placement of the body's origin.
    #[inline(always)]
    #[must_use]
    pub fn origin(&self, row: usize) -> Pose {
        super::origin_pose(&self.motion[row], self.mass[row].center)
    }

    fn byte_count(&self) -> usize {
        self.index.capacity() * 4
            + self.motion.capacity() * size_of::<Motion>()
            + self.mass.capacity() * size_of::<MassProps>()
            + self.inv_inertia.capacity() * size_of::<Mat3>()
            + self.drive.capacity() * size_of::<Drive>()
            + self.slow_time.capacity() * size_of::<Float>()
    }
}

/// `v` with the locked components 0.
#[inline]
#[must_use]
pub fn without(v: Vec3, locked: [bool; 3]) -> Vec3 {
    let keep = |k: usize| if locked[k] { 0.0 } else { v[k] };
    Vec3::new(keep(0), keep(1), keep(2))
}

/// All bodies of a world.
#[derive(Clone, Debug)]
pub struct BodyStore {
    /// By stable index; rows of destroyed bodies are left as they are until the index is used again.
    pub bodies: Vec<Body>,
    /// By [`SetId`]; sets of islands that woke up are empty and used again.
    pub sets: Vec<BodySet>,
    free_sets: Vec<u32>,
}

impl Default for BodyStore {
    fn default() -> Self {
        Self { bodies: Vec::new(), sets: vec![BodySet::default(); 3], free_sets: Vec::new() }
    }
}

impl BodyStore {
    /// Adds a body with the stable index `index`, without shapes or mass.
    pub fn add(&mut self, index: usize, def: &BodyDef, rotation: crate::math::Quat) {
        let kinematic = def.body_type == BodyType::Kinematic;
        let locks =
            if def.body_type == BodyType::Dynamic { def.motion_locks } else { MotionLocks::default() };
        let set = match def.body_type {
            _ if !def.is_enabled => SetId::DISABLED,
            BodyType::Static => SetId::STATIC,
            _ => SetId::AWAKE,
        };
        let still = def.body_type == BodyType::Static;
        let rows = &mut self.sets[set.0 as usize];
        let row = rows.len();
        rows.index.push(index as u32);
        rows.motion.push(Motion {
            x: def.position,
            x_rest: Vec3::zeros(),
            q: rotation,
            p: if still { Vec3::zeros() } else { without(def.linear_velocity, locks.linear) },
            l: if still { Vec3::zeros() } else { without(def.angular_velocity, locks.angular) },
        });
        rows.mass.push(MassProps::IMMOVABLE);
        rows.inv_inertia.push(Mat3::zeros());
        rows.drive.push(Drive {
            force: Vec3::zeros(),
            torque: Vec3::zeros(),
            gravity_scale: def.gravity_scale,
            linear_damping: def.linear_damping,
            angular_damping: def.angular_damping,
            locks,
            sleep_threshold: def.sleep_threshold,
            enable_sleep: def.enable_sleep,
            kinematic,
        });
        rows.slow_time.push(0.0);
        let body = Body {
            set,
            row: row as u32,
            body_type: def.body_type,
            shapes: Vec::new(),
            contacts: Vec::new(),
            joints: Vec::new(),
            island: NONE,
            island_place: NONE,
            mass_override: false,
            quarantined: false,
            name: def.name.clone(),
            user_data: def.user_data,
        };
        if index == self.bodies.len() {
            self.bodies.push(body);
        } else {
            self.bodies[index] = body;
        }
    }

    /// Takes a body's row away.
    pub fn remove(&mut self, index: usize) {
        let (set, row) = (self.bodies[index].set, self.bodies[index].row as usize);
        self.remove_row(set, row);
        self.bodies[index].row = NONE;
    }

    fn remove_row(&mut self, set: SetId, row: usize) {
        let rows = &mut self.sets[set.0 as usize];
        rows.swap_remove(row);
        if let Some(&moved) = rows.index.get(row) {
            self.bodies[moved as usize].row = row as u32;
        }
    }

    /// Moves a body's row to another set.
    pub fn transfer(&mut self, index: usize, to: SetId) {
        let (from, row) = (self.bodies[index].set, self.bodies[index].row as usize);
        if from == to {
            return;
        }
        let [source, target] = self
            .sets
            .get_disjoint_mut([from.0 as usize, to.0 as usize])
            .expect("two sets of the store are distinct");
        target.push_row_of(source, row);
        let new_row = target.len() - 1;
        self.remove_row(from, row);
        let body = &mut self.bodies[index];
        (body.set, body.row) = (to, new_row as u32);
    }

    /// An empty set for an island that falls asleep.
    pub fn open_sleeping_set(&mut self) -> SetId {
        let id = self.free_sets.pop().unwrap_or_else(|| {
            self.sets.push(BodySet::default());
            self.sets.len() as u32 - 1
        });
        SetId(id)
    }

    /// Gives back the empty set of an island that woke up.
    pub fn close_sleeping_set(&mut self, set: SetId) {
        debug_assert!(set.is_sleeping() && self.sets[set.0 as usize].is_empty());
        self.sets[set.0 as usize] = BodySet::default();
        self.free_sets.push(set.0);
    }

    /// The set and row of a body.
    #[inline(always)]
    #[must_use]
    pub fn at(&self, index: usize) -> (&BodySet, usize) {
        let b = &self.bodies[index];
        (&self.sets[b.set.0 as usize], b.row as usize)
    }

    /// The set and row of a body, to be written.
    #[inline(always)]
    pub fn at_mut(&mut self, index: usize) -> (&mut BodySet, usize) {
        let b = &self.bodies[index];
        (&mut self.sets[b.set.0 as usize], b.row as usize)
    }

    /// The awake bodies.
    #[inline(always)]
    #[must_use]
    pub fn awake(&self) -> &BodySet {
        &self.sets[SetId::AWAKE.0 as usize]
    }

    /// Bytes held, names aside.
    #[must_use]
    pub fn byte_count(&self) -> usize {
        let lists: usize =
            self.bodies.iter().map(|b| 4 * (b.shapes.capacity() + b.contacts.capacity())).sum();
        self.bodies.capacity() * size_of::<Body>()
            + lists
            + self.sets.iter().map(BodySet::byte_count).sum::<usize>()
            + self.free_sets.capacity() * 4
    }
}
