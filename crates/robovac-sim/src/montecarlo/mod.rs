//! Monte Carlo studies: many runs of the same algorithms with different seeds.
//!
//! A run is one algorithm with one seed, made in a [`Lab`]; its [`RunOutcome`] is coverage over time and what happened on
//! the way. For behaviours that explore, the share of the [boundary](robovac_core::coverage::Boundary) that they have met takes the
//! place of coverage. A [`RunTally`] takes outcomes as they come, in any order, and sums them up. `Study` of `robovac-app` is the page's:
//! it says which runs are missing and keeps what came out. The command line makes the same runs on all cores.

mod export;
mod lab;
mod outcome;
mod quantile;
mod request;
mod summary;

pub use export::{EntrantRuns, StudyHeader, to_csv, to_json};
pub use lab::{Lab, Terms};
pub use outcome::{GOALS, RunOutcome, SAMPLES};
pub use quantile::quantile;
pub use request::RunsRequest;
pub use summary::{Band, RunTally, Summary, TimeTo};
