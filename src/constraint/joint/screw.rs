//! A screw along x of both frames: B slides along x of A by `pitch` each turn about it.
//!   C = d · x − pitch · angle / 2π
//! Besides, the origin of frame B stays on the axis (2) and the axes along each other (2).

use super::parts::{Drive, about, along};
use super::{Geometry, Law, Rows, Side};
use crate::error::{Result, check};
use crate::math::{Float, scalar::PI};

/// A screw.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct ScrewJoint {
    /// How far B goes along x with each turn \[m\]; default 0: it only turns.
    pub pitch: Float,
    /// What acts on the angle \[rad\].
    pub drive: Drive,
}

impl ScrewJoint {
    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        check::finite("pitch", self.pitch)?;
        self.drive.validate()
    }

    /// See the module.
    pub fn emit(&self, g: &Geometry, rows: &mut impl Rows) {
        let arms = g.arms_at_b();
        for k in [1, 2] {
            let u = g.axis(0, k);
            rows.linear(u, arms[0], arms[1], g.d.dot(&u), Law::Equal);
        }
        g.align_axes(rows, 0, Law::Equal);
        let x = g.axis(0, 0);
        let (slide, turn) = (along(x, arms), about(x));
        let per_radian = self.pitch / (2.0 * PI);
        let both = [0, 1].map(|i| Side {
            linear: slide[i].linear,
            angular: slide[i].angular - turn[i].angular * per_radian,
        });
        let angle = g.angle_about(0, 0).radians();
        rows.general(both, g.d.dot(&x) - angle * per_radian, Law::Equal, false);
        self.drive.emit(turn, angle, true, rows);
    }
}
