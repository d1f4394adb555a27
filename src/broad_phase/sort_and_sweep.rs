//! Sort and sweep along one axis \[Baraff 1992\]: boxes sorted by their lower sides; each is compared with those that
//! begin before it ends. The axis is the one along which the centres vary most.

use super::slab::Sweep;
use super::sorted::{Roll, Sorted};
use super::structure::{Structure, Whole};
use crate::math::{Aabb, Float};
use crate::simd::{BoxProbe, Quad};

/// Both in one list, what stands and what moves.
pub(super) type SortAndSweep = Whole<Line>;

/// Another axis must be better by this factor, in variance, before the list is sorted along it: a scene that spreads
/// alike along two axes would otherwise be sorted anew every few steps.
const HYSTERESIS: Float = 1.5;

/// Four boxes of the sorted list, in columns.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
struct Block {
    lower: [Quad; 3],
    upper: [Quad; 3],
}

/// Hit by nothing.
const FREE: Block = Block { lower: [[Float::MAX; 4]; 3], upper: [[-Float::MAX; 4]; 3] };

impl Block {
    #[inline(always)]
    fn hits(&self, probe: &BoxProbe) -> u32 {
        probe.hits(self.lower.each_ref(), self.upper.each_ref())
    }
}

/// Boxes in a line.
#[derive(Clone, Debug, Default)]
pub(super) struct Line {
    roll: Roll,
    axis: usize,
    list: Sorted,
    /// The boxes in the order of the list.
    blocks: Vec<Block>,
}

impl Line {
    fn choose_axis(&mut self) {
        let variance = variance(&self.roll.boxes.aabbs);
        let best = (1..3).fold(0, |best, k| if variance[k] > variance[best] { k } else { best });
        if variance[best] > HYSTERESIS * variance[self.axis] {
            self.axis = best;
        }
    }

    fn aabb_at(&self, place: usize) -> Aabb {
        self.roll.boxes.aabb(self.list.order[place].proxy)
    }

    /// Calls `meet` with the places, from `from` on, of the boxes that overlap `aabb` and begin before it ends,
    /// until told to stop.
    #[inline(always)]
    fn scan(&self, aabb: &Aabb, from: usize, meet: &mut impl FnMut(usize) -> bool) -> bool {
        let (probe, end) = (BoxProbe::new(aabb), aabb.upper[self.axis]);
        let mut mask = 0b1111 << (from % 4) & 0b1111u32;
        for (quad, block) in (from / 4..).zip(self.blocks.iter().skip(from / 4)) {
            if block.lower[self.axis][0] > end {
                break;
            }
            let mut hits = block.hits(&probe) & mask;
            while hits != 0 {
                if !meet(quad * 4 + hits.trailing_zeros() as usize) {
                    return false;
                }
                hits &= hits - 1;
            }
            mask = 0b1111;
        }
        true
    }
}

/// The variance of the centres along each axis, times four.
fn variance(aabbs: &[Aabb]) -> [Float; 3] {
    let n = (aabbs.len() as Float).max(1.0);
    let mut mean = [0.0 as Float; 3];
    for b in aabbs {
        (0..3).for_each(|k| mean[k] += (b.lower[k] + b.upper[k]) / n);
    }
    let mut sum = [0.0 as Float; 3];
    for b in aabbs {
        (0..3).for_each(|k| {
            sum[k] += (b.lower[k] + b.upper[k] - mean[k]) * (b.lower[k] + b.upper[k] - mean[k]) / n
        });
    }
    sum
}

impl Structure for Line {
    const JOIN_SHARE: usize = 3;

    fn contains(&self, proxy: u32) -> bool {
        self.roll.boxes.contains(proxy)
    }

    fn aabb(&self, proxy: u32) -> Aabb {
        self.roll.boxes.aabb(proxy)
    }

    fn len(&self) -> usize {
        self.roll.boxes.len()
    }

    fn insert(&mut self, proxy: u32, aabb: &Aabb) {
        self.roll.insert(proxy, aabb);
    }

    fn remove(&mut self, proxy: u32) {
        self.roll.remove(proxy);
    }

    fn update(&mut self, proxy: u32, aabb: &Aabb) {
        self.roll.update(proxy, aabb);
    }

    fn refresh(&mut self) {
        if self.roll.changed {
            self.rebuild();
        }
    }

    fn rebuild(&mut self) {
        self.choose_axis();
        self.roll.call(std::slice::from_mut(&mut self.list));
        self.list.sort(&self.roll.boxes, self.axis);
        let Self { roll, list, blocks, .. } = self;
        blocks.clear();
        blocks.extend(list.order.chunks(4).map(|four| {
            let mut block = FREE;
            for (i, entry) in four.iter().enumerate() {
                let b = roll.boxes.aabb(entry.proxy);
                for k in 0..3 {
                    block.lower[k][i] = b.lower[k];
                    block.upper[k][i] = b.upper[k];
                }
            }
            block
        }));
    }

    fn within(&mut self, meet: &mut impl FnMut(u32, u32)) {
        for (place, entry) in self.list.order.iter().enumerate() {
            self.scan(&self.aabb_at(place), place + 1, &mut |other| {
                meet(entry.proxy, self.list.order[other].proxy);
                true
            });
        }
    }

    /// Both lists are swept together if they lie along one axis; otherwise each box here asks the other list.
    fn between(&mut self, other: &mut Self, meet: &mut impl FnMut(u32, u32)) {
        if self.axis != other.axis {
            for (proxy, aabb) in self.roll.boxes.iter() {
                other.query(aabb, &mut |met| {
                    meet(proxy, met);
                    true
                });
            }
            return;
        }
        let (mine, others) = (&self.list.order, &other.list.order);
        let mut from = 0;
        for (place, entry) in mine.iter().enumerate() {
            while from < others.len() && others[from].lower < entry.lower {
                from += 1;
            }
            other.scan(&self.aabb_at(place), from, &mut |met| {
                meet(entry.proxy, others[met].proxy);
                true
            });
        }
        from = 0;
        for (place, entry) in others.iter().enumerate() {
            // Those that begin together were met above.
            while from < mine.len() && mine[from].lower <= entry.lower {
                from += 1;
            }
            self.scan(&other.aabb_at(place), from, &mut |met| {
                meet(mine[met].proxy, entry.proxy);
                true
            });
        }
    }

    fn query(&self, aabb: &Aabb, visit: &mut impl FnMut(u32) -> bool) -> bool {
        if self.roll.changed {
            return self.roll.boxes.iter().all(|(proxy, b)| !b.overlaps(aabb) || visit(proxy));
        }
        let from = self.list.window(aabb.lower[self.axis], aabb.upper[self.axis]).start;
        self.scan(aabb, from, &mut |place| visit(self.list.order[place].proxy))
    }

    fn cast(&self, sweep: &Sweep, max: Float, visit: &mut dyn FnMut(u32, Float) -> Float) -> Float {
        let (whole, mut max) = (max, max);
        let mut meet = |proxy: u32, aabb: &Aabb| {
            if sweep.entry(aabb, max).is_some() {
                max = max.min(visit(proxy, max));
            }
            max > 0.0
        };
        if self.roll.changed {
            let _ = self.roll.boxes.iter().all(|(proxy, aabb)| meet(proxy, aabb));
        } else {
            let swept = sweep.bounds(whole);
            let mut window = self.list.window(swept.lower[self.axis], swept.upper[self.axis]);
            let mut at = |place: usize| meet(self.list.order[place].proxy, &self.aabb_at(place));
            let _ = if sweep.goes_back(self.axis) { window.rev().all(at) } else { window.all(&mut at) };
        }
        max
    }

    fn bounds(&self) -> Aabb {
        self.roll.boxes.bounds()
    }

    fn byte_count(&self) -> usize {
        self.roll.byte_count() + self.list.byte_count() + self.blocks.capacity() * size_of::<Block>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::vec3;

    #[test]
    fn the_axis_follows_the_spread_with_hysteresis() {
        let mut line = Line::default();
        let place = |line: &mut Line, spread: [Float; 3]| {
            for i in 0..8u32 {
                let sign = |bit: u32| if i >> bit & 1 == 0 { -1.0 } else { 1.0 };
                let p = vec3(sign(0) * spread[0], sign(1) * spread[1], sign(2) * spread[2]);
                let b = Aabb::around(p, vec3(0.1, 0.1, 0.1));
                if line.contains(i) { line.update(i, &b) } else { line.insert(i, &b) }
            }
            line.refresh();
            line.axis
        };
        assert_eq!(place(&mut line, [1.0, 2.0, 1.0]), 1);
        assert_eq!(place(&mut line, [1.0, 2.0, 2.2]), 1);
        assert_eq!(place(&mut line, [1.0, 2.0, 3.0]), 2);
        assert_eq!(place(&mut line, [1.0, 2.8, 2.5]), 2);
        assert_eq!(place(&mut line, [9.0, 2.8, 2.5]), 0);
    }
}
