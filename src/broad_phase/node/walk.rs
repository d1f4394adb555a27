//! Questions to one tree.

use super::super::slab::Sweep;
use super::{FAN, Nodes, bits};
use crate::math::{Aabb, Float};
use crate::simd::BoxProbe;

impl Nodes {
    /// Visits the proxies whose boxes overlap `aabb` until told to stop; returns whether it was not.
    pub(super) fn query(&self, aabb: &Aabb, visit: &mut impl FnMut(u32) -> bool) -> bool {
        self.root.is_none_or(|root| self.query_below(root, &BoxProbe::new(aabb), visit))
    }

    /// All ways down are equally long and short: a tree of 2³¹ boxes has at most 12 levels.
    pub(super) fn query_below(&self, at: u32, probe: &BoxProbe, visit: &mut impl FnMut(u32) -> bool) -> bool {
        let node = self.node(at);
        let hits = node.hits(probe);
        if node.level == 0 {
            bits(hits).all(|slot| visit(node.children[slot]))
        } else {
            bits(hits).all(|slot| self.query_below(node.children[slot], probe, visit))
        }
    }

    /// Visits the proxies that `sweep` meets, the nearest child of a node first, and returns the fraction that the
    /// visitor left of it.
    pub(super) fn cast(
        &self,
        sweep: &Sweep,
        max: Float,
        visit: &mut dyn FnMut(u32, Float) -> Float,
    ) -> Float {
        self.root.map_or(max, |root| self.cast_below(root, sweep, max, visit))
    }

    fn cast_below(
        &self,
        at: u32,
        sweep: &Sweep,
        max: Float,
        visit: &mut dyn FnMut(u32, Float) -> Float,
    ) -> Float {
        let node = self.node(at);
        let mut met = [(0.0 as Float, 0u32); FAN];
        let mut count = 0;
        for first in (0..node.len()).step_by(4) {
            let (hits, enter) = node.entries(first / 4, sweep, max);
            for i in bits(hits) {
                // By insertion: there are few, and equals stay in the order of the slots.
                let place = met[..count].iter().rposition(|m| m.0 <= enter[i]).map_or(0, |p| p + 1);
                met.copy_within(place..count, place + 1);
                met[place] = (enter[i], node.children[first + i]);
                count += 1;
            }
        }
        let mut max = max;
        for &(enter, child) in &met[..count] {
            if enter > max {
                break;
            }
            max = match node.level {
                0 => max.min(visit(child, max)),
                _ => self.cast_below(child, sweep, max, visit),
            };
            if max <= 0.0 {
                return 0.0;
            }
        }
        max
    }
}
