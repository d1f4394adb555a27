//! E: joints and chains.

use super::{G, loops, scene};
use crate::case::{Case, Reference, Track};
use crate::engines::Motion;
use crate::metrics::{crossings, energy, energy_change};
use crate::references::{chain, elliptic};
use crate::scene::{Body, Form, Hold, Joint, Mass, Scene, Spring};
use crate::vector::{V3, add, norm, rotate, sub, turn};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

pub fn cases() -> Vec<Case> {
    vec![
        pendulum("e1_pendulum_90", "a pendulum from 90°", 90.0, true),
        pendulum("e1_pendulum_170", "a pendulum from 170°", 170.0, true),
        pendulum("e1_rod_90", "a ball on a rod without mass, from 90°", 90.0, false),
        swinging("e2_double_pendulum", "two rods from the horizontal", 2, 1.0, 3.0),
        swinging("e3_chain_10", "ten rods from the horizontal", 10, 0.2, 1.0),
        swinging("e3_chain_20", "twenty rods from the horizontal", 20, 0.2, 0.5),
        hanging("e4_chain_1", "twenty links at rest, the last like the others", 1.0),
        hanging("e4_chain_100", "twenty links at rest, the last of 100 kg", 100.0),
        hanging("e4_chain_10000", "twenty links at rest, the last of 10 t", 1e4),
        four_bars("e6_four_bars_2", "three bars and two couplers fall over and come back", 2),
        four_bars("e6_four_bars_10", "eleven bars and ten couplers fall over and come back", 10)
            .defaults_only(),
        soft("e7_spring_1", "a soft slide at 1 Hz", 1.0, 0.1),
        soft("e7_spring_5", "a soft slide at 5 Hz", 5.0, 0.1),
        soft("e7_spring_5_undamped", "a soft slide at 5 Hz without damping", 5.0, 0.0),
        soft("e7_spring_5_critical", "a soft slide at 5 Hz, critically damped", 5.0, 1.0),
        soft("e7_spring_20", "a soft slide at 20 Hz", 20.0, 0.1),
        soft("e7_spring_60", "a soft slide at 60 Hz", 60.0, 0.1),
        soft("e7_spring_120", "a soft slide at 120 Hz", 120.0, 0.1),
        cantilever(),
    ]
    .into_iter()
    .chain(loops::cases())
    .collect()
}

/// The anchor of what hangs.
pub fn ground() -> Body {
    Body { collides: false, ..Body::fixed(Form::Sphere(0.02), [0.0; 3]) }
}

/// A thin rod along x.
pub fn rod(mass: f64, length: f64, at: V3) -> Body {
    let across = mass * length * length / 12.0;
    let mass = Some(Mass::new(mass, [0.01 * across, across, across]));
    Body { collides: false, mass, ..Body::dynamic(Form::Sphere(0.02), at) }
}

/// A point of a body.
pub fn point(m: &Motion, local: V3) -> V3 {
    add(m.position, rotate(m.rotation, local))
}

/// The mass sits on a bar that turns with it (a ball joint), or hangs by a rod that holds nothing but its distance.
pub fn pendulum_scene(name: &'static str, about: &'static str, amplitude: f64, bar: bool) -> Scene {
    let mut scene = scene(name, about);
    let (s, c) = libm::sincos(amplitude);
    scene.bodies.push(ground());
    scene.bodies.push(Body {
        collides: false,
        rotation: turn([0.0, 0.0, 1.0], amplitude - FRAC_PI_2),
        // As small as Box3D bears: a sphere of 5 mm.
        mass: Some(Mass::new(1.0, [1e-5; 3])),
        ..Body::dynamic(Form::Sphere(0.005), [s, -c, 0.0])
    });
    scene.joints.push(if bar {
        Joint::ball([0, 1], [[0.0; 3], [-1.0, 0.0, 0.0]])
    } else {
        Joint::new(Hold::Rod(1.0), [0, 1], [[0.0; 3]; 2])
    });
    scene
}

/// Its period \[s\]. The bar has no mass, the ball 1e-5 kg m²: if it turns with the bar, the pendulum is as much longer.
pub fn pendulum_period(amplitude: f64, bar: bool) -> f64 {
    elliptic::pendulum_period(if bar { 1.0 + 1e-5 } else { 1.0 }, amplitude, G)
}

fn pendulum(name: &'static str, about: &'static str, degrees: f64, bar: bool) -> Case {
    let amplitude = degrees * PI / 180.0;
    let scene = pendulum_scene(name, about, amplitude, bar);
    let period = pendulum_period(amplitude, bar);
    let judge = move |scene: &Scene, track: &Track| {
        let zeros = crossings(&track.times, &track.series(|f| f[0].position[0]), false, true);
        let n = zeros.len().saturating_sub(1);
        let found = if n == 0 { 0.0 } else { (zeros[n] - zeros[0]) / n as f64 };
        let gap = track.greatest(|f| (norm(f[0].position) - 1.0).abs());
        let energy = energy_change(scene, &track.frames, G);
        super::verdict((found / period - 1.0).abs()).and("joint_gap", gap).and("energy", energy)
    };
    Case::run('E', Reference::ClosedForm, scene, 4.0 * period, Box::new(judge))
        .primary("relative error of the period")
}

/// Thin rods along x from the origin, 1 kg but for the last.
pub fn rods(name: &'static str, about: &'static str, count: usize, size: f64, last: f64) -> Scene {
    let mut scene = scene(name, about);
    scene.bodies.push(ground());
    for i in 0..count {
        let mass = if i + 1 == count { last } else { 1.0 };
        scene.bodies.push(rod(mass, size, [(i as f64 + 0.5) * size, 0.0, 0.0]));
        let end = if i == 0 { 0.0 } else { 0.5 * size };
        scene.joints.push(Joint::ball([i, i + 1], [[end, 0.0, 0.0], [-0.5 * size, 0.0, 0.0]]));
    }
    scene
}

/// The greatest gap of a chain of rods.
pub fn chain_gap(frame: &[Motion], size: f64) -> f64 {
    let mut end = [0.0; 3];
    frame.iter().fold(0.0, |worst: f64, m| {
        let gap = norm(sub(point(m, [-0.5 * size, 0.0, 0.0]), end));
        end = point(m, [0.5 * size, 0.0, 0.0]);
        worst.max(gap)
    })
}

fn swinging(name: &'static str, about: &'static str, count: usize, size: f64, duration: f64) -> Case {
    let scene = rods(name, about, count, size, 1.0);
    let length = count as f64 * size;
    let judge = move |scene: &Scene, track: &Track| {
        let picks = track.moments(30);
        let times: Vec<f64> = picks.iter().map(|&k| track.times[k]).collect();
        let truth = chain::tips(count, size, G, &times);
        let off = picks.iter().zip(&truth).map(|(&k, t)| {
            let frame = &track.frames[k];
            norm(sub(point(&frame[count - 1], [0.5 * size, 0.0, 0.0]), [t[0], t[1], 0.0]))
        });
        let size_of_energy = count as f64 * G * length;
        super::verdict(off.fold(0.0, f64::max))
            .and("joint_gap", track.greatest(|f| chain_gap(f, size)) / size)
            .and("energy", energy_change(scene, &track.frames, size_of_energy))
    };
    Case::run('E', Reference::GoldenValues, scene, duration, Box::new(judge))
        .primary("greatest distance of the tip from its integrated way")
        .scale(length, "m, the length")
}

/// Rods of 0.2 m that hang at rest, the last one of another mass.
pub fn hanging_scene(name: &'static str, about: &'static str, count: usize, last: f64) -> Scene {
    let mut scene = rods(name, about, count, 0.2, last);
    let down = turn([0.0, 0.0, 1.0], -FRAC_PI_2);
    for body in scene.bodies.iter_mut().skip(1) {
        body.position = [0.0, -body.position[0], 0.0];
        body.rotation = down;
    }
    scene
}

/// How much longer than it should be a hanging chain is, as a share.
pub fn stretch(frame: &[Motion], count: usize) -> f64 {
    let length = 0.2 * count as f64;
    norm(sub(point(&frame[count - 1], [0.1, 0.0, 0.0]), [0.0, -length, 0.0])) / length
}

fn hanging(name: &'static str, about: &'static str, last: f64) -> Case {
    let scene = hanging_scene(name, about, 20, last);
    let judge = |_: &Scene, track: &Track| {
        super::verdict(stretch(track.last(), 20))
            .and("worst_stretch", track.greatest(|f| stretch(f, 20)))
            .and("joint_gap", track.greatest(|f| chain_gap(f, 0.2)) / 0.2)
    };
    Case::run('E', Reference::ClosedForm, scene, 10.0, Box::new(judge))
        .primary("distance of the end from where it should hang, over the length")
        .most_rate(480.0)
}

fn four_bars(name: &'static str, about: &'static str, windows: usize) -> Case {
    let mut scene = scene(name, about);
    scene.bodies.push(ground());
    let hinge = |a: usize, b: usize, la: V3, lb: V3| Joint::new(Hold::Hinge, [a, b], [la, lb]);
    // Bars stand on the ground a metre apart, couplers join their tops; all begin to fall towards +x at 1 m/s.
    for k in 0..=windows {
        let bar = Body {
            rotation: turn([0.0, 0.0, 1.0], FRAC_PI_2),
            velocity: [0.5, 0.0, 0.0],
            spin: [0.0, 0.0, -1.0],
            ..rod(1.0, 1.0, [k as f64, 0.5, 0.0])
        };
        scene.bodies.push(bar);
        scene.joints.push(hinge(0, 1 + k, [k as f64, 0.0, 0.0], [-0.5, 0.0, 0.0]));
    }
    for k in 0..windows {
        let coupler = scene.bodies.len();
        let body = rod(1.0, 1.0, [k as f64 + 0.5, 1.0, 0.0]);
        scene.bodies.push(Body { velocity: [1.0, 0.0, 0.0], ..body });
        scene.joints.push(hinge(1 + k, coupler, [0.5, 0.0, 0.0], [-0.5, 0.0, 0.0]));
        scene.joints.push(hinge(2 + k, coupler, [0.5, 0.0, 0.0], [0.5, 0.0, 0.0]));
    }
    let bars = windows + 1;
    let judge = move |scene: &Scene, track: &Track| {
        let size = G * (0.5 * bars as f64 + windows as f64);
        let gap = |f: &[Motion]| {
            (0..windows).fold(0.0_f64, |worst, k| {
                let coupler = &f[bars + k];
                let left = norm(sub(point(&f[k], [0.5, 0.0, 0.0]), point(coupler, [-0.5, 0.0, 0.0])));
                let right = norm(sub(point(&f[k + 1], [0.5, 0.0, 0.0]), point(coupler, [0.5, 0.0, 0.0])));
                worst.max(left).max(right)
            })
        };
        let flat = (energy(scene, track.last()) - energy(scene, track.first())) / size;
        super::verdict(energy_change(scene, &track.frames, size))
            .and("joint_gap", track.greatest(gap))
            .and("energy_at_end", flat)
    };
    Case::run('E', Reference::Invariant, scene, 4.0, Box::new(judge))
        .primary("greatest change of energy")
        .scale(1.0, "the energy of falling from upright to flat")
        .most_rate(480.0)
}

fn soft(name: &'static str, about: &'static str, hertz: f64, zeta: f64) -> Case {
    let mut scene = scene(name, about);
    scene.gravity = [0.0; 3];
    scene.bodies.push(ground());
    scene.bodies.push(Body {
        collides: false,
        mass: Some(Mass::new(1.0, [4e-3; 3])),
        ..Body::dynamic(Form::Sphere(0.1), [0.1, 0.0, 0.0])
    });
    let w = TAU * hertz;
    let spring = Spring { hertz, damping_ratio: zeta, mass: 1.0 };
    scene.joints.push(Joint::new(Hold::Slider(Some(spring)), [0, 1], [[0.0; 3]; 2]));
    let ringing = w * f64::sqrt(1.0 - zeta * zeta);
    let judge = move |_: &Scene, track: &Track| {
        let exact = |t: f64| {
            let (s, c) = libm::sincos(ringing * t);
            // sin(r t) / r, which is t where nothing rings.
            let way = if ringing > 0.0 { s / ringing } else { t };
            0.1 * libm::exp(-zeta * w * t) * (c + zeta * w * way)
        };
        let off = |k: usize| (track.frames[k][0].position[0] - exact(track.times[k])).abs();
        super::verdict((0..track.len()).map(off).fold(0.0, f64::max))
    };
    Case::run('E', Reference::ClosedForm, scene, 1.0, Box::new(judge))
        .primary("greatest error of the place")
        .scale(0.1, "m, the amplitude")
}

fn cantilever() -> Case {
    let mut scene = scene("e8_cantilever", "ten cubes welded in a row, held at one end");
    scene.bodies.push(ground());
    for i in 0..10 {
        let at = [0.1 + 0.2 * i as f64, 0.0, 0.0];
        scene.bodies.push(Body { collides: false, ..Body::dynamic(Form::Box([0.1; 3]), at) });
        let end = if i == 0 { [0.0; 3] } else { [0.1, 0.0, 0.0] };
        scene.joints.push(Joint::new(Hold::Weld, [i, i + 1], [end, [-0.1, 0.0, 0.0]]));
    }
    let judge = |_: &Scene, track: &Track| {
        let tip = |f: &[Motion]| norm(sub(point(&f[9], [0.1, 0.0, 0.0]), [2.0, 0.0, 0.0]));
        super::verdict(tip(track.last())).and("worst_deflection_m", track.greatest(tip))
    };
    Case::run('E', Reference::ClosedForm, scene, 5.0, Box::new(judge))
        .primary("deflection of the tip, at the end")
        .scale(2.0, "m, the length")
        .most_rate(960.0)
}
