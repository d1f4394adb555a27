//! How a world is made.

use crate::broad_phase::BroadPhaseKind;
use crate::error::{Error, ErrorCode, Result, check, expect};
use crate::integrate::IntegratorKind;
use crate::math::{Float, Vec3, vec3};
use crate::narrow_phase::{GjkKind, ManifoldKind, NarrowPhaseKind};
use crate::solver::SolverKind;
use crate::world::{Identity, SurfaceMaterial, World, WorldDef};

/// What a world can be made from: a [`WorldConfig`], or a reference to a [`WorldDef`].
pub trait WorldPlan {
    /// Makes the world.
    ///
    /// # Errors
    /// What is wrong with the plan.
    fn carry_out(self) -> Result<World>;
}

impl WorldPlan for &WorldDef {
    fn carry_out(self) -> Result<World> {
        World::try_with_identity(self, Identity::new(0))
    }
}

impl WorldPlan for WorldConfig {
    fn carry_out(self) -> Result<World> {
        self.carry_out_by(WorldDef::default())
    }
}

impl WorldConfig {
    /// Makes the world by the methods that `def` names.
    fn carry_out_by(self, def: WorldDef) -> Result<World> {
        self.validate()?;
        let def = WorldDef { gravity: self.gravity, restitution_threshold: 0.0, enable_sleep: false, ..def };
        let mut world = def.carry_out()?;
        world.seed = Settings {
            solver_steps: self.solver_steps as u32,
            rb_separation_force: self.rb_separation_force,
            sb_separation_force: self.sb_separation_force,
            material: SurfaceMaterial {
                restitution: self.bounciness,
                friction: self.friction,
                ..SurfaceMaterial::default()
            },
        };
        Ok(world)
    }
}

/// The settings of a world. To be made by a [`WorldBuilder`].
#[derive(Clone, Debug, PartialEq)]
pub struct WorldConfig {
    /// The acceleration of everything that falls \[m/s²\]; default (0, −10, 0).
    pub gravity: Vec3,
    /// Into how many sub-steps the solver divides an update, or how many iterations it makes if it is one that
    /// iterates, 1 … 1000; default 4.
    pub solver_steps: usize,
    /// Scale of the speed at which overlapping rigid bodies push each other apart, ≥ 0; default 1, which is
    /// 3 m/s at most.
    pub rb_separation_force: Float,
    /// The same for a rigid body that overlaps a static one.
    pub sb_separation_force: Float,
    /// Coefficient of restitution of all shapes, from 0 (no bounce) to 1 (nothing is lost); default 0.
    pub bounciness: Float,
    /// Coefficient of friction of all shapes, ≥ 0; default 0.6.
    pub friction: Float,
}

impl Default for WorldConfig {
    fn default() -> Self {
        Self {
            gravity: vec3(0.0, -10.0, 0.0),
            solver_steps: 4,
            rb_separation_force: 1.0,
            sb_separation_force: 1.0,
            bounciness: 0.0,
            friction: 0.6,
        }
    }
}

impl WorldConfig {
    /// Checks every field.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn validate(&self) -> Result<()> {
        check::finite_vec("gravity", self.gravity)?;
        if !(1..=1000).contains(&self.solver_steps) {
            let sentence = format!("solver_steps is {}; it must be 1 … 1000.", self.solver_steps);
            return Err(Error::new(ErrorCode::Range, sentence));
        }
        check::not_negative("rb_separation_force", self.rb_separation_force)?;
        check::not_negative("sb_separation_force", self.sb_separation_force)?;
        check::within("bounciness", self.bounciness, 0.0, 1.0)?;
        check::not_negative("friction", self.friction)?;
        Ok(())
    }
}

/// What a world remembers of its configuration, its definition aside.
#[derive(Clone, Debug)]
pub(crate) struct Settings {
    pub solver_steps: u32,
    pub rb_separation_force: Float,
    pub sb_separation_force: Float,
    /// Of all shapes made by the builders of bodies.
    pub material: SurfaceMaterial,
}

impl Default for Settings {
    fn default() -> Self {
        let config = WorldConfig::default();
        Self {
            solver_steps: config.solver_steps as u32,
            rb_separation_force: config.rb_separation_force,
            sb_separation_force: config.sb_separation_force,
            material: SurfaceMaterial::default(),
        }
    }
}

/// Makes a [`World`] step by step. What is not said stays at the default of [`WorldConfig`].
///
/// ```
/// use merev::{Shape, WorldBuilder};
///
/// let mut world = WorldBuilder::new().down_gravity(10.0).bounciness(0.9).build();
/// world.add_staticbody(Shape::new_box(10.0, 1.0, 10.0)).pos(0.0, -5.0, 0.0).finish();
/// let ball = world.add_rigidbody(Shape::new_sphere(1.0)).finish();
/// for _ in 0..50 {
///     world.update(0.01);
/// }
/// assert!(world.get(ball).unwrap().position().y < -1.0);
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[must_use = "there is no world before `build`"]
pub struct WorldBuilder {
    config: WorldConfig,
    /// The methods, of those that the engine has several of; the rest of it is not looked at.
    methods: WorldDef,
}

impl WorldBuilder {
    /// Begins with the defaults.
    pub fn new() -> Self {
        Self::default()
    }

    fn with(mut self, set: impl FnOnce(&mut WorldConfig)) -> Result<Self> {
        set(&mut self.config);
        self.config.validate()?;
        Ok(self)
    }

    /// Which integrator moves the bodies; the engine's choice otherwise.
    pub fn integrator(mut self, kind: IntegratorKind) -> Self {
        self.methods.integrator = kind;
        self
    }

    /// Which solver holds the contacts; the engine's choice otherwise.
    pub fn solver(mut self, kind: SolverKind) -> Self {
        self.methods.solver = kind;
        self
    }

    /// How many sweeps each sub-step has, 0 … 10 000, of the solvers that iterate; with 0, the default, `solver_steps`
    /// are their iterations, as in the thesis.
    ///
    /// # Panics
    /// Where [`try_solver_iterations`](Self::try_solver_iterations) fails.
    #[track_caller]
    pub fn solver_iterations(self, iterations: u32) -> Self {
        expect(self.try_solver_iterations(iterations))
    }

    /// How many sweeps each sub-step has, 0 … 10 000 (see [`solver_iterations`](Self::solver_iterations)).
    ///
    /// # Errors
    /// Range.
    pub fn try_solver_iterations(mut self, iterations: u32) -> Result<Self> {
        self.methods.solver_iterations = check::count("solver_iterations", iterations, 0, 10_000)?;
        Ok(self)
    }

    /// How many corners the friction pyramids of the solvers lemke and dantzig have, 3 … 64; default 8.
    ///
    /// # Panics
    /// Where [`try_friction_facets`](Self::try_friction_facets) fails.
    #[track_caller]
    pub fn friction_facets(self, facets: u32) -> Self {
        expect(self.try_friction_facets(facets))
    }

    /// How many corners the friction pyramids of the solvers lemke and dantzig have, 3 … 64.
    ///
    /// # Errors
    /// Range.
    pub fn try_friction_facets(mut self, facets: u32) -> Result<Self> {
        self.methods.friction_facets = check::count("friction_facets", facets, 3, 64)?;
        Ok(self)
    }

    /// Whether sequential_impulse visits the points in another order in every iteration; default true.
    pub fn shuffle_contacts(mut self, on: bool) -> Self {
        self.methods.shuffle_contacts = on;
        self
    }

    /// Whether the first iterations of sequential_impulse correct by more than is missing; default false.
    pub fn over_correct(mut self, on: bool) -> Self {
        self.methods.over_correct = on;
        self
    }

    /// Nothing falls.
    pub fn no_gravity(mut self) -> Self {
        self.config.gravity = Vec3::zeros();
        self
    }

    /// Gravity of this strength \[m/s²\] towards −y.
    ///
    /// # Panics
    /// Where [`try_down_gravity`](Self::try_down_gravity) fails.
    #[track_caller]
    pub fn down_gravity(self, gravity: Float) -> Self {
        expect(self.try_down_gravity(gravity))
    }

    /// Gravity of this strength \[m/s²\] towards −y.
    ///
    /// # Errors
    /// NotFinite.
    pub fn try_down_gravity(self, gravity: Float) -> Result<Self> {
        self.try_gravity(vec3(0.0, -check::finite("gravity", gravity)?, 0.0))
    }

    /// Any gravity \[m/s²\].
    ///
    /// # Panics
    /// Where [`try_gravity`](Self::try_gravity) fails.
    #[track_caller]
    pub fn gravity(self, gravity: Vec3) -> Self {
        expect(self.try_gravity(gravity))
    }

    /// Any gravity \[m/s²\].
    ///
    /// # Errors
    /// NotFinite.
    pub fn try_gravity(self, gravity: Vec3) -> Result<Self> {
        self.with(|config| config.gravity = gravity)
    }

    /// Into how many sub-steps the solver divides an update, 1 … 1000.
    ///
    /// # Panics
    /// Where [`try_solver_steps`](Self::try_solver_steps) fails.
    #[track_caller]
    pub fn solver_steps(self, solver_steps: usize) -> Self {
        expect(self.try_solver_steps(solver_steps))
    }

    /// Into how many sub-steps the solver divides an update, 1 … 1000.
    ///
    /// # Errors
    /// Range: also for 0.
    pub fn try_solver_steps(self, solver_steps: usize) -> Result<Self> {
        self.with(|config| config.solver_steps = solver_steps)
    }

    /// How fast overlapping rigid bodies push each other apart, ≥ 0 (see [`WorldConfig`]).
    ///
    /// # Panics
    /// Where [`try_rb_separation_force`](Self::try_rb_separation_force) fails.
    #[track_caller]
    pub fn rb_separation_force(self, rb_separation_force: Float) -> Self {
        expect(self.try_rb_separation_force(rb_separation_force))
    }

    /// How fast overlapping rigid bodies push each other apart, ≥ 0 (see [`WorldConfig`]).
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn try_rb_separation_force(self, rb_separation_force: Float) -> Result<Self> {
        self.with(|config| config.rb_separation_force = rb_separation_force)
    }

    /// How fast a static body pushes out a rigid one that overlaps it, ≥ 0 (see [`WorldConfig`]).
    ///
    /// # Panics
    /// Where [`try_sb_separation_force`](Self::try_sb_separation_force) fails.
    #[track_caller]
    pub fn sb_separation_force(self, sb_separation_force: Float) -> Self {
        expect(self.try_sb_separation_force(sb_separation_force))
    }

    /// How fast a static body pushes out a rigid one that overlaps it, ≥ 0 (see [`WorldConfig`]).
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn try_sb_separation_force(self, sb_separation_force: Float) -> Result<Self> {
        self.with(|config| config.sb_separation_force = sb_separation_force)
    }

    /// Impacts are perfectly inelastic.
    pub fn no_bounce(mut self) -> Self {
        self.config.bounciness = 0.0;
        self
    }

    /// Impacts are perfectly elastic.
    pub fn max_bounce(mut self) -> Self {
        self.config.bounciness = 1.0;
        self
    }

    /// Any coefficient of restitution, 0 … 1.
    ///
    /// # Panics
    /// Where [`try_bounciness`](Self::try_bounciness) fails.
    #[track_caller]
    pub fn bounciness(self, bounciness: Float) -> Self {
        expect(self.try_bounciness(bounciness))
    }

    /// Any coefficient of restitution, 0 … 1.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn try_bounciness(self, bounciness: Float) -> Result<Self> {
        self.with(|config| config.bounciness = bounciness)
    }

    /// Everything is slippery.
    pub fn no_friction(mut self) -> Self {
        self.config.friction = 0.0;
        self
    }

    /// Any coefficient of friction, ≥ 0.
    ///
    /// # Panics
    /// Where [`try_friction`](Self::try_friction) fails.
    #[track_caller]
    pub fn friction(self, friction: Float) -> Self {
        expect(self.try_friction(friction))
    }

    /// Any coefficient of friction, ≥ 0.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn try_friction(self, friction: Float) -> Result<Self> {
        self.with(|config| config.friction = friction)
    }

    /// The narrow phase.
    pub fn narrow_phase(mut self, kind: NarrowPhaseKind) -> Self {
        self.methods.narrow_phase = kind;
        self
    }

    /// How GJK looks at simplices.
    pub fn gjk(mut self, kind: GjkKind) -> Self {
        self.methods.gjk = kind;
        self
    }

    /// How contact points are found where faces meet. [`build`](Self::build) fails where the library was built
    /// without the kind.
    pub fn manifold(mut self, kind: ManifoldKind) -> Self {
        self.methods.manifold = kind;
        self
    }

    /// Chooses what finds the pairs of shapes that may touch.
    pub fn broad_phase(mut self, kind: BroadPhaseKind) -> Self {
        self.methods.broad_phase = kind;
        self
    }

    /// Makes the world.
    ///
    /// # Panics
    /// Where [`try_build`](Self::try_build) fails.
    #[must_use]
    #[track_caller]
    pub fn build(self) -> World {
        expect(self.try_build())
    }

    /// Makes the world.
    ///
    /// # Errors
    /// Unsupported: the library was built without the kind of manifold. All else was checked when it was given.
    pub fn try_build(self) -> Result<World> {
        self.config.carry_out_by(self.methods)
    }
}
