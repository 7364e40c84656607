//! The comparison as plain objects.

use super::{Comparison, ComparisonTable, MedianAndRange, Race, RoomSet, TrialProgress};
use crate::{Mark, explore::SessionState};
use coverage_planners::{
    Bounds,
    metrics::{METRICS, MetricInfo, PlanNumbers, SweepBound},
};
use robovac_core::registry::Params;
use serde::Serialize;

/// Snapshot of a comparison, one per frame.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct ComparisonView<'a> {
    version: u32,
    set: &'static str,
    sets: Vec<(&'static str, &'static str)>,
    seeds: u32,
    rooms: Vec<&'a str>,
    /// Number of the session's room in `rooms`.
    done: usize,
    total: usize,
    cancelled: bool,
    entrants: Vec<EntrantView<'a>>,
    /// Chosen entrants that could race, but don't: nine race at most.
    waiting: Vec<usize>,
    /// Which of those that race leaves if one of them joins; `None` while there is room.
    leaves: Option<usize>,
    race: Option<RaceView<'a>>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
struct EntrantView<'a> {
    id: &'static str,
    #[cfg_attr(feature = "types", ts(type = "\"planner\" | \"behaviour\""))]
    kind: &'static str,
    /// With what tells it from its copies.
    title: String,
    /// That alone, such as "vertical"; empty without copies.
    distinction: String,
    mark: Mark,
    /// 1, or 2 and up for copies; 0 for one that was removed, and for a program that isn't there.
    copy: usize,
    chosen: bool,
    /// What the robot lacks for it; it then doesn't take part.
    lacks: &'static str,
    params: &'a Params,
    /// `out`, `trying`, `done` or `failed`.
    #[cfg_attr(feature = "types", ts(type = "\"out\" | \"trying\" | \"done\" | \"failed\""))]
    state: &'static str,
    /// 0 to 1.
    progress: f64,
    message: &'a str,
}

#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
struct RaceView<'a> {
    state: SessionState,
    time_s: f64,
    end_s: f64,
    planned_s: f64,
    speed: f64,
    /// Whether it stands still because the user's program hasn't got farther.
    waits: bool,
    /// Why the user's program failed; empty if it didn't.
    failure: &'a str,
    lanes: Vec<LaneView>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
struct LaneView {
    /// Its number in `entrants`.
    entrant: usize,
    /// When it had swept 95 % and arrived, s.
    won_s: Option<f64>,
    coverage: f64,
    time_s: f64,
    distance_m: f64,
    turning_deg: f64,
    finished: bool,
    /// Rank, from 1.
    place: usize,
}

impl<'a> ComparisonView<'a> {
    /// The snapshot of `comparison`.
    pub fn new(comparison: &'a Comparison) -> Self {
        let (done, total) = comparison.count();
        let mut marks = Mark::of_all();
        let entrants = comparison.entrants().iter().enumerate().map(|(index, entrant)| {
            let (state, progress, message) = match comparison.progress(index) {
                TrialProgress::Out => ("out", 0.0, ""),
                TrialProgress::Trying(share) => ("trying", share, ""),
                TrialProgress::Done => ("done", 1.0, ""),
                TrialProgress::Failed(message) => ("failed", 1.0, message),
            };
            let (algorithm, copy) = (entrant.algorithm, comparison.copy_number(index));
            let (title, distinction) = (comparison.title(entrant), comparison.distinction(index));
            let mut mark = Mark::of(algorithm);
            if copy > 1 {
                mark = mark.copied(&marks);
                marks.push(mark);
            }
            EntrantView {
                id: algorithm.id(),
                kind: algorithm.kind(),
                title: match distinction.as_str() {
                    "" => title,
                    number if number.starts_with('(') => format!("{title} {number}"),
                    values => format!("{title}, {values}"),
                },
                distinction,
                mark,
                copy,
                chosen: comparison.is_chosen(index) && comparison.lacks(index).is_empty(),
                lacks: comparison.lacks(index),
                params: &entrant.params,
                state,
                progress,
                message,
            }
        });
        Self {
            version: comparison.version(),
            set: comparison.set().id(),
            sets: RoomSet::all().map(|(_, id, title)| (id, title)).collect(),
            seeds: comparison.seeds(),
            rooms: comparison.rooms().iter().map(|&room| comparison.room_name(room)).collect(),
            done,
            total,
            cancelled: comparison.is_cancelled(),
            entrants: entrants.collect(),
            waiting: comparison.waiting(),
            leaves: comparison.leaves(),
            race: comparison
                .race()
                .filter(|race| !race.lanes().is_empty())
                .map(|race| RaceView::new(race, comparison.race_failure())),
        }
    }
}

impl<'a> RaceView<'a> {
    fn new(race: &Race, failure: &'a str) -> Self {
        let lanes = race.lanes().iter().zip(race.places()).map(|(lane, place)| LaneView {
            place,
            entrant: lane.racer.entrant,
            won_s: lane.won_s(),
            coverage: lane.run().coverage(),
            time_s: lane.run().time_s(),
            distance_m: lane.run().distance_m(),
            turning_deg: lane.run().turning_rad().to_degrees(),
            finished: lane.run().is_finished(),
        });
        Self {
            state: race.state(),
            time_s: race.time_s(),
            end_s: race.end_s(),
            planned_s: race.planned_s(),
            speed: race.speed(),
            waits: race.waits(),
            failure,
            lanes: lanes.collect(),
        }
    }
}

/// A table of numbers.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct TableView {
    metrics: &'static [MetricInfo],
    /// Of a single room.
    bounds: Option<Bounds>,
    least: Option<SweepBound>,
    rows: Vec<RowView>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
struct RowView {
    /// Number of the planner in the view's `entrants`.
    entrant: usize,
    trials: usize,
    missing: usize,
    failure: String,
    values: Vec<Option<MedianAndRange>>,
    /// The exact coverage of its paths and the bounds for it, above which the excess is: medians of seeds, sums over rooms.
    least: Option<SweepBound>,
    /// Which values are the best of their columns.
    best: Vec<bool>,
    /// Whether it leaves floor out that others clean: it then has the best of nothing that costs.
    leaves_floor: bool,
    /// What a paper prints in the place of each value.
    printed: Vec<Option<f64>>,
}

impl TableView {
    /// `table`, with the bounds of its only room.
    pub fn new(table: &ComparisonTable, numbers: Option<&PlanNumbers>) -> Self {
        let rows = table.rows.iter().map(|row| RowView {
            entrant: row.index,
            trials: row.trials,
            missing: row.missing,
            failure: row.failure.clone().unwrap_or_default(),
            values: row.values.clone(),
            least: row.least,
            best: (0..METRICS.len()).map(|column| table.is_best(row, column)).collect(),
            leaves_floor: !row.is_complete,
            printed: METRICS.iter().map(|metric| row.printed?.value(metric.id)).collect(),
        });
        let (bounds, least) = numbers.map_or((None, None), |numbers| (numbers.bounds, numbers.least));
        Self { metrics: METRICS, bounds, least, rows: rows.collect() }
    }
}
