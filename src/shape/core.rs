//! A shape as a core of points and a radius: all that GJK and EPA need to know.

use super::Hull;
use super::cuboid::corner;
use super::ray::{Wide, narrow, wide};
use crate::math::{Float, Vec3};

/// A convex solid: all points within `radius` of the convex hull of the core points.
#[derive(Clone, Copy, Debug)]
pub struct Core<'a> {
    /// The points.
    pub points: CorePoints<'a>,
    /// The radius \[m\].
    pub radius: Float,
}

/// The points of a core, in the shape's frame.
#[derive(Clone, Copy, Debug)]
pub enum CorePoints<'a> {
    /// A sphere's centre.
    One(Vec3),
    /// The ends of a capsule's segment.
    Two([Vec3; 2]),
    /// The corners of the box with these half extents.
    Box(Vec3),
    /// Any points, at least one.
    Cloud(&'a [Vec3]),
    /// The vertices of a hull.
    Hull(&'a Hull),
}

impl CorePoints<'_> {
    /// The index of the point farthest along `d` (any length). In double: GJK on a thin gap would otherwise choose
    /// its points by rounding.
    #[inline]
    pub(crate) fn support(&self, d: &Wide) -> usize {
        match self {
            Self::One(_) => 0,
            Self::Two([p, q]) => usize::from(wide(q - p).dot(d) > 0.0),
            Self::Box(_) => {
                usize::from(d.x >= 0.0) | usize::from(d.y >= 0.0) << 1 | usize::from(d.z >= 0.0) << 2
            }
            Self::Cloud(points) => first_greatest(points.len(), |i| wide(points[i]).dot(d)),
            // Scaled so that the direction stays a number in f32.
            Self::Hull(h) => {
                h.support_by(|| narrow(d / d.amax().max(f64::MIN_POSITIVE)), |i| wide(h.vertices()[i]).dot(d))
            }
        }
    }

    /// The point with this index.
    #[inline]
    #[must_use]
    pub fn point(&self, i: usize) -> Vec3 {
        match self {
            Self::One(p) => *p,
            Self::Two(p) => p[i],
            Self::Box(half) => corner(*half, i),
            Self::Cloud(points) => points[i],
            Self::Hull(h) => h.vertices()[i],
        }
    }

    /// A point of the core's hull, where searches start.
    #[inline]
    #[must_use]
    pub fn center(&self) -> Vec3 {
        match self {
            Self::One(p) => *p,
            Self::Two([p, q]) => (p + q) * 0.5,
            Self::Box(_) => Vec3::zeros(),
            Self::Cloud(points) => points[0],
            Self::Hull(h) => h.center(),
        }
    }
}

/// The number below `n` with the greatest height; the first of equals.
#[inline(always)]
pub(super) fn first_greatest<T: PartialOrd>(n: usize, height: impl Fn(usize) -> T) -> usize {
    let mut best = (0, height(0));
    for i in 1..n {
        let h = height(i);
        if h > best.1 {
            best = (i, h);
        }
    }
    best.0
}
