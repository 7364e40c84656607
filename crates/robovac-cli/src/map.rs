//! `map`: quality of a robot's maps, with and without drift correction.

use super::{
    bag_file::BagFile,
    conditions::ConditionsArguments,
    failure::Failure,
    output,
    simulate::DEFAULT_ROBOT,
    task::{ParamArguments, PlacementArguments},
};
use clap::ValueEnum;
use robovac_core::{
    geometry::{Pose, difference},
    robot::{Laser, SensorReadings},
};
use robovac_ros::{Pace, RunTopics, SourceMap};
use robovac_sim::{
    Run, STEP_S, controller,
    mapping::{
        MapObserver, MapQuality, MapTruth, Mapper, MapperSetup, OccupancyMap, RESOLUTION, SeenBoundary, ThesisMap,
        Tracking,
    },
    montecarlo::quantile,
};
use serde::Serialize;
use std::{
    fmt::Write,
    path::{Path, PathBuf},
    sync::Arc,
    time::Instant,
};

/// Readings that are taken at once, so that measuring the time takes none: a second.
const BATCH: usize = 67;
/// Name of the thesis' grid in results.
const THESIS: &str = "thesis";

/// Map a room in simulation and compare maps and poses with ground truth
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    placement: PlacementArguments,
    /// Driving behaviour, see "robovac behaviours"
    #[arg(long, value_name = "ID", default_value = "wall_follow")]
    behaviour: String,
    #[command(flatten)]
    params: ParamArguments,
    /// Number of runs; seeds count up from --seed
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u64).range(1..=10_000))]
    seeds: u64,
    /// Simulated time of each run
    #[arg(long, value_name = "MINUTES", default_value_t = 20.0, value_parser = super::montecarlo::parse_minutes, allow_hyphen_values = true)]
    minutes: f64,
    #[command(flatten)]
    conditions: ConditionsArguments,
    /// Localisation
    #[arg(long, value_name = "WAY", default_value = "both")]
    tracking: TrackingWays,
    /// Grid of the map
    #[arg(long, value_name = "GRID", default_value = "own")]
    grid: MeasuredGrids,
    /// Write ROS 2 messages of the run with the first seed as MCAP, with the corrected map, or with that by odometry if
    /// --tracking is odometry
    #[arg(long, value_name = "FILE")]
    mcap: Option<PathBuf>,
    /// Write JSON instead of tables
    #[arg(long)]
    json: bool,
}

/// Ways of keeping track that are compared.
#[derive(Clone, Copy, ValueEnum)]
enum TrackingWays {
    /// Encoder counts only
    Odometry,
    /// Drift corrected by matching bumper and light bumper contacts
    Corrected,
    /// Both, on the same drives
    Both,
}

/// Grids that are measured.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum MeasuredGrids {
    /// Cells of 5 cm with probabilities
    Own,
    /// Also the grid of Krapinec's thesis: 100 x 100 cells of 10 cm, by odometry, as printed
    Thesis,
}

/// What keeps a map during a run.
enum Kept {
    Mapper(Box<Mapper>),
    Thesis(Box<ThesisMap>),
}

impl Kept {
    fn id(&self) -> &'static str {
        match self {
            Self::Mapper(mapper) => mapper.setup().tracking.id(),
            Self::Thesis(_) => THESIS,
        }
    }

    fn update(&mut self, sensed: &SensorReadings) {
        match self {
            Self::Mapper(mapper) => mapper.update(sensed),
            Self::Thesis(thesis) => thesis.update(sensed),
        }
    }

    fn pose(&self) -> Pose {
        match self {
            Self::Mapper(mapper) => mapper.pose(),
            Self::Thesis(thesis) => thesis.pose(),
        }
    }

    fn map(&self) -> &OccupancyMap {
        match self {
            Self::Mapper(mapper) => mapper.map(),
            Self::Thesis(thesis) => thesis.map(),
        }
    }
}

/// Result of a run with one kind of tracking, or on the thesis' grid.
#[derive(Serialize)]
struct MapOutcome {
    seed: u64,
    tracking: &'static str,
    /// Error of the pose at the end, and its median and 90th percentile over the run, once a second.
    error_m: [f64; 3],
    error_deg: [f64; 3],
    #[serde(flatten)]
    quality: Quality,
    /// Simulated time over what the mapper took, natively.
    times_real_time: f64,
}

/// As [`MapQuality`].
#[derive(Serialize)]
struct Quality {
    right: f64,
    known: f64,
    boundary: f64,
    /// Share of the boundary that the laser has seen; `null` without a laser.
    seen: Option<f64>,
    boundary_error_m: Option<f64>,
}

/// Runs all seeds and returns the output.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let id = &arguments.behaviour;
    let info = controller::find(id).ok_or_else(|| Failure::unknown("behaviour", id, "behaviours"))?;
    let params = arguments.params.checked(info.params)?;
    let placement = arguments.placement.placement(DEFAULT_ROBOT)?;
    let prepared = placement.prepare()?;
    let conditions = arguments.conditions.conditions();
    let ways: &[Tracking] = match arguments.tracking {
        TrackingWays::Odometry => &[Tracking::Odometry],
        TrackingWays::Corrected => &[Tracking::Corrected],
        TrackingWays::Both => &[Tracking::Corrected, Tracking::Odometry],
    };
    let (first, has_thesis) = (arguments.params.seed, arguments.grid == MeasuredGrids::Thesis);
    let mut outcomes = Vec::new();
    for seed in first..first.saturating_add(arguments.seeds) {
        let run = prepared.run_behaviour(info, &params, conditions, seed);
        let run = run.ok_or_else(|| Failure::unknown("behaviour", id, "behaviours"))?;
        let setup = |tracking| MapperSetup {
            robot: prepared.robot.clone(),
            start: prepared.floor.start,
            tracking,
            odometry: arguments.conditions.odometry,
            seed,
        };
        if let Some(path) = arguments.mcap.as_deref().filter(|_| seed == first) {
            let mapper = Mapper::new(setup(ways.first().copied().unwrap_or_default()));
            let observer = MapObserver::default().with_mapper(mapper);
            let run = prepared.run_behaviour(info, &params, conditions, seed);
            let run = run.ok_or_else(|| Failure::unknown("behaviour", id, "behaviours"))?.observed(Box::new(observer));
            let source = SourceMap { plan: &placement.plan, robot: &prepared.robot, path: &[], smooth: None };
            record(run, &source, arguments.minutes, path)?;
        }
        let mappers = ways.iter().map(|&way| Kept::Mapper(Box::new(Mapper::new(setup(way)))));
        let thesis = has_thesis.then(|| Kept::Thesis(Box::new(ThesisMap::new(&prepared.robot, prepared.floor.start))));
        outcomes.extend(follow(
            run,
            mappers.chain(thesis).map(Followed::new).collect(),
            prepared.robot.sensors.laser,
            arguments.minutes,
            seed,
        ));
    }
    let names: Vec<&str> = ways.iter().map(|way| way.id()).chain(has_thesis.then_some(THESIS)).collect();
    Ok(if arguments.json { output::json(&outcomes) } else { to_text(&names, &outcomes) })
}

/// Drives once more with the mapper in the run, and writes its messages.
fn record(mut run: Run, source: &SourceMap<'_>, minutes: f64, path: &Path) -> Result<(), Failure> {
    let mut bag = BagFile::create(path)?;
    let most_steps = (60.0 * minutes / STEP_S) as u64;
    let mut topics = RunTopics::new(source, &run, Pace::FILE);
    while !run.is_finished() && run.steps() < most_steps {
        run.step();
        topics.step(&run);
        bag.put_all(topics.take())?;
    }
    topics.finish(&run);
    bag.put_all(topics.take())?;
    bag.finish()
}

/// A map that follows a run, and how far off its pose was.
struct Followed {
    kept: Kept,
    errors: Vec<(f64, f64)>,
    seconds: f64,
}

impl Followed {
    fn new(kept: Kept) -> Self {
        Self { kept, errors: Vec::new(), seconds: 0.0 }
    }

    fn take(&mut self, readings: &[SensorReadings], truth: Pose) {
        let begin = Instant::now();
        for sensed in readings {
            self.kept.update(sensed);
        }
        self.seconds += begin.elapsed().as_secs_f64();
        self.note(truth, self.kept.pose());
    }

    fn note(&mut self, truth: Pose, pose: Pose) {
        let off = (pose.position() - truth.position()).norm();
        self.errors.push((off, difference(truth.heading, pose.heading).abs().to_degrees()));
    }
}

/// Drives to the end with mappers that listen; a behaviour that makes a map of its own drives by that.
fn follow(mut run: Run, mut mappers: Vec<Followed>, laser: Option<Laser>, minutes: f64, seed: u64) -> Vec<MapOutcome> {
    let most_steps = (60.0 * minutes / STEP_S) as u64;
    let mut readings = Vec::with_capacity(BATCH);
    let (mut seen, mut last) = (SeenBoundary::default(), None);
    while !run.is_finished() && run.steps() < most_steps {
        run.step();
        readings.push(run.sensors().clone());
        // A new scan is another list.
        let scan = run.sensors().laser.as_ref();
        if let Some(laser) = laser.filter(|_| scan.map(Arc::as_ptr) != last.as_ref().map(Arc::as_ptr)) {
            last = scan.cloned();
            seen.look(&run.floor().walls, &laser, run.pose(), RESOLUTION);
        }
        if readings.len() == BATCH {
            for mapper in &mut mappers {
                mapper.take(&readings, run.pose());
            }
            readings.clear();
        }
    }
    for mapper in &mut mappers {
        mapper.take(&readings, run.pose());
    }
    let truth = MapTruth::of(run.floor(), RESOLUTION);
    let seen = laser.map(|_| &seen);
    mappers.into_iter().map(|followed| followed.outcome(&truth, seen, run.time_s(), seed)).collect()
}

impl Followed {
    fn outcome(self, truth: &MapTruth, seen: Option<&SeenBoundary>, time_s: f64, seed: u64) -> MapOutcome {
        let MapQuality { right, known, boundary, boundary_error_m, .. } = truth.quality(self.kept.map());
        let of = |value: &dyn Fn(&(f64, f64)) -> f64| {
            let values: Vec<f64> = self.errors.iter().map(value).collect();
            let last = values.last().copied().unwrap_or_default();
            [last, at(&values, 0.5), at(&values, 0.9)]
        };
        MapOutcome {
            seed,
            tracking: self.kept.id(),
            error_m: of(&|error| error.0),
            error_deg: of(&|error| error.1),
            quality: Quality {
                right,
                known,
                boundary,
                seen: seen.map(|seen| seen.mapped(truth, self.kept.map())),
                boundary_error_m,
            },
            times_real_time: time_s / self.seconds.max(1e-9),
        }
    }
}

/// A quantile of unsorted values.
fn at(values: &[f64], p: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    quantile(&sorted, p).unwrap_or_default()
}

fn to_text(names: &[&str], outcomes: &[MapOutcome]) -> String {
    let mut text = String::new();
    for name in names {
        let of_way: Vec<&MapOutcome> = outcomes.iter().filter(|outcome| outcome.tracking == *name).collect();
        let _ = writeln!(text, "{name}");
        let heads =
            ["end", "median", "90 %", "end", "median", "90 %", "right", "floor", "boundary", "seen", "off", "speed"];
        let _ = write!(text, "{:>10}", "seed");
        for head in heads {
            let _ = write!(text, " {head:>9}");
        }
        text.push('\n');
        for outcome in &of_way {
            row(&mut text, &outcome.seed.to_string(), &outcome.numbers());
        }
        for (name, p) in [("median", 0.5), ("90 %", 0.9)] {
            let column = |i: usize| at(&of_way.iter().map(|outcome| outcome.numbers()[i]).collect::<Vec<_>>(), p);
            row(&mut text, name, &std::array::from_fn(column));
        }
        text.push('\n');
    }
    text + "end, median, 90 %: pose error at the end and over the run; right: share of known cells correct within one cell;\n\
            floor, boundary: mapped shares of the reachable ones; seen: mapped share of the boundary that a laser has seen; off: mean distance of occupied cells from a true edge;\n\
            speed: multiple of real time\n"
}

impl MapOutcome {
    fn numbers(&self) -> [f64; 12] {
        let [a, b, c] = self.error_m;
        let [d, e, f] = self.error_deg;
        let Quality { right, known, boundary, seen, boundary_error_m } = self.quality;
        let seen = seen.unwrap_or(f64::NAN);
        [a, b, c, d, e, f, right, known, boundary, seen, boundary_error_m.unwrap_or_default(), self.times_real_time]
    }
}

fn row(text: &mut String, name: &str, numbers: &[f64; 12]) {
    let _ = write!(text, "{name:>10}");
    for (i, number) in numbers.iter().enumerate() {
        let cell = match i {
            _ if number.is_nan() => "-".to_owned(),
            0..3 | 10 => format!("{number:.3} m"),
            3..6 => format!("{number:.2}°"),
            6..10 => format!("{:.1} %", 100.0 * number),
            _ => format!("{number:.0}"),
        };
        let _ = write!(text, " {cell:>9}");
    }
    text.push('\n');
}
