//! Many runs on the page: settings, work for workers, curves and numbers.

use super::session_mirror::SessionMirror;
use js_sys::Float64Array;
use robovac_app::compare::{ManyRuns, ManyRunsOffer, ManyRunsPlace, ManyRunsView};
use robovac_playground::wire::{message, to_js};
use robovac_sim::montecarlo::{Band, RunOutcome, Summary, to_csv, to_json};
use wasm_bindgen::prelude::*;

/// Many runs of algorithms in the playground's room.
#[wasm_bindgen]
#[derive(Default)]
pub struct MonteCarlo {
    state: ManyRuns,
}

#[wasm_bindgen]
impl MonteCarlo {
    /// The behaviours that clean, not started.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// All available algorithms, in the order of the view's list, and the numbers in the menus.
    #[wasm_bindgen(unchecked_return_type = "rust.ManyRunsOffer")]
    pub fn offer(&self) -> Result<JsValue, JsValue> {
        to_js(&ManyRunsOffer::new(&self.state))
    }

    /// Takes over room, robot, start, conditions and seed from the mirror of the playground; cheap if unchanged.
    pub fn take(&mut self, mirror: &SessionMirror) {
        self.state.take(mirror.session());
    }

    // ---- choices; each throws a message and changes nothing if the choice isn't possible

    /// Includes an algorithm, or excludes it, by its number in the offer.
    pub fn choose(&mut self, entrant: usize, takes_part: bool) {
        self.state.choose(entrant, takes_part);
    }

    /// Sets a parameter of an algorithm from the text of a form.
    pub fn set_param(&mut self, entrant: usize, id: &str, text: &str) -> Result<(), JsValue> {
        self.state.set_param(entrant, id, text).map_err(message)
    }

    /// Number of runs of each algorithm.
    pub fn set_seeds(&mut self, seeds: u32) {
        self.state.set_seeds(seeds);
    }

    /// Simulated time of each run, min.
    pub fn set_minutes(&mut self, minutes: u32) {
        self.state.set_minutes(minutes);
    }

    /// The choices as the part of a link after the playground's.
    pub fn link(&self) -> String {
        self.state.to_link()
    }

    /// Restores the result of `link`.
    pub fn restore(&mut self, link: &str) -> Result<(), JsValue> {
        self.state.restore(link).map_err(message)
    }

    // ---- runs

    /// Starts the missing runs.
    pub fn run(&mut self) {
        self.state.run();
    }

    /// Cancels the remaining runs.
    pub fn cancel(&mut self) {
        self.state.cancel();
    }

    /// Runs to be made, if any; pass them to `Runner.run` in a worker.
    #[wasm_bindgen(unchecked_return_type = "{ id: number } | undefined")]
    pub fn take_batch(&mut self) -> Result<JsValue, JsValue> {
        self.state.take_batch().map_or(Ok(JsValue::UNDEFINED), |request| to_js(&request))
    }

    /// Whether running runs are still required.
    pub fn is_wanted(&self, id: u32) -> bool {
        self.state.is_wanted(id)
    }

    /// A worker has finished.
    pub fn batch_finished(&mut self, id: u32, outcomes: &[f64]) {
        self.state.batch_finished(id, Ok(RunOutcome::from_numbers(outcomes)));
    }

    /// A worker has failed.
    pub fn batch_failed(&mut self, id: u32, message: &str) {
        self.state.batch_finished(id, Err(message.to_owned()));
    }

    // ---- results

    /// Snapshot for every frame: choices and progress.
    #[wasm_bindgen(unchecked_return_type = "rust.ManyRunsView")]
    pub fn view(&self) -> Result<JsValue, JsValue> {
        to_js(&ManyRunsView::new(&self.state))
    }

    /// Place and conditions of all runs; changes with the view's `version`.
    #[wasm_bindgen(unchecked_return_type = "rust.ManyRunsPlace | null")]
    pub fn place(&self) -> Result<JsValue, JsValue> {
        to_js(&ManyRunsPlace::new(&self.state))
    }

    /// Summary of an algorithm's runs, by its number in the view's list; null without any.
    #[wasm_bindgen(unchecked_return_type = "rust.Summary | null")]
    pub fn summary(&self, entrant: usize) -> Result<JsValue, JsValue> {
        let known = entrant < self.state.entrants().len();
        to_js(&known.then(|| self.state.summary(entrant)).flatten() as &Option<Summary>)
    }

    /// Coverage over time, 0 to 1: all lower ends of the band, all medians, then all upper ends, at the start and at
    /// the ends of equal parts of the time; empty without runs.
    pub fn curve(&self, entrant: usize) -> Float64Array {
        let known = entrant < self.state.entrants().len();
        flat(&if known { Band::curve(&self.state.runs(entrant)) } else { Vec::new() })
    }

    /// All runs as CSV.
    pub fn csv(&self) -> String {
        self.state.export().map(|(head, entries)| to_csv(&head, &entries)).unwrap_or_default()
    }

    /// Quantiles, curves and all runs as JSON.
    pub fn json(&self) -> String {
        self.state.export().map(|(head, entries)| to_json(&head, &entries)).unwrap_or_default()
    }
}

/// Summary of runs that were read from a file, each as [`RunOutcome::to_numbers`] has it; null without any.
#[wasm_bindgen(unchecked_return_type = "rust.Summary | null")]
pub fn summary_of_runs(numbers: &[f64]) -> Result<JsValue, JsValue> {
    let runs = RunOutcome::from_numbers(numbers);
    to_js(&Summary::of(&runs.iter().collect::<Vec<_>>()))
}

/// Their coverage over time, as [`MonteCarlo::curve`] has it.
#[wasm_bindgen]
pub fn bands_of_runs(numbers: &[f64]) -> Float64Array {
    let runs = RunOutcome::from_numbers(numbers);
    flat(&Band::curve(&runs.iter().collect::<Vec<_>>()))
}

/// All lower ends, all medians, then all upper ends.
fn flat(bands: &[Band]) -> Float64Array {
    let ends: [fn(&Band) -> f64; 3] = [|band| band.low, |band| band.median, |band| band.high];
    let flat: Vec<f64> = ends.iter().flat_map(|end| bands.iter().map(end)).collect();
    Float64Array::from(flat.as_slice())
}
