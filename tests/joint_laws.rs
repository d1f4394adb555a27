//! Joints against closed forms and golden values: pendulums, chains, springs. Each scene runs upright and turned as a
//! whole by a random rotation.

mod common;

use common::Random;
use merev::constraint::joint::{
    DistanceJoint, Drive, JointKind, PrismaticJoint, RevoluteJoint, SphericalJoint, Spring,
};
use merev::math::{length, scalar, vec3};
use merev::shape::MassData;
use merev::world::{BodyDef, JointDef, WorldDef};
use merev::{BodyId, Float, Mat3, Pose, Quat, Vec3, World};

const SINGLE: bool = size_of::<Float>() == 4;
const G: Float = 9.81;
const DT: Float = 1.0 / 60.0;

/// The rotations that every scene is tried in.
fn turns() -> [Quat; 2] {
    [Quat::identity(), Random(77).rotation()]
}

/// A world whose gravity is turned by `q`.
fn world(q: &Quat) -> World {
    let def = WorldDef { gravity: q * vec3(0.0, -G, 0.0), enable_sleep: false, ..WorldDef::default() };
    World::try_new(&def).unwrap()
}

fn body(world: &mut World, q: &Quat, at: Vec3, mass: Float, inertia: Vec3) -> BodyId {
    let def = BodyDef { rotation: *q, ..BodyDef::dynamic(q * at) };
    let id = world.create_body(&def).unwrap();
    let data = MassData { mass, center: Vec3::zeros(), inertia: Mat3::from_diagonal(&inertia) };
    world.body_mut(id).unwrap().set_mass_data(&data).unwrap();
    id
}

fn fixed(world: &mut World, q: &Quat) -> BodyId {
    world.create_body(&BodyDef { rotation: *q, ..BodyDef::fixed(Vec3::zeros()) }).unwrap()
}

fn at(p: Vec3) -> Pose {
    Pose::new(p, Quat::identity())
}

/// A thin rod along x with its centre at `x`.
fn rod(world: &mut World, q: &Quat, x: Float, size: Float, mass: Float) -> BodyId {
    let i = mass * size * size / 12.0;
    body(world, q, vec3(x, 0.0, 0.0), mass, vec3(0.01 * i, i, i))
}

/// A chain of rods from the origin along x, held by ball joints; the last one has the mass `last`.
fn chain(world: &mut World, q: &Quat, count: usize, size: Float, last: Float) -> Vec<BodyId> {
    let ground = fixed(world, q);
    let mut rods = Vec::new();
    for i in 0..count {
        let mass = if i + 1 == count { last } else { 1.0 };
        let rod = rod(world, q, (i as Float + 0.5) * size, size, mass);
        let (other, end) =
            if i == 0 { (ground, Vec3::zeros()) } else { (rods[i - 1], vec3(0.5 * size, 0.0, 0.0)) };
        let kind = JointKind::Spherical(SphericalJoint::default());
        let def = JointDef::new(kind, other, rod).frames(at(end), at(vec3(-0.5 * size, 0.0, 0.0)));
        world.create_joint(&def).unwrap();
        rods.push(rod);
    }
    rods
}

/// The far end of a rod, turned back.
fn tip(world: &World, q: &Quat, rod: BodyId, size: Float) -> Vec3 {
    let body = world.body(rod).unwrap();
    q.inverse() * (body.transform().point(vec3(0.5 * size, 0.0, 0.0)))
}

#[test]
fn a_pendulum_keeps_its_period_and_energy() {
    for q in turns() {
        for (amplitude, period) in [(90.0, 2.367_842), (170.0, 4.893_524)] {
            let mut w = world(&q);
            let ground = fixed(&mut w, &q);
            let start = (amplitude as Float).to_radians();
            let bob =
                body(&mut w, &q, vec3(scalar::sin(start), -scalar::cos(start), 0.0), 1.0, Vec3::repeat(1e-6));
            let arm = -vec3(scalar::sin(start), -scalar::cos(start), 0.0);
            let kind = JointKind::Revolute(RevoluteJoint::default());
            w.create_joint(&JointDef::new(kind, ground, bob).frames(at(Vec3::zeros()), at(arm))).unwrap();
            let energy = |w: &World| w.step_report().kinetic_energy + w.step_report().potential_energy;
            let e0 = energy(&w);
            let (mut crossings, mut last, mut gap, mut drift) =
                (Vec::new(), 1.0 as Float, 0.0 as Float, 0.0_f64);
            for step in 1..=900 {
                w.try_step(DT, 4).unwrap();
                let p = q.inverse() * w.body(bob).unwrap().world_center();
                gap = gap.max((length(p) - 1.0).abs());
                drift = drift.max((energy(&w) - e0).abs());
                if last > 0.0 && p.x <= 0.0 {
                    crossings.push((step as Float - p.x / (p.x - last)) * DT);
                }
                last = p.x;
            }
            let n = crossings.len() - 1;
            let measured = (crossings[n] - crossings[0]) / n as Float;
            let error = (measured / period - 1.0).abs();
            println!("{amplitude}°: period off by {error:.1e}, gap {gap:.1e} m, energy {:.1e}", drift / 9.81);
            assert!(error < if amplitude < 100.0 { 6e-4 } else { 2e-3 }, "period {measured}");
            assert!(gap < 4e-4 && drift < 0.01 * 9.81, "gap {gap}, energy {drift}");
        }
    }
}

#[test]
fn a_double_pendulum_follows_the_golden_values() {
    for q in turns() {
        let mut w = world(&q);
        let rods = chain(&mut w, &q, 2, 1.0, 1.0);
        let golden = [
            (60, vec3(-1.662_115_1, -1.041_466_6, 0.0)),
            (120, vec3(0.313_524_8, -1.914_746_6, 0.0)),
            (180, vec3(1.330_436_8, -1.398_644_9, 0.0)),
        ];
        for step in 1..=180 {
            w.try_step(DT, 4).unwrap();
            if let Some((_, want)) = golden.iter().find(|g| g.0 == step) {
                let error = length(tip(&w, &q, rods[1], 1.0) - want);
                println!("t = {} s: tip off by {error:.1e} m, gap {:.1e} m", step / 60, w.joint_gap().0);
                assert!(error < 0.02);
            }
        }
    }
}

#[test]
fn a_chain_follows_the_golden_values() {
    for q in turns() {
        for (count, golden) in [
            (10, vec![(30, vec3(1.296_165_5, -1.229_563, 0.0)), (60, vec3(-1.764_752_5, -0.927_582_9, 0.0))]),
            (20, vec![(30, vec3(3.509_259, -1.226_253, 0.0)), (60, vec3(-1.057_89, -3.400_939_2, 0.0))]),
        ] {
            let mut w = world(&q);
            let rods = chain(&mut w, &q, count, 0.2, 1.0);
            for step in 1..=60 {
                w.try_step(DT, 4).unwrap();
                if let Some((_, want)) = golden.iter().find(|g| g.0 == step) {
                    let error = length(tip(&w, &q, rods[count - 1], 0.2) - want);
                    println!("{count} links, step {step}: {error:.1e} m, gap {:.1e} m", w.joint_gap().0);
                    assert!(error < 0.05);
                }
            }
        }
    }
}

#[test]
fn a_hanging_chain_does_not_stretch() {
    for q in turns() {
        for heavy in [1.0, 100.0, 1e3, 1e4, 1e5] {
            // Built hanging, to see what the load does.
            let mut w = world(&q);
            let down = Quat::from_axis_angle(&Vec3::z_axis(), -scalar::PI / 2.0);
            let rods = chain(&mut w, &(q * down), 20, 0.2, heavy);
            for _ in 0..600 {
                w.try_step(DT, 4).unwrap();
            }
            let end = tip(&w, &(q * down), rods[19], 0.2);
            let stretch = (length(end) - 4.0).abs() / 4.0;
            println!("20 links, the last {heavy} kg: stretched by {:.5} %", 100.0 * stretch);
            assert!(stretch < 1e-3);
        }
    }
}

#[test]
fn a_spring_swings_and_settles_as_asked() {
    for q in turns() {
        for hertz in [1.0, 5.0, 20.0, 48.0] {
            for zeta in [0.0, 0.1, 1.0] {
                let mut w = World::try_new(&WorldDef {
                    gravity: Vec3::zeros(),
                    enable_sleep: false,
                    ..Default::default()
                })
                .unwrap();
                let ground = fixed(&mut w, &q);
                let weight = body(&mut w, &q, vec3(0.1, 0.0, 0.0), 1.0, Vec3::repeat(0.1));
                let spring = Spring { enable: true, hertz, damping_ratio: zeta, ..Spring::default() };
                let kind =
                    JointKind::Prismatic(PrismaticJoint { drive: Drive { spring, ..Drive::default() } });
                w.create_joint(&JointDef::new(kind, ground, weight)).unwrap();
                let (omega, mut worst) = (2.0 * std::f64::consts::PI * scalar::double(hertz), 0.0_f64);
                let zeta = scalar::double(zeta);
                for step in 1..=60 {
                    w.try_step(DT, 4).unwrap();
                    let x = (q.inverse() * w.body(weight).unwrap().world_center()).x;
                    let t = f64::from(step) / 60.0;
                    let exact = if zeta < 1.0 {
                        let wd = omega * (1.0 - zeta * zeta).sqrt();
                        libm::exp(-zeta * omega * t)
                            * (libm::cos(wd * t) + zeta * omega / wd * libm::sin(wd * t))
                    } else {
                        libm::exp(-omega * t) * (1.0 + omega * t)
                    };
                    worst = worst.max((scalar::double(x) / 0.1 - exact).abs());
                }
                println!(
                    "{hertz} Hz, ζ {zeta:.1}, f h {:.3}: off by {worst:.1e} of the start",
                    hertz / 240.0
                );
                assert!(worst < if SINGLE { 2e-3 } else { 1e-6 });
            }
        }
    }
}

#[test]
fn a_weight_on_a_spring_sags_as_it_should() {
    for q in turns() {
        let mut w = world(&q);
        let ground = fixed(&mut w, &q);
        let weight = body(&mut w, &q, vec3(0.0, -1.0, 0.0), 2.0, Vec3::repeat(0.1));
        let kind = JointKind::Distance(DistanceJoint {
            length: 1.0,
            enable_spring: true,
            hertz: 2.0,
            damping_ratio: 0.5,
            ..DistanceJoint::default()
        });
        w.create_joint(&JointDef::new(kind, ground, weight)).unwrap();
        for _ in 0..600 {
            w.try_step(DT, 4).unwrap();
        }
        let omega = 2.0 * scalar::PI * 2.0;
        let sag = -(q.inverse() * w.body(weight).unwrap().world_center()).y - 1.0;
        println!("sag {sag} m, wanted {}", G / (omega * omega));
        assert!((sag / (G / (omega * omega)) - 1.0).abs() < 1e-3);
    }
}
