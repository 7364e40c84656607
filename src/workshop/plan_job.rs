//! Planning in a worker.

use coverage_planners::{Bounds, CoveragePath, Film, ProgressReport, Proof, metrics::WalkMetrics};
use js_sys::{Function, Object, Reflect};
use robovac_playground::wire::{
    clock,
    frames::frames_to_js,
    proof::proof_to_js,
    request::request_from_js,
    walk::{self, flat},
};
use std::ops::ControlFlow;
use wasm_bindgen::prelude::*;

/// Milliseconds between two reports of the best walk so far, at least: often enough to see it grow. Where walks are long,
/// telling them takes so many times less than planning.
const REPORT_EVERY_MS: f64 = 50.0;
const TELLING: f64 = 10.0;

/// Plans a request made by `Playground.take_plan_request`. To be called in a worker, as it blocks until it is done.
///
/// `on_progress(done, cells, proof, film)` is called some twenty times a second and, if filmed, at the end, with the share done, 0 to 1,
/// the best walk so far as x, y, x, y, ..., what is proven of it, `[cost, bound]` or nothing, and what the planner was filmed
/// at since the last call, an array. Returns `{ cells, seconds, trace, proof }`; throws a message if the request is not valid.
#[wasm_bindgen]
pub fn plan(request: &JsValue, on_progress: &Function) -> Result<JsValue, JsValue> {
    let request = request_from_js(request)?;
    let mut film = None;
    let mut observe = reporter(on_progress, &mut film, || request.film());
    let answer = request.serve(|| clock() / 1000.0, Some(&mut observe)).map_err(|e| e.to_string())?;
    drop(observe);
    if let Some(mut film) = film.or_else(|| request.film()) {
        tell(
            on_progress,
            &ProgressReport { done: 1.0, walk: &answer.path.cells, proof: answer.proof },
            Some(&mut film),
        );
    }
    let result = Object::new();
    Reflect::set(&result, &"cells".into(), &flat(&answer.path.cells))?;
    Reflect::set(&result, &"seconds".into(), &answer.seconds.into())?;
    Reflect::set(&result, &"trace".into(), &robovac_playground::wire::to_js(&answer.trace)?)?;
    Reflect::set(&result, &"proof".into(), &proof_to_js(answer.proof))?;
    Ok(result.into())
}

/// What is proven of the walk that a planner has made for that request, in steps + 2 x quarter turns; nothing if it misses
/// cells, as it needn't be as long then. Takes as long as [`Bounds::of`].
#[wasm_bindgen]
pub fn prove(request: &JsValue, cells: &[u32]) -> Result<JsValue, JsValue> {
    let job = request_from_js(request)?.job;
    let walk = WalkMetrics::of(&job, &CoveragePath { cells: walk::cells(cells) });
    let proof = (walk.visited_cells == walk.reachable_cells)
        .then(|| Proof { cost: walk.cost() as u64, bound: Bounds::of(&job).cost as u64 });
    Ok(proof_to_js(proof))
}

/// Tells `on_progress` now and then how far a planner is, and films it from the first walk on of which something is proven.
/// That walk is told at once, as what a film `begin`s with may take longer to make.
pub(super) fn reporter(
    on_progress: &Function,
    film: &mut Option<Film>,
    begin: impl Fn() -> Option<Film>,
) -> impl FnMut(ProgressReport<'_>) -> ControlFlow<()> {
    let mut next = clock() + REPORT_EVERY_MS;
    let mut is_proven = false;
    move |report| {
        let is_first = report.proof.is_some() && !is_proven;
        let now = clock();
        if is_first || now >= next {
            // With its proof it could be kept, but there is no film of it yet.
            let proof = report.proof.filter(|_| !is_first);
            tell(on_progress, &ProgressReport { proof, ..report }, film.as_mut());
            let told = clock();
            next = told + REPORT_EVERY_MS.max(TELLING * (told - now));
        }
        if is_first {
            is_proven = true;
            *film = begin();
        }
        if let Some(film) = film.as_mut() {
            film.take(&report);
        }
        ControlFlow::Continue(())
    }
}

/// A page that can't take the report shouldn't stop the planner.
fn tell(on_progress: &Function, ProgressReport { done, walk, proof }: &ProgressReport<'_>, film: Option<&mut Film>) {
    let frames = film.map_or_else(Vec::new, Film::take_frames);
    let frames = frames_to_js(&frames).unwrap_or_default();
    let _ = on_progress.call4(&JsValue::NULL, &(*done).into(), &flat(walk), &proof_to_js(*proof), &frames);
}
