//! Heaps: many contacts that come and go.

use crate::scene::{Body, Form, Scene};

/// The generator that the published convex pile is made with; its constants are part of the scene.
struct Random(u32);

impl Random {
    /// In -0.5 … 0.5.
    fn half(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(2_147_001_325).wrapping_add(715_136_305);
        (self.0 & 0xffff) as f32 / 65535.0 - 0.5
    }

    /// Of length 1: a point of a ball, pushed to its surface.
    fn direction(&mut self) -> [f32; 3] {
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
    scene.clouds.push((0..32).map(|_| random.direction().map(|x| 2.0 * x)).collect());
    for layer in 0..80 {
        for i in 0..8 {
            for k in 0..8 {
                let at = [-16.0 + 4.0 * i as f32, 2.0 + 4.0 * layer as f32, -16.0 + 4.0 * k as f32];
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
                let half = [0.45; 3].map(|h| h + 0.3 * random.half());
                let turn = [random.half(), random.half(), random.half(), 1.0];
                let size = turn.iter().map(|x| x * x).sum::<f32>().sqrt();
                let at = [1.5 * (i as f32 - 9.5), 1.0 + 2.0 * layer as f32, 1.5 * (k as f32 - 9.5)];
                let body = Body::dynamic(Form::Box(half), at);
                scene.bodies.push(Body { rotation: turn.map(|x| x / size), ..body });
            }
        }
    }
    scene
}
