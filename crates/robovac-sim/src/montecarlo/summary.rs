//! Summary of many runs of one algorithm.

use super::{GOALS, RunOutcome, SAMPLES, quantile};
use serde::Serialize;
use std::{array, collections::BTreeMap};

/// The quantiles that bands are made of: one run in ten is below, half of them, one in ten above.
const QUANTILES: [f64; 3] = [0.1, 0.5, 0.9];

/// The middle of many values and where four in five of them lie; see [`quantile`] for the definition.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Band {
    /// A tenth of the values is lower.
    pub low: f64,
    /// Half of the values are lower.
    pub median: f64,
    /// A tenth of the values is higher.
    pub high: f64,
}

/// When runs had swept a share of the floor.
///
/// The time of a run that didn't get there is only known to be longer than the run. Times that depend on such a run are
/// `None`: the median, unless more than half of the runs got there.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct TimeTo {
    /// The share, %.
    pub percent: f64,
    /// Runs that got there.
    pub reached: usize,
    /// One run in ten was there by then, s.
    pub low_s: Option<f64>,
    /// Half of the runs were there by then, s.
    pub median_s: Option<f64>,
    /// Nine runs in ten were there by then, s.
    pub high_s: Option<f64>,
}

/// Summary of many runs of one algorithm.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Summary {
    /// How many.
    pub runs: usize,
    /// Swept share of the reachable floor at the end, 0 to 1.
    pub coverage: Band,
    /// When it had swept the shares of [`GOALS`].
    pub time_to: [TimeTo; GOALS.len()],
    /// Distance driven, m.
    pub distance_m: Band,
    /// How often the bumper was pressed.
    pub bumps: Band,
    /// Falls of all runs together.
    pub falls: u32,
    /// Share of the dirt that was left, 0 to 1; `None` where there was none.
    pub dirt_left: Option<Band>,
}

/// Outcomes of one algorithm by their seeds. The order in which they come makes no difference.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RunTally(BTreeMap<u64, RunOutcome>);

impl RunTally {
    /// Takes a run; one with the same seed is replaced, as it was the same.
    pub fn add(&mut self, outcome: RunOutcome) {
        self.0.insert(outcome.seed, outcome);
    }

    /// Whether there is a run with that seed.
    pub fn has(&self, seed: u64) -> bool {
        self.0.contains_key(&seed)
    }

    /// The runs with seeds from `first` on, `count` at most, by their seeds.
    pub fn runs(&self, first: u64, count: u64) -> Vec<&RunOutcome> {
        self.0.range(first..first.saturating_add(count)).map(|(_, outcome)| outcome).collect()
    }
}

impl Summary {
    /// Sums up `runs`; `None` if there are none.
    pub fn of(runs: &[&RunOutcome]) -> Option<Self> {
        Some(Self {
            runs: runs.len(),
            coverage: Band::of(runs, RunOutcome::coverage)?,
            time_to: array::from_fn(|goal| TimeTo::of(runs, goal)),
            distance_m: Band::of(runs, |run| run.distance_m)?,
            bumps: Band::of(runs, |run| f64::from(run.bumps))?,
            falls: runs.iter().map(|run| run.falls).sum(),
            dirt_left: Band::of(runs, |run| run.dirt_left.unwrap_or(0.0)).filter(|_| runs[0].dirt_left.is_some()),
        })
    }
}

impl Band {
    /// The band of a number of each run.
    fn of(runs: &[&RunOutcome], number: impl Fn(&RunOutcome) -> f64) -> Option<Self> {
        let [low, median, high] = quantiles(runs, number)?;
        Some(Self { low, median, high })
    }

    /// The same in another unit.
    #[must_use]
    pub fn times(self, factor: f64) -> Self {
        Self { low: factor * self.low, median: factor * self.median, high: factor * self.high }
    }

    /// The bands of coverage over time: one at the start and one at the end of each of [`SAMPLES`] equal parts of it.
    pub fn curve(runs: &[&RunOutcome]) -> Vec<Self> {
        let at = |sample: usize| Self::of(runs, |run| run.curve.get(sample).copied().unwrap_or(0.0));
        (0..=SAMPLES).filter_map(at).collect()
    }
}

impl TimeTo {
    fn of(runs: &[&RunOutcome], goal: usize) -> Self {
        let times = quantiles(runs, |run| run.reached_s[goal]).unwrap_or([f64::INFINITY; 3]);
        let [low_s, median_s, high_s] = times.map(|time| Some(time).filter(|time| time.is_finite()));
        let reached = runs.iter().filter(|run| run.reached_s[goal].is_finite()).count();
        Self { percent: 100.0 * GOALS[goal], reached, low_s, median_s, high_s }
    }
}

fn quantiles(runs: &[&RunOutcome], number: impl Fn(&RunOutcome) -> f64) -> Option<[f64; 3]> {
    let mut values: Vec<f64> = runs.iter().map(|run| number(run)).collect();
    values.sort_unstable_by(f64::total_cmp);
    let [Some(low), Some(median), Some(high)] = QUANTILES.map(|p| quantile(&values, p)) else { return None };
    Some([low, median, high])
}
