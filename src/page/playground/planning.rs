//! Planning, which happens in a worker.

use super::Playground;
use coverage_planners::{ProgressReport, TraceStep, metrics::SweepBound};
use js_sys::Array;
use robovac_playground::wire::{
    bytes::from_bytes, pictures::pictures_from_js, proof::proof_from_js, request, trajectory::trajectory_from_js, walk,
};
use robovac_sim::experiment::planning::PlanAnswer;
use wasm_bindgen::prelude::*;

/// Simulated time of the opening scene at its start, s, so that there is something to see at once.
const OPENING_S: f64 = 600.0;

#[wasm_bindgen]
impl Playground {
    /// The pending planning request, returned once; pass it to `plan` in a worker. To be called in every frame.
    #[wasm_bindgen(unchecked_return_type = "{ id: number; planner: string; bytes: Uint8Array } | undefined")]
    pub fn take_plan_request(&mut self) -> Result<JsValue, JsValue> {
        let request = self.session.take_plan_request();
        // A changed opening scene starts at its beginning.
        if std::mem::take(&mut self.is_opening) && request.is_none() {
            self.session.run_ahead(OPENING_S);
        }
        request.map_or(Ok(JsValue::UNDEFINED), |request| request::request_to_js(&request))
    }

    /// Progress of the worker: the share done, its best path so far, and the path's proof (cost and bound).
    pub fn plan_progress(&mut self, id: u32, done: f64, path: &JsValue, proof: Option<Vec<f64>>) {
        let proof = proof_from_js(proof);
        let path = walk::path_from_js(path);
        self.session.plan_progress(id, ProgressReport { done, walk: &path.cells, line: &path.line, proof });
    }

    /// The film of a plan that was found or kept; see `film`.
    pub fn plan_filmed(&mut self, id: u32, pictures: &Array) {
        self.session.plan_filmed(id, pictures_from_js(pictures));
    }

    /// The worker has finished.
    pub fn plan_finished(
        &mut self,
        id: u32,
        path: &JsValue,
        seconds: f64,
        trace: Option<Vec<u8>>,
        proof: Option<Vec<f64>>,
    ) -> Result<(), JsValue> {
        let trace: Option<Vec<TraceStep>> = trace.map(|bytes| from_bytes(&bytes)).transpose()?;
        let trace = trace.unwrap_or_default();
        let path = walk::path_from_js(path);
        let proof = proof_from_js(proof);
        self.session.plan_finished(id, PlanAnswer { path, seconds, proof, trace });
        Ok(())
    }

    /// The worker has rounded the corners of its plan; see `smooth`.
    pub fn plan_smoothed(&mut self, id: u32, knots: &[f64]) {
        self.session.plan_smoothed(id, trajectory_from_js(knots));
    }

    /// The worker has proven bounds of its plan: its cost and the least; and its exact coverage with the least length, m, and time, s.
    pub fn plan_proven(&mut self, id: u32, proof: Option<Vec<f64>>, least: Option<Vec<f64>>) {
        let least = least.and_then(|least| <[f64; 3]>::try_from(least).ok());
        let least = least.map(|[coverage, length_m, duration_s]| SweepBound { coverage, length_m, duration_s });
        self.session.plan_proven(id, proof_from_js(proof), least);
    }

    /// The worker has failed.
    pub fn plan_failed(&mut self, id: u32, message: &str) {
        self.session.plan_failed(id, message);
    }

    /// Cancels planning. The page must end the worker.
    pub fn cancel_plan(&mut self) {
        self.session.cancel_plan();
    }

    /// Ends planning with the best walk so far, `seconds` after the worker began. The page must end the worker.
    pub fn keep_plan(&mut self, seconds: f64) {
        self.session.keep_plan(seconds);
    }
}
