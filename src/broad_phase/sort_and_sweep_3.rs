//! Sort and sweep along all three axes \[Cohen et al. 1995\]: along each axis the boxes whose intervals overlap are
//! read off a sorted list, and a pair overlaps when it does so along all three.

use super::slab::Sweep;
use super::sorted::{Roll, Sorted};
use super::structure::{Structure, Whole};
use crate::math::{Aabb, Float};

/// Both in the same lists, what stands and what moves.
pub(super) type SortAndSweep3 = Whole<Lines>;

/// Boxes in three lines.
#[derive(Clone, Debug, Default)]
pub(super) struct Lines {
    roll: Roll,
    /// By axis.
    lists: [Sorted; 3],
    /// By axis, in the order of its list: the intervals' upper sides.
    upper: [Vec<Float>; 3],
    /// By proxy: a number of its own for each box asked about and each axis along which both overlap.
    stamps: Vec<u32>,
}

impl Lines {
    /// Calls `meet` with what overlaps `aabb` along all axes: along x from place `from` on, stamped; along y, of those
    /// stamped; along z, likewise. `stamp` and `stamp` + 1 are numbers not used before.
    fn intersect(&mut self, aabb: &Aabb, from: usize, stamp: u32, meet: &mut impl FnMut(u32)) {
        let Self { lists, upper, stamps, .. } = self;
        for (axis, (list, upper)) in lists.iter().zip(&*upper).enumerate() {
            let mut window = list.window(aabb.lower[axis], aabb.upper[axis]);
            if axis == 0 {
                window.start = window.start.max(from).min(window.end);
            }
            let lower = aabb.lower[axis];
            for (entry, &end) in list.order[window.clone()].iter().zip(&upper[window]) {
                let mark = &mut stamps[entry.proxy as usize];
                match axis {
                    0 if end >= lower => *mark = stamp,
                    1 if end >= lower && *mark == stamp => *mark = stamp + 1,
                    2 if end >= lower && *mark == stamp + 1 => meet(entry.proxy),
                    _ => {}
                }
            }
        }
    }

    fn clear_stamps(&mut self) {
        let len = self.roll.boxes.proxies.iter().max().map_or(0, |&last| last as usize + 1);
        self.stamps.clear();
        self.stamps.resize(len, 0);
    }

    /// The axis whose window for this box holds least, and that window.
    fn least_window(&self, aabb: &Aabb) -> (usize, std::ops::Range<usize>) {
        let windows = [0, 1, 2].map(|k| self.lists[k].window(aabb.lower[k], aabb.upper[k]));
        let [x, y, z] = windows;
        let (axis, best) = if y.len() < x.len() { (1, y) } else { (0, x) };
        if z.len() < best.len() { (2, z) } else { (axis, best) }
    }
}

impl Structure for Lines {
    const JOIN_SHARE: usize = 2;

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
        self.roll.call(&mut self.lists);
        for (axis, (list, upper)) in self.lists.iter_mut().zip(&mut self.upper).enumerate() {
            list.sort(&self.roll.boxes, axis);
            upper.clear();
            upper.extend(list.order.iter().map(|entry| self.roll.boxes.aabb(entry.proxy).upper[axis]));
        }
    }

    fn within(&mut self, meet: &mut impl FnMut(u32, u32)) {
        self.clear_stamps();
        for place in 0..self.len() {
            let proxy = self.lists[0].order[place].proxy;
            let aabb = self.aabb(proxy);
            // Along x only what comes later: each pair is met once.
            self.intersect(&aabb, place + 1, 2 * place as u32 + 1, &mut |met| meet(proxy, met));
        }
    }

    fn between(&mut self, other: &mut Self, meet: &mut impl FnMut(u32, u32)) {
        other.clear_stamps();
        for (i, (proxy, aabb)) in (0u32..).zip(self.roll.boxes.iter()) {
            other.intersect(aabb, 0, 2 * i + 1, &mut |met| meet(proxy, met));
        }
    }

    /// A single box is compared with those in its least window only.
    fn query(&self, aabb: &Aabb, visit: &mut impl FnMut(u32) -> bool) -> bool {
        let boxes = &self.roll.boxes;
        if self.roll.changed {
            return boxes.iter().all(|(proxy, b)| !b.overlaps(aabb) || visit(proxy));
        }
        let (axis, window) = self.least_window(aabb);
        self.lists[axis].order[window]
            .iter()
            .all(|entry| !boxes.aabb(entry.proxy).overlaps(aabb) || visit(entry.proxy))
    }

    fn cast(&self, sweep: &Sweep, max: Float, visit: &mut dyn FnMut(u32, Float) -> Float) -> Float {
        let boxes = &self.roll.boxes;
        let (whole, mut max) = (max, max);
        let mut meet = |proxy: u32, aabb: &Aabb| {
            if sweep.entry(aabb, max).is_some() {
                max = max.min(visit(proxy, max));
            }
            max > 0.0
        };
        if self.roll.changed {
            let _ = boxes.iter().all(|(proxy, aabb)| meet(proxy, aabb));
        } else {
            let (axis, mut window) = self.least_window(&sweep.bounds(whole));
            let order = &self.lists[axis].order;
            let mut at = |place: usize| meet(order[place].proxy, &boxes.aabb(order[place].proxy));
            let _ = if sweep.goes_back(axis) { window.rev().all(at) } else { window.all(&mut at) };
        }
        max
    }

    fn bounds(&self) -> Aabb {
        self.roll.boxes.bounds()
    }

    fn byte_count(&self) -> usize {
        self.roll.byte_count()
            + self.lists.iter().map(Sorted::byte_count).sum::<usize>()
            + self.upper.iter().map(|u| u.capacity() * size_of::<Float>()).sum::<usize>()
            + self.stamps.capacity() * size_of::<u32>()
    }
}
