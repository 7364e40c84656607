//! `montecarlo`: many runs of the same algorithms, on all cores.

use super::{
    conditions::ConditionsArguments,
    failure::Failure,
    parallel::{in_parallel, jobs},
    simulate::DEFAULT_ROBOT,
    task::PlacementArguments,
};
use robovac_sim::{
    Conditions,
    experiment::{Algorithm, BEHAVIOUR, Entrant, PLANNER, planning::Placement},
    montecarlo::{Band, EntrantRuns, Lab, RunsHeader, Summary, Terms, TimeTo, to_csv, to_json},
};
use std::fmt::Write;

/// Run behaviours and planned paths many times and report statistics
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    placement: PlacementArguments,
    #[command(flatten)]
    entrants: EntrantArguments,
    /// Number of runs of each algorithm, one seed per run
    #[arg(long, value_name = "N", default_value_t = 30, value_parser = clap::value_parser!(u64).range(1..=100_000))]
    seeds: u64,
    /// First seed
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Seed of planners, which plan once [default: the first seed]
    #[arg(long, value_name = "N")]
    plan_seed: Option<u64>,
    /// Simulated time of each run
    #[arg(long, value_name = "MINUTES", default_value_t = 30.0, value_parser = parse_minutes, allow_hyphen_values = true)]
    minutes: f64,
    #[command(flatten)]
    conditions: ConditionsArguments,
    /// Round the corners of plans: curves instead of stops where they keep the floor swept
    #[arg(long)]
    smooth: bool,
    /// Runs in parallel [default: one per core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    jobs: Option<u16>,
    /// Write quantiles, curves and all runs as JSON instead of a table
    #[arg(long, conflicts_with = "csv")]
    json: bool,
    /// Write all runs as CSV instead of a table
    #[arg(long)]
    csv: bool,
}

/// At least one must be given.
#[derive(clap::Args)]
#[group(required = true, multiple = true)]
struct EntrantArguments {
    /// Behaviours, see "robovac behaviours", with parameters as in "compare"; repeated or separated by commas
    #[arg(long = "behaviour", value_name = "LIST", value_delimiter = ',')]
    behaviours: Vec<String>,
    /// Planners, see "robovac planners", whose paths are driven; repeated or separated by commas
    #[arg(long = "planner", value_name = "LIST", value_delimiter = ',')]
    planners: Vec<String>,
}

/// Makes all runs and returns the output.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let entrants = arguments.entrants.find()?;
    let placement = arguments.placement.placement(DEFAULT_ROBOT)?;
    let (conditions, odometry) = (arguments.conditions.conditions(), arguments.conditions.odometry);
    let terms = Terms {
        conditions,
        odometry,
        smooth: arguments.smooth,
        duration_s: 60.0 * arguments.minutes,
        plan_seed: arguments.plan_seed.unwrap_or(arguments.seed),
    };
    let lab = Lab::on(placement.prepare()?, terms);
    // That an algorithm has no plan here is a result too.
    let failures: Vec<Option<String>> =
        entrants.iter().map(|entrant| lab.plan(entrant, None).err().map(|error| error.to_string())).collect();
    let seeds = arguments.seed..arguments.seed.saturating_add(arguments.seeds);
    let able = (0..entrants.len()).filter(|&who| failures[who].is_none());
    let runs: Vec<(usize, u64)> = able.flat_map(|who| seeds.clone().map(move |seed| (who, seed))).collect();
    let outcomes = in_parallel(&runs, jobs(arguments.jobs), |&(who, seed)| lab.run(&entrants[who], seed));
    let of =
        |who: usize| runs.iter().zip(&outcomes).filter(move |((w, _), _)| *w == who).filter_map(|(_, o)| o.as_ref());
    let result = |who: usize| failures[who].as_deref().map_or_else(|| Ok(of(who).collect()), Err);
    let entries: Vec<EntrantRuns<'_>> =
        entrants.iter().enumerate().map(|(who, entrant)| (entrant, result(who))).collect();
    let head = RunsHeader {
        room: &placement.plan.name,
        robot: placement.robot.id,
        cell_size_m: placement.cells.size,
        conditions,
        odometry,
        smooth: arguments.smooth,
        minutes: arguments.minutes,
    };
    Ok(match (arguments.json, arguments.csv) {
        (true, _) => to_json(&head, &entries),
        (_, true) => to_csv(&head, &entries),
        _ => table(&head, &placement, arguments, &entries),
    })
}

impl EntrantArguments {
    fn find(&self) -> Result<Vec<Entrant>, Failure> {
        let behaviours = self.behaviours.iter().map(|name| (BEHAVIOUR, name));
        let mut entrants = Vec::new();
        for (kind, name) in behaviours.chain(self.planners.iter().map(|name| (PLANNER, name))) {
            let id = name.split('~').next().unwrap_or_default();
            Algorithm::find_kind(kind, id).map_err(|_| Failure::unknown(kind, id, &format!("{kind}s")))?;
            let entrant = Entrant::parse(kind, name).map_err(|error| Failure::usage(error.to_string()))?;
            if entrant.algorithm.behaviour().is_some_and(|info| info.claims.manual) {
                return Err(Failure::usage(format!("behaviour \"{id}\" is driven by hand; choose another one")));
            }
            entrants.push(entrant);
        }
        Ok(entrants)
    }
}

/// Columns of numbers.
const COLUMNS: usize = 11;

/// A Markdown table: medians, with 10 to 90 % of the runs in brackets.
fn table(head: &RunsHeader<'_>, placement: &Placement, arguments: &Arguments, entries: &[EntrantRuns<'_>]) -> String {
    let Conditions { slip, noise, quantised, start_charge_percent: charge, .. } = head.conditions;
    let quantised = if quantised { ", rounded wheel speeds" } else { "" };
    let smooth = if arguments.smooth { ", rounded corners" } else { "" };
    let charge = if charge < 100 { format!(", start charge {charge} %") } else { String::new() };
    let (robot, minutes) = (placement.robot.title, head.minutes);
    let mut text = format!(
        "### {}, {robot}: {} runs of {minutes} min, slip {}, noise {noise}{quantised}{smooth}{charge}\n\n\
         | Algorithm | Coverage, % | 90 % after, min | runs | 99 % after, min | runs | Distance, m | Excess in metres, % | in minutes, % | Bumps | Falls | Dirt left, % |\n\
         |---{}|\n",
        head.room,
        arguments.seeds,
        slip.id(),
        "|--:".repeat(COLUMNS),
    );
    for (entrant, result) in entries {
        let summary = match result {
            Ok(runs) => Summary::of(runs),
            Err(why) => {
                let _ = writeln!(text, "| {entrant} ({why}) |{}", " – |".repeat(COLUMNS));
                None
            }
        };
        let Some(summary) = summary else { continue };
        let Summary { runs, coverage, time_to: [to_90, to_99], distance_m, bumps, falls, dirt_left, excess } = summary;
        let percent = coverage.times(100.0);
        let dirt = dirt_left.map_or("–".to_owned(), |left| band(left.times(100.0), 1));
        let excess =
            excess.map_or(["–", "–"].map(str::to_owned), |above| above.map(|share| band(share.times(100.0), 0)));
        let [metres, minutes] = excess;
        let time = |to: &TimeTo| format!("{} | {}", times(to), share(to.reached, runs));
        // Writing to a string doesn't fail.
        let _ = writeln!(
            text,
            "| {entrant} | {} | {} | {} | {} | {metres} | {minutes} | {} | {falls} | {dirt} |",
            band(percent, 1),
            time(&to_90),
            time(&to_99),
            band(distance_m, 0),
            band(bumps, 0)
        );
    }
    text += "\nMedians, with the 10th and 90th percentiles in brackets. Dash: too few runs got there in time.\n\
             Excess: distance above the least that sweeping as much floor takes, and time above driving that at top speed.\n";
    if entries.iter().any(|(entrant, _)| entrant.explores()) {
        text += "Coverage of exploring behaviours: share of reachable walls and furniture detected.\n";
    }
    text
}

fn band(Band { low, median, high }: Band, digits: usize) -> String {
    format!("{median:.digits$} ({low:.digits$} to {high:.digits$})")
}

/// Times in minutes, with a dash for what too few runs reached.
fn times(to: &TimeTo) -> String {
    let [low, median, high] =
        [to.low_s, to.median_s, to.high_s].map(|s| s.map_or("–".to_owned(), |s| format!("{:.1}", s / 60.0)));
    if to.reached == 0 { median } else { format!("{median} ({low} to {high})") }
}

fn share(reached: usize, runs: usize) -> String {
    format!("{:.0} %", 100.0 * reached as f64 / runs as f64)
}

pub fn parse_minutes(text: &str) -> Result<f64, String> {
    let minutes = text.parse().ok().filter(|minutes: &f64| (0.1..=6000.0).contains(minutes));
    minutes.ok_or_else(|| "give a number of minutes from 0.1 to 6000, e.g. 30".to_owned())
}
