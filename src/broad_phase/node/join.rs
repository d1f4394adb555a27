//! All pairs at once: a tree walked against itself, or two trees walked together \[Brinkhoff et al. 1993\].
//!
//! One query for each box goes down from the root each time; a join goes down once for all boxes of a node, and looks
//! at no child outside of what the two nodes share.

use super::{FAN, Nodes, bits};
use crate::math::{Aabb, max, min};
use crate::simd::BoxProbe;

impl Nodes {
    /// Calls `meet` with every pair of overlapping proxies of this tree, each once.
    pub(super) fn within(&self, meet: &mut impl FnMut(u32, u32)) {
        if let Some(root) = self.root {
            self.within_below(root, meet);
        }
    }

    fn within_below(&self, at: u32, meet: &mut impl FnMut(u32, u32)) {
        let node = self.node(at);
        for slot in 0..node.len() {
            let (child, aabb) = (node.children[slot], node.aabb(slot));
            // Those after this one.
            let hits = node.hits(&BoxProbe::new(&aabb)) & (!0 << slot << 1);
            if node.level == 0 {
                bits(hits).for_each(|other| meet(child, node.children[other]));
            } else {
                self.within_below(child, meet);
                for other in bits(hits) {
                    let shared = intersection(&aabb, &node.aabb(other));
                    self.between_below(child, self, node.children[other], &shared, meet);
                }
            }
        }
    }

    /// Calls `meet` with every overlapping pair of a proxy here and one of `other`.
    pub(super) fn between(&self, other: &Nodes, meet: &mut impl FnMut(u32, u32)) {
        if let (Some(a), Some(b)) = (self.root, other.root) {
            let (box_a, box_b) = (self.node(a).tight_bounds(), other.node(b).tight_bounds());
            if box_a.overlaps(&box_b) {
                self.between_below(a, other, b, &intersection(&box_a, &box_b), meet);
            }
        }
    }

    /// The same below two nodes whose boxes share `shared`.
    fn between_below(
        &self,
        at_a: u32,
        other: &Nodes,
        at_b: u32,
        shared: &Aabb,
        meet: &mut impl FnMut(u32, u32),
    ) {
        let (a, b) = (self.node(at_a), other.node(at_b));
        let probe = BoxProbe::new(shared);
        // The boxes of a leaf are asked for one by one below a node of leaves: leaves next to each other mostly share no
        // box, and finding that out costs as much.
        if a.level == 0 && b.level <= 1 {
            for slot in bits(a.hits(&probe)) {
                let (child, probe) = (a.children[slot], BoxProbe::new(&a.aabb(slot)));
                if b.level == 0 {
                    bits(b.hits(&probe)).for_each(|hit| meet(child, b.children[hit]));
                    continue;
                }
                for below in bits(b.hits(&probe)) {
                    let leaf = other.node(b.children[below]);
                    bits(leaf.hits(&probe)).for_each(|hit| meet(child, leaf.children[hit]));
                }
            }
            return;
        }
        // The higher tree is opened alone until both are at one level, and then the first.
        if a.level >= b.level {
            for slot in bits(a.hits(&probe)) {
                let shared = intersection(shared, &a.aabb(slot));
                self.between_below(a.children[slot], other, at_b, &shared, meet);
            }
        } else {
            for slot in bits(b.hits(&probe)) {
                let shared = intersection(shared, &b.aabb(slot));
                self.between_below(at_a, other, b.children[slot], &shared, meet);
            }
        }
    }
}

const _: () = assert!(FAN <= 32, "a bit for each child");

/// What two overlapping boxes share.
fn intersection(a: &Aabb, b: &Aabb) -> Aabb {
    Aabb { lower: max(a.lower, b.lower), upper: min(a.upper, b.upper) }
}
