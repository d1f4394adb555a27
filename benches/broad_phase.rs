//! The broad phase's table: unit boxes strewn over a cube of side (8 N)^(1/3), a tenth of them moving by up to
//! half their size a step.

use divan::{Bencher, black_box};
use merev::broad_phase::{BroadPhase, BroadPhaseKind, Layer, PairSet};
use merev::{Aabb, Float, Vec3, math::scalar, math::vec3};
use std::fmt;

fn main() {
    divan::main();
}

/// A dynamic tree, and how many boxes are in it.
#[derive(Clone, Copy)]
struct Case(BroadPhaseKind, u32);

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{} {}", self.0.name(), self.1)
    }
}

const CASES: [Case; 6] = [
    Case(BroadPhaseKind::DynamicBvh, 1_000),
    Case(BroadPhaseKind::DynamicRTree, 1_000),
    Case(BroadPhaseKind::DynamicBvh, 10_000),
    Case(BroadPhaseKind::DynamicRTree, 10_000),
    Case(BroadPhaseKind::DynamicBvh, 100_000),
    Case(BroadPhaseKind::DynamicRTree, 100_000),
];

/// splitmix64
struct Random(u64);

impl Random {
    /// −1 … 1.
    fn signed(&mut self) -> Float {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ x >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ x >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^= x >> 31;
        (x >> 40) as Float / (1u64 << 23) as Float - 1.0
    }

    fn vec(&mut self) -> Vec3 {
        vec3(self.signed(), self.signed(), self.signed())
    }
}

struct Scene {
    boxes: Vec<Aabb>,
    tree: Box<dyn BroadPhase>,
    /// Every tenth proxy.
    moved: Vec<u32>,
    pairs: Vec<[u32; 2]>,
    random: Random,
}

impl Scene {
    fn new(Case(kind, count): Case, rest: Layer) -> Self {
        let mut random = Random(1);
        let side = scalar::cbrt(8.0 * count as Float);
        let half = vec3(0.5, 0.5, 0.5);
        let boxes: Vec<_> = (0..count).map(|_| Aabb::around(random.vec() * (0.5 * side), half)).collect();
        let mut tree = kind.build();
        for (i, b) in (0u32..).zip(&boxes) {
            tree.insert(i, b, if i % 10 == 0 { Layer::Moving } else { rest });
        }
        let mut scene =
            Self { boxes, tree, moved: (0..count).step_by(10).collect(), pairs: Vec::new(), random };
        // Long enough for the tree to age.
        (0..100).for_each(|_| scene.step());
        scene
    }

    fn shift(&mut self) {
        for &i in &self.moved {
            let b = &mut self.boxes[i as usize];
            let d = self.random.vec() * 0.5;
            *b = Aabb { lower: b.lower + d, upper: b.upper + d };
            self.tree.update(i, b);
        }
    }

    fn step(&mut self) {
        self.shift();
        self.tree.find_pairs(&self.moved, &mut self.pairs);
    }
}

/// Updates and pairs, everything in the moving tree.
#[divan::bench(args = CASES, max_time = 3)]
fn step_all_moving(bencher: Bencher, case: Case) {
    let mut scene = Scene::new(case, Layer::Moving);
    bencher.bench_local(|| scene.step());
}

/// Updates and pairs, nine tenths in the static tree.
#[divan::bench(args = CASES, max_time = 3)]
fn step_rest_static(bencher: Bencher, case: Case) {
    let mut scene = Scene::new(case, Layer::Static);
    bencher.bench_local(|| scene.step());
}

/// Updates alone.
#[divan::bench(args = CASES, max_time = 3)]
fn update_all_moving(bencher: Bencher, case: Case) {
    let mut scene = Scene::new(case, Layer::Moving);
    bencher.bench_local(|| scene.shift());
}

/// Pairs alone, of trees that did not change.
#[divan::bench(args = CASES, max_time = 3)]
fn pairs_all_moving(bencher: Bencher, case: Case) {
    let mut scene = Scene::new(case, Layer::Moving);
    bencher.bench_local(|| scene.tree.find_pairs(&scene.moved, &mut scene.pairs));
}

/// Pairs of a single moved proxy.
#[divan::bench(args = CASES, max_time = 3)]
fn pairs_of_one(bencher: Bencher, case: Case) {
    let mut scene = Scene::new(case, Layer::Moving);
    bencher.bench_local(|| scene.tree.find_pairs(&scene.moved[7..8], &mut scene.pairs));
}

/// One box query the size of a box, by all proxies in turn.
#[divan::bench(args = CASES, max_time = 3)]
fn query(bencher: Bencher, case: Case) {
    let scene = Scene::new(case, Layer::Moving);
    let mut next = scene.boxes.iter().cycle();
    bencher.bench_local(|| {
        let mut found = 0;
        scene.tree.query(next.next().unwrap(), &mut |proxy| {
            found += proxy;
            true
        });
        found
    });
}

/// A ray through the whole cube, to the nearest box.
#[divan::bench(args = CASES, max_time = 3)]
fn ray_to_nearest(bencher: Bencher, case: Case) {
    let mut scene = Scene::new(case, Layer::Moving);
    let side = scalar::cbrt(8.0 * case.1 as Float);
    let Scene { tree, random, .. } = &mut scene;
    bencher.bench_local(|| {
        let (from, to) = (random.vec() * side, random.vec() * (0.5 * side));
        let mut last = 0;
        tree.cast(Vec3::zeros(), from, to - from, 1.0, &mut |proxy, max| {
            last = proxy;
            // A stand-in for the shape's own test.
            max * 0.9
        });
        last
    });
}

/// Arranging all boxes in the static tree anew.
#[divan::bench(args = CASES, max_time = 3)]
fn rebuild_static(bencher: Bencher, case: Case) {
    let mut scene = Scene::new(case, Layer::Static);
    bencher.bench_local(|| scene.tree.rebuild_static());
}

/// Inserting all boxes one by one.
#[divan::bench(args = CASES, max_time = 3)]
fn insert_all(bencher: Bencher, case: Case) {
    let scene = Scene::new(case, Layer::Moving);
    bencher.bench_local(|| {
        let mut tree = case.0.build();
        (0u32..).zip(&scene.boxes).for_each(|(i, b)| tree.insert(i, b, Layer::Moving));
        tree
    });
}

/// Looking up every pair of a step among a million, half of them known.
#[divan::bench]
fn pair_set_get(bencher: Bencher) {
    let mut set = PairSet::new();
    for i in 0..1_000_000u32 {
        set.insert([i / 4, i / 4 + 1 + i % 4 * 97], i);
    }
    let mut i = 0u32;
    bencher.bench_local(|| {
        i = i.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        black_box(set.get([i >> 14, (i >> 14) + 1 + i % 8 * 97]))
    });
}

/// Pairs when everything moved.
#[divan::bench(args = CASES, max_time = 3)]
fn pairs_of_all(bencher: Bencher, case: Case) {
    let mut scene = Scene::new(case, Layer::Moving);
    let all: Vec<u32> = (0..case.1).collect();
    bencher.bench_local(|| scene.tree.find_pairs(&all, &mut scene.pairs));
}
