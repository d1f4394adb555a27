use super::bvh::{PairFinder, Tree};
use super::slab::Sweep;
use super::structure::sort_pairs;
use super::{BroadPhase, BroadPhaseStats, Layer};
use crate::math::{Aabb, Float, Vec3};

/// Two trees of boxes, one for what stands and one for what moves: a landscape of a million static boxes costs a
/// step only what the moving boxes see of it.
///
/// A proxy that moves grows the boxes above it; `find_pairs` makes the grown part tight before it walks, and
/// arranges a tree anew when it has worn out (see `Tree::refresh`).
#[derive(Clone, Debug)]
pub struct DynamicBvh {
    /// By [`Layer`].
    trees: [Tree; 2],
    finder: PairFinder,
}

impl Default for DynamicBvh {
    fn default() -> Self {
        Self::new()
    }
}

impl DynamicBvh {
    /// An empty broad phase.
    #[must_use]
    pub fn new() -> Self {
        Self { trees: [Tree::new(), Tree::new()], finder: PairFinder::default() }
    }

    fn tree_of(&mut self, proxy: u32) -> &mut Tree {
        let layer = self.trees.iter().position(|tree| tree.contains(proxy)).expect("the proxy was inserted");
        &mut self.trees[layer]
    }

    #[cfg(test)]
    pub(super) fn is_static(&self, proxy: u32) -> bool {
        self.trees[Layer::Static as usize].contains(proxy)
    }

    #[cfg(test)]
    pub(super) fn validate(&self) {
        self.trees.iter().for_each(Tree::validate);
    }
}

impl BroadPhase for DynamicBvh {
    fn insert(&mut self, proxy: u32, aabb: &Aabb, layer: Layer) {
        self.trees[layer as usize].insert(proxy, aabb);
    }

    fn remove(&mut self, proxy: u32) {
        self.tree_of(proxy).remove(proxy);
    }

    fn update(&mut self, proxy: u32, aabb: &Aabb) {
        self.tree_of(proxy).update(proxy, aabb);
    }

    fn set_layer(&mut self, proxy: u32, layer: Layer) {
        let tree = self.tree_of(proxy);
        let aabb = tree.aabb(proxy);
        tree.remove(proxy);
        self.trees[layer as usize].insert(proxy, &aabb);
    }

    fn find_pairs(&mut self, moved: &[u32], out: &mut Vec<[u32; 2]>) {
        out.clear();
        self.trees.iter_mut().for_each(Tree::refresh);
        moved.iter().for_each(|&proxy| self.tree_of(proxy).mark_moved(proxy));
        let [still, moving] = &self.trees;
        if moved.len() * 4 > moving.len() {
            self.finder.within(moving, out);
            self.finder.between(moving, still, out);
        } else {
            self.finder.each(moving, moving, out);
            self.finder.each(moving, still, out);
            self.finder.each(still, moving, out);
        }
        moved.iter().for_each(|&proxy| self.tree_of(proxy).unmark_moved(proxy));
        sort_pairs(out);
    }

    fn query(&self, aabb: &Aabb, visit: &mut dyn FnMut(u32) -> bool) {
        let _ = self.trees.iter().all(|tree| tree.query(aabb, visit));
    }

    fn cast(
        &self,
        box_half: Vec3,
        origin: Vec3,
        translation: Vec3,
        max_fraction: Float,
        visit: &mut dyn FnMut(u32, Float) -> Float,
    ) {
        let sweep = Sweep::new(box_half, origin, translation, max_fraction);
        let left = self.trees[0].cast(&sweep, max_fraction, visit);
        if left > 0.0 {
            self.trees[1].cast(&sweep, left, visit);
        }
    }

    fn rebuild_static(&mut self) {
        self.trees[Layer::Static as usize].rebuild();
    }

    fn bounds(&self) -> Aabb {
        self.trees[0].bounds().union(&self.trees[1].bounds())
    }

    fn stats(&self) -> BroadPhaseStats {
        BroadPhaseStats {
            proxies: self.trees.iter().map(Tree::len).sum(),
            nodes: self.trees.iter().map(Tree::node_count).sum(),
            height: self.trees.iter().map(Tree::height).max().unwrap_or(0),
        }
    }

    fn byte_count(&self) -> usize {
        self.trees.iter().map(Tree::byte_count).sum::<usize>() + self.finder.byte_count()
    }

    fn clone_box(&self) -> Box<dyn BroadPhase> {
        Box::new(self.clone())
    }
}
