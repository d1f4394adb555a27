//! Every tolerance of the engine, with its unit and its reason.

use super::Float;

/// Machine epsilon of [`Float`].
pub const EPSILON: Float = Float::EPSILON;

/// The least size of a shape \[m\]: radii and half extents below it are refused as degenerate. Small enough
/// for watch parts, large enough that inertia (∝ size⁵) stays a normal number in f32.
pub const MIN_SIZE: Float = 1e-5;

/// The greatest coordinate or size accepted \[m\]. Squares and cubes of it still are finite in f32.
pub const MAX_COORDINATE: Float = 1e9;
