//! Vectors, rotations, placements and boxes as C sees them. The small operations on them are inline C.

use super::guard::neutral;
use super::mvFloat;
use crate::error::{Result, check};
use crate::math::{Aabb, Mat3, Pose, Quat, Vec3, vec3};

/// A vector or point in two dimensions.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct mvVec2 {
    /// Along x.
    pub x: mvFloat,
    /// Along y.
    pub y: mvFloat,
}

/// A vector or point in three dimensions.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct mvVec3 {
    /// Along x.
    pub x: mvFloat,
    /// Along y.
    pub y: mvFloat,
    /// Along z.
    pub z: mvFloat,
}

/// A position in the world. A type of its own, so that world positions can get more digits than everything
/// else without a change to programs: convert with mvToPos() and mvToVec3(), subtract with mvSubPos().
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct mvPos {
    /// Along x.
    pub x: mvFloat,
    /// Along y.
    pub y: mvFloat,
    /// Along z.
    pub z: mvFloat,
}

/// Cosine and sine of one angle.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct mvCosSin {
    /// The cosine.
    pub cosine: mvFloat,
    /// The sine.
    pub sine: mvFloat,
}

/// A rotation as a unit quaternion: vector part v, scalar part s. The identity is v = 0, s = 1.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct mvQuat {
    /// The vector part.
    pub v: mvVec3,
    /// The scalar part.
    pub s: mvFloat,
}

/// A rigid placement: rotate by q, then shift by p.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct mvTransform {
    /// The shift [m].
    pub p: mvVec3,
    /// The rotation.
    pub q: mvQuat,
}

/// A rigid placement in the world: rotate by q, then shift to p.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct mvWorldTransform {
    /// The shift [m].
    pub p: mvPos,
    /// The rotation.
    pub q: mvQuat,
}

/// A 3 by 3 matrix, by columns.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct mvMatrix3 {
    /// The first column.
    pub cx: mvVec3,
    /// The second column.
    pub cy: mvVec3,
    /// The third column.
    pub cz: mvVec3,
}

/// An axis-aligned box.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct mvAABB {
    /// The least corner.
    pub lower_bound: mvVec3,
    /// The greatest corner.
    pub upper_bound: mvVec3,
}

/// A plane: the points whose dot product with the unit normal equals the offset. The distance of a point from
/// it is dot(normal, point) - offset, positive on the side the normal points to.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct mvPlane {
    /// The normal, of length 1.
    pub normal: mvVec3,
    /// The distance of the plane from the origin, along the normal.
    pub offset: mvFloat,
}

/// The closest points of two segments or lines.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct mvSegmentDistanceResult {
    /// The closest point on the first.
    pub point1: mvVec3,
    /// Where it lies, as a fraction of the first's direction.
    pub fraction1: mvFloat,
    /// The closest point on the second.
    pub point2: mvVec3,
    /// Where it lies, as a fraction of the second's direction.
    pub fraction2: mvFloat,
}

pub(super) const ZERO3: mvVec3 = mvVec3 { x: 0.0, y: 0.0, z: 0.0 };
pub(super) const ORIGIN: mvPos = mvPos { x: 0.0, y: 0.0, z: 0.0 };
pub(super) const IDENTITY: mvQuat = mvQuat { v: ZERO3, s: 1.0 };

neutral! {
    mvVec3 = ZERO3;
    mvPos = ORIGIN;
    mvCosSin = mvCosSin { cosine: 1.0, sine: 0.0 };
    mvQuat = IDENTITY;
    mvTransform = mvTransform { p: ZERO3, q: IDENTITY };
    mvWorldTransform = mvWorldTransform { p: ORIGIN, q: IDENTITY };
    mvMatrix3 = mvMatrix3 { cx: ZERO3, cy: ZERO3, cz: ZERO3 };
    mvAABB = mvAABB { lower_bound: ZERO3, upper_bound: ZERO3 };
    mvPlane = mvPlane { normal: ZERO3, offset: 0.0 };
    mvSegmentDistanceResult =
        mvSegmentDistanceResult { point1: ZERO3, fraction1: 0.0, point2: ZERO3, fraction2: 0.0 };
}

// Conversions without checks, both ways.

impl From<Vec3> for mvVec3 {
    fn from(v: Vec3) -> Self {
        Self { x: v.x, y: v.y, z: v.z }
    }
}

impl From<Vec3> for mvPos {
    fn from(v: Vec3) -> Self {
        Self { x: v.x, y: v.y, z: v.z }
    }
}

impl From<Quat> for mvQuat {
    fn from(q: Quat) -> Self {
        Self { v: mvVec3 { x: q.i, y: q.j, z: q.k }, s: q.w }
    }
}

impl From<Pose> for mvTransform {
    fn from(t: Pose) -> Self {
        Self { p: t.p.into(), q: t.q.into() }
    }
}

impl From<Pose> for mvWorldTransform {
    fn from(t: Pose) -> Self {
        Self { p: t.p.into(), q: t.q.into() }
    }
}

impl From<Mat3> for mvMatrix3 {
    fn from(m: Mat3) -> Self {
        let column = |k: usize| mvVec3 { x: m[(0, k)], y: m[(1, k)], z: m[(2, k)] };
        Self { cx: column(0), cy: column(1), cz: column(2) }
    }
}

impl From<Aabb> for mvAABB {
    fn from(b: Aabb) -> Self {
        Self { lower_bound: b.lower.into(), upper_bound: b.upper.into() }
    }
}

impl mvVec3 {
    pub(super) fn raw(self) -> Vec3 {
        vec3(self.x, self.y, self.z)
    }

    /// The vector, checked to be finite.
    pub(super) fn finite(self, name: &str) -> Result<Vec3> {
        check::finite_vec(name, self.raw())
    }

    /// The vector, checked to be finite and within the greatest coordinate.
    pub(super) fn point(self, name: &str) -> Result<Vec3> {
        check::point(name, self.raw())
    }
}

impl mvPos {
    pub(super) fn raw(self) -> Vec3 {
        vec3(self.x, self.y, self.z)
    }

    /// The position, checked to be finite and within the greatest coordinate.
    pub(super) fn point(self, name: &str) -> Result<Vec3> {
        check::point(name, self.raw())
    }
}

impl mvQuat {
    pub(super) fn raw(self) -> Quat {
        Quat::new_unchecked(nalgebra::Quaternion::new(self.s, self.v.x, self.v.y, self.v.z))
    }

    /// The rotation, checked to be finite and of unit length.
    pub(super) fn rotation(self, name: &str) -> Result<Quat> {
        check::rotation(name, self.raw())
    }
}

impl mvTransform {
    pub(super) fn raw(self) -> Pose {
        Pose::new(self.p.raw(), self.q.raw())
    }

    /// The placement, checked.
    pub(super) fn pose(self, name: &str) -> Result<Pose> {
        check::pose(name, &self.raw())
    }
}

impl mvWorldTransform {
    pub(super) fn raw(self) -> Pose {
        Pose::new(self.p.raw(), self.q.raw())
    }

    /// The placement, checked.
    pub(super) fn pose(self, name: &str) -> Result<Pose> {
        check::pose(name, &self.raw())
    }
}

impl mvMatrix3 {
    pub(super) fn raw(self) -> Mat3 {
        Mat3::from_columns(&[self.cx.raw(), self.cy.raw(), self.cz.raw()])
    }

    /// The matrix, checked to be finite.
    pub(super) fn finite(self, name: &str) -> Result<Mat3> {
        for column in [self.cx, self.cy, self.cz] {
            column.finite(name)?;
        }
        Ok(self.raw())
    }
}

impl mvAABB {
    pub(super) fn raw(self) -> Aabb {
        Aabb { lower: self.lower_bound.raw(), upper: self.upper_bound.raw() }
    }
}
