//! `run`: a user's program drives the simulated robot, or plans its walk. See docs/program-protocol.md.

mod child;
mod frames;
mod language;
mod protocol;
mod runtimes;
mod sandbox;
mod talk;

use super::{
    conditions::ConditionsArguments, failure::Failure, montecarlo::parse_minutes, output, signals::end_requested,
    simulate::DEFAULT_ROBOT, source::RoomArguments, task::parse_cell,
};
pub use child::{ProgramProcess, WaitFor};
use coverage_planners::{CoveragePath, metrics::WalkMetrics};
pub use frames::drive_framed;
pub use language::Language;
pub use protocol::{Reply, Words};
use robovac_core::grid::Cell;
use robovac_sim::{
    Conditions, Run, What,
    experiment::{
        PlanAnswer, Planned,
        planning::{GivenStart, Placement, choose_robot},
    },
    montecarlo::{Lab, ProgramRun, Terms, quantile},
    program::{ProgramRoom, RobotFacts, check_walk},
};
pub use sandbox::Sandbox;
use serde::Serialize;
use std::{
    fmt::Write,
    path::{Path, PathBuf},
    slice,
    sync::{
        Arc, Mutex,
        atomic::{AtomicBool, AtomicUsize, Ordering},
    },
    thread,
};
pub use talk::{Prints, Ready, drive, greet, hello, plan};

/// Run your own program on the simulated robot: Python, JavaScript, or any program that speaks the protocol
#[derive(clap::Args)]
pub struct Arguments {
    /// Your program: a file that ends in .py (run by python3) or .js (by node), or any with --command
    program: PathBuf,
    /// What runs the program, which gets the file as its last argument
    #[arg(long, value_name = "COMMAND")]
    command: Option<String>,
    #[command(flatten)]
    room: RoomArguments,
    /// Robot, see "robovac robots"
    #[arg(long, value_name = "ID", default_value = DEFAULT_ROBOT)]
    robot: String,
    /// Planning cell to start in: column and row, counted from 0 at the lower left [default: the map's own start]
    #[arg(long, value_name = "X,Y", value_parser = parse_cell, allow_hyphen_values = true)]
    start: Option<Cell>,
    /// Heading at the start, degrees counter-clockwise from 0 = right [default: 0 with --start, else the map's own]
    #[arg(long, value_name = "DEG", allow_hyphen_values = true)]
    heading: Option<f64>,
    /// Planning cell size in metres [default: chosen for the robot]
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    cell: Option<f64>,
    /// Random seed of the run, or of the first one
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u64).range(0..=u64::from(u32::MAX)))]
    seed: u64,
    /// Number of runs; seeds count up from --seed
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..=10_000))]
    seeds: u64,
    /// Simulated time after which a run is stopped
    #[arg(long, value_name = "MINUTES", default_value_t = 30.0, value_parser = parse_minutes, allow_hyphen_values = true)]
    minutes: f64,
    #[command(flatten)]
    conditions: ConditionsArguments,
    /// Runs in parallel [default: one per core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    jobs: Option<u16>,
    /// Memory that the program may use
    #[arg(long, value_name = "MB", default_value_t = 1024, value_parser = clap::value_parser!(u64).range(32..=1_000_000))]
    memory: u64,
    /// Write JSON instead of text
    #[arg(long)]
    json: bool,
}

/// What all runs have in common.
struct RunStudy {
    language: Language,
    lab: Lab,
    placement: Placement,
    memory_mb: u64,
    end: Arc<AtomicBool>,
}

/// Report of all runs.
#[derive(Serialize)]
struct ProgramReport {
    program: String,
    room: String,
    robot: &'static str,
    cell_size_m: f64,
    minutes: f64,
    slip: &'static str,
    noise: String,
    quantised: bool,
    start_charge_percent: u8,
    runs: Vec<ProgramOutcome>,
}

/// Result of a run.
#[derive(Debug, Clone, Serialize)]
struct ProgramOutcome {
    seed: u64,
    /// `behaviour` or `planner`.
    kind: &'static str,
    /// Why it ended: `done`, `time`, `battery`.
    end: &'static str,
    time_s: f64,
    /// Swept share of the reachable floor, 0 to 1.
    coverage: f64,
    distance_m: f64,
    turning_deg: f64,
    bumps: u32,
    falls: u32,
    /// Area swept again, as a share of the area swept.
    overlap: f64,
    /// Distance between the robot's true and estimated position at the end.
    pose_error_m: Option<f64>,
    /// In hexadecimal; two runs share it only if they are in the same state, to the last bit.
    digest: String,
    /// A planner's walk, and the cells that it misses.
    #[serde(skip_serializing_if = "Option::is_none")]
    walk: Option<WalkMetrics>,
    #[serde(skip_serializing_if = "Option::is_none")]
    misses: Option<Misses>,
    /// Time, s, and text of what it printed.
    prints: Vec<(f64, String)>,
}

/// Cells that a walk misses.
#[derive(Debug, Clone, Serialize)]
struct Misses {
    cells: usize,
    first: Cell,
}

/// Runs the program and returns the output.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let program = &arguments.program;
    // An interpreter's own message would be longer.
    std::fs::metadata(program).map_err(|error| Failure::io(program.display(), &error))?;
    let language = Language::of(program, arguments.command.as_deref())?;
    let plan = arguments.room.plan()?;
    let (robot, cell_size) = choose_robot(&arguments.robot, &plan, arguments.cell)
        .ok_or_else(|| Failure::unknown("robot", &arguments.robot, "robots"))?;
    let placement = Placement {
        plan,
        robot,
        cells: cell_size.into(),
        start: arguments.start.map(GivenStart::Cell),
        heading_deg: arguments.heading,
    };
    let terms = Terms {
        conditions: arguments.conditions.conditions(),
        odometry: arguments.conditions.odometry,
        smooth: false,
        duration_s: 60.0 * arguments.minutes,
        plan_seed: arguments.seed,
    };
    let study = RunStudy {
        language,
        lab: Lab::on(placement.prepare()?, terms),
        placement,
        memory_mb: arguments.memory,
        end: end_requested()?,
    };
    let seeds: Vec<u64> = (arguments.seed..arguments.seed.saturating_add(arguments.seeds)).collect();
    let jobs = arguments.jobs.map_or_else(|| thread::available_parallelism().map_or(1, usize::from), usize::from);
    let runs = study
        .make_all(&seeds, jobs)
        .map_err(|(seed, fault)| Failure::planner(format!("{}, seed {seed}: {fault}", program.display())))?;
    let Conditions { slip, noise, quantised, start_charge_percent, .. } = terms.conditions;
    let report = ProgramReport {
        program: program.display().to_string(),
        room: study.placement.plan.name.clone(),
        robot: study.placement.robot.id,
        cell_size_m: study.placement.cells.size,
        minutes: arguments.minutes,
        slip: slip.id(),
        noise: noise.to_string(),
        quantised,
        start_charge_percent,
        runs,
    };
    Ok(if arguments.json { output::json(&report) } else { report.to_text(&study.placement) })
}

impl RunStudy {
    /// Makes the runs, `jobs` at a time, and returns them in the order of the seeds; or the first seed that failed, and why.
    fn make_all(&self, seeds: &[u64], jobs: usize) -> Result<Vec<ProgramOutcome>, (u64, String)> {
        let next = AtomicUsize::new(0);
        let has_failed = AtomicBool::new(false);
        let results = Mutex::new(Vec::new());
        let work = || {
            while !has_failed.load(Ordering::Relaxed) && !self.end.load(Ordering::Relaxed) {
                let Some(&seed) = seeds.get(next.fetch_add(1, Ordering::Relaxed)) else { break };
                let result = self.make(seed);
                has_failed.fetch_or(result.is_err(), Ordering::Relaxed);
                if let Ok(mut results) = results.lock() {
                    results.push((seed, result));
                }
            }
        };
        thread::scope(|scope| {
            for _ in 0..jobs.min(seeds.len()) {
                scope.spawn(work);
            }
        });
        let mut results = results.into_inner().unwrap_or_default();
        results.sort_by_key(|&(seed, _)| seed);
        if self.end.load(Ordering::Relaxed) {
            return Err((seeds[0], "interrupted".to_owned()));
        }
        results.into_iter().map(|(seed, result)| result.map_err(|fault| (seed, fault))).collect()
    }

    fn make(&self, seed: u64) -> Result<ProgramOutcome, String> {
        let mut process = ProgramProcess::start(self.language.command(), self.memory_mb, Arc::clone(&self.end))?;
        let mut prints = Prints::new();
        let robot = RobotFacts::of(&self.lab.prepared().robot);
        let ready = greet(&mut process, &robot, &[seed], &mut prints)?;
        if ready == Ready::Plans {
            return self.plan(seed, &mut process, prints);
        }
        let mut run = ProgramRun::new(&self.lab, seed);
        let end = if ready == Ready::DrivesFramed {
            let ends = drive_framed(&mut process, slice::from_mut(&mut run), slice::from_mut(&mut prints));
            ends.map_err(|(_, fault)| fault)?.first().copied().unwrap_or_default()
        } else {
            drive(&mut process, &mut run, &mut prints)?
        };
        Ok(ProgramOutcome::of(run.lockstep().run(), seed, "behaviour", end, prints))
    }

    fn plan(&self, seed: u64, process: &mut ProgramProcess, mut prints: Prints) -> Result<ProgramOutcome, String> {
        let (prepared, terms) = (self.lab.prepared(), self.lab.terms());
        let room = ProgramRoom::of(&prepared.job, self.placement.cells.size);
        let cells = plan(process, &room, &mut prints)?;
        let missed = check_walk(&prepared.job, &cells).map_err(|fault| fault.to_string())?;
        let answer = PlanAnswer { path: CoveragePath::walk(cells), seconds: 0.0, proof: None, trace: Vec::new() };
        let planned = Planned::new(prepared, &answer).map_err(|error| error.to_string())?;
        let mut run = planned.run(prepared, terms.conditions, terms.odometry, seed);
        while !run.is_finished() && run.steps() < terms.steps() {
            run.step();
        }
        let end = if run.is_finished() { "done" } else { "time" };
        Ok(ProgramOutcome {
            walk: planned.walk,
            misses: missed.map(|missed| Misses { cells: missed.count, first: missed.first }),
            ..ProgramOutcome::of(&run, seed, "planner", end, prints)
        })
    }
}

impl ProgramOutcome {
    fn of(run: &Run, seed: u64, kind: &'static str, end: &'static str, prints: Vec<(f64, String)>) -> Self {
        let is_empty = run.events().iter().any(|event| event.what == What::BatteryEmpty);
        Self {
            seed,
            kind,
            end: if is_empty && end != "time" { "battery" } else { end },
            time_s: run.time_s(),
            coverage: run.coverage(),
            distance_m: run.distance_m(),
            turning_deg: run.turning_rad().to_degrees(),
            bumps: run.bumps(),
            falls: run.falls(),
            overlap: run.tracker().overlap(),
            pose_error_m: run.pose_error_m(),
            digest: format!("{:016x}", run.digest()),
            walk: None,
            misses: None,
            prints,
        }
    }

    /// Why it ended, in words.
    fn end_in_words(&self) -> &'static str {
        match (self.end, self.kind) {
            ("done", "planner") => "reached the end of the walk",
            ("done", _) => "done",
            ("battery", _) => "stopped by an empty battery",
            _ => "stopped by --minutes",
        }
    }
}

impl ProgramReport {
    fn to_text(&self, placement: &Placement) -> String {
        let kind = self.runs.first().map_or("", |run| run.kind);
        let name = Path::new(&self.program).file_name().map_or_else(String::new, |name| name.to_string_lossy().into());
        let mut text = format!(
            "Program   {name} ({kind})\nRoom      {}\nRobot     {}\nWheels    slip: {}\nSensors   noise: {}\n\n",
            self.room, placement.robot.title, self.slip, self.noise
        );
        if let [run] = &*self.runs {
            run.tell(&mut text);
        } else {
            self.table(&mut text);
        }
        text
    }

    fn table(&self, text: &mut String) {
        let _ = writeln!(
            text,
            "{:>8} {:>9} {:>10} {:>10} {:>6}  {:16}  End",
            "Seed", "Coverage", "Time", "Distance", "Bumps", "Digest"
        );
        for run in &self.runs {
            let _ = writeln!(
                text,
                "{:>8} {:>7.1} % {:>6.1} min {:>8.1} m {:>6}  {}  {}",
                run.seed,
                100.0 * run.coverage,
                run.time_s / 60.0,
                run.distance_m,
                run.bumps,
                run.digest,
                run.end_in_words(),
            );
        }
        let median = |value: fn(&ProgramOutcome) -> f64| {
            let mut values: Vec<f64> = self.runs.iter().map(value).collect();
            values.sort_by(f64::total_cmp);
            quantile(&values, 0.5).unwrap_or_default()
        };
        let _ = writeln!(
            text,
            "{:>8} {:>7.1} % {:>6.1} min {:>8.1} m {:>6.0}",
            "median",
            100.0 * median(|run| run.coverage),
            median(|run| run.time_s) / 60.0,
            median(|run| run.distance_m),
            median(|run| f64::from(run.bumps)),
        );
    }
}

impl ProgramOutcome {
    fn tell(&self, text: &mut String) {
        for (time_s, print) in &self.prints {
            let _ = writeln!(text, "{time_s:8.2} s  {print}");
        }
        if !self.prints.is_empty() {
            text.push('\n');
        }
        if let Some(walk) = &self.walk {
            let missed = match &self.misses {
                None => "all cells visited".to_owned(),
                Some(Misses { cells, first }) => format!("cells missed: {cells}, the first at {first}"),
            };
            let _ = writeln!(text, "Walk      {} steps, {} turns, {missed}", walk.steps, walk.turns);
        }
        let pose = self.pose_error_m.map(|metres| format!("Pose      {metres:.3} m off at the end\n"));
        let _ = write!(
            text,
            "Coverage  {:.1} % of the reachable floor, {:.1} % swept again\n\
             Drive     {:.1} m in {}, turns of {:.0}°, bumps: {}\n\
             {}\
             Run       {}, seed {}, digest {}\n",
            100.0 * self.coverage,
            100.0 * self.overlap,
            self.distance_m,
            output::minutes(self.time_s),
            self.turning_deg,
            self.bumps,
            pose.unwrap_or_default(),
            self.end_in_words(),
            self.seed,
            self.digest,
        );
    }
}
