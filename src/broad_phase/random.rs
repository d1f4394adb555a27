use crate::math::{Float, Vec3, vec3};

/// Random numbers for tests: splitmix64.
pub(super) struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ x >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ x >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ x >> 31
    }

    /// 0 … n − 1.
    pub fn below(&mut self, n: u32) -> u32 {
        (((self.next() >> 32) * u64::from(n)) >> 32) as u32
    }

    /// −1 … 1.
    pub fn signed(&mut self) -> Float {
        (self.next() >> 40) as Float / (1u64 << 23) as Float - 1.0
    }

    pub fn vec(&mut self) -> Vec3 {
        vec3(self.signed(), self.signed(), self.signed())
    }
}
