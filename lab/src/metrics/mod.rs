//! Rulers: what can be read off a run, whichever engine made it.

mod laws;
mod signals;

pub use laws::{angular_momentum, energy, energy_change, kinetic, momentum};
pub use signals::{apexes, crossings};
