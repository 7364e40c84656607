//! Planning, by planners of the registry and by those written in Python.

use crate::{
    failure::Failure,
    place::{PlaceArguments, checked},
    watch::SignalWatch,
};
use coverage_planners::{Bounds, CoveragePath, PlannerInfo, find, metrics::METRICS, smooth::SmoothSetup};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::{prelude::*, types::PyDict};
use robovac_core::{
    geometry::Point,
    grid::{Cell, Direction, Grid},
};
use robovac_sim::{
    controller,
    experiment::{
        PlanAnswer, Planned,
        planning::{Placement, PlanSolution, PlanningTask},
    },
};
use serde_json::json;
use std::time::Instant;

/// What determines a plan.
pub struct PlanArguments<'a> {
    /// Room and robot.
    pub place: &'a PlaceArguments,
    /// Id of the planner.
    pub planner: &'a str,
    /// Its parameters.
    pub params: &'a [(String, String)],
    /// Share of the floor for which the cells are chosen, percent.
    pub coverage_percent: Option<f64>,
    /// Seed of its random numbers.
    pub seed: u64,
    /// Whether corners will be rounded.
    pub is_rounded: bool,
}

/// The planner with that id.
pub fn planner(id: &str) -> Result<&'static PlannerInfo, Failure> {
    find(id).ok_or_else(|| match controller::find(id) {
        Some(_) => Failure::usage(format!("\"{id}\" is a behaviour: simulate(room, behaviour=\"{id}\")")),
        None => Failure::unknown("planner", id, "planners"),
    })
}

impl PlanArguments<'_> {
    /// Plans; ends early if `watch` says so.
    pub fn solve(&self, watch: &mut SignalWatch) -> Result<(PlanningTask, PlanSolution), Failure> {
        let planner = planner(self.planner)?;
        let params = checked(planner.params, self.params)?;
        let mut task = PlanningTask {
            placement: self.place.placement()?,
            planner,
            params,
            seed: self.seed,
            is_rounded: self.is_rounded,
        };
        if let Some(percent) = self.coverage_percent {
            task.fit_cells(percent / 100.0, &mut |_| watch.look())?;
        }
        let begin = Instant::now();
        let solution = task.solve(|| begin.elapsed().as_secs_f64(), Some(&mut |_| watch.look()))?;
        Ok((task, solution))
    }
}

/// Plans with a planner of the registry.
#[pyfunction]
pub fn plan<'py>(
    py: Python<'py>,
    place: PlaceArguments,
    planner: &str,
    params: Vec<(String, String)>,
    coverage_percent: Option<f64>,
    seed: u64,
) -> PyResult<Bound<'py, PyDict>> {
    let arguments =
        PlanArguments { place: &place, planner, params: &params, coverage_percent, seed, is_rounded: false };
    let mut watch = SignalWatch::new();
    let solved = py.detach(|| arguments.solve(&mut watch));
    watch.finish()?;
    let (task, solution) = solved?;
    let given = serde_json::to_value(&task.params).unwrap_or_default();
    to_python(py, &task.placement, &solution, json!({ "planner": planner, "params": given, "seed": seed }))
}

/// The grid that a planner written in Python gets.
#[pyfunction]
pub fn planning_job(py: Python<'_>, place: PlaceArguments) -> PyResult<Bound<'_, PyDict>> {
    let (placement, prepared) = py.detach(|| {
        let placement = place.placement()?;
        let prepared = placement.prepare()?;
        Ok::<_, Failure>((placement, prepared))
    })?;
    let job = &prepared.job;
    let heading = match job.heading {
        Direction::Right => "right",
        Direction::Up => "up",
        Direction::Left => "left",
        Direction::Down => "down",
    };
    let result = PyDict::new(py);
    result.set_item("free", flags(py, &job.free)?)?;
    result.set_item("start", (job.start.x, job.start.y))?;
    result.set_item("heading", heading)?;
    result.set_item("cell_m", placement.cells.size)?;
    result.set_item("step_s", job.step_s)?;
    result.set_item("turn_s", job.turn_s)?;
    Ok(result)
}

/// Checks and measures the walk of a planner written in Python.
#[pyfunction]
pub fn plan_given<'py>(
    py: Python<'py>,
    place: PlaceArguments,
    name: &str,
    cells: Vec<(i32, i32)>,
    planning_s: f64,
) -> PyResult<Bound<'py, PyDict>> {
    let solve = || {
        let placement = place.placement()?;
        let prepared = placement.prepare()?;
        let path = CoveragePath::walk(cells.iter().map(|&(x, y)| Cell::new(x, y)).collect());
        let answer = PlanAnswer { path, seconds: planning_s, proof: None, trace: Vec::new() };
        let planned = Planned::new(&prepared, &answer)
            .map_err(|error| Failure::contract(format!("planner \"{name}\" returned an invalid walk: {error}")))?;
        let smooth = SmoothSetup::default();
        Ok::<_, Failure>((placement, PlanSolution { prepared, path: answer.path, planned, smooth }))
    };
    let (placement, solution) = py.detach(solve)?;
    to_python(py, &placement, &solution, json!({ "planner": name, "params": {}, "seed": null }))
}

/// A plan as numbers in JSON, and arrays.
fn to_python<'py>(
    py: Python<'py>,
    placement: &Placement,
    solution: &PlanSolution,
    mut report: serde_json::Value,
) -> PyResult<Bound<'py, PyDict>> {
    let PlanSolution { prepared, path, planned, .. } = solution;
    let numbers = py.detach(|| planned.numbers(prepared, Bounds::of(&prepared.job)));
    report["robot"] = json!(placement.robot.id);
    report["cell_m"] = json!(placement.cells.size);
    report["cell_offset_m"] = json!(placement.cells.offset);
    report["start"] = json!([prepared.job.start.x, prepared.job.start.y]);
    report["heading_deg"] = json!(prepared.floor.start.heading.to_degrees());
    report["walk"] = json!(numbers.walk);
    report["drive"] = json!(numbers.drive);
    report["bounds"] = json!(numbers.bounds);
    report["above_bound_percent"] = json!(numbers.above_bound_percent());
    report["planning_s"] = json!(numbers.planning_s);
    report["proof"] = json!(planned.proof.map(|proof| json!({ "cost": proof.cost, "bound": proof.bound })));
    report["metrics"] = METRICS.iter().map(|metric| (metric.id, metric.value(&numbers))).collect();
    let result = PyDict::new(py);
    result.set_item("report", report.to_string())?;
    let cells: Vec<i32> = path.cells.iter().flat_map(|cell| [cell.x, cell.y]).collect();
    result.set_item("cells", pairs(py, cells)?)?;
    result.set_item("line_m", points(py, &planned.line)?)?;
    result.set_item("free", flags(py, &prepared.job.free)?)?;
    Ok(result)
}

/// Values in pairs, one row each.
fn pairs<T: numpy::Element>(py: Python<'_>, values: Vec<T>) -> PyResult<Bound<'_, PyArray2<T>>> {
    let rows = values.len() / 2;
    PyArray1::from_vec(py, values).reshape([rows, 2])
}

/// Points, one row each, m.
pub fn points<'py>(py: Python<'py>, points: &[Point]) -> PyResult<Bound<'py, PyArray2<f64>>> {
    pairs(py, points.iter().flat_map(|at| [at.x, at.y]).collect())
}

/// A grid; row 0 is at the bottom.
pub fn flags<'py>(py: Python<'py>, grid: &Grid<bool>) -> PyResult<Bound<'py, PyArray2<bool>>> {
    PyArray1::from_slice(py, grid.values()).reshape([grid.height(), grid.width()])
}
