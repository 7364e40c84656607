//! Runs in workers: a request comes in as a plain object, outcomes go out as numbers.

use js_sys::Float64Array;
use robovac_sim::montecarlo::{Lab, RunOutcome, RunsRequest};
use wasm_bindgen::prelude::*;

/// Makes runs. Keeps the room and the planned paths of the last ones, as the next usually have the same.
#[wasm_bindgen]
#[derive(Default)]
pub struct Runner {
    lab: Option<(String, Lab)>,
}

#[wasm_bindgen]
impl Runner {
    /// No run yet.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Makes the runs of a request of `MonteCarlo.take_batch`. Blocks until they are done.
    ///
    /// Returns the argument of `MonteCarlo.batch_finished`; throws a message if there is no result.
    pub fn run(&mut self, request: JsValue) -> Result<Float64Array, JsValue> {
        let request: RunsRequest = serde_wasm_bindgen::from_value(request).map_err(|e| e.to_string())?;
        if self.lab.as_ref().is_none_or(|(place, _)| *place != request.place) {
            self.lab = Some((request.place.clone(), request.lab()?));
        }
        let Some((_, lab)) = &self.lab else { return Err("there is no room".into()) };
        let outcomes = request.run(lab, None)?;
        let numbers: Vec<f64> = outcomes.iter().flat_map(RunOutcome::to_numbers).collect();
        Ok(Float64Array::from(numbers.as_slice()))
    }
}
