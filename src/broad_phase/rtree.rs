//! Guttman's R-tree, as the seed has it: the child whose volume grows least takes a box in, and a full node is parted
//! by the quadratic method \[Guttman 1984\].

use super::node::{Entry, FAN, Grown, Growth, LEAST, Node};
use super::structure::Whole;
use crate::math::{Aabb, Float};

/// Both in one tree, what stands and what moves.
pub(super) type RTree = Whole<Grown<Quadratic>>;

#[derive(Clone, Debug, Default)]
pub(super) struct Quadratic;

impl Growth for Quadratic {
    const REINSERTED: usize = 0;

    fn choose(node: &Node, aabb: &Aabb) -> usize {
        let mut best = (0, [Float::INFINITY; 3]);
        for slot in 0..node.len() {
            let child = node.aabb(slot);
            let union = child.union(aabb);
            // Flat boxes and points have no volume; the sum of the sides then tells.
            let cost = [volume(&union) - volume(&child), volume(&child), margin(&union) - margin(&child)];
            if cost < best.1 {
                best = (slot, cost);
            }
        }
        best.0
    }

    fn part(entries: &mut [Entry; FAN + 1]) -> usize {
        // The two that would waste most volume together begin the groups.
        let (mut seeds, mut most) = ((0, 1), -Float::INFINITY);
        for i in 0..entries.len() {
            for j in i + 1..entries.len() {
                let (a, b) = (&entries[i].aabb, &entries[j].aabb);
                let waste = volume(&a.union(b)) - volume(a) - volume(b);
                if waste > most {
                    (seeds, most) = ((i, j), waste);
                }
            }
        }
        // The groups grow from both ends towards each other.
        let last = entries.len() - 1;
        entries.swap(last, seeds.1);
        entries.swap(0, seeds.0);
        let (mut left, mut right) = (1, last);
        let mut around = [entries[0].aabb, entries[last].aabb];
        while left < right {
            let rest = right - left;
            let sizes = [left, entries.len() - right];
            // A group that needs all that is left gets it.
            let short = sizes.iter().position(|size| size + rest <= LEAST);
            let growth = |e: &Entry| [0, 1].map(|g| volume(&around[g].union(&e.aabb)) - volume(&around[g]));
            let (mut next, mut most) = (left, -1.0);
            if short.is_none() {
                for (i, entry) in entries.iter().enumerate().take(right).skip(left) {
                    let [a, b] = growth(entry);
                    if (a - b).abs() > most {
                        (next, most) = (i, (a - b).abs());
                    }
                }
            }
            let [a, b] = growth(&entries[next]);
            let by_size = || (volume(&around[0]), sizes[0]) < (volume(&around[1]), sizes[1]);
            let group =
                short.unwrap_or_else(|| if a != b { usize::from(b < a) } else { usize::from(!by_size()) });
            around[group] = around[group].union(&entries[next].aabb);
            if group == 0 {
                entries.swap(left, next);
                left += 1;
            } else {
                right -= 1;
                entries.swap(right, next);
            }
        }
        left
    }
}

fn volume(b: &Aabb) -> Float {
    let d = b.upper - b.lower;
    d.x * d.y * d.z
}

fn margin(b: &Aabb) -> Float {
    (b.upper - b.lower).sum()
}
