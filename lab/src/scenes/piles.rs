//! Heaps: many contacts that come and go.

use super::machines::pit;
use crate::scene::{Body, Form, Scene};
use crate::vector::{add, unit};

/// The generator that the published convex pile is made with; its constants are part of the scene.
pub struct Random(pub u32);

impl Random {
    /// In -0.5 … 0.5.
    pub fn half(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(2_147_001_325).wrapping_add(715_136_305);
        (self.0 & 0xffff) as f32 / 65535.0 - 0.5
    }

    /// Of length 1: a point of a ball, pushed to its surface.
    pub fn direction(&mut self) -> [f32; 3] {
        loop {
            let p = [self.half(), self.half(), self.half()];
            let l2 = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
            if l2 <= 0.25 && l2 > 0.0 {
                return p.map(|x| x / l2.sqrt());
            }
        }
    }
}

pub fn convex_pile() -> Scene {
    let mut scene = Scene::new("convex_pile", "5120 hulls of 32 points fall into a heap", 500);
    scene.sleep = true;
    scene.floor([250.0, 1.0, 250.0]);
    let mut random = Random(42);
    scene.clouds.push((0..32).map(|_| random.direction().map(|x| f64::from(2.0 * x))).collect());
    for layer in 0..80 {
        for i in 0..8 {
            for k in 0..8 {
                let at =
                    [-16.0 + 4.0 * f64::from(i), 2.0 + 4.0 * f64::from(layer), -16.0 + 4.0 * f64::from(k)];
                scene.bodies.push(Body::dynamic(Form::Hull(0), at));
            }
        }
    }
    scene
}

pub fn box_pile() -> Scene {
    let mut scene = Scene::new("box_pile", "4000 boxes of all sizes fall into a pit", 400);
    scene.floor([20.0, 1.0, 20.0]);
    for (x, z) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
        let half = if z == 0.0 { [1.0, 15.0, 18.0] } else { [18.0, 15.0, 1.0] };
        scene.bodies.push(Body::fixed(Form::Box(half), [17.0 * x, 15.0, 17.0 * z]));
    }
    let mut random = Random(7);
    for layer in 0..10 {
        for i in 0..20 {
            for k in 0..20 {
                let half = [0.45; 3].map(|h| h + 0.3 * f64::from(random.half()));
                let turn = [random.half(), random.half(), random.half(), 1.0].map(f64::from);
                let at =
                    [1.5 * (f64::from(i) - 9.5), 1.0 + 2.0 * f64::from(layer), 1.5 * (f64::from(k) - 9.5)];
                let body = Body::dynamic(Form::Box(half), at);
                scene.bodies.push(Body { rotation: unit(turn), ..body });
            }
        }
    }
    scene
}

/// 8000 balls fall into a pit.
pub fn sphere_pile() -> Scene {
    let mut scene = Scene::new("sphere_pile", "8000 balls fall into a pit", 400);
    pit(&mut scene, 12.0, 20.0);
    let mut random = Random(3);
    for k in 0..8000 {
        let shift = [random.half(), 0.0, random.half()].map(|x| 0.05 * f64::from(x));
        let at = [f64::from(k % 20) - 9.5, 0.6 + f64::from(k / 400), f64::from(k / 20 % 20) - 9.5];
        scene.bodies.push(Body::dynamic(Form::Sphere(0.4), add(at, shift)));
    }
    scene
}

/// 2000 hulls of 8 to 24 points, eight different ones, fall into a pit.
pub fn hull_pile() -> Scene {
    let mut scene = Scene::new("hull_pile", "2000 hulls of 8 to 24 points fall into a pit", 400);
    pit(&mut scene, 12.0, 20.0);
    let mut random = Random(5);
    for k in 0..8 {
        let count = 8 + 16 * k / 7;
        scene.clouds.push((0..count).map(|_| random.direction().map(|x| f64::from(0.5 * x))).collect());
    }
    for k in 0..2000 {
        let at = [k % 10, k / 100, k / 10 % 10].map(f64::from);
        let at = [2.0 * (at[0] - 4.5), 1.0 + 1.2 * at[1], 2.0 * (at[2] - 4.5)];
        scene.bodies.push(Body::dynamic(Form::Hull(k as usize % 8), at));
    }
    scene
}

/// 500 boxes on a plain of 50 000 immovable ones.
pub fn big_static() -> Scene {
    let mut scene = Scene::new("big_static", "500 boxes on 50 000 immovable ones", 400);
    for k in 0..50_000 {
        let at = [f64::from(k % 250) - 125.0, -0.5, f64::from(k / 250) - 100.0];
        scene.bodies.push(Body::fixed(Form::Box([0.5; 3]), at));
    }
    let mut random = Random(9);
    for _ in 0..500 {
        let at = [random.half(), random.half(), random.half()].map(f64::from);
        let at = [200.0 * at[0], 3.0 + 4.0 * at[1], 160.0 * at[2]];
        scene.bodies.push(Body::dynamic(Form::Box([0.4; 3]), at));
    }
    scene
}
