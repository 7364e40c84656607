//! Light bumper signal as a function of distance.
//!
//! How the signal falls with distance is a Create 3's, whose sensors have the same range of values: the means of its
//! seven sensors at a white baseboard were 3545, 2961, 1291, 359, 93, 38 and 25 at 15, 25, 50, 110, 200, 300 and 400 mm
//! from the bumper (github.com/slowrunner, Create3-WaLI, `create3_ir_dist.py`). The law `A / (d + d0)²` with A = 5.8 and
//! d0 = 17 mm, saturating towards 4095, meets the first four within 15 %; beyond, the signal fades out at the model's
//! range, which is a figure of the model.

use super::LightBumper;
use serde::{Deserialize, Serialize};

/// Largest value of a signal.
pub const MOST_LIGHT: f64 = 4095.0;

/// A and d0 of the law.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LightLaw {
    /// A: the signal of a white wall times the square of its distance from the light source, m².
    pub gain_m2: f64,
    /// d0: how far the light source is behind the body's edge, m.
    pub offset_m: f64,
}

impl LightLaw {
    /// The law measured on a Create 3.
    pub const CREATE_3: Self = Self { gain_m2: 5.8, offset_m: 0.017 };
}

impl LightBumper {
    /// Signal of a surface `distance` metres ahead of a sensor. `share` is the share of light that the surface reflects:
    /// its reflectance times the cosine of the angle at which the light meets it (Lambert), 0 to 1.
    #[inline]
    pub fn light_at(&self, distance: f64, share: f64) -> f64 {
        let from_source = distance + self.law.offset_m;
        let light = share * self.law.gain_m2 / (from_source * from_source);
        let part = distance / self.range;
        let fading = 1.0 - part * part * part * part;
        fading * light / (1.0 + (light / MOST_LIGHT) * (light / MOST_LIGHT)).sqrt()
    }

    /// The distance, m, at which a surface reflects that much light: the inverse of [`Self::light_at`] to a tenth of a
    /// millimetre. 0 for more light than anything reflects, the range for none.
    pub fn distance_of_light(&self, light: f64, share: f64) -> f64 {
        let (mut near, mut far) = (0.0, self.range);
        while far - near > 1e-4 {
            let middle = 0.5 * (near + far);
            if self.light_at(middle, share) > light {
                near = middle;
            } else {
                far = middle;
            }
        }
        0.5 * (near + far)
    }

    /// The distance, m, at which a surface perpendicular to the beam would reflect as much light as one `distance` metres
    /// ahead that reflects only `share` of it, 0 to 1; for distances without fade-out.
    #[inline]
    pub fn apparent_distance(&self, distance: f64, share: f64) -> f64 {
        (distance + self.law.offset_m) / share.sqrt() - self.law.offset_m
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::robot::model;

    fn roomba() -> LightBumper {
        model("roomba600").unwrap().sensors.light_bumper.unwrap()
    }

    #[test]
    fn signals_fall_as_those_measured_on_a_create_3() {
        for (distance, measured) in [(0.015, 3545.0), (0.025, 2961.0), (0.05, 1291.0), (0.11, 359.0)] {
            let light = roomba().light_at(distance, 1.0);
            assert!((light / measured - 1.0).abs() < 0.15, "{distance} m: {light}, measured {measured}");
        }
    }

    #[test]
    fn distances_are_found_again() {
        for share in [0.3, 0.7, 1.0] {
            for millimetres in 1..200 {
                let distance = f64::from(millimetres) / 1000.0;
                let found = roomba().distance_of_light(roomba().light_at(distance, share), share);
                assert!((found - distance).abs() < 2e-4, "{distance} m at {share}: {found}");
            }
        }
        assert!(roomba().distance_of_light(1e9, 1.0) < 1e-3 && roomba().distance_of_light(0.0, 1.0) > 0.199);
    }
}
