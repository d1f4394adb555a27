//! Joints: how they are made, act, break and are destroyed.

use super::{BodyId, BodyType, JointId, JointMut, JointRef, World};
use crate::body::{NONE, SetId};
use crate::constraint::joint::store::coordinate;
use crate::constraint::joint::{Angle, GearJoint, Joint, JointKind, MAX_ROWS, geometry};
use crate::error::{Error, ErrorCode, Result, check};
use crate::event::JointEvent;
use crate::math::scalar::double;
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

pub(super) fn threshold(name: &str, x: Float) -> Result<Float> {
    if x >= 0.0 {
        Ok(x)
    } else {
        Err(Error::new(ErrorCode::Range, format!("{name} is {x}; it must not be negative.")))
    }
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
        self.joints.live.iter().fold((0.0, 0.0), |(gap, angle): (Float, Float), &j| {
            let joint = &self.joints.joints[j as usize];
            if !joint.active || joint.hertz > 0.0 {
                return (gap, angle);
            }
            let (linear, angular) = joint.separation(&self.bodies);
            (gap.max(linear), angle.max(angular))
        })
    }
}

/// How a gear is asked for: by ids.
impl GearJoint {
    /// A gear between two joints of a world.
    ///
    /// # Errors
    /// Null, foreign or stale ids.
    pub fn between(world: &World, first: JointId, second: JointId, ratio: Float) -> Result<Self> {
        Ok(Self { joints: [world.joint_index(first)? as u32, world.joint_index(second)? as u32], ratio })
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
