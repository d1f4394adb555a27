//! Overlap-minimising top-down bulk loading \[Lee, Lee 2003\], as the seed has it: a node's boxes are cut into as many
//! equal parts as it needs children, along x, then y, then z; each part becomes a child in the same way.

use super::node::{Builder, FAN, Item, Packed, Packing, cut, top_level};
use super::structure::Whole;

/// Both in one tree, what stands and what moves.
pub(super) type Omt = Whole<Packed<Cuts>>;

#[derive(Clone, Debug, Default)]
pub(super) struct Cuts;

impl Packing for Cuts {
    fn pack(builder: &mut Builder, items: &mut [Item]) -> u32 {
        build(builder, items, top_level(items.len()))
    }
}

/// A node of this level over the items. The children are as few as can hold them, so all but a few nodes are full.
fn build(builder: &mut Builder, items: &mut [Item], level: u32) -> u32 {
    if level == 0 {
        return builder.leaf(items);
    }
    let at = builder.inner(level);
    let plan = Plan::new(items.len().div_ceil(FAN.pow(level)), items.len());
    plan.carry_out(items);
    let mut from = 0;
    for &end in plan.ends(2) {
        let child = build(builder, &mut items[from..end], level - 1);
        builder.hang(at, child);
        from = end;
    }
    at
}

/// Where to cut, counted bottom-up and carried out top-down.
#[derive(Clone, Copy, Debug, Default)]
struct Plan {
    /// By axis: how many parts there are after the cuts along it, and where each of them ends.
    cuts: [(usize, [usize; FAN]); 3],
}

impl Plan {
    /// Along the last axis there are `parts` parts, alike in size but for one item; along the one before round
    /// (parts^(2/3)) groups of them, and along the first round (parts^(1/3)) groups of those. Where a level does not
    /// divide evenly the smaller groups come first.
    fn new(parts: usize, items: usize) -> Self {
        let mut plan = Self::default();
        let mut below = items;
        for (axis, groups) in [(2, parts), (1, rounded_power(parts, 2)), (0, rounded_power(parts, 1))] {
            let (small, small_groups) = (below / groups, groups - below % groups);
            for g in 0..groups {
                let end = (g + 1) * small + (g + 1).saturating_sub(small_groups);
                plan.cuts[axis].1[g] = if axis == 2 { end } else { plan.cuts[axis + 1].1[end - 1] };
            }
            plan.cuts[axis].0 = groups;
            below = groups;
        }
        plan
    }

    /// The ends of the parts after the cuts along this axis.
    fn ends(&self, axis: usize) -> &[usize] {
        let (count, ends) = &self.cuts[axis];
        &ends[..*count]
    }

    fn carry_out(&self, items: &mut [Item]) {
        let whole = [items.len()];
        for axis in 0..3 {
            let mut from = 0;
            for &end in if axis == 0 { &whole[..] } else { self.ends(axis - 1) } {
                let mut inside = [0; FAN];
                let mut count = 0;
                for &cut in self.ends(axis).iter().filter(|&&cut| from < cut && cut < end) {
                    inside[count] = cut - from;
                    count += 1;
                }
                cut(&mut items[from..end], axis, &inside[..count]);
                from = end;
            }
        }
    }
}

/// n^(power/3), rounded, without a rounding error on the way.
fn rounded_power(n: usize, power: u32) -> usize {
    (1..).find(|r| (2 * r + 1usize).pow(3) > 8 * n.pow(power)).unwrap_or(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_rounded() {
        // 2^(1/3) = 1.26, 2^(2/3) = 1.59, 13^(1/3) = 2.35, 13^(2/3) = 5.53, 16^(2/3) = 6.35, 27^(1/3) = 3
        let powers = [(2, 1, 1), (2, 2, 2), (13, 1, 2), (13, 2, 6), (16, 2, 6), (27, 1, 3), (1, 2, 1)];
        powers.iter().for_each(|&(n, power, r)| assert_eq!(rounded_power(n, power), r));
    }

    /// The seed's appendix, redone by hand: 13 parts of 100 items are 4 of 7 and 9 of 8, small ones first; 6 groups
    /// of those are 5 of 2 parts and 1 of 3; 2 groups of those are 3 each.
    #[test]
    fn cuts_are_counted_from_below() {
        let plan = Plan::new(13, 100);
        assert_eq!(plan.ends(2), [7, 14, 21, 28, 36, 44, 52, 60, 68, 76, 84, 92, 100]);
        assert_eq!(plan.ends(1), [14, 28, 44, 60, 76, 100]);
        assert_eq!(plan.ends(0), [44, 100]);
    }

    #[test]
    fn no_part_is_empty_or_too_large() {
        for parts in 2..=FAN {
            for items in (parts - 1) * FAN + 1..=parts * FAN {
                let plan = Plan::new(parts, items);
                let mut from = 0;
                for &end in plan.ends(2) {
                    assert!(from < end && end - from <= FAN);
                    from = end;
                }
                assert_eq!(from, items);
                (0..2).for_each(|axis| {
                    assert!(plan.ends(axis).iter().all(|e| plan.ends(axis + 1).contains(e)))
                });
            }
        }
    }
}
