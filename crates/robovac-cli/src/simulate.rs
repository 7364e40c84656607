//! `simulate`: a robot drives a planned walk by its own pose estimate, or runs a behaviour.

use super::{
    bag_file::BagFile,
    conditions::ConditionsArguments,
    failure::Failure,
    output, plan,
    task::{self, CoverageArguments, MissedCoverage, ParamArguments, PlacementArguments},
    twin,
};
use coverage_planners::smooth::{SmoothPath, SmoothSetup};
use robovac_core::{floor_plan::ScenarioPose, geometry::MetricPath, registry::Params, robot::OdometryModel};
use robovac_ros::{Pace, RunTopics, SourceMap};
use robovac_sim::{
    Conditions, Run, STEP_S, SlipLevel, What,
    controller::{self, BehaviourInfo},
    experiment::{
        Algorithm, Settings,
        planning::{PathToDrive, Placement, PlanSolution, Planned, PlanningError, PlanningTask, RoomSetup, TaskReport},
    },
};
use serde::Serialize;
use std::{fmt::Write, path::PathBuf, sync::Arc, time::Instant};

/// The default robot.
pub const DEFAULT_ROBOT: &str = "roomba600";
/// Default time after which a behaviour that doesn't end by itself is stopped, s.
const MOST_TIME_S: f64 = 1800.0;

/// Simulate a cleaning robot that follows a plan or a behaviour
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    placement: PlacementArguments,
    #[command(flatten)]
    coverage: CoverageArguments,
    #[command(flatten)]
    algorithm: AlgorithmArguments,
    #[command(flatten)]
    params: ParamArguments,
    #[command(flatten)]
    conditions: ConditionsArguments,
    /// Simulate a twin: a file of "robovac twin --json". Its levels of slip and noise apply where none is given
    #[arg(long, value_name = "FILE", conflicts_with = "robot")]
    twin: Option<PathBuf>,
    /// Round the corners of a plan: curves instead of stops where they keep the floor swept
    #[arg(long, conflicts_with = "behaviour")]
    smooth: bool,
    /// Simulated time between two samples
    #[arg(long, value_name = "SECONDS", default_value_t = 10.0, value_parser = parse_seconds, allow_hyphen_values = true)]
    sample: f64,
    /// Simulated time limit [default: none; 1800 for behaviours that never finish]
    #[arg(long, value_name = "SECONDS", value_parser = parse_seconds, allow_hyphen_values = true)]
    max_time: Option<f64>,
    /// Write ROS 2 messages as MCAP, for Foxglove and "ros2 bag"
    #[arg(long, value_name = "FILE")]
    mcap: Option<PathBuf>,
    /// Write one JSON object instead of a table and a summary
    #[arg(long)]
    json: bool,
}

/// One of the two, unless a scenario says it.
#[derive(clap::Args)]
#[group(multiple = false)]
struct AlgorithmArguments {
    /// Planner, see "robovac planners" [default: all that the scenario of --map says]
    #[arg(long, value_name = "ID")]
    planner: Option<String>,
    /// Behaviour, see "robovac behaviours"
    #[arg(long, value_name = "ID")]
    behaviour: Option<String>,
}

/// What is simulated.
struct SimulatedTask {
    placement: Placement,
    algorithm: Algorithm,
    params: Params,
    seed: u64,
    conditions: Conditions,
    odometry: OdometryModel,
    smooth: bool,
    /// Driven in place of the planner's.
    path: Option<MetricPath>,
}

/// Report of a run.
#[derive(Serialize)]
struct SimulateReport {
    #[serde(flatten)]
    task: TaskReport,
    slip: SlipLevel,
    noise: String,
    quantised: bool,
    start_charge_percent: u8,
    odometry: OdometryModel,
    /// Corners of the scenario's path, which is driven in place of the planner's.
    #[serde(skip_serializing_if = "Option::is_none")]
    path_corners: Option<usize>,
    /// The coverage that was asked for, if no planning cells reach it.
    #[serde(skip_serializing_if = "Option::is_none")]
    missed: Option<MissedCoverage>,
    /// The plan with rounded corners, if they are.
    #[serde(skip_serializing_if = "Option::is_none")]
    smooth: Option<RoundedPlan>,
    #[serde(flatten)]
    totals: Totals,
    samples: Vec<SimulateSample>,
}

/// A plan with rounded corners.
#[derive(Serialize)]
struct RoundedPlan {
    corners: usize,
    rounded: usize,
    /// Time by the robot's motion model.
    planned_s: f64,
    /// Swept share of the reachable floor, exact, 0 to 1.
    planned_coverage: f64,
    /// The same with a stop at every corner.
    stopped_s: f64,
    stopped_coverage: f64,
}

/// The numbers of a run when it is over or was stopped.
#[derive(Serialize)]
struct Totals {
    time_s: f64,
    /// Swept share of the reachable floor, 0 to 1.
    coverage: f64,
    distance_m: f64,
    turning_deg: f64,
    /// How often the bumper was pressed.
    bumps: u32,
    /// Area swept again, as a share of the area swept.
    overlap: f64,
    /// Distance between the robot's true and estimated position.
    pose_error_m: Option<f64>,
    /// Whether the robot has finished.
    finished: bool,
    /// Whether the battery was empty before that.
    battery_empty: bool,
    /// In hexadecimal; two runs share it only if they are in the same state, to the last bit.
    digest: String,
}

/// One moment of a run.
#[derive(Serialize)]
struct SimulateSample {
    time_s: f64,
    /// Swept share of the reachable floor, 0 to 1.
    coverage: f64,
    /// Where the robot is.
    pose: ScenarioPose,
    /// Its estimated pose.
    estimate: Option<ScenarioPose>,
}

impl Arguments {
    /// By the options, or if they name no algorithm by the scenario.
    fn task(&self) -> Result<SimulatedTask, Failure> {
        let Some(algorithm) = self.algorithm.find()? else { return self.scenario() };
        let params = self.params.checked(algorithm.params())?;
        let mut placement = self.placement.placement(DEFAULT_ROBOT)?;
        let mut conditions = Conditions::default();
        if let Some(path) = &self.twin {
            let file = twin::open(path)?;
            placement.robot = file.twin.of(&placement.robot);
            conditions = file.conditions(conditions);
        }
        let (seed, odometry, smooth, path) = (self.params.seed, self.conditions.odometry, self.smooth, None);
        let conditions = self.conditions.over(conditions);
        Ok(SimulatedTask { placement, algorithm, params, seed, conditions, odometry, smooth, path })
    }

    /// The scenario's run, with other slip, noise or charge if they are given.
    fn scenario(&self) -> Result<SimulatedTask, Failure> {
        let (plan, settings) = self.placement.scenario()?;
        if self.params.are_given() || self.coverage.is_given() || self.twin.is_some() {
            let what = "--param, --seed, --coverage and --twin";
            return Err(Failure::usage(format!("{what}: the scenario has these; leave them out, or give --planner")));
        }
        let (robot, conditions) = (settings.robot_model(), self.conditions.over(settings.conditions));
        let cells = settings.cells();
        let Settings { algorithm, params, seed, odometry, path, .. } = settings;
        let placement = Placement { plan, robot, cells, start: None, heading_deg: None };
        let smooth = self.smooth || settings.smooth;
        Ok(SimulatedTask { placement, algorithm, params, seed, conditions, odometry, smooth, path })
    }
}

/// A plan, and what rounding its corners may do.
type RoundablePlan = (Planned, SmoothSetup);

impl SimulatedTask {
    /// The room laid out, the plan if it is one, and the coverage that it misses.
    fn prepare(
        &mut self,
        coverage: &CoverageArguments,
    ) -> Result<(RoomSetup, Option<RoundablePlan>, Option<MissedCoverage>), Failure> {
        let Placement { plan, robot, cells, .. } = &self.placement;
        if let Some(path) = &self.path {
            let heading = plan.start.map_or(0.0, |start| start.heading);
            let prepared = RoomSetup::along(plan, robot, *cells, path, heading).map_err(PlanningError::from)?;
            let planned = Planned::along(&prepared, path, 0.0);
            return Ok((prepared, Some((planned, SmoothSetup::default())), None));
        }
        let Some(planner) = self.algorithm.planner() else { return Ok((self.placement.prepare()?, None, None)) };
        let (placement, params) = (self.placement.clone(), self.params.clone());
        let mut task = PlanningTask { placement, planner, params, seed: self.seed, is_rounded: self.smooth };
        let missed = coverage.fit_cells(&mut task)?;
        self.placement.clone_from(&task.placement);
        let begin = Instant::now();
        let PlanSolution { prepared, planned, smooth, .. } = task.solve(|| begin.elapsed().as_secs_f64(), None)?;
        Ok((prepared, Some((planned, smooth)), missed))
    }
}

/// Plans if needed, drives, and returns the output.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let mut task = arguments.task()?;
    // First of all: a long run that can't be written is lost.
    let mut bag = arguments.mcap.as_deref().map(BagFile::create).transpose()?;
    let (prepared, planned, missed) = task.prepare(&arguments.coverage)?;
    let SimulatedTask { placement, algorithm, params, seed, conditions, odometry, path: own_path, .. } = task;
    let mut smooth = None;
    let (mut run, driven) = if let Some((mut planned, setup)) = planned {
        if task.smooth {
            let (rounded, plan) = round(planned, &prepared, &setup)?;
            (planned, smooth) = (rounded, Some(plan));
        }
        (planned.run(&prepared, conditions, odometry, seed), planned.driven())
    } else {
        let info = algorithm.behaviour().ok_or_else(|| Failure::unknown("planner", algorithm.id(), "planners"))?;
        let run = prepared.run_behaviour(info, &params, conditions, seed);
        (run.ok_or_else(|| Failure::unknown("behaviour", info.id, "behaviours"))?, PathToDrive::default())
    };
    let never_ends = algorithm.behaviour().is_some_and(|info| !info.claims.ends);
    let max_time = arguments.max_time.or(never_ends.then_some(MOST_TIME_S));
    let source = SourceMap {
        plan: &placement.plan,
        robot: &prepared.robot,
        path: &driven.line,
        smooth: driven.smooth.as_deref(),
    };
    let mut topics = bag.is_some().then(|| RunTopics::new(&source, &run, Pace::FILE));
    let mut record = |run: &Run| match (&mut topics, &mut bag) {
        (Some(topics), Some(bag)) => {
            topics.step(run);
            bag.put_all(topics.take())
        }
        _ => Ok(()),
    };
    let samples = drive(&mut run, arguments.sample, max_time, &mut record)?;
    if let (Some(topics), Some(mut bag)) = (&mut topics, bag) {
        topics.finish(&run);
        bag.put_all(topics.take())?;
        bag.finish()?;
    }
    let report = SimulateReport {
        task: TaskReport::new(algorithm, &params, seed, &placement, &prepared),
        slip: conditions.slip,
        noise: conditions.noise.to_string(),
        quantised: conditions.quantised,
        start_charge_percent: conditions.start_charge_percent,
        odometry,
        path_corners: own_path.map(|path| path.corners().len()),
        missed,
        smooth,
        totals: Totals::of(&run),
        samples,
    };
    Ok(if arguments.json { output::json(&report) } else { report.to_text(algorithm, &placement) })
}

/// The plan with its corners rounded.
fn round(planned: Planned, prepared: &RoomSetup, setup: &SmoothSetup) -> Result<(Planned, RoundedPlan), Failure> {
    let stopped_s = planned.drive.duration_s;
    let path =
        prepared.smooth(&planned.line, setup, false).map_err(|error| Failure::usage(format!("--smooth: {error}")))?;
    let SmoothPath { trajectory, coverage, stopped_coverage, corners, rounded } = path;
    let planned_s = trajectory.duration_s();
    let plan = RoundedPlan { corners, rounded, planned_s, planned_coverage: coverage, stopped_s, stopped_coverage };
    Ok((planned.driven_along(prepared, Arc::new(trajectory)), plan))
}

impl AlgorithmArguments {
    fn find(&self) -> Result<Option<Algorithm>, Failure> {
        if let Some(id) = &self.planner {
            return plan::planner(id).map(|info| Some(Algorithm::Planner(info)));
        }
        let Some(id) = &self.behaviour else { return Ok(None) };
        autonomous(id).map(|info| Some(Algorithm::Behaviour(info)))
    }
}

/// The behaviour with that id, which drives by itself.
pub fn autonomous(id: &str) -> Result<&'static BehaviourInfo, Failure> {
    let info = controller::find(id).ok_or_else(|| Failure::unknown("behaviour", id, "behaviours"))?;
    if info.claims.manual {
        return Err(Failure::usage(format!("behaviour \"{id}\" is driven by hand; use it on the page")));
    }
    Ok(info)
}

/// Drives to the end or for `max_time` seconds, and takes a sample at the start, every `interval` seconds and at the end;
/// `record` sees every step.
fn drive(
    run: &mut Run,
    interval: f64,
    max_time: Option<f64>,
    record: &mut dyn FnMut(&Run) -> Result<(), Failure>,
) -> Result<Vec<SimulateSample>, Failure> {
    let most_steps = max_time.map_or(u64::MAX, |seconds| (seconds / STEP_S) as u64);
    let mut samples = vec![SimulateSample::of(run)];
    while !run.is_finished() && run.steps() < most_steps {
        run.step();
        record(run)?;
        let is_last = run.is_finished() || run.steps() == most_steps;
        if is_last || run.time_s() >= samples.len() as f64 * interval {
            samples.push(SimulateSample::of(run));
        }
    }
    Ok(samples)
}

impl SimulateSample {
    fn of(run: &Run) -> Self {
        Self {
            time_s: run.time_s(),
            coverage: run.coverage(),
            pose: run.pose().into(),
            estimate: run.estimate().map(Into::into),
        }
    }
}

impl Totals {
    fn of(run: &Run) -> Self {
        let battery_empty = run.events().iter().any(|event| event.what == What::BatteryEmpty);
        Self {
            time_s: run.time_s(),
            coverage: run.coverage(),
            distance_m: run.distance_m(),
            turning_deg: run.turning_rad().to_degrees(),
            bumps: run.bumps(),
            overlap: run.tracker().overlap(),
            pose_error_m: run.pose_error_m(),
            finished: run.is_finished() && !battery_empty,
            battery_empty,
            digest: format!("{:016x}", run.digest()),
        }
    }
}

impl SimulateReport {
    fn to_text(&self, algorithm: Algorithm, placement: &Placement) -> String {
        let mut text = task::summary(algorithm, placement, &self.task);
        if let Some(corners) = self.path_corners {
            let _ = writeln!(text, "Path      {corners} corners of the scenario, in place of the planner's");
        }
        text += &self.missed.as_ref().map(MissedCoverage::to_text).unwrap_or_default();
        let quantised = if self.quantised { ", rounded speeds" } else { "" };
        let _ = writeln!(text, "Wheels    slip: {}, odometry: {}{quantised}", self.slip.id(), self.odometry.id());
        let _ = writeln!(text, "Sensors   noise: {}", self.noise);
        if self.start_charge_percent < 100 {
            let _ = writeln!(text, "Battery   start charge: {} %", self.start_charge_percent);
        }
        if let Some(plan) = &self.smooth {
            let (planned, stopped) = (output::minutes(plan.planned_s), output::minutes(plan.stopped_s));
            let _ = writeln!(
                text,
                "Corners   {} of {} rounded: planned {planned} for {:.2} % swept, with stops {stopped} for {:.2} %",
                plan.rounded,
                plan.corners,
                100.0 * plan.planned_coverage,
                100.0 * plan.stopped_coverage,
            );
        }
        text.push('\n');
        let _ = writeln!(text, "{:>10}  {:>9}  {:30}  Estimate", "Time", "Coverage", "Pose");
        for sample in &self.samples {
            let coverage = format!("{:.1} %", 100.0 * sample.coverage);
            let estimate = sample.estimate.as_ref().map(place).unwrap_or_default();
            let _ = writeln!(text, "{:8.2} s  {coverage:>9}  {:30}  {estimate}", sample.time_s, place(&sample.pose));
        }
        let totals = &self.totals;
        let end = match (totals.finished, algorithm) {
            (true, Algorithm::Planner(_)) => "reached the end of the walk",
            (true, Algorithm::Behaviour(_)) => "finished",
            (false, _) if totals.battery_empty => "stopped by an empty battery",
            (false, _) => "stopped by --max-time",
        };
        let pose = totals.pose_error_m.map(|metres| format!("Pose      {metres:.3} m off at the end\n"));
        let _ = write!(
            text,
            "\n\
             Coverage  {:.1} % of the reachable floor, {:.1} % swept again\n\
             Drive     {:.1} m in {}, turns of {:.0}°, bumps: {}\n\
             {}\
             Run       {end}, digest {}\n",
            100.0 * totals.coverage,
            100.0 * totals.overlap,
            totals.distance_m,
            output::minutes(totals.time_s),
            totals.turning_deg,
            totals.bumps,
            pose.unwrap_or_default(),
            totals.digest,
        );
        text
    }
}

fn place(pose: &ScenarioPose) -> String {
    format!("({:.3} m, {:.3} m, {:.1}°)", pose.x, pose.y, pose.heading_deg)
}

pub fn parse_seconds(text: &str) -> Result<f64, String> {
    let seconds = text.parse().ok().filter(|seconds: &f64| seconds.is_finite() && *seconds > 0.0);
    seconds.ok_or_else(|| "give a number of seconds greater than 0, e.g. 10".to_owned())
}
