//! The dirt sensor: counts particles hitting the brush housing.
//!
//! Noise: at "typical" up to 2, at "harsh" up to 20 of 255 are read while nothing hits it. The figures are ours; the Open
//! Interface only says that more is dirtier.

use super::Noisy;
use crate::SensorKind;

/// Amount of dirt in one step with a reading of 255, m² of a spot: from a strip 17 cm wide at 0.3 m/s.
const FULL: f64 = 7.65e-4;
/// Share of a reading that remains after a step: it decays within about a tenth of a second.
const FADES: f64 = 0.7;

/// The decaying signal, 0 to 255.
#[derive(Debug, Clone, Default)]
pub(super) struct DirtSensor(f64);

impl DirtSensor {
    /// The reading after a step in which `amount` of dirt was picked up.
    pub fn read(&mut self, amount: f64, noise: &Noisy<'_>) -> u8 {
        self.0 = (self.0 * FADES).max((255.0 / FULL * amount).min(255.0));
        let hum = noise.pick(SensorKind::Dirt, [0.0, 3.0, 21.0]) * noise.uniform(SensorKind::Dirt, 0);
        self.0.max(hum) as u8
    }
}
