//! A run that can be rewound.

use crate::{Input, Run, STEP_S};

/// Memory for all key frames, bytes.
const KEY_FRAME_BUDGET: usize = 48 << 20;
/// Initial steps between key frames; doubled whenever memory runs short. 4096 steps are a minute of robot time.
const FIRST_INTERVAL: u64 = 4096;
/// Most samples of the coverage curve; beyond that every second one is dropped.
const MOST_SAMPLES: usize = 1024;
/// Steps simulated between two checks of the time.
const CHUNK: u64 = 64;

/// A run with key frames and its coverage curve.
///
/// Runs are deterministic, so a moment is reproduced by simulating from the last key frame before it: no poses are
/// stored, and the state after seeking is exact to the last bit. A person's inputs are stored with their steps and
/// repeated.
pub struct RunRecording {
    run: Run,
    key_frames: Vec<Run>,
    interval: u64,
    /// Furthest step reached so far.
    end: u64,
    /// Target of a seek.
    goal: Option<u64>,
    curve: Vec<(f64, f64)>,
    curve_stride: u64,
    /// Changes when the run is replaced by another state.
    version: u64,
    /// A person's inputs, with the number of steps before each, and the number already applied.
    inputs: Vec<(u64, Input)>,
    applied: usize,
    /// Memory for all key frames, bytes.
    budget: usize,
}

impl RunRecording {
    /// A recording of `run` from here on.
    pub fn new(run: Run) -> Self {
        Self::within(run, KEY_FRAME_BUDGET)
    }

    /// A recording of `run` from here on with key frames of at most about `budget` bytes.
    pub fn within(run: Run, budget: usize) -> Self {
        let curve = vec![(run.time_s(), run.coverage())];
        Self {
            key_frames: vec![run.clone()],
            interval: FIRST_INTERVAL,
            end: run.steps(),
            goal: None,
            curve,
            curve_stride: 64,
            version: 0,
            inputs: Vec::new(),
            applied: 0,
            budget,
            run,
        }
    }

    /// The same with a person's inputs, with the number of steps before each; they are repeated.
    pub fn with_inputs(self, inputs: Vec<(u64, Input)>) -> Self {
        Self { inputs, ..self }
    }

    /// The same from the start again, without what was simulated so far.
    pub fn again(&self) -> Self {
        Self::within(self.key_frames[0].clone(), 0).with_inputs(self.inputs.clone())
    }

    /// A person's inputs, with the number of steps before each.
    pub fn inputs(&self) -> &[(u64, Input)] {
        &self.inputs
    }

    /// The run at the displayed time.
    pub fn run(&self) -> &Run {
        &self.run
    }

    /// The run at the displayed time, to take its changes since it was last drawn.
    pub fn run_mut(&mut self) -> &mut Run {
        &mut self.run
    }

    /// Furthest simulated time, s.
    pub fn end_s(&self) -> f64 {
        self.end as f64 * STEP_S
    }

    /// Furthest step simulated.
    pub fn end_steps(&self) -> u64 {
        self.end
    }

    /// Time (s) and coverage (0 to 1) of the whole run so far.
    pub fn curve(&self) -> &[(f64, f64)] {
        &self.curve
    }

    /// Coverage at the beginning: above that of the start alone if the floor was swept before.
    pub fn first_coverage(&self) -> f64 {
        self.curve.first().map_or(0.0, |&(_, coverage)| coverage)
    }

    /// Changes when the displayed run is replaced rather than continued.
    pub fn version(&self) -> u64 {
        self.version
    }

    /// Whether a seek is in progress.
    pub fn is_seeking(&self) -> bool {
        self.goal.is_some()
    }

    /// Applies an input of a person now. The simulation beyond this moment is dropped, as it would continue
    /// differently.
    pub fn input(&mut self, input: Input) {
        let now = self.run.steps();
        self.goal = None;
        if now < self.end {
            self.end = now;
            self.key_frames.retain(|frame| frame.steps() <= now);
            self.curve.retain(|&(time, _)| time <= self.run.time_s());
            self.version += 1;
        }
        self.inputs.truncate(self.applied);
        self.inputs.push((now, input));
        self.applied += 1;
        self.run.apply(input);
    }

    /// Whether the run has ended, without an input that would continue it.
    pub fn is_over(&self) -> bool {
        self.run.is_finished() && self.applied == self.inputs.len()
    }

    /// One simulation step.
    pub fn step(&mut self) {
        self.catch_up();
        self.run.step();
        let steps = self.run.steps();
        if steps <= self.end {
            return;
        }
        self.end = steps;
        if steps.is_multiple_of(self.curve_stride) || self.run.is_finished() {
            self.sample();
        }
        if steps.is_multiple_of(self.interval) {
            self.key_frame();
        }
    }

    /// Applies the inputs of this moment.
    fn catch_up(&mut self) {
        while let Some(&(_, input)) = self.inputs.get(self.applied).filter(|(step, _)| *step <= self.run.steps()) {
            self.run.apply(input);
            self.applied += 1;
        }
    }

    /// Up to `steps` steps, while `has_time` returns true; returns the number taken.
    pub fn advance(&mut self, steps: u64, has_time: &mut dyn FnMut() -> bool) -> u64 {
        let mut taken = 0;
        while taken < steps && !self.is_over() && !self.run.waits() && has_time() {
            for _ in 0..CHUNK.min(steps - taken) {
                self.step();
                taken += 1;
            }
        }
        taken
    }

    /// Starts to seek `time_s`, within the simulated time; [`RunRecording::seek_on`] completes it.
    pub fn seek(&mut self, time_s: f64) {
        let goal = ((time_s / STEP_S).round().max(0.0) as u64).min(self.end);
        let before = self.key_frames.partition_point(|f| f.steps() <= goal);
        let frame = &self.key_frames[before.max(1) - 1];
        if self.run.steps() > goal || self.run.steps() < frame.steps() {
            self.run = frame.clone();
            // A key frame is taken right after its step, before any input there.
            self.applied = self.inputs.partition_point(|&(step, _)| step < self.run.steps());
            self.version += 1;
        }
        self.goal = Some(goal);
    }

    /// The same for a time that may not have been simulated yet.
    pub fn seek_ahead(&mut self, time_s: f64) {
        self.seek(time_s);
        self.goal = Some((time_s / STEP_S).round().max(0.0) as u64);
    }

    /// Continues a seek, while `has_time` returns true.
    pub fn seek_on(&mut self, has_time: &mut dyn FnMut() -> bool) {
        if let Some(goal) = self.goal {
            let left = goal.saturating_sub(self.run.steps());
            self.advance(left, has_time);
            if self.run.steps() >= goal || self.is_over() || self.run.waits() {
                self.goal = None;
                // The last inputs were applied before the run paused there.
                if self.run.steps() == self.end {
                    self.catch_up();
                }
            }
        }
    }

    /// Ends a seek at the present moment.
    pub fn stop_seeking(&mut self) {
        self.goal = None;
    }

    fn sample(&mut self) {
        self.curve.push((self.run.time_s(), self.run.coverage()));
        if self.curve.len() > MOST_SAMPLES {
            thin_out(&mut self.curve);
            self.curve_stride *= 2;
        }
    }

    fn key_frame(&mut self) {
        let affordable = (self.budget / self.run.bytes().max(1)).max(4);
        if self.key_frames.len() >= affordable {
            thin_out(&mut self.key_frames);
            self.interval *= 2;
        }
        self.key_frames.push(self.run.clone());
    }
}

/// Drops every second item; the first one stays.
fn thin_out<T>(items: &mut Vec<T>) {
    let mut index = 0;
    items.retain(|_| {
        index += 1;
        index % 2 == 1
    });
}
