use super::{MassData, RayHit, degenerate, ray};
use crate::error::{Error, ErrorCode, Result, check};
use crate::math::scalar::double;
use crate::math::tolerance::MAX_COORDINATE;
use crate::math::{Aabb, Float, Pose, Vec3, length, vec3};

/// Everything on one side of a plane: all x with `normal · x ≤ offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfSpace {
    normal: Vec3,
    offset: Float,
}

impl HalfSpace {
    /// The side of the plane away from `normal` (any length, scaled to 1), `offset` \[m\] from the origin.
    ///
    /// # Errors
    /// A number is not finite, the normal has no length, or the offset is too great.
    pub fn new(normal: Vec3, offset: Float) -> Result<Self> {
        let n = check::finite_vec("The half-space's normal", normal)?;
        check::finite("The half-space's offset", offset)?;
        let largest = n.amax();
        if largest <= 0.0 {
            return Err(degenerate("The half-space's normal is zero; it must have a direction."));
        }
        if offset.abs() > MAX_COORDINATE {
            let sentence =
                format!("The half-space's offset is {offset} m; it must lie within ±{MAX_COORDINATE} m.");
            return Err(Error::new(ErrorCode::Range, sentence));
        }
        // Scaled by its largest component first, so that no square over- or underflows.
        let n = n / largest;
        Ok(Self { normal: n / length(n), offset })
    }

    /// The outward unit normal.
    #[must_use]
    #[inline(always)]
    pub fn normal(&self) -> Vec3 {
        self.normal
    }

    /// The distance of the plane from the origin along the normal \[m\].
    #[must_use]
    #[inline(always)]
    pub fn offset(&self) -> Float {
        self.offset
    }

    /// The height of `p` above the plane \[m\].
    #[must_use]
    #[inline(always)]
    pub fn height(&self, p: Vec3) -> Float {
        self.normal.dot(&p) - self.offset
    }

    pub(super) fn volume(&self) -> Float {
        0.0
    }

    pub(super) fn mass_data(&self, _density: Float) -> MassData {
        MassData::ZERO
    }

    /// Of the corners of the world's box, those over the lowest part of the plane bound each coordinate.
    pub(super) fn aabb(&self, pose: &Pose) -> Aabb {
        const END: Float = MAX_COORDINATE;
        let n = pose.vector(self.normal);
        let offset = self.offset + n.dot(&pose.p);
        let mut b = Aabb::around(Vec3::zeros(), vec3(END, END, END));
        for k in 0..3 {
            let tilt = END * (n[(k + 1) % 3].abs() + n[(k + 2) % 3].abs());
            let reach = (offset + tilt) / n[k];
            if n[k] > 0.0 {
                b.upper[k] = reach.clamp(-END, END);
            } else if n[k] < 0.0 {
                b.lower[k] = reach.clamp(-END, END);
            }
        }
        b
    }

    pub(super) fn inner_radius(&self) -> Float {
        MAX_COORDINATE
    }

    pub(super) fn outer_radius(&self, _from: Vec3) -> Float {
        MAX_COORDINATE
    }

    pub(super) fn closest_point(&self, p: Vec3) -> Vec3 {
        p - self.normal * self.height(p).max(0.0)
    }

    pub(super) fn contains(&self, p: Vec3) -> bool {
        self.height(p) <= 0.0
    }

    pub(super) fn ray_cast(&self, origin: Vec3, translation: Vec3, max_fraction: Float) -> Option<RayHit> {
        if self.contains(origin) {
            return Some(RayHit::inside(origin));
        }
        let n = ray::wide(self.normal);
        let height = n.dot(&ray::wide(origin)) - double(self.offset);
        let fall = -n.dot(&ray::wide(translation));
        if fall <= 0.0 {
            return None;
        }
        RayHit::at(origin, translation, (height / fall).max(0.0), max_fraction, |_| self.normal)
    }
}
