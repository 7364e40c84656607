//! Runs as MCAP bags with ROS 2 messages, simulated again in a worker.

use robovac_app::{
    explore::{Session, SessionSnapshot},
    export::RunBag,
    map::MapSession,
};
use robovac_core::geometry::Point;
use robovac_playground::wire::{message, trajectory::trajectory_from_js};
use robovac_sim::experiment::planning::PathToDrive;
use std::sync::Arc;
use wasm_bindgen::prelude::*;

/// What is missing, as a sentence for users.
const MISFIT: &str =
    "There is no run: the robot doesn't fit into this room. Move its start, or choose a smaller robot.";

/// The run of a playground: `snapshot`, `corners`, `knots`, `inputs`, the end of the run and a program's log are the playground's.
/// Blocks until it was simulated again; throws a sentence for users.
#[wasm_bindgen]
pub fn run_bag(
    #[wasm_bindgen(unchecked_param_type = "rust.SessionSnapshot")] snapshot: JsValue,
    corners: &[f64],
    knots: &[f64],
    inputs: &[f64],
    end_s: f64,
    program_log: Option<Vec<u8>>,
) -> Result<Vec<u8>, JsValue> {
    let line: Vec<Point> = corners.chunks_exact(2).map(|at| Point::new(at[0], at[1])).collect();
    let smooth = (!knots.is_empty()).then(|| Arc::new(trajectory_from_js(knots)));
    let driven = PathToDrive { line: line.into(), smooth };
    let mut session = session(snapshot)?;
    if let Some(log) = program_log {
        session.extend_program(session.program_version(), &log).map_err(message)?;
    }
    let bag = RunBag::of_session(&session, &driven, RunBag::inputs_from_numbers(inputs), end_s);
    finish(bag.map_err(message)?)
}

/// The same of the Map tab: `link`, `stored` and a program's log are those of its session, `snapshot` is the playground's.
#[wasm_bindgen]
pub fn map_bag(
    #[wasm_bindgen(unchecked_param_type = "rust.SessionSnapshot")] snapshot: JsValue,
    link: &str,
    stored: &str,
    program_log: Option<Vec<u8>>,
) -> Result<Vec<u8>, JsValue> {
    let mut mapping = MapSession::new();
    mapping.take(&session(snapshot)?);
    mapping.restore(link).map_err(message)?;
    mapping.resume(stored).map_err(message)?;
    if let Some(log) = program_log {
        mapping.extend_program(mapping.program_version(), &log).map_err(message)?;
    }
    finish(RunBag::of_mapping(&mapping).map_err(message)?)
}

fn session(snapshot: JsValue) -> Result<Session, JsValue> {
    let snapshot: SessionSnapshot = serde_wasm_bindgen::from_value(snapshot).map_err(message)?;
    let mut session = Session::new();
    session.follow(&snapshot).map_err(message)?;
    Ok(session)
}

fn finish(bag: Option<RunBag>) -> Result<Vec<u8>, JsValue> {
    let (bytes, _) = bag.ok_or(MISFIT)?.finish().map_err(message)?;
    Ok(bytes)
}
