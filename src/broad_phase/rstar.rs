//! The R*-tree \[Beckmann et al. 1990\]: above the leaves the child takes a box in whose overlap with its neighbours
//! grows least; a node is parted along the axis of the least margins, where the halves overlap least; and before a
//! node is parted, its outermost children go back to the tree once.

use super::node::{Entry, FAN, Grown, Growth, LEAST, Node};
use super::structure::Whole;
use crate::math::{Aabb, Float, max, min};
use std::cmp::Ordering;

/// Both in one tree, what stands and what moves.
pub(super) type RStar = Whole<Grown<Margins>>;

#[derive(Clone, Debug, Default)]
pub(super) struct Margins;

impl Growth for Margins {
    /// 30 %, the paper's figure.
    const REINSERTED: usize = (FAN + 1) * 3 / 10;

    fn choose(node: &Node, aabb: &Aabb) -> usize {
        let mut best = (0, [Float::INFINITY; 4]);
        for slot in 0..node.len() {
            let child = node.aabb(slot);
            let union = child.union(aabb);
            let overlap_growth = if node.level() == 1 && !child.contains(aabb) {
                (0..node.len()).filter(|&other| other != slot).fold(0.0, |sum, other| {
                    let other = node.aabb(other);
                    sum + shared_volume(&union, &other) - shared_volume(&child, &other)
                })
            } else {
                0.0
            };
            let cost = [
                overlap_growth,
                volume(&union) - volume(&child),
                volume(&child),
                margin(&union) - margin(&child),
            ];
            if cost < best.1 {
                best = (slot, cost);
            }
        }
        best.0
    }

    fn part(entries: &mut [Entry; FAN + 1]) -> usize {
        let (mut axis, mut least) = (0, Float::INFINITY);
        for k in 0..3 {
            sort_along(entries, k);
            let sum = ways_to_part(entries).map(|(_, a, b)| margin(&a) + margin(&b)).sum();
            if sum < least {
                (axis, least) = (k, sum);
            }
        }
        sort_along(entries, axis);
        let (mut middle, mut cost) = (LEAST, [Float::INFINITY; 2]);
        for (at, a, b) in ways_to_part(entries) {
            let new = [shared_volume(&a, &b), volume(&a) + volume(&b)];
            if new < cost {
                (middle, cost) = (at, new);
            }
        }
        middle
    }
}

/// By the lower side, where that ties by the upper.
fn sort_along(entries: &mut [Entry], axis: usize) {
    let key = |e: &Entry| (e.aabb.lower[axis], e.aabb.upper[axis]);
    entries.sort_unstable_by(|a, b| key(a).partial_cmp(&key(b)).unwrap_or(Ordering::Equal));
}

/// Every allowed size of the first group, with the boxes around both groups.
fn ways_to_part(entries: &[Entry; FAN + 1]) -> impl Iterator<Item = (usize, Aabb, Aabb)> {
    let mut after = [Aabb::EMPTY; FAN + 2];
    for i in (0..=FAN).rev() {
        after[i] = after[i + 1].union(&entries[i].aabb);
    }
    let mut before = Aabb::EMPTY;
    (1..=FAN + 1 - LEAST).filter_map(move |at| {
        before = before.union(&entries[at - 1].aabb);
        (at >= LEAST).then_some((at, before, after[at]))
    })
}

fn shared_volume(a: &Aabb, b: &Aabb) -> Float {
    let d = min(a.upper, b.upper) - max(a.lower, b.lower);
    d.x.max(0.0) * d.y.max(0.0) * d.z.max(0.0)
}

fn volume(b: &Aabb) -> Float {
    let d = b.upper - b.lower;
    d.x * d.y * d.z
}

fn margin(b: &Aabb) -> Float {
    (b.upper - b.lower).sum()
}
