//! A: free motion, where only the integrator counts.

use super::{G, scene};
use crate::case::{Case, Reference, Track, Verdict};
use crate::engines::Motion;
use crate::metrics::{angular_momentum, crossings, energy, energy_change, kinetic};
use crate::references::top;
use crate::scene::{Body, Form, Hold, Joint, Mass, Scene, Spring};
use crate::vector::{V3, add, angle_between, conjugate, norm, rotate, scale, sub};
use std::f64::consts::TAU;

pub fn cases() -> Vec<Case> {
    vec![ballistic(), stable_spin(), tumbling(), dzhanibekov(), fast_slender(), soft_spring()]
}

fn ballistic() -> Case {
    let mut scene = scene("a1_ballistic", "a thrown ball");
    let (start, velocity) = ([0.0; 3], [-2.0, 8.0, 2.0]);
    scene.bodies.push(Body { velocity, ..Body::dynamic(Form::Sphere(0.5), start) });
    let judge = move |scene: &Scene, track: &Track| {
        let off = |k: usize| {
            let t = track.times[k];
            let there = add(scale(velocity, t), [0.0, -0.5 * G * t * t, 0.0]);
            norm(sub(track.frames[k][0].position, there))
        };
        let error = track.moments(100).into_iter().map(off).fold(0.0, f64::max);
        let size = energy(scene, track.first());
        super::verdict(error).and("energy", energy_change(scene, &track.frames, size))
    };
    Case::run('A', Reference::ClosedForm, scene, 10.0, Box::new(judge))
        .primary("greatest distance from the parabola")
        .scale(1.0, "m, the ball's diameter")
        .integrators()
}

/// The box of scenes A2 to A5: 10 kg.
pub fn box_of_ten(spin: V3) -> Body {
    let half = [0.05, 0.2, 0.45];
    Body { spin, density: 10.0 / (0.1 * 0.4 * 0.9), ..Body::dynamic(Form::Box(half), [0.0; 3]) }
}

/// Its principal moments \[kg m²\].
const INERTIA: V3 = [10.0 / 12.0 * 0.97, 10.0 / 12.0 * 0.82, 10.0 / 12.0 * 0.17];

pub fn stable_spin_scene() -> Scene {
    let mut scene = scene("a2_stable_spin", "a box that spins about its axis of greatest inertia");
    scene.gravity = [0.0; 3];
    scene.bodies.push(Body { velocity: [-0.9, 0.4, 0.1], ..box_of_ten([0.5, 0.0, 0.0]) });
    scene
}

/// How far a run of A2 is from the truth, all that a wrong frame or unit would show in together.
pub fn stable_spin_error(track: &Track) -> f64 {
    let off = |k: usize| {
        let (m, t) = (&track.frames[k][0], track.times[k]);
        let turned = crate::vector::turn([1.0, 0.0, 0.0], 0.5 * t);
        let place = norm(sub(m.position, scale([-0.9, 0.4, 0.1], t)));
        let spin = norm(sub(m.spin, [0.5, 0.0, 0.0])) / 0.5;
        let speed = norm(sub(m.velocity, [-0.9, 0.4, 0.1]));
        angle_between(m.rotation, turned).max(place).max(spin).max(speed)
    };
    track.moments(100).into_iter().map(off).fold(0.0, f64::max)
}

fn stable_spin() -> Case {
    let judge = |_: &Scene, track: &Track| super::verdict(stable_spin_error(track));
    Case::run('A', Reference::ClosedForm, stable_spin_scene(), 10.0, Box::new(judge))
        .primary("greatest of: angle off [rad], place off [m], velocity off [m/s], spin off over its size")
        .integrators()
}

/// Greatest change of angular momentum (as a vector) and of energy, over their sizes.
fn kept(scene: &Scene, track: &Track) -> (f64, f64) {
    let (l, e) = (angular_momentum(scene, track.first()), kinetic(scene, track.first()));
    let off_l = track.greatest(|f| norm(sub(angular_momentum(scene, f), l)) / norm(l));
    let off_e = track.greatest(|f| (kinetic(scene, f) - e).abs() / e);
    (off_l, off_e)
}

/// The judge of what spins freely: the greater of both.
pub fn kept_spin(scene: &Scene, track: &Track) -> Verdict {
    let (l, e) = kept(scene, track);
    super::verdict(l.max(e)).and("angular_momentum", l).and("energy", e)
}

fn tumbling() -> Case {
    let mut scene = scene("a3_tumbling", "a box that tumbles about its middle axis");
    scene.gravity = [0.0; 3];
    let spin = [0.1, 5.0, 0.1];
    scene.bodies.push(box_of_ten(spin));
    let judge = move |scene: &Scene, track: &Track| {
        let picks = track.moments(100);
        let times: Vec<f64> = picks.iter().map(|&k| track.times[k]).collect();
        let truth = top::rotations(INERTIA, spin, crate::vector::STILL, &times);
        let off = picks.iter().zip(&truth).map(|(&k, &q)| angle_between(track.frames[k][0].rotation, q));
        let (l, e) = kept(scene, track);
        super::verdict(off.fold(0.0, f64::max)).and("angular_momentum", l).and("energy", e)
    };
    Case::run('A', Reference::GoldenValues, scene, 10.0, Box::new(judge))
        .primary("greatest angle from the integrated rotation")
        .scale(1.0, "rad")
        .integrators()
}

fn dzhanibekov() -> Case {
    let mut scene = scene("a4_dzhanibekov", "a box near the separatrix turns over and over");
    scene.gravity = [0.0; 3];
    let spin = [1e-3, 5.0, 1e-3];
    scene.bodies.push(box_of_ten(spin));
    let truth = top::sign_changes(INERTIA, spin, 1, 5, 60.0);
    let duration = truth[4] + 2.0;
    let judge = move |scene: &Scene, track: &Track| {
        let own = |m: &Motion| rotate(conjugate(m.rotation), m.spin)[1];
        let found = crossings(&track.times, &track.series(|f| own(&f[0])), true, true);
        let off = truth.iter().enumerate().map(|(k, t)| found.get(k).map_or(1.0, |f| (f - t).abs() / t));
        let (l, e) = kept(scene, track);
        let error = off.fold(0.0, f64::max);
        super::verdict(error).and("angular_momentum", l).and("energy", e).and("flips", found.len() as f64)
    };
    Case::run('A', Reference::GoldenValues, scene, duration, Box::new(judge))
        .primary(
            "greatest relative error of the first five times at which it turns over; 1 for a missing one",
        )
        .most_rate(480.0)
        .integrators()
}

fn fast_slender() -> Case {
    let mut scene = scene("a5_fast_slender", "the tumbling box six times as fast");
    scene.gravity = [0.0; 3];
    scene.bodies.push(box_of_ten([0.6, 30.0, 0.6]));
    Case::run('A', Reference::Invariant, scene, 30.0, Box::new(kept_spin))
        .primary("greatest change of energy or of angular momentum, over their size")
        .most_rate(480.0)
        .integrators()
}

fn soft_spring() -> Case {
    let mut scene = scene("a7_soft_spring", "two masses on a spring");
    scene.gravity = [0.0; 3];
    let w = 2000.0_f64.sqrt();
    for x in [-0.6, 0.6] {
        let mass = Some(Mass::new(1.0, [4e-3; 3]));
        scene.bodies.push(Body { collides: false, mass, ..Body::dynamic(Form::Sphere(0.1), [x, 0.0, 0.0]) });
    }
    let spring = Spring { hertz: w / TAU, damping_ratio: 0.0, mass: 0.5 };
    scene.joints.push(Joint::new(Hold::Spring(1.0, spring), [0, 1], [[0.0; 3]; 2]));
    let judge = move |_: &Scene, track: &Track| {
        let length = |f: &[Motion]| norm(sub(f[1].position, f[0].position)) - 1.0;
        let off = |k: usize| (length(&track.frames[k]) - 0.2 * libm::cos(w * track.times[k])).abs();
        let error = (0..track.len()).map(off).fold(0.0, f64::max);
        let series = track.series(length);
        let zeros = crossings(&track.times, &series, true, false);
        let periods = zeros.len().saturating_sub(1).max(1) as f64;
        let span = zeros.last().unwrap_or(&f64::NAN) - zeros.first().unwrap_or(&f64::NAN);
        let tail = &track.frames[track.len() - track.len() / 5..];
        let late = tail.iter().map(|f| length(f).abs()).fold(0.0, f64::max);
        super::verdict(error)
            .and("frequency", (periods / span * TAU / w - 1.0).abs())
            .and("amplitude_left", late / 0.2)
    };
    Case::run('A', Reference::ClosedForm, scene, 2.0, Box::new(judge))
        .primary("greatest error of the spring's stretch")
        .scale(0.2, "m, the amplitude")
}
