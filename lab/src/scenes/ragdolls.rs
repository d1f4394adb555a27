//! Bodies that hang together: a heap of ragdolls.

use super::machines::pit;
use crate::scene::{Body, Form, Joint, Scene};
use crate::vector::{STILL, add, conjugate, rotate, sub, turn};
use std::f64::consts::FRAC_PI_2;

/// A limb: centre, half length, radius, whether it lies along x, and what it hangs on and where.
type Limb = ([f64; 3], f64, f64, bool, usize, [f64; 3]);

/// Eleven limbs of a person with arms held out: pelvis, chest, head, arms, legs.
const LIMBS: [Limb; 11] = [
    ([0.0, 0.0, 0.0], 0.08, 0.11, true, 0, [0.0; 3]),
    ([0.0, 0.32, 0.0], 0.12, 0.12, false, 0, [0.0, 0.12, 0.0]),
    ([0.0, 0.69, 0.0], 0.04, 0.09, false, 1, [0.0, 0.57, 0.0]),
    ([0.33, 0.46, 0.0], 0.10, 0.05, true, 1, [0.18, 0.46, 0.0]),
    ([-0.33, 0.46, 0.0], 0.10, 0.05, true, 1, [-0.18, 0.46, 0.0]),
    ([0.63, 0.46, 0.0], 0.10, 0.04, true, 3, [0.48, 0.46, 0.0]),
    ([-0.63, 0.46, 0.0], 0.10, 0.04, true, 4, [-0.48, 0.46, 0.0]),
    ([0.10, -0.32, 0.0], 0.14, 0.07, false, 0, [0.10, -0.11, 0.0]),
    ([-0.10, -0.32, 0.0], 0.14, 0.07, false, 0, [-0.10, -0.11, 0.0]),
    ([0.10, -0.74, 0.0], 0.15, 0.055, false, 7, [0.10, -0.53, 0.0]),
    ([-0.10, -0.74, 0.0], 0.15, 0.055, false, 8, [-0.10, -0.53, 0.0]),
];

/// 100 ragdolls of eleven capsules and ten ball joints fall into a pit.
pub fn ragdoll_pile() -> Scene {
    let mut scene = Scene::new("ragdoll_pile", "100 ragdolls of 11 capsules fall into a pit", 400);
    pit(&mut scene, 4.0, 20.0);
    let lying = turn([0.0, 0.0, 1.0], FRAC_PI_2);
    for k in 0..100 {
        let slot = [k % 3, k / 6, k / 3 % 2].map(f64::from);
        let at = [2.2 * (slot[0] - 1.0), 1.5 + 2.2 * slot[1], 2.5 * (slot[2] - 0.5)];
        let first = scene.bodies.len();
        for (i, &(centre, half, radius, across, parent, anchor)) in LIMBS.iter().enumerate() {
            let rotation = if across { lying } else { STILL };
            let body = Body::dynamic(Form::Capsule(half, radius), add(at, centre));
            scene.bodies.push(Body { rotation, ..body });
            if i > 0 {
                let local = [first + parent, first + i].map(|b| {
                    let body = &scene.bodies[b];
                    rotate(conjugate(body.rotation), sub(add(at, anchor), body.position))
                });
                scene.joints.push(Joint::ball([first + parent, first + i], local));
            }
        }
    }
    scene
}
