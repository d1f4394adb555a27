//! A world with an accuracy to keep: islands get the sub-steps that they need, and no more.

mod common;

use common::{Random, random_body};
use merev::constraint::joint::{JointKind, RevoluteJoint, SphericalJoint};
use merev::math::{length, vec3};
use merev::shape::MassData;
use merev::solver::{Lanes, SolverKind};
use merev::world::{BodyDef, JointDef, ShapeDef, WorldDef};
use merev::{BodyId, ErrorCode, Float, Mat3, Pose, Shape, Vec3, World};

const DT: Float = 1.0 / 60.0;

fn world(accuracy: Float) -> World {
    World::try_new(&WorldDef { accuracy, enable_sleep: false, ..WorldDef::default() }).unwrap()
}

fn floor(world: &mut World, at: Float) -> BodyId {
    let floor = BodyDef::fixed(vec3(at, -0.5, 0.0));
    world.create_body_with_shape(&floor, &ShapeDef::default(), Shape::new_box(10.0, 1.0, 10.0)).unwrap().0
}

/// Cubes of 1 kg on each other, at rest.
fn stack(world: &mut World, count: usize, at: Float) -> Vec<BodyId> {
    floor(world, at);
    (0..count)
        .map(|k| {
            let body = BodyDef::dynamic(vec3(at, 0.5 + k as Float, 0.0));
            let surface = ShapeDef { density: 1.0, ..ShapeDef::default() };
            world.create_body_with_shape(&body, &surface, Shape::new_box(1.0, 1.0, 1.0)).unwrap().0
        })
        .collect()
}

/// A chain of rods of half a metre that starts level, and swings fast.
fn chain(world: &mut World, links: usize) -> Vec<BodyId> {
    let mut last = world.create_body(&BodyDef::fixed(vec3(0.0, 30.0, 0.0))).unwrap();
    (0..links)
        .map(|k| {
            let body = BodyDef::dynamic(vec3(0.25 + 0.5 * k as Float, 30.0, 0.0));
            let id = world.create_body(&body).unwrap();
            let inertia = Mat3::from_diagonal(&vec3(0.001, 0.02, 0.02));
            let data = MassData { mass: 1.0, center: Vec3::zeros(), inertia };
            world.body_mut(id).unwrap().set_mass_data(&data).unwrap();
            let start = if k == 0 { Vec3::zeros() } else { vec3(0.25, 0.0, 0.0) };
            let frames = [Pose::translation(start), Pose::translation(vec3(-0.25, 0.0, 0.0))];
            let kind = JointKind::Spherical(SphericalJoint::default());
            world.create_joint(&JointDef::new(kind, last, id).frames(frames[0], frames[1])).unwrap();
            last = id;
            id
        })
        .collect()
}

fn run(world: &mut World, steps: usize, sub_steps: u32) {
    (0..steps).for_each(|_| world.try_step(DT, sub_steps).unwrap());
}

fn place(world: &World, id: BodyId) -> Vec3 {
    world.body(id).unwrap().world_center()
}

/// The end of a swinging chain, which goes some 5 m in a second, comes the nearer to where many sub-steps take it, the
/// smaller the error that is allowed, and the stack beside it stays with the sub-steps it has.
#[test]
fn who_asks_for_less_error_gets_it_where_it_is_to_be_had() {
    let mut exact = world(0.0);
    let reference = chain(&mut exact, 3);
    run(&mut exact, 60, 400);
    let mut errors = Vec::new();
    for accuracy in [0.0, 1e-2, 3e-4, 1e-4] {
        let mut w = world(accuracy);
        let rods = chain(&mut w, 3);
        let cubes = stack(&mut w, 5, 50.0);
        let mut most = 0;
        for _ in 0..60 {
            run(&mut w, 1, 2);
            most = most.max(w.step_report().most_sub_steps);
            assert_eq!(w.body(cubes[4]).unwrap().sub_steps(), 2);
        }
        let error = length(place(&w, rods[2]) - place(&exact, reference[2]));
        println!(
            "accuracy {accuracy:e}: {error:.1e} m, up to {most} sub-steps, by itself {:.1e}",
            w.step_report().error
        );
        assert_eq!(w.body(rods[0]).unwrap().sub_steps(), w.body(rods[2]).unwrap().sub_steps());
        assert!(accuracy == 0.0 || error < 5.0 * accuracy);
        errors.push((error, most));
    }
    assert_eq!(errors[0].1, 2);
    assert!(errors.windows(2).all(|pair| pair[0].1 <= pair[1].1), "{errors:?}");
    assert!(errors[2].1 > 2 && errors[3].1 >= 8 && errors[3].0 < 0.15 * errors[0].0, "{errors:?}");
}

/// What flies freely without turning, what rests, and what more sub-steps do not help gets no more of them.
#[test]
fn what_needs_no_more_gets_no_more() {
    let mut w = world(1e-4);
    let cubes = stack(&mut w, 10, 0.0);
    let ball = BodyDef { linear_velocity: vec3(5.0, 5.0, 0.0), ..BodyDef::dynamic(vec3(0.0, 50.0, 0.0)) };
    let ball = w.create_body_with_shape(&ball, &ShapeDef::default(), Shape::new_sphere(0.5)).unwrap().0;
    for _ in 0..120 {
        run(&mut w, 1, 4);
        assert_eq!(w.step_report().most_sub_steps, 4);
    }
    for id in [ball, cubes[0]] {
        assert_eq!(w.body(id).unwrap().sub_steps(), 4);
    }
}

/// Impulses mean the same in islands of every level: a stack that a chain falls on, and shares its sub-steps with,
/// stays as it was; so it does when the accuracy is given up.
#[test]
fn islands_of_different_levels_become_one() {
    let mut w = world(1e-6);
    let cubes = stack(&mut w, 4, 0.0);
    let hinge = JointKind::Revolute(RevoluteJoint::default());
    let (post, arm) = (BodyDef::fixed(vec3(2.0, 4.2, 0.0)), BodyDef::dynamic(vec3(1.0, 5.932, 0.0)));
    let post = w.create_body(&post).unwrap();
    let light = ShapeDef { density: 1.0, ..ShapeDef::default() };
    let arm = w.create_body_with_shape(&arm, &light, Shape::new_sphere(0.2)).unwrap().0;
    let frames = [Pose::IDENTITY, Pose::translation(vec3(1.0, -1.732, 0.0))];
    w.create_joint(&JointDef::new(hinge, post, arm).frames(frames[0], frames[1])).unwrap();
    let (mut before, mut most) = (0, 0);
    for step in 0..240 {
        let apart = w.body(arm).unwrap().sub_steps() != w.body(cubes[0]).unwrap().sub_steps();
        before += usize::from(apart);
        run(&mut w, 1, 2);
        most = most.max(w.body(cubes[0]).unwrap().sub_steps());
        if step == 200 {
            w.set_accuracy(0.0).unwrap();
            assert_eq!(w.body(cubes[0]).unwrap().sub_steps(), 2);
        }
        let top = place(&w, cubes[3]);
        assert!((top - vec3(0.0, 3.5, 0.0)).norm() < 0.02, "step {step}: {top:?}");
    }
    assert!(before > 0 && most > 2, "they never differed: {before}, or never met: {most}");
}

/// Momentum and angular momentum of things that collide far from anything else stay, whatever their levels.
#[test]
fn an_isolated_heap_keeps_its_momentum() {
    let def = WorldDef { gravity: Vec3::zeros(), accuracy: 1e-3, enable_sleep: false, ..WorldDef::default() };
    let mut w = World::try_new(&def).unwrap();
    let mut random = Random(5);
    for _ in 0..40 {
        let place = random.vec(2.5);
        let body = BodyDef {
            linear_velocity: -place * 0.5,
            angular_velocity: random.vec(3.0),
            rotation: random.rotation(),
            ..BodyDef::dynamic(place)
        };
        let shape = Shape::new_box(0.5, 0.8, 0.6);
        w.create_body_with_shape(&body, &ShapeDef::default(), shape).unwrap();
    }
    run(&mut w, 1, 2);
    let start = w.step_report();
    let (mut most, mut size) = (0, 0.0_f64);
    for _ in 0..120 {
        run(&mut w, 1, 2);
        most = most.max(w.step_report().most_sub_steps);
    }
    let end = w.step_report();
    for k in 0..3 {
        size = size.max(start.angular_momentum[k].abs());
        let change = (end.linear_momentum[k] - start.linear_momentum[k]).abs();
        assert!(change < if size_of::<Float>() == 4 { 0.2 } else { 1e-8 }, "{change} of some 9600");
    }
    for k in 0..3 {
        let change = (end.angular_momentum[k] - start.angular_momentum[k]).abs() / size;
        assert!(change < if size_of::<Float>() == 4 { 1e-4 } else { 1e-9 }, "{change}");
    }
    assert!(most > 2, "nothing needed more");
}

fn lively(accuracy: Float, lanes: Lanes) -> World {
    let def = WorldDef { accuracy, lanes, ..WorldDef::default() };
    let mut w = World::try_new(&def).unwrap();
    chain(&mut w, 4);
    stack(&mut w, 3, 20.0);
    floor(&mut w, 0.0);
    let mut random = Random(8);
    for _ in 0..40 {
        random_body(&mut w, &mut random);
    }
    w
}

/// Two runs, both widths, and a life that was saved and gone back to are the same to the bit.
#[test]
fn the_choice_of_sub_steps_is_part_of_the_state() {
    let mut one = lively(1e-3, Lanes::Four);
    let mut two = lively(1e-3, Lanes::One);
    let mut most = 0;
    let mut hashes = Vec::new();
    let mut saved = one.save();
    for step in 0..150 {
        if step == 70 {
            saved = one.save();
        }
        run(&mut one, 1, 4);
        run(&mut two, 1, 4);
        assert_eq!(one.state_hash(), two.state_hash(), "step {step}");
        hashes.push(one.state_hash());
        most = most.max(one.step_report().most_sub_steps);
    }
    assert!(most > 4);
    one.restore(&saved).unwrap();
    for &hash in &hashes[70..] {
        run(&mut one, 1, 4);
        assert_eq!(one.state_hash(), hash);
    }
    let mut other = lively(0.0, Lanes::Four);
    run(&mut other, 150, 4);
    assert_ne!(other.state_hash(), hashes[149]);
}

/// A ball whose hinge is taken away flies on with the least sub-steps, and so does everything where nothing moves.
#[test]
fn what_comes_free_needs_no_more() {
    let mut w = world(1e-6);
    let post = w.create_body(&BodyDef::fixed(vec3(0.0, 30.0, 0.0))).unwrap();
    let ball = BodyDef::dynamic(vec3(1.0, 30.0, 0.0));
    let ball = w.create_body_with_shape(&ball, &ShapeDef::default(), Shape::new_sphere(0.2)).unwrap().0;
    let kind = JointKind::Spherical(SphericalJoint::default());
    let frames = [Pose::IDENTITY, Pose::translation(vec3(-1.0, 0.0, 0.0))];
    let joint = w.create_joint(&JointDef::new(kind, post, ball).frames(frames[0], frames[1])).unwrap();
    run(&mut w, 40, 2);
    assert!(w.body(ball).unwrap().sub_steps() > 2);
    // Whoever asks for many gets no more than a thousand.
    run(&mut w, 1, 400);
    assert!(w.step_report().most_sub_steps <= 1000);
    w.destroy_joint(joint, true).unwrap();
    run(&mut w, 1, 2);
    assert_eq!(w.body(ball).unwrap().sub_steps(), 2);
}

#[test]
fn an_accuracy_that_makes_no_sense_is_refused() {
    let code = |def: WorldDef| World::try_new(&def).map(|_| ()).unwrap_err().code();
    for accuracy in [-0.1, 1.5] {
        assert_eq!(code(WorldDef { accuracy, ..WorldDef::default() }), ErrorCode::Range);
    }
    let rigid = WorldDef { accuracy: 0.01, solver: SolverKind::Dantzig, ..WorldDef::default() };
    assert_eq!(code(rigid), ErrorCode::Unsupported);
    let mut w = world(0.0);
    assert_eq!(w.set_accuracy(Float::NAN).unwrap_err().code(), ErrorCode::NotFinite);
    w.set_accuracy(0.5).unwrap();
    assert_eq!(w.def().accuracy, 0.5);
}
