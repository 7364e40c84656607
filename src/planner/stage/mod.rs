//! Stages that planners are composed of: they take what they need as arguments and keep nothing.

mod axis;
mod contest;
mod cost;
mod decompose;
mod distances;
mod flood;
mod frame;
mod mega;
mod order;
mod progress;
mod roam;
mod seek;
mod sweep;
mod tighten;
mod transit;
mod wavefront;

pub use axis::{lanes_lie_down, swap_axes, swap_walk};
pub(super) use contest::{Contest, MAX_CELLS_FOR_ALL};
pub use cost::Costs;
pub use decompose::{Block, Run, Side, decompose};
pub use distances::Links;
pub use flood::Flood;
pub(super) use mega::{Added, MegaCells};
pub use order::{Visit, improve, nearest_first};
pub use progress::Progress;
pub(super) use roam::{Floor, Rule};
pub use seek::Seeker;
pub use sweep::{SWEEPS, Sweep, append_sweep, sweeps_of};
pub use tighten::tighten;
pub use transit::{Stop, Transit};
pub(super) use wavefront::{GOAL, Goal, STEP, cover, obstacle_transform};
