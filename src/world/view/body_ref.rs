//! A body, to be read.

use super::{BodyRef, ColliderRef, ContactData};
use crate::body::SetId;
use crate::math::{Aabb, Float, Mat3, Pose, Vec3};
use crate::shape::MassData;
use crate::world::{BodyId, BodyType, JointId, MotionLocks, ShapeId};

impl<'w> BodyRef<'w> {
    fn at(&self) -> (&'w crate::body::BodySet, usize) {
        self.world.bodies.at(self.index)
    }

    fn body(&self) -> &'w crate::body::Body {
        &self.world.bodies.bodies[self.index]
    }

    /// Its id.
    #[must_use]
    pub fn id(&self) -> BodyId {
        self.world.body_id(self.index)
    }
    /// How it moves.
    #[must_use]
    pub fn body_type(&self) -> BodyType {
        self.body().body_type
    }
    /// Its name.
    #[must_use]
    pub fn name(&self) -> &'w str {
        &self.body().name
    }
    /// Its user data.
    #[must_use]
    pub fn user_data(&self) -> u64 {
        self.body().user_data
    }
    /// The sub-steps that the next step takes for it: those of the last one, or more where the world has an accuracy to
    /// keep; 0 before the first step.
    #[must_use]
    pub fn sub_steps(&self) -> u32 {
        let islands = &self.world.islands.islands;
        let level = islands.get(self.body().island as usize).map_or(0, |island| island.pacing.level);
        self.world.last_sub_steps << level
    }
    /// Where its origin is.
    #[must_use]
    pub fn transform(&self) -> Pose {
        let (set, row) = self.at();
        set.origin(row)
    }
    /// The centre of mass in the world \[m\].
    #[must_use]
    pub fn world_center(&self) -> Vec3 {
        let (set, row) = self.at();
        set.motion[row].x
    }
    /// The centre of mass in the body \[m\].
    #[must_use]
    pub fn local_center(&self) -> Vec3 {
        let (set, row) = self.at();
        set.mass[row].center
    }
    /// Velocity of the centre of mass \[m/s\].
    #[must_use]
    pub fn linear_velocity(&self) -> Vec3 {
        let (set, row) = self.at();
        set.velocity(row)
    }
    /// \[rad/s\], world axes.
    #[must_use]
    pub fn angular_velocity(&self) -> Vec3 {
        let (set, row) = self.at();
        set.angular_velocity(row)
    }
    /// Momentum \[kg m/s\]; 0 for bodies without mass.
    #[must_use]
    pub fn momentum(&self) -> Vec3 {
        let (set, row) = self.at();
        if set.mass[row].inv_mass > 0.0 { set.motion[row].p } else { Vec3::zeros() }
    }
    /// Angular momentum about the centre of mass, world axes \[kg m²/s\]; 0 for bodies without inertia.
    #[must_use]
    pub fn angular_momentum(&self) -> Vec3 {
        let (set, row) = self.at();
        if set.mass[row].turns() { set.motion[row].l } else { Vec3::zeros() }
    }
    /// Velocity of the body's point that is at `point` of the world \[m/s\].
    #[must_use]
    pub fn velocity_at(&self, point: Vec3) -> Vec3 {
        self.linear_velocity() + self.angular_velocity().cross(&(point - self.world_center()))
    }
    /// Of translation and rotation \[J\].
    #[must_use]
    pub fn kinetic_energy(&self) -> Float {
        0.5 * (self.momentum().dot(&self.linear_velocity())
            + self.angular_momentum().dot(&self.angular_velocity()))
    }
    /// \[kg\]; 0 for bodies without mass.
    #[must_use]
    pub fn mass(&self) -> Float {
        let (set, row) = self.at();
        set.mass[row].mass
    }
    /// \[1/kg\]; 0 for bodies without mass.
    #[must_use]
    pub fn inverse_mass(&self) -> Float {
        let (set, row) = self.at();
        set.mass[row].inv_mass
    }
    /// Mass, centre and inertia about the centre of mass in body axes.
    #[must_use]
    pub fn mass_data(&self) -> MassData {
        let (set, row) = self.at();
        let m = &set.mass[row];
        MassData { mass: m.mass, center: m.center, inertia: m.inertia }
    }
    /// I_w⁻¹ [1/(kg m²)], with locked axes zero.
    #[must_use]
    pub fn world_inverse_inertia(&self) -> Mat3 {
        let (set, row) = self.at();
        set.inv_inertia[row]
    }
    /// \[1/s\]
    #[must_use]
    pub fn linear_damping(&self) -> Float {
        let (set, row) = self.at();
        set.drive[row].linear_damping
    }
    /// \[1/s\]
    #[must_use]
    pub fn angular_damping(&self) -> Float {
        let (set, row) = self.at();
        set.drive[row].angular_damping
    }
    /// Factor on gravity.
    #[must_use]
    pub fn gravity_scale(&self) -> Float {
        let (set, row) = self.at();
        set.drive[row].gravity_scale
    }
    /// \[m/s\]
    #[must_use]
    pub fn sleep_threshold(&self) -> Float {
        let (set, row) = self.at();
        set.drive[row].sleep_threshold
    }
    /// Whether it may sleep.
    #[must_use]
    pub fn is_sleep_enabled(&self) -> bool {
        let (set, row) = self.at();
        set.drive[row].enable_sleep
    }
    /// Locked directions.
    #[must_use]
    pub fn motion_locks(&self) -> MotionLocks {
        let (set, row) = self.at();
        set.drive[row].locks
    }
    /// Whether a step moves it.
    #[must_use]
    pub fn is_awake(&self) -> bool {
        self.body().set == SetId::AWAKE
    }
    /// Whether it takes part.
    #[must_use]
    pub fn is_enabled(&self) -> bool {
        self.body().set != SetId::DISABLED
    }
    /// Whether it was disabled because its state stopped being finite.
    #[must_use]
    pub fn is_quarantined(&self) -> bool {
        self.body().quarantined
    }
    /// The forces and torques collected for the next step \[N, N m\].
    #[must_use]
    pub fn pending_forces(&self) -> (Vec3, Vec3) {
        let (set, row) = self.at();
        (set.drive[row].force, set.drive[row].torque)
    }
    /// Its shapes, in order of attachment.
    pub fn shapes(&self) -> impl ExactSizeIterator<Item = ShapeId> + use<'w> {
        let world = self.world;
        self.body().shapes.iter().map(move |&s| world.shape_id(s as usize))
    }
    /// Its joints, unordered.
    pub fn joints(&self) -> impl ExactSizeIterator<Item = JointId> + use<'w> {
        self.world.joints_of(self.index)
    }

    /// An upper bound for the number of its touching contacts.
    #[must_use]
    pub fn contact_capacity(&self) -> usize {
        self.body().contacts.len()
    }
    /// Its touching contacts, in order of contact slots.
    #[must_use]
    pub fn contacts(&self) -> Vec<ContactData> {
        let mut list: Vec<u32> = self.body().contacts.clone();
        list.sort_unstable();
        list.iter().filter_map(|&c| self.world.contact_data(c as usize)).collect()
    }
    /// The box around all its shapes; around its origin where it has none.
    #[must_use]
    pub fn aabb(&self) -> Aabb {
        let origin = self.transform();
        let shapes = &self.body().shapes;
        if shapes.is_empty() {
            return Aabb { lower: origin.p, upper: origin.p };
        }
        shapes.iter().fold(Aabb::EMPTY, |b, &s| b.union(&self.world.colliders[s as usize].aabb(&origin)))
    }
    /// The closest point of its shapes to `target`, and the distance \[m\]; the origin where it has none.
    #[must_use]
    pub fn closest_point(&self, target: Vec3) -> (Vec3, Float) {
        let origin = self.transform();
        let mut best = (origin.p, Float::MAX);
        for &s in &self.body().shapes {
            let shape = ColliderRef { world: self.world, index: s as usize };
            let p = shape.closest_point(target);
            let d = crate::math::length(p - target);
            if d < best.1 {
                best = (p, d);
            }
        }
        if best.1 == Float::MAX {
            best.1 = crate::math::length(origin.p - target);
        }
        best
    }
}
