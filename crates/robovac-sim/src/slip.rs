//! Wheel slip: wheel motion that differs from encoder counts.
//!
//! Borenstein & Feng (Measurement and correction of systematic odometry errors in mobile robots, IEEE Transactions on
//! Robotics and Automation 12(6), 1996) name the two errors that matter most for two driven wheels: wheels of unequal
//! diameter, and a wheel base that differs from the nominal one. Both are constant for a robot, so they are drawn once.
//! Errors due to the floor are random and add up like a random walk: its variance grows with the distance, as in the
//! odometry model of Thrun, Burgard & Fox (Probabilistic Robotics, 2005, section 5.4).
//!
//! Owners have measured the errors of household robots:
//! - A Create 2 driving for 10 s on tiles covered 582 to 600 mm while its encoders reported 601 to 604 mm; on carpet
//!   698 to 735 mm of 763 to 805 mm, and 294 to 331 mm of 329 to 357 mm (K. Tibow, Roombas, motors, and noise,
//!   ktibow.github.io/blog/roombamotors; three runs each). So carpet eats about 9 % of the way, and runs on tiles that the
//!   encoders can't tell apart differ by 3 %.
//! - Encoders of a Roomba 630 read about 10 % low (`PyRoombaAdapter`, pull request 28), a 780's odometry needs a
//!   factor of 1.125 (`create_robot`, issue 32): uncalibrated robots are off by whole percents.

use crate::RandomStream;
use rand::Rng as _;
use robovac_core::rng::{Rng, normal};
use serde::{Deserialize, Serialize};

/// Level of wheel slip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum SlipLevel {
    /// Wheels of exactly the nominal size that never slip, not even on carpet; only the encoders' resolution is left.
    #[default]
    None,
    /// A calibrated robot on a hard floor: after Borenstein & Feng's square of 4 m it is off by about 20 cm.
    Typical,
    /// A robot out of the box, with worn wheels on a dusty floor: off by about a metre after the same square.
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

    fn figures(self) -> SlipFigures {
        match self {
            Self::None => SlipFigures { size: 0.0, wheel_base: 0.0, slip: 0.0, carpet: 1.0 },
            Self::Typical => SlipFigures { size: 0.001, wheel_base: 0.005, slip: 0.001, carpet: 0.96 },
            Self::Harsh => SlipFigures { size: 0.005, wheel_base: 0.02, slip: 0.006, carpet: 0.91 },
        }
    }
}

/// Sizes of the errors. Those of the harsh level follow the measurements above; a calibrated robot (typical) is assumed
/// to be three to six times better, on a carpet with a short pile (ours, like the share of each).
#[derive(Debug, Clone, Copy)]
struct SlipFigures {
    /// Standard deviation of each wheel's size, as a share of it.
    size: f64,
    /// Standard deviation of the wheel base, as a share of it.
    wheel_base: f64,
    /// Standard deviation of each wheel's slip after one metre, m.
    slip: f64,
    /// Share of the distance that remains on carpet.
    carpet: f64,
}

/// Factor of random slip on carpet (ours: Tibow's robot veered left and right there).
const CARPET_SLIP: f64 = 3.0;

/// Errors of one robot's wheels.
#[derive(Debug, Clone)]
pub struct Slip {
    rng: Rng,
    figures: SlipFigures,
    /// Sizes of the wheels as shares of the nominal one: left, right, and the one that moves the robot sideways.
    sizes: [f64; 3],
    /// True wheel base as a share of the nominal one.
    base: f64,
}

impl Slip {
    /// The wheels of the robot with number `seed`.
    pub fn new(level: SlipLevel, seed: u64) -> Self {
        let mut rng = RandomStream::Slip.seeded(seed);
        let figures = level.figures();
        let mut about_one = |deviation: f64| 1.0 + deviation * normal(&mut rng);
        let sizes = [figures.size; 3].map(&mut about_one);
        let base = about_one(figures.wheel_base);
        Self { rng, figures, sizes, base }
    }

    /// Actual motion of the rims for the encoders' motion: left, right, sideways, m.
    #[inline]
    pub fn apply(&mut self, rolled: [f64; 3], is_on_carpet: impl FnOnce() -> bool) -> [f64; 3] {
        if self.figures.slip == 0.0 || rolled == [0.0; 3] {
            return rolled;
        }
        let (share, slip) = if is_on_carpet() {
            (self.figures.carpet, CARPET_SLIP * self.figures.slip)
        } else {
            (1.0, self.figures.slip)
        };
        let deviates = self.deviates();
        let mut real = [0.0; 3];
        for (i, real) in real.iter_mut().enumerate() {
            if rolled[i] != 0.0 {
                *real = share * self.sizes[i] * rolled[i] + slip * rolled[i].abs().sqrt() * deviates[i];
            }
        }
        real
    }

    /// The effective wheel base for turns, where `nominal` is that of the robot's odometry, m.
    #[inline]
    pub fn wheel_base(&self, nominal: f64) -> f64 {
        nominal * self.base
    }

    /// Three independent random numbers of mean 0 and variance 1 from one draw: each the sum of two uniform numbers of ten
    /// bits. Over the hundreds of steps that make a metre they add up to a normal deviate (central limit theorem), and
    /// there is no logarithm to pay for in every step.
    #[inline]
    fn deviates(&mut self) -> [f64; 3] {
        // The sum of two has a mean of 1023 and a variance of (1024² - 1) / 6.
        const DEVIATION: f64 = 418.046_050_094;
        let bits = self.rng.next_u64();
        let sum = |shift: u32| ((bits >> shift) & 1023) + ((bits >> (shift + 10)) & 1023);
        [0, 20, 40].map(|shift| (sum(shift) as f64 - 1023.0) / DEVIATION)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn deviates_have_zero_mean_and_unit_variance_and_are_independent() {
        let mut slip = Slip::new(SlipLevel::Typical, 5);
        let draws: Vec<[f64; 3]> = (0..20_000).map(|_| slip.deviates()).collect();
        let mean = |f: &dyn Fn(&[f64; 3]) -> f64| draws.iter().map(f).sum::<f64>() / 20_000.0;
        for i in 0..3 {
            assert!(mean(&|d| d[i]).abs() < 0.03 && (mean(&|d| d[i] * d[i]) - 1.0).abs() < 0.03);
            assert!(mean(&|d| d[i] * d[(i + 1) % 3]).abs() < 0.03);
        }
    }

    #[test]
    fn carpet_eats_a_share_of_the_way() {
        let mut slip = Slip::new(SlipLevel::Harsh, 2);
        let mut drive = |is_on_carpet: bool| {
            (0..200_000).map(|_| slip.apply([0.0045, 0.0045, 0.0], || is_on_carpet)[0]).sum::<f64>() / 900.0
        };
        let share = drive(true) / drive(false);
        assert!((share - 0.91).abs() < 0.01, "{share}");
        let mut perfect = Slip::new(SlipLevel::None, 2);
        assert_eq!(perfect.apply([0.1, -0.2, 0.3], || true), [0.1, -0.2, 0.3]);
    }
}
