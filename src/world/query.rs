//! Questions to a world: what a ray or a moving solid meets, what overlaps a box or a solid.
//!
//! Queries see the shapes of all enabled bodies, whether static, awake or asleep, where they are now, if the
//! filter does. Hits come nearest first; hits equally near and overlaps come in order of their shapes' slots. So
//! no answer depends on the broad phase, which only proposes candidates.

use super::{BodyRef, ColliderRef, QueryFilter, ShapeId, World};
use crate::error::{Error, ErrorCode, Result, check};
use crate::math::tolerance::EPSILON;
use crate::math::{Aabb, Float, Pose, Vec3, rotate, rotate_back};
use crate::narrow_phase::{Proxy, cast_proxy, overlap_proxy};
use crate::shape::RayHit;

/// Where a ray or a moving solid meets a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShapeHit {
    /// The shape.
    pub shape: ShapeId,
    /// Where on its surface, in the world \[m\]. Where the cast starts inside, the ray's origin or, for a solid,
    /// some point of the shape.
    pub point: Vec3,
    /// The outward unit normal of its surface there; zero where the cast starts inside.
    pub normal: Vec3,
    /// The share of the translation travelled, 0 … 1.
    pub fraction: Float,
    /// The user material id of its surface.
    pub user_material_id: u64,
}

/// A ray, or a solid that moves without turning.
struct Cast<'a> {
    solid: Option<&'a Proxy<'a>>,
    origin: Vec3,
    translation: Vec3,
    max_fraction: Float,
}

impl<'a> Cast<'a> {
    fn new(solid: Option<&'a Proxy<'a>>, origin: Vec3, translation: Vec3) -> Result<Self> {
        let origin = check::point("origin", origin)?;
        let translation = check::point("translation", translation)?;
        Ok(Self { solid, origin, translation, max_fraction: 1.0 })
    }

    fn up_to(self, max_fraction: Float) -> Result<Self> {
        let max_fraction = check::within("max_fraction", max_fraction, 0.0, 1.0)?;
        Ok(Self { max_fraction, ..self })
    }

    /// Where it meets `shape`, in the world.
    fn at(&self, shape: ColliderRef<'_>, world_from_shape: &Pose) -> Option<ShapeHit> {
        let translation = rotate_back(&world_from_shape.q, self.translation);
        let hit = match self.solid {
            None => {
                let origin = world_from_shape.point_back(self.origin);
                shape.shape().ray_cast(origin, translation, self.max_fraction)?
            }
            Some(solid) => {
                let shape_from_solid = seen_from(world_from_shape, self.origin);
                let hit =
                    cast_proxy(shape.shape(), solid, &shape_from_solid, translation, self.max_fraction)?;
                RayHit { fraction: hit.fraction, point: hit.point, normal: hit.normal }
            }
        };
        Some(ShapeHit {
            shape: shape.id(),
            point: world_from_shape.point(hit.point),
            normal: rotate(&world_from_shape.q, hit.normal),
            fraction: hit.fraction,
            user_material_id: shape.material().user_material_id,
        })
    }
}

/// A frame at `origin` with the world's axes, seen from a shape.
fn seen_from(world_from_shape: &Pose, origin: Vec3) -> Pose {
    world_from_shape.back_to(&Pose::translation(origin))
}

/// Which of two hits comes first.
fn order(a: &ShapeHit, b: &ShapeHit) -> std::cmp::Ordering {
    a.fraction.total_cmp(&b.fraction).then(a.shape.index1.cmp(&b.shape.index1))
}

/// Hands out hits, nearest first, as `callback` wants them (see [`World::cast_ray`]).
fn hand_out(hits: &[ShapeHit], callback: &mut dyn FnMut(&ShapeHit) -> Float) {
    let mut max = 1.0;
    for hit in hits {
        if hit.fraction > max {
            return;
        }
        let answer = callback(hit);
        if answer == 0.0 {
            return;
        }
        if answer > 0.0 {
            max = answer.min(max);
        }
    }
}

impl World {
    /// The nearest shape that the ray from `origin` along `translation` \[m\] meets. Shapes that the ray starts in
    /// are not seen.
    ///
    /// # Errors
    /// NotFinite, Range: a number is not finite or beyond ±10⁹ m.
    pub fn cast_ray_closest(
        &self,
        origin: Vec3,
        translation: Vec3,
        filter: QueryFilter,
    ) -> Result<Option<ShapeHit>> {
        let cast = Cast::new(None, origin, translation)?;
        Ok(self.closest(&cast, filter, |hit| hit.normal != Vec3::zeros()))
    }

    /// Calls `callback` with the shapes that the ray from `origin` along `translation` \[m\] meets, nearest first.
    /// Its answer is −1 to ignore the hit, 0 to stop, a fraction in (0, 1) to see nothing beyond it, or 1 to go
    /// on. A shape that the ray starts in is met at fraction 0 with a zero normal; a ray without length meets those
    /// alone.
    ///
    /// # Errors
    /// NotFinite, Range: a number is not finite or beyond ±10⁹ m.
    pub fn cast_ray(
        &self,
        origin: Vec3,
        translation: Vec3,
        filter: QueryFilter,
        callback: &mut dyn FnMut(&ShapeHit) -> Float,
    ) -> Result<()> {
        hand_out(&self.cast_ray_all(origin, translation, filter)?, callback);
        Ok(())
    }

    /// All shapes that the ray from `origin` along `translation` \[m\] meets, nearest first, those it starts in
    /// included (see [`cast_ray`](Self::cast_ray)).
    ///
    /// # Errors
    /// NotFinite, Range: a number is not finite or beyond ±10⁹ m.
    pub fn cast_ray_all(
        &self,
        origin: Vec3,
        translation: Vec3,
        filter: QueryFilter,
    ) -> Result<Vec<ShapeHit>> {
        Ok(self.all(&Cast::new(None, origin, translation)?, filter))
    }

    /// The nearest shape that `solid` meets on its way: its points lie relative to `origin`, in world axes, and
    /// move along `translation` \[m\]. A shape that it overlaps from the start is met at fraction 0 with a zero
    /// normal; one that it only touches and does not approach is not met.
    ///
    /// # Errors
    /// NotFinite, Range: a number is not finite or beyond ±10⁹ m. A [`Proxy`] is checked when it is made.
    pub fn cast_shape_closest(
        &self,
        solid: &Proxy<'_>,
        origin: Vec3,
        translation: Vec3,
        filter: QueryFilter,
    ) -> Result<Option<ShapeHit>> {
        Ok(self.closest(&Cast::new(Some(solid), origin, translation)?, filter, |_| true))
    }

    /// Calls `callback` with the shapes that `solid` meets on its way (see
    /// [`cast_shape_closest`](Self::cast_shape_closest)), nearest first. It answers as for
    /// [`cast_ray`](Self::cast_ray). A solid that does not move meets what it overlaps.
    ///
    /// # Errors
    /// NotFinite, Range: a number is not finite or beyond ±10⁹ m.
    pub fn cast_shape(
        &self,
        solid: &Proxy<'_>,
        origin: Vec3,
        translation: Vec3,
        filter: QueryFilter,
        callback: &mut dyn FnMut(&ShapeHit) -> Float,
    ) -> Result<()> {
        hand_out(&self.cast_shape_all(solid, origin, translation, filter)?, callback);
        Ok(())
    }

    /// All shapes that `solid` meets on its way (see [`cast_shape_closest`](Self::cast_shape_closest)), nearest
    /// first.
    ///
    /// # Errors
    /// NotFinite, Range: a number is not finite or beyond ±10⁹ m.
    pub fn cast_shape_all(
        &self,
        solid: &Proxy<'_>,
        origin: Vec3,
        translation: Vec3,
        filter: QueryFilter,
    ) -> Result<Vec<ShapeHit>> {
        Ok(self.all(&Cast::new(Some(solid), origin, translation)?, filter))
    }

    /// Calls `callback` with the shapes whose tight boxes overlap `aabb`, in order of slots, until it returns
    /// false. These shapes may overlap the box; no other shape does.
    ///
    /// # Errors
    /// NotFinite, Range: a corner is not finite or beyond ±10⁹ m, or the corners are not in order.
    pub fn overlap_aabb(
        &self,
        aabb: &Aabb,
        filter: QueryFilter,
        callback: &mut dyn FnMut(ShapeId) -> bool,
    ) -> Result<()> {
        let _ = self.overlaps_of_box(aabb, filter)?.into_iter().all(|s| callback(self.shape_id(s)));
        Ok(())
    }

    /// All shapes whose tight boxes overlap `aabb`, in order of slots.
    ///
    /// # Errors
    /// NotFinite, Range: a corner is not finite or beyond ±10⁹ m, or the corners are not in order.
    pub fn overlap_aabb_all(&self, aabb: &Aabb, filter: QueryFilter) -> Result<Vec<ShapeId>> {
        Ok(self.overlaps_of_box(aabb, filter)?.into_iter().map(|s| self.shape_id(s)).collect())
    }

    /// Calls `callback` with the shapes that overlap or touch `solid`, whose points lie relative to `origin` in
    /// world axes, in order of slots, until it returns false.
    ///
    /// # Errors
    /// NotFinite, Range: the origin is not finite or beyond ±10⁹ m.
    pub fn overlap_shape(
        &self,
        solid: &Proxy<'_>,
        origin: Vec3,
        filter: QueryFilter,
        callback: &mut dyn FnMut(ShapeId) -> bool,
    ) -> Result<()> {
        let _ = self.overlaps_of_solid(solid, origin, filter)?.all(|s| callback(self.shape_id(s)));
        Ok(())
    }

    /// All shapes that overlap or touch `solid`, in order of slots (see [`overlap_shape`](Self::overlap_shape)).
    ///
    /// # Errors
    /// NotFinite, Range: the origin is not finite or beyond ±10⁹ m.
    pub fn overlap_shape_all(
        &self,
        solid: &Proxy<'_>,
        origin: Vec3,
        filter: QueryFilter,
    ) -> Result<Vec<ShapeId>> {
        Ok(self.overlaps_of_solid(solid, origin, filter)?.map(|s| self.shape_id(s)).collect())
    }

    fn sees(&self, filter: QueryFilter, shape: usize) -> bool {
        filter.sees(&self.colliders[shape].filter)
    }

    /// The hit of `cast` with one shape, where it is seen and met.
    fn hit(&self, cast: &Cast<'_>, filter: QueryFilter, shape: usize) -> Option<ShapeHit> {
        let shape = ColliderRef { world: self, index: shape };
        if self.sees(filter, shape.index) { cast.at(shape, &shape.world_pose()) } else { None }
    }

    /// Sweeps the box of `cast` through the broad phase; `visit(shape)` returns the fraction beyond which nothing
    /// matters any more.
    fn sweep(&self, cast: &Cast<'_>, visit: &mut dyn FnMut(usize) -> Float) {
        let (center, half) = match cast.solid {
            None => (cast.origin, Vec3::zeros()),
            Some(solid) => (cast.origin + solid.aabb().center(), solid.aabb().half()),
        };
        // Boxes are met with the rounding of their coordinates; nearer than that nothing may be left out, or the
        // order of visits would decide between equals.
        let size = cast.origin.amax() + half.amax() + center.amax() + cast.translation.amax();
        let slack = 8.0 * EPSILON * size / cast.translation.amax();
        self.broad_phase.cast(half, center, cast.translation, 1.0, &mut |shape, max| {
            // Without a way all boxes are met at 0, and the slack, no number, does not matter.
            (visit(shape as usize) + slack).max(Float::MIN_POSITIVE).min(max)
        });
    }

    /// The first hit that is `wanted`.
    fn closest(
        &self,
        cast: &Cast<'_>,
        filter: QueryFilter,
        wanted: impl Fn(&ShapeHit) -> bool,
    ) -> Option<ShapeHit> {
        let mut best: Option<ShapeHit> = None;
        self.sweep(cast, &mut |shape| {
            if let Some(hit) = self.hit(cast, filter, shape).filter(&wanted)
                && best.is_none_or(|b| order(&hit, &b).is_lt())
            {
                best = Some(hit);
            }
            best.map_or(1.0, |b| b.fraction)
        });
        best
    }

    /// All hits, in order.
    fn all(&self, cast: &Cast<'_>, filter: QueryFilter) -> Vec<ShapeHit> {
        let mut hits = Vec::new();
        self.sweep(cast, &mut |shape| {
            hits.extend(self.hit(cast, filter, shape));
            1.0
        });
        hits.sort_unstable_by(order);
        hits
    }

    /// The shapes seen whose fat boxes overlap `aabb`, in order.
    fn candidates(&self, aabb: &Aabb, filter: QueryFilter) -> Vec<usize> {
        let mut found = Vec::new();
        self.broad_phase.query(aabb, &mut |shape| {
            if self.sees(filter, shape as usize) {
                found.push(shape as usize);
            }
            true
        });
        found.sort_unstable();
        found
    }

    fn overlaps_of_box(&self, aabb: &Aabb, filter: QueryFilter) -> Result<Vec<usize>> {
        check::point("The box's lower corner", aabb.lower)?;
        check::point("The box's upper corner", aabb.upper)?;
        if !aabb.is_valid() {
            return Err(Error::new(ErrorCode::Range, "The box's lower corner lies above its upper corner."));
        }
        let mut found = self.candidates(aabb, filter);
        found.retain(|&index| ColliderRef { world: self, index }.aabb().overlaps(aabb));
        Ok(found)
    }

    fn overlaps_of_solid<'q>(
        &'q self,
        solid: &'q Proxy<'_>,
        origin: Vec3,
        filter: QueryFilter,
    ) -> Result<impl Iterator<Item = usize> + 'q> {
        check::point("origin", origin)?;
        let aabb = solid.aabb();
        // What touches must not be lost to the rounding of boxes.
        let margin = 8.0 * EPSILON * (origin.amax() + aabb.lower.amax().max(aabb.upper.amax()));
        let around = Aabb { lower: origin + aabb.lower, upper: origin + aabb.upper }.grown(margin);
        let found = self.candidates(&around, filter).into_iter();
        Ok(found.filter(move |&index| {
            let shape = ColliderRef { world: self, index };
            overlap_proxy(shape.shape(), solid, &seen_from(&shape.world_pose(), origin))
        }))
    }
}

impl<'w> BodyRef<'w> {
    /// The nearest hit of `cast` with the body's shapes, as if its origin were at `at`.
    fn closest(
        &self,
        cast: &Cast<'_>,
        filter: QueryFilter,
        at: &Pose,
        wanted: impl Fn(&ShapeHit) -> bool,
    ) -> Option<ShapeHit> {
        self.seen_shapes(filter)
            .filter_map(|shape| cast.at(shape, &at.then(&shape.local_pose())))
            .filter(wanted)
            .min_by(order)
    }

    fn seen_shapes(&self, filter: QueryFilter) -> impl Iterator<Item = ColliderRef<'w>> {
        let world = self.world;
        let shapes = world.bodies.bodies[self.index].shapes.iter().map(|&s| s as usize);
        shapes.filter(move |&s| world.sees(filter, s)).map(move |index| ColliderRef { world, index })
    }

    /// Where the ray from `origin` along at most `max_fraction` (0 … 1) of `translation` \[m\] first meets a shape
    /// of this body, were the body's origin at `at`; pass [`transform`](Self::transform) for where it is. Shapes
    /// that the ray starts in are not seen. Disabled bodies are.
    ///
    /// # Errors
    /// NotFinite, Range: a number is not finite or out of range, or `at` is no placement.
    pub fn ray_cast(
        &self,
        origin: Vec3,
        translation: Vec3,
        filter: QueryFilter,
        max_fraction: Float,
        at: &Pose,
    ) -> Result<Option<ShapeHit>> {
        let cast = Cast::new(None, origin, translation)?.up_to(max_fraction)?;
        Ok(self.closest(&cast, filter, &check::pose("at", at)?, |hit| hit.normal != Vec3::zeros()))
    }

    /// Where `solid`, moving from `origin` along at most `max_fraction` (0 … 1) of `translation` \[m\], first meets
    /// a shape of this body, were the body's origin at `at` (see [`World::cast_shape_closest`]).
    ///
    /// # Errors
    /// NotFinite, Range: a number is not finite or out of range, or `at` is no placement.
    pub fn shape_cast(
        &self,
        solid: &Proxy<'_>,
        origin: Vec3,
        translation: Vec3,
        filter: QueryFilter,
        max_fraction: Float,
        at: &Pose,
    ) -> Result<Option<ShapeHit>> {
        let cast = Cast::new(Some(solid), origin, translation)?.up_to(max_fraction)?;
        Ok(self.closest(&cast, filter, &check::pose("at", at)?, |_| true))
    }

    /// Whether `solid` at `origin` overlaps or touches a shape of this body, were the body's origin at `at`.
    ///
    /// # Errors
    /// NotFinite, Range: a number is not finite or out of range, or `at` is no placement.
    pub fn overlap_shape(
        &self,
        solid: &Proxy<'_>,
        origin: Vec3,
        filter: QueryFilter,
        at: &Pose,
    ) -> Result<bool> {
        let (origin, at) = (check::point("origin", origin)?, check::pose("at", at)?);
        Ok(self.seen_shapes(filter).any(|shape| {
            let pose = at.then(&shape.local_pose());
            overlap_proxy(shape.shape(), solid, &seen_from(&pose, origin))
        }))
    }
}

impl ColliderRef<'_> {
    /// Where the ray from `origin` along `translation` \[m\] first meets this shape, whatever else is in the way.
    /// One that starts inside hits at fraction 0 with a zero normal.
    ///
    /// # Errors
    /// NotFinite, Range: a number is not finite or beyond ±10⁹ m.
    pub fn ray_cast(&self, origin: Vec3, translation: Vec3) -> Result<Option<ShapeHit>> {
        Ok(Cast::new(None, origin, translation)?.at(*self, &self.world_pose()))
    }

    /// Where `solid`, moving from `origin` along `translation` \[m\], first meets this shape, whatever else is in
    /// the way (see [`World::cast_shape_closest`]).
    ///
    /// # Errors
    /// NotFinite, Range: a number is not finite or beyond ±10⁹ m.
    pub fn shape_cast(&self, solid: &Proxy<'_>, origin: Vec3, translation: Vec3) -> Result<Option<ShapeHit>> {
        Ok(Cast::new(Some(solid), origin, translation)?.at(*self, &self.world_pose()))
    }

    /// Whether `solid` at `origin` overlaps or touches this shape.
    ///
    /// # Errors
    /// NotFinite, Range: the origin is not finite or beyond ±10⁹ m.
    pub fn overlap_shape(&self, solid: &Proxy<'_>, origin: Vec3) -> Result<bool> {
        let origin = check::point("origin", origin)?;
        Ok(overlap_proxy(self.shape(), solid, &seen_from(&self.world_pose(), origin)))
    }
}
