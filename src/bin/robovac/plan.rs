//! `plan`: one walk over one room, with its numbers.

use super::{failure::Failure, source::Source};
use robovac_playground::{
    app::planning::{CELL_ROBOT, PlanReport, PlanningTask, choose_robot, run as run_task},
    grid::Cell,
    planner::{Params, PlannerInfo, find},
    robot::RobotModel,
};
use std::time::Instant;

/// Plan a walk that covers a room
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    source: Source,
    /// Planner, see "robovac planners"
    #[arg(long, value_name = "ID")]
    planner: String,
    /// Planning cell to start in: column and row, counted from 0 at the lower left [default: the map's own start]
    #[arg(long, value_name = "X,Y", value_parser = parse_cell, allow_hyphen_values = true)]
    start: Option<Cell>,
    /// Heading at the start, degrees counter-clockwise from 0 = right [default: 0 with --start, else the map's own]
    #[arg(long, value_name = "DEG", allow_hyphen_values = true)]
    heading: Option<f64>,
    /// Seed of the planner's random numbers
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    /// Parameter of the planner; may be given several times
    #[arg(long = "param", value_name = "KEY=VALUE", value_parser = parse_param)]
    params: Vec<(String, String)>,
    /// Robot, see "robovac robots"; "cell" fills one planning cell
    #[arg(long, value_name = "ID", default_value = CELL_ROBOT)]
    robot: String,
    /// Side of the planning cells in metres [default: a map cell for the robot "cell", else what suits the robot]
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    cell: Option<f64>,
    /// Write one JSON object instead of a summary
    #[arg(long)]
    json: bool,
}

/// Plans and returns what is to be printed.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let planner =
        find(&arguments.planner).ok_or_else(|| Failure::unknown("planner", &arguments.planner, "planners"))?;
    let params = checked_params(planner, &arguments.params)?;
    let plan = arguments.source.plan()?;
    let (robot, cell_size) = choose_robot(&arguments.robot, &plan, arguments.cell)
        .ok_or_else(|| Failure::unknown("robot", &arguments.robot, "robots"))?;
    let task = PlanningTask {
        plan: &plan,
        robot: &robot,
        cell_size,
        start: arguments.start,
        heading_deg: arguments.heading,
        planner,
        params: &params,
        seed: arguments.seed,
    };
    let begin = Instant::now();
    let report = run_task(&task, || begin.elapsed().as_secs_f64(), None)?.report;
    Ok(if arguments.json { to_json(&report) } else { summary(&report, planner, &robot) })
}

/// Values for the planner, each read as what the planner takes; unknown names are refused by the check.
fn checked_params(planner: &PlannerInfo, given: &[(String, String)]) -> Result<Params, Failure> {
    let value = |(key, text): &(String, String)| {
        let spec = planner.params.iter().find(|spec| spec.id == key);
        spec.map_or_else(|| robovac_playground::planner::ParamValue::Choice(text.clone()), |spec| spec.kind.parse(text))
    };
    Ok(Params::checked(planner.params, given.iter().map(|pair| (pair.0.as_str(), value(pair))))?)
}

fn to_json(report: &PlanReport) -> String {
    // Numbers, strings and lists: nothing in here can fail to be written.
    serde_json::to_string(report).unwrap_or_default() + "\n"
}

fn summary(report: &PlanReport, planner: &PlannerInfo, robot: &RobotModel) -> String {
    let room = &report.room;
    let seconds = report.duration_s.round() as u64;
    format!(
        "Planner   {}, seed {}\n\
         Room      {}: {} x {} cells of {} m\n\
         Robot     {}, starts in cell {} with heading {:.0}°\n\
         Coverage  {:.1} % of the reachable floor, {} reachable cells\n\
         Walk      {} steps, {} quarter turns and {} at the start, {} revisits, {:.1} % overlap\n\
         Drive     {:.1} m in {} min {} s\n\
         Planning  {:.3} s\n",
        planner.title,
        report.seed,
        room.name,
        room.width,
        room.height,
        room.resolution_m,
        robot.title,
        report.start,
        report.heading_deg,
        100.0 * report.coverage,
        report.reachable_cells,
        report.steps,
        report.turns,
        report.initial_turns,
        report.revisits,
        100.0 * report.overlap,
        report.length_m,
        seconds / 60,
        seconds % 60,
        report.planning_s,
    )
}

fn parse_cell(text: &str) -> Result<Cell, String> {
    let cell = text.split_once(',').and_then(|(x, y)| Some(Cell::new(x.trim().parse().ok()?, y.trim().parse().ok()?)));
    cell.ok_or_else(|| "give column and row as two whole numbers, e.g. 3,4".to_owned())
}

fn parse_param(text: &str) -> Result<(String, String), String> {
    let pair = text.split_once('=').filter(|(key, _)| !key.is_empty());
    pair.map(|(key, value)| (key.to_owned(), value.to_owned())).ok_or_else(|| "give it as key=value".to_owned())
}
