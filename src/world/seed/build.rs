//! How bodies are made.

use super::{RigidBodyId, StaticBodyId};
use crate::error::{Error, ErrorCode, Result, check, expect};
use crate::math::{Float, Quat, Vec3, vec3};
use crate::shape::Shape;
use crate::world::{BodyDef, BodyId, ShapeDef, World};

/// Density of rigid bodies whose mass is not given \[kg/m³\].
const DENSITY: Float = 1.0;

impl World {
    /// Adds a body with one shape of the world's material.
    fn add_body(&mut self, body: &BodyDef, shape: Shape, density: Float) -> Result<BodyId> {
        let def = ShapeDef { material: self.seed.material, density, ..ShapeDef::default() };
        Ok(self.create_body_with_shape(body, &def, shape)?.0)
    }
}

/// Makes a body that moves by forces and contacts. Without [`finish`](Self::finish) there is none.
#[derive(Debug)]
#[must_use = "nothing is created before `finish`"]
pub struct RigidbodyBuilder<'w> {
    world: &'w mut World,
    shape: Shape,
    mass: Option<Float>,
    def: BodyDef,
}

impl<'w> RigidbodyBuilder<'w> {
    /// Begins a body of this shape at the world's origin, unturned, at rest, with a density of 1 kg/m³.
    pub fn new(world: &'w mut World, shape: Shape) -> Self {
        Self { world, shape, mass: None, def: BodyDef::dynamic(Vec3::zeros()) }
    }

    /// Sets the mass \[kg\], > 0, spread evenly over the shape.
    ///
    /// # Panics
    /// Where [`try_mass`](Self::try_mass) fails.
    #[track_caller]
    pub fn mass(self, mass: Float) -> Self {
        expect(self.try_mass(mass))
    }

    /// Sets the mass \[kg\], > 0, spread evenly over the shape.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn try_mass(mut self, mass: Float) -> Result<Self> {
        self.mass = Some(check::positive("mass", mass)?);
        Ok(self)
    }

    /// Sets where the origin of the shape is \[m\], within ±10⁹.
    ///
    /// # Panics
    /// Where [`try_position`](Self::try_position) fails.
    #[track_caller]
    pub fn position(self, position: Vec3) -> Self {
        expect(self.try_position(position))
    }

    /// Sets where the origin of the shape is \[m\], within ±10⁹.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn try_position(mut self, position: Vec3) -> Result<Self> {
        self.def.position = check::point("position", position)?;
        Ok(self)
    }

    /// [`position`](Self::position), by its coordinates.
    ///
    /// # Panics
    /// Where [`try_pos`](Self::try_pos) fails.
    #[track_caller]
    pub fn pos(self, x: Float, y: Float, z: Float) -> Self {
        expect(self.try_pos(x, y, z))
    }

    /// [`try_position`](Self::try_position), by its coordinates.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn try_pos(self, x: Float, y: Float, z: Float) -> Result<Self> {
        self.try_position(vec3(x, y, z))
    }

    /// Sets how the shape is turned, from its own axes to the world's.
    ///
    /// # Panics
    /// Where [`try_rotation`](Self::try_rotation) fails.
    #[track_caller]
    pub fn rotation(self, rotation: Quat) -> Self {
        expect(self.try_rotation(rotation))
    }

    /// Sets how the shape is turned, from its own axes to the world's.
    ///
    /// # Errors
    /// NotFinite, Range: not a unit quaternion.
    pub fn try_rotation(mut self, rotation: Quat) -> Result<Self> {
        self.def.rotation = check::rotation("rotation", rotation)?;
        Ok(self)
    }

    /// Creates the body.
    ///
    /// # Panics
    /// Where [`try_finish`](Self::try_finish) fails.
    #[track_caller]
    pub fn finish(self) -> RigidBodyId {
        expect(self.try_finish())
    }

    /// Creates the body.
    ///
    /// # Errors
    /// Range: the shape is a half-space, which has no mass, or the mass is too great or small for its size.
    pub fn try_finish(self) -> Result<RigidBodyId> {
        let density = self.mass.map_or(DENSITY, |mass| mass / self.shape.volume());
        let mut data = self.shape.mass_data(density);
        let bounded = !matches!(self.shape, Shape::HalfSpace(_));
        let inertia = data.inertia.trace();
        if bounded && !(inertia.is_normal() && density.is_normal()) {
            let sentence = format!("A shape of this size cannot have a mass of {} kg.", data.mass);
            return Err(Error::new(ErrorCode::Range, sentence));
        }
        let id = self.world.add_body(&self.def, self.shape, density)?;
        if let Some(mass) = self.mass {
            // Exactly as given: mass / volume × volume need not be.
            data.mass = mass;
            let index = self.world.body_index(id)?;
            self.world.set_mass(index, &data);
        }
        Ok(RigidBodyId(id))
    }
}

/// Makes a body that never moves. Without [`finish`](Self::finish) there is none.
#[derive(Debug)]
#[must_use = "nothing is created before `finish`"]
pub struct StaticbodyBuilder<'w> {
    world: &'w mut World,
    shape: Shape,
    def: BodyDef,
}

impl<'w> StaticbodyBuilder<'w> {
    /// Begins a body of this shape at the world's origin, unturned.
    pub fn new(world: &'w mut World, shape: Shape) -> Self {
        Self { world, shape, def: BodyDef::fixed(Vec3::zeros()) }
    }

    /// Sets where the origin of the shape is \[m\], within ±10⁹.
    ///
    /// # Panics
    /// Where [`try_position`](Self::try_position) fails.
    #[track_caller]
    pub fn position(self, position: Vec3) -> Self {
        expect(self.try_position(position))
    }

    /// Sets where the origin of the shape is \[m\], within ±10⁹.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn try_position(mut self, position: Vec3) -> Result<Self> {
        self.def.position = check::point("position", position)?;
        Ok(self)
    }

    /// [`position`](Self::position), by its coordinates.
    ///
    /// # Panics
    /// Where [`try_pos`](Self::try_pos) fails.
    #[track_caller]
    pub fn pos(self, x: Float, y: Float, z: Float) -> Self {
        expect(self.try_pos(x, y, z))
    }

    /// [`try_position`](Self::try_position), by its coordinates.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn try_pos(self, x: Float, y: Float, z: Float) -> Result<Self> {
        self.try_position(vec3(x, y, z))
    }

    /// Sets how the shape is turned, from its own axes to the world's.
    ///
    /// # Panics
    /// Where [`try_rotation`](Self::try_rotation) fails.
    #[track_caller]
    pub fn rotation(self, rotation: Quat) -> Self {
        expect(self.try_rotation(rotation))
    }

    /// Sets how the shape is turned, from its own axes to the world's.
    ///
    /// # Errors
    /// NotFinite, Range: not a unit quaternion.
    pub fn try_rotation(mut self, rotation: Quat) -> Result<Self> {
        self.def.rotation = check::rotation("rotation", rotation)?;
        Ok(self)
    }

    /// Creates the body.
    ///
    /// # Panics
    /// Where [`try_finish`](Self::try_finish) fails.
    #[track_caller]
    pub fn finish(self) -> StaticBodyId {
        expect(self.try_finish())
    }

    /// Creates the body.
    ///
    /// # Errors
    /// None today: everything was checked when it was given.
    pub fn try_finish(self) -> Result<StaticBodyId> {
        Ok(StaticBodyId(self.world.add_body(&self.def, self.shape, DENSITY)?))
    }
}
