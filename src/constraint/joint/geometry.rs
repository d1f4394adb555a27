//! Where the frames of a joint are, and the angles between them.

use super::{Law, Rows};
use crate::math::{Float, Quat, Vec3, rotate, scalar, vec3};

/// The two frames of a joint at one time, world axes.
#[derive(Clone, Copy, Debug)]
pub struct Geometry {
    /// From the centres of mass of A and B to the origins of the frames \[m\].
    pub arm: [Vec3; 2],
    /// From the origin of frame A to that of frame B \[m\].
    pub d: Vec3,
    /// World from frame.
    pub q: [Quat; 2],
    /// The origin of frame A in the world \[m\].
    pub origin_a: Vec3,
    /// The last known turns, so that coordinates count them.
    pub turns: [Angle; 2],
}

impl Geometry {
    /// Axis `k` of frame `side`.
    #[inline]
    #[must_use]
    pub fn axis(&self, side: usize, k: usize) -> Vec3 {
        let q = &self.q[side];
        let (x, y, z, w) = (q.i, q.j, q.k, q.w);
        match k {
            0 => vec3(1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)),
            1 => vec3(2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x)),
            _ => vec3(2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)),
        }
    }

    /// Frame A from frame B.
    #[inline]
    #[must_use]
    pub fn relative(&self) -> Quat {
        self.q[0].conjugate() * self.q[1]
    }

    /// The arms to one common point, halfway between the origins of the frames: an impulse that acts there on both
    /// bodies keeps their angular momentum.
    #[inline]
    #[must_use]
    pub fn middle_arms(&self) -> [Vec3; 2] {
        [self.arm[0] + self.d * 0.5, self.arm[1] - self.d * 0.5]
    }

    /// The arms to the origin of frame B.
    #[inline]
    #[must_use]
    pub fn arms_at_b(&self) -> [Vec3; 2] {
        [self.arm[0] + self.d, self.arm[1]]
    }

    /// Holds the origins together, by the given law.
    #[inline]
    pub fn hold_points(&self, rows: &mut impl Rows, law: Law) {
        let [a, b] = self.middle_arms();
        for (k, u) in [Vec3::x(), Vec3::y(), Vec3::z()].into_iter().enumerate() {
            rows.linear(u, a, b, self.d[k], law);
        }
    }

    /// Holds frame B's axes along frame A's, by the given law. C is twice the vector part of the relative rotation:
    /// the rotation vector, up to third order.
    pub fn hold_rotation(&self, rows: &mut impl Rows, law: Law) {
        let e = rotation_vector(&self.relative());
        for k in 0..3 {
            rows.angular(self.axis(0, k), e[k], law);
        }
    }

    /// Holds axis `k` of frame B along axis `k` of frame A: of b = R_b e_k the parts across a = R_a e_k vanish,
    ///   C = b · u,  Ċ = (ω_B − ω_A) · (b × u)   for the other two axes u of frame A.
    pub fn align_axes(&self, rows: &mut impl Rows, k: usize, law: Law) {
        let b = self.axis(1, k);
        for j in [(k + 1) % 3, (k + 2) % 3] {
            let u = self.axis(0, j);
            rows.angular(b.cross(&u), b.dot(&u), law);
        }
    }

    /// The turn of B against A about axis `k` of both frames, counting whole turns from the last known one.
    #[must_use]
    pub fn angle_about(&self, k: usize, slot: usize) -> Angle {
        let q = self.relative();
        self.turns[slot].next(twist(&q, k))
    }
}

/// An angle that counts turns.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Angle {
    /// Whole turns.
    pub turns: i32,
    /// The rest, −π … π \[rad\].
    pub rest: Float,
}

impl Angle {
    /// This many radians.
    #[must_use]
    pub fn of(radians: Float) -> Self {
        let turns = (radians / (2.0 * scalar::PI)).round();
        Self { turns: turns as i32, rest: radians - turns * (2.0 * scalar::PI) }
    }

    /// The angle in radians.
    #[must_use]
    pub fn radians(self) -> Float {
        self.turns as Float * (2.0 * scalar::PI) + self.rest
    }

    /// The angle nearest to this one whose rest is `rest`.
    #[must_use]
    pub fn next(self, rest: Float) -> Self {
        let turns = if rest - self.rest > scalar::PI {
            self.turns.saturating_sub(1)
        } else if rest - self.rest < -scalar::PI {
            self.turns.saturating_add(1)
        } else {
            self.turns
        };
        Self { turns, rest }
    }
}

/// The angle of the twist of `q` about axis `k`, −π … π \[rad\].
#[must_use]
pub fn twist(q: &Quat, k: usize) -> Float {
    let v = [q.i, q.j, q.k][k];
    let (s, c) = if q.w < 0.0 { (-v, -q.w) } else { (v, q.w) };
    if s == 0.0 && c == 0.0 { 0.0 } else { 2.0 * scalar::atan2(s, c) }
}

/// Splits the rotation of frame B against frame A: it is a swing that carries axis z of A into that of B, after a
/// twist about z. Returns the rotation vector of the swing (its z is 0; in frame A \[rad\]) and the twist \[rad\].
#[must_use]
pub fn swing_twist(q: &Quat) -> (Vec3, Float) {
    let length = (q.k * q.k + q.w * q.w).sqrt();
    if length < 1e-6 {
        // A swing of half a turn: any twist will do.
        return (vec3(q.i, q.j, 0.0) * scalar::PI, 0.0);
    }
    let (tw, tz) = (q.w / length, q.k / length);
    // Swing = q ∘ twist⁻¹.
    let (sx, sy) = (q.i * tw - q.j * tz, q.j * tw + q.i * tz);
    let half = (sx * sx + sy * sy).sqrt();
    let angle = 2.0 * scalar::atan2(half, length);
    let k = if half > 1e-9 { angle / half } else { 2.0 };
    (vec3(sx * k, sy * k, 0.0), twist(q, 2))
}

/// The rotation vector of `q`, of at most half a turn \[rad\].
#[must_use]
pub fn rotation_vector(q: &Quat) -> Vec3 {
    let sign = if q.w < 0.0 { -1.0 } else { 1.0 };
    let v = vec3(q.i, q.j, q.k) * sign;
    let s2 = v.dot(&v);
    if s2 < 1e-4 {
        // asin(s)/s = 1 + s²/6 + 3 s⁴/40 + …
        return v * (2.0 * (1.0 + s2 * (1.0 / 6.0 + s2 * (3.0 / 40.0))));
    }
    let s = s2.sqrt();
    v * (2.0 * scalar::atan2(s, q.w * sign) / s)
}

/// The axes, in frame A, about which turns of B change the parts of the rotation vector `e`: the rows of
/// 1 − ½ e× + (1/θ² − (1 + cos θ) / (2 θ sin θ)) e× e×.
#[must_use]
pub fn rotation_vector_axes(e: Vec3) -> [Vec3; 3] {
    let t2 = e.dot(&e);
    let k = if t2 < 1e-2 {
        1.0 / 12.0 + t2 / 720.0
    } else {
        let t = t2.sqrt();
        let (s, c) = scalar::sin_cos(t);
        1.0 / t2 - (1.0 + c) / (2.0 * t * s.max(1e-3))
    };
    let cross = crate::math::skew(e);
    let m = crate::math::Mat3::identity() - cross * 0.5 + cross * cross * k;
    [0, 1, 2].map(|i| vec3(m[(i, 0)], m[(i, 1)], m[(i, 2)]))
}

/// The axis, in the world, that changes a twist about z: for unit axes a and b the rate is
/// (ω_B − ω_A) · (a + b) / (1 + a · b).
#[must_use]
pub fn twist_axis(a: Vec3, b: Vec3) -> Vec3 {
    (a + b) / (1.0 + a.dot(&b)).max(0.05)
}

/// A vector in frame coordinates, in the world.
#[must_use]
pub fn in_world(q: &Quat, v: Vec3) -> Vec3 {
    rotate(q, v)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{length, quat_about};

    #[test]
    fn swing_and_twist_make_the_rotation() {
        for i in 0..200 {
            let f = i as Float;
            let q = quat_about(vec3(1.0, 0.3 * f - 4.0, 2.0 - 0.1 * f), 0.11 * f - 3.0);
            let (swing, angle) = swing_twist(&q);
            let back = quat_about(swing, length(swing)) * quat_about(Vec3::z(), angle);
            let apart = back.conjugate() * q;
            assert!(length(vec3(apart.i, apart.j, apart.k)) < 1e-4, "{i}: {swing} {angle}");
            assert!(swing.z == 0.0);
        }
    }

    #[test]
    fn rotation_vectors_come_back() {
        for angle in [0.0, 1e-4, 0.01, 0.03, 1.0, 3.0] {
            let axis = vec3(0.6, 0.0, -0.8);
            let v = rotation_vector(&quat_about(axis, angle));
            assert!(length(v - axis * angle) < 1e-5 * (1.0 + angle), "{angle}: {v}");
            let v = rotation_vector(&quat_about(axis, -angle));
            assert!(length(v + axis * angle) < 1e-5 * (1.0 + angle));
        }
    }

    #[test]
    fn the_axes_of_the_rotation_vector_are_its_gradient() {
        for i in 0..100 {
            let f = i as Float;
            let q = quat_about(vec3(1.0, 0.3 * f - 4.0, 2.0 - 0.1 * f), 0.03 * f - 1.4);
            let e = rotation_vector(&q);
            let axes = rotation_vector_axes(e);
            for k in 0..3 {
                let mut w = Vec3::zeros();
                w[k] = 1e-2;
                let slope = (rotation_vector(&crate::math::turn(&q, w))
                    - rotation_vector(&crate::math::turn(&q, -w)))
                    / 2e-2;
                for j in 0..3 {
                    assert!((slope[j] - axes[j][k]).abs() < 1e-3, "{i}: {slope} {axes:?}");
                }
            }
        }
    }

    #[test]
    fn angles_count_turns() {
        let mut angle = Angle::default();
        for k in 1..=100 {
            let a = 0.7 * k as Float;
            angle = angle.next(twist(&quat_about(Vec3::z(), a), 2));
            assert!((angle.radians() - a).abs() < 1e-4, "{a}: {angle:?}");
        }
        for k in (-100..100).rev() {
            let a = 0.7 * k as Float;
            angle = angle.next(twist(&quat_about(Vec3::z(), a), 2));
            assert!((angle.radians() - a).abs() < 1e-4, "{a}: {angle:?}");
        }
        assert!((Angle::of(20.0).radians() - 20.0).abs() < 1e-5);
    }
}
