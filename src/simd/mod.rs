//! Lanes: several scalars computed side by side. Every width gives the same bits: no fused multiply-add, no
//! reduction across lanes, and minimum and maximum that treat equal operands alike.
//!
//! `Float` itself is the lane of width 1, the oracle. [`Four`] has four: one SSE register for f32 on x86-64
//! (baseline there, so nothing is detected at run time), a plain array elsewhere.

mod boxes;
mod four;

pub use boxes::BoxProbe;
pub use four::Four;

use crate::math::Float;
use std::ops::{Add, Mul, Neg, Sub};

/// Asks for the memory of `x`, which will be needed soon. Changes nothing but when it arrives.
#[inline(always)]
pub fn prefetch<T>(x: &T) {
    #[cfg(target_arch = "x86_64")]
    for line in 0..size_of::<T>().div_ceil(64) {
        use core::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: SSE, which every x86-64 target has; a prefetch never faults, and the address lies in `x`.
        unsafe { _mm_prefetch::<_MM_HINT_T0>((&raw const *x).cast::<i8>().add(64 * line)) }
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = x;
}

/// A row of four scalars in memory: what bodies are gathered and scattered by.
pub type Quad = [Float; 4];

/// A group of scalars that are computed side by side.
pub trait Lane:
    Copy
    + Send
    + Sync
    + std::fmt::Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// How many.
    const N: usize;
    /// The result of a comparison.
    type Mask: Copy;
    /// An index for each lane.
    type Index: Copy + Send + Sync + AsRef<[u32]> + AsMut<[u32]> + std::fmt::Debug;

    /// An index for each lane, all the same.
    fn same_index(i: u32) -> Self::Index;
    /// All lanes the same.
    fn splat(x: Float) -> Self;
    /// Lane `i`.
    fn get(self, i: usize) -> Float;
    /// Sets lane `i`.
    fn put(&mut self, i: usize, x: Float);
    /// Quotients.
    fn over(self, d: Self) -> Self;
    /// Square roots.
    fn sqrt(self) -> Self;
    /// The lesser; the second where they compare equal or one is NaN.
    fn min(self, b: Self) -> Self;
    /// The greater; the second where they compare equal or one is NaN.
    fn max(self, b: Self) -> Self;
    /// Where `self > b`.
    fn gt(self, b: Self) -> Self::Mask;
    /// Where the mask is set `a`, elsewhere `b`.
    fn select(mask: Self::Mask, a: Self, b: Self) -> Self;
    /// Whether the mask is set anywhere.
    fn any(mask: Self::Mask) -> bool;
    /// Four columns from one [`Quad`] a lane.
    fn gather(rows: impl Fn(usize) -> Quad) -> [Self; 4];
    /// One [`Quad`] a lane from four columns.
    fn scatter(columns: [Self; 4], write: impl FnMut(usize, Quad));

    /// All lanes 0.
    #[inline(always)]
    fn zero() -> Self {
        Self::splat(0.0)
    }
}

impl Lane for Float {
    const N: usize = 1;
    type Mask = bool;
    type Index = [u32; 1];

    #[inline(always)]
    fn same_index(i: u32) -> [u32; 1] {
        [i]
    }
    #[inline(always)]
    fn splat(x: Float) -> Self {
        x
    }
    #[inline(always)]
    fn get(self, _: usize) -> Float {
        self
    }
    #[inline(always)]
    fn put(&mut self, _: usize, x: Float) {
        *self = x;
    }
    #[inline(always)]
    fn over(self, d: Self) -> Self {
        self / d
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Float::sqrt(self)
    }
    #[inline(always)]
    fn min(self, b: Self) -> Self {
        if self < b { self } else { b }
    }
    #[inline(always)]
    fn max(self, b: Self) -> Self {
        if self > b { self } else { b }
    }
    #[inline(always)]
    fn gt(self, b: Self) -> bool {
        self > b
    }
    #[inline(always)]
    fn select(mask: bool, a: Self, b: Self) -> Self {
        if mask { a } else { b }
    }
    #[inline(always)]
    fn any(mask: bool) -> bool {
        mask
    }
    #[inline(always)]
    fn gather(rows: impl Fn(usize) -> Quad) -> [Self; 4] {
        rows(0)
    }
    #[inline(always)]
    fn scatter(columns: [Self; 4], mut write: impl FnMut(usize, Quad)) {
        write(0, columns);
    }
}

/// A vector in each lane.
#[derive(Clone, Copy, Debug)]
pub struct V3<L> {
    /// The x components.
    pub x: L,
    /// The y components.
    pub y: L,
    /// The z components.
    pub z: L,
}

impl<L: Lane> V3<L> {
    /// From components.
    #[inline(always)]
    pub fn new(x: L, y: L, z: L) -> Self {
        Self { x, y, z }
    }
    /// All 0.
    #[inline(always)]
    pub fn zero() -> Self {
        Self::new(L::zero(), L::zero(), L::zero())
    }
    /// The vector of lane `i`.
    #[inline(always)]
    pub fn get(&self, i: usize) -> crate::math::Vec3 {
        crate::math::vec3(self.x.get(i), self.y.get(i), self.z.get(i))
    }
    /// Sets the vector of lane `i`.
    #[inline(always)]
    pub fn put(&mut self, i: usize, v: crate::math::Vec3) {
        self.x.put(i, v.x);
        self.y.put(i, v.y);
        self.z.put(i, v.z);
    }
    /// Dot products.
    #[inline(always)]
    pub fn dot(self, o: Self) -> L {
        self.x * o.x + self.y * o.y + self.z * o.z
    }
    /// Cross products.
    #[inline(always)]
    pub fn cross(self, o: Self) -> Self {
        Self::new(self.y * o.z - self.z * o.y, self.z * o.x - self.x * o.z, self.x * o.y - self.y * o.x)
    }
    /// Each vector times its lane's factor.
    #[inline(always)]
    pub fn times(self, s: L) -> Self {
        Self::new(self.x * s, self.y * s, self.z * s)
    }
    /// Selects by lane.
    #[inline(always)]
    pub fn select(mask: L::Mask, a: Self, b: Self) -> Self {
        Self::new(L::select(mask, a.x, b.x), L::select(mask, a.y, b.y), L::select(mask, a.z, b.z))
    }
}

impl<L: Lane> Add for V3<L> {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        Self::new(self.x + o.x, self.y + o.y, self.z + o.z)
    }
}

impl<L: Lane> Sub for V3<L> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        Self::new(self.x - o.x, self.y - o.y, self.z - o.z)
    }
}

/// A symmetric matrix in each lane.
#[derive(Clone, Copy, Debug)]
pub struct Sym3<L> {
    /// Row 1.
    pub xx: L,
    /// Row 1, column 2.
    pub xy: L,
    /// Row 1, column 3.
    pub xz: L,
    /// Row 2.
    pub yy: L,
    /// Row 2, column 3.
    pub yz: L,
    /// Row 3.
    pub zz: L,
}

impl<L: Lane> Sym3<L> {
    /// Matrix times vector.
    #[inline(always)]
    pub fn times(&self, v: V3<L>) -> V3<L> {
        V3::new(
            self.xx * v.x + self.xy * v.y + self.xz * v.z,
            self.xy * v.x + self.yy * v.y + self.yz * v.z,
            self.xz * v.x + self.yz * v.y + self.zz * v.z,
        )
    }
}
