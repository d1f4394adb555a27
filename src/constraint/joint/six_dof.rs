//! Six degrees of freedom, each free, locked or limited, with spring, motor and friction.
//!
//! The linear ones are the parts of d (from the origin of frame A to that of B) along the axes of frame A, with
//! impulses at the origin of frame B; the angular ones the parts of the rotation vector of B against A, each −π … π.

use super::geometry::{in_world, rotation_vector, rotation_vector_axes};
use super::parts::{Drive, about, along};
use super::{Geometry, Law, Rows};
use crate::error::Result;

/// What an axis may do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[repr(i32)]
pub enum AxisMode {
    /// No row of its own; spring, motor and friction act.
    Free = 0,
    /// Held at 0.
    #[default]
    Locked = 1,
    /// Kept within the drive's limits.
    Limited = 2,
}

/// One axis.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Axis {
    /// Default locked.
    pub mode: AxisMode,
    /// What acts on it; its limit counts where the mode is `Limited`.
    pub drive: Drive,
}

/// Six axes.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct SixDofJoint {
    /// Along x, y, z of frame A \[m\].
    pub linear: [Axis; 3],
    /// About them \[rad\].
    pub angular: [Axis; 3],
}

impl SixDofJoint {
    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        self.linear.iter().chain(&self.angular).try_for_each(|axis| axis.drive.validate())
    }

    /// See the module.
    pub fn emit(&self, g: &Geometry, rows: &mut impl Rows) {
        let arms = g.arms_at_b();
        let turn = rotation_vector(&g.relative());
        for k in 0..3 {
            let u = g.axis(0, k);
            emit_axis(&self.linear[k], along(u, arms), g.d.dot(&u), false, rows);
        }
        let axes = rotation_vector_axes(turn);
        for k in 0..3 {
            emit_axis(&self.angular[k], about(in_world(&g.q[0], axes[k])), turn[k], true, rows);
        }
    }
}

fn emit_axis(
    axis: &Axis,
    sides: [super::Side; 2],
    c: crate::math::Float,
    angular: bool,
    rows: &mut impl Rows,
) {
    if axis.mode == AxisMode::Locked {
        rows.general(sides, c, Law::Equal, angular);
        return;
    }
    let mut drive = axis.drive;
    drive.limit.enable = axis.mode == AxisMode::Limited;
    drive.emit(sides, c, angular, rows);
}
