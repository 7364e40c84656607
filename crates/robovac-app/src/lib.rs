//! View models of the Robovac Playground, one folder a tab: pure, so that all of it is tested natively.

pub mod bench;
pub mod compare;
pub mod connection;
pub mod explore;
pub mod export;
pub mod floor_plan;
mod import;
pub mod map;
mod pack;
mod palette;
mod scene;
mod viewport;

pub use import::{Import, ImportError, ScenarioChoices, ScenarioError};
pub use pack::{pack, unpack};
pub use palette::Palette;
pub use scene::{FilmScene, RobotView, Scene, SearchScene, Sensed};
pub use viewport::Viewport;
