//! Joints: what all of them have. What one kind has is in the file of its name.

use super::access::{edit_at_joint, is_joint, read_joint, write_joint, write_world};
use super::def_check::{flag, from_word, to_word};
use super::guard::Neutral;
use super::id::{mvBodyId, mvJointId, mvWorldId};
use super::joint_def::*;
use super::math::{mvTransform, mvVec3};
use super::{Flag, mvFloat, registry};
use crate::constraint::joint::{
    DistanceJoint, GearJoint, JointKind, MotorJoint, ParallelJoint, PrismaticJoint, PulleyJoint,
    RevoluteJoint, ScrewJoint, SixDofJoint, SphericalJoint, UniversalJoint, WeldJoint, WheelJoint,
};
use crate::error::{Error, ErrorCode, Result};
use crate::world::{JointRef, World};
use core::ffi::c_void;

/// The parameters of one kind of joint.
pub(super) trait Kind: Copy {
    /// As it is called in sentences.
    const NAME: &'static str;
    fn of(kind: &JointKind) -> Option<Self>;
    fn wrapped(self) -> JointKind;
}

macro_rules! kinds {
    ($($t:ident = $variant:ident, $name:literal;)+) => {$(
        impl Kind for $t {
            const NAME: &'static str = $name;
            fn of(kind: &JointKind) -> Option<Self> {
                if let JointKind::$variant(j) = kind { Some(*j) } else { None }
            }
            fn wrapped(self) -> JointKind {
                JointKind::$variant(self)
            }
        }
    )+};
}

kinds! {
    DistanceJoint = Distance, "distance";
    MotorJoint = Motor, "motor";
    ParallelJoint = Parallel, "parallel";
    PrismaticJoint = Prismatic, "prismatic";
    PulleyJoint = Pulley, "pulley";
    RevoluteJoint = Revolute, "revolute";
    ScrewJoint = Screw, "screw";
    SixDofJoint = SixDof, "six-axes";
    SphericalJoint = Spherical, "spherical";
    UniversalJoint = Universal, "universal";
    WeldJoint = Weld, "weld";
    WheelJoint = Wheel, "wheel";
}

/// A gear, told from a rack and pinion.
#[derive(Clone, Copy)]
pub(super) struct Gear(pub GearJoint);

/// A rack and pinion, told from a gear.
#[derive(Clone, Copy)]
pub(super) struct RackPinion(pub GearJoint);

macro_rules! gears {
    ($($t:ident, $name:literal;)+) => {$(
        impl Kind for $t {
            const NAME: &'static str = $name;
            fn of(kind: &JointKind) -> Option<Self> {
                if let JointKind::$t(j) = kind { Some(Self(*j)) } else { None }
            }
            fn wrapped(self) -> JointKind {
                JointKind::$t(self.0)
            }
        }
    )+};
}

gears! {
    Gear, "gear";
    RackPinion, "rack-and-pinion";
}

/// The name of a joint in sentences.
fn name(kind: &JointKind) -> &'static str {
    match kind {
        JointKind::SixDof(_) => SixDofJoint::NAME,
        JointKind::RackPinion(_) => RackPinion::NAME,
        other => other.name(),
    }
}

fn wanted<K: Kind>(joint: JointRef<'_>) -> Result<K> {
    K::of(joint.kind()).ok_or_else(|| {
        let (is, not) = (name(joint.kind()), K::NAME);
        Error::new(ErrorCode::Range, format!("The joint is a {is} joint, not a {not} joint."))
    })
}

/// Reads a joint of the kind that the closure's first argument names.
pub(super) fn get<K: Kind, R: Neutral>(id: mvJointId, f: impl FnOnce(&K, JointRef<'_>) -> Result<R>) -> R {
    read_joint(id, |r| f(&wanted(r)?, r))
}

/// Changes a joint of the kind that the closure's argument names; everything is checked before anything changes.
pub(super) fn set<K: Kind>(id: mvJointId, f: impl FnOnce(&mut K) -> Result<()>) {
    write_joint(id, |mut j| {
        let mut kind: K = wanted(j.as_ref())?;
        f(&mut kind)?;
        j.set_kind(kind.wrapped())
    });
}

/// Creates a joint.
pub(super) fn create(
    world: mvWorldId,
    f: impl FnOnce(&World) -> Result<(mvJointDef, JointKind)>,
) -> mvJointId {
    write_world(world, |e| {
        let (base, kind) = f(e.world)?;
        e.world.create_joint(&base.with(kind)?).map(Into::into)
    })
}

/// Destroy a joint, with the gears that run on it.
/// @param jointId the joint
/// @param wakeAttached whether its bodies wake
/// @note Errors: mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvDestroyJoint(joint_id: mvJointId, wake_attached: Flag) {
    edit_at_joint(joint_id, |e| {
        e.world.joint(joint_id.into())?;
        e.world.destroy_joint(joint_id.into(), flag("wakeAttached", wake_attached)?)
    });
}

/// Does this id name a joint that lives? Never fails; false also while another thread changes the world.
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_IsValid(id: mvJointId) -> bool {
    is_joint(id)
}

/// Get what a joint is.
/// @param jointId the joint
/// @return one of the mv_...Joint constants; mv_parallelJoint, which is 0, for a bad joint
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_GetType(joint_id: mvJointId) -> mvJointType {
    read_joint(joint_id, |j| {
        Ok(match j.kind() {
            JointKind::Parallel(_) => mv_parallelJoint,
            JointKind::Distance(_) => mv_distanceJoint,
            JointKind::Filter => mv_filterJoint,
            JointKind::Motor(_) => mv_motorJoint,
            JointKind::Prismatic(_) => mv_prismaticJoint,
            JointKind::Revolute(_) => mv_revoluteJoint,
            JointKind::Spherical(_) => mv_sphericalJoint,
            JointKind::Weld(_) => mv_weldJoint,
            JointKind::Wheel(_) => mv_wheelJoint,
            JointKind::Universal(_) => mv_universalJoint,
            JointKind::SixDof(_) => mv_sixDofJoint,
            JointKind::Gear(_) => mv_gearJoint,
            JointKind::RackPinion(_) => mv_rackPinionJoint,
            JointKind::Pulley(_) => mv_pulleyJoint,
            JointKind::Screw(_) => mv_screwJoint,
        })
    })
}

/// Get the first body of a joint.
/// @param jointId the joint
/// @return body A; of a gear that of its first joint; null for a bad joint
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_GetBodyA(joint_id: mvJointId) -> mvBodyId {
    read_joint(joint_id, |j| Ok(j.body_a().into()))
}

/// Get the second body of a joint.
/// @param jointId the joint
/// @return body B; of a gear that of its first joint; null for a bad joint
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_GetBodyB(joint_id: mvJointId) -> mvBodyId {
    read_joint(joint_id, |j| Ok(j.body_b().into()))
}

/// Get the world that a joint lives in.
/// @param jointId the joint
/// @return the world; null for a bad joint
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_GetWorld(joint_id: mvJointId) -> mvWorldId {
    read_joint(joint_id, |_| Ok(registry::world_id(joint_id.world0)))
}

/// Move frame A of a joint in body A. Where the frames do not fit each other, the joint pulls them together.
/// @param jointId the joint
/// @param localFrame where the frame is, from the body's origin
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_SetLocalFrameA(joint_id: mvJointId, local_frame: mvTransform) {
    write_joint(joint_id, |mut j| j.set_local_frame_a(&local_frame.raw()));
}

/// Get frame A of a joint.
/// @param jointId the joint
/// @return where the frame is, from the origin of body A; the identity for a bad joint
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_GetLocalFrameA(joint_id: mvJointId) -> mvTransform {
    read_joint(joint_id, |j| Ok(j.local_frame_a().into()))
}

/// Move frame B of a joint in body B. Where the frames do not fit each other, the joint pulls them together.
/// @param jointId the joint
/// @param localFrame where the frame is, from the body's origin
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_SetLocalFrameB(joint_id: mvJointId, local_frame: mvTransform) {
    write_joint(joint_id, |mut j| j.set_local_frame_b(&local_frame.raw()));
}

/// Get frame B of a joint.
/// @param jointId the joint
/// @return where the frame is, from the origin of body B; the identity for a bad joint
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_GetLocalFrameB(joint_id: mvJointId) -> mvTransform {
    read_joint(joint_id, |j| Ok(j.local_frame_b().into()))
}

/// Let the bodies of a joint collide with each other, or not.
/// @param jointId the joint
/// @param shouldCollide whether they collide
/// @note Errors: mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_SetCollideConnected(joint_id: mvJointId, should_collide: Flag) {
    write_joint(joint_id, |mut j| {
        j.set_collide_connected(flag("shouldCollide", should_collide)?);
        Ok(())
    });
}

/// Do the bodies of a joint collide with each other?
/// @param jointId the joint
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_GetCollideConnected(joint_id: mvJointId) -> bool {
    read_joint(joint_id, |j| Ok(j.collide_connected()))
}

/// Set the user data of a joint.
/// @param jointId the joint
/// @param userData anything; it is never followed
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_SetUserData(joint_id: mvJointId, user_data: *mut c_void) {
    write_joint(joint_id, |mut j| {
        j.set_user_data(to_word(user_data));
        Ok(())
    });
}

/// Get the user data of a joint.
/// @param jointId the joint
/// @return what was set; null for a bad joint
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_GetUserData(joint_id: mvJointId) -> *mut c_void {
    read_joint(joint_id, |j| Ok(from_word(j.user_data())))
}

/// Wake the bodies of a joint.
/// @param jointId the joint
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_WakeBodies(joint_id: mvJointId) {
    write_joint(joint_id, |mut j| {
        j.wake_bodies();
        Ok(())
    });
}

/// Get the force of a joint on body B; body A has the opposite.
/// @param jointId the joint
/// @return the mean over the last step, in world axes [N]; zero for a bad joint
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_GetConstraintForce(joint_id: mvJointId) -> mvVec3 {
    read_joint(joint_id, |j| Ok(j.constraint_force().into()))
}

/// Get the torque of a joint on body B, about the origin of frame B.
/// @param jointId the joint
/// @return the mean over the last step, in world axes [N m]; zero for a bad joint
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_GetConstraintTorque(joint_id: mvJointId) -> mvVec3 {
    read_joint(joint_id, |j| Ok(j.constraint_torque().into()))
}

/// Get by how much a joint fails to hold lengths. Springs do not count, limits only where they are exceeded.
/// @param jointId the joint
/// @return the error [m], >= 0; 0 for a bad joint
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_GetLinearSeparation(joint_id: mvJointId) -> mvFloat {
    read_joint(joint_id, |j| Ok(j.linear_separation()))
}

/// Get by how much a joint fails to hold angles. Springs do not count, limits only where they are exceeded.
/// @param jointId the joint
/// @return the error [rad], >= 0; 0 for a bad joint
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_GetAngularSeparation(joint_id: mvJointId) -> mvFloat {
    read_joint(joint_id, |j| Ok(j.angular_separation()))
}

/// Set how stiffly a joint holds what it holds.
/// @param jointId the joint
/// @param hertz the stiffness [Hz], >= 0; 0 is rigid
/// @param dampingRatio the damping ratio, >= 0
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_SetConstraintTuning(joint_id: mvJointId, hertz: mvFloat, damping_ratio: mvFloat) {
    write_joint(joint_id, |mut j| j.set_constraint_tuning(hertz, damping_ratio));
}

/// Get how stiffly a joint holds what it holds.
/// @param jointId the joint
/// @param hertz where to write the stiffness [Hz], 0 for rigid; may be null
/// @param dampingRatio where to write the damping ratio; may be null
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_GetConstraintTuning(
    joint_id: mvJointId,
    hertz: Option<&mut mvFloat>,
    damping_ratio: Option<&mut mvFloat>,
) {
    read_joint(joint_id, |j| {
        let tuning = j.constraint_tuning();
        hertz.into_iter().for_each(|x| *x = tuning.0);
        damping_ratio.into_iter().for_each(|x| *x = tuning.1);
        Ok(())
    });
}

/// Set the force above which a joint makes an event.
/// @param jointId the joint
/// @param threshold the force [N], >= 0; infinity for none
/// @note Errors: mv_errorRange, also for NaN.
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_SetForceThreshold(joint_id: mvJointId, threshold: mvFloat) {
    write_joint(joint_id, |mut j| {
        let torque = j.as_ref().thresholds().1;
        j.set_thresholds(threshold, torque)
    });
}

/// Get the force above which a joint makes an event.
/// @param jointId the joint
/// @return the force [N], infinity for none; 0 for a bad joint
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_GetForceThreshold(joint_id: mvJointId) -> mvFloat {
    read_joint(joint_id, |j| Ok(j.thresholds().0))
}

/// Set the torque above which a joint makes an event.
/// @param jointId the joint
/// @param threshold the torque [N m], >= 0; infinity for none
/// @note Errors: mv_errorRange, also for NaN.
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_SetTorqueThreshold(joint_id: mvJointId, threshold: mvFloat) {
    write_joint(joint_id, |mut j| {
        let force = j.as_ref().thresholds().0;
        j.set_thresholds(force, threshold)
    });
}

/// Get the torque above which a joint makes an event.
/// @param jointId the joint
/// @return the torque [N m], infinity for none; 0 for a bad joint
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_GetTorqueThreshold(joint_id: mvJointId) -> mvFloat {
    read_joint(joint_id, |j| Ok(j.thresholds().1))
}

/// Let a joint break at the end of a step in which it made an event, or not.
/// @param jointId the joint
/// @param flag whether it breaks
/// @note Errors: mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_SetBreakable(joint_id: mvJointId, flag: Flag) {
    write_joint(joint_id, |mut j| {
        j.set_breakable(super::def_check::flag("flag", flag)?);
        Ok(())
    });
}

/// Does a joint break where it makes an event?
/// @param jointId the joint
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_IsBreakable(joint_id: mvJointId) -> bool {
    read_joint(joint_id, |j| Ok(j.is_breakable()))
}

/// Get the size of a joint in drawings.
/// @param jointId the joint
/// @return the size [m]; 0 for a bad joint
#[unsafe(no_mangle)]
pub extern "C" fn mvJoint_GetDrawScale(joint_id: mvJointId) -> mvFloat {
    read_joint(joint_id, |j| Ok(j.draw_scale()))
}
