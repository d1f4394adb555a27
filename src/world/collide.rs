//! Stages 2 to 4 of a step: boxes, pairs, contacts.

use super::collider::clamped;
use super::side::{Side, Sides};
use super::{BodyType, Collider, World};
use crate::body::NONE;
use crate::constraint::{Contact, ContactPoint, contact::flags};
use crate::math::tolerance::{CONTACT_MARGIN, FAT_MARGIN, PASSING_GAP, SAME_PLACE};
use crate::math::{Aabb, Float, Pose, Vec3, length, length_squared, rotate, rotate_back};
use crate::narrow_phase::{self, Cache, Manifold};
use crate::shape::Shape;
use crate::simd;

/// Lists that a step fills and empties.
#[derive(Clone, Debug, Default)]
pub(crate) struct Scratch {
    pub pairs: Vec<[u32; 2]>,
    /// Contacts that become or cease to be constraints, and that end, in this step.
    pub started: Vec<u32>,
    pub stopped: Vec<u32>,
    pub gone: Vec<u32>,
    pub slow_time: Vec<Float>,
    pub fell_asleep: Vec<u32>,
    pub broken: Vec<u32>,
    pub(super) sides: Sides,
}

/// How many contacts ahead a walk over them asks for their memory, and for that of their sides.
pub(super) const CONTACTS_AHEAD: usize = 12;
const SIDES_AHEAD: usize = 6;

impl World {
    /// The box of a new collider; those of moving bodies get a margin.
    pub(super) fn first_box(&self, collider: &Collider, origin: &Pose, body: usize) -> Aabb {
        let tight = collider.aabb(origin);
        match self.bodies.bodies[body].body_type {
            BodyType::Static => tight,
            _ => clamped(&tight.grown(FAT_MARGIN * collider.inner_radius)),
        }
    }

    /// Stage 2: fits the fat boxes of awake bodies to where they may go in this step.
    pub(super) fn update_bounds(&mut self, dt: Float) {
        let gravity = length(self.def.gravity);
        for row in 0..self.bodies.awake().len() {
            let set = self.bodies.awake();
            let origin = set.origin(row);
            let (v, w) = (set.velocity(row), set.angular_velocity(row));
            let kick = gravity * set.drive[row].gravity_scale.abs() * dt * dt;
            let body = set.index[row] as usize;
            for k in 0..self.bodies.bodies[body].shapes.len() {
                let index = self.bodies.bodies[body].shapes[k];
                let collider = &mut self.colliders[index as usize];
                // Beyond the shape's own size margins would only make ghost contacts.
                let limit = collider.inner_radius;
                let way = v * dt;
                let far = length(way);
                let way = if far > limit { way * (limit / far) } else { way };
                let turn = (length(w) * dt * collider.reach + kick).min(limit);
                let needed = clamped(
                    &collider.aabb(&origin).swept(way).grown(CONTACT_MARGIN * collider.inner_radius + turn),
                );
                if !collider.fat.contains(&needed) {
                    collider.fat = clamped(&needed.grown(FAT_MARGIN * collider.inner_radius));
                    self.broad_phase.update(index, &collider.fat);
                    self.moved.push(index);
                }
            }
        }
    }

    /// After bodies moved: where one went out of its fat box, that follows, so that queries see it. What bodies
    /// were expected to do left room for the usual step, and this seldom finds anything.
    pub(super) fn keep_boxes_around_shapes(&mut self) {
        for row in 0..self.bodies.awake().len() {
            let set = self.bodies.awake();
            let origin = set.origin(row);
            for &index in &self.bodies.bodies[set.index[row] as usize].shapes {
                let collider = &mut self.colliders[index as usize];
                let tight = collider.aabb(&origin);
                if !collider.fat.contains(&tight) {
                    collider.fat = clamped(&tight.grown(FAT_MARGIN * collider.inner_radius));
                    self.broad_phase.update(index, &collider.fat);
                    self.moved.push(index);
                }
            }
        }
    }

    /// Stage 3: new pairs of boxes become contacts.
    pub(super) fn find_pairs(&mut self) {
        self.moved.sort_unstable();
        self.moved.dedup();
        let mut pairs = std::mem::take(&mut self.scratch.pairs);
        pairs.clear();
        if !self.moved.is_empty() {
            self.broad_phase.find_pairs(&self.moved, &mut pairs);
        }
        self.moved.clear();
        // A crowd comes at once: make the room at once, too.
        let free = self.identity.contacts.slots() - self.identity.contacts.live();
        let new = pairs.len().saturating_sub(self.pairs.len() + free);
        crate::memory::make_room(&mut self.contacts.contacts, new);
        self.pairs.reserve(new);
        for &pair in &pairs {
            if self.pairs.get(pair).is_none() && self.may_collide(pair) {
                self.create_contact(pair);
            }
        }
        self.scratch.pairs = pairs;
    }

    fn may_collide(&self, pair: [u32; 2]) -> bool {
        let [a, b] = pair.map(|i| &self.colliders[i as usize]);
        if a.body == b.body || !a.filter.collides(&b.filter) || self.joint_forbids(a.body, b.body) {
            return false;
        }
        let dynamic = |c: &Collider| self.bodies.bodies[c.body as usize].body_type == BodyType::Dynamic;
        if !dynamic(a) && !dynamic(b) {
            return false;
        }
        match &self.callbacks.custom_filter {
            Some(ask) if a.custom_filtering || b.custom_filtering => {
                ask(self, self.shape_id(pair[0] as usize), self.shape_id(pair[1] as usize))
            }
            _ => true,
        }
    }

    fn create_contact(&mut self, pair: [u32; 2]) {
        let (index, _) = self.identity.contacts.allocate();
        let [a, b] = pair.map(|i| &self.colliders[i as usize]);
        let mut contact = Contact::new(pair, [a.body, b.body]);
        contact.set(flags::EVENTS, a.contact_events || b.contact_events);
        contact.set(flags::HIT_EVENTS, a.hit_events || b.hit_events);
        contact.set(flags::PRE_SOLVE, a.pre_solve_events || b.pre_solve_events);
        contact.rounding = [a.shape.rounding(), b.shape.rounding()];
        self.contacts.add(index, contact, &mut self.bodies.bodies);
        self.pairs.insert(pair, index as u32);
        let awake = self.deserves_attention(index);
        self.contacts.set_awake(index, awake);
    }

    /// Stage 4: manifolds of all awake contacts; contacts whose boxes parted end.
    pub(super) fn update_contacts(&mut self, dt: Float) {
        let mut scratch = std::mem::take(&mut self.scratch);
        scratch.started.clear();
        scratch.stopped.clear();
        scratch.gone.clear();
        scratch.sides.begin_step(self.colliders.len());
        // A callback may look at any contact: then each one is worked on in a copy.
        let in_place = !self.callbacks.see_contacts();
        let mut taken = if in_place { std::mem::take(&mut self.contacts.contacts) } else { Vec::new() };
        for k in 0..self.contacts.awake.len() {
            let index = self.contacts.awake[k];
            let mut copy;
            let contact = if in_place {
                self.prefetch_contacts(&taken, &scratch.sides, k);
                &mut taken[index as usize]
            } else {
                copy = self.contacts.contacts[index as usize];
                &mut copy
            };
            let [a, b] = scratch.sides.of(self, contact.shape, dt);
            if !a.fat.overlaps(&b.fat) {
                scratch.gone.push(index);
                continue;
            }
            let was = contact.is(flags::CONSTRAINT);
            self.update_contact(contact, a, b, dt);
            let is = contact.count > 0;
            if is != was {
                if is { scratch.started.push(index) } else { scratch.stopped.push(index) }
            }
            if !in_place {
                self.contacts.contacts[index as usize] = *contact;
            }
        }
        if in_place {
            self.contacts.contacts = taken;
        }
        // By shapes, not by slots: slots depend on what else is in the world.
        let shapes = |c: &u32| self.contacts.contacts[*c as usize].shape;
        for list in [&mut scratch.gone, &mut scratch.stopped, &mut scratch.started] {
            list.sort_unstable_by_key(shapes);
        }
        for &index in &scratch.gone {
            self.destroy_contact(index as usize, false);
        }
        self.scratch = scratch;
    }

    /// Asks for what the walk over the awake contacts, now at `k`, will need soon.
    #[inline(always)]
    fn prefetch_contacts(&self, contacts: &[Contact], sides: &Sides, k: usize) {
        if let Some(&index) = self.contacts.awake.get(k + CONTACTS_AHEAD) {
            simd::prefetch(&contacts[index as usize]);
        }
        if let Some(&index) = self.contacts.awake.get(k + SIDES_AHEAD) {
            for shape in contacts[index as usize].shape {
                sides.prefetch(shape);
                simd::prefetch(&self.colliders[shape as usize]);
            }
        }
    }

    /// Stage 5: constraints that came and went change islands and colours.
    pub(super) fn build_islands(&mut self) {
        let scratch = std::mem::take(&mut self.scratch);
        for &index in &scratch.stopped {
            self.end_constraint(index as usize);
        }
        for &index in &scratch.started {
            self.begin_constraint(index as usize);
        }
        self.scratch = scratch;
    }

    /// Recomputes one contact.
    fn update_contact(&self, contact: &mut Contact, a: &Side, b: &Side, dt: Float) {
        let size = a.size.min(b.size);
        let relative = b.v - a.v;
        let way = length(relative) * dt + a.spin_way + b.spin_way + a.fall + b.fall;
        let margin = CONTACT_MARGIN * size + way.min(size);

        let shapes = contact.shape.map(|s| &self.colliders[s as usize].shape);
        let mut manifold = self.meet(shapes, a, b, margin, &mut contact.cache);
        let normal = rotate(&a.q, manifold.normal);

        if a.asleep || b.asleep {
            // A sleeper is woken by what will touch it in this step, not by what passes by.
            let approach = normal.dot(&relative) * dt - a.spin_way - b.spin_way;
            if manifold.points[..manifold.count]
                .iter()
                .all(|p| p.separation > 0.0 && p.separation + approach > 0.0)
            {
                manifold.count = 0;
            }
        }
        if manifold.count > 0 && Self::passes_by(shapes, a, b, &manifold, normal, dt, size) {
            manifold.count = 0;
        }
        if let Some(ask) = &self.callbacks.pre_solve
            && manifold.count > 0
            && contact.is(flags::PRE_SOLVE)
        {
            let point = a.x + a.arm + rotate(&a.q, manifold.points[0].point);
            let [sa, sb] = contact.shape.map(|s| self.shape_id(s as usize));
            if !ask(self, sa, sb, point, normal) {
                manifold.count = 0;
            }
        }
        Self::carry_impulses(contact, &manifold, normal, a, b, size);
        self.mix_materials(contact, a, b);
    }

    /// The manifold of two sides, in the frame of A's shape.
    fn meet(&self, shapes: [&Shape; 2], a: &Side, b: &Side, margin: Float, cache: &mut Cache) -> Manifold {
        let a_from_b = Self::pose_between(a, b);
        let mut manifold = Manifold::default();
        narrow_phase::collide(
            shapes[0],
            shapes[1],
            &a_from_b,
            margin,
            self.def.methods(),
            cache,
            &mut manifold,
        );
        manifold
    }

    /// Whether two shapes that are apart will stay so in this step, although the plane between their nearest points
    /// would stop them: corners that fly past each other. Turning is left out; where it could matter they do not pass.
    fn passes_by(
        shapes: [&Shape; 2],
        a: &Side,
        b: &Side,
        manifold: &Manifold,
        normal: Vec3,
        dt: Float,
        size: Float,
    ) -> bool {
        let gap = manifold.points[..manifold.count].iter().map(|p| p.separation).fold(Float::MAX, Float::min);
        // A row acts up to a sub-step before the surface is reached: two steps are surely enough.
        let way = (b.v - a.v) * (2.0 * dt);
        // What rests, or does not get there anyway, is not asked.
        if gap <= PASSING_GAP * size || gap + normal.dot(&way) >= 0.0 || a.spin_way + b.spin_way > gap {
            return false;
        }
        let a_from_b = Self::pose_between(a, b);
        let way = rotate_back(&a.q, way);
        narrow_phase::shape_cast(shapes[0], shapes[1], &a_from_b, way, 1.0).is_none()
    }

    /// Where the shape of B is in the frame of A's, from the difference of the centres: exact far from the origin, too.
    fn pose_between(a: &Side, b: &Side) -> Pose {
        Pose::new(rotate_back(&a.q, (b.x - a.x) + b.arm - a.arm), a.q.conjugate() * b.q)
    }

    /// The deepest overlap of a contact at the present poses \[m\]; 0 for none. Asks no callback.
    pub(super) fn overlap_now(&self, contact: &Contact) -> Float {
        let [a, b] = contact.shape.map(|s| self.side(s, 0.0));
        let shapes = contact.shape.map(|s| &self.colliders[s as usize].shape);
        let manifold = self.meet(shapes, &a, &b, 0.0, &mut contact.cache.clone());
        manifold.points().iter().fold(0.0, |deepest, p| deepest.max(-p.separation))
    }

    /// Takes the new points in; those with known features keep their impulses.
    fn carry_impulses(
        contact: &mut Contact,
        manifold: &Manifold,
        normal: Vec3,
        a: &Side,
        b: &Side,
        size: Float,
    ) {
        let (mut old, old_count) = (contact.points, contact.count as usize);
        let old = &mut old[..old_count];
        contact.normal = normal;
        contact.count = manifold.count as u8;
        let mut strangers = 0;
        for (point, new) in contact.points.iter_mut().zip(&manifold.points[..manifold.count]) {
            *point = Default::default();
            point.anchor = a.arm + rotate(&a.q, new.point);
            if let Some(known) = old.iter_mut().find(|o| o.feature == new.feature) {
                (point.impulse, point.memory, point.friction) = (known.impulse, known.memory, known.friction);
                known.feature = TAKEN;
            } else {
                strangers += 1;
                point.feature = TAKEN;
            }
        }
        if strangers > 0 && old_count > 0 {
            inherit_by_place(&mut contact.points[..manifold.count], old, size);
        }
        for (point, new) in contact.points.iter_mut().zip(&manifold.points[..manifold.count]) {
            point.separation = new.separation;
            point.feature = new.feature;
            let arm_b = point.anchor + (a.x - b.x);
            point.approach = normal.dot(&(b.v + b.w.cross(&arm_b) - a.v - a.w.cross(&point.anchor)));
        }
        contact.total_friction = Vec3::zeros();
        if contact.count == 0 {
            contact.clear_impulses();
        }
    }

    /// Coefficients of the pair. Done every step, so that changes of materials take effect at once.
    fn mix_materials(&self, contact: &mut Contact, a: &Side, b: &Side) {
        let [ca, cb] = contact.shape.map(|s| &self.colliders[s as usize]);
        let (ma, mb) = (&ca.material, &cb.material);
        let (ia, ib) = (ma.user_material_id, mb.user_material_id);
        let root = |x: Float, y: Float| if x == y { x } else { (x * y).sqrt().min(Float::MAX) };
        let (sa, sb) = (ma.resolved_static_friction(), mb.resolved_static_friction());
        (contact.friction, contact.static_friction) = match &self.callbacks.friction {
            Some(mix) => (
                coefficient(mix(self, ma.friction, ia, mb.friction, ib), Float::MAX),
                coefficient(mix(self, sa, ia, sb, ib), Float::MAX),
            ),
            None => (root(ma.friction, mb.friction), root(sa, sb)),
        };
        contact.restitution = match &self.callbacks.restitution {
            Some(mix) => coefficient(mix(self, ma.restitution, ia, mb.restitution, ib), 1.0),
            None => ma.restitution.max(mb.restitution),
        };
        contact.rolling_lever = (ma.rolling_resistance * ca.rolling_radius())
            .max(mb.rolling_resistance * cb.rolling_radius())
            .min(Float::MAX);
        contact.conveyor = if ma.tangent_velocity == Vec3::zeros() && mb.tangent_velocity == Vec3::zeros() {
            Vec3::zeros()
        } else {
            let world = |s: &Side, c: &Collider, t: Vec3| {
                // Given in the body's frame; `q` is the shape's.
                rotate(&s.q, rotate_back(&c.local.q, t))
            };
            world(b, cb, mb.tangent_velocity) - world(a, ca, ma.tangent_velocity)
        };
        debug_assert!(contact.place[0] != NONE);
    }
}

/// A feature that no point has: it is spoken for, or not known yet.
const TAKEN: u32 = u32::MAX;

/// Points whose features are new take over the impulse of the nearest old point that no other one has, within
/// [`SAME_PLACE`]: two faces may change roles without anything having moved.
fn inherit_by_place(points: &mut [ContactPoint], old: &mut [ContactPoint], size: Float) {
    let reach = SAME_PLACE * size;
    for point in points.iter_mut().filter(|p| p.feature == TAKEN) {
        let mut best: Option<(Float, usize)> = None;
        for (k, o) in old.iter().enumerate().filter(|(_, o)| o.feature != TAKEN) {
            let d = length_squared(o.anchor - point.anchor);
            if d < reach * reach && best.is_none_or(|(least, _)| d < least) {
                best = Some((d, k));
            }
        }
        if let Some((_, k)) = best {
            (point.impulse, point.memory, point.friction) = (old[k].impulse, old[k].memory, old[k].friction);
            old[k].feature = TAKEN;
        }
    }
}

/// A callback's answer, made harmless: a coefficient that is not a number ≥ 0 counts as 0.
fn coefficient(x: Float, most: Float) -> Float {
    if x > 0.0 { x.min(most) } else { 0.0 }
}
