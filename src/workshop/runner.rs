//! Runs in workers: a request comes in as a plain object, outcomes go out as numbers.

use js_sys::{Array, Float64Array, Reflect, Uint8Array, Uint32Array};
use robovac_app::{Import, compare::ProgramRuns, explore::Session};
use robovac_core::floor_plan::{
    SourceFile,
    generate::{FlatId, FlatIdError},
};
use robovac_playground::wire::{message, walk};
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

    /// Makes the runs of a request of `MonteCarlo.take_batch`. Blocks until they are done. A request with a `job` is for
    /// the user's program: the page adds its logs in the order of the seeds as `logs`, or its plan as `cells`.
    ///
    /// Returns the argument of `MonteCarlo.batch_finished`; throws a message if there is no result.
    pub fn run(&mut self, request: JsValue) -> Result<Float64Array, JsValue> {
        let work = request.clone();
        let request: RunsRequest = serde_wasm_bindgen::from_value(request).map_err(|e| e.to_string())?;
        if let Some(job) = &request.job {
            return run_program(&request, job, &work);
        }
        if self.lab.as_ref().is_none_or(|(place, _)| *place != request.place) {
            self.lab = Some((request.place.clone(), request.lab()?));
        }
        let Some((_, lab)) = &self.lab else { return Err("there is no room".into()) };
        let outcomes = request.run(lab, None)?;
        Ok(to_numbers(&outcomes))
    }
}

/// The job with which a user's program drives in the room of a link, or in that of a scenario file with the link's settings.
#[wasm_bindgen]
pub fn job_of_place(link: &str, scenario: Option<String>) -> Result<Vec<u8>, JsValue> {
    let mut session = Session::new();
    if let Some(text) = scenario {
        let file = SourceFile { name: "scene.json".to_owned(), bytes: text.into_bytes() };
        session.load(&[file]).map_err(message)?;
    }
    if let Some(name) = link.split('&').find_map(|pair| pair.strip_prefix("flat=")) {
        let flat: FlatId = name.parse().map_err(|e: FlatIdError| e.to_string())?;
        session.take_import(Import { plan: flat.build(), choices: None }).map_err(|e| e.to_string())?;
    }
    // The program drives in its place.
    session.restore(&format!("{link}&behaviour=bounce")).map_err(message)?;
    Ok(session.program_job().to_bytes())
}

/// Runs of the user's program, by the logs or the plan in `work`.
fn run_program(request: &RunsRequest, job: &[u8], work: &JsValue) -> Result<Float64Array, JsValue> {
    let runs = ProgramRuns::new(job, request.duration_s)?;
    let outcomes = if request.behaves {
        let logs: Array = Reflect::get(work, &"logs".into())?.dyn_into().map_err(|_| "the logs are missing")?;
        let logs = logs.iter().map(|log| Uint8Array::new(&log).to_vec());
        request.seeds.iter().zip(logs).map(|(&seed, log)| runs.behave(seed, &log)).collect::<Result<_, _>>()?
    } else {
        let cells = walk::cells(&Uint32Array::new(&Reflect::get(work, &"cells".into())?).to_vec());
        runs.follow(&request.seeds, cells)?
    };
    Ok(to_numbers(&outcomes))
}

fn to_numbers(outcomes: &[RunOutcome]) -> Float64Array {
    let numbers: Vec<f64> = outcomes.iter().flat_map(RunOutcome::to_numbers).collect();
    Float64Array::from(numbers.as_slice())
}
