//! Film of a search: the intermediate walks of a planner that improves its walk.

mod change;
mod record;
mod showing;

use change::Change;
pub use record::{Film, Frame, MOST_FILMED_CELLS};
pub use showing::{Ink, Picture, Showing};
