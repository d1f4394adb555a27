//! Pairs of overlapping leaves, in two ways: one query for each moved leaf, or two trees (or one tree twice)
//! walked together. The second shares the upper levels between leaves; measured, it wins once a quarter moved.

use super::{LEAF, MOVED, NOTHING, Place, ROOT, Tree, overlap};

/// The walks that find pairs, with the scratch they keep. What they append is in no useful order.
#[derive(Clone, Debug, Default)]
pub(in super::super) struct PairFinder {
    /// Nodes, or places, still to be opened.
    nodes: Vec<u32>,
    /// Overlapping subtrees, one of them with a moved leaf.
    stack: Vec<[Place; 2]>,
    /// Places of moved leaves.
    leaves: Vec<Place>,
}

impl PairFinder {
    pub fn byte_count(&self) -> usize {
        (self.nodes.capacity() + self.leaves.capacity()) * size_of::<u32>()
            + self.stack.capacity() * size_of::<[Place; 2]>()
    }

    /// Appends the pairs of each leaf of `from` that is marked as moved with the leaves of `tree`. Two moved leaves
    /// see each other twice and are reported by the lower one.
    pub fn each(&mut self, from: &Tree, tree: &Tree, out: &mut Vec<[u32; 2]>) {
        let root = tree.child_at(ROOT);
        self.list_moved(from);
        for &place in &self.leaves {
            let (proxy, aabb) = (from.child_at(place) ^ LEAF, from.box_at(place));
            let mut meet = |other: u32, marks: u32| {
                if marks & MOVED == 0 || proxy < other {
                    out.push([proxy.min(other), proxy.max(other)]);
                }
            };
            if root & LEAF == 0 {
                self.nodes.push(root);
            } else if root != NOTHING && overlap(&tree.bounds(), &aabb) {
                meet(root ^ LEAF, tree.marks_at(ROOT));
            }
            while let Some(node) = self.nodes.pop() {
                let n = &tree.nodes[node as usize];
                for slot in [0, 1] {
                    if !overlap(&n.boxes[slot], &aabb) {
                        continue;
                    }
                    match n.children[slot] {
                        child if child & LEAF == 0 => self.nodes.push(child),
                        leaf => meet(leaf ^ LEAF, n.marks >> slot),
                    }
                }
            }
        }
    }

    /// Lists the moved leaves in the order of the tree, so that neighbours follow each other and find in the
    /// cache what the last one read.
    fn list_moved(&mut self, tree: &Tree) {
        self.leaves.clear();
        if tree.marks_at(ROOT) & MOVED != 0 {
            self.nodes.push(ROOT);
        }
        while let Some(place) = self.nodes.pop() {
            let child = tree.child_at(place);
            if child & LEAF != 0 {
                self.leaves.push(place);
                continue;
            }
            for below in [child << 1 | 1, child << 1] {
                if tree.marks_at(below) & MOVED != 0 {
                    self.nodes.push(below);
                }
            }
        }
    }

    /// Appends the pairs within `tree` of which one leaf at least is marked as moved, each once.
    pub fn within(&mut self, tree: &Tree, out: &mut Vec<[u32; 2]>) {
        let root = tree.child_at(ROOT);
        if tree.marks_at(ROOT) & MOVED == 0 || root & LEAF != 0 {
            return;
        }
        self.nodes.push(root);
        while let Some(node) = self.nodes.pop() {
            let n = &tree.nodes[node as usize];
            if n.boxes[0].overlaps(&n.boxes[1]) {
                self.stack.push([node << 1, node << 1 | 1]);
                self.descend(tree, tree, out);
            }
            for slot in [1, 0] {
                if n.marks >> slot & MOVED != 0 && n.children[slot] & LEAF == 0 {
                    self.nodes.push(n.children[slot]);
                }
            }
        }
    }

    /// Appends the pairs of a leaf in `a` and a leaf in `b`, one of them marked as moved.
    pub fn between(&mut self, a: &Tree, b: &Tree, out: &mut Vec<[u32; 2]>) {
        let empty = a.child_at(ROOT) == NOTHING || b.child_at(ROOT) == NOTHING;
        let moved = (a.marks_at(ROOT) | b.marks_at(ROOT)) & MOVED != 0;
        if !empty && moved && a.bounds().overlaps(&b.bounds()) {
            self.stack.push([ROOT, ROOT]);
            self.descend(a, b, out);
        }
    }

    fn descend(&mut self, a: &Tree, b: &Tree, out: &mut Vec<[u32; 2]>) {
        while let Some([p, q]) = self.stack.pop() {
            let (x, y) = (a.child_at(p), b.child_at(q));
            match (x & LEAF != 0, y & LEAF != 0) {
                (true, true) => {
                    let (x, y) = (x ^ LEAF, y ^ LEAF);
                    out.push([x.min(y), x.max(y)]);
                }
                (false, true) => self.open_left(a, x, b, q),
                (true, false) => self.open_right(a, p, b, y),
                // The larger is opened: what is left then overlaps least.
                (false, false) if a.box_at(p).area() >= b.box_at(q).area() => self.open_left(a, x, b, q),
                (false, false) => self.open_right(a, p, b, y),
            }
        }
    }

    #[inline(always)]
    fn open_left(&mut self, a: &Tree, node: u32, b: &Tree, q: Place) {
        let (n, aabb, marks) = (&a.nodes[node as usize], b.box_at(q), b.marks_at(q));
        for slot in [1, 0] {
            if (n.marks >> slot | marks) & MOVED != 0 && overlap(&n.boxes[slot], &aabb) {
                self.stack.push([node << 1 | slot as u32, q]);
            }
        }
    }

    #[inline(always)]
    fn open_right(&mut self, a: &Tree, p: Place, b: &Tree, node: u32) {
        let (n, aabb, marks) = (&b.nodes[node as usize], a.box_at(p), a.marks_at(p));
        for slot in [1, 0] {
            if (n.marks >> slot | marks) & MOVED != 0 && overlap(&n.boxes[slot], &aabb) {
                self.stack.push([p, node << 1 | slot as u32]);
            }
        }
    }
}

impl Tree {
    /// Marks a leaf, and everything above it, as moved.
    pub fn mark_moved(&mut self, proxy: u32) {
        let mut place = self.places[proxy as usize];
        while place != NOTHING && self.marks_at(place) & MOVED == 0 {
            self.mark(place, MOVED);
            place = self.nodes[place as usize >> 1].parent;
        }
    }

    /// Takes back [`Tree::mark_moved`].
    pub fn unmark_moved(&mut self, proxy: u32) {
        let mut place = self.places[proxy as usize];
        while place != NOTHING && self.marks_at(place) & MOVED != 0 {
            self.unmark(place, MOVED);
            place = self.nodes[place as usize >> 1].parent;
        }
    }
}
