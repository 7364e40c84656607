//! Planning cells for a coverage, in a worker.

use js_sys::Float64Array;
use robovac_app::explore::SessionSnapshot;
use robovac_core::coverage::PlanningCells;
use robovac_playground::wire::message;
use robovac_sim::experiment::{Settings, planning::FittedCells};
use std::ops::ControlFlow;
use wasm_bindgen::prelude::*;

/// The planning cells with which the planner of a snapshot of `Playground.snapshot` sweeps `percent` of the floor in the least
/// time, or most of it: their side and how far they begin to the left of the room's lower-left corner and below it, m; the share
/// that is swept, 0 to 1; and the time, s, with rounded corners if the session has them. Blocks until they are found; throws a
/// sentence for users if there is no choice.
#[wasm_bindgen]
pub fn fit_cells(
    #[wasm_bindgen(unchecked_param_type = "rust.SessionSnapshot")] snapshot: JsValue,
    percent: f64,
) -> Result<Float64Array, JsValue> {
    let snapshot: SessionSnapshot = serde_wasm_bindgen::from_value(snapshot).map_err(message)?;
    let (room, settings) = snapshot.lay_out().map_err(message)?;
    let planner = settings.algorithm.planner().ok_or("Only planners have planning cells.")?;
    let go_on = &mut |_: f64| ControlFlow::Continue(());
    let Settings { params, seed, smooth, .. } = &settings;
    let fitted = room.fit_cells(planner, params, *seed, percent / 100.0, *smooth, go_on).map_err(message)?;
    let FittedCells { cells: PlanningCells { size, offset: [left, below] }, coverage, duration_s } = fitted;
    Ok(Float64Array::from([size, left, below, coverage, duration_s].as_slice()))
}
