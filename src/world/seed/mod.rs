//! The seed's interface: the few calls that a first program needs, in the words of the document this engine grew
//! from. Bodies have one shape each; units are those of the rest of the engine (m, kg, s, rad).
//!
//! Every call that can fail has a twin named `try_…` that returns the error; the plain call panics with the
//! error's sentence. Both kinds of calls can be mixed with the rest of [`World`]: a [`RigidBodyId`] converts into
//! the [`BodyId`] it is.

mod build;
mod config;
mod view;

pub use build::{RigidbodyBuilder, StaticbodyBuilder};
pub(super) use config::Settings;
pub use config::{WorldBuilder, WorldConfig, WorldPlan};
pub use view::{
    ObjID, RigidBodyId, RigidBodyRef, RigidbodyIter, StaticBodyId, StaticbodyIter, StaticbodyRef,
};

use super::World;
use crate::body::NONE;
use crate::constraint::contact::flags;
use crate::error::{Result, expect};
use crate::math::{Aabb, Float, Vec3};
use crate::shape::Shape;

impl World {
    /// A world from a configuration; [`WorldBuilder`] is the more comfortable way. Things at rest do not fall
    /// asleep in it, and every approach bounces, however slow.
    ///
    /// # Panics
    /// Where [`World::try_new`] fails.
    #[must_use]
    #[track_caller]
    pub fn new(config: WorldConfig) -> Self {
        expect(World::try_new(config))
    }

    /// The body with this id, to be read; `None` where it was destroyed or is of another world.
    #[must_use]
    pub fn get<'w, ID: ObjID<'w>>(&'w self, id: ID) -> Option<ID::Ref> {
        id.look_up(self).ok()
    }

    /// The body with this id, to be read.
    ///
    /// # Errors
    /// Stale or Foreign: it was destroyed, or is of another world.
    pub fn try_get<'w, ID: ObjID<'w>>(&'w self, id: ID) -> Result<ID::Ref> {
        id.look_up(self)
    }

    /// Begins a body that never moves. Nothing is created before [`StaticbodyBuilder::finish`].
    pub fn add_staticbody(&mut self, shape: Shape) -> StaticbodyBuilder<'_> {
        StaticbodyBuilder::new(self, shape)
    }

    /// All static bodies that have a shape, in order of their slots.
    #[must_use]
    pub fn staticbodies(&self) -> StaticbodyIter<'_> {
        StaticbodyIter::new(self)
    }

    /// Begins a body that moves by forces and contacts. Nothing is created before [`RigidbodyBuilder::finish`].
    pub fn add_rigidbody(&mut self, shape: Shape) -> RigidbodyBuilder<'_> {
        RigidbodyBuilder::new(self, shape)
    }

    /// All dynamic bodies that have a shape, in order of their slots.
    #[must_use]
    pub fn rigidbodies(&self) -> RigidbodyIter<'_> {
        RigidbodyIter::new(self)
    }

    /// The points of contact through which bodies pushed each other in the last update, in order of contacts. Each
    /// is three vectors in world axes:
    ///
    /// 1. where the bodies A and B touched \[m\],
    /// 2. the unit normal there, from A to B,
    /// 3. the impulse that B got from A during the update, friction included \[N s\]; A got its opposite.
    ///
    /// Of two shapes, the one with the lower slot (in a young world: the older one) is A's. A point that is merely near, or that parts, carries
    /// no impulse and is not listed. Friction acts on a contact as a whole: its points share it as they share the
    /// pressure, so that the sum of the impulses on a body is all that contacts did to its momentum.
    pub fn contacts(&self) -> impl Iterator<Item = (Vec3, Vec3, Vec3)> + '_ {
        let contacts = self.live_contacts().map(|index| &self.contacts.contacts[index]);
        contacts.filter(|c| c.is(flags::CONSTRAINT) && c.awake_place != NONE).flat_map(|c| {
            let (set, row) = self.bodies.at(c.body[0] as usize);
            let center = set.motion[row].x;
            let pressure: Float = c.points().iter().map(|p| p.total).sum();
            c.points().iter().filter(|p| p.total > 0.0).map(move |p| {
                let impulse = c.normal * p.total + c.total_friction * (p.total / pressure);
                (center + p.anchor, c.normal, impulse)
            })
        })
    }

    /// Moves the world by `delta` seconds, in as many sub-steps as [`WorldBuilder::solver_steps`] said. With 0,
    /// contacts are found and nothing moves.
    ///
    /// # Panics
    /// Where [`World::try_update`] fails.
    #[track_caller]
    pub fn update(&mut self, delta: Float) {
        expect(self.try_update(delta));
    }

    /// Moves the world by `delta` seconds (see [`World::update`]).
    ///
    /// # Errors
    /// NotFinite or Range: `delta` is not a finite number ≥ 0.
    pub fn try_update(&mut self, delta: Float) -> Result<()> {
        self.try_step(delta, self.seed.solver_steps)
    }

    /// The boxes by which the engine judges who may touch whom, a little larger than the shapes they hold, each
    /// with the slot of its shape (from 0; a body's first shape in the order of creation). Disabled bodies have
    /// none.
    pub fn aabbs(&self) -> impl Iterator<Item = (&Aabb, usize)> {
        let pool = &self.identity.shapes;
        let live = (0..pool.slots()).filter(|&i| pool.is_live(i, pool.generation(i)));
        live.map(|i| (&self.colliders[i], i))
            .filter(|(c, _)| self.is_enabled(c.body))
            .map(|(c, i)| (&c.fat, i))
    }

    fn is_enabled(&self, body: u32) -> bool {
        self.bodies.bodies[body as usize].set != crate::body::SetId::DISABLED
    }
}
