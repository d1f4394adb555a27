//! Constraints that persist from step to step. A contact is keyed by (shape, child) on both sides.

pub mod contact;
pub mod joint;

pub use contact::{Contact, ContactPoint, ContactStore};
pub use joint::{Joint, JointKind, JointStore};
