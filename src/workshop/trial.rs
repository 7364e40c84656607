//! Comparing in workers: a trial comes in as a plain object, walk and numbers go out.

use super::plan_job::reporter;
use js_sys::{Function, Object, Reflect, Uint32Array};
use robovac_playground::wire::{
    clock, to_js,
    trajectory::trajectory_to_js,
    walk::{self, path_to_js},
};
use robovac_sim::experiment::{Arena, TrialRequest};
use wasm_bindgen::prelude::*;

/// Runs trials. Keeps the room of the last one, as the next often has the same.
#[wasm_bindgen]
#[derive(Default)]
pub struct TrialRunner {
    arena: Option<(String, Arena)>,
}

#[wasm_bindgen]
impl TrialRunner {
    /// No trial yet.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Runs a trial of `Comparison.take_trial`. Blocks until it is done.
    ///
    /// A request with a `job` is for the user's program: the page adds its plan as `cells` and the `seconds` that it took.
    /// `on_progress(done, cells)` as for `plan`. Returns `{ cells, numbers, knots }`; throws a message if there is no result.
    pub fn run(&mut self, request: JsValue, on_progress: &Function) -> Result<JsValue, JsValue> {
        let cells = Reflect::get(&request, &"cells".into())?;
        let seconds = Reflect::get(&request, &"seconds".into())?.as_f64().unwrap_or(0.0);
        let request: TrialRequest = serde_wasm_bindgen::from_value(request).map_err(|e| e.to_string())?;
        if self.arena.as_ref().is_none_or(|(place, _)| *place != request.place) {
            self.arena = Some((request.place.clone(), request.arena()?));
        }
        let Some((_, arena)) = &self.arena else { return Err("there is no room".into()) };
        let mut film = None;
        let mut observe = reporter(on_progress, &mut film, || None);
        let outcome = if request.job.is_some() {
            request.judge(arena, walk::cells(&Uint32Array::new(&cells).to_vec()), seconds)?
        } else {
            request.run(arena, || clock() / 1000.0, Some(&mut observe))?
        };
        let result = Object::new();
        Reflect::set(&result, &"cells".into(), &path_to_js(&outcome.path.cells, &outcome.path.line))?;
        Reflect::set(&result, &"numbers".into(), &to_js(&outcome.numbers)?)?;
        let knots = outcome.smooth.as_deref().map(trajectory_to_js);
        Reflect::set(&result, &"knots".into(), &knots.map_or(JsValue::UNDEFINED, Into::into))?;
        Ok(result.into())
    }
}
