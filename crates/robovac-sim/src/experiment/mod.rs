//! What an experiment needs without a page: room and robot to plan and run.

mod algorithm;
mod arena;
mod csv;
mod entrant;
mod import;
pub mod kidnapping;
pub mod planning;
mod settings;
mod shows;
mod trial;

pub use algorithm::Algorithm;
pub use arena::{Arena, Outcome, TrialError};
pub use csv::quoted;
pub use entrant::{BEHAVIOUR, Entrant, PLANNER};
pub use import::{Choices, Import, ScenarioError};
pub use planning::{Answer, MOST_SEARCH_CELLS, PlanRequest, Planned, Prepared};
pub use settings::{CELL_SIZES, SPEEDS, Settings, SettingsError};
pub use shows::Shows;
pub use trial::{TrialRequest, plan_of};
