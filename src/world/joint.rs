//! Joints: how they are made, read, changed and destroyed.

use super::{BodyId, BodyType, JointId, World};
use crate::body::{NONE, SetId};
use crate::constraint::joint::store::coordinate;
use crate::constraint::joint::{
    Angle, GearJoint, Geometry, Joint, JointKind, MAX_ROWS, Rows, geometry, pulley::PulleyJoint, universal,
    wheel,
};
use crate::error::{Error, ErrorCode, Result, check};
use crate::event::JointEvent;
use crate::math::scalar::{double, single};
use crate::math::{Float, Pose, Vec3, length};

/// What a joint is made from.
#[derive(Clone, Debug, PartialEq)]
pub struct JointDef {
    /// What is between the bodies.
    pub kind: JointKind,
    /// The first body.
    pub body_a: BodyId,
    /// The second.
    pub body_b: BodyId,
    /// Body A from the joint's frame A, at the body's origin.
    pub local_frame_a: Pose,
    /// Body B from the joint's frame B, at the body's origin.
    pub local_frame_b: Pose,
    /// Above this force the joint makes an event \[N\], ≥ 0; default ∞.
    pub force_threshold: Float,
    /// Above this torque the joint makes an event \[N m\], ≥ 0; default ∞.
    pub torque_threshold: Float,
    /// Whether it breaks there; default false.
    pub breakable: bool,
    /// Stiffness of what the joint holds \[Hz\], ≥ 0; default 0: rigid.
    pub constraint_hertz: Float,
    /// Its damping ratio, ≥ 0; default 2.
    pub constraint_damping_ratio: Float,
    /// Size in drawings \[m\], ≥ 0; default 1.
    pub draw_scale: Float,
    /// Whether the two bodies collide; default false.
    pub collide_connected: bool,
    /// Anything.
    pub user_data: u64,
}

impl JointDef {
    /// A joint between two bodies whose frames are at their origins.
    #[must_use]
    pub fn new(kind: JointKind, body_a: BodyId, body_b: BodyId) -> Self {
        Self {
            kind,
            body_a,
            body_b,
            local_frame_a: Pose::IDENTITY,
            local_frame_b: Pose::IDENTITY,
            force_threshold: Float::INFINITY,
            torque_threshold: Float::INFINITY,
            breakable: false,
            constraint_hertz: 0.0,
            constraint_damping_ratio: 2.0,
            draw_scale: 1.0,
            collide_connected: false,
            user_data: 0,
        }
    }

    /// With these frames, from the bodies' origins.
    #[must_use]
    pub fn frames(mut self, a: Pose, b: Pose) -> Self {
        (self.local_frame_a, self.local_frame_b) = (a, b);
        self
    }

    /// Checks every number.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn validate(&self) -> Result<()> {
        self.kind.validate()?;
        check::pose("local_frame_a", &self.local_frame_a)?;
        check::pose("local_frame_b", &self.local_frame_b)?;
        threshold("force_threshold", self.force_threshold)?;
        threshold("torque_threshold", self.torque_threshold)?;
        check::not_negative("constraint_hertz", self.constraint_hertz)?;
        check::not_negative("constraint_damping_ratio", self.constraint_damping_ratio)?;
        check::not_negative("draw_scale", self.draw_scale)?;
        Ok(())
    }
}

fn threshold(name: &str, x: Float) -> Result<Float> {
    if x >= 0.0 {
        Ok(x)
    } else {
        Err(Error::new(ErrorCode::Range, format!("{name} is {x}; it must not be negative.")))
    }
}

/// A joint, to be read.
#[derive(Clone, Copy, Debug)]
pub struct JointRef<'w> {
    world: &'w World,
    index: usize,
}

/// A joint, to be changed. Changes act from the next step on; setters that refuse change nothing.
#[derive(Debug)]
pub struct JointMut<'w> {
    world: &'w mut World,
    index: usize,
}

impl World {
    /// Ties two bodies together, and wakes them.
    ///
    /// # Errors
    /// Null, foreign or stale ids; what [`JointDef::validate`] says; Range: a body with itself.
    pub fn create_joint(&mut self, def: &JointDef) -> Result<JointId> {
        let (a, b) = (self.body_index(def.body_a)?, self.body_index(def.body_b)?);
        if a == b {
            return Err(Error::new(ErrorCode::Range, "A joint ties two bodies; these are the same."));
        }
        def.validate()?;
        let frames = [
            check::pose("local_frame_a", &def.local_frame_a)?,
            check::pose("local_frame_b", &def.local_frame_b)?,
        ];
        let mut joint = Joint {
            kind: def.kind,
            bodies: [a as u32, b as u32, NONE, NONE],
            frames,
            collide_connected: def.collide_connected,
            hertz: def.constraint_hertz,
            damping_ratio: def.constraint_damping_ratio,
            force_threshold: def.force_threshold,
            torque_threshold: def.torque_threshold,
            breakable: def.breakable,
            draw_scale: def.draw_scale,
            user_data: def.user_data,
            active: false,
            start: [0.0; 2],
            impulse: [0.0; MAX_ROWS],
            turns: [Angle::default(); 2],
            total: Vec3::zeros(),
            total_angular: Vec3::zeros(),
            total_dt: 0.0,
            push: 1.0,
        };
        if let JointKind::Gear(gear) | JointKind::RackPinion(gear) = def.kind {
            self.prepare_gear(&mut joint, &gear)?;
        }
        let g = joint.geometry(&self.bodies);
        joint.turns[0].rest = match joint.kind {
            JointKind::Revolute(_) | JointKind::Wheel(_) => geometry::twist(&g.relative(), 2),
            JointKind::Screw(_) => geometry::twist(&g.relative(), 0),
            _ => 0.0,
        };
        if let JointKind::Pulley(p) = &mut joint.kind
            && p.max_length == 0.0
        {
            p.max_length = p.length(&g);
            if p.min_length > p.max_length {
                return Err(Error::new(
                    ErrorCode::Range,
                    "The pulley's rope is shorter than its least length.",
                ));
            }
        }
        let (index, _) = self.identity.joints.allocate();
        self.joints.add(index, joint, &mut self.bodies);
        if !def.collide_connected {
            self.destroy_contacts_between(a, b);
        }
        self.activate_joint(index);
        Ok(self.joint_id(index))
    }

    /// Takes the bodies of the two joints over, and where their coordinates start.
    fn prepare_gear(&self, joint: &mut Joint, gear: &GearJoint) -> Result<()> {
        let mut bodies = [NONE; 4];
        for (k, &index) in gear.joints.iter().enumerate() {
            let pool = &self.identity.joints;
            if !pool.is_live(index as usize, pool.generation_of(index as usize)) {
                return Err(Error::new(ErrorCode::Stale, "A joint of the gear was destroyed."));
            }
            let part = &self.joints.joints[index as usize];
            let Some(c) = coordinate(&part.kind, &part.geometry(&self.bodies)) else {
                return Err(Error::new(ErrorCode::Range, "Gears run between revolute and prismatic joints."));
            };
            joint.start[k] = double(c.value);
            bodies[2 * k] = part.bodies[0];
            bodies[2 * k + 1] = part.bodies[1];
        }
        let slides = |index: u32| matches!(self.joints.joints[index as usize].kind, JointKind::Prismatic(_));
        if matches!(joint.kind, JointKind::RackPinion(_))
            && (slides(gear.joints[0]) || !slides(gear.joints[1]))
        {
            return Err(Error::new(
                ErrorCode::Range,
                "Rack and pinion run from a revolute to a prismatic joint.",
            ));
        }
        if gear.joints[0] == gear.joints[1] {
            return Err(Error::new(ErrorCode::Range, "A gear runs between two joints; these are the same."));
        }
        joint.bodies = bodies;
        Ok(())
    }

    /// Removes a joint, with the gears that run on it. The bodies stay asleep unless `wake`.
    ///
    /// # Errors
    /// Null, foreign or stale id.
    pub fn destroy_joint(&mut self, id: JointId, wake: bool) -> Result<()> {
        let index = self.joint_index(id)?;
        self.remove_joint(index, wake);
        Ok(())
    }

    pub(crate) fn remove_joint(&mut self, index: usize, wake: bool) {
        let gears: Vec<usize> = self
            .joints
            .live
            .iter()
            .copied()
            .filter(|&j| match &self.joints.joints[j as usize].kind {
                JointKind::Gear(g) | JointKind::RackPinion(g) => g.joints.contains(&(index as u32)),
                _ => false,
            })
            .map(|j| j as usize)
            .collect();
        for gear in gears {
            self.remove_joint(gear, wake);
        }
        if wake {
            self.wake_joint(index);
        }
        self.deactivate_joint(index);
        let joint = &self.joints.joints[index];
        let ([a, b, ..], collide) = (joint.bodies, joint.collide_connected);
        self.joints.remove(index, &mut self.bodies);
        self.identity.joints.release(index);
        if !collide {
            self.look_for_pairs_of(a as usize);
            self.look_for_pairs_of(b as usize);
        }
    }

    /// Destroys the joints of a body.
    pub(crate) fn remove_joints_of(&mut self, body: usize) {
        while let Some(&joint) = self.bodies.bodies[body].joints.last() {
            self.remove_joint(joint as usize, true);
        }
    }

    /// A joint whose bodies are all enabled acts: it ties their islands together.
    pub(crate) fn activate_joint(&mut self, index: usize) {
        let joint = &self.joints.joints[index];
        let enabled = joint.members().all(|b| self.bodies.bodies[b as usize].set != SetId::DISABLED);
        if joint.active || !enabled {
            return;
        }
        self.wake_joint(index);
        let joint = &mut self.joints.joints[index];
        joint.active = true;
        self.joints.version += 1;
        let joint = &self.joints.joints[index];
        if joint.ties() {
            let members: Vec<u32> = joint.members().collect();
            let moving = |w: &World, b: u32| w.bodies.bodies[b as usize].island != NONE;
            if let Some(&first) = members.iter().find(|&&b| moving(self, b)) {
                for &other in &members {
                    if other != first {
                        self.islands.link(first, other, &mut self.bodies.bodies);
                    }
                }
            }
        }
    }

    /// A joint ceases to act, because it or one of its bodies goes.
    pub(crate) fn deactivate_joint(&mut self, index: usize) {
        let joint = &mut self.joints.joints[index];
        if !joint.active {
            return;
        }
        joint.active = false;
        joint.clear_impulses();
        self.joints.version += 1;
        let joint = &self.joints.joints[index];
        if joint.ties() {
            let members: Vec<u32> = joint.members().collect();
            let moving = |b: &u32| self.bodies.bodies[*b as usize].island != NONE;
            if let Some(&first) = members.iter().find(|b| moving(b)) {
                for &other in members.iter().filter(|&&b| b != first) {
                    self.islands.unlink(first, other, &self.bodies.bodies);
                }
            }
        }
    }

    /// Wakes all bodies of a joint.
    pub(crate) fn wake_joint(&mut self, index: usize) {
        let members = self.joints.joints[index].bodies;
        for body in members.into_iter().filter(|&b| b != NONE) {
            self.wake_body(body as usize);
        }
    }

    /// Whether a joint forbids two bodies to collide.
    pub(crate) fn joint_forbids(&self, a: u32, b: u32) -> bool {
        let lists = [a, b].map(|i| &self.bodies.bodies[i as usize].joints);
        let shorter = if lists[0].len() <= lists[1].len() { lists[0] } else { lists[1] };
        shorter.iter().any(|&j| {
            let joint = &self.joints.joints[j as usize];
            let pair = [joint.bodies[0], joint.bodies[1]];
            !joint.collide_connected && joint.bodies[2] == NONE && (pair == [a, b] || pair == [b, a])
        })
    }

    pub(crate) fn destroy_contacts_between(&mut self, a: usize, b: usize) {
        let mut k = self.bodies.bodies[a].contacts.len();
        while k > 0 {
            k -= 1;
            let c = self.bodies.bodies[a].contacts[k] as usize;
            if self.contacts.contacts[c].body.contains(&(b as u32)) {
                self.destroy_contact(c, true);
            }
        }
    }

    /// Pairs of a body's shapes are looked for in the next step.
    pub(crate) fn look_for_pairs_of(&mut self, body: usize) {
        if self.bodies.bodies[body].set != SetId::DISABLED {
            self.moved.extend_from_slice(&self.bodies.bodies[body].shapes);
        }
    }

    /// How many joints there are.
    #[must_use]
    pub fn joint_count(&self) -> usize {
        self.identity.joints.live()
    }

    /// The ids of all joints, in order of their slots.
    pub fn joints(&self) -> impl Iterator<Item = JointId> + '_ {
        self.joints.live.iter().map(|&j| self.joint_id(j as usize))
    }

    /// Looks a joint up.
    ///
    /// # Errors
    /// Null, foreign or stale id.
    pub fn joint(&self, id: JointId) -> Result<JointRef<'_>> {
        Ok(JointRef { world: self, index: self.joint_index(id)? })
    }

    /// Looks a joint up to change it.
    ///
    /// # Errors
    /// Null, foreign or stale id.
    pub fn joint_mut(&mut self, id: JointId) -> Result<JointMut<'_>> {
        let index = self.joint_index(id)?;
        Ok(JointMut { world: self, index })
    }

    pub(crate) fn joint_index(&self, id: JointId) -> Result<usize> {
        id.look_up(self.identity.tag, &self.identity.joints)
    }

    pub(crate) fn joint_id(&self, index: usize) -> JointId {
        JointId {
            index1: index as u32 + 1,
            world: self.identity.tag,
            generation: self.identity.joints.generation(index) as u16,
        }
    }

    /// Events of the last step: joints whose force or torque exceeded a threshold, and those that broke.
    #[must_use]
    pub fn joint_events(&self) -> &[JointEvent] {
        &self.events.joint
    }

    /// Stage 10, for joints: who carries more than its threshold, and breaks.
    pub(super) fn publish_joints(&mut self) {
        for k in 0..self.joints.live.len() {
            let index = self.joints.live[k];
            let joint = &self.joints.joints[index as usize];
            let bounded = joint.force_threshold < Float::INFINITY || joint.torque_threshold < Float::INFINITY;
            if !bounded || !self.joints.is_awake(index, &self.bodies) {
                continue;
            }
            let (force, torque) = joint.force_and_torque();
            let (force, torque) = (length(force), length(torque));
            if force > joint.force_threshold || torque > joint.torque_threshold {
                let event = JointEvent {
                    joint: self.joint_id(index as usize),
                    force,
                    torque,
                    broke: joint.breakable,
                    user_data: joint.user_data,
                };
                self.events.joint.push(event);
            }
        }
        for k in 0..self.events.joint.len() {
            let event = self.events.joint[k];
            if event.broke
                && let Ok(index) = self.joint_index(event.joint)
            {
                self.remove_joint(index, true);
            }
        }
    }

    /// The greatest error of what joints hold, by the present poses: of lengths \[m\] and of angles \[rad\].
    #[must_use]
    pub fn joint_gap(&self) -> (Float, Float) {
        let mut rows = Rows::default();
        self.joints.live.iter().fold((0.0, 0.0), |(gap, angle): (Float, Float), &j| {
            let joint = &self.joints.joints[j as usize];
            if !joint.active || joint.hertz > 0.0 {
                return (gap, angle);
            }
            let (linear, angular) = joint.separation(&self.bodies, &mut rows);
            (gap.max(linear), angle.max(angular))
        })
    }
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
        self.at().separation(&self.world.bodies, &mut Rows::default()).0
    }

    /// The error of what it holds: of angles \[rad\].
    #[must_use]
    pub fn angular_separation(&self) -> Float {
        self.at().separation(&self.world.bodies, &mut Rows::default()).1
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
        let (swing, twist) = crate::constraint::joint::swing_twist(&self.geometry().relative());
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
        let mut rows = Rows::default();
        wheel.emit(&self.geometry(), &mut rows);
        let mut own = Rows::default();
        wheel.steering.emit(crate::constraint::joint::axis_sides(Vec3::x()), 0.0, true, &mut own);
        let first = rows.rows.len() - own.rows.len();
        let sum: Float = own
            .rows
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
        let mut rows = [Rows::default(), Rows::default()];
        let g = self.as_ref().geometry();
        old.emit(&g, &mut rows[0]);
        kind.emit(&g, &mut rows[1]);
        let law = |r: &Rows| {
            let kinds = r.rows.iter().map(|r| (std::mem::discriminant(&r.law), r.law.is_unbounded()));
            kinds.collect::<Vec<_>>()
        };
        let same = law(&rows[0]) == law(&rows[1]);
        let joint = self.at();
        if !same {
            let (total, angular) = (joint.total, joint.total_angular);
            // What holds the bodies comes first and stays.
            let kept = rows[0].rows.iter().zip(&rows[1].rows).take_while(|(a, b)| a.law == b.law).count();
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

/// How a gear is asked for: by ids.
impl GearJoint {
    /// A gear between two joints of a world.
    ///
    /// # Errors
    /// Null, foreign or stale ids.
    pub fn between(world: &World, first: JointId, second: JointId, ratio: Float) -> Result<Self> {
        Ok(Self {
            joints: [world.joint_index(first)? as u32, world.joint_index(second)? as u32],
            ratio: single(double(ratio)),
        })
    }
}

impl Joint {
    /// Whether it ties islands together.
    pub(crate) fn ties(&self) -> bool {
        !matches!(self.kind, JointKind::Filter)
    }

    /// Whether it takes momentum from the world: one of its bodies is immovable, or a fixed point takes part.
    pub(crate) fn holds_to_world(&self, immovable: impl Fn(u32) -> bool) -> bool {
        matches!(self.kind, JointKind::Pulley(_)) || self.members().any(immovable)
    }
}

impl World {
    pub(crate) fn joints_of(&self, body: usize) -> impl ExactSizeIterator<Item = JointId> + use<'_> {
        self.bodies.bodies[body].joints.iter().map(|&j| self.joint_id(j as usize))
    }

    /// Whether joints tie a body to a kinematic one that moves.
    pub(super) fn is_driven_by_joints(&self, body: usize) -> bool {
        self.bodies.bodies[body].joints.iter().any(|&j| {
            let joint = &self.joints.joints[j as usize];
            joint.active
                && joint.ties()
                && joint.members().any(|b| {
                    self.bodies.bodies[b as usize].body_type == BodyType::Kinematic
                        && self.is_moving(b as usize)
                })
        })
    }
}
