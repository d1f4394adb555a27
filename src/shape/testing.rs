//! Seeded randomness and random shapes for the tests of geometry.

use super::{Capsule, Shape, Sphere};
use crate::math::{Float, Pose, Quat, Vec3, quat, vec3};

/// SplitMix64 (Steele, Lea & Flood 2014).
pub(crate) struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }

    pub fn within(&mut self, lo: Float, hi: Float) -> Float {
        lo + (hi - lo) * ((self.bits() >> 40) as Float / (1_u64 << 24) as Float)
    }

    pub fn vec(&mut self, r: Float) -> Vec3 {
        vec3(self.within(-r, r), self.within(-r, r), self.within(-r, r))
    }

    pub fn unit(&mut self) -> Vec3 {
        loop {
            let v = self.vec(1.0);
            let l2 = v.dot(&v);
            if (0.01..=1.0).contains(&l2) {
                return v / l2.sqrt();
            }
        }
    }

    pub fn rotation(&mut self) -> Quat {
        quat(self.within(-1.0, 1.0), self.vec(1.0))
    }

    pub fn pose(&mut self, r: Float) -> Pose {
        Pose::new(self.vec(r), self.rotation())
    }

    pub fn cloud(&mut self, n: usize, half: Vec3) -> Vec<Vec3> {
        (0..n).map(|_| self.unit().component_mul(&half)).collect()
    }

    /// A bounded shape of one of four kinds, of size about 1.
    pub fn shape(&mut self, kind: usize) -> Shape {
        match kind {
            0 => Shape::Sphere(Sphere::new(self.vec(0.5), self.within(0.2, 1.0)).unwrap()),
            1 => {
                let (p, q) = (self.vec(1.0), self.vec(1.0) + vec3(0.0, 0.0, 2.0));
                Shape::Capsule(Capsule::new(p, q, self.within(0.1, 0.6)).unwrap())
            }
            2 => Shape::new_box(self.within(0.3, 2.0), self.within(0.3, 2.0), self.within(0.3, 2.0)),
            _ => {
                let half = vec3(self.within(0.3, 1.0), self.within(0.3, 1.0), self.within(0.3, 1.0));
                let n = 4 + self.below(30);
                loop {
                    if let Ok(h) = Shape::hull(&self.cloud(n.max(6), half)) {
                        return h;
                    }
                }
            }
        }
    }
}
