//! One box against four at a time.

use super::Quad;
use crate::math::Aabb;

#[cfg(all(target_arch = "x86_64", not(feature = "f64")))]
mod register {
    use super::*;
    use core::arch::x86_64::*;

    /// Calls SSE2 functions.
    macro_rules! sse {
        // SAFETY: they need the target features sse and sse2, which every x86-64 target has, and touch no memory.
        ($e:expr) => {
            unsafe { $e }
        };
    }

    /// See the [module](super::super).
    #[derive(Clone, Copy, Debug)]
    pub struct BoxProbe {
        lower: [__m128; 3],
        upper: [__m128; 3],
    }

    #[inline(always)]
    fn load(q: &Quad) -> __m128 {
        // SAFETY: four f32 are read from an array of four f32; the load need not be aligned.
        unsafe { _mm_loadu_ps(q.as_ptr()) }
    }

    impl BoxProbe {
        /// The box spread over the lanes.
        #[inline(always)]
        #[must_use]
        pub fn new(aabb: &Aabb) -> Self {
            let splat = |x: f32| sse!(_mm_set1_ps(x));
            Self {
                lower: [0, 1, 2].map(|k| splat(aabb.lower[k])),
                upper: [0, 1, 2].map(|k| splat(aabb.upper[k])),
            }
        }

        /// Four boxes given by the columns of their corners: bit `i` is set where box `i` overlaps (closed boxes,
        /// no NaN).
        #[inline(always)]
        #[must_use]
        pub fn hits(&self, lower: [&Quad; 3], upper: [&Quad; 3]) -> u32 {
            let on = |k: usize| {
                sse!(_mm_and_ps(
                    _mm_cmple_ps(load(lower[k]), self.upper[k]),
                    _mm_cmple_ps(self.lower[k], load(upper[k]))
                ))
            };
            sse!(_mm_movemask_ps(_mm_and_ps(_mm_and_ps(on(0), on(1)), on(2)))) as u32
        }
    }
}

#[cfg(any(test, not(target_arch = "x86_64"), feature = "f64"))]
mod portable {
    use super::*;

    /// See the [module](super::super).
    #[derive(Clone, Copy, Debug)]
    pub struct BoxProbe(Aabb);

    impl BoxProbe {
        /// The box.
        #[inline(always)]
        #[must_use]
        pub fn new(aabb: &Aabb) -> Self {
            Self(*aabb)
        }

        /// Four boxes given by the columns of their corners: bit `i` is set where box `i` overlaps (closed boxes,
        /// no NaN).
        #[inline(always)]
        #[must_use]
        pub fn hits(&self, lower: [&Quad; 3], upper: [&Quad; 3]) -> u32 {
            let on = |i: usize, k: usize| (lower[k][i] <= self.0.upper[k]) & (self.0.lower[k] <= upper[k][i]);
            (0..4).fold(0, |bits, i| bits | u32::from(on(i, 0) & on(i, 1) & on(i, 2)) << i)
        }
    }
}

#[cfg(any(not(target_arch = "x86_64"), feature = "f64"))]
pub use portable::BoxProbe;
#[cfg(all(target_arch = "x86_64", not(feature = "f64")))]
pub use register::BoxProbe;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Float, vec3};

    #[test]
    fn both_ways_agree_with_the_plain_test() {
        // Every relation of two intervals on each axis, touching ones included.
        let places: Vec<Float> = (0..7).map(|k| k as Float * 0.5 - 1.5).collect();
        let b = Aabb::around(vec3(0.0, 0.0, 0.0), vec3(0.5, 0.5, 0.5));
        let (probe, plain) = (BoxProbe::new(&b), portable::BoxProbe::new(&b));
        for &x in &places {
            for &y in &places {
                for z in places.windows(4) {
                    let boxes = [0, 1, 2, 3].map(|i| Aabb::around(vec3(x, y, z[i]), vec3(0.5, 0.25, 0.0)));
                    let lower = [0, 1, 2].map(|k| boxes.map(|b| b.lower[k]));
                    let upper = [0, 1, 2].map(|k| boxes.map(|b| b.upper[k]));
                    let expected = (0..4).fold(0, |m, i| m | u32::from(b.overlaps(&boxes[i])) << i);
                    assert_eq!(probe.hits(lower.each_ref(), upper.each_ref()), expected);
                    assert_eq!(plain.hits(lower.each_ref(), upper.each_ref()), expected);
                }
            }
        }
    }
}
