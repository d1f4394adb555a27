//! Where bodies are and how they move.

use super::access::{read_body, write_body};
use super::def_check::flag;
use super::id::mvBodyId;
use super::math::{mvPos, mvQuat, mvVec3, mvWorldTransform};
use super::{Flag, mvFloat};
use crate::math::Pose;

/// Get the position of a body's origin.
/// @param bodyId the body
/// @return the position [m]; zero for a bad body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetPosition(body_id: mvBodyId) -> mvPos {
    read_body(body_id, |b| Ok(b.transform().p.into()))
}

/// Get the rotation of a body.
/// @param bodyId the body
/// @return the rotation; the identity for a bad body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetRotation(body_id: mvBodyId) -> mvQuat {
    read_body(body_id, |b| Ok(b.transform().q.into()))
}

/// Get where a body is: the position of its origin, and its rotation.
/// @param bodyId the body
/// @return the placement; the identity for a bad body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetTransform(body_id: mvBodyId) -> mvWorldTransform {
    read_body(body_id, |b| Ok(b.transform().into()))
}

/// Move a body at once, without regard for what is in the way. Its velocity stays; what it touched wakes up.
/// @param bodyId the body
/// @param position where its origin goes [m]
/// @param rotation its new rotation, of length 1
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_SetTransform(body_id: mvBodyId, position: mvPos, rotation: mvQuat) {
    write_body(body_id, |mut b| {
        b.set_transform(&Pose::new(position.point("position")?, rotation.rotation("rotation")?))
    });
}

/// Give a body the velocity that takes it to a placement in a given time. Meant for kinematic bodies.
/// @param bodyId the body
/// @param target where its origin shall go
/// @param timeStep in which time [s], > 0
/// @param wake whether to wake the body; a sleeping body is left alone otherwise
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_SetTargetTransform(
    body_id: mvBodyId,
    target: mvWorldTransform,
    time_step: mvFloat,
    wake: Flag,
) {
    write_body(body_id, |mut b| {
        let (target, wake) = (target.pose("target")?, flag("wake", wake)?);
        crate::error::check::positive("timeStep", time_step)?;
        if wake || b.as_ref().is_awake() { b.set_target_transform(&target, time_step) } else { Ok(()) }
    });
}

/// Get a point of the world as seen from a body.
/// @param bodyId the body
/// @param worldPoint the point [m]
/// @return the point in the body's frame; zero for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetLocalPoint(body_id: mvBodyId, world_point: mvPos) -> mvVec3 {
    read_body(body_id, |b| Ok(b.transform().point_back(world_point.point("worldPoint")?).into()))
}

/// Get a point of a body as seen from the world.
/// @param bodyId the body
/// @param localPoint the point in the body's frame [m]
/// @return the point in the world; zero for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetWorldPoint(body_id: mvBodyId, local_point: mvVec3) -> mvPos {
    read_body(body_id, |b| Ok(b.transform().point(local_point.point("localPoint")?).into()))
}

/// Get a vector of the world as seen from a body.
/// @param bodyId the body
/// @param worldVector the vector
/// @return the vector in the body's frame; zero for bad arguments
/// @note Errors: mv_errorNotFinite.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetLocalVector(body_id: mvBodyId, world_vector: mvVec3) -> mvVec3 {
    read_body(body_id, |b| Ok(b.transform().vector_back(world_vector.finite("worldVector")?).into()))
}

/// Get a vector of a body as seen from the world.
/// @param bodyId the body
/// @param localVector the vector in the body's frame
/// @return the vector in the world; zero for bad arguments
/// @note Errors: mv_errorNotFinite.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetWorldVector(body_id: mvBodyId, local_vector: mvVec3) -> mvVec3 {
    read_body(body_id, |b| Ok(b.transform().vector(local_vector.finite("localVector")?).into()))
}

/// Get the velocity of a point of a body.
/// @param bodyId the body
/// @param localPoint the point in the body's frame [m]
/// @return the velocity in world axes [m/s]; zero for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetLocalPointVelocity(body_id: mvBodyId, local_point: mvVec3) -> mvVec3 {
    read_body(body_id, |b| Ok(b.velocity_at(b.transform().point(local_point.point("localPoint")?)).into()))
}

/// Get the velocity of the point of a body that is at a point of the world.
/// @param bodyId the body
/// @param worldPoint the point [m]
/// @return the velocity in world axes [m/s]; zero for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetWorldPointVelocity(body_id: mvBodyId, world_point: mvPos) -> mvVec3 {
    read_body(body_id, |b| Ok(b.velocity_at(world_point.point("worldPoint")?).into()))
}

/// Get the velocity of a body's centre of mass.
/// @param bodyId the body
/// @return the velocity [m/s]; zero for a bad body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetLinearVelocity(body_id: mvBodyId) -> mvVec3 {
    read_body(body_id, |b| Ok(b.linear_velocity().into()))
}

/// Set the velocity of a body's centre of mass. Wakes the body unless it is zero; static bodies stay.
/// @param bodyId the body
/// @param linearVelocity the velocity [m/s]
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_SetLinearVelocity(body_id: mvBodyId, linear_velocity: mvVec3) {
    write_body(body_id, |mut b| b.set_linear_velocity(linear_velocity.raw()));
}

/// Get the angular velocity of a body.
/// @param bodyId the body
/// @return the angular velocity in world axes [rad/s]; zero for a bad body
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetAngularVelocity(body_id: mvBodyId) -> mvVec3 {
    read_body(body_id, |b| Ok(b.angular_velocity().into()))
}

/// Set the angular velocity of a body. Wakes the body unless it is zero; static bodies stay.
/// @param bodyId the body
/// @param angularVelocity the angular velocity in world axes [rad/s]
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_SetAngularVelocity(body_id: mvBodyId, angular_velocity: mvVec3) {
    write_body(body_id, |mut b| b.set_angular_velocity(angular_velocity.raw()));
}

/// Get the momentum of a body.
/// @param bodyId the body
/// @return the momentum [kg m/s]; zero for a body without mass or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetMomentum(body_id: mvBodyId) -> mvVec3 {
    read_body(body_id, |b| Ok(b.momentum().into()))
}

/// Set the momentum of a body. Bodies without mass are left alone.
/// @param bodyId the body
/// @param momentum the momentum [kg m/s]
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_SetMomentum(body_id: mvBodyId, momentum: mvVec3) {
    write_body(body_id, |mut b| b.set_momentum(momentum.raw()));
}

/// Get the angular momentum of a body about its centre of mass.
/// @param bodyId the body
/// @return the angular momentum in world axes [kg m^2/s]; zero for a body without inertia or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetAngularMomentum(body_id: mvBodyId) -> mvVec3 {
    read_body(body_id, |b| Ok(b.angular_momentum().into()))
}

/// Set the angular momentum of a body about its centre of mass. Bodies without inertia are left alone.
/// @param bodyId the body
/// @param angularMomentum the angular momentum in world axes [kg m^2/s]
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_SetAngularMomentum(body_id: mvBodyId, angular_momentum: mvVec3) {
    write_body(body_id, |mut b| b.set_angular_momentum(angular_momentum.raw()));
}

/// Get the energy of a body's translation and rotation.
/// @param bodyId the body
/// @return the energy [J]; 0 for a body without mass or a bad one
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_GetKineticEnergy(body_id: mvBodyId) -> mvFloat {
    read_body(body_id, |b| Ok(b.kinetic_energy()))
}

/// Add a force for the next step. Only awake dynamic bodies feel it.
/// @param bodyId the body
/// @param force the force in world axes [N]
/// @param point where it acts, in the world [m]
/// @param wake whether to wake the body first
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_ApplyForce(body_id: mvBodyId, force: mvVec3, point: mvPos, wake: Flag) {
    write_body(body_id, |mut b| b.apply_force(force.raw(), point.point("point")?, flag("wake", wake)?));
}

/// Add a force at the centre of mass for the next step. Only awake dynamic bodies feel it.
/// @param bodyId the body
/// @param force the force in world axes [N]
/// @param wake whether to wake the body first
/// @note Errors: mv_errorNotFinite.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_ApplyForceToCenter(body_id: mvBodyId, force: mvVec3, wake: Flag) {
    write_body(body_id, |mut b| b.apply_force_to_center(force.raw(), flag("wake", wake)?));
}

/// Add a torque for the next step. Only awake dynamic bodies feel it.
/// @param bodyId the body
/// @param torque the torque in world axes [N m]
/// @param wake whether to wake the body first
/// @note Errors: mv_errorNotFinite.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_ApplyTorque(body_id: mvBodyId, torque: mvVec3, wake: Flag) {
    write_body(body_id, |mut b| b.apply_torque(torque.raw(), flag("wake", wake)?));
}

/// Change the momentum of a body at once. Only awake dynamic bodies feel it.
/// @param bodyId the body
/// @param impulse the change in world axes [N s]
/// @param point where it acts, in the world [m]
/// @param wake whether to wake the body first
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_ApplyLinearImpulse(body_id: mvBodyId, impulse: mvVec3, point: mvPos, wake: Flag) {
    write_body(body_id, |mut b| {
        b.apply_linear_impulse(impulse.raw(), point.point("point")?, flag("wake", wake)?)
    });
}

/// Change the momentum of a body at once, at its centre of mass. Only awake dynamic bodies feel it.
/// @param bodyId the body
/// @param impulse the change in world axes [N s]
/// @param wake whether to wake the body first
/// @note Errors: mv_errorNotFinite.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_ApplyLinearImpulseToCenter(body_id: mvBodyId, impulse: mvVec3, wake: Flag) {
    write_body(body_id, |mut b| b.apply_linear_impulse_to_center(impulse.raw(), flag("wake", wake)?));
}

/// Change the angular momentum of a body at once. Only awake dynamic bodies feel it.
/// @param bodyId the body
/// @param impulse the change in world axes [N m s]
/// @param wake whether to wake the body first
/// @note Errors: mv_errorNotFinite.
#[unsafe(no_mangle)]
pub extern "C" fn mvBody_ApplyAngularImpulse(body_id: mvBodyId, impulse: mvVec3, wake: Flag) {
    write_body(body_id, |mut b| b.apply_angular_impulse(impulse.raw(), flag("wake", wake)?));
}
