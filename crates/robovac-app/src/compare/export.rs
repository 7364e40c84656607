//! Results as CSV and JSON, one record per trial; the same from the page and from the command line.

use coverage_planners::{
    Bounds,
    metrics::{METRICS, PlanNumbers},
};
use robovac_core::{coverage::PlanningCells, registry::Params};
use robovac_sim::experiment::Entrant;
use robovac_sim::experiment::quoted;
use serde::Serialize;
use std::{collections::BTreeMap, fmt::Write};

/// The result of one planner in one room with one seed.
#[derive(Debug, Clone)]
pub struct Record<'a> {
    /// Name of the room.
    pub room: &'a str,
    /// Name of the robot: its id, with what makes it an own one or a twin.
    pub robot: &'a str,
    /// Side of the planning cells, m, and where they begin.
    pub cells: PlanningCells,
    /// The planner with its parameters.
    pub entrant: &'a Entrant,
    /// Seed of its random numbers.
    pub seed: u64,
    /// The numbers, or the reason for the failure.
    pub result: &'a Result<PlanNumbers, String>,
}

#[derive(Serialize)]
struct JsonRecord<'a> {
    room: &'a str,
    robot: &'a str,
    cell_size_m: f64,
    /// Left out for cells that begin in the corner.
    #[serde(skip_serializing_if = "Option::is_none")]
    cell_offset_m: Option<[f64; 2]>,
    planner: &'static str,
    params: &'a Params,
    seed: u64,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<&'a str>,
    /// Reachable planning cells, for a walk.
    #[serde(skip_serializing_if = "Option::is_none")]
    cells: Option<usize>,
    /// Lower bounds in the room.
    #[serde(skip_serializing_if = "Option::is_none")]
    bounds: Option<Bounds>,
    /// By the names of [`METRICS`].
    numbers: BTreeMap<&'static str, Option<f64>>,
}

/// A JSON array of records. Numbers have the ids and units of [`METRICS`].
pub fn to_json(records: &[Record<'_>]) -> String {
    let records: Vec<JsonRecord<'_>> = records
        .iter()
        .map(|r| JsonRecord {
            room: r.room,
            robot: r.robot,
            cell_size_m: r.cells.size,
            cell_offset_m: (r.cells.offset != [0.0; 2]).then_some(r.cells.offset),
            planner: r.entrant.id(),
            params: &r.entrant.params,
            seed: r.seed,
            error: r.result.as_ref().err().map(String::as_str),
            cells: r.result.as_ref().ok().and_then(|numbers| Some(numbers.walk?.reachable_cells)),
            bounds: r.result.as_ref().ok().and_then(|numbers| numbers.bounds),
            numbers: match r.result {
                Ok(numbers) => METRICS.iter().map(|metric| (metric.id, metric.value(numbers))).collect(),
                Err(_) => BTreeMap::new(),
            },
        })
        .collect();
    // Fails only for maps whose keys aren't strings.
    serde_json::to_string_pretty(&records).unwrap_or_default() + "\n"
}

/// A table with a header line; numbers with their units in the header, empty if missing.
pub fn to_csv(records: &[Record<'_>]) -> String {
    let mut csv = String::from(
        "room,robot,cell size [m],cell offset x [m],cell offset y [m],planner,seed,error,cells,bound steps,bound turns,bound steps + 2 turns",
    );
    for metric in METRICS {
        let unit = if metric.unit.is_empty() { String::new() } else { format!(" [{}]", metric.unit) };
        // Writing to a string doesn't fail.
        let _ = write!(csv, ",{}{unit}", metric.id);
    }
    csv.push('\n');
    for r in records {
        let error = r.result.as_ref().err().map_or("", String::as_str);
        let PlanningCells { size, offset: [left, below] } = r.cells;
        let (room, robot, error) = (quoted(r.room), quoted(r.robot), quoted(error));
        let _ = write!(csv, "{room},{robot},{size},{left},{below},{},{},{error},", r.entrant, r.seed);
        let numbers = r.result.as_ref().ok();
        csv += &numbers.and_then(|n| Some(n.walk?.reachable_cells.to_string())).unwrap_or_default();
        match numbers.and_then(|n| n.bounds) {
            Some(Bounds { steps, turns, cost }) => {
                let _ = write!(csv, ",{steps},{turns},{cost}");
            }
            None => csv += ",,,",
        }
        for metric in METRICS {
            let value = r.result.as_ref().ok().and_then(|numbers| metric.value(numbers));
            let _ = write!(csv, ",{}", value.map(|v| v.to_string()).unwrap_or_default());
        }
        csv.push('\n');
    }
    csv
}
