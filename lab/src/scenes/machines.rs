//! Scenes with moving walls: a drum that turns cubes over, a pit of scrap that is stirred.

use super::piles::Random;
use crate::scene::{Body, Form, Kind, Part, Scene};
use crate::vector::{STILL, scale, turn};
use std::f64::consts::TAU;

/// 8000 cubes in a drum of 36 slats and 4 ribs that turns at 25 °/s.
pub fn washer() -> Scene {
    let mut scene = Scene::new("washer", "8000 cubes in a drum that turns", 1000);
    let (inner, outer, depth) = (16.0, 18.0, 10.0);
    let middle = 0.5 * (inner + outer);
    let half = [0.5 * (outer - inner), 0.5 * outer * TAU / 36.0 + 0.1, depth];
    let mut parts: Vec<Part> = (0..36)
        .map(|k| {
            let angle = TAU * f64::from(k) / 36.0;
            let (s, c) = libm::sincos(angle);
            Part { half, position: [middle * c, middle * s, 0.0], rotation: turn([0.0, 0.0, 1.0], angle) }
        })
        .collect();
    for k in 0..4 {
        let angle = TAU * (f64::from(k) + 0.5) / 4.0;
        let (s, c) = libm::sincos(angle);
        let position = scale([c, s, 0.0], inner - 1.0);
        parts.push(Part { half: [1.0, 0.25, depth], position, rotation: turn([0.0, 0.0, 1.0], angle) });
    }
    for side in [-1.0, 1.0] {
        let position = [0.0, 0.0, side * (depth + 0.5)];
        parts.push(Part { half: [outer, outer, 0.5], position, rotation: STILL });
    }
    scene.compounds.push(parts);
    scene.bodies.push(Body {
        kind: Kind::Kinematic,
        spin: [0.0, 0.0, TAU * 25.0 / 360.0],
        ..Body::fixed(Form::Boxes(0), [0.0; 3])
    });
    for k in 0..8000 {
        let at = [k % 20, k / 20 % 20, k / 400].map(|i| 0.9 * (f64::from(i) - 9.5));
        scene.bodies.push(Body::dynamic(Form::Box([0.2; 3]), at));
    }
    scene
}

/// 10 584 hulls of ten points in a pit of 100 m, stirred by a prism of 16 sides that goes round.
pub fn junkyard() -> Scene {
    let mut scene = Scene::new("junkyard", "10 584 hulls in a pit that is stirred", 500);
    pit(&mut scene, 50.0, 30.0);
    let mut random = Random(42);
    scene.clouds.push((0..10).map(|_| random.direction().map(|x| f64::from(1.5 * x))).collect());
    let ring = |y: f64| {
        (0..16).map(move |k| {
            let (s, c) = libm::sincos(TAU * f64::from(k) / 16.0);
            [4.0 * c, y, 4.0 * s]
        })
    };
    scene.clouds.push(ring(-10.0).chain(ring(10.0)).collect());
    scene.bodies.push(Body {
        kind: Kind::Kinematic,
        velocity: [4.0, 0.0, 0.0],
        spin: [0.0, 1.0, 0.0],
        ..Body::fixed(Form::Hull(1), [-20.0, 10.0, 0.0])
    });
    for k in 0..10_584 {
        let (x, z) = (f64::from(k % 21), f64::from(k / 21 % 21));
        let at = [4.0 * (x - 10.0), 4.0 + 3.5 * f64::from(k / 441), 4.0 * (z - 10.0)];
        scene.bodies.push(Body::dynamic(Form::Hull(0), at));
    }
    scene
}

/// A floor with four walls, this far from the middle.
pub fn pit(scene: &mut Scene, far: f64, height: f64) {
    scene.floor([far + 2.0, 1.0, far + 2.0]);
    for (x, z) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
        let half = if z == 0.0 { [1.0, height, far] } else { [far + 2.0, height, 1.0] };
        let out = far + 1.0;
        scene.bodies.push(Body::fixed(Form::Box(half), [out * x, height, out * z]));
    }
}
