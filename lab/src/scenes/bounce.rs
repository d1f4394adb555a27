//! Restitution.

use crate::scene::{Body, Form, Scene};

/// A ball of diameter 1 m falls 4 m onto a slab with coefficient of restitution 0.9, 100 steps a second.
pub fn bouncing_ball() -> Scene {
    let mut scene = Scene::new("bouncing_ball", "a ball that bounces for 16.994 s", 2000);
    scene.dt = 0.01;
    scene.sleep = true;
    scene.restitution_threshold = Some(0.0);
    let surface = |body: Body| Body { density: 1.0, friction: 0.1, restitution: 0.9, ..body };
    scene.bodies.push(surface(Body::fixed(Form::Box([5.0, 0.5, 5.0]), [0.0, -5.0, 0.0])));
    scene.bodies.push(surface(Body::dynamic(Form::Sphere(0.5), [0.0, 0.0, 0.0])));
    scene
}
