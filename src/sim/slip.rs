//! Wheels that don't do exactly what their encoders say.

use crate::rng::{Rng, normal, seeded};
use serde::{Deserialize, Serialize};

/// How well the wheels hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum SlipLevel {
    /// Wheels of exactly the nominal size that never slip; only the encoders' resolution is left.
    #[default]
    None,
    /// A good hard floor: wheels differ by about 0.1 %, and slip adds 0.3 mm a metre (one standard deviation each).
    Typical,
    /// Carpet and worn wheels: five times that.
    Harsh,
}

impl SlipLevel {
    /// All levels, with their names in links and on the command line.
    pub const ALL: [(Self, &'static str); 3] =
        [(Self::None, "none"), (Self::Typical, "typical"), (Self::Harsh, "harsh")];

    /// The level of that name.
    pub fn parse(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(_, n)| *n == name).map(|(level, _)| level)
    }

    /// Name in links and on the command line.
    pub fn id(self) -> &'static str {
        Self::ALL[self as usize].1
    }
}

/// What one robot's wheels do: a size error each, drawn once, and slip that adds up like a random walk.
///
/// The levels are ours, chosen so that the heading drifts by about a third of a degree a metre at "typical", as an
/// uncalibrated hobby robot does.
#[derive(Debug, Clone)]
pub struct Slip {
    rng: Rng,
    size_left: f64,
    size_right: f64,
    /// Standard deviation of the slip after one metre, m.
    per_root_metre: f64,
}

impl Slip {
    /// The wheels of the robot with number `seed`.
    pub fn new(level: SlipLevel, seed: u64) -> Self {
        let mut rng = seeded(seed, 1);
        let factor = [0.0, 1.0, 5.0][level as usize];
        let mut size = || 1.0 + 0.001 * factor * normal(&mut rng);
        let (size_left, size_right) = (size(), size());
        Self { rng, size_left, size_right, per_root_metre: 0.0003 * factor }
    }

    /// How far the rims really move the robot when the encoders say so: left, right, sideways, m.
    #[inline]
    pub fn apply(&mut self, rolled: [f64; 3], is_on_carpet: impl FnOnce() -> bool) -> [f64; 3] {
        let [left, right, lateral] = rolled;
        if self.per_root_metre == 0.0 {
            return rolled;
        }
        let _ = is_on_carpet;
        let mut slip = |travel: f64| self.per_root_metre * travel.abs().sqrt() * normal(&mut self.rng);
        [left * self.size_left + slip(left), right * self.size_right + slip(right), lateral]
    }

    /// The wheel base that the robot turns by, where `nominal` is what its odometry takes it for, m.
    #[inline]
    pub fn wheel_base(&self, nominal: f64) -> f64 {
        nominal
    }
}
