//! The depth of two overlapping cores by Minkowski portal refinement (Snethen, XenoCollide, Game Programming Gems 7,
//! 2008): a ray from a point deep inside the difference A − B through the origin leaves it through a triangle of
//! support points, the portal; moving the portal outwards until it lies on the surface gives a normal.
//!
//! The depth is exact *along that normal*, which is that of the place where the ray leaves, not that of the place
//! closest to the origin: never less than EPA's, and more where the centres lie askew. Cheaper: no list of faces.

use super::depth::{Depth, DepthStatus};
use super::gjk::{Pair, Simplex, Vertex};
use crate::math::tolerance::EPA_PROGRESS;
use crate::shape::Wide;

/// Of the search for the first portal, and of its refinement.
const MAX_ITERATIONS: u32 = 64;

/// A search that begins in the origin has no ray: it begins beside it, by this share of the size.
const ASIDE: f64 = 1e-6;

/// The depth of the pair, of which GJK knows that it overlaps.
pub(super) fn depth(pair: &Pair, simplex: &Simplex) -> Depth {
    let scale = simplex.scale().max(pair.support(Wide::x()).w.amax()).max(f64::MIN_POSITIVE);
    let mut search = Search { pair, inside: pair.between_centers(), iterations: 0 };
    if search.inside.norm() <= ASIDE * scale {
        search.inside = Wide::new(ASIDE * scale, 0.0, 0.0);
    }
    let (portal, normal, status) = match search.portal() {
        Ok(portal) => search.refine(portal, scale),
        // The origin lies on the surface, or what looked like an inside has none.
        Err(direction) => {
            let v = pair.support(direction);
            ([v; 3], direction / direction.norm().max(f64::MIN_POSITIVE), DepthStatus::Degenerate)
        }
    };
    let (a, b) = pair.witnesses(portal.iter().zip(weights(&portal, &normal)));
    Depth { status, iterations: search.iterations, depth: -pair.gap_along(normal), normal, a, b }
}

struct Search<'p, 'a> {
    pair: &'p Pair<'a>,
    /// The point from which the ray starts.
    inside: Wide,
    iterations: u32,
}

impl Search<'_, '_> {
    /// Three support points whose triangle the ray meets; or the last direction, where there are none.
    fn portal(&mut self) -> Result<[Vertex; 3], Wide> {
        let v0 = self.inside;
        let mut v1 = self.pair.support(-v0);
        if v1.w.dot(&v0) >= 0.0 {
            return Err(-v0);
        }
        let mut d = v1.w.cross(&v0);
        if d.norm_squared() <= 1e-24 * v1.w.norm_squared() * v0.norm_squared() {
            // The ray leaves through the first point: any direction across will do.
            let mut e = Wide::zeros();
            e[v0.iamin()] = 1.0;
            d = v0.cross(&e);
        }
        let mut v2 = self.pair.support(d);
        if v2.w.dot(&d) <= 0.0 {
            return Err(d);
        }
        d = (v1.w - v0).cross(&(v2.w - v0));
        if d.dot(&v0) > 0.0 {
            std::mem::swap(&mut v1, &mut v2);
            d = -d;
        }
        while self.iterations < MAX_ITERATIONS {
            self.iterations += 1;
            let v3 = self.pair.support(d);
            if v3.w.dot(&d) <= 0.0 {
                return Err(if d.norm_squared() > 0.0 { d } else { -v0 });
            }
            if v1.w.cross(&v3.w).dot(&v0) < 0.0 {
                v2 = v3;
            } else if v3.w.cross(&v2.w).dot(&v0) < 0.0 {
                v1 = v3;
            } else {
                return Ok([v1, v2, v3]);
            }
            d = (v1.w - v0).cross(&(v2.w - v0));
        }
        Err(if d.norm_squared() > 0.0 { d } else { -v0 })
    }

    /// Moves the portal to the surface.
    fn refine(&mut self, portal: [Vertex; 3], scale: f64) -> ([Vertex; 3], Wide, DepthStatus) {
        let v0 = self.inside;
        let [mut v1, mut v2, mut v3] = portal;
        let mut normal = -v0 / v0.norm();
        for _ in 0..MAX_ITERATIONS {
            let n = (v2.w - v1.w).cross(&(v3.w - v1.w));
            let length = n.norm();
            if length <= 0.0 {
                return ([v1, v2, v3], normal, DepthStatus::Degenerate);
            }
            normal = if n.dot(&(v1.w - v0)) < 0.0 { -n / length } else { n / length };
            self.iterations += 1;
            let v4 = self.pair.support(normal);
            let reached = normal.dot(&v1.w).max(normal.dot(&v2.w)).max(normal.dot(&v3.w));
            if normal.dot(&v4.w) - reached <= EPA_PROGRESS * scale {
                return ([v1, v2, v3], normal, DepthStatus::Converged);
            }
            if [v1.id, v2.id, v3.id].contains(&v4.id) {
                return ([v1, v2, v3], normal, DepthStatus::Repeated);
            }
            // Of the three tetrahedra over the portal, the one that the ray passes.
            let across = v4.w.cross(&v0);
            if v1.w.dot(&across) >= 0.0 {
                if v2.w.dot(&across) >= 0.0 {
                    v1 = v4;
                } else {
                    v3 = v4;
                }
            } else if v3.w.dot(&across) >= 0.0 {
                v2 = v4;
            } else {
                v1 = v4;
            }
        }
        ([v1, v2, v3], normal, DepthStatus::IterationLimit)
    }
}

/// The weights of the origin's foot on the portal, moved into it.
fn weights(portal: &[Vertex; 3], normal: &Wide) -> [f64; 3] {
    let [a, b, c] = portal.each_ref().map(|v| v.w);
    let foot = normal * normal.dot(&a);
    let area = |p: Wide, q: Wide| (p - foot).cross(&(q - foot)).dot(normal);
    let turn = (b - a).cross(&(c - a)).dot(normal).signum();
    let k = [area(b, c), area(c, a), area(a, b)].map(|k| (k * turn).max(0.0));
    let sum = k[0] + k[1] + k[2];
    if sum > 0.0 { k.map(|k| k / sum) } else { [1.0 / 3.0; 3] }
}
