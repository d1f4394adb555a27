//! Moving bodies forward in time.
//!
//! Free rotation is the one part of a rigid body's motion without a simple formula: angular momentum L is constant
//! in the world, but a body whose moments of inertia differ tumbles under it. [`moser_veselov`] turns the body so
//! that L *and* the energy stay what they are; [`turn_by`] is the exact turn of a body whose ω is constant.

mod free_rotation;
mod principal_axes;

pub use free_rotation::{moser_veselov, turn_by};
pub use principal_axes::{ISOTROPY, PrincipalAxes, is_isotropic};
