//! Arguments shared by the commands: room, robot, start and parameters.

use super::{failure::Failure, source::RoomSource};
use robovac_core::{
    floor_plan::FloorPlan,
    grid::Cell,
    registry::{ParamSpec, Params},
};
use robovac_sim::experiment::{
    Algorithm, Settings,
    planning::{GivenStart, Placement, PlanningTask, TaskReport, choose_robot},
};
use serde::Serialize;
use std::ops::ControlFlow;

/// Room, robot and start.
#[derive(clap::Args)]
pub struct PlacementArguments {
    #[command(flatten)]
    source: RoomSource,
    /// Planning cell to start in: column and row, counted from 0 at the lower left [default: the map's own start]
    #[arg(long, value_name = "X,Y", value_parser = parse_cell, allow_hyphen_values = true)]
    start: Option<Cell>,
    /// Heading at the start, degrees counter-clockwise from 0 = right [default: 0 with --start, else the map's own]
    #[arg(long, value_name = "DEG", allow_hyphen_values = true)]
    heading: Option<f64>,
    /// Robot, see "robovac robots"; "cell" fills one planning cell [default: "cell" to plan, else "roomba600"]
    #[arg(long, value_name = "ID")]
    robot: Option<String>,
    /// Planning cell size in metres [default: the map's cell size for the robot "cell", else chosen for the robot]
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    cell: Option<f64>,
}

/// Cells chosen for a coverage.
#[derive(clap::Args)]
pub struct CoverageArguments {
    /// Choose the planning cells with which the planner sweeps this share of the reachable floor in the least time
    #[arg(long, value_name = "PERCENT", value_parser = parse_percent, conflicts_with = "cell")]
    coverage: Option<f64>,
}

/// A coverage that no planning cells reach.
#[derive(Serialize)]
pub struct MissedCoverage {
    /// What was asked for, as a share of the reachable floor, 0 to 1.
    asked: f64,
    /// The most that any cells reach, and their side.
    most: f64,
    cell_size_m: f64,
}

/// Parameters and seed of one algorithm.
#[derive(clap::Args)]
pub struct ParamArguments {
    /// Parameter of the algorithm; can be repeated
    #[arg(long = "param", value_name = "KEY=VALUE", value_parser = parse_param)]
    params: Vec<(String, String)>,
    /// Random seed
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u64,
}

impl PlacementArguments {
    /// The robot in its room, with every name looked up and the room loaded.
    pub fn placement(&self, default_robot: &str) -> Result<Placement, Failure> {
        let plan = self.source.plan()?;
        let robot = self.robot.as_deref().unwrap_or(default_robot);
        let (robot, cell_size) =
            choose_robot(robot, &plan, self.cell).ok_or_else(|| Failure::unknown("robot", robot, "robots"))?;
        Ok(Placement {
            plan,
            robot,
            cells: cell_size.into(),
            start: self.start.map(GivenStart::Cell),
            heading_deg: self.heading,
        })
    }
}

impl PlacementArguments {
    /// What a scenario file alone says: its room and all settings.
    pub fn scenario(&self) -> Result<(FloorPlan, Settings), Failure> {
        let found =
            self.source.scenario()?.filter(|(_, choices)| choices.algorithm().is_some() || choices.path.is_some());
        let (plan, choices) = found.ok_or_else(|| {
            Failure::usage(
                "give --planner or --behaviour, or as --map a scenario with an algorithm or a path".to_owned(),
            )
        })?;
        if self.start.is_some() || self.heading.is_some() || self.robot.is_some() || self.cell.is_some() {
            let what = "--start, --heading, --robot and --cell";
            return Err(Failure::usage(format!("{what}: the scenario has these; leave them out, or give --planner")));
        }
        let settings = choices.settings(&Settings::new()).map_err(|error| Failure::usage(error.to_string()))?;
        let by_hand = settings.algorithm.behaviour().is_some_and(|info| info.claims.manual);
        if by_hand && settings.path.is_none() {
            return Err(Failure::usage("the scenario's robot is driven by hand; use it on the page".to_owned()));
        }
        if settings.algorithm.is_program() && settings.path.is_none() {
            return Err(Failure::usage("the scenario runs a program; use \"robovac run\" with its file".to_owned()));
        }
        Ok((plan, settings))
    }
}

impl CoverageArguments {
    /// Whether cells are to be chosen.
    pub fn is_given(&self) -> bool {
        self.coverage.is_some()
    }

    /// Sets the task's planning cells, if they are to be chosen for a coverage; returns what is missing if none reach it. The
    /// start in cells is one of the default cells.
    pub fn fit_cells(&self, task: &mut PlanningTask) -> Result<Option<MissedCoverage>, Failure> {
        let Some(percent) = self.coverage else { return Ok(None) };
        let share = percent / 100.0;
        let fitted = task.fit_cells(share, &mut |_| ControlFlow::Continue(()))?;
        let missed = MissedCoverage { asked: share, most: fitted.coverage, cell_size_m: fitted.cells.size };
        Ok((missed.most < missed.asked).then_some(missed))
    }
}

impl MissedCoverage {
    /// A line of a summary.
    pub fn to_text(&self) -> String {
        let Self { asked, most, cell_size_m } = self;
        let (asked, most) = (100.0 * asked, 100.0 * most);
        format!(
            "Missed    none of the planning cells tried reach {asked:.2} %: those of {cell_size_m} m sweep most, {most:.2} %\n"
        )
    }
}

impl ParamArguments {
    /// Whether a parameter or seed was given.
    pub fn are_given(&self) -> bool {
        !self.params.is_empty() || self.seed != 0
    }

    /// Values for all of `specs`, each parsed by its kind; unknown names are refused by the check.
    pub fn checked(&self, specs: &[ParamSpec]) -> Result<Params, Failure> {
        let mut params = Params::defaults(specs);
        for (id, text) in &self.params {
            params.set_text(specs, id, text)?;
        }
        Ok(params)
    }
}

/// The lines of a summary that name the task.
pub fn summary(algorithm: Algorithm, placement: &Placement, report: &TaskReport) -> String {
    let room = &report.room;
    let kind = if algorithm.planner().is_some() { "Planner" } else { "Behaviour" };
    let begun =
        room.offset_m.map_or_else(String::new, |[x, y]| format!(", begun {x} m left of the corner and {y} m below it"));
    format!(
        "{kind:10}{}, seed {}\n\
         Room      {}: {} x {} cells of {} m{begun}\n\
         Robot     {}, starts in cell {} with heading {:.0}°\n",
        algorithm.title(),
        report.seed,
        room.name,
        room.width,
        room.height,
        room.resolution_m,
        placement.robot.title,
        report.start,
        report.heading_deg,
    )
}

fn parse_percent(text: &str) -> Result<f64, String> {
    let percent = text.parse().ok().filter(|percent: &f64| (0.0..=100.0).contains(percent));
    percent.ok_or_else(|| "give a number from 0 to 100, e.g. 99".to_owned())
}

pub fn parse_cell(text: &str) -> Result<Cell, String> {
    let cell = text.split_once(',').and_then(|(x, y)| Some(Cell::new(x.trim().parse().ok()?, y.trim().parse().ok()?)));
    cell.ok_or_else(|| "give column and row as two whole numbers, e.g. 3,4".to_owned())
}

fn parse_param(text: &str) -> Result<(String, String), String> {
    let pair = text.split_once('=').filter(|(key, _)| !key.is_empty());
    pair.map(|(key, value)| (key.to_owned(), value.to_owned())).ok_or_else(|| "give it as key=value".to_owned())
}
