//! Planning cells for a coverage, in a worker.

use robovac_app::explore::SessionSnapshot;
use robovac_playground::wire::message;
use std::ops::ControlFlow;
use wasm_bindgen::prelude::*;

/// Side of the planning cells, m, with which the planner of a snapshot of `Playground.snapshot` sweeps `percent` of the floor
/// in the least time. Blocks until it is found; throws a sentence for users if there is no choice.
#[wasm_bindgen]
pub fn fit_cells(
    #[wasm_bindgen(unchecked_param_type = "rust.SessionSnapshot")] snapshot: JsValue,
    percent: f64,
) -> Result<f64, JsValue> {
    let snapshot: SessionSnapshot = serde_wasm_bindgen::from_value(snapshot).map_err(message)?;
    let (room, settings) = snapshot.lay_out().map_err(message)?;
    let planner = settings.algorithm.planner().ok_or("Only planners have planning cells.")?;
    let fitted =
        room.fit_cells(planner, &settings.params, settings.seed, percent / 100.0, &mut |_| ControlFlow::Continue(()));
    let fitted = fitted.ok_or("There is no choice: this robot fills its cells, or this planner needs none.")?;
    Ok(fitted.cell_size)
}
