//! Maps that a robot makes, and where it believes to be on them, from what a Roomba senses: a bumper, six light sensors that
//! reach a hand's breadth, and wheel counts.
//!
//! [`Mapper`] is what others use: it takes readings and has a map, a pose and how sure it is of it. Its map is an
//! [`OccupancyMap`] in log odds, which grows as the robot goes; beside it, [`Marks`] tell what the robot has cleaned and
//! where it found dirt. Everything is in the frame of the pose that it started from (REP 103).

mod layer;
pub mod locate;
mod mapper;
mod marks;
mod occupancy_map;
mod spread;

pub use layer::Layer;
pub use mapper::{Mapper, MapperSetup, Tracking};
pub use marks::{Mark, Marks};
pub use occupancy_map::OccupancyMap;
pub use spread::Spread;
