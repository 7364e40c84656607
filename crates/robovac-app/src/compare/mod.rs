//! The Compare tab: planners compared in the same room, with the same robot and the same metrics.
//!
//! [`Comparison`] defines the trials and keeps the results, [`ComparisonTable`] summarises them, [`Race`] lets robots drive the plans
//! under one clock, [`ManyRuns`] does the same for many runs.

mod base;
mod comparison;
mod differing;
mod entrants;
mod export;
mod kept_paths;
mod many_runs;
mod many_runs_view;
mod program_runs;
mod race;
mod race_log;
mod rooms;
mod table;
mod table_2;
mod trials;
mod view;

pub use comparison::{Comparison, MOST_SEEDS};
pub use export::{Record, to_csv, to_json};
pub use many_runs::{MINUTES, MOST_MINUTES, ManyRuns, SEEDS};
pub use many_runs_view::{ManyRunsOffer, ManyRunsPlace, ManyRunsView};
pub use program_runs::ProgramRuns;
pub use race::{MOST_LANES, Race, RaceLane, RaceSetup, Racer};
pub use rooms::{RoomChoice, RoomSet};
pub use table::{ComparisonTable, MedianAndRange, Row};
pub use table_2::{PrintedRow, TABLE_2, TABLE_2_CELL, TABLE_2_ROOM};
pub use trials::{Trial, TrialProgress};
pub use view::{ComparisonView, TableView};
