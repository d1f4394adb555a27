//! A rope that runs from body A over a fixed point, to another, and down to body B, with a hoist between them:
//!   length = |a − ground_a| + ratio · |b − ground_b|
//! is kept within the rope's least and greatest length; where they are the same it is a rod that bends.

use super::{Geometry, Law, Rows, Side};
use crate::error::{Error, ErrorCode, Result, check};
use crate::math::{Float, Vec3, length};

/// A rope over two fixed points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PulleyJoint {
    /// The fixed points, in the world \[m\].
    pub ground: [Vec3; 2],
    /// How many lengths of rope hold B for each that holds A; > 0, default 1.
    pub ratio: Float,
    /// Least length \[m\], ≥ 0; default 0: it is slack.
    pub min_length: Float,
    /// Greatest length \[m\]; default 0: what it is when the joint is made.
    pub max_length: Float,
}

impl Default for PulleyJoint {
    fn default() -> Self {
        Self { ground: [Vec3::zeros(); 2], ratio: 1.0, min_length: 0.0, max_length: 0.0 }
    }
}

impl PulleyJoint {
    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        check::point("ground anchor A", self.ground[0])?;
        check::point("ground anchor B", self.ground[1])?;
        check::positive("ratio", self.ratio)?;
        check::not_negative("min_length", self.min_length)?;
        check::not_negative("max_length", self.max_length)?;
        if self.max_length > 0.0 && self.min_length > self.max_length {
            return Err(Error::new(
                ErrorCode::Range,
                format!(
                    "The lengths are {} and {}; the lesser must come first.",
                    self.min_length, self.max_length
                ),
            ));
        }
        Ok(())
    }

    /// The parts of the rope at A and at B, as vectors from the fixed points.
    #[must_use]
    pub fn parts(&self, g: &Geometry) -> [Vec3; 2] {
        [g.origin_a - self.ground[0], g.origin_a + g.d - self.ground[1]]
    }

    /// The rope's length \[m\].
    #[must_use]
    pub fn length(&self, g: &Geometry) -> Float {
        let [a, b] = self.parts(g).map(length);
        a + self.ratio * b
    }

    /// See the module.
    pub fn emit(&self, g: &Geometry, rows: &mut impl Rows) {
        let parts = self.parts(g);
        let unit = |v: Vec3| {
            let l = length(v);
            if l > 1e-6 { v / l } else { Vec3::y() }
        };
        let (u, w) = (unit(parts[0]), unit(parts[1]) * self.ratio);
        let sides = [
            Side { linear: u, angular: g.arm[0].cross(&u) },
            Side { linear: w, angular: g.arm[1].cross(&w) },
        ];
        let size = length(parts[0]) + self.ratio * length(parts[1]);
        if self.min_length == self.max_length {
            rows.general(sides, size - self.max_length, Law::Equal, false);
        } else {
            rows.general(sides.map(Side::reversed), self.max_length - size, Law::AtLeast, false);
            rows.general(sides, size - self.min_length, Law::AtLeast, false);
        }
    }
}
