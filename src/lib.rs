//! merev: a rigid-body physics engine, used as a C library.
//!
//! The modules stand in the order in which data flows through one step of the world.

pub mod error;
pub mod math;
mod memory;
pub mod simd;

pub mod world;

pub mod body;
pub mod shape;

pub mod broad_phase;
pub mod constraint;
pub mod event;
pub mod integrate;
pub mod island;
pub mod narrow_phase;
pub mod solver;

pub mod debug_draw;

pub mod capi;

pub use error::{Error, ErrorCode, Result};
pub use math::Aabb as AABB;
pub use math::{Aabb, Float, Mat3, Pose, Quat, Vec3};
pub use shape::Shape;
pub use world::{BodyDef, BodyId, BodyType, ShapeDef, ShapeId, World, WorldDef};
pub use world::{
    ObjID, RigidBodyId, RigidBodyRef, RigidbodyBuilder, StaticBodyId, StaticbodyBuilder, StaticbodyRef,
    WorldBuilder, WorldConfig,
};
