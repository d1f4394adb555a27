//! A joint, to be read and to be changed.

use crate::constraint::joint::{
    Geometry, Joint, JointKind, JointRow, axis_sides, geometry, pulley::PulleyJoint, swing_twist, universal,
    wheel,
};
use crate::error::{Error, ErrorCode, Result, check};
use crate::math::{Float, Pose, Vec3, length};
use crate::world::joint::threshold;
use crate::world::{BodyId, JointId, World};

/// A joint, to be read.
#[derive(Clone, Copy, Debug)]
pub struct JointRef<'w> {
    pub(crate) world: &'w World,
    pub(crate) index: usize,
}

/// A joint, to be changed. Changes act from the next step on; setters that refuse change nothing.
#[derive(Debug)]
pub struct JointMut<'w> {
    pub(crate) world: &'w mut World,
    pub(crate) index: usize,
}

impl<'w> JointRef<'w> {
    fn at(&self) -> &'w Joint {
        &self.world.joints.joints[self.index]
    }

    /// Its id.
    #[must_use]
    pub fn id(&self) -> JointId {
        self.world.joint_id(self.index)
    }

    /// What it does, with its parameters.
    #[must_use]
    pub fn kind(&self) -> &'w JointKind {
        &self.at().kind
    }

    /// The first body (of a gear: of its first joint).
    #[must_use]
    pub fn body_a(&self) -> BodyId {
        self.world.body_id(self.at().bodies[0] as usize)
    }

    /// The second body (of a gear: of its first joint).
    #[must_use]
    pub fn body_b(&self) -> BodyId {
        self.world.body_id(self.at().bodies[1] as usize)
    }

    /// Body A from frame A.
    #[must_use]
    pub fn local_frame_a(&self) -> Pose {
        self.at().frames[0]
    }

    /// Body B from frame B.
    #[must_use]
    pub fn local_frame_b(&self) -> Pose {
        self.at().frames[1]
    }

    /// Whether the two bodies collide.
    #[must_use]
    pub fn collide_connected(&self) -> bool {
        self.at().collide_connected
    }

    /// Anything.
    #[must_use]
    pub fn user_data(&self) -> u64 {
        self.at().user_data
    }

    /// Stiffness \[Hz\] and damping ratio of what the joint holds; 0 Hz is rigid.
    #[must_use]
    pub fn constraint_tuning(&self) -> (Float, Float) {
        (self.at().hertz, self.at().damping_ratio)
    }

    /// Force and torque above which it makes an event.
    #[must_use]
    pub fn thresholds(&self) -> (Float, Float) {
        (self.at().force_threshold, self.at().torque_threshold)
    }

    /// Whether it breaks there.
    #[must_use]
    pub fn is_breakable(&self) -> bool {
        self.at().breakable
    }

    /// Size in drawings \[m\].
    #[must_use]
    pub fn draw_scale(&self) -> Float {
        self.at().draw_scale
    }

    /// The force on B, mean over the last step \[N\]: the impulses that were applied, divided by its length. A has the
    /// opposite.
    #[must_use]
    pub fn constraint_force(&self) -> Vec3 {
        self.at().force_and_torque().0
    }

    /// The torque on B about the origin of frame B, mean over the last step \[N m\].
    #[must_use]
    pub fn constraint_torque(&self) -> Vec3 {
        self.at().force_and_torque().1
    }

    /// The error of what it holds: of lengths \[m\].
    #[must_use]
    pub fn linear_separation(&self) -> Float {
        self.at().separation(&self.world.bodies).0
    }

    /// The error of what it holds: of angles \[rad\].
    #[must_use]
    pub fn angular_separation(&self) -> Float {
        self.at().separation(&self.world.bodies).1
    }

    /// Where the frames are.
    #[must_use]
    pub fn geometry(&self) -> Geometry {
        self.at().geometry(&self.world.bodies)
    }

    /// The coordinate of a joint that has one: angle of a revolute or screw joint, spin of a wheel \[rad\], counting
    /// turns; translation of a prismatic joint, travel of a wheel's suspension (see [`suspension`](Self::suspension)),
    /// length of a distance joint or of a pulley's rope \[m\]. 0 for others.
    #[must_use]
    pub fn coordinate(&self) -> Float {
        let g = self.geometry();
        match &self.at().kind {
            JointKind::Revolute(_) => g.angle_about(2, 0).radians(),
            JointKind::Wheel(_) => wheel::spin_angle(&g).radians(),
            JointKind::Screw(_) => g.angle_about(0, 0).radians(),
            JointKind::Prismatic(_) => g.d.dot(&g.axis(0, 0)),
            JointKind::Distance(_) => length(g.d),
            JointKind::Pulley(p) => PulleyJoint::length(p, &g),
            _ => 0.0,
        }
    }

    /// How fast the coordinate changes \[rad/s, m/s\].
    #[must_use]
    pub fn speed(&self) -> Float {
        let g = self.geometry();
        let velocity = self.relative_velocity(&g);
        match &self.at().kind {
            JointKind::Revolute(_) => velocity.1.dot(&g.axis(0, 2)),
            JointKind::Wheel(_) => velocity.1.dot(&g.axis(1, 2)),
            JointKind::Screw(_) => velocity.1.dot(&g.axis(0, 0)),
            JointKind::Prismatic(_) => velocity.0.dot(&g.axis(0, 0)),
            JointKind::Distance(_) => velocity.0.dot(&crate::math::normalize_or(g.d, g.axis(0, 0))),
            _ => 0.0,
        }
    }

    /// Of the origin of frame B against A's body at that point, and of B's turn against A's.
    fn relative_velocity(&self, g: &Geometry) -> (Vec3, Vec3) {
        let [a, b, ..] = self.at().bodies;
        let of = |body: u32| {
            let (set, row) = self.world.bodies.at(body as usize);
            (set.velocity(row), set.angular_velocity(row))
        };
        let ((va, wa), (vb, wb)) = (of(a), of(b));
        let [arm_a, arm_b] = g.arms_at_b();
        (vb + wb.cross(&arm_b) - va - wa.cross(&arm_a), wb - wa)
    }

    /// Travel of a wheel's suspension \[m\]; 0 for other joints.
    #[must_use]
    pub fn suspension(&self) -> Float {
        let g = self.geometry();
        if let JointKind::Wheel(_) = self.at().kind { g.d.dot(&g.axis(0, 0)) } else { 0.0 }
    }

    /// Steering angle of a wheel \[rad\]; 0 for other joints.
    #[must_use]
    pub fn steering(&self) -> Float {
        if let JointKind::Wheel(_) = self.at().kind { wheel::steering_angle(&self.geometry()) } else { 0.0 }
    }

    /// The swing of z of frame B from z of frame A and the twist about z \[rad\].
    #[must_use]
    pub fn swing_and_twist(&self) -> (Float, Float) {
        let (swing, twist) = swing_twist(&self.geometry().relative());
        (length(swing), twist)
    }

    /// The two angles of a universal joint \[rad\].
    #[must_use]
    pub fn universal_angles(&self) -> [Float; 2] {
        universal::angles(&self.geometry())
    }

    /// The parts of d along the axes of frame A \[m\], and of the rotation vector \[rad\]: the coordinates of a
    /// six-degrees-of-freedom joint.
    #[must_use]
    pub fn six_coordinates(&self) -> (Vec3, Vec3) {
        let g = self.geometry();
        (crate::math::rotate_back(&g.q[0], g.d), geometry::rotation_vector(&g.relative()))
    }

    /// The mean force or torque of the motor over the last sub-step, along its axis \[N, N m\]; of a spherical joint
    /// about the axes of frame A. 0 without one.
    #[must_use]
    pub fn motor_force(&self) -> Vec3 {
        let joint = self.at();
        let row = match &joint.kind {
            JointKind::Revolute(j) => j.drive.motor_row().map(|r| r + 5),
            JointKind::Prismatic(j) => j.drive.motor_row().map(|r| r + 5),
            JointKind::Screw(j) => j.drive.motor_row().map(|r| r + 5),
            JointKind::Wheel(j) => j.spin_row(),
            JointKind::Distance(j) => j.motor_row(),
            JointKind::Spherical(j) => j.motor_row(),
            _ => None,
        };
        let h = self.world.last_h;
        let Some(row) = row.filter(|_| h > 0.0) else { return Vec3::zeros() };
        let three = matches!(joint.kind, JointKind::Spherical(_));
        let at = |k: usize| if k == 0 || three { joint.impulse[row + k] / h } else { 0.0 };
        Vec3::new(at(0), at(1), at(2))
    }

    /// The mean torque that steers a wheel, over the last sub-step \[N m\]: spring, friction, motor and limits.
    #[must_use]
    pub fn steering_torque(&self) -> Float {
        let JointKind::Wheel(wheel) = &self.at().kind else { return 0.0 };
        let h = self.world.last_h;
        if !wheel.enable_steering || h <= 0.0 {
            return 0.0;
        }
        let rows = self.at().kind.rows(&self.geometry());
        let mut own = Vec::new();
        wheel.steering.emit(axis_sides(Vec3::x()), 0.0, true, &mut |row: JointRow| own.push(row));
        let first = rows.len() - own.len();
        let sum: Float = own
            .iter()
            .enumerate()
            .map(|(k, row)| row.sides[1].angular.x * self.at().impulse[first + k])
            .sum();
        sum / h
    }
}

impl JointMut<'_> {
    /// To read it.
    #[must_use]
    pub fn as_ref(&self) -> JointRef<'_> {
        JointRef { world: self.world, index: self.index }
    }

    fn at(&mut self) -> &mut Joint {
        &mut self.world.joints.joints[self.index]
    }

    /// Gives it other parameters; the bodies wake where they change.
    ///
    /// # Errors
    /// What [`JointKind::validate`] says; Range: another kind of joint, or other joints of a gear.
    pub fn set_kind(&mut self, kind: JointKind) -> Result<()> {
        kind.validate()?;
        let old = self.at().kind;
        if !old.is_same_joint(&kind) {
            return Err(Error::new(
                ErrorCode::Range,
                format!("This is a {} joint, not a {} joint.", old.name(), kind.name()),
            ));
        }
        if let (JointKind::Gear(a) | JointKind::RackPinion(a), JointKind::Gear(b) | JointKind::RackPinion(b)) =
            (old, kind)
            && a.joints != b.joints
        {
            return Err(Error::new(ErrorCode::Range, "A gear keeps its joints."));
        }
        if old == kind {
            return Ok(());
        }
        // Rows may come and go: impulses lose their places then.
        let g = self.as_ref().geometry();
        let rows = [old.rows(&g), kind.rows(&g)];
        let law = |r: &[JointRow]| {
            let kinds = r.iter().map(|r| (std::mem::discriminant(&r.law), r.law.is_unbounded()));
            kinds.collect::<Vec<_>>()
        };
        let same = law(&rows[0]) == law(&rows[1]);
        let joint = self.at();
        if !same {
            let (total, angular) = (joint.total, joint.total_angular);
            // What holds the bodies comes first and stays.
            let kept = rows[0].iter().zip(&rows[1]).take_while(|(a, b)| a.law == b.law).count();
            joint.impulse[kept..].fill(0.0);
            (joint.total, joint.total_angular) = (total, angular);
        }
        joint.kind = kind;
        if !same {
            self.world.joints.version += 1;
        }
        self.world.wake_joint(self.index);
        Ok(())
    }

    /// Moves frame A, body from frame.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn set_local_frame_a(&mut self, frame: &Pose) -> Result<()> {
        self.at().frames[0] = check::pose("local_frame_a", frame)?;
        self.world.wake_joint(self.index);
        Ok(())
    }

    /// Moves frame B, body from frame.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn set_local_frame_b(&mut self, frame: &Pose) -> Result<()> {
        self.at().frames[1] = check::pose("local_frame_b", frame)?;
        self.world.wake_joint(self.index);
        Ok(())
    }

    /// Lets the two bodies collide, or not.
    pub fn set_collide_connected(&mut self, on: bool) {
        let [a, b, ..] = self.at().bodies;
        if self.at().collide_connected == on {
            return;
        }
        self.at().collide_connected = on;
        if on {
            self.world.look_for_pairs_of(a as usize);
            self.world.look_for_pairs_of(b as usize);
        } else {
            self.world.destroy_contacts_between(a as usize, b as usize);
        }
        self.world.wake_joint(self.index);
    }

    /// Sets the user data.
    pub fn set_user_data(&mut self, data: u64) {
        self.at().user_data = data;
    }

    /// Sets stiffness \[Hz\], 0 for rigid, and damping ratio of what the joint holds.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn set_constraint_tuning(&mut self, hertz: Float, damping_ratio: Float) -> Result<()> {
        check::not_negative("constraint_hertz", hertz)?;
        check::not_negative("constraint_damping_ratio", damping_ratio)?;
        (self.at().hertz, self.at().damping_ratio) = (hertz, damping_ratio);
        // A mesh solves rigid and soft joints apart.
        self.world.joints.version += 1;
        self.world.wake_joint(self.index);
        Ok(())
    }

    /// Sets the force \[N\] and torque \[N m\] above which it makes an event; ∞ for none.
    ///
    /// # Errors
    /// Range.
    pub fn set_thresholds(&mut self, force: Float, torque: Float) -> Result<()> {
        threshold("force_threshold", force)?;
        threshold("torque_threshold", torque)?;
        (self.at().force_threshold, self.at().torque_threshold) = (force, torque);
        Ok(())
    }

    /// Whether it breaks at the thresholds.
    pub fn set_breakable(&mut self, on: bool) {
        self.at().breakable = on;
    }

    /// Wakes its bodies.
    pub fn wake_bodies(&mut self) {
        self.world.wake_joint(self.index);
    }
}
