//! Distance and overlap of two shapes, without a world.

use super::depth::DepthStatus;
pub use super::gjk::Status as DistanceStatus;
use super::gjk::{GjkKind, Pair, Simplex};
use super::{Methods, NarrowPhaseKind};
use crate::error::{Error, ErrorCode, Result, check};
use crate::math::scalar::{double, single};
use crate::math::{Aabb, Float, Pose, Vec3};
use crate::shape::{Core, CorePoints, HalfSpace, Shape, narrow};

/// How far two shapes are apart, in the frame of A.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistanceResult {
    /// The distance \[m\]; 0 where they touch or overlap.
    pub distance: Float,
    /// The point of A closest to B \[m\]. Where they overlap, a common point.
    pub point_a: Vec3,
    /// The point of B closest to A \[m\]. Where they overlap, the same point.
    pub point_b: Vec3,
    /// The unit vector from A to B; zero where the cores overlap (see [`Core`]).
    pub normal: Vec3,
    /// How the search ended.
    pub status: DistanceStatus,
    /// How many iterations it took.
    pub iterations: u32,
}

/// How deep two shapes overlap, in the frame of A.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthResult {
    /// How far B must move along the normal to leave A \[m\]; negative where they are apart by that distance.
    pub depth: Float,
    /// The unit vector from A to B.
    pub normal: Vec3,
    /// A point on the surface of A, and one on that of B \[m\].
    pub point_a: Vec3,
    /// See `point_a`.
    pub point_b: Vec3,
    /// How the search ended.
    pub status: DepthStatus,
    /// How many iterations the search for the depth took, GJK's not counted.
    pub iterations: u32,
}

/// A convex solid given by a few points and a radius: all points within `radius` of their hull.
#[derive(Clone, Copy, Debug)]
pub struct Proxy<'a> {
    core: Core<'a>,
}

/// The most points of a [`Proxy`].
pub const MAX_PROXY_POINTS: usize = 64;

impl<'a> Proxy<'a> {
    /// A proxy with these points and this radius (≥ 0) \[m\].
    ///
    /// # Errors
    /// No point, more than [`MAX_PROXY_POINTS`], or a number not finite or out of range.
    pub fn new(points: &'a [Vec3], radius: Float) -> Result<Self> {
        if !(1..=MAX_PROXY_POINTS).contains(&points.len()) {
            let sentence = format!("A proxy has 1 to {MAX_PROXY_POINTS} points, not {}.", points.len());
            return Err(Error::new(ErrorCode::Range, sentence));
        }
        for p in points {
            check::point("A point of the proxy", *p)?;
        }
        let radius =
            check::within("The proxy's radius", radius, 0.0, crate::math::tolerance::MAX_COORDINATE)?;
        Ok(Self { core: Core { points: CorePoints::Cloud(points), radius } })
    }

    /// The box around it, in the frame of its points \[m\].
    #[must_use]
    pub fn aabb(&self) -> Aabb {
        let CorePoints::Cloud(points) = self.core.points else { unreachable!("a proxy is made of points") };
        Aabb::of_points(points).grown(self.core.radius)
    }

    pub(super) fn core(&self) -> &Core<'a> {
        &self.core
    }
}

/// The distance between A and B. Two half-spaces count as overlapping.
#[must_use]
pub fn distance(a: &Shape, b: &Shape, a_from_b: &Pose) -> DistanceResult {
    distance_by(a, b, a_from_b, GjkKind::Auto)
}

/// The same by this sub-algorithm.
#[must_use]
pub fn distance_by(a: &Shape, b: &Shape, a_from_b: &Pose, gjk: GjkKind) -> DistanceResult {
    match (a, b) {
        (Shape::HalfSpace(_), Shape::HalfSpace(_)) => overlapping(Vec3::zeros()),
        (Shape::HalfSpace(h), _) => above_half_space(h, b, a_from_b),
        (_, Shape::HalfSpace(h)) => {
            let d = above_half_space(h, a, &a_from_b.inverse());
            DistanceResult {
                point_a: a_from_b.point(d.point_b),
                point_b: a_from_b.point(d.point_a),
                normal: -a_from_b.vector(d.normal),
                ..d
            }
        }
        _ => distance_cores(&core(a), &core(b), a_from_b, gjk, |_| {}),
    }
}

/// The distance between two proxies.
#[must_use]
pub fn distance_proxy(a: &Proxy, b: &Proxy, a_from_b: &Pose) -> DistanceResult {
    distance_cores(&a.core, &b.core, a_from_b, GjkKind::Auto, |_| {})
}

/// How deep two bounded shapes overlap, by GJK and MPR for [`NarrowPhaseKind::GjkMpr`] and by GJK and EPA else;
/// `None` for half-spaces.
#[must_use]
pub fn penetration(a: &Shape, b: &Shape, a_from_b: &Pose, kind: NarrowPhaseKind) -> Option<DepthResult> {
    let (ca, cb) = (a.core()?, b.core()?);
    let (ra, rb) = (double(ca.radius), double(cb.radius));
    let pair = Pair::new(ca.points, cb.points, a_from_b);
    let close = pair.distance(GjkKind::Auto, Float::MAX);
    let (depth, normal, on_a, on_b, status, iterations) = if close.status == DistanceStatus::Overlapping {
        let d = Methods::from(kind).depth(&pair, &close.simplex);
        (d.depth, d.normal, d.a, d.b, d.status, d.iterations)
    } else {
        let apart = close.distance > ra + rb;
        let status = if apart { DepthStatus::Apart } else { DepthStatus::Converged };
        (-close.distance, close.normal, close.a, close.b, status, 0)
    };
    Some(DepthResult {
        depth: single(depth + ra + rb),
        normal: narrow(normal),
        point_a: narrow(on_a + normal * ra),
        point_b: narrow(on_b - normal * rb),
        status,
        iterations,
    })
}

/// Whether A and B have a point in common; cheaper than the distance. Two half-spaces count as overlapping.
#[must_use]
pub fn overlap(a: &Shape, b: &Shape, a_from_b: &Pose) -> bool {
    let (Some(ca), Some(cb)) = (a.core(), b.core()) else {
        return distance(a, b, a_from_b).distance <= 0.0;
    };
    overlap_cores(&ca, &cb, a_from_b)
}

/// Whether a shape and a proxy have a point in common.
#[must_use]
pub fn overlap_proxy(a: &Shape, b: &Proxy, a_from_b: &Pose) -> bool {
    match a {
        Shape::HalfSpace(h) => h.height(lowest(h, &b.core, a_from_b)) <= 0.0,
        _ => overlap_cores(&core(a), &b.core, a_from_b),
    }
}

fn overlap_cores(a: &Core, b: &Core, pose: &Pose) -> bool {
    let reach = a.radius + b.radius;
    let close = Pair::new(a.points, b.points, pose).distance(GjkKind::Auto, reach);
    match close.status {
        DistanceStatus::Beyond => false,
        DistanceStatus::Overlapping => true,
        _ => single(close.distance) <= reach,
    }
}

/// The core of a bounded shape.
pub(super) fn core(shape: &Shape) -> Core<'_> {
    shape.core().expect("half-spaces are handled before")
}

fn overlapping(point: Vec3) -> DistanceResult {
    DistanceResult {
        distance: 0.0,
        point_a: point,
        point_b: point,
        normal: Vec3::zeros(),
        status: DistanceStatus::Overlapping,
        iterations: 0,
    }
}

pub(super) fn distance_cores(
    a: &Core,
    b: &Core,
    pose: &Pose,
    gjk: GjkKind,
    trace: impl FnMut(&Simplex),
) -> DistanceResult {
    let close = Pair::new(a.points, b.points, pose).traced(gjk, Float::MAX, trace);
    let (ra, rb) = (double(a.radius), double(b.radius));
    let (on_a, on_b) = (close.a + close.normal * ra, close.b - close.normal * rb);
    let gap = single(close.distance - ra - rb);
    // Where only the rounded parts overlap, the point that shares the way between the cores by the radii is in both.
    let share = if ra + rb > 0.0 { ra / (ra + rb) } else { 0.0 };
    let middle = close.a + close.normal * (close.distance * share);
    let apart = gap > 0.0;
    DistanceResult {
        distance: gap.max(0.0),
        point_a: narrow(if apart { on_a } else { middle }),
        point_b: narrow(if apart { on_b } else { middle }),
        normal: narrow(close.normal),
        status: if apart { close.status } else { DistanceStatus::Overlapping },
        iterations: close.iterations,
    }
}

/// The lowest point of a bounded shape above a half-space, in the frame of the half-space.
pub(super) fn lowest(h: &HalfSpace, b: &Core, pose: &Pose) -> Vec3 {
    let down = pose.vector_back(-h.normal());
    let p = b.points.point(b.points.support(&crate::shape::wide(down)));
    pose.point(p + down * b.radius)
}

fn above_half_space(h: &HalfSpace, b: &Shape, pose: &Pose) -> DistanceResult {
    let p = lowest(h, &core(b), pose);
    let height = h.height(p);
    if height <= 0.0 {
        return DistanceResult { normal: h.normal(), ..overlapping(p) };
    }
    DistanceResult {
        distance: height,
        point_a: p - h.normal() * height,
        point_b: p,
        normal: h.normal(),
        status: DistanceStatus::Converged,
        iterations: 0,
    }
}
