//! Questions to one tree: what overlaps a box, what does a moving box meet.

use super::super::slab::Sweep;
use super::{Child, LEAF, NOTHING, ROOT, Tree, overlap};
use crate::math::{Aabb, Float};

impl Tree {
    /// Visits the proxies whose boxes overlap `aabb` until told to stop; returns whether it was not.
    pub fn query(&self, aabb: &Aabb, visit: &mut dyn FnMut(u32) -> bool) -> bool {
        let mut stack = Stack::new(NOTHING);
        if self.child_at(ROOT) != NOTHING && self.box_at(ROOT).overlaps(aabb) {
            stack.push(self.child_at(ROOT));
        }
        while let Some(child) = stack.pop() {
            if child & LEAF != 0 {
                if !visit(child ^ LEAF) {
                    return false;
                }
                continue;
            }
            let node = &self.nodes[child as usize];
            for slot in [1, 0] {
                if overlap(&node.boxes[slot], aabb) {
                    stack.push(node.children[slot]);
                }
            }
        }
        true
    }

    /// Visits the proxies that `sweep` meets, the nearer child of a node first, and returns the fraction that the
    /// visitor left of it.
    pub fn cast(&self, sweep: &Sweep, max: Float, visit: &mut dyn FnMut(u32, Float) -> Float) -> Float {
        let mut max = max;
        let mut stack = Stack::<(Child, Float)>::new((NOTHING, 0.0));
        if self.child_at(ROOT) != NOTHING
            && let Some(enter) = sweep.entry(&self.box_at(ROOT), max)
        {
            stack.push((self.child_at(ROOT), enter));
        }
        while let Some((child, enter)) = stack.pop() {
            if enter > max {
                continue;
            }
            if child & LEAF != 0 {
                max = max.min(visit(child ^ LEAF, max));
                if max <= 0.0 {
                    return 0.0;
                }
                continue;
            }
            let node = &self.nodes[child as usize];
            let enter = [sweep.entry(&node.boxes[0], max), sweep.entry(&node.boxes[1], max)];
            // What is pushed last comes first.
            let near = usize::from(enter[1] < enter[0] && enter[1].is_some());
            for slot in [near ^ 1, near] {
                if let Some(enter) = enter[slot] {
                    stack.push((node.children[slot], enter));
                }
            }
        }
        max
    }

    /// The nodes on the longest way from the root to a leaf.
    pub fn height(&self) -> usize {
        let mut stack = Stack::new((NOTHING, 0));
        stack.push((self.child_at(ROOT), 0));
        let mut height = 0;
        while let Some((child, depth)) = stack.pop() {
            height = height.max(depth);
            if child & LEAF == 0 {
                self.nodes[child as usize].children.iter().for_each(|&below| stack.push((below, depth + 1)));
            }
        }
        height
    }
}

/// A stack that takes memory only in trees deeper than any sound one.
struct Stack<T> {
    near: [T; 64],
    far: Vec<T>,
    len: usize,
}

impl<T: Copy> Stack<T> {
    fn new(blank: T) -> Self {
        Self { near: [blank; 64], far: Vec::new(), len: 0 }
    }

    #[inline(always)]
    fn push(&mut self, item: T) {
        match self.near.get_mut(self.len) {
            Some(slot) => *slot = item,
            None => self.far.push(item),
        }
        self.len += 1;
    }

    #[inline(always)]
    fn pop(&mut self) -> Option<T> {
        self.len = self.len.checked_sub(1)?;
        if self.len < self.near.len() { Some(self.near[self.len]) } else { self.far.pop() }
    }
}
