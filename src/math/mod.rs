//! Scalars, vectors, poses and boxes: thin names over nalgebra, plus the few functions that must give the
//! same bits on every platform.
//!
//! Nothing here calls the platform's math library: `+ − × ÷ √` are exact by IEEE 754, and the trigonometric
//! functions come from the `libm` crate, which is plain Rust.

mod aabb;
mod pose;
pub mod scalar;
pub mod tolerance;

pub use aabb::Aabb;
pub use pose::Pose;

/// The scalar of the whole engine: `f32`, or `f64` with the feature `f64`.
#[cfg(not(feature = "f64"))]
pub type Float = f32;
/// The scalar of the whole engine: `f32`, or `f64` with the feature `f64`.
#[cfg(feature = "f64")]
pub type Float = f64;

/// A vector or point in three dimensions.
pub type Vec3 = nalgebra::Vector3<Float>;
/// A unit quaternion: a rotation.
pub type Quat = nalgebra::UnitQuaternion<Float>;
/// A 3×3 matrix.
pub type Mat3 = nalgebra::Matrix3<Float>;

/// Shorthand for [`Vec3::new`].
#[inline(always)]
#[must_use]
pub fn vec3(x: Float, y: Float, z: Float) -> Vec3 {
    Vec3::new(x, y, z)
}

/// The length of `v`.
#[inline(always)]
#[must_use]
pub fn length(v: Vec3) -> Float {
    v.dot(&v).sqrt()
}

/// The square of the length of `v`.
#[inline(always)]
#[must_use]
pub fn length_squared(v: Vec3) -> Float {
    v.dot(&v)
}

/// `v` scaled to length 1, or `fallback` where `v` is too short to have a direction.
#[inline(always)]
#[must_use]
pub fn normalize_or(v: Vec3, fallback: Vec3) -> Vec3 {
    let l2 = v.dot(&v);
    if l2 > Float::MIN_POSITIVE * 4.0 { v / l2.sqrt() } else { fallback }
}

/// Component-wise absolute value.
#[inline(always)]
#[must_use]
pub fn abs(v: Vec3) -> Vec3 {
    vec3(v.x.abs(), v.y.abs(), v.z.abs())
}

/// Component-wise minimum.
#[inline(always)]
#[must_use]
pub fn min(a: Vec3, b: Vec3) -> Vec3 {
    vec3(a.x.min(b.x), a.y.min(b.y), a.z.min(b.z))
}

/// Component-wise maximum.
#[inline(always)]
#[must_use]
pub fn max(a: Vec3, b: Vec3) -> Vec3 {
    vec3(a.x.max(b.x), a.y.max(b.y), a.z.max(b.z))
}

/// A unit vector at a right angle to the unit vector `n` (Duff et al., JCGT 2017: no branch but one copied
/// sign, stable everywhere). The second tangent is `n.cross(&t)`.
#[inline(always)]
#[must_use]
pub fn any_tangent(n: Vec3) -> Vec3 {
    let s = if n.z >= 0.0 { 1.0 } else { -1.0 };
    let a = -1.0 / (s + n.z);
    vec3(1.0 + s * n.x * n.x * a, s * n.x * n.y * a, -s * n.x)
}

/// The matrix of the cross product: `skew(v) * w == v.cross(&w)`.
#[inline(always)]
#[must_use]
pub fn skew(v: Vec3) -> Mat3 {
    Mat3::new(0.0, -v.z, v.y, v.z, 0.0, -v.x, -v.y, v.x, 0.0)
}

/// The quaternion `(s, v)` scaled to length 1; the identity where it has no length. What is not finite stays so.
#[inline(always)]
#[must_use]
pub fn quat(s: Float, v: Vec3) -> Quat {
    let l2 = s * s + v.dot(&v);
    if l2 == 0.0 {
        return Quat::identity();
    }
    let k = 1.0 / l2.sqrt();
    Quat::new_unchecked(nalgebra::Quaternion::new(s * k, v.x * k, v.y * k, v.z * k))
}

/// The rotation by `angle` \[rad\] about `axis` (any length but zero).
#[must_use]
pub fn quat_about(axis: Vec3, angle: Float) -> Quat {
    let (s, c) = scalar::sin_cos(0.5 * angle);
    quat(c, normalize_or(axis, Vec3::z()) * s)
}

/// The rotation matrix of `q`.
#[inline(always)]
#[must_use]
pub fn rotation_matrix(q: &Quat) -> Mat3 {
    let (x, y, z, w) = (q.i, q.j, q.k, q.w);
    let (x2, y2, z2) = (x + x, y + y, z + z);
    let (xx, yy, zz, xy, xz, yz) = (x * x2, y * y2, z * z2, x * y2, x * z2, y * z2);
    let (wx, wy, wz) = (w * x2, w * y2, w * z2);
    Mat3::new(
        1.0 - (yy + zz),
        xy - wz,
        xz + wy,
        xy + wz,
        1.0 - (xx + zz),
        yz - wx,
        xz - wy,
        yz + wx,
        1.0 - (xx + yy),
    )
}

/// `q * v`, the rotated vector.
#[inline(always)]
#[must_use]
pub fn rotate(q: &Quat, v: Vec3) -> Vec3 {
    let u = vec3(q.i, q.j, q.k);
    let t = u.cross(&v) * 2.0;
    v + t * q.w + u.cross(&t)
}

/// `q⁻¹ * v`, the vector rotated back.
#[inline(always)]
#[must_use]
pub fn rotate_back(q: &Quat, v: Vec3) -> Vec3 {
    let u = vec3(-q.i, -q.j, -q.k);
    let t = u.cross(&v) * 2.0;
    v + t * q.w + u.cross(&t)
}

/// `q` turned by the rotation vector `w` \[rad\], small per step: q ← normalise(q + ½ w q).
#[inline(always)]
#[must_use]
pub fn turn(q: &Quat, w: Vec3) -> Quat {
    let (h, v) = (w * 0.5, vec3(q.i, q.j, q.k));
    quat(q.w - h.dot(&v), v + h * q.w + h.cross(&v))
}

/// Whether all components are finite.
#[inline(always)]
#[must_use]
pub fn is_finite(v: Vec3) -> bool {
    v.x.is_finite() && v.y.is_finite() && v.z.is_finite()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rotations_agree_with_nalgebra_and_undo() {
        let q = quat_about(vec3(1.0, -2.0, 0.5), 1.3);
        let v = vec3(0.3, -4.0, 2.0);
        assert!(length(rotate(&q, v) - q * v) < 1e-5);
        assert!(length(rotation_matrix(&q) * v - q * v) < 1e-5);
        assert!(length(rotate_back(&q, rotate(&q, v)) - v) < 1e-5);
    }

    #[test]
    fn tangents_are_unit_and_orthogonal() {
        for n in [Vec3::x(), -Vec3::x(), Vec3::y(), Vec3::z(), -Vec3::z(), vec3(0.6, 0.0, -0.8)] {
            let t = any_tangent(n);
            assert!(n.dot(&t).abs() < 1e-6 && (length(t) - 1.0).abs() < 1e-6);
        }
    }

    #[test]
    fn a_vector_without_length_falls_back() {
        assert_eq!(normalize_or(Vec3::zeros(), Vec3::y()), Vec3::y());
        assert_eq!(quat(0.0, Vec3::zeros()), Quat::identity());
    }
}
