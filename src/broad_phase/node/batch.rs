//! Some boxes of a tree, picked out: a small tree of their own that asks others all its questions at once.

use super::{FAN, NONE, Node, Nodes, bits};
use crate::simd::BoxProbe;

/// The boxes that were picked, packed in the order of the tree they come from.
#[derive(Clone, Debug, Default)]
pub(in super::super) struct Batch {
    nodes: Nodes,
    len: usize,
}

impl Batch {
    #[cfg(test)]
    fn len(&self) -> usize {
        self.len
    }

    pub fn clear(&mut self) {
        self.nodes.clear();
        self.len = 0;
    }

    /// The node to be filled next.
    fn open(&mut self, level: u32) -> &mut Node {
        if self.nodes.nodes.last().is_none_or(|node| node.level != level || node.len() == FAN) {
            self.nodes.nodes.push(Node::new(level));
        }
        self.nodes.nodes.last_mut().expect("it was pushed")
    }

    /// Puts the nodes above those of level 0, in which all boxes are.
    fn close(&mut self) {
        let mut level = 0..self.nodes.nodes.len();
        while level.len() > 1 {
            let above = level.end;
            let height = self.nodes.nodes[level.start].level + 1;
            for child in level {
                let bounds = self.nodes.nodes[child].tight_bounds();
                self.open(height).push(child as u32, &bounds);
            }
            level = above..self.nodes.nodes.len();
        }
        self.nodes.root = (!level.is_empty()).then_some(level.start as u32);
    }

    /// Calls `meet` with every overlapping pair of a picked proxy and one of a tree, in one walk of both or, if there
    /// are few, with a query for each.
    pub(super) fn meet(&self, tree: &Nodes, share: usize, size: usize, meet: &mut impl FnMut(u32, u32)) {
        let Some(root) = tree.root else { return };
        if self.len * share > size {
            self.nodes.between(tree, meet);
            return;
        }
        for leaf in self.nodes.nodes.iter().take_while(|node| node.level == 0) {
            for slot in 0..leaf.len() {
                tree.query_below(root, &BoxProbe::new(&leaf.aabb(slot)), &mut |met| {
                    meet(leaf.children[slot], met);
                    true
                });
            }
        }
    }

    pub fn byte_count(&self) -> usize {
        self.nodes.byte_count()
    }
}

impl Nodes {
    /// Picks a child of a node of level 0.
    pub(super) fn pick(&mut self, mut at: u32, mut slot: u32) {
        while at != NONE {
            let node = self.node_mut(at);
            let before = node.picked;
            node.picked |= 1 << slot;
            if before != 0 {
                return;
            }
            (at, slot) = (node.parent, node.slot);
        }
    }

    /// Moves what is picked to a batch, which is empty.
    pub(super) fn hand_over(&mut self, batch: &mut Batch) {
        if let Some(root) = self.root {
            self.hand_over_below(root, batch);
        }
        batch.close();
    }

    fn hand_over_below(&mut self, at: u32, batch: &mut Batch) {
        let node = self.node_mut(at);
        let picked = std::mem::take(&mut node.picked);
        if node.level == 0 {
            let node = self.node(at);
            for slot in bits(picked) {
                batch.open(0).push(node.children[slot], &node.aabb(slot));
            }
            batch.len += picked.count_ones() as usize;
            return;
        }
        let children = node.children;
        bits(picked).for_each(|slot| self.hand_over_below(children[slot], batch));
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::omt::Cuts;
    use super::super::super::random::Random;
    use super::super::super::rtree::Quadratic;
    use super::super::super::structure::Structure;
    use super::super::{Grown, Repacked};
    use super::*;
    use crate::math::{Aabb, Vec3, vec3};

    #[test]
    fn a_batch_asks_what_its_boxes_would_ask() {
        let (mut tree, mut random) = (Grown::<Repacked<Quadratic, Cuts>>::default(), Random::new(4));
        let boxes: Vec<_> =
            (0..3000).map(|_| Aabb::around(random.vec() * 14.0, vec3(0.5, 0.5, 0.5))).collect();
        (0..).zip(&boxes).for_each(|(i, b)| tree.insert(i, b));
        let mut batch = Batch::default();
        tree.hand_over(&mut batch);
        assert_eq!((batch.len(), batch.nodes.root), (0, None));
        tree.meet(&batch, &mut |_, _| panic!("nobody asks"));
        // One by one, together, all.
        for count in [1, 16, 17, 40, 300, 3000] {
            let picked: Vec<u32> = (0..count).map(|k| k * (3000 / count)).collect();
            picked.iter().for_each(|&i| tree.pick(i));
            tree.hand_over(&mut batch);
            assert_eq!(batch.nodes.validate(false, true), count as usize);
            let (mut found, mut expected) = (Vec::new(), Vec::new());
            tree.meet(&batch, &mut |a, b| found.push([a, b]));
            for &i in &picked {
                tree.query(&boxes[i as usize], &mut |met| {
                    expected.push([i, met]);
                    true
                });
            }
            found.sort_unstable();
            expected.sort_unstable();
            assert!(found.len() >= count as usize && found == expected);
            // What was handed over is picked no more.
            tree.hand_over(&mut batch);
            assert_eq!(batch.len(), 0);
        }
        // Another tree, far away but for one.
        let mut other = Grown::default();
        other.insert(9, &Aabb::around(boxes[5].lower, Vec3::zeros()));
        other.insert(8, &Aabb::around(vec3(99.0, 0.0, 0.0), Vec3::zeros()));
        tree.pick(5);
        tree.hand_over(&mut batch);
        let mut found = Vec::new();
        (other as Grown<Repacked<Quadratic, Cuts>>).meet(&batch, &mut |a, b| found.push([a, b]));
        assert_eq!(found, [[5, 9]]);
    }
}
