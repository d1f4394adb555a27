//! Queries of a world against plain loops over all its shapes.

mod common;

use common::{Random, random_world};
use merev::broad_phase::BroadPhaseKind;
use merev::math::{tolerance::MAX_COORDINATE, vec3};
use merev::narrow_phase::Proxy;
use merev::world::{BodyDef, BodyType, ColliderRef, QueryFilter, ShapeDef, ShapeHit, WorldDef};
use merev::{Aabb, BodyId, ErrorCode, Float, Pose, Shape, ShapeId, Vec3, World};

const ALL: QueryFilter = QueryFilter { category_bits: u64::MAX, mask_bits: u64::MAX };

/// The shapes a query should see, by slot.
fn visible(world: &World, filter: QueryFilter) -> Vec<ColliderRef<'_>> {
    let bodies = world.bodies().map(|b| world.body(b).unwrap()).filter(|b| b.is_enabled());
    let mut shapes: Vec<_> = bodies.flat_map(|b| b.shapes()).map(|s| world.shape(s).unwrap()).collect();
    shapes.retain(|s| filter.sees(&s.filter()));
    shapes.sort_by_key(|s| s.id().index1);
    shapes
}

fn sorted(mut hits: Vec<ShapeHit>) -> Vec<ShapeHit> {
    hits.sort_by(|a, b| (a.fraction, a.shape.index1).partial_cmp(&(b.fraction, b.shape.index1)).unwrap());
    hits
}

/// Asks one world many random questions, compares the answers with those of loops, and returns them.
fn interrogate(world: &World, seed: u64) -> (Vec<ShapeHit>, Vec<ShapeId>) {
    let mut random = Random(seed);
    let (mut hits, mut overlaps) = (Vec::new(), Vec::new());
    for k in 0..60 {
        let filter = QueryFilter { mask_bits: if k % 3 == 0 { 0b0101 } else { u64::MAX }, ..ALL };
        let shapes = visible(world, filter);
        let (origin, translation) = (random.vec(9.0), random.vec(12.0));

        let all = world.cast_ray_all(origin, translation, filter).unwrap();
        let plain = shapes.iter().filter_map(|s| s.ray_cast(origin, translation).unwrap()).collect();
        assert_eq!(all, sorted(plain));
        let closest = world.cast_ray_closest(origin, translation, filter).unwrap();
        assert_eq!(closest, all.iter().find(|h| h.normal != Vec3::zeros()).copied());
        hits.extend(all);

        let points: Vec<Vec3> = (0..1 + random.below(5)).map(|_| random.vec(0.8)).collect();
        let solid = Proxy::new(&points, random.within(0.0, 0.5)).unwrap();
        let way = if k % 5 == 0 { Vec3::zeros() } else { translation };
        let all = world.cast_shape_all(&solid, origin, way, filter).unwrap();
        let plain = shapes.iter().filter_map(|s| s.shape_cast(&solid, origin, way).unwrap()).collect();
        assert_eq!(all, sorted(plain));
        assert_eq!(world.cast_shape_closest(&solid, origin, way, filter).unwrap(), all.first().copied());

        let touching = world.overlap_shape_all(&solid, origin, filter).unwrap();
        let plain = shapes.iter().filter(|s| s.overlap_shape(&solid, origin).unwrap());
        assert_eq!(touching, plain.map(|s| s.id()).collect::<Vec<_>>());
        if way == Vec3::zeros() {
            assert!(all.iter().all(|h| h.fraction == 0.0 && touching.contains(&h.shape)));
        }
        hits.extend(all);
        overlaps.extend(touching);

        let half = random.vec(2.0).map(Float::abs);
        let aabb = Aabb::around(origin, half);
        let inside = world.overlap_aabb_all(&aabb, filter).unwrap();
        let plain = shapes.iter().filter(|s| s.aabb().overlaps(&aabb));
        assert_eq!(inside, plain.map(|s| s.id()).collect::<Vec<_>>());
        overlaps.extend(inside);
    }
    (hits, overlaps)
}

#[test]
fn answers_are_those_of_plain_loops_over_all_broad_phases_at_rest_in_motion_and_after_teleports() {
    for seed in 0..6 {
        let mut found = 0;
        let answers = BroadPhaseKind::ALL.map(|kind| {
            let (mut world, bodies) = random_world(kind, seed, 60);
            let mut random = Random(seed ^ 77);
            let mut all = vec![interrogate(&world, seed)];
            for step in 0..40 {
                world.try_step(1.0 / 60.0, 4).unwrap();
                if step % 8 < 2 {
                    all.push(interrogate(&world, seed + step));
                }
                if step % 10 == 9 {
                    let body = bodies[random.below(bodies.len())];
                    world.body_mut(body).unwrap().set_transform(&random.pose(6.0)).unwrap();
                    all.push(interrogate(&world, seed + step));
                }
            }
            found += all.iter().map(|(h, o)| h.len() + o.len()).sum::<usize>();
            all
        });
        assert!(answers.windows(2).all(|pair| pair[0] == pair[1]), "seed {seed}");
        assert!(found > 2000, "the questions are of some interest: {found}");
    }
}

#[test]
fn what_a_step_moved_out_of_its_box_is_found_where_it_is() {
    for kind in BroadPhaseKind::ALL {
        let def = WorldDef { broad_phase: kind, gravity: Vec3::zeros(), ..WorldDef::default() };
        let mut world = World::try_new(&def).unwrap();
        // 10 m in one step, a hundred times the ball's size.
        let body = BodyDef { linear_velocity: vec3(600.0, 0.0, 0.0), ..BodyDef::dynamic(Vec3::zeros()) };
        let (ball, shape) =
            world.create_body_with_shape(&body, &ShapeDef::default(), Shape::new_sphere(0.1)).unwrap();
        world.try_step(1.0 / 60.0, 4).unwrap();
        let x = world.body(ball).unwrap().transform().p;
        assert!((x.x - 10.0).abs() < 1e-3);
        let hit = world.cast_ray_closest(x + vec3(0.0, 1.0, 0.0), vec3(0.0, -2.0, 0.0), ALL).unwrap();
        assert_eq!(hit.unwrap().shape, shape);
        let at = Aabb::around(x, vec3(0.01, 0.01, 0.01));
        assert_eq!(world.overlap_aabb_all(&at, ALL).unwrap(), [shape]);
        let before = Aabb::around(Vec3::zeros(), vec3(0.01, 0.01, 0.01));
        assert!(world.overlap_aabb_all(&before, ALL).unwrap().is_empty());
    }
}

/// Three balls of diameter 1 inside one of 6 and a box beyond, along x.
fn nested() -> (World, Vec<ShapeId>) {
    let mut world = World::try_new(&WorldDef::default()).unwrap();
    let mut add = |x: Float, shape: Shape, material: u64| {
        let mut def = ShapeDef::default();
        def.material.user_material_id = material;
        world.create_body_with_shape(&BodyDef::fixed(vec3(x, 0.0, 0.0)), &def, shape).unwrap().1
    };
    let shapes = vec![
        add(0.0, Shape::new_sphere(6.0), 10),
        add(1.0, Shape::new_sphere(1.0), 11),
        add(2.0, Shape::new_sphere(1.0), 12),
        add(2.0, Shape::new_sphere(1.0), 13),
        add(8.0, Shape::new_box(2.0, 2.0, 2.0), 14),
    ];
    (world, shapes)
}

#[test]
fn a_ray_from_within_sees_what_is_inside_and_beyond() {
    let (world, s) = nested();
    let (origin, way) = (Vec3::zeros(), vec3(10.0, 0.0, 0.0));
    let all = world.cast_ray_all(origin, way, ALL).unwrap();
    assert_eq!(all.iter().map(|h| h.shape).collect::<Vec<_>>(), s, "nearest first, equals by slot");
    assert_eq!((all[0].fraction, all[0].normal), (0.0, Vec3::zeros()));
    let hit = world.cast_ray_closest(origin, way, ALL).unwrap().unwrap();
    assert_eq!((hit.shape, hit.user_material_id), (s[1], 11));
    assert!((hit.fraction - 0.05).abs() < 1e-6 && (hit.point - vec3(0.5, 0.0, 0.0)).amax() < 1e-6);
    assert!((hit.normal - vec3(-1.0, 0.0, 0.0)).amax() < 1e-6);
}

#[test]
fn a_callback_ignores_stops_clips_and_goes_on() {
    let (world, s) = nested();
    let seen = |answer: &dyn Fn(&ShapeHit) -> Float| {
        let mut seen = Vec::new();
        let mut note = |hit: &ShapeHit| {
            seen.push(hit.shape);
            answer(hit)
        };
        world.cast_ray(Vec3::zeros(), vec3(10.0, 0.0, 0.0), ALL, &mut note).unwrap();
        seen
    };
    assert_eq!(seen(&|_| 1.0), s);
    assert_eq!(seen(&|_| -1.0), s);
    assert_eq!(seen(&|_| 0.0), s[..1]);
    assert_eq!(seen(&|_| 0.1), s[..2], "nothing beyond 1 m");
    // To clip at each hit is to see the nearest ones: both of the equal ones after the first two were ignored.
    let [first, second] = [s[0], s[1]];
    let clip = |h: &ShapeHit| if h.shape == first || h.shape == second { -1.0 } else { h.fraction };
    assert_eq!(seen(&clip), s[..4]);

    let ball = [Vec3::zeros()];
    let mut count = 0;
    let solid = Proxy::new(&ball, 0.1).unwrap();
    let mut stop = |_: &ShapeHit| {
        count += 1;
        0.0
    };
    world.cast_shape(&solid, Vec3::zeros(), vec3(10.0, 0.0, 0.0), ALL, &mut stop).unwrap();
    let mut first = None;
    let mut keep = |shape| {
        first = Some(shape);
        false
    };
    world.overlap_shape(&solid, vec3(2.0, 0.0, 0.0), ALL, &mut keep).unwrap();
    assert_eq!((count, first), (1, Some(s[0])));
    let around = Aabb::around(vec3(2.0, 0.0, 0.0), vec3(0.1, 0.1, 0.1));
    let mut list = Vec::new();
    let mut two = |shape| {
        list.push(shape);
        list.len() < 2
    };
    world.overlap_aabb(&around, ALL, &mut two).unwrap();
    assert_eq!(list, [s[0], s[2]]);
}

#[test]
fn filters_work_both_ways() {
    let mut world = World::try_new(&WorldDef::default()).unwrap();
    let mut def = ShapeDef::default();
    (def.filter.category_bits, def.filter.mask_bits) = (0b10, 0b100);
    world.create_body_with_shape(&BodyDef::default(), &def, Shape::new_box(1.0, 1.0, 1.0)).unwrap();
    let hits = |category_bits, mask_bits| {
        let filter = QueryFilter { category_bits, mask_bits };
        let ray = world.cast_ray_all(vec3(-2.0, 0.0, 0.0), vec3(4.0, 0.0, 0.0), filter).unwrap();
        let near = Aabb::around(Vec3::zeros(), vec3(1.0, 1.0, 1.0));
        assert_eq!(ray.len(), world.overlap_aabb_all(&near, filter).unwrap().len());
        ray.len()
    };
    assert_eq!(hits(0b100, 0b10), 1);
    assert_eq!(hits(0b100, 0b01), 0, "the query does not want it");
    assert_eq!(hits(0b001, 0b10), 0, "it does not want the query");
}

#[test]
fn disabled_bodies_are_not_seen_and_sleeping_ones_are() {
    let mut world = World::try_new(&WorldDef::default()).unwrap();
    let (ball, shape) = world
        .create_body_with_shape(
            &BodyDef::dynamic(Vec3::zeros()),
            &ShapeDef::default(),
            Shape::new_sphere(1.0),
        )
        .unwrap();
    let seen = |world: &World| {
        let hit = world.cast_ray_closest(vec3(-2.0, 0.0, 0.0), vec3(4.0, 0.0, 0.0), ALL).unwrap();
        hit.map(|h| h.shape)
    };
    world.body_mut(ball).unwrap().set_awake(false);
    assert!(!world.body(ball).unwrap().is_awake());
    assert_eq!(seen(&world), Some(shape));
    world.body_mut(ball).unwrap().disable();
    assert_eq!(seen(&world), None);
    world.body_mut(ball).unwrap().enable();
    assert_eq!(seen(&world), Some(shape));
    world.body_mut(ball).unwrap().set_type(BodyType::Static).unwrap();
    assert_eq!(seen(&world), Some(shape));
    world.destroy_body(ball).unwrap();
    assert_eq!(seen(&world), None);
}

#[test]
fn a_body_is_asked_as_if_it_were_elsewhere() {
    let mut world = World::try_new(&WorldDef::default()).unwrap();
    let body = world.create_body(&BodyDef::dynamic(vec3(5.0, 0.0, 0.0))).unwrap();
    let mut add = |x: Float| {
        let local = Pose::translation(vec3(x, 0.0, 0.0));
        world.create_shape(body, &ShapeDef::default(), Shape::new_sphere(1.0), local).unwrap()
    };
    let (near, far) = (add(-1.0), add(1.0));
    let body = world.body(body).unwrap();
    let (here, origin) = (body.transform(), Pose::IDENTITY);
    let ray = |at: &Pose, max| body.ray_cast(Vec3::zeros(), vec3(10.0, 0.0, 0.0), ALL, max, at).unwrap();
    let hit = ray(&here, 1.0).unwrap();
    assert_eq!(hit.shape, near);
    assert!((hit.fraction - 0.35).abs() < 1e-6);
    assert_eq!(ray(&here, 0.34), None);
    assert_eq!(ray(&origin, 1.0).unwrap().shape, far);

    let points = [Vec3::zeros()];
    let ball = Proxy::new(&points, 0.25).unwrap();
    let cast =
        |at: &Pose, max| body.shape_cast(&ball, Vec3::zeros(), vec3(10.0, 0.0, 0.0), ALL, max, at).unwrap();
    assert!((cast(&here, 1.0).unwrap().fraction - 0.325).abs() < 1e-6);
    assert_eq!(cast(&here, 0.3), None);
    assert!(body.overlap_shape(&ball, vec3(4.0, 0.0, 0.0), ALL, &here).unwrap());
    assert!(!body.overlap_shape(&ball, vec3(4.0, 0.0, 0.0), ALL, &origin).unwrap());
    let nobody = QueryFilter { mask_bits: 0, ..ALL };
    assert!(!body.overlap_shape(&ball, vec3(4.0, 0.0, 0.0), nobody, &here).unwrap());
}

#[test]
fn bad_questions_are_refused_with_a_sentence() {
    fn refused<T: std::fmt::Debug>(answer: merev::Result<T>, code: ErrorCode) {
        let error = answer.expect_err("it should be refused");
        assert_eq!(error.code(), code);
        assert!(error.sentence().ends_with('.'));
    }
    use ErrorCode::{NotFinite, Range};
    let (world, shapes) = nested();
    let (nan, far) = (vec3(0.0, Float::NAN, 0.0), vec3(2.0 * MAX_COORDINATE, 0.0, 0.0));
    let (zero, x, none) = (Vec3::zeros(), Vec3::x(), &mut |_: &ShapeHit| 1.0);
    let points = [zero];
    let solid = Proxy::new(&points, 1.0).unwrap();
    for (bad, code) in [(nan, NotFinite), (vec3(Float::INFINITY, 0.0, 0.0), NotFinite), (far, Range)] {
        for (o, d) in [(bad, x), (zero, bad)] {
            refused(world.cast_ray_closest(o, d, ALL), code);
            refused(world.cast_ray(o, d, ALL, none), code);
            refused(world.cast_ray_all(o, d, ALL), code);
            refused(world.cast_shape_closest(&solid, o, d, ALL), code);
            refused(world.cast_shape(&solid, o, d, ALL, none), code);
            refused(world.cast_shape_all(&solid, o, d, ALL), code);
            let shape = world.shape(shapes[0]).unwrap();
            refused(shape.ray_cast(o, d), code);
            refused(shape.shape_cast(&solid, o, d), code);
            let body = world.body(shape.body()).unwrap();
            refused(body.ray_cast(o, d, ALL, 1.0, &Pose::IDENTITY), code);
            refused(body.shape_cast(&solid, o, d, ALL, 1.0, &Pose::IDENTITY), code);
        }
        refused(world.overlap_shape_all(&solid, bad, ALL), code);
        refused(world.overlap_shape(&solid, bad, ALL, &mut |_| true), code);
        refused(world.overlap_aabb_all(&Aabb { lower: -x, upper: bad }, ALL), code);
        refused(world.overlap_aabb(&Aabb { lower: -bad, upper: x }, ALL, &mut |_| true), code);
        refused(world.shape(shapes[0]).unwrap().overlap_shape(&solid, bad), code);
        refused(Proxy::new(&[bad], 0.0), code);
    }
    let body: BodyId = world.shape(shapes[0]).unwrap().body();
    let body = world.body(body).unwrap();
    refused(body.ray_cast(zero, x, ALL, 1.5, &Pose::IDENTITY), Range);
    refused(body.ray_cast(zero, x, ALL, Float::NAN, &Pose::IDENTITY), NotFinite);
    refused(body.shape_cast(&solid, zero, x, ALL, -0.1, &Pose::IDENTITY), Range);
    refused(body.overlap_shape(&solid, zero, ALL, &Pose::translation(nan)), NotFinite);
    refused(world.overlap_aabb_all(&Aabb { lower: x, upper: -x }, ALL), Range);
    refused(Proxy::new(&[], 0.0), Range);
    refused(Proxy::new(&[zero; 65], 0.0), Range);
    refused(Proxy::new(&points, -1.0), Range);
    refused(Proxy::new(&points, Float::NAN), NotFinite);
    refused(Proxy::new(&points, 2.0 * MAX_COORDINATE), Range);
}

#[test]
fn a_ray_meets_what_a_moving_point_meets() {
    let mut random = Random(5);
    let mut world = World::try_new(&WorldDef::default()).unwrap();
    let mut hits = 0;
    for k in 0..2000 {
        let def = BodyDef { rotation: random.rotation(), ..BodyDef::fixed(random.vec(1.0)) };
        let (body, shape) = world.create_body_with_shape(&def, &ShapeDef::default(), random.shape()).unwrap();
        let shape = world.shape(shape).unwrap();
        // Every other ray is aimed at the shape, or straight away from it.
        let origin = random.vec(3.0);
        let aimed = (shape.aabb().center() - origin) * random.within(-2.0, 2.0);
        let way = if k % 2 == 0 { aimed } else { random.vec(6.0) };
        let points = [Vec3::zeros()];
        let ray = shape.ray_cast(origin, way).unwrap();
        let point = shape.shape_cast(&Proxy::new(&points, 0.0).unwrap(), origin, way).unwrap();
        match (ray, point) {
            (Some(r), Some(p)) => {
                assert!((r.fraction - p.fraction).abs() < 1e-4, "{:?}: {r:?} {p:?}", shape.shape());
                assert_eq!(r.normal == Vec3::zeros(), p.normal == Vec3::zeros());
                assert!(r.normal == Vec3::zeros() || (r.point - p.point).amax() < 1e-4);
                hits += 1;
            }
            (None, None) => {}
            // What grazes may be met by either; a wider point then tells.
            _ => {
                let wide = Proxy::new(&points, 1e-4).unwrap();
                let near = shape.shape_cast(&wide, origin, way).unwrap();
                assert!(ray.is_none() || near.is_some(), "{:?} {ray:?} {point:?}", shape.shape());
            }
        }
        world.destroy_body(body).unwrap();
    }
    assert!(hits > 300);
}
