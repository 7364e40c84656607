//! What `plan` and `simulate` have in common: which planner is to cover which room with which robot.

use super::{failure::Failure, source::Source};
use robovac_playground::{
    app::planning::{PlanningTask, TaskReport, choose_robot},
    grid::Cell,
    planner::{Params, PlannerInfo, find},
};

/// Planner, room, robot and start.
#[derive(clap::Args)]
pub struct TaskArguments {
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
    /// Seed of all random numbers
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    /// Parameter of the planner; may be given several times
    #[arg(long = "param", value_name = "KEY=VALUE", value_parser = parse_param)]
    params: Vec<(String, String)>,
    /// Robot, see "robovac robots"; "cell" fills one planning cell [default: "cell" to plan, "roomba600" to simulate]
    #[arg(long, value_name = "ID")]
    robot: Option<String>,
    /// Side of the planning cells in metres [default: a map cell for the robot "cell", else what suits the robot]
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    cell: Option<f64>,
}

impl TaskArguments {
    /// The task, with every name looked up and the room loaded.
    pub fn task(&self, default_robot: &str) -> Result<PlanningTask, Failure> {
        let planner = find(&self.planner).ok_or_else(|| Failure::unknown("planner", &self.planner, "planners"))?;
        let params = checked_params(planner, &self.params)?;
        let plan = self.source.plan()?;
        let robot = self.robot.as_deref().unwrap_or(default_robot);
        let (robot, cell_size) =
            choose_robot(robot, &plan, self.cell).ok_or_else(|| Failure::unknown("robot", robot, "robots"))?;
        Ok(PlanningTask {
            plan,
            robot,
            cell_size,
            start: self.start,
            heading_deg: self.heading,
            planner,
            params,
            seed: self.seed,
        })
    }
}

/// The lines of a summary that say what was asked for.
pub fn summary(task: &PlanningTask, report: &TaskReport) -> String {
    let room = &report.room;
    format!(
        "Planner   {}, seed {}\n\
         Room      {}: {} x {} cells of {} m\n\
         Robot     {}, starts in cell {} with heading {:.0}°\n",
        task.planner.title,
        report.seed,
        room.name,
        room.width,
        room.height,
        room.resolution_m,
        task.robot.title,
        report.start,
        report.heading_deg,
    )
}

/// Values for the planner, each read as what the planner takes; unknown names are refused by the check.
fn checked_params(planner: &PlannerInfo, given: &[(String, String)]) -> Result<Params, Failure> {
    let mut params = Params::defaults(planner.params);
    for (id, text) in given {
        params.set_text(planner.params, id, text)?;
    }
    Ok(params)
}

fn parse_cell(text: &str) -> Result<Cell, String> {
    let cell = text.split_once(',').and_then(|(x, y)| Some(Cell::new(x.trim().parse().ok()?, y.trim().parse().ok()?)));
    cell.ok_or_else(|| "give column and row as two whole numbers, e.g. 3,4".to_owned())
}

fn parse_param(text: &str) -> Result<(String, String), String> {
    let pair = text.split_once('=').filter(|(key, _)| !key.is_empty());
    pair.map(|(key, value)| (key.to_owned(), value.to_owned())).ok_or_else(|| "give it as key=value".to_owned())
}
