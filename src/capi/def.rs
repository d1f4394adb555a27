//! Definitions: what worlds, bodies and shapes are made from.

use super::guard::neutral;
use super::id::mvShapeId;
use super::math::{IDENTITY, ORIGIN, ZERO3, mvPos, mvQuat, mvVec3};
use super::{Flag, MV_ABI_REVISION, mvFloat};
use crate::world::{BodyDef, Filter, QueryFilter, ShapeDef, SurfaceMaterial, WorldDef};
use core::ffi::{c_char, c_int, c_void};
use std::mem::size_of;

/// Category bits that match every mask.
pub const MV_DEFAULT_CATEGORY_BITS: u64 = 0xffff_ffff_ffff_ffff;
/// Mask bits that accept every category.
pub const MV_DEFAULT_MASK_BITS: u64 = 0xffff_ffff_ffff_ffff;

/// How a body moves: one of mv_staticBody, mv_kinematicBody, mv_dynamicBody.
pub type mvBodyType = i32;
/// Never moves by itself; nothing pushes it.
pub const mv_staticBody: mvBodyType = 0;
/// Moves with the velocity it is given; nothing pushes it.
pub const mv_kinematicBody: mvBodyType = 1;
/// Moves by forces and contacts.
pub const mv_dynamicBody: mvBodyType = 2;

/// The solver of contacts: one of the mv_solver... constants.
pub type mvSolverKind = i32;
/// What the library thinks best.
pub const mv_solver_auto: mvSolverKind = 0;

/// How bodies are moved through a sub-step: one of the mv_integrator... constants.
pub type mvIntegratorKind = i32;
/// What the library thinks best.
pub const mv_integrator_auto: mvIntegratorKind = 0;

/// How pairs of close shapes are found: one of the mv_broadPhase... constants. All find the same pairs.
pub type mvBroadPhaseKind = i32;
/// What the library thinks best.
pub const mv_broadPhase_auto: mvBroadPhaseKind = 0;

/// How contact points of two shapes are found: one of the mv_narrowPhase... constants.
pub type mvNarrowPhaseKind = i32;
/// What the library thinks best.
pub const mv_narrowPhase_auto: mvNarrowPhaseKind = 0;

/// How the search for the distance of two shapes looks at simplices: one of the mv_gjk... constants. All find the same
/// distance, up to rounding.
pub type mvGjkKind = i32;
/// What the library thinks best.
pub const mv_gjk_auto: mvGjkKind = 0;

/// How contact points are found where faces meet: one of the mv_manifold... constants.
pub type mvManifoldKind = i32;
/// What the library thinks best.
pub const mv_manifold_auto: mvManifoldKind = 0;

/// Decides whether two shapes may collide. Asked on the stepping thread, when their boxes meet and one of them has
/// enableCustomFiltering. The world may be read but not changed.
///
/// @return false to let them pass through each other
pub type mvCustomFilterFcn =
    Option<unsafe extern "C" fn(shapeIdA: mvShapeId, shapeIdB: mvShapeId, context: *mut c_void) -> Flag>;

/// Decides whether a contact acts in this step. Asked on the stepping thread, in every step in which the shapes
/// touch or nearly do and one of them has enablePreSolveEvents. The world may be read but not changed.
///
/// @param point one of the points of contact
/// @param normal from shape A to shape B, of length 1
/// @return false to let the shapes pass through each other in this step
pub type mvPreSolveFcn = Option<
    unsafe extern "C" fn(
        shapeIdA: mvShapeId,
        shapeIdB: mvShapeId,
        point: mvPos,
        normal: mvVec3,
        context: *mut c_void,
    ) -> Flag,
>;

/// Mixes the friction of two materials: called for every contact in every step, on the stepping thread, once for
/// sliding and once for static friction. A result that is not a number >= 0 counts as 0.
pub type mvFrictionCallback = Option<
    unsafe extern "C" fn(
        frictionA: mvFloat,
        userMaterialIdA: u64,
        frictionB: mvFloat,
        userMaterialIdB: u64,
        context: *mut c_void,
    ) -> mvFloat,
>;

/// Mixes the restitution of two materials: called for every contact in every step, on the stepping thread. A result
/// that is not a number from 0 to 1 is moved there.
pub type mvRestitutionCallback = Option<
    unsafe extern "C" fn(
        restitutionA: mvFloat,
        userMaterialIdA: u64,
        restitutionB: mvFloat,
        userMaterialIdB: u64,
        context: *mut c_void,
    ) -> mvFloat,
>;

/// What a world is made from. Made by mvDefaultWorldDef().
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvWorldDef {
    /// Shows that the definition was made by its function. Leave it alone.
    pub internal_value: i32,
    /// Gravity [m/s^2]; default (0, -10, 0).
    pub gravity: mvVec3,
    /// Collisions up to this approach speed do not bounce [m/s], >= 0; default 0.1.
    pub restitution_threshold: mvFloat,
    /// Collisions above this approach speed make hit events [m/s], >= 0; default 1.
    pub hit_event_threshold: mvFloat,
    /// How stiff contacts are against overlap, as a fraction of the sub-step rate, > 0 and at most 0.5; default 0.21.
    pub contact_stiffness: mvFloat,
    /// How strongly the recovery of overlap is damped, > 0; 1 is critical; default 0.5.
    pub contact_damping_ratio: mvFloat,
    /// The greatest speed at which overlap is pushed out [m/s], >= 0; default 3.
    pub contact_speed: mvFloat,
    /// The greatest speed of a body [m/s], > 0; default infinity, no limit.
    pub maximum_linear_speed: mvFloat,
    /// Mixes friction instead of the default, the geometric mean; may be null.
    pub friction_callback: mvFrictionCallback,
    /// Passed to frictionCallback.
    pub friction_context: *mut c_void,
    /// Mixes restitution instead of the default, the greater one; may be null.
    pub restitution_callback: mvRestitutionCallback,
    /// Passed to restitutionCallback.
    pub restitution_context: *mut c_void,
    /// Whether bodies at rest fall asleep; default true.
    pub enable_sleep: Flag,
    /// Whether contact impulses are kept from step to step; default true. Off is for experiments.
    pub enable_warm_starting: Flag,
    /// Whether steady loads are remembered, so that stacks rest without overlap; default true. Off is for experiments.
    pub enable_load_memory: Flag,
    /// How many threads step the world. Only 1, the default, is built yet.
    pub worker_count: u32,
    /// Anything: mvWorld_GetUserData().
    pub user_data: *mut c_void,
    /// The error that a step may add to the motion, as a share of the way gone in it, 0 to 1; default 0: exactly the
    /// sub-steps asked for. Otherwise they are the least, and an island gets two, four, ... 32 times as many where that
    /// is needed and helps: for swinging, spinning and springy things. Only with the solver softStep.
    pub accuracy: mvFloat,
    /// The contact solver; default mv_solver_auto.
    pub solver: mvSolverKind,
    /// The sweeps of each sub-step of the solvers sequentialImpulse and projectedGaussSeidel, at most 10000; default 0:
    /// the step is not divided, and has as many sweeps as it was to have sub-steps.
    pub solver_iterations: u32,
    /// The corners of the friction pyramids of the solvers lemke and dantzig (which makes them even), 3 to 64;
    /// default 8.
    pub friction_facets: u32,
    /// Whether sequentialImpulse visits the points in another order in every iteration; default true.
    pub shuffle_contacts: Flag,
    /// Whether the first iterations of sequentialImpulse correct by more than is missing; default false.
    pub over_correct: Flag,
    /// The integrator; default mv_integrator_auto.
    pub integrator: mvIntegratorKind,
    /// The broad phase; default mv_broadPhase_auto.
    pub broad_phase: mvBroadPhaseKind,
    /// The narrow phase; default mv_narrowPhase_auto.
    pub narrow_phase: mvNarrowPhaseKind,
    /// How the narrow phase looks at simplices; default mv_gjk_auto.
    pub gjk: mvGjkKind,
    /// How contact points are found where faces meet; default mv_manifold_auto.
    pub manifold: mvManifoldKind,
}

/// Directions in which a body cannot move, in world axes.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvMotionLocks {
    /// No translation along x.
    pub linear_x: Flag,
    /// No translation along y.
    pub linear_y: Flag,
    /// No translation along z.
    pub linear_z: Flag,
    /// No rotation about x.
    pub angular_x: Flag,
    /// No rotation about y.
    pub angular_y: Flag,
    /// No rotation about z.
    pub angular_z: Flag,
}

/// What a body is made from. Made by mvDefaultBodyDef().
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvBodyDef {
    /// Shows that the definition was made by its function. Leave it alone.
    pub internal_value: i32,
    /// How the body moves; default mv_staticBody.
    pub r#type: mvBodyType,
    /// The position of the body's origin [m].
    pub position: mvPos,
    /// The rotation of the body, of length 1.
    pub rotation: mvQuat,
    /// The velocity of the body's origin [m/s].
    pub linear_velocity: mvVec3,
    /// The angular velocity, in world axes [rad/s].
    pub angular_velocity: mvVec3,
    /// The fraction of the velocity lost per second, for small values [1/s], >= 0; default 0.
    pub linear_damping: mvFloat,
    /// The fraction of the angular velocity lost per second, for small values [1/s], >= 0; default 0.
    pub angular_damping: mvFloat,
    /// A factor on gravity; default 1.
    pub gravity_scale: mvFloat,
    /// The body may fall asleep below this speed [m/s], >= 0; default 0.05.
    pub sleep_threshold: mvFloat,
    /// A name for people, in UTF-8; null for none. Copied.
    pub name: *const c_char,
    /// Anything: mvBody_GetUserData().
    pub user_data: *mut c_void,
    /// Directions in which the body cannot move; none by default.
    pub motion_locks: mvMotionLocks,
    /// Whether the body may fall asleep; default true.
    pub enable_sleep: Flag,
    /// Whether the body starts awake; default true.
    pub is_awake: Flag,
    /// Whether the body takes part at all; default true.
    pub is_enabled: Flag,
}

/// Which shapes collide: each one's mask must hold a category of the other, unless they share a group.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct mvFilter {
    /// What the shape is; default all bits.
    pub category_bits: u64,
    /// What the shape collides with; default all bits.
    pub mask_bits: u64,
    /// Shapes of one group other than 0 always collide if it is positive, and never if it is negative.
    pub group_index: c_int,
}

/// Which shapes a query sees: its mask must hold a category of the shape and the shape's mask one of the query.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct mvQueryFilter {
    /// What the query is; default all bits.
    pub category_bits: u64,
    /// What the query sees; default all bits.
    pub mask_bits: u64,
}

/// What a surface does in contact.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct mvSurfaceMaterial {
    /// The coefficient of sliding friction, >= 0; default 0.6. A pair has the geometric mean.
    pub friction: mvFloat,
    /// The coefficient of static friction; negative, the default, means that of sliding. A pair has the geometric mean.
    pub static_friction: mvFloat,
    /// The coefficient of restitution, 0 to 1; default 0. A pair has the greater one.
    pub restitution: mvFloat,
    /// The resistance to rolling, as a fraction of the radius by which the pressure is ahead, >= 0; default 0. A pair
    /// has the greater one.
    pub rolling_resistance: mvFloat,
    /// The velocity of the surface as that of a conveyor belt, in the body's frame [m/s].
    pub tangent_velocity: mvVec3,
    /// Anything; passed to mixing callbacks and given with hits.
    pub user_material_id: u64,
    /// A colour for drawing, 0xRRGGBB; 0 means none.
    pub custom_color: u32,
}

/// What a shape is made from, besides its geometry. Made by mvDefaultShapeDef().
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvShapeDef {
    /// Shows that the definition was made by its function. Leave it alone.
    pub internal_value: i32,
    /// A name for people, in UTF-8; null for none. Copied.
    pub name: *const c_char,
    /// Anything: mvShape_GetUserData().
    pub user_data: *mut c_void,
    /// The surface.
    pub base_material: mvSurfaceMaterial,
    /// The density [kg/m^3], >= 0; default 1000.
    pub density: mvFloat,
    /// What the shape collides with; default everything.
    pub filter: mvFilter,
    /// Whether the custom filter callback is asked about this shape; default false.
    pub enable_custom_filtering: Flag,
    /// Whether contacts of this shape make begin and end events; one of the two shapes is enough; default true.
    pub enable_contact_events: Flag,
    /// Whether contacts of this shape make hit events; one of the two shapes is enough; default false.
    pub enable_hit_events: Flag,
    /// Whether the pre-solve callback is asked about contacts of this shape; default false.
    pub enable_pre_solve_events: Flag,
    /// Whether making the shape updates the mass of its body; default true.
    pub update_body_mass: Flag,
}

/// What stands in a definition's internalValue: it mixes the struct's size, the precision and the ABI revision with
/// what the definition is for.
pub(super) const fn cookie<T>(purpose: u32) -> i32 {
    let mut h = 0x811c_9dc5 ^ purpose;
    let facts = [size_of::<T>() as u32, size_of::<mvFloat>() as u32, MV_ABI_REVISION as u32];
    let mut k = 0;
    while k < facts.len() {
        h = (h ^ facts[k]).wrapping_mul(0x0100_0193).rotate_left(7);
        k += 1;
    }
    h as i32
}

pub(super) const WORLD_COOKIE: i32 = cookie::<mvWorldDef>(1);
pub(super) const BODY_COOKIE: i32 = cookie::<mvBodyDef>(2);
pub(super) const SHAPE_COOKIE: i32 = cookie::<mvShapeDef>(3);

neutral! {
    mvFilter = mvFilter { category_bits: 0, mask_bits: 0, group_index: 0 };
    mvQueryFilter = mvQueryFilter { category_bits: 0, mask_bits: 0 };
    mvMotionLocks = mvMotionLocks { linear_x: 0, linear_y: 0, linear_z: 0, angular_x: 0, angular_y: 0, angular_z: 0 };
    mvSurfaceMaterial = mvSurfaceMaterial {
        friction: 0.0,
        static_friction: 0.0,
        restitution: 0.0,
        rolling_resistance: 0.0,
        tangent_velocity: ZERO3,
        user_material_id: 0,
        custom_color: 0,
    };
}

/// Get a world definition with the default values.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultWorldDef() -> mvWorldDef {
    let d = WorldDef::default();
    mvWorldDef {
        internal_value: WORLD_COOKIE,
        gravity: d.gravity.into(),
        restitution_threshold: d.restitution_threshold,
        hit_event_threshold: d.hit_event_threshold,
        contact_stiffness: d.contact_stiffness,
        contact_damping_ratio: d.contact_damping_ratio,
        contact_speed: d.contact_speed,
        maximum_linear_speed: d.maximum_linear_speed,
        friction_callback: None,
        friction_context: std::ptr::null_mut(),
        restitution_callback: None,
        restitution_context: std::ptr::null_mut(),
        enable_sleep: d.enable_sleep.into(),
        enable_warm_starting: d.enable_warm_starting.into(),
        enable_load_memory: d.enable_load_memory.into(),
        worker_count: d.worker_count,
        user_data: std::ptr::null_mut(),
        accuracy: d.accuracy,
        solver: mv_solver_auto,
        solver_iterations: d.solver_iterations,
        friction_facets: d.friction_facets,
        shuffle_contacts: d.shuffle_contacts.into(),
        over_correct: d.over_correct.into(),
        integrator: mv_integrator_auto,
        broad_phase: mv_broadPhase_auto,
        narrow_phase: mv_narrowPhase_auto,
        gjk: mv_gjk_auto,
        manifold: mv_manifold_auto,
    }
}

/// Get a body definition with the default values: a static body at the origin.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultBodyDef() -> mvBodyDef {
    let d = BodyDef::default();
    mvBodyDef {
        internal_value: BODY_COOKIE,
        r#type: d.body_type as i32,
        position: ORIGIN,
        rotation: IDENTITY,
        linear_velocity: ZERO3,
        angular_velocity: ZERO3,
        linear_damping: d.linear_damping,
        angular_damping: d.angular_damping,
        gravity_scale: d.gravity_scale,
        sleep_threshold: d.sleep_threshold,
        name: std::ptr::null(),
        user_data: std::ptr::null_mut(),
        motion_locks: d.motion_locks.into(),
        enable_sleep: d.enable_sleep.into(),
        is_awake: d.is_awake.into(),
        is_enabled: d.is_enabled.into(),
    }
}

/// Get a shape definition with the default values.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultShapeDef() -> mvShapeDef {
    let d = ShapeDef::default();
    mvShapeDef {
        internal_value: SHAPE_COOKIE,
        name: std::ptr::null(),
        user_data: std::ptr::null_mut(),
        base_material: d.material.into(),
        density: d.density,
        filter: d.filter.into(),
        enable_custom_filtering: d.enable_custom_filtering.into(),
        enable_contact_events: d.enable_contact_events.into(),
        enable_hit_events: d.enable_hit_events.into(),
        enable_pre_solve_events: d.enable_pre_solve_events.into(),
        update_body_mass: d.update_body_mass.into(),
    }
}

/// Get the filter that collides with everything.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultFilter() -> mvFilter {
    Filter::default().into()
}

/// Get the query filter that sees everything.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultQueryFilter() -> mvQueryFilter {
    let d = QueryFilter::default();
    mvQueryFilter { category_bits: d.category_bits, mask_bits: d.mask_bits }
}

/// Get the default surface.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultSurfaceMaterial() -> mvSurfaceMaterial {
    SurfaceMaterial::default().into()
}
