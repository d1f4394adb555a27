//! Four lanes.

use super::{Lane, Quad};
use crate::math::Float;
use std::ops::{Add, Mul, Neg, Sub};

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

    /// Four lanes in one SSE register. SSE2 is part of x86-64 itself.
    #[derive(Clone, Copy, Debug)]
    #[repr(transparent)]
    pub struct Four(__m128);

    impl Four {
        #[inline(always)]
        pub fn from_array(a: Quad) -> Self {
            Self(sse!(_mm_set_ps(a[3], a[2], a[1], a[0])))
        }
        #[inline(always)]
        pub fn to_array(self) -> Quad {
            // SAFETY: a register of four f32 and an array of four f32 have the same size, and any bits are valid.
            unsafe { core::mem::transmute::<__m128, [f32; 4]>(self.0) }
        }
        #[inline(always)]
        fn load(q: Quad) -> Self {
            // SAFETY: as above; the compiler makes one unaligned load of it.
            Self(unsafe { core::mem::transmute::<[f32; 4], __m128>(q) })
        }
        #[inline(always)]
        fn transpose(r: [Self; 4]) -> [Self; 4] {
            let (a, b) = sse!((_mm_unpacklo_ps(r[0].0, r[1].0), _mm_unpackhi_ps(r[0].0, r[1].0)));
            let (c, d) = sse!((_mm_unpacklo_ps(r[2].0, r[3].0), _mm_unpackhi_ps(r[2].0, r[3].0)));
            [
                Self(sse!(_mm_movelh_ps(a, c))),
                Self(sse!(_mm_movehl_ps(c, a))),
                Self(sse!(_mm_movelh_ps(b, d))),
                Self(sse!(_mm_movehl_ps(d, b))),
            ]
        }
    }

    impl Add for Four {
        type Output = Self;
        #[inline(always)]
        fn add(self, o: Self) -> Self {
            Self(sse!(_mm_add_ps(self.0, o.0)))
        }
    }
    impl Sub for Four {
        type Output = Self;
        #[inline(always)]
        fn sub(self, o: Self) -> Self {
            Self(sse!(_mm_sub_ps(self.0, o.0)))
        }
    }
    impl Mul for Four {
        type Output = Self;
        #[inline(always)]
        fn mul(self, o: Self) -> Self {
            Self(sse!(_mm_mul_ps(self.0, o.0)))
        }
    }
    impl Neg for Four {
        type Output = Self;
        #[inline(always)]
        fn neg(self) -> Self {
            Self(sse!(_mm_xor_ps(self.0, _mm_set1_ps(-0.0))))
        }
    }

    impl Lane for Four {
        const N: usize = 4;
        type Mask = __m128;
        type Index = [u32; 4];

        #[inline(always)]
        fn same_index(i: u32) -> [u32; 4] {
            [i; 4]
        }
        #[inline(always)]
        fn splat(x: Float) -> Self {
            Self(sse!(_mm_set1_ps(x)))
        }
        #[inline(always)]
        fn get(self, i: usize) -> Float {
            self.to_array()[i]
        }
        #[inline(always)]
        fn put(&mut self, i: usize, x: Float) {
            assert!(i < 4);
            // SAFETY: a register of four f32 in memory is an array of four f32, and `i` is one of them. Writing
            // the element alone spares a round trip of the whole register.
            unsafe { (&raw mut self.0).cast::<f32>().add(i).write(x) }
        }
        #[inline(always)]
        fn over(self, d: Self) -> Self {
            Self(sse!(_mm_div_ps(self.0, d.0)))
        }
        #[inline(always)]
        fn sqrt(self) -> Self {
            Self(sse!(_mm_sqrt_ps(self.0)))
        }
        #[inline(always)]
        fn min(self, b: Self) -> Self {
            Self(sse!(_mm_min_ps(self.0, b.0)))
        }
        #[inline(always)]
        fn max(self, b: Self) -> Self {
            Self(sse!(_mm_max_ps(self.0, b.0)))
        }
        #[inline(always)]
        fn gt(self, b: Self) -> __m128 {
            sse!(_mm_cmpgt_ps(self.0, b.0))
        }
        #[inline(always)]
        fn select(mask: __m128, a: Self, b: Self) -> Self {
            Self(sse!(_mm_or_ps(_mm_and_ps(mask, a.0), _mm_andnot_ps(mask, b.0))))
        }
        #[inline(always)]
        fn any(mask: __m128) -> bool {
            sse!(_mm_movemask_ps(mask)) != 0
        }
        #[inline(always)]
        fn gather(rows: impl Fn(usize) -> Quad) -> [Self; 4] {
            Self::transpose([
                Self::load(rows(0)),
                Self::load(rows(1)),
                Self::load(rows(2)),
                Self::load(rows(3)),
            ])
        }
        #[inline(always)]
        fn scatter(columns: [Self; 4], mut write: impl FnMut(usize, Quad)) {
            for (i, row) in Self::transpose(columns).into_iter().enumerate() {
                write(i, row.to_array());
            }
        }
    }
}

#[cfg(not(all(target_arch = "x86_64", not(feature = "f64"))))]
mod register {
    use super::*;

    /// Four lanes in a plain array.
    #[derive(Clone, Copy, Debug)]
    #[repr(transparent)]
    pub struct Four([Float; 4]);

    impl Four {
        #[inline(always)]
        pub fn from_array(a: Quad) -> Self {
            Self(a)
        }
        #[inline(always)]
        pub fn to_array(self) -> Quad {
            self.0
        }
        #[inline(always)]
        fn each(self, o: Self, f: impl Fn(Float, Float) -> Float) -> Self {
            Self([f(self.0[0], o.0[0]), f(self.0[1], o.0[1]), f(self.0[2], o.0[2]), f(self.0[3], o.0[3])])
        }
    }

    impl Add for Four {
        type Output = Self;
        #[inline(always)]
        fn add(self, o: Self) -> Self {
            self.each(o, |a, b| a + b)
        }
    }
    impl Sub for Four {
        type Output = Self;
        #[inline(always)]
        fn sub(self, o: Self) -> Self {
            self.each(o, |a, b| a - b)
        }
    }
    impl Mul for Four {
        type Output = Self;
        #[inline(always)]
        fn mul(self, o: Self) -> Self {
            self.each(o, |a, b| a * b)
        }
    }
    impl Neg for Four {
        type Output = Self;
        #[inline(always)]
        fn neg(self) -> Self {
            Self(self.0.map(|a| -a))
        }
    }

    impl Lane for Four {
        const N: usize = 4;
        type Mask = [bool; 4];
        type Index = [u32; 4];

        #[inline(always)]
        fn same_index(i: u32) -> [u32; 4] {
            [i; 4]
        }
        #[inline(always)]
        fn splat(x: Float) -> Self {
            Self([x; 4])
        }
        #[inline(always)]
        fn get(self, i: usize) -> Float {
            self.0[i]
        }
        #[inline(always)]
        fn put(&mut self, i: usize, x: Float) {
            self.0[i] = x;
        }
        #[inline(always)]
        fn over(self, d: Self) -> Self {
            self.each(d, |a, b| a / b)
        }
        #[inline(always)]
        fn sqrt(self) -> Self {
            Self(self.0.map(Float::sqrt))
        }
        #[inline(always)]
        fn min(self, b: Self) -> Self {
            self.each(b, |a, b| if a < b { a } else { b })
        }
        #[inline(always)]
        fn max(self, b: Self) -> Self {
            self.each(b, |a, b| if a > b { a } else { b })
        }
        #[inline(always)]
        fn gt(self, b: Self) -> [bool; 4] {
            std::array::from_fn(|i| self.0[i] > b.0[i])
        }
        #[inline(always)]
        fn select(mask: [bool; 4], a: Self, b: Self) -> Self {
            Self(std::array::from_fn(|i| if mask[i] { a.0[i] } else { b.0[i] }))
        }
        #[inline(always)]
        fn any(mask: [bool; 4]) -> bool {
            mask.contains(&true)
        }
        #[inline(always)]
        fn gather(rows: impl Fn(usize) -> Quad) -> [Self; 4] {
            let r = [rows(0), rows(1), rows(2), rows(3)];
            std::array::from_fn(|c| Self(std::array::from_fn(|i| r[i][c])))
        }
        #[inline(always)]
        fn scatter(columns: [Self; 4], mut write: impl FnMut(usize, Quad)) {
            for i in 0..4 {
                write(i, std::array::from_fn(|c| columns[c].0[i]));
            }
        }
    }
}

pub use register::Four;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_lanes_equal_four_scalars_bit_for_bit() {
        let a = [1.25, -3.5e-7, 7.1e8, -0.0];
        let b = [0.3, 2.25, -9.1e-3, 0.0];
        let (x, y) = (Four::from_array(a), Four::from_array(b));
        let check = |got: Four, want: &dyn Fn(Float, Float) -> Float| {
            for i in 0..4 {
                assert_eq!(got.get(i).to_bits(), want(a[i], b[i]).to_bits(), "lane {i}");
            }
        };
        check(x + y, &|a, b| a + b);
        check(x - y, &|a, b| a - b);
        check(x * y, &|a, b| a * b);
        check(x.over(y), &|a, b| a / b);
        check(-x, &|a, _| -a);
        check(x.min(y), &|a, b| Lane::min(a, b));
        check(x.max(y), &|a, b| Lane::max(a, b));
        check(y.min(x), &|a, b| Lane::min(b, a));
        check(Four::select(x.gt(y), x, y), &|a, b| if a > b { a } else { b });
    }

    #[test]
    fn gather_and_scatter_transpose() {
        let rows: [Quad; 4] = std::array::from_fn(|i| std::array::from_fn(|c| (10 * i + c) as Float));
        let columns = Four::gather(|i| rows[i]);
        assert_eq!(columns[2].to_array(), [2.0, 12.0, 22.0, 32.0]);
        let mut back = [[0.0; 4]; 4];
        Four::scatter(columns, |i, row| back[i] = row);
        assert_eq!(back, rows);
    }
}
