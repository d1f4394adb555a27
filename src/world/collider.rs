//! A shape attached to a body.

use super::def::{Filter, ShapeDef, SurfaceMaterial};
use crate::math::tolerance::MAX_COORDINATE;
use crate::math::{Aabb, Float, Pose, Vec3, vec3};
use crate::shape::{MassData, Shape};

/// A shape attached to a body. Found by a stable index, which also is its proxy in the broad phase.
#[derive(Clone, Debug)]
pub struct Collider {
    /// Geometry in the shape's own frame.
    pub shape: Shape,
    /// Body from shape.
    pub local: Pose,
    /// Stable index of the body.
    pub body: u32,
    /// Surface.
    pub material: SurfaceMaterial,
    /// \[kg/m³\]
    pub density: Float,
    /// What it collides with.
    pub filter: Filter,
    /// Ask the custom filter.
    pub custom_filtering: bool,
    /// Make begin and end events.
    pub contact_events: bool,
    /// Make hit events.
    pub hit_events: bool,
    /// Ask before solving.
    pub pre_solve_events: bool,
    /// How thin it is \[m\]: the bound of margins.
    pub inner_radius: Float,
    /// Reach from the body's centre of mass \[m\]. Written when the mass changes.
    pub reach: Float,
    /// The box that the broad phase knows.
    pub fat: Aabb,
    /// A name for people.
    pub name: String,
    /// Anything.
    pub user_data: u64,
}

impl Collider {
    /// From a definition.
    #[must_use]
    pub fn new(def: &ShapeDef, shape: Shape, local: Pose, body: u32) -> Self {
        let inner_radius = shape.inner_radius();
        Self {
            local,
            body,
            material: def.material,
            density: def.density,
            filter: def.filter,
            custom_filtering: def.enable_custom_filtering,
            contact_events: def.enable_contact_events,
            hit_events: def.enable_hit_events,
            pre_solve_events: def.enable_pre_solve_events,
            inner_radius,
            reach: 0.0,
            fat: Aabb::EMPTY,
            name: def.name.clone(),
            user_data: def.user_data,
            shape,
        }
    }

    /// Mass in the body's frame.
    #[must_use]
    pub fn mass_data(&self) -> MassData {
        self.shape.mass_data(self.density).placed(&self.local)
    }

    /// The tight box, with the body's origin at `origin`.
    #[inline]
    #[must_use]
    pub fn aabb(&self, origin: &Pose) -> Aabb {
        clamped(&self.shape.aabb(&origin.then(&self.local)))
    }

    /// The radius that rolling resistance is a share of.
    #[must_use]
    pub fn rolling_radius(&self) -> Float {
        match &self.shape {
            Shape::Sphere(s) => s.radius(),
            Shape::Capsule(c) => c.radius(),
            Shape::HalfSpace(_) => 0.0,
            _ => self.inner_radius,
        }
    }
}

/// The box within the range of coordinates that broad phases take.
#[inline]
#[must_use]
pub fn clamped(b: &Aabb) -> Aabb {
    let m = vec3(MAX_COORDINATE, MAX_COORDINATE, MAX_COORDINATE);
    let within = |v: Vec3| crate::math::max(crate::math::min(v, m), -m);
    Aabb { lower: within(b.lower), upper: within(b.upper) }
}
