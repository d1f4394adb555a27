//! The distance between two cores: GJK (Gilbert, Johnson & Keerthi 1988). One loop, one rule for its end, and a choice
//! of sub-algorithms that find the point of a simplex closest to the origin.
//!
//! | kind | idea | paper | cost | when to pick it | where it fails |
//! |---|---|---|---|---|---|
//! | [`Barycentric`](GjkKind::Barycentric) | a linear system for the coordinates, recursion over faces | the thesis, 5.2.1 | slowest | as the oracle | nowhere seen; slow |
//! | [`CutSpace`](GjkKind::CutSpace) | in which Voronoi region is the origin? | the thesis, 5.2.2; Ericson 2005 | least | round and compact shapes | areas of slivers are rounding |
//! | [`SignedVolumes`](GjkKind::SignedVolumes) | signs of volumes, seen in the best coordinate plane | Montanari, Petrinic & Barbieri 2017 | low | always: this is `Auto` | – |
//! | [`Johnson`](GjkKind::Johnson) | cofactors of all faces, from small to large | Gilbert, Johnson & Keerthi 1988 | medium | to compare with older work | flat and thin simplices |
//!
//! Points and directions here are double in both builds. The differences of f32 coordinates are exact in double,
//! so that the sub-algorithm has digits to spare where plates, needles and thin gaps leave none in f32; the cost
//! is next to nothing, since the work is scalar.

mod barycentric;
mod cut_space;
mod johnson;
mod signed_volumes;
mod simplex;
#[cfg(test)]
mod tests;

use crate::math::scalar::double;
use crate::math::tolerance::{GJK_PROGRESS, GJK_TOUCH};
use crate::math::{Float, Pose};
use crate::shape::{CorePoints, Wide, wide};
use barycentric::Barycentric;
use cut_space::CutSpace;
use johnson::Johnson;
use signed_volumes::SignedVolumes;
pub(super) use simplex::{Simplex, Vertex};
use simplex::{SubAlgorithm, largest};

/// More iterations than any pair of shapes needs (the worst seen in fuzzing is below 40).
const MAX_ITERATIONS: u32 = 64;

/// How the point of a simplex closest to the origin is found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum GjkKind {
    /// Whatever is best: today the same as `SignedVolumes`.
    #[default]
    Auto = 0,
    /// A linear system for barycentric coordinates, with recursion over the faces: slow, the oracle.
    Barycentric = 1,
    /// The Voronoi regions of vertices, edges and faces.
    CutSpace = 2,
    /// Signs of volumes.
    SignedVolumes = 3,
    /// Cofactors, with a backup procedure.
    Johnson = 4,
}

impl GjkKind {
    /// All kinds.
    #[rustfmt::skip]
    pub const ALL: [GjkKind; 5] = [
        Self::Auto,
        Self::Barycentric,
        Self::CutSpace,
        Self::SignedVolumes,
        Self::Johnson,
    ];

    /// The name in lists and charts.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::Barycentric => "barycentric",
            Self::CutSpace => "cut_space",
            Self::SignedVolumes => "signed_volumes",
            Self::Johnson => "johnson",
        }
    }
}

/// The ways out of GJK.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Status {
    /// No point of the difference lies closer: the distance is exact up to rounding.
    Converged = 0,
    /// The next support point is one of the last: the distance is the best that rounding allows.
    Repeated = 1,
    /// An iteration came no closer: the distance is the best that rounding allows.
    Stalled = 2,
    /// The cores overlap: the distance is 0.
    Overlapping = 3,
    /// The cores are farther apart than the caller cares; the distance is a lower bound.
    Beyond = 4,
    /// Too many iterations: the distance is an upper bound.
    IterationLimit = 5,
}

impl Status {
    /// All ways out.
    pub const ALL: [Status; 6] = [
        Self::Converged,
        Self::Repeated,
        Self::Stalled,
        Self::Overlapping,
        Self::Beyond,
        Self::IterationLimit,
    ];

    /// The name in lists and charts.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::Repeated => "repeated",
            Self::Stalled => "stalled",
            Self::Overlapping => "overlapping",
            Self::Beyond => "beyond",
            Self::IterationLimit => "iteration_limit",
        }
    }
}

/// Two cores, B seen from A.
pub(super) struct Pair<'a> {
    a: CorePoints<'a>,
    b: CorePoints<'a>,
    rotation: nalgebra::Matrix3<f64>,
    position: Wide,
}

/// The closest points of two cores, in the frame of A.
pub(super) struct Closest {
    pub status: Status,
    pub iterations: u32,
    pub distance: f64,
    /// On the core of A and on that of B.
    pub a: Wide,
    pub b: Wide,
    /// From A to B; zero where the cores overlap.
    pub normal: Wide,
    pub simplex: Simplex,
}

impl<'a> Pair<'a> {
    pub fn new(a: CorePoints<'a>, b: CorePoints<'a>, pose: &Pose) -> Self {
        let q =
            nalgebra::Quaternion::new(double(pose.q.w), double(pose.q.i), double(pose.q.j), double(pose.q.k));
        let l2: f64 = q.w * q.w + q.i * q.i + q.j * q.j + q.k * q.k;
        let (s, x, y, z, w) = (2.0 / l2, q.i, q.j, q.k, q.w);
        let rotation = nalgebra::Matrix3::new(
            1.0 - s * (y * y + z * z),
            s * (x * y - w * z),
            s * (x * z + w * y),
            s * (x * y + w * z),
            1.0 - s * (x * x + z * z),
            s * (y * z - w * x),
            s * (x * z - w * y),
            s * (y * z + w * x),
            1.0 - s * (x * x + y * y),
        );
        Self { a, b, rotation, position: wide(pose.p) }
    }

    /// Moves B by `by`, in the frame of A.
    pub fn shift(&mut self, by: Wide) {
        self.position += by;
    }

    /// The vertex of the difference A − B farthest along `d`, which need not have length 1.
    #[inline]
    pub fn support(&self, d: Wide) -> Vertex {
        let ia = self.a.support(&d);
        let ib = self.b.support(&-self.rotation.tr_mul(&d));
        let w = wide(self.a.point(ia)) - (self.rotation * wide(self.b.point(ib)) + self.position);
        Vertex { w, id: (ia as u16, ib as u16) }
    }

    /// The points of A and of B that mix with these weights, in the frame of A.
    pub fn witnesses<'v>(&self, mix: impl IntoIterator<Item = (&'v Vertex, f64)>) -> (Wide, Wide) {
        let mut sum = (Wide::zeros(), Wide::zeros(), 0.0);
        for (v, k) in mix {
            sum.0 += wide(self.a.point(v.id.0 as usize)) * k;
            sum.1 += wide(self.b.point(v.id.1 as usize)) * k;
            sum.2 += k;
        }
        (sum.0, self.rotation * sum.1 + self.position * sum.2)
    }

    /// The gap between the cores along the unit normal `n`, from A to B; negative where they overlap.
    pub fn gap_along(&self, n: Wide) -> f64 {
        -n.dot(&self.support(n).w)
    }

    /// A point of the difference, well inside for all cores but clouds: from the middle of B to that of A.
    #[inline]
    pub fn between_centers(&self) -> Wide {
        wide(self.a.center()) - (self.rotation * wide(self.b.center()) + self.position)
    }

    /// A first guess.
    fn start(&self) -> Wide {
        let d = self.between_centers();
        if d.dot(&d) > 0.0 { d } else { Wide::y() }
    }

    /// The distance of the cores; gives up with `Beyond` once it is known to be more than `limit`.
    #[inline]
    pub fn distance(&self, kind: GjkKind, limit: Float) -> Closest {
        self.traced(kind, limit, |_| {})
    }

    /// The same; `trace` sees each simplex, reduced to what carries its closest point. Costs nothing where it does
    /// nothing.
    #[inline]
    pub fn traced(&self, kind: GjkKind, limit: Float, trace: impl FnMut(&Simplex)) -> Closest {
        match kind {
            GjkKind::Auto | GjkKind::SignedVolumes => self.search::<SignedVolumes>(limit, trace),
            GjkKind::Barycentric => self.search::<Barycentric>(limit, trace),
            GjkKind::CutSpace => self.search::<CutSpace>(limit, trace),
            GjkKind::Johnson => self.search::<Johnson>(limit, trace),
        }
    }

    fn search<S: SubAlgorithm>(&self, limit: Float, mut trace: impl FnMut(&Simplex)) -> Closest {
        let limit = double(limit);
        let mut simplex = Simplex::default();
        let mut v = self.start();
        simplex.push(self.support(-v));
        v = simplex.reduce::<S>();
        trace(&simplex);
        let mut scale = simplex.scale();
        let (mut status, mut iterations) = (Status::IterationLimit, 0);
        while iterations < MAX_ITERATIONS {
            iterations += 1;
            let vv = v.dot(&v);
            if vv <= GJK_TOUCH * scale * scale {
                status = Status::Overlapping;
                break;
            }
            let w = self.support(-v);
            scale = scale.max(largest(&w.w));
            let vw = v.dot(&w.w);
            let length = vv.sqrt();
            if vw > limit * length {
                status = Status::Beyond;
                v *= vw / vv;
                break;
            }
            if vv - vw <= GJK_PROGRESS * vv + 4.0 * f64::EPSILON * scale * length {
                status = Status::Converged;
                break;
            }
            if simplex.holds(w.id) {
                status = Status::Repeated;
                break;
            }
            let before = simplex;
            simplex.push(w);
            let next = simplex.reduce::<S>();
            trace(&simplex);
            if simplex.len() == 4 {
                status = Status::Overlapping;
                break;
            }
            if next.dot(&next) >= vv {
                simplex = before;
                status = Status::Stalled;
                break;
            }
            v = next;
        }
        let (a, b) = self.witnesses(simplex.vertices().iter().zip(simplex.weights().iter().copied()));
        let distance = if status == Status::Overlapping { 0.0 } else { v.dot(&v).sqrt() };
        let normal = if distance > 0.0 { -simplex.direction(v) } else { Wide::zeros() };
        Closest { status, iterations, distance, a, b, normal, simplex }
    }
}
