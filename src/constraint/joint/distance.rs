//! Two points at a distance: a rod, a rope, or a spring.
//!
//! With d from A's point to B's and u = d/|d|:
//!   C = |d| − length,  Ċ = u · (ḋ_B − ḋ_A)
//! Rigid unless the spring is enabled; then the limits (a rope is an upper limit and no spring force) and the motor
//! act, too. A rigid joint of length 0 holds the points together; a spring of length 0 pulls along three axes.

use super::parts::{Limit, Motor, along};
use super::{Geometry, Law, Rows};
use crate::error::{Error, ErrorCode, Result, check};
use crate::math::{Float, length};

/// Two points at a distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistanceJoint {
    /// The rod's length, or where the spring rests \[m\], ≥ 0; default 1.
    pub length: Float,
    /// Whether the joint gives: else it is a rod. Default false.
    pub enable_spring: bool,
    /// Frequency \[Hz\], ≥ 0; 0, the default, is a spring without force.
    pub hertz: Float,
    /// ≥ 0; default 0.
    pub damping_ratio: Float,
    /// The spring's force, pushing when positive: the least (how hard it can pull) and the greatest \[N\]. Default ±∞.
    pub spring_force: [Float; 2],
    /// Least and greatest length, where the spring is enabled.
    pub limit: Limit,
    /// Changes the length, where the spring is enabled.
    pub motor: Motor,
}

impl Default for DistanceJoint {
    fn default() -> Self {
        Self {
            length: 1.0,
            enable_spring: false,
            hertz: 0.0,
            damping_ratio: 0.0,
            spring_force: [Float::NEG_INFINITY, Float::INFINITY],
            limit: Limit::default(),
            motor: Motor::default(),
        }
    }
}

/// Below this distance \[m\] two points have no direction between them.
const NO_DIRECTION: Float = 1e-6;

impl DistanceJoint {
    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        check::not_negative("length", self.length)?;
        check::not_negative("hertz", self.hertz)?;
        check::not_negative("damping_ratio", self.damping_ratio)?;
        self.limit.validate()?;
        check::not_negative("minimum length", self.limit.lower)?;
        self.motor.validate()?;
        let [lower, upper] = self.spring_force;
        if lower <= upper {
            Ok(())
        } else {
            Err(Error::new(
                ErrorCode::Range,
                format!("The spring force runs from {lower} to {upper}; the lower one must come first."),
            ))
        }
    }

    /// See the module.
    pub fn emit(&self, g: &Geometry, rows: &mut impl Rows) {
        let size = length(g.d);
        let spring =
            Law::Spring { hertz: self.hertz, damping_ratio: self.damping_ratio, force: self.spring_force };
        let pulls = self.enable_spring && self.hertz > 0.0;
        if self.length == 0.0 && (pulls || !self.enable_spring) {
            g.hold_points(rows, if pulls { spring } else { Law::Equal });
        }
        let u = if size > NO_DIRECTION { g.d / size } else { g.axis(0, 0) };
        // The impulse acts along the line through both points: their moment is the same about either.
        let sides = along(u, g.arm);
        if !self.enable_spring {
            if self.length > 0.0 {
                rows.general(sides, size - self.length, Law::Equal, false);
            }
            return;
        }
        if pulls && self.length > 0.0 {
            rows.general(sides, size - self.length, spring, false);
        }
        if self.motor.enable {
            let law = Law::Motor { speed: self.motor.speed, max: self.motor.max_force };
            rows.general(sides, 0.0, law, false);
        }
        if self.limit.enable {
            if self.limit.lower == self.limit.upper {
                rows.general(sides, size - self.limit.lower, Law::Equal, false);
            } else {
                rows.general(sides, size - self.limit.lower, Law::AtLeast, false);
                let back = sides.map(super::Side::reversed);
                rows.general(back, self.limit.upper - size, Law::AtLeast, false);
            }
        }
    }

    /// Where the motor's row stands among those of `emit`.
    #[must_use]
    pub fn motor_row(&self) -> Option<usize> {
        let pulls = self.enable_spring && self.hertz > 0.0;
        let before = if !pulls {
            0
        } else if self.length == 0.0 {
            3
        } else {
            1
        };
        (self.enable_spring && self.motor.enable).then_some(before)
    }
}
