//! Moving one shape against another: conservative advancement (Mirtich 1996). Without rotation each step goes to
//! where the separating plane of the last distance is reached, so the fraction grows towards the true one and never
//! passes it.

use super::gjk::{GjkKind, Pair, Status};
use super::query::{Proxy, core, lowest};
use crate::math::scalar::{double, single};
use crate::math::tolerance::CAST_ARRIVAL;
use crate::math::{Float, Pose, Vec3};
use crate::shape::{Core, HalfSpace, Shape, narrow, wide};

/// Polytopes arrive within a dozen steps, grazing balls need a few more.
const MAX_STEPS: u32 = 64;

/// Where a moving shape first touches, in the frame of A.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CastHit {
    /// The share of the translation travelled, 0 … `max_fraction`.
    pub fraction: Float,
    /// The point of contact \[m\].
    pub point: Vec3,
    /// The outward unit normal of A there; zero where the shapes overlap from the start.
    pub normal: Vec3,
}

/// Moves B along `translation` (in the frame of A), without turning, until it touches A, at most `max_fraction` ≥ 0
/// of the way. Shapes that overlap from the start hit at fraction 0; shapes that only touch and do not approach do
/// not hit.
#[must_use]
pub fn shape_cast(
    a: &Shape,
    b: &Shape,
    a_from_b: &Pose,
    translation: Vec3,
    max_fraction: Float,
) -> Option<CastHit> {
    match (a, b) {
        (Shape::HalfSpace(_), Shape::HalfSpace(_)) => {
            Some(CastHit { fraction: 0.0, point: Vec3::zeros(), normal: Vec3::zeros() })
        }
        (Shape::HalfSpace(h), _) => cast_at_half_space(h, &core(b), a_from_b, translation, max_fraction),
        (_, Shape::HalfSpace(_)) => {
            let hit =
                shape_cast(b, a, &a_from_b.inverse(), -a_from_b.vector_back(translation), max_fraction)?;
            // That point stood still in the frame of B; B itself has moved on.
            let point = a_from_b.point(hit.point) + translation * hit.fraction;
            Some(CastHit { fraction: hit.fraction, point, normal: -a_from_b.vector(hit.normal) })
        }
        _ => cast_cores(&core(a), &core(b), a_from_b, translation, max_fraction),
    }
}

/// The same for a proxy moving towards a shape.
#[must_use]
pub fn cast_proxy(
    a: &Shape,
    b: &Proxy,
    a_from_b: &Pose,
    translation: Vec3,
    max_fraction: Float,
) -> Option<CastHit> {
    match a {
        Shape::HalfSpace(h) => cast_at_half_space(h, b.core(), a_from_b, translation, max_fraction),
        _ => cast_cores(&core(a), b.core(), a_from_b, translation, max_fraction),
    }
}

/// The same for two proxies.
#[must_use]
pub fn shape_cast_proxy(
    a: &Proxy,
    b: &Proxy,
    a_from_b: &Pose,
    translation: Vec3,
    max_fraction: Float,
) -> Option<CastHit> {
    cast_cores(a.core(), b.core(), a_from_b, translation, max_fraction)
}

fn cast_at_half_space(
    h: &HalfSpace,
    b: &Core,
    pose: &Pose,
    translation: Vec3,
    max_fraction: Float,
) -> Option<CastHit> {
    let p = lowest(h, b, pose);
    let hit = Shape::HalfSpace(*h).ray_cast(p, translation, max_fraction)?;
    Some(CastHit { fraction: hit.fraction, point: hit.point, normal: hit.normal })
}

fn cast_cores(a: &Core, b: &Core, pose: &Pose, translation: Vec3, max_fraction: Float) -> Option<CastHit> {
    let mut pair = Pair::new(a.points, b.points, pose);
    let way = wide(translation);
    let (ra, radii) = (double(a.radius), double(a.radius + b.radius));
    let mut fraction = 0.0;
    for step in 0..MAX_STEPS {
        let close = pair.distance(GjkKind::Auto, Float::MAX);
        let gap = close.distance - radii;
        let hit = |normal| {
            let point = narrow(close.a + close.normal * ra);
            Some(CastHit { fraction: single(fraction), point, normal })
        };
        if step == 0 && (gap <= 0.0 || close.status == Status::Overlapping) {
            return hit(Vec3::zeros());
        }
        if close.status == Status::Overlapping {
            // Only rounding can carry the cores past the plane just reached.
            return hit(narrow(-way / way.norm().max(f64::MIN_POSITIVE)));
        }
        let approach = -way.dot(&close.normal);
        if approach <= 0.0 {
            return None;
        }
        let size = close.simplex.scale() + radii;
        if gap <= CAST_ARRIVAL * size || step + 1 == MAX_STEPS {
            return hit(narrow(close.normal));
        }
        let advance = gap / approach;
        fraction += advance;
        if fraction > double(max_fraction) {
            return None;
        }
        pair.shift(way * advance);
    }
    None
}
