//! Covariance of the pose estimate.

/// Standard deviations and covariance of a pose.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PoseCovariance {
    /// Covariance of the position: xx, xy, yy, m².
    pub position: [f64; 3],
    /// Standard deviation of the heading, rad.
    pub heading: f64,
}

impl PoseCovariance {
    /// The ellipse of one standard deviation: its half axes, m, the longer one first, and the direction of that, rad.
    pub fn ellipse(&self) -> ([f64; 2], f64) {
        let [xx, xy, yy] = self.position;
        let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let root = (half * half + xy * xy).sqrt();
        let axes = [mean + root, (mean - root).max(0.0)].map(f64::sqrt);
        (axes, 0.5 * robovac_core::math::atan2(2.0 * xy, xx - yy))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ellipse_of_a_slanted_covariance() {
        // Variances 4 and 1 along axes turned by 30 degrees.
        let (sin, cos) = robovac_core::math::sin_cos(std::f64::consts::FRAC_PI_6);
        let spread = PoseCovariance {
            position: [4.0 * cos * cos + sin * sin, 3.0 * sin * cos, 4.0 * sin * sin + cos * cos],
            heading: 0.0,
        };
        let ([long, short], direction) = spread.ellipse();
        assert!((long - 2.0).abs() < 1e-12 && (short - 1.0).abs() < 1e-12);
        assert!((direction - std::f64::consts::FRAC_PI_6).abs() < 1e-12);
    }
}
