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

/// The greatest whole number not above `x`, within the range of the type; 0 for NaN. Older x86 have no instruction for
/// [`f64::floor`].
#[inline]
pub fn floor(x: f64) -> i32 {
    let whole = x as i32;
    whole.saturating_sub(i32::from(f64::from(whole) > x))
}

/// The least whole number not below `x`, within the range of the type; 0 for NaN.
#[inline]
pub fn ceil(x: f64) -> i32 {
    let whole = x as i32;
    whole.saturating_add(i32::from(f64::from(whole) < x))
}

/// Sine and cosine of an angle in radians, accurate to the last bit or two; faster than two separate calls.
///
/// The angle less its quarter turns, and for what is left the polynomials of Sun's fdlibm (`k_sin.c` and `k_cos.c`).
#[inline]
pub fn sin_cos(radians: f64) -> (f64, f64) {
    // Adding and subtracting it rounds to a whole number.
    const ROUND: f64 = 6_755_399_441_055_744.0;
    // A quarter turn as the sum of 33 bits and the rest.
    const QUARTER: (f64, f64) = (1.570_796_326_734_125_6, 6.077_100_506_506_192e-11);
    const SIN: [f64; 6] = [
        -0.166_666_666_666_666_32,
        0.008_333_333_333_322_49,
        -0.000_198_412_698_298_579_5,
        2.755_731_370_707_006_8e-6,
        -2.505_076_025_340_686_3e-8,
        1.589_690_995_211_55e-10,
    ];
    const COS: [f64; 6] = [
        0.041_666_666_666_666_6,
        -0.001_388_888_888_887_411,
        2.480_158_728_947_673e-5,
        -2.755_731_435_139_066_3e-7,
        2.087_572_321_298_175e-9,
        -1.135_964_755_778_819_5e-11,
    ];
    let is_near = radians.abs() < 1e5;
    if !is_near {
        return libm::sincos(radians);
    }
    let quarters = (radians * core::f64::consts::FRAC_2_PI + ROUND) - ROUND;
    let x = (radians - quarters * QUARTER.0) - quarters * QUARTER.1;
    let square = x * x;
    let sin = x + x * (square * polynomial(square, SIN));
    let half = 0.5 * square;
    let large = 1.0 - half;
    let cos = large + ((1.0 - large - half) + square * square * polynomial(square, COS));
    match quarters as i32 & 3 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// The value of a polynomial, constant first.
#[inline]
fn polynomial(x: f64, factors: [f64; 6]) -> f64 {
    factors.into_iter().rev().fold(0.0, |sum, factor| sum * x + factor)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_are_those_of_the_standard_library() {
        for x in [-2.0, -1.5, -1.0, -1e-300, -0.0, 0.0, 0.3, 1.0, 7.999, 1e12, -1e12, f64::INFINITY, f64::NAN] {
            assert_eq!((floor(x), ceil(x)), (x.floor() as i32, x.ceil() as i32), "{x}");
        }
    }

    #[test]
    fn sine_and_cosine_are_those_of_libm() {
        let turns = (-4000..4000).map(|i| f64::from(i) * 0.001_7);
        let quarters = (-9..9).map(|i| f64::from(i) * FRAC_PI_2);
        for angle in turns.chain(quarters).chain([0.0, 1e-9, 99_999.3, -1e5, 3e17]) {
            let (sine, cosine) = sin_cos(angle);
            assert!((sine - sin(angle)).abs() < 2.3e-16 && (cosine - cos(angle)).abs() < 2.3e-16, "{angle}");
        }
        assert!(sin_cos(f64::NAN).0.is_nan() && sin_cos(f64::INFINITY).1.is_nan());
        assert_eq!(sin_cos(0.0), (0.0, 1.0));
    }
}
