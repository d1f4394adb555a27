//! A ball joint: the origins together, all turns free within a cone and a range of twist.
//!
//! The rotation of B against A is split into a swing, which carries z of A into z of B, after a twist about z. The
//! swing's rotation vector s = (s_x, s_y) must stay in the ellipse (s_x/a)² + (s_y/b)² ≤ 1: with ρ the root of that
//! sum, the limit's row is
//!   C = (1 − ρ) |s| / ρ ≥ 0,   against the turn along the ellipse's normal.
//! The twist's rate is (ω_B − ω_A) · (z_A + z_B) / (1 + z_A · z_B).
//! The spring pulls along the rotation vector from the target to the present rotation; motor and friction act on
//! the three parts of ω_B − ω_A, in the axes of frame A.

use super::geometry::{in_world, rotation_vector, swing_twist, twist_axis};
use super::parts::{Limit, Spring, at_most};
use super::{Geometry, Law, Rows};
use crate::error::{Result, check};
use crate::math::scalar::{self, PI};
use crate::math::{Float, Quat, Vec3, length, vec3};

/// A ball joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphericalJoint {
    /// Whether the swing is limited; default false.
    pub enable_cone_limit: bool,
    /// Half-angles of the cone for turns about x and about y of frame A \[rad\], 0 … π; default 0.
    pub cone_angle: [Float; 2],
    /// Bounds of the twist about z \[rad\].
    pub twist: Limit,
    /// Towards `target_rotation`.
    pub spring: Spring,
    /// Frame B in frame A where the spring rests; default the identity.
    pub target_rotation: Quat,
    /// Whether the motor runs; default false.
    pub enable_motor: bool,
    /// Angular velocity of B against A that the motor wants, axes of frame A \[rad/s\]; default 0.
    pub motor_velocity: Vec3,
    /// Its greatest torque, about each axis \[N m\], ≥ 0; default 0.
    pub max_motor_torque: Float,
    /// Torque of dry friction, about each axis \[N m\], ≥ 0; default 0.
    pub friction: Float,
}

impl Default for SphericalJoint {
    fn default() -> Self {
        Self {
            enable_cone_limit: false,
            cone_angle: [0.0; 2],
            twist: Limit::default(),
            spring: Spring::default(),
            target_rotation: Quat::identity(),
            enable_motor: false,
            motor_velocity: Vec3::zeros(),
            max_motor_torque: 0.0,
            friction: 0.0,
        }
    }
}

/// A cone this narrow \[rad\] is a line.
const NARROW: Float = 1e-3;

impl SphericalJoint {
    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        for angle in self.cone_angle {
            check::within("cone angle", angle, 0.0, PI * 1.0001)?;
        }
        self.twist.validate()?;
        self.spring.validate()?;
        check::rotation("target_rotation", self.target_rotation)?;
        check::finite_vec("motor_velocity", self.motor_velocity)?;
        at_most(self.max_motor_torque, "max_motor_torque")?;
        at_most(self.friction, "friction")
    }

    /// See the module.
    pub fn emit(&self, g: &Geometry, rows: &mut impl Rows) {
        g.hold_points(rows, Law::Equal);
        let springs = self.spring.enable && self.spring.hertz > 0.0;
        if springs {
            let from_target = self.target_rotation.conjugate() * g.relative();
            // In the target's frame, seen from the world.
            let e = rotation_vector(&from_target);
            let world = g.q[0] * self.target_rotation;
            for (k, u) in [Vec3::x(), Vec3::y(), Vec3::z()].into_iter().enumerate() {
                rows.angular(in_world(&world, u), e[k], self.spring.law());
            }
        }
        if self.friction > 0.0 {
            for k in 0..3 {
                rows.angular(g.axis(0, k), 0.0, Law::Motor { speed: 0.0, max: self.friction });
            }
        }
        if self.enable_motor {
            for k in 0..3 {
                let law = Law::Motor { speed: self.motor_velocity[k], max: self.max_motor_torque };
                rows.angular(g.axis(0, k), 0.0, law);
            }
        }
        if !self.enable_cone_limit && !self.twist.enable {
            return;
        }
        let (swing, twist) = swing_twist(&g.relative());
        if self.enable_cone_limit {
            let (axis, c) = self.cone_row(swing);
            rows.angular(-in_world(&g.q[0], axis), c, Law::AtLeast);
        }
        if self.twist.enable {
            let u = twist_axis(g.axis(0, 2), g.axis(1, 2));
            if self.twist.lower == self.twist.upper {
                rows.angular(u, twist - self.twist.lower, Law::Equal);
            } else {
                rows.angular(u, twist - self.twist.lower, Law::AtLeast);
                rows.angular(-u, self.twist.upper - twist, Law::AtLeast);
            }
        }
    }

    /// The axis about which a turn leads straight out of the cone, in frame A, and how far it still may go.
    fn cone_row(&self, swing: Vec3) -> (Vec3, Float) {
        let inv = self.cone_angle.map(|a| 1.0 / a.max(NARROW));
        let (x, y) = (swing.x * inv[0], swing.y * inv[1]);
        let (rho, size) = ((x * x + y * y).sqrt(), length(swing));
        if rho < 1e-6 {
            return (Vec3::x(), self.cone_angle[0].min(self.cone_angle[1]));
        }
        let normal = vec3(x * inv[0], y * inv[1], 0.0);
        let normal = normal / length(normal);
        // The swing's vector θ a changes along its axis a by ω · a, and across it, along z × a, by the turn of the
        // plane in which z swings to b: by ω · (b × a) θ / sin θ.
        let a = swing / size;
        let (s, c) = scalar::sin_cos(size);
        let b = a.cross(&Vec3::z()) * s + Vec3::z() * c;
        let across = normal.dot(&Vec3::z().cross(&a)) * size / s.max(0.05);
        let axis = a * normal.dot(&a) + b.cross(&a) * across;
        (axis, (1.0 - rho) * (size / rho) * normal.dot(&a))
    }

    /// Where the first of the three rows of the motor stands among those of `emit`.
    #[must_use]
    pub fn motor_row(&self) -> Option<usize> {
        let springs = self.spring.enable && self.spring.hertz > 0.0;
        self.enable_motor.then(|| 3 + 3 * usize::from(springs) + 3 * usize::from(self.friction > 0.0))
    }
}
