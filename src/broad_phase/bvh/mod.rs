//! A binary tree of boxes over proxies, patched in place as they move.
//!
//! A node holds the boxes of its two *children*, so one cache line answers both tests and leaves need no node of
//! their own: n proxies take n − 1 nodes of 64 bytes (f32). A child is named by its [`Place`], the slot of the
//! node above it that holds its box. Node 0 is the *anchor*: its first slot holds the whole tree, its second is
//! never used, so that every child, the root too, has a place.

mod build;
mod pairs;
mod walk;

pub(super) use pairs::PairFinder;

use crate::math::{Aabb, Float};
use build::{Builder, INSERTION_WEAR};

/// A slot of a node: twice the node's number, plus 0 or 1.
type Place = u32;

/// What a slot holds: the number of a node, or a proxy with [`LEAF`] set, or [`NOTHING`].
type Child = u32;

const LEAF: u32 = 1 << 31;
const NOTHING: u32 = u32::MAX;

/// The place of the root.
const ROOT: Place = 0;

/// Marks of a slot, set on every slot above a marked one, too.
/// The box of a leaf below was replaced since the last `refresh`.
const STALE: u32 = 1;
/// A leaf below is among the moved of this `find_pairs`.
const MOVED: u32 = 4;

#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
struct Node {
    boxes: [Aabb; 2],
    children: [Child; 2],
    /// The place of this node; [`NOTHING`] for the anchor.
    parent: Place,
    /// [`STALE`] and [`MOVED`], shifted left by the slot.
    marks: u32,
}

const EMPTY_NODE: Node = Node { boxes: [Aabb::EMPTY; 2], children: [NOTHING; 2], parent: NOTHING, marks: 0 };

/// See the [module](self).
#[derive(Clone, Debug)]
pub(super) struct Tree {
    nodes: Vec<Node>,
    /// Nodes not in use, the last one first.
    free: Vec<u32>,
    /// By proxy: its place, or [`NOTHING`].
    places: Vec<Place>,
    len: usize,
    /// Updates and insertions since the last `rebuild`.
    wear: usize,
    builder: Builder,
}

impl Tree {
    pub fn new() -> Self {
        Self {
            nodes: vec![EMPTY_NODE],
            free: Vec::new(),
            places: Vec::new(),
            len: 0,
            wear: 0,
            builder: Builder::default(),
        }
    }

    /// The number of proxies.
    pub fn len(&self) -> usize {
        self.len
    }

    pub fn contains(&self, proxy: u32) -> bool {
        self.places.get(proxy as usize).is_some_and(|&place| place != NOTHING)
    }

    /// The box of a proxy in the tree.
    pub fn aabb(&self, proxy: u32) -> Aabb {
        self.box_at(self.places[proxy as usize])
    }

    pub fn bounds(&self) -> Aabb {
        self.box_at(ROOT)
    }

    /// The nodes in use, the anchor apart.
    pub fn node_count(&self) -> usize {
        self.nodes.len() - 1 - self.free.len()
    }

    pub fn byte_count(&self) -> usize {
        self.nodes.capacity() * size_of::<Node>()
            + (self.free.capacity() + self.places.capacity()) * size_of::<u32>()
            + self.builder.byte_count()
    }

    pub fn insert(&mut self, proxy: u32, aabb: &Aabb) {
        debug_assert!(aabb.is_valid() && proxy < LEAF - 1 && !self.contains(proxy));
        let at = proxy as usize;
        if at >= self.places.len() {
            self.places.resize(at + 1, NOTHING);
        }
        self.len += 1;
        self.wear += INSERTION_WEAR;
        if self.child_at(ROOT) == NOTHING {
            self.attach(ROOT, proxy | LEAF, *aabb, 0);
            return;
        }
        let place = self.best_sibling(proxy, aabb);
        let (sibling, sibling_box, marks) = (self.child_at(place), self.box_at(place), self.marks_at(place));
        let node = self.take_node();
        self.attach(node << 1, sibling, sibling_box, marks);
        self.attach(node << 1 | 1, proxy | LEAF, *aabb, 0);
        self.attach(place, node, sibling_box.union(aabb), marks);
        let mut above = place >> 1;
        while above != 0 {
            self.rotate(above);
            above = self.refit(above) >> 1;
        }
    }

    pub fn remove(&mut self, proxy: u32) {
        let place = std::mem::replace(&mut self.places[proxy as usize], NOTHING);
        debug_assert_ne!(place, NOTHING, "proxy {proxy} is not in the tree");
        self.len -= 1;
        let node = place >> 1;
        if node == 0 {
            self.nodes[0] = EMPTY_NODE;
            return;
        }
        let sibling = place ^ 1;
        let up = self.nodes[node as usize].parent;
        self.attach(up, self.child_at(sibling), self.box_at(sibling), self.marks_at(sibling));
        self.free.push(node);
        let mut above = up >> 1;
        while above != 0 {
            let (place, before) =
                (self.nodes[above as usize].parent, self.box_at(self.nodes[above as usize].parent));
            self.refit(above);
            if self.box_at(place) == before {
                return;
            }
            above = place >> 1;
        }
    }

    /// Replaces the box of a proxy and grows the boxes above it; the next [`Tree::refresh`] makes them tight.
    pub fn update(&mut self, proxy: u32, aabb: &Aabb) {
        debug_assert!(aabb.is_valid());
        let mut place = self.places[proxy as usize];
        self.set_box(place, aabb);
        self.mark(place, STALE);
        while place > 1 {
            place = self.nodes[place as usize >> 1].parent;
            let (node, slot) = (place as usize >> 1, place as usize & 1);
            let node = &mut self.nodes[node];
            if node.marks >> slot & STALE != 0 && node.boxes[slot].contains(aabb) {
                return;
            }
            node.marks |= STALE << slot;
            node.boxes[slot] = node.boxes[slot].union(aabb);
        }
    }

    /// The place at which a leaf with this box adds least area to the tree: down from the root, each time into
    /// the child that can still be cheapest, until neither can beat the best place seen \[Catto GDC19\].
    fn best_sibling(&self, proxy: u32, aabb: &Aabb) -> Place {
        let leaf_area = aabb.area();
        let (mut place, mut depth) = (ROOT, 0);
        let direct = self.bounds().union(aabb).area();
        let (mut best, mut best_cost) = (ROOT, direct);
        // What the ancestors grow by when the leaf comes below `place`.
        let mut inherited = direct - self.bounds().area();
        loop {
            let child = self.child_at(place);
            if child & LEAF != 0 {
                return best;
            }
            let node = &self.nodes[child as usize];
            let areas = node.boxes.map(|b| b.area());
            let costs = node.boxes.map(|b| b.union(aabb).area() + inherited);
            // The least cost of a place below: a leaf smaller than its sibling may save the difference.
            let bound = |slot: usize| match node.children[slot] & LEAF {
                0 => costs[slot] + (leaf_area - areas[slot]).min(0.0),
                _ => costs[slot],
            };
            let bounds = [bound(0), bound(1)];
            // Identical boxes tie everywhere: the proxy's bits then deal them out evenly.
            let slot = if bounds[0] != bounds[1] {
                usize::from(bounds[1] < bounds[0])
            } else {
                let distance = |slot: usize| (node.boxes[slot].center() - aabb.center()).amax();
                let (d0, d1) = (distance(0), distance(1));
                if d0 != d1 { usize::from(d1 < d0) } else { (proxy >> (depth & 31) & 1) as usize }
            };
            if costs[slot ^ 1] < best_cost {
                (best, best_cost) = (child << 1 | (slot as u32 ^ 1), costs[slot ^ 1]);
            }
            if bounds[slot] > best_cost {
                return best;
            }
            // Among equals the deeper place wins: identical boxes must not line up in a list.
            if costs[slot] <= best_cost {
                (best, best_cost) = (child << 1 | slot as u32, costs[slot]);
            }
            inherited = costs[slot] - areas[slot];
            place = child << 1 | slot as u32;
            depth += 1;
        }
    }

    /// Swaps a child of this node with a grandchild on the other side where that saves most area
    /// \[Kopta 2012\]. The box of the node itself stays.
    fn rotate(&mut self, node: u32) {
        let n = &self.nodes[node as usize];
        let (mut best, mut best_saving) = (None, 0.0 as Float);
        for slot in 0..2 {
            let inner = n.children[slot];
            if inner & LEAF != 0 {
                continue;
            }
            let (area, other) = (n.boxes[slot].area(), &n.boxes[slot ^ 1]);
            let boxes = &self.nodes[inner as usize].boxes;
            for (kept, kept_box) in boxes.iter().enumerate() {
                let saving = area - kept_box.union(other).area();
                if saving > best_saving {
                    (best, best_saving) = (Some((slot, inner << 1 | (kept as u32 ^ 1))), saving);
                }
            }
        }
        let Some((slot, grandchild)) = best else { return };
        let other = node << 1 | (slot as u32 ^ 1);
        let (a, a_box, a_marks) = (self.child_at(other), self.box_at(other), self.marks_at(other));
        let (b, b_box, b_marks) =
            (self.child_at(grandchild), self.box_at(grandchild), self.marks_at(grandchild));
        self.attach(other, b, b_box, b_marks);
        self.attach(grandchild, a, a_box, a_marks);
        self.refit(grandchild >> 1);
    }

    /// Makes tight the box and the marks of a node from its children's; returns the node's place.
    fn refit(&mut self, node: u32) -> Place {
        let n = &self.nodes[node as usize];
        let (place, child, union) = (n.parent, node, n.boxes[0].union(&n.boxes[1]));
        let marks = (n.marks | n.marks >> 1) & (STALE | MOVED);
        self.attach(place, child, union, marks);
        place
    }

    fn take_node(&mut self) -> u32 {
        self.free.pop().unwrap_or_else(|| {
            self.nodes.push(EMPTY_NODE);
            self.nodes.len() as u32 - 1
        })
    }

    /// Puts a child into a slot, with its box and its marks (of slot 0).
    fn attach(&mut self, place: Place, child: Child, aabb: Aabb, marks: u32) {
        let (node, slot) = (&mut self.nodes[place as usize >> 1], place as usize & 1);
        node.boxes[slot] = aabb;
        node.children[slot] = child;
        node.marks = node.marks & !((STALE | MOVED) << slot) | marks << slot;
        if child & LEAF != 0 {
            self.places[(child ^ LEAF) as usize] = place;
        } else {
            self.nodes[child as usize].parent = place;
        }
    }

    fn child_at(&self, place: Place) -> Child {
        self.nodes[place as usize >> 1].children[place as usize & 1]
    }

    fn box_at(&self, place: Place) -> Aabb {
        self.nodes[place as usize >> 1].boxes[place as usize & 1]
    }

    fn set_box(&mut self, place: Place, aabb: &Aabb) {
        self.nodes[place as usize >> 1].boxes[place as usize & 1] = *aabb;
    }

    fn marks_at(&self, place: Place) -> u32 {
        self.nodes[place as usize >> 1].marks >> (place & 1) & (STALE | MOVED)
    }

    fn mark(&mut self, place: Place, mark: u32) {
        self.nodes[place as usize >> 1].marks |= mark << (place & 1);
    }

    fn unmark(&mut self, place: Place, mark: u32) {
        self.nodes[place as usize >> 1].marks &= !(mark << (place & 1));
    }

    /// Checks every link, box and mark.
    #[cfg(test)]
    pub fn validate(&self) {
        if self.len == 0 {
            assert_eq!((self.child_at(ROOT), self.node_count()), (NOTHING, 0));
            return;
        }
        let (mut leaves, mut nodes, mut stack) = (0, 0, vec![ROOT]);
        while let Some(place) = stack.pop() {
            let (child, aabb) = (self.child_at(place), self.box_at(place));
            assert_eq!(self.marks_at(place) & MOVED, 0);
            if child & LEAF != 0 {
                leaves += 1;
                assert_eq!(self.places[(child ^ LEAF) as usize], place);
                continue;
            }
            nodes += 1;
            assert_eq!(self.nodes[child as usize].parent, place);
            let mut union = Aabb::EMPTY;
            for below in [child << 1, child << 1 | 1] {
                assert!(aabb.contains(&self.box_at(below)));
                assert!(self.marks_at(below) & STALE <= self.marks_at(place) & STALE);
                union = union.union(&self.box_at(below));
                stack.push(below);
            }
            assert!(union == aabb || self.marks_at(place) & STALE != 0);
        }
        assert_eq!((leaves, nodes), (self.len, self.node_count()));
        assert_eq!(nodes + 1, leaves);
        assert_eq!(self.places.iter().filter(|&&p| p != NOTHING).count(), self.len);
    }
}

/// Whether two closed boxes overlap, without a branch: in a tree's walk the outcome cannot be predicted.
#[inline(always)]
fn overlap(a: &Aabb, b: &Aabb) -> bool {
    (a.lower.x <= b.upper.x)
        & (b.lower.x <= a.upper.x)
        & (a.lower.y <= b.upper.y)
        & (b.lower.y <= a.upper.y)
        & (a.lower.z <= b.upper.z)
        & (b.lower.z <= a.upper.z)
}
