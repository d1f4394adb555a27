//! A body, to be changed.

use super::{BodyMut, BodyRef};
use crate::body::{NONE, SetId};
use crate::error::{Error, ErrorCode, Result, check};
use crate::math::{Float, Pose, Quat, Vec3};
use crate::shape::{MassData, Shape};
use crate::world::{BodyType, MotionLocks};

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

    pub(super) fn refresh_boxes(&mut self) {
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
                world.islands.split(
                    island,
                    &mut world.bodies.bodies,
                    &world.contacts.contacts,
                    &world.joints.joints,
                );
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
