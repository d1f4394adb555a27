//! What the narrow phase needs to know of a shape: gathered once a step, however many contacts the shape has.

use super::{BodyType, World};
use crate::body::SetId;
use crate::math::{Aabb, Float, Pose, Quat, Vec3, length, rotate};

/// One side of a contact.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(super) struct Side {
    /// The box that the broad phase knows.
    pub fat: Aabb,
    /// In which step this was gathered.
    step: u32,
    pub asleep: bool,
    /// Bound of the way it can go in this step \[m\], relative motion aside.
    pub spin_way: Float,
    /// What gravity adds to the way in this step \[m\].
    pub fall: Float,
    /// The bound of margins \[m\]: none for what never moves, a floor does not make a marble's margin large.
    pub size: Float,
    /// World from shape rotation, and the shape's origin from the centre of mass, world axes.
    pub q: Quat,
    pub arm: Vec3,
    pub x: Vec3,
    pub v: Vec3,
    pub w: Vec3,
}

/// The sides of a step, by collider.
#[derive(Clone, Debug, Default)]
pub(super) struct Sides {
    sides: Vec<Side>,
    step: u32,
}

impl Sides {
    /// Forgets what it knows.
    pub fn begin_step(&mut self, colliders: usize) {
        if self.sides.len() != colliders || self.step == u32::MAX {
            self.sides.clear();
            self.sides.resize(colliders, Side::UNKNOWN);
            self.step = 0;
        }
        self.step += 1;
    }

    /// Both sides of a pair of colliders.
    #[inline]
    pub fn of(&mut self, world: &World, pair: [u32; 2], dt: Float) -> [&Side; 2] {
        for shape in pair {
            if self.sides[shape as usize].step != self.step {
                self.sides[shape as usize] = Side { step: self.step, ..world.side(shape, dt) };
            }
        }
        pair.map(|shape| &self.sides[shape as usize])
    }

    /// Asks for the memory of a side that will be needed soon.
    #[inline]
    pub fn prefetch(&self, shape: u32) {
        crate::simd::prefetch(&self.sides[shape as usize]);
    }

    /// Bytes held.
    pub fn byte_count(&self) -> usize {
        self.sides.capacity() * size_of::<Side>()
    }
}

impl Side {
    /// Of no step.
    const UNKNOWN: Side = Side {
        fat: Aabb::EMPTY,
        step: 0,
        asleep: false,
        spin_way: 0.0,
        fall: 0.0,
        size: 0.0,
        q: Pose::IDENTITY.q,
        arm: Vec3::new(0.0, 0.0, 0.0),
        x: Vec3::new(0.0, 0.0, 0.0),
        v: Vec3::new(0.0, 0.0, 0.0),
        w: Vec3::new(0.0, 0.0, 0.0),
    };
}

impl World {
    /// One side of a contact as it is now.
    pub(super) fn side(&self, shape: u32, dt: Float) -> Side {
        let collider = &self.colliders[shape as usize];
        let body = &self.bodies.bodies[collider.body as usize];
        let (set, row) = (&self.bodies.sets[body.set.0 as usize], body.row as usize);
        let motion = &set.motion[row];
        let moves = body.set == SetId::AWAKE;
        let (v, w) = if moves {
            (set.velocity(row), set.angular_velocity(row))
        } else {
            (Vec3::zeros(), Vec3::zeros())
        };
        let plain = collider.local == Pose::IDENTITY;
        Side {
            fat: collider.fat,
            q: if plain { motion.q } else { motion.q * collider.local.q },
            arm: rotate(&motion.q, collider.local.p - set.mass[row].center),
            x: motion.x,
            v,
            w,
            spin_way: length(w) * dt * collider.reach,
            fall: if moves {
                length(self.def.gravity) * set.drive[row].gravity_scale.abs() * dt * dt
            } else {
                0.0
            },
            asleep: body.set.is_sleeping(),
            size: if body.body_type == BodyType::Static { Float::MAX } else { collider.inner_radius },
            ..Side::UNKNOWN
        }
    }
}
