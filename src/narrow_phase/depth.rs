//! What the ways to the depth of two overlapping cores have in common: their answer and their ways out.

use super::gjk::{Pair, Simplex};
use crate::shape::Wide;

/// The ways out of EPA and MPR.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum DepthStatus {
    /// The face or portal lies on the surface: the depth along its normal is exact up to rounding.
    Converged = 0,
    /// The shapes do not overlap: the depth is 0.
    Apart = 1,
    /// The difference has no volume (two segments, say): the depth is 0 and the normal leaves its plane or line.
    Flat = 2,
    /// There is no room for more vertices: the depth is that of the best normal so far.
    Full = 3,
    /// The next support point is one of the polytope's: the depth is the best that rounding allows.
    Repeated = 4,
    /// A new face would have no area or the polytope no closed rim: the depth is that of the best normal so far.
    Degenerate = 5,
    /// Too many iterations: the depth is that of the best normal so far.
    IterationLimit = 6,
}

impl DepthStatus {
    /// All ways out.
    pub const ALL: [DepthStatus; 7] = [
        Self::Converged,
        Self::Apart,
        Self::Flat,
        Self::Full,
        Self::Repeated,
        Self::Degenerate,
        Self::IterationLimit,
    ];

    /// The name in lists and charts.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::Apart => "apart",
            Self::Flat => "flat",
            Self::Full => "full",
            Self::Repeated => "repeated",
            Self::Degenerate => "degenerate",
            Self::IterationLimit => "iteration_limit",
        }
    }
}

/// How deep two cores overlap, in the frame of A.
#[derive(Clone, Copy, Debug)]
pub(super) struct Depth {
    pub status: DepthStatus,
    pub iterations: u32,
    /// How far B must move along the normal to leave A.
    pub depth: f64,
    /// From A to B, of length 1.
    pub normal: Wide,
    /// On the surface of A and on that of B.
    pub a: Wide,
    pub b: Wide,
}

/// A way to the depth, from the simplex with which GJK found the overlap.
pub(super) type Method = fn(&Pair, &Simplex) -> Depth;
