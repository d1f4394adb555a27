//! An attached shape, to be read and to be changed.

use super::{BodyMut, BodyRef, ColliderMut, ColliderRef, ContactData};
use crate::body::SetId;
use crate::constraint::contact::flags;
use crate::error::{Result, check};
use crate::math::{Aabb, Float, Pose, Vec3};
use crate::shape::{MassData, Shape};
use crate::world::{BodyId, Collider, Filter, ShapeId, SurfaceMaterial};

impl<'w> ColliderRef<'w> {
    fn collider(&self) -> &'w Collider {
        &self.world.colliders[self.index]
    }

    /// Its id.
    #[must_use]
    pub fn id(&self) -> ShapeId {
        self.world.shape_id(self.index)
    }
    /// The body it is attached to.
    #[must_use]
    pub fn body(&self) -> BodyId {
        self.world.body_id(self.collider().body as usize)
    }
    /// Geometry in its own frame.
    #[must_use]
    pub fn shape(&self) -> &'w Shape {
        &self.collider().shape
    }
    /// Body from shape.
    #[must_use]
    pub fn local_pose(&self) -> Pose {
        self.collider().local
    }
    /// World from shape.
    #[must_use]
    pub fn world_pose(&self) -> Pose {
        let (set, row) = self.world.bodies.at(self.collider().body as usize);
        set.origin(row).then(&self.collider().local)
    }
    /// Surface.
    #[must_use]
    pub fn material(&self) -> SurfaceMaterial {
        self.collider().material
    }
    /// \[kg/m³\]
    #[must_use]
    pub fn density(&self) -> Float {
        self.collider().density
    }
    /// What it collides with.
    #[must_use]
    pub fn filter(&self) -> Filter {
        self.collider().filter
    }
    /// Its name.
    #[must_use]
    pub fn name(&self) -> &'w str {
        &self.collider().name
    }
    /// Its user data.
    #[must_use]
    pub fn user_data(&self) -> u64 {
        self.collider().user_data
    }
    /// Whether begin and end events are made.
    #[must_use]
    pub fn are_contact_events_enabled(&self) -> bool {
        self.collider().contact_events
    }
    /// Whether hit events are made.
    #[must_use]
    pub fn are_hit_events_enabled(&self) -> bool {
        self.collider().hit_events
    }
    /// Whether the pre-solve callback is asked.
    #[must_use]
    pub fn are_pre_solve_events_enabled(&self) -> bool {
        self.collider().pre_solve_events
    }
    /// Mass, centre and inertia in the body's frame, by density.
    #[must_use]
    pub fn mass_data(&self) -> MassData {
        self.collider().mass_data()
    }
    /// The tight box in the world.
    #[must_use]
    pub fn aabb(&self) -> Aabb {
        let (set, row) = self.world.bodies.at(self.collider().body as usize);
        self.collider().aabb(&set.origin(row))
    }
    /// The closest point of the shape to `target`, both in the world; `target` itself where it is inside.
    #[must_use]
    pub fn closest_point(&self, target: Vec3) -> Vec3 {
        let pose = self.world_pose();
        pose.point(self.collider().shape.closest_point(pose.point_back(target)))
    }
    /// An upper bound for the number of its touching contacts.
    #[must_use]
    pub fn contact_capacity(&self) -> usize {
        let body = &self.world.bodies.bodies[self.collider().body as usize];
        let mine = |c: &&u32| self.world.contacts.contacts[**c as usize].shape.contains(&(self.index as u32));
        body.contacts.iter().filter(mine).count()
    }
    /// Its touching contacts, in order of contact slots.
    #[must_use]
    pub fn contacts(&self) -> Vec<ContactData> {
        let body = BodyRef { world: self.world, index: self.collider().body as usize };
        let (id, mut list) = (self.id(), body.contacts());
        list.retain(|c| c.shape_a == id || c.shape_b == id);
        list
    }
}

impl ColliderMut<'_> {
    /// To read it.
    #[must_use]
    pub fn as_ref(&self) -> ColliderRef<'_> {
        ColliderRef { world: self.world, index: self.index }
    }

    fn collider(&mut self) -> &mut Collider {
        &mut self.world.colliders[self.index]
    }

    /// Sets the name.
    pub fn set_name(&mut self, name: &str) {
        self.collider().name = name.to_owned();
    }
    /// Sets the user data.
    pub fn set_user_data(&mut self, data: u64) {
        self.collider().user_data = data;
    }

    /// Sets the surface; takes effect in the next step. What lies on a conveyor that starts or stops wakes up.
    ///
    /// # Errors
    /// What [`SurfaceMaterial::validate`] says.
    pub fn set_material(&mut self, material: &SurfaceMaterial) -> Result<()> {
        material.validate()?;
        if self.collider().material.tangent_velocity != material.tangent_velocity {
            let body = self.collider().body as usize;
            self.world.wake_touching(body);
        }
        self.collider().material = *material;
        Ok(())
    }

    /// Sets the density \[kg/m³\], ≥ 0.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn set_density(&mut self, density: Float, update_body_mass: bool) -> Result<()> {
        let density = check::not_negative("density", density)?;
        self.collider().density = density;
        if update_body_mass {
            let body = self.collider().body as usize;
            self.world.update_mass(body);
        }
        Ok(())
    }

    /// Sets what it collides with; its contacts end and are found anew in the next step.
    pub fn set_filter(&mut self, filter: Filter) {
        if self.collider().filter == filter {
            return;
        }
        self.collider().filter = filter;
        self.find_contacts_anew();
    }

    fn find_contacts_anew(&mut self) {
        let body = self.collider().body as usize;
        self.world.wake_touching(body);
        self.world.destroy_contacts_of_shape(self.index);
        if self.world.bodies.bodies[body].set != SetId::DISABLED {
            self.world.moved.push(self.index as u32);
        }
    }

    /// Makes begin and end events, or not.
    pub fn enable_contact_events(&mut self, on: bool) {
        self.collider().contact_events = on;
        self.refresh_flags();
    }
    /// Makes hit events, or not.
    pub fn enable_hit_events(&mut self, on: bool) {
        self.collider().hit_events = on;
        self.refresh_flags();
    }
    /// Asks the pre-solve callback, or not.
    pub fn enable_pre_solve_events(&mut self, on: bool) {
        self.collider().pre_solve_events = on;
        self.refresh_flags();
    }

    fn refresh_flags(&mut self) {
        let world = &mut *self.world;
        let body = world.colliders[self.index].body as usize;
        for &c in &world.bodies.bodies[body].contacts {
            let contact = &mut world.contacts.contacts[c as usize];
            if contact.shape.contains(&(self.index as u32)) {
                let [a, b] = contact.shape.map(|s| &world.colliders[s as usize]);
                contact.set(flags::EVENTS, a.contact_events || b.contact_events);
                contact.set(flags::HIT_EVENTS, a.hit_events || b.hit_events);
                contact.set(flags::PRE_SOLVE, a.pre_solve_events || b.pre_solve_events);
            }
        }
    }

    /// Replaces the geometry, placed by `local` (body from shape). Does not change the body's mass unless
    /// `update_body_mass`.
    ///
    /// # Errors
    /// NotFinite, Range; a half-space on a body that moves.
    pub fn set_shape(&mut self, shape: Shape, local: &Pose, update_body_mass: bool) -> Result<()> {
        let local = check::pose("local pose", local)?;
        let body = self.collider().body as usize;
        self.world.check_half_space(body, &shape)?;
        self.find_contacts_anew();
        let inner_radius = shape.inner_radius();
        let collider = self.collider();
        (collider.shape, collider.local, collider.inner_radius) = (shape, local, inner_radius);
        if update_body_mass {
            self.world.update_mass(body);
        } else {
            self.world.update_reach(body);
        }
        BodyMut { world: &mut *self.world, index: body }.refresh_boxes();
        Ok(())
    }
}
