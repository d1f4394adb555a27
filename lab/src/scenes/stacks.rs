//! Towers, which show how far a solver carries a load.

use crate::scene::{Body, Form, Scene};

/// Adds `n` cubes with side 1 m on each other.
fn stack(scene: &mut Scene, n: usize) {
    scene.floor([400.0, 1.0, 400.0]);
    for i in 0..n {
        scene.bodies.push(Body::dynamic(Form::Box([0.5; 3]), [0.0, 0.5 + i as f64, 0.0]));
    }
}

pub fn stack_10() -> Scene {
    let mut scene = Scene::new("stack_10", "10 cubes on each other", 1200);
    stack(&mut scene, 10);
    scene
}

pub fn stack_20() -> Scene {
    let mut scene = Scene::new("stack_20", "20 cubes on each other", 1200);
    stack(&mut scene, 20);
    scene
}

pub fn heavy_on_light() -> Scene {
    let mut scene = Scene::new("heavy_on_light", "a cube of 1000 kg on one of 1 kg", 600);
    scene.floor([400.0, 1.0, 400.0]);
    for (i, density) in [1.0, 1000.0].into_iter().enumerate() {
        let cube = Body::dynamic(Form::Box([0.5; 3]), [0.0, 0.5 + i as f64, 0.0]);
        scene.bodies.push(Body { density, ..cube });
    }
    scene
}
