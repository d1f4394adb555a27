//! What can go wrong, with a number for C and a sentence for people.

use std::borrow::Cow;
use std::fmt;

/// The kind of a failure. The numbers are part of the C ABI and never reused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum ErrorCode {
    /// An id or a pointer is null.
    Null = 1,
    /// The id's object was destroyed.
    Stale = 2,
    /// The id belongs to another world.
    Foreign = 3,
    /// A definition was not made by its `default` function, or by another version of the library.
    Definition = 4,
    /// A number is NaN or infinite.
    NotFinite = 5,
    /// A value lies outside its stated range.
    Range = 6,
    /// Geometry without volume, direction or size.
    Degenerate = 7,
    /// The world is inside a step or a query: a callback must not change it.
    Locked = 8,
    /// Another thread is using the world.
    Busy = 9,
    /// A stated capacity is exhausted.
    Capacity = 10,
    /// A known choice that is not built.
    Unsupported = 11,
    /// An internal fault was caught earlier; the world can only be destroyed.
    Faulted = 12,
    /// An internal fault was caught now.
    Internal = 13,
}

/// A failure: its kind and one sentence that says what was wrong and what would be right.
#[derive(Clone, Debug, PartialEq)]
pub struct Error {
    code: ErrorCode,
    sentence: Cow<'static, str>,
}

/// The result of every fallible call.
pub type Result<T, E = Error> = std::result::Result<T, E>;

impl Error {
    /// An error of this kind with this sentence.
    pub fn new(code: ErrorCode, sentence: impl Into<Cow<'static, str>>) -> Self {
        Self { code, sentence: sentence.into() }
    }

    /// The kind.
    #[must_use]
    pub fn code(&self) -> ErrorCode {
        self.code
    }

    /// The sentence.
    #[must_use]
    pub fn sentence(&self) -> &str {
        &self.sentence
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.sentence)
    }
}

impl std::error::Error for Error {}

/// The value, or a panic with the error's sentence: for the plain twins of calls named `try_…`.
#[track_caller]
pub(crate) fn expect<T>(result: Result<T>) -> T {
    match result {
        Ok(value) => value,
        Err(error) => panic!("{error}"),
    }
}

/// Checks that are written again and again at the API's edge.
pub(crate) mod check {
    use super::{Error, ErrorCode, Result};
    use crate::math::{Float, Pose, Quat, Vec3, is_finite, tolerance::MAX_COORDINATE};

    /// A finite scalar.
    pub fn finite(name: &str, x: Float) -> Result<Float> {
        if x.is_finite() {
            Ok(x)
        } else {
            Err(Error::new(ErrorCode::NotFinite, format!("{name} is {x}; it must be finite.")))
        }
    }

    /// A finite vector.
    pub fn finite_vec(name: &str, v: Vec3) -> Result<Vec3> {
        if is_finite(v) {
            Ok(v)
        } else {
            let (x, y, z) = (v.x, v.y, v.z);
            Err(Error::new(ErrorCode::NotFinite, format!("{name} is ({x}, {y}, {z}); it must be finite.")))
        }
    }

    /// A finite point within ±[`MAX_COORDINATE`].
    pub fn point(name: &str, v: Vec3) -> Result<Vec3> {
        finite_vec(name, v)?;
        if v.amax() <= MAX_COORDINATE {
            Ok(v)
        } else {
            Err(Error::new(
                ErrorCode::Range,
                format!("{name} lies more than {MAX_COORDINATE} m from the origin."),
            ))
        }
    }

    /// A finite scalar ≥ 0.
    pub fn not_negative(name: &str, x: Float) -> Result<Float> {
        if finite(name, x)? >= 0.0 {
            Ok(x)
        } else {
            Err(Error::new(ErrorCode::Range, format!("{name} is {x}; it must not be negative.")))
        }
    }

    /// A finite scalar > 0.
    pub fn positive(name: &str, x: Float) -> Result<Float> {
        if finite(name, x)? > 0.0 {
            Ok(x)
        } else {
            Err(Error::new(ErrorCode::Range, format!("{name} is {x}; it must be greater than 0.")))
        }
    }

    /// A finite scalar in [lo, hi].
    pub fn within(name: &str, x: Float, lo: Float, hi: Float) -> Result<Float> {
        if (lo..=hi).contains(&finite(name, x)?) {
            Ok(x)
        } else {
            Err(Error::new(ErrorCode::Range, format!("{name} is {x}; it must lie between {lo} and {hi}.")))
        }
    }

    /// A whole number in [lo, hi].
    pub fn count(name: &str, n: u32, lo: u32, hi: u32) -> Result<u32> {
        if (lo..=hi).contains(&n) {
            Ok(n)
        } else {
            Err(Error::new(ErrorCode::Range, format!("{name} is {n}; it must lie between {lo} and {hi}.")))
        }
    }

    /// A finite unit quaternion, up to 1 in 10³; returned normalised to the last bit.
    pub fn rotation(name: &str, q: Quat) -> Result<Quat> {
        if !(q.w.is_finite() && q.i.is_finite() && q.j.is_finite() && q.k.is_finite()) {
            return Err(Error::new(ErrorCode::NotFinite, format!("{name} has a part that is not finite.")));
        }
        if !Pose::new(Vec3::zeros(), q).is_valid() {
            return Err(Error::new(ErrorCode::Range, format!("{name} is not a unit quaternion.")));
        }
        Ok(crate::math::quat(q.w, crate::math::vec3(q.i, q.j, q.k)))
    }

    /// A valid placement.
    pub fn pose(name: &str, t: &Pose) -> Result<Pose> {
        Ok(Pose::new(point(name, t.p)?, rotation(name, t.q)?))
    }
}
