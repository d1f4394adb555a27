//! What several tests share: seeded randomness and random scenes.
#![allow(dead_code, reason = "each test uses a part of it")]

use merev::broad_phase::BroadPhaseKind;
use merev::math::{quat, vec3};
use merev::world::{BodyDef, BodyType, ShapeDef, WorldDef};
use merev::{BodyId, Float, Pose, Quat, Shape, Vec3, World};

/// SplitMix64 (Steele, Lea & Flood 2014).
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }

    pub fn within(&mut self, lo: Float, hi: Float) -> Float {
        lo + (hi - lo) * ((self.bits() >> 40) as Float / (1_u64 << 24) as Float)
    }

    pub fn vec(&mut self, r: Float) -> Vec3 {
        vec3(self.within(-r, r), self.within(-r, r), self.within(-r, r))
    }

    pub fn rotation(&mut self) -> Quat {
        quat(self.within(-1.0, 1.0), self.vec(1.0))
    }

    pub fn pose(&mut self, r: Float) -> Pose {
        Pose::new(self.vec(r), self.rotation())
    }

    /// A bounded shape of any kind, of size about 1.
    pub fn shape(&mut self) -> Shape {
        match self.below(4) {
            0 => Shape::new_sphere(self.within(0.2, 1.5)),
            1 => Shape::new_capsule(self.within(0.2, 1.5), self.within(0.2, 1.0)),
            2 => Shape::new_box(self.within(0.2, 2.0), self.within(0.2, 2.0), self.within(0.2, 2.0)),
            _ => {
                let points: Vec<Vec3> = (0..6 + self.below(20)).map(|_| self.vec(0.7)).collect();
                Shape::hull(&points).expect("random points span a hull")
            }
        }
    }
}

/// A world of this broad phase with a floor and `n` random bodies of all types over it.
pub fn random_world(kind: BroadPhaseKind, seed: u64, n: usize) -> (World, Vec<BodyId>) {
    let mut random = Random(seed);
    let mut world = World::try_new(&WorldDef { broad_phase: kind, ..WorldDef::default() }).unwrap();
    let floor = world.create_body(&BodyDef::fixed(vec3(0.0, -4.0, 0.0))).unwrap();
    let plane = Shape::half_space(vec3(0.1, 1.0, -0.05), 0.0).unwrap();
    world.create_shape(floor, &ShapeDef::default(), plane, Pose::IDENTITY).unwrap();
    let bodies = (0..n).map(|_| random_body(&mut world, &mut random)).collect();
    (world, bodies)
}

/// Adds a body of any type with one to three shapes.
pub fn random_body(world: &mut World, random: &mut Random) -> BodyId {
    let body_type = match random.below(8) {
        0 | 1 => BodyType::Static,
        2 => BodyType::Kinematic,
        _ => BodyType::Dynamic,
    };
    let def = BodyDef {
        body_type,
        position: random.vec(5.0),
        rotation: random.rotation(),
        linear_velocity: if random.below(4) == 0 { random.vec(60.0) } else { random.vec(2.0) },
        angular_velocity: random.vec(6.0),
        is_enabled: random.below(10) != 0,
        is_awake: random.below(6) != 0,
        ..BodyDef::default()
    };
    let body = world.create_body(&def).unwrap();
    for _ in 0..1 + random.below(3) {
        let mut def = ShapeDef { density: 100.0, ..ShapeDef::default() };
        def.filter.category_bits = 1 << random.below(4);
        def.material.user_material_id = random.bits();
        def.material.restitution = 0.3;
        let (shape, local) = (random.shape(), random.pose(0.5));
        world.create_shape(body, &def, shape, local).unwrap();
    }
    body
}
