use super::{MassData, RayHit, check_size, ray};
use crate::error::{Result, check};
use crate::math::scalar::{PI, double};
use crate::math::{Aabb, Float, Mat3, Pose, Vec3, length, length_squared, vec3};

/// A ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    center: Vec3,
    radius: Float,
}

impl Sphere {
    /// A ball with this centre and radius \[m\], in the shape's frame.
    ///
    /// # Errors
    /// The centre is not finite or too far out, or the radius is not a valid size.
    pub fn new(center: Vec3, radius: Float) -> Result<Self> {
        Ok(Self {
            center: check::point("The sphere's centre", center)?,
            radius: check_size("The sphere's radius", radius)?,
        })
    }

    /// The centre \[m\].
    #[must_use]
    #[inline(always)]
    pub fn center(&self) -> Vec3 {
        self.center
    }

    /// The radius \[m\].
    #[must_use]
    #[inline(always)]
    pub fn radius(&self) -> Float {
        self.radius
    }

    pub(super) fn volume(&self) -> Float {
        4.0 / 3.0 * PI * self.radius * self.radius * self.radius
    }

    pub(super) fn mass_data(&self, density: Float) -> MassData {
        let mass = density * self.volume();
        let i = 0.4 * mass * self.radius * self.radius;
        MassData { mass, center: self.center, inertia: Mat3::from_diagonal(&vec3(i, i, i)) }
    }

    #[inline]
    pub(super) fn aabb(&self, pose: &Pose) -> Aabb {
        Aabb::around(pose.point(self.center), vec3(self.radius, self.radius, self.radius))
    }

    pub(super) fn inner_radius(&self) -> Float {
        self.radius
    }

    pub(super) fn outer_radius(&self, from: Vec3) -> Float {
        length(self.center - from) + self.radius
    }

    pub(super) fn closest_point(&self, p: Vec3) -> Vec3 {
        let d = p - self.center;
        let l = length(d);
        if l <= self.radius { p } else { self.center + d * (self.radius / l) }
    }

    pub(super) fn contains(&self, p: Vec3) -> bool {
        length_squared(p - self.center) <= self.radius * self.radius
    }

    pub(super) fn ray_cast(&self, origin: Vec3, translation: Vec3, max_fraction: Float) -> Option<RayHit> {
        if self.contains(origin) {
            return Some(RayHit::inside(origin));
        }
        let t =
            ray::enter_ball(ray::wide(origin - self.center), ray::wide(translation), double(self.radius))?;
        RayHit::at(origin, translation, t, max_fraction, |p| p - self.center)
    }
}
