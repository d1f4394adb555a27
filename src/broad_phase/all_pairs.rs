//! No structure at all: every box against every other, in columns. The oracle stays by itself; this is what its split
//! twin is made of.

use super::boxes::Boxes;
use super::slab::Sweep;
use super::structure::Structure;
use crate::math::{Aabb, Float};

/// Boxes in no order.
#[derive(Clone, Debug, Default)]
pub(super) struct AllPairs {
    boxes: Boxes,
}

impl Structure for AllPairs {
    const JOIN_SHARE: usize = 2;

    fn contains(&self, proxy: u32) -> bool {
        self.boxes.contains(proxy)
    }

    fn aabb(&self, proxy: u32) -> Aabb {
        self.boxes.aabb(proxy)
    }

    fn len(&self) -> usize {
        self.boxes.len()
    }

    fn insert(&mut self, proxy: u32, aabb: &Aabb) {
        self.boxes.insert(proxy, aabb);
    }

    fn remove(&mut self, proxy: u32) {
        self.boxes.remove(proxy);
    }

    fn update(&mut self, proxy: u32, aabb: &Aabb) {
        self.boxes.update(proxy, aabb);
    }

    fn refresh(&mut self) {}

    fn rebuild(&mut self) {}

    fn within(&mut self, meet: &mut impl FnMut(u32, u32)) {
        for (i, (proxy, aabb)) in self.boxes.iter().enumerate() {
            for (other, b) in self.boxes.iter().skip(i + 1) {
                if aabb.overlaps(b) {
                    meet(proxy, other);
                }
            }
        }
    }

    fn between(&mut self, other: &mut Self, meet: &mut impl FnMut(u32, u32)) {
        for (proxy, aabb) in self.boxes.iter() {
            for (met, _) in other.boxes.iter().filter(|(_, b)| aabb.overlaps(b)) {
                meet(proxy, met);
            }
        }
    }

    fn query(&self, aabb: &Aabb, visit: &mut impl FnMut(u32) -> bool) -> bool {
        self.boxes.iter().all(|(proxy, b)| !b.overlaps(aabb) || visit(proxy))
    }

    fn cast(&self, sweep: &Sweep, max: Float, visit: &mut dyn FnMut(u32, Float) -> Float) -> Float {
        let mut max = max;
        for (proxy, aabb) in self.boxes.iter() {
            if sweep.entry(aabb, max).is_some() {
                max = max.min(visit(proxy, max));
                if max <= 0.0 {
                    return 0.0;
                }
            }
        }
        max
    }

    fn bounds(&self) -> Aabb {
        self.boxes.bounds()
    }

    fn byte_count(&self) -> usize {
        self.boxes.byte_count()
    }
}
