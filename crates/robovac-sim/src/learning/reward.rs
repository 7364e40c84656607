//! What a step gained, and its worth.

/// What happened in one step of an episode: the parts of every reward.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Gains {
    /// Floor swept for the first time, m².
    pub swept_m2: f64,
    /// Sum of all turning, rad, at least 0.
    pub turned_rad: f64,
    /// Times that the bumper was pressed.
    pub bumps: f64,
    /// Simulated time, s.
    pub time_s: f64,
    /// Falls down a drop-off.
    pub falls: f64,
    /// 1 in the step in which the wanted share of the floor was reached.
    pub finished: f64,
}

/// The worth of each part; a reward is the sum of parts times weights.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RewardWeights {
    /// For each m² of floor swept for the first time.
    pub swept_m2: f64,
    /// For each radian of turning.
    pub turned_rad: f64,
    /// For each press of the bumper.
    pub bump: f64,
    /// For each second.
    pub second: f64,
    /// For each fall.
    pub fall: f64,
    /// For reaching the wanted share of the floor.
    pub finish: f64,
}

/// A Roomba that drives straight over new floor gains about 1 a second.
impl Default for RewardWeights {
    fn default() -> Self {
        Self { swept_m2: 20.0, turned_rad: -0.02, bump: -0.1, second: -0.1, fall: -10.0, finish: 10.0 }
    }
}

impl Gains {
    /// Names of the parts, in the order of [`Gains::parts`].
    pub const NAMES: [&str; 6] = ["swept_m2", "turned_rad", "bumps", "time_s", "falls", "finished"];

    /// The parts.
    pub fn parts(&self) -> [f64; Self::NAMES.len()] {
        let Self { swept_m2, turned_rad, bumps, time_s, falls, finished } = *self;
        [swept_m2, turned_rad, bumps, time_s, falls, finished]
    }
}

impl RewardWeights {
    /// The reward for `gains`.
    pub fn reward(&self, gains: &Gains) -> f64 {
        let Self { swept_m2, turned_rad, bump, second, fall, finish } = *self;
        let weights = [swept_m2, turned_rad, bump, second, fall, finish];
        weights.iter().zip(gains.parts()).map(|(weight, part)| weight * part).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reward_is_the_sum_of_its_parts() {
        let gains = Gains { swept_m2: 0.05, turned_rad: 1.0, bumps: 1.0, time_s: 0.1, falls: 0.0, finished: 0.0 };
        assert!((RewardWeights::default().reward(&gains) - (1.0 - 0.02 - 0.1 - 0.01)).abs() < 1e-12);
        assert_eq!(RewardWeights::default().reward(&Gains::default()), 0.0);
    }
}
