//! Vectors and quaternions (x, y, z, w) as plain arrays, in double precision, for scenes and rulers.

pub type V3 = [f64; 3];
pub type Q4 = [f64; 4];

pub const STILL: Q4 = [0.0, 0.0, 0.0, 1.0];

pub fn add(a: V3, b: V3) -> V3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn sub(a: V3, b: V3) -> V3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn scale(a: V3, k: f64) -> V3 {
    a.map(|x| k * x)
}

pub fn dot(a: V3, b: V3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: V3, b: V3) -> V3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn norm(a: V3) -> f64 {
    dot(a, a).sqrt()
}

/// The product: `b` is applied first.
pub fn times([ax, ay, az, aw]: Q4, [bx, by, bz, bw]: Q4) -> Q4 {
    [
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    ]
}

pub fn conjugate([x, y, z, w]: Q4) -> Q4 {
    [-x, -y, -z, w]
}

/// Of length 1; no rotation if it has none.
pub fn unit(q: Q4) -> Q4 {
    let size = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    if size > 0.0 { q.map(|x| x / size) } else { STILL }
}

/// Rotates a vector by a quaternion of any length.
pub fn rotate(q: Q4, v: V3) -> V3 {
    let p = times(times(q, [v[0], v[1], v[2], 0.0]), conjugate(q));
    let size = q.iter().map(|x| x * x).sum::<f64>();
    [p[0] / size, p[1] / size, p[2] / size]
}

/// A turn about an axis of length 1 by an angle \[rad\].
pub fn turn(axis: V3, angle: f64) -> Q4 {
    let (s, c) = libm::sincos(0.5 * angle);
    [s * axis[0], s * axis[1], s * axis[2], c]
}

/// The angle between two rotations \[rad\], 0 … π.
pub fn angle_between(a: Q4, b: Q4) -> f64 {
    let [x, y, z, w] = times(conjugate(unit(a)), unit(b));
    2.0 * libm::atan2(norm([x, y, z]), w.abs())
}

/// The angle between two directions \[rad\], 0 … π.
pub fn angle(a: V3, b: V3) -> f64 {
    libm::atan2(norm(cross(a, b)), dot(a, b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_compose_and_have_their_angle() {
        let (a, b) = (turn([0.0, 0.0, 1.0], 0.3), turn([0.0, 0.0, 1.0], 0.5));
        assert!((angle_between(a, b) - 0.2).abs() < 1e-15);
        let v = rotate(times(a, b), [1.0, 0.0, 0.0]);
        assert!(norm(sub(v, [libm::cos(0.8), libm::sin(0.8), 0.0])) < 1e-15);
        assert!((angle([2.0, 0.0, 0.0], [0.0, 3.0, 0.0]) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
        assert!(norm(sub(rotate(conjugate(a), rotate(a, [1.0, 2.0, 3.0])), [1.0, 2.0, 3.0])) < 1e-14);
    }
}
