//! merev, through its C interface, as a program in C would use it.

use super::merev::{double, float, kinds};
use super::{Engine, Method, Motion, Setting};
use crate::scene::{Form, Hold, Joint, Kind, Scene};
use crate::vector::{Q4, V3};
use merev::capi::*;
use std::ffi::CStr;

/// What it comes with: the others are the same code behind the same door.
pub fn methods() -> Vec<Method> {
    super::merev::methods().into_iter().take(1).collect()
}

/// A merev world of a scene, held by its id.
pub struct MerevC {
    world: mvWorldId,
    /// All bodies, in the scene's order.
    all: Vec<mvBodyId>,
    /// The dynamic ones.
    bodies: Vec<mvBodyId>,
    dt: mvFloat,
    sub_steps: i32,
}

fn vector(v: V3) -> mvVec3 {
    let [x, y, z] = v.map(float);
    mvVec3 { x, y, z }
}

fn place(v: V3) -> mvPos {
    let [x, y, z] = v.map(float);
    mvPos { x, y, z }
}

fn quaternion(q: Q4) -> mvQuat {
    mvQuat { v: vector([q[0], q[1], q[2]]), s: float(q[3]) }
}

/// The sentence of the last call that failed, if one has.
fn check() -> Result<(), String> {
    if mvGetLastError() == mv_errorNone {
        return Ok(());
    }
    // SAFETY: the message is a string that lives until the next failing call.
    Err(unsafe { CStr::from_ptr(mvGetLastErrorMessage()) }.to_string_lossy().into_owned())
}

/// What a hull of a point cloud is freed by.
struct Hulls(Vec<*mut mvHullData>);

impl Drop for Hulls {
    fn drop(&mut self) {
        // SAFETY: each was made by merev, and is destroyed once.
        self.0.iter().for_each(|&hull| unsafe { mvDestroyHull(hull) });
    }
}

impl MerevC {
    pub fn new(scene: &Scene, method: &Method, setting: &Setting) -> Result<Self, String> {
        // What failed before is not this world's.
        mvGetLastError();
        let (solver, integrator) = kinds(method);
        let mut def = mvDefaultWorldDef();
        def.gravity = vector(scene.gravity);
        def.enable_sleep = scene.sleep.into();
        (def.solver, def.integrator) = (solver as i32, integrator as i32);
        def.solver_iterations = setting.iterations;
        def.accuracy = float(setting.accuracy.unwrap_or(0.0));
        if let Some(speed) = scene.restitution_threshold {
            def.restitution_threshold = float(speed);
        }
        let world = mvCreateWorld(Some(&def));
        let mut this = Self {
            world,
            all: Vec::new(),
            bodies: Vec::new(),
            dt: float(setting.dt()),
            sub_steps: setting.sub_steps as i32,
        };
        this.fill(scene);
        check()?;
        Ok(this)
    }

    fn fill(&mut self, scene: &Scene) {
        let hulls = Hulls(
            scene
                .clouds
                .iter()
                .map(|cloud| {
                    let points: Vec<mvVec3> = cloud.iter().copied().map(vector).collect();
                    let count = points.len() as i32;
                    // SAFETY: the points live during the call.
                    unsafe { mvCreateHull(points.as_ptr(), count, count) }
                })
                .collect(),
        );
        for body in &scene.bodies {
            let mut def = mvDefaultBodyDef();
            def.r#type = match body.kind {
                Kind::Static => mv_staticBody,
                Kind::Kinematic => mv_kinematicBody,
                Kind::Dynamic => mv_dynamicBody,
            };
            def.position = place(body.position);
            def.rotation = quaternion(body.rotation);
            def.linear_velocity = vector(body.velocity);
            def.angular_velocity = vector(body.spin);
            let mut surface = mvDefaultShapeDef();
            surface.density = float(body.density);
            surface.base_material.friction = float(body.friction);
            surface.base_material.restitution = float(body.restitution);
            surface.enable_contact_events = 0;
            if !body.collides {
                surface.filter.mask_bits = 0;
            }
            // SAFETY: definitions come from their own functions, ids are those just made, hulls are live.
            let id = unsafe {
                let id = mvCreateBody(self.world, Some(&def));
                match body.form {
                    Form::Box(half) => {
                        let [x, y, z] = half.map(float);
                        mvCreateBoxShape(id, Some(&surface), x, y, z);
                    }
                    Form::Sphere(radius) => {
                        let sphere = mvSphere { center: vector([0.0; 3]), radius: float(radius) };
                        mvCreateSphereShape(id, Some(&surface), Some(&sphere));
                    }
                    Form::Capsule(half, radius) => {
                        let capsule = mvCapsule {
                            center1: vector([0.0, -half, 0.0]),
                            center2: vector([0.0, half, 0.0]),
                            radius: float(radius),
                        };
                        mvCreateCapsuleShape(id, Some(&surface), Some(&capsule));
                    }
                    Form::Hull(k) => {
                        mvCreateHullShape(id, Some(&surface), hulls.0[k]);
                    }
                    Form::Boxes(k) => {
                        for part in &scene.compounds[k] {
                            let at = mvTransform { p: vector(part.position), q: quaternion(part.rotation) };
                            let unit = mvMakeCubeHull(1.0);
                            let size = vector(part.half);
                            mvCreateTransformedHullShape(id, Some(&surface), &raw const unit.base, at, size);
                        }
                    }
                }
                id
            };
            if let Some(mass) = body.mass {
                let [x, y, z] = mass.inertia;
                let inertia = mvMatrix3 {
                    cx: vector([x, 0.0, 0.0]),
                    cy: vector([0.0, y, 0.0]),
                    cz: vector([0.0, 0.0, z]),
                };
                mvBody_SetMassData(
                    id,
                    mvMassData { mass: float(mass.mass), center: vector(mass.center), inertia },
                );
                mvBody_SetLinearVelocity(id, vector(body.velocity));
                mvBody_SetAngularVelocity(id, vector(body.spin));
            }
            self.all.push(id);
            if body.kind == Kind::Dynamic {
                self.bodies.push(id);
            }
        }
        for joint in &scene.joints {
            self.tie(joint);
        }
    }

    /// Makes a joint.
    fn tie(&self, joint: &Joint) {
        let fill = |base: &mut mvJointDef| {
            (base.body_id_a, base.body_id_b) = (self.all[joint.bodies[0]], self.all[joint.bodies[1]]);
            for (k, frame) in [&mut base.local_frame_a, &mut base.local_frame_b].into_iter().enumerate() {
                *frame = mvTransform { p: vector(joint.local[k]), q: quaternion(joint.axes[k]) };
            }
        };
        match joint.hold {
            Hold::Ball => {
                let mut def = mvDefaultSphericalJointDef();
                fill(&mut def.base);
                mvCreateSphericalJoint(self.world, Some(&def));
            }
            Hold::Hinge => {
                let mut def = mvDefaultRevoluteJointDef();
                fill(&mut def.base);
                mvCreateRevoluteJoint(self.world, Some(&def));
            }
            Hold::Slider(spring) => {
                let mut def = mvDefaultPrismaticJointDef();
                fill(&mut def.base);
                if let Some(s) = spring {
                    def.enable_spring = 1;
                    (def.hertz, def.damping_ratio) = (float(s.hertz), float(s.damping_ratio));
                }
                mvCreatePrismaticJoint(self.world, Some(&def));
            }
            Hold::Weld => {
                let mut def = mvDefaultWeldJointDef();
                fill(&mut def.base);
                mvCreateWeldJoint(self.world, Some(&def));
            }
            Hold::Rod(length) => {
                let mut def = mvDefaultDistanceJointDef();
                fill(&mut def.base);
                def.length = float(length);
                mvCreateDistanceJoint(self.world, Some(&def));
            }
            Hold::Spring(length, s) => {
                let mut def = mvDefaultDistanceJointDef();
                fill(&mut def.base);
                def.length = float(length);
                def.enable_spring = 1;
                (def.hertz, def.damping_ratio) = (float(s.hertz), float(s.damping_ratio));
                mvCreateDistanceJoint(self.world, Some(&def));
            }
        }
    }
}

impl Engine for MerevC {
    fn step(&mut self) {
        mvWorld_Step(self.world, self.dt, self.sub_steps);
    }

    fn push(&mut self, body: usize, force: V3, point: V3) {
        mvBody_ApplyForce(self.all[body], vector(force), place(point), 1);
    }

    fn is_broken(&self) -> bool {
        mvWorld_GetStepReport(self.world).quarantined_count > 0
    }

    fn motions(&self, out: &mut Vec<Motion>) {
        out.clear();
        out.extend(self.bodies.iter().map(|&id| {
            let (p, q) = (mvBody_GetWorldCenter(id), mvBody_GetTransform(id).q);
            let (v, w) = (mvBody_GetLinearVelocity(id), mvBody_GetAngularVelocity(id));
            Motion {
                position: [p.x, p.y, p.z].map(double),
                rotation: [q.v.x, q.v.y, q.v.z, q.s].map(double),
                velocity: [v.x, v.y, v.z].map(double),
                spin: [w.x, w.y, w.z].map(double),
            }
        }));
    }
}

impl Drop for MerevC {
    fn drop(&mut self) {
        mvDestroyWorld(self.world);
    }
}
