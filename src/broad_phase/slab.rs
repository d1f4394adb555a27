use crate::math::{Aabb, Float, Vec3, abs, tolerance::EPSILON};
use crate::simd::{Four, Lane, Quad};

/// A box (or a point) swept along a translation, ready to be tested against many boxes.
///
/// The test is the slab method (Kay, Kajiya 1986) with a padded interval, so that rounding never loses a box that
/// is touched; and it is monotone: a box that holds another is entered no later, which lets a tree prune.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sweep {
    origin: Vec3,
    /// Half extents of the moving box, and the padding.
    half: Vec3,
    /// 1 / translation; 0 along an axis where the sweep does not move.
    inv: Vec3,
}

impl Sweep {
    pub fn new(half: Vec3, origin: Vec3, translation: Vec3, max_fraction: Float) -> Self {
        let reach = abs(translation) * max_fraction;
        let mut sweep = Self { origin, half, inv: Vec3::zeros() };
        for k in 0..3 {
            let size = origin[k].abs() + half[k];
            sweep.half[k] += 4.0 * EPSILON * (size + reach[k]) + Float::MIN_POSITIVE;
            // A move that rounding swallows counts as none; the box grows by it instead.
            if reach[k] > EPSILON * size && translation[k].abs() >= Float::MIN_POSITIVE {
                sweep.inv[k] = 1.0 / translation[k];
            } else {
                sweep.half[k] += reach[k];
            }
        }
        sweep
    }

    /// A box that every box with an [`entry`](Self::entry) up to `max_fraction` overlaps.
    pub fn bounds(&self, max_fraction: Float) -> Aabb {
        let mut b = Aabb::around(self.origin, self.half);
        for k in 0..3 {
            let way = if self.inv[k] != 0.0 { max_fraction / self.inv[k] } else { 0.0 };
            b.lower[k] += way.min(0.0);
            b.upper[k] += way.max(0.0);
            // Far more than the roundings in `entry` and here.
            let slack = 32.0 * EPSILON * (self.origin[k].abs() + self.half[k] + way.abs());
            b.lower[k] -= slack;
            b.upper[k] += slack;
        }
        b
    }

    /// Whether the sweep goes towards lower coordinates along an axis.
    pub fn goes_back(&self, axis: usize) -> bool {
        self.inv[axis] < 0.0
    }

    /// The fraction of the translation, in [0, `max_fraction`], at which `b` is first touched.
    #[inline]
    pub fn entry(&self, b: &Aabb, max_fraction: Float) -> Option<Float> {
        let lower = b.lower - self.half - self.origin;
        let upper = b.upper + self.half - self.origin;
        let (mut enter, mut leave) = (0.0 as Float, max_fraction);
        for k in 0..3 {
            if self.inv[k] != 0.0 {
                let (t0, t1) = (lower[k] * self.inv[k], upper[k] * self.inv[k]);
                enter = enter.max(t0.min(t1));
                leave = leave.min(t0.max(t1));
            } else if lower[k] > 0.0 || upper[k] < 0.0 {
                return None;
            }
        }
        (enter <= leave + leave.abs() * (4.0 * EPSILON)).then(|| enter.min(max_fraction))
    }

    /// [`entry`](Self::entry) of four boxes given by the columns of their corners: bit `i` is set where box `i` is
    /// touched, and its fraction stands beside. Boxes that hold nothing may count as touched.
    #[inline(always)]
    pub fn entries(&self, lower: [&Quad; 3], upper: [&Quad; 3], max_fraction: Float) -> (u32, Quad) {
        let (mut enter, mut leave) = (Four::splat(0.0), Four::splat(max_fraction));
        let mut missed = Four::splat(-1.0);
        for k in 0..3 {
            let (half, origin) = (Four::splat(self.half[k]), Four::splat(self.origin[k]));
            let lower = Four::from_array(*lower[k]) - half - origin;
            let upper = Four::from_array(*upper[k]) + half - origin;
            if self.inv[k] != 0.0 {
                let inv = Four::splat(self.inv[k]);
                let (t0, t1) = (lower * inv, upper * inv);
                enter = enter.max(t0.min(t1));
                leave = leave.min(t0.max(t1));
            } else {
                // One of them is above 0.
                missed = missed.max(lower).max(-upper);
            }
        }
        let slack = leave + leave.max(-leave) * Four::splat(4.0 * EPSILON);
        let (late, missed) = (enter.to_array(), missed.to_array());
        let slack = slack.to_array();
        let hits =
            (0..4).fold(0, |bits, i| bits | u32::from((late[i] <= slack[i]) & (missed[i] <= 0.0)) << i);
        (hits, enter.min(Four::splat(max_fraction)).to_array())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::broad_phase::random::Random;
    use crate::math::vec3;

    #[test]
    fn four_boxes_at_once_are_entered_like_one() {
        let mut random = Random::new(5);
        let mut number = |size: Float| (random.below(2001) as Float - 1000.0) * (size / 1000.0);
        for round in 0..20_000 {
            let still = [0, 1, 2].map(|k| if round >> k & 1 == 1 { 0.0 } else { 1.0 });
            let mut corner = |size: Float| vec3(number(size), number(size), number(size));
            let boxes: [Aabb; 4] = std::array::from_fn(|_| Aabb::around(corner(4.0), abs(corner(2.0))));
            let way = corner(8.0).component_mul(&Vec3::from(still));
            let sweep = Sweep::new(abs(corner(0.5)), corner(4.0), way, 1.0);
            let max = if round % 3 == 0 { 0.4 } else { 1.0 };
            let lower = [0, 1, 2].map(|k| boxes.map(|b| b.lower[k]));
            let upper = [0, 1, 2].map(|k| boxes.map(|b| b.upper[k]));
            let (hits, enter) = sweep.entries(lower.each_ref(), upper.each_ref(), max);
            for i in 0..4 {
                let four = (hits >> i & 1 == 1).then_some(enter[i]);
                assert_eq!(four, sweep.entry(&boxes[i], max), "{sweep:?} {:?}", boxes[i]);
            }
        }
    }

    #[test]
    fn a_ray_on_a_face_touches() {
        let b = Aabb::around(Vec3::zeros(), vec3(1.0, 1.0, 1.0));
        for y in [-1.0, 1.0] {
            let sweep = Sweep::new(Vec3::zeros(), vec3(-3.0, y, 1.0), vec3(2.0, 0.0, 0.0), 2.0);
            assert!((sweep.entry(&b, 2.0).unwrap() - 1.0).abs() < 1e-5);
            assert_eq!(sweep.entry(&b, 0.5), None);
        }
        let beside = Sweep::new(Vec3::zeros(), vec3(-3.0, 1.01, 0.0), vec3(2.0, 0.0, 0.0), 2.0);
        assert_eq!(beside.entry(&b, 2.0), None);
    }

    #[test]
    fn a_sweep_without_translation_is_an_overlap() {
        let b = Aabb::around(Vec3::zeros(), vec3(1.0, 1.0, 1.0));
        let at = |x| Sweep::new(vec3(0.5, 0.5, 0.5), vec3(x, 0.0, 0.0), Vec3::zeros(), 1.0).entry(&b, 1.0);
        assert_eq!(at(1.5), Some(0.0));
        assert_eq!(at(1.51), None);
    }
}
