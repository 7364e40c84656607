//! `compare`: planners against each other in the same rooms, by one definition of every number.

use super::{
    failure::Failure,
    output,
    parallel::{in_parallel, jobs},
    source,
};
use coverage_planners::{
    PLANNERS,
    metrics::{METRICS, PlanNumbers},
};
use robovac_app::compare::{ComparisonTable, Record, RoomChoice, RoomSet, Row, to_csv, to_json};
use robovac_core::{
    floor_plan::{FloorPlan, room},
    robot::RobotModel,
};
use robovac_sim::experiment::{
    Algorithm, Arena, Entrant,
    planning::{CELL_ROBOT, choose_robot},
};
use std::{path::Path, time::Instant};

/// Compare planners in the same rooms
#[derive(clap::Args)]
pub struct Arguments {
    /// Rooms, separated by commas: ids (see "robovac rooms"), kinds of rooms, "all", or map files
    #[arg(long, value_name = "LIST", default_value = "all", value_delimiter = ',')]
    rooms: Vec<String>,
    /// Planners, separated by commas, with their parameters: "boustrophedon,snake~patience:3"; "all" or "fast" for many
    #[arg(long, value_name = "LIST", default_value = "fast", value_delimiter = ',')]
    planners: Vec<String>,
    /// Robot, see "robovac robots"; "cell" fills one planning cell
    #[arg(long, value_name = "ID", default_value = CELL_ROBOT)]
    robot: String,
    /// Planning cell size in metres [default: the map's cell size for the robot "cell", else chosen for the robot]
    #[arg(long, value_name = "M")]
    cell: Option<f64>,
    /// Round the corners: curves instead of stops where they keep the floor swept
    #[arg(long)]
    smooth: bool,
    /// First random seed
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Number of seeds for randomised planners; the table shows the median
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..=1000))]
    seeds: u64,
    /// Plans made in parallel [default: one per core]; with 1, planning times are more stable
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    jobs: Option<u16>,
    /// Write all trials as JSON instead of a table
    #[arg(long, conflicts_with = "csv")]
    json: bool,
    /// Write all trials as CSV instead of a table
    #[arg(long)]
    csv: bool,
}

/// A room with what its trials need.
struct TrialRoom {
    name: String,
    robot: RobotModel,
    cell_size: f64,
    arena: Result<Arena, String>,
}

/// One planner in one room with one seed; numbers in the lists of rooms and planners.
struct CompareTrial {
    place: usize,
    entrant: usize,
    seed: u64,
}

/// Makes all trials and returns the output.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let plans = plans(&arguments.rooms)?;
    let entrants = entrants(&arguments.planners)?;
    let place = |plan: &FloorPlan| {
        let (robot, cell_size) = choose_robot(&arguments.robot, plan, arguments.cell)
            .ok_or_else(|| Failure::unknown("robot", &arguments.robot, "robots"))?;
        let arena = Arena::new(plan, &robot, cell_size, None).map_err(|e| e.to_string());
        let arena = arena.map(|arena| arena.smooth(arguments.smooth));
        Ok(TrialRoom { name: plan.name.clone(), robot, cell_size, arena })
    };
    let places: Vec<TrialRoom> = plans.iter().map(place).collect::<Result<_, Failure>>()?;
    let mut trials = Vec::new();
    for place in 0..places.len() {
        for (index, entrant) in entrants.iter().enumerate() {
            let seeds = if entrant.is_deterministic() { 1 } else { arguments.seeds };
            trials.extend((0..seeds).map(|i| CompareTrial { place, entrant: index, seed: arguments.seed + i }));
        }
    }
    let attempt = |trial: &CompareTrial| attempt(&places[trial.place], &entrants[trial.entrant], trial.seed);
    let results = in_parallel(&trials, jobs(arguments.jobs), attempt);
    let record = |(trial, result): (&CompareTrial, _)| {
        let place: &TrialRoom = &places[trial.place];
        Record {
            room: &place.name,
            robot: place.robot.id,
            cells: place.cell_size.into(),
            entrant: &entrants[trial.entrant],
            seed: trial.seed,
            result,
        }
    };
    let records = || trials.iter().zip(&results).map(record).collect::<Vec<_>>();
    Ok(match (arguments.json, arguments.csv) {
        (true, _) => to_json(&records()),
        (_, true) => to_csv(&records()),
        _ => tables(&places, &entrants, &trials, &results),
    })
}

fn attempt(place: &TrialRoom, entrant: &Entrant, seed: u64) -> Result<PlanNumbers, String> {
    let begin = Instant::now();
    let arena = place.arena.as_ref().map_err(Clone::clone)?;
    let planner = entrant.algorithm.planner().ok_or("a behaviour doesn't plan; use robovac montecarlo")?;
    let outcome = arena.run(planner, &entrant.params, seed, || begin.elapsed().as_secs_f64(), None);
    outcome.map(|outcome| outcome.numbers).map_err(|e| e.to_string())
}

/// The rooms by id, kind, "all" or file.
fn plans(names: &[String]) -> Result<Vec<FloorPlan>, Failure> {
    let mut plans = Vec::new();
    for name in names {
        if let Some(info) = room(name) {
            plans.push((info.build)());
        } else if let Ok(set) = RoomSet::parse(name) {
            plans.extend(set.rooms(RoomChoice::Own).iter().filter_map(|choice| match choice {
                RoomChoice::Shipped(id) => room(id).map(|info| (info.build)()),
                RoomChoice::Own => None,
            }));
        } else if Path::new(name).exists() {
            plans.push(source::load_with_image(Path::new(name))?);
        } else {
            let known = RoomSet::all().map(|set| set.1).filter(|&id| id != "this").collect::<Vec<_>>().join(", ");
            return Err(Failure::usage(format!(
                "\"{name}\" is neither a room (\"robovac rooms\" lists them), nor a kind of rooms ({known}), nor a file"
            )));
        }
    }
    Ok(plans)
}

fn entrants(names: &[String]) -> Result<Vec<Entrant>, Failure> {
    let mut entrants = Vec::new();
    for name in names {
        match &**name {
            "all" => entrants.extend(PLANNERS.iter().map(|&p| Entrant::new(Algorithm::Planner(p)))),
            "fast" => {
                entrants
                    .extend(PLANNERS.iter().filter(|p| p.claims.fast).map(|&p| Entrant::new(Algorithm::Planner(p))));
            }
            name => entrants.push(Entrant::parse_planner(name).map_err(|e| Failure::usage(e.to_string()))?.0),
        }
    }
    Ok(entrants)
}

/// Metrics that a table on a terminal has room for.
const SHOWN: [&str; 10] = [
    "coverage",
    "above_minimum",
    "length",
    "duration",
    "excess_length",
    "excess_time",
    "turns",
    "steps",
    "revisits",
    "planning",
];

/// A Markdown table for each room.
fn tables(
    places: &[TrialRoom],
    entrants: &[Entrant],
    trials: &[CompareTrial],
    results: &[Result<PlanNumbers, String>],
) -> String {
    let columns: Vec<usize> =
        METRICS.iter().enumerate().filter(|(_, metric)| SHOWN.contains(&metric.id)).map(|(i, _)| i).collect();
    let row = |place: usize, (index, entrant): (usize, &Entrant)| {
        let own = trials.iter().zip(results).filter(|(trial, _)| (trial.place, trial.entrant) == (place, index));
        Row::new(entrant.clone(), index, &[own.map(|(_, result)| result.clone()).collect()])
    };
    let table = |(index, place): (usize, &TrialRoom)| {
        let title = format!("{}, {}, cells of {} m", place.name, place.robot.title, place.cell_size);
        let rows = entrants.iter().enumerate().map(|entrant| row(index, entrant)).collect();
        output::markdown(&title, &columns, &ComparisonTable::new(rows))
    };
    places.iter().enumerate().map(table).collect()
}
