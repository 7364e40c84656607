//! A run that can be rewound.

use crate::{Input, Run, STEP_S};

/// Memory that key frames may take together, bytes.
const KEY_FRAME_BUDGET: usize = 48 << 20;
/// Steps between key frames at first; doubled whenever memory runs short. 4096 steps are a minute of robot time.
const FIRST_INTERVAL: u64 = 4096;
/// Samples of the coverage curve; when there are more, every second one is dropped.
const MOST_SAMPLES: usize = 1024;
/// Steps simulated between two looks at the clock.
const CHUNK: u64 = 64;

/// A run with key frames and its coverage curve.
///
/// Runs are deterministic, so a moment is found again by going on from the last key frame before it: no poses are
/// stored, and what is shown after scrubbing is what was shown before, to the last bit. What a person did to the robot
/// is stored with its step, and done again there.
pub struct RunRecording {
    run: Run,
    key_frames: Vec<Run>,
    interval: u64,
    /// Furthest step reached so far.
    end: u64,
    /// Where a scrub is heading.
    goal: Option<u64>,
    curve: Vec<(f64, f64)>,
    curve_stride: u64,
    /// Changes whenever the run was replaced by another state of itself.
    version: u64,
    /// What a person did, after how many steps, and how many of these things the run has behind it.
    inputs: Vec<(u64, Input)>,
    applied: usize,
    /// Memory that key frames may take together, bytes.
    budget: usize,
}

impl RunRecording {
    /// A recording of `run` from here on.
    pub fn new(run: Run) -> Self {
        Self::within(run, KEY_FRAME_BUDGET)
    }

    /// A recording of `run` from here on whose key frames take at most about `budget` bytes.
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

    /// The same with what a person did in it at another time, after how many steps: it is done again there.
    pub fn with_inputs(self, inputs: Vec<(u64, Input)>) -> Self {
        Self { inputs, ..self }
    }

    /// What a person did, after how many steps.
    pub fn inputs(&self) -> &[(u64, Input)] {
        &self.inputs
    }

    /// The run at the moment that is shown.
    pub fn run(&self) -> &Run {
        &self.run
    }

    /// The run at the moment that is shown, to take what changed since it was last drawn.
    pub fn run_mut(&mut self) -> &mut Run {
        &mut self.run
    }

    /// Furthest simulated time, s.
    pub fn end_s(&self) -> f64 {
        self.end as f64 * STEP_S
    }

    /// Time (s) and coverage (0 to 1) of the whole run so far.
    pub fn curve(&self) -> &[(f64, f64)] {
        &self.curve
    }

    /// Grows whenever the run that is shown was replaced rather than continued.
    pub fn version(&self) -> u64 {
        self.version
    }

    /// Whether a scrub is still on its way.
    pub fn is_seeking(&self) -> bool {
        self.goal.is_some()
    }

    /// Lets a person do something now. What had been simulated beyond this moment is forgotten: it would go on otherwise.
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

    /// Whether the run has come to its end, and nobody has done anything to it there that would let it go on.
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

    /// Does what a person did at this moment.
    fn catch_up(&mut self) {
        while let Some(&(_, input)) = self.inputs.get(self.applied).filter(|(step, _)| *step <= self.run.steps()) {
            self.run.apply(input);
            self.applied += 1;
        }
    }

    /// Up to `steps` steps, as long as `has_time` says so; returns how many were taken.
    pub fn advance(&mut self, steps: u64, has_time: &mut dyn FnMut() -> bool) -> u64 {
        let mut taken = 0;
        while taken < steps && !self.is_over() && has_time() {
            for _ in 0..CHUNK.min(steps - taken) {
                self.step();
                taken += 1;
            }
        }
        taken
    }

    /// Heads for the moment `time_s`, within what has been simulated; [`RunRecording::seek_on`] gets there.
    pub fn seek(&mut self, time_s: f64) {
        let goal = ((time_s / STEP_S).round().max(0.0) as u64).min(self.end);
        let before = self.key_frames.partition_point(|f| f.steps() <= goal);
        let frame = &self.key_frames[before.max(1) - 1];
        if self.run.steps() > goal || self.run.steps() < frame.steps() {
            self.run = frame.clone();
            // A frame is taken right after its step, before anything is done to the robot there.
            self.applied = self.inputs.partition_point(|&(step, _)| step < self.run.steps());
            self.version += 1;
        }
        self.goal = Some(goal);
    }

    /// Goes on towards the moment sought, as long as `has_time` says so.
    pub fn seek_on(&mut self, has_time: &mut dyn FnMut() -> bool) {
        if let Some(goal) = self.goal {
            let left = goal.saturating_sub(self.run.steps());
            self.advance(left, has_time);
            if self.run.steps() >= goal || self.is_over() {
                self.goal = None;
                // What was done last was done before time stood still there.
                if self.run.steps() == self.end {
                    self.catch_up();
                }
            }
        }
    }

    /// Gives up a scrub and stays where it got to.
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
