//! Rapier, from its published crate: one thread, with the SIMD it comes with.

use super::{Engine, Method, Motion, Setting};
use crate::scene::{Form, Hold, Joint, Kind, Scene};
use crate::vector::{self, Q4, V3};
use rapier3d::prelude::*;

/// It has one way. (Its reduced coordinates start all joints at zero, which few scenes do.)
pub fn methods() -> Vec<Method> {
    vec![Method { solver: "soft_step", integrator: "", iterates: true }]
}

/// A Rapier world of a scene.
pub struct Rapier {
    world: PhysicsWorld,
    /// All bodies, in the scene's order.
    all: Vec<RigidBodyHandle>,
    /// The dynamic ones, and their centres of mass from their origins.
    bodies: Vec<(RigidBodyHandle, V3)>,
    /// Bodies that have a force for the next step: Rapier's forces stay.
    pushed: Vec<RigidBodyHandle>,
}

fn triple(v: V3) -> Vector {
    let [x, y, z] = v.map(|x| x as f32);
    Vector::new(x, y, z)
}

fn rotation(q: Q4) -> Rotation {
    let [x, y, z, w] = q.map(|x| x as f32);
    Rotation::from_xyzw(x, y, z, w)
}

fn array(v: Vector) -> V3 {
    [v.x, v.y, v.z].map(f64::from)
}

impl Rapier {
    pub fn new(scene: &Scene, setting: &Setting) -> Result<Self, String> {
        if setting.accuracy.is_some() {
            return Err("Rapier has no such setting".into());
        }
        let mut world = PhysicsWorld { gravity: triple(scene.gravity), ..PhysicsWorld::default() };
        let p = &mut world.integration_parameters;
        p.dt = setting.dt() as f32;
        p.num_solver_iterations = setting.sub_steps as usize;
        if setting.iterations > 0 {
            p.num_internal_pgs_iterations = setting.iterations as usize;
        }
        // As for the others: no continuous collision, no clamp of speeds.
        p.max_ccd_substeps = 0;
        p.normalized_max_linear_velocity = Real::MAX;
        let mut this = Self { world, all: Vec::new(), bodies: Vec::new(), pushed: Vec::new() };
        for body in &scene.bodies {
            this.add(scene, body)?;
        }
        for joint in &scene.joints {
            this.tie(joint)?;
        }
        Ok(this)
    }

    fn add(&mut self, scene: &Scene, body: &crate::scene::Body) -> Result<(), String> {
        let kind = match body.kind {
            Kind::Static => RigidBodyType::Fixed,
            Kind::Kinematic => RigidBodyType::KinematicVelocityBased,
            Kind::Dynamic => RigidBodyType::Dynamic,
        };
        let mut builder = RigidBodyBuilder::new(kind)
            .pose(Pose::from_parts(triple(body.position), rotation(body.rotation)))
            .linvel(triple(body.velocity))
            .angvel(triple(body.spin))
            .can_sleep(scene.sleep)
            .allow_fast_rotation(true)
            .gyroscopic_forces_enabled(true);
        if let Some(mass) = body.mass {
            builder = builder.additional_mass_properties(MassProperties::new(
                triple(mass.center),
                mass.mass as f32,
                triple(mass.inertia),
            ));
        }
        let handle = self.world.bodies.insert(builder);
        let cuboid = |half: V3| {
            let [x, y, z] = half.map(|x| x as f32);
            ColliderBuilder::cuboid(x, y, z)
        };
        let colliders = match body.form {
            Form::Box(half) => vec![cuboid(half)],
            Form::Sphere(radius) => vec![ColliderBuilder::ball(radius as f32)],
            Form::Capsule(half, radius) => vec![ColliderBuilder::capsule_y(half as f32, radius as f32)],
            Form::Hull(k) => {
                let points: Vec<Vector> = scene.clouds[k].iter().copied().map(triple).collect();
                vec![ColliderBuilder::convex_hull(&points).ok_or("Rapier makes no hull of these points")?]
            }
            Form::Boxes(k) => scene.compounds[k]
                .iter()
                .map(|part| {
                    cuboid(part.half)
                        .position(Pose::from_parts(triple(part.position), rotation(part.rotation)))
                })
                .collect(),
        };
        for collider in colliders {
            // A pair is to have √(ab): the product of the roots.
            let mut collider = collider
                .friction((body.friction.sqrt()) as f32)
                .friction_combine_rule(CoefficientCombineRule::Multiply)
                .restitution(body.restitution as f32)
                .restitution_combine_rule(CoefficientCombineRule::Max)
                .density(if body.mass.is_some() { 0.0 } else { body.density as f32 });
            if !body.collides {
                collider = collider.collision_groups(InteractionGroups::none());
            }
            self.world.colliders.insert_with_parent(collider, handle, &mut self.world.bodies);
        }
        self.all.push(handle);
        if body.kind == Kind::Dynamic {
            self.bodies.push((handle, body.center()));
        }
        Ok(())
    }

    /// Makes a joint.
    fn tie(&mut self, joint: &Joint) -> Result<(), String> {
        // Rapier's hinges turn about x, the scene's about z.
        let x_to_z = vector::turn([0.0, 1.0, 0.0], -std::f64::consts::FRAC_PI_2);
        let (mask, inner) = match joint.hold {
            Hold::Ball => (JointAxesMask::LOCKED_SPHERICAL_AXES, vector::STILL),
            Hold::Hinge => (JointAxesMask::LOCKED_REVOLUTE_AXES, x_to_z),
            Hold::Slider(_) => (JointAxesMask::LOCKED_PRISMATIC_AXES, vector::STILL),
            Hold::Weld => (JointAxesMask::LOCKED_FIXED_AXES, vector::STILL),
            Hold::Rod(_) => return Err("Rapier has no rod".into()),
            Hold::Spring(..) => (JointAxesMask::empty(), vector::STILL),
        };
        let frame = |k: usize| {
            Pose::from_parts(triple(joint.local[k]), rotation(vector::times(joint.axes[k], inner)))
        };
        let mut builder = GenericJointBuilder::new(mask)
            .local_frame1(frame(0))
            .local_frame2(frame(1))
            .contacts_enabled(false);
        if let Hold::Spring(length, s) = joint.hold {
            builder = builder
                .coupled_axes(JointAxesMask::LIN_AXES)
                .motor_position(JointAxis::LinX, length as f32, s.stiffness() as f32, s.damping() as f32)
                .motor_model(JointAxis::LinX, MotorModel::ForceBased);
        }
        if let Hold::Slider(Some(s)) = joint.hold {
            builder = builder
                .motor_position(JointAxis::LinX, 0.0, s.stiffness() as f32, s.damping() as f32)
                .motor_model(JointAxis::LinX, MotorModel::ForceBased);
        }
        let (a, b) = (self.all[joint.bodies[0]], self.all[joint.bodies[1]]);
        self.world.impulse_joints.insert(a, b, builder.build(), true);
        Ok(())
    }
}

impl Engine for Rapier {
    fn step(&mut self) {
        self.world.step();
        for handle in self.pushed.drain(..) {
            self.world.bodies[handle].reset_forces(false);
            self.world.bodies[handle].reset_torques(false);
        }
    }

    fn push(&mut self, body: usize, force: V3, point: V3) {
        let handle = self.all[body];
        self.world.bodies[handle].add_force_at_point(triple(force), triple(point), true);
        self.pushed.push(handle);
    }

    fn motions(&self, out: &mut Vec<Motion>) {
        out.clear();
        out.extend(self.bodies.iter().map(|(handle, center)| {
            let body = &self.world.bodies[*handle];
            let q = *body.rotation();
            let turn = [q.x, q.y, q.z, q.w].map(f64::from);
            let origin = array(body.translation());
            let position =
                if *center == [0.0; 3] { origin } else { vector::add(origin, vector::rotate(turn, *center)) };
            Motion { position, rotation: turn, velocity: array(body.linvel()), spin: array(body.angvel()) }
        }));
    }
}
