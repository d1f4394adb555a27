//! The C functions of merev, in a library that is put into the Python wheel.

pub use merev::capi::*;
