//! Sort-tile-recursive packing \[Leutenegger et al. 1997\]: slabs along x, columns along y, runs along z, each run a
//! full node; then the same over the nodes.

use super::node::{Builder, FAN, Item, Packed, Packing, cut};
use super::structure::Whole;
use crate::math::{Float, scalar};

/// Both in one tree, what stands and what moves.
pub(super) type Str = Whole<Packed<Tiles>>;

#[derive(Clone, Debug, Default)]
pub(super) struct Tiles;

impl Packing for Tiles {
    fn pack(builder: &mut Builder, items: &mut [Item]) -> u32 {
        let (mut count, mut level) = (items.len(), 0);
        loop {
            tile(&mut items[..count], 0);
            // The nodes of this level are the items of the next; none is written before what it holds was read.
            let nodes = count.div_ceil(FAN);
            for k in 0..nodes {
                let run = k * FAN..count.min((k + 1) * FAN);
                let at = if level == 0 {
                    builder.leaf(&items[run])
                } else {
                    let at = builder.inner(level);
                    items[run].iter().for_each(|item| builder.hang(at, item.index));
                    at
                };
                items[k] = builder.item(at);
            }
            if nodes == 1 {
                return items[0].index;
            }
            (count, level) = (nodes, level + 1);
        }
    }
}

/// Cuts into slabs of S = ⌈P^(1/d)⌉ for P nodes and d axes left, each of a whole number of nodes, and those
/// in turn along the next axis; the last axis cuts runs of one node.
fn tile(items: &mut [Item], axis: usize) {
    let nodes = items.len().div_ceil(FAN);
    if nodes <= 1 {
        return;
    }
    let slabs = match axis {
        0 => ceil_root(nodes, 3),
        1 => ceil_root(nodes, 2),
        _ => nodes,
    };
    let size = nodes.div_ceil(slabs) * FAN;
    slice(items, axis, size);
    if axis < 2 {
        items.chunks_mut(size).for_each(|slab| tile(slab, axis + 1));
    }
}

/// Arranges along the axis so that each chunk of `size` comes before the next: halved at a multiple of the size.
fn slice(items: &mut [Item], axis: usize, size: usize) {
    let chunks = items.len().div_ceil(size);
    if chunks < 2 {
        return;
    }
    let middle = chunks / 2 * size;
    cut(items, axis, &[middle]);
    let (left, right) = items.split_at_mut(middle);
    slice(left, axis, size);
    slice(right, axis, size);
}

/// The least s with s^power ≥ n.
fn ceil_root(n: usize, power: u32) -> usize {
    let n_float = n as Float;
    let guess = if power == 3 { scalar::cbrt(n_float) } else { n_float.sqrt() } as usize;
    let mut s = guess.saturating_sub(1).max(1);
    while s.pow(power) < n {
        s += 1;
    }
    s
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_exact() {
        for n in 1..5000 {
            for power in [2, 3] {
                let s = ceil_root(n, power);
                assert!(s.pow(power) >= n && (s - 1).pow(power) < n);
            }
        }
    }
}
