//! Shapes: geometry in a frame of its own, shared by bodies and by queries without a world.
//!
//! The contract of a shape: validated construction, mass properties, a bounding box, a support function over a
//! core of points with a radius, faces for manifolds. Shapes know nothing of bodies.
//!
//! | shape | core points | radius | faces |
//! |---|---|---|---|
//! | [`Sphere`] | 1 | yes | – |
//! | [`Capsule`] | 2 | yes | – |
//! | [`Cuboid`] | 8, implicit | 0 | 6 |
//! | [`Hull`] | 4 … 255 | 0 | 4 … 506 |
//! | [`HalfSpace`] | – | – | 1, unbounded |

mod capsule;
mod core;
pub(crate) mod cuboid;
mod half_space;
mod hull;
mod mass;
mod polytope;
mod ray;
mod sphere;
#[cfg(test)]
pub(crate) mod testing;
#[cfg(test)]
mod tests;

use crate::error::{Error, Result, expect};
use crate::math::{Aabb, Float, Pose, Vec3};
use std::sync::Arc;

pub use self::core::{Core, CorePoints};
pub use capsule::Capsule;
pub use cuboid::Cuboid;
pub use half_space::HalfSpace;
pub use hull::{Hull, HullFace, MAX_HULL_VERTICES};
pub use mass::MassData;
pub use polytope::Edge;
pub(crate) use polytope::{EdgeRay, Polytope};
pub use ray::RayHit;
pub(crate) use ray::{Wide, narrow, wide};
pub use sphere::Sphere;

/// A solid, placed in a frame of its own. Cheap to clone: a hull's data are shared.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A ball.
    Sphere(Sphere),
    /// All points within a radius of a segment.
    Capsule(Capsule),
    /// A box, centred on the frame's origin with its axes along the frame's.
    Box(Cuboid),
    /// The convex hull of a point cloud.
    Hull(Arc<Hull>),
    /// Everything on one side of a plane. Static bodies only: it has no mass.
    HalfSpace(HalfSpace),
}

/// Runs the same expression on whichever shape it is.
macro_rules! each {
    ($shape:expr, $s:ident => $body:expr) => {
        match $shape {
            Shape::Sphere($s) => $body,
            Shape::Capsule($s) => $body,
            Shape::Box($s) => $body,
            Shape::Hull($s) => $body,
            Shape::HalfSpace($s) => $body,
        }
    };
}

impl Shape {
    /// A box of these full side lengths along x, y and z \[m\], centred on the origin.
    ///
    /// # Panics
    /// With the error's sentence, where [`Shape::try_new_box`] fails.
    #[must_use]
    #[track_caller]
    pub fn new_box(width: Float, height: Float, depth: Float) -> Self {
        expect(Self::try_new_box(width, height, depth))
    }

    /// A ball of this diameter \[m\], centred on the origin.
    ///
    /// # Panics
    /// With the error's sentence, where [`Shape::try_new_sphere`] fails.
    #[must_use]
    #[track_caller]
    pub fn new_sphere(diameter: Float) -> Self {
        expect(Self::try_new_sphere(diameter))
    }

    /// A capsule along y, centred on the origin: `length` between the centres of its caps, and `diameter` \[m\].
    ///
    /// # Panics
    /// With the error's sentence, where [`Shape::try_new_capsule`] fails.
    #[must_use]
    #[track_caller]
    pub fn new_capsule(length: Float, diameter: Float) -> Self {
        expect(Self::try_new_capsule(length, diameter))
    }

    /// A box of these full side lengths \[m\].
    ///
    /// # Errors
    /// A side is not finite, shorter than 2 × [`MIN_SIZE`](crate::math::tolerance::MIN_SIZE) or too long.
    pub fn try_new_box(width: Float, height: Float, depth: Float) -> Result<Self> {
        Cuboid::new(Vec3::new(width, height, depth) * 0.5).map(Self::Box)
    }

    /// A ball of this diameter \[m\], centred on the origin.
    ///
    /// # Errors
    /// The diameter is not finite, less than 2 × [`MIN_SIZE`](crate::math::tolerance::MIN_SIZE) or too great.
    pub fn try_new_sphere(diameter: Float) -> Result<Self> {
        Sphere::new(Vec3::zeros(), diameter * 0.5).map(Self::Sphere)
    }

    /// A capsule along y, centred on the origin: `length` between the centres of its caps, and `diameter` \[m\].
    ///
    /// # Errors
    /// A number is not finite, the length is below [`MIN_SIZE`](crate::math::tolerance::MIN_SIZE) (take a
    /// sphere), the diameter below twice that, or one is too great.
    pub fn try_new_capsule(length: Float, diameter: Float) -> Result<Self> {
        let end = Vec3::new(0.0, length * 0.5, 0.0);
        Capsule::new(-end, end, diameter * 0.5).map(Self::Capsule)
    }

    /// The convex hull of `points` \[m\], at most [`MAX_HULL_VERTICES`] vertices.
    ///
    /// # Errors
    /// See [`Hull::new`].
    pub fn hull(points: &[Vec3]) -> Result<Self> {
        Hull::new(points).map(|h| Self::Hull(Arc::new(h)))
    }

    /// Everything below a plane: all x with `normal · x ≤ offset` (`normal` of any length, scaled to 1;
    /// `offset` \[m\] along the scaled normal).
    ///
    /// # Errors
    /// A number is not finite, the normal has no length or the offset is too great.
    pub fn half_space(normal: Vec3, offset: Float) -> Result<Self> {
        HalfSpace::new(normal, offset).map(Self::HalfSpace)
    }

    /// Mass, centre of mass and inertia at this density \[kg/m³\], exact for the solid. A half-space has none:
    /// all zero.
    #[must_use]
    pub fn mass_data(&self, density: Float) -> MassData {
        each!(self, s => s.mass_data(density))
    }

    /// The volume \[m³\]; 0 for a half-space, which has no bounded one.
    #[must_use]
    pub fn volume(&self) -> Float {
        each!(self, s => s.volume())
    }

    /// The least axis-aligned box around the shape placed by `world_from_shape`. That of a half-space reaches
    /// to [`MAX_COORDINATE`](crate::math::tolerance::MAX_COORDINATE), and to the plane where that is
    /// axis-aligned.
    #[must_use]
    #[inline]
    pub fn aabb(&self, world_from_shape: &Pose) -> Aabb {
        each!(self, s => s.aabb(world_from_shape))
    }

    /// How thin the shape is \[m\]: the radius of the ball around its centre that just fits in. What moves less
    /// than this in a step cannot pass through unseen.
    #[must_use]
    pub fn inner_radius(&self) -> Float {
        each!(self, s => s.inner_radius())
    }

    /// The greatest distance of a point of the shape from the point `from` of its frame \[m\];
    /// [`MAX_COORDINATE`](crate::math::tolerance::MAX_COORDINATE) for a half-space.
    #[must_use]
    pub fn outer_radius(&self, from: Vec3) -> Float {
        each!(self, s => s.outer_radius(from))
    }

    /// The point of the solid closest to `point`, both in the shape's frame; `point` itself where inside.
    #[must_use]
    pub fn closest_point(&self, point: Vec3) -> Vec3 {
        each!(self, s => s.closest_point(point))
    }

    /// Whether the solid (surface included) holds `point` of the shape's frame.
    #[must_use]
    pub fn contains(&self, point: Vec3) -> bool {
        each!(self, s => s.contains(point))
    }

    /// Where the ray from `origin` along `translation` first meets the surface, all in the shape's frame, within
    /// `max_fraction` ≥ 0 of the translation. A ray that starts inside hits at fraction 0 with a zero normal.
    #[must_use]
    pub fn ray_cast(&self, origin: Vec3, translation: Vec3, max_fraction: Float) -> Option<RayHit> {
        each!(self, s => s.ray_cast(origin, translation, max_fraction))
    }

    /// The radius about the shape's core points \[m\]; 0 for shapes without a rounding.
    #[must_use]
    pub fn rounding(&self) -> Float {
        self.core().map_or(0.0, |core| core.radius)
    }

    /// The shape as core points and a radius; `None` for a half-space, which has no such form.
    #[must_use]
    #[inline]
    pub fn core(&self) -> Option<Core<'_>> {
        Some(match self {
            Self::Sphere(s) => Core { points: CorePoints::One(s.center()), radius: s.radius() },
            Self::Capsule(c) => {
                Core { points: CorePoints::Two([c.center1(), c.center2()]), radius: c.radius() }
            }
            Self::Box(b) => Core { points: CorePoints::Box(b.half()), radius: 0.0 },
            Self::Hull(h) => Core { points: CorePoints::Hull(h), radius: 0.0 },
            Self::HalfSpace(_) => return None,
        })
    }
}

/// An error of the kind `Degenerate`.
fn degenerate(sentence: impl Into<std::borrow::Cow<'static, str>>) -> Error {
    Error::new(crate::error::ErrorCode::Degenerate, sentence)
}

/// A size (radius, half extent, length) in [`MIN_SIZE`](crate::math::tolerance::MIN_SIZE) … `MAX_COORDINATE`.
fn check_size(name: &str, x: Float) -> Result<Float> {
    use crate::error::{ErrorCode, check};
    use crate::math::tolerance::{MAX_COORDINATE, MIN_SIZE};
    let x = check::positive(name, x)?;
    if x < MIN_SIZE {
        return Err(degenerate(format!("{name} is {x} m; it must be at least {MIN_SIZE} m.")));
    }
    if x > MAX_COORDINATE {
        return Err(Error::new(
            ErrorCode::Range,
            format!("{name} is {x} m; it must be at most {MAX_COORDINATE} m."),
        ));
    }
    Ok(x)
}
