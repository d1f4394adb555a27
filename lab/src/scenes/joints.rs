//! Chains, pendulums and a cloth of ball joints.

use crate::scene::{Body, Form, Joint, Kind, Mass, Scene};

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

/// `count` thin rods of this length along x from the origin, held by ball joints: E1 to E3 of the catalogue. The
/// last one has the mass `last` \[kg\], the others 1 kg.
fn chain(name: &'static str, about: &'static str, count: usize, size: f64, last: f64, steps: usize) -> Scene {
    let mut scene = Scene::new(name, about, steps);
    scene.gravity = [0.0, -9.81, 0.0];
    scene.bodies.push(Body { collides: false, ..Body::fixed(Form::Sphere(0.02), [0.0; 3]) });
    for i in 0..count {
        let x = (i as f64 + 0.5) * size;
        let mass = if i + 1 == count { last } else { 1.0 };
        let across = mass * size * size / 12.0;
        scene.bodies.push(Body {
            collides: false,
            mass: Some(Mass { mass, inertia: [0.01 * across, across, across] }),
            ..Body::dynamic(Form::Sphere(0.02), [x, 0.0, 0.0])
        });
        let end = if i == 0 { 0.0 } else { 0.5 * size };
        let ends = [[end, 0.0, 0.0], [-0.5 * size, 0.0, 0.0]];
        scene.joints.push(Joint::ball([i, i + 1], ends));
    }
    scene
}

pub fn double_pendulum() -> Scene {
    chain("double_pendulum", "two rods from the horizontal (E2)", 2, 1.0, 1.0, 180)
}

pub fn chain_10() -> Scene {
    chain("chain_10", "ten rods from the horizontal (E3)", 10, 0.2, 1.0, 60)
}

pub fn chain_20() -> Scene {
    chain("chain_20", "twenty rods from the horizontal (E3)", 20, 0.2, 1.0, 60)
}

/// A point mass on a bar of 1 m, from the horizontal (E1).
pub fn pendulum() -> Scene {
    let mut scene = Scene::new("pendulum", "a point mass on a bar, from the horizontal (E1)", 900);
    scene.gravity = [0.0, -9.81, 0.0];
    scene.bodies.push(Body { collides: false, ..Body::fixed(Form::Sphere(0.02), [0.0; 3]) });
    scene.bodies.push(Body {
        collides: false,
        // As small as Box3D bears: a sphere of 5 mm.
        mass: Some(Mass { mass: 1.0, inertia: [1e-5; 3] }),
        ..Body::dynamic(Form::Sphere(0.005), [1.0, 0.0, 0.0])
    });
    scene.joints.push(Joint::ball([0, 1], [[0.0; 3], [-1.0, 0.0, 0.0]]));
    scene
}

/// Twenty rods hanging at rest, the last one of this mass (E4).
pub fn hanging_chain(last: f64) -> Scene {
    let mut scene = chain("hanging_chain", "twenty rods hanging at rest (E4)", 20, 0.2, last, 600);
    let half = std::f64::consts::FRAC_1_SQRT_2;
    for body in &mut scene.bodies {
        let [x, _, _] = body.position;
        body.position = [0.0, -x, 0.0];
        body.rotation = [0.0, 0.0, -half, half];
    }
    // The ground's own frame stays; its anchor is the origin.
    scene.bodies[0].rotation = [0.0, 0.0, 0.0, 1.0];
    scene
}

pub fn hanging_chain_1() -> Scene {
    hanging_chain(1.0)
}
