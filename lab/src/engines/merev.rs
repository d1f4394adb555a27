//! merev, through its Rust API; and merev as the ruler that all engines are measured with.

use super::{Engine, Method, Motion, Setting};
use crate::scene::{Form, Hold, Joint, Kind, Scene, Spring};
use crate::vector::{Q4, V3};
use merev::constraint::joint::{
    DistanceJoint, Drive, JointKind, PrismaticJoint, RevoluteJoint, SphericalJoint, Spring as JointSpring,
    WeldJoint,
};
use merev::integrate::IntegratorKind;
use merev::math::{Pose, Quat};
use merev::shape::MassData;
use merev::solver::SolverKind;
use merev::world::{Filter, JointDef, StepReport, SurfaceMaterial};
use merev::{BodyDef, BodyId, BodyType, Float, Mat3, Shape, ShapeDef, Vec3, World, WorldDef};

/// Of the build.
pub const PRECISION: &str = if size_of::<Float>() == 8 { "f64" } else { "f32" };

/// What it comes with first, then the other solvers, then the other integrators.
pub fn methods() -> Vec<Method> {
    let (solver, integrator) = (SolverKind::Auto.resolved(), IntegratorKind::MoserVeselov);
    let method = |s: SolverKind, i: IntegratorKind| Method {
        solver: s.name(),
        integrator: i.name(),
        iterates: s.iterates(),
    };
    let mut all = vec![method(solver, integrator)];
    all.extend(SolverKind::ALL.into_iter().filter(|&s| s != solver).map(|s| method(s, integrator)));
    all.extend(IntegratorKind::ALL.into_iter().filter(|&i| i != integrator).map(|i| method(solver, i)));
    all
}

/// Solver and integrator of a method.
pub fn kinds(method: &Method) -> (SolverKind, IntegratorKind) {
    let solver = SolverKind::ALL.into_iter().find(|s| s.name() == method.solver);
    let integrator = IntegratorKind::ALL.into_iter().find(|i| i.name() == method.integrator);
    (solver.unwrap_or_default(), integrator.unwrap_or_default())
}

/// A merev world of a scene.
pub struct Merev {
    world: World,
    /// All bodies, in the scene's order.
    all: Vec<BodyId>,
    /// The dynamic ones.
    bodies: Vec<BodyId>,
    dt: Float,
    sub_steps: u32,
}

#[allow(clippy::unnecessary_cast, reason = "Float may be f64")]
pub(super) fn float(x: f64) -> Float {
    x as Float
}

#[allow(clippy::useless_conversion, reason = "Float may be f64")]
pub fn double(x: Float) -> f64 {
    f64::from(x)
}

fn vector(v: V3) -> Vec3 {
    Vec3::new(float(v[0]), float(v[1]), float(v[2]))
}

fn turn(q: Q4) -> Quat {
    let mut quaternion = Quat::identity().into_inner();
    quaternion.coords.copy_from_slice(&q.map(float));
    Quat::new_unchecked(quaternion)
}

fn spring(s: &Spring) -> JointSpring {
    JointSpring {
        enable: true,
        hertz: float(s.hertz),
        damping_ratio: float(s.damping_ratio),
        ..JointSpring::default()
    }
}

fn joint_kind(hold: &Hold) -> JointKind {
    match hold {
        Hold::Ball => JointKind::Spherical(SphericalJoint::default()),
        Hold::Hinge => JointKind::Revolute(RevoluteJoint::default()),
        Hold::Slider(s) => JointKind::Prismatic(PrismaticJoint {
            drive: Drive { spring: s.as_ref().map(spring).unwrap_or_default(), ..Drive::default() },
        }),
        Hold::Weld => JointKind::Weld(WeldJoint::default()),
        Hold::Rod(length) => {
            JointKind::Distance(DistanceJoint { length: float(*length), ..DistanceJoint::default() })
        }
        Hold::Spring(length, s) => JointKind::Distance(DistanceJoint {
            length: float(*length),
            enable_spring: true,
            hertz: float(s.hertz),
            damping_ratio: float(s.damping_ratio),
            ..DistanceJoint::default()
        }),
    }
}

impl Merev {
    pub fn new(scene: &Scene, method: &Method, setting: &Setting) -> Result<Self, String> {
        let (solver, integrator) = kinds(method);
        let mut def = WorldDef {
            gravity: vector(scene.gravity),
            enable_sleep: scene.sleep,
            solver,
            integrator,
            solver_iterations: setting.iterations,
            accuracy: float(setting.accuracy.unwrap_or(0.0)),
            ..WorldDef::default()
        };
        if let Some(speed) = scene.restitution_threshold {
            def.restitution_threshold = float(speed);
        }
        let mut this = Self {
            world: World::try_new(&def).map_err(|e| e.to_string())?,
            all: Vec::new(),
            bodies: Vec::new(),
            dt: float(setting.dt()),
            sub_steps: setting.sub_steps,
        };
        this.fill(scene).map_err(|e| e.to_string())?;
        Ok(this)
    }

    fn fill(&mut self, scene: &Scene) -> merev::Result<()> {
        let hulls = scene
            .clouds
            .iter()
            .map(|cloud| Shape::hull(&cloud.iter().copied().map(vector).collect::<Vec<_>>()))
            .collect::<merev::Result<Vec<Shape>>>()?;
        for body in &scene.bodies {
            let def = BodyDef {
                body_type: match body.kind {
                    Kind::Static => BodyType::Static,
                    Kind::Kinematic => BodyType::Kinematic,
                    Kind::Dynamic => BodyType::Dynamic,
                },
                position: vector(body.position),
                rotation: turn(body.rotation),
                linear_velocity: vector(body.velocity),
                angular_velocity: vector(body.spin),
                ..BodyDef::default()
            };
            let surface = ShapeDef {
                density: float(body.density),
                material: SurfaceMaterial {
                    friction: float(body.friction),
                    restitution: float(body.restitution),
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
            let id = self.world.create_body(&def)?;
            let mut attach = |shape: Shape, at: Pose| self.world.create_shape(id, &surface, shape, at);
            let cuboid = |half: V3| {
                let full = vector(half) * 2.0;
                Shape::try_new_box(full.x, full.y, full.z)
            };
            match body.form {
                Form::Box(half) => attach(cuboid(half)?, Pose::IDENTITY)?,
                Form::Sphere(radius) => attach(Shape::try_new_sphere(2.0 * float(radius))?, Pose::IDENTITY)?,
                Form::Capsule(half, radius) => {
                    attach(Shape::try_new_capsule(2.0 * float(half), 2.0 * float(radius))?, Pose::IDENTITY)?
                }
                Form::Hull(k) => attach(hulls[k].clone(), Pose::IDENTITY)?,
                Form::Boxes(k) => {
                    let mut last = None;
                    for part in &scene.compounds[k] {
                        let at = Pose::new(vector(part.position), turn(part.rotation));
                        last = Some(attach(cuboid(part.half)?, at)?);
                    }
                    last.expect("a compound has parts")
                }
            };
            if let Some(mass) = body.mass {
                let data = MassData {
                    mass: float(mass.mass),
                    center: vector(mass.center),
                    inertia: Mat3::from_diagonal(&vector(mass.inertia)),
                };
                self.world.body_mut(id)?.set_mass_data(&data)?;
                // The state is momentum: with another mass it would be another velocity.
                let mut body_mut = self.world.body_mut(id)?;
                body_mut.set_linear_velocity(vector(body.velocity))?;
                body_mut.set_angular_velocity(vector(body.spin))?;
            }
            self.all.push(id);
            if body.kind == Kind::Dynamic {
                self.bodies.push(id);
            }
        }
        for joint in &scene.joints {
            let Joint { hold, bodies, local, axes } = joint;
            let frame = |k: usize| Pose::new(vector(local[k]), turn(axes[k]));
            let (a, b) = (self.all[bodies[0]], self.all[bodies[1]]);
            self.world.create_joint(&JointDef::new(joint_kind(hold), a, b).frames(frame(0), frame(1)))?;
        }
        Ok(())
    }

    /// Energy, momentum and overlap of a scene whose dynamic bodies are there, whichever engine moved them: one
    /// ruler for all. Contacts are found anew at exactly these places. None if they are nowhere.
    pub fn measure(scene: &Scene, motions: &[Motion]) -> Option<StepReport> {
        let mut scene = scene.clone();
        scene.sleep = false;
        let mut there = motions.iter();
        for body in scene.bodies.iter_mut().filter(|b| b.kind == Kind::Dynamic) {
            let motion = there.next().expect("a motion for every dynamic body");
            body.rotation = crate::vector::unit(motion.rotation);
            let arm = crate::vector::rotate(body.rotation, body.center());
            body.position = crate::vector::sub(motion.position, arm);
            (body.velocity, body.spin) = (motion.velocity, motion.spin);
        }
        let mut ruler = Self::new(&scene, &methods()[0], &Setting::of(&scene)).ok()?;
        ruler.world.try_step(0.0, 1).ok()?;
        Some(ruler.world.step_report())
    }
}

impl Engine for Merev {
    fn step(&mut self) {
        self.world.try_step(self.dt, self.sub_steps).expect("a step");
    }

    fn push(&mut self, body: usize, force: V3, point: V3) {
        let mut body = self.world.body_mut(self.all[body]).expect("a live body");
        body.apply_force(vector(force), vector(point), true).expect("a finite force");
    }

    fn motions(&self, out: &mut Vec<Motion>) {
        out.clear();
        out.extend(self.bodies.iter().map(|&id| {
            let body = self.world.body(id).expect("a live body");
            let (p, Pose { q, .. }) = (body.world_center(), body.transform());
            let (v, w) = (body.linear_velocity(), body.angular_velocity());
            Motion {
                position: [p.x, p.y, p.z].map(double),
                rotation: [q.i, q.j, q.k, q.w].map(double),
                velocity: [v.x, v.y, v.z].map(double),
                spin: [w.x, w.y, w.z].map(double),
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

    fn residual(&self) -> Option<f64> {
        let report = self.world.step_report();
        Some(double(report.residual.max(report.solve.residual)))
    }

    fn is_broken(&self) -> bool {
        self.world.step_report().quarantined > 0
    }
}
