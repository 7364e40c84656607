//! Summary of a comparison: a table of planners by metrics.

use super::PrintedRow;
use coverage_planners::metrics::{Better, METRICS, MetricInfo, PlanNumbers, SweepBound};
use robovac_sim::experiment::{Entrant, planning::WHOLE};
use serde::Serialize;

/// Median and range of a number over several seeds.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct MedianAndRange {
    /// The median.
    pub median: f64,
    /// The smallest value.
    pub min: f64,
    /// The largest value.
    pub max: f64,
}

/// The results of one planner.
#[derive(Debug, Clone)]
pub struct Row {
    /// The planner with its parameters.
    pub entrant: Entrant,
    /// Its number in the registry.
    pub index: usize,
    /// One for each of [`METRICS`]: summed over the rooms for every seed (for shares, averaged); then over the seeds.
    /// `None` while a room has no result.
    pub values: Vec<Option<MedianAndRange>>,
    /// The exact coverage of its paths and the bounds for it, above which the excess is: combined as the values are, the medians.
    /// `None` for a robot that fills a cell, and while a room has no result.
    pub least: Option<SweepBound>,
    /// Trials included in the values.
    pub trials: usize,
    /// Rooms in which all trials failed or are missing.
    pub missing: usize,
    /// The message of the first failed trial.
    pub failure: Option<String>,
    /// Whether all walks visit all cells and all paths in metres sweep [`WHOLE`]; others cost less for doing less, so they
    /// are the best in nothing but coverage.
    pub is_complete: bool,
    /// What a paper prints for this planner in this room.
    pub printed: Option<&'static PrintedRow>,
}

/// Whether a plan does all that others do.
fn is_complete(numbers: &PlanNumbers) -> bool {
    numbers.walk.map_or(numbers.drive.coverage >= WHOLE, |walk| walk.is_complete())
}

/// The table of planners by metrics.
#[derive(Debug, Clone)]
pub struct ComparisonTable {
    /// The planners.
    pub rows: Vec<Row>,
    /// The best median of each of [`METRICS`], as rounded for display; `None` with fewer than two rows.
    pub best: Vec<Option<f64>>,
}

impl MedianAndRange {
    /// Median and range of `values`; `None` without any.
    pub fn of(mut values: Vec<f64>) -> Option<Self> {
        values.sort_by(f64::total_cmp);
        let (&min, &max) = (values.first()?, values.last()?);
        let median = f64::midpoint(values[(values.len() - 1) / 2], values[values.len() / 2]);
        Some(Self { median, min, max })
    }
}

impl Row {
    /// A planner with its results, room by room.
    pub fn new(entrant: Entrant, index: usize, rooms: &[Vec<Result<PlanNumbers, String>>]) -> Self {
        let failure = rooms.iter().flatten().find_map(|result| result.as_ref().err().cloned());
        let rooms: Vec<Vec<PlanNumbers>> =
            rooms.iter().map(|trials| trials.iter().filter_map(|t| t.as_ref().ok()).copied().collect()).collect();
        // Shares of different rooms don't add up.
        let values =
            METRICS.iter().map(|metric| over_rooms(&|n| metric.value(n), metric.unit == "%", &rooms)).collect();
        Self {
            entrant,
            index,
            values,
            least: least(&rooms),
            trials: rooms.iter().map(Vec::len).sum(),
            missing: rooms.iter().filter(|trials| trials.is_empty()).count(),
            failure,
            is_complete: rooms.iter().flatten().all(is_complete),
            printed: None,
        }
    }
}

impl Row {
    /// Whether it can have the best value.
    fn counts_in(&self, metric: &MetricInfo) -> bool {
        self.is_complete || metric.better == Better::Higher
    }
}

/// The exact coverage, and the bounds for it.
fn least(rooms: &[Vec<PlanNumbers>]) -> Option<SweepBound> {
    let median =
        |value: &dyn Fn(&PlanNumbers) -> Option<f64>, is_share| Some(over_rooms(value, is_share, rooms)?.median);
    Some(SweepBound {
        coverage: median(&|numbers| Some(numbers.excess?.swept), true)?,
        length_m: median(&|numbers| Some(numbers.excess?.bound.length_m), false)?,
        duration_s: median(&|numbers| Some(numbers.excess?.bound.duration_s), false)?,
    })
}

/// A number for each seed, combined over the rooms: the sum, or of shares the mean.
fn over_rooms(
    value: &dyn Fn(&PlanNumbers) -> Option<f64>,
    is_share: bool,
    rooms: &[Vec<PlanNumbers>],
) -> Option<MedianAndRange> {
    let seeds = rooms.first()?.len();
    let count = rooms.len() as f64;
    let of_seed = |seed: usize| -> Option<f64> {
        let values = rooms.iter().map(|trials| value(trials.get(seed)?));
        let sum = values.sum::<Option<f64>>()?;
        Some(if is_share { sum / count } else { sum })
    };
    MedianAndRange::of((0..seeds).map(of_seed).collect::<Option<Vec<f64>>>()?)
        .filter(|_| rooms.iter().all(|r| r.len() == seeds))
}

impl ComparisonTable {
    /// The table of those planners.
    pub fn new(rows: Vec<Row>) -> Self {
        let best = METRICS.iter().enumerate().map(|(column, metric)| best_of(&rows, column, metric)).collect();
        Self { rows, best }
    }

    /// Whether a planner has the best value, at the displayed precision.
    pub fn is_best(&self, row: &Row, column: usize) -> bool {
        let (metric, value) = (&METRICS[column], row.values[column]);
        value.is_some_and(|v| row.counts_in(metric) && self.best[column] == Some(metric.rounded(v.median)))
    }
}

fn best_of(rows: &[Row], column: usize, metric: &MetricInfo) -> Option<f64> {
    // Planning times vary on a busy machine, so none is the best.
    if metric.id == PLANNING {
        return None;
    }
    let rows = rows.iter().filter(|row| row.counts_in(metric));
    let values: Vec<f64> = rows.filter_map(|r| Some(metric.rounded(r.values[column]?.median))).collect();
    let spread = MedianAndRange::of(values.clone()).filter(|_| values.len() > 1)?;
    Some(if metric.better == Better::Lower { spread.min } else { spread.max })
}

/// Id of the only metric that isn't deterministic.
const PLANNING: &str = "planning";
