//! Restitution at the time of impact.
//!
//! Within a sub-step a point's gap follows s(t) = s + v t + ½ a t², with v the normal velocity when the sub-step
//! begins and a the normal acceleration. It closes at t* = 2s / (−v + √(v² − 2 a s)), with the speed
//! v* = √(v² − 2 a s); reflected there the point leaves with e v*, and at the end of the sub-step it is
//! e v* τ + ½ a τ² away with τ = h − t*, moving at e v* + a τ. Where that way is negative it would bounce again
//! within the sub-step: that is rest, and left to the ordinary row. So the bounce does not depend on where in
//! the sub-step it fell, and each impact is reflected once.

use super::contact_block::{ContactBlock, FrictionPart, ImpactPart};
use crate::math::tolerance::EPSILON;
use crate::math::{Float, Vec3, length, rotate};
use crate::simd::Lane;
use crate::solver::SubStep;
use crate::solver::rows::Rows;

/// Finds the impacts of the sub-step that begins now.
pub fn find<L: Lane, const P: usize, F: FrictionPart<L, P>, R: ImpactPart<L, P>>(
    block: &mut ContactBlock<L, P, F, R>,
    rows: &Rows,
    sub: &SubStep,
) {
    let (normal, offset, points, rounding) = (block.normal, block.offset, block.points, block.rounding);
    let Some(impact) = block.impact.get() else { return };
    for lane in 0..L::N {
        let (a, b) = (block.a.as_ref()[lane] as usize, block.b.as_ref()[lane] as usize);
        let restitution = impact.restitution.get(lane);
        if restitution <= 0.0 {
            continue;
        }
        let (row_a, row_b) = (&rows.row[a], &rows.row[b]);
        let n = normal.get(lane);
        // A body that constraints hold does not accelerate freely.
        let free = |i: usize| if rows.aux[i].supported { Vec3::zeros() } else { rows.aux[i].accel };
        let accel = n.dot(&(free(b) - free(a)));
        for (k, point) in points.iter().enumerate() {
            impact.on[k].put(lane, 0.0);
            if point.mass.get(lane) <= 0.0 {
                continue;
            }
            let ra = point.r.get(lane);
            let rb = ra + offset.get(lane);
            // The cores of rounded shapes turn, their touching points do not.
            let (ca, cb) = (ra - n * rounding[0].get(lane), rb + n * rounding[1].get(lane));
            let moved_a = row_a.dx() + rotate(&row_a.dq(), ca) - ca;
            let moved_b = row_b.dx() + rotate(&row_b.dq(), cb) - cb;
            let gap = point.separation.get(lane) + n.dot(&(moved_b - moved_a));
            let v = n.dot(&(row_b.v() + row_b.w().cross(&rb) - row_a.v() - row_a.w().cross(&ra)));
            if let Some((mean, end)) = reflect(gap, v, accel, restitution, sub) {
                impact.on[k].put(lane, 1.0);
                impact.mean[k].put(lane, mean);
                impact.end[k].put(lane, end);
            }
        }
    }
}

/// A target so low that a row never pushes \[m/s\].
const FREE: Float = 1e12;

/// The mean normal velocity over the sub-step and the one at its end, where an impact falls into it.
fn reflect(gap: Float, v: Float, accel: Float, restitution: Float, sub: &SubStep) -> Option<(Float, Float)> {
    if v >= 0.0 {
        return None;
    }
    let h = sub.h;
    // Already overlapping: the impact is now.
    let s = gap.max(0.0);
    let square = v * v - 2.0 * accel * s;
    if square <= 0.0 {
        return None;
    }
    let speed = square.sqrt();
    let t = 2.0 * s / (speed - v);
    let leaves = restitution * speed;
    if speed <= sub.restitution_threshold {
        return None;
    }
    if t > h {
        // It flies through this sub-step: the ordinary row would brake it at the surface.
        return Some((-FREE, -FREE));
    }
    let rest = h - t;
    let way = leaves * rest + 0.5 * accel * rest * rest;
    if way <= 0.0 && rest > 0.0 {
        return None;
    }
    Some(((way - s) / h, leaves + accel * rest))
}

/// Impulses on B that are to be taken back, and on A with the opposite sign.
#[derive(Default)]
struct TakenBack {
    p: Vec3,
    /// Moments about the centres of A and B.
    l: [Vec3; 2],
    /// What went into them, by size.
    p_size: Float,
    l_size: [Float; 2],
}

impl TakenBack {
    fn add(&mut self, p: Vec3, l: Vec3, arms: [Vec3; 2]) {
        self.p += p;
        self.p_size += length(p);
        for (side, r) in arms.into_iter().enumerate() {
            self.l[side] += r.cross(&p) + l;
            self.l_size[side] += length(r) * length(p) + length(l);
        }
    }

    /// Takes them out of what body `i`, on this side, carries to the next sub-step. What rounding leaves of nothing
    /// is nothing, by the size of what went into it: the body flies freely then, and its way is exact.
    fn take(&self, rows: &mut Rows, i: usize, side: usize) {
        if i == 0 || rows.aux[i].kinematic {
            return;
        }
        let sign = if side == 0 { 1.0 } else { -1.0 };
        let inv_mass = rows.row[i].inv_mass();
        let (turn, lever) = if rows.aux[i].spin {
            (self.l[side], self.l_size[side])
        } else {
            (rows.inertia[i].times(self.l[side]), self.l_size[side] * rows.inertia[i].trace())
        };
        let rest = |carried: Vec3, part: Vec3, size: Float| {
            let rest = carried + part * sign;
            if length(rest) <= 64.0 * EPSILON * size { Vec3::zeros() } else { rest }
        };
        let warm = &mut rows.aux[i].warm;
        warm[0] = rest(warm[0], self.p * inv_mass, self.p_size * inv_mass);
        warm[1] = rest(warm[1], turn, lever);
    }
}

/// Takes the impulses of impacts out of what the bodies carry to the next sub-step: they happen once.
pub fn end<L: Lane, const P: usize, F: FrictionPart<L, P>, R: ImpactPart<L, P>>(
    block: &mut ContactBlock<L, P, F, R>,
    rows: &mut Rows,
) {
    let Some(impact) = block.impact.get() else { return };
    let on = impact.on;
    for lane in 0..L::N {
        if (0..P).all(|k| on[k].get(lane) == 0.0) {
            continue;
        }
        let (a, b) = (block.a.as_ref()[lane] as usize, block.b.as_ref()[lane] as usize);
        let (n, offset) = (block.normal.get(lane), block.offset.get(lane));
        let mut back = TakenBack::default();
        let mut remove = |p: Vec3, l: Vec3, ra: Vec3| back.add(p, l, [ra, ra + offset]);
        for (k, p) in block.points.iter_mut().enumerate() {
            if on[k].get(lane) != 0.0 {
                remove(n * p.lambda.get(lane), Vec3::zeros(), p.r.get(lane));
                p.lambda.put(lane, 0.0);
            }
        }
        // The friction of an impact is part of it.
        let t = super::contact_block::tangents(block.normal).map(|t| t.get(lane));
        if let Some(f) = block.friction.dry() {
            let p = t[0] * f.lambda[0].get(lane) + t[1] * f.lambda[1].get(lane);
            remove(p, n * f.twist.get(lane), f.r.get(lane));
            f.lambda[0].put(lane, 0.0);
            f.lambda[1].put(lane, 0.0);
            f.twist.put(lane, 0.0);
        }
        if let Some(e) = block.friction.extra() {
            remove(Vec3::zeros(), t[0] * e.lambda[0].get(lane) + t[1] * e.lambda[1].get(lane), Vec3::zeros());
            e.lambda[0].put(lane, 0.0);
            e.lambda[1].put(lane, 0.0);
        }
        back.take(rows, a, 0);
        back.take(rows, b, 1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sub(h: Float) -> SubStep {
        SubStep { h, inv_h: 1.0 / h, ..SubStep::default() }
    }

    #[test]
    fn a_fall_is_reflected_where_it_lands_wherever_that_is_in_the_sub_step() {
        // From height z at speed −v under −10, e = 0.8: closed form beside the function, over 40 phases.
        let h = 1.0 / 240.0;
        for phase in 0..40 {
            let gap = 4.0 * h * (phase as Float + 0.5) / 40.0;
            let (mean, end) = reflect(gap, -4.0, -10.0, 0.8, &sub(h)).expect("it lands in this sub-step");
            let speed = (16.0 + 20.0 * gap).sqrt();
            let t = (speed - 4.0) / 10.0;
            let rest = h - t;
            let z = 0.8 * speed * rest - 5.0 * rest * rest;
            assert!((gap + mean * h - z).abs() < 1e-6 && (end - (0.8 * speed - 10.0 * rest)).abs() < 1e-5);
        }
    }

    #[test]
    fn parting_late_slow_or_repeated_impacts_are_none() {
        let h = 1.0 / 240.0;
        assert!(reflect(0.0, 0.1, -10.0, 0.8, &sub(h)).is_none(), "parting");
        assert_eq!(reflect(0.1, -4.0, -10.0, 0.8, &sub(h)), Some((-FREE, -FREE)), "too far away");
        let threshold = SubStep { restitution_threshold: 1.0, ..sub(h) };
        assert!(reflect(0.0, -0.9, -10.0, 0.8, &threshold).is_none(), "slower than the threshold");
        assert!(reflect(0.0, -0.01, -10.0, 0.8, &sub(h)).is_none(), "would land again at once");
        assert!(reflect(0.0, -1.0, -10.0, 0.8, &sub(h)).is_some());
    }
}
