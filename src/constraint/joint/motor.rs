//! Drives frame B against frame A: towards a velocity, with a bounded force, and towards its place, by a spring.

use super::geometry::rotation_vector;
use super::parts::at_most;
use super::{Geometry, Law, Rows};
use crate::error::{Result, check};
use crate::math::{Float, Vec3};

/// A motor between two frames.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorJoint {
    /// Velocity of B's point against A's that is wanted, axes of frame A \[m/s\]; default 0.
    pub linear_velocity: Vec3,
    /// Greatest force for it, along each axis \[N\], ≥ 0; default 0.
    pub max_velocity_force: Float,
    /// Angular velocity that is wanted, axes of frame A \[rad/s\]; default 0.
    pub angular_velocity: Vec3,
    /// Greatest torque for it, about each axis \[N m\], ≥ 0; default 0.
    pub max_velocity_torque: Float,
    /// Spring that brings the origins together \[Hz\], ≥ 0; default 0: none.
    pub linear_hertz: Float,
    /// Its damping ratio, ≥ 0; default 1.
    pub linear_damping_ratio: Float,
    /// Its greatest force, along each axis \[N\], ≥ 0; default 0.
    pub max_spring_force: Float,
    /// Spring that brings the axes along each other \[Hz\], ≥ 0; default 0: none.
    pub angular_hertz: Float,
    /// Its damping ratio, ≥ 0; default 1.
    pub angular_damping_ratio: Float,
    /// Its greatest torque, about each axis \[N m\], ≥ 0; default 0.
    pub max_spring_torque: Float,
}

impl Default for MotorJoint {
    fn default() -> Self {
        Self {
            linear_velocity: Vec3::zeros(),
            max_velocity_force: 0.0,
            angular_velocity: Vec3::zeros(),
            max_velocity_torque: 0.0,
            linear_hertz: 0.0,
            linear_damping_ratio: 1.0,
            max_spring_force: 0.0,
            angular_hertz: 0.0,
            angular_damping_ratio: 1.0,
            max_spring_torque: 0.0,
        }
    }
}

impl MotorJoint {
    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        check::finite_vec("linear_velocity", self.linear_velocity)?;
        at_most(self.max_velocity_force, "max_velocity_force")?;
        check::finite_vec("angular_velocity", self.angular_velocity)?;
        at_most(self.max_velocity_torque, "max_velocity_torque")?;
        check::not_negative("linear_hertz", self.linear_hertz)?;
        check::not_negative("linear_damping_ratio", self.linear_damping_ratio)?;
        at_most(self.max_spring_force, "max_spring_force")?;
        check::not_negative("angular_hertz", self.angular_hertz)?;
        check::not_negative("angular_damping_ratio", self.angular_damping_ratio)?;
        at_most(self.max_spring_torque, "max_spring_torque")
    }

    /// Up to twelve rows, three for each of springs and velocities that has a force.
    pub fn emit(&self, g: &Geometry, rows: &mut impl Rows) {
        let [a, b] = g.middle_arms();
        let spring =
            |hertz, damping_ratio, max: Float| Law::Spring { hertz, damping_ratio, force: [-max, max] };
        if self.linear_hertz > 0.0 && self.max_spring_force > 0.0 {
            let law = spring(self.linear_hertz, self.linear_damping_ratio, self.max_spring_force);
            for k in 0..3 {
                let u = g.axis(0, k);
                rows.linear(u, a, b, g.d.dot(&u), law);
            }
        }
        if self.angular_hertz > 0.0 && self.max_spring_torque > 0.0 {
            let law = spring(self.angular_hertz, self.angular_damping_ratio, self.max_spring_torque);
            let e = rotation_vector(&g.relative());
            for k in 0..3 {
                rows.angular(g.axis(0, k), e[k], law);
            }
        }
        if self.max_velocity_force > 0.0 {
            for k in 0..3 {
                let law = Law::Motor { speed: self.linear_velocity[k], max: self.max_velocity_force };
                rows.linear(g.axis(0, k), a, b, 0.0, law);
            }
        }
        if self.max_velocity_torque > 0.0 {
            for k in 0..3 {
                let law = Law::Motor { speed: self.angular_velocity[k], max: self.max_velocity_torque };
                rows.angular(g.axis(0, k), 0.0, law);
            }
        }
    }
}
