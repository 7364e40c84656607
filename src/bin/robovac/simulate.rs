//! `simulate`: a robot drives the planned walk, on its own estimate of where it is.

use super::{
    failure::Failure,
    output,
    task::{self, TaskArguments},
};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use robovac_playground::{
    app::planning::{PlanningTask, TaskReport},
    floorplan::ScenarioPose,
    robot::OdometryModel,
    sim::{Conditions, Run, STEP_S, SlipLevel},
};
use serde::Serialize;
use std::{fmt::Write, time::Instant};

/// The robot unless another one is asked for.
const DEFAULT_ROBOT: &str = "roomba600";

/// Plan a walk and let a simulated robot drive it
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    task: TaskArguments,
    /// How much the wheels slip
    #[arg(long, value_name = "LEVEL", default_value = SlipLevel::None.id(), value_parser = slip_parser())]
    slip: SlipLevel,
    /// How the robot computes its pose from the counts of its wheels
    #[arg(long, value_name = "MODEL", default_value = OdometryModel::Arc.id(), value_parser = odometry_parser())]
    odometry: OdometryModel,
    /// Simulated time between two samples
    #[arg(long, value_name = "SECONDS", default_value_t = 10.0, value_parser = parse_seconds, allow_hyphen_values = true)]
    sample: f64,
    /// Simulated time after which to stop [default: when the walk is driven]
    #[arg(long, value_name = "SECONDS", value_parser = parse_seconds, allow_hyphen_values = true)]
    max_time: Option<f64>,
    /// Write one JSON object instead of a table and a summary
    #[arg(long)]
    json: bool,
}

/// What is written about a run.
#[derive(Serialize)]
struct Report {
    #[serde(flatten)]
    task: TaskReport,
    slip: SlipLevel,
    odometry: OdometryModel,
    #[serde(flatten)]
    totals: Totals,
    samples: Vec<Sample>,
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
    /// Distance between where the robot is and where it believes to be.
    pose_error_m: Option<f64>,
    /// Whether the robot came to the end of the walk.
    finished: bool,
    /// In hexadecimal; two runs share it only if they are in the same state, to the last bit.
    digest: String,
}

/// One moment of a run.
#[derive(Serialize)]
struct Sample {
    time_s: f64,
    /// Swept share of the reachable floor, 0 to 1.
    coverage: f64,
    /// Where the robot is.
    pose: ScenarioPose,
    /// Where it believes to be.
    estimate: Option<ScenarioPose>,
}

/// Plans, drives and returns what is to be printed.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let task = arguments.task.task(DEFAULT_ROBOT)?;
    let begin = Instant::now();
    let solution = task.solve(|| begin.elapsed().as_secs_f64(), None)?;
    let Arguments { slip, odometry, .. } = *arguments;
    let mut run =
        solution.planned.run(&solution.prepared, Conditions { slip, ..Conditions::default() }, odometry, task.seed);
    let samples = drive(&mut run, arguments.sample, arguments.max_time);
    let report =
        Report { task: TaskReport::new(&task, &solution.prepared), slip, odometry, totals: Totals::of(&run), samples };
    Ok(if arguments.json { output::json(&report) } else { report.to_text(&task) })
}

/// Drives to the end or for `max_time` seconds, and takes a sample at the start, every `interval` seconds and at the end.
fn drive(run: &mut Run, interval: f64, max_time: Option<f64>) -> Vec<Sample> {
    let most_steps = max_time.map_or(u64::MAX, |seconds| (seconds / STEP_S) as u64);
    let mut samples = vec![Sample::of(run)];
    while !run.is_finished() && run.steps() < most_steps {
        run.step();
        let is_last = run.is_finished() || run.steps() == most_steps;
        if is_last || run.time_s() >= samples.len() as f64 * interval {
            samples.push(Sample::of(run));
        }
    }
    samples
}

impl Sample {
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
        Self {
            time_s: run.time_s(),
            coverage: run.coverage(),
            distance_m: run.distance_m(),
            turning_deg: run.turning_rad().to_degrees(),
            bumps: run.bumps(),
            overlap: run.tracker().overlap(),
            pose_error_m: run.pose_error_m(),
            finished: run.is_finished(),
            digest: format!("{:016x}", run.digest()),
        }
    }
}

impl Report {
    fn to_text(&self, task: &PlanningTask) -> String {
        let mut text = task::summary(task, &self.task);
        let _ = writeln!(text, "Wheels    slip: {}, odometry: {}\n", self.slip.id(), self.odometry.id());
        let _ = writeln!(text, "{:>10}  {:>9}  {:30}  Estimate", "Time", "Coverage", "Pose");
        for sample in &self.samples {
            let coverage = format!("{:.1} %", 100.0 * sample.coverage);
            let estimate = sample.estimate.as_ref().map(place).unwrap_or_default();
            let _ = writeln!(text, "{:8.2} s  {coverage:>9}  {:30}  {estimate}", sample.time_s, place(&sample.pose));
        }
        let totals = &self.totals;
        let end = if totals.finished { "came to the end of the walk" } else { "stopped by --max-time" };
        let _ = write!(
            text,
            "\n\
             Coverage  {:.1} % of the reachable floor, {:.1} % overlap\n\
             Drive     {:.1} m in {}, turns of {:.0}°, {} bumps\n\
             Pose      {} off at the end\n\
             Run       {end}, digest {}\n",
            100.0 * totals.coverage,
            100.0 * totals.overlap,
            totals.distance_m,
            output::minutes(totals.time_s),
            totals.turning_deg,
            totals.bumps,
            totals.pose_error_m.map(|metres| format!("{metres:.3} m")).unwrap_or_default(),
            totals.digest,
        );
        text
    }
}

fn place(pose: &ScenarioPose) -> String {
    format!("({:.3} m, {:.3} m, {:.1}°)", pose.x, pose.y, pose.heading_deg)
}

fn slip_parser() -> impl TypedValueParser<Value = SlipLevel> {
    let names = SlipLevel::ALL.map(|(_, name)| name);
    PossibleValuesParser::new(names).map(|name| SlipLevel::parse(&name).unwrap_or_default())
}

fn odometry_parser() -> impl TypedValueParser<Value = OdometryModel> {
    let names = OdometryModel::ALL.map(|(_, name)| name);
    PossibleValuesParser::new(names).map(|name| OdometryModel::parse(&name).unwrap_or_default())
}

fn parse_seconds(text: &str) -> Result<f64, String> {
    let seconds = text.parse().ok().filter(|seconds: &f64| seconds.is_finite() && *seconds > 0.0);
    seconds.ok_or_else(|| "give a number of seconds greater than 0, e.g. 10".to_owned())
}
