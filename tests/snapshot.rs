//! A restored snapshot has the same future, bit for bit.

mod common;

use common::{Random, random_body, random_world};
use merev::broad_phase::BroadPhaseKind;
use merev::world::{Identity, WorldDef};
use merev::{BodyId, ErrorCode, World};

/// Some steps in which bodies also come, go and are thrown about, as `seed` has it; the hash after each of them.
fn live(world: &mut World, bodies: &mut Vec<BodyId>, seed: u64) -> Vec<u64> {
    let mut random = Random(seed);
    let mut hashes = Vec::new();
    for _ in 0..30 {
        match random.below(4) {
            0 => bodies.push(random_body(world, &mut random)),
            1 => world.destroy_body(bodies.swap_remove(random.below(bodies.len()))).unwrap(),
            2 => {
                let body = bodies[random.below(bodies.len())];
                world.body_mut(body).unwrap().set_transform(&random.pose(5.0)).unwrap();
            }
            _ => {}
        }
        world.try_step(1.0 / 60.0, 4).unwrap();
        hashes.push(world.state_hash());
    }
    hashes
}

#[test]
fn a_restored_world_lives_the_same_life_again() {
    for (k, kind) in BroadPhaseKind::ALL.into_iter().enumerate() {
        // The default is tried longer.
        for seed in 0..if kind == BroadPhaseKind::DynamicBvh { 4 } else { 1 } {
            let seed = seed + k as u64;
            let (mut world, mut bodies) = random_world(kind, seed, 60);
            live(&mut world, &mut bodies, seed);
            let (saved, known) = (world.save(), bodies.clone());
            let hash = world.state_hash();
            let first = live(&mut world, &mut bodies, seed + 100);
            // Another life in between must leave no trace.
            live(&mut world, &mut bodies, seed + 200);
            for _ in 0..2 {
                world.restore(&saved).unwrap();
                assert_eq!(world.state_hash(), hash);
                assert_eq!(live(&mut world, &mut known.clone(), seed + 100), first);
            }
        }
    }
}

#[test]
fn all_broad_phases_live_the_same_life() {
    let lives = BroadPhaseKind::ALL.map(|kind| {
        let (mut world, mut bodies) = random_world(kind, 9, 60);
        live(&mut world, &mut bodies, 10)
    });
    assert!(lives.iter().all(|life| *life == lives[0]));
}

#[test]
fn ids_given_out_after_the_save_are_stale_and_those_destroyed_live_again() {
    let (mut world, bodies) = random_world(BroadPhaseKind::Auto, 3, 10);
    let shapes: Vec<_> = bodies.iter().flat_map(|&b| world.body(b).unwrap().shapes()).collect();
    let saved = world.save();
    let mut random = Random(4);
    world.destroy_body(bodies[0]).unwrap();
    let late: Vec<BodyId> = (0..5).map(|_| random_body(&mut world, &mut random)).collect();
    let late_shapes: Vec<_> = late.iter().flat_map(|&b| world.body(b).unwrap().shapes()).collect();

    world.restore(&saved).unwrap();
    assert!(bodies.iter().all(|&b| world.body(b).is_ok()));
    assert!(shapes.iter().all(|&s| world.shape(s).is_ok()));
    assert!(late.iter().all(|&b| world.body(b).unwrap_err().code() == ErrorCode::Stale));
    assert!(late_shapes.iter().all(|&s| world.shape(s).unwrap_err().code() == ErrorCode::Stale));
    // Not even when their slots are used again.
    let again: Vec<BodyId> = (0..8).map(|_| random_body(&mut world, &mut random)).collect();
    assert!(late.iter().all(|b| world.body(*b).is_err() && !again.contains(b)));
}

#[test]
fn a_snapshot_of_another_world_is_refused() {
    let world = |tag| World::try_with_identity(&WorldDef::default(), Identity::new(tag)).unwrap();
    let (mut a, b) = (world(1), world(2));
    let before = a.state_hash();
    let error = a.restore(&b.save()).unwrap_err();
    assert_eq!((error.code(), error.sentence()), (ErrorCode::Foreign, "The snapshot is of another world."));
    assert_eq!(a.state_hash(), before);
}
