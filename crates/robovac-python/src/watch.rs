//! Ctrl-C during long work.

use pyo3::prelude::*;
use std::{
    ops::ControlFlow,
    thread::{self, ThreadId},
    time::{Duration, Instant},
};

/// Time between two looks: nobody notices it, and it costs nothing.
const EVERY: Duration = Duration::from_millis(50);

/// Asks now and then whether a signal has arrived; keeps the exception of its handler.
pub struct SignalWatch {
    last: Instant,
    /// Signals arrive in the thread that began.
    thread: ThreadId,
    error: Option<PyErr>,
}

impl SignalWatch {
    /// Begins now.
    pub fn new() -> Self {
        Self { last: Instant::now(), thread: thread::current().id(), error: None }
    }

    /// Whether to stop. To be called while detached from the interpreter.
    pub fn look(&mut self) -> ControlFlow<()> {
        if self.error.is_none() && self.last.elapsed() >= EVERY && thread::current().id() == self.thread {
            self.last = Instant::now();
            self.error = Python::attach(|py| py.check_signals().err());
        }
        if self.error.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// The exception of a signal's handler, if there was one.
    pub fn finish(self) -> PyResult<()> {
        self.error.map_or(Ok(()), Err)
    }
}
