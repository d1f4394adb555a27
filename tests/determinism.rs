//! The same bits, whatever finds the pairs, however many lanes solve them, and whoever else is in the world.

mod common;

use common::Random;
use merev::broad_phase::BroadPhaseKind;
use merev::math::vec3;
use merev::solver::Lanes;
use merev::world::{BodyDef, ShapeDef, WorldDef};
use merev::{BodyId, Float, Shape, World};

/// A floor, a heap of mixed bodies with every kind of contact, and a kinematic sweeper.
fn heap(world: &mut World, at: Float) -> Vec<BodyId> {
    let mut random = Random(3);
    let floor = BodyDef::fixed(vec3(at, -0.5, 0.0));
    world.create_body_with_shape(&floor, &ShapeDef::default(), Shape::new_box(30.0, 1.0, 30.0)).unwrap();
    let mut sweeper = BodyDef::kinematic(vec3(at - 6.0, 0.5, 0.0));
    sweeper.linear_velocity = vec3(1.5, 0.0, 0.0);
    sweeper.angular_velocity = vec3(0.0, 0.7, 0.0);
    world.create_body_with_shape(&sweeper, &ShapeDef::default(), Shape::new_box(1.0, 1.0, 6.0)).unwrap();
    (0..150)
        .map(|i| {
            let place = vec3(
                at + (i % 5) as Float * 1.6 - 3.2,
                1.0 + (i / 25) as Float * 1.6,
                (i / 5 % 5) as Float * 1.6 - 3.2,
            );
            let mut body = BodyDef::dynamic(place + random.vec(0.2));
            body.rotation = random.rotation();
            body.linear_velocity = random.vec(2.0);
            body.angular_velocity = random.vec(5.0);
            let mut surface = ShapeDef::default();
            surface.material.restitution = if i % 3 == 0 { 0.6 } else { 0.0 };
            surface.material.rolling_resistance = if i % 4 == 0 { 0.05 } else { 0.0 };
            surface.material.friction = if i % 7 == 0 { 0.0 } else { 0.5 };
            if i % 11 == 0 {
                surface.material.tangent_velocity = vec3(0.5, 0.0, 0.0);
            }
            let shape = random.shape();
            world.create_body_with_shape(&body, &surface, shape).unwrap().0
        })
        .collect()
}

fn run(def: &WorldDef, steps: usize) -> Vec<u64> {
    let mut world = World::try_new(def).unwrap();
    heap(&mut world, 0.0);
    (0..steps)
        .map(|_| {
            world.try_step(1.0 / 60.0, 4).unwrap();
            world.state_hash()
        })
        .collect()
}

const STEPS: usize = 300;

#[test]
fn two_runs_broad_phases_and_lanes_agree_in_every_step() {
    let first = run(&WorldDef::default(), STEPS);
    assert_eq!(first, run(&WorldDef::default(), STEPS), "two runs");
    for broad_phase in BroadPhaseKind::ALL {
        for lanes in Lanes::ALL {
            let other = run(&WorldDef { broad_phase, lanes, ..WorldDef::default() }, STEPS);
            assert_eq!(first, other, "{} with {lanes:?}", broad_phase.name());
        }
    }
}

#[test]
fn a_neighbour_in_the_same_world_changes_no_bit() {
    let mut alone = World::try_new(&WorldDef::default()).unwrap();
    let a = heap(&mut alone, 0.0);
    let mut shared = World::try_new(&WorldDef::default()).unwrap();
    let b = heap(&mut shared, 0.0);
    heap(&mut shared, 500.0);
    heap(&mut shared, 1000.0);
    for step in 0..STEPS {
        alone.try_step(1.0 / 60.0, 4).unwrap();
        shared.try_step(1.0 / 60.0, 4).unwrap();
        for (&a, &b) in a.iter().zip(&b) {
            let (a, b) = (alone.body(a).unwrap(), shared.body(b).unwrap());
            let same = a.transform() == b.transform()
                && a.momentum() == b.momentum()
                && a.angular_momentum() == b.angular_momentum()
                && a.is_awake() == b.is_awake();
            assert!(same, "step {step}: body {:?}", a.id());
        }
    }
}

/// Hashes of the heap after 300 steps. They change only when the engine computes something differently, which is
/// then said in the change log; debug and release builds, and all platforms, agree.
#[test]
fn the_golden_hash_holds() {
    let golden: u64 = if size_of::<Float>() == 4 { GOLDEN_F32 } else { GOLDEN_F64 };
    let hash = *run(&WorldDef::default(), STEPS).last().unwrap();
    assert_eq!(hash, golden, "the state hashes to {hash:#018x}");
}

const GOLDEN_F32: u64 = 0xbc23177416b74e23;
const GOLDEN_F64: u64 = 0x60cb8b28f6cde70d;
