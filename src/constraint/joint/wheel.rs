//! A wheel on its suspension. A is the chassis, B the wheel.
//!
//! The origin of frame B moves along x of frame A, the suspension's travel (2 rows hold it there). The wheel spins
//! about z of frame B. Without steering that axis stays along z of frame A (2 rows); with steering it only stays
//! across x (1 row: C = z_B · x_A) and turns about x by the steering angle.

use super::geometry::Angle;
use super::parts::{Drive, Motor, about, along, at_most};
use super::{Geometry, Law, Rows};
use crate::error::Result;
use crate::math::{Float, scalar};

/// A wheel.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct WheelJoint {
    /// What acts on the travel along x of frame A \[m\].
    pub suspension: Drive,
    /// Spins the wheel about z of frame B \[rad/s\].
    pub spin: Motor,
    /// Torque of dry friction in the bearing \[N m\], ≥ 0; default 0.
    pub spin_friction: Float,
    /// Whether the wheel steers; default false.
    pub enable_steering: bool,
    /// What acts on the steering angle, about x of frame A \[rad\].
    pub steering: Drive,
}

impl WheelJoint {
    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        self.suspension.validate()?;
        self.spin.validate()?;
        at_most(self.spin_friction, "spin_friction")?;
        self.steering.validate()
    }

    /// See the module.
    pub fn emit(&self, g: &Geometry, rows: &mut impl Rows) {
        let arms = g.arms_at_b();
        let x = g.axis(0, 0);
        for k in [1, 2] {
            let u = g.axis(0, k);
            rows.linear(u, arms[0], arms[1], g.d.dot(&u), Law::Equal);
        }
        let spin = g.axis(1, 2);
        if self.enable_steering {
            rows.angular(spin.cross(&x), spin.dot(&x), Law::Equal);
        } else {
            g.align_axes(rows, 2, Law::Equal);
        }
        // The motor comes first: its row is read back.
        if self.spin.enable {
            let law = Law::Motor { speed: self.spin.speed, max: self.spin.max_force };
            rows.general(about(spin), 0.0, law, true);
        }
        if self.spin_friction > 0.0 {
            rows.general(about(spin), 0.0, Law::Motor { speed: 0.0, max: self.spin_friction }, true);
        }
        self.suspension.emit(along(x, arms), g.d.dot(&x), false, rows);
        if self.enable_steering {
            self.steering.emit(about(x), steering_angle(g), true, rows);
        }
    }

    /// Where the spin motor's row stands among those of `emit`.
    #[must_use]
    pub fn spin_row(&self) -> Option<usize> {
        self.spin.enable.then_some(if self.enable_steering { 3 } else { 4 })
    }
}

/// From z of frame A to z of frame B, about x of frame A \[rad\].
#[must_use]
pub fn steering_angle(g: &Geometry) -> Float {
    let spin = g.axis(1, 2);
    scalar::atan2(-spin.dot(&g.axis(0, 1)), spin.dot(&g.axis(0, 2)))
}

/// The wheel's turn about z of frame B, counting whole turns from the last known one.
#[must_use]
pub fn spin_angle(g: &Geometry) -> Angle {
    g.angle_about(2, 0)
}
