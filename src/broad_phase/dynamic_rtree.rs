//! The default: packed trees that are patched, apart for what stands, what rests and what is on its way.
//!
//! A proxy that can move lives in the *calm* tree. One that is updated again and again goes over to the *lively* tree, and
//! comes back after it was left alone for a while. The lively tree is small and most of it moves: its boxes are replaced
//! where they are, it is packed anew every few steps, and its pairs are found by one walk of it with each tree. The calm
//! tree is then seldom touched.
//!
//! Who goes over depends only on the calls made so far, and only so many do in a step that it costs little.

use super::node::{Batch, Grown, Repacked};
use super::omt::Cuts;
use super::rtree::Quadratic;
use super::slab::Sweep;
use super::structure::{Marks, Structure, ordered, sort_pairs};
use super::{BroadPhase, BroadPhaseStats, Layer};
use crate::math::{Aabb, Float, Vec3};

pub(super) type Tree = Grown<Repacked<Quadratic, Cuts>>;

/// The trees, by number: what cannot move, what can but seldom does, what moves most of the time.
const STILL: usize = 0;
const CALM: usize = 1;
const LIVELY: usize = 2;
const TREES: usize = 3;

/// A proxy becomes lively once it was updated this many times, each time at most [`NEAR`] steps after the last.
const STREAK: u8 = 4;
const NEAR: u32 = 2;

/// A proxy is calm again after this many steps without an update.
const IDLE: u32 = 8;

/// How many may become lively in a step: so many, and one for so many that are.
const ROOM: usize = 256;
const ROOM_SHARE: usize = 4;

/// What is known of a proxy in use.
#[derive(Clone, Copy, Debug, Default)]
struct Life {
    /// The step of the last update.
    last: u32,
    /// Its place among the lively.
    place: u32,
    /// Updates that came soon after each other.
    streak: u8,
    tree: u8,
}

#[derive(Clone, Debug, Default)]
pub(super) struct DynamicRTree {
    trees: [Tree; TREES],
    marks: Marks,
    /// By proxy.
    lives: Vec<Life>,
    /// Who is in the lively tree, in the order in which they are looked through for idlers, and where that stands.
    lively: Vec<u32>,
    next: usize,
    /// Counts calls of `find_pairs`; may wrap, which can only make a proxy calm too late or lively too soon.
    step: u32,
    /// How many became lively in this step.
    roused: usize,
    /// Scratch: who moved, in one tree.
    batch: Batch,
}

impl DynamicRTree {
    fn life(&mut self, proxy: u32) -> &mut Life {
        &mut self.lives[proxy as usize]
    }

    /// Puts a proxy that is nowhere into a tree.
    fn put(&mut self, proxy: u32, aabb: &Aabb, tree: usize) {
        let place = self.lively.len() as u32;
        if tree == LIVELY {
            self.lively.push(proxy);
        }
        *self.life(proxy) = Life { last: self.step, place, streak: 0, tree: tree as u8 };
        self.trees[tree].insert(proxy, aabb);
    }

    /// Takes a proxy out of its tree.
    fn take(&mut self, proxy: u32) {
        let Life { tree, place, .. } = *self.life(proxy);
        self.trees[tree as usize].remove(proxy);
        if tree as usize == LIVELY {
            self.lively.swap_remove(place as usize);
            if let Some(&last) = self.lively.get(place as usize) {
                self.life(last).place = place;
            }
        }
    }

    /// Whether an update makes this calm proxy lively.
    fn rouse(&mut self, proxy: u32) -> bool {
        let step = self.step;
        let life = self.life(proxy);
        let gap = step.wrapping_sub(std::mem::replace(&mut life.last, step));
        if gap > 0 {
            life.streak = if gap <= NEAR { life.streak.saturating_add(1) } else { 0 };
        }
        let roused = life.streak >= STREAK && self.roused < ROOM + self.lively.len() / ROOM_SHARE;
        self.roused += usize::from(roused);
        roused
    }

    /// Makes some of those calm that have been idle; each of the lively comes up once in [`IDLE`] steps.
    fn settle(&mut self) {
        for _ in 0..self.lively.len().div_ceil(IDLE as usize) {
            // From the end, so that who fills a gap was looked at.
            if self.next == 0 {
                self.next = self.lively.len();
            }
            self.next -= 1;
            let proxy = self.lively[self.next];
            if self.step.wrapping_sub(self.life(proxy).last) > IDLE {
                let aabb = self.trees[LIVELY].aabb(proxy);
                self.take(proxy);
                self.put(proxy, &aabb, CALM);
            }
            self.next = self.next.min(self.lively.len());
        }
    }

    /// For which two trees all pairs are found by one walk of both: where a good part of what can meet moved. Two that
    /// stand make no pair.
    fn joins(&self, counts: &[usize; TREES]) -> [[bool; TREES]; TREES] {
        let mut joins = [[false; TREES]; TREES];
        for a in 0..TREES {
            for b in 0..TREES {
                let moved = if a == b { counts[a] } else { counts[a] + counts[b] };
                let least = self.trees[a].len().min(self.trees[b].len());
                joins[a][b] = (a, b) != (STILL, STILL) && moved * Tree::JOIN_SHARE > least;
            }
        }
        joins
    }
}

impl BroadPhase for DynamicRTree {
    fn insert(&mut self, proxy: u32, aabb: &Aabb, layer: Layer) {
        if proxy as usize >= self.lives.len() {
            self.lives.resize(proxy as usize + 1, Life::default());
        }
        self.put(proxy, aabb, if layer == Layer::Static { STILL } else { CALM });
        self.marks.set_layer(proxy, layer);
    }

    fn remove(&mut self, proxy: u32) {
        self.take(proxy);
    }

    fn update(&mut self, proxy: u32, aabb: &Aabb) {
        let step = self.step;
        let life = self.life(proxy);
        let tree = life.tree as usize;
        if tree == LIVELY {
            life.last = step;
        } else if tree == CALM && self.rouse(proxy) {
            self.take(proxy);
            self.put(proxy, aabb, LIVELY);
            return;
        }
        self.trees[tree].update(proxy, aabb);
    }

    fn set_layer(&mut self, proxy: u32, layer: Layer) {
        let aabb = self.trees[self.life(proxy).tree as usize].aabb(proxy);
        self.take(proxy);
        self.insert(proxy, &aabb, layer);
    }

    fn find_pairs(&mut self, moved: &[u32], out: &mut Vec<[u32; 2]>) {
        out.clear();
        self.settle();
        self.step = self.step.wrapping_add(1);
        self.roused = 0;
        self.trees.iter_mut().for_each(Tree::refresh);
        let mut counts = [0; TREES];
        moved.iter().for_each(|&proxy| counts[self.lives[proxy as usize].tree as usize] += 1);
        let joins = self.joins(&counts);
        let Self { trees, marks, lives, batch, .. } = self;
        marks.mark(moved);
        for a in CALM..TREES {
            for b in (0..=a).filter(|&b| joins[a][b]) {
                let mut meet = |a, b| {
                    if marks.accept(a, b) {
                        out.push(ordered(a, b));
                    }
                };
                if a == b {
                    trees[a].within(&mut meet);
                } else {
                    let [a, b] = trees.get_disjoint_mut([a, b]).expect("two trees");
                    a.between(b, &mut meet);
                }
            }
        }
        for home in 0..TREES {
            let others = (0..TREES).filter(|&other| !joins[home][other] && (home, other) != (STILL, STILL));
            if counts[home] == 0 || others.clone().next().is_none() {
                continue;
            }
            let at_home = moved.iter().filter(|&&proxy| lives[proxy as usize].tree as usize == home);
            at_home.for_each(|&proxy| trees[home].pick(proxy));
            trees[home].hand_over(batch);
            others.for_each(|other| {
                trees[other].meet(batch, &mut |proxy, met| {
                    if marks.accept_met(proxy, met) && met != proxy {
                        out.push(ordered(proxy, met));
                    }
                });
            });
        }
        marks.unmark(moved);
        sort_pairs(out);
    }

    fn query(&self, aabb: &Aabb, visit: &mut dyn FnMut(u32) -> bool) {
        let _ = self.trees.iter().all(|tree| tree.query(aabb, &mut |proxy| visit(proxy)));
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
        let mut left = max_fraction;
        for tree in &self.trees {
            left = tree.cast(&sweep, left, visit);
            if left <= 0.0 {
                return;
            }
        }
    }

    fn rebuild_static(&mut self) {
        self.trees[STILL].rebuild();
    }

    fn bounds(&self) -> Aabb {
        self.trees.iter().fold(Aabb::EMPTY, |all, tree| all.union(&tree.bounds()))
    }

    fn stats(&self) -> BroadPhaseStats {
        self.trees.iter().fold(BroadPhaseStats::default(), |all, tree| {
            let (nodes, height) = tree.nodes_and_height();
            BroadPhaseStats {
                proxies: all.proxies + tree.len(),
                nodes: all.nodes + nodes,
                height: all.height.max(height),
            }
        })
    }

    fn byte_count(&self) -> usize {
        self.trees.iter().map(Tree::byte_count).sum::<usize>()
            + self.marks.byte_count()
            + self.lives.capacity() * size_of::<Life>()
            + self.lively.capacity() * size_of::<u32>()
            + self.batch.byte_count()
    }

    fn clone_box(&self) -> Box<dyn BroadPhase> {
        Box::new(self.clone())
    }
}
