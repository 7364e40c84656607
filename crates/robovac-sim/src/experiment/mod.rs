//! Experiments without a page: from room and robot to plan and run.

mod algorithm;
mod arena;
mod csv;
mod entrant;
pub mod kidnapping;
pub mod planning;
mod settings;
mod shows;
mod trial;
mod twin_file;

pub use algorithm::Algorithm;
pub use arena::{Arena, PlanOutcome, TrialError};
pub use csv::quoted;
pub use entrant::{BEHAVIOUR, Entrant, PLANNER};
pub use planning::{MOST_SEARCH_CELLS, PlanAnswer, PlanRequest, Planned, RoomSetup};
pub use settings::{CELL_SIZES, KEPT_PATH, SPEEDS, Settings, SettingsError};
pub use shows::Shows;
pub use trial::{GENERATED, TrialRequest, plan_of};
pub use twin_file::{TwinFigure, TwinFile, TwinFileError};
