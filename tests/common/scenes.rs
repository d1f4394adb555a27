//! Scenes of the laws and stability tests, each axis-aligned or turned as a whole (gravity included).
#![allow(dead_code, reason = "each test uses a part of it")]

use merev::math::{quat_about, vec3};
use merev::world::{BodyDef, ShapeDef, WorldDef};
use merev::{BodyId, Float, Quat, Shape, Vec3, World};

/// A scene under construction: everything is given in upright coordinates and placed turned.
pub struct Scene {
    pub world: World,
    pub turn: Quat,
    /// Upright origin of the scene in the world.
    pub origin: Vec3,
}

/// Upright, and turned by an arbitrary rotation.
pub fn orientations() -> [Quat; 2] {
    [Quat::identity(), quat_about(vec3(0.48, -0.31, 0.82), 1.234)]
}

impl Scene {
    pub fn new(def: &WorldDef, turn: Quat) -> Self {
        let def = WorldDef { gravity: turn * def.gravity, ..def.clone() };
        Self { world: World::try_new(&def).unwrap(), turn, origin: Vec3::zeros() }
    }

    pub fn add(&mut self, def: &BodyDef, surface: &ShapeDef, shape: Shape) -> BodyId {
        let placed = BodyDef {
            position: self.turn * (def.position + self.origin),
            rotation: self.turn * def.rotation,
            linear_velocity: self.turn * def.linear_velocity,
            angular_velocity: self.turn * def.angular_velocity,
            ..def.clone()
        };
        self.world.create_body_with_shape(&placed, surface, shape).unwrap().0
    }

    /// A large static box whose top is at height 0.
    pub fn floor(&mut self, surface: &ShapeDef) -> BodyId {
        self.add(&BodyDef::fixed(vec3(0.0, -1.0, 0.0)), surface, Shape::new_box(400.0, 2.0, 400.0))
    }

    /// The upright position of a body's origin.
    pub fn position(&self, body: BodyId) -> Vec3 {
        self.turn.conjugate() * self.world.body(body).unwrap().transform().p - self.origin
    }

    /// The upright velocity of a body's centre.
    pub fn velocity(&self, body: BodyId) -> Vec3 {
        self.turn.conjugate() * self.world.body(body).unwrap().linear_velocity()
    }

    /// Steps of 1/60 s in 4 sub-steps.
    pub fn steps(&mut self, count: usize) {
        for _ in 0..count {
            self.world.try_step(1.0 / 60.0, 4).unwrap();
        }
    }

    pub fn all_asleep(&self) -> bool {
        self.world.counters().awake_bodies == 0
    }
}

pub fn cube() -> Shape {
    Shape::new_box(1.0, 1.0, 1.0)
}

/// A world without sleep.
pub fn sleepless() -> WorldDef {
    WorldDef { enable_sleep: false, ..WorldDef::default() }
}

/// `n` unit cubes on each other.
pub fn stack(def: &WorldDef, turn: Quat, n: usize) -> (Scene, Vec<BodyId>) {
    let mut scene = Scene::new(def, turn);
    scene.floor(&ShapeDef::default());
    let bodies = (0..n)
        .map(|i| {
            let at = BodyDef::dynamic(vec3(0.0, 0.5 + i as Float, 0.0));
            scene.add(&at, &ShapeDef::default(), cube())
        })
        .collect();
    (scene, bodies)
}

/// A cube of `ratio` kg on a cube of 1 kg.
pub fn heavy_on_light(def: &WorldDef, turn: Quat, ratio: Float) -> Scene {
    let mut scene = Scene::new(def, turn);
    scene.floor(&ShapeDef::default());
    for (i, density) in [1.0, ratio].into_iter().enumerate() {
        let surface = ShapeDef { density, ..ShapeDef::default() };
        scene.add(&BodyDef::dynamic(vec3(0.0, 0.5 + i as Float, 0.0)), &surface, cube());
    }
    scene
}

/// A planar pyramid of unit cubes, density 100, with `rows` rows; returns the topmost last.
pub fn pyramid(def: &WorldDef, turn: Quat, rows: usize) -> (Scene, Vec<BodyId>) {
    let mut scene = Scene::new(def, turn);
    scene.floor(&ShapeDef::default());
    let surface = ShapeDef { density: 100.0, ..ShapeDef::default() };
    let mut bodies = Vec::new();
    for row in 0..rows {
        for k in row..rows {
            let x = 0.5 * row as Float + (k - row) as Float - 0.5 * rows as Float;
            let at = BodyDef::dynamic(vec3(x, 0.5 + row as Float, 0.0));
            bodies.push(scene.add(&at, &surface, cube()));
        }
    }
    (scene, bodies)
}
