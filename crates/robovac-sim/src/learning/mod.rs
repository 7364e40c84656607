//! Cleaning as a task for reinforcement learning: episodes, observations by name, and rewards in parts.
//!
//! An [`Episode`] is one robot on one floor. Each step applies a drive command for a fixed time and returns [`Gains`], of
//! which [`RewardWeights`] make a number. What a policy may see is chosen by name: [`ReadingsEncoder`] are what the Open
//! Interface reports, [`OwnMap`] is the map that the robot keeps by itself, [`truth`] is what only the simulator knows.
//! All is plain arithmetic on one robot; a batch of them on many cores is up to the caller.

mod ego_map;
mod episode;
mod own_map;
mod readings;
mod reward;
pub mod truth;

pub use ego_map::{CELL_M, EgoMap, PATCH_LEN, PatchMark, SCALES, SIDE};
pub use episode::{Episode, EpisodeRoom, Observations, StepOutcome, Task};
pub use own_map::OwnMap;
pub use readings::{READING_NAMES, READINGS, ReadingsEncoder};
pub use reward::{Gains, RewardWeights};
