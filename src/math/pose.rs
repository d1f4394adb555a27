use super::{Float, Quat, Vec3, is_finite, rotate, rotate_back};

/// A rigid placement `dst_from_src`: rotates by `q`, then shifts by `p`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Where the origin of `src` lies in `dst` \[m\].
    pub p: Vec3,
    /// The axes of `src` in `dst`.
    pub q: Quat,
}

impl Default for Pose {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Pose {
    /// Leaves everything where it is.
    pub const IDENTITY: Pose = Pose {
        p: Vec3::new(0.0, 0.0, 0.0),
        q: Quat::new_unchecked(nalgebra::Quaternion::new(1.0, 0.0, 0.0, 0.0)),
    };

    /// A placement from position and rotation.
    #[inline(always)]
    #[must_use]
    pub const fn new(p: Vec3, q: Quat) -> Self {
        Self { p, q }
    }

    /// A shift without rotation.
    #[inline(always)]
    #[must_use]
    pub fn translation(p: Vec3) -> Self {
        Self { p, ..Self::IDENTITY }
    }

    /// A point of `src`, seen in `dst`.
    #[inline(always)]
    #[must_use]
    pub fn point(&self, src: Vec3) -> Vec3 {
        rotate(&self.q, src) + self.p
    }

    /// A direction of `src`, seen in `dst`.
    #[inline(always)]
    #[must_use]
    pub fn vector(&self, src: Vec3) -> Vec3 {
        rotate(&self.q, src)
    }

    /// A point of `dst`, seen in `src`.
    #[inline(always)]
    #[must_use]
    pub fn point_back(&self, dst: Vec3) -> Vec3 {
        rotate_back(&self.q, dst - self.p)
    }

    /// A direction of `dst`, seen in `src`.
    #[inline(always)]
    #[must_use]
    pub fn vector_back(&self, dst: Vec3) -> Vec3 {
        rotate_back(&self.q, dst)
    }

    /// `a_from_c = a_from_b.then(b_from_c)`.
    #[inline(always)]
    #[must_use]
    pub fn then(&self, inner: &Pose) -> Pose {
        Pose { p: self.point(inner.p), q: self.q * inner.q }
    }

    /// `a_from_b = w_from_a.back_to(w_from_b)`: the second placement seen from the first.
    #[inline(always)]
    #[must_use]
    pub fn back_to(&self, other: &Pose) -> Pose {
        Pose { p: rotate_back(&self.q, other.p - self.p), q: self.q.conjugate() * other.q }
    }

    /// `src_from_dst`.
    #[inline(always)]
    #[must_use]
    pub fn inverse(&self) -> Pose {
        Pose { p: -rotate_back(&self.q, self.p), q: self.q.conjugate() }
    }

    /// Whether the position is finite and the rotation a finite unit quaternion (to 1 in 10³).
    #[must_use]
    pub fn is_valid(&self) -> bool {
        let n: Float = self.q.w * self.q.w + self.q.i * self.q.i + self.q.j * self.q.j + self.q.k * self.q.k;
        is_finite(self.p) && n.is_finite() && (n - 1.0).abs() < 2e-3
    }
}
