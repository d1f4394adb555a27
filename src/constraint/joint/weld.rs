//! Two frames held together: rigidly, or by springs that make a soft body of many.

use super::{Geometry, Law, Rows};
use crate::error::{Result, check};
use crate::math::Float;

/// A weld.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct WeldJoint {
    /// Stiffness of the place \[Hz\], ≥ 0; default 0: rigid.
    pub linear_hertz: Float,
    /// Its damping ratio, ≥ 0; default 0.
    pub linear_damping_ratio: Float,
    /// Stiffness of the rotation \[Hz\], ≥ 0; default 0: rigid.
    pub angular_hertz: Float,
    /// Its damping ratio, ≥ 0; default 0.
    pub angular_damping_ratio: Float,
}

impl WeldJoint {
    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        check::not_negative("linear_hertz", self.linear_hertz)?;
        check::not_negative("linear_damping_ratio", self.linear_damping_ratio)?;
        check::not_negative("angular_hertz", self.angular_hertz)?;
        check::not_negative("angular_damping_ratio", self.angular_damping_ratio)?;
        Ok(())
    }

    /// Six rows: the origins together, the axes along each other.
    pub fn emit(&self, g: &Geometry, rows: &mut impl Rows) {
        g.hold_points(rows, law(self.linear_hertz, self.linear_damping_ratio));
        g.hold_rotation(rows, law(self.angular_hertz, self.angular_damping_ratio));
    }
}

fn law(hertz: Float, damping_ratio: Float) -> Law {
    if hertz == 0.0 {
        Law::Equal
    } else {
        Law::Spring { hertz, damping_ratio, force: [Float::NEG_INFINITY, Float::INFINITY] }
    }
}
