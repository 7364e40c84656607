//! The curve of time over coverage, in a worker.

use js_sys::{Float64Array, Function};
use robovac_app::explore::SessionSnapshot;
use robovac_core::geometry::Point;
use robovac_playground::wire::message;
use std::ops::ControlFlow;
use wasm_bindgen::prelude::*;

/// Calls `on_point([asked, coverage, seconds, metres])` with what the plan of a snapshot of `Playground.snapshot` takes, whose `corners`
/// are x, y, x, y, ... in m, and with what paths take that sweep other `shares` of the floor, 0 to 1: first those below it, from the
/// nearest on. Blocks until all are found.
#[wasm_bindgen]
pub fn trade_off(
    #[wasm_bindgen(unchecked_param_type = "rust.SessionSnapshot")] snapshot: JsValue,
    corners: &[f64],
    shares: &[f64],
    on_point: &Function,
) -> Result<(), JsValue> {
    let snapshot: SessionSnapshot = serde_wasm_bindgen::from_value(snapshot).map_err(message)?;
    let (room, settings) = snapshot.lay_out().map_err(message)?;
    let planner = settings.algorithm.planner().ok_or("Only plans have a coverage to choose.")?;
    let line: Vec<Point> = corners.chunks_exact(2).map(|at| Point::new(at[0], at[1])).collect();
    let job = room.job.rounded(snapshot.choices.smooth == Some(true));
    planner.build(&settings.params).trade_off(&job, &line, shares, &mut |point| {
        let numbers = [point.asked, point.coverage, point.duration_s, point.length_m];
        // The listener's errors don't stop the search.
        let _ = on_point.call1(&JsValue::NULL, &Float64Array::from(numbers.as_slice()));
        ControlFlow::Continue(())
    });
    Ok(())
}
