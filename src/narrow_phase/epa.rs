//! The depth of two overlapping cores: the expanding-polytope algorithm (van den Bergen 2001), which grows a
//! polytope inside the difference A − B until its face closest to the origin lies on the surface.
//!
//! In double, like GJK. The polytope lives on the stack.

use super::depth::{Depth, DepthStatus};
use super::gjk::{Pair, Simplex, Vertex};
use crate::math::tolerance::EPA_PROGRESS;
use crate::shape::Wide;

const MAX_VERTICES: usize = 64;
const MAX_FACES: usize = 2 * MAX_VERTICES;

#[derive(Clone, Copy, Default)]
struct Face {
    v: [u8; 3],
    normal: Wide,
    distance: f64,
}

struct Polytope {
    vertices: [Vertex; MAX_VERTICES],
    len: usize,
    faces: [Face; MAX_FACES],
    faces_len: usize,
}

/// The depth of the pair, from the simplex with which GJK found that it overlaps.
pub(super) fn depth(pair: &Pair, simplex: &Simplex) -> Depth {
    let (seed, len) = spread(pair, simplex);
    let seed = match (seed, len) {
        (seed, 4) => seed,
        (seed, len) => return flat(pair, &seed[..len]),
    };
    let scale = seed.iter().map(|v| v.w.amax()).fold(0.0, f64::max);
    let mut polytope = Polytope {
        vertices: [Vertex::default(); MAX_VERTICES],
        len: 4,
        faces: [Face::default(); MAX_FACES],
        faces_len: 0,
    };
    polytope.vertices[..4].copy_from_slice(&seed);
    let up = (seed[1].w - seed[0].w).cross(&(seed[2].w - seed[0].w)).dot(&(seed[3].w - seed[0].w));
    let [b, c] = if up > 0.0 { [2, 1] } else { [1, 2] };
    for v in [[0, b, c], [b, 0, 3], [c, b, 3], [0, c, 3]] {
        polytope.add(v);
    }
    let (mut status, mut iterations) = (DepthStatus::Full, 0);
    let mut best = polytope.closest();
    while polytope.len < MAX_VERTICES {
        iterations += 1;
        let w = pair.support(best.normal);
        if best.normal.dot(&w.w) - best.distance <= EPA_PROGRESS * scale {
            status = DepthStatus::Converged;
            break;
        }
        if polytope.vertices[..polytope.len].iter().any(|v| v.id == w.id) {
            status = DepthStatus::Repeated;
            break;
        }
        if !polytope.grow(w, scale) {
            status = DepthStatus::Degenerate;
            break;
        }
        best = polytope.closest();
    }
    let (a, b) = pair.witnesses(polytope.weights(&best, scale).iter().map(|(v, k)| (v, *k)));
    // What the best normal really gives, even where the search ended early.
    Depth { status, iterations, depth: -pair.gap_along(best.normal), normal: best.normal, a, b }
}

impl Polytope {
    /// Adds a face; `false` where it has no area or there is no room.
    fn add(&mut self, v: [u8; 3]) -> bool {
        let [a, b, c] = v.map(|i| self.vertices[i as usize].w);
        let n = (b - a).cross(&(c - a));
        let l = n.dot(&n).sqrt();
        if l <= 0.0 || self.faces_len == MAX_FACES {
            return false;
        }
        let normal = n / l;
        self.faces[self.faces_len] = Face { v, normal, distance: normal.dot(&a) };
        self.faces_len += 1;
        true
    }

    fn closest(&self) -> Face {
        let mut best = self.faces[0];
        for f in &self.faces[1..self.faces_len] {
            if f.distance < best.distance {
                best = *f;
            }
        }
        best
    }

    /// Replaces the faces that see `w` by a fan around it.
    fn grow(&mut self, w: Vertex, scale: f64) -> bool {
        let tip = self.len as u8;
        self.vertices[self.len] = w;
        self.len += 1;
        // An edge between two seen faces is met in both directions and cancels; what stays is the horizon.
        let mut horizon = [[0_u8; 2]; 3 * MAX_VERTICES];
        let mut n = 0;
        let mut i = 0;
        while i < self.faces_len {
            let f = self.faces[i];
            if f.normal.dot(&w.w) - f.distance <= 1e-14 * scale {
                i += 1;
                continue;
            }
            for k in 0..3 {
                let (from, to) = (f.v[k], f.v[(k + 1) % 3]);
                if let Some(m) = horizon[..n].iter().position(|e| *e == [to, from]) {
                    n -= 1;
                    horizon[m] = horizon[n];
                } else if n < horizon.len() {
                    horizon[n] = [from, to];
                    n += 1;
                }
            }
            self.faces_len -= 1;
            self.faces[i] = self.faces[self.faces_len];
        }
        n >= 3 && horizon[..n].iter().all(|&[from, to]| self.add([from, to, tip]))
    }

    /// The vertices and weights of the point of the surface closest to the origin. Several triangles
    /// may share the plane of `best`: the one that holds the point knows it.
    fn weights(&self, best: &Face, scale: f64) -> [(Vertex, f64); 3] {
        let mut found = (f64::NEG_INFINITY, [0.0; 3], best.v);
        for f in &self.faces[..self.faces_len] {
            if f.normal.dot(&best.normal) < 1.0 - 1e-9 || f.distance - best.distance > 1e-9 * scale {
                continue;
            }
            let [a, b, c] = f.v.map(|i| self.vertices[i as usize].w);
            let o = f.normal * f.distance;
            let area = |p: Wide, q: Wide| (p - o).cross(&(q - o)).dot(&f.normal);
            let k = [area(b, c), area(c, a), area(a, b)];
            let least = k[0].min(k[1]).min(k[2]) / (k[0] + k[1] + k[2]);
            if least > found.0 {
                found = (least, k, f.v);
            }
        }
        let k = found.1.map(|k| k.max(0.0));
        let sum = (k[0] + k[1] + k[2]).max(f64::MIN_POSITIVE);
        [0, 1, 2].map(|i| (self.vertices[found.2[i] as usize], k[i] / sum))
    }
}

/// Spreads the simplex to four vertices with volume, as far as the difference has any.
fn spread(pair: &Pair, simplex: &Simplex) -> ([Vertex; 4], usize) {
    let mut v = [Vertex::default(); 4];
    let mut len = 0;
    let scale = simplex.scale().max(pair.support(Wide::x()).w.amax()).max(f64::MIN_POSITIVE);
    let least = 1e-12 * scale;
    let given = simplex.vertices().iter().copied();
    // First what GJK found, then whatever lies out along the axes and the normals of what there is.
    for w in given {
        if stands_out(&v[..len], w.w) > least {
            v[len] = w;
            len += 1;
        }
    }
    if len == 0 {
        v[0] = pair.support(Wide::y());
        len = 1;
    }
    while len < 4 {
        let directions = match len {
            1 => [Wide::x(), Wide::y(), Wide::z()],
            2 => {
                let d = v[1].w - v[0].w;
                [d.cross(&Wide::x()), d.cross(&Wide::y()), d.cross(&Wide::z())]
            }
            _ => {
                let n = (v[1].w - v[0].w).cross(&(v[2].w - v[0].w));
                [n, n, n]
            }
        };
        let mut best = (least, Vertex::default());
        for d in directions.into_iter().filter(|d| d.amax() > 0.0).flat_map(|d| [d, -d]) {
            let w = pair.support(d);
            let height = stands_out(&v[..len], w.w);
            if height > best.0 {
                best = (height, w);
            }
        }
        if best.0 <= least {
            break;
        }
        v[len] = best.1;
        len += 1;
    }
    (v, len)
}

/// The distance of `w` from the point, line or plane of `v`.
fn stands_out(v: &[Vertex], w: Wide) -> f64 {
    match v {
        [] => f64::INFINITY,
        [a] => (w - a.w).norm(),
        [a, b] => {
            let d = b.w - a.w;
            d.cross(&(w - a.w)).norm() / d.norm()
        }
        [a, b, c, ..] => {
            let n = (b.w - a.w).cross(&(c.w - a.w));
            n.dot(&(w - a.w)).abs() / n.norm()
        }
    }
}

/// Two cores without a common volume, which touch: any normal of their difference will do.
fn flat(pair: &Pair, v: &[Vertex]) -> Depth {
    let normal = match v {
        [a, b, c, ..] => (b.w - a.w).cross(&(c.w - a.w)),
        [a, b] => {
            let d = b.w - a.w;
            let mut e = Wide::zeros();
            e[d.iamin()] = 1.0;
            d.cross(&e)
        }
        _ => Wide::y(),
    };
    let share = 1.0 / v.len() as f64;
    let (a, b) = pair.witnesses(v.iter().map(|v| (v, share)));
    Depth { status: DepthStatus::Flat, iterations: 0, depth: 0.0, normal: normal / normal.norm(), a, b }
}
