//! Chains, pendulums and a cloth of ball joints.

use super::group_e;
use crate::scene::{Body, Form, Joint, Kind, Scene};
use std::f64::consts::FRAC_PI_2;

/// A cloth of 100 × 100 spheres whose upper row is fixed, tied to their neighbours: 19 800 ball joints.
pub fn joint_grid() -> Scene {
    let mut scene = Scene::new("joint_grid", "100 × 100 spheres on 19 800 ball joints", 100);
    let n = 100;
    for k in 0..n {
        for i in 0..n {
            let body = Body::dynamic(Form::Sphere(0.4), [k as f64, -(i as f64), 0.0]);
            let kind = if i == 0 { Kind::Static } else { Kind::Dynamic };
            scene.bodies.push(Body { kind, collides: false, ..body });
            let this = k * n + i;
            if i > 0 {
                let ends = [[0.0, -0.5, 0.0], [0.0, 0.5, 0.0]];
                scene.joints.push(Joint::ball([this - 1, this], ends));
            }
            if k > 0 {
                let ends = [[0.5, 0.0, 0.0], [-0.5, 0.0, 0.0]];
                scene.joints.push(Joint::ball([this - n, this], ends));
            }
        }
    }
    scene
}

/// Thin rods along x from the origin, held by ball joints, for the race.
fn chain(name: &'static str, about: &'static str, count: usize, size: f64, steps: usize) -> Scene {
    Scene { steps, ..group_e::rods(name, about, count, size, 1.0) }
}

pub fn double_pendulum() -> Scene {
    chain("double_pendulum", "two rods from the horizontal (E2)", 2, 1.0, 180)
}

pub fn chain_10() -> Scene {
    chain("chain_10", "ten rods from the horizontal (E3)", 10, 0.2, 60)
}

pub fn chain_20() -> Scene {
    chain("chain_20", "twenty rods from the horizontal (E3)", 20, 0.2, 60)
}

/// A point mass on a bar of 1 m (E1).
pub fn pendulum() -> Scene {
    let about = "a point mass on a bar, from the horizontal (E1)";
    Scene { steps: 900, ..group_e::pendulum_scene("pendulum", about, FRAC_PI_2, true) }
}

/// The last of the rods has this mass (E4).
pub fn hanging_chain(last: f64) -> Scene {
    let about = "twenty rods hanging at rest (E4)";
    Scene { steps: 600, ..group_e::hanging_scene("hanging_chain", about, 20, last) }
}

pub fn hanging_chain_1() -> Scene {
    hanging_chain(1.0)
}
