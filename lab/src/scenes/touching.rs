//! G6 and G7: contacts that are exactly on the edge of being, and contacts that last.

use super::{G, scene};
use crate::case::{Case, Reference, Track};
use crate::engines::Motion;
use crate::references::wheel::Wheel;
use crate::scene::{Body, Form, Mass, Scene};
use crate::vector::{Q4, STILL, V3, add, angle, norm, rotate, scale, sub, turn};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use std::sync::OnceLock;

pub fn cases() -> Vec<Case> {
    vec![touching(), overlapping(), swapped(), yawing(), rolling_prism()]
}

fn distance(a: &Motion, b: &Motion) -> f64 {
    norm(sub(a.position, b.position))
}

/// Without gravity and without a velocity, in pairs that are far from each other.
fn weightless(name: &'static str, about: &'static str) -> Scene {
    Scene { gravity: [0.0; 3], ..scene(name, about) }
}

fn touching() -> Case {
    let mut scene =
        weightless("g6_touching", "faces, edges and balls that exactly touch stay where they are");
    let cube = |at: V3, q: Q4| Body { rotation: q, ..Body::dynamic(Form::Box([0.5; 3]), at) };
    let (eighth, diagonal) = (turn([0.0, 0.0, 1.0], FRAC_PI_4), 0.5_f64.sqrt());
    let pairs: [[Body; 2]; 6] = [
        [cube([0.0, -0.5, 0.0], STILL), cube([0.0, 0.5, 0.0], STILL)],
        // Half a face on half a face, and on a static one.
        [cube([10.0, -0.5, 0.0], STILL), cube([10.5, 0.5, 0.0], STILL)],
        [Body::fixed(Form::Box([0.5; 3]), [20.0, -0.5, 0.0]), cube([20.0, 0.5, 0.0], STILL)],
        // Edge along edge, and edge along face.
        [cube([30.0, -diagonal, 0.0], eighth), cube([30.0, diagonal, 0.0], eighth)],
        [cube([40.0, -0.5, 0.0], STILL), cube([40.0, diagonal, 0.0], eighth)],
        [
            Body::dynamic(Form::Sphere(0.5), [50.0, -0.5, 0.0]),
            Body::dynamic(Form::Sphere(0.5), [50.0, 0.5, 0.0]),
        ],
    ];
    scene.bodies.extend(pairs.into_iter().flatten());
    let judge = |_: &Scene, track: &Track| {
        let turned = |f: &[Motion]| f.iter().map(|m| norm(m.spin)).fold(0.0, f64::max);
        super::verdict(track.farthest(track.last())).and("spin_rad_s", track.greatest(turned))
    };
    Case::run('G', Reference::Invariant, scene, 1.0, Box::new(judge))
        .primary("greatest distance of a body from its place, at the end")
        .scale(1.0, "m, the side")
        .most_rate(480.0)
}

fn overlapping() -> Case {
    let about = "balls in one place, crossing capsules, a ball with its centre on a face";
    let mut scene = weightless("g6_overlapping", about);
    let capsule = Form::Capsule(0.5, 0.1);
    let lying = turn([0.0, 0.0, 1.0], FRAC_PI_2);
    let pairs: [[Body; 2]; 4] = [
        [Body::dynamic(Form::Sphere(0.5), [0.0; 3]), Body::dynamic(Form::Sphere(0.5), [0.0; 3])],
        [
            Body::dynamic(Form::Box([0.5; 3]), [10.0, 0.0, 0.0]),
            Body::dynamic(Form::Box([0.5; 3]), [10.0, 0.0, 0.0]),
        ],
        [
            Body::dynamic(capsule, [20.0, 0.0, 0.0]),
            Body { rotation: lying, ..Body::dynamic(capsule, [20.0, 0.0, 0.0]) },
        ],
        [
            Body::fixed(Form::Box([2.0; 3]), [30.0, -2.0, 0.0]),
            Body::dynamic(Form::Sphere(0.5), [30.0, 0.0, 0.0]),
        ],
    ];
    scene.bodies.extend(pairs.into_iter().flatten());
    let judge = |_: &Scene, track: &Track| {
        let (first, last) = (track.first(), track.last());
        let moved = |k: usize| sub(last[k].position, first[k].position);
        // What one gets the other gets too; the ball goes straight up; crossing axes leave along what is across both.
        let pairs = [0, 2, 4].map(|k| norm(add(moved(k), moved(k + 1)))).into_iter().fold(0.0, f64::max);
        let up = moved(6);
        let aside = norm([up[0], 0.0, up[2]]).max(norm([moved(4)[0], moved(4)[1], 0.0]));
        let left = [1.0 - distance(&last[0], &last[1]), 1.0 - distance(&last[2], &last[3])];
        let stuck = left.into_iter().chain([0.2 - distance(&last[4], &last[5]), 0.5 - up[1]]);
        super::verdict(pairs.max(aside))
            .and("unequal", pairs)
            .and("aside", aside)
            .and("overlap_left_m", stuck.fold(0.0, f64::max))
    };
    Case::run('G', Reference::Invariant, scene, 1.0, Box::new(judge))
        .primary("greatest of: what both of a pair have moved together, what was pushed aside")
        .scale(1.0, "m, the size")
        .most_rate(480.0)
}

fn swapped() -> Case {
    let mut scene = weightless("g6_swapped", "overlapping pairs, each twice: whichever of both comes first");
    let q = turn([0.6, 0.0, 0.8], 0.7);
    let forms = [Form::Box([0.5, 0.3, 0.4]), Form::Sphere(0.4), Form::Capsule(0.4, 0.2), Form::Hull(0)];
    let hull = (0..12).map(|k| {
        let (s, c) = libm::sincos(1.9 * f64::from(k));
        [0.5 * c, 0.08 * f64::from(k) - 0.44, 0.5 * s]
    });
    scene.clouds.push(hull.collect());
    let body = |form: Form, at: V3| Body {
        rotation: q,
        mass: Some(Mass::new(100.0, [8.0, 9.0, 10.0])),
        ..Body::dynamic(form, at)
    };
    let mut pair = 0;
    for i in 0..forms.len() {
        for j in i..forms.len() {
            let at = [4.0 * f64::from(pair), 0.0, 0.0];
            let other = |at: V3| Body { rotation: STILL, ..body(forms[j], add(at, [0.23, 0.41, 0.17])) };
            scene.bodies.extend([body(forms[i], at), other(at)]);
            let at = add(at, [0.0, 0.0, 8.0]);
            scene.bodies.extend([other(at), body(forms[i], at)]);
            pair += 1;
        }
    }
    let judge = |_: &Scene, track: &Track| {
        let (first, last) = (track.first(), track.last());
        let moved = |k: usize| sub(last[k].position, first[k].position);
        let fours = 0..first.len() / 4;
        let off = fours.flat_map(|k| {
            [norm(sub(moved(4 * k), moved(4 * k + 3))), norm(sub(moved(4 * k + 1), moved(4 * k + 2)))]
        });
        super::verdict(off.fold(0.0, f64::max)).and("moved_m", track.farthest(last))
    };
    Case::run('G', Reference::Invariant, scene, 0.5, Box::new(judge))
        .primary("greatest difference of a body's way from that of its twin")
        .scale(0.4, "m, the size")
        .most_rate(480.0)
}

fn yawing() -> Case {
    let mut scene = scene("g7_yawing", "a box turns on the spot at 0.1/s, without friction, for 20 s");
    let surface = |b: Body| Body { friction: 0.0, ..b };
    scene.floor_of([20.0, 1.0, 20.0], surface);
    let spin = [0.0, 0.1, 0.0];
    scene.bodies.push(surface(Body { spin, ..Body::dynamic(Form::Box([0.5; 3]), [0.0, 0.5, 0.0]) }));
    let judge = move |_: &Scene, track: &Track| {
        let late = &track.frames[track.len() / 4..];
        let off = |f: &[Motion]| norm(f[0].velocity).max(0.5 * norm(sub(f[0].spin, spin)));
        let worst = late.iter().map(|f| off(f)).fold(0.0, f64::max);
        let tilt = late.iter().map(|f| angle(rotate(f[0].rotation, [0.0, 1.0, 0.0]), [0.0, 1.0, 0.0]));
        super::verdict(worst)
            .and("tilt_rad", tilt.fold(0.0, f64::max))
            .and("wander_m", norm(sub(track.last()[0].position, late[0][0].position)))
    };
    Case::run('G', Reference::ClosedForm, scene, 20.0, Box::new(judge))
        .primary("greatest of speed and of spin's error × half side, after the first quarter")
        .scale(0.05, "m/s, spin × half side")
        .most_rate(240.0)
}

fn rolling_prism() -> Case {
    let about = "a prism of 32 sides rolls over its corners and loses at each what it must";
    let mut scene = scene("g7_rolling_prism", about);
    let surface = |b: Body| Body { friction: 1.0, ..b };
    scene.floor_of([50.0, 1.0, 20.0], surface);
    let wheel = Wheel { sides: 32, radius: 0.5, moment: 0.125, g: G };
    let alpha = wheel.half_angle();
    let corner = |k: usize, z: f64| {
        let (s, c) = libm::sincos((2.0 * k as f64 + 1.0) * PI / wheel.sides as f64 - FRAC_PI_2);
        [wheel.radius * c, wheel.radius * s, z]
    };
    scene.clouds.push((0..wheel.sides).flat_map(|k| [corner(k, -0.5), corner(k, 0.5)]).collect());
    // It stands on a face and turns about the corner ahead, which is to the right and below.
    let spin = 3.0;
    let velocity = scale([libm::cos(alpha), libm::sin(alpha), 0.0], spin * wheel.radius);
    scene.bodies.push(surface(Body {
        velocity,
        spin: [0.0, 0.0, -spin],
        mass: Some(Mass::new(100.0, [100.0 * wheel.moment; 3])),
        ..Body::dynamic(Form::Hull(0), [0.0, wheel.radius * libm::cos(alpha), 0.0])
    }));
    let duration = 2.0;
    let times: Vec<f64> = (1..=60).map(|k| f64::from(k) / 30.0).collect();
    let truth = OnceLock::new();
    let judge = move |_: &Scene, track: &Track| {
        let truth: &Vec<f64> = truth.get_or_init(|| wheel.ways(spin, &times));
        assert_eq!(truth.len(), times.len(), "it stops before the end");
        let off = times.iter().zip(truth).map(|(&t, x)| (track.frames[track.at(t)][0].position[0] - x).abs());
        super::verdict(off.fold(0.0, f64::max)).and("aside_m", track.last()[0].position[2].abs())
    };
    Case::run('G', Reference::GoldenValues, scene, duration, Box::new(judge))
        .primary("greatest error of the way rolled")
        .scale(3.0, "m, about that way")
        .most_rate(960.0)
}
