//! C9: what slides and may tip, jam or be stopped at once where Coulomb's law has no answer.

use super::group_c::box_on_floor;
use super::{G, scene};
use crate::case::{Case, Reference, Track};
use crate::references::rod::{Rod, State};
use crate::scene::{Body, Form, Mass, Scene};
use crate::vector::{V3, norm, rotate, sub, turn};
use std::f64::consts::FRAC_PI_2;
use std::sync::OnceLock;

pub fn cases() -> Vec<Case> {
    vec![
        rod("c9_rod_low", "a slender rod slides on its end, friction 0.3", 0.3, 0.4),
        rod("c9_rod", "a slender rod slides on its end, friction 1: an answer there is", 1.0, 0.5),
        rod("c9_rod_paradox", "a slender rod slides on its end, friction 1.6: Painlevé's paradox", 1.6, 0.5),
        tipping_box(),
    ]
}

/// Follows a body whose contact point is `direction` from its centre, in its own frame.
fn follow(scene: Scene, rod: Rod, start: State, direction: V3, duration: f64) -> Case {
    let times: Vec<f64> = (1..=(30.0 * duration) as usize).map(|k| k as f64 / 30.0).collect();
    let truth = OnceLock::new();
    let judge = move |_: &Scene, track: &Track| {
        let truth: &Vec<State> = truth.get_or_init(|| rod.states(start, &times));
        assert_eq!(truth.len(), times.len(), "it leaves the floor or lies down before the end");
        let (mut off, mut turned) = (0.0_f64, 0.0_f64);
        for (&t, s) in times.iter().zip(truth) {
            let m = &track.frames[track.at(t)][0];
            off = off.max(norm(sub(m.position, [s.x, rod.height(s.angle), 0.0])));
            let d = rotate(m.rotation, direction);
            let (sin, cos) = libm::sincos(s.angle);
            turned = turned.max(norm(sub(d, [cos, -sin, 0.0])));
        }
        super::verdict(off).and("direction", turned)
    };
    Case::run('C', Reference::GoldenValues, scene, duration, Box::new(judge))
        .primary("greatest distance of the centre from its integrated way")
        .most_rate(1920.0)
}

/// A rod of 1 m and 1 kg with round ends of 1 cm, at 60°, its lower end ahead; it moves at 2 m/s without turning.
fn rod(name: &'static str, about: &'static str, friction: f64, duration: f64) -> Case {
    let mut scene = scene(name, about);
    let surface = |b: Body| Body { friction, ..b };
    scene.floor_of([10.0, 1.0, 10.0], surface);
    let rod = Rod { arm: 0.5, radius: 0.01, moment: 1.0 / 12.0, friction, g: G };
    let start = State { x: 0.0, angle: 60.0_f64.to_radians(), speed: 2.0, spin: 0.0 };
    // The capsule lies along y; its lower end is at −y.
    let body = Body {
        rotation: turn([0.0, 0.0, 1.0], FRAC_PI_2 - start.angle),
        velocity: [start.speed, 0.0, 0.0],
        mass: Some(Mass::new(1.0, [1.0 / 12.0, 1e-3, 1.0 / 12.0])),
        ..Body::dynamic(Form::Capsule(0.5, 0.01), [0.0, rod.height(start.angle), 0.0])
    };
    scene.bodies.push(surface(body));
    follow(scene, rod, start, [0.0, -1.0, 0.0], duration).scale(1.0, "m, its length")
}

/// The tall box of C9 with friction 0.55, just above the ratio of its sides: it tips as it slides.
fn tipping_box() -> Case {
    let half = [0.15, 0.3, 0.6];
    let about = "a box slides on its edge and tips, friction 0.55";
    let mut scene = box_on_floor("c9_tipping_box", about, half, 0.55);
    scene.bodies[1].density = 200.0;
    scene.bodies[1].velocity = [4.0, 0.0, 0.0];
    let arm = norm([half[0], half[1], 0.0]);
    let rod = Rod { arm, radius: 0.0, moment: arm * arm / 3.0, friction: 0.55, g: G };
    let start = State { x: 0.0, angle: libm::atan2(half[1], half[0]), speed: 4.0, spin: 0.0 };
    let direction = [half[0] / arm, -half[1] / arm, 0.0];
    follow(scene, rod, start, direction, 0.5).scale(0.6, "m, its height")
}
