//! merev: a rigid-body physics engine, used as a C library.

pub mod broad_phase;
pub mod capi;
pub mod error;
pub mod math;
pub mod narrow_phase;
pub mod shape;

pub use error::{Error, ErrorCode, Result};
pub use math::{Aabb, Float, Mat3, Pose, Quat, Vec3};
