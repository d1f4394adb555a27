//! Bodies, shapes and contacts as a user sees them.

use super::{
    BodyDef, BodyId, BodyType, Collider, ContactId, Filter, MotionLocks, ShapeId, SurfaceMaterial, World,
};
use crate::body::{NONE, SetId};
use crate::constraint::contact::flags;
use crate::error::{Error, ErrorCode, Result, check};
use crate::math::{Aabb, Float, Mat3, Pose, Quat, Vec3};
use crate::shape::{MassData, Shape};

/// A body, to be read.
#[derive(Clone, Copy, Debug)]
pub struct BodyRef<'w> {
    pub(crate) world: &'w World,
    pub(crate) index: usize,
}

/// A body, to be changed. Setters check what they are given and change nothing when they refuse it.
#[derive(Debug)]
pub struct BodyMut<'w> {
    pub(crate) world: &'w mut World,
    pub(crate) index: usize,
}

/// An attached shape, to be read.
#[derive(Clone, Copy, Debug)]
pub struct ColliderRef<'w> {
    pub(crate) world: &'w World,
    pub(crate) index: usize,
}

/// An attached shape, to be changed.
#[derive(Debug)]
pub struct ColliderMut<'w> {
    pub(crate) world: &'w mut World,
    pub(crate) index: usize,
}

/// A touching contact, as of the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactData {
    /// The contact.
    pub contact: ContactId,
    /// The shape with the lower slot.
    pub shape_a: ShapeId,
    /// The other.
    pub shape_b: ShapeId,
    /// Unit normal from A to B.
    pub normal: Vec3,
    /// Number of points.
    pub count: usize,
    /// The points, the first `count` of them.
    pub points: [ContactDataPoint; 4],
    /// Sum of the friction impulses on B over the last step \[N s\].
    pub friction_impulse: Vec3,
}

/// A point of a [`ContactData`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactDataPoint {
    /// Where, in the world, at the start of the last step \[m\].
    pub point: Vec3,
    /// From the centre of mass of A \[m\].
    pub anchor_a: Vec3,
    /// From the centre of mass of B \[m\].
    pub anchor_b: Vec3,
    /// Gap at the start of the last step \[m\].
    pub separation: Float,
    /// Normal impulse of the last sub-step \[N s\].
    pub normal_impulse: Float,
    /// Sum of the normal impulses over the last step \[N s\].
    pub total_normal_impulse: Float,
    /// Normal velocity at the start of the last step, negative when approaching \[m/s\].
    pub normal_velocity: Float,
    /// Which features of the shapes meet here.
    pub feature: u32,
}

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

impl BodyMut<'_> {
    /// To read it.
    #[must_use]
    pub fn as_ref(&self) -> BodyRef<'_> {
        BodyRef { world: self.world, index: self.index }
    }

    fn at(&mut self) -> (&mut crate::body::BodySet, usize) {
        self.world.bodies.at_mut(self.index)
    }

    fn is(&self, t: BodyType) -> bool {
        self.world.bodies.bodies[self.index].body_type == t
    }

    /// Sets the name.
    pub fn set_name(&mut self, name: &str) {
        self.world.bodies.bodies[self.index].name = name.to_owned();
    }
    /// Sets the user data.
    pub fn set_user_data(&mut self, data: u64) {
        self.world.bodies.bodies[self.index].user_data = data;
    }

    /// Moves the origin there. A teleport: what it touched wakes up, velocities stay.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn set_transform(&mut self, transform: &Pose) -> Result<()> {
        let pose = check::pose("transform", transform)?;
        self.world.wake_touching(self.index);
        let (set, row) = self.at();
        let (v, w, center) = (set.velocity(row), set.angular_velocity(row), set.mass[row].center);
        set.motion[row].q = pose.q;
        set.motion[row].place(pose.point(center));
        set.refresh_inertia(row);
        set.set_velocity(row, v);
        set.set_angular_velocity(row, w);
        self.refresh_boxes();
        Ok(())
    }

    fn refresh_boxes(&mut self) {
        let world = &mut *self.world;
        let (set, row) = world.bodies.at(self.index);
        let origin = set.origin(row);
        let enabled = world.bodies.bodies[self.index].set != SetId::DISABLED;
        for k in 0..world.bodies.bodies[self.index].shapes.len() {
            let s = world.bodies.bodies[self.index].shapes[k] as usize;
            world.colliders[s].fat = world.first_box(&world.colliders[s], &origin, self.index);
            if enabled {
                world.broad_phase.update(s as u32, &world.colliders[s].fat);
                world.moved.push(s as u32);
            }
        }
    }

    /// Gives a body the velocity that takes its origin to `target` in `dt` seconds (> 0). A static body stays.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn set_target_transform(&mut self, target: &Pose, dt: Float) -> Result<()> {
        let target = check::pose("target", target)?;
        check::positive("time_step", dt)?;
        let (set, row) = self.at();
        let center = target.point(set.mass[row].center);
        let v = (center - set.motion[row].x) / dt;
        let mut turn = target.q * set.motion[row].q.conjugate();
        if turn.w < 0.0 {
            turn = Quat::new_unchecked(-turn.into_inner());
        }
        let axis = Vec3::new(turn.i, turn.j, turn.k);
        let s = crate::math::length(axis);
        let w = if s > 0.0 {
            axis * (2.0 * crate::math::scalar::atan2(s, turn.w) / (s * dt))
        } else {
            Vec3::zeros()
        };
        check::point("The angular velocity that follows", w)?;
        self.set_linear_velocity(v)?;
        self.set_angular_velocity(w)
    }

    /// Sets the velocity of the centre of mass \[m/s\]. Wakes the body unless it is 0; no effect on static ones.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn set_linear_velocity(&mut self, v: Vec3) -> Result<()> {
        let v = check::point("linear_velocity", v)?;
        if self.is(BodyType::Static) {
            return Ok(());
        }
        self.wake_for(v);
        let (set, row) = self.at();
        set.set_velocity(row, v);
        self.kinematic_moves();
        Ok(())
    }

    /// Sets the angular velocity, world axes \[rad/s\]. Wakes the body unless it is 0.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn set_angular_velocity(&mut self, w: Vec3) -> Result<()> {
        let w = check::point("angular_velocity", w)?;
        if self.is(BodyType::Static) {
            return Ok(());
        }
        self.wake_for(w);
        let (set, row) = self.at();
        set.set_angular_velocity(row, w);
        self.kinematic_moves();
        Ok(())
    }

    fn wake_for(&mut self, v: Vec3) {
        if v != Vec3::zeros() {
            self.world.wake_body(self.index);
        }
    }

    /// A kinematic body that moves wakes what it touches, and its contacts deserve attention.
    fn kinematic_moves(&mut self) {
        if self.is(BodyType::Kinematic) && self.world.bodies.bodies[self.index].set == SetId::AWAKE {
            self.world.wake_touching(self.index);
            for k in 0..self.world.bodies.bodies[self.index].contacts.len() {
                let c = self.world.bodies.bodies[self.index].contacts[k] as usize;
                let awake = self.world.deserves_attention(c);
                self.world.contacts.set_awake(c, awake);
            }
        }
    }

    /// Sets the momentum \[kg m/s\]. Bodies without mass are left alone.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn set_momentum(&mut self, p: Vec3) -> Result<()> {
        let p = check::finite_vec("momentum", p)?;
        let inv_mass = self.as_ref().inverse_mass();
        if inv_mass > 0.0 {
            self.set_linear_velocity(p * inv_mass)?;
        }
        Ok(())
    }

    /// Sets the angular momentum about the centre of mass, world axes \[kg m²/s\].
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn set_angular_momentum(&mut self, l: Vec3) -> Result<()> {
        let l = check::finite_vec("angular_momentum", l)?;
        let w = self.as_ref().world_inverse_inertia() * l;
        check::point("The angular velocity that follows", w)?;
        if self.as_ref().mass() > 0.0 {
            self.wake_for(l);
            let free = self.as_ref().motion_locks().angular == [false; 3];
            let (set, row) = self.at();
            if free && set.mass[row].turns() {
                set.motion[row].l = l;
            } else {
                set.set_angular_velocity(row, w);
            }
        }
        Ok(())
    }

    fn pushed(&mut self, wake: bool) -> bool {
        if !self.is(BodyType::Dynamic) {
            return false;
        }
        if wake {
            self.world.wake_body(self.index);
        }
        self.world.bodies.bodies[self.index].set == SetId::AWAKE
    }

    /// Adds a force for the next step \[N\], at a point of the world. Sleeping bodies ignore it unless `wake`.
    ///
    /// # Errors
    /// NotFinite.
    pub fn apply_force(&mut self, force: Vec3, point: Vec3, wake: bool) -> Result<()> {
        let (force, point) = (check::finite_vec("force", force)?, check::finite_vec("point", point)?);
        if self.pushed(wake) {
            let (set, row) = self.at();
            let arm = point - set.motion[row].x;
            set.drive[row].force += force;
            set.drive[row].torque += arm.cross(&force);
        }
        Ok(())
    }

    /// Adds a force at the centre of mass for the next step \[N\].
    ///
    /// # Errors
    /// NotFinite.
    pub fn apply_force_to_center(&mut self, force: Vec3, wake: bool) -> Result<()> {
        let force = check::finite_vec("force", force)?;
        if self.pushed(wake) {
            let (set, row) = self.at();
            set.drive[row].force += force;
        }
        Ok(())
    }

    /// Adds a torque for the next step \[N m\].
    ///
    /// # Errors
    /// NotFinite.
    pub fn apply_torque(&mut self, torque: Vec3, wake: bool) -> Result<()> {
        let torque = check::finite_vec("torque", torque)?;
        if self.pushed(wake) {
            let (set, row) = self.at();
            set.drive[row].torque += torque;
        }
        Ok(())
    }

    /// Changes momentum at once \[N s\], at a point of the world.
    ///
    /// # Errors
    /// NotFinite.
    pub fn apply_linear_impulse(&mut self, impulse: Vec3, point: Vec3, wake: bool) -> Result<()> {
        let (impulse, point) = (check::finite_vec("impulse", impulse)?, check::finite_vec("point", point)?);
        if self.pushed(wake) {
            let arm = point - self.as_ref().world_center();
            self.change_momentum(impulse, arm.cross(&impulse))?;
        }
        Ok(())
    }

    /// Changes momentum at once, at the centre of mass \[N s\].
    ///
    /// # Errors
    /// NotFinite.
    pub fn apply_linear_impulse_to_center(&mut self, impulse: Vec3, wake: bool) -> Result<()> {
        let impulse = check::finite_vec("impulse", impulse)?;
        if self.pushed(wake) {
            self.change_momentum(impulse, Vec3::zeros())?;
        }
        Ok(())
    }

    /// Changes angular momentum at once \[N m s\].
    ///
    /// # Errors
    /// NotFinite.
    pub fn apply_angular_impulse(&mut self, impulse: Vec3, wake: bool) -> Result<()> {
        let impulse = check::finite_vec("impulse", impulse)?;
        if self.pushed(wake) {
            self.change_momentum(Vec3::zeros(), impulse)?;
        }
        Ok(())
    }

    fn change_momentum(&mut self, p: Vec3, l: Vec3) -> Result<()> {
        let (set, row) = self.at();
        check::finite_vec("The momentum that follows", set.motion[row].p + p)?;
        check::finite_vec("The angular momentum that follows", set.motion[row].l + l)?;
        let locks = set.drive[row].locks;
        if set.mass[row].inv_mass > 0.0 {
            set.motion[row].p += crate::body::store::without(p, locks.linear);
        }
        if set.mass[row].turns() && l != Vec3::zeros() {
            if locks.angular == [false; 3] {
                set.motion[row].l += l;
            } else {
                let w = set.angular_velocity(row) + set.inv_inertia[row] * l;
                set.set_angular_velocity(row, w);
            }
        }
        Ok(())
    }

    /// Gives the body a mass of its own; shapes no longer change it until
    /// [`apply_mass_from_shapes`](Self::apply_mass_from_shapes). The inertia is about the centre of mass.
    ///
    /// # Errors
    /// NotFinite; Range: negative mass, or an inertia that no solid has; the body is not dynamic.
    pub fn set_mass_data(&mut self, data: &MassData) -> Result<()> {
        if !self.is(BodyType::Dynamic) {
            return Err(Error::new(ErrorCode::Range, "Only dynamic bodies have mass data."));
        }
        check_mass_data(data)?;
        self.world.bodies.bodies[self.index].mass_override = true;
        self.world.set_mass(self.index, data);
        Ok(())
    }

    /// Makes the body's mass that of its shapes again.
    pub fn apply_mass_from_shapes(&mut self) {
        self.world.bodies.bodies[self.index].mass_override = false;
        self.world.update_mass(self.index);
    }

    /// Sets the linear damping \[1/s\], ≥ 0.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn set_linear_damping(&mut self, c: Float) -> Result<()> {
        let c = check::not_negative("linear_damping", c)?;
        let (set, row) = self.at();
        set.drive[row].linear_damping = c;
        Ok(())
    }
    /// Sets the angular damping \[1/s\], ≥ 0.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn set_angular_damping(&mut self, c: Float) -> Result<()> {
        let c = check::not_negative("angular_damping", c)?;
        let (set, row) = self.at();
        set.drive[row].angular_damping = c;
        Ok(())
    }
    /// Sets the factor on gravity.
    ///
    /// # Errors
    /// NotFinite.
    pub fn set_gravity_scale(&mut self, scale: Float) -> Result<()> {
        let scale = check::finite("gravity_scale", scale)?;
        let (set, row) = self.at();
        if set.drive[row].gravity_scale != scale {
            set.drive[row].gravity_scale = scale;
            self.world.wake_body(self.index);
        }
        Ok(())
    }
    /// Sets the speed below which it may fall asleep \[m/s\], ≥ 0.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn set_sleep_threshold(&mut self, speed: Float) -> Result<()> {
        let speed = check::not_negative("sleep_threshold", speed)?;
        let (set, row) = self.at();
        set.drive[row].sleep_threshold = speed;
        Ok(())
    }
    /// Lets it sleep, or wakes it and keeps it awake.
    pub fn enable_sleep(&mut self, on: bool) {
        let (set, row) = self.at();
        set.drive[row].enable_sleep = on;
        if !on {
            self.world.wake_body(self.index);
        }
    }
    /// Wakes the body's island, or puts it to sleep, whatever its speed: its velocities become 0. Only dynamic
    /// bodies sleep, and none that a moving kinematic body touches.
    pub fn set_awake(&mut self, awake: bool) {
        let body = &self.world.bodies.bodies[self.index];
        if awake {
            self.world.wake_body(self.index);
        } else if body.set == SetId::AWAKE && body.island != NONE {
            let island = body.island;
            if self.world.islands.islands[island as usize].lost > 0 {
                let world = &mut *self.world;
                world.islands.split(island, &mut world.bodies.bodies, &world.contacts.contacts);
            }
            let island = self.world.bodies.bodies[self.index].island;
            if !self.world.touches_moving_kinematic(island as usize) {
                self.world.put_to_sleep(island);
            }
        }
    }

    /// Sets the locked directions; the velocity along them becomes 0. Only dynamic bodies have locks.
    pub fn set_motion_locks(&mut self, locks: MotionLocks) {
        if !self.is(BodyType::Dynamic) {
            return;
        }
        self.world.wake_body(self.index);
        let (set, row) = self.at();
        let (v, w) = (set.velocity(row), set.angular_velocity(row));
        set.drive[row].locks = locks;
        set.refresh_inertia(row);
        set.set_velocity(row, v);
        set.set_angular_velocity(row, w);
    }

    /// Takes it out of the world, keeping its state.
    pub fn disable(&mut self) {
        self.world.disable_body(self.index);
    }

    /// Puts it back into the world, awake. Also ends a quarantine.
    pub fn enable(&mut self) {
        self.world.enable_body(self.index);
    }

    /// Changes how it moves. Velocities become 0 for static bodies.
    ///
    /// # Errors
    /// Range: a half-space cannot move.
    pub fn set_type(&mut self, body_type: BodyType) -> Result<()> {
        let body = &self.world.bodies.bodies[self.index];
        if body.body_type == body_type {
            return Ok(());
        }
        if body_type != BodyType::Static
            && body
                .shapes
                .iter()
                .any(|&s| matches!(self.world.colliders[s as usize].shape, Shape::HalfSpace(_)))
        {
            return Err(Error::new(ErrorCode::Range, "A half-space has no mass; its body must be static."));
        }
        let enabled = body.set != SetId::DISABLED;
        self.world.disable_body(self.index);
        let (set, row) = self.at();
        let (v, w) = (set.velocity(row), set.angular_velocity(row));
        self.world.bodies.bodies[self.index].body_type = body_type;
        self.world.bodies.bodies[self.index].mass_override = false;
        let (set, row) = self.at();
        set.drive[row].kinematic = body_type == BodyType::Kinematic;
        if body_type != BodyType::Dynamic {
            set.drive[row].locks = MotionLocks::default();
        }
        self.world.update_mass(self.index);
        let (set, row) = self.at();
        let still = body_type == BodyType::Static;
        set.set_velocity(row, if still { Vec3::zeros() } else { v });
        set.set_angular_velocity(row, if still { Vec3::zeros() } else { w });
        if enabled {
            self.world.enable_body(self.index);
        }
        Ok(())
    }
}

fn check_mass_data(data: &MassData) -> Result<()> {
    check::not_negative("mass", data.mass)?;
    check::point("center", data.center)?;
    let m = &data.inertia;
    if !m.iter().all(|x| x.is_finite()) {
        return Err(Error::new(ErrorCode::NotFinite, "The inertia has an element that is not finite."));
    }
    let scale = m.amax();
    if (m - m.transpose()).amax() > 1e-3 * scale {
        return Err(Error::new(ErrorCode::Range, "The inertia is not symmetric."));
    }
    if data.mass == 0.0 && scale > 0.0 {
        return Err(Error::new(ErrorCode::Range, "A body without mass has no inertia."));
    }
    // No solid has a principal moment greater than the sum of the other two; a little is left to rounding.
    let moments = crate::integrate::PrincipalAxes::of(m).moments;
    let (least, most) = (moments.min(), moments.max());
    if least < -1e-4 * scale || most > (moments.sum() - most) * 1.001 + 1e-6 * scale {
        return Err(Error::new(ErrorCode::Range, "The inertia is that of no solid body."));
    }
    if scale > 0.0 && least <= 1e-6 * most {
        return Err(Error::new(ErrorCode::Degenerate, "The inertia vanishes about an axis."));
    }
    Ok(())
}

impl World {
    /// Takes a body out of the world, keeping its state.
    pub(crate) fn disable_body(&mut self, index: usize) {
        if self.bodies.bodies[index].set == SetId::DISABLED {
            return;
        }
        self.wake_touching(index);
        for k in 0..self.bodies.bodies[index].shapes.len() {
            let shape = self.bodies.bodies[index].shapes[k] as usize;
            self.leave_broad_phase(shape);
        }
        self.islands.leave(index as u32, &mut self.bodies.bodies);
        self.bodies.transfer(index, SetId::DISABLED);
        let (set, row) = self.bodies.at_mut(index);
        (set.drive[row].force, set.drive[row].torque) = (Vec3::zeros(), Vec3::zeros());
    }

    /// Puts a body back into the world, awake.
    pub(crate) fn enable_body(&mut self, index: usize) {
        if self.bodies.bodies[index].set != SetId::DISABLED {
            return;
        }
        let body_type = self.bodies.bodies[index].body_type;
        let set = if body_type == BodyType::Static { SetId::STATIC } else { SetId::AWAKE };
        self.bodies.transfer(index, set);
        self.bodies.bodies[index].quarantined = false;
        if body_type == BodyType::Dynamic {
            self.islands.open(index as u32, &mut self.bodies.bodies);
        }
        let (rows, row) = self.bodies.at_mut(index);
        rows.slow_time[row] = 0.0;
        let origin = rows.origin(row);
        for k in 0..self.bodies.bodies[index].shapes.len() {
            let shape = self.bodies.bodies[index].shapes[k] as usize;
            self.colliders[shape].fat = self.first_box(&self.colliders[shape], &origin, index);
            self.enter_broad_phase(shape);
        }
    }

    /// The data of a contact, where it touches.
    pub(crate) fn contact_data(&self, index: usize) -> Option<ContactData> {
        let contact = &self.contacts.contacts[index];
        if !contact.is(flags::TOUCHING) {
            return None;
        }
        let x = |side: usize| {
            let (set, row) = self.bodies.at(contact.body[side] as usize);
            set.motion[row].x
        };
        let (xa, xb) = (x(0), x(1));
        let mut points = [ContactDataPoint::default(); 4];
        for (out, p) in points.iter_mut().zip(contact.points()) {
            *out = ContactDataPoint {
                point: xa + p.anchor,
                anchor_a: p.anchor,
                anchor_b: p.anchor + (xa - xb),
                separation: p.separation,
                normal_impulse: p.impulse,
                total_normal_impulse: p.total,
                normal_velocity: p.approach,
                feature: p.feature,
            };
        }
        Some(ContactData {
            contact: self.contact_id(index),
            shape_a: self.shape_id(contact.shape[0] as usize),
            shape_b: self.shape_id(contact.shape[1] as usize),
            normal: contact.normal,
            count: contact.count as usize,
            points,
            friction_impulse: contact.total_friction,
        })
    }

    /// A body with one shape, in one call.
    ///
    /// # Errors
    /// As of [`create_body`](Self::create_body) and [`create_shape`](Self::create_shape); nothing is left behind.
    pub fn create_body_with_shape(
        &mut self,
        body: &BodyDef,
        def: &super::ShapeDef,
        shape: Shape,
    ) -> Result<(BodyId, ShapeId)> {
        let id = self.create_body(body)?;
        match self.create_shape(id, def, shape, Pose::IDENTITY) {
            Ok(shape) => Ok((id, shape)),
            Err(e) => {
                self.destroy_body(id)?;
                Err(e)
            }
        }
    }
}

impl<'w> ColliderRef<'w> {
    fn collider(&self) -> &'w Collider {
        &self.world.colliders[self.index]
    }

    /// Its id.
    #[must_use]
    pub fn id(&self) -> ShapeId {
        self.world.shape_id(self.index)
    }
    /// The body it is attached to.
    #[must_use]
    pub fn body(&self) -> BodyId {
        self.world.body_id(self.collider().body as usize)
    }
    /// Geometry in its own frame.
    #[must_use]
    pub fn shape(&self) -> &'w Shape {
        &self.collider().shape
    }
    /// Body from shape.
    #[must_use]
    pub fn local_pose(&self) -> Pose {
        self.collider().local
    }
    /// World from shape.
    #[must_use]
    pub fn world_pose(&self) -> Pose {
        let (set, row) = self.world.bodies.at(self.collider().body as usize);
        set.origin(row).then(&self.collider().local)
    }
    /// Surface.
    #[must_use]
    pub fn material(&self) -> SurfaceMaterial {
        self.collider().material
    }
    /// \[kg/m³\]
    #[must_use]
    pub fn density(&self) -> Float {
        self.collider().density
    }
    /// What it collides with.
    #[must_use]
    pub fn filter(&self) -> Filter {
        self.collider().filter
    }
    /// Its name.
    #[must_use]
    pub fn name(&self) -> &'w str {
        &self.collider().name
    }
    /// Its user data.
    #[must_use]
    pub fn user_data(&self) -> u64 {
        self.collider().user_data
    }
    /// Whether begin and end events are made.
    #[must_use]
    pub fn are_contact_events_enabled(&self) -> bool {
        self.collider().contact_events
    }
    /// Whether hit events are made.
    #[must_use]
    pub fn are_hit_events_enabled(&self) -> bool {
        self.collider().hit_events
    }
    /// Whether the pre-solve callback is asked.
    #[must_use]
    pub fn are_pre_solve_events_enabled(&self) -> bool {
        self.collider().pre_solve_events
    }
    /// Mass, centre and inertia in the body's frame, by density.
    #[must_use]
    pub fn mass_data(&self) -> MassData {
        self.collider().mass_data()
    }
    /// The tight box in the world.
    #[must_use]
    pub fn aabb(&self) -> Aabb {
        let (set, row) = self.world.bodies.at(self.collider().body as usize);
        self.collider().aabb(&set.origin(row))
    }
    /// The closest point of the shape to `target`, both in the world; `target` itself where it is inside.
    #[must_use]
    pub fn closest_point(&self, target: Vec3) -> Vec3 {
        let pose = self.world_pose();
        pose.point(self.collider().shape.closest_point(pose.point_back(target)))
    }
    /// An upper bound for the number of its touching contacts.
    #[must_use]
    pub fn contact_capacity(&self) -> usize {
        let body = &self.world.bodies.bodies[self.collider().body as usize];
        let mine = |c: &&u32| self.world.contacts.contacts[**c as usize].shape.contains(&(self.index as u32));
        body.contacts.iter().filter(mine).count()
    }
    /// Its touching contacts, in order of contact slots.
    #[must_use]
    pub fn contacts(&self) -> Vec<ContactData> {
        let body = BodyRef { world: self.world, index: self.collider().body as usize };
        let (id, mut list) = (self.id(), body.contacts());
        list.retain(|c| c.shape_a == id || c.shape_b == id);
        list
    }
}

impl ColliderMut<'_> {
    /// To read it.
    #[must_use]
    pub fn as_ref(&self) -> ColliderRef<'_> {
        ColliderRef { world: self.world, index: self.index }
    }

    fn collider(&mut self) -> &mut Collider {
        &mut self.world.colliders[self.index]
    }

    /// Sets the name.
    pub fn set_name(&mut self, name: &str) {
        self.collider().name = name.to_owned();
    }
    /// Sets the user data.
    pub fn set_user_data(&mut self, data: u64) {
        self.collider().user_data = data;
    }

    /// Sets the surface; takes effect in the next step. What lies on a conveyor that starts or stops wakes up.
    ///
    /// # Errors
    /// What [`SurfaceMaterial::validate`] says.
    pub fn set_material(&mut self, material: &SurfaceMaterial) -> Result<()> {
        material.validate()?;
        if self.collider().material.tangent_velocity != material.tangent_velocity {
            let body = self.collider().body as usize;
            self.world.wake_touching(body);
        }
        self.collider().material = *material;
        Ok(())
    }

    /// Sets the density \[kg/m³\], ≥ 0.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn set_density(&mut self, density: Float, update_body_mass: bool) -> Result<()> {
        let density = check::not_negative("density", density)?;
        self.collider().density = density;
        if update_body_mass {
            let body = self.collider().body as usize;
            self.world.update_mass(body);
        }
        Ok(())
    }

    /// Sets what it collides with; its contacts end and are found anew in the next step.
    pub fn set_filter(&mut self, filter: Filter) {
        if self.collider().filter == filter {
            return;
        }
        self.collider().filter = filter;
        self.find_contacts_anew();
    }

    fn find_contacts_anew(&mut self) {
        let body = self.collider().body as usize;
        self.world.wake_touching(body);
        self.world.destroy_contacts_of_shape(self.index);
        if self.world.bodies.bodies[body].set != SetId::DISABLED {
            self.world.moved.push(self.index as u32);
        }
    }

    /// Makes begin and end events, or not.
    pub fn enable_contact_events(&mut self, on: bool) {
        self.collider().contact_events = on;
        self.refresh_flags();
    }
    /// Makes hit events, or not.
    pub fn enable_hit_events(&mut self, on: bool) {
        self.collider().hit_events = on;
        self.refresh_flags();
    }
    /// Asks the pre-solve callback, or not.
    pub fn enable_pre_solve_events(&mut self, on: bool) {
        self.collider().pre_solve_events = on;
        self.refresh_flags();
    }

    fn refresh_flags(&mut self) {
        let world = &mut *self.world;
        let body = world.colliders[self.index].body as usize;
        for &c in &world.bodies.bodies[body].contacts {
            let contact = &mut world.contacts.contacts[c as usize];
            if contact.shape.contains(&(self.index as u32)) {
                let [a, b] = contact.shape.map(|s| &world.colliders[s as usize]);
                contact.set(flags::EVENTS, a.contact_events || b.contact_events);
                contact.set(flags::HIT_EVENTS, a.hit_events || b.hit_events);
                contact.set(flags::PRE_SOLVE, a.pre_solve_events || b.pre_solve_events);
            }
        }
    }

    /// Replaces the geometry, placed by `local` (body from shape). Does not change the body's mass unless
    /// `update_body_mass`.
    ///
    /// # Errors
    /// NotFinite, Range; a half-space on a body that moves.
    pub fn set_shape(&mut self, shape: Shape, local: &Pose, update_body_mass: bool) -> Result<()> {
        let local = check::pose("local pose", local)?;
        let body = self.collider().body as usize;
        self.world.check_half_space(body, &shape)?;
        self.find_contacts_anew();
        let inner_radius = shape.inner_radius();
        let collider = self.collider();
        (collider.shape, collider.local, collider.inner_radius) = (shape, local, inner_radius);
        if update_body_mass {
            self.world.update_mass(body);
        } else {
            self.world.update_reach(body);
        }
        BodyMut { world: &mut *self.world, index: body }.refresh_boxes();
        Ok(())
    }
}
