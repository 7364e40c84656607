//! Monte Carlo studies: many runs of the same algorithms with different seeds.
//!
//! A run is one algorithm with one seed, made in a [`Lab`]; its [`RunOutcome`] is coverage over time with other
//! results. For exploring behaviours the detected share of the [boundary](robovac_core::coverage::Boundary) replaces
//! coverage. A [`RunTally`] takes outcomes in any order and summarises them. `ManyRuns` of `robovac-app` is the page's
//! study: it schedules missing runs and keeps their results. The command line makes the same runs on all cores.

mod export;
mod lab;
mod outcome;
mod program_run;
mod quantile;
mod request;
mod summary;

pub use export::{EntrantRuns, RunsHeader, to_csv, to_json};
pub use lab::{Lab, Terms};
pub use outcome::{GOALS, OutcomeMeter, RunOutcome, SAMPLES};
pub use program_run::ProgramRun;
pub use quantile::quantile;
pub use request::RunsRequest;
pub use summary::{Band, RunTally, Summary, TimeTo};
