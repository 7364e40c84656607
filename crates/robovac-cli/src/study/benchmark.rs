//! `benchmark`: a study of every planner and behaviour over a fixed set of rooms, and its table.

use super::{Failure, Opened, Shards, open, read, table, work};
use coverage_planners::PLANNERS;
use robovac_sim::{
    controller::{BEHAVIOURS, BehaviourInfo},
    montecarlo::quantile,
    study::{StudyRoom, fingerprint},
};
use serde_json::json;
use std::{
    fmt::Write,
    fs,
    path::{Path, PathBuf},
    thread,
};

/// Rooms of the benchmark: furnished, mazes, and shapes of the literature, all small enough for 20 minutes.
const ROOMS: [&str; 12] = [
    "flat",
    "bedroom",
    "kitchen",
    "dining",
    "clutter",
    "living",
    "thesis226",
    "empty",
    "ushape",
    "comb",
    "ring",
    "crossing",
];
/// Seeds of the generated flats, and of the runs in each room.
const FLATS: u64 = 20;
const SEEDS: u64 = 3;
const MINUTES: f64 = 20.0;

/// Drive every planner and behaviour in a fixed set of rooms, and write the table of all (see docs/benchmark.md)
#[derive(clap::Args)]
pub struct Arguments {
    /// Folder for the study, its runs as Parquet, and the table as CSV and Markdown
    #[arg(long, value_name = "FOLDER", default_value = "benchmark")]
    out: PathBuf,
    /// Only two rooms, one flat, one seed and two minutes, to check that everything works
    #[arg(long)]
    quick: bool,
    /// Make the table of this study instead
    #[arg(long, value_name = "FILE", conflicts_with = "quick")]
    study: Option<PathBuf>,
    /// Runs in parallel [default: one per core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    jobs: Option<u16>,
}

/// What is known of an algorithm in one set of rooms under the same conditions.
struct ResultGroup {
    algorithm: String,
    rooms: &'static str,
    conditions: String,
    runs: usize,
    failed: usize,
    /// Shares of the floor; times to 90 %, s, infinite for those that never had so much; distances, m; bumps.
    coverage: Vec<f64>,
    reached_s: Vec<f64>,
    distance_m: Vec<f64>,
    bumps: Vec<f64>,
    digests: Vec<u8>,
}

/// Runs the benchmark; returns the table.
pub fn run(Arguments { out, quick, study: given, jobs }: &Arguments) -> Result<String, Failure> {
    fs::create_dir_all(out).map_err(|error| Failure::io(out.display(), &error))?;
    let (study, runs) = (out.join("study.json"), out.join("runs.parquet"));
    if runs.exists() {
        let runs = runs.display();
        return Err(Failure::usage(format!("{runs}: the file exists; choose another --out or delete it")));
    }
    let text = format!("{:#}\n", spec(*quick));
    let opened = given.as_ref().map_or_else(|| read(&study, text.as_bytes()), |given| open(given))?;
    let shards = Shards::open(&runs, &opened)?;
    let jobs = jobs.map_or_else(|| thread::available_parallelism().map_or(1, usize::from), usize::from);
    work::make_shards(&opened, &shards, (0, 1), jobs)?;
    let groups = groups(&opened, &shards)?;
    let command = match given {
        Some(given) => format!("benchmark --study {}", given.display()),
        None => format!("benchmark{}", if *quick { " --quick" } else { "" }),
    };
    let markdown = markdown(&groups, &command);
    if given.is_none() {
        put(&study, &text)?;
    }
    put(&out.join("table.csv"), &csv(&groups))?;
    put(&out.join("table.md"), &markdown)?;
    table::write(&opened, &shards, &runs)?;
    shards.remove()?;
    Ok(markdown)
}

/// The study: whatever is in the registries takes part.
fn spec(is_quick: bool) -> serde_json::Value {
    let rooms: &[&str] = if is_quick { &["bedroom", "ushape"] } else { &ROOMS };
    let mut rooms: Vec<_> = rooms.iter().map(|room| json!({ "room": room })).collect();
    rooms.push(json!({ "flats": { "first": 1, "count": if is_quick { 1 } else { FLATS } } }));
    let planners = PLANNERS.iter().map(|info| json!({ "planner": info.id }));
    let drives = |info: &&&BehaviourInfo| info.claims.cleans && !info.claims.manual && !info.claims.needs_laser;
    let behaviours = BEHAVIOURS.iter().filter(drives);
    json!({
        "format": "robovac-study",
        "version": 1,
        "name": "Benchmark of the field",
        "rooms": rooms,
        "robots": [{ "robot": "roomba600" }],
        "algorithms": planners.chain(behaviours.map(|info| json!({ "behaviour": info.id }))).collect::<Vec<_>>(),
        "conditions": [{ "name": "perfect" }, { "name": "typical", "slip": "typical", "noise": "typical" }],
        "seeds": { "first": 1, "count": if is_quick { 1 } else { SEEDS } },
        "minutes": if is_quick { 2.0 } else { MINUTES },
    })
}

/// Groups in the order of the study.
fn groups(opened: &Opened, shards: &Shards) -> Result<Vec<ResultGroup>, Failure> {
    let mut groups: Vec<ResultGroup> = Vec::new();
    for shard in 0..shards.count() {
        for row in shards.load(shard)? {
            let Some(run) = opened.study.run(row.run) else { continue };
            let rooms = if matches!(run.room, StudyRoom::Flat(_)) { "flats" } else { "rooms" };
            let (algorithm, conditions) = (run.entrant.to_string(), run.conditions.name.clone());
            let is_its = |group: &ResultGroup| {
                group.algorithm == algorithm && group.rooms == rooms && group.conditions == conditions
            };
            let index = groups.iter().position(is_its).unwrap_or(groups.len());
            if index == groups.len() {
                groups.push(ResultGroup::new(algorithm, rooms, conditions));
            }
            let Some(group) = groups.get_mut(index) else { continue };
            group.runs += 1;
            let Some(outcome) = row.outcome else {
                group.failed += 1;
                continue;
            };
            group.coverage.push(outcome.coverage);
            group.reached_s.push(outcome.reached_s[0].unwrap_or(f64::INFINITY));
            group.distance_m.push(outcome.distance_m);
            group.bumps.push(f64::from(outcome.bumps));
            group.digests.extend(outcome.digest.as_bytes());
        }
    }
    for group in &mut groups {
        for values in [&mut group.coverage, &mut group.reached_s, &mut group.distance_m, &mut group.bumps] {
            values.sort_by(f64::total_cmp);
        }
    }
    Ok(groups)
}

impl ResultGroup {
    fn new(algorithm: String, rooms: &'static str, conditions: String) -> Self {
        let (coverage, reached_s, distance_m, bumps, digests) = Default::default();
        let (runs, failed) = (0, 0);
        Self { algorithm, rooms, conditions, runs, failed, coverage, reached_s, distance_m, bumps, digests }
    }

    /// Median, and the 10 % and 90 % quantiles of coverage, %.
    fn coverage(&self) -> Option<[f64; 3]> {
        let at = |p| quantile(&self.coverage, p).map(|share| 100.0 * share);
        Some([at(0.5)?, at(0.1)?, at(0.9)?])
    }
}

/// One line for each group.
fn csv(groups: &[ResultGroup]) -> String {
    let mut text = "algorithm,rooms,conditions,runs,failed,coverage_percent,coverage_p10,coverage_p90,time_to_90_s,\
                    distance_m,bumps,digest,version\n"
        .to_owned();
    for group in groups {
        let ResultGroup { algorithm, rooms, conditions, runs, failed, .. } = group;
        let number = |value: Option<f64>| {
            value.filter(|value| value.is_finite()).map_or_else(String::new, |value| format!("{value:.2}"))
        };
        let [median, low, high] = group.coverage().map_or([None; 3], |numbers| numbers.map(Some)).map(number);
        let [reached, distance, bumps] =
            [&group.reached_s, &group.distance_m, &group.bumps].map(|values| number(quantile(values, 0.5)));
        let (digest, version) = (fingerprint([group.digests.as_slice()]), env!("CARGO_PKG_VERSION"));
        let _ = writeln!(
            text,
            "{algorithm},{rooms},{conditions},{runs},{failed},{median},{low},{high},{reached},{distance},{bumps},\
             {digest:016x},{version}"
        );
    }
    text
}

/// One line for each algorithm.
fn markdown(groups: &[ResultGroup], command: &str) -> String {
    let (mut names, mut columns) = (Vec::new(), Vec::new());
    for ResultGroup { algorithm, rooms, conditions, .. } in groups {
        if !names.contains(&algorithm.as_str()) {
            names.push(algorithm.as_str());
        }
        if !columns.contains(&(*rooms, conditions.as_str())) {
            columns.push((*rooms, conditions.as_str()));
        }
    }
    let mut text = "| algorithm |".to_owned();
    for (rooms, conditions) in &columns {
        let _ = write!(text, " {rooms}, {conditions} |");
    }
    let _ = writeln!(text, " runs without results |\n|---|{}--:|", "--:|".repeat(columns.len()));
    for name in names {
        let its = || groups.iter().filter(move |group| group.algorithm == name);
        let _ = write!(text, "| `{name}` |");
        for (rooms, conditions) in &columns {
            let group = its().find(|group| group.rooms == *rooms && group.conditions == *conditions);
            let cell = group.and_then(ResultGroup::coverage);
            let cell =
                cell.map_or("–".to_owned(), |[median, low, high]| format!("{median:.1} ({low:.0} to {high:.0})"));
            let _ = write!(text, " {cell} |");
        }
        let (failed, runs) = its().fold((0, 0), |(failed, runs), group| (failed + group.failed, runs + group.runs));
        let _ = writeln!(text, " {failed} of {runs} |");
    }
    let digest = fingerprint(groups.iter().map(|group| group.digests.as_slice()));
    let version = env!("CARGO_PKG_VERSION");
    let _ = writeln!(
        text,
        "\nSwept share of the reachable floor, %: the median, and the 10 % and 90 % quantiles. \
         `robovac {command}`, version {version}, digest of all runs {digest:016x}."
    );
    text
}

fn put(path: &Path, text: &str) -> Result<(), Failure> {
    fs::write(path, text).map_err(|error| Failure::io(path.display(), &error))
}
