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

type Tree = Grown<Repacked<Quadratic, Cuts>>;

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
    /// How many may still become lively in this step.
    room: usize,
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
        let roused = life.streak >= STREAK && self.room > 0;
        self.room -= usize::from(roused);
        roused
    }

    /// Makes some of those calm that have been idle; one in [`IDLE`] of the lively is looked at, in turn.
    fn settle(&mut self) {
        for _ in 0..self.lively.len().div_ceil(IDLE as usize) {
            // From the end, so that who fills a gap was looked at.
            self.next = self.next.min(self.lively.len());
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
        self.room = ROOM + self.lively.len() / ROOM_SHARE;
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

#[cfg(test)]
mod tests {
    use super::super::BruteForce;
    use super::super::random::Random;
    use super::*;
    use crate::math::vec3;

    impl DynamicRTree {
        /// How many are in each tree; all that is kept beside the trees is checked.
        fn census(&self) -> [usize; TREES] {
            self.trees.iter().for_each(Tree::validate);
            assert_eq!(self.lively.len(), self.trees[LIVELY].len());
            for (place, &proxy) in self.lively.iter().enumerate() {
                let life = self.lives[proxy as usize];
                assert_eq!((life.tree as usize, life.place as usize), (LIVELY, place));
            }
            self.trees.each_ref().map(Tree::len)
        }
    }

    /// A tree beside the oracle.
    struct Both {
        tree: DynamicRTree,
        oracle: BruteForce,
        boxes: Vec<Aabb>,
        random: Random,
    }

    impl Both {
        /// Every fourth stands.
        fn new(count: u32) -> Self {
            let (mut tree, mut oracle, mut random) =
                (DynamicRTree::default(), BruteForce::new(), Random::new(3));
            let side = crate::math::scalar::cbrt(8.0 * count as Float);
            let half = vec3(0.5, 0.5, 0.5);
            let boxes: Vec<_> = (0..count).map(|_| Aabb::around(random.vec() * (0.5 * side), half)).collect();
            for (i, b) in (0..).zip(&boxes) {
                let layer = if i % 4 == 0 { Layer::Static } else { Layer::Moving };
                tree.insert(i, b, layer);
                oracle.insert(i, b, layer);
            }
            Self { tree, oracle, boxes, random }
        }

        fn step(&mut self, moved: &[u32]) -> [usize; TREES] {
            for &i in moved {
                let (b, d) = (&mut self.boxes[i as usize], self.random.vec() * 0.5);
                *b = Aabb { lower: b.lower + d, upper: b.upper + d };
                self.tree.update(i, b);
                self.oracle.update(i, b);
            }
            let (mut found, mut expected) = (vec![[7, 7]], Vec::new());
            self.tree.find_pairs(moved, &mut found);
            self.oracle.find_pairs(moved, &mut expected);
            assert_eq!(found, expected);
            self.tree.census()
        }
    }

    #[test]
    fn what_moves_again_and_again_becomes_lively_and_calms_down() {
        let mut both = Both::new(1200);
        let movers: Vec<u32> = (0..1200).filter(|i| i % 4 == 1).collect();
        let everything: Vec<u32> = (0..1200).collect();
        assert_eq!(both.step(&everything), [300, 900, 0]);
        // As many as there is room for: 256 in the first step, the rest in the next.
        let counts: Vec<_> = (0..7).map(|_| both.step(&movers)[LIVELY]).collect();
        assert_eq!(counts, [0, 0, 0, 256, 300, 300, 300]);
        // Every other step is often enough, every third is not.
        let by_turns: Vec<_> = (0..36)
            .map(|k| {
                let lately: Vec<_> = (0..1200).filter(|i| i % 4 == 1 && i / 4 % 2 == k % 2).collect();
                let seldom = (0..1200).filter(|i| i % 4 == 2 && i / 4 % 3 == k % 3);
                let mut moved: Vec<_> = seldom.chain(lately).collect();
                moved.sort_unstable();
                both.step(&moved)
            })
            .collect();
        assert!(by_turns.iter().all(|counts| *counts == [300, 600, 300]), "{by_turns:?}");
        // Left alone they go back, some in each step.
        let counts: Vec<_> = (0..6 * IDLE).map(|_| both.step(&[4])[LIVELY]).collect();
        assert!(
            counts.is_sorted_by(|a, b| a >= b) && counts.windows(2).all(|w| w[0] - w[1] <= 38),
            "{counts:?}"
        );
        assert_eq!((counts[0], counts[counts.len() - 1]), (300, 0));
    }

    #[test]
    fn now_and_then_is_no_reason_to_become_lively() {
        let mut both = Both::new(2000);
        let mut random = Random::new(8);
        for _ in 0..60 {
            let moved: Vec<_> = (0..2000).filter(|_| random.below(10) == 0).collect();
            assert!(both.step(&moved)[LIVELY] < 40);
        }
    }

    #[test]
    fn the_lively_may_go_change_layer_or_all_but_stop() {
        let mut both = Both::new(800);
        let movers: Vec<u32> = (0..800).filter(|i| i % 4 == 1).collect();
        (0..6).for_each(|_| assert!(both.step(&movers)[LIVELY] <= 200));
        for &i in movers.iter().step_by(5) {
            both.tree.remove(i);
            both.oracle.remove(i);
        }
        for &i in movers.iter().skip(1).step_by(5) {
            both.tree.set_layer(i, Layer::Static);
            both.oracle.set_layer(i, Layer::Static);
        }
        let left: Vec<u32> =
            movers.iter().copied().enumerate().filter(|k| k.0 % 5 > 1).map(|k| k.1).collect();
        both.tree = both.tree.clone();
        assert_eq!(both.step(&left), [240, 400, 120]);
        // Few of each tree: asked for one by one.
        assert_eq!(both.step(&[4, 6, left[7]]), [240, 400, 120]);
        assert_eq!(both.step(&[]), [240, 400, 120]);
        // From one end of the world to the other.
        for &i in &left {
            let b = both.boxes[i as usize];
            let d = vec3(if i % 2 == 0 { 500.0 } else { -500.0 }, 0.0, 0.0);
            both.boxes[i as usize] = Aabb { lower: b.lower + d, upper: b.upper + d };
        }
        both.step(&left);
        assert_eq!(both.tree.bounds(), both.oracle.bounds());
    }
}
