//! The point of a simplex closest to the origin by cutting space along its features: in which Voronoi region does the
//! origin lie, that of a vertex, an edge, a face or the inside? (Ericson, Real-Time Collision Detection 2005, 5.1.)

use super::simplex::{Best, Simplex, SubAlgorithm, Weights};

pub(super) struct CutSpace;

impl SubAlgorithm for CutSpace {
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

/// A volume below this share of the cube of the size is rounding: such a tetrahedron has no inside.
const FLAT: f64 = 1e-14;

/// The areas are differences of products; a sum below this share of the products is rounding.
const SLIVER: f64 = 1e-13;

/// The weights of one, two or three vertices.
fn at<const N: usize>(members: [usize; N], t: [f64; N]) -> Weights {
    let mut weight = [0.0; 4];
    members.iter().zip(t).for_each(|(&i, t)| weight[i] = t);
    weight
}

/// Two planes across the segment, one at each end.
#[inline]
fn segment(s: &Simplex, [i, j]: [usize; 2]) -> Weights {
    let a = s.w(i);
    let ab = s.w(j) - a;
    let (along, whole) = (-a.dot(&ab), ab.dot(&ab));
    if along <= 0.0 {
        at([i], [1.0])
    } else if along >= whole {
        at([j], [1.0])
    } else {
        let t = along / whole;
        at([i, j], [1.0 - t, t])
    }
}

/// Three corners, then three edges, are cut away; what is left is the inside.
#[inline]
fn triangle(s: &Simplex, [i, j, k]: [usize; 3]) -> Weights {
    let (a, b, c) = (s.w(i), s.w(j), s.w(k));
    let (ab, ac) = (b - a, c - a);
    // How far the origin lies along the edges from A, as seen from each corner.
    let (ab_a, ac_a) = (-ab.dot(&a), -ac.dot(&a));
    if ab_a <= 0.0 && ac_a <= 0.0 {
        return at([i], [1.0]);
    }
    let (ab_b, ac_b) = (-ab.dot(&b), -ac.dot(&b));
    if ab_b >= 0.0 && ac_b <= ab_b {
        return at([j], [1.0]);
    }
    let (ab_c, ac_c) = (-ab.dot(&c), -ac.dot(&c));
    if ac_c >= 0.0 && ab_c <= ac_c {
        return at([k], [1.0]);
    }
    // Twice the areas of the triangles that the origin's foot makes with the edges.
    let area_ab = ab_a * ac_b - ab_b * ac_a;
    if area_ab <= 0.0 && ab_a >= 0.0 && ab_b <= 0.0 && ab_a > ab_b {
        let t = ab_a / (ab_a - ab_b);
        return at([i, j], [1.0 - t, t]);
    }
    let area_ca = ab_c * ac_a - ab_a * ac_c;
    if area_ca <= 0.0 && ac_a >= 0.0 && ac_c <= 0.0 && ac_a > ac_c {
        let t = ac_a / (ac_a - ac_c);
        return at([i, k], [1.0 - t, t]);
    }
    let area_bc = ab_b * ac_c - ab_c * ac_b;
    let (from_b, from_c) = (ac_b - ab_b, ab_c - ac_c);
    if area_bc <= 0.0 && from_b >= 0.0 && from_c >= 0.0 && from_b + from_c > 0.0 {
        let t = from_b / (from_b + from_c);
        return at([j, k], [1.0 - t, t]);
    }
    let whole = area_ab + area_bc + area_ca;
    let reach = [ab_a, ac_a, ab_b, ac_b, ab_c, ac_c].iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    if area_ab > 0.0 && area_bc > 0.0 && area_ca > 0.0 && whole > SLIVER * reach * reach {
        return at([i, j, k], [area_bc / whole, area_ca / whole, area_ab / whole]);
    }
    // A sliver: rounding has left a gap between the regions of its edges.
    let mut best = Best::new();
    [[i, j], [j, k], [k, i]].into_iter().for_each(|e| best.offer(s, segment(s, e)));
    best.weight
}

/// The planes of the four faces: the closest point is the best of the faces that see the origin.
fn tetrahedron(s: &Simplex) -> Weights {
    let size = s.scale();
    let mut best = Best::new();
    let mut inside = true;
    let mut weight = [0.0; 4];
    for (top, face) in [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]].into_iter().enumerate() {
        let [a, b, c] = face.map(|i| s.w(i));
        let n = (b - a).cross(&(c - a));
        let (origin, opposite) = (-n.dot(&a), n.dot(&(s.w(top) - a)));
        let flat = opposite.abs() <= FLAT * size * size * size;
        if flat || origin * opposite <= 0.0 {
            inside = false;
            best.offer(s, triangle(s, face));
        } else {
            weight[top] = origin / opposite;
        }
    }
    if inside {
        let sum: f64 = weight.iter().sum();
        weight.map(|w| w / sum)
    } else {
        best.weight
    }
}
