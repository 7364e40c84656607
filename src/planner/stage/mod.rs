//! Stages that planners are composed of: they take what they need as arguments and keep nothing.

mod axis;
mod cost;
mod decompose;
mod distances;
mod flood;
mod frame;
mod min_cut;
mod order;
mod part;
mod seek;
mod strips;
mod strokes;
mod sweep;
mod tighten;
mod transit;

pub use axis::{swap_axes, swap_grid, swap_walk};
pub use cost::Costs;
pub use decompose::{Block, Run, Side, decompose};
pub use distances::Links;
pub(super) use flood::Flood;
pub use order::{Visit, improve, nearest_first};
pub use part::{Part, drive};
pub use seek::Seeker;
pub use strips::{Strips, strips};
pub use strokes::{lanes_of, strokes};
pub use sweep::{SWEEPS, Sweep, append_sweep, sweeps_of};
pub use tighten::tighten;
pub use transit::{Stop, Transit};
