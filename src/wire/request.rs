//! Planning request to a worker, as a plain object.

use coverage_planners::{self, CoverageJob};
use js_sys::{Reflect, Uint8Array};
use robovac_app::explore::SessionSnapshot;
use robovac_core::{grid::Direction, registry::ParamValue};
use robovac_core::{
    grid::{Cell, Grid},
    registry::Params,
};
use robovac_sim::{
    experiment::planning::{PlanRequest, RoomSetup},
    program::PLANNER_PROGRAM,
};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use wasm_bindgen::JsValue;

/// A request in the form for the worker; the free cells are passed as bytes.
#[derive(Debug, Serialize, Deserialize)]
struct WireRequest {
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

/// The request as a JavaScript object with its free cells in `free`. For a planner in metres, and for bounds in metres, the page
/// adds the session's snapshot as `place`.
pub fn request_to_js(request: &PlanRequest) -> Result<JsValue, JsValue> {
    let job = &request.job;
    let wire = WireRequest {
        id: request.id,
        planner: request.planner.id.to_owned(),
        params: request.params.iter().map(|(id, value)| (id.to_owned(), value.clone())).collect(),
        seed: request.seed,
        width: job.free.width(),
        start: [job.start.x, job.start.y],
        heading: job.heading,
        step_s: job.step_s,
        turn_s: job.turn_s,
    };
    let object = crate::wire::to_js(&wire)?;
    let free: Vec<u8> = job.free.values().iter().map(|&f| u8::from(f)).collect();
    Reflect::set(&object, &"free".into(), &Uint8Array::from(free.as_slice()))?;
    Ok(object)
}

/// The inverse of [`request_to_js`].
pub fn request_from_js(object: &JsValue) -> Result<PlanRequest, JsValue> {
    let wire: WireRequest = serde_wasm_bindgen::from_value(object.clone()).map_err(|e| e.to_string())?;
    let free = Uint8Array::new(&Reflect::get(object, &"free".into())?).to_vec();
    let program = (wire.planner == PLANNER_PROGRAM.id).then_some(&PLANNER_PROGRAM);
    let planner = coverage_planners::find(&wire.planner)
        .or(program)
        .ok_or_else(|| format!("there is no planner \"{}\"", wire.planner))?;
    let given = wire.params.iter().map(|(id, value)| (id.as_str(), value.clone()));
    let params = Params::checked(planner.params, given).map_err(|e| e.to_string())?;
    let job = match laid_out(object)? {
        Some((room, is_rounded)) if planner.claims.in_metres => room.job.rounded(is_rounded),
        _ => wire.job(&free).ok_or("the planning request has no free start")?,
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
    fn job(&self, free: &[u8]) -> Option<CoverageJob> {
        let free = Grid::from_rows(self.width, free.iter().map(|&f| f != 0).collect())?;
        let start = Cell::new(self.start[0], self.start[1]);
        let job = CoverageJob::new(&free, start, self.heading)?;
        Some(CoverageJob { step_s: self.step_s, turn_s: self.turn_s, ..job })
    }
}
