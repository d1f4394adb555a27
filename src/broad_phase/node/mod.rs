//! The store of the R-tree family: wide nodes in one flat array, and what every tree in it can do whoever built it.
//!
//! A node of level 0 holds proxies, a node of level k holds nodes of level k − 1, so all ways down are equally long.
//! It keeps the boxes of its *children*, in columns: four are tested at a time, and a child is opened only once its
//! box was hit.

mod batch;
mod join;
mod pack;
mod patch;
mod walk;

pub(super) use batch::Batch;
pub(super) use pack::{Builder, Item, Packed, Packing, cut, top_level};
pub(super) use patch::{Entry, Grown, Growth, LEAST, Repacked};

use super::slab::Sweep;
use crate::math::{Aabb, Float, vec3};
use crate::simd::{BoxProbe, Quad};

/// Children of a node, at most.
pub(super) const FAN: usize = 16;
const QUADS: usize = FAN / 4;

/// No node.
const NONE: u32 = u32::MAX;

#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(super) struct Node {
    /// Corners of the children by axis; of free slots such that nothing hits them.
    lower: [[Quad; QUADS]; 3],
    upper: [[Quad; QUADS]; 3],
    /// Nodes, or proxies in a node of level 0.
    children: [u32; FAN],
    len: u32,
    level: u32,
    /// The node above and the slot there, kept where a tree is patched; [`NONE`] for the root.
    parent: u32,
    slot: u32,
    /// Around all children, kept where a tree is patched; may be too large while `stale`.
    bounds: Aabb,
    /// A box of a child was replaced since the last refresh.
    stale: bool,
    /// Children that are picked or have something picked below them, a bit each; none but within a `find_pairs`.
    picked: u32,
}

impl Node {
    fn new(level: u32) -> Self {
        Self {
            lower: [[[Float::MAX; 4]; QUADS]; 3],
            upper: [[[-Float::MAX; 4]; QUADS]; 3],
            children: [NONE; FAN],
            len: 0,
            level,
            parent: NONE,
            slot: 0,
            bounds: Aabb::EMPTY,
            stale: false,
            picked: 0,
        }
    }

    pub fn len(&self) -> usize {
        self.len as usize
    }

    pub fn level(&self) -> u32 {
        self.level
    }

    #[inline(always)]
    pub fn aabb(&self, slot: usize) -> Aabb {
        let (q, i) = (slot / 4, slot % 4);
        let corner = |c: &[[Quad; QUADS]; 3]| vec3(c[0][q][i], c[1][q][i], c[2][q][i]);
        Aabb { lower: corner(&self.lower), upper: corner(&self.upper) }
    }

    #[inline(always)]
    fn set_aabb(&mut self, slot: usize, b: &Aabb) {
        let (q, i) = (slot / 4, slot % 4);
        for k in 0..3 {
            self.lower[k][q][i] = b.lower[k];
            self.upper[k][q][i] = b.upper[k];
        }
    }

    fn push(&mut self, child: u32, aabb: &Aabb) {
        let slot = self.len as usize;
        self.set_aabb(slot, aabb);
        self.children[slot] = child;
        self.len += 1;
    }

    /// Takes a child out; the last one comes to its slot.
    fn swap_remove(&mut self, slot: usize) {
        let last = self.len as usize - 1;
        self.set_aabb(slot, &self.aabb(last));
        self.children[slot] = self.children[last];
        self.set_aabb(last, &Aabb::EMPTY);
        self.children[last] = NONE;
        self.len -= 1;
    }

    /// The least box around the children.
    fn tight_bounds(&self) -> Aabb {
        // Not `Float::min`: there is no NaN to care for, and without that care a comparison is one instruction.
        let least = |a: Float, b: Float| if a < b { a } else { b };
        let most = |a: Float, b: Float| if a > b { a } else { b };
        let mut all = Aabb::EMPTY;
        for k in 0..3 {
            let (mut lower, mut upper) = (self.lower[k][0], self.upper[k][0]);
            for q in 1..QUADS {
                for i in 0..4 {
                    lower[i] = least(lower[i], self.lower[k][q][i]);
                    upper[i] = most(upper[i], self.upper[k][q][i]);
                }
            }
            all.lower[k] = least(least(lower[0], lower[1]), least(lower[2], lower[3]));
            all.upper[k] = most(most(upper[0], upper[1]), most(upper[2], upper[3]));
        }
        all
    }

    /// The children that overlap, a bit each.
    #[inline(always)]
    fn hits(&self, probe: &BoxProbe) -> u32 {
        let (l, u) = (&self.lower, &self.upper);
        let quads = (self.len as usize).div_ceil(4);
        (0..QUADS.min(quads)).fold(0, |bits, q| {
            bits | probe.hits([&l[0][q], &l[1][q], &l[2][q]], [&u[0][q], &u[1][q], &u[2][q]]) << (4 * q)
        })
    }

    /// The children of a quad that a sweep meets, a bit each, and where on its way.
    #[inline(always)]
    fn entries(&self, quad: usize, sweep: &Sweep, max: Float) -> (u32, Quad) {
        let (l, u) = (&self.lower, &self.upper);
        let (hits, enter) =
            sweep.entries([0, 1, 2].map(|k| &l[k][quad]), [0, 1, 2].map(|k| &u[k][quad]), max);
        let used = self.len as usize - 4 * quad;
        (if used < 4 { hits & ((1 << used) - 1) } else { hits }, enter)
    }
}

/// The numbers of the bits that are set, from the lowest.
#[inline(always)]
pub(super) fn bits(mut mask: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        (mask != 0).then(|| {
            let i = mask.trailing_zeros() as usize;
            mask &= mask - 1;
            i
        })
    })
}

/// The nodes of one tree.
#[derive(Clone, Debug, Default)]
pub(super) struct Nodes {
    nodes: Vec<Node>,
    free: Vec<u32>,
    /// `None` in an empty tree.
    root: Option<u32>,
}

impl Nodes {
    fn clear(&mut self) {
        self.nodes.clear();
        self.free.clear();
        self.root = None;
    }

    fn take(&mut self, level: u32) -> u32 {
        match self.free.pop() {
            Some(node) => {
                self.nodes[node as usize] = Node::new(level);
                node
            }
            None => {
                self.nodes.push(Node::new(level));
                self.nodes.len() as u32 - 1
            }
        }
    }

    fn node(&self, node: u32) -> &Node {
        &self.nodes[node as usize]
    }

    fn node_mut(&mut self, node: u32) -> &mut Node {
        &mut self.nodes[node as usize]
    }

    fn nodes_and_height(&self) -> (usize, usize) {
        let height = self.root.map_or(0, |root| self.node(root).level as usize + 1);
        (self.nodes.len() - self.free.len(), height)
    }

    fn byte_count(&self) -> usize {
        self.nodes.capacity() * size_of::<Node>() + self.free.capacity() * size_of::<u32>()
    }

    /// Checks that boxes hold what is below them (and no more, if `tight`), and that levels and links are right;
    /// returns the number of proxies.
    #[cfg(test)]
    fn validate(&self, linked: bool, tight: bool) -> usize {
        let Some(root) = self.root else { return 0 };
        let (mut proxies, mut seen, mut stack) = (0, 0, vec![(root, Aabb::EMPTY, NONE, 0)]);
        while let Some((at, around, parent, slot)) = stack.pop() {
            let (node, bounds) = (self.node(at), self.node(at).tight_bounds());
            seen += 1;
            assert!(node.len() > 0);
            assert!(!linked || (node.parent == parent && (at == root || node.slot as usize == slot)));
            assert!(!linked || (node.bounds.contains(&bounds) && (at == root || node.bounds == around)));
            assert!(at == root || bounds == around || (!tight && around.contains(&bounds)));
            for slot in 0..node.len() {
                match node.level {
                    0 => proxies += 1,
                    level => {
                        assert_eq!(self.node(node.children[slot]).level, level - 1);
                        stack.push((node.children[slot], node.aabb(slot), at, slot));
                    }
                }
            }
            assert!((node.len()..FAN).all(|slot| node.aabb(slot) == Aabb::EMPTY));
        }
        assert_eq!(seen, self.nodes.len() - self.free.len());
        proxies
    }
}
