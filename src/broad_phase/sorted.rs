//! Lists of boxes sorted along an axis, kept from step to step: what moved a little is put right by insertion.

use super::boxes::Boxes;
use crate::math::{Aabb, Float};
use std::cmp::Ordering;

/// Boxes, and who must come into the sorted lists or go out of them at the next refresh.
#[derive(Clone, Debug, Default)]
pub(super) struct Roll {
    pub boxes: Boxes,
    /// By proxy: whether the lists (or `fresh`) hold it.
    listed: Vec<bool>,
    fresh: Vec<u32>,
    gone: bool,
    /// Whether the lists are out of date.
    pub changed: bool,
}

impl Roll {
    pub fn insert(&mut self, proxy: u32, aabb: &Aabb) {
        self.boxes.insert(proxy, aabb);
        let at = proxy as usize;
        if at >= self.listed.len() {
            self.listed.resize(at + 1, false);
        }
        if !std::mem::replace(&mut self.listed[at], true) {
            self.fresh.push(proxy);
        }
        self.changed = true;
    }

    pub fn remove(&mut self, proxy: u32) {
        self.boxes.remove(proxy);
        (self.gone, self.changed) = (true, true);
    }

    pub fn update(&mut self, proxy: u32, aabb: &Aabb) {
        self.boxes.update(proxy, aabb);
        self.changed = true;
    }

    /// Brings the members of the lists up to date; their order is left to [`Sorted::sort`].
    pub fn call(&mut self, lists: &mut [Sorted]) {
        let Self { boxes, listed, fresh, gone, changed } = self;
        if std::mem::take(gone) {
            for list in &mut *lists {
                list.order.retain(|entry| boxes.contains(entry.proxy));
            }
            fresh.retain(|&proxy| boxes.contains(proxy));
            listed.fill(false);
            boxes.proxies.iter().for_each(|&proxy| listed[proxy as usize] = true);
        }
        for list in lists {
            list.order.extend(fresh.iter().map(|&proxy| Entry { lower: 0.0, proxy }));
        }
        fresh.clear();
        *changed = false;
    }

    pub fn byte_count(&self) -> usize {
        self.boxes.byte_count() + self.listed.capacity() + self.fresh.capacity() * size_of::<u32>()
    }
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Entry {
    pub lower: Float,
    pub proxy: u32,
}

/// How a list was brought into order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Way {
    /// By insertion: it was nearly sorted.
    Insertion,
    /// Anew: insertion would have moved too much.
    Full,
}

/// Insertion gives up after this many moves an entry.
const PATIENCE: usize = 8;

/// Proxies in the order of the lower sides of their boxes along one axis.
#[derive(Clone, Debug, Default)]
pub(super) struct Sorted {
    pub order: Vec<Entry>,
    /// By place: the highest upper side up to there. It ascends, so a search in it finds the first box that reaches
    /// up to a value, without error.
    highest: Vec<Float>,
}

impl Sorted {
    /// Reads the lower sides along `axis` and sorts by them.
    pub fn sort(&mut self, boxes: &Boxes, axis: usize) -> Way {
        for entry in &mut self.order {
            entry.lower = boxes.aabb(entry.proxy).lower[axis];
        }
        let way = if insert_all(&mut self.order) {
            Way::Insertion
        } else {
            let before = |a: &Entry, b: &Entry| a.lower.partial_cmp(&b.lower).unwrap_or(Ordering::Equal);
            self.order.sort_unstable_by(before);
            Way::Full
        };
        self.highest.clear();
        let mut high = -Float::MAX;
        self.highest.extend(self.order.iter().map(|entry| {
            high = high.max(boxes.aabb(entry.proxy).upper[axis]);
            high
        }));
        way
    }

    /// The places in which boxes that touch the interval lie; not all that lie there need touch it.
    pub fn window(&self, lower: Float, upper: Float) -> std::ops::Range<usize> {
        let from = self.highest.partition_point(|&high| high < lower);
        let to = self.order.partition_point(|entry| entry.lower <= upper);
        from..to.max(from)
    }

    pub fn byte_count(&self) -> usize {
        self.order.capacity() * size_of::<Entry>() + self.highest.capacity() * size_of::<Float>()
    }
}

/// Sorts by insertion; gives up, with the list in some order, when that takes too long.
fn insert_all(order: &mut [Entry]) -> bool {
    let mut moves = PATIENCE * order.len();
    for i in 1..order.len() {
        let entry = order[i];
        let mut hole = i;
        while hole > 0 && order[hole - 1].lower > entry.lower {
            order[hole] = order[hole - 1];
            hole -= 1;
            if moves == 0 {
                order[hole] = entry;
                return false;
            }
            moves -= 1;
        }
        order[hole] = entry;
    }
    true
}

#[cfg(test)]
mod tests {
    use super::super::random::Random;
    use super::*;
    use crate::math::{Vec3, vec3};

    #[test]
    fn small_moves_are_inserted_and_large_ones_sorted() {
        let (mut roll, mut lists, mut random) = (Roll::default(), [Sorted::default()], Random::new(1));
        let mut at: Vec<Vec3> = (0..1000).map(|_| random.vec() * 100.0).collect();
        let half = vec3(0.5, 0.5, 0.5);
        (0..).zip(&at).for_each(|(i, &p)| roll.insert(i, &Aabb::around(p, half)));
        for round in 0..20 {
            roll.call(&mut lists);
            let way = lists[0].sort(&roll.boxes, 1);
            let afresh = round == 0 || round == 10;
            assert_eq!(way, if afresh { Way::Full } else { Way::Insertion }, "round {round}");
            assert!(lists[0].order.is_sorted_by(|a, b| a.lower <= b.lower));
            assert!(lists[0].highest.is_sorted() && lists[0].highest.len() == 1000);
            for (i, p) in (0..).zip(&mut at) {
                *p += random.vec() * if round == 9 { 100.0 } else { 0.2 };
                roll.update(i, &Aabb::around(*p, half));
            }
        }
    }

    #[test]
    fn who_goes_and_comes_back_is_listed_once() {
        let (mut roll, mut lists) = (Roll::default(), [Sorted::default(), Sorted::default()]);
        let b = Aabb::around(Vec3::zeros(), Vec3::zeros());
        (0..4).for_each(|i| roll.insert(i, &b));
        roll.remove(1);
        roll.insert(1, &b);
        roll.remove(2);
        roll.call(&mut lists);
        roll.remove(3);
        roll.insert(3, &b);
        roll.remove(0);
        roll.insert(2, &b);
        roll.call(&mut lists);
        for list in &lists {
            let mut proxies: Vec<_> = list.order.iter().map(|e| e.proxy).collect();
            proxies.sort_unstable();
            assert_eq!(proxies, [1, 2, 3]);
        }
    }
}
