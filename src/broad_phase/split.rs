use super::slab::Sweep;
use super::structure::{Marks, Structure, ordered, sort_pairs};
use super::{BroadPhase, BroadPhaseStats, Layer};
use crate::math::{Aabb, Float, Vec3};

/// A broad phase of two structures, one for what stands and one for what moves: two standing boxes are never
/// compared, and where nothing that stands changed, its structure is not touched. The *split* rows of the seed's
/// table of timings.
#[derive(Clone, Debug, Default)]
pub(super) struct Split<S> {
    /// By [`Layer`].
    sets: [S; 2],
    marks: Marks,
    /// Scratch: who moved, after where they stand.
    order: Vec<[u32; 2]>,
}

impl<S: Structure> Split<S> {
    fn set_of(&mut self, proxy: u32) -> &mut S {
        let layer = self.sets.iter().position(|set| set.contains(proxy)).expect("the proxy was inserted");
        &mut self.sets[layer]
    }
}

impl<S: Structure> BroadPhase for Split<S> {
    fn insert(&mut self, proxy: u32, aabb: &Aabb, layer: Layer) {
        self.sets[layer as usize].insert(proxy, aabb);
        self.marks.set_layer(proxy, layer);
    }

    fn remove(&mut self, proxy: u32) {
        self.set_of(proxy).remove(proxy);
    }

    fn update(&mut self, proxy: u32, aabb: &Aabb) {
        self.set_of(proxy).update(proxy, aabb);
    }

    fn set_layer(&mut self, proxy: u32, layer: Layer) {
        let set = self.set_of(proxy);
        let aabb = set.aabb(proxy);
        set.remove(proxy);
        self.insert(proxy, &aabb, layer);
    }

    fn find_pairs(&mut self, moved: &[u32], out: &mut Vec<[u32; 2]>) {
        out.clear();
        let Self { sets: [still, moving], marks, order } = self;
        still.refresh();
        moving.refresh();
        marks.mark(moved);
        if moved.len() * S::JOIN_SHARE > moving.len() {
            let mut meet = |a, b| {
                if marks.accept(a, b) {
                    out.push(ordered(a, b));
                }
            };
            moving.within(&mut meet);
            moving.between(still, &mut meet);
        } else {
            order.clear();
            order.extend(moved.iter().map(|&proxy| {
                let set = if moving.contains(proxy) { &*moving } else { &*still };
                [set.place_of(proxy), proxy]
            }));
            order.sort_unstable();
            for &[_, proxy] in &*order {
                let mut meet = |met| {
                    if marks.accept_met(proxy, met) && met != proxy {
                        out.push(ordered(proxy, met));
                    }
                    true
                };
                if moving.contains(proxy) {
                    let aabb = moving.aabb(proxy);
                    moving.query(&aabb, &mut meet);
                    still.query(&aabb, &mut meet);
                } else {
                    moving.query(&still.aabb(proxy), &mut meet);
                }
            }
        }
        marks.unmark(moved);
        sort_pairs(out);
    }

    fn query(&self, aabb: &Aabb, visit: &mut dyn FnMut(u32) -> bool) {
        let _ = self.sets.iter().all(|set| set.query(aabb, &mut |proxy| visit(proxy)));
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
        let left = self.sets[0].cast(&sweep, max_fraction, visit);
        if left > 0.0 {
            self.sets[1].cast(&sweep, left, visit);
        }
    }

    fn rebuild_static(&mut self) {
        self.sets[Layer::Static as usize].rebuild();
    }

    fn bounds(&self) -> Aabb {
        self.sets[0].bounds().union(&self.sets[1].bounds())
    }

    fn stats(&self) -> BroadPhaseStats {
        let [(n0, h0), (n1, h1)] = self.sets.each_ref().map(|set| set.nodes_and_height());
        let proxies = self.sets.iter().map(Structure::len).sum();
        BroadPhaseStats { proxies, nodes: n0 + n1, height: h0.max(h1) }
    }

    fn byte_count(&self) -> usize {
        self.sets.iter().map(Structure::byte_count).sum::<usize>()
            + self.marks.byte_count()
            + self.order.capacity() * size_of::<[u32; 2]>()
    }

    fn clone_box(&self) -> Box<dyn BroadPhase> {
        Box::new(self.clone())
    }
}
