//! Checks of numbers, and the mathematics that must give the same bits on every platform.

use super::guard::{call, needed};
use super::math::*;
use super::mvFloat;
use crate::error::{Error, ErrorCode, check};
use crate::math::{Float, Vec3, length, scalar, tolerance::MAX_COORDINATE, vec3};

/// Is this number finite: neither NaN nor infinite?
#[unsafe(no_mangle)]
pub extern "C" fn mvIsValidFloat(a: mvFloat) -> bool {
    a.is_finite()
}

/// Are all components finite?
#[unsafe(no_mangle)]
pub extern "C" fn mvIsValidVec3(a: mvVec3) -> bool {
    crate::math::is_finite(a.raw())
}

/// Is this a finite quaternion of length 1 (to 1 in 1000)?
#[unsafe(no_mangle)]
pub extern "C" fn mvIsValidQuat(q: mvQuat) -> bool {
    q.rotation("").is_ok()
}

/// Is the position finite and the rotation valid?
#[unsafe(no_mangle)]
pub extern "C" fn mvIsValidTransform(a: mvTransform) -> bool {
    a.raw().is_valid()
}

/// Are all components finite?
#[unsafe(no_mangle)]
pub extern "C" fn mvIsValidMatrix3(a: mvMatrix3) -> bool {
    a.finite("").is_ok()
}

/// Are both corners finite, and the lower one not above the upper one?
#[unsafe(no_mangle)]
pub extern "C" fn mvIsValidAABB(a: mvAABB) -> bool {
    a.raw().is_valid()
}

/// Are all coordinates finite and within the greatest that the library accepts, 1e9?
#[unsafe(no_mangle)]
pub extern "C" fn mvIsBoundedAABB(a: mvAABB) -> bool {
    a.lower_bound.point("").is_ok() && a.upper_bound.point("").is_ok()
}

/// Is this box valid and bounded?
#[unsafe(no_mangle)]
pub extern "C" fn mvIsSaneAABB(a: mvAABB) -> bool {
    mvIsValidAABB(a) && mvIsBoundedAABB(a)
}

/// Is this plane finite, with a normal of length 1 (to 1 in 1000)?
#[unsafe(no_mangle)]
pub extern "C" fn mvIsValidPlane(a: mvPlane) -> bool {
    let n = a.normal.raw();
    a.offset.is_finite() && (n.dot(&n) - 1.0).abs() < 2e-3
}

/// Is this position finite?
#[unsafe(no_mangle)]
pub extern "C" fn mvIsValidPosition(p: mvPos) -> bool {
    crate::math::is_finite(p.raw())
}

/// Is the position finite and the rotation valid?
#[unsafe(no_mangle)]
pub extern "C" fn mvIsValidWorldTransform(t: mvWorldTransform) -> bool {
    t.raw().is_valid()
}

/// Get the angle of the point (x, y) seen from the origin, with the same bits on every platform.
///
/// @return the angle in radians, from -pi to pi; 0 for (0, 0) and for bad arguments
/// @note Errors: mv_errorNotFinite.
#[unsafe(no_mangle)]
pub extern "C" fn mvAtan2(y: mvFloat, x: mvFloat) -> mvFloat {
    call(|| Ok(scalar::atan2(check::finite("y", y)?, check::finite("x", x)?)))
}

/// Get cosine and sine of an angle, with the same bits on every platform.
///
/// @param radians the angle, any finite number
/// @return cosine and sine; those of 0 for bad arguments
/// @note Errors: mv_errorNotFinite.
#[unsafe(no_mangle)]
pub extern "C" fn mvComputeCosSin(radians: mvFloat) -> mvCosSin {
    call(|| {
        let (sine, cosine) = scalar::sin_cos(check::finite("radians", radians)?);
        Ok(mvCosSin { cosine, sine })
    })
}

/// Get the rotation of a rotation matrix.
///
/// @param m a rotation matrix: orthonormal columns, determinant 1 (to 1 in 100)
/// @return the unit quaternion; the identity for bad arguments
/// @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange when m is no rotation.
#[unsafe(no_mangle)]
pub extern "C" fn mvMakeQuatFromMatrix(m: Option<&mvMatrix3>) -> mvQuat {
    call(|| {
        let m = needed("m", m)?.finite("m")?;
        let off = (m.transpose() * m - crate::math::Mat3::identity()).amax();
        if off > 0.01 || m.determinant() < 0.0 {
            return Err(Error::new(ErrorCode::Range, "m is not a rotation matrix."));
        }
        // The four squares of the parts, from the diagonal; the largest gives the best divisor.
        let t = [1.0 + m.m11 - m.m22 - m.m33, 1.0 - m.m11 + m.m22 - m.m33, 1.0 - m.m11 - m.m22 + m.m33];
        let w = 1.0 + m.m11 + m.m22 + m.m33;
        let q = if w >= t[0].max(t[1]).max(t[2]) {
            crate::math::quat(w, vec3(m.m32 - m.m23, m.m13 - m.m31, m.m21 - m.m12))
        } else if t[0] >= t[1].max(t[2]) {
            crate::math::quat(m.m32 - m.m23, vec3(t[0], m.m12 + m.m21, m.m13 + m.m31))
        } else if t[1] >= t[2] {
            crate::math::quat(m.m13 - m.m31, vec3(m.m12 + m.m21, t[1], m.m23 + m.m32))
        } else {
            crate::math::quat(m.m21 - m.m12, vec3(m.m13 + m.m31, m.m23 + m.m32, t[2]))
        };
        Ok(q.into())
    })
}

/// Get the least rotation that turns one direction into another.
///
/// @param v1 the direction to turn, of length 1
/// @param v2 the direction to reach, of length 1
/// @return the rotation; for opposite directions one of the half turns that do it; the identity for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorDegenerate when a vector is not of length 1 (to 1 in 1000).
#[unsafe(no_mangle)]
pub extern "C" fn mvComputeQuatBetweenUnitVectors(v1: mvVec3, v2: mvVec3) -> mvQuat {
    call(|| {
        let (a, b) = (v1.finite("v1")?, v2.finite("v2")?);
        for (name, v) in [("v1", a), ("v2", b)] {
            if (v.dot(&v) - 1.0).abs() >= 2e-3 {
                return Err(Error::new(ErrorCode::Degenerate, format!("{name} is not of length 1.")));
            }
        }
        // Half way between them; where they are opposite there is no half way, and any axis at a right angle does.
        let half = a + b;
        if length(half) < 1e-3 {
            return Ok(crate::math::quat(0.0, crate::math::any_tangent(a)).into());
        }
        let half = half / length(half);
        Ok(crate::math::quat(a.dot(&half), a.cross(&half)).into())
    })
}

/// Get the inertia of a point mass, about the origin.
///
/// Add it to an inertia about the centre of mass to get that about a point at the distance of origin.
/// @param mass the mass [kg], not negative
/// @param origin where the mass is [m]
/// @return the inertia [kg m^2]; zero for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvSteiner(mass: mvFloat, origin: mvVec3) -> mvMatrix3 {
    call(|| {
        let (m, d) = (check::not_negative("mass", mass)?, origin.point("origin")?);
        Ok(((crate::math::Mat3::identity() * d.dot(&d) - d * d.transpose()) * m).into())
    })
}

/// Get the point of a segment closest to a target.
///
/// @param a the start of the segment
/// @param b the end of the segment; may equal a
/// @param q the target
/// @return the closest point; zero for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvPointToSegmentDistance(a: mvVec3, b: mvVec3, q: mvVec3) -> mvVec3 {
    call(|| {
        let (a, b, q) = (a.point("a")?, b.point("b")?, q.point("q")?);
        let d = b - a;
        let t = fraction((q - a).dot(&d), d.dot(&d)).clamp(0.0, 1.0);
        Ok((a + d * t).into())
    })
}

/// Get the closest points of two infinite lines.
///
/// @param p1 a point of the first line
/// @param d1 the first line's direction, of any length but 0
/// @param p2 a point of the second line
/// @param d2 the second line's direction, of any length but 0
/// @return the closest points; for parallel lines the first is p1; zero for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorDegenerate for a direction without length.
#[unsafe(no_mangle)]
pub extern "C" fn mvLineDistance(p1: mvVec3, d1: mvVec3, p2: mvVec3, d2: mvVec3) -> mvSegmentDistanceResult {
    call(|| {
        let (p1, d1, p2, d2) = (p1.point("p1")?, d1.point("d1")?, p2.point("p2")?, d2.point("d2")?);
        if length(d1) < Float::MIN_POSITIVE || length(d2) < Float::MIN_POSITIVE {
            return Err(Error::new(ErrorCode::Degenerate, "A direction has no length."));
        }
        let (a, b, c) = (d1.dot(&d1), d1.dot(&d2), d2.dot(&d2));
        let r = p1 - p2;
        let det = a * c - b * b;
        let t1 = if det > 1e-6 * a * c { (b * d2.dot(&r) - c * d1.dot(&r)) / det } else { 0.0 };
        let t2 = fraction((p1 + d1 * t1 - p2).dot(&d2), c);
        Ok(result(p1, d1, t1, p2, d2, t2))
    })
}

/// Get the closest points of two segments.
///
/// @param p1 the start of the first segment
/// @param q1 the end of the first segment; may equal p1
/// @param p2 the start of the second segment
/// @param q2 the end of the second segment; may equal p2
/// @return the closest points; zero for bad arguments
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvSegmentDistance(
    p1: mvVec3,
    q1: mvVec3,
    p2: mvVec3,
    q2: mvVec3,
) -> mvSegmentDistanceResult {
    call(|| {
        let (p1, q1, p2, q2) = (p1.point("p1")?, q1.point("q1")?, p2.point("p2")?, q2.point("q2")?);
        let (d1, d2, r) = (q1 - p1, q2 - p2, p1 - p2);
        let (a, b, c) = (d1.dot(&d1), d1.dot(&d2), d2.dot(&d2));
        let det = a * c - b * b;
        let free = if det > 1e-6 * a * c { (b * d2.dot(&r) - c * d1.dot(&r)) / det } else { 0.0 };
        let t1 = free.clamp(0.0, 1.0);
        // The best on the second for that; where it runs over an end, the best on the first for that end.
        let wanted = fraction((p1 + d1 * t1 - p2).dot(&d2), c);
        let t2 = wanted.clamp(0.0, 1.0);
        let t1 = if t2 == wanted { t1 } else { fraction((p2 + d2 * t2 - p1).dot(&d1), a).clamp(0.0, 1.0) };
        Ok(result(p1, d1, t1, p2, d2, t2))
    })
}

/// `top / bottom`, 0 where the bottom is 0.
fn fraction(top: Float, bottom: Float) -> Float {
    if bottom > 0.0 { top / bottom } else { 0.0 }
}

fn result(p1: Vec3, d1: Vec3, t1: Float, p2: Vec3, d2: Vec3, t2: Float) -> mvSegmentDistanceResult {
    mvSegmentDistanceResult {
        point1: (p1 + d1 * t1).into(),
        fraction1: t1,
        point2: (p2 + d2 * t2).into(),
        fraction2: t2,
    }
}

const _: () = assert!(MAX_COORDINATE == 1e9, "the header names this number");
