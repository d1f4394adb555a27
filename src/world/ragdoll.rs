//! Humans that fall: capsules for bones, ball joints and hinges between them.
//!
//! A human of 1.8 m stands on the origin of its frame, y up, looking along z, its left side at +x. Each bone is a body
//! whose origin is the joint to the bone it hangs on and whose axes are the human's. In the rest pose no spring is
//! strained and no limit reached.

use super::{BodyDef, BodyId, JointDef, JointId, ShapeDef, SurfaceMaterial, World};
use crate::constraint::joint::{Drive, JointKind, Limit, RevoluteJoint, SphericalJoint, Spring};
use crate::error::{Error, ErrorCode, Result, check};
use crate::math::scalar::PI;
use crate::math::{Float, Pose, Quat, Vec3, length, quat, quat_about, rotate, vec3};
use crate::shape::{Capsule, Shape};

/// What a human is made from.
#[derive(Clone, Debug, PartialEq)]
pub struct HumanDef {
    /// How many bones: 11, the default, or 14, with a spine of two parts and feet.
    pub bones: usize,
    /// Where it stands \[m\]; default the origin.
    pub position: Vec3,
    /// How it stands; default upright: y is up.
    pub rotation: Quat,
    /// \[m\], > 0; default 1.8.
    pub height: Float,
    /// \[kg/m³\], > 0; default 1000.
    pub density: Float,
    /// Of the whole body \[kg\], ≥ 0; 0, the default, is what the density gives.
    pub mass: Float,
    /// Torque of dry friction in each joint \[N m\], ≥ 0; default 1.
    pub friction_torque: Float,
    /// Springs that hold the rest pose \[Hz\], ≥ 0; default 0: none.
    pub spring_hertz: Float,
    /// Their damping ratio, ≥ 0; default 0.7.
    pub spring_damping_ratio: Float,
    /// Collision group of all bones. Negative, as the default −1, bones of one group do not collide: give each human
    /// a group of its own, or they pass through each other. Bones that a joint ties never collide.
    pub group_index: i32,
    /// The surface of all bones.
    pub material: SurfaceMaterial,
    /// Of bodies and joints.
    pub user_data: u64,
}

impl Default for HumanDef {
    fn default() -> Self {
        Self {
            bones: 11,
            position: Vec3::zeros(),
            rotation: Quat::identity(),
            height: 1.8,
            density: 1000.0,
            mass: 0.0,
            friction_torque: 1.0,
            spring_hertz: 0.0,
            spring_damping_ratio: 0.7,
            group_index: -1,
            material: SurfaceMaterial::default(),
            user_data: 0,
        }
    }
}

impl HumanDef {
    /// Checks every field.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn validate(&self) -> Result<()> {
        if self.bones != 11 && self.bones != 14 {
            let n = self.bones;
            return Err(Error::new(ErrorCode::Range, format!("A human has 11 or 14 bones, not {n}.")));
        }
        check::point("position", self.position)?;
        check::rotation("rotation", self.rotation)?;
        check::within("height", self.height, 0.01, 100.0)?;
        check::positive("density", self.density)?;
        check::not_negative("mass", self.mass)?;
        check::not_negative("friction_torque", self.friction_torque)?;
        check::not_negative("spring_hertz", self.spring_hertz)?;
        check::not_negative("spring_damping_ratio", self.spring_damping_ratio)?;
        self.material.validate()
    }
}

/// The bones of a human: the pelvis first, each after the one it hangs on.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Human {
    /// Pelvis, (abdomen,) chest, head, left and right upper arm, left and right forearm, left and right thigh, left
    /// and right shank(, left and right foot).
    pub bodies: Vec<BodyId>,
    /// The joint of each bone but the first to the one it hangs on.
    pub joints: Vec<JointId>,
}

/// How a bone hangs on another.
#[derive(Clone, Copy)]
enum Hold {
    /// Not at all.
    Root,
    /// By a ball joint: along which way the bone points, the middle of its cone, half-angles of the cone for turns
    /// about the side axis and the one across, and how far it twists either way.
    Ball { along: Float, middle: [Float; 3], cone: [Float; 2], twist: Float },
    /// By a hinge about the side axis, with this sign, and its range.
    Hinge { sign: Float, range: [Float; 2] },
}

/// A bone of a human of 1.8 m.
struct Bone {
    /// On which it hangs.
    parent: usize,
    /// The joint between them.
    joint: [Float; 3],
    /// The capsule.
    ends: [[Float; 3]; 2],
    radius: Float,
    hold: Hold,
}

fn bone(parent: usize, joint: [Float; 3], ends: [[Float; 3]; 2], radius: Float, hold: Hold) -> Bone {
    Bone { parent, joint, ends, radius, hold }
}

/// The bones, in the order of [`Human::bodies`].
fn skeleton(count: usize) -> Vec<Bone> {
    let fine = count == 14;
    let spine = |cone, twist| Hold::Ball { along: 1.0, middle: [0.0, 1.0, 0.0], cone, twist };
    let mut all = vec![bone(0, [0.0, 0.98, 0.0], [[-0.07, 0.98, 0.0], [0.07, 0.98, 0.0]], 0.11, Hold::Root)];
    if fine {
        let abdomen = [[-0.05, 1.14, 0.0], [0.05, 1.14, 0.0]];
        all.push(bone(0, [0.0, 1.06, 0.0], abdomen, 0.11, spine([0.35, 0.25], 0.3)));
        let chest = [[0.0, 1.32, 0.0], [0.0, 1.36, 0.0]];
        all.push(bone(1, [0.0, 1.2, 0.0], chest, 0.14, spine([0.35, 0.25], 0.3)));
    } else {
        let trunk = [[0.0, 1.2, 0.0], [0.0, 1.36, 0.0]];
        all.push(bone(0, [0.0, 1.08, 0.0], trunk, 0.14, spine([0.6, 0.45], 0.6)));
    }
    let chest = all.len() - 1;
    let skull = [[0.0, 1.61, 0.0], [0.0, 1.69, 0.0]];
    all.push(bone(chest, [0.0, 1.52, 0.0], skull, 0.105, spine([0.7, 0.5], 0.9)));
    let pair = |all: &mut Vec<Bone>, parents: [usize; 2], make: &dyn Fn(Float) -> Bone| {
        for (parent, side) in parents.into_iter().zip([1.0, -1.0]) {
            all.push(Bone { parent, ..make(side) });
        }
        [all.len() - 2, all.len() - 1]
    };
    let arms = pair(&mut all, [chest; 2], &|s| {
        let hold = Hold::Ball { along: -1.0, middle: [0.6 * s, -0.6, 0.5], cone: [1.5, 1.4], twist: 1.0 };
        bone(0, [0.22 * s, 1.44, 0.0], [[0.22 * s, 1.4, 0.0], [0.22 * s, 1.19, 0.0]], 0.045, hold)
    });
    pair(&mut all, arms, &|s| {
        let hold = Hold::Hinge { sign: -1.0, range: [-0.05, 2.5] };
        bone(0, [0.22 * s, 1.15, 0.0], [[0.22 * s, 1.12, 0.0], [0.22 * s, 0.86, 0.0]], 0.04, hold)
    });
    let thighs = pair(&mut all, [0; 2], &|s| {
        let hold = Hold::Ball { along: -1.0, middle: [0.15 * s, -0.85, 0.5], cone: [1.1, 0.7], twist: 0.5 };
        bone(0, [0.09 * s, 0.93, 0.0], [[0.09 * s, 0.88, 0.0], [0.09 * s, 0.53, 0.0]], 0.07, hold)
    });
    let shanks = pair(&mut all, thighs, &|s| {
        let end = if fine { 0.12 } else { 0.055 };
        let hold = Hold::Hinge { sign: 1.0, range: [-0.05, 2.3] };
        bone(0, [0.09 * s, 0.5, 0.0], [[0.09 * s, 0.46, 0.0], [0.09 * s, end, 0.0]], 0.05, hold)
    });
    if fine {
        pair(&mut all, shanks, &|s| {
            let hold = Hold::Hinge { sign: 1.0, range: [-0.7, 0.5] };
            bone(0, [0.09 * s, 0.08, 0.0], [[0.09 * s, 0.05, -0.04], [0.09 * s, 0.05, 0.14]], 0.045, hold)
        });
    }
    all
}

fn scaled(p: [Float; 3], k: Float) -> Vec3 {
    vec3(p[0], p[1], p[2]) * k
}

/// The shortest turn from one direction to another.
fn between(a: Vec3, b: Vec3) -> Quat {
    quat(1.0 + a.dot(&b), a.cross(&b))
}

impl HumanDef {
    /// The joint of a bone, and the rotations of its frames in the parent and in the bone.
    fn joint(&self, hold: Hold) -> Option<(JointKind, Quat, Quat)> {
        let spring = Spring {
            enable: self.spring_hertz > 0.0,
            hertz: self.spring_hertz,
            damping_ratio: self.spring_damping_ratio,
            ..Spring::default()
        };
        match hold {
            Hold::Root => None,
            Hold::Ball { along, middle, cone, twist } => {
                // z along the bone, x to the side.
                let qb = quat_about(Vec3::x(), -along * PI * 0.5);
                let middle = vec3(middle[0], middle[1], middle[2]);
                let qa = between(vec3(0.0, along, 0.0), middle / length(middle)) * qb;
                let kind = SphericalJoint {
                    enable_cone_limit: true,
                    cone_angle: cone,
                    twist: Limit { enable: true, lower: -twist, upper: twist },
                    spring,
                    target_rotation: qa.conjugate() * qb,
                    friction: self.friction_torque,
                    ..SphericalJoint::default()
                };
                Some((JointKind::Spherical(kind), qa, qb))
            }
            Hold::Hinge { sign, range } => {
                let q = quat_about(Vec3::y(), sign * PI * 0.5);
                let drive = Drive {
                    spring,
                    limit: Limit { enable: true, lower: range[0], upper: range[1] },
                    friction: self.friction_torque,
                    ..Drive::default()
                };
                Some((JointKind::Revolute(RevoluteJoint { drive }), q, q))
            }
        }
    }
}

impl World {
    /// Makes a human.
    ///
    /// # Errors
    /// What [`HumanDef::validate`] says; what bodies, shapes and joints may fail with. Nothing is left behind then.
    pub fn create_human(&mut self, def: &HumanDef) -> Result<Human> {
        def.validate()?;
        let mut human = Human::default();
        match self.grow_human(def, &mut human) {
            Ok(()) => Ok(human),
            Err(e) => {
                self.destroy_human(&human);
                Err(e)
            }
        }
    }

    fn grow_human(&mut self, def: &HumanDef, human: &mut Human) -> Result<()> {
        let (bones, k) = (skeleton(def.bones), def.height / 1.8);
        let rotation = check::rotation("rotation", def.rotation)?;
        let mut volume = 0.0;
        let mut capsules = Vec::with_capacity(bones.len());
        for b in &bones {
            let [p, q] = b.ends.map(|p| scaled(p, k) - scaled(b.joint, k));
            let r = b.radius * k;
            volume += PI * r * r * (length(q - p) + r * (4.0 / 3.0));
            capsules.push(Capsule::new(p, q, r)?);
        }
        let density = if def.mass > 0.0 { def.mass / volume } else { def.density };
        let mut shape =
            ShapeDef { density, material: def.material, user_data: def.user_data, ..ShapeDef::default() };
        shape.filter.group_index = def.group_index;
        for (b, capsule) in bones.iter().zip(capsules) {
            let position = def.position + rotate(&rotation, scaled(b.joint, k));
            let body = BodyDef { rotation, user_data: def.user_data, ..BodyDef::dynamic(position) };
            let id = self.create_body(&body)?;
            human.bodies.push(id);
            self.create_shape(id, &shape, Shape::Capsule(capsule), Pose::IDENTITY)?;
            if let Some((kind, qa, qb)) = def.joint(b.hold) {
                let at = scaled(b.joint, k) - scaled(bones[b.parent].joint, k);
                let mut joint = JointDef::new(kind, human.bodies[b.parent], id)
                    .frames(Pose::new(at, qa), Pose::new(Vec3::zeros(), qb));
                joint.user_data = def.user_data;
                human.joints.push(self.create_joint(&joint)?);
            }
        }
        Ok(())
    }

    /// Removes what is left of a human: bones that were destroyed before are passed over.
    pub fn destroy_human(&mut self, human: &Human) {
        for &body in &human.bodies {
            let _ = self.destroy_body(body);
        }
    }
}

impl Human {
    /// Sets the torque of dry friction in each joint \[N m\], ≥ 0.
    ///
    /// # Errors
    /// NotFinite, Range; Stale: a joint was destroyed.
    pub fn set_friction(&self, world: &mut World, torque: Float) -> Result<()> {
        check::not_negative("friction_torque", torque)?;
        self.change(world, |_, friction| *friction = torque)
    }

    /// Sets the springs that hold the rest pose: \[Hz\], 0 for none, and damping ratio.
    ///
    /// # Errors
    /// NotFinite, Range; Stale: a joint was destroyed.
    pub fn set_spring(&self, world: &mut World, hertz: Float, damping_ratio: Float) -> Result<()> {
        check::not_negative("spring_hertz", hertz)?;
        check::not_negative("spring_damping_ratio", damping_ratio)?;
        self.change(world, |spring, _| {
            (spring.enable, spring.hertz, spring.damping_ratio) = (hertz > 0.0, hertz, damping_ratio);
        })
    }

    fn change(&self, world: &mut World, f: impl Fn(&mut Spring, &mut Float)) -> Result<()> {
        for &id in &self.joints {
            world.joint(id)?;
        }
        for &id in &self.joints {
            let mut joint = world.joint_mut(id)?;
            let mut kind = *joint.as_ref().kind();
            match &mut kind {
                JointKind::Revolute(j) => f(&mut j.drive.spring, &mut j.drive.friction),
                JointKind::Spherical(j) => f(&mut j.spring, &mut j.friction),
                _ => {}
            }
            joint.set_kind(kind)?;
        }
        Ok(())
    }

    /// Gives all bones this velocity \[m/s\], without rotation.
    ///
    /// # Errors
    /// NotFinite, Range; Stale: a bone was destroyed.
    pub fn set_velocity(&self, world: &mut World, velocity: Vec3) -> Result<()> {
        check::point("velocity", velocity)?;
        for &id in &self.bodies {
            world.body(id)?;
        }
        for &id in &self.bodies {
            let mut body = world.body_mut(id)?;
            body.set_angular_velocity(Vec3::zeros())?;
            body.set_linear_velocity(velocity)?;
        }
        Ok(())
    }

    /// Pushes the whole human: the impulse \[N s\] is shared out by mass, so that all bones gain the same velocity.
    ///
    /// # Errors
    /// NotFinite, Range; Stale: a bone was destroyed.
    pub fn apply_impulse(&self, world: &mut World, impulse: Vec3) -> Result<()> {
        check::finite_vec("impulse", impulse)?;
        let mut mass = 0.0;
        for &id in &self.bodies {
            mass += world.body(id)?.mass();
        }
        if mass > 0.0 {
            for &id in &self.bodies {
                let mut body = world.body_mut(id)?;
                let share = body.as_ref().mass() / mass;
                body.apply_linear_impulse_to_center(impulse * share, true)?;
            }
        }
        Ok(())
    }
}
