//! Summary of many runs of one algorithm.

use super::{GOALS, RunOutcome, quantile};
use serde::Serialize;
use std::{array, collections::BTreeMap};

/// The quantiles of a band: lowest tenth, median, highest tenth.
const QUANTILES: [f64; 3] = [0.1, 0.5, 0.9];

/// Median and central 80 % of values; see [`quantile`] for the definition.
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

/// Time at which runs reached a share of the floor.
///
/// The time of a run that didn't reach it is only known to be longer than the run. Times that depend on such a run are
/// `None`: the median, unless more than half of the runs reached it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct TimeTo {
    /// The share, %.
    pub percent: f64,
    /// Number of runs that reached it.
    pub reached: usize,
    /// Time by which one run in ten reached it, s.
    pub low_s: Option<f64>,
    /// Time by which half of the runs reached it, s.
    pub median_s: Option<f64>,
    /// Time by which nine runs in ten reached it, s.
    pub high_s: Option<f64>,
}

/// Summary of many runs of one algorithm.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Summary {
    /// Number of runs.
    pub runs: usize,
    /// Swept share of the reachable floor at the end, 0 to 1.
    pub coverage: Band,
    /// Times to the shares of [`GOALS`].
    pub time_to: [TimeTo; GOALS.len()],
    /// Distance driven, m.
    pub distance_m: Band,
    /// Number of bumps.
    pub bumps: Band,
    /// Falls of all runs together.
    pub falls: u32,
    /// Remaining share of the dirt, 0 to 1; `None` if there was none.
    pub dirt_left: Option<Band>,
    /// How far distance and time exceed the least of any run that sweeps as much, as shares; `None` if there is none for a run.
    pub excess: Option<[Band; 2]>,
}

/// Outcomes of one algorithm by their seeds. Their order makes no difference.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RunTally(BTreeMap<u64, RunOutcome>);

impl RunTally {
    /// Adds a run; one with the same seed is replaced, as it is equal.
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
    /// Summary of `runs`; `None` if there are none.
    pub fn of(runs: &[&RunOutcome]) -> Option<Self> {
        Some(Self {
            runs: runs.len(),
            coverage: Band::of(runs, RunOutcome::coverage)?,
            time_to: array::from_fn(|goal| TimeTo::of(runs, goal)),
            distance_m: Band::of(runs, |run| run.distance_m)?,
            bumps: Band::of(runs, |run| f64::from(run.bumps))?,
            falls: runs.iter().map(|run| run.falls).sum(),
            dirt_left: Band::of(runs, |run| run.dirt_left.unwrap_or(0.0)).filter(|_| runs[0].dirt_left.is_some()),
            excess: runs.iter().all(|run| run.excess.is_some()).then(|| excess(runs)).flatten(),
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

    /// The bands of coverage over time: one for each sample of the runs' curves, which have equally many.
    pub fn curve(runs: &[&RunOutcome]) -> Vec<Self> {
        let samples = runs.first().map_or(0, |run| run.curve.len());
        let at = |sample: usize| Self::of(runs, |run| run.curve.get(sample).copied().unwrap_or(0.0));
        (0..samples).filter_map(at).collect()
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

fn excess(runs: &[&RunOutcome]) -> Option<[Band; 2]> {
    let of = |which: usize| Band::of(runs, |run| run.excess.map_or(0.0, |above| above[which]));
    Some([of(0)?, of(1)?])
}

fn quantiles(runs: &[&RunOutcome], number: impl Fn(&RunOutcome) -> f64) -> Option<[f64; 3]> {
    let mut values: Vec<f64> = runs.iter().map(|run| number(run)).collect();
    values.sort_unstable_by(f64::total_cmp);
    let [Some(low), Some(median), Some(high)] = QUANTILES.map(|p| quantile(&values, p)) else { return None };
    Some([low, median, high])
}
