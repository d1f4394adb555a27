//! Rays against solids. The few numbers of a ray are computed in double in both builds: seen from far away,
//! a radius or a thin slab would drown in the rounding of f32.

use crate::math::scalar::{double, single};
use crate::math::{Float, Vec3, normalize_or};

/// Where a ray or a moving shape meets a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayHit {
    /// The share of the translation travelled, 0 … `max_fraction`.
    pub fraction: Float,
    /// The point on the surface \[m\], in the frame of the call.
    pub point: Vec3,
    /// The outward unit normal of the surface; zero where the ray starts inside.
    pub normal: Vec3,
}

impl RayHit {
    /// The hit of a ray that starts inside.
    pub(crate) fn inside(origin: Vec3) -> Self {
        Self { fraction: 0.0, point: origin, normal: Vec3::zeros() }
    }

    /// The hit at fraction `t`, if that is in reach; `normal` maps the point to a vector along the normal.
    pub(crate) fn at(
        origin: Vec3,
        translation: Vec3,
        t: f64,
        max_fraction: Float,
        normal: impl FnOnce(Vec3) -> Vec3,
    ) -> Option<Self> {
        if t < 0.0 || t > double(max_fraction) {
            return None;
        }
        let point = narrow(wide(origin) + wide(translation) * t);
        Some(Self {
            fraction: single(t),
            point,
            normal: normalize_or(normal(point), -normalize_or(translation, Vec3::y())),
        })
    }
}

/// A vector in double.
pub(crate) type Wide = nalgebra::Vector3<f64>;

/// To double.
#[inline(always)]
pub(crate) fn wide(v: Vec3) -> Wide {
    Wide::new(double(v.x), double(v.y), double(v.z))
}

/// Back to [`Float`].
#[inline(always)]
pub(crate) fn narrow(v: Wide) -> Vec3 {
    Vec3::new(single(v.x), single(v.y), single(v.z))
}

/// The fraction at which the ray `o + t d` enters the ball of radius `r` about the origin, from outside. The
/// discriminant is taken from the closest approach, not from b² − 4ac, which cancels for far rays (Haines et al.,
/// Ray Tracing Gems 2019, ch. 7).
pub(super) fn enter_ball(o: Wide, d: Wide, r: f64) -> Option<f64> {
    let dd = d.dot(&d);
    if dd <= 0.0 {
        return None;
    }
    let closest = -o.dot(&d) / dd;
    let miss = o + d * closest;
    let room = r * r - miss.dot(&miss);
    (closest >= 0.0 && room >= 0.0).then(|| (closest - (room / dd).sqrt()).max(0.0))
}

/// Clips the interval `t` of a ray by the half-space `distance + t·rate ≤ 0`; `true` where this plane is now the
/// one of entry. An empty interval ends with `t.0 > t.1`.
pub(super) fn clip(t: &mut (f64, f64), distance: f64, rate: f64) -> bool {
    if rate < 0.0 {
        let enter = -distance / rate;
        if enter >= t.0 {
            t.0 = enter;
            return true;
        }
    } else if rate > 0.0 {
        t.1 = t.1.min(-distance / rate);
    } else if distance > 0.0 {
        t.1 = -1.0; // Beside the slab for ever.
    }
    false
}
