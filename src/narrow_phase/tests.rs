//! Every pair of shapes against certificates that do not trust the code under test: a normal is checked by the
//! support functions of both shapes, a distance by its two witnesses together with the plane between them.

use super::gjk::Pair;
use super::*;
use crate::math::scalar::{double, single};
use crate::math::tolerance::{DEPTH_PREFERENCE, EDGE_PREFERENCE, EPSILON};
use crate::math::{Vec3, length, quat_about, vec3};
use crate::shape::testing::Random;
use crate::shape::wide;

/// The ways whose normal is the best one. MPR's need not be: it has tests of its own.
const KINDS: [NarrowPhaseKind; 2] = [NarrowPhaseKind::Specialised, NarrowPhaseKind::GjkEpa];

/// Room for rounding in shapes of size about 1, and for the progress that GJK leaves in double.
const TIGHT: Float = 40.0 * EPSILON + 1e-12;

fn run(a: &Shape, b: &Shape, pose: &Pose, margin: Float, methods: impl Into<Methods>) -> Manifold {
    let mut m = Manifold::default();
    collide(a, b, pose, margin, methods.into(), &mut Cache::default(), &mut m);
    m
}

/// The gap between bounded shapes along the unit normal `n`, by their support functions, in double.
fn gap_along(a: &Shape, b: &Shape, pose: &Pose, n: Vec3) -> Float {
    let (ca, cb) = (a.core().unwrap(), b.core().unwrap());
    let n = wide(n) / wide(n).norm();
    let pair = Pair::new(ca.points, cb.points, pose);
    single(pair.gap_along(n) - double(ca.radius + cb.radius))
}

/// A pair of bounded shapes with a gap of about −0.5 … 0.3 along a random direction.
fn pair(random: &mut Random, i: usize, j: usize) -> (Shape, Shape, Pose) {
    let (a, b) = (random.shape(i), random.shape(j));
    let mut pose = Pose::new(Vec3::zeros(), random.rotation());
    let n = random.unit();
    let want = match random.below(4) {
        0 => random.within(-0.01, 0.01),
        1 => 0.0,
        _ => random.within(-0.5, 0.3),
    };
    pose.p = n * (want - gap_along(&a, &b, &pose, n));
    (a, b, pose)
}

fn check_points(a: &Shape, b: &Shape, pose: &Pose, m: &Manifold, margin: Float) {
    assert!((length(m.normal) - 1.0).abs() < 1e-5, "normal {}", m.normal);
    let gap = gap_along(a, b, pose, m.normal);
    for p in m.points() {
        assert!(p.separation <= margin);
        assert!(
            p.separation >= gap - 5e-6,
            "{} below the gap {gap} {m:?} {a:?} {b:?} {pose:?}",
            p.separation
        );
        let half = m.normal * (0.5 * p.separation);
        let (on_a, on_b) = (p.point - half, pose.point_back(p.point + half));
        let (off_a, off_b) = (length(a.closest_point(on_a) - on_a), length(b.closest_point(on_b) - on_b));
        let off = 2e-3 + 0.05 * p.separation.abs();
        assert!(
            off_a < off && off_b < off,
            "point off A by {off_a}, off B by {off_b}: {m:?} {gap} {a:?} {b:?}"
        );
    }
    let mut ids: Vec<_> = m.points().iter().map(|p| p.feature).collect();
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), m.count, "feature numbers are unique: {m:?} {a:?} {b:?} {pose:?}");
}

fn each_pair(seed: u64, rounds: usize, mut f: impl FnMut(&Shape, &Shape, &Pose, &mut Random)) {
    let mut random = Random(seed);
    for i in 0..4 {
        for j in 0..4 {
            for _ in 0..rounds {
                let (a, b, pose) = pair(&mut random, i, j);
                f(&a, &b, &pose, &mut random);
            }
        }
    }
}

#[test]
fn distances_are_certified_by_a_plane() {
    let (mut worst, mut total, mut runs) = (0, 0, 0);
    each_pair(21, 2000, |a, b, pose, _| {
        let d = distance(a, b, pose);
        worst = worst.max(d.iterations);
        total += d.iterations;
        runs += 1;
        assert_eq!(overlap(a, b, pose), d.distance <= 0.0 || d.distance < TIGHT && overlap(a, b, pose));
        if d.distance > 0.0 {
            assert!((length(d.point_b - d.point_a) - d.distance).abs() < TIGHT);
            assert!((gap_along(a, b, pose, d.normal) - d.distance).abs() < TIGHT);
            assert!(length(a.closest_point(d.point_a) - d.point_a) < TIGHT);
            let in_b = pose.point_back(d.point_b);
            assert!(length(b.closest_point(in_b) - in_b) < TIGHT);
        } else {
            // A common point proves the overlap.
            let in_b = pose.point_back(d.point_a);
            assert!(length(a.closest_point(d.point_a) - d.point_a) < TIGHT, "{a:?} {b:?} {pose:?} {d:?}");
            assert!(
                length(b.closest_point(in_b) - in_b) < TIGHT,
                "{} {a:?} {b:?} {pose:?} {d:?}",
                length(b.closest_point(in_b) - in_b)
            );
        }
    });
    assert!(worst < 30, "{worst} iterations, mean {}", total as Float / runs as Float);
}

#[test]
fn manifolds_keep_their_promises() {
    let mut short = 0;
    each_pair(22, 2000, |a, b, pose, random| {
        let margin = if random.below(2) == 0 { 0.0 } else { 0.05 };
        let inner = a.inner_radius().min(b.inner_radius());
        let d = distance(a, b, pose);
        for kind in KINDS {
            let m = run(a, b, pose, margin, kind);
            if m.count == 0 {
                assert!(d.distance > margin - TIGHT, "{kind:?} {a:?} {b:?} {pose:?} missed: {d:?}");
                continue;
            }
            check_points(a, b, pose, &m, margin);
            // No direction parts the shapes clearly better than the normal.
            let gap = gap_along(a, b, pose, m.normal);
            let slack = 2.0 * EDGE_PREFERENCE * inner + (2.0 * DEPTH_PREFERENCE + 0.001) * gap.abs() + TIGHT;
            if d.distance <= 0.0 {
                for _ in 0..50 {
                    let other = gap_along(a, b, pose, random.unit());
                    assert!(other <= gap + slack, "{kind:?} {a:?} {b:?} {pose:?}: {gap}, but {other}");
                }
            }
            // The deepest place is in the manifold, all but always.
            let least = m.points().iter().map(|p| p.separation).fold(Float::MAX, Float::min);
            short += usize::from(least > gap + 0.02 * gap.abs() + 1e-3);
            assert!(
                least <= gap + 0.2 * gap.abs() + 0.05,
                "{kind:?} {a:?} {b:?} {pose:?}: {least} against {gap}"
            );
        }
    });
    // Of 64 000: where the deepest corner lies beside the reference face.
    assert!(short <= 40, "{short}");
}

#[test]
fn both_ways_to_the_normal_find_the_same_depth() {
    each_pair(23, 1000, |a, b, pose, _| {
        let inner = a.inner_radius().min(b.inner_radius());
        let [m, n] = KINDS.map(|kind| run(a, b, pose, 0.0, kind));
        if m.count > 0 && n.count > 0 {
            let (g, h) = (gap_along(a, b, pose, m.normal), gap_along(a, b, pose, n.normal));
            let slack = 2.0 * EDGE_PREFERENCE * inner + 2.5 * DEPTH_PREFERENCE * g.abs() + TIGHT;
            assert!((g - h).abs() <= slack, "{a:?} {b:?} {pose:?}: {g} {h} {m:?} {n:?}");
        } else {
            assert!(m.count == n.count || distance(a, b, pose).distance < TIGHT, "{m:?} {n:?}");
        }
    });
}

#[test]
fn swapping_the_shapes_mirrors_the_manifold() {
    let mut compared = 0;
    each_pair(24, 1000, |a, b, pose, _| {
        let m = run(a, b, pose, 0.02, NarrowPhaseKind::Auto);
        let mut n = run(b, a, &pose.inverse(), 0.02, NarrowPhaseKind::Auto);
        n.mirror(pose);
        // Where two axes tie, either may be taken; then the depths tie too.
        if m.count > 0 && n.count > 0 {
            let (g, h) = (gap_along(a, b, pose, m.normal), gap_along(a, b, pose, n.normal));
            assert!((g - h).abs() < 2e-3 + 0.05 * g.abs());
            if length(m.normal - n.normal) < 1e-4 && m.count == n.count {
                for p in m.points() {
                    if let Some(q) = n.points().iter().find(|q| q.feature == p.feature) {
                        compared += 1;
                        assert!(length(p.point - q.point) < 2e-3, "{p:?} {q:?}");
                        assert!((p.separation - q.separation).abs() < 1e-3);
                    }
                }
            }
        }
    });
    assert!(compared > 3_000, "{compared}");
}

#[test]
fn a_cache_changes_nothing() {
    each_pair(25, 300, |a, b, pose, random| {
        let mut cache = Cache::default();
        let mut out = Manifold::default();
        let mut pose = *pose;
        for _ in 0..5 {
            pose.p += random.vec(0.02);
            collide(a, b, &pose, 0.01, Methods::default(), &mut cache, &mut out);
            let fresh = run(a, b, &pose, 0.01, NarrowPhaseKind::Auto);
            assert_eq!((out.count, out.points()), (fresh.count, fresh.points()));
        }
    });
    assert!(size_of::<Cache>() <= 16);
}

#[test]
fn a_half_space_feels_every_shape() {
    let mut random = Random(26);
    for kind in 0..4 {
        for _ in 0..500 {
            let b = random.shape(kind);
            let floor = Shape::half_space(random.unit(), random.within(-1.0, 1.0)).unwrap();
            let Shape::HalfSpace(h) = &floor else { unreachable!() };
            let pose = random.pose(1.5);
            // The lowest point by the support function.
            let core = b.core().unwrap();
            let down = pose.vector_back(-h.normal());
            let p = core.points.point(core.points.support(&wide(down)));
            let height = h.height(pose.point(p)) - core.radius;
            let m = run(&floor, &b, &pose, 0.1, NarrowPhaseKind::Auto);
            assert_eq!(m.count > 0, height <= 0.1, "{height}");
            if m.count > 0 {
                let least = m.points().iter().map(|p| p.separation).fold(Float::MAX, Float::min);
                assert!((least - height).abs() < 1e-3);
                assert!(length(m.normal - h.normal()) < 1e-6);
            }
            let mut n = run(&b, &floor, &pose.inverse(), 0.1, NarrowPhaseKind::Auto);
            n.mirror(&pose);
            assert_eq!(m.count, n.count);
            let d = distance(&floor, &b, &pose);
            assert!((d.distance - height.max(0.0)).abs() < 1e-5);
        }
    }
}

#[test]
fn four_points_carry_a_box_on_a_box_to_a_few_ulps() {
    let mut random = Random(27);
    let shapes =
        [Shape::new_box(1.0, 1.0, 1.0), Shape::new_box(2.0, 0.002, 2.0), Shape::new_box(1.0, 3.0, 1.0)];
    for a in &shapes {
        for b in &shapes {
            let (Shape::Box(ca), Shape::Box(cb)) = (a, b) else { unreachable!() };
            let touch = ca.half().y + cb.half().y;
            for _ in 0..200 {
                let gap = random.within(-1e-4, 1e-4);
                let yaw = if random.below(2) == 0 { 0.0 } else { random.within(-3.0, 3.0) };
                let slide = vec3(random.within(-0.3, 0.3), touch + gap, random.within(-0.3, 0.3));
                let pose = Pose::new(slide, quat_about(Vec3::y(), yaw));
                for kind in KINDS {
                    let m = run(a, b, &pose, 0.01, kind);
                    assert_eq!(m.count, 4, "{kind:?} {a:?} {b:?} {pose:?}");
                    assert!(length(m.normal - Vec3::y()) < 8.0 * EPSILON);
                    for p in m.points() {
                        let exact = pose.p.y - touch;
                        assert!(
                            (p.separation - exact).abs() <= 4.0 * EPSILON * touch.max(1.0),
                            "{p:?} {exact}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn what_rests_keeps_its_numbers_while_it_jitters() {
    let mut random = Random(28);
    let cube = Shape::new_box(1.0, 1.0, 1.0);
    let corners: Vec<_> =
        (0..8).map(|i| vec3((i & 1) as Float, (i >> 1 & 1) as Float, (i >> 2) as Float)).collect();
    let hull = Shape::hull(&corners.iter().map(|c| c - vec3(0.5, 0.5, 0.5)).collect::<Vec<_>>()).unwrap();
    let capsule = Shape::new_capsule(0.6, 1.0);
    let lying = quat_about(Vec3::z(), crate::math::scalar::PI * 0.5);
    let yaw = quat_about(Vec3::y(), 0.7);
    let cases = [
        (&cube, &cube, Pose::IDENTITY.q, 4),
        (&cube, &cube, yaw, 4),
        (&cube, &hull, Pose::IDENTITY.q, 4),
        (&hull, &cube, yaw, 4),
        (&hull, &hull, Pose::IDENTITY.q, 4),
        (&hull, &hull, yaw, 4),
        (&cube, &capsule, lying, 2),
        (&capsule, &capsule, Pose::IDENTITY.q, 2),
    ];
    let all = KINDS.into_iter().flat_map(|kind| {
        let built = ManifoldKind::ALL.into_iter().filter(|m| m.is_built());
        built.map(move |manifold| Methods { kind, manifold, ..Methods::default() })
    });
    for kind in all {
        for (case, (a, b, q, count)) in cases.iter().enumerate() {
            let place = if case == 7 { Vec3::x() } else { Vec3::y() };
            let ids = |pose: &Pose| {
                let m = run(a, b, pose, 0.01, kind);
                let mut ids: Vec<_> = m.points().iter().map(|p| p.feature).collect();
                ids.sort_unstable();
                ids
            };
            let first = ids(&Pose::new(place, *q));
            assert_eq!(first.len(), *count, "{kind:?} case {case}");
            for _ in 0..300 {
                let pose = Pose::new(place + random.vec(1e-5), crate::math::turn(q, random.vec(1e-5)));
                assert_eq!(ids(&pose), first, "{kind:?} case {case} {pose:?}");
            }
        }
    }
}

#[test]
fn degenerate_placements_give_finite_unit_normals() {
    let mut random = Random(29);
    let mut shapes: Vec<_> = (0..4).map(|k| random.shape(k)).collect();
    shapes.push(Shape::new_box(2.0, 2.0, 0.002));
    shapes.push(Shape::new_box(1.0, 0.001, 0.001));
    shapes.push(Shape::new_capsule(2.0, 0.002));
    shapes.push(Shape::new_sphere(2.0));
    shapes.push(Shape::new_box(1.0, 1.0, 1.0));
    let corners: Vec<_> =
        (0..8).map(|i| vec3((i & 1) as Float, (i >> 1 & 1) as Float, (i >> 2) as Float)).collect();
    shapes.push(Shape::hull(&corners).unwrap());
    let quarter = crate::math::scalar::PI * 0.5;
    let turns = [0.0, 1.0, 0.5, 1e-3 / quarter, 1e-7 / quarter];
    let places = [
        Vec3::zeros(),
        Vec3::x(),
        Vec3::y(),
        vec3(0.5, 0.5, 0.0),
        vec3(1.0, 1.0, 1.0),
        vec3(0.0, 1e-9, 0.0),
        vec3(1e-20, 0.0, 0.0),
    ];
    for a in &shapes {
        for b in &shapes {
            for turn in turns {
                for axis in [Vec3::x(), Vec3::y(), Vec3::z(), vec3(1.0, 1.0, 1.0)] {
                    for p in places {
                        let pose = Pose::new(p, quat_about(axis, turn * quarter));
                        let d = distance(a, b, &pose);
                        for kind in KINDS {
                            let m = run(a, b, &pose, 0.01, kind);
                            if d.distance <= 0.0 {
                                assert!(m.count > 0, "{kind:?} {a:?} {b:?} {pose:?}");
                            }
                            if m.count > 0 {
                                assert!((length(m.normal) - 1.0).abs() < 1e-5);
                                check_points(a, b, &pose, &m, 0.01);
                            }
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn capsules_lie_on_two_points() {
    let floor = Shape::new_box(4.0, 1.0, 4.0);
    let capsule = Shape::new_capsule(1.0, 0.5);
    let lying = Pose::new(vec3(0.0, 0.75, 0.0), quat_about(Vec3::z(), crate::math::scalar::PI * 0.5));
    for kind in KINDS {
        for pose in [lying, Pose::new(vec3(1.9, 0.75, 0.0), lying.q)] {
            assert_eq!(run(&floor, &capsule, &pose, 0.01, kind).count, 2, "{kind:?}");
        }
        // Side by side, and along an edge turned up.
        let beside = Pose::translation(vec3(0.5, 0.3, 0.0));
        assert_eq!(run(&capsule, &capsule, &beside, 0.01, kind).count, 2);
        let bar = Shape::new_box(1.0, 4.0, 1.0);
        let corner = Pose::translation(vec3(1.0, 0.0, 1.0) * (0.5 + 0.25 * (0.5 as Float).sqrt()));
        assert_eq!(run(&bar, &capsule, &corner, 0.01, kind).count, 2);
        // Crossed capsules touch in one point.
        let crossed = Pose::new(vec3(0.5, 0.0, 0.0), quat_about(Vec3::x(), 1.0));
        assert_eq!(run(&capsule, &capsule, &crossed, 0.01, kind).count, 1);
    }
}

#[test]
fn scaling_a_pair_scales_its_manifold() {
    // Powers of two scale without rounding: the answer must scale to the bit.
    let mut random = Random(30);
    for _ in 0..2000 {
        let half = vec3(random.within(0.3, 1.0), random.within(0.3, 1.0), random.within(0.3, 1.0));
        let boxed = |k: Float| Shape::new_box(half.x * k, half.y * k, 2.0 * k);
        let cloud = random.cloud(12, half);
        let hull = |k: Float| Shape::hull(&cloud.iter().map(|p| p * k).collect::<Vec<_>>()).unwrap();
        let pose = Pose::new(random.vec(1.0), random.rotation());
        for k in [1.0 / 1024.0, 1024.0] {
            let scaled = Pose::new(pose.p * k, pose.q);
            for (a, b, ka, kb) in
                [(boxed(1.0), boxed(1.0), boxed(k), boxed(k)), (boxed(1.0), hull(1.0), boxed(k), hull(k))]
            {
                let (m, n) = (
                    run(&a, &b, &pose, 0.01, NarrowPhaseKind::Auto),
                    run(&ka, &kb, &scaled, 0.01 * k, NarrowPhaseKind::Auto),
                );
                assert_eq!((m.count, m.count > 0 && m.normal != n.normal), (n.count, false));
                for (p, q) in m.points().iter().zip(n.points()) {
                    assert_eq!((p.separation * k, p.feature), (q.separation, q.feature));
                }
            }
        }
    }
}

#[test]
fn casts_arrive_where_the_shapes_touch() {
    let mut hits = 0;
    each_pair(31, 300, |a, b, pose, random| {
        let from = Pose::new(pose.p + random.unit() * 5.0, pose.q);
        let way = pose.p - from.p + random.vec(0.5);
        let start = distance(a, b, &from).distance;
        let Some(hit) = shape_cast(a, b, &from, way, 1.0) else {
            // Nothing on the way is closer than touching.
            for k in 0..=20 {
                let there = Pose::new(from.p + way * (k as Float / 20.0), from.q);
                assert!(distance(a, b, &there).distance > 0.0);
            }
            return;
        };
        let there = Pose::new(from.p + way * hit.fraction, from.q);
        let d = distance(a, b, &there);
        assert!(d.distance < 1e-5, "{d:?}");
        if start > 0.0 {
            hits += 1;
            assert!((length(hit.normal) - 1.0).abs() < 1e-5 && hit.normal.dot(&way) < 0.0);
            let before = Pose::new(from.p + way * (hit.fraction * 0.99), from.q);
            assert!(distance(a, b, &before).distance > 0.0);
            assert!(length(a.closest_point(hit.point) - hit.point) < 1e-4);
        }
    });
    assert!(hits > 1500, "{hits}");
}

/// Distance by certificate for shapes of any size and thinness: the plane must part them by as much as the witnesses
/// are apart, relative to the size of the pair.
#[test]
fn distances_survive_needles_plates_and_giants() {
    let mut random = Random(32);
    let (mut worst, mut off) = ((0.0 as Float, 0), 0);
    let mut ended = [0; 6];
    for round in 0..60_000 {
        let size = |random: &mut Random| [1e-3, 0.1, 1.0, 1.0, 10.0, 1e4][random.below(6)];
        let thin = |random: &mut Random| {
            let k = [1.0, 1.0, 1e-2, 1e-4][random.below(4)];
            vec3(
                random.within(0.5, 1.0),
                random.within(0.5, 1.0) * if random.below(2) == 0 { k } else { 1.0 },
                random.within(0.5, 1.0) * k,
            )
        };
        let make = |random: &mut Random| {
            let scale = size(random);
            let half = thin(random) * scale;
            let half = half.map(|x| x.max(1e-4 * scale).max(2e-5));
            match random.below(3) {
                0 => Shape::new_capsule(half.x * 2.0, half.z),
                1 => Shape::new_box(half.x, half.y, half.z),
                _ => {
                    let n = 4 + random.below(60);
                    let cloud = random.cloud(n, half);
                    Shape::hull(&cloud).unwrap_or_else(|_| Shape::new_box(half.x, half.y, half.z))
                }
            }
        };
        let (a, b) = (make(&mut random), make(&mut random));
        let mut pose = Pose::new(
            Vec3::zeros(),
            if round % 3 == 0 { quat_about(Vec3::y(), random.within(0.0, 1e-6)) } else { random.rotation() },
        );
        let n = if round % 3 == 0 { Vec3::y() } else { random.unit() };
        let scale = a.outer_radius(Vec3::zeros()).max(b.outer_radius(Vec3::zeros()));
        let want = [0.0, 1e-7, -1e-7, 1e-4, -1e-4, 0.3][random.below(6)] * scale;
        pose.p = n * (want - gap_along(&a, &b, &pose, n));
        let d = distance(&a, &b, &pose);
        ended[d.status as usize] += 1;
        if d.distance > 0.0 {
            let apart = (length(d.point_b - d.point_a) - d.distance).abs();
            let proven = (gap_along(&a, &b, &pose, d.normal) - d.distance).abs();
            // The normal is stored in Float: turning it by an ulp moves the supports by an ulp of the size.
            let error = apart.max(proven) / scale;
            off += usize::from(error > 40.0 * EPSILON + 1e-7);
            if error > worst.0 {
                worst = (error, round);
            }
        }
        for kind in KINDS {
            let m = run(&a, &b, &pose, 0.01 * scale, kind);
            if m.count > 0 {
                assert!((length(m.normal) - 1.0).abs() < 1e-5, "{kind:?} {a:?} {b:?} {pose:?} {m:?}");
                assert!(
                    m.points()
                        .iter()
                        .all(|p| crate::math::is_finite(p.point) && p.separation <= 0.01 * scale)
                );
            }
            assert!(
                m.count > 0 || d.distance > 0.0099 * scale,
                "{kind:?} {pose:?} {d:?} {round} {} {} {a:?} {b:?}",
                a.inner_radius(),
                b.inner_radius()
            );
        }
    }
    // A sliver of 0.1 mm a hair above a face of 4 km may stall on a normal with four digits.
    assert!(off <= 5 && worst.0 < 2e-4, "{off} off, worst {worst:?} {ended:?}");
    assert_eq!(ended[DistanceStatus::IterationLimit as usize], 0, "{ended:?}");
}

#[test]
fn a_small_box_rests_on_a_huge_one() {
    let ground = Shape::new_box(2000.0, 2.0, 2000.0);
    let small = Shape::new_box(0.01, 0.01, 0.01);
    let mut random = Random(33);
    for _ in 0..500 {
        let pose = Pose::new(
            vec3(random.within(-900.0, 900.0), 1.005, random.within(-900.0, 900.0)),
            quat_about(Vec3::y(), random.within(0.0, 6.0)),
        );
        for kind in KINDS {
            let m = run(&ground, &small, &pose, 1e-3, kind);
            assert_eq!(m.count, 4, "{kind:?} {pose:?} {m:?}");
            assert!(length(m.normal - Vec3::y()) < 1e-6);
            assert!(m.points().iter().all(|p| p.separation.abs() < 4.0 * EPSILON));
        }
    }
}

#[test]
fn proxies_agree_with_shapes() {
    let mut random = Random(34);
    for _ in 0..500 {
        let (ca, cb) = (random.cloud(12, vec3(1.0, 0.5, 0.7)), random.cloud(9, vec3(0.4, 1.0, 0.4)));
        let (a, b) = (Shape::hull(&ca).unwrap(), Shape::hull(&cb).unwrap());
        let pose = random.pose(2.0);
        let (pa, pb) = (Proxy::new(&ca, 0.0).unwrap(), Proxy::new(&cb, 0.1).unwrap());
        let (d, e) = (distance(&a, &b, &pose).distance, distance_proxy(&pa, &pb, &pose).distance);
        assert!(((d - 0.1).max(0.0) - e).abs() < TIGHT, "{d} {e}");
        let way = -pose.p;
        let hit = shape_cast_proxy(&pa, &Proxy::new(&cb, 0.0).unwrap(), &pose, way, 1.0);
        assert_eq!(hit.is_some(), shape_cast(&a, &b, &pose, way, 1.0).is_some());
    }
    assert!(Proxy::new(&[], 0.0).is_err() && Proxy::new(&[Vec3::zeros(); 65], 0.0).is_err());
    assert!(Proxy::new(&[Vec3::zeros()], -1.0).is_err());
}
