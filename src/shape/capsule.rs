use super::{MassData, RayHit, check_size, degenerate, ray};
use crate::error::{Result, check};
use crate::math::scalar::{PI, double};
use crate::math::tolerance::MIN_SIZE;
use crate::math::{Aabb, Float, Mat3, Pose, Vec3, length, length_squared, max, min, vec3};

/// All points within a radius of a segment. The segment must have a length: a capsule whose caps coincide is
/// refused, it is a [`Sphere`](super::Sphere).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Capsule {
    center1: Vec3,
    center2: Vec3,
    radius: Float,
}

impl Capsule {
    /// A capsule with these cap centres and this radius \[m\], in the shape's frame.
    ///
    /// # Errors
    /// A centre is not finite or too far out, the radius is not a valid size, or the centres lie closer than
    /// [`MIN_SIZE`].
    pub fn new(center1: Vec3, center2: Vec3, radius: Float) -> Result<Self> {
        let center1 = check::point("The capsule's first centre", center1)?;
        let center2 = check::point("The capsule's second centre", center2)?;
        let radius = check_size("The capsule's radius", radius)?;
        if length(center2 - center1) < MIN_SIZE {
            return Err(degenerate(format!(
                "The capsule's centres are less than {MIN_SIZE} m apart; a sphere is the right shape."
            )));
        }
        Ok(Self { center1, center2, radius })
    }

    /// The centre of the first cap \[m\].
    #[must_use]
    #[inline(always)]
    pub fn center1(&self) -> Vec3 {
        self.center1
    }

    /// The centre of the second cap \[m\].
    #[must_use]
    #[inline(always)]
    pub fn center2(&self) -> Vec3 {
        self.center2
    }

    /// The radius \[m\].
    #[must_use]
    #[inline(always)]
    pub fn radius(&self) -> Float {
        self.radius
    }

    /// The point of the segment closest to `p`.
    #[inline(always)]
    pub(crate) fn on_segment(&self, p: Vec3) -> Vec3 {
        let d = self.center2 - self.center1;
        self.center1 + d * ((p - self.center1).dot(&d) / length_squared(d)).clamp(0.0, 1.0)
    }

    pub(super) fn volume(&self) -> Float {
        let r = self.radius;
        PI * r * r * (length(self.center2 - self.center1) + r * (4.0 / 3.0))
    }

    /// A cylinder and two half balls. A half ball's centre of mass lies 3/8 r from its flat side, which turns
    /// the parallel-axis terms of both caps about the middle into m_s (l²/4 + 3/8 l r).
    pub(super) fn mass_data(&self, density: Float) -> MassData {
        let (r, d) = (self.radius, self.center2 - self.center1);
        let l = length(d);
        let cylinder = density * PI * r * r * l;
        let ball = density * 4.0 / 3.0 * PI * r * r * r;
        let along = (0.5 * cylinder + 0.4 * ball) * r * r;
        let across =
            cylinder * (3.0 * r * r + l * l) / 12.0 + ball * (0.4 * r * r + 0.25 * l * l + 0.375 * l * r);
        let u = d / l;
        MassData {
            mass: cylinder + ball,
            center: (self.center1 + self.center2) * 0.5,
            inertia: Mat3::from_diagonal(&vec3(across, across, across))
                + u * u.transpose() * (along - across),
        }
    }

    #[inline]
    pub(super) fn aabb(&self, pose: &Pose) -> Aabb {
        let (p, q) = (pose.point(self.center1), pose.point(self.center2));
        Aabb { lower: min(p, q), upper: max(p, q) }.grown(self.radius)
    }

    pub(super) fn inner_radius(&self) -> Float {
        self.radius
    }

    pub(super) fn outer_radius(&self, from: Vec3) -> Float {
        length(self.center1 - from).max(length(self.center2 - from)) + self.radius
    }

    pub(super) fn closest_point(&self, p: Vec3) -> Vec3 {
        let on_axis = self.on_segment(p);
        let d = p - on_axis;
        let l = length(d);
        if l <= self.radius { p } else { on_axis + d * (self.radius / l) }
    }

    pub(super) fn contains(&self, p: Vec3) -> bool {
        length_squared(p - self.on_segment(p)) <= self.radius * self.radius
    }

    /// The ray enters through the cylinder if that point lies between the caps, else through a cap.
    pub(super) fn ray_cast(&self, origin: Vec3, translation: Vec3, max_fraction: Float) -> Option<RayHit> {
        if self.contains(origin) {
            return Some(RayHit::inside(origin));
        }
        let (o, d, r) = (ray::wide(origin - self.center1), ray::wide(translation), double(self.radius));
        let axis = ray::wide(self.center2 - self.center1);
        let l2 = axis.dot(&axis);
        let (flat_o, flat_d) = (o - axis * (o.dot(&axis) / l2), d - axis * (d.dot(&axis) / l2));
        let side = ray::enter_ball(flat_o, flat_d, r).filter(|t| {
            let h = (o + d * *t).dot(&axis);
            // A start inside the infinite cylinder clamps to 0: that is no entry through its side.
            (0.0..=l2).contains(&h) && flat_o.dot(&flat_o) >= r * r
        });
        let caps = [ray::enter_ball(o, d, r), ray::enter_ball(o - axis, d, r)];
        let t = side.into_iter().chain(caps.into_iter().flatten()).reduce(f64::min)?;
        RayHit::at(origin, translation, t, max_fraction, |p| p - self.on_segment(p))
    }
}
