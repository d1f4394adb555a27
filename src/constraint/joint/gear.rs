//! Two joints in step: with q₁ and q₂ the coordinates of two revolute or prismatic joints,
//!   C = q₁ + ratio · q₂ − constant
//! whose row has four sides, two of each joint. Two gears in mesh that turn against each other have a positive
//! ratio r₂/r₁; a rack and pinion is a revolute and a prismatic joint, with the ratio in rad/m or m/rad. Because
//! the coordinates are those of joints, gears may sit on a moving carrier: a differential is two such rows.

use super::{JointRow, Law, Rows, Side};
use crate::error::{Error, ErrorCode, Result, check};
use crate::math::Float;

/// Two joints in step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GearJoint {
    /// Slots of the two joints.
    pub joints: [u32; 2],
    /// How far the first coordinate goes back when the second goes on by 1; finite, not 0. Default 1.
    pub ratio: Float,
}

/// A joint's coordinate and how it changes.
#[derive(Clone, Copy, Debug)]
pub struct Coordinate {
    /// \[rad\] or \[m\], relative to what it was when the gear was made.
    pub value: Float,
    /// Of bodies A and B.
    pub sides: [Side; 2],
}

impl GearJoint {
    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        if check::finite("ratio", self.ratio)? == 0.0 {
            return Err(Error::new(ErrorCode::Range, "The ratio is 0; it must not be."));
        }
        Ok(())
    }

    /// See the module.
    pub fn emit(&self, [first, second]: [&Coordinate; 2], rows: &mut impl Rows) {
        rows.push(JointRow {
            sides: first.sides,
            more: Some(second.sides.map(|s| s.times(self.ratio))),
            c: first.value + self.ratio * second.value,
            law: Law::Equal,
            angular: true,
        });
    }
}
