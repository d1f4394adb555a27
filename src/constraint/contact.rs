//! Contacts: what is remembered about two shapes whose fat boxes meet.

use crate::body::{Body, NONE};
use crate::math::{Float, Vec3};
use crate::narrow_phase::{Cache, MAX_MANIFOLD_POINTS};

/// Flags of a contact.
pub mod flags {
    /// The manifold has points, so the contact is a constraint: it has a colour and joins islands.
    pub const CONSTRAINT: u16 = 1;
    /// The surfaces touch, by the measure of the events.
    pub const TOUCHING: u16 = 2;
    /// Begin and end events are wanted.
    pub const EVENTS: u16 = 4;
    /// Hit events are wanted.
    pub const HIT_EVENTS: u16 = 8;
    /// The pre-solve callback is wanted.
    pub const PRE_SOLVE: u16 = 16;
}

/// One point of contact. Impulses are of one sub-step unless said.
#[derive(Clone, Copy, Debug, Default)]
pub struct ContactPoint {
    /// From the centre of mass of A to the middle between the surfaces, world axes \[m\]. By `update_contacts`.
    pub anchor: Vec3,
    /// Gap along the normal \[m\]. By `update_contacts`.
    pub separation: Float,
    /// Which features of the two shapes meet here. By `update_contacts`.
    pub feature: u32,
    /// Normal impulse of the last sub-step \[N s\]. By `solve`.
    pub impulse: Float,
    /// The slowly filtered impulse that is no longer leaked \[N s\]. By `prepare`.
    pub memory: Float,
    /// Friction impulse on B of the last sub-step, world axes \[N s\]. By `solve`, of solvers with friction at each point.
    pub friction: Vec3,
    /// Sum of the normal impulses over the last step \[N s\]. By `solve`.
    pub total: Float,
    /// Normal velocity of B against A at the start of the step \[m/s\]. By `prepare`.
    pub approach: Float,
}

/// A contact between shapes A and B, A's index being the lower one.
///
/// In f32 the first 64 bytes are what most walks over contacts look at, the next what the solver asks for besides.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct Contact {
    /// Indices of the colliders.
    pub shape: [u32; 2],
    /// Stable indices of the bodies.
    pub body: [u32; 2],
    /// Where the contact stands in each body's list.
    pub place: [u32; 2],
    /// Where it stands in the list of awake contacts, or [`NONE`].
    pub awake_place: u32,
    /// See [`flags`].
    pub flags: u16,
    /// Graph colour, while it is an awake constraint.
    pub color: u8,
    /// Number of points.
    pub count: u8,
    /// What the narrow phase wants to remember.
    pub cache: Cache,
    /// Unit normal from A to B, world axes.
    pub normal: Vec3,
    /// Sliding friction coefficient of the pair.
    pub friction: Float,
    /// Static friction coefficient of the pair.
    pub static_friction: Float,
    /// Restitution of the pair.
    pub restitution: Float,
    /// Lever of the rolling resistance \[m\].
    pub rolling_lever: Float,
    /// Radii of the rounding of A and B \[m\]: a round surface turns under its contact point, which stays.
    pub rounding: [Float; 2],
    /// Velocity of B's surface against A's as of a conveyor, world axes \[m/s\].
    pub conveyor: Vec3,
    /// Friction impulse on B of the last sub-step, world axes \[N s\].
    pub friction_impulse: Vec3,
    /// Impulse about the normal of the last sub-step \[N m s\].
    pub twist_impulse: Float,
    /// Rolling resistance impulse on B of the last sub-step, world axes \[N m s\].
    pub rolling_impulse: Vec3,
    /// Sum of the friction impulses on B over the last step, world axes \[N s\].
    pub total_friction: Vec3,
    /// The points, the first `count` of them.
    pub points: [ContactPoint; MAX_MANIFOLD_POINTS],
}

impl Contact {
    /// A contact that was not looked at yet.
    #[must_use]
    pub fn new(shape: [u32; 2], body: [u32; 2]) -> Self {
        Self {
            shape,
            body,
            place: [NONE; 2],
            awake_place: NONE,
            flags: 0,
            color: crate::island::color::NO_COLOR,
            count: 0,
            cache: Cache::default(),
            normal: Vec3::zeros(),
            points: [ContactPoint::default(); MAX_MANIFOLD_POINTS],
            friction: 0.0,
            static_friction: 0.0,
            restitution: 0.0,
            rolling_lever: 0.0,
            rounding: [0.0; 2],
            conveyor: Vec3::zeros(),
            friction_impulse: Vec3::zeros(),
            twist_impulse: 0.0,
            rolling_impulse: Vec3::zeros(),
            total_friction: Vec3::zeros(),
        }
    }

    /// Whether a flag is set.
    #[inline(always)]
    #[must_use]
    pub fn is(&self, flag: u16) -> bool {
        self.flags & flag != 0
    }

    /// Sets or clears a flag.
    #[inline(always)]
    pub fn set(&mut self, flag: u16, on: bool) {
        if on {
            self.flags |= flag;
        } else {
            self.flags &= !flag;
        }
    }

    /// The points.
    #[inline(always)]
    #[must_use]
    pub fn points(&self) -> &[ContactPoint] {
        &self.points[..self.count as usize]
    }

    /// Forgets the impulses of the last step.
    pub fn clear_impulses(&mut self) {
        for p in &mut self.points {
            (p.impulse, p.memory, p.total, p.friction) = (0.0, 0.0, 0.0, Vec3::zeros());
        }
        self.friction_impulse = Vec3::zeros();
        self.twist_impulse = 0.0;
        self.rolling_impulse = Vec3::zeros();
        self.total_friction = Vec3::zeros();
    }
}

/// All contacts of a world by stable index, and the list of those that a step looks at.
#[derive(Clone, Debug, Default)]
pub struct ContactStore {
    /// By stable index; destroyed ones are left as they are until the index is used again.
    pub contacts: Vec<Contact>,
    /// Contacts with an awake body, in no particular (but reproducible) order.
    pub awake: Vec<u32>,
}

impl ContactStore {
    /// Adds a contact with the stable index `index` and enters it into its bodies' lists.
    pub fn add(&mut self, index: usize, mut contact: Contact, bodies: &mut [Body]) {
        for side in 0..2 {
            let list = &mut bodies[contact.body[side] as usize].contacts;
            contact.place[side] = list.len() as u32;
            list.push(index as u32);
        }
        if index == self.contacts.len() {
            crate::memory::make_room(&mut self.contacts, 1);
            self.contacts.push(contact);
        } else {
            self.contacts[index] = contact;
        }
    }

    /// Takes a contact out of its bodies' lists and of the awake list.
    pub fn remove(&mut self, index: usize, bodies: &mut [Body]) {
        self.set_awake(index, false);
        let contact = self.contacts[index];
        for side in 0..2 {
            let body = contact.body[side];
            let list = &mut bodies[body as usize].contacts;
            let place = contact.place[side] as usize;
            list.swap_remove(place);
            if let Some(&moved) = list.get(place) {
                let moved = &mut self.contacts[moved as usize];
                // A body never has a contact with itself, so one side is enough.
                let side = usize::from(moved.body[0] != body);
                moved.place[side] = place as u32;
            }
        }
    }

    /// Enters a contact into the awake list or takes it out.
    pub fn set_awake(&mut self, index: usize, awake: bool) {
        let place = self.contacts[index].awake_place;
        if awake && place == NONE {
            self.contacts[index].awake_place = self.awake.len() as u32;
            self.awake.push(index as u32);
        } else if !awake && place != NONE {
            self.awake.swap_remove(place as usize);
            if let Some(&moved) = self.awake.get(place as usize) {
                self.contacts[moved as usize].awake_place = place;
            }
            self.contacts[index].awake_place = NONE;
        }
    }

    /// Asks for the memory of a contact, if there is one.
    #[inline(always)]
    pub fn prefetch_at(&self, index: Option<u32>) {
        if let Some(index) = index {
            crate::simd::prefetch(&self.contacts[index as usize]);
        }
    }

    /// Asks for the memory of the first part of a contact, if there is one.
    #[inline(always)]
    pub fn prefetch_head(&self, index: Option<u32>) {
        if let Some(index) = index {
            crate::simd::prefetch(&self.contacts[index as usize].shape);
        }
    }

    /// Bytes held.
    #[must_use]
    pub fn byte_count(&self) -> usize {
        self.contacts.capacity() * size_of::<Contact>() + self.awake.capacity() * 4
    }
}
