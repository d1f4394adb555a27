//! Every operation in any order leaves a world whose parts agree, and the odd states that once did not.

mod common;

use common::{Random, random_body, random_world};
use merev::broad_phase::BroadPhaseKind;
use merev::math::vec3;
use merev::shape::MassData;
use merev::world::{Filter, MotionLocks, SurfaceMaterial};
use merev::{BodyDef, BodyId, BodyType, Float, Mat3, Pose, Shape, ShapeDef, ShapeId, Vec3, World, WorldDef};

const DT: Float = 1.0 / 60.0;

fn any_type(random: &mut Random) -> BodyType {
    [BodyType::Static, BodyType::Kinematic, BodyType::Dynamic, BodyType::Dynamic][random.below(4)]
}

/// A speed that is often 0, so that kinematic bodies stop and start.
fn any_velocity(random: &mut Random) -> Vec3 {
    [Vec3::zeros(), random.vec(1.0), random.vec(20.0)][random.below(3)]
}

fn change_body(world: &mut World, body: BodyId, random: &mut Random) {
    let mut b = world.body_mut(body).unwrap();
    match random.below(20) {
        0 => b.set_transform(&random.pose(5.0)).unwrap(),
        1 => b.set_linear_velocity(any_velocity(random)).unwrap(),
        2 => b.set_angular_velocity(any_velocity(random)).unwrap(),
        3 => b.set_target_transform(&random.pose(5.0), 0.5).unwrap(),
        4..=7 => b.set_awake(random.below(4) == 0),
        8 => b.disable(),
        9..=11 => b.enable(),
        12 | 13 => drop(b.set_type(any_type(random))),
        14 => {
            let mut lock = || random.below(3) == 0;
            let locks = MotionLocks { linear: [lock(), lock(), lock()], angular: [lock(), lock(), lock()] };
            b.set_motion_locks(locks);
        }
        15 => b.apply_linear_impulse(random.vec(50.0), random.vec(5.0), random.below(2) == 0).unwrap(),
        16 => b.apply_force(random.vec(500.0), random.vec(5.0), random.below(2) == 0).unwrap(),
        17 => {
            let mass = [0.0, 1.0][random.below(2)];
            let data = MassData { mass, center: random.vec(0.3), inertia: Mat3::identity() * mass };
            drop(b.set_mass_data(&data));
        }
        18 => b.set_gravity_scale([-1.0, 0.0, 1.0][random.below(3)]).unwrap(),
        _ => b.apply_mass_from_shapes(),
    }
}

fn change_shape(world: &mut World, shape: ShapeId, random: &mut Random) {
    let mut s = world.shape_mut(shape).unwrap();
    match random.below(6) {
        0 => s.set_filter(Filter { category_bits: 1 << random.below(4), ..Filter::default() }),
        1 => drop(s.set_shape(random.shape(), &random.pose(0.5), random.below(2) == 0)),
        2 => s.enable_contact_events(random.below(2) == 0),
        3 => s.enable_hit_events(random.below(2) == 0),
        4 => s.set_density([0.0, 10.0, 100.0][random.below(3)], random.below(2) == 0).unwrap(),
        _ => {
            let tangent_velocity = any_velocity(random);
            let (restitution, rolling_resistance) = (random.within(0.0, 1.0), random.within(0.0, 0.2));
            let material =
                SurfaceMaterial { tangent_velocity, restitution, rolling_resistance, ..Default::default() };
            s.set_material(&material).unwrap();
        }
    }
}

/// One operation.
fn act(world: &mut World, random: &mut Random) {
    let bodies: Vec<BodyId> = world.bodies().collect();
    let body = bodies[random.below(bodies.len())];
    let shapes: Vec<ShapeId> = world.body(body).unwrap().shapes().collect();
    match random.below(40) {
        0 if bodies.len() < 40 => drop(random_body(world, random)),
        1 if bodies.len() > 20 => world.destroy_body(body).unwrap(),
        2 if !shapes.is_empty() => {
            world.destroy_shape(shapes[random.below(shapes.len())], random.below(2) == 0).unwrap();
        }
        3 if shapes.len() < 3 => {
            let (shape, local) = (random.shape(), random.pose(0.5));
            world.create_shape(body, &ShapeDef::default(), shape, local).unwrap();
        }
        4..=9 if !shapes.is_empty() => change_shape(world, shapes[random.below(shapes.len())], random),
        10 => world.set_gravity(vec3(0.0, random.within(-20.0, 5.0), 0.0)).unwrap(),
        11 => world.enable_sleeping(random.below(4) != 0),
        12 => world.enable_warm_starting(random.below(4) != 0),
        13 => {
            let saved = world.save();
            world.try_step(DT, 2).unwrap();
            world.validate();
            world.restore(&saved).unwrap();
        }
        14..=20 => {
            let dt = [0.0, DT, DT, 0.1, 1e-3][random.below(5)];
            world.try_step(dt, 1 + random.below(6) as u32).unwrap();
            let live = |s| world.shape(s).is_ok();
            assert!(world.contact_begin_events().iter().all(|e| live(e.shape_a) && live(e.shape_b)));
            assert!(world.contact_hit_events().iter().all(|e| live(e.shape_a) && live(e.shape_b)));
        }
        _ => change_body(world, body, random),
    }
}

#[test]
fn any_sequence_of_operations_leaves_a_consistent_world() {
    for seed in 0..100 {
        let kind = BroadPhaseKind::ALL[seed as usize % BroadPhaseKind::ALL.len()];
        let (mut world, _) = random_world(kind, seed, 30);
        let mut random = Random(seed + 1000);
        for step in 0..1500 {
            act(&mut world, &mut random);
            world.validate();
            if step % 300 == 299 {
                // Time enough to fall asleep.
                world.set_gravity(vec3(0.0, -10.0, 0.0)).unwrap();
                for _ in 0..60 {
                    world.try_step(DT, 4).unwrap();
                    world.validate();
                }
            }
        }
        assert_eq!(world.step_report().quarantined, 0);
    }
}

fn with_box(world: &mut World, body_type: BodyType, y: Float) -> BodyId {
    let def = BodyDef { body_type, position: vec3(0.0, y, 0.0), ..BodyDef::default() };
    world.create_body_with_shape(&def, &ShapeDef::default(), Shape::new_box(1.0, 1.0, 1.0)).unwrap().0
}

#[test]
fn a_body_on_a_moving_kinematic_one_is_not_put_to_sleep() {
    let mut world = World::try_new(&WorldDef::default()).unwrap();
    let lift = with_box(&mut world, BodyType::Kinematic, 0.0);
    let load = with_box(&mut world, BodyType::Dynamic, 1.0);
    world.body_mut(lift).unwrap().set_linear_velocity(vec3(0.0, 0.5, 0.0)).unwrap();
    for _ in 0..10 {
        world.try_step(DT, 4).unwrap();
        world.body_mut(load).unwrap().set_awake(false);
        world.validate();
    }
    assert!(world.body(load).unwrap().is_awake());
    assert!(world.body(load).unwrap().transform().p.y > 1.05);
    // On one that stands still it is.
    world.body_mut(lift).unwrap().set_linear_velocity(Vec3::zeros()).unwrap();
    world.body_mut(load).unwrap().set_awake(false);
    assert!(!world.body(load).unwrap().is_awake());
    world.try_step(DT, 4).unwrap();
    world.body_mut(lift).unwrap().set_linear_velocity(vec3(0.0, 0.5, 0.0)).unwrap();
    assert!(world.body(load).unwrap().is_awake());
    world.validate();
}

#[test]
fn lengths_of_steps_from_one_extreme_to_the_other_break_nothing() {
    let mut world = World::try_new(&WorldDef::default()).unwrap();
    with_box(&mut world, BodyType::Static, 0.0);
    let a = with_box(&mut world, BodyType::Dynamic, 0.99);
    with_box(&mut world, BodyType::Dynamic, 1.98);
    assert!(world.try_step(Float::MIN_POSITIVE * 1e-3, 4).is_err(), "1/h is infinite");
    for dt in [DT, 1e-30, DT, 1e-10, 1e-20, DT, 0.0, DT, Float::MIN_POSITIVE * 16.0, DT] {
        world.try_step(dt, 4).unwrap();
        world.validate();
    }
    for _ in 0..120 {
        world.try_step(DT, 4).unwrap();
    }
    assert_eq!(world.step_report().quarantined, 0);
    assert!((world.body(a).unwrap().transform().p.y - 1.0).abs() < 0.02);
    for dt in [1e3, 1e10, 1e30, Float::MAX, DT] {
        world.try_step(dt, 4).unwrap();
        world.validate();
    }
}

#[test]
fn a_kinematic_body_that_flies_out_of_all_numbers_is_quarantined_where_it_was() {
    let mut world = World::try_new(&WorldDef::default()).unwrap();
    let fly = with_box(&mut world, BodyType::Kinematic, 7.0);
    world.body_mut(fly).unwrap().set_linear_velocity(vec3(1e9, 0.0, 0.0)).unwrap();
    world.try_step(Float::MAX / 2.0, 4).unwrap();
    world.validate();
    let body = world.body(fly).unwrap();
    assert!(body.is_quarantined() && body.transform() == Pose::translation(vec3(0.0, 7.0, 0.0)));
}

#[test]
fn impulses_that_would_leave_the_range_of_numbers_are_refused() {
    let mut world = World::try_new(&WorldDef::default()).unwrap();
    let body = with_box(&mut world, BodyType::Dynamic, 0.0);
    let most = vec3(0.0, Float::MAX, 0.0);
    let mut b = world.body_mut(body).unwrap();
    b.apply_linear_impulse_to_center(most, true).unwrap();
    assert!(b.apply_linear_impulse_to_center(most, true).is_err());
    assert!(b.apply_linear_impulse(most, vec3(9.0, 0.0, 0.0), true).is_err());
    assert_eq!(b.as_ref().momentum(), most);
}

#[test]
fn a_conveyor_that_starts_wakes_what_lies_on_it() {
    let mut world = World::try_new(&WorldDef::default()).unwrap();
    let belt = with_box(&mut world, BodyType::Static, 0.0);
    let parcel = with_box(&mut world, BodyType::Dynamic, 1.0);
    for _ in 0..90 {
        world.try_step(DT, 4).unwrap();
    }
    assert!(!world.body(parcel).unwrap().is_awake());
    let shape = world.body(belt).unwrap().shapes().next().unwrap();
    let material = SurfaceMaterial { tangent_velocity: vec3(0.3, 0.0, 0.0), ..SurfaceMaterial::default() };
    world.shape_mut(shape).unwrap().set_material(&material).unwrap();
    for _ in 0..30 {
        world.try_step(DT, 4).unwrap();
    }
    assert!(world.body(parcel).unwrap().linear_velocity().x > 0.2);
}

#[test]
fn masses_beyond_the_range_of_numbers_count_as_none() {
    for density in [Float::MIN_POSITIVE * 1e-3, Float::MIN_POSITIVE, Float::MAX] {
        let mut world = World::try_new(&WorldDef::default()).unwrap();
        let def = ShapeDef { density, ..ShapeDef::default() };
        let body = BodyDef::dynamic(vec3(0.0, 2.0, 0.0));
        let (body, _) = world.create_body_with_shape(&body, &def, Shape::new_box(0.3, 3.0, 3.0)).unwrap();
        with_box(&mut world, BodyType::Static, 0.0);
        for _ in 0..20 {
            world.try_step(DT, 4).unwrap();
            world.validate();
        }
        assert!(!world.body(body).unwrap().is_quarantined(), "{density}");
    }
}

#[test]
fn friction_beyond_the_range_of_numbers_holds() {
    let mut world = World::try_new(&WorldDef::default()).unwrap();
    let floor = with_box(&mut world, BodyType::Static, 0.0);
    let body = with_box(&mut world, BodyType::Dynamic, 1.0);
    for (body, friction) in [(floor, Float::MAX), (body, 1e30)] {
        let shape = world.body(body).unwrap().shapes().next().unwrap();
        let material =
            SurfaceMaterial { friction, rolling_resistance: Float::MAX, ..SurfaceMaterial::default() };
        world.shape_mut(shape).unwrap().set_material(&material).unwrap();
    }
    // Within the margin, but not pressed.
    world.set_gravity(Vec3::zeros()).unwrap();
    let shape = world.body(body).unwrap().shapes().next().unwrap();
    world.shape_mut(shape).unwrap().set_shape(Shape::new_sphere(4.0), &Pose::IDENTITY, true).unwrap();
    let mut b = world.body_mut(body).unwrap();
    b.set_transform(&Pose::translation(vec3(0.0, 4.502, 0.0))).unwrap();
    b.set_linear_velocity(vec3(0.5, 0.0, 0.0)).unwrap();
    for _ in 0..60 {
        world.try_step(DT, 4).unwrap();
    }
    assert_eq!(world.step_report().quarantined, 0);
}

#[test]
fn a_target_that_takes_too_fast_a_turn_changes_nothing() {
    let mut world = World::try_new(&WorldDef::default()).unwrap();
    let body = with_box(&mut world, BodyType::Kinematic, 0.0);
    let target = Pose::new(vec3(1e-2, 0.0, 0.0), merev::math::quat_about(vec3(0.0, 1.0, 0.0), 2.0));
    assert!(world.body_mut(body).unwrap().set_target_transform(&target, 1e-9).is_err());
    assert_eq!(world.body(body).unwrap().linear_velocity(), Vec3::zeros());
}

#[test]
fn end_events_of_a_step_are_sorted() {
    let mut world = World::try_new(&WorldDef { gravity: Vec3::zeros(), ..WorldDef::default() }).unwrap();
    let mut bodies = Vec::new();
    for k in 0..20 {
        for y in [0.0, 0.99] {
            let position = vec3(3.0 * k as Float, y, 0.0);
            let def = BodyDef { body_type: BodyType::Dynamic, position, ..BodyDef::default() };
            let shape = Shape::new_box(1.0, 1.0, 1.0);
            bodies.push(world.create_body_with_shape(&def, &ShapeDef::default(), shape).unwrap().0);
        }
    }
    world.try_step(DT, 4).unwrap();
    world.try_step(DT, 4).unwrap();
    // Half of the lower ones fall asleep and wake again, which stirs the list of awake contacts.
    for k in (0..40).step_by(6) {
        world.body_mut(bodies[k]).unwrap().set_awake(false);
    }
    for &body in bodies.iter().rev().step_by(2) {
        world.body_mut(body).unwrap().set_awake(true);
        let mut there = world.body(body).unwrap().transform();
        // A visible gap, but their boxes still meet.
        there.p.y += 0.03;
        world.body_mut(body).unwrap().set_transform(&there).unwrap();
    }
    world.try_step(DT, 4).unwrap();
    let slots: Vec<u32> = world.contact_end_events().iter().map(|e| e.contact.index1).collect();
    assert!(slots.len() >= 20 && slots.is_sorted(), "{slots:?}");
}
