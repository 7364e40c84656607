//! Planning request to a worker.

use super::{
    bytes::{from_bytes, to_bytes},
    message,
};
use coverage_planners::{self, CoverageJob};
use js_sys::{Object, Reflect, Uint8Array};
use robovac_app::explore::SessionSnapshot;
use robovac_core::{
    grid::{Cell, Direction, Grid},
    registry::Params,
};
use robovac_sim::{
    experiment::planning::{PlanRequest, RoomSetup},
    program::PLANNER_PROGRAM,
};
use serde::{Deserialize, Serialize};
use wasm_bindgen::JsValue;

/// A request in the form for the worker.
#[derive(Debug, Serialize, Deserialize)]
struct WireRequest {
    id: u32,
    planner: String,
    /// Values as text, by name.
    params: Vec<(String, String)>,
    seed: u64,
    width: usize,
    free: Vec<bool>,
    start: Cell,
    heading: Direction,
    step_s: f64,
    turn_s: f64,
}

/// The request as `{ id, planner, bytes }`, of which only workers read the bytes. For a planner in metres, and for bounds in metres,
/// the page adds the session's snapshot as `place`.
pub fn request_to_js(request: &PlanRequest) -> Result<JsValue, JsValue> {
    let PlanRequest { id, planner, ref params, seed, ref job } = *request;
    let bytes = to_bytes(&WireRequest {
        id,
        planner: planner.id.to_owned(),
        params: params.iter().map(|(id, value)| (id.to_owned(), value.to_string())).collect(),
        seed,
        width: job.free.width(),
        free: job.free.values().to_vec(),
        start: job.start,
        heading: job.heading,
        step_s: job.step_s,
        turn_s: job.turn_s,
    })?;
    let object = Object::new();
    Reflect::set(&object, &"id".into(), &id.into())?;
    Reflect::set(&object, &"planner".into(), &planner.id.into())?;
    Reflect::set(&object, &"bytes".into(), &Uint8Array::from(bytes.as_slice()))?;
    Ok(object.into())
}

/// The inverse of [`request_to_js`].
pub fn request_from_js(object: &JsValue) -> Result<PlanRequest, JsValue> {
    let bytes = Reflect::get(object, &"bytes".into()).map_err(|_| "this is no planning request")?;
    let wire: WireRequest = from_bytes(&Uint8Array::new(&bytes).to_vec())?;
    let program = (wire.planner == PLANNER_PROGRAM.id).then_some(&PLANNER_PROGRAM);
    let planner = coverage_planners::find(&wire.planner)
        .or(program)
        .ok_or_else(|| format!("there is no planner \"{}\"", wire.planner))?;
    let mut params = Params::defaults(planner.params);
    for (id, text) in &wire.params {
        params.set_text(planner.params, id, text).map_err(message)?;
    }
    let job = match laid_out(object)? {
        Some((room, is_rounded)) if planner.is_in_metres() => room.job.rounded(is_rounded),
        _ => wire.job().ok_or("the planning request has no free start")?,
    };
    Ok(PlanRequest { id: wire.id, planner, params, seed: wire.seed, job })
}

/// The room of a request, laid out for its robot, if it is there, and whether corners are to be rounded.
pub fn laid_out(object: &JsValue) -> Result<Option<(RoomSetup, bool)>, JsValue> {
    let place = Reflect::get(object, &"place".into())?;
    if place.is_undefined() {
        return Ok(None);
    }
    let place: SessionSnapshot = serde_wasm_bindgen::from_value(place).map_err(|e| e.to_string())?;
    let room = place.lay_out().map_err(|e| e.to_string())?.0;
    Ok(Some((room, place.choices.smooth == Some(true))))
}

impl WireRequest {
    fn job(&self) -> Option<CoverageJob> {
        let free = Grid::from_rows(self.width, self.free.clone())?;
        let job = CoverageJob::new(&free, self.start, self.heading)?;
        Some(CoverageJob { step_s: self.step_s, turn_s: self.turn_s, ..job })
    }
}
