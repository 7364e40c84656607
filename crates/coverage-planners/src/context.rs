//! Context of a planner: random numbers, progress and cancellation.

use super::{Proof, TraceStep};
use robovac_core::{
    grid::Cell,
    rng::{Rng, seeded},
};
use std::ops::ControlFlow;

/// Why there is no plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum PlanError {
    /// The caller asked to stop.
    #[error("planning was cancelled")]
    Cancelled,
    /// The planner can't be made.
    #[error("the planner isn't in the registry")]
    Unlisted,
}

/// Handed to a planner for one run.
pub struct PlanContext<'a> {
    /// The run's random numbers.
    pub rng: Rng,
    /// How good the best walk so far is known to be; planners that prove nothing leave it alone.
    pub proof: Option<Proof>,
    observer: Option<Observer<'a>>,
    tracer: Option<StepTracer<'a>>,
}

/// How far a planner is.
#[derive(Debug, Clone, Copy)]
pub struct ProgressReport<'a> {
    /// Share of the work that is done, 0 to 1.
    pub done: f64,
    /// The best walk so far; empty before the first.
    pub walk: &'a [Cell],
    /// How good that walk is known to be.
    pub proof: Option<Proof>,
}

/// Receives a planner's progress; returns whether to continue.
pub type Observer<'a> = &'a mut dyn FnMut(ProgressReport<'_>) -> ControlFlow<()>;

/// Receives every decision.
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

    /// The same run, its decisions told to `tracer`.
    pub fn traced(self, tracer: StepTracer<'a>) -> Self {
        Self { tracer: Some(tracer), ..self }
    }

    /// Tells a decision; where nobody listens it isn't made.
    #[inline]
    pub fn trace(&mut self, step: impl FnOnce() -> TraceStep) {
        if let Some(tracer) = &mut self.tracer {
            tracer(step());
        }
    }

    /// Whether somebody watches: what is only shown needn't be made otherwise.
    pub fn is_observed(&self) -> bool {
        self.observer.is_some()
    }

    /// To be called every few milliseconds: reports how far the planner is, 0 to 1, and the walk that it has so far.
    pub fn checkpoint(&mut self, done: f64, walk: &[Cell]) -> Result<(), PlanError> {
        let report = ProgressReport { done, walk, proof: self.proof };
        match self.observer.as_mut().map(|observe| observe(report)) {
            Some(ControlFlow::Break(())) => Err(PlanError::Cancelled),
            _ => Ok(()),
        }
    }
}
