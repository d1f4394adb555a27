//! B: impacts.

use super::{G, scene};
use crate::case::{Case, Reference, Track};
use crate::engines::Motion;
use crate::metrics::{apexes, crossings, energy, kinetic, momentum};
use crate::scene::{Body, Form, Scene};
use crate::vector::{norm, sub, turn};
use std::f64::consts::FRAC_PI_6;

pub fn cases() -> Vec<Case> {
    vec![
        bouncing_ball(),
        elastic_balls(),
        cradle("b3_cradle", "five balls with gaps of 2 mm, elastic", 2e-3, 1.0),
        cradle("b3_cradle_close", "five balls with gaps of 0.1 mm, elastic", 1e-4, 1.0),
        cradle("b3_cradle_wide", "five balls with gaps of 20 mm, elastic", 2e-2, 1.0),
        cradle("b3_cradle_touching", "five balls that touch, elastic", 0.0, 1.0),
        cradle("b3_cradle_inelastic", "five balls with gaps of 2 mm, e = 0.9", 2e-3, 0.9),
        rod(0.0),
        rod(0.5),
        rod(1.0),
        balls_666(),
        balls_666_elastic(),
        overlap(),
        rest_noise(),
    ]
}

/// A scene where even the slowest impact bounces.
fn bouncy(name: &'static str, about: &'static str) -> Scene {
    Scene { restitution_threshold: Some(0.0), ..scene(name, about) }
}

fn bouncing_ball() -> Case {
    let mut scene = bouncy("b1_bouncing_ball", "a ball falls 1 m and bounces with e = 0.8");
    let surface = |b: Body| Body { restitution: 0.8, friction: 0.0, ..b };
    scene.floor_of([5.0, 1.0, 5.0], surface);
    scene.bodies.push(surface(Body::dynamic(Form::Sphere(0.1), [0.0, 1.1, 0.0])));
    let judge = |_: &Scene, track: &Track| {
        let heights = track.series(|f| f[0].position[1] - 0.1);
        let speeds = track.series(|f| f[0].velocity[1]);
        let found = apexes(&heights, &speeds, G);
        let mut exact = 1.0;
        let mut off = Vec::new();
        for k in 0..5 {
            exact *= 0.64;
            off.push(found.get(k).map_or(1.0, |h| (h / exact - 1.0).abs()));
        }
        // An apex after the first flight tells when that flight began.
        let fall = (2.0_f64 / G).sqrt();
        let turns = crossings(&track.times, &speeds, false, true);
        let time = fall * 2.6;
        let late = turns.first().map_or(1.0, |t| (t - fall - 0.8 * fall).abs() / time);
        super::verdict(off.iter().copied().fold(0.0, f64::max))
            .and("first_peak", off[0])
            .and("first_apex_time", late)
            .and("penetration", -heights.iter().copied().fold(0.0, f64::min) / 0.1)
    };
    Case::run('B', Reference::ClosedForm, scene, 3.6, Box::new(judge))
        .primary("greatest relative error of the first five peaks; 1 for a missing one")
}

fn elastic_balls() -> Case {
    let mut scene = bouncy("b2_elastic_balls", "nine balls fall 5 m and bounce with e = 1");
    let surface = |b: Body| Body { restitution: 1.0, friction: 0.0, ..b };
    scene.floor_of([10.0, 1.0, 10.0], surface);
    for i in 0..9 {
        let (x, z) = (f64::from(i % 3), f64::from(i / 3));
        scene.bodies.push(surface(Body::dynamic(Form::Sphere(0.1), [x, 5.1, z])));
    }
    let judge = |_: &Scene, track: &Track| {
        let (mut sum, mut count, mut drift) = (0.0, 0.0, 0.0_f64);
        for i in 0..9 {
            let heights = track.series(|f| f[i].position[1] - 0.1);
            let found = apexes(&heights, &track.series(|f| f[i].velocity[1]), G);
            // A bounce takes 2.02 s; a ball that no longer bounces has lost all.
            for k in 0..9 {
                let off = found.get(k).map_or(1.0, |h| h / 5.0 - 1.0);
                (sum, count) = (sum + off * off, count + 1.0);
                drift = drift.max(off.abs());
            }
        }
        super::verdict(f64::sqrt(sum / count)).and("worst_peak", drift)
    };
    Case::run('B', Reference::ClosedForm, scene, 19.2, Box::new(judge))
        .primary("root mean square of the relative errors of nine peaks each; 1 for a missing one")
        .most_rate(480.0)
}

fn cradle(name: &'static str, about: &'static str, gap: f64, e: f64) -> Case {
    let mut scene = bouncy(name, about);
    scene.gravity = [0.0; 3];
    for i in 0..5 {
        let x = if i == 0 { -0.1 } else { (0.2 + gap) * f64::from(i) };
        let velocity = [if i == 0 { 1.0 } else { 0.0 }, 0.0, 0.0];
        scene.bodies.push(Body {
            velocity,
            restitution: e,
            friction: 0.0,
            ..Body::dynamic(Form::Sphere(0.1), [x, 0.0, 0.0])
        });
    }
    // One impact after another hands on (1 + e)/2 of the speed and keeps (1 − e)/2.
    let (on, keep) = (0.5 * (1.0 + e), 0.5 * (1.0 - e));
    let mut exact = [0.0; 5];
    let mut speed = 1.0;
    for v in exact.iter_mut().take(4) {
        (*v, speed) = (speed * keep, speed * on);
    }
    exact[4] = speed;
    // The faster ones behind would catch up only later: e = 0.9 leaves them in order.
    let judge = move |scene: &Scene, track: &Track| {
        let off = track.last().iter().zip(exact).map(|(m, v)| (m.velocity[0] - v).abs()).sum();
        let (p, k) = (momentum(scene, track.first()), kinetic(scene, track.first()));
        let k_exact: f64 = exact.iter().map(|v| v * v).sum();
        super::verdict(off)
            .and("momentum", norm(sub(momentum(scene, track.last()), p)) / norm(p))
            .and("energy", (kinetic(scene, track.last()) / k - k_exact).abs())
    };
    Case::run('B', Reference::ClosedForm, scene, 0.5, Box::new(judge))
        .primary("sum of the errors of the velocities after impacts one after another")
        .scale(1.0, "m/s, the first ball's speed")
}

fn rod(e: f64) -> Case {
    let (name, about) = match e {
        0.0 => ("b5_rod_0", "a slanted rod hits the floor, e = 0"),
        0.5 => ("b5_rod_05", "a slanted rod hits the floor, e = 0.5"),
        _ => ("b5_rod_1", "a slanted rod hits the floor, e = 1"),
    };
    let mut scene = bouncy(name, about);
    scene.gravity = [0.0; 3];
    let (half, thin, speed) = (0.5, 0.025, 3.0);
    let (s, c) = libm::sincos(FRAC_PI_6);
    // Of the lower corner, from the centre: its lever and its depth.
    let (lever, depth) = (half * c - thin * s, half * s + thin * c);
    let surface = |b: Body| Body { restitution: e, friction: 0.0, ..b };
    scene.floor_of([5.0, 1.0, 5.0], surface);
    scene.bodies.push(surface(Body {
        rotation: turn([0.0, 0.0, 1.0], FRAC_PI_6),
        velocity: [0.0, -speed, 0.0],
        density: 1.0 / (8.0 * half * thin * thin),
        ..Body::dynamic(Form::Box([half, thin, thin]), [0.0, depth + 0.05, 0.0])
    }));
    let inertia = (half * half + thin * thin) / 3.0;
    let p = (1.0 + e) * speed / (1.0 + lever * lever / inertia);
    // The lower corner is at −x: the impulse turns the rod clockwise seen from z.
    let (v, w) = (p - speed, -p * lever / inertia);
    let judge = move |_: &Scene, track: &Track| {
        let m = &track.last()[0];
        let off = norm(sub(m.velocity, [0.0, v, 0.0])) / speed;
        let turn = norm(sub(m.spin, [0.0, 0.0, w])) * half / speed;
        super::verdict(off.max(turn)).and("velocity", off).and("spin", turn)
    };
    Case::run('B', Reference::ClosedForm, scene, 1.0 / 12.0, Box::new(judge))
        .primary("greatest of the errors of velocity and of spin × half length, over the speed of impact")
}

/// 6 × 6 × 6 balls over a floor.
fn block_of_balls(scene: &mut Scene, height: f64, e: f64) {
    let surface = |b: Body| Body { restitution: e, friction: 0.0, ..b };
    scene.floor_of([20.0, 1.0, 20.0], surface);
    let mut random = super::Random::new(666);
    let density = 10.0 / (4.0 / 3.0 * std::f64::consts::PI * 1e-3);
    for i in 0..216 {
        let at = [i % 6, i / 6 % 6, i / 36].map(|k| 0.21 * f64::from(k) + 1e-3 * random.half());
        let position = [at[0], at[1] + height, at[2]];
        scene.bodies.push(surface(Body { density, ..Body::dynamic(Form::Sphere(0.1), position) }));
    }
}

fn balls_666() -> Case {
    let mut scene = bouncy("b7_666_balls", "216 balls without friction fall and spread");
    block_of_balls(&mut scene, 0.101, 0.0);
    let judge = |_: &Scene, track: &Track| {
        let overlap = |f: &[Motion]| {
            let floor = f.iter().map(|m| 0.1 - m.position[1]).fold(0.0, f64::max);
            (0..f.len()).fold(floor, |worst, i| {
                (0..i).fold(worst, |w, k| w.max(0.2 - norm(sub(f[i].position, f[k].position))))
            })
        };
        let picks = track.moments(60);
        let all: Vec<f64> = picks.iter().map(|&k| overlap(&track.frames[k]) / 0.1).collect();
        let mean = all.iter().sum::<f64>() / all.len() as f64;
        super::verdict(all.iter().copied().fold(0.0, f64::max)).and("mean_overlap", mean)
    };
    Case::run('B', Reference::Invariant, scene, 2.0, Box::new(judge))
        .primary("deepest overlap in 60 moments, over the radius")
        .most_rate(240.0)
}

fn balls_666_elastic() -> Case {
    let mut scene = bouncy("b8_666_balls_elastic", "216 elastic balls fall and jump");
    block_of_balls(&mut scene, 1.101, 1.0);
    let judge = |scene: &Scene, track: &Track| {
        let start = energy(scene, track.first());
        let picks = track.moments(60);
        let off = picks.iter().map(|&k| (energy(scene, &track.frames[k]) / start - 1.0).abs());
        super::verdict(off.fold(0.0, f64::max)).and("end", energy(scene, track.last()) / start - 1.0)
    };
    Case::run('B', Reference::Invariant, scene, 2.0, Box::new(judge))
        .primary("greatest change of energy in 60 moments, over the energy")
        .most_rate(240.0)
}

fn overlap() -> Case {
    let mut scene = scene("b9_overlap", "ten boxes that begin a quarter inside each other");
    scene.floor([20.0, 1.0, 20.0]);
    for row in 0..4 {
        for k in 0..4 - row {
            let (x, y) = (0.75 * (f64::from(k) + 0.5 * f64::from(row)), 0.5 + 0.75 * f64::from(row));
            scene.bodies.push(Body::dynamic(Form::Box([0.5; 3]), [x, y, 0.0]));
        }
    }
    let judge = |scene: &Scene, track: &Track| {
        let size = 1000.0 * G;
        let kick = track.greatest(|f| kinetic(scene, f)) / size;
        let spread = track.greatest(|f| f.iter().map(|m| m.position[0].abs()).fold(0.0, f64::max));
        super::verdict(kick).and("farthest_m", spread)
    };
    Case::run('B', Reference::Invariant, scene, 2.0, Box::new(judge))
        .primary("greatest kinetic energy")
        .scale(1.0, "m g L of a box")
        .most_rate(960.0)
}

fn rest_noise() -> Case {
    let mut scene = scene("b10_rest_noise", "a box at rest");
    scene.floor([20.0, 1.0, 20.0]);
    scene.bodies.push(Body::dynamic(Form::Box([0.5; 3]), [0.0, 0.5, 0.0]));
    let judge = |_: &Scene, track: &Track| {
        let late = &track.frames[track.len() / 2..];
        let v2: f64 = late.iter().map(|f| norm(f[0].velocity) * norm(f[0].velocity)).sum();
        let speed = (v2 / late.len() as f64).sqrt();
        let creep = norm(sub(track.last()[0].position, late[0][0].position));
        super::verdict(speed).and("sink", (0.5 - track.last()[0].position[1]).abs()).and("creep", creep)
    };
    Case::run('B', Reference::Invariant, scene, 20.0, Box::new(judge))
        .primary("root mean square of the speed in the second half")
        .scale(G.sqrt(), "m/s, √(g L)")
        .most_rate(480.0)
}
