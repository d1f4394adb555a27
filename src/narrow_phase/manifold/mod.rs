//! From the normal to the points: which of the common area of two faces becomes contact points.
//!
//! Contract: [`faces`] gets a face of A whose normal is the contact's, finds the face of B that looks at it most, and
//! leaves at most four points in the frame of A: those of the common area, seen along the normal, whose gap is at
//! most the margin. The same features give the same numbers from step to step.
//!
//! | kind | idea | paper | cost | when to pick it | where it fails |
//! |---|---|---|---|---|---|
//! | [`SutherlandHodgman`](ManifoldKind::SutherlandHodgman) | B's face is cut by the sides of A's, in space | Sutherland & Hodgman 1974 | least, no memory | always: this is `Auto` | convex faces only |
//! | [`Clipper2`](ManifoldKind::Clipper2) | both faces are projected to the plane, intersected as polygons and projected back | the thesis, 5.4; Vatti 1992 | some µs and allocations a pair | to compare with the thesis | corners move by the grid, 10⁻⁹ of a face |
//!
//! Faces without area never get here with an area to intersect: a sphere's is a point, a capsule's a segment. Their
//! contacts with faces, edges and each other have closed forms, which all kinds share, as do pairs of edges.

#[cfg(feature = "clipper2")]
mod clipper2;
pub(super) mod reduce;
pub(super) mod sutherland_hodgman;
#[cfg(test)]
mod tests;

use super::contact::Manifold;
use super::frame::Frame;
use crate::math::Float;
use crate::shape::Polytope;

/// How contact points are found where two faces meet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum ManifoldKind {
    /// Whatever is best: today the same as `SutherlandHodgman`.
    #[default]
    Auto = 0,
    /// The face of B is cut by the sides of A's face.
    SutherlandHodgman = 1,
    /// Both faces are intersected by the polygon library Clipper2. Needs the cargo feature `clipper2`.
    Clipper2 = 2,
}

impl ManifoldKind {
    /// All kinds.
    #[rustfmt::skip]
    pub const ALL: [ManifoldKind; 3] = [
        Self::Auto,
        Self::SutherlandHodgman,
        Self::Clipper2,
    ];

    /// The name in lists and charts.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::SutherlandHodgman => "sutherland_hodgman",
            Self::Clipper2 => "clipper2",
        }
    }

    /// Whether this build of the library has it.
    #[must_use]
    pub fn is_built(self) -> bool {
        self != Self::Clipper2 || cfg!(feature = "clipper2")
    }
}

/// By what share of the thinner shape's inner radius a corner may stand outside a side and still count as inside.
/// Boxes of equal size lie exactly on top of each other all the time: without this, rounding would decide in each
/// step anew whether a corner belongs to the one or the other.
pub(super) const FLUSH: Float = 1e-4;

/// Fills `out` with the contact of face `face` of `p` with the face of `q` that looks at it most, in the frame of
/// `p`: `p` is A and `q` is B.
#[inline]
pub(super) fn faces<P: Polytope, Q: Polytope>(
    kind: ManifoldKind,
    p: &P,
    q: &Q,
    frame: &Frame,
    face: usize,
    margin: Float,
    out: &mut Manifold,
) {
    match kind {
        #[cfg(feature = "clipper2")]
        ManifoldKind::Clipper2 => clipper2::faces(p, q, frame, face, margin, out),
        _ => sutherland_hodgman::faces(p, q, frame, face, margin, out),
    }
}
