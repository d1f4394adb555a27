//! The world: all bodies, shapes and contacts, and what a user does with them.

mod accuracy;
mod collide;
mod collider;
mod def;
mod id;
mod islands;
mod joint;
mod publish;
mod query;
mod ragdoll;
mod report;
mod seed;
mod side;
mod step;
mod validate;
mod view;

pub use collider::Collider;
pub use def::{BodyDef, BodyType, Filter, MotionLocks, QueryFilter, ShapeDef, SurfaceMaterial, WorldDef};
pub use id::{BodyId, ContactId, IdPool, Identity, JointId, ShapeId};
pub use joint::JointDef;
pub use query::ShapeHit;
pub use ragdoll::{Human, HumanDef};
pub use report::{Counters, Profile, StepReport};
pub use seed::{
    ObjID, RigidBodyId, RigidBodyRef, RigidbodyBuilder, RigidbodyIter, StaticBodyId, StaticbodyBuilder,
    StaticbodyIter, StaticbodyRef, WorldBuilder, WorldConfig, WorldPlan,
};
pub use view::{BodyMut, BodyRef, ColliderMut, ColliderRef, ContactData, JointMut, JointRef};

use crate::body::{BodyStore, MassProps, SetId};
use crate::broad_phase::{BroadPhase, Layer, PairSet};
use crate::constraint::{ContactStore, JointStore, contact::flags};
use crate::error::{Error, ErrorCode, Result, check};
use crate::event::{BodyMoveEvent, ContactBeginEvent, ContactEndEvent, ContactHitEvent, Events};
use crate::island::{IslandStore, color::Coloring, pacing::Pacing};
use crate::math::{Float, Pose, Vec3};
use crate::shape::{MassData, Shape};
use crate::solver::Work;
use std::sync::Arc;

/// Decides whether two shapes may collide, asked when their boxes meet: (world, A, B).
pub type CustomFilter = dyn Fn(&World, ShapeId, ShapeId) -> bool + Send + Sync;
/// Decides whether a contact acts in this step: (world, A, B, point, normal from A to B).
pub type PreSolve = dyn Fn(&World, ShapeId, ShapeId, Vec3, Vec3) -> bool + Send + Sync;
/// Mixes a coefficient of two materials: (world, value A, material id A, value B, material id B).
pub type Mixing = dyn Fn(&World, Float, u64, Float, u64) -> Float + Send + Sync;

/// What the user wants to be asked.
#[derive(Clone, Default)]
pub(crate) struct Callbacks {
    pub custom_filter: Option<Arc<CustomFilter>>,
    pub pre_solve: Option<Arc<PreSolve>>,
    pub friction: Option<Arc<Mixing>>,
    pub restitution: Option<Arc<Mixing>>,
}

impl Callbacks {
    /// Whether one of them is called, with the world, while contacts are brought up to date.
    fn see_contacts(&self) -> bool {
        self.pre_solve.is_some() || self.friction.is_some() || self.restitution.is_some()
    }
}

impl std::fmt::Debug for Callbacks {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Callbacks")
            .field("custom_filter", &self.custom_filter.is_some())
            .field("pre_solve", &self.pre_solve.is_some())
            .field("friction", &self.friction.is_some())
            .field("restitution", &self.restitution.is_some())
            .finish()
    }
}

/// A world of rigid bodies.
#[derive(Clone, Debug)]
pub struct World {
    pub(crate) def: WorldDef,
    pub(crate) identity: Identity,
    pub(crate) bodies: BodyStore,
    pub(crate) colliders: Vec<Collider>,
    pub(crate) broad_phase: Box<dyn BroadPhase>,
    pub(crate) pairs: PairSet,
    pub(crate) contacts: ContactStore,
    pub(crate) joints: JointStore,
    pub(crate) islands: IslandStore,
    pub(crate) coloring: Coloring,
    pub(crate) events: Events,
    pub(crate) callbacks: Callbacks,
    pub(crate) work: Work,
    pub(crate) rehearsal: accuracy::Rehearsal,
    pub(crate) scratch: collide::Scratch,
    /// Colliders whose fat box is new since the last `find_pairs`.
    pub(crate) moved: Vec<u32>,
    /// Length of a sub-step of the last step \[s\].
    pub(crate) last_h: Float,
    pub(crate) last_sub_steps: u32,
    pub(crate) profile: Profile,
    pub(crate) counts: report::Counts,
    /// What [`World::update`] and the builders of bodies go by.
    pub(crate) seed: seed::Settings,
}

/// The whole state of a world at one time. Restoring it gives the same future, bit for bit.
#[derive(Clone, Debug)]
pub struct Snapshot(Box<World>);

impl World {
    /// A world from a [`&WorldDef`](WorldDef) or a [`WorldConfig`].
    ///
    /// # Errors
    /// What [`WorldDef::validate`] or [`WorldConfig::validate`] says.
    pub fn try_new(plan: impl WorldPlan) -> Result<World> {
        plan.carry_out()
    }

    /// A world whose ids are told from those of other worlds by `identity`.
    ///
    /// # Errors
    /// What [`WorldDef::validate`] says.
    pub fn try_with_identity(def: &WorldDef, identity: Identity) -> Result<World> {
        def.validate()?;
        Ok(World {
            broad_phase: def.broad_phase.build(),
            def: def.clone(),
            identity,
            bodies: BodyStore::default(),
            colliders: Vec::new(),
            pairs: PairSet::new(),
            contacts: ContactStore::default(),
            joints: JointStore::default(),
            islands: IslandStore::default(),
            coloring: Coloring::default(),
            events: Events::default(),
            callbacks: Callbacks::default(),
            work: Work::default(),
            rehearsal: accuracy::Rehearsal::default(),
            scratch: collide::Scratch::default(),
            moved: Vec::new(),
            last_h: 0.0,
            last_sub_steps: 0,
            profile: Profile::default(),
            counts: report::Counts::default(),
            seed: seed::Settings::default(),
        })
    }

    /// Ends the world and gives back what the next one in its place needs so that old ids stay stale.
    #[must_use]
    pub fn into_identity(self) -> Identity {
        self.identity.successor()
    }

    /// Saves the whole state.
    #[must_use]
    pub fn save(&self) -> Snapshot {
        Snapshot(Box::new(self.clone()))
    }

    /// Goes back to a saved state of this world. Ids of what was destroyed since are valid again; ids given out
    /// since are stale, for good.
    ///
    /// # Errors
    /// Foreign: the snapshot is of a world with another identity.
    pub fn restore(&mut self, snapshot: &Snapshot) -> Result<()> {
        if snapshot.0.identity.tag != self.identity.tag {
            return Err(Error::new(ErrorCode::Foreign, "The snapshot is of another world."));
        }
        let mut identity = self.identity.clone();
        identity.restore(&snapshot.0.identity);
        let work = std::mem::take(&mut self.work);
        *self = (*snapshot.0).clone();
        self.identity = identity;
        self.work = work;
        Ok(())
    }

    // ---- definition -----------------------------------------------------------------------------------------

    /// What the world was made from, with the changes since.
    #[must_use]
    pub fn def(&self) -> &WorldDef {
        &self.def
    }

    /// \[m/s²\]
    #[must_use]
    pub fn gravity(&self) -> Vec3 {
        self.def.gravity
    }

    /// Sets gravity \[m/s²\] and wakes everything.
    ///
    /// # Errors
    /// NotFinite.
    pub fn set_gravity(&mut self, gravity: Vec3) -> Result<()> {
        self.def.gravity = check::finite_vec("gravity", gravity)?;
        self.wake_all();
        Ok(())
    }

    /// Sets the approach speed up to which nothing bounces \[m/s\].
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn set_restitution_threshold(&mut self, speed: Float) -> Result<()> {
        self.def.restitution_threshold = check::not_negative("restitution_threshold", speed)?;
        Ok(())
    }

    /// Sets the approach speed above which hit events are made \[m/s\].
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn set_hit_event_threshold(&mut self, speed: Float) -> Result<()> {
        self.def.hit_event_threshold = check::not_negative("hit_event_threshold", speed)?;
        Ok(())
    }

    /// Sets the greatest speed of bodies \[m/s\]; ∞ for none.
    ///
    /// # Errors
    /// Range.
    pub fn set_maximum_linear_speed(&mut self, speed: Float) -> Result<()> {
        self.def.maximum_linear_speed = def::speed_limit(speed)?;
        Ok(())
    }

    /// Sets how overlap is recovered, see [`WorldDef`]: stiffness as a share of the sub-step rate, damping ratio,
    /// greatest speed \[m/s\].
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn set_contact_tuning(&mut self, stiffness: Float, damping_ratio: Float, speed: Float) -> Result<()> {
        let mut def = self.def.clone();
        (def.contact_stiffness, def.contact_damping_ratio, def.contact_speed) =
            (stiffness, damping_ratio, speed);
        def.validate()?;
        self.def = def;
        Ok(())
    }

    /// Sets the accuracy to keep, see [`WorldDef::accuracy`].
    ///
    /// # Errors
    /// NotFinite, Range; Unsupported with another solver than soft_step.
    pub fn set_accuracy(&mut self, accuracy: Float) -> Result<()> {
        let def = WorldDef { accuracy, ..self.def.clone() };
        def.validate()?;
        self.def = def;
        if accuracy == 0.0 {
            self.islands.islands.iter_mut().for_each(|island| island.pacing = Pacing::default());
        }
        Ok(())
    }

    /// Lets bodies fall asleep, or wakes all and keeps them awake.
    pub fn enable_sleeping(&mut self, on: bool) {
        self.def.enable_sleep = on;
        if !on {
            self.wake_all();
        }
    }

    /// Keeps impulses from step to step, or not.
    pub fn enable_warm_starting(&mut self, on: bool) {
        self.def.enable_warm_starting = on;
    }

    /// Sets the user data.
    pub fn set_user_data(&mut self, data: u64) {
        self.def.user_data = data;
    }

    /// Who decides whether shapes with custom filtering collide; `None` for everyone does.
    pub fn set_custom_filter(&mut self, filter: Option<Arc<CustomFilter>>) {
        self.callbacks.custom_filter = filter;
    }

    /// Who is asked about contacts of shapes with pre-solve events.
    pub fn set_pre_solve(&mut self, pre_solve: Option<Arc<PreSolve>>) {
        self.callbacks.pre_solve = pre_solve;
    }

    /// How friction is mixed; `None` for √(ab).
    pub fn set_friction_mixing(&mut self, mixing: Option<Arc<Mixing>>) {
        self.callbacks.friction = mixing;
    }

    /// How restitution is mixed; `None` for the greater one.
    pub fn set_restitution_mixing(&mut self, mixing: Option<Arc<Mixing>>) {
        self.callbacks.restitution = mixing;
    }

    // ---- bodies ---------------------------------------------------------------------------------------------

    /// Adds a body. It has no mass before it has a shape with a density, or mass data of its own.
    ///
    /// # Errors
    /// What [`BodyDef::validate`] says.
    pub fn create_body(&mut self, def: &BodyDef) -> Result<BodyId> {
        def.validate()?;
        let rotation = check::rotation("rotation", def.rotation)?;
        let (index, generation) = self.identity.bodies.allocate();
        self.bodies.add(index, def, rotation);
        if def.is_enabled && def.body_type == BodyType::Dynamic {
            let island = self.islands.open(index as u32, &mut self.bodies.bodies);
            if !def.is_awake {
                self.put_to_sleep(island);
            }
        }
        Ok(BodyId { index1: index as u32 + 1, world: self.identity.tag, generation: generation as u16 })
    }

    /// Removes a body with its shapes and contacts; what it touched wakes up.
    ///
    /// # Errors
    /// Null, foreign or stale id.
    pub fn destroy_body(&mut self, id: BodyId) -> Result<()> {
        let index = self.body_index(id)?;
        self.wake_touching(index);
        self.remove_joints_of(index);
        for k in (0..self.bodies.bodies[index].shapes.len()).rev() {
            let shape = self.bodies.bodies[index].shapes[k] as usize;
            self.remove_collider(shape);
        }
        self.bodies.bodies[index].shapes.clear();
        self.islands.leave(index as u32, &mut self.bodies.bodies);
        self.bodies.remove(index);
        self.identity.bodies.release(index);
        Ok(())
    }

    /// Looks a body up.
    ///
    /// # Errors
    /// Null, foreign or stale id.
    pub fn body(&self, id: BodyId) -> Result<BodyRef<'_>> {
        Ok(BodyRef { world: self, index: self.body_index(id)? })
    }

    /// Looks a body up to change it.
    ///
    /// # Errors
    /// Null, foreign or stale id.
    pub fn body_mut(&mut self, id: BodyId) -> Result<BodyMut<'_>> {
        let index = self.body_index(id)?;
        Ok(BodyMut { world: self, index })
    }

    /// The ids of all bodies, in order of their slots.
    pub fn bodies(&self) -> impl Iterator<Item = BodyId> + '_ {
        let pool = &self.identity.bodies;
        (0..pool.slots()).filter(|&i| pool.is_live(i, pool.generation(i))).map(|i| self.body_id(i))
    }

    /// How many bodies there are.
    #[must_use]
    pub fn body_count(&self) -> usize {
        self.identity.bodies.live()
    }

    /// The ids of the awake bodies (dynamic and kinematic), in no particular order.
    pub fn awake_bodies(&self) -> impl ExactSizeIterator<Item = BodyId> + '_ {
        self.bodies.awake().index.iter().map(|&i| self.body_id(i as usize))
    }

    pub(crate) fn body_index(&self, id: BodyId) -> Result<usize> {
        id.look_up(self.identity.tag, &self.identity.bodies)
    }

    pub(crate) fn body_id(&self, index: usize) -> BodyId {
        BodyId {
            index1: index as u32 + 1,
            world: self.identity.tag,
            generation: self.identity.bodies.generation(index) as u16,
        }
    }

    // ---- shapes ---------------------------------------------------------------------------------------------

    /// Attaches a shape to a body, placed by `local` (body from shape).
    ///
    /// # Errors
    /// Null, foreign or stale id; what [`ShapeDef::validate`] says; a half-space on a body that moves.
    pub fn create_shape(
        &mut self,
        body: BodyId,
        def: &ShapeDef,
        shape: Shape,
        local: Pose,
    ) -> Result<ShapeId> {
        let body_index = self.body_index(body)?;
        def.validate()?;
        let local = check::pose("local pose", &local)?;
        self.check_half_space(body_index, &shape)?;
        let (index, generation) = self.identity.shapes.allocate();
        let mut collider = Collider::new(def, shape, local, body_index as u32);
        let body = &mut self.bodies.bodies[body_index];
        body.shapes.push(index as u32);
        let (set, row) = self.bodies.at(body_index);
        collider.fat = self.first_box(&collider, &set.origin(row), body_index);
        if index == self.colliders.len() {
            self.colliders.push(collider);
        } else {
            self.colliders[index] = collider;
        }
        if self.bodies.bodies[body_index].set != SetId::DISABLED {
            self.enter_broad_phase(index);
        }
        if def.update_body_mass {
            self.update_mass(body_index);
        } else {
            self.update_reach(body_index);
        }
        Ok(ShapeId { index1: index as u32 + 1, world: self.identity.tag, generation: generation as u16 })
    }

    /// Removes a shape; what it touched wakes up.
    ///
    /// # Errors
    /// Null, foreign or stale id.
    pub fn destroy_shape(&mut self, id: ShapeId, update_body_mass: bool) -> Result<()> {
        let index = self.shape_index(id)?;
        let body = self.colliders[index].body as usize;
        self.wake_touching(body);
        self.bodies.bodies[body].shapes.retain(|&s| s as usize != index);
        self.remove_collider(index);
        if update_body_mass {
            self.update_mass(body);
        } else {
            self.update_reach(body);
        }
        Ok(())
    }

    /// Looks a shape up.
    ///
    /// # Errors
    /// Null, foreign or stale id.
    pub fn shape(&self, id: ShapeId) -> Result<ColliderRef<'_>> {
        Ok(ColliderRef { world: self, index: self.shape_index(id)? })
    }

    /// Looks a shape up to change it.
    ///
    /// # Errors
    /// Null, foreign or stale id.
    pub fn shape_mut(&mut self, id: ShapeId) -> Result<ColliderMut<'_>> {
        let index = self.shape_index(id)?;
        Ok(ColliderMut { world: self, index })
    }

    /// How many shapes there are.
    #[must_use]
    pub fn shape_count(&self) -> usize {
        self.identity.shapes.live()
    }

    pub(crate) fn shape_index(&self, id: ShapeId) -> Result<usize> {
        id.look_up(self.identity.tag, &self.identity.shapes)
    }

    pub(crate) fn shape_id(&self, index: usize) -> ShapeId {
        ShapeId {
            index1: index as u32 + 1,
            world: self.identity.tag,
            generation: self.identity.shapes.generation(index) as u16,
        }
    }

    pub(crate) fn check_half_space(&self, body: usize, shape: &Shape) -> Result<()> {
        if matches!(shape, Shape::HalfSpace(_)) && self.bodies.bodies[body].body_type != BodyType::Static {
            return Err(Error::new(ErrorCode::Range, "A half-space has no mass; its body must be static."));
        }
        Ok(())
    }

    /// Puts a collider into the broad phase.
    pub(crate) fn enter_broad_phase(&mut self, index: usize) {
        let collider = &self.colliders[index];
        let layer = match self.bodies.bodies[collider.body as usize].body_type {
            BodyType::Static => Layer::Static,
            _ => Layer::Moving,
        };
        self.broad_phase.insert(index as u32, &collider.fat, layer);
        self.moved.push(index as u32);
    }

    /// Takes a collider out of the broad phase, with its contacts.
    pub(crate) fn leave_broad_phase(&mut self, index: usize) {
        self.destroy_contacts_of_shape(index);
        self.broad_phase.remove(index as u32);
        self.moved.retain(|&m| m as usize != index);
    }

    fn remove_collider(&mut self, index: usize) {
        if self.bodies.bodies[self.colliders[index].body as usize].set != SetId::DISABLED {
            self.leave_broad_phase(index);
        }
        self.identity.shapes.release(index);
    }

    /// Destroys the contacts of a shape, e.g. because its filter changed.
    pub(crate) fn destroy_contacts_of_shape(&mut self, index: usize) {
        let body = self.colliders[index].body as usize;
        let mut k = self.bodies.bodies[body].contacts.len();
        while k > 0 {
            k -= 1;
            let c = self.bodies.bodies[body].contacts[k] as usize;
            if self.contacts.contacts[c].shape.contains(&(index as u32)) {
                self.destroy_contact(c, true);
            }
        }
    }

    /// Destroys a contact. With `announce` its end event is kept for the next step's list.
    pub(crate) fn destroy_contact(&mut self, index: usize, announce: bool) {
        let contact = self.contacts.contacts[index];
        if contact.is(flags::TOUCHING) && contact.is(flags::EVENTS) {
            let event = ContactEndEvent {
                shape_a: self.shape_id(contact.shape[0] as usize),
                shape_b: self.shape_id(contact.shape[1] as usize),
                contact: self.contact_id(index),
            };
            if announce { self.events.pending_end.push(event) } else { self.events.end.push(event) }
        }
        self.end_constraint(index);
        self.contacts.remove(index, &mut self.bodies.bodies);
        self.pairs.remove(contact.shape);
        self.identity.contacts.release(index);
    }

    pub(crate) fn contact_id(&self, index: usize) -> ContactId {
        ContactId {
            index1: index as u32 + 1,
            world: self.identity.tag,
            generation: self.identity.contacts.generation(index),
        }
    }

    // ---- mass -----------------------------------------------------------------------------------------------

    /// Recomputes a body's mass from its shapes, unless the user gave it mass data.
    pub(crate) fn update_mass(&mut self, body: usize) {
        if self.bodies.bodies[body].mass_override {
            self.update_reach(body);
            return;
        }
        let dynamic = self.bodies.bodies[body].body_type == BodyType::Dynamic;
        let data = if dynamic {
            self.bodies.bodies[body]
                .shapes
                .iter()
                .fold(MassData::ZERO, |sum, &s| sum.with(&self.colliders[s as usize].mass_data()))
        } else {
            MassData::ZERO
        };
        self.set_mass(body, &data);
    }

    /// Gives a body this mass; its velocities stay, that of the origin included.
    pub(crate) fn set_mass(&mut self, body: usize, data: &MassData) {
        let (set, row) = self.bodies.at_mut(body);
        let (v, w, origin) = (set.velocity(row), set.angular_velocity(row), set.origin(row));
        let old_center = set.motion[row].x;
        set.mass[row] = MassProps::new(data, 0.0);
        let center = origin.point(set.mass[row].center);
        set.motion[row].place(center);
        set.refresh_inertia(row);
        let shifted = v + w.cross(&(set.motion[row].x - old_center));
        set.set_velocity(row, shifted);
        set.set_angular_velocity(row, w);
        self.update_reach(body);
    }

    /// Recomputes how far a body and each of its shapes reach from the centre of mass.
    pub(crate) fn update_reach(&mut self, body: usize) {
        let (set, row) = self.bodies.at(body);
        let center = set.mass[row].center;
        let mut extent: Float = 0.0;
        for k in 0..self.bodies.bodies[body].shapes.len() {
            let collider = &mut self.colliders[self.bodies.bodies[body].shapes[k] as usize];
            collider.reach = collider.shape.outer_radius(collider.local.point_back(center));
            extent = extent.max(collider.reach);
        }
        let (set, row) = self.bodies.at_mut(body);
        set.mass[row].extent = extent;
    }

    // ---- events ---------------------------------------------------------------------------------------------

    /// Bodies that moved in the last step.
    #[must_use]
    pub fn body_events(&self) -> &[BodyMoveEvent] {
        &self.events.moved
    }

    /// Contacts that began in the last step.
    #[must_use]
    pub fn contact_begin_events(&self) -> &[ContactBeginEvent] {
        &self.events.begin
    }

    /// Contacts that ended in the last step, or by destruction before it.
    #[must_use]
    pub fn contact_end_events(&self) -> &[ContactEndEvent] {
        &self.events.end
    }

    /// Hits of the last step.
    #[must_use]
    pub fn contact_hit_events(&self) -> &[ContactHitEvent] {
        &self.events.hit
    }

    /// Whether this contact still exists.
    #[must_use]
    pub fn contains_contact(&self, id: ContactId) -> bool {
        id.look_up(self.identity.tag, &self.identity.contacts).is_ok()
    }
}
