//! What every broad phase must answer, judged by the oracle.

use super::node::{Grown, Growth, Packed, Packing, Repacked};
use super::random::Random;
use super::structure::Structure;
use super::{BroadPhase, BroadPhaseKind, BruteForce, DynamicBvh, Layer, omt, rstar, rtree, str_packing};
use crate::math::{Aabb, Float, Vec3, vec3};

fn each_kind(test: impl Fn(&mut dyn BroadPhase)) {
    for kind in BroadPhaseKind::ALL {
        test(&mut *kind.build());
    }
}

fn all_pairs(bp: &mut dyn BroadPhase, count: u32) -> Vec<[u32; 2]> {
    let mut out = vec![[7, 7]];
    bp.find_pairs(&(0..count).collect::<Vec<_>>(), &mut out);
    assert!(out.is_sorted_by(|a, b| a < b));
    out
}

#[test]
fn kinds_have_names_and_numbers() {
    for (i, kind) in BroadPhaseKind::ALL.into_iter().enumerate() {
        assert_eq!(kind as i32, i as i32 + 1);
        assert!(!kind.name().is_empty());
    }
}

#[test]
fn empty_and_single() {
    each_kind(|bp| {
        assert!(all_pairs(bp, 0).is_empty());
        assert_eq!(bp.bounds(), Aabb::EMPTY);
        bp.rebuild_static();
        let b = Aabb::around(vec3(1.0, 2.0, 3.0), vec3(1.0, 0.0, 1.0));
        for layer in [Layer::Moving, Layer::Static] {
            bp.insert(3, &b, layer);
            bp.rebuild_static();
            assert_eq!((bp.bounds(), bp.stats().proxies), (b, 1));
            let mut out = Vec::new();
            bp.find_pairs(&[3], &mut out);
            assert!(out.is_empty());
            assert_eq!(query(bp, &b), [3]);
            bp.remove(3);
            assert!(query(bp, &b).is_empty());
        }
    });
}

#[test]
fn four_hundred_posts_under_one_plate() {
    each_kind(|bp| {
        bp.insert(0, &Aabb::around(vec3(0.0, 1.0, 0.0), vec3(50.0, 0.1, 50.0)), Layer::Moving);
        for i in 0..400u32 {
            let p = vec3((i % 20) as Float * 4.0 - 38.0, 0.5, (i / 20) as Float * 4.0 - 38.0);
            bp.insert(i + 1, &Aabb::around(p, vec3(0.5, 0.5, 0.5)), Layer::Moving);
        }
        let expected: Vec<_> = (1..=400).map(|i| [0, i]).collect();
        assert_eq!(all_pairs(bp, 401), expected);
        let mut out = Vec::new();
        bp.find_pairs(&[0], &mut out);
        assert_eq!(out, expected);
        bp.find_pairs(&[17], &mut out);
        assert_eq!(out, [[0, 17]]);
    });
}

#[test]
fn fifteen_hundred_boxes_in_one_spot() {
    each_kind(|bp| {
        for i in 0..1500 {
            bp.insert(i, &Aabb::around(vec3(1.0, 1.0, 1.0), vec3(0.5, 0.5, 0.5)), Layer::Moving);
        }
        assert!(bp.stats().height < 40, "a tree of height {}", bp.stats().height);
        let pairs = all_pairs(bp, 1500);
        assert_eq!(pairs.len(), 1_124_250);
        assert_eq!((pairs[0], pairs[1_124_249]), ([0, 1], [1498, 1499]));
    });
}

#[test]
fn ten_thousand_boxes_in_one_spot_of_which_ten_move() {
    each_kind(|bp| {
        let (count, moving) = (10_000, [0, 1, 77, 500, 501, 2345, 5000, 8191, 9998, 9999]);
        for i in 0..count {
            let layer = if moving.contains(&i) { Layer::Moving } else { Layer::Static };
            bp.insert(i, &Aabb::around(vec3(1.0, 1.0, 1.0), vec3(0.5, 0.5, 0.5)), layer);
        }
        assert!(bp.stats().height < 40, "a tree of height {}", bp.stats().height);
        let mut out = Vec::new();
        bp.find_pairs(&moving, &mut out);
        assert_eq!(out.len(), 10 * 9990 + 45);
        assert!(out.is_sorted_by(|a, b| a < b));
        assert!(out.iter().all(|[a, b]| moving.contains(a) || moving.contains(b)));
        // Taken out from the middle, half of them.
        (0..count).filter(|i| i % 2 == 1).for_each(|i| bp.remove(i));
        bp.find_pairs(&[0, 500, 9998], &mut out);
        assert_eq!(out.len(), 3 * 4997 + 3);
    });
}

#[test]
fn static_boxes_make_no_pairs_among_themselves() {
    each_kind(|bp| {
        let b = Aabb::around(Vec3::zeros(), vec3(1.0, 1.0, 1.0));
        (0..4).for_each(|i| bp.insert(i, &b, Layer::Static));
        assert!(all_pairs(bp, 4).is_empty());
        bp.set_layer(2, Layer::Moving);
        assert_eq!(all_pairs(bp, 4), [[0, 2], [1, 2], [2, 3]]);
        bp.set_layer(2, Layer::Moving);
        bp.rebuild_static();
        assert_eq!(all_pairs(bp, 4), [[0, 2], [1, 2], [2, 3]]);
    });
}

#[test]
fn concentric_boxes_of_all_sizes() {
    each_kind(|bp| {
        for i in 0..600 {
            let half = 1.0 + i as Float;
            bp.insert(i, &Aabb::around(Vec3::zeros(), vec3(half, half, half)), Layer::Moving);
        }
        assert_eq!(all_pairs(bp, 600).len(), 600 * 599 / 2);
        assert_eq!(query(bp, &Aabb::around(Vec3::zeros(), Vec3::zeros())).len(), 600);
    });
}

#[test]
fn boxes_as_large_as_the_world_allows() {
    each_kind(|bp| {
        let m = crate::math::tolerance::MAX_COORDINATE;
        bp.insert(0, &Aabb { lower: vec3(-m, -m, -m), upper: vec3(m, 0.0, m) }, Layer::Static);
        for i in 1..100 {
            let b = Aabb::around(vec3(i as Float * 3.0, 0.9, 0.0), vec3(1.0, 1.0, 1.0));
            bp.insert(i, &b, if i % 2 == 0 { Layer::Moving } else { Layer::Static });
        }
        assert_eq!(all_pairs(bp, 100), (1..100).filter(|i| i % 2 == 0).map(|i| [0, i]).collect::<Vec<_>>());
    });
}

/// A box of one of the kinds that break trees.
fn any_box(random: &mut Random, spread: Float) -> Aabb {
    let cube = |r: Float| vec3(r, r, r);
    match random.below(12) {
        0 => Aabb::around(random.vec() * spread, Vec3::zeros()),
        1 => Aabb::around(vec3(1.0, 2.0, 3.0), cube(0.5)),
        2 => Aabb::around(random.vec() * 2.0 + cube(1e6), cube(1.0)),
        3 => Aabb::around(random.vec() * spread, vec3(spread, 0.0, spread * 0.5)),
        4 => Aabb::around(random.vec() * spread, vec3(0.0, random.signed().abs() * spread, 0.0)),
        5 | 6 => {
            let cluster = random.below(4) as Float * 0.25 * spread;
            Aabb::around(random.vec() + cube(cluster), cube(0.1))
        }
        // On a grid, so that faces touch exactly.
        7 | 8 => {
            let p = random.vec() * spread;
            Aabb::around(vec3(p.x.round(), p.y.round(), p.z.round()), cube(0.5))
        }
        _ => Aabb::around(random.vec() * spread, crate::math::abs(random.vec())),
    }
}

fn any_layer(random: &mut Random) -> Layer {
    if random.below(3) == 0 { Layer::Static } else { Layer::Moving }
}

fn query(bp: &dyn BroadPhase, aabb: &Aabb) -> Vec<u32> {
    let mut found = Vec::new();
    bp.query(aabb, &mut |proxy| {
        found.push(proxy);
        true
    });
    found.sort_unstable();
    found
}

fn cast(bp: &dyn BroadPhase, half: Vec3, origin: Vec3, translation: Vec3, max: Float) -> Vec<u32> {
    let mut found = Vec::new();
    bp.cast(half, origin, translation, max, &mut |proxy, max| {
        found.push(proxy);
        max
    });
    found.sort_unstable();
    found
}

/// Everything a subject answers, against the oracle.
fn compare(
    subject: &mut dyn BroadPhase,
    oracle: &mut BruteForce,
    moved: &[u32],
    random: &mut Random,
    spread: Float,
) {
    let (mut found, mut expected) = (Vec::new(), Vec::new());
    oracle.find_pairs(moved, &mut expected);
    subject.find_pairs(moved, &mut found);
    assert_eq!(found, expected);
    assert_eq!(subject.bounds(), oracle.bounds());
    assert_eq!(subject.stats().proxies, oracle.stats().proxies);
    for _ in 0..40 {
        let b = any_box(random, spread);
        assert_eq!(query(subject, &b), query(oracle, &b));
        let half = if random.below(2) == 0 { Vec3::zeros() } else { crate::math::abs(random.vec()) };
        let mut d = random.vec() * (2.0 * spread);
        (0..3).for_each(|k| d[k] *= random.below(2) as Float);
        let origin = if random.below(2) == 0 { b.lower } else { b.center() - d };
        let max = [1.0, 0.3, 2.0][random.below(3) as usize];
        assert_eq!(cast(subject, half, origin, d, max), cast(oracle, half, origin, d, max));
    }
}

#[test]
fn random_lives_agree_with_the_oracle() {
    for (seed, count, rounds) in [(1, 10, 60), (2, 60, 40), (3, 300, 25), (4, 3000, 6)] {
        for kind in BroadPhaseKind::ALL {
            let mut random = Random::new(seed);
            let (mut subject, mut oracle) = (kind.build(), BruteForce::new());
            let spread = 2.0 * (count as Float).sqrt();
            let mut in_use = vec![false; count as usize];
            for round in 0..rounds {
                let mut moved = Vec::new();
                for proxy in 0..count {
                    let used = &mut in_use[proxy as usize];
                    let b = any_box(&mut random, spread);
                    match random.below(if round == 0 { 2 } else { 10 }) {
                        0 if *used => {
                            subject.remove(proxy);
                            oracle.remove(proxy);
                            *used = false;
                        }
                        0 | 1 if !*used => {
                            let layer = any_layer(&mut random);
                            subject.insert(proxy, &b, layer);
                            oracle.insert(proxy, &b, layer);
                            (*used, _) = (true, moved.push(proxy));
                        }
                        2 | 3 if *used => {
                            subject.update(proxy, &b);
                            oracle.update(proxy, &b);
                            moved.push(proxy);
                        }
                        4 if *used => {
                            let layer = any_layer(&mut random);
                            subject.set_layer(proxy, layer);
                            oracle.set_layer(proxy, layer);
                        }
                        5 if *used => moved.push(proxy),
                        _ => {}
                    }
                }
                if random.below(4) == 0 {
                    subject.rebuild_static();
                }
                if random.below(4) == 0 {
                    subject = subject.clone();
                }
                compare(&mut *subject, &mut oracle, &moved, &mut random, spread);
            }
        }
    }
}

#[test]
fn trees_stay_sound_under_small_moves() {
    let (mut bvh, mut oracle, mut random) = (DynamicBvh::new(), BruteForce::new(), Random::new(9));
    let mut boxes: Vec<_> =
        (0..500).map(|_| Aabb::around(random.vec() * 8.0, crate::math::abs(random.vec()))).collect();
    for (i, b) in (0u32..).zip(&boxes) {
        bvh.insert(i, b, any_layer(&mut random));
        bvh.validate();
    }
    for i in 0..500 {
        oracle.insert(i, &boxes[i as usize], if bvh.is_static(i) { Layer::Static } else { Layer::Moving });
    }
    for _ in 0..50 {
        let mut moved: Vec<_> = (0..60).map(|_| random.below(500)).collect();
        moved.sort_unstable();
        moved.dedup();
        for &i in &moved {
            let b = &mut boxes[i as usize];
            let d = random.vec() * 0.3;
            *b = Aabb { lower: b.lower + d, upper: b.upper + d };
            bvh.update(i, b);
            oracle.update(i, b);
        }
        bvh.validate();
        compare(&mut bvh, &mut oracle, &moved, &mut random, 8.0);
        bvh.validate();
    }
}

/// Random insertions, moves small and large, and removals, until nothing is left; the tree is checked after each.
fn live_and_validate<S: Structure>(validate: impl Fn(&S)) {
    let (mut tree, mut random) = (S::default(), Random::new(11));
    for round in 0..4000 {
        let proxy = random.below(400);
        let b = any_box(&mut random, 20.0);
        match (tree.contains(proxy), random.below(4)) {
            (false, _) if round < 3000 => tree.insert(proxy, &b),
            (true, 0) => tree.remove(proxy),
            (true, 1) => tree.update(proxy, &b),
            (true, _) => {
                let (old, d) = (tree.aabb(proxy), random.vec() * 0.3);
                tree.update(proxy, &Aabb { lower: old.lower + d, upper: old.upper + d });
            }
            _ => {}
        }
        if round % 16 == 0 {
            tree.refresh();
        }
        if round % 500 == 250 {
            tree.rebuild();
        }
        validate(&tree);
    }
    for proxy in 0..400 {
        if tree.contains(proxy) {
            tree.remove(proxy);
            validate(&tree);
        }
    }
    tree.refresh();
    assert_eq!((tree.len(), tree.nodes_and_height()), (0, (0, 0)));
}

#[test]
fn wide_trees_stay_sound_through_random_lives() {
    fn grown<G: Growth>() {
        live_and_validate(Grown::<G>::validate);
    }
    fn packed<P: Packing>() {
        live_and_validate(Packed::<P>::validate);
    }
    grown::<rtree::Quadratic>();
    grown::<rstar::Margins>();
    grown::<Repacked<rtree::Quadratic, omt::Cuts>>();
    packed::<str_packing::Tiles>();
    packed::<omt::Cuts>();
}

/// After a change and before the next `find_pairs`, too, all questions are answered right.
#[test]
fn questions_between_a_change_and_the_next_pairs_see_it() {
    each_kind(|bp| {
        let (mut oracle, mut random) = (BruteForce::new(), Random::new(21));
        let mut used = [false; 200];
        for round in 0..600 {
            let (proxy, b) = (random.below(200), any_box(&mut random, 12.0));
            let used = &mut used[proxy as usize];
            match (*used, random.below(3)) {
                (false, _) => {
                    bp.insert(proxy, &b, Layer::Moving);
                    oracle.insert(proxy, &b, Layer::Moving);
                    *used = true;
                }
                (true, 0) => {
                    bp.remove(proxy);
                    oracle.remove(proxy);
                    *used = false;
                }
                (true, _) => {
                    bp.update(proxy, &b);
                    oracle.update(proxy, &b);
                }
            }
            let place = any_box(&mut random, 12.0);
            assert_eq!(query(bp, &place), query(&oracle, &place));
            let way = random.vec() * 30.0;
            assert_eq!(
                cast(bp, Vec3::zeros(), place.lower, way, 1.0),
                cast(&oracle, Vec3::zeros(), place.lower, way, 1.0)
            );
            if round % 50 == 0 {
                bp.find_pairs(&[], &mut Vec::new());
            }
        }
    });
}

#[test]
fn visitors_stop_and_shorten() {
    each_kind(|bp| {
        for i in 0..100 {
            let b = Aabb::around(vec3(i as Float * 2.0, 0.0, 0.0), vec3(0.5, 0.5, 0.5));
            bp.insert(i, &b, if i % 3 == 0 { Layer::Static } else { Layer::Moving });
        }
        let mut seen = 0;
        bp.query(&bp.bounds(), &mut |_| {
            seen += 1;
            seen < 7
        });
        assert_eq!(seen, 7);

        let (mut nearest, mut visits) = (None, 0);
        bp.cast(Vec3::zeros(), vec3(240.0, 0.25, 0.0), vec3(-480.0, 0.0, 0.0), 1.0, &mut |proxy, max| {
            visits += 1;
            let t = (240.0 - (proxy as Float * 2.0 + 0.5)) / 480.0;
            if t <= max {
                nearest = Some(proxy);
            }
            t.min(max)
        });
        assert_eq!(nearest, Some(99));
        assert!(visits <= 100);

        let mut visits = 0;
        bp.cast(Vec3::zeros(), vec3(-1.0, 0.0, 0.0), vec3(480.0, 0.0, 0.0), 1.0, &mut |_, _| {
            visits += 1;
            0.0
        });
        assert_eq!(visits, 1);
    });
}

#[test]
fn a_ray_that_geometry_says_touches_is_never_missed() {
    let mut random = Random::new(5);
    for far in [0.0, 1.0, 1e3, 1e6] {
        for _ in 0..5000 {
            let b = Aabb::around(random.vec() * 3.0 + vec3(far, -far, far), crate::math::abs(random.vec()));
            // Through a point of the box, mostly of its surface.
            let mut hit = b.center() + random.vec().component_mul(&b.half());
            let axis = random.below(3) as usize;
            hit[axis] = if random.below(2) == 0 { b.lower[axis] } else { b.upper[axis] };
            let mut d = random.vec() * 10.0;
            (0..3).for_each(|k| d[k] *= random.below(2) as Float);
            let origin = hit - d * 0.5;
            each_kind(|bp| {
                bp.insert(0, &b, Layer::Moving);
                assert_eq!(cast(bp, Vec3::zeros(), origin, d, 1.0), [0], "{b:?} {origin} {d}");
            });
        }
    }
}
