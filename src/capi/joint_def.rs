//! What the definitions of all joints share.

use super::Flag;
use super::def_check::{flag, from_word, to_word};
use super::guard::Neutral;
use super::id::mvBodyId;
use super::math::mvTransform;
use super::mvFloat;
use crate::constraint::joint::JointKind;
use crate::error::Result;
use crate::world::{BodyId, JointDef};
use core::ffi::c_void;

/// What a joint is: one of the mv_...Joint constants. Numbers are never reused.
pub type mvJointType = i32;
/// A spring keeps two axes along each other.
pub const mv_parallelJoint: mvJointType = 0;
/// A rod, rope or spring between two points.
pub const mv_distanceJoint: mvJointType = 1;
/// The bodies do not collide.
pub const mv_filterJoint: mvJointType = 2;
/// Drives one body against another.
pub const mv_motorJoint: mvJointType = 3;
/// A slide along x.
pub const mv_prismaticJoint: mvJointType = 4;
/// A hinge about z.
pub const mv_revoluteJoint: mvJointType = 5;
/// Ball and socket.
pub const mv_sphericalJoint: mvJointType = 6;
/// Two bodies as one.
pub const mv_weldJoint: mvJointType = 7;
/// A wheel on its suspension.
pub const mv_wheelJoint: mvJointType = 8;
/// Cardan's joint.
pub const mv_universalJoint: mvJointType = 9;
/// Six axes, each free, locked or limited.
pub const mv_sixDofJoint: mvJointType = 10;
/// Two joints in step.
pub const mv_gearJoint: mvJointType = 11;
/// A turn in step with a slide.
pub const mv_rackPinionJoint: mvJointType = 12;
/// A rope over two fixed points.
pub const mv_pulleyJoint: mvJointType = 13;
/// A slide in step with a turn about the same axis.
pub const mv_screwJoint: mvJointType = 14;

/// What all joints have. A part of each joint's definition, set by its mvDefault...JointDef().
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvJointDef {
    /// Anything: mvJoint_GetUserData().
    pub user_data: *mut c_void,
    /// The first body.
    pub body_id_a: mvBodyId,
    /// The second body, another one of the same world. At least one of them should be dynamic.
    pub body_id_b: mvBodyId,
    /// Where the joint's frame A is in body A, from the body's origin; default the identity.
    pub local_frame_a: mvTransform,
    /// Where the joint's frame B is in body B, from the body's origin; default the identity.
    pub local_frame_b: mvTransform,
    /// Above this force the joint makes an event [N], >= 0; default infinity.
    pub force_threshold: mvFloat,
    /// Above this torque the joint makes an event [N m], >= 0; default infinity.
    pub torque_threshold: mvFloat,
    /// How stiffly the joint holds what it holds [Hz], >= 0; 0, the default, is rigid.
    pub constraint_hertz: mvFloat,
    /// The damping ratio that belongs to it, >= 0; default 2.
    pub constraint_damping_ratio: mvFloat,
    /// The size in drawings [m], >= 0; default 1.
    pub draw_scale: mvFloat,
    /// Whether the two bodies collide with each other; default false.
    pub collide_connected: Flag,
    /// Whether the joint breaks where it would make an event; default false.
    pub breakable: Flag,
}

pub(super) fn default_base() -> mvJointDef {
    let d = JointDef::new(JointKind::Filter, mvBodyId::NEUTRAL.into(), mvBodyId::NEUTRAL.into());
    mvJointDef {
        user_data: from_word(d.user_data),
        body_id_a: d.body_a.into(),
        body_id_b: d.body_b.into(),
        local_frame_a: d.local_frame_a.into(),
        local_frame_b: d.local_frame_b.into(),
        force_threshold: d.force_threshold,
        torque_threshold: d.torque_threshold,
        constraint_hertz: d.constraint_hertz,
        constraint_damping_ratio: d.constraint_damping_ratio,
        draw_scale: d.draw_scale,
        collide_connected: d.collide_connected.into(),
        breakable: d.breakable.into(),
    }
}

impl mvJointDef {
    /// For these bodies.
    pub(super) fn between(mut self, a: BodyId, b: BodyId) -> Self {
        (self.body_id_a, self.body_id_b) = (a.into(), b.into());
        self
    }

    /// The engine's definition; its numbers are checked where the joint is made.
    pub(super) fn with(&self, kind: JointKind) -> Result<JointDef> {
        Ok(JointDef {
            kind,
            body_a: self.body_id_a.into(),
            body_b: self.body_id_b.into(),
            local_frame_a: self.local_frame_a.pose("localFrameA")?,
            local_frame_b: self.local_frame_b.pose("localFrameB")?,
            force_threshold: self.force_threshold,
            torque_threshold: self.torque_threshold,
            breakable: flag("breakable", self.breakable)?,
            constraint_hertz: self.constraint_hertz,
            constraint_damping_ratio: self.constraint_damping_ratio,
            draw_scale: self.draw_scale,
            collide_connected: flag("collideConnected", self.collide_connected)?,
            user_data: to_word(self.user_data),
        })
    }
}
