//! Planning in a worker: a job comes in as plain arrays, the walk goes out as one.

use super::clock;
use crate::{
    app::PlanRequest,
    grid::{Cell, Direction, Grid},
    planner::{self, CoverageJob, ParamValue, Params},
};
use js_sys::{Function, Uint8Array, Uint32Array};
use serde::{Deserialize, Serialize};
use std::{collections::BTreeMap, ops::ControlFlow};
use wasm_bindgen::prelude::*;

/// Milliseconds between two reports of the best walk so far: often enough to see it grow.
const REPORT_EVERY_MS: f64 = 100.0;

/// A request as it crosses to the worker; the free cells go beside it, as bytes.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct WireRequest {
    id: u32,
    planner: String,
    params: BTreeMap<String, ParamValue>,
    seed: u64,
    width: usize,
    start: [i32; 2],
    heading: Direction,
    step_s: f64,
    turn_s: f64,
}

impl WireRequest {
    fn new(request: &PlanRequest) -> Self {
        let job = &request.job;
        Self {
            id: request.id,
            planner: request.planner.id.to_owned(),
            params: request.params.iter().map(|(id, value)| (id.to_owned(), value.clone())).collect(),
            seed: request.seed,
            width: job.free.width(),
            start: [job.start.x, job.start.y],
            heading: job.heading,
            step_s: job.step_s,
            turn_s: job.turn_s,
        }
    }

    /// The inverse of [`WireRequest::new`].
    fn request(&self, free: &[u8]) -> Result<PlanRequest, String> {
        let job = self.job(free).ok_or("the planning request has no free start")?;
        let planner =
            planner::find(&self.planner).ok_or_else(|| format!("there is no planner \"{}\"", self.planner))?;
        let given = self.params.iter().map(|(id, value)| (id.as_str(), value.clone()));
        let params = Params::checked(planner.params, given).map_err(|e| e.to_string())?;
        Ok(PlanRequest { id: self.id, planner, params, seed: self.seed, job })
    }

    fn job(&self, free: &[u8]) -> Option<CoverageJob> {
        let free = Grid::from_rows(self.width, free.iter().map(|&f| f != 0).collect())?;
        let start = Cell::new(self.start[0], self.start[1]);
        let job = CoverageJob::new(&free, start, self.heading)?;
        Some(CoverageJob { step_s: self.step_s, turn_s: self.turn_s, ..job })
    }
}

/// The request as a JavaScript object with its free cells in `free`.
pub(super) fn to_js(request: &PlanRequest) -> Result<JsValue, JsValue> {
    let object = super::to_js(&WireRequest::new(request))?;
    let free: Vec<u8> = request.job.free.values().iter().map(|&f| u8::from(f)).collect();
    js_sys::Reflect::set(&object, &"free".into(), &Uint8Array::from(free.as_slice()))?;
    Ok(object)
}

/// Plans a request made by `Playground.take_plan_request`. To be called in a worker, as it blocks until it is done.
///
/// `on_progress(done, cells)` is called about ten times a second with the share done, 0 to 1, and the best walk so far
/// as x, y, x, y, ... Returns `{ cells, seconds }`; throws a message if the request is not valid.
#[wasm_bindgen]
pub fn plan(request: &JsValue, on_progress: &Function) -> Result<JsValue, JsValue> {
    let wire: WireRequest =
        serde_wasm_bindgen::from_value(request.clone()).map_err(|e| JsValue::from(e.to_string()))?;
    let free = Uint8Array::new(&js_sys::Reflect::get(request, &"free".into())?).to_vec();
    let request = wire.request(&free)?;

    let mut observe = reporter(on_progress);
    let answer = request.serve(|| clock() / 1000.0, Some(&mut observe)).map_err(|e| e.to_string())?;
    let result = js_sys::Object::new();
    js_sys::Reflect::set(&result, &"cells".into(), &flat(&answer.path.cells))?;
    js_sys::Reflect::set(&result, &"seconds".into(), &answer.seconds.into())?;
    Ok(result.into())
}

/// Tells `on_progress` now and then how far a planner is.
pub(super) fn reporter(on_progress: &Function) -> impl FnMut(f64, &[Cell]) -> ControlFlow<()> {
    let mut reported = clock();
    move |done, so_far| {
        let now = clock();
        if now - reported >= REPORT_EVERY_MS {
            reported = now;
            // A page that can't take the report shouldn't stop the planner.
            let _ = on_progress.call2(&JsValue::NULL, &done.into(), &flat(so_far));
        }
        ControlFlow::Continue(())
    }
}

/// Cells as x, y, x, y, ...
pub(super) fn flat(cells: &[Cell]) -> Uint32Array {
    let flat: Vec<u32> = cells.iter().flat_map(|c| [c.x as u32, c.y as u32]).collect();
    Uint32Array::from(flat.as_slice())
}

/// The inverse of [`flat`].
pub(super) fn cells(flat: &[u32]) -> Vec<Cell> {
    flat.chunks_exact(2).map(|c| Cell::new(c[0] as i32, c[1] as i32)).collect()
}
