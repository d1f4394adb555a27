//! A hinge about z of both frames.
//!
//! Rows: the origins together (3), z_B along z_A (2, see [`Geometry::align_axes`]); what acts on the angle of B
//! against A about z, counting whole turns: spring, friction, motor, limits.

use super::parts::{Drive, about};
use super::{Geometry, Law, Rows};
use crate::error::Result;

/// A hinge.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct RevoluteJoint {
    /// What acts on the angle \[rad\]; the limits may lie beyond ±π.
    pub drive: Drive,
}

impl RevoluteJoint {
    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        self.drive.validate()
    }

    /// See the module.
    pub fn emit(&self, g: &Geometry, rows: &mut impl Rows) {
        g.hold_points(rows, Law::Equal);
        g.align_axes(rows, 2, Law::Equal);
        self.drive.emit(about(g.axis(0, 2)), g.angle_about(2, 0).radians(), true, rows);
    }
}
