//! What is true, by ways that share nothing with an engine: closed forms, and integrations of high order, in minimal
//! coordinates or of bodies on ideal joints.

pub mod chain;
pub mod elliptic;
pub mod extrapolation;
pub mod galton;
pub mod mechanism;
pub mod rod;
pub mod statics;
pub mod top;
pub mod tops;
pub mod wheel;
