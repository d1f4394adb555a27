//! The C library: what `include/merev.h` declares.
//!
//! Every exported function is a thin shell: guard → look up → one call of the engine → convert. The guard turns
//! errors and panics into a code and a sentence for the calling thread ([`error`]); the look-up finds a world
//! and takes its lock without ever waiting ([`registry`]). Names are those of C, so that what the header
//! declares can be found here by searching for it. The header is made from these files by cbindgen (`xtask
//! header`); doc comments go into it word for word, so they speak to C programmers.
//!
//! This is the only room, besides `simd` and one file of `parallel`, that contains `unsafe`. What C can pass by
//! value is any bit pattern, so structs hold numbers, pointers and bytes only: booleans and enumerations are
//! checked before they become Rust's.
#![allow(non_camel_case_types, non_upper_case_globals, non_snake_case)]
// C's rules for pointers are in the header; a section for Rust callers would end up there too.
#![allow(clippy::missing_safety_doc)]
#![warn(missing_docs)]

mod access;
mod base;
mod body;
mod body_mass;
mod body_motion;
mod body_query;
mod bulk;
mod callback;
mod collide;
mod contact;
mod debug_draw;
mod def;
mod def_check;
mod distance;
mod error;
mod event;
mod geometry;
mod guard;
mod hull;
mod hull_data;
mod human;
mod id;
mod joint;
mod joint_def;
mod joint_distance;
mod joint_filter;
mod joint_gear;
mod joint_motor;
mod joint_parallel;
mod joint_prismatic;
mod joint_pulley;
mod joint_rack_pinion;
mod joint_revolute;
mod joint_screw;
mod joint_six_dof;
mod joint_spherical;
mod joint_universal;
mod joint_weld;
mod joint_wheel;
mod kind;
mod math;
mod math_fcn;
mod query;
mod registry;
mod shape;
mod shape_data;
mod shape_surface;
mod side;
mod world;
mod world_tuning;

pub use crate::math::Float as mvFloat;

/// A byte that C calls bool. From C it may have any value, so it is checked before it becomes Rust's.
/// cbindgen:ignore
pub type Flag = u8;

pub use base::*;
pub use body::*;
pub use body_mass::*;
pub use body_motion::*;
pub use body_query::*;
pub use bulk::*;
pub use collide::*;
pub use contact::*;
pub use debug_draw::*;
pub use def::*;
pub use distance::*;
pub use error::*;
pub use event::*;
pub use geometry::*;
pub use hull::*;
pub use hull_data::*;
pub use human::*;
pub use id::*;
pub use joint::*;
pub use joint_def::*;
pub use joint_distance::*;
pub use joint_filter::*;
pub use joint_gear::*;
pub use joint_motor::*;
pub use joint_parallel::*;
pub use joint_prismatic::*;
pub use joint_pulley::*;
pub use joint_rack_pinion::*;
pub use joint_revolute::*;
pub use joint_screw::*;
pub use joint_six_dof::*;
pub use joint_spherical::*;
pub use joint_universal::*;
pub use joint_weld::*;
pub use joint_wheel::*;
pub use kind::*;
pub use math::*;
pub use math_fcn::*;
pub use query::*;
pub use shape::*;
pub use shape_data::*;
pub use shape_surface::*;
pub use world::*;
pub use world_tuning::*;
