use crate::math::{Mat3, Pose, Vec3, rotation_matrix, vec3};

/// A placement with its rotation as a matrix: for many points at once.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    pub r: Mat3,
    pub p: Vec3,
}

impl Frame {
    #[inline(always)]
    pub fn new(pose: &Pose) -> Self {
        Self { r: rotation_matrix(&pose.q), p: pose.p }
    }

    /// Column `k` of the rotation: axis k of `src`, seen in `dst`.
    #[inline(always)]
    pub fn axis(&self, k: usize) -> Vec3 {
        vec3(self.r[(0, k)], self.r[(1, k)], self.r[(2, k)])
    }

    #[inline(always)]
    pub fn vector(&self, v: Vec3) -> Vec3 {
        self.axis(0) * v.x + self.axis(1) * v.y + self.axis(2) * v.z
    }

    #[inline(always)]
    pub fn point(&self, v: Vec3) -> Vec3 {
        self.vector(v) + self.p
    }

    #[inline(always)]
    pub fn vector_back(&self, v: Vec3) -> Vec3 {
        vec3(self.axis(0).dot(&v), self.axis(1).dot(&v), self.axis(2).dot(&v))
    }

    #[inline(always)]
    pub fn inverse(&self) -> Self {
        let r = self.r.transpose();
        Self { r, p: -self.vector_back(self.p) }
    }
}
