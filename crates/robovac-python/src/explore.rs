//! Mapping an unknown room.

use crate::{
    conditions::ConditionsArguments,
    failure::Failure,
    place::{PlaceArguments, checked},
    room::Room,
    watch::SignalWatch,
};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::{prelude::*, types::PyDict};
use robovac_core::geometry::{Pose, difference};
use robovac_sim::{
    STEP_S, controller,
    mapping::{MapQuality, MapTruth, Mapper, MapperSetup, RESOLUTION, Tracking},
};
use serde_json::json;

/// Steps between two looks for signals.
const STEPS: u64 = 256;

/// What explores, and how its map is made.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct ExplorerArguments {
    behaviour: String,
    params: Vec<(String, String)>,
    tracking: String,
    seed: u64,
    max_time_s: f64,
}

struct Explored {
    mapper: Mapper,
    report: serde_json::Value,
    poses: Vec<f64>,
    estimates: Vec<f64>,
}

/// Drives and maps; the map is in the frame of the room.
#[pyfunction]
pub fn explore(
    py: Python<'_>,
    place: PlaceArguments,
    explorer: ExplorerArguments,
    conditions: ConditionsArguments,
) -> PyResult<Bound<'_, PyDict>> {
    let mut watch = SignalWatch::new();
    let explored = py.detach(|| explorer.run(&place, &conditions, &mut watch));
    watch.finish()?;
    let Explored { mapper, report, poses, estimates } = explored?;
    let rows = poses.len() / 3;
    let result = PyDict::new(py);
    result.set_item("report", report.to_string())?;
    result.set_item("pose", PyArray1::from_vec(py, poses).reshape([rows, 3])?)?;
    result.set_item("estimate", PyArray1::from_vec(py, estimates).reshape([rows, 3])?)?;
    let map = mapper.map().to_plan("Map");
    let origin = map.as_ref().map(|plan| (plan.origin.x, plan.origin.y));
    result.set_item("map", map.map(Room::of))?;
    result.set_item("origin_m", origin)?;
    Ok(result)
}

impl ExplorerArguments {
    fn run(
        &self,
        place: &PlaceArguments,
        conditions: &ConditionsArguments,
        watch: &mut SignalWatch,
    ) -> Result<Explored, Failure> {
        if !(self.max_time_s.is_finite() && self.max_time_s > 0.0) {
            let message = format!("max_time_s can't be {}; use a number of seconds greater than 0", self.max_time_s);
            return Err(Failure::usage(message));
        }
        let id = &self.behaviour;
        let info = controller::find(id).filter(|info| !info.claims.manual);
        let info = info.ok_or_else(|| Failure::unknown("behaviour", id, "behaviours"))?;
        let params = checked(info.params, &self.params)?;
        let tracking = Tracking::parse(&self.tracking).ok_or_else(|| {
            Failure::usage(format!("tracking can't be \"{}\"; use \"odometry\" or \"corrected\"", self.tracking))
        })?;
        let odometry = conditions.odometry()?;
        let prepared = place.placement()?.prepare()?;
        let run = prepared.run_behaviour(info, &params, conditions.conditions()?, self.seed);
        let mut run = run.ok_or_else(|| Failure::unknown("behaviour", id, "behaviours"))?;
        let (robot, start) = (prepared.robot.clone(), prepared.floor.start);
        let mut mapper = Mapper::new(MapperSetup { robot, start, tracking, odometry, seed: self.seed });
        let (mut poses, mut estimates) = (Vec::new(), Vec::new());
        let mut note = |truth: Pose, estimate: Pose| {
            poses.extend([truth.x, truth.y, truth.heading]);
            estimates.extend([estimate.x, estimate.y, estimate.heading]);
        };
        let most_steps = (self.max_time_s / STEP_S) as u64;
        let a_second = (1.0 / STEP_S) as u64;
        note(run.pose(), mapper.pose());
        while !run.is_finished() && run.steps() < most_steps {
            run.step();
            mapper.update(run.sensors());
            if run.steps().is_multiple_of(a_second) {
                note(run.pose(), mapper.pose());
            }
            if run.steps().is_multiple_of(STEPS) && watch.look().is_break() {
                break;
            }
        }
        note(run.pose(), mapper.pose());
        let truth = MapTruth::of(run.floor(), RESOLUTION);
        let MapQuality { right, known, boundary, boundary_error_m, cells } = truth.quality(mapper.map());
        let (at, estimate) = (run.pose(), mapper.pose());
        let report = json!({
            "behaviour": id, "robot": prepared.robot.id, "seed": self.seed, "tracking": self.tracking,
            "time_s": run.time_s(), "distance_m": run.distance_m(), "bumps": run.bumps(),
            "finished": run.is_finished(), "right": right, "known": known, "boundary": boundary,
            "boundary_error_m": boundary_error_m, "known_cells": cells,
            "pose_error_m": (at.position() - estimate.position()).norm(),
            "heading_error_deg": difference(at.heading, estimate.heading).abs().to_degrees(),
        });
        Ok(Explored { mapper, report, poses, estimates })
    }
}
