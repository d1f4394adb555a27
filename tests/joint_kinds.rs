//! Every kind of joint: what it holds, what it leaves free, what acts on it, and what it reports.

mod common;

use common::Random;
use merev::constraint::joint::{
    AxisMode, DistanceJoint, Drive, GearJoint, JointKind, Limit, Motor, MotorJoint, ParallelJoint,
    PrismaticJoint, PulleyJoint, RevoluteJoint, ScrewJoint, SixDofJoint, SphericalJoint, Spring,
    UniversalJoint, WeldJoint, WheelJoint, six_dof::Axis,
};
use merev::math::{length, quat_about, scalar, vec3};
use merev::shape::MassData;
use merev::world::{BodyDef, JointDef, JointId, ShapeDef, WorldDef};
use merev::{BodyId, ErrorCode, Float, Mat3, Pose, Quat, Shape, Vec3, World};

const DT: Float = 1.0 / 60.0;
const SINGLE: bool = size_of::<Float>() == 4;

fn world(gravity: Vec3) -> World {
    World::try_new(&WorldDef { gravity, enable_sleep: false, ..WorldDef::default() }).unwrap()
}

fn floating() -> World {
    world(Vec3::zeros())
}

fn falling() -> World {
    world(vec3(0.0, -10.0, 0.0))
}

fn body(w: &mut World, at: Vec3) -> BodyId {
    heavy(w, at, 1.0, vec3(0.1, 0.1, 0.1))
}

fn heavy(w: &mut World, at: Vec3, mass: Float, inertia: Vec3) -> BodyId {
    let id = w.create_body(&BodyDef::dynamic(at)).unwrap();
    let data = MassData { mass, center: Vec3::zeros(), inertia: Mat3::from_diagonal(&inertia) };
    w.body_mut(id).unwrap().set_mass_data(&data).unwrap();
    id
}

fn ground(w: &mut World) -> BodyId {
    w.create_body(&BodyDef::fixed(Vec3::zeros())).unwrap()
}

fn at(p: Vec3) -> Pose {
    Pose::new(p, Quat::identity())
}

/// A joint whose frames stand at `p` in the world, turned by `q`.
fn join(w: &mut World, kind: JointKind, a: BodyId, b: BodyId, p: Vec3, q: Quat) -> JointId {
    let frame = |w: &World, id| {
        let t = w.body(id).unwrap().transform();
        Pose::new(t.point_back(p), t.q.conjugate() * q)
    };
    let (fa, fb) = (frame(w, a), frame(w, b));
    w.create_joint(&JointDef::new(kind, a, b).frames(fa, fb)).unwrap()
}

fn run(w: &mut World, seconds: Float) {
    for _ in 0..(seconds / DT).round() as usize {
        w.try_step(DT, 4).unwrap();
    }
}

fn spin(w: &mut World, id: BodyId, omega: Vec3) {
    w.body_mut(id).unwrap().set_angular_velocity(omega).unwrap();
}

fn omega(w: &World, id: BodyId) -> Vec3 {
    w.body(id).unwrap().angular_velocity()
}

fn place(w: &World, id: BodyId) -> Vec3 {
    w.body(id).unwrap().world_center()
}

/// Every kind with something to do, for tests of all.
fn all_kinds() -> Vec<JointKind> {
    let drive = Drive {
        spring: Spring { enable: true, hertz: 3.0, damping_ratio: 0.3, max_force: 50.0 },
        target: 0.2,
        limit: Limit { enable: true, lower: -0.5, upper: 0.5 },
        motor: Motor { enable: true, speed: 1.0, max_force: 0.5 },
        friction: 0.1,
    };
    vec![
        JointKind::Distance(DistanceJoint { length: 0.0, ..DistanceJoint::default() }),
        JointKind::Distance(DistanceJoint {
            length: 0.3,
            enable_spring: true,
            hertz: 2.0,
            damping_ratio: 0.1,
            limit: Limit { enable: true, lower: 0.0, upper: 0.8 },
            motor: Motor { enable: true, speed: 0.3, max_force: 0.2 },
            ..DistanceJoint::default()
        }),
        JointKind::Filter,
        JointKind::Motor(MotorJoint {
            linear_velocity: vec3(0.1, 0.0, 0.2),
            max_velocity_force: 1.0,
            angular_velocity: vec3(0.0, 1.0, 0.0),
            max_velocity_torque: 1.0,
            linear_hertz: 1.0,
            max_spring_force: 2.0,
            angular_hertz: 1.0,
            max_spring_torque: 2.0,
            ..MotorJoint::default()
        }),
        JointKind::Parallel(ParallelJoint::default()),
        JointKind::Prismatic(PrismaticJoint { drive }),
        JointKind::Revolute(RevoluteJoint { drive }),
        JointKind::Spherical(SphericalJoint {
            enable_cone_limit: true,
            cone_angle: [0.5, 0.3],
            twist: Limit { enable: true, lower: -0.3, upper: 0.4 },
            spring: Spring { enable: true, hertz: 2.0, damping_ratio: 0.2, max_force: 5.0 },
            enable_motor: true,
            motor_velocity: vec3(0.0, 0.5, 1.0),
            max_motor_torque: 0.3,
            friction: 0.1,
            ..SphericalJoint::default()
        }),
        JointKind::Weld(WeldJoint::default()),
        JointKind::Weld(WeldJoint { linear_hertz: 5.0, angular_hertz: 4.0, ..WeldJoint::default() }),
        JointKind::Wheel(WheelJoint {
            suspension: drive,
            spin: Motor { enable: true, speed: 3.0, max_force: 1.0 },
            spin_friction: 0.1,
            enable_steering: true,
            steering: drive,
        }),
        JointKind::Universal(UniversalJoint { drives: [drive; 2] }),
        JointKind::SixDof(SixDofJoint {
            linear: [
                Axis { mode: AxisMode::Limited, drive },
                Axis::default(),
                Axis { mode: AxisMode::Free, drive },
            ],
            angular: [
                Axis::default(),
                Axis { mode: AxisMode::Limited, drive },
                Axis { mode: AxisMode::Free, drive: Drive::default() },
            ],
        }),
        JointKind::Screw(ScrewJoint { pitch: 0.2, drive }),
    ]
}

#[test]
fn momentum_stays_whatever_the_joint() {
    let mut random = Random(5);
    for kind in all_kinds() {
        let mut w = floating();
        let mut ids = Vec::new();
        for _ in 0..4 {
            let id = heavy(&mut w, random.vec(1.0), random.within(0.5, 3.0), vec3(0.2, 0.3, 0.25));
            let mut b = w.body_mut(id).unwrap();
            b.set_linear_velocity(random.vec(2.0)).unwrap();
            b.set_angular_velocity(random.vec(3.0)).unwrap();
            ids.push(id);
        }
        for pair in ids.windows(2) {
            let middle = (place(&w, pair[0]) + place(&w, pair[1])) * 0.5;
            join(&mut w, kind, pair[0], pair[1], middle, random.rotation());
        }
        let before = w.step_report();
        run(&mut w, 5.0);
        let after = w.step_report();
        let change = |a: [f64; 3], b: [f64; 3]| (0..3).map(|k| (a[k] - b[k]).abs()).fold(0.0, f64::max);
        let p = change(before.linear_momentum, after.linear_momentum);
        let l = change(before.angular_momentum, after.angular_momentum);
        // Of some 10 kg m/s and kg m²/s, after some 1e5 impulses, each of which rounds.
        let bound = if SINGLE { 1e-3 } else { 1e-11 };
        assert!(p < bound && l < bound, "{}: ΔP {p:.1e}, ΔL {l:.1e}", kind.name());
        w.validate();
    }
}

#[test]
fn reported_forces_are_what_changed_the_momentum() {
    let mut random = Random(8);
    for kind in all_kinds() {
        let mut w = falling();
        let (a, b) = (body(&mut w, vec3(0.0, 0.0, 0.0)), body(&mut w, vec3(1.0, 0.0, 0.0)));
        spin(&mut w, a, vec3(1.0, 2.0, 0.5));
        let joint = join(&mut w, kind, a, b, vec3(0.6, 0.1, 0.0), random.rotation());
        for _ in 0..60 {
            let (p, l) = (w.body(b).unwrap().momentum(), w.body(b).unwrap().angular_momentum());
            // The arm turns during the step: take it as it is in the middle.
            let arm = |w: &World| w.joint(joint).unwrap().geometry().arm[1];
            let before = arm(&w);
            w.try_step(DT, 16).unwrap();
            let (force, torque) =
                (w.joint(joint).unwrap().constraint_force(), w.joint(joint).unwrap().constraint_torque());
            let dp = w.body(b).unwrap().momentum() - p - vec3(0.0, -10.0 * DT, 0.0);
            // The momentum of the fall rounds in each sub-step.
            let rounding = if SINGLE { 2e-5 } else { 1e-12 };
            assert!(length(dp - force * DT) < rounding * (1.0 + length(p)), "{}: {dp} {force}", kind.name());
            let dl = w.body(b).unwrap().angular_momentum() - l;
            let moment = ((before + arm(&w)) * 0.5).cross(&force) + torque;
            // Arms turn by some 0.05 rad in the step.
            let slack = 0.05 * DT * (length(force) * (1.0 + length(before)) + length(torque)) + 1e-4;
            assert!(length(dl - moment * DT) < slack, "{}: {dl} {}", kind.name(), moment * DT);
        }
    }
}

#[test]
fn everything_keeps_its_frames_together_under_load() {
    let mut random = Random(2);
    for kind in all_kinds() {
        if matches!(kind, JointKind::Weld(j) if j.linear_hertz > 0.0) {
            continue;
        }
        let mut w = falling();
        let root = ground(&mut w);
        let mut last = root;
        for k in 0..4 {
            let next = body(&mut w, vec3(0.5 + k as Float, 0.0, 0.0));
            join(&mut w, kind, last, next, vec3(k as Float, 0.0, 0.0), random.rotation());
            last = next;
        }
        let (mut gap, mut angle) = (0.0 as Float, 0.0 as Float);
        for step in 0..240 {
            w.try_step(DT, 4).unwrap();
            let (g, a) = w.joint_gap();
            if step > 10 {
                gap = gap.max(g);
                angle = angle.max(a);
            }
        }
        println!("{}: gap {gap:.1e} m, {angle:.1e} rad", kind.name());
        // Limits are solved after what holds, one by one: they may give by what one sweep leaves.
        assert!(gap < 0.02 && angle < 0.1, "{}: {gap} m, {angle} rad", kind.name());
    }
}

#[test]
fn a_hinge_counts_turns_and_stops_at_limits_beyond_them() {
    let mut w = floating();
    let (g, b) = (ground(&mut w), body(&mut w, Vec3::zeros()));
    let limit = Limit { enable: true, lower: -1.0, upper: 20.0 };
    let kind = JointKind::Revolute(RevoluteJoint { drive: Drive { limit, ..Drive::default() } });
    let joint = join(&mut w, kind, g, b, Vec3::zeros(), Quat::identity());
    spin(&mut w, b, vec3(0.0, 0.0, 9.0));
    run(&mut w, 1.0);
    assert!((w.joint(joint).unwrap().coordinate() - 9.0).abs() < 1e-3);
    assert!((w.joint(joint).unwrap().speed() - 9.0).abs() < 1e-3);
    run(&mut w, 3.0);
    assert!((w.joint(joint).unwrap().coordinate() - 20.0).abs() < 1e-3, "it stops at the limit");
    assert!(omega(&w, b).z.abs() < 1e-3);
    spin(&mut w, b, vec3(0.0, 0.0, -9.0));
    run(&mut w, 5.0);
    assert!((w.joint(joint).unwrap().coordinate() + 1.0).abs() < 1e-3, "and at the lower one");
}

#[test]
fn a_motor_takes_the_torque_it_has() {
    let mut w = floating();
    let (g, b) = (ground(&mut w), body(&mut w, Vec3::zeros()));
    let motor = Motor { enable: true, speed: 4.0, max_force: 0.2 };
    let kind = JointKind::Revolute(RevoluteJoint { drive: Drive { motor, ..Drive::default() } });
    let joint = join(&mut w, kind, g, b, Vec3::zeros(), Quat::identity());
    // 0.2 N m on 0.1 kg m²: 2 rad/s².
    run(&mut w, 1.0);
    assert!((omega(&w, b).z - 2.0).abs() < 1e-3);
    assert!((w.joint(joint).unwrap().motor_force().x - 0.2).abs() < 1e-4);
    run(&mut w, 2.0);
    assert!((omega(&w, b).z - 4.0).abs() < 1e-3);
    assert!(w.joint(joint).unwrap().motor_force().x.abs() < 1e-3, "at speed it pulls no more");
    // Changed while it runs: at once.
    let motor = Motor { enable: true, speed: 0.0, max_force: Float::INFINITY };
    let kind = JointKind::Revolute(RevoluteJoint { drive: Drive { motor, ..Drive::default() } });
    w.joint_mut(joint).unwrap().set_kind(kind).unwrap();
    w.try_step(DT, 4).unwrap();
    assert!(omega(&w, b).z.abs() < 1e-4);
}

#[test]
fn dry_friction_brakes_evenly_and_then_holds() {
    for kind in ["revolute", "prismatic", "spherical"] {
        let mut w = floating();
        let (g, b) = (ground(&mut w), body(&mut w, Vec3::zeros()));
        let drive = Drive { friction: 0.1, ..Drive::default() };
        let joint = match kind {
            "revolute" => JointKind::Revolute(RevoluteJoint { drive }),
            "prismatic" => JointKind::Prismatic(PrismaticJoint { drive }),
            _ => JointKind::Spherical(SphericalJoint { friction: 0.1, ..SphericalJoint::default() }),
        };
        join(&mut w, joint, g, b, Vec3::zeros(), Quat::identity());
        let read = |w: &World| {
            if kind == "prismatic" { w.body(b).unwrap().linear_velocity().x } else { omega(w, b).z }
        };
        if kind == "prismatic" {
            w.body_mut(b).unwrap().set_linear_velocity(vec3(0.5, 0.0, 0.0)).unwrap();
            run(&mut w, 2.0);
            assert!((read(&w) - 0.3).abs() < 1e-4, "0.1 N on 1 kg: 0.1 m/s²");
            run(&mut w, 4.0);
        } else {
            spin(&mut w, b, vec3(0.0, 0.0, 2.0));
            run(&mut w, 1.0);
            assert!((read(&w) - 1.0).abs() < 1e-3, "{kind}: 0.1 N m on 0.1 kg m²: 1 rad/s²");
            run(&mut w, 2.0);
        }
        assert!(read(&w).abs() < 1e-6, "{kind} rests: {}", read(&w));
        // Below the friction nothing moves.
        for _ in 0..60 {
            let mut b = w.body_mut(b).unwrap();
            if kind == "prismatic" {
                b.apply_force_to_center(vec3(0.09, 0.0, 0.0), true).unwrap();
            } else {
                b.apply_torque(vec3(0.0, 0.0, 0.09), true).unwrap();
            }
            w.try_step(DT, 4).unwrap();
        }
        assert!(read(&w).abs() < 1e-6, "{kind} holds");
    }
}

#[test]
fn a_ball_joint_stays_in_its_cone_and_twist() {
    let mut random = Random(12);
    for (cone, twist) in [([0.5, 0.5], 0.4), ([0.7, 0.25], 0.3)] {
        let mut w = falling();
        let g = ground(&mut w);
        let b = body(&mut w, vec3(0.0, 0.0, -1.0));
        let kind = JointKind::Spherical(SphericalJoint {
            enable_cone_limit: true,
            cone_angle: cone,
            twist: Limit { enable: true, lower: -twist, upper: twist },
            ..SphericalJoint::default()
        });
        let joint = join(&mut w, kind, g, b, Vec3::zeros(), Quat::identity());
        let (mut most, mut most_twist) = (0.0 as Float, 0.0 as Float);
        for step in 0..600 {
            if step % 60 == 0 {
                spin(&mut w, b, random.vec(6.0));
            }
            w.try_step(DT, 4).unwrap();
            let (swing, t) =
                merev::constraint::joint::swing_twist(&w.joint(joint).unwrap().geometry().relative());
            let rho = {
                let (x, y) = (swing.x / cone[0], swing.y / cone[1]);
                (x * x + y * y).sqrt()
            };
            most = most.max(rho);
            most_twist = most_twist.max(t.abs());
        }
        println!("cone {cone:?}: {most:.4} of it, twist {:.4}", most_twist / twist);
        assert!(most < 1.05 && most > 0.9 && most_twist < 1.03 * twist && most_twist > 0.5 * twist);
    }
}

#[test]
fn welds_hold_a_cantilever() {
    let mut w = falling();
    let root = ground(&mut w);
    let mut last = root;
    for k in 0..10 {
        let x = 0.1 + 0.2 * k as Float;
        let cube = heavy(&mut w, vec3(x, 0.0, 0.0), 8.0, Vec3::repeat(8.0 * 0.04 / 6.0));
        join(
            &mut w,
            JointKind::Weld(WeldJoint::default()),
            last,
            cube,
            vec3(x - 0.1, 0.0, 0.0),
            Quat::identity(),
        );
        last = cube;
    }
    run(&mut w, 5.0);
    let tip = place(&w, last);
    println!("tip at {tip:?}, moves at {:.1e} m/s", length(w.body(last).unwrap().linear_velocity()));
    assert!((tip.y.abs() + (tip.x - 1.9).abs()) / 1.9 < 1e-4);
}

#[test]
fn a_wheel_sags_spins_and_steers() {
    let mut w = falling();
    let g = ground(&mut w);
    let b = body(&mut w, Vec3::zeros());
    let up = quat_about(Vec3::z(), scalar::PI / 2.0);
    let spring = |hertz: Float| Spring { enable: true, hertz, damping_ratio: 1.0, ..Spring::default() };
    let mut wheel = WheelJoint {
        suspension: Drive { spring: spring(2.0), ..Drive::default() },
        spin: Motor { enable: true, speed: 5.0, max_force: 10.0 },
        enable_steering: true,
        steering: Drive { spring: spring(5.0), target: 0.3, ..Drive::default() },
        ..WheelJoint::default()
    };
    let joint = join(&mut w, JointKind::Wheel(wheel), g, b, Vec3::zeros(), up);
    run(&mut w, 3.0);
    let sag = 10.0 / (16.0 * scalar::PI * scalar::PI);
    let read = w.joint(joint).unwrap();
    assert!((read.suspension() + sag).abs() < 1e-4, "{} {sag}", read.suspension());
    assert!((read.steering() - 0.3).abs() < 1e-3, "{}", read.steering());
    assert!((read.speed() - 5.0).abs() < 1e-3);
    assert!(length(place(&w, b) - vec3(0.0, -sag, 0.0)) < 1e-3, "it stays on its line");
    wheel.enable_steering = false;
    w.joint_mut(joint).unwrap().set_kind(JointKind::Wheel(wheel)).unwrap();
    run(&mut w, 2.0);
    assert!(w.joint(joint).unwrap().steering().abs() < 1e-3, "without steering it points forward");
}

#[test]
fn a_motor_joint_brings_a_body_to_its_place() {
    let mut w = falling();
    let g = ground(&mut w);
    let b = body(&mut w, vec3(1.0, 0.5, -0.3));
    let motor = MotorJoint {
        linear_hertz: 2.0,
        max_spring_force: 100.0,
        angular_hertz: 2.0,
        max_spring_torque: 100.0,
        ..MotorJoint::default()
    };
    let def = JointDef::new(JointKind::Motor(motor), g, b).frames(at(vec3(0.0, 2.0, 0.0)), Pose::IDENTITY);
    w.create_joint(&def).unwrap();
    spin(&mut w, b, vec3(3.0, 0.0, 0.0));
    run(&mut w, 4.0);
    let sag = 10.0 / (16.0 * scalar::PI * scalar::PI);
    assert!(length(place(&w, b) - vec3(0.0, 2.0 - sag, 0.0)) < 1e-3);
    assert!(length(omega(&w, b)) < 1e-3);
}

#[test]
fn a_parallel_joint_keeps_a_body_upright() {
    let mut w = floating();
    let g = ground(&mut w);
    let b = body(&mut w, Vec3::zeros());
    let kind =
        JointKind::Parallel(ParallelJoint { hertz: 2.0, damping_ratio: 1.0, ..ParallelJoint::default() });
    w.create_joint(&JointDef::new(kind, g, b)).unwrap();
    spin(&mut w, b, vec3(2.0, -1.0, 4.0));
    run(&mut w, 4.0);
    let z = w.body(b).unwrap().transform().vector(Vec3::z());
    assert!(length(z - Vec3::z()) < 1e-3, "{z:?}");
    assert!((omega(&w, b).z - 4.0).abs() < 0.05, "the turn about z is free");
}

#[test]
fn joined_bodies_collide_only_if_they_are_told_to() {
    let cube = Shape::new_box(1.0, 1.0, 1.0);
    let build = |collide: bool, joined: bool| {
        let mut w = falling();
        let g = ground(&mut w);
        w.create_shape(g, &ShapeDef::default(), Shape::new_box(4.0, 1.0, 4.0), Pose::IDENTITY).unwrap();
        let b = w.create_body(&BodyDef::dynamic(vec3(0.0, 1.2, 0.0))).unwrap();
        w.create_shape(b, &ShapeDef::default(), cube.clone(), Pose::IDENTITY).unwrap();
        let joint = joined.then(|| {
            let mut def = JointDef::new(JointKind::Filter, g, b);
            def.collide_connected = collide;
            w.create_joint(&def).unwrap()
        });
        (w, b, joint)
    };
    for (collide, joined, rests) in [(false, false, true), (true, true, true), (false, true, false)] {
        let (mut w, b, _) = build(collide, joined);
        run(&mut w, 1.0);
        assert_eq!(place(&w, b).y > 0.9, rests, "collide {collide}, joined {joined}");
    }
    // Taken away, or changed, it counts at once.
    let (mut w, b, joint) = build(false, true);
    w.try_step(DT, 4).unwrap();
    w.destroy_joint(joint.unwrap(), true).unwrap();
    run(&mut w, 1.0);
    assert!(place(&w, b).y > 0.9);
    let (mut w, b, joint) = build(false, true);
    w.joint_mut(joint.unwrap()).unwrap().set_collide_connected(true);
    run(&mut w, 1.0);
    assert!(place(&w, b).y > 0.9);
    w.joint_mut(joint.unwrap()).unwrap().set_collide_connected(false);
    run(&mut w, 1.0);
    assert!(place(&w, b).y < 0.0);
}

#[test]
fn a_cardan_shaft_turns_by_its_law() {
    // Shafts along x and along a line 30° from it; tan θ₂ = tan θ₁ / cos β, with θ₁ from the plane of both.
    let beta = scalar::PI / 6.0;
    let mut w = floating();
    let g = ground(&mut w);
    let (a, b) =
        (body(&mut w, vec3(-1.0, 0.0, 0.0)), body(&mut w, vec3(scalar::cos(beta), scalar::sin(beta), 0.0)));
    let hinge = |w: &mut World, id, at: Vec3, along: Vec3| {
        let q = Quat::rotation_between(&Vec3::z(), &along).unwrap();
        join(w, JointKind::Revolute(RevoluteJoint::default()), g, id, at, q)
    };
    let out = vec3(scalar::cos(beta), scalar::sin(beta), 0.0);
    let first = hinge(&mut w, a, vec3(-1.0, 0.0, 0.0), Vec3::x());
    let second = hinge(&mut w, b, out, out);
    // The cross: one pin fixed in A across x, the other fixed in B across its shaft.
    let frame_a = Pose::new(vec3(1.0, 0.0, 0.0), quat_about(Vec3::z(), scalar::PI / 2.0));
    let pin_b = vec3(0.0, 0.0, 1.0);
    let q_b = Quat::rotation_between(&Vec3::y(), &pin_b).unwrap();
    let def = JointDef::new(JointKind::Universal(UniversalJoint::default()), a, b)
        .frames(frame_a, Pose::new(-out, q_b));
    w.create_joint(&def).unwrap();
    let motor = Motor { enable: true, speed: 2.0, max_force: 1e3 };
    let drive = Drive { motor, ..Drive::default() };
    w.joint_mut(first).unwrap().set_kind(JointKind::Revolute(RevoluteJoint { drive })).unwrap();
    let mut worst = 0.0 as Float;
    for _ in 0..240 {
        w.try_step(DT, 4).unwrap();
        let (t1, t2) = (w.joint(first).unwrap().coordinate(), w.joint(second).unwrap().coordinate());
        // The pin of A lies in the plane of the shafts (y) at the start.
        let (s1, c1) = scalar::sin_cos(t1);
        let want = scalar::atan2(s1 * scalar::cos(beta), c1);
        let alternative = scalar::atan2(s1, c1 * scalar::cos(beta));
        let off = |x: Float| {
            let d = (t2 - x) / (2.0 * scalar::PI);
            ((d - d.round()) * 2.0 * scalar::PI).abs()
        };
        worst = worst.max(off(want).min(off(alternative)));
    }
    println!("Cardan: off by {worst:.1e} rad");
    assert!(worst < 2e-3);
}

#[test]
fn six_axes_do_as_they_are_told() {
    let mut w = falling();
    let g = ground(&mut w);
    let b = body(&mut w, Vec3::zeros());
    let free = Axis { mode: AxisMode::Free, drive: Drive::default() };
    let limited = |lower, upper| Axis {
        mode: AxisMode::Limited,
        drive: Drive { limit: Limit { enable: true, lower, upper }, ..Drive::default() },
    };
    let joint = SixDofJoint {
        linear: [free, limited(-0.7, 0.3), Axis::default()],
        angular: [limited(-0.2, 0.2), Axis::default(), free],
    };
    let id = join(&mut w, JointKind::SixDof(joint), g, b, Vec3::zeros(), Quat::identity());
    w.body_mut(b).unwrap().set_linear_velocity(vec3(1.0, 0.0, 2.0)).unwrap();
    spin(&mut w, b, vec3(1.0, 2.0, 0.0));
    run(&mut w, 2.0);
    let (d, r) = w.joint(id).unwrap().six_coordinates();
    assert!((d.x - 2.0).abs() < 2e-3, "x is free: {d:?}");
    assert!((d.y + 0.7).abs() < 1e-3, "y rests on its limit: {d:?}");
    assert!(d.z.abs() < 1e-4 && r.y.abs() < 1e-3, "z and the turn about y are locked: {d:?} {r:?}");
    assert!((r.x - 0.2).abs() < 2e-3, "the turn about x stopped: {r:?}");
}

#[test]
fn a_rack_runs_with_its_pinion() {
    let mut w = floating();
    let g = ground(&mut w);
    let (pinion, rack) = (body(&mut w, Vec3::zeros()), body(&mut w, vec3(0.0, -0.5, 0.0)));
    let hinge = join(
        &mut w,
        JointKind::Revolute(RevoluteJoint::default()),
        g,
        pinion,
        Vec3::zeros(),
        Quat::identity(),
    );
    let at_rack = place(&w, rack);
    let slide =
        join(&mut w, JointKind::Prismatic(PrismaticJoint::default()), g, rack, at_rack, Quat::identity());
    // A pinion of radius 0.5 over its rack: x = 0.5 θ, so θ − 2 x = 0.
    let gear = GearJoint::between(&w, hinge, slide, -2.0).unwrap();
    w.create_joint(&JointDef::new(JointKind::RackPinion(gear), pinion, rack)).unwrap();
    spin(&mut w, pinion, vec3(0.0, 0.0, 4.0));
    run(&mut w, 5.0);
    let (angle, x) = (w.joint(hinge).unwrap().coordinate(), w.joint(slide).unwrap().coordinate());
    assert!(angle > 1.0 && (angle - 2.0 * x).abs() < 1e-4, "{angle} {x}");
    // Energy: ½ I ω² with I + m r² = 0.1 + 0.25.
    let e = w.step_report().kinetic_energy;
    let speed = omega(&w, pinion).z;
    assert!((e - scalar::double(0.5 * 0.35 * speed * speed)).abs() < 1e-4);
    let wrong = GearJoint::between(&w, slide, hinge, 1.0).unwrap();
    let refused = w.create_joint(&JointDef::new(JointKind::RackPinion(wrong), pinion, rack));
    assert_eq!(refused.unwrap_err().code(), ErrorCode::Range);
}

#[test]
fn a_pulley_is_atwoods_machine() {
    let mut w = falling();
    let (a, b) =
        (heavy(&mut w, vec3(-1.0, 0.0, 0.0), 2.0, Vec3::repeat(0.1)), body(&mut w, vec3(1.0, 0.0, 0.0)));
    let pulley =
        PulleyJoint { ground: [vec3(-1.0, 4.0, 0.0), vec3(1.0, 4.0, 0.0)], ..PulleyJoint::default() };
    let joint = w.create_joint(&JointDef::new(JointKind::Pulley(pulley), a, b)).unwrap();
    run(&mut w, 1.0);
    // (2 − 1) g / 3 for one second: 1.667 m/s and 0.833 m.
    assert!((w.body(a).unwrap().linear_velocity().y + 10.0 / 3.0).abs() < 1e-3);
    assert!((place(&w, a).y + 5.0 / 3.0).abs() < 1e-3, "{}", place(&w, a).y);
    assert!((w.joint(joint).unwrap().coordinate() - 8.0).abs() < 1e-4);
    // With a hoist of ratio 2, B of 4 kg balances A of 2 kg; and a rope does not push.
    let mut w = falling();
    let (a, b) = (
        heavy(&mut w, vec3(-1.0, 0.0, 0.0), 2.0, Vec3::repeat(0.1)),
        heavy(&mut w, vec3(1.0, 0.0, 0.0), 4.0, Vec3::repeat(0.1)),
    );
    w.create_joint(&JointDef::new(JointKind::Pulley(PulleyJoint { ratio: 2.0, ..pulley }), a, b)).unwrap();
    run(&mut w, 2.0);
    assert!(place(&w, a).y.abs() < 1e-4 && place(&w, b).y.abs() < 1e-4);
    w.body_mut(a).unwrap().set_linear_velocity(vec3(0.0, 3.0, 0.0)).unwrap();
    run(&mut w, 0.2);
    assert!((place(&w, a).y - (0.6 - 0.2)).abs() < 0.02, "thrown up, A flies: {}", place(&w, a).y);
}

#[test]
fn a_screw_goes_with_its_turns() {
    let mut w = falling();
    let g = ground(&mut w);
    let b = body(&mut w, Vec3::zeros());
    let up = quat_about(Vec3::z(), scalar::PI / 2.0);
    let screw = JointKind::Screw(ScrewJoint { pitch: 0.3, drive: Drive::default() });
    let joint = join(&mut w, screw, g, b, Vec3::zeros(), up);
    run(&mut w, 2.0);
    let turn = w.joint(joint).unwrap().coordinate();
    let y = place(&w, b).y;
    assert!((y - 0.3 * turn / (2.0 * scalar::PI)).abs() < 1e-4, "{y} {turn}");
    // a = g / (1 + I (2π/p)² / m)
    let a = 10.0 / (1.0 + 0.1 * (4.0 * scalar::PI * scalar::PI / 0.09));
    assert!((y + 0.5 * a * 4.0).abs() < 2e-3 * a * 2.0, "{y}");
}

#[test]
fn loops_stay_closed() {
    // Four bars in a plane, all hinges: two redundant rows a hinge.
    let mut w = falling();
    let g = ground(&mut w);
    let hinge = JointKind::Revolute(RevoluteJoint::default());
    let rod = |w: &mut World, a: Vec3, b: Vec3| {
        let id = heavy(w, (a + b) * 0.5, 1.0, Vec3::repeat(1.0 / 12.0));
        (id, a, b)
    };
    let (p, q) = (vec3(0.0, 1.0, 0.0), vec3(1.0, 1.0, 0.0));
    let rods = [rod(&mut w, Vec3::zeros(), p), rod(&mut w, p, q), rod(&mut w, q, Vec3::x())];
    join(&mut w, hinge, g, rods[0].0, Vec3::zeros(), Quat::identity());
    join(&mut w, hinge, rods[0].0, rods[1].0, p, Quat::identity());
    join(&mut w, hinge, rods[1].0, rods[2].0, q, Quat::identity());
    join(&mut w, hinge, rods[2].0, g, Vec3::x(), Quat::identity());
    for (id, v, turn) in [(rods[0].0, 0.5, -1.0), (rods[1].0, 1.0, 0.0), (rods[2].0, 0.5, -1.0)] {
        w.body_mut(id).unwrap().set_linear_velocity(vec3(v, 0.0, 0.0)).unwrap();
        spin(&mut w, id, vec3(0.0, 0.0, turn));
    }
    let energy = |w: &World| w.step_report().kinetic_energy + w.step_report().potential_energy;
    let e0 = energy(&w);
    let (mut gap, mut drift) = (0.0 as Float, 0.0_f64);
    for _ in 0..600 {
        w.try_step(DT, 4).unwrap();
        gap = gap.max(w.joint_gap().0);
        drift = drift.max((energy(&w) - e0).abs());
    }
    println!("four-bar: gap {gap:.1e} m, energy {:.1e} of {e0:.1}", drift);
    assert!(gap < 1e-3 && drift < 0.02 * e0.abs(), "gap {gap}, energy {drift} of {e0}");

    // Bricard's loop: five rods on six hinges, Grübler count 0, yet it moves.
    let mut w = falling();
    let g = ground(&mut w);
    let corners = [
        vec3(0.0, 0.0, 0.0),
        vec3(1.0, 0.0, 0.0),
        vec3(1.0, -1.0, 0.0),
        vec3(1.0, -1.0, 1.0),
        vec3(0.0, -1.0, 1.0),
        vec3(0.0, 0.0, 1.0),
    ];
    let rods: Vec<_> = corners.windows(2).map(|c| rod(&mut w, c[0], c[1])).collect();
    // Each hinge's axis lies along the rod before the last: across both rods that it joins.
    let axis = [Vec3::y(), Vec3::z(), Vec3::x(), Vec3::y(), Vec3::z(), Vec3::x()];
    for k in 0..6 {
        let a = if k == 0 { g } else { rods[k - 1].0 };
        let b = if k == 5 { g } else { rods[k].0 };
        let turn = Quat::rotation_between(&Vec3::z(), &axis[k]).unwrap();
        join(&mut w, hinge, a, b, corners[k], turn);
    }
    let e0 = energy(&w);
    let (mut gap, mut drift, mut moved) = (0.0 as Float, 0.0_f64, 0.0 as Float);
    let start = place(&w, rods[2].0);
    for _ in 0..600 {
        w.try_step(DT, 4).unwrap();
        gap = gap.max(w.joint_gap().0);
        drift = drift.max((energy(&w) - e0).abs());
        moved = moved.max(length(place(&w, rods[2].0) - start));
    }
    println!("Bricard: gap {gap:.1e} m, energy {drift:.1e} J, moved {moved:.2} m");
    assert!(gap < 1e-3 && drift < 0.5 && moved > 0.3);
}

#[test]
fn two_joints_on_one_pair_and_coincident_frames_work() {
    let mut w = falling();
    let g = ground(&mut w);
    let b = body(&mut w, vec3(1.0, 0.0, 0.0));
    for _ in 0..5 {
        join(&mut w, JointKind::Spherical(SphericalJoint::default()), g, b, Vec3::zeros(), Quat::identity());
    }
    run(&mut w, 2.0);
    assert!((length(place(&w, b)) - 1.0).abs() < 1e-3);
    w.validate();
}

#[test]
fn joints_break_where_they_are_told() {
    let mut w = falling();
    let g = ground(&mut w);
    let b = body(&mut w, vec3(0.0, -1.0, 0.0));
    let mut def = JointDef::new(JointKind::Distance(DistanceJoint::default()), g, b);
    def.force_threshold = 15.0;
    def.breakable = true;
    let joint = w.create_joint(&def).unwrap();
    run(&mut w, 1.0);
    assert!(w.joint_events().is_empty() && w.joint_count() == 1, "10 N are not too much");
    for _ in 0..60 {
        w.body_mut(b).unwrap().apply_force_to_center(vec3(0.0, -6.0, 0.0), true).unwrap();
        w.try_step(DT, 4).unwrap();
        if let Some(event) = w.joint_events().first() {
            assert!(event.broke && event.joint == joint && (event.force - 16.0).abs() < 0.5, "{event:?}");
            assert_eq!(w.joint(joint).unwrap_err().code(), ErrorCode::Stale);
            run(&mut w, 0.5);
            assert!(place(&w, b).y < -1.5);
            return;
        }
    }
    panic!("16 N did not break it");
}

#[test]
fn jointed_bodies_sleep_and_wake_together_and_snapshots_hold() {
    let mut w = World::try_new(&WorldDef::default()).unwrap();
    let g = ground(&mut w);
    let mut last = g;
    let mut ids = Vec::new();
    for k in 0..5 {
        let b = body(&mut w, vec3(0.0, -0.5 - k as Float, 0.0));
        let kind = JointKind::Spherical(SphericalJoint { friction: 0.01, ..SphericalJoint::default() });
        join(&mut w, kind, last, b, vec3(0.0, -(k as Float), 0.0), Quat::identity());
        last = b;
        ids.push(b);
    }
    run(&mut w, 3.0);
    assert!(ids.iter().all(|&b| !w.body(b).unwrap().is_awake()), "a chain at rest sleeps");
    w.validate();
    w.body_mut(ids[2]).unwrap().apply_linear_impulse_to_center(vec3(1.0, 0.0, 0.0), true).unwrap();
    assert!(ids.iter().all(|&b| w.body(b).unwrap().is_awake()), "it wakes as a whole");
    run(&mut w, 0.5);
    let saved = w.save();
    run(&mut w, 1.0);
    let once = w.state_hash();
    w.restore(&saved).unwrap();
    run(&mut w, 1.0);
    assert_eq!(once, w.state_hash(), "a restored world lives the same life again");
    // Destroyed, disabled, enabled: the rest goes on.
    w.destroy_body(ids[3]).unwrap();
    assert_eq!(w.joint_count(), 3);
    w.body_mut(ids[1]).unwrap().disable();
    run(&mut w, 0.2);
    w.validate();
    w.body_mut(ids[1]).unwrap().enable();
    run(&mut w, 0.2);
    w.validate();
}

#[test]
fn what_is_wrong_is_refused_with_a_reason() {
    let mut w = floating();
    let (a, b) = (body(&mut w, Vec3::zeros()), body(&mut w, Vec3::x()));
    let code = |w: &mut World, def: &JointDef| w.create_joint(def).unwrap_err().code();
    let weld = JointKind::Weld(WeldJoint::default());
    assert_eq!(code(&mut w, &JointDef::new(weld, a, a)), ErrorCode::Range);
    assert_eq!(code(&mut w, &JointDef::new(weld, a, BodyId::NULL)), ErrorCode::Null);
    let bad = JointKind::Weld(WeldJoint { linear_hertz: Float::NAN, ..WeldJoint::default() });
    assert_eq!(code(&mut w, &JointDef::new(bad, a, b)), ErrorCode::NotFinite);
    let limit = Limit { enable: true, lower: 1.0, upper: -1.0 };
    let bad = JointKind::Revolute(RevoluteJoint { drive: Drive { limit, ..Drive::default() } });
    assert_eq!(code(&mut w, &JointDef::new(bad, a, b)), ErrorCode::Range);
    let mut def = JointDef::new(weld, a, b);
    def.force_threshold = -1.0;
    assert_eq!(code(&mut w, &def), ErrorCode::Range);
    let gear = JointKind::Gear(GearJoint { joints: [7, 8], ratio: 1.0 });
    assert_eq!(code(&mut w, &JointDef::new(gear, a, b)), ErrorCode::Stale);
    let id = w.create_joint(&JointDef::new(weld, a, b)).unwrap();
    let other = JointKind::Revolute(RevoluteJoint::default());
    assert_eq!(w.joint_mut(id).unwrap().set_kind(other).unwrap_err().code(), ErrorCode::Range);
    w.destroy_joint(id, true).unwrap();
    assert_eq!(w.destroy_joint(id, true).unwrap_err().code(), ErrorCode::Stale);
    assert_eq!(w.joint_count(), 0);
}

/// Joints of any kind between bodies far apart, turned anyhow, of all masses: nothing may leave the numbers.
#[test]
fn wild_joints_stay_finite() {
    let mut random = Random(99);
    let kinds = all_kinds();
    for round in 0..40 {
        let mut w = falling();
        let mut ids = vec![ground(&mut w)];
        for _ in 0..6 {
            let scale = [1e-3, 1.0, 1e3][random.below(3)];
            let p = random.vec(2.0);
            let id = heavy(&mut w, p, scale, Vec3::repeat(0.1 * scale));
            spin(&mut w, id, random.vec(20.0));
            ids.push(id);
        }
        for _ in 0..8 {
            let (a, b) = (ids[random.below(7)], ids[random.below(7)]);
            if a != b {
                let kind = kinds[random.below(kinds.len())];
                let def = JointDef::new(kind, a, b).frames(random.pose(1.0), random.pose(1.0));
                w.create_joint(&def).unwrap();
            }
        }
        for _ in 0..120 {
            w.try_step(DT, 4).unwrap();
        }
        let report = w.step_report();
        assert_eq!(report.quarantined, 0, "round {round}");
        assert!(report.kinetic_energy.is_finite(), "round {round}: {}", report.kinetic_energy);
        w.validate();
    }
}
