//! Every choice of the narrow phase, through the public interface: against oracles in double, against each other, and
//! in small scenes that must stand.

#[path = "../benches/support/fuzz.rs"]
mod fuzz;
#[path = "../benches/support/mod.rs"]
mod support;

use merev::math::scalar::double;
use merev::math::tolerance::EPSILON;
use merev::math::{length, quat_about, vec3};
use merev::narrow_phase::{
    Cache, DepthStatus, GjkKind, MAX_TRACE_STEPS, Manifold, ManifoldKind, Methods, NarrowPhaseKind,
    TraceStep, collide, distance_by, distance_traced, penetration,
};
use merev::shape::Shape;
use merev::{BodyDef, Float, Pose, ShapeDef, Vec3, World, WorldDef};
use support::{CLASSES, Clouds, Random, cuboid, pair, round_hull};

fn built() -> impl Iterator<Item = ManifoldKind> {
    ManifoldKind::ALL.into_iter().filter(|k| k.is_built())
}

fn run(a: &Shape, b: &Shape, pose: &Pose, margin: Float, methods: Methods) -> Manifold {
    let mut out = Manifold::default();
    collide(a, b, pose, margin, methods, &mut Cache::default(), &mut out);
    out
}

/// Fewer pairs than the bench `fuzz_pairs` runs, of the same kinds.
#[test]
fn pairs_that_break_such_methods_break_none() {
    let tallies = fuzz::run(7, 500 * CLASSES.len());
    let rounding = 4.0 * double(EPSILON);
    for (m, (name, of_method)) in fuzz::methods().iter().zip(&tallies).enumerate() {
        for (class, t) in CLASSES.iter().zip(of_method) {
            assert_eq!(t.bad, 0, "{name} {class}");
            let worst = t.errors.last().copied().unwrap_or(0.0);
            let mean = t.errors.iter().sum::<f64>() / t.errors.len().max(1) as f64;
            match name.as_str() {
                // The oracle and the default are right everywhere, up to what a stall on a thin gap leaves.
                "gjk_barycentric" | "gjk_signed_volumes" => {
                    assert!(mean <= 1e-8 + rounding && worst <= 1e-5, "{name} {class}: {mean} {worst}");
                }
                "epa" => assert!(mean <= 1e-5, "{name} {class}: {mean} {worst}"),
                _ => {}
            }
            if m < GjkKind::ALL.len() - 1 {
                assert_eq!(t.statuses[5], 0, "{name} {class} ended at the limit");
            }
        }
    }
}

#[test]
fn all_gjk_kinds_agree_on_ordinary_pairs() {
    let mut random = Random(41);
    let room = 40.0 * double(EPSILON) + 1e-12;
    for _ in 0..2_000 {
        let (a, b, pose) = pair(&mut random, 0);
        let clouds = Clouds::new(&a, &b, &pose);
        let (lower, upper) = clouds.distance();
        assert!(upper - lower <= 1e-12 * clouds.scale);
        let exact = (upper - clouds.radii).max(0.0);
        let (sa, sb) = (a.shape.unwrap(), b.shape.unwrap());
        for kind in GjkKind::ALL {
            let d = distance_by(&sa, &sb, &pose, kind);
            let off = (double(d.distance) - exact).abs();
            assert!(off <= room * clouds.scale, "{kind:?}: {d:?} {exact}");
        }
    }
}

#[test]
fn a_trace_shows_the_search() {
    let mut random = Random(42);
    for _ in 0..500 {
        let (a, b, pose) = pair(&mut random, 0);
        let (a, b) = (a.shape.unwrap(), b.shape.unwrap());
        for kind in GjkKind::ALL {
            let mut steps = [TraceStep::default(); MAX_TRACE_STEPS];
            let (d, n) = distance_traced(&a, &b, &pose, kind, &mut steps).unwrap();
            assert_eq!(d, distance_by(&a, &b, &pose, kind), "tracing changes nothing");
            assert!((1..=MAX_TRACE_STEPS).contains(&n));
            for s in &steps[..n] {
                assert!((1..=4).contains(&s.count));
                let sum: Float = s.weights[..s.count].iter().sum();
                assert!((sum - 1.0).abs() < 1e-5);
            }
            // Each simplex lies closer than the one before, up to rounding.
            assert!(steps[..n].windows(2).all(|w| w[1].distance <= w[0].distance * 1.000_001 + 1e-6));
            // With too little room the end takes the last place.
            let mut one = [TraceStep::default(); 1];
            let (_, m) = distance_traced(&a, &b, &pose, kind, &mut one).unwrap();
            assert_eq!((m, one[0]), (1, steps[n - 1]));
        }
    }
}

/// EPA finds the least depth; MPR finds a depth that parts the shapes along its normal and is never less.
#[test]
fn depths_hold_against_all_axes() {
    let mut random = Random(43);
    let (mut compared, mut excess) = (0, Vec::new());
    while compared < 600 {
        let half = vec3(random.within(0.3, 1.0), random.within(0.3, 1.0), random.within(0.3, 1.0));
        let a = if random.below(2) == 0 { cuboid(half) } else { round_hull(&mut random, 8, half) };
        let b = if random.below(2) == 0 { cuboid(half) } else { round_hull(&mut random, 7, half) };
        let pose = Pose::new(random.vec(0.8), random.rotation());
        let clouds = Clouds::new(&a, &b, &pose);
        let (Some(sa), Some(sb)) = (&a.shape, &b.shape) else { continue };
        if clouds.distance().1 > 0.0 {
            assert_eq!(
                penetration(sa, sb, &pose, NarrowPhaseKind::GjkEpa).unwrap().status,
                DepthStatus::Apart
            );
            continue;
        }
        compared += 1;
        let exact = clouds.depth().unwrap();
        let [epa, mpr] = [NarrowPhaseKind::GjkEpa, NarrowPhaseKind::GjkMpr].map(|kind| {
            let d = penetration(sa, sb, &pose, kind).unwrap();
            // Moved out by the depth along the normal, the shapes are apart or just touch.
            let out = Pose::new(pose.p + d.normal * (d.depth + 1e-4), pose.q);
            assert!(distance_by(sa, sb, &out, GjkKind::Auto).distance > 0.0, "{kind:?} {d:?}");
            assert!((length(d.normal) - 1.0).abs() < 1e-5);
            d
        });
        let (e, m) = (double(epa.depth) - exact, double(mpr.depth) - exact);
        assert!(epa.status == DepthStatus::Converged && e.abs() < 2e-6, "{epa:?} {exact}");
        assert!(m > -2e-6, "{mpr:?} {exact}");
        excess.push(m / exact.max(1e-3));
    }
    excess.sort_by(f64::total_cmp);
    // Half of the time MPR finds the least depth too; it never is without bound.
    assert!(support::quantile(&excess, 0.5) < 0.05 && excess[excess.len() - 1] < 20.0, "{:?}", excess.last());
}

fn on_both(a: &Shape, b: &Shape, pose: &Pose, m: &Manifold, off: Float) {
    for p in m.points() {
        let half = m.normal * (0.5 * p.separation);
        let (on_a, on_b) = (p.point - half, pose.point_back(p.point + half));
        let (da, db) = (length(a.closest_point(on_a) - on_a), length(b.closest_point(on_b) - on_b));
        assert!(da < off && db < off, "off A by {da}, off B by {db}: {m:?}");
    }
}

#[test]
fn manifolds_of_all_kinds_agree() {
    let mut random = Random(44);
    let (mut same, mut all) = (0, 0);
    for round in 0..6_000 {
        let (a, b, pose) = pair(&mut random, [0, 1, 8, 9][round % 4]);
        let (a, b) = (a.shape.unwrap(), b.shape.unwrap());
        let margin = 0.02 * a.inner_radius().min(b.inner_radius());
        for kind in NarrowPhaseKind::ALL {
            let reference = Methods { kind, manifold: ManifoldKind::SutherlandHodgman, ..Methods::default() };
            let m = run(&a, &b, &pose, margin, reference);
            for manifold in built() {
                let n = run(&a, &b, &pose, margin, Methods { manifold, ..reference });
                // What lies on the very margin, or corner to corner, may be seen by one of them only.
                if m.count == 0 || n.count == 0 {
                    let deepest = m.points().iter().chain(n.points()).map(|p| p.separation);
                    assert!(deepest.fold(Float::MAX, Float::min) > margin * 0.9, "{manifold:?} {m:?} {n:?}");
                    continue;
                }
                // Along a normal that is not the best one, the surfaces are not met under each other.
                let slant = if kind == NarrowPhaseKind::GjkMpr { 0.5 } else { 0.05 };
                on_both(&a, &b, &pose, &n, 2e-3 + slant * n.points[0].separation.abs());
                let least =
                    |m: &Manifold| m.points().iter().map(|p| p.separation).fold(Float::MAX, Float::min);
                let ids: std::collections::BTreeSet<_> = n.points().iter().map(|p| p.feature).collect();
                assert_eq!(ids.len(), n.count, "{manifold:?} {n:?}");
                let spread = |m: &Manifold| {
                    let far = m
                        .points()
                        .iter()
                        .flat_map(|p| m.points().iter().map(move |q| length(p.point - q.point)));
                    far.fold(0.0, Float::max)
                };
                all += 1;
                same += usize::from(
                    (least(&m) - least(&n)).abs() < 1e-4
                        && m.count == n.count
                        && (spread(&m) - spread(&n)).abs() < 1e-3
                        && length(m.normal - n.normal) < 1e-5,
                );
            }
        }
    }
    assert!(same as f64 > 0.97 * all as f64, "{same} of {all}");
}

/// Nothing is lost to the grid of the polygon library, be the faces small or large.
#[test]
fn manifolds_keep_their_digits_at_any_size() {
    for size in [1e-3, 1.0, 1e3] {
        let shape = Shape::new_box(size, size, size);
        let small = Shape::new_box(size * 1e-3 + 4e-5, size * 1e-3 + 4e-5, size * 1e-3 + 4e-5);
        let place = vec3(0.25 * size, 0.999 * size, 0.125 * size);
        for manifold in built() {
            for kind in NarrowPhaseKind::ALL {
                let methods = Methods { kind, manifold, ..Methods::default() };
                let m = run(&shape, &shape, &Pose::translation(place), 0.01 * size, methods);
                assert_eq!(m.count, 4, "{methods:?} {size}");
                for p in m.points() {
                    let (x, z) = (p.point.x / size, p.point.z / size);
                    let off = |v: Float, ends: [Float; 2]| (v - ends[0]).abs().min((v - ends[1]).abs());
                    let wrong = off(x, [-0.25, 0.5]).max(off(z, [-0.375, 0.5]));
                    assert!(wrong <= 4.0 * EPSILON.max(1e-9), "{methods:?} {size}: {p:?} {wrong}");
                    assert!((p.separation + 0.001 * size).abs() <= 4.0 * EPSILON * size, "{p:?}");
                }
                // A face a thousand times smaller than the other.
                let half = 0.5 * (size * 1e-3 + 4e-5);
                let pose = Pose::new(vec3(0.1 * size, 0.5 * size + half, 0.0), quat_about(Vec3::y(), 0.4));
                let m = run(&shape, &small, &pose, 0.01 * half, methods);
                assert_eq!(m.count, 4, "{methods:?} {size}");
                for p in m.points() {
                    let away = length(vec3(p.point.x - 0.1 * size, 0.0, p.point.z)) / half;
                    assert!((away * away - 2.0).abs() < 4e-3, "{methods:?} {size}: {away}");
                }
            }
        }
    }
}

/// Points, segments and faces seen from their edges.
#[test]
fn faces_without_area_have_contacts() {
    let floor = Shape::new_box(4.0, 1.0, 4.0);
    let quarter = core::f64::consts::FRAC_PI_2 as Float;
    let lying = quat_about(Vec3::z(), quarter);
    let wedge: Vec<Vec3> = [(-1.0, 0.0), (1.0, 0.0), (1.0, 2.0), (-1.0, 2.0)]
        .iter()
        .flat_map(|&(x, y)| [vec3(x, y, -0.001 * y), vec3(x, y, 0.001 * y)])
        .collect();
    // A plate that stands on its lower edge: its best face is all but upright.
    let plate = Shape::hull(&wedge).unwrap();
    let cases = [
        (Shape::new_sphere(1.0), Pose::translation(vec3(0.3, 0.999, 0.0)), 1),
        (Shape::new_capsule(1.0, 0.5), Pose::new(vec3(0.0, 0.749, 0.0), lying), 2),
        (Shape::new_capsule(1.0, 0.5), Pose::new(vec3(2.0, 0.749, 0.0), lying), 2),
        (Shape::new_capsule(1.0, 0.5), Pose::translation(vec3(0.0, 1.249, 0.0)), 1),
        (plate.clone(), Pose::translation(vec3(0.0, 0.4999, 0.0)), 2),
        (plate, Pose::translation(vec3(1.5, 0.4999, 0.0)), 2),
    ];
    for (case, (shape, pose, count)) in cases.iter().enumerate() {
        for kind in NarrowPhaseKind::ALL {
            for manifold in built() {
                let m = run(&floor, shape, pose, 1e-3, Methods { kind, manifold, ..Methods::default() });
                assert_eq!(m.count, *count, "case {case} {kind:?} {manifold:?} {m:?}");
                assert!(length(m.normal - Vec3::y()) < 1e-2);
                on_both(&floor, shape, pose, &m, 2e-3);
            }
        }
    }
}

#[test]
fn many_threads_find_the_same_manifolds() {
    let work = |manifold| {
        let mut random = Random(45);
        let methods = Methods { manifold, ..Methods::default() };
        let mut sum = Vec::new();
        for _ in 0..2_000 {
            let (a, b, pose) = pair(&mut random, 8);
            sum.push(run(&a.shape.unwrap(), &b.shape.unwrap(), &pose, 0.01, methods));
        }
        sum
    };
    for manifold in built() {
        let alone = work(manifold);
        let threads: Vec<_> = (0..4).map(|_| std::thread::spawn(move || work(manifold))).collect();
        for thread in threads {
            assert!(thread.join().unwrap() == alone);
        }
    }
}

/// Boxes put down with gaps of 1 mm, in a column and in a pyramid; the result is how far one of them has strayed.
fn stands(def: &WorldDef) -> Float {
    let mut world = World::try_new(def).unwrap();
    let ground = world.create_body(&BodyDef::fixed(vec3(0.0, -0.5, 0.0))).unwrap();
    world
        .create_shape(ground, &ShapeDef::default(), Shape::new_box(40.0, 1.0, 40.0), Pose::IDENTITY)
        .unwrap();
    let cube = Shape::new_box(1.0, 1.0, 1.0);
    let corners =
        (0..8).map(|i| vec3((i & 1) as Float - 0.5, (i >> 1 & 1) as Float - 0.5, (i >> 2) as Float - 0.5));
    let hull = Shape::hull(&corners.collect::<Vec<_>>()).unwrap();
    let mut places: Vec<Vec3> = (0..5).map(|i| vec3(-6.0, 0.501 + 1.001 * i as Float, 0.0)).collect();
    for row in 0..4 {
        for i in 0..4 - row {
            let x = i as Float * 1.05 + row as Float * 0.525;
            places.push(vec3(x, 0.501 + 1.001 * row as Float, 0.0));
        }
    }
    let ids: Vec<_> = places
        .iter()
        .enumerate()
        .map(|(i, p)| {
            let id = world.create_body(&BodyDef::dynamic(*p)).unwrap();
            let shape = if i % 2 == 0 { &cube } else { &hull };
            world.create_shape(id, &ShapeDef::default(), shape.clone(), Pose::IDENTITY).unwrap();
            id
        })
        .collect();
    (0..180).for_each(|_| world.try_step(1.0 / 60.0, 4).unwrap());
    let strayed = |(id, p): (_, &Vec3)| length(world.body(id).unwrap().transform().p - p);
    ids.into_iter().zip(&places).map(strayed).fold(0.0, Float::max)
}

#[test]
fn stacks_stand_whatever_finds_their_contacts() {
    for narrow_phase in NarrowPhaseKind::ALL {
        for manifold in built() {
            let strayed = stands(&WorldDef { narrow_phase, manifold, ..WorldDef::default() });
            assert!(strayed < 0.02, "{narrow_phase:?} {manifold:?}: {strayed}");
        }
    }
    for gjk in GjkKind::ALL {
        let def = WorldDef { narrow_phase: NarrowPhaseKind::GjkEpa, gjk, ..WorldDef::default() };
        let strayed = stands(&def);
        assert!(strayed < 0.02, "{gjk:?}: {strayed}");
    }
}

#[test]
fn a_kind_that_is_not_built_is_refused() {
    let def = WorldDef { manifold: ManifoldKind::Clipper2, ..WorldDef::default() };
    match def.validate() {
        Ok(()) => assert!(ManifoldKind::Clipper2.is_built()),
        Err(e) => {
            assert!(!ManifoldKind::Clipper2.is_built());
            assert_eq!(e.code(), merev::ErrorCode::Unsupported);
        }
    }
}
