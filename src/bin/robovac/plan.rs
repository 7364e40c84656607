//! `plan`: one walk over one room, with its numbers.

use super::{
    failure::Failure,
    output,
    task::{self, TaskArguments},
};
use robovac_playground::app::planning::{self, CELL_ROBOT, PlanReport, PlanningTask};
use std::time::Instant;

/// Plan a walk that covers a room
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    task: TaskArguments,
    /// Write one JSON object instead of a summary
    #[arg(long)]
    json: bool,
}

/// Plans and returns what is to be printed.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let task = arguments.task.task(CELL_ROBOT)?;
    let begin = Instant::now();
    let report = planning::run(&task, || begin.elapsed().as_secs_f64(), None)?.report;
    Ok(if arguments.json { output::json(&report) } else { summary(&task, &report) })
}

fn summary(task: &PlanningTask, report: &PlanReport) -> String {
    format!(
        "{}\
         Coverage  {:.1} % of the reachable floor, {} reachable cells\n\
         Walk      {} steps, {} quarter turns and {} at the start, {} revisits, {:.1} % overlap\n\
         Drive     {:.1} m in {}\n\
         Planning  {:.3} s\n",
        task::summary(task, &report.task),
        100.0 * report.coverage,
        report.reachable_cells,
        report.steps,
        report.turns,
        report.initial_turns,
        report.revisits,
        100.0 * report.overlap,
        report.length_m,
        output::minutes(report.duration_s),
        report.planning_s,
    )
}
