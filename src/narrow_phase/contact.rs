use crate::math::{Float, Pose, Vec3};

/// The most points a manifold has.
pub const MAX_MANIFOLD_POINTS: usize = 4;

/// One point of contact between shape A and shape B, in the frame of A.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ManifoldPoint {
    /// The middle between the two surfaces along the normal \[m\].
    pub point: Vec3,
    /// The gap along the normal \[m\]: positive apart, negative overlapping.
    pub separation: Float,
    /// Which features of A and B made this point; the same features give the same number in the next step.
    pub feature: u32,
}

/// The contact between two convex shapes: up to four points that share a normal.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Manifold {
    /// The unit normal, from A to B, in the frame of A.
    pub normal: Vec3,
    /// The points, the first `count` of them.
    pub points: [ManifoldPoint; MAX_MANIFOLD_POINTS],
    /// How many points there are, 0 … 4.
    pub count: usize,
}

impl Manifold {
    /// The points.
    #[must_use]
    #[inline]
    pub fn points(&self) -> &[ManifoldPoint] {
        &self.points[..self.count]
    }

    /// Adds a point; there must be room.
    #[inline]
    pub(super) fn push(&mut self, point: Vec3, separation: Float, feature: u32) {
        self.points[self.count] = ManifoldPoint { point, separation, feature };
        self.count += 1;
    }

    /// Makes this manifold the only point between two balls around `p` and `q`, if their gap is at most `margin`.
    /// `fallback` is the normal of concentric balls.
    #[inline]
    pub(super) fn between_balls(
        &mut self,
        (p, r): (Vec3, Float),
        (q, s): (Vec3, Float),
        margin: Float,
        fallback: Vec3,
        id: u32,
    ) {
        let d = q - p;
        let distance = crate::math::length(d);
        if distance - (r + s) > margin {
            return;
        }
        let tiny = Float::MIN_POSITIVE.sqrt();
        self.normal = if distance > tiny { d / distance } else { fallback };
        self.push(p + self.normal * (0.5 * (distance + r - s)), distance - (r + s), id);
    }

    /// From the manifold of (B, A) in the frame of B to that of (A, B) in the frame of A.
    pub(super) fn mirror(&mut self, a_from_b: &Pose) {
        self.normal = -a_from_b.vector(self.normal);
        for p in &mut self.points[..self.count] {
            p.point = a_from_b.point(p.point);
            p.feature = feature::mirrored(p.feature);
        }
    }
}

/// Numbers for the pairs of features that make a point: the kind in two bits, then 15 bits for each shape. They
/// name features of the shapes only, not which shape's face was clipped against, so that a contact keeps its
/// numbers when the reference face changes sides.
pub(super) mod feature {
    const SHIFT: u32 = 15;
    const MASK: u32 = (1 << SHIFT) - 1;
    const EDGES: u32 = 0;
    const VERTEX_A: u32 = 1;
    const VERTEX_B: u32 = 2;
    const OTHER: u32 = 3;

    const fn make(kind: u32, a: usize, b: usize) -> u32 {
        kind << (2 * SHIFT) | (a as u32 & MASK) << SHIFT | (b as u32 & MASK)
    }

    /// Where an edge of A crosses an edge of B.
    #[inline]
    pub const fn edges(a: usize, b: usize) -> u32 {
        make(EDGES, a, b)
    }

    /// A vertex of A (or the end of a capsule) on B.
    #[inline]
    pub const fn vertex_a(v: usize) -> u32 {
        make(VERTEX_A, v, 0)
    }

    /// A vertex of B on A.
    #[inline]
    pub const fn vertex_b(v: usize) -> u32 {
        make(VERTEX_B, 0, v)
    }

    /// A corner between two edges of the same shape that do not meet there: rounding made it.
    #[inline]
    pub const fn sliver(i: usize, j: usize) -> u32 {
        make(OTHER, i, j)
    }

    /// Another number for the same pair of features.
    #[inline]
    pub const fn twin(id: u32) -> u32 {
        id | OTHER << (2 * SHIFT)
    }

    /// The number of the same pair with A and B exchanged.
    #[inline]
    pub const fn mirrored(id: u32) -> u32 {
        let kind = match id >> (2 * SHIFT) {
            VERTEX_A => VERTEX_B,
            VERTEX_B => VERTEX_A,
            kind => kind,
        };
        make(kind, (id & MASK) as usize, (id >> SHIFT & MASK) as usize)
    }
}
