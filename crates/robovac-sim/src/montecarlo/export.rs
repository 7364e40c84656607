//! Results as CSV and JSON: the same from the page and from the command line.

use super::{Band, GOALS, RunOutcome, SAMPLES, Summary};
use crate::experiment::quoted;
use crate::{Conditions, SlipLevel, experiment::Entrant};
use robovac_core::{registry::Params, robot::OdometryModel};
use serde::Serialize;
use std::fmt::Write;

/// Settings that all runs have in common.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct RunsHeader<'a> {
    /// Name of the room.
    pub room: &'a str,
    /// Name of the robot, as [`Settings::robot_name`](crate::experiment::Settings::robot_name) has it.
    pub robot: &'a str,
    /// Side of the planning cells, m.
    pub cell_size_m: f64,
    /// Slip, noise and battery.
    #[serde(skip)]
    pub conditions: Conditions,
    /// How followers of planned paths compute their poses.
    pub odometry: OdometryModel,
    /// Whether they round corners.
    pub smooth: bool,
    /// Simulated time of each run, min.
    pub minutes: f64,
}

/// An algorithm with its runs, or the reason for the failure.
pub type EntrantRuns<'a> = (&'a Entrant, Result<Vec<&'a RunOutcome>, &'a str>);

#[derive(Serialize)]
struct JsonStudy<'a> {
    #[serde(flatten)]
    head: RunsHeader<'a>,
    slip: SlipLevel,
    noise: String,
    quantised: bool,
    start_charge_percent: u8,
    /// The times of all curves' samples, s.
    times_s: Vec<f64>,
    algorithms: Vec<JsonAlgorithm<'a>>,
}

#[derive(Serialize)]
struct JsonAlgorithm<'a> {
    algorithm: &'static str,
    kind: &'static str,
    /// Whether coverage and times refer to floor or boundary.
    measure: &'static str,
    params: &'a Params,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<&'a str>,
    #[serde(flatten)]
    summary: Option<Summary>,
    /// Coverage over time, 0 to 1, as quantiles over the runs.
    curve: JsonCurve,
    /// The runs one by one.
    each: Vec<JsonRun>,
}

#[derive(Serialize)]
struct JsonCurve {
    low: Vec<f64>,
    median: Vec<f64>,
    high: Vec<f64>,
}

#[derive(Serialize)]
struct JsonRun {
    seed: u64,
    coverage: f64,
    /// Times at which the goals were reached, s; `null` if they weren't.
    reached_s: [Option<f64>; GOALS.len()],
    time_s: f64,
    distance_m: f64,
    bumps: u32,
    falls: u32,
    dirt_left: Option<f64>,
    /// Excess of distance and time, as shares.
    excess: Option<[f64; 2]>,
    digest: String,
}

/// A JSON object: the settings, and for each algorithm quantiles over its runs and every single run.
pub fn to_json(head: &RunsHeader<'_>, entries: &[EntrantRuns<'_>]) -> String {
    let study = JsonStudy {
        head: *head,
        slip: head.conditions.slip,
        noise: head.conditions.noise.to_string(),
        quantised: head.conditions.quantised,
        start_charge_percent: head.conditions.start_charge_percent,
        times_s: (0..=SAMPLES).map(|i| 60.0 * head.minutes * i as f64 / SAMPLES as f64).collect(),
        algorithms: entries.iter().map(JsonAlgorithm::of).collect(),
    };
    // Fails only for maps whose keys aren't strings.
    serde_json::to_string(&study).unwrap_or_default() + "\n"
}

/// A table with a header line, one line per run; empty for missing values.
pub fn to_csv(head: &RunsHeader<'_>, entries: &[EntrantRuns<'_>]) -> String {
    let mut csv = String::from(
        "room,robot,slip,noise,rounded wheel speeds,start charge [%],minutes,kind,algorithm,seed,error,coverage [%],time to 90 % [s],time to 99 % [s],\
         time [s],distance [m],bumps,falls,dirt left [%],excess distance [%],\
         excess time [%],digest,measure\n",
    );
    let Conditions { slip, quantised, start_charge_percent, .. } = head.conditions;
    let common = format!(
        "{},{},{},{},{quantised},{start_charge_percent},{}",
        quoted(head.room),
        quoted(head.robot),
        slip.id(),
        quoted(&head.conditions.noise.to_string()),
        head.minutes
    );
    for (entrant, result) in entries {
        let (kind, measure) = (entrant.algorithm.kind(), measure(entrant));
        // Writing to a string doesn't fail.
        let _ = match result {
            Err(error) => writeln!(csv, "{common},{kind},{entrant},,{},,,,,,,,,,,,{measure}", quoted(error)),
            Ok(runs) => runs.iter().try_for_each(|run| {
                let [to_90, to_99] = run.reached_s.map(|s| if s.is_finite() { s.to_string() } else { String::new() });
                let RunOutcome { seed, time_s, distance_m, bumps, falls, digest, .. } = run;
                let coverage = 100.0 * run.coverage();
                let dirt = run.dirt_left.map(|left| (100.0 * left).to_string()).unwrap_or_default();
                let [more_m, more_s] = [0, 1].map(|i| run.excess.map_or_else(String::new, |above| (100.0 * above[i]).to_string()));
                writeln!(
                    csv,
                    "{common},{kind},{entrant},{seed},,{coverage},{to_90},{to_99},{time_s},{distance_m},{bumps},{falls},{dirt},{more_m},{more_s},{digest:016x},{measure}"
                )
            }),
        };
    }
    csv
}

/// What shares refer to: swept floor or detected boundary.
fn measure(entrant: &Entrant) -> &'static str {
    if entrant.explores() { "boundary" } else { "floor" }
}

impl<'a> JsonAlgorithm<'a> {
    fn of((entrant, result): &'a EntrantRuns<'a>) -> Self {
        let runs = result.as_deref().unwrap_or_default();
        let bands = Band::curve(runs);
        let line = |of: fn(&Band) -> f64| bands.iter().map(of).collect();
        Self {
            algorithm: entrant.id(),
            kind: entrant.algorithm.kind(),
            measure: measure(entrant),
            params: &entrant.params,
            error: result.as_ref().err().copied(),
            summary: Summary::of(runs),
            curve: JsonCurve { low: line(|b| b.low), median: line(|b| b.median), high: line(|b| b.high) },
            each: runs.iter().map(|run| JsonRun::of(run)).collect(),
        }
    }
}

impl JsonRun {
    fn of(run: &RunOutcome) -> Self {
        Self {
            seed: run.seed,
            coverage: run.coverage(),
            reached_s: run.reached_s.map(|time| Some(time).filter(|time| time.is_finite())),
            time_s: run.time_s,
            distance_m: run.distance_m,
            bumps: run.bumps,
            falls: run.falls,
            dirt_left: run.dirt_left,
            excess: run.excess,
            digest: format!("{:016x}", run.digest),
        }
    }
}
