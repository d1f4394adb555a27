use super::{Float, Pose, Vec3, abs, max, min, rotation_matrix, vec3};

/// An axis-aligned box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// The least corner \[m\].
    pub lower: Vec3,
    /// The greatest corner \[m\].
    pub upper: Vec3,
}

impl Aabb {
    /// The empty box: the neutral element of [`Aabb::union`].
    pub const EMPTY: Aabb = Aabb {
        lower: Vec3::new(Float::MAX, Float::MAX, Float::MAX),
        upper: Vec3::new(-Float::MAX, -Float::MAX, -Float::MAX),
    };

    /// The box of this centre and these half extents, all ≥ 0.
    #[inline(always)]
    #[must_use]
    pub fn around(center: Vec3, half: Vec3) -> Self {
        Self { lower: center - half, upper: center + half }
    }

    /// The least box around `points`; [`Aabb::EMPTY`] for none.
    #[must_use]
    pub fn of_points(points: &[Vec3]) -> Self {
        points.iter().fold(Self::EMPTY, |b, &p| Self { lower: min(b.lower, p), upper: max(b.upper, p) })
    }

    /// The middle.
    #[inline(always)]
    #[must_use]
    pub fn center(&self) -> Vec3 {
        (self.lower + self.upper) * 0.5
    }

    /// Half the side lengths.
    #[inline(always)]
    #[must_use]
    pub fn half(&self) -> Vec3 {
        (self.upper - self.lower) * 0.5
    }

    /// The area of the surface \[m²\]: what a dynamic tree minimises.
    #[inline(always)]
    #[must_use]
    pub fn area(&self) -> Float {
        let d = self.upper - self.lower;
        2.0 * (d.x * d.y + d.y * d.z + d.z * d.x)
    }

    /// The least box around both.
    #[inline(always)]
    #[must_use]
    pub fn union(&self, other: &Aabb) -> Aabb {
        Aabb { lower: min(self.lower, other.lower), upper: max(self.upper, other.upper) }
    }

    /// Whether the boxes touch or overlap (closed boxes).
    #[inline(always)]
    #[must_use]
    pub fn overlaps(&self, other: &Aabb) -> bool {
        self.lower.x <= other.upper.x
            && other.lower.x <= self.upper.x
            && self.lower.y <= other.upper.y
            && other.lower.y <= self.upper.y
            && self.lower.z <= other.upper.z
            && other.lower.z <= self.upper.z
    }

    /// Whether `inner` lies inside.
    #[inline(always)]
    #[must_use]
    pub fn contains(&self, inner: &Aabb) -> bool {
        self.lower.x <= inner.lower.x
            && self.lower.y <= inner.lower.y
            && self.lower.z <= inner.lower.z
            && inner.upper.x <= self.upper.x
            && inner.upper.y <= self.upper.y
            && inner.upper.z <= self.upper.z
    }

    /// The box grown by `margin` on every side.
    #[inline(always)]
    #[must_use]
    pub fn grown(&self, margin: Float) -> Aabb {
        let m = vec3(margin, margin, margin);
        Aabb { lower: self.lower - m, upper: self.upper + m }
    }

    /// The box swept along `d`.
    #[inline(always)]
    #[must_use]
    pub fn swept(&self, d: Vec3) -> Aabb {
        Aabb { lower: min(self.lower, self.lower + d), upper: max(self.upper, self.upper + d) }
    }

    /// The box around this box placed by `dst_from_src`.
    #[must_use]
    pub fn placed(&self, dst_from_src: &Pose) -> Aabb {
        let r = rotation_matrix(&dst_from_src.q);
        let (c, h) = (self.center(), self.half());
        let half = vec3(
            abs(r.row(0).transpose()).dot(&h),
            abs(r.row(1).transpose()).dot(&h),
            abs(r.row(2).transpose()).dot(&h),
        );
        Aabb::around(dst_from_src.point(c), half)
    }

    /// Whether both corners are finite and in order.
    #[must_use]
    pub fn is_valid(&self) -> bool {
        super::is_finite(self.lower)
            && super::is_finite(self.upper)
            && self.lower.x <= self.upper.x
            && self.lower.y <= self.upper.y
            && self.lower.z <= self.upper.z
    }

    /// The entry parameter t ∈ [0, `max_t`] of the ray `origin + t·d` into the box, `inv_d` being 1/d by
    /// component (±∞ where d is 0); `None` where it misses.
    #[inline(always)]
    #[must_use]
    pub fn ray(&self, origin: Vec3, inv_d: Vec3, max_t: Float) -> Option<Float> {
        let (mut t0, mut t1) = (0.0 as Float, max_t);
        for k in 0..3 {
            let (a, b) = ((self.lower[k] - origin[k]) * inv_d[k], (self.upper[k] - origin[k]) * inv_d[k]);
            // f32::max ignores a NaN (0 · ∞ on a slab's face), which keeps the ray inside that slab.
            t0 = t0.max(a.min(b));
            t1 = t1.min(a.max(b));
        }
        (t0 <= t1).then_some(t0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::quat_about;

    #[test]
    fn a_placed_box_holds_its_corners() {
        let b = Aabb::around(vec3(0.5, -1.0, 2.0), vec3(1.0, 2.0, 3.0));
        let pose = Pose::new(vec3(3.0, 0.0, -1.0), quat_about(vec3(1.0, 1.0, 0.3), 0.7));
        let placed = b.placed(&pose).grown(1e-5);
        for i in 0..8 {
            let s = |k: i32| if i >> k & 1 == 1 { 1.0 } else { -1.0 };
            let corner = b.center() + b.half().component_mul(&vec3(s(0), s(1), s(2)));
            let p = pose.point(corner);
            assert!(placed.contains(&Aabb { lower: p, upper: p }));
        }
    }

    #[test]
    fn rays_hit_and_miss() {
        let b = Aabb::around(Vec3::zeros(), vec3(1.0, 1.0, 1.0));
        let inv = |d: Vec3| vec3(1.0 / d.x, 1.0 / d.y, 1.0 / d.z);
        assert_eq!(b.ray(vec3(-3.0, 0.0, 0.0), inv(vec3(1.0, 0.0, 0.0)), 10.0), Some(2.0));
        assert_eq!(b.ray(vec3(-3.0, 0.0, 0.0), inv(vec3(1.0, 0.0, 0.0)), 1.0), None);
        assert_eq!(b.ray(vec3(-3.0, 2.0, 0.0), inv(vec3(1.0, 0.0, 0.0)), 10.0), None);
        assert_eq!(b.ray(Vec3::zeros(), inv(vec3(0.0, 1.0, 0.0)), 10.0), Some(0.0));
    }
}
