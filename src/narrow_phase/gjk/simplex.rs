//! One to four points of the difference A − B, and what a sub-algorithm makes of them.

use crate::shape::Wide;

/// A vertex of the difference A − B, and the points of A and B that make it.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::narrow_phase) struct Vertex {
    pub w: Wide,
    pub id: (u16, u16),
}

/// One weight a vertex: of those a simplex lacks, zero.
pub(super) type Weights = [f64; 4];

/// Finds the point of a simplex closest to the origin.
pub(super) trait SubAlgorithm {
    /// The weights of that point: none negative, their sum 1, zero for the vertices that do not carry it. All four
    /// are positive only where the origin lies in the tetrahedron. The simplex has at least one vertex, which may
    /// coincide, lie on a line or in a plane.
    fn weights(simplex: &Simplex) -> Weights;
}

/// One to four vertices, with the weights of the point closest to the origin.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::narrow_phase) struct Simplex {
    v: [Vertex; 4],
    weight: Weights,
    len: usize,
}

impl Simplex {
    pub fn push(&mut self, v: Vertex) {
        self.v[self.len] = v;
        self.len += 1;
    }

    pub fn len(&self) -> usize {
        self.len
    }

    pub fn vertices(&self) -> &[Vertex] {
        &self.v[..self.len]
    }

    pub fn holds(&self, id: (u16, u16)) -> bool {
        self.vertices().iter().any(|v| v.id == id)
    }

    /// The place of vertex `i`.
    #[inline(always)]
    pub(super) fn w(&self, i: usize) -> Wide {
        self.v[i].w
    }

    /// The largest coordinate.
    #[inline]
    pub fn scale(&self) -> f64 {
        self.vertices().iter().fold(0.0, |s, v| largest(&v.w).max(s))
    }

    /// The unit vector along `v`, the point closest to the origin. Where that lies in a triangle, the normal of the
    /// triangle has more digits than a short `v`, unless the triangle is narrower still.
    pub fn direction(&self, v: Wide) -> Wide {
        let vv = v.dot(&v);
        if self.len == 3 {
            let (a, b, c) = (self.v[0].w, self.v[1].w, self.v[2].w);
            let n = (b - a).cross(&(c - a));
            let nn = n.dot(&n);
            let longest = (b - a).norm_squared().max((c - a).norm_squared()).max((c - b).norm_squared());
            if nn > vv * longest {
                let n = n / nn.sqrt();
                return if n.dot(&v) < 0.0 { -n } else { n };
            }
        }
        v / vv.sqrt()
    }

    /// The weights of the point closest to the origin.
    pub fn weights(&self) -> &[f64] {
        &self.weight[..self.len]
    }

    /// Keeps the vertices that carry the point closest to the origin and returns that point. All four stay only
    /// where the origin lies inside.
    #[inline(always)]
    pub(super) fn reduce<S: SubAlgorithm>(&mut self) -> Wide {
        self.weight = S::weights(self);
        let mut kept = 0;
        for i in 0..self.len {
            if self.weight[i] > 0.0 {
                (self.v[kept], self.weight[kept]) = (self.v[i], self.weight[i]);
                kept += 1;
            }
        }
        self.len = kept;
        self.weight[kept..].fill(0.0);
        self.point(&self.weight)
    }

    /// The point that mixes the vertices with these weights.
    #[inline]
    pub(super) fn point(&self, weight: &Weights) -> Wide {
        let v = &self.v;
        v[0].w * weight[0] + v[1].w * weight[1] + v[2].w * weight[2] + v[3].w * weight[3]
    }
}

/// The best of several faces.
pub(super) struct Best {
    square: f64,
    pub weight: Weights,
}

impl Best {
    pub fn new() -> Self {
        Self { square: f64::INFINITY, weight: [0.0; 4] }
    }

    #[inline]
    pub fn offer(&mut self, simplex: &Simplex, weight: Weights) {
        let p = simplex.point(&weight);
        let square = p.dot(&p);
        if square < self.square {
            *self = Self { square, weight };
        }
    }
}

/// The largest |coordinate|.
#[inline(always)]
pub(in crate::narrow_phase) fn largest(v: &Wide) -> f64 {
    v.x.abs().max(v.y.abs()).max(v.z.abs())
}
