//! The point of a simplex closest to the origin, by signed volumes: the barycentric coordinates are ratios of
//! determinants taken in the coordinate plane where the simplex is largest, and their signs tell which faces to
//! look at next. Unlike Johnson's recursion this stays right on flat simplices.

use super::simplex::{Best, Simplex, SubAlgorithm, Weights};
use crate::shape::Wide;

pub(super) struct SignedVolumes;

impl SubAlgorithm for SignedVolumes {
    #[inline(always)]
    fn weights(s: &Simplex) -> Weights {
        match s.len() {
            1 => [1.0, 0.0, 0.0, 0.0],
            2 => segment(s, [0, 1]),
            3 => triangle(s, [0, 1, 2]),
            _ => tetrahedron(s),
        }
    }
}

#[inline]
fn segment(s: &Simplex, [i, j]: [usize; 2]) -> Weights {
    let (p, q) = (s.w(i), s.w(j));
    let d = q - p;
    let dd = d.dot(&d);
    let t = if dd > 0.0 { (-p.dot(&d) / dd).clamp(0.0, 1.0) } else { 0.0 };
    let mut weight = [0.0; 4];
    (weight[i], weight[j]) = (1.0 - t, t);
    weight
}

#[inline]
fn triangle(s: &Simplex, [i, j, k]: [usize; 3]) -> Weights {
    let (a, b, c) = (s.w(i), s.w(j), s.w(k));
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
            best.offer(s, segment(s, edge));
        }
    }
    best.weight
}

fn tetrahedron(s: &Simplex) -> Weights {
    let (a, b, c, d) = (s.w(0), s.w(1), s.w(2), s.w(3));
    let (bc, da) = (b.cross(&c), d.cross(&a));
    let part = [-bc.dot(&d), da.dot(&c), -da.dot(&b), bc.dot(&a)];
    let whole = part[0] + part[1] + part[2] + part[3];
    // A flat tetrahedron tells nothing by its signs, and has no inside.
    let size = s.scale();
    let flat = whole.abs() <= 1e-14 * size * size * size;
    let mut best = Best::new();
    let mut inside = true;
    for (f, face) in [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]].into_iter().enumerate() {
        let outside = part[f] * whole <= 0.0;
        inside &= !outside;
        if outside || flat {
            best.offer(s, triangle(s, face));
        }
    }
    if inside && !flat {
        [part[0] / whole, part[1] / whole, part[2] / whole, part[3] / whole]
    } else {
        best.weight
    }
}

/// Twice the signed area of the triangle o p q, seen in the plane of coordinates y and z.
#[inline(always)]
fn minor(p: &Wide, q: &Wide, o: &Wide, y: usize, z: usize) -> f64 {
    (p[y] - o[y]) * (q[z] - o[z]) - (p[z] - o[z]) * (q[y] - o[y])
}
