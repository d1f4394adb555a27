//! Mass, boxes and rays of shapes without a world.

use super::guard::{call, needed, neutral};
use super::hull_data::{mvHullData, solid};
use super::math::{ORIGIN, ZERO3, mvAABB, mvPos, mvTransform, mvVec3};
use super::mvFloat;
use super::shape_data::{mvCapsule, mvMassData, mvSphere};
use crate::error::{Result, check};
use crate::math::{Float, Pose, Vec3};
use crate::shape::{RayHit, Shape};
use core::ffi::c_int;

/// A ray to be cast at a shape, in the shape's frame.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvRayCastInput {
    /// Where the ray starts [m].
    pub origin: mvVec3,
    /// From the start to the end of the ray [m].
    pub translation: mvVec3,
    /// The greatest fraction of the translation to consider, not negative; usually 1.
    pub max_fraction: mvFloat,
}

/// Where a ray or a moving shape hits a shape.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvCastOutput {
    /// The outward normal of the surface at the point, of length 1.
    pub normal: mvVec3,
    /// The point on the surface [m].
    pub point: mvVec3,
    /// The fraction of the translation travelled.
    pub fraction: mvFloat,
    /// The number of iterations used; 0 where the answer is a closed form.
    pub iterations: c_int,
    /// Whether there was a hit. If not, everything else is zero.
    pub hit: bool,
}

/// Where a ray or a moving shape hits a shape of a world.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvWorldCastOutput {
    /// The outward normal of the surface at the point, of length 1.
    pub normal: mvVec3,
    /// The point on the surface [m].
    pub point: mvPos,
    /// The fraction of the translation travelled.
    pub fraction: mvFloat,
    /// The number of iterations used; 0 where the answer is a closed form.
    pub iterations: c_int,
    /// Whether there was a hit. If not, everything else is zero.
    pub hit: bool,
}

pub(super) const NO_HIT: mvCastOutput =
    mvCastOutput { normal: ZERO3, point: ZERO3, fraction: 0.0, iterations: 0, hit: false };

neutral! {
    mvCastOutput = NO_HIT;
    mvWorldCastOutput =
        mvWorldCastOutput { normal: ZERO3, point: ORIGIN, fraction: 0.0, iterations: 0, hit: false };
}

/// Get mass, centre of mass and inertia of a solid sphere.
///
/// @param shape the sphere
/// @param density the density [kg/m^3], not negative
/// @return the exact figures; zero for bad arguments
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub extern "C" fn mvComputeSphereMass(shape: Option<&mvSphere>, density: mvFloat) -> mvMassData {
    call(|| mass(&Shape::Sphere(needed("The sphere", shape)?.solid()?), &Pose::IDENTITY, density))
}

/// Get mass, centre of mass and inertia of a solid capsule.
///
/// @param shape the capsule
/// @param density the density [kg/m^3], not negative
/// @return the exact figures; zero for bad arguments
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub extern "C" fn mvComputeCapsuleMass(shape: Option<&mvCapsule>, density: mvFloat) -> mvMassData {
    call(|| mass(&Shape::Capsule(needed("The capsule", shape)?.solid()?), &Pose::IDENTITY, density))
}

/// Get mass, centre of mass and inertia of a solid hull.
///
/// @param shape the hull
/// @param density the density [kg/m^3], not negative
/// @return the exact figures; zero for bad arguments
/// @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvComputeHullMass(shape: *const mvHullData, density: mvFloat) -> mvMassData {
    call(|| {
        // Sound: the caller passes a hull.
        let (shape, pose) = unsafe { solid(shape) }?;
        mass(&shape, &pose, density)
    })
}

/// Get the box around a placed sphere.
///
/// @param shape the sphere
/// @param transform where it is
/// @return the box; zero for bad arguments
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub extern "C" fn mvComputeSphereAABB(shape: Option<&mvSphere>, transform: mvTransform) -> mvAABB {
    call(|| {
        let shape = Shape::Sphere(needed("The sphere", shape)?.solid()?);
        Ok(shape.aabb(&transform.pose("transform")?).into())
    })
}

/// Get the box around a placed capsule.
///
/// @param shape the capsule
/// @param transform where it is
/// @return the box; zero for bad arguments
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub extern "C" fn mvComputeCapsuleAABB(shape: Option<&mvCapsule>, transform: mvTransform) -> mvAABB {
    call(|| {
        let shape = Shape::Capsule(needed("The capsule", shape)?.solid()?);
        Ok(shape.aabb(&transform.pose("transform")?).into())
    })
}

/// Get the box around a placed hull.
///
/// @param shape the hull
/// @param transform where it is
/// @return the box; zero for bad arguments
/// @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvComputeHullAABB(shape: *const mvHullData, transform: mvTransform) -> mvAABB {
    call(|| {
        // Sound: the caller passes a hull.
        let (shape, local) = unsafe { solid(shape) }?;
        Ok(shape.aabb(&transform.pose("transform")?.then(&local)).into())
    })
}

/// Can this ray be cast: are all its numbers finite and in range?
#[unsafe(no_mangle)]
pub extern "C" fn mvIsValidRay(input: Option<&mvRayCastInput>) -> bool {
    input.is_some_and(|i| ray(i).is_ok())
}

/// Cast a ray at a sphere. A ray that starts inside does not hit.
///
/// @param shape the sphere
/// @param input the ray, in the same frame
/// @return the first hit; no hit for bad arguments
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub extern "C" fn mvRayCastSphere(shape: Option<&mvSphere>, input: Option<&mvRayCastInput>) -> mvCastOutput {
    call(|| cast(&Shape::Sphere(needed("The sphere", shape)?.solid()?), &Pose::IDENTITY, input))
}

/// Cast a ray at a capsule. A ray that starts inside does not hit.
///
/// @param shape the capsule
/// @param input the ray, in the same frame
/// @return the first hit; no hit for bad arguments
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
#[unsafe(no_mangle)]
pub extern "C" fn mvRayCastCapsule(
    shape: Option<&mvCapsule>,
    input: Option<&mvRayCastInput>,
) -> mvCastOutput {
    call(|| cast(&Shape::Capsule(needed("The capsule", shape)?.solid()?), &Pose::IDENTITY, input))
}

/// Cast a ray at a hull. A ray that starts inside does not hit.
///
/// @param shape the hull
/// @param input the ray, in the same frame
/// @return the first hit; no hit for bad arguments
/// @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvRayCastHull(
    shape: *const mvHullData,
    input: Option<&mvRayCastInput>,
) -> mvCastOutput {
    call(|| {
        // Sound: the caller passes a hull.
        let (shape, pose) = unsafe { solid(shape) }?;
        cast(&shape, &pose, input)
    })
}

fn mass(shape: &Shape, pose: &Pose, density: Float) -> Result<mvMassData> {
    let density = check::not_negative("density", density)?;
    Ok(shape.mass_data(density).placed(pose).into())
}

fn ray(input: &mvRayCastInput) -> Result<(Vec3, Vec3, Float)> {
    Ok((
        input.origin.point("origin")?,
        input.translation.point("translation")?,
        check::not_negative("maxFraction", input.max_fraction)?,
    ))
}

fn cast(shape: &Shape, pose: &Pose, input: Option<&mvRayCastInput>) -> Result<mvCastOutput> {
    let (origin, translation, max_fraction) = ray(needed("The ray", input)?)?;
    let hit = shape.ray_cast(pose.point_back(origin), pose.vector_back(translation), max_fraction);
    Ok(hit.filter(from_outside).map_or(NO_HIT, |h| mvCastOutput {
        normal: pose.vector(h.normal).into(),
        point: pose.point(h.point).into(),
        fraction: h.fraction,
        iterations: 0,
        hit: true,
    }))
}

/// Whether the ray started outside: one that starts inside hits at once, without a normal.
pub(super) fn from_outside(hit: &RayHit) -> bool {
    hit.normal != Vec3::zeros()
}
