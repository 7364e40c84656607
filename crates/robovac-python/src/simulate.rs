//! Simulated runs.

use crate::{
    conditions::ConditionsArguments,
    controller::{BehaviourFault, PythonController},
    failure::Failure,
    place::{PlaceArguments, checked},
    plan::{PlanArguments, flags, points},
    watch::SignalWatch,
};
use coverage_planners::smooth::SmoothSetup;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::{prelude::*, types::PyDict};
use robovac_core::geometry::{Point, Pose};
use robovac_sim::{
    Conditions, Run, STEP_S, What, controller,
    experiment::planning::{Placement, RoomSetup},
};
use serde_json::json;
use std::sync::{Arc, PoisonError};

/// Default time after which a behaviour that doesn't end by itself is stopped, s.
const MOST_TIME_S: f64 = 1800.0;
/// Distance of the trail's points, m.
const TRAIL: f64 = 0.02;
/// Steps between two looks for signals.
const STEPS: u64 = 1024;

/// What drives.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct DriverArguments {
    planner: Option<String>,
    behaviour: Option<String>,
    /// A walk that was planned before.
    cells: Option<Vec<(i32, i32)>>,
    /// An object with `step`, and its name.
    object: Option<(Py<PyAny>, String)>,
    params: Vec<(String, String)>,
    coverage_percent: Option<f64>,
    smooth: bool,
    seed: u64,
    /// Of the planner.
    plan_seed: u64,
    sample_s: f64,
    max_time_s: Option<f64>,
}

/// What was seen on the way.
#[derive(Default)]
struct Log {
    time_s: Vec<f64>,
    coverage: Vec<f64>,
    pose: Vec<f64>,
    estimate: Vec<f64>,
    trail: Vec<Point>,
}

/// The end of a run.
struct Outcome {
    log: Log,
    totals: serde_json::Value,
    prepared: RoomSetup,
    visits: Vec<u8>,
    line: Vec<Point>,
    fault: Option<BehaviourFault>,
}

/// Drives to the end.
#[pyfunction]
pub fn simulate(
    py: Python<'_>,
    place: PlaceArguments,
    driver: DriverArguments,
    conditions: ConditionsArguments,
) -> PyResult<Bound<'_, PyDict>> {
    let mut watch = SignalWatch::new();
    let outcome = py.detach(|| driver.run(&place, &conditions, &mut watch));
    watch.finish()?;
    let outcome = outcome?;
    if let Some(fault) = &outcome.fault {
        let error = fault.lock().unwrap_or_else(PoisonError::into_inner).take();
        error.map_or(Ok(()), Err)?;
    }
    let Outcome { log, totals, prepared, visits, line, .. } = outcome;
    let floor = &prepared.floor;
    let (height, width) = (floor.floor.height(), floor.floor.width());
    let result = PyDict::new(py);
    result.set_item("totals", totals.to_string())?;
    result.set_item("time_s", PyArray1::from_vec(py, log.time_s))?;
    result.set_item("coverage", PyArray1::from_vec(py, log.coverage))?;
    result.set_item("pose", poses(py, log.pose)?)?;
    result.set_item("estimate", poses(py, log.estimate)?)?;
    result.set_item("trail_m", points(py, &log.trail)?)?;
    result.set_item("line_m", points(py, &line)?)?;
    result.set_item("visits", PyArray1::from_vec(py, visits).reshape([height, width])?)?;
    result.set_item("floor", flags(py, &floor.floor)?)?;
    result.set_item("resolution_m", floor.resolution)?;
    Ok(result)
}

impl DriverArguments {
    fn run(
        &self,
        place: &PlaceArguments,
        conditions: &ConditionsArguments,
        watch: &mut SignalWatch,
    ) -> Result<Outcome, Failure> {
        for (name, seconds) in [("sample_s", Some(self.sample_s)), ("max_time_s", self.max_time_s)] {
            if let Some(seconds) = seconds.filter(|seconds| !(seconds.is_finite() && *seconds > 0.0)) {
                return Err(Failure::usage(format!(
                    "{name} can't be {seconds}; use a number of seconds greater than 0"
                )));
            }
        }
        let odometry = conditions.odometry()?;
        let conditions = conditions.conditions()?;
        let (mut never_ends, mut line, mut fault) = (false, Vec::new(), None);
        let (placement, prepared, mut run) = match (&self.planner, &self.behaviour, &self.cells, &self.object) {
            (Some(planner), ..) => {
                let Self { params, coverage_percent, plan_seed, .. } = self;
                let arguments = PlanArguments {
                    place,
                    planner,
                    params,
                    coverage_percent: *coverage_percent,
                    seed: *plan_seed,
                    is_rounded: self.smooth,
                };
                let (task, solution) = arguments.solve(watch)?;
                let mut planned = solution.planned;
                if self.smooth {
                    planned = planned.rounded(&solution.prepared, &solution.smooth)?;
                }
                line = planned.line.to_vec();
                let run = planned.run(&solution.prepared, conditions, odometry, self.seed);
                (task.placement, solution.prepared, run)
            }
            (_, Some(id), ..) => {
                let info = controller::find(id).filter(|info| !info.claims.manual);
                let info = info.ok_or_else(|| Failure::unknown("behaviour", id, "behaviours"))?;
                never_ends = !info.claims.ends;
                let params = checked(info.params, &self.params)?;
                let (placement, prepared) = prepare(place)?;
                let run = prepared.run_behaviour(info, &params, conditions, self.seed);
                let run = run.ok_or_else(|| Failure::unknown("behaviour", id, "behaviours"))?;
                (placement, prepared, run)
            }
            (.., Some((object, name))) => {
                never_ends = true;
                let (placement, prepared) = prepare(place)?;
                let object = Python::attach(|py| object.clone_ref(py));
                let driver = PythonController::new(object, name.clone());
                fault = Some(driver.fault());
                let run = Run::new(&prepared.setup(conditions, self.seed), Box::new(driver));
                (placement, prepared, run)
            }
            (_, _, cells, _) => {
                let (placement, prepared) = prepare(place)?;
                let corners = self.given(&prepared, cells.as_deref().unwrap_or_default())?;
                line = corners.to_vec();
                let run = prepared.run_along(&corners, conditions, odometry, self.seed);
                (placement, prepared, run)
            }
        };
        let max_time = self.max_time_s.or(never_ends.then_some(MOST_TIME_S));
        let log = drive(&mut run, self.sample_s, max_time, watch);
        let totals = totals(&run, &placement, conditions);
        let visits = run.tracker().visits().values().to_vec();
        Ok(Outcome { log, totals, prepared, visits, line, fault })
    }

    /// The line of a walk that was planned before.
    fn given(&self, prepared: &RoomSetup, cells: &[(i32, i32)]) -> Result<Arc<[Point]>, Failure> {
        let cells = cells.iter().map(|&(x, y)| robovac_core::grid::Cell::new(x, y)).collect();
        let line = prepared
            .line(&coverage_planners::CoveragePath::walk(cells))
            .map_err(|error| Failure::contract(format!("the walk is invalid: {error}")))?;
        if !self.smooth {
            return Ok(line);
        }
        prepared.smooth(&line, &SmoothSetup::default(), false)?;
        Err(Failure::usage("smooth: only plans of planners of the list can be driven smoothly".to_owned()))
    }
}

fn prepare(place: &PlaceArguments) -> Result<(Placement, RoomSetup), Failure> {
    let placement = place.placement()?;
    let prepared = placement.prepare()?;
    Ok((placement, prepared))
}

/// Drives to the end or for `max_time` seconds.
fn drive(run: &mut Run, interval: f64, max_time: Option<f64>, watch: &mut SignalWatch) -> Log {
    let most_steps = max_time.map_or(u64::MAX, |seconds| (seconds / STEP_S) as u64);
    let mut log = Log::default();
    log.sample(run);
    log.trail.push(run.pose().position());
    while !run.is_finished() && run.steps() < most_steps {
        run.step();
        if run.steps().is_multiple_of(STEPS) && watch.look().is_break() {
            break;
        }
        let at = run.pose().position();
        if log.trail.last().is_none_or(|last| (at - last).norm_squared() > TRAIL * TRAIL) {
            log.trail.push(at);
        }
        let is_last = run.is_finished() || run.steps() == most_steps;
        if is_last || run.time_s() >= log.time_s.len() as f64 * interval {
            log.sample(run);
        }
    }
    log
}

impl Log {
    fn sample(&mut self, run: &Run) {
        self.time_s.push(run.time_s());
        self.coverage.push(run.coverage());
        let numbers = |pose: Pose| [pose.x, pose.y, pose.heading];
        self.pose.extend(numbers(run.pose()));
        self.estimate.extend(run.estimate().map_or([f64::NAN; 3], numbers));
    }
}

fn totals(run: &Run, placement: &Placement, conditions: Conditions) -> serde_json::Value {
    let battery_empty = run.events().iter().any(|event| event.what == What::BatteryEmpty);
    json!({
        "robot": placement.robot.id,
        "cell_m": placement.cells.size,
        "time_s": run.time_s(),
        "coverage": run.coverage(),
        "distance_m": run.distance_m(),
        "turning_deg": run.turning_rad().to_degrees(),
        "bumps": run.bumps(),
        "falls": run.falls(),
        "overlap": run.tracker().overlap(),
        "pose_error_m": run.pose_error_m(),
        "finished": run.is_finished() && !battery_empty,
        "battery_empty": battery_empty,
        "slip": conditions.slip.id(),
        "noise": conditions.noise.to_string(),
        "floor_m2": run.floor().area(),
        "digest": format!("{:016x}", run.digest()),
    })
}

/// Poses, one row each: x and y in m, heading in rad.
fn poses(py: Python<'_>, numbers: Vec<f64>) -> PyResult<Bound<'_, PyArray2<f64>>> {
    let rows = numbers.len() / 3;
    PyArray1::from_vec(py, numbers).reshape([rows, 3])
}
