//! Context of a planner: random numbers, progress and cancellation.

use super::{Proof, TraceStep};
use robovac_core::{
    geometry::Point,
    grid::Cell,
    rng::{Rng, seeded},
};
use std::ops::ControlFlow;

/// Reasons for a planner to return no plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum PlanError {
    /// The caller asked to stop.
    #[error("planning was cancelled")]
    Cancelled,
    /// The planner isn't in the registry.
    #[error("the planner isn't in the registry")]
    Unlisted,
    /// The planner plans in metres and the job has no place.
    #[error("the planner plans in metres: it needs the floor that the cells lie on")]
    NoFloor,
    /// The planner plans for a disc and the robot's tool isn't one.
    #[error("the planner plans in metres for a round tool, and this robot cleans with its whole body; give it a tool")]
    OtherTool,
    /// A parameter doesn't suit the robot.
    #[error("the {what} doesn't suit this robot; use {expected}")]
    Unsuited {
        /// Name of the parameter.
        what: &'static str,
        /// Accepted values.
        expected: &'static str,
    },
}

/// Handed to a planner for one run.
pub struct PlanContext<'a> {
    /// The run's random numbers.
    pub rng: Rng,
    /// Bound of the best walk so far; planners that prove nothing leave it `None`.
    pub proof: Option<Proof>,
    observer: Option<Observer<'a>>,
    tracer: Option<StepTracer<'a>>,
}

/// Progress of a planner.
#[derive(Debug, Clone, Copy)]
pub struct ProgressReport<'a> {
    /// Share of the work that is done, 0 to 1.
    pub done: f64,
    /// The best walk so far; empty before the first, and for a planner in metres.
    pub walk: &'a [Cell],
    /// The best path in metres so far; empty before the first, and for walks.
    pub line: &'a [Point],
    /// Proven quality of that walk.
    pub proof: Option<Proof>,
}

/// Receives a planner's progress; returns whether to continue.
pub type Observer<'a> = &'a mut dyn FnMut(ProgressReport<'_>) -> ControlFlow<()>;

/// Receives every decision of the planner.
pub type StepTracer<'a> = &'a mut dyn FnMut(TraceStep);

impl<'a> PlanContext<'a> {
    /// A run without observer.
    pub fn new(seed: u64) -> Self {
        Self { rng: seeded(seed, 0), proof: None, observer: None, tracer: None }
    }

    /// A run that reports to `observer`.
    pub fn observed(seed: u64, observer: Observer<'a>) -> Self {
        Self { rng: seeded(seed, 0), proof: None, observer: Some(observer), tracer: None }
    }

    /// The same run, with its decisions reported to `tracer`.
    pub fn traced(self, tracer: StepTracer<'a>) -> Self {
        Self { tracer: Some(tracer), ..self }
    }

    /// Reports a decision; `step` is not evaluated without a tracer.
    #[inline]
    pub fn trace(&mut self, step: impl FnOnce() -> TraceStep) {
        if let Some(tracer) = &mut self.tracer {
            tracer(step());
        }
    }

    /// Whether decisions are reported to anybody.
    pub fn is_traced(&self) -> bool {
        self.tracer.is_some()
    }

    /// Whether there is an observer; values that are only shown needn't be computed otherwise.
    pub fn is_observed(&self) -> bool {
        self.observer.is_some()
    }

    /// Reports progress, 0 to 1, and the best walk so far. To be called every few milliseconds.
    pub fn checkpoint(&mut self, done: f64, walk: &[Cell]) -> Result<(), PlanError> {
        self.report(ProgressReport { done, walk, line: &[], proof: self.proof })
    }

    /// The same for a path in metres.
    pub fn checkpoint_in_metres(&mut self, done: f64, line: &[Point]) -> Result<(), PlanError> {
        self.report(ProgressReport { done, walk: &[], line, proof: self.proof })
    }

    fn report(&mut self, report: ProgressReport<'_>) -> Result<(), PlanError> {
        match self.observer.as_mut().map(|observe| observe(report)) {
            Some(ControlFlow::Break(())) => Err(PlanError::Cancelled),
            _ => Ok(()),
        }
    }
}
