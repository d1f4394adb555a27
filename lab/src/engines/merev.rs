//! merev, through its Rust API; and merev as the ruler that all engines are measured with.

use super::{Engine, Motion};
use crate::scene::{Form, Kind, Scene};
use merev::constraint::joint::{JointKind, SphericalJoint};
use merev::math::{Pose, Quat};
use merev::shape::MassData;
use merev::world::{Filter, JointDef, StepReport, SurfaceMaterial};
use merev::{BodyDef, BodyId, BodyType, Float, Mat3, Shape, ShapeDef, Vec3, World, WorldDef};

/// A merev world of a scene.
pub struct Merev {
    world: World,
    /// The dynamic bodies.
    bodies: Vec<BodyId>,
    dt: Float,
    sub_steps: u32,
}

fn vector(v: [f32; 3]) -> Vec3 {
    Vec3::new(Float::from(v[0]), Float::from(v[1]), Float::from(v[2]))
}

fn turn(q: [f32; 4]) -> Quat {
    let mut quaternion = Quat::identity().into_inner();
    quaternion.coords.copy_from_slice(&q.map(Float::from));
    Quat::new_unchecked(quaternion)
}

#[allow(clippy::unnecessary_cast, reason = "Float may be f64")]
fn narrow(x: Float) -> f32 {
    x as f32
}

impl Merev {
    pub fn new(scene: &Scene) -> Self {
        let mut def =
            WorldDef { gravity: vector(scene.gravity), enable_sleep: scene.sleep, ..WorldDef::default() };
        if let Some(speed) = scene.restitution_threshold {
            def.restitution_threshold = Float::from(speed);
        }
        let mut world = World::try_new(&def).expect("the scene's world");
        let hulls: Vec<Shape> = scene
            .clouds
            .iter()
            .map(|cloud| Shape::hull(&cloud.iter().copied().map(vector).collect::<Vec<_>>()).expect("a hull"))
            .collect();
        let (mut bodies, mut all) = (Vec::new(), Vec::new());
        for body in &scene.bodies {
            let def = BodyDef {
                body_type: if body.kind == Kind::Static { BodyType::Static } else { BodyType::Dynamic },
                position: vector(body.position),
                rotation: turn(body.rotation),
                linear_velocity: vector(body.velocity),
                ..BodyDef::default()
            };
            let surface = ShapeDef {
                density: Float::from(body.density),
                material: SurfaceMaterial {
                    friction: Float::from(body.friction),
                    restitution: Float::from(body.restitution),
                    ..SurfaceMaterial::default()
                },
                enable_contact_events: false,
                filter: if body.collides {
                    Filter::default()
                } else {
                    Filter { mask_bits: 0, ..Filter::default() }
                },
                ..ShapeDef::default()
            };
            let shape = match body.form {
                Form::Box(half) => {
                    let full = vector(half) * 2.0;
                    Shape::new_box(full.x, full.y, full.z)
                }
                Form::Sphere(radius) => Shape::new_sphere(2.0 * Float::from(radius)),
                Form::Hull(k) => hulls[k].clone(),
            };
            let (id, _) = world.create_body_with_shape(&def, &surface, shape).expect("the scene's body");
            if let Some(mass) = body.mass {
                let data = MassData {
                    mass: Float::from(mass.mass),
                    center: Vec3::zeros(),
                    inertia: Mat3::from_diagonal(&vector(mass.inertia)),
                };
                world.body_mut(id).expect("just made").set_mass_data(&data).expect("a body's mass");
            }
            all.push(id);
            if body.kind == Kind::Dynamic {
                bodies.push(id);
            }
        }
        for ball in &scene.balls {
            let kind = JointKind::Spherical(SphericalJoint::default());
            let frame = |k: usize| Pose::new(vector(ball.local[k]), Quat::identity());
            let def =
                JointDef::new(kind, all[ball.bodies[0]], all[ball.bodies[1]]).frames(frame(0), frame(1));
            world.create_joint(&def).expect("the scene's joint");
        }
        Self { world, bodies, dt: Float::from(scene.dt), sub_steps: scene.sub_steps }
    }

    /// Energy, momentum and overlap of a scene whose dynamic bodies are there, whichever engine moved them: one
    /// ruler for all. Contacts are found anew at exactly these places.
    pub fn measure(scene: &Scene, motions: &[Motion]) -> StepReport {
        let mut scene = scene.clone();
        scene.sleep = false;
        let mut there = motions.iter();
        for body in scene.bodies.iter_mut().filter(|b| b.kind == Kind::Dynamic) {
            let motion = there.next().expect("a motion for every dynamic body");
            (body.position, body.rotation) = (motion.position, motion.rotation);
        }
        let mut ruler = Self::new(&scene);
        for (&id, motion) in ruler.bodies.iter().zip(motions) {
            let mut body = ruler.world.body_mut(id).expect("a live body");
            body.set_linear_velocity(vector(motion.velocity)).expect("a finite velocity");
            body.set_angular_velocity(vector(motion.spin)).expect("a finite velocity");
        }
        ruler.world.try_step(0.0, 1).expect("a step of no length");
        ruler.world.step_report()
    }
}

impl Engine for Merev {
    fn step(&mut self) {
        self.world.try_step(self.dt, self.sub_steps).expect("a step");
    }

    fn motions(&self, out: &mut Vec<Motion>) {
        out.clear();
        out.extend(self.bodies.iter().map(|&id| {
            let body = self.world.body(id).expect("a live body");
            let Pose { p, q } = body.transform();
            let (v, w) = (body.linear_velocity(), body.angular_velocity());
            Motion {
                position: [p.x, p.y, p.z].map(narrow),
                rotation: [q.i, q.j, q.k, q.w].map(narrow),
                velocity: [v.x, v.y, v.z].map(narrow),
                spin: [w.x, w.y, w.z].map(narrow),
            }
        }));
    }

    fn stages(&self) -> Vec<(&'static str, f32)> {
        let p = self.world.profile();
        vec![
            ("boxes", p.update_bounds),
            ("pairs", p.find_pairs),
            ("contacts", p.update_contacts),
            ("islands", p.build_islands),
            ("prepare", p.prepare),
            ("solve", p.solve),
            ("advance", p.advance),
            ("sleep", p.update_sleep),
            ("events", p.publish_events),
        ]
    }
}
