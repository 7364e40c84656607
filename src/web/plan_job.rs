//! Planning in a worker.

use super::{clock, request::request_from_js, walk::flat};
use crate::planner::Report;
use js_sys::{Function, Object, Reflect};
use std::ops::ControlFlow;
use wasm_bindgen::prelude::*;

/// Milliseconds between two reports of the best walk so far: often enough to see it grow.
const REPORT_EVERY_MS: f64 = 100.0;

/// Plans a request made by `Playground.take_plan_request`. To be called in a worker, as it blocks until it is done.
///
/// `on_progress(done, cells)` is called about ten times a second with the share done, 0 to 1, and the best walk so far
/// as x, y, x, y, ... Returns `{ cells, seconds, trace }`; throws a message if the request is not valid.
#[wasm_bindgen]
pub fn plan(request: &JsValue, on_progress: &Function) -> Result<JsValue, JsValue> {
    let request = request_from_js(request)?;
    let mut observe = reporter(on_progress);
    let answer = request.serve(|| clock() / 1000.0, Some(&mut observe)).map_err(|e| e.to_string())?;
    let result = Object::new();
    Reflect::set(&result, &"cells".into(), &flat(&answer.path.cells))?;
    Reflect::set(&result, &"seconds".into(), &answer.seconds.into())?;
    Reflect::set(&result, &"trace".into(), &super::to_js(&answer.trace)?)?;
    Ok(result.into())
}

/// Tells `on_progress` now and then how far a planner is.
pub(super) fn reporter(on_progress: &Function) -> impl FnMut(Report<'_>) -> ControlFlow<()> {
    let mut reported = clock();
    move |Report { done, walk, .. }| {
        let now = clock();
        if now - reported >= REPORT_EVERY_MS {
            reported = now;
            // A page that can't take the report shouldn't stop the planner.
            let _ = on_progress.call2(&JsValue::NULL, &done.into(), &flat(walk));
        }
        ControlFlow::Continue(())
    }
}
