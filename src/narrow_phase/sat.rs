//! Separating axes of two solids with flat faces: the face normals of both, and the cross products of those edge
//! pairs that form a face of the difference A − B (Gregorius, The Separating Axis Test between Convex Polyhedra,
//! GDC 2013).

use super::frame::Frame;
use crate::math::tolerance::PARALLEL_SINE;
use crate::math::{Float, Vec3, length, length_squared};
use crate::shape::{EdgeRay, Polytope};

/// The share of a pair's size that is surely more than the rounding of a gap.
const ROUNDING: Float = 1e-4;

/// The angle \[rad\] by which rounding may at most turn an axis out of the arcs of its edges, where they are clear
/// (see [`EdgeRay::cosine`]) and not parallel.
const ASTRAY: Float = 1e-2;

/// The face of `p` in front of which the whole of `q` lies farthest, and how far that is. `known` is the gap of one of
/// the faces.
pub(super) fn best_face<P: Polytope, Q: Polytope>(
    p: &P,
    q: &Q,
    p_from_q: &Frame,
    margin: Float,
    known: Float,
) -> (Float, usize) {
    // The whole of q comes at least as near as a ball within it: most faces need not be measured.
    let middle = p_from_q.point(q.center());
    let least = q.inner_radius() - ROUNDING * size(p, q, middle);
    let mut best = (-Float::MAX, 0);
    for i in 0..p.face_count() {
        let (n, d) = p.plane(i);
        if n.dot(&middle) - d - least < known.max(best.0) {
            continue;
        }
        let s = face_gap(p, q, p_from_q, i);
        if s > best.0 {
            best = (s, i);
            if s > margin {
                break;
            }
        }
    }
    best
}

/// A bound of all lengths that enter a gap; `middle` is the centre of `q` in the frame of `p`.
fn size<P: Polytope, Q: Polytope>(p: &P, q: &Q, middle: Vec3) -> Float {
    length(middle) + length(p.center()) + length(q.center()) + p.reach() + q.reach()
}

/// The gap between face `i` of `p` and all of `q`.
#[inline]
pub(super) fn face_gap<P: Polytope, Q: Polytope>(p: &P, q: &Q, p_from_q: &Frame, i: usize) -> Float {
    let (n, d) = p.plane(i);
    let deepest = q.vertex(q.support(-p_from_q.vector_back(n)));
    n.dot(&p_from_q.point(deepest)) - d
}

/// An axis from the edges `a` of A and `b` of B.
#[derive(Clone, Copy, Debug)]
pub(super) struct EdgeAxis {
    pub gap: Float,
    pub a: usize,
    pub b: usize,
    /// From A to B, in the frame of A.
    pub normal: Vec3,
}

/// The edge pair with the greatest gap, or the first whose gap exceeds `margin`. Pairs whose gap is at most `worth`
/// may be passed over. `frame` is that of `p` from `q`, `back` the other way.
pub(super) fn best_edges<P: Polytope, Q: Polytope>(
    p: &P,
    q: &Q,
    frame: &Frame,
    back: &Frame,
    margin: Float,
    worth: Float,
) -> Option<EdgeAxis> {
    // The inner loop should read tables.
    if P::IMPLICIT && !Q::IMPLICIT {
        let found = scan_edges(q, p, back, frame, margin, worth)?;
        let EdgeAxis { gap, a, b, normal } = found;
        return Some(EdgeAxis { gap, a: b, b: a, normal: -frame.vector(normal) });
    }
    scan_edges(p, q, frame, back, margin, worth)
}

/// Tells which edges of one solid give no gap worth looking at, whatever edge of the other they are paired with.
///
/// The axis of a pair lies on the arc between the normals of either edge. Along it the other solid comes nearer than
/// the middle of a ball within it by the ball's radius, so the gap is at most the height of that middle over the edge,
/// less the radius. The height is at most that over the nearer of the two faces, over the cosine of half the arc.
struct Blind {
    middle: Vec3,
    /// The least height that is worth looking at.
    least: Float,
}

impl Blind {
    #[inline(always)]
    fn skips(&self, edge: &EdgeRay) -> bool {
        let up = self.middle - edge.start;
        edge.normals[0].dot(&up).max(edge.normals[1].dot(&up)).max(0.0) < edge.cosine * self.least
    }
}

/// Numbers of edges, in order.
struct List {
    numbers: [u16; super::polytopes::MOST_EDGES],
    len: usize,
}

impl List {
    fn of(count: usize, keep: impl Fn(usize) -> bool) -> Self {
        let mut list = Self { numbers: [0; super::polytopes::MOST_EDGES], len: 0 };
        for i in (0..count).filter(|&i| keep(i)) {
            list.numbers[list.len] = i as u16;
            list.len += 1;
        }
        list
    }

    fn iter(&self) -> impl Iterator<Item = usize> {
        self.numbers[..self.len].iter().map(|&i| i as usize)
    }
}

fn scan_edges<P: Polytope, Q: Polytope>(
    p: &P,
    q: &Q,
    frame: &Frame,
    back: &Frame,
    margin: Float,
    worth: Float,
) -> Option<EdgeAxis> {
    let middle = frame.point(q.center());
    // Of a plate so thin that the side of an axis may be rounding, all edges are looked at.
    let is_thin = p.inner_radius() <= 2.0 * ASTRAY * p.reach();
    let slack = if is_thin { Float::MAX } else { ASTRAY * size(p, q, middle) };
    let of_p = Blind { middle, least: worth + q.inner_radius() - slack };
    let of_q = Blind { middle: back.point(p.center()), least: worth + p.inner_radius() - slack };
    let kept = List::of(p.edge_count(), |i| !of_p.skips(&p.edge_ray(i)));
    let all_clear = kept.iter().all(|i| p.edge_ray(i).cosine > 0.0);
    let mut best: Option<EdgeAxis> = None;
    for j in 0..q.edge_count() {
        let e = q.edge_ray(j);
        // What is known of an edge holds for its pairs with clear ones.
        let (is_clear, is_blind) = (e.cosine > 0.0, of_q.skips(&e));
        if is_blind && all_clear {
            continue;
        }
        let (on_b, along_b) = (frame.point(e.start), frame.vector(e.along));
        let [n0, n1] = e.normals.map(|n| frame.vector(n));
        let count = if is_clear { kept.len } else { p.edge_count() };
        for k in 0..count {
            let i = if is_clear { kept.numbers[k] as usize } else { k };
            let f = p.edge_ray(i);
            if is_blind && f.cosine > 0.0 {
                continue;
            }
            // The arcs between the normals of either edge, B's turned round, cross on the sphere: only then do the
            // edges face each other.
            let (a, b) = (f.normals[0].dot(&along_b), f.normals[1].dot(&along_b));
            if a * b >= 0.0 {
                continue;
            }
            let (c, d) = (-n0.dot(&f.along), -n1.dot(&f.along));
            if c * d >= 0.0 || c * b <= 0.0 {
                continue;
            }
            if let Some((normal, gap)) = edge_gap(f.start, f.along, on_b, along_b, p.center())
                && best.is_none_or(|x| gap > x.gap)
            {
                best = Some(EdgeAxis { gap, a: i, b: j, normal });
                if gap > margin {
                    return best;
                }
            }
        }
    }
    best
}

/// The unit normal of two edges, away from the centre of A, and the gap along it; `None` for parallel edges.
#[inline(always)]
pub(super) fn edge_gap(
    on_a: Vec3,
    along_a: Vec3,
    on_b: Vec3,
    along_b: Vec3,
    center: Vec3,
) -> Option<(Vec3, Float)> {
    let n = along_a.cross(&along_b);
    let l2 = length_squared(n);
    if l2 <= PARALLEL_SINE * PARALLEL_SINE * length_squared(along_a) * length_squared(along_b) {
        return None;
    }
    let n = n / l2.sqrt();
    let n = if n.dot(&(on_a - center)) < 0.0 { -n } else { n };
    Some((n, n.dot(&(on_b - on_a))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::vec3;
    use crate::shape::testing::Random;
    use crate::shape::{Cuboid, Hull};

    /// Passing over what is not worth looking at finds the same axes as looking at all of them.
    fn check<P: Polytope, Q: Polytope>(random: &mut Random, p: &P, q: &Q) {
        let pose = random.pose(1.2);
        let frame = Frame::new(&pose);
        let back = frame.inverse();
        let margin = random.within(0.0, 0.1);
        let all: Vec<Float> = (0..p.face_count()).map(|i| face_gap(p, q, &frame, i)).collect();
        let known = all[random.below(all.len())];
        let (gap, face) = best_face(p, q, &frame, Float::MAX, known);
        let best = all.iter().copied().fold(-Float::MAX, Float::max);
        assert_eq!((gap, all[face]), (best, best), "the best face at {pose:?}");
        let every = best_edges(p, q, &frame, &back, margin, -Float::MAX);
        for _ in 0..8 {
            let worth = random.within(-0.6, margin).min(margin);
            let some = best_edges(p, q, &frame, &back, margin, worth);
            match (&every, &some) {
                (Some(every), some) if every.gap > worth => {
                    let some = some.as_ref().expect("an axis was passed over");
                    assert_eq!((every.a, every.b, every.gap), (some.a, some.b, some.gap), "at {pose:?}");
                }
                (_, Some(some)) => assert!(some.gap <= worth),
                (_, None) => {}
            }
        }
    }

    #[test]
    fn what_is_passed_over_is_never_the_best_axis() {
        let mut random = Random(41);
        for k in 0..3000 {
            // From cubes to plates and needles.
            let thin = [1.0, 0.3, 0.05, 0.004][k % 4];
            let half = vec3(random.within(0.3, 1.0), random.within(0.3, 1.0), thin);
            let cuboid = Cuboid::new(half).unwrap();
            let (n, m) = (6 + random.below(12), 6 + random.below(12));
            let (Ok(a), Ok(b)) =
                (Hull::new(&random.cloud(n, half)), Hull::new(&random.cloud(m, vec3(1.0, 0.7, 0.5))))
            else {
                continue;
            };
            check(&mut random, &a, &b);
            check(&mut random, &cuboid, &b);
            check(&mut random, &b, &cuboid);
            check(&mut random, &cuboid, &Cuboid::new(vec3(0.5, 0.8, 0.3)).unwrap());
        }
    }
}
