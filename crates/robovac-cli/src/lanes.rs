//! `lanes`: a path in metres through a room, with its bounds.

use super::{failure::Failure, output, simulate::parse_seconds, source::RoomSource, sweep::unknown_ending};
use coverage_planners::lanes::{
    LanesError, LanesObjective, LanesPlan, LanesProgress, LanesSetup, MetricBound, plan_lanes,
};
use coverage_planners::{
    smooth::{SmoothPath, SmoothSetup},
    sweep::planned_for,
};
use robovac_app::export::{PathFormat, SavedPath, path_dxf};
use robovac_core::{
    coverage::ReachableFloor,
    robot::{OdometryModel, RobotModel, model},
    trajectory::Trajectory,
};
use robovac_sim::{
    Conditions,
    experiment::planning::{PathToDrive, PlanningError, RoomSetup},
};
use serde::Serialize;
use std::{
    fs,
    ops::ControlFlow,
    path::{Path, PathBuf},
    sync::Arc,
    time::Instant,
};

/// Plan lanes in metres: the shortest time, or distance, found for a share of the floor
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    source: RoomSource,
    /// Robot, see "robovac robots"
    #[arg(long, value_name = "ID", default_value = "roomba600")]
    robot: String,
    /// Share of the reachable floor to sweep, percent
    #[arg(long, value_name = "PERCENT", default_value_t = 99.0)]
    coverage: f64,
    /// Least room between body and obstacles, m
    #[arg(long, value_name = "M", default_value_t = LanesSetup::default().clearance)]
    clearance: f64,
    /// How far neighbouring lanes overlap, m
    #[arg(long, value_name = "M", default_value_t = LanesSetup::default().overlap)]
    overlap: f64,
    /// What the search minimises
    #[arg(long, value_name = "time|distance", default_value = "time", value_parser = ["time", "distance"])]
    minimise: String,
    /// Moves that the search tries for every metre of the bound; 0 keeps the first path
    #[arg(long, value_name = "N", default_value_t = LanesSetup::default().effort, conflicts_with = "seconds")]
    effort: f64,
    /// Search for this many seconds instead; the path then depends on the machine
    #[arg(long, value_name = "S", value_parser = parse_seconds)]
    seconds: Option<f64>,
    /// Random seed
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    /// Round the corners: the search counts the time of curves, and sweeps a little more than asked, as curves may
    /// leave floor out
    #[arg(long)]
    smooth: bool,
    /// Drive the path in the simulator, too, without noise
    #[arg(long)]
    drive: bool,
    /// Output file; can be repeated; its extension chooses the format: .csv table, .yaml ROS path, .mcap ROS 2 bag, .oi.txt
    /// Open Interface bytes for a Roomba 600, .txt program, .dxf drawing of room and path; with --smooth along the curves
    #[arg(long, value_name = "FILE")]
    out: Vec<PathBuf>,
    /// Write one JSON object instead of a summary
    #[arg(long)]
    json: bool,
}

/// The numbers of a path.
#[derive(Serialize)]
struct LanesReport<'a> {
    room: &'a str,
    robot: &'a str,
    seed: u64,
    floor_m2: f64,
    required_coverage: f64,
    coverage: f64,
    clearance_m: f64,
    corners: usize,
    length_m: f64,
    duration_s: f64,
    bound_length_m: f64,
    bound_duration_s: f64,
    /// Above the bounds for the coverage reached, as shares.
    excess_length: f64,
    excess_duration: f64,
    first_path_s: Option<f64>,
    planning_s: f64,
    /// With rounded corners.
    smooth: Option<SmoothReport>,
    driven: Option<DrivenReport>,
}

/// The path with rounded corners.
#[derive(Serialize)]
struct SmoothReport {
    /// Rounded corners.
    rounded: usize,
    length_m: f64,
    duration_s: f64,
    coverage: f64,
    /// Above the bounds on paths without stops for the coverage reached, as shares.
    bound_length_m: f64,
    bound_duration_s: f64,
    excess_length: f64,
    excess_duration: f64,
}

/// The path driven in the simulator.
#[derive(Serialize)]
struct DrivenReport {
    length_m: f64,
    duration_s: f64,
    coverage: f64,
    bumps: u32,
}

/// Plans, writes the files, and returns the output.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let robot = model(&arguments.robot).ok_or_else(|| Failure::unknown("robot", &arguments.robot, "robots"))?;
    let formats: Vec<PathFormat> = arguments.out.iter().map(|out| format_of(out)).collect::<Result<_, _>>()?;
    let plan = arguments.source.plan()?;
    let floor = ReachableFloor::new(&plan, robot, None).map_err(PlanningError::from)?;
    let setup = LanesSetup {
        coverage: arguments.coverage / 100.0,
        clearance: arguments.clearance,
        overlap: arguments.overlap,
        effort: if arguments.seconds.is_some() { LanesSetup::MOST_EFFORT } else { arguments.effort },
        seed: arguments.seed,
        objective: if arguments.minimise == "distance" { LanesObjective::Distance } else { LanesObjective::Time },
        is_rounded: arguments.smooth,
    };
    let begin = Instant::now();
    let mut first_path_s = None;
    let found = plan_lanes(&floor, robot, &setup, &mut |progress: LanesProgress<'_>| {
        let now = begin.elapsed().as_secs_f64();
        if !progress.path.is_empty() {
            first_path_s.get_or_insert(now);
        }
        ControlFlow::Continue(arguments.seconds.map_or(0.0, |seconds| now / seconds))
    })?;
    let planning_s = begin.elapsed().as_secs_f64();
    let area = floor.area();
    let required = arguments.coverage / 100.0;
    let room = RoomSetup::on(&plan, floor, robot, robot.default_cell);
    let smooth = if arguments.smooth {
        let setup = SmoothSetup { loss: 0.0, least: required, clearance: found.clearance, ..SmoothSetup::default() };
        let path = room.smooth(&found.path, &setup, false);
        Some(path.map_err(|error| Failure::usage(format!("--smooth: {error}")))?)
    } else {
        None
    };
    let trajectory = smooth.as_ref().map(|path| &path.trajectory);
    let path = SavedPath { corners: &found.path, heading: room.floor.start.heading, smooth: trajectory };
    for (out, format) in arguments.out.iter().zip(formats) {
        let content = format.bytes(path, &plan, robot, &planned_for(robot), || path_dxf(&plan, path))?;
        fs::write(out, content).map_err(|error| Failure::io(out.display(), &error))?;
    }
    let trajectory = smooth.as_ref().map(|path| Arc::new(path.trajectory.clone()));
    let driven = arguments.drive.then(|| drive(&room, &found, trajectory));
    let report = LanesReport {
        room: &plan.name,
        robot: robot.id,
        seed: setup.seed,
        floor_m2: area,
        required_coverage: required,
        coverage: found.coverage,
        clearance_m: found.clearance,
        corners: found.path.len(),
        length_m: found.length_m,
        duration_s: found.duration_s,
        bound_length_m: found.bound.length_m,
        bound_duration_s: found.bound.duration_s,
        excess_length: found.excess[0],
        excess_duration: found.excess[1],
        first_path_s,
        planning_s,
        smooth: smooth.map(|path| SmoothReport::of(&path, &room)),
        driven,
    };
    Ok(if arguments.json { output::json(&report) } else { summary(&report, robot) })
}

impl SmoothReport {
    fn of(path: &SmoothPath, room: &RoomSetup) -> Self {
        let RoomSetup { floor, robot, .. } = room;
        let (length_m, duration_s) = (path.trajectory.length_m(), path.trajectory.duration_s());
        let bound = MetricBound::without_stops(floor, robot, path.coverage);
        let [excess_length, excess_duration] = bound.excess(length_m, duration_s);
        Self {
            rounded: path.rounded,
            length_m,
            duration_s,
            coverage: path.coverage,
            bound_length_m: bound.length_m,
            bound_duration_s: bound.duration_s,
            excess_length,
            excess_duration,
        }
    }
}

fn drive(room: &RoomSetup, found: &LanesPlan, smooth: Option<Arc<Trajectory>>) -> DrivenReport {
    let driven = PathToDrive { line: found.path.clone().into(), smooth };
    let mut run = room.run_driven(&driven, Conditions::default(), OdometryModel::Arc, 0);
    while !run.is_finished() {
        run.step();
    }
    DrivenReport { length_m: run.distance_m(), duration_s: run.time_s(), coverage: run.coverage(), bumps: run.bumps() }
}

fn format_of(out: &Path) -> Result<PathFormat, Failure> {
    PathFormat::of_file(out).ok_or_else(|| unknown_ending(out, ".csv, .yaml, .mcap, .oi.txt, .txt or .dxf"))
}

fn summary(report: &LanesReport<'_>, robot: &RobotModel) -> String {
    let driven = report.driven.as_ref().map_or_else(String::new, |run| {
        format!(
            "Driven    {:.1} m in {}, {:.2} % of the floor, bumps: {}\n",
            run.length_m,
            output::minutes(run.duration_s),
            100.0 * run.coverage,
            run.bumps
        )
    });
    let smooth = report.smooth.as_ref().map_or_else(String::new, |path| {
        format!(
            "Smooth    {:.1} m in {}, {:.2} % of the floor, {} corners rounded\n\
             Excess    {:.1} % in metres, {:.1} % in minutes: without stops at least {:.1} m and {}\n",
            path.length_m,
            output::minutes(path.duration_s),
            100.0 * path.coverage,
            path.rounded,
            100.0 * path.excess_length,
            100.0 * path.excess_duration,
            path.bound_length_m,
            output::minutes(path.bound_duration_s),
        )
    });
    let short = if report.coverage < report.required_coverage {
        format!(", {:.2} % asked for", 100.0 * report.required_coverage)
    } else {
        String::new()
    };
    format!(
        "Room      {}, {:.1} m² of reachable floor\n\
         Robot     {}, {:.1} mm off obstacles or more\n\
         Coverage  {:.2} %{short}\n\
         Path      {:.1} m in {}, {} corners\n\
         Bound     at least {:.1} m and {} for {:.2} %\n\
         Excess    {:.1} % in metres, {:.1} % in minutes\n\
         {smooth}{driven}\
         Planning  {:.2} s, first path after {:.2} s\n",
        report.room,
        report.floor_m2,
        robot.title,
        1000.0 * report.clearance_m,
        100.0 * report.coverage,
        report.length_m,
        output::minutes(report.duration_s),
        report.corners,
        report.bound_length_m,
        output::minutes(report.bound_duration_s),
        100.0 * report.required_coverage,
        100.0 * report.excess_length,
        100.0 * report.excess_duration,
        report.planning_s,
        report.first_path_s.unwrap_or(report.planning_s),
    )
}

impl From<LanesError> for Failure {
    fn from(error: LanesError) -> Self {
        match error {
            LanesError::Value { .. } => Self::usage(error.to_string()),
            LanesError::Cancelled => Self::planner(error.to_string()),
        }
    }
}
