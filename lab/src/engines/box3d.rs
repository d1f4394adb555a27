//! Box3D, through the declarations of boxddd-sys.

use super::{Engine, Motion};
use crate::scene::{Form, Kind, Scene};
use boxddd_sys::ffi as b3;

/// A Box3D world of a scene.
pub struct Box3d {
    world: b3::b3WorldId,
    /// The dynamic bodies.
    bodies: Vec<b3::b3BodyId>,
    dt: f32,
    sub_steps: i32,
}

fn vector([x, y, z]: [f32; 3]) -> b3::b3Vec3 {
    b3::b3Vec3 { x, y, z }
}

fn array(v: b3::b3Vec3) -> [f32; 3] {
    [v.x, v.y, v.z]
}

impl Box3d {
    pub fn new(scene: &Scene) -> Self {
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
                def.restitutionThreshold = speed;
            }
            let world = b3::b3CreateWorld(&raw const def);
            let hulls: Vec<*mut b3::b3HullData> = scene
                .clouds
                .iter()
                .map(|cloud| {
                    let points: Vec<b3::b3Vec3> = cloud.iter().copied().map(vector).collect();
                    let count = points.len() as i32;
                    let hull = b3::b3CreateHull(points.as_ptr(), count, count);
                    assert!(!hull.is_null(), "Box3D makes no hull of these points");
                    hull
                })
                .collect();
            let (mut bodies, mut all) = (Vec::new(), Vec::new());
            for body in &scene.bodies {
                let mut def = b3::b3DefaultBodyDef();
                def.type_ = match body.kind {
                    Kind::Static => b3::b3BodyType_b3_staticBody,
                    Kind::Dynamic => b3::b3BodyType_b3_dynamicBody,
                };
                def.position = vector(body.position);
                let [x, y, z, w] = body.rotation;
                def.rotation = b3::b3Quat { v: vector([x, y, z]), s: w };
                def.linearVelocity = vector(body.velocity);
                let id = b3::b3CreateBody(world, &raw const def);
                let mut surface = b3::b3DefaultShapeDef();
                surface.density = body.density;
                surface.baseMaterial.friction = body.friction;
                surface.baseMaterial.restitution = body.restitution;
                surface.enableContactEvents = false;
                if !body.collides {
                    surface.filter.maskBits = 0;
                }
                match body.form {
                    Form::Box([x, y, z]) => {
                        let hull = b3::b3MakeBoxHull(x, y, z);
                        b3::b3CreateHullShape(id, &raw const surface, &raw const hull.base);
                    }
                    Form::Sphere(radius) => {
                        let sphere = b3::b3Sphere { center: vector([0.0; 3]), radius };
                        b3::b3CreateSphereShape(id, &raw const surface, &raw const sphere);
                    }
                    Form::Hull(k) => {
                        b3::b3CreateHullShape(id, &raw const surface, hulls[k]);
                    }
                }
                if let Some(mass) = body.mass {
                    let [x, y, z] = mass.inertia;
                    let inertia = b3::b3Matrix3 {
                        cx: vector([x, 0.0, 0.0]),
                        cy: vector([0.0, y, 0.0]),
                        cz: vector([0.0, 0.0, z]),
                    };
                    let data = b3::b3MassData { mass: mass.mass, center: vector([0.0; 3]), inertia };
                    b3::b3Body_SetMassData(id, data);
                }
                all.push(id);
                if body.kind == Kind::Dynamic {
                    bodies.push(id);
                }
            }
            for ball in &scene.balls {
                let mut def = b3::b3DefaultSphericalJointDef();
                def.base.bodyIdA = all[ball.bodies[0]];
                def.base.bodyIdB = all[ball.bodies[1]];
                def.base.localFrameA.p = vector(ball.local[0]);
                def.base.localFrameB.p = vector(ball.local[1]);
                b3::b3CreateSphericalJoint(world, &raw const def);
            }
            for hull in hulls {
                b3::b3DestroyHull(hull);
            }
            Self { world, bodies, dt: scene.dt, sub_steps: scene.sub_steps as i32 }
        }
    }
}

impl Engine for Box3d {
    fn step(&mut self) {
        // SAFETY: the world lives as long as self.
        unsafe { b3::b3World_Step(self.world, self.dt, self.sub_steps) }
    }

    fn motions(&self, out: &mut Vec<Motion>) {
        out.clear();
        out.extend(self.bodies.iter().map(|&id| {
            // SAFETY: the bodies live as long as the world.
            unsafe {
                let there = b3::b3Body_GetTransform(id);
                let q = there.q;
                Motion {
                    position: array(there.p),
                    rotation: [q.v.x, q.v.y, q.v.z, q.s],
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
