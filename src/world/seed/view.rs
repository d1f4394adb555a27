//! How bodies are looked at.

use crate::body::BodySet;
use crate::error::{Error, ErrorCode, Result};
use crate::math::{Float, Mat3, Pose, Quat, Vec3};
use crate::shape::Shape;
use crate::world::{BodyId, BodyRef, BodyType, World};

/// A body that moves by forces and contacts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct RigidBodyId(pub(super) BodyId);

/// A body that never moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct StaticBodyId(pub(super) BodyId);

impl From<RigidBodyId> for BodyId {
    fn from(id: RigidBodyId) -> BodyId {
        id.0
    }
}

impl From<StaticBodyId> for BodyId {
    fn from(id: StaticBodyId) -> BodyId {
        id.0
    }
}

/// An id by which [`World::get`] finds something.
pub trait ObjID<'w> {
    /// What it finds.
    type Ref;

    /// Finds it.
    ///
    /// # Errors
    /// Stale or Foreign: it was destroyed, or is of another world.
    fn look_up(self, world: &'w World) -> Result<Self::Ref>;
}

impl<'w> ObjID<'w> for RigidBodyId {
    type Ref = RigidBodyRef<'w>;

    fn look_up(self, world: &'w World) -> Result<RigidBodyRef<'w>> {
        let body = world.body(self.0)?;
        RigidBodyRef::new(body).ok_or_else(|| changed("dynamic"))
    }
}

impl<'w> ObjID<'w> for StaticBodyId {
    type Ref = StaticbodyRef<'w>;

    fn look_up(self, world: &'w World) -> Result<StaticbodyRef<'w>> {
        let body = world.body(self.0)?;
        StaticbodyRef::new(body).ok_or_else(|| changed("static"))
    }
}

fn changed(kind: &str) -> Error {
    Error::new(ErrorCode::Stale, format!("The body is no longer a {kind} one with a shape."))
}

/// The first shape of a body of this type.
fn first_shape(body: BodyRef<'_>, body_type: BodyType) -> Option<&Shape> {
    let first = body.shapes().next().filter(|_| body.body_type() == body_type)?;
    Some(body.world.shape(first).ok()?.shape())
}

/// A body that moves by forces and contacts, as it is now. Bodies are stored in columns; this stands for one row.
#[derive(Clone, Copy, Debug)]
pub struct RigidBodyRef<'w> {
    body: BodyRef<'w>,
    shape: &'w Shape,
    origin: Pose,
    momentum: Vec3,
    angular_momentum: Vec3,
}

impl<'w> RigidBodyRef<'w> {
    /// `None` where the body is not dynamic, or has no shape.
    fn new(body: BodyRef<'w>) -> Option<Self> {
        let shape = first_shape(body, BodyType::Dynamic)?;
        Some(Self {
            body,
            shape,
            origin: body.transform(),
            momentum: body.momentum(),
            angular_momentum: body.angular_momentum(),
        })
    }

    fn row(&self) -> (&'w BodySet, usize) {
        self.body.world.bodies.at(self.body.index)
    }

    /// Its id.
    #[must_use]
    pub fn id(&self) -> RigidBodyId {
        RigidBodyId(self.body.id())
    }

    /// Its shape; the first where it has several.
    #[must_use]
    pub fn shape(&self) -> &Shape {
        self.shape
    }

    /// The inverse of its mass \[1/kg\], which is what the engine computes with.
    #[must_use]
    pub fn inv_mass(&self) -> &Float {
        let (set, row) = self.row();
        &set.mass[row].inv_mass
    }

    /// Its mass \[kg\].
    #[must_use]
    pub fn mass(&self) -> Float {
        self.body.mass()
    }

    /// The inverse of its inertia tensor about the centre of mass, in world axes, as it is turned now
    /// \[1/(kg m²)\]. Solids are solid: a ball has ⅖ m r².
    #[must_use]
    pub fn inverse_inertia(&self) -> &Mat3 {
        let (set, row) = self.row();
        &set.inv_inertia[row]
    }

    /// Where its shape's origin is \[m\]: for balls, boxes and capsules the centre of mass.
    #[must_use]
    pub fn position(&self) -> &Vec3 {
        &self.origin.p
    }

    /// How it is turned, from its own axes to the world's.
    #[must_use]
    pub fn rotation(&self) -> &Quat {
        &self.origin.q
    }

    /// Its momentum \[kg m/s\].
    #[must_use]
    pub fn momentum(&self) -> &Vec3 {
        &self.momentum
    }

    /// Its angular momentum about the centre of mass, in world axes \[kg m²/s\].
    #[must_use]
    pub fn angular_momentum(&self) -> &Vec3 {
        &self.angular_momentum
    }

    /// The velocity \[m/s\] of its point that is at `position` of the world \[m\].
    #[must_use]
    pub fn local_velocity(&self, position: Vec3) -> Vec3 {
        self.body.velocity_at(position)
    }

    /// How much an impulse along the unit vector `direction`, at `position` of the world \[m\], changes the
    /// velocity of that point along it \[1/kg\]: 1/m + u·((I⁻¹ (r × u)) × r). Its inverse is the mass that the body
    /// seems to have there.
    #[must_use]
    #[doc(alias = "impulse_effectivnes")]
    pub fn impulse_effectiveness(&self, position: Vec3, direction: Vec3) -> Float {
        let arm = position - self.body.world_center();
        let turn = self.inverse_inertia() * arm.cross(&direction);
        direction.dot(&(direction * *self.inv_mass() + turn.cross(&arm)))
    }
}

/// A body that never moves. Bodies are stored in columns; this stands for one row.
#[derive(Clone, Copy, Debug)]
pub struct StaticbodyRef<'w> {
    body: BodyRef<'w>,
    shape: &'w Shape,
    origin: Pose,
}

impl<'w> StaticbodyRef<'w> {
    /// `None` where the body is not static, or has no shape.
    fn new(body: BodyRef<'w>) -> Option<Self> {
        let shape = first_shape(body, BodyType::Static)?;
        Some(Self { body, shape, origin: body.transform() })
    }

    /// Its id.
    #[must_use]
    pub fn id(&self) -> StaticBodyId {
        StaticBodyId(self.body.id())
    }

    /// Its shape; the first where it has several.
    #[must_use]
    pub fn shape(&self) -> &Shape {
        self.shape
    }

    /// Where its shape's origin is \[m\].
    #[must_use]
    pub fn position(&self) -> &Vec3 {
        &self.origin.p
    }

    /// How it is turned, from its own axes to the world's.
    #[must_use]
    pub fn rotation(&self) -> &Quat {
        &self.origin.q
    }
}

/// The slots of live bodies, from `next` on.
fn next_body<'w, R>(
    world: &'w World,
    next: &mut usize,
    accept: impl Fn(BodyRef<'w>) -> Option<R>,
) -> Option<R> {
    let pool = &world.identity.bodies;
    while *next < pool.slots() {
        let index = *next;
        *next += 1;
        if pool.is_live(index, pool.generation(index))
            && let Some(found) = accept(BodyRef { world, index })
        {
            return Some(found);
        }
    }
    None
}

/// All dynamic bodies of a world, see [`World::rigidbodies`].
#[derive(Clone, Debug)]
pub struct RigidbodyIter<'w> {
    world: &'w World,
    next: usize,
}

impl<'w> RigidbodyIter<'w> {
    pub(super) fn new(world: &'w World) -> Self {
        Self { world, next: 0 }
    }
}

impl<'w> Iterator for RigidbodyIter<'w> {
    type Item = RigidBodyRef<'w>;

    fn next(&mut self) -> Option<RigidBodyRef<'w>> {
        next_body(self.world, &mut self.next, RigidBodyRef::new)
    }
}

/// All static bodies of a world, see [`World::staticbodies`].
#[derive(Clone, Debug)]
pub struct StaticbodyIter<'w> {
    world: &'w World,
    next: usize,
}

impl<'w> StaticbodyIter<'w> {
    pub(super) fn new(world: &'w World) -> Self {
        Self { world, next: 0 }
    }
}

impl<'w> Iterator for StaticbodyIter<'w> {
    type Item = StaticbodyRef<'w>;

    fn next(&mut self) -> Option<StaticbodyRef<'w>> {
        next_body(self.world, &mut self.next, StaticbodyRef::new)
    }
}
