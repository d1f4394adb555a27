//! The point of a simplex closest to the origin, by signed volumes: the barycentric coordinates are ratios of
//! determinants taken in the coordinate plane where the simplex is largest, and their signs tell which faces to
//! look at next. Unlike Johnson's recursion this stays right on flat simplices.

use crate::shape::Wide;

/// A vertex of the difference A − B: w = a − b.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::narrow_phase) struct Vertex {
    pub a: Wide,
    pub b: Wide,
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
    pub fn scale(&self) -> f64 {
        self.vertices().iter().map(|v| v.w.amax()).fold(0.0, f64::max)
    }

    /// The closest points of A and B.
    pub fn witnesses(&self) -> (Wide, Wide) {
        let mut sum = (Wide::zeros(), Wide::zeros());
        for (v, &k) in self.vertices().iter().zip(&self.weight) {
            sum.0 += v.a * k;
            sum.1 += v.b * k;
        }
        sum
    }

    /// Keeps the vertices that carry the point closest to the origin and returns that point. All four stay only
    /// where the origin lies inside.
    pub fn reduce(&mut self) -> Wide {
        let all = [0, 1, 2, 3];
        self.weight = match self.len {
            1 => [1.0, 0.0, 0.0, 0.0],
            2 => self.segment([0, 1]),
            3 => self.triangle([0, 1, 2]),
            _ => self.tetrahedron(all),
        };
        let mut kept = 0;
        for i in all {
            if i < self.len && self.weight[i] > 0.0 {
                (self.v[kept], self.weight[kept]) = (self.v[i], self.weight[i]);
                kept += 1;
            }
        }
        self.len = kept;
        self.weight[kept..].fill(0.0);
        self.point(&self.weight)
    }

    fn point(&self, weight: &[f64; 4]) -> Wide {
        let mut p = Wide::zeros();
        for (v, &k) in self.v.iter().zip(weight) {
            if k != 0.0 {
                p += v.w * k;
            }
        }
        p
    }

    fn segment(&self, [i, j]: [usize; 2]) -> [f64; 4] {
        let (p, q) = (self.v[i].w, self.v[j].w);
        let d = q - p;
        let dd = d.dot(&d);
        let t = if dd > 0.0 { (-p.dot(&d) / dd).clamp(0.0, 1.0) } else { 0.0 };
        let mut weight = [0.0; 4];
        (weight[i], weight[j]) = (1.0 - t, t);
        weight
    }

    fn triangle(&self, [i, j, k]: [usize; 3]) -> [f64; 4] {
        let (a, b, c) = (self.v[i].w, self.v[j].w, self.v[k].w);
        let n = (b - a).cross(&(c - a));
        let nn = n.dot(&n);
        if nn > 0.0 {
            let o = n * (a.dot(&n) / nn);
            // Drop the coordinate along which the triangle is seen best.
            let x = n.iamax();
            let (y, z) = ((x + 1) % 3, (x + 2) % 3);
            let area = |p: &Wide, q: &Wide| (p[y] - o[y]) * (q[z] - o[z]) - (p[z] - o[z]) * (q[y] - o[y]);
            let part = [area(&b, &c), area(&c, &a), area(&a, &b)];
            let whole = n[x];
            let outside = part.map(|p| p * whole <= 0.0);
            if outside == [false; 3] {
                let sum = part[0] + part[1] + part[2];
                let mut weight = [0.0; 4];
                (weight[i], weight[j], weight[k]) = (part[0] / sum, part[1] / sum, part[2] / sum);
                return weight;
            }
            return self.closest_of(
                [(outside[0], [j, k]), (outside[1], [k, i]), (outside[2], [i, j])],
                Self::segment,
            );
        }
        self.closest_of([(true, [j, k]), (true, [k, i]), (true, [i, j])], Self::segment)
    }

    fn tetrahedron(&self, [i, j, k, l]: [usize; 4]) -> [f64; 4] {
        let [a, b, c, d] = self.v.map(|v| v.w);
        let volume = |p: &Wide, q: &Wide, r: &Wide| p.dot(&q.cross(r));
        let part = [volume(&b, &d, &c), volume(&a, &c, &d), volume(&a, &d, &b), volume(&a, &b, &c)];
        let whole = part[0] + part[1] + part[2] + part[3];
        let outside = part.map(|p| p * whole <= 0.0);
        if outside == [false; 4] {
            return part.map(|p| p / whole);
        }
        let faces = [[j, k, l], [i, k, l], [i, j, l], [i, j, k]];
        // A flat tetrahedron tells nothing by its signs.
        let size = self.scale();
        let flat = whole.abs() <= 1e-14 * size * size * size;
        self.closest_of([0, 1, 2, 3].map(|f| (flat || outside[f], faces[f])), Self::triangle)
    }

    /// The best of the chosen faces.
    fn closest_of<const N: usize, F>(
        &self,
        faces: [(bool, F); N],
        solve: impl Fn(&Self, F) -> [f64; 4],
    ) -> [f64; 4] {
        let mut best = (f64::INFINITY, [0.0; 4]);
        for (_, face) in faces.into_iter().filter(|f| f.0) {
            let weight = solve(self, face);
            let p = self.point(&weight);
            let d = p.dot(&p);
            if d < best.0 {
                best = (d, weight);
            }
        }
        best.1
    }
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
                s.push(Vertex { w: w + shift * (round % 2) as f64, id: (i as u16, 0), ..Vertex::default() });
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
