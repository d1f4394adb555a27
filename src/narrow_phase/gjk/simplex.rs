//! The point of a simplex closest to the origin, by signed volumes: the barycentric coordinates are ratios of
//! determinants taken in the coordinate plane where the simplex is largest, and their signs tell which faces to
//! look at next. Unlike Johnson's recursion this stays right on flat simplices.

use crate::shape::Wide;

/// A vertex of the difference A − B, and the points of A and B that make it.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::narrow_phase) struct Vertex {
    pub w: Wide,
    pub id: (u16, u16),
}

/// One to four vertices, with the weights of the point closest to the origin.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::narrow_phase) struct Simplex {
    v: [Vertex; 4],
    weight: [f64; 4],
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
    pub fn reduce(&mut self) -> Wide {
        self.weight = match self.len {
            1 => [1.0, 0.0, 0.0, 0.0],
            2 => self.segment([0, 1]),
            3 => self.triangle([0, 1, 2]),
            _ => self.tetrahedron(),
        };
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

    #[inline]
    fn point(&self, weight: &Weights) -> Wide {
        let v = &self.v;
        v[0].w * weight[0] + v[1].w * weight[1] + v[2].w * weight[2] + v[3].w * weight[3]
    }

    #[inline]
    fn segment(&self, [i, j]: [usize; 2]) -> Weights {
        let (p, q) = (self.v[i].w, self.v[j].w);
        let d = q - p;
        let dd = d.dot(&d);
        let t = if dd > 0.0 { (-p.dot(&d) / dd).clamp(0.0, 1.0) } else { 0.0 };
        let mut weight = [0.0; 4];
        (weight[i], weight[j]) = (1.0 - t, t);
        weight
    }

    #[inline]
    fn triangle(&self, [i, j, k]: [usize; 3]) -> Weights {
        let (a, b, c) = (self.v[i].w, self.v[j].w, self.v[k].w);
        let n = (b - a).cross(&(c - a));
        let nn = n.dot(&n);
        // Which corners have no part in the closest point: all may, where the triangle has no area.
        let mut outside = [true; 3];
        if nn > 0.0 {
            let o = n * (a.dot(&n) / nn);
            // Drop the coordinate along which the triangle is seen best.
            let (whole, area_bc, area_ca, area_ab) = match (n.x.abs(), n.y.abs(), n.z.abs()) {
                (x, y, z) if x >= y && x >= z => {
                    (n.x, minor(&b, &c, &o, 1, 2), minor(&c, &a, &o, 1, 2), minor(&a, &b, &o, 1, 2))
                }
                (_, y, z) if y >= z => {
                    (n.y, minor(&b, &c, &o, 2, 0), minor(&c, &a, &o, 2, 0), minor(&a, &b, &o, 2, 0))
                }
                _ => (n.z, minor(&b, &c, &o, 0, 1), minor(&c, &a, &o, 0, 1), minor(&a, &b, &o, 0, 1)),
            };
            outside = [area_bc * whole <= 0.0, area_ca * whole <= 0.0, area_ab * whole <= 0.0];
            if outside == [false; 3] {
                let scale = 1.0 / (area_bc + area_ca + area_ab);
                let mut weight = [0.0; 4];
                (weight[i], weight[j], weight[k]) = (area_bc * scale, area_ca * scale, area_ab * scale);
                return weight;
            }
        }
        let mut best = Best::new();
        for (f, edge) in [[j, k], [k, i], [i, j]].into_iter().enumerate() {
            if outside[f] {
                best.offer(self, self.segment(edge));
            }
        }
        best.weight
    }

    fn tetrahedron(&self) -> Weights {
        let (a, b, c, d) = (self.v[0].w, self.v[1].w, self.v[2].w, self.v[3].w);
        let (bc, da) = (b.cross(&c), d.cross(&a));
        let part = [-bc.dot(&d), da.dot(&c), -da.dot(&b), bc.dot(&a)];
        let whole = part[0] + part[1] + part[2] + part[3];
        // A flat tetrahedron tells nothing by its signs.
        let size = self.scale();
        let flat = whole.abs() <= 1e-14 * size * size * size;
        let mut best = Best::new();
        let mut inside = true;
        for (f, face) in [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]].into_iter().enumerate() {
            let outside = part[f] * whole <= 0.0;
            inside &= !outside;
            if outside || flat {
                best.offer(self, self.triangle(face));
            }
        }
        if inside {
            [part[0] / whole, part[1] / whole, part[2] / whole, part[3] / whole]
        } else {
            best.weight
        }
    }
}

/// One weight a vertex.
type Weights = [f64; 4];

/// The best of several faces.
struct Best {
    square: f64,
    weight: Weights,
}

impl Best {
    fn new() -> Self {
        Self { square: f64::INFINITY, weight: [0.0; 4] }
    }

    #[inline]
    fn offer(&mut self, simplex: &Simplex, weight: Weights) {
        let p = simplex.point(&weight);
        let square = p.dot(&p);
        if square < self.square {
            *self = Self { square, weight };
        }
    }
}

/// Twice the signed area of the triangle o p q, seen in the plane of coordinates y and z.
#[inline(always)]
fn minor(p: &Wide, q: &Wide, o: &Wide, y: usize, z: usize) -> f64 {
    (p[y] - o[y]) * (q[z] - o[z]) - (p[z] - o[z]) * (q[y] - o[y])
}

/// The largest |coordinate|.
#[inline(always)]
pub(in crate::narrow_phase) fn largest(v: &Wide) -> f64 {
    v.x.abs().max(v.y.abs()).max(v.z.abs())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::testing::Random;
    use crate::shape::wide;

    /// The distance to the origin by a projected-gradient search over a fine grid of weights would be coarse; the
    /// optimality condition is exact: p · (w − p) ≥ 0 for all vertices w.
    #[test]
    fn the_closest_point_satisfies_the_optimality_condition() {
        let mut random = Random(11);
        for round in 0..20_000 {
            let len = 2 + round % 3;
            let flat = if round % 5 == 0 { 1e-7 } else { 1.0 };
            let shift = wide(random.vec(1.0));
            let mut s = Simplex::default();
            for i in 0..len {
                let mut w = wide(random.vec(1.0));
                w.z *= flat;
                s.push(Vertex { w: w + shift * (round % 2) as f64, id: (i as u16, 0) });
            }
            let all = s;
            let p = s.reduce();
            if s.len() == 4 {
                continue;
            }
            for v in all.vertices() {
                assert!(p.dot(&(v.w - p)) >= -1e-12, "round {round}: {}", p.dot(&(v.w - p)));
            }
        }
    }
}
