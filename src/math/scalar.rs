//! Transcendental functions with the same bits on every platform (crate `libm`, plain Rust).

use super::Float;

/// π.
#[cfg(not(feature = "f64"))]
pub const PI: Float = core::f32::consts::PI;
/// π.
#[cfg(feature = "f64")]
pub const PI: Float = core::f64::consts::PI;

macro_rules! portable {
    ($($(#[$doc:meta])* $name:ident($($arg:ident),+) = $single:ident | $double:ident;)+) => {$(
        $(#[$doc])*
        #[inline]
        #[must_use]
        pub fn $name($($arg: Float),+) -> Float {
            #[cfg(not(feature = "f64"))]
            { libm::$single($($arg),+) }
            #[cfg(feature = "f64")]
            { libm::$double($($arg),+) }
        }
    )+};
}

portable! {
    /// The sine of an angle \[rad\].
    sin(x) = sinf | sin;
    /// The cosine of an angle \[rad\].
    cos(x) = cosf | cos;
    /// The tangent of an angle \[rad\].
    tan(x) = tanf | tan;
    /// The angle of the point (x, y), −π … π \[rad\].
    atan2(y, x) = atan2f | atan2;
    /// The angle with this cosine, 0 … π \[rad\].
    acos(x) = acosf | acos;
    /// The cube root.
    cbrt(x) = cbrtf | cbrt;
    /// The logarithm to base 2.
    log2(x) = log2f | log2;
    /// e to the power of x.
    exp(x) = expf | exp;
}

/// Sine and cosine of an angle \[rad\].
#[inline]
#[must_use]
pub fn sin_cos(x: Float) -> (Float, Float) {
    (sin(x), cos(x))
}

/// To double, in which a few delicate parts compute in both builds.
#[inline(always)]
#[must_use]
#[cfg_attr(feature = "f64", allow(clippy::unnecessary_cast))]
pub fn double(x: Float) -> f64 {
    x as f64
}

/// From double, rounded to nearest.
#[inline(always)]
#[must_use]
#[cfg_attr(feature = "f64", allow(clippy::unnecessary_cast))]
pub fn single(x: f64) -> Float {
    x as Float
}
