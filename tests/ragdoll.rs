//! Humans that fall: still at rest, whole in flight, within their limits, and asleep in the end.

mod common;

use common::Random;
use merev::constraint::joint::JointKind;
use merev::math::{quat_about, rotate, vec3};
use merev::world::{BodyDef, Human, HumanDef, ShapeDef, WorldDef};
use merev::{ErrorCode, Float, Pose, Shape, Vec3, World};

const DT: Float = 1.0 / 60.0;

fn world(gravity: Float) -> World {
    World::try_new(&WorldDef { gravity: vec3(0.0, -gravity, 0.0), ..WorldDef::default() }).unwrap()
}

fn floor(w: &mut World) {
    let ground = w.create_body(&BodyDef::fixed(vec3(0.0, -1.0, 0.0))).unwrap();
    let slab = Shape::new_box(200.0, 2.0, 200.0);
    w.create_shape(ground, &ShapeDef::default(), slab, Pose::IDENTITY).unwrap();
}

/// The worst error of anything a joint holds, limits included: \[m\] and \[rad\].
fn errors(w: &World, human: &Human) -> (Float, Float) {
    human.joints.iter().fold((0.0, 0.0), |(a, b): (Float, Float), &j| {
        let joint = w.joint(j).unwrap();
        (a.max(joint.linear_separation()), b.max(joint.angular_separation()))
    })
}

#[test]
fn at_rest_nothing_moves() {
    for (bones, hertz) in [(11, 0.0), (14, 0.0), (11, 5.0), (14, 5.0)] {
        let mut w = world(0.0);
        let rotation = quat_about(vec3(0.6, 0.0, 0.8), 1.0);
        let def = HumanDef { bones, spring_hertz: hertz, rotation, height: 1.6, ..HumanDef::default() };
        let human = w.create_human(&def).unwrap();
        assert_eq!((human.bodies.len(), human.joints.len()), (bones, bones - 1));
        let (gap, angle) = errors(&w, &human);
        assert!(gap < 1e-6 && angle < 1e-5, "{bones}: {gap} m, {angle} rad");
        for _ in 0..60 {
            w.try_step(DT, 4).unwrap();
        }
        // Rounding alone: f32 has 1e-7 of a metre, which errors of place turn into 1e-5 m/s.
        let energy = w.step_report().kinetic_energy;
        assert!(energy < 1e-7, "{bones} bones, {hertz} Hz: {energy} J");
    }
}

#[test]
fn the_mass_is_what_is_asked_for() {
    for bones in [11, 14] {
        let mut w = world(0.0);
        let human = w.create_human(&HumanDef { bones, mass: 75.0, ..HumanDef::default() }).unwrap();
        let mass: Float = human.bodies.iter().map(|&b| w.body(b).unwrap().mass()).sum();
        assert!((mass - 75.0).abs() < 1e-3, "{mass}");
        let human = w.create_human(&HumanDef { bones, ..HumanDef::default() }).unwrap();
        let mass: Float = human.bodies.iter().map(|&b| w.body(b).unwrap().mass()).sum();
        assert!((45.0..95.0).contains(&mass), "{mass} kg at the density of water");
    }
}

#[test]
fn in_flight_momentum_stays_and_limits_hold() {
    let mut r = Random(5);
    for bones in [11, 14] {
        let mut w = world(0.0);
        let def = HumanDef { bones, mass: 75.0, ..HumanDef::default() };
        let human = w.create_human(&def).unwrap();
        human.apply_impulse(&mut w, vec3(75.0, 0.0, 150.0)).unwrap();
        for &b in &human.bodies {
            let spin = vec3(r.within(-1.0, 1.0), r.within(-1.0, 1.0), r.within(-1.0, 1.0)) * 10.0;
            w.body_mut(b).unwrap().set_angular_velocity(spin).unwrap();
        }
        let start = w.step_report();
        let mut worst: (Float, Float) = (0.0, 0.0);
        for _ in 0..300 {
            w.try_step(DT, 4).unwrap();
            let (gap, angle) = errors(&w, &human);
            worst = (worst.0.max(gap), worst.1.max(angle));
        }
        let end = w.step_report();
        let size = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let change = |a: [f64; 3], b: [f64; 3]| size([a[0] - b[0], a[1] - b[1], a[2] - b[2]]);
        let p = change(start.linear_momentum, end.linear_momentum) / size(start.linear_momentum);
        let l = change(start.angular_momentum, end.angular_momentum) / size(start.angular_momentum);
        println!("{bones} bones: worst {worst:?}, momentum {p:.1e}, angular momentum {l:.1e}");
        assert!(worst.0 < 0.02 && worst.1 < 0.15, "{bones} bones: {worst:?}");
        assert!(p < 5e-5 && l < 1e-4, "{bones} bones: {p} and {l}");
        assert!(end.kinetic_energy < start.kinetic_energy);
    }
}

/// Humans that lie in layers, each turned about its middle by chance.
fn strew(w: &mut World, count: i32, middle: impl Fn(i32) -> Vec3) -> Vec<Human> {
    let mut r = Random(7);
    (0..count)
        .map(|k| {
            let turn = quat_about(Vec3::y(), r.within(-3.0, 3.0))
                * quat_about(Vec3::x(), 0.5 * merev::math::scalar::PI);
            let def = HumanDef {
                bones: if k % 3 == 0 { 14 } else { 11 },
                position: middle(k) - rotate(&turn, vec3(0.0, 0.9, 0.0)),
                rotation: turn,
                group_index: -(k + 1),
                friction_torque: 5.0,
                ..HumanDef::default()
            };
            w.create_human(&def).unwrap()
        })
        .collect()
}

/// Lets a heap fall asleep within `seconds`; the worst errors of joints then, \[m\] and \[rad\].
fn sleep(w: &mut World, humans: &[Human], seconds: Float) -> (Float, Float) {
    let mut slept = None;
    for step in 0..(seconds / DT) as usize {
        w.try_step(DT, 4).unwrap();
        if w.awake_bodies().len() == 0 {
            slept = Some(step as Float * DT);
            break;
        }
    }
    assert!(slept.is_some(), "{} bodies are awake after {seconds} s", w.awake_bodies().len());
    assert_eq!(w.step_report().quarantined, 0);
    let worst = humans.iter().map(|human| errors(w, human));
    let worst = worst.fold((0.0, 0.0), |a: (Float, Float), b| (a.0.max(b.0), a.1.max(b.1)));
    println!("{} humans: asleep after {slept:?} s; gap {} m, {} rad", humans.len(), worst.0, worst.1);
    let bodies = || humans.iter().flat_map(|human| &human.bodies);
    assert!(bodies().all(|&b| w.body(b).unwrap().world_center().y > 0.0));
    worst
}

#[test]
fn a_narrow_heap_falls_asleep() {
    let mut w = world(10.0);
    floor(&mut w);
    // Four in each layer, so that none is inside another at the start.
    let cell = |on: bool| if on { 1.1 } else { -1.1 };
    let middle = |k: i32| vec3(cell(k % 2 == 0), 0.4 + 0.6 * (k / 4) as Float, cell(k % 4 < 2));
    let humans = strew(&mut w, 20, middle);
    let (gap, angle) = sleep(&mut w, &humans, 20.0);
    assert!(gap < 0.002 && angle < 0.05, "{gap} m, {angle} rad");
    // Gone without a trace.
    humans.iter().for_each(|h| w.destroy_human(h));
    assert_eq!((w.counters().bodies, w.joint_count()), (1, 0));
}

#[test]
fn a_hundred_humans_fall_asleep() {
    let mut w = world(10.0);
    floor(&mut w);
    let row = |k: i32| 2.2 * (k % 5 - 2) as Float;
    let middle = |k: i32| vec3(row(k), 0.4 + 0.6 * (k / 25) as Float, row(k / 5));
    let humans = strew(&mut w, 100, middle);
    let (gap, angle) = sleep(&mut w, &humans, 30.0);
    // Which joint is wedged when a heap falls asleep is chance: 0.016 rad in single, 0.058 in double precision.
    assert!(gap < 0.002 && angle < 0.07, "{gap} m, {angle} rad");
}

/// Islands that have joints and contacts are swept twice, others once, whoever shares their batch.
#[test]
fn a_far_neighbour_changes_nothing() {
    let run = |boxes: bool, human: bool| {
        let mut w = world(10.0);
        floor(&mut w);
        let humans = if human { strew(&mut w, 1, |_| vec3(0.0, 1.0, 0.0)) } else { Vec::new() };
        let mut bodies: Vec<_> = humans.iter().flat_map(|h| h.bodies.clone()).collect();
        for k in 0..if boxes { 4 } else { 0 } {
            let def = BodyDef::dynamic(vec3(50.0, 0.5 + 1.2 * k as Float, 0.1 * k as Float));
            let body = w.create_body(&def).unwrap();
            w.create_shape(body, &ShapeDef::default(), Shape::new_box(1.0, 1.0, 1.0), Pose::IDENTITY)
                .unwrap();
            bodies.push(body);
        }
        (0..120).for_each(|_| w.try_step(DT, 4).unwrap());
        let state = |&b| {
            let body = w.body(b).unwrap();
            (body.transform(), body.momentum(), body.angular_momentum())
        };
        bodies.iter().map(state).collect::<Vec<_>>()
    };
    assert_eq!(run(true, true), [run(false, true), run(true, false)].concat());
}

#[test]
fn settings_reach_every_joint_and_nonsense_none() {
    let mut w = world(0.0);
    let human = w.create_human(&HumanDef::default()).unwrap();
    human.set_friction(&mut w, 4.0).unwrap();
    human.set_spring(&mut w, 3.0, 0.5).unwrap();
    for &j in &human.joints {
        let (spring, friction) = match w.joint(j).unwrap().kind() {
            JointKind::Revolute(j) => (j.drive.spring, j.drive.friction),
            JointKind::Spherical(j) => (j.spring, j.friction),
            other => panic!("{other:?}"),
        };
        assert!(spring.enable && spring.hertz == 3.0 && spring.damping_ratio == 0.5 && friction == 4.0);
    }
    human.set_velocity(&mut w, Vec3::x()).unwrap();
    assert_eq!(human.set_friction(&mut w, -1.0).unwrap_err().code(), ErrorCode::Range);
    assert_eq!(human.set_spring(&mut w, Float::NAN, 1.0).unwrap_err().code(), ErrorCode::NotFinite);
    for def in [
        HumanDef { bones: 12, ..HumanDef::default() },
        HumanDef { height: 0.0, ..HumanDef::default() },
        HumanDef { density: -1.0, ..HumanDef::default() },
        HumanDef { mass: -1.0, ..HumanDef::default() },
        HumanDef { friction_torque: -1.0, ..HumanDef::default() },
    ] {
        assert_eq!(w.create_human(&def).unwrap_err().code(), ErrorCode::Range);
    }
    assert_eq!((w.counters().bodies, w.joint_count()), (11, 10));
    w.destroy_body(human.bodies[3]).unwrap();
    assert_eq!(human.set_friction(&mut w, 1.0).unwrap_err().code(), ErrorCode::Stale);
}
