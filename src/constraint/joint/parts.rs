//! What several joints have: springs, limits, motors and dry friction on one coordinate.

use super::{Law, Rows, Side};
use crate::error::{Error, ErrorCode, Result, check};
use crate::math::{Float, Vec3};

/// A spring and its damper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// Default false.
    pub enable: bool,
    /// Frequency of the undamped oscillation \[Hz\], ≥ 0; default 0, no effect.
    pub hertz: Float,
    /// 1 is critical; ≥ 0, default 0.
    pub damping_ratio: Float,
    /// Greatest force \[N\] or torque \[N m\], ≥ 0, may be infinite; default ∞.
    pub max_force: Float,
}

impl Default for Spring {
    fn default() -> Self {
        Self { enable: false, hertz: 0.0, damping_ratio: 0.0, max_force: Float::INFINITY }
    }
}

impl Spring {
    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        check::not_negative("hertz", self.hertz)?;
        check::not_negative("damping_ratio", self.damping_ratio)?;
        at_most(self.max_force, "max_force")
    }

    /// The law of its row.
    #[must_use]
    pub fn law(&self) -> Law {
        let force = [-self.max_force, self.max_force];
        Law::Spring { hertz: self.hertz, damping_ratio: self.damping_ratio, force }
    }

    fn acts(&self) -> bool {
        self.enable && self.hertz > 0.0
    }
}

/// Bounds of a coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Limit {
    /// Default false.
    pub enable: bool,
    /// \[m\] or \[rad\]; default 0.
    pub lower: Float,
    /// ≥ lower; default 0.
    pub upper: Float,
}

impl Limit {
    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        check::finite("lower limit", self.lower)?;
        check::finite("upper limit", self.upper)?;
        if self.lower > self.upper {
            return Err(Error::new(
                ErrorCode::Range,
                format!("The limits are {} and {}; the lower one must come first.", self.lower, self.upper),
            ));
        }
        Ok(())
    }
}

/// A motor that wants a speed.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Motor {
    /// Default false.
    pub enable: bool,
    /// \[m/s\] or \[rad/s\]; default 0.
    pub speed: Float,
    /// Greatest force \[N\] or torque \[N m\], ≥ 0, may be infinite; default 0.
    pub max_force: Float,
}

impl Motor {
    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        check::finite("motor speed", self.speed)?;
        at_most(self.max_force, "max_force")
    }
}

/// All that may act on one free coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Drive {
    /// Towards `target`.
    pub spring: Spring,
    /// Where the spring rests \[m\] or \[rad\]; default 0.
    pub target: Float,
    /// Bounds.
    pub limit: Limit,
    /// Motor.
    pub motor: Motor,
    /// Force of dry friction \[N\] or \[N m\], ≥ 0; default 0.
    pub friction: Float,
}

impl Drive {
    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        self.spring.validate()?;
        check::finite("target", self.target)?;
        self.limit.validate()?;
        self.motor.validate()?;
        at_most(self.friction, "friction")
    }

    /// Its rows for the coordinate `c`, whose rate the sides give.
    pub fn emit(&self, sides: [Side; 2], c: Float, angular: bool, rows: &mut impl Rows) {
        if self.spring.acts() {
            rows.general(sides, c - self.target, self.spring.law(), angular);
        }
        if self.friction > 0.0 {
            rows.general(sides, 0.0, Law::Motor { speed: 0.0, max: self.friction }, angular);
        }
        if self.motor.enable {
            let law = Law::Motor { speed: self.motor.speed, max: self.motor.max_force };
            rows.general(sides, 0.0, law, angular);
        }
        if self.limit.enable {
            if self.limit.lower == self.limit.upper {
                rows.general(sides, c - self.limit.lower, Law::Equal, angular);
            } else {
                rows.general(sides, c - self.limit.lower, Law::AtLeast, angular);
                rows.general(sides.map(Side::reversed), self.limit.upper - c, Law::AtLeast, angular);
            }
        }
    }

    /// Where the motor's row stands among those of `emit`.
    #[must_use]
    pub fn motor_row(&self) -> Option<usize> {
        self.motor.enable.then(|| usize::from(self.spring.acts()) + usize::from(self.friction > 0.0))
    }
}

/// The sides of a turn of B against A about `u`.
#[inline]
#[must_use]
pub fn about(u: Vec3) -> [Side; 2] {
    let zero = Vec3::zeros();
    [Side { linear: zero, angular: -u }, Side { linear: zero, angular: u }]
}

/// The sides of a slide of B against A along `u`, with arms to where it acts.
#[inline]
#[must_use]
pub fn along(u: Vec3, [a, b]: [Vec3; 2]) -> [Side; 2] {
    [Side { linear: -u, angular: -a.cross(&u) }, Side { linear: u, angular: b.cross(&u) }]
}

/// A bound on a force: not negative, maybe infinite.
pub fn at_most(x: Float, name: &str) -> Result<()> {
    if x >= 0.0 {
        Ok(())
    } else if x.is_nan() {
        Err(Error::new(ErrorCode::NotFinite, format!("{name} is {x}; it must be a number.")))
    } else {
        Err(Error::new(ErrorCode::Range, format!("{name} is {x}; it must not be negative.")))
    }
}
