//! Stages that planners are composed of. They take what they need as arguments; those that are objects keep memory to be
//! used again, and nothing of a planner.

mod anneal;
mod axis;
mod contest;
mod cost;
mod decompose;
mod distances;
mod flood;
mod frame;
mod mega;
mod min_cut;
mod nearest;
mod order;
mod part;
mod progress;
mod roam;
mod seek;
mod strips;
mod strokes;
mod sweep;
mod tighten;
mod tours;
mod transit;
mod wavefront;

pub use anneal::{Moves, Schedule, anneal};
pub use axis::{lanes_lie_down, swap_axes, swap_grid, swap_walk};
pub(super) use contest::{Contest, MAX_CELLS_FOR_ALL};
pub use cost::Costs;
pub use decompose::{Block, Run, Side, decompose};
pub use distances::Links;
pub use flood::Flood;
pub(super) use mega::{Added, MegaCells};
pub use nearest::nearest_first;
pub use order::{Visit, improve};
pub use part::{Part, drive};
pub use progress::Progress;
pub(super) use roam::{Floor, Rule};
pub use seek::Seeker;
pub use strips::{Borders, Strips, strips};
pub use strokes::{lanes_of, strokes};
pub use sweep::{SWEEPS, Sweep, append_sweep, sweeps_of};
pub use tighten::tighten;
pub(super) use tours::{Tours, between};
pub use transit::{Stop, Transit};
pub(super) use wavefront::{GOAL, Goal, STEP, cover, obstacle_transform};
