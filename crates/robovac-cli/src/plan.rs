//! `plan`: one walk through one room, with its metrics.

use super::{
    failure::Failure,
    output,
    task::{self, CoverageArguments, MissedCoverage, ParamArguments, PlacementArguments},
};
use coverage_planners::{PlannerInfo, find, metrics::MetricExcess};
use robovac_sim::experiment::{
    Algorithm,
    planning::{CELL_ROBOT, PlanReport, PlanningTask},
};
use serde::Serialize;
use std::time::Instant;

/// Plan a path that covers a room
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    placement: PlacementArguments,
    #[command(flatten)]
    coverage: CoverageArguments,
    /// Planner, see "robovac planners"
    #[arg(long, value_name = "ID")]
    planner: String,
    #[command(flatten)]
    params: ParamArguments,
    /// Write one JSON object instead of a summary
    #[arg(long)]
    json: bool,
}

/// A plan, and the coverage that it misses.
#[derive(Serialize)]
struct PlanOutput {
    #[serde(flatten)]
    report: PlanReport,
    #[serde(skip_serializing_if = "Option::is_none")]
    missed: Option<MissedCoverage>,
}

/// Plans and returns the output.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let planner = planner(&arguments.planner)?;
    let params = arguments.params.checked(planner.params)?;
    let placement = arguments.placement.placement(CELL_ROBOT)?;
    let mut task = PlanningTask { placement, planner, params, seed: arguments.params.seed, is_rounded: false };
    let missed = arguments.coverage.fit_cells(&mut task)?;
    let begin = Instant::now();
    let solution = task.solve(|| begin.elapsed().as_secs_f64(), None)?;
    let output = PlanOutput { report: PlanReport::new(&task, solution), missed };
    Ok(if arguments.json { output::json(&output) } else { summary(&task, &output) })
}

/// The planner with that id.
pub fn planner(id: &str) -> Result<&'static PlannerInfo, Failure> {
    find(id).ok_or_else(|| Failure::unknown("planner", id, "planners"))
}

fn summary(task: &PlanningTask, output: &PlanOutput) -> String {
    let PlanOutput { report, missed } = output;
    let missed = missed.as_ref().map(MissedCoverage::to_text).unwrap_or_default();
    let PlanReport { walk, drive, bounds, .. } = report;
    let above =
        report.above_bound_percent.map(|percent| format!(", the walk is {percent:.1} % above")).unwrap_or_default();
    let (cells, path) = match walk {
        None => (String::new(), format!("Path      {} corners", report.corners_m.len())),
        Some(walk) => (
            format!(", {} reachable cells", walk.reachable_cells),
            format!(
                "Walk      {} steps, {} quarter turns and {} at the start, {} revisits, {:.1} % swept again\n\
                 Bound     at least {} steps, at least {} quarter turns, steps + 2 x turns at least {}{above}",
                walk.steps,
                walk.turns,
                walk.initial_turns,
                walk.revisits,
                100.0 * drive.overlap,
                bounds.steps,
                bounds.turns,
                bounds.cost,
            ),
        ),
    };
    let excess = report.excess.map_or_else(String::new, |MetricExcess { swept, bound, above }| {
        format!(
            "Excess    {:.1} % in metres, {:.1} % in minutes: sweeping {:.2} % takes at least {:.1} m and {}\n",
            100.0 * above[0],
            100.0 * above[1],
            100.0 * swept,
            bound.length_m,
            output::minutes(bound.duration_s),
        )
    });
    format!(
        "{}\
         Coverage  {:.1} % of the reachable floor{cells}\n\
         {missed}\
         {path}\n\
         Drive     {:.1} m in {}, {:.1} Wh\n\
         {excess}\
         Planning  {:.3} s\n",
        task::summary(Algorithm::Planner(task.planner), &task.placement, &report.task),
        100.0 * drive.coverage,
        drive.length_m,
        output::minutes(drive.duration_s),
        drive.energy_wh,
        report.planning_s,
    )
}
