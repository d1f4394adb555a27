//! A slide along x of frame A.
//!
//! With d from the origin of frame A to that of B: the parts of d across x vanish (2), B does not turn against A (3);
//! what acts on the translation d · x. Impulses act at the origin of frame B, on both bodies:
//!   C = d · u,  Ċ = u · (v_B + ω_B × r_B − v_A − ω_A × (r_A + d))
//! whose arm to A holds that u turns with it.

use super::parts::{Drive, along};
use super::{Geometry, Law, Rows};
use crate::error::Result;

/// A slide.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct PrismaticJoint {
    /// What acts on the translation \[m\].
    pub drive: Drive,
}

impl PrismaticJoint {
    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        self.drive.validate()
    }

    /// See the module.
    pub fn emit(&self, g: &Geometry, rows: &mut impl Rows) {
        let [a, b] = g.arms_at_b();
        for k in [1, 2] {
            let u = g.axis(0, k);
            rows.linear(u, a, b, g.d.dot(&u), Law::Equal);
        }
        g.hold_rotation(rows, Law::Equal);
        let x = g.axis(0, 0);
        self.drive.emit(along(x, [a, b]), g.d.dot(&x), false, rows);
    }
}
