//! Planar pyramids of cubes with side 1 m and density 100.

use crate::scene::{Body, Form, Scene};

/// Adds a planar pyramid in the plane at `z` whose lowest row starts at `left`, and whose top is `rows` high.
fn pyramid(scene: &mut Scene, rows: usize, left: f64, z: f64) {
    for row in 0..rows {
        for k in 0..rows - row {
            let x = left + 0.5 + 0.5 * row as f64 + k as f64;
            let cube = Body::dynamic(Form::Box([0.5; 3]), [x, 0.5 + row as f64, z]);
            scene.bodies.push(Body { density: 100.0, ..cube });
        }
    }
}

pub fn large_pyramid() -> Scene {
    let mut scene = Scene::new("large_pyramid", "100 rows of cubes: one island of 5050 bodies", 200);
    scene.floor([400.0, 1.0, 400.0]);
    pyramid(&mut scene, 100, -50.0, 0.0);
    scene
}

pub fn many_pyramids() -> Scene {
    let mut scene = Scene::new("many_pyramids", "14 × 14 pyramids of 10 rows: 196 islands", 100);
    let half = 77.0;
    scene.floor([half, 1.0, half]);
    for line in 0..14 {
        let z = -(half - 1.0) + line as f64 * 2.0 * (half - 1.0) / 13.0;
        for column in 0..14 {
            pyramid(&mut scene, 10, -half + 0.5 + 11.0 * column as f64, z);
        }
    }
    scene
}

pub fn pyramid_10() -> Scene {
    let mut scene = Scene::new("pyramid_10", "10 rows of cubes", 600);
    scene.floor([400.0, 1.0, 400.0]);
    pyramid(&mut scene, 10, -5.0, 0.0);
    scene
}
