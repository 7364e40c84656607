//! `robovac._native`: what the Python package `robovac` calls. Its API for users, with documentation and types, is in
//! `python/robovac` of the repository; names here follow it.
//!
//! Long work detaches from the interpreter, so that other threads go on, and asks at checkpoints for signals such as Ctrl-C.
//! Errors are those of `python/robovac/_errors.py`, with the sentences of the command line.

#![allow(
    clippy::needless_pass_by_value,
    clippy::struct_excessive_bools,
    clippy::too_many_arguments,
    reason = "arguments and fields are those of Python"
)]

mod batch;
mod compare;
mod conditions;
mod controller;
mod explore;
mod failure;
mod lists;
mod picture;
mod place;
mod plan;
mod room;
mod rooms;
mod simulate;
mod watch;

use pyo3::prelude::*;

#[pymodule]
mod _native {
    #[pymodule_export]
    use super::batch::Batch;
    #[pymodule_export]
    use super::compare::compare;
    #[pymodule_export]
    use super::controller::Sensed;
    #[pymodule_export]
    use super::explore::explore;
    #[pymodule_export]
    use super::lists::{behaviours, metrics, planners, reading_names, robots, rooms, truth_names};
    #[pymodule_export]
    use super::plan::{plan, plan_given, planning_job};
    #[pymodule_export]
    use super::room::Room;
    #[pymodule_export]
    use super::simulate::simulate;
    use pyo3::prelude::*;

    #[pymodule_init]
    fn version(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
