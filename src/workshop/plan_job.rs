//! Planning in a worker.

use coverage_planners::{
    Bounds, CoveragePath, Film, ProgressReport, Proof,
    metrics::{DriveMetrics, MetricExcess, WalkMetrics},
};
use js_sys::{Array, Float64Array, Function, Object, Reflect, Uint8Array};
use robovac_app::explore::pictures;
use robovac_playground::wire::{
    bytes::to_bytes,
    clock,
    frames::{frames_from_js, frames_to_js},
    pictures::pictures_to_js,
    proof::{proof_from_js, proof_to_js},
    request::{laid_out, request_from_js},
    trajectory::{trajectory_from_js, trajectory_to_js},
    walk::{path_from_js, path_to_js},
};
use std::ops::ControlFlow;
use wasm_bindgen::prelude::*;

/// Milliseconds between two reports of the best walk so far, at least: often enough to see it grow. For long walks the
/// interval grows, so that reports take a small share of the time.
const REPORT_EVERY_MS: f64 = 50.0;
const TELLING: f64 = 10.0;

/// Plans a request of `Playground.take_plan_request`. To be called in a worker, as it blocks until it is done.
///
/// `on_progress(done, cells, proof, film)` is called some twenty times a second and, if filmed, at the end, with the
/// share done, 0 to 1, the best path so far (see [`path_to_js`]), its proof, `[cost, bound]` or `undefined`, and the
/// array of film frames since the last call. Returns `{ cells, seconds, trace, proof }`; throws a message if the
/// request is not valid.
#[wasm_bindgen]
pub fn plan(request: &JsValue, on_progress: &Function) -> Result<JsValue, JsValue> {
    let request = request_from_js(request)?;
    let mut film = None;
    let mut observe = reporter(on_progress, &mut film, || request.film());
    let answer = request.serve(|| clock() / 1000.0, Some(&mut observe)).map_err(|e| e.to_string())?;
    drop(observe);
    let CoveragePath { cells, line } = &answer.path;
    // The frames that are left.
    if let Some(film) = &mut film {
        tell(on_progress, &ProgressReport { done: 1.0, walk: cells, line, proof: answer.proof }, Some(film));
    }
    let result = Object::new();
    Reflect::set(&result, &"cells".into(), &path_to_js(&answer.path.cells, &answer.path.line))?;
    Reflect::set(&result, &"seconds".into(), &answer.seconds.into())?;
    Reflect::set(&result, &"trace".into(), &Uint8Array::from(to_bytes(&answer.trace)?.as_slice()))?;
    Reflect::set(&result, &"proof".into(), &proof_to_js(answer.proof))?;
    Ok(result.into())
}

/// The pictures of a request's film, see [`pictures_to_js`]: `frames` are all that its planning reported, `path` is the plan, with
/// its proof; `undefined` if the search isn't filmed.
#[wasm_bindgen]
pub fn film(request: &JsValue, frames: &Array, path: &JsValue, proof: Option<Vec<f64>>) -> Result<JsValue, JsValue> {
    let Some((room, _)) = laid_out(request)? else { return Ok(JsValue::UNDEFINED) };
    let Some(film) = request_from_js(request)?.film_with(frames_from_js(frames)?) else {
        return Ok(JsValue::UNDEFINED);
    };
    let frames = film.ended(&path_from_js(path), proof_from_js(proof));
    Ok(pictures_to_js(&pictures(&frames, &room.planning_grid)).into())
}

/// The proof of a planner's walk for that request, in steps + 2 x quarter turns; `undefined` if it misses cells, as the
/// bound doesn't apply then, and for a path in metres. Takes as long as [`Bounds::of`].
#[wasm_bindgen]
pub fn prove(request: &JsValue, path: &JsValue) -> Result<JsValue, JsValue> {
    let path = path_from_js(path);
    if path.is_in_metres() {
        return Ok(JsValue::UNDEFINED);
    }
    let job = request_from_js(request)?.job;
    let walk = WalkMetrics::of(&job, &path);
    let proof = (walk.visited_cells == walk.reachable_cells)
        .then(|| Proof { cost: walk.cost() as u64, bound: Bounds::of(&job).cost as u64 });
    Ok(proof_to_js(proof))
}

/// The trajectory with rounded corners of a plan for that request, see [`trajectory_to_js`]; `undefined` if corners aren't to be
/// rounded, or the robot can't.
#[wasm_bindgen]
pub fn smooth(request: &JsValue, path: &JsValue) -> Result<JsValue, JsValue> {
    let Some((room, true)) = laid_out(request)? else { return Ok(JsValue::UNDEFINED) };
    let line = room.line(&path_from_js(path)).map_err(|e| e.to_string())?;
    let path = room.smooth(&line, &request_from_js(request)?.smooth_setup(), false);
    Ok(path.map_or(JsValue::UNDEFINED, |path| trajectory_to_js(&path.trajectory).into()))
}

/// The share of the floor that a plan for that request sweeps, measured exactly, and the least length, m, and time, s, of any path
/// that sweeps as much: without stops for its trajectory, the result of [`smooth`], if there is one. `undefined` for a robot that
/// fills a cell, and if the request leaves the room out.
#[wasm_bindgen]
pub fn least(request: &JsValue, path: &JsValue, knots: Option<Vec<f64>>) -> Result<JsValue, JsValue> {
    let Some((room, _)) = laid_out(request)? else { return Ok(JsValue::UNDEFINED) };
    let (floor, robot) = (&room.floor, &room.robot);
    let excess = if let Some(knots) = knots {
        let trajectory = trajectory_from_js(&knots);
        let drive = DriveMetrics::of_trajectory(floor, robot, &trajectory);
        MetricExcess::of_trajectory(floor, robot, &trajectory, &drive)
    } else {
        let line = room.line(&path_from_js(path)).map_err(|e| e.to_string())?;
        MetricExcess::of(floor, robot, &line, &DriveMetrics::of(floor, robot, &line))
    };
    Ok(excess.map_or(JsValue::UNDEFINED, |MetricExcess { swept, bound, .. }| {
        Float64Array::from([swept, bound.length_m, bound.duration_s].as_slice()).into()
    }))
}

/// Reports a planner's progress to `on_progress` regularly, and films it from the first walk on. That walk
/// is reported at once, as the walks that a film `begin`s with can take longer.
pub(super) fn reporter(
    on_progress: &Function,
    film: &mut Option<Film>,
    begin: impl Fn() -> Option<Film>,
) -> impl FnMut(ProgressReport<'_>) -> ControlFlow<()> {
    let mut next = clock() + REPORT_EVERY_MS;
    let mut has_begun = false;
    move |report| {
        let is_first = !(has_begun || report.walk.is_empty() && report.line.is_empty());
        let now = clock();
        if is_first || now >= next {
            // With its proof it could be kept, but it has no film yet.
            let proof = report.proof.filter(|_| !is_first);
            tell(on_progress, &ProgressReport { proof, ..report }, film.as_mut());
            let told = clock();
            next = told + REPORT_EVERY_MS.max(TELLING * (told - now));
        }
        if is_first {
            has_begun = true;
            *film = begin();
        }
        if let Some(film) = film.as_mut() {
            film.take(&report);
        }
        ControlFlow::Continue(())
    }
}

/// Calls the listener, whose errors don't stop the planner.
fn tell(on_progress: &Function, report: &ProgressReport<'_>, film: Option<&mut Film>) {
    let ProgressReport { done, walk, line, proof } = *report;
    let frames = film.map_or_else(Vec::new, Film::take_frames);
    let frames = frames_to_js(&frames).unwrap_or_default();
    let _ = on_progress.call4(&JsValue::NULL, &done.into(), &path_to_js(walk, line), &proof_to_js(proof), &frames);
}
