//! Elementary functions that give the same bits natively and in WebAssembly.
//!
//! The standard library's `sin` or `exp` call the platform's maths library, whose last bits differ between targets;
//! a simulation fed with them drifts apart within minutes. Everything here goes through `libm`. Square roots and the
//! four operations are exact by IEEE 754 everywhere and need no wrapper.

pub use core::f64::consts::{FRAC_PI_2, PI, TAU};

/// Sine of an angle in radians.
#[inline]
pub fn sin(radians: f64) -> f64 {
    libm::sin(radians)
}

/// Cosine of an angle in radians.
#[inline]
pub fn cos(radians: f64) -> f64 {
    libm::cos(radians)
}

/// Angle of the vector (x, y) in radians, in (-π, π].
#[inline]
pub fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// e to the power `x`.
#[inline]
pub fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// Natural logarithm; NaN for negative `x`.
#[inline]
pub fn ln(x: f64) -> f64 {
    libm::log(x)
}

/// Length of the vector (x, y), without overflow on the way.
#[inline]
pub fn hypot(x: f64, y: f64) -> f64 {
    libm::hypot(x, y)
}
