//! A spring that keeps z of frame B along z of frame A: it holds a body upright.

use super::parts::at_most;
use super::{Geometry, Law, Rows};
use crate::error::{Result, check};
use crate::math::Float;

/// Keeps two axes parallel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParallelJoint {
    /// Stiffness \[Hz\], ≥ 0; default 1. 0 has no effect.
    pub hertz: Float,
    /// Damping ratio, ≥ 0; default 1.
    pub damping_ratio: Float,
    /// Greatest torque, about each axis \[N m\], ≥ 0; default ∞.
    pub max_torque: Float,
}

impl Default for ParallelJoint {
    fn default() -> Self {
        Self { hertz: 1.0, damping_ratio: 1.0, max_torque: Float::INFINITY }
    }
}

impl ParallelJoint {
    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        check::not_negative("hertz", self.hertz)?;
        check::not_negative("damping_ratio", self.damping_ratio)?;
        at_most(self.max_torque, "max_torque")
    }

    /// Two rows, see [`Geometry::align_axes`].
    pub fn emit(&self, g: &Geometry, rows: &mut impl Rows) {
        let force = [-self.max_torque, self.max_torque];
        let law = Law::Spring { hertz: self.hertz, damping_ratio: self.damping_ratio, force };
        if self.hertz > 0.0 && self.max_torque > 0.0 {
            g.align_axes(rows, 2, law);
        }
    }
}
