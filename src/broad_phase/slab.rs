use crate::math::{Aabb, Float, Vec3, abs, tolerance::EPSILON};

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
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::vec3;

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
