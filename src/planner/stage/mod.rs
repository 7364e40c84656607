//! Stages that planners are composed of: they take what they need as arguments and keep nothing.

mod anneal;
mod axis;
mod cost;
mod decompose;
mod distances;
mod flood;
mod frame;
mod lanes;
mod order;
mod seek;
mod sweep;
mod tighten;
mod transit;

pub use anneal::{Moves, Schedule, anneal};
pub use axis::{swap_axes, swap_walk};
pub use cost::Costs;
pub use decompose::{Block, Run, Side, decompose};
pub use distances::Links;
pub use lanes::{Lane, Prefer, cheapest_lanes};
pub use order::{Visit, improve, nearest_first};
pub use seek::Seeker;
pub use sweep::{SWEEPS, Sweep, append_sweep, sweeps_of};
pub use tighten::tighten;
pub use transit::{Stop, Transit};
