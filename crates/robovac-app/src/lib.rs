//! View models of the Robovac Playground, one folder a tab: pure, so that all of it is tested natively.

pub mod bench;
pub mod compare;
pub mod connection;
mod entry;
pub mod explore;
pub mod export;
pub mod floor_plan;
mod import;
pub mod map;
mod pack;
mod palette;
mod param;
mod scene;
#[cfg(feature = "types")]
pub mod types;
mod viewport;

pub use entry::CatalogueEntry;
pub use import::{Import, ImportError, ScenarioChoices, ScenarioError};
pub use pack::{pack, unpack};
pub use palette::Palette;
pub use param::{Param, params};
pub use scene::{FilmScene, RobotView, Scene, SearchScene, Sensed};
pub use viewport::Viewport;
