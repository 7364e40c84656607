//! Angles in radians, counter-clockwise positive.

use crate::math::{PI, TAU};

/// The same angle in (-π, π].
///
/// ```
/// use robovac_core::{geometry::normalize, math::PI};
/// assert_eq!(normalize(3.0 * PI), PI);
/// assert_eq!(normalize(-PI), PI);
/// ```
#[inline]
pub fn normalize(radians: f64) -> f64 {
    if radians > -PI && radians <= PI {
        return radians;
    }
    let wrapped = radians - TAU * ((radians + PI) / TAU).floor();
    if wrapped <= -PI { wrapped + TAU } else { wrapped }
}

/// The shortest turn that leads from heading `from` to heading `to`, in (-π, π].
#[inline]
pub fn difference(from: f64, to: f64) -> f64 {
    normalize(to - from)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn difference_takes_the_short_way_round() {
        assert!((difference(3.0, -3.0) - (TAU - 6.0)).abs() < 1e-12);
        assert!((difference(-3.0, 3.0) + (TAU - 6.0)).abs() < 1e-12);
    }

    #[test]
    fn normalize_stays_in_range() {
        for k in -100..100 {
            let angle = normalize(f64::from(k) * 0.37);
            assert!(angle > -PI && angle <= PI, "{angle}");
        }
    }
}
