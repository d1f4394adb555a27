//! From definitions to the engine's: everything is checked on the way, since any bits can come from C.

use super::Flag;
use super::def::*;
use super::error::text;
use crate::error::{Error, ErrorCode, Result};
use crate::world::{
    BodyDef, BodyType, Filter, MotionLocks, QueryFilter, ShapeDef, SurfaceMaterial, WorldDef,
};
use core::ffi::c_void;

/// A byte that C calls bool, checked.
pub(super) fn flag(name: &str, byte: Flag) -> Result<bool> {
    match byte {
        0 => Ok(false),
        1 => Ok(true),
        _ => Err(Error::new(ErrorCode::Range, format!("{name} is {byte}; a bool is 0 or 1."))),
    }
}

/// One of several constants, checked.
pub(super) fn choice<T: Copy>(name: &str, value: i32, all: &[T], number: impl Fn(T) -> i32) -> Result<T> {
    let found = all.iter().copied().find(|&k| number(k) == value);
    found.ok_or_else(|| {
        Error::new(
            ErrorCode::Range,
            format!("{name} is {value}; it must be one of the constants of its type."),
        )
    })
}

pub(super) fn body_type(value: mvBodyType) -> Result<BodyType> {
    choice("type", value, &[BodyType::Static, BodyType::Kinematic, BodyType::Dynamic], |k| k as i32)
}

pub(super) fn check_cookie(what: &str, value: i32, cookie: i32) -> Result<()> {
    if value == cookie {
        return Ok(());
    }
    let sentence = format!(
        "The definition was not made by mvDefault{what}Def(), or the program was compiled for another build of the library."
    );
    Err(Error::new(ErrorCode::Definition, sentence))
}

/// Pointers as the engine keeps them.
pub(super) fn to_word(p: *mut c_void) -> u64 {
    p.expose_provenance() as u64
}

pub(super) fn from_word(word: u64) -> *mut c_void {
    std::ptr::with_exposed_provenance_mut(word as usize)
}

impl mvWorldDef {
    pub(super) fn checked(&self) -> Result<WorldDef> {
        check_cookie("World", self.internal_value, WORLD_COOKIE)?;
        let def = WorldDef {
            gravity: self.gravity.raw(),
            restitution_threshold: self.restitution_threshold,
            hit_event_threshold: self.hit_event_threshold,
            contact_stiffness: self.contact_stiffness,
            contact_damping_ratio: self.contact_damping_ratio,
            contact_speed: self.contact_speed,
            maximum_linear_speed: self.maximum_linear_speed,
            enable_sleep: flag("enableSleep", self.enable_sleep)?,
            enable_warm_starting: flag("enableWarmStarting", self.enable_warm_starting)?,
            enable_load_memory: flag("enableLoadMemory", self.enable_load_memory)?,
            worker_count: self.worker_count,
            accuracy: self.accuracy,
            solver: super::kind::solver(self.solver)?,
            solver_iterations: self.solver_iterations,
            friction_facets: self.friction_facets,
            shuffle_contacts: flag("shuffleContacts", self.shuffle_contacts)?,
            over_correct: flag("overCorrect", self.over_correct)?,
            integrator: super::kind::integrator(self.integrator)?,
            broad_phase: super::kind::broad_phase(self.broad_phase)?,
            narrow_phase: super::kind::narrow_phase(self.narrow_phase)?,
            gjk: super::kind::gjk(self.gjk)?,
            manifold: super::kind::manifold(self.manifold)?,
            user_data: to_word(self.user_data),
            ..WorldDef::default()
        };
        def.validate()?;
        Ok(def)
    }
}

impl mvBodyDef {
    /// # Safety
    /// `name` is null or a zero-terminated string.
    pub(super) unsafe fn checked(&self) -> Result<BodyDef> {
        check_cookie("Body", self.internal_value, BODY_COOKIE)?;
        Ok(BodyDef {
            body_type: body_type(self.r#type)?,
            position: self.position.raw(),
            rotation: self.rotation.raw(),
            linear_velocity: self.linear_velocity.raw(),
            angular_velocity: self.angular_velocity.raw(),
            linear_damping: self.linear_damping,
            angular_damping: self.angular_damping,
            gravity_scale: self.gravity_scale,
            sleep_threshold: self.sleep_threshold,
            motion_locks: self.motion_locks.checked()?,
            enable_sleep: flag("enableSleep", self.enable_sleep)?,
            is_awake: flag("isAwake", self.is_awake)?,
            is_enabled: flag("isEnabled", self.is_enabled)?,
            // Sound: by this function's contract.
            name: unsafe { text("The body's name", self.name) }?.to_owned(),
            user_data: to_word(self.user_data),
        })
    }
}

impl mvShapeDef {
    /// # Safety
    /// `name` is null or a zero-terminated string.
    pub(super) unsafe fn checked(&self) -> Result<ShapeDef> {
        check_cookie("Shape", self.internal_value, SHAPE_COOKIE)?;
        Ok(ShapeDef {
            material: self.base_material.raw(),
            density: self.density,
            filter: self.filter.raw(),
            enable_custom_filtering: flag("enableCustomFiltering", self.enable_custom_filtering)?,
            enable_contact_events: flag("enableContactEvents", self.enable_contact_events)?,
            enable_hit_events: flag("enableHitEvents", self.enable_hit_events)?,
            enable_pre_solve_events: flag("enablePreSolveEvents", self.enable_pre_solve_events)?,
            update_body_mass: flag("updateBodyMass", self.update_body_mass)?,
            // Sound: by this function's contract.
            name: unsafe { text("The shape's name", self.name) }?.to_owned(),
            user_data: to_word(self.user_data),
        })
    }
}

impl mvMotionLocks {
    pub(super) fn checked(&self) -> Result<MotionLocks> {
        Ok(MotionLocks {
            linear: [
                flag("linearX", self.linear_x)?,
                flag("linearY", self.linear_y)?,
                flag("linearZ", self.linear_z)?,
            ],
            angular: [
                flag("angularX", self.angular_x)?,
                flag("angularY", self.angular_y)?,
                flag("angularZ", self.angular_z)?,
            ],
        })
    }
}

impl From<MotionLocks> for mvMotionLocks {
    fn from(m: MotionLocks) -> Self {
        let [linear_x, linear_y, linear_z] = m.linear.map(u8::from);
        let [angular_x, angular_y, angular_z] = m.angular.map(u8::from);
        Self { linear_x, linear_y, linear_z, angular_x, angular_y, angular_z }
    }
}

impl mvFilter {
    pub(super) fn raw(&self) -> Filter {
        Filter { category_bits: self.category_bits, mask_bits: self.mask_bits, group_index: self.group_index }
    }
}

impl From<Filter> for mvFilter {
    fn from(f: Filter) -> Self {
        Self { category_bits: f.category_bits, mask_bits: f.mask_bits, group_index: f.group_index }
    }
}

impl mvQueryFilter {
    pub(super) fn raw(&self) -> QueryFilter {
        QueryFilter { category_bits: self.category_bits, mask_bits: self.mask_bits }
    }
}

impl mvSurfaceMaterial {
    pub(super) fn raw(&self) -> SurfaceMaterial {
        SurfaceMaterial {
            friction: self.friction,
            static_friction: self.static_friction,
            restitution: self.restitution,
            rolling_resistance: self.rolling_resistance,
            tangent_velocity: self.tangent_velocity.raw(),
            user_material_id: self.user_material_id,
            custom_color: self.custom_color,
        }
    }
}

impl From<SurfaceMaterial> for mvSurfaceMaterial {
    fn from(m: SurfaceMaterial) -> Self {
        Self {
            friction: m.friction,
            static_friction: m.static_friction,
            restitution: m.restitution,
            rolling_resistance: m.rolling_resistance,
            tangent_velocity: m.tangent_velocity.into(),
            user_material_id: m.user_material_id,
            custom_color: m.custom_color,
        }
    }
}
