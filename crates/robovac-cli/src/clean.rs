//! `clean`: how clean a robot gets a room by a map that it has made itself.

use super::{
    conditions::ConditionsArguments,
    failure::Failure,
    output,
    simulate::DEFAULT_ROBOT,
    task::{ParamArguments, PlacementArguments},
};
use robovac_sim::{
    Input, RandomStream, Run, STEP_S, controller,
    mapping::{MapObserver, Mapper, MapperSetup, Tracking},
    montecarlo::quantile,
};
use serde::Serialize;
use std::fmt::Write;

/// Longest time that it cleans, s.
const MOST_S: f64 = 4.0 * 3600.0;

/// Simulate a robot that maps a room, then cleans the remaining floor using that map
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    placement: PlacementArguments,
    /// Behaviour used for mapping, see "robovac behaviours"
    #[arg(long, value_name = "ID", default_value = "explore_frontier")]
    behaviour: String,
    #[command(flatten)]
    params: ParamArguments,
    #[command(flatten)]
    conditions: ConditionsArguments,
    /// Number of runs; seeds count up from --seed
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u64).range(1..=10_000))]
    seeds: u64,
    /// Simulated time after which cleaning starts, if the map isn't complete by then
    #[arg(long, value_name = "MINUTES", default_value_t = 40.0, value_parser = super::montecarlo::parse_minutes, allow_hyphen_values = true)]
    minutes: f64,
    /// Planner for the remaining floor, see "robovac planners"
    #[arg(long, value_name = "ID", default_value = "boustrophedon_cells")]
    by: String,
    /// Kidnap the robot after this many minutes of cleaning: put it down at a random pose
    #[arg(long, value_name = "MINUTES")]
    carry: Option<f64>,
    /// Localisation: corrected or odometry
    #[arg(long, value_name = "WAY", default_value = "corrected", value_parser = parse_tracking)]
    tracking: Tracking,
    /// Write JSON instead of a table
    #[arg(long)]
    json: bool,
}

fn parse_tracking(text: &str) -> Result<Tracking, String> {
    Tracking::parse(text).ok_or_else(|| format!("unknown localisation method \"{text}\"; use corrected or odometry"))
}

/// Result of a run.
#[derive(Serialize)]
struct CleanOutcome {
    seed: u64,
    /// Time until it began to clean, and until it ended, s.
    mapped_s: f64,
    end_s: f64,
    /// Share of the reachable floor that it had really swept by then.
    swept_mapping: f64,
    swept: f64,
    /// Share of the floor that is reachable on its map which it estimates to have swept.
    estimate: Option<f64>,
    /// Error of its pose in the end, m.
    error_m: f64,
    bumps: u32,
    end: &'static str,
}

/// Runs all seeds and returns the output.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let id = &arguments.behaviour;
    let info = controller::find(id).ok_or_else(|| Failure::unknown("behaviour", id, "behaviours"))?;
    let planner =
        coverage_planners::find(&arguments.by).ok_or_else(|| Failure::unknown("planner", &arguments.by, "planners"))?;
    let mut params = arguments.params.checked(info.params)?;
    // Only one that makes a map of its own has it.
    let _ = params.set_text(info.params, "tracking", arguments.tracking.id());
    let prepared = arguments.placement.placement(DEFAULT_ROBOT)?.prepare()?;
    let conditions = arguments.conditions.conditions();
    let first = arguments.params.seed;
    let mut outcomes = Vec::new();
    for seed in first..first.saturating_add(arguments.seeds) {
        let run = prepared.run_behaviour(info, &params, conditions, seed);
        let run = run.ok_or_else(|| Failure::unknown("behaviour", id, "behaviours"))?;
        let mut observer = MapObserver::default();
        if run.mapper().is_none() {
            let robot = prepared.robot.clone();
            let (tracking, odometry, start) = (arguments.tracking, arguments.conditions.odometry, prepared.floor.start);
            observer = observer.with_mapper(Mapper::new(MapperSetup { robot, start, tracking, odometry, seed }));
        }
        let run = run.observed(Box::new(observer));
        outcomes.push(clean(run, arguments, planner.id, seed));
    }
    Ok(if arguments.json { output::json(&outcomes) } else { to_text(&outcomes) })
}

/// Maps, then cleans.
fn clean(mut run: Run, arguments: &Arguments, planner: &'static str, seed: u64) -> CleanOutcome {
    while !run.is_finished() && run.time_s() < 60.0 * arguments.minutes {
        run.step();
    }
    let (mapped_s, swept_mapping) = (run.time_s(), run.coverage());
    run.apply(Input::Clean(planner));
    let most = ((mapped_s + MOST_S) / STEP_S) as u64;
    let carry = arguments.carry.map(|minutes| ((mapped_s + 60.0 * minutes) / STEP_S) as u64);
    while !run.is_finished() && run.steps() < most {
        if carry == Some(run.steps()) {
            run.apply(Input::Lift);
            for _ in 0..100 {
                run.step();
            }
            let place =
                run.floor().anywhere(&mut RandomStream::KidnappingBetweenCleanings.seeded(seed)).unwrap_or(run.pose());
            run.apply(Input::PutDown(place));
        }
        run.step();
    }
    let swept = run.intent().zip(run.mapper()).and_then(|(intent, mapper)| intent.swept(mapper.marks()));
    CleanOutcome {
        seed,
        mapped_s,
        end_s: run.time_s(),
        swept_mapping,
        swept: run.coverage(),
        estimate: swept.map(|[swept, all]| swept / all.max(1e-9)),
        error_m: run.pose_error_m().unwrap_or_default(),
        bumps: run.bumps(),
        end: if run.is_finished() { run.activity() } else { "not finished" },
    }
}

fn to_text(outcomes: &[CleanOutcome]) -> String {
    let mut text = String::new();
    let heads = ["mapped", "swept", "cleaned", "swept", "estimate", "pose off", "bumps"];
    // Writing to a string can't fail.
    let _ = write!(text, "{:>8}", "seed");
    for head in heads {
        let _ = write!(text, " {head:>9}");
    }
    text.push('\n');
    for outcome in outcomes {
        let _ = writeln!(text, "{:>8}{}  {}", outcome.seed, row(&outcome.numbers()), outcome.end);
    }
    for (name, p) in [("worst", 0.0), ("median", 0.5), ("best", 1.0)] {
        let column = |i: usize| {
            let mut values: Vec<f64> = outcomes.iter().map(|outcome| outcome.numbers()[i]).collect();
            values.sort_by(f64::total_cmp);
            // Of shares, more is better.
            let is_share = matches!(i, 1 | 3 | 4);
            quantile(&values, if is_share { p } else { 1.0 - p }).unwrap_or_default()
        };
        let _ = writeln!(text, "{name:>8}{}", row(&std::array::from_fn(column)));
    }
    text + "mapped, cleaned: time needed; swept: true share of the reachable floor swept by then; estimate: the robot's own\n\
            estimate of that share, from its map; pose off: pose error at the end\n"
}

impl CleanOutcome {
    fn numbers(&self) -> [f64; 7] {
        let estimate = self.estimate.unwrap_or_default();
        let Self { mapped_s, end_s, swept_mapping, swept, error_m, bumps, .. } = *self;
        [mapped_s, swept_mapping, end_s - mapped_s, swept, estimate, error_m, f64::from(bumps)]
    }
}

fn row(numbers: &[f64; 7]) -> String {
    let cell = |(i, number): (usize, &f64)| match i {
        0 | 2 => format!("{:.1} min", number / 60.0),
        1 | 3 | 4 => format!("{:.1} %", 100.0 * number),
        5 => format!("{:.1} cm", 100.0 * number),
        _ => format!("{number:.0}"),
    };
    numbers.iter().enumerate().map(cell).fold(String::new(), |mut text, cell| {
        let _ = write!(text, " {cell:>9}");
        text
    })
}
