//! Stacks, mass ratios and pyramids (accuracy.md D1, D2, D10): nothing sags, drifts or falls, upright or turned.

#[path = "common/scenes.rs"]
mod scenes;

use merev::math::length;
use merev::world::WorldDef;
use merev::{Float, Vec3};
use scenes::{heavy_on_light, orientations, pyramid, sleepless, stack};

/// How far bodies are from where they were put, at most.
fn drift(scene: &scenes::Scene, bodies: &[merev::BodyId], start: &[Vec3]) -> Float {
    bodies.iter().zip(start).map(|(&b, &s)| length(scene.position(b) - s)).fold(0.0, Float::max)
}

#[test]
fn stacks_of_10_and_20_neither_sag_nor_drift_in_20_s() {
    for turn in orientations() {
        for n in [10, 20] {
            let (mut scene, bodies) = stack(&sleepless(), turn, n);
            let start: Vec<Vec3> = bodies.iter().map(|&b| scene.position(b)).collect();
            scene.steps(1200);
            let overlap = scene.world.step_report().worst_penetration;
            let drift = drift(&scene, &bodies, &start);
            println!("stack of {n}: overlap {:.4} mm, drift {:.4} mm", overlap * 1e3, drift * 1e3);
            assert!(overlap < 0.5e-3, "stack of {n}: overlap {overlap} m");
            assert!(drift < 1e-3, "stack of {n}: drift {drift} m");
        }
    }
}

#[test]
fn heavy_on_light_does_not_sag() {
    for turn in orientations() {
        for ratio in [1.0, 10.0, 100.0] {
            let mut scene = heavy_on_light(&sleepless(), turn, ratio);
            scene.steps(1200);
            let overlap = scene.world.step_report().worst_penetration;
            println!("{ratio} on 1: overlap {:.4} mm", overlap * 1e3);
            assert!(overlap < 0.5e-3, "{ratio} on 1: overlap {overlap} m");
        }
    }
}

#[test]
fn pyramids_of_10_and_100_rows_stand() {
    for turn in orientations() {
        for rows in [10, 100] {
            let (mut scene, bodies) = pyramid(&sleepless(), turn, rows);
            let start: Vec<Vec3> = bodies.iter().map(|&b| scene.position(b)).collect();
            scene.steps(600);
            let top = scene.position(*bodies.last().unwrap());
            let sideways = bodies
                .iter()
                .zip(&start)
                .map(|(&b, s)| (scene.position(b) - s).z.abs())
                .fold(0.0, Float::max);
            println!("pyramid of {rows}: top at {:.4} m, {:.4} m sideways", top.y, sideways);
            assert!(top.y > rows as Float - 1.2, "pyramid of {rows}: top at {}", top.y);
            assert!(sideways < 0.2, "pyramid of {rows}: {sideways} m sideways");
        }
    }
}

#[test]
fn all_of_them_fall_asleep_within_30_s() {
    let def = WorldDef::default();
    let until_asleep = |name: &str, mut scene: scenes::Scene| {
        for second in 1..=30 {
            scene.steps(60);
            if scene.all_asleep() {
                println!("{name} sleeps after {second} s");
                return;
            }
        }
        panic!("{name}: {} bodies awake after 30 s", scene.world.counters().awake_bodies);
    };
    for turn in orientations() {
        until_asleep("stack of 10", stack(&def, turn, 10).0);
        until_asleep("stack of 20", stack(&def, turn, 20).0);
        for ratio in [1.0, 10.0, 100.0] {
            until_asleep("heavy on light", heavy_on_light(&def, turn, ratio));
        }
        until_asleep("pyramid of 10", pyramid(&def, turn, 10).0);
        until_asleep("pyramid of 100", pyramid(&def, turn, 100).0);
    }
}
