//! The Map tab: a robot maps an unknown room.
//!
//! [`MapSession`] is the tab's state: a room taken over from the session, a robot in it that explores and maps, and
//! time. The robot's estimates are in its run's mapper; quality figures compare them with [`RoomTruth`], which nothing
//! else uses. [`Stored`] preserves all of it over a reload.

mod base;
mod curve;
mod expected;
mod figures;
mod grid;
mod keeping;
mod known;
mod layers;
mod map_estimate;
mod numbers;
mod program;
mod session;
mod setup;
mod stage;
mod state;
mod store;
mod truth;
mod view;
mod words;

pub use curve::CurveSample;
pub use expected::{BY_BUMPER, ByBumper};
pub use figures::MapErrorFigures;
pub use grid::MapGrid;
pub use known::{Known, OpenError};
pub use layers::Layers;
pub use map_estimate::MapEstimate;
pub use program::MapProgramView;
pub use session::MapSession;
pub use setup::{MapSetup, cleaners, explorers, methods};
pub use state::{MapAction, MapPhase};
pub use store::{STORE_VERSION, StoreError, Stored};
pub use truth::{CellVerdict, RoomTruth};
pub use view::MapView;
