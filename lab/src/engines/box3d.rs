//! Box3D, through the declarations of boxddd-sys.

use super::{Engine, Method, Motion, Setting};
use crate::scene::{Form, Hold, Kind, Scene, Spring};
use crate::vector::{Q4, V3};
use boxddd_sys::ffi as b3;

/// It has one way.
pub fn methods() -> Vec<Method> {
    vec![Method { solver: "soft_step", integrator: "", iterates: false }]
}

/// A Box3D world of a scene.
pub struct Box3d {
    world: b3::b3WorldId,
    /// All bodies, in the scene's order.
    all: Vec<b3::b3BodyId>,
    /// The dynamic ones.
    bodies: Vec<b3::b3BodyId>,
    dt: f32,
    sub_steps: i32,
}

fn vector(v: V3) -> b3::b3Vec3 {
    let [x, y, z] = v.map(|x| x as f32);
    b3::b3Vec3 { x, y, z }
}

fn quaternion(q: Q4) -> b3::b3Quat {
    b3::b3Quat { v: vector([q[0], q[1], q[2]]), s: q[3] as f32 }
}

fn array(v: b3::b3Vec3) -> V3 {
    [v.x, v.y, v.z].map(f64::from)
}

/// What a hull of a point cloud is freed by.
struct Hulls(Vec<*mut b3::b3HullData>);

impl Drop for Hulls {
    fn drop(&mut self) {
        // SAFETY: each was made by Box3D, which copies hulls into its shapes, and is destroyed once.
        self.0.iter().for_each(|&hull| unsafe { b3::b3DestroyHull(hull) });
    }
}

impl Box3d {
    pub fn new(scene: &Scene, setting: &Setting) -> Result<Self, String> {
        if setting.accuracy.is_some() || setting.iterations > 0 {
            return Err("Box3D has no such setting".into());
        }
        // SAFETY: definitions come from their own functions, ids are those just made, and every pointer is to a
        // live local value, which Box3D copies.
        unsafe {
            let mut def = b3::b3DefaultWorldDef();
            def.gravity = vector(scene.gravity);
            def.enableSleep = scene.sleep;
            def.workerCount = 1;
            // merev has no continuous collision yet; nobody is to pay for what the other does not do.
            def.enableContinuous = false;
            // ∞ is refused; this is far beyond what any scene reaches.
            def.maximumLinearSpeed = 1e5;
            if let Some(speed) = scene.restitution_threshold {
                def.restitutionThreshold = speed as f32;
            }
            let world = b3::b3CreateWorld(&raw const def);
            let mut this = Self {
                world,
                all: Vec::new(),
                bodies: Vec::new(),
                dt: setting.dt() as f32,
                sub_steps: setting.sub_steps as i32,
            };
            let mut hulls = Hulls(Vec::new());
            for cloud in &scene.clouds {
                let points: Vec<b3::b3Vec3> = cloud.iter().copied().map(vector).collect();
                let count = points.len() as i32;
                let hull = b3::b3CreateHull(points.as_ptr(), count, count);
                if hull.is_null() {
                    return Err("Box3D makes no hull of these points".into());
                }
                hulls.0.push(hull);
            }
            for body in &scene.bodies {
                let mut def = b3::b3DefaultBodyDef();
                def.type_ = match body.kind {
                    Kind::Static => b3::b3BodyType_b3_staticBody,
                    Kind::Kinematic => b3::b3BodyType_b3_kinematicBody,
                    Kind::Dynamic => b3::b3BodyType_b3_dynamicBody,
                };
                def.position = vector(body.position);
                def.rotation = quaternion(body.rotation);
                def.linearVelocity = vector(body.velocity);
                def.angularVelocity = vector(body.spin);
                // A turn of more than 45° a step is else cut.
                def.allowFastRotation = true;
                let id = b3::b3CreateBody(world, &raw const def);
                let mut surface = b3::b3DefaultShapeDef();
                surface.density = body.density as f32;
                surface.baseMaterial.friction = body.friction as f32;
                surface.baseMaterial.restitution = body.restitution as f32;
                surface.enableContactEvents = false;
                if !body.collides {
                    surface.filter.maskBits = 0;
                }
                match body.form {
                    Form::Box(half) => {
                        let [x, y, z] = half.map(|x| x as f32);
                        let hull = b3::b3MakeBoxHull(x, y, z);
                        b3::b3CreateHullShape(id, &raw const surface, &raw const hull.base);
                    }
                    Form::Sphere(radius) => {
                        let sphere = b3::b3Sphere { center: vector([0.0; 3]), radius: radius as f32 };
                        b3::b3CreateSphereShape(id, &raw const surface, &raw const sphere);
                    }
                    Form::Capsule(half, radius) => {
                        let capsule = b3::b3Capsule {
                            center1: vector([0.0, -half, 0.0]),
                            center2: vector([0.0, half, 0.0]),
                            radius: radius as f32,
                        };
                        b3::b3CreateCapsuleShape(id, &raw const surface, &raw const capsule);
                    }
                    Form::Hull(k) => {
                        b3::b3CreateHullShape(id, &raw const surface, hulls.0[k]);
                    }
                    Form::Boxes(k) => {
                        for part in &scene.compounds[k] {
                            let at =
                                b3::b3Transform { p: vector(part.position), q: quaternion(part.rotation) };
                            let [x, y, z] = part.half.map(|x| x as f32);
                            let hull = b3::b3MakeTransformedBoxHull(x, y, z, at);
                            b3::b3CreateHullShape(id, &raw const surface, &raw const hull.base);
                        }
                    }
                }
                if let Some(mass) = body.mass {
                    let [x, y, z] = mass.inertia;
                    let inertia = b3::b3Matrix3 {
                        cx: vector([x, 0.0, 0.0]),
                        cy: vector([0.0, y, 0.0]),
                        cz: vector([0.0, 0.0, z]),
                    };
                    let data =
                        b3::b3MassData { mass: mass.mass as f32, center: vector(mass.center), inertia };
                    b3::b3Body_SetMassData(id, data);
                    // It has been changed with the centre.
                    b3::b3Body_SetLinearVelocity(id, vector(body.velocity));
                }
                this.all.push(id);
                if body.kind == Kind::Dynamic {
                    this.bodies.push(id);
                }
            }
            for joint in &scene.joints {
                this.tie(joint);
            }
            Ok(this)
        }
    }

    /// Makes a joint.
    fn tie(&self, joint: &crate::scene::Joint) {
        let fill = |base: &mut b3::b3JointDef| {
            (base.bodyIdA, base.bodyIdB) = (self.all[joint.bodies[0]], self.all[joint.bodies[1]]);
            for (k, frame) in [&mut base.localFrameA, &mut base.localFrameB].into_iter().enumerate() {
                *frame = b3::b3Transform { p: vector(joint.local[k]), q: quaternion(joint.axes[k]) };
            }
        };
        // SAFETY: definitions come from their own functions, ids are live, pointers are to live local values.
        unsafe {
            match joint.hold {
                Hold::Ball => {
                    let mut def = b3::b3DefaultSphericalJointDef();
                    fill(&mut def.base);
                    b3::b3CreateSphericalJoint(self.world, &raw const def);
                }
                Hold::Hinge => {
                    let mut def = b3::b3DefaultRevoluteJointDef();
                    fill(&mut def.base);
                    b3::b3CreateRevoluteJoint(self.world, &raw const def);
                }
                Hold::Slider(spring) => {
                    let mut def = b3::b3DefaultPrismaticJointDef();
                    fill(&mut def.base);
                    if let Some(Spring { hertz, damping_ratio, .. }) = spring {
                        def.enableSpring = true;
                        (def.hertz, def.dampingRatio) = (hertz as f32, damping_ratio as f32);
                    }
                    b3::b3CreatePrismaticJoint(self.world, &raw const def);
                }
                Hold::Weld => {
                    let mut def = b3::b3DefaultWeldJointDef();
                    fill(&mut def.base);
                    b3::b3CreateWeldJoint(self.world, &raw const def);
                }
                Hold::Rod(length) => {
                    let mut def = b3::b3DefaultDistanceJointDef();
                    fill(&mut def.base);
                    def.length = length as f32;
                    b3::b3CreateDistanceJoint(self.world, &raw const def);
                }
                Hold::Spring(length, spring) => {
                    let mut def = b3::b3DefaultDistanceJointDef();
                    fill(&mut def.base);
                    def.length = length as f32;
                    def.enableSpring = true;
                    (def.hertz, def.dampingRatio) = (spring.hertz as f32, spring.damping_ratio as f32);
                    b3::b3CreateDistanceJoint(self.world, &raw const def);
                }
            }
        }
    }
}

impl Engine for Box3d {
    fn step(&mut self) {
        // SAFETY: the world lives as long as self.
        unsafe { b3::b3World_Step(self.world, self.dt, self.sub_steps) }
    }

    fn push(&mut self, body: usize, force: V3, point: V3) {
        // SAFETY: the bodies live as long as the world.
        unsafe { b3::b3Body_ApplyForce(self.all[body], vector(force), vector(point), true) }
    }

    fn motions(&self, out: &mut Vec<Motion>) {
        out.clear();
        out.extend(self.bodies.iter().map(|&id| {
            // SAFETY: the bodies live as long as the world.
            unsafe {
                let q = b3::b3Body_GetRotation(id);
                Motion {
                    position: array(b3::b3Body_GetWorldCenter(id)),
                    rotation: [q.v.x, q.v.y, q.v.z, q.s].map(f64::from),
                    velocity: array(b3::b3Body_GetLinearVelocity(id)),
                    spin: array(b3::b3Body_GetAngularVelocity(id)),
                }
            }
        }));
    }

    fn stages(&self) -> Vec<(&'static str, f32)> {
        // SAFETY: the world lives as long as self.
        let p = unsafe { b3::b3World_GetProfile(self.world) };
        vec![
            ("pairs", p.pairs),
            ("contacts", p.collide),
            ("set-up", p.solverSetup),
            ("constraints", p.constraints),
            ("transforms", p.transforms),
            ("refit", p.refit),
            ("sleep", p.sleepIslands),
        ]
    }
}

impl Drop for Box3d {
    fn drop(&mut self) {
        // SAFETY: the world is destroyed once, and nothing uses it afterwards.
        unsafe { b3::b3DestroyWorld(self.world) }
    }
}
