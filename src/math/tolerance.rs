//! Every tolerance of the engine, with its unit and its reason.

use super::Float;

/// Machine epsilon of [`Float`].
pub const EPSILON: Float = Float::EPSILON;

/// The least size of a shape \[m\]: radii and half extents below it are refused as degenerate. Small enough
/// for watch parts, large enough that inertia (∝ size⁵) stays a normal number in f32.
pub const MIN_SIZE: Float = 1e-5;

/// The greatest coordinate or size accepted \[m\]. Squares and cubes of it still are finite in f32.
pub const MAX_COORDINATE: Float = 1e9;

/// How far a point may stand out of a hull's face and still count as lying in it, as a share of the sum of the
/// largest |coordinates| along the three axes. Input points carry half an ulp of rounding each, a rotation applied by
/// the caller a few more. The hull is built in double: with double input its own rounding, on thin triangles, is what
/// counts.
pub const HULL_FLATNESS: f64 = if cfg!(feature = "f64") { 4e-12 } else { 4.0 * f32::EPSILON as f64 };

/// By how much of the thinner shape's inner radius an edge–edge axis must beat the best face axis. Without it
/// a box that rocks by a hair would trade its four-point face manifold for a single point, back and forth.
pub const EDGE_PREFERENCE: Float = 1e-3;

/// The same for face B against face A: equal in the commonest case of all, two boxes face to face.
pub const FACE_PREFERENCE: Float = 5e-4;

/// The share of the depth that an edge axis or face B must win on top: deep overlaps rock more.
pub const DEPTH_PREFERENCE: Float = 0.02;

/// Two edges whose directions have a sine below this are parallel: their cross product is rounding, and a face
/// axis says the same better.
pub const PARALLEL_SINE: Float = 2e-3;

/// Contact points whose separations differ by less than this share of the contact's extent are equally deep:
/// which of them is kept must not depend on rounding.
pub const EQUAL_DEPTH: Float = 1e-4;

/// The relative gain in squared distance that GJK must still make to go on. The sub-algorithm computes in
/// double in both builds, so this is far above its rounding and far below that of f32 results.
pub const GJK_PROGRESS: f64 = 1e-13;

/// Below this share of the largest core coordinate, squared, the distance of two cores is zero: closer than that
/// the direction between them would be rounding, and EPA knows the normal better.
pub const GJK_TOUCH: f64 = 1e-20;

/// EPA ends when a new support point would move the depth by less than this share of the scale.
pub const EPA_PROGRESS: f64 = 1e-11;

/// A cast has arrived when the gap is below this share of the pair's size.
pub const CAST_ARRIVAL: f64 = 1e-7;

/// How long an island has to be slow before it falls asleep \[s\].
pub const TIME_TO_SLEEP: Float = 0.5;

/// Fat boxes exceed what they hold by this share of the shape's inner radius: a body that moves by less than
/// that makes no work for the broad phase.
pub const FAT_MARGIN: Float = 0.1;

/// Contact points exist up to a gap of this share of the shape's inner radius, besides what the bodies may move
/// towards each other in the step: enough that a resting body's points never flicker.
pub const CONTACT_MARGIN: Float = 0.02;

/// Shapes farther apart than this share of the smaller inner radius, which would meet in the step, are asked whether
/// they do: corners may fly past each other. What rests is nearer by far.
pub const PASSING_GAP: Float = 1e-3;

/// Shapes cease to touch, for the events, at a gap of this share of the inner radius: wider than rounding, so
/// that a resting contact does not end and begin.
pub const TOUCH_MARGIN: Float = 1e-3;

/// A contact point without a known feature is taken for an old one that is nearer than this share of the inner
/// radius: more than a body at rest moves in a step, less than the distance of two points of a manifold.
pub const SAME_PLACE: Float = 0.1;
