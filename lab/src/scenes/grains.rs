//! J2 and J3: what many bodies do together, and grains.

use super::{G, Random, scene};
use crate::case::{Case, Reference, Threshold, Track};
use crate::references::galton::{Board, energy_coefficient};
use crate::scene::{Body, Form, Scene};
use crate::vector::turn;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::OnceLock;

pub fn cases() -> Vec<Case> {
    vec![galton(), four_balls(), hopper()]
}

const BALLS: usize = 80;
const TIME: f64 = 2.0;

/// Pegs a metre apart in rows, each shifted by half of it.
fn board() -> Board {
    let row = |k: i32| {
        let shift = if k % 2 == 0 { 0.0 } else { 0.5 };
        (-5..=5).map(move |i| [f64::from(i) + shift, -0.87 * f64::from(k)])
    };
    Board { pegs: (0..8).flat_map(row).collect(), reach: 0.3, g: G }
}

/// Where the balls begin, in the plane of the board.
fn starts(seed: u64) -> Vec<[f64; 2]> {
    let mut random = Random::new(seed);
    (0..BALLS).map(|_| [0.8 * random.half(), 0.8 + 0.2 * random.half()]).collect()
}

/// One board for all balls: each has a plane of its own across the pegs.
fn galton_scene() -> Scene {
    let about = "80 elastic balls fall through a board of pegs, against as many of the truth";
    let mut scene = scene("j2_galton", about);
    scene.restitution_threshold = Some(0.0);
    let surface = |b: Body| Body { restitution: 1.0, friction: 0.0, ..b };
    let depth = 0.35 * BALLS as f64;
    let along = turn([1.0, 0.0, 0.0], FRAC_PI_2);
    for [x, y] in board().pegs {
        let peg = Body::fixed(Form::Capsule(0.5 * depth + 1.0, 0.15), [x, y, 0.5 * depth]);
        scene.bodies.push(surface(Body { rotation: along, ..peg }));
    }
    for (k, [x, y]) in starts(2).into_iter().enumerate() {
        let at = [x, y, 0.35 * k as f64];
        scene.bodies.push(surface(Body::dynamic(Form::Sphere(0.15), at)));
    }
    scene
}

fn galton() -> Case {
    let truth = OnceLock::new();
    let judge = move |_: &Scene, track: &Track| {
        let truth: &Vec<[f64; 2]> =
            truth.get_or_init(|| starts(2).iter().map(|&p| board().end(p, TIME)).collect());
        let found: Vec<[f64; 2]> = track.last().iter().map(|m| [m.position[0], m.position[1]]).collect();
        let width =
            |all: &[[f64; 2]]| (all.iter().map(|p| p[0] * p[0]).sum::<f64>() / all.len() as f64).sqrt();
        super::verdict(energy_coefficient(truth, &found))
            .and("width_over_exact", width(&found) / width(truth))
    };
    Case::run('J', Reference::GoldenValues, galton_scene(), TIME, Box::new(judge))
        .primary("energy distance of the places from those of the truth, over its greatest value")
        .scale(1.0, "1; two samples of the truth are 0.01 apart")
        .most_rate(240.0)
        .defaults_only()
}

/// Three balls on the floor, a little apart, and one on them: the least heap. The line to the one above is ψ off the
/// vertical; at both contacts of a lower ball friction is the same, so it must be tan(ψ/2) of the force above.
fn four_balls_scene(friction: f64) -> Scene {
    let mut scene = scene("j3_four_balls", "");
    let surface = |b: Body| Body { friction, ..b };
    scene.floor_of([10.0, 1.0, 10.0], surface);
    let out = APART / 3.0_f64.sqrt();
    for k in 0..3 {
        let (s, c) = libm::sincos(TAU * f64::from(k) / 3.0);
        scene.bodies.push(surface(Body::dynamic(Form::Sphere(0.5), [out * c, 0.5, out * s])));
    }
    let up = 0.5 + (1.0 - out * out).sqrt();
    scene.bodies.push(surface(Body::dynamic(Form::Sphere(0.5), [0.0, up, 0.0])));
    scene
}

/// Between middles of the lower balls, whose diameter is 1 m.
const APART: f64 = 1.05;

fn four_balls() -> Case {
    let sine = APART / 3.0_f64.sqrt();
    Case::threshold(
        'J',
        "j3_four_balls",
        "the friction with which three balls bear a fourth",
        2.0,
        Threshold {
            scene: Box::new(four_balls_scene),
            beyond: Box::new(|track| track.first()[3].position[1] - track.last()[3].position[1] < 0.05),
            exact: libm::tan(0.5 * libm::asin(sine)),
            range: [0.05, 1.0],
            halvings: 10,
        },
    )
    .most_rate(240.0)
}

/// Of the grains \[m\].
const GRAIN: f64 = 0.1;
const OPENINGS: [f64; 3] = [0.4, 0.6, 0.8];
/// Between hoppers, and how wide one is.
const PITCH: f64 = 4.0;
const WIDTH: f64 = 1.3;

/// Three hoppers with a flat bottom and an opening, one layer of grains thick.
fn hopper_scene() -> Scene {
    let mut scene = scene("j3_hopper", "grains flow out of three openings: the exponent of Beverloo's law");
    let surface = |b: Body| Body { friction: 0.4, ..b };
    let smooth = |b: Body| Body { friction: 0.0, ..b };
    let thick = 0.5 * GRAIN + 0.002;
    for side in [-1.0, 1.0] {
        let at = [PITCH, 0.0, side * (thick + 0.5)];
        scene.bodies.push(smooth(Body::fixed(Form::Box([2.0 * PITCH, 10.0, 0.5]), at)));
    }
    let mut random = Random::new(3);
    for (k, opening) in OPENINGS.into_iter().enumerate() {
        let x = PITCH * k as f64;
        for side in [-1.0, 1.0] {
            let (wall, lip) = (0.5 * WIDTH + 0.1, 0.25 * (WIDTH - opening));
            let at = [x + side * wall, 2.5, 0.0];
            scene.bodies.push(surface(Body::fixed(Form::Box([0.1, 2.6, 0.3]), at)));
            let at = [x + side * (0.5 * opening + lip), -0.1, 0.0];
            scene.bodies.push(surface(Body::fixed(Form::Box([lip, 0.1, 0.3]), at)));
        }
        for i in 0..12 * 20 {
            let (column, row) = (f64::from(i % 12), f64::from(i / 12));
            let at =
                [x + 0.104 * (column - 5.5) + 0.02 * random.half(), 0.06 + 0.1 * row, 0.002 * random.half()];
            scene.bodies.push(surface(Body::dynamic(Form::Sphere(0.5 * GRAIN), at)));
        }
    }
    scene
}

/// The slope of log(grains a second) over log(opening − 1.4 grains).
fn exponent(rates: [f64; 3]) -> f64 {
    let x = OPENINGS.map(|d| libm::log(d - 1.4 * GRAIN));
    let y = rates.map(|r| libm::log(r.max(1e-3)));
    let mean = |v: [f64; 3]| v.iter().sum::<f64>() / 3.0;
    let (mx, my) = (mean(x), mean(y));
    let top: f64 = (0..3).map(|k| (x[k] - mx) * (y[k] - my)).sum();
    top / x.iter().map(|x| (x - mx) * (x - mx)).sum::<f64>()
}

fn hopper() -> Case {
    let (from, to) = (0.3, 1.1);
    let judge = move |_: &Scene, track: &Track| {
        let through = |t: f64, k: usize| {
            let frame = &track.frames[track.at(t)];
            let per = frame.len() / OPENINGS.len();
            frame[k * per..(k + 1) * per].iter().filter(|m| m.position[1] < -0.05).count() as f64
        };
        let rates = [0, 1, 2].map(|k| (through(to, k) - through(from, k)) / (to - from));
        // Grains a second over what falls freely through the opening's scale, √g D^3/2 / d².
        let widest = rates[2] * GRAIN * GRAIN / (G.sqrt() * libm::pow(OPENINGS[2] - 1.4 * GRAIN, 1.5));
        super::verdict((exponent(rates) - 1.5).abs()).and("exponent", exponent(rates)).and("constant", widest)
    };
    Case::run('J', Reference::ClosedForm, hopper_scene(), to, Box::new(judge))
        .primary("error of the fitted exponent; by Beverloo's empirical law it is 3/2 for a slot")
        .scale(1.5, "1, the exponent; grains are counted, below 0.1 it is noise")
        .most_rate(60.0)
        .defaults_only()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How far apart two samples of the truth are, and that they do spread.
    #[test]
    fn samples_of_the_truth_are_near_each_other() {
        let ends = |seed| -> Vec<[f64; 2]> { starts(seed).iter().map(|&p| board().end(p, TIME)).collect() };
        let (a, b, c) = (ends(2), ends(3), ends(4));
        let off = [energy_coefficient(&a, &b), energy_coefficient(&a, &c), energy_coefficient(&b, &c)];
        println!("{off:?}");
        assert!(off.iter().all(|&x| x < 0.03), "{off:?}");
        let still = energy_coefficient(&a, &starts(2));
        assert!(still > 0.3, "{still}");
    }

    #[test]
    fn the_fit_finds_its_exponent() {
        let law = OPENINGS.map(|d| 50.0 * libm::pow(d - 0.14, 1.5));
        assert!((exponent(law) - 1.5).abs() < 1e-12);
    }

    /// For balls that touch, the published figure √3 − √2.
    #[test]
    fn the_least_friction_of_touching_balls_is_known() {
        let touching = libm::tan(0.5 * libm::asin(1.0 / 3.0_f64.sqrt()));
        assert!((touching - (3.0_f64.sqrt() - 2.0_f64.sqrt())).abs() < 1e-15);
    }
}
