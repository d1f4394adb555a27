//! Numbers, mostly sensible, sometimes not.

use merev::capi::*;

/// SplitMix64.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x5851_f42d_4c95_7f2d)
    }

    pub fn word(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn below(&mut self, n: usize) -> usize {
        (self.word() % n as u64) as usize
    }

    /// An index that prefers the end of a list.
    pub fn late(&mut self, n: usize) -> usize {
        let a = self.below(n);
        a.max(self.below(n))
    }

    fn unit(&mut self) -> f64 {
        (self.word() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn num(&mut self) -> mvFloat {
        let u = self.unit();
        match self.below(24) {
            0 => mvFloat::NAN,
            1 => mvFloat::INFINITY,
            2 => -mvFloat::INFINITY,
            3 => mvFloat::MAX,
            4 => mvFloat::MIN_POSITIVE,
            5 => 0.0,
            6 => -0.0,
            7 => (u * 2e9) as mvFloat,
            8 => -(u * 10.0) as mvFloat,
            9 => (u * 1e-6) as mvFloat,
            10 => (u * 1e5) as mvFloat,
            _ => (u * 2.0) as mvFloat,
        }
    }

    pub fn size(&mut self) -> mvFloat {
        if self.below(20) == 0 { self.num() } else { (0.1 + self.unit()) as mvFloat }
    }

    fn small(&mut self) -> mvFloat {
        (self.unit() * 8.0 - 4.0) as mvFloat
    }

    pub fn vec(&mut self) -> mvVec3 {
        let mut v = mvVec3 { x: self.small(), y: self.small(), z: self.small() };
        match self.below(40) {
            0 => v.x = self.num(),
            1 => v.y = self.num(),
            2 => v.z = self.num(),
            3 => v = mvVec3::default(),
            _ => {}
        }
        v
    }

    pub fn pos(&mut self) -> mvPos {
        let v = self.vec();
        mvPos { x: v.x, y: v.y, z: v.z }
    }

    /// A position where bodies meet.
    pub fn place(&mut self) -> mvPos {
        let mut p = self.pos();
        p.y += 3.0;
        p
    }

    pub fn quat(&mut self) -> mvQuat {
        let v = mvVec3 { x: self.small(), y: self.small(), z: self.small() };
        let s = self.small();
        let l = (v.x * v.x + v.y * v.y + v.z * v.z + s * s).sqrt();
        match self.below(30) {
            0 => mvQuat { v: self.vec(), s: self.num() },
            1..=12 => mvQuat { v: mvVec3::default(), s: 1.0 },
            _ => mvQuat { v: mvVec3 { x: v.x / l, y: v.y / l, z: v.z / l }, s: s / l },
        }
    }

    pub fn transform(&mut self) -> mvTransform {
        mvTransform { p: self.vec(), q: self.quat() }
    }

    pub fn world_transform(&mut self) -> mvWorldTransform {
        mvWorldTransform { p: self.place(), q: self.quat() }
    }

    pub fn flag(&mut self) -> Flag {
        if self.below(12) == 0 { self.word() as u8 } else { self.below(2) as u8 }
    }

    /// A number for an enumeration, a count or a capacity.
    pub fn choice(&mut self) -> i32 {
        match self.below(10) {
            0 => self.word() as i32,
            1 => -1,
            2 => i32::MIN,
            3 => i32::MAX,
            _ => self.below(4) as i32,
        }
    }

    pub fn filter(&mut self) -> mvQueryFilter {
        let mut f = mvDefaultQueryFilter();
        if self.below(6) == 0 {
            f.mask_bits = self.word();
        }
        f
    }

    pub fn aabb(&mut self) -> mvAABB {
        let (a, d) = (self.vec(), self.size());
        if self.below(10) == 0 {
            return mvAABB { lower_bound: a, upper_bound: self.vec() };
        }
        mvAABB { lower_bound: a, upper_bound: mvVec3 { x: a.x + d, y: a.y + d, z: a.z + d } }
    }
}
