//! A universal joint (Cardan's): the origins together, and x of frame A across y of frame B; B turns about x of A by
//! the first angle and about its own y by the second.
//!   C = x_A · y_B,  Ċ = (ω_B − ω_A) · (y_B × x_A)

use super::parts::{Drive, about};
use super::{Geometry, Law, Rows};
use crate::error::Result;
use crate::math::{Float, scalar};

/// A universal joint.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct UniversalJoint {
    /// What acts on the angles about x of frame A and about y of frame B \[rad\].
    pub drives: [Drive; 2],
}

impl UniversalJoint {
    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        self.drives[0].validate()?;
        self.drives[1].validate()
    }

    /// See the module.
    pub fn emit(&self, g: &Geometry, rows: &mut impl Rows) {
        g.hold_points(rows, Law::Equal);
        let (x, y) = (g.axis(0, 0), g.axis(1, 1));
        rows.angular(y.cross(&x), x.dot(&y), Law::Equal);
        let angles = angles(g);
        for ((drive, u), angle) in self.drives.iter().zip([x, y]).zip(angles) {
            drive.emit(about(u), angle, true, rows);
        }
    }
}

/// About x of frame A and about y of frame B, each −π … π \[rad\].
#[must_use]
pub fn angles(g: &Geometry) -> [Float; 2] {
    let (xa, ya, za) = (g.axis(0, 0), g.axis(0, 1), g.axis(0, 2));
    let (xb, yb, zb) = (g.axis(1, 0), g.axis(1, 1), g.axis(1, 2));
    [scalar::atan2(yb.dot(&za), yb.dot(&ya)), scalar::atan2(zb.dot(&xa), xb.dot(&xa))]
}
