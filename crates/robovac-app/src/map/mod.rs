//! The Map tab: a robot maps an unknown room.
//!
//! [`MapSession`] is what the page has: a room taken over from the session, a robot in it that explores and maps, and time. What it
//! believes is in its run's mapper; [`RoomTruth`] is what quality figures compare that with, and nothing else uses it.
//! [`Stored`] brings all of it over a reload.

mod base;
mod curve;
mod figures;
mod keeping;
mod known;
mod layers;
mod map_estimate;
mod numbers;
mod session;
mod setup;
mod stage;
mod state;
mod store;
mod truth;
mod view;
mod words;

pub use curve::CurveSample;
pub use figures::MapErrorFigures;
pub use known::{Known, OpenError};
pub use layers::Layers;
pub use map_estimate::MapEstimate;
pub use session::MapSession;
pub use setup::{MapSetup, cleaners, explorers};
pub use state::{MapAction, MapPhase};
pub use store::{STORE_VERSION, StoreError, Stored};
pub use truth::{CellVerdict, RoomTruth};
pub use view::MapView;
