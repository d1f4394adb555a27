//! Constraints that persist from step to step. A contact is keyed by its two shapes.

pub mod contact;
pub mod joint;

pub use contact::{Contact, ContactPoint, ContactStore};
pub use joint::{Joint, JointKind, JointStore};
