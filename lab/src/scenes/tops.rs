//! C12 and C13: bodies of revolution that spin on a floor.

use super::{G, scene};
use crate::case::{Case, Reference, Track};
use crate::engines::Motion;
use crate::references::tops::{Disc, Top};
use crate::scene::{Body, Form, Mass, Scene};
use crate::vector::{V3, add, angle, norm, rotate, scale, sub, turn};
use std::f64::consts::TAU;
use std::sync::OnceLock;

pub fn cases() -> Vec<Case> {
    vec![
        tippe_top("c12_tippe_top", "a top of 4 cm with its weight below turns over", 0.02, 150.0, 1.5),
        tippe_top(
            "c12_tippe_top_large",
            "the same top ten times as large",
            0.2,
            150.0 / 10.0_f64.sqrt(),
            4.5,
        ),
        disc("c13_euler_disc", "a disc of 1 m, tilted by 30°, rolls on its rim", 0.5, 0.02, 30.0),
        disc("c13_coin", "a disc of 10 cm, tilted by 5°, rolls on its rim", 0.05, 0.002, 5.0),
    ]
}

const UP: V3 = [0.0, 1.0, 0.0];

fn axis(m: &Motion) -> V3 {
    rotate(m.rotation, UP)
}

/// A ball with the moments of a full one, its centre of mass 0.3 of its radius below its middle, spun upright.
fn tippe_top(name: &'static str, about: &'static str, radius: f64, spin: f64, duration: f64) -> Case {
    let mut scene = scene(name, about);
    let friction = 0.3;
    let surface = |b: Body| Body { friction, ..b };
    scene.floor_of([100.0 * radius, 20.0 * radius, 100.0 * radius], surface);
    let top = Top { radius, offset: 0.3 * radius, moment: 0.4 * radius * radius, friction, g: G };
    let mass = 1000.0 * radius * radius * radius * TAU * 2.0 / 3.0;
    let rotation = turn([0.0, 0.0, 1.0], 0.1);
    let spin = [0.0, spin, 0.0];
    let center = [0.0, -top.offset, 0.0];
    // Its centre of mass is at rest.
    let body = Body {
        rotation,
        spin,
        mass: Some(Mass { center, ..Mass::new(mass, [mass * top.moment; 3]) }),
        ..Body::dynamic(Form::Sphere(radius), [0.0, radius, 0.0])
    };
    scene.bodies.push(surface(body));
    let times: Vec<f64> = (1..=(30.0 * duration) as usize).map(|k| k as f64 / 30.0).collect();
    let truth = OnceLock::new();
    let judge = move |_: &Scene, track: &Track| {
        let truth: &Vec<[V3; 2]> = truth.get_or_init(|| top.motions(rotation, spin, &times));
        let start = top.jellett(spin, rotate(rotation, UP));
        let drift = track.greatest(|f| (top.jellett(f[0].spin, axis(&f[0])) / start - 1.0).abs());
        let off = times.iter().zip(truth).map(|(&t, &[n, _])| {
            let m = &track.frames[track.at(t)][0];
            (angle(axis(m), UP) - angle(n, UP)).abs()
        });
        super::verdict(drift)
            .and("tilt_error_rad", off.fold(0.0, f64::max))
            .and("greatest_tilt_rad", track.greatest(|f| angle(axis(&f[0]), UP)))
    };
    Case::run('C', Reference::Invariant, scene, duration, Box::new(judge))
        .primary("greatest change of Jellett's integral, over its size")
        .most_rate(960.0)
}

/// A flat cylinder that rolls with its centre of mass at rest. Not all engines have cylinders: its lower face is one of
/// 60 corners, under a tip, with the mass of a cylinder; what the corners cost is in the error.
fn disc(name: &'static str, about: &'static str, radius: f64, half: f64, degrees: f64) -> Case {
    let mut scene = scene(name, about);
    let surface = |b: Body| Body { friction: 1.0, ..b };
    scene.floor_of([10.0, 1.0, 10.0], surface);
    let disc = Disc { radius, half, g: G };
    let tilt = degrees.to_radians();
    let rate = disc.rate(tilt);
    let corners = (0..60).map(|k| {
        let (s, c) = libm::sincos(TAU * f64::from(k) / 60.0);
        [radius * c, -half, radius * s]
    });
    scene.clouds.push(corners.chain([[0.0, half, 0.0]]).collect());
    let mass = 1000.0 * TAU * radius * radius * half;
    let (across, along) = disc.moments();
    let (s, c) = libm::sincos(tilt);
    // Its lowest point is at +x; its spin lies along the line to it.
    let (down, normal) = ([c, -s, 0.0], [s, c, 0.0]);
    let spin = add(scale(down, -rate * s), scale(normal, rate * s * half / radius));
    let body = Body {
        rotation: turn([0.0, 0.0, 1.0], -tilt),
        spin,
        mass: Some(Mass::new(mass, [across, along, across].map(|i| mass * i))),
        ..Body::dynamic(Form::Hull(0), [0.0, radius * s + half * c, 0.0])
    };
    scene.bodies.push(surface(body));
    let duration = 2.0;
    let judge = move |_: &Scene, track: &Track| {
        let mut turned = 0.0;
        for pair in track.frames.windows(2) {
            let axes = [axis(&pair[0][0]), axis(&pair[1][0])];
            // Which way it leans says nothing once it lies flat.
            if axes.iter().any(|&n| angle(n, UP) < 0.1 * tilt) {
                break;
            }
            let way = axes.map(|n| libm::atan2(-n[2], n[0]));
            let step = (way[1] - way[0]).rem_euclid(TAU);
            turned += if step > 0.5 * TAU { step - TAU } else { step };
        }
        let lean = track.greatest(|f| (angle(axis(&f[0]), UP) - tilt).abs());
        let wander = norm(sub(track.last()[0].position, track.first()[0].position));
        super::verdict((turned / (rate * track.end()) - 1.0).abs())
            .and("tilt_error", lean / tilt)
            .and("wander", wander / radius)
    };
    Case::run('C', Reference::ClosedForm, scene, duration, Box::new(judge))
        .primary("relative error of how far it has gone round in 2 s")
        .most_rate(1920.0)
}
