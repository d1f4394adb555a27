//! Definitions: what a world, a body and an attached shape are made from.

use crate::broad_phase::BroadPhaseKind;
use crate::error::{Error, ErrorCode, Result, check};
use crate::integrate::IntegratorKind;
use crate::math::{Float, Quat, Vec3, vec3};
use crate::narrow_phase::{GjkKind, ManifoldKind, Methods, NarrowPhaseKind};
use crate::solver::{Lanes, SolverKind};

/// How a body moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[repr(i32)]
pub enum BodyType {
    /// Never moves by itself; infinite mass.
    #[default]
    Static = 0,
    /// Moves with the velocity it is given; infinite mass.
    Kinematic = 1,
    /// Moves by forces and contacts.
    Dynamic = 2,
}

/// Which directions of motion a body lacks, in world axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct MotionLocks {
    /// No translation along x, y, z.
    pub linear: [bool; 3],
    /// No rotation about x, y, z.
    pub angular: [bool; 3],
}

impl MotionLocks {
    /// Whether any direction is locked.
    #[must_use]
    pub fn any(self) -> bool {
        self != Self::default()
    }
}

/// What a world is made from.
#[derive(Clone, Debug, PartialEq)]
pub struct WorldDef {
    /// \[m/s²\], default (0, −10, 0).
    pub gravity: Vec3,
    /// Approach speeds up to this do not bounce \[m/s\]; default 0.1, 0 is allowed.
    pub restitution_threshold: Float,
    /// Approach speeds above this make hit events \[m/s\]; default 1.
    pub hit_event_threshold: Float,
    /// Contact stiffness as a share of the sub-step rate; default 0.21 (twice that against static bodies). (0, 0.5]
    pub contact_stiffness: Float,
    /// Damping ratio of the contacts' overlap recovery; default 0.5, > 0.
    pub contact_damping_ratio: Float,
    /// Greatest speed at which overlap is pushed out \[m/s\]; default 3.
    pub contact_speed: Float,
    /// Greatest speed of a body \[m/s\]; default ∞: no clamp.
    pub maximum_linear_speed: Float,
    /// Whether bodies at rest fall asleep; default true.
    pub enable_sleep: bool,
    /// Whether impulses are kept from step to step; default true. Off is for experiments.
    pub enable_warm_starting: bool,
    /// Whether steady loads are remembered so that they need no overlap; default true.
    pub enable_load_memory: bool,
    /// Number of threads that step the world; default 1. Only 1 is built yet.
    pub worker_count: u32,
    /// The error that a step may add to the motion, as a share of the way gone in it, 0 … 1; default 0: exactly the
    /// sub-steps asked for. Otherwise they are the least, and an island gets two, four, … 32 times as many where
    /// that is needed and helps, see [`crate::island::pacing`]. Only with the solver soft_step.
    pub accuracy: Float,
    /// The contact solver; default auto.
    pub solver: SolverKind,
    /// Sweeps a sub-step of the solvers sequential_impulse and projected_gauss_seidel, at most 10 000; default 0: the
    /// step is then not divided, and has as many sweeps as it was to have sub-steps, as in the thesis.
    pub solver_iterations: u32,
    /// Corners of the friction pyramids of the solvers lemke and dantzig (which makes them even), 3 … 64; default 8.
    pub friction_facets: u32,
    /// Whether sequential_impulse visits the points in another order in every iteration; default true.
    pub shuffle_contacts: bool,
    /// Whether the first iterations of sequential_impulse correct by more than is missing; default false.
    pub over_correct: bool,
    /// How bodies move through a sub-step; default auto.
    pub integrator: IntegratorKind,
    /// The broad phase; default auto.
    pub broad_phase: BroadPhaseKind,
    /// The narrow phase; default auto.
    pub narrow_phase: NarrowPhaseKind,
    /// How GJK looks at simplices, where the narrow phase asks it; default auto.
    pub gjk: GjkKind,
    /// How contact points are found where faces meet; default auto.
    pub manifold: ManifoldKind,
    /// How many constraints are solved side by side; every width gives the same bits. Default auto.
    pub lanes: Lanes,
    /// Anything.
    pub user_data: u64,
}

impl Default for WorldDef {
    fn default() -> Self {
        Self {
            gravity: vec3(0.0, -10.0, 0.0),
            restitution_threshold: 0.1,
            hit_event_threshold: 1.0,
            contact_stiffness: 0.21,
            contact_damping_ratio: 0.5,
            contact_speed: 3.0,
            maximum_linear_speed: Float::INFINITY,
            enable_sleep: true,
            enable_warm_starting: true,
            enable_load_memory: true,
            worker_count: 1,
            accuracy: 0.0,
            solver: SolverKind::Auto,
            solver_iterations: 0,
            friction_facets: 8,
            shuffle_contacts: true,
            over_correct: false,
            integrator: IntegratorKind::Auto,
            broad_phase: BroadPhaseKind::Auto,
            narrow_phase: NarrowPhaseKind::Auto,
            gjk: GjkKind::Auto,
            manifold: ManifoldKind::Auto,
            lanes: Lanes::Auto,
            user_data: 0,
        }
    }
}

impl WorldDef {
    /// The choices of the narrow phase.
    pub(crate) fn methods(&self) -> Methods {
        Methods { kind: self.narrow_phase, gjk: self.gjk, manifold: self.manifold }
    }

    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        check::finite_vec("gravity", self.gravity)?;
        check::not_negative("restitution_threshold", self.restitution_threshold)?;
        check::not_negative("hit_event_threshold", self.hit_event_threshold)?;
        check::within("contact_stiffness", self.contact_stiffness, 1e-6, 0.5)?;
        check::positive("contact_damping_ratio", self.contact_damping_ratio)?;
        check::not_negative("contact_speed", self.contact_speed)?;
        speed_limit(self.maximum_linear_speed)?;
        check::count("solver_iterations", self.solver_iterations, 0, 10_000)?;
        check::count("friction_facets", self.friction_facets, 3, 64)?;
        if self.worker_count != 1 {
            return Err(Error::new(
                ErrorCode::Unsupported,
                "worker_count must be 1: more threads are not built yet.",
            ));
        }
        if !self.manifold.is_built() {
            return Err(Error::new(
                ErrorCode::Unsupported,
                "This library was built without the feature clipper2: manifold must be another kind.",
            ));
        }
        let is_soft_step = self.solver.resolved() == SolverKind::SoftStep;
        if check::within("accuracy", self.accuracy, 0.0, 1.0)? != 0.0 && !is_soft_step {
            return Err(Error::new(
                ErrorCode::Unsupported,
                "accuracy must be 0 with this solver: error control is built for soft_step.",
            ));
        }
        Ok(())
    }
}

/// A speed limit: positive, possibly infinite.
pub(crate) fn speed_limit(x: Float) -> Result<Float> {
    if x > 0.0 {
        Ok(x)
    } else {
        Err(Error::new(ErrorCode::Range, format!("The speed limit is {x}; it must be greater than 0.")))
    }
}

/// What a body is made from.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyDef {
    /// How it moves; default static.
    pub body_type: BodyType,
    /// The body's origin in the world \[m\].
    pub position: Vec3,
    /// The body's axes in the world.
    pub rotation: Quat,
    /// Velocity of the origin \[m/s\].
    pub linear_velocity: Vec3,
    /// \[rad/s\]
    pub angular_velocity: Vec3,
    /// Share of the speed lost per second, small values: v ← v / (1 + h·c). ≥ 0, default 0.
    pub linear_damping: Float,
    /// The same for the rotation. ≥ 0, default 0.
    pub angular_damping: Float,
    /// Factor on gravity; default 1.
    pub gravity_scale: Float,
    /// Below this speed a body may fall asleep \[m/s\]; default 0.05, ≥ 0.
    pub sleep_threshold: Float,
    /// Directions it cannot move in.
    pub motion_locks: MotionLocks,
    /// Whether it may fall asleep; default true.
    pub enable_sleep: bool,
    /// Whether it starts awake; default true.
    pub is_awake: bool,
    /// Whether it takes part at all; default true.
    pub is_enabled: bool,
    /// A name for people.
    pub name: String,
    /// Anything.
    pub user_data: u64,
}

impl Default for BodyDef {
    fn default() -> Self {
        Self {
            body_type: BodyType::Static,
            position: Vec3::zeros(),
            rotation: Quat::identity(),
            linear_velocity: Vec3::zeros(),
            angular_velocity: Vec3::zeros(),
            linear_damping: 0.0,
            angular_damping: 0.0,
            gravity_scale: 1.0,
            sleep_threshold: 0.05,
            motion_locks: MotionLocks::default(),
            enable_sleep: true,
            is_awake: true,
            is_enabled: true,
            name: String::new(),
            user_data: 0,
        }
    }
}

impl BodyDef {
    /// A dynamic body at `position`.
    #[must_use]
    pub fn dynamic(position: Vec3) -> Self {
        Self { body_type: BodyType::Dynamic, position, ..Self::default() }
    }

    /// A static body at `position`.
    #[must_use]
    pub fn fixed(position: Vec3) -> Self {
        Self { position, ..Self::default() }
    }

    /// A kinematic body at `position`.
    #[must_use]
    pub fn kinematic(position: Vec3) -> Self {
        Self { body_type: BodyType::Kinematic, position, ..Self::default() }
    }

    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        check::point("position", self.position)?;
        check::rotation("rotation", self.rotation)?;
        check::point("linear_velocity", self.linear_velocity)?;
        check::point("angular_velocity", self.angular_velocity)?;
        check::not_negative("linear_damping", self.linear_damping)?;
        check::not_negative("angular_damping", self.angular_damping)?;
        check::finite("gravity_scale", self.gravity_scale)?;
        check::not_negative("sleep_threshold", self.sleep_threshold)?;
        Ok(())
    }
}

/// Which shapes collide: both masks must hold the other's category, unless they share a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Filter {
    /// What the shape is.
    pub category_bits: u64,
    /// What it collides with.
    pub mask_bits: u64,
    /// Two shapes of the same group ≠ 0 always (> 0) or never (< 0) collide.
    pub group_index: i32,
}

impl Default for Filter {
    fn default() -> Self {
        Self { category_bits: u64::MAX, mask_bits: u64::MAX, group_index: 0 }
    }
}

impl Filter {
    /// Whether shapes with these filters collide.
    #[must_use]
    pub fn collides(&self, other: &Filter) -> bool {
        if self.group_index == other.group_index && self.group_index != 0 {
            return self.group_index > 0;
        }
        self.mask_bits & other.category_bits != 0 && self.category_bits & other.mask_bits != 0
    }
}

/// Which shapes a query sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct QueryFilter {
    /// What the query is.
    pub category_bits: u64,
    /// What it sees.
    pub mask_bits: u64,
}

impl Default for QueryFilter {
    fn default() -> Self {
        Self { category_bits: u64::MAX, mask_bits: u64::MAX }
    }
}

impl QueryFilter {
    /// Whether the query sees a shape with this filter.
    #[must_use]
    pub fn sees(&self, shape: &Filter) -> bool {
        self.mask_bits & shape.category_bits != 0 && self.category_bits & shape.mask_bits != 0
    }
}

/// What a surface does in contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceMaterial {
    /// Sliding friction coefficient, ≥ 0; default 0.6. A pair has √(ab).
    pub friction: Float,
    /// Static friction coefficient; negative, the default, means the sliding one. A pair has √(ab).
    pub static_friction: Float,
    /// Coefficient of restitution, 0 … 1; default 0. A pair has the greater one.
    pub restitution: Float,
    /// Rolling resistance, the lever of the pressure ahead of the contact as a share of the radius, ≥ 0; default 0.
    /// A pair has the greater one.
    pub rolling_resistance: Float,
    /// Velocity of the surface as on a conveyor, in the shape's body frame \[m/s\].
    pub tangent_velocity: Vec3,
    /// Passed to callbacks.
    pub user_material_id: u64,
    /// 0xRRGGBB for debug draw; 0 means none.
    pub custom_color: u32,
}

impl Default for SurfaceMaterial {
    fn default() -> Self {
        Self {
            friction: 0.6,
            static_friction: -1.0,
            restitution: 0.0,
            rolling_resistance: 0.0,
            tangent_velocity: Vec3::zeros(),
            user_material_id: 0,
            custom_color: 0,
        }
    }
}

impl SurfaceMaterial {
    /// The static coefficient, with the default resolved.
    #[must_use]
    pub fn resolved_static_friction(&self) -> Float {
        if self.static_friction < 0.0 { self.friction } else { self.static_friction }
    }

    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        check::not_negative("friction", self.friction)?;
        check::finite("static_friction", self.static_friction)?;
        check::within("restitution", self.restitution, 0.0, 1.0)?;
        check::not_negative("rolling_resistance", self.rolling_resistance)?;
        check::point("tangent_velocity", self.tangent_velocity)?;
        Ok(())
    }
}

/// What an attached shape is made from, besides its geometry.
#[derive(Clone, Debug, PartialEq)]
pub struct ShapeDef {
    /// The surface.
    pub material: SurfaceMaterial,
    /// \[kg/m³\], ≥ 0; default 1000.
    pub density: Float,
    /// What it collides with.
    pub filter: Filter,
    /// Whether the custom filter callback is asked about this shape; default false.
    pub enable_custom_filtering: bool,
    /// Whether contacts of this shape make begin and end events (either shape is enough); default true.
    pub enable_contact_events: bool,
    /// Whether contacts of this shape make hit events (either shape is enough); default false.
    pub enable_hit_events: bool,
    /// Whether the pre-solve callback is asked about contacts of this shape; default false.
    pub enable_pre_solve_events: bool,
    /// Whether attaching it updates the body's mass; default true.
    pub update_body_mass: bool,
    /// A name for people.
    pub name: String,
    /// Anything.
    pub user_data: u64,
}

impl Default for ShapeDef {
    fn default() -> Self {
        Self {
            material: SurfaceMaterial::default(),
            density: 1000.0,
            filter: Filter::default(),
            enable_custom_filtering: false,
            enable_contact_events: true,
            enable_hit_events: false,
            enable_pre_solve_events: false,
            update_body_mass: true,
            name: String::new(),
            user_data: 0,
        }
    }
}

impl ShapeDef {
    /// Checks every field.
    pub fn validate(&self) -> Result<()> {
        self.material.validate()?;
        check::not_negative("density", self.density)?;
        Ok(())
    }
}
