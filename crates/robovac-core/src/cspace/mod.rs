//! Configuration space: where a body of any outline fits, over x, y and heading (001, section 2: the obstacle map).
//!
//! An [`Outline`] is moved over a room with its origin in the centre of every cell. A [`ConfigurationSpace`] contains
//! which cells are FREE and which are FULL, exactly, by Minkowski sums (Lozano-Pérez, Spatial planning: a configuration
//! space approach, IEEE Transactions on Computers 1983). [`ObstacleRuns`] numbers its obstacles.

mod bits;
mod canvas;
mod error;
mod motion;
mod obstacles;
mod outline;
mod scene;
mod space;
mod steps;
mod sum;
mod swath;

pub use error::CspaceError;
pub use motion::Motion;
pub use obstacles::ObstacleRuns;
pub use outline::{EXTENTS, MAX_OUTLINE_CORNERS, Outline};
pub use space::{ConfigurationSpace, MAX_BYTES};
pub use steps::FreeSteps;
pub use swath::Swath;

/// Overlaps up to this count as touching, m; allows for rounding.
const HAIR: f64 = 1e-9;
