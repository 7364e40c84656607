//! View models of the Robovac Playground, one folder a tab: pure, so that all of it is tested natively.

pub mod bench;
pub mod compare;
pub mod draft;
pub mod explore;
pub mod export;
mod pack;
mod palette;
mod readings;
mod scene;
pub mod survey;
mod viewport;

pub use pack::{pack, unpack};
pub use palette::Palette;
pub use readings::{READINGS, readings};
pub use scene::{FilmScene, RobotView, Scene, SearchScene, Sensed};
pub use viewport::Viewport;
