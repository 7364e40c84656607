//! A simulation that a user's program drives.

use robovac_app::explore::{LaidOutJob, ProgramJob};
use robovac_playground::wire::message;
use robovac_sim::program::{Lockstep, LockstepFrame, LogEnd, ProgramRoom, layout_json};
use std::collections::BTreeMap;
use wasm_bindgen::prelude::*;

/// A program's own robot in its own room. The program senses and drives in turn:
///
/// ```js
/// const runner = new ProgramRunner(job);
/// const sensed = new Float64Array(memory.buffer, runner.readings_ptr(), runner.readings_len());
/// while (runner.step(...program(sensed)));
/// ```
#[wasm_bindgen]
pub struct ProgramRunner {
    lockstep: Lockstep,
    job: LaidOutJob,
    seed: u64,
    /// Key frames by their steps.
    frames: BTreeMap<u64, LockstepFrame>,
    /// First step that wasn't taken by `take_log` yet.
    untaken: u32,
}

#[wasm_bindgen]
impl ProgramRunner {
    /// The simulation of `playground.program_job()`; with another seed, if one is given. Throws a sentence for users.
    #[wasm_bindgen(constructor)]
    pub fn new(job: &[u8], seed: Option<u32>) -> Result<Self, JsValue> {
        let job = ProgramJob::from_bytes(job).map_err(message)?;
        Ok(Self::at_start(job.lay_out().map_err(message)?, seed))
    }

    /// The same room with another seed, from the start: to lay it out takes as long as some minutes in it. The readings
    /// have another address then.
    pub fn again(self, seed: Option<u32>) -> Self {
        Self::at_start(self.job, seed)
    }

    /// Names and places of the readings, as JSON: `{"slots": [{"name", "index", "count", "flag", "unit", "about"}, ...],
    /// "laser": index of the first range}`.
    pub fn layout() -> String {
        layout_json()
    }

    /// Facts about the robot, as JSON.
    pub fn facts(&self) -> String {
        self.lockstep.facts().to_json()
    }

    /// The grid for planners, as JSON: `{"width", "height", "cell", "start": [x, y], "rows"}`, the top row first.
    pub fn room(&self) -> String {
        ProgramRoom::of(&self.job.room.job, self.job.cell_size).to_json()
    }

    /// Seed of everything random.
    pub fn seed(&self) -> u32 {
        self.seed as u32
    }

    /// Address of the readings in the module's memory; doesn't change. A view on them must be made again when memory
    /// has grown, which detaches it.
    pub fn readings_ptr(&self) -> *const f64 {
        self.lockstep.readings().as_ptr()
    }

    /// Number of readings, with the laser's ranges.
    pub fn readings_len(&self) -> usize {
        self.lockstep.readings().len()
    }

    /// Drives for 15 ms with these speeds of the left and the right wheel, mm/s. False once the run is over: the battery
    /// is empty, or `finish` was called.
    pub fn step(&mut self, left: f64, right: f64) -> bool {
        self.lockstep.step([left, right])
    }

    /// The program has nothing left to do, or failed. The robot brakes until it is at rest.
    pub fn finish(&mut self, has_failed: bool) {
        self.lockstep.finish(if has_failed { LogEnd::Failed } else { LogEnd::Done });
    }

    /// Steps taken.
    pub fn steps(&self) -> f64 {
        self.lockstep.run().steps() as f64
    }

    /// Digest of the state, 16 hexadecimal digits.
    pub fn digest(&self) -> String {
        format!("{:016x}", self.lockstep.digest())
    }

    /// The part of the log since the last call, for `playground.extend_program`.
    pub fn take_log(&mut self) -> Vec<u8> {
        let bytes = self.lockstep.log_bytes(self.untaken);
        self.untaken = self.lockstep.log_until();
        bytes
    }

    /// The whole log.
    pub fn log(&self) -> Vec<u8> {
        self.lockstep.log_bytes(0)
    }

    /// Keeps the present state; returns its number of steps.
    pub fn snapshot(&mut self) -> f64 {
        let frame = self.lockstep.frame();
        let steps = frame.steps();
        self.frames.insert(steps, frame);
        steps as f64
    }

    /// Goes back to the last kept state at or before that step, and forgets those after it. Returns its number of
    /// steps.
    pub fn rewind(&mut self, step: f64) -> f64 {
        self.frames.retain(|&steps, _| steps as f64 <= step || steps == 0);
        if let Some((_, frame)) = self.frames.last_key_value() {
            self.lockstep.restore(frame);
        }
        let steps = self.lockstep.run().steps();
        self.untaken = self.untaken.min(steps as u32);
        steps as f64
    }

    /// Forgets the state that was kept at that step.
    pub fn forget(&mut self, step: f64) {
        if step > 0.0 {
            self.frames.remove(&(step as u64));
        }
    }
}

impl ProgramRunner {
    /// Without a seed it is that of the job.
    fn at_start(job: LaidOutJob, seed: Option<u32>) -> Self {
        let seed = seed.map_or(job.seed, u64::from);
        let lockstep = Lockstep::new(&job.room, job.conditions, seed, job.inputs.clone());
        let mut frames = BTreeMap::new();
        frames.insert(0, lockstep.frame());
        Self { lockstep, job, seed, frames, untaken: 0 }
    }
}
