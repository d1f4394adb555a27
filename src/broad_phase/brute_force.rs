use super::slab::Sweep;
use super::{BroadPhase, BroadPhaseStats, Layer, is_candidate};
use crate::math::{Aabb, Float, Vec3};

/// Every moved box against every other: the oracle, and quick enough for a few dozen boxes.
#[derive(Clone, Debug, Default)]
pub struct BruteForce {
    /// By proxy; `None` where the number is not in use.
    entries: Vec<Option<Entry>>,
    len: usize,
}

#[derive(Clone, Copy, Debug)]
struct Entry {
    aabb: Aabb,
    layer: Layer,
    /// Written and cleared by `find_pairs`.
    moved: bool,
}

impl BruteForce {
    /// An empty broad phase.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    fn entries(&self) -> impl Iterator<Item = (u32, &Entry)> {
        self.entries.iter().enumerate().filter_map(|(i, e)| e.as_ref().map(|e| (i as u32, e)))
    }

    fn entry(&mut self, proxy: u32) -> &mut Entry {
        self.entries[proxy as usize].as_mut().expect("the proxy was inserted")
    }
}

impl BroadPhase for BruteForce {
    fn insert(&mut self, proxy: u32, aabb: &Aabb, layer: Layer) {
        let at = proxy as usize;
        if at >= self.entries.len() {
            self.entries.resize(at + 1, None);
        }
        debug_assert!(self.entries[at].is_none(), "proxy {proxy} is in use");
        self.entries[at] = Some(Entry { aabb: *aabb, layer, moved: false });
        self.len += 1;
    }

    fn remove(&mut self, proxy: u32) {
        self.entries[proxy as usize].take().expect("the proxy was inserted");
        self.len -= 1;
    }

    fn update(&mut self, proxy: u32, aabb: &Aabb) {
        self.entry(proxy).aabb = *aabb;
    }

    fn set_layer(&mut self, proxy: u32, layer: Layer) {
        self.entry(proxy).layer = layer;
    }

    fn find_pairs(&mut self, moved: &[u32], out: &mut Vec<[u32; 2]>) {
        out.clear();
        for &proxy in moved {
            self.entry(proxy).moved = true;
        }
        for (b, second) in self.entries() {
            for (a, first) in self.entries().take_while(|&(a, _)| a < b) {
                if (first.moved || second.moved)
                    && is_candidate(first.layer, second.layer)
                    && first.aabb.overlaps(&second.aabb)
                {
                    out.push([a, b]);
                }
            }
        }
        out.sort_unstable();
        for &proxy in moved {
            self.entry(proxy).moved = false;
        }
    }

    fn query(&self, aabb: &Aabb, visit: &mut dyn FnMut(u32) -> bool) {
        for (proxy, entry) in self.entries() {
            if entry.aabb.overlaps(aabb) && !visit(proxy) {
                return;
            }
        }
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
        let mut max = max_fraction;
        for (proxy, entry) in self.entries() {
            if sweep.entry(&entry.aabb, max).is_some() {
                max = max.min(visit(proxy, max));
                if max <= 0.0 {
                    return;
                }
            }
        }
    }

    fn rebuild_static(&mut self) {}

    fn bounds(&self) -> Aabb {
        self.entries().fold(Aabb::EMPTY, |all, (_, e)| all.union(&e.aabb))
    }

    fn stats(&self) -> BroadPhaseStats {
        BroadPhaseStats { proxies: self.len, nodes: 0, height: 0 }
    }

    fn byte_count(&self) -> usize {
        self.entries.capacity() * size_of::<Option<Entry>>()
    }

    fn clone_box(&self) -> Box<dyn BroadPhase> {
        Box::new(self.clone())
    }
}
