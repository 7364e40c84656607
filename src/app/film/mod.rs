//! How a walk came to be: what a planner that improves its walk had on its way, to be watched afterwards.

mod change;
mod record;
mod showing;

use change::Change;
pub use record::{Film, Frame, MOST_FILMED_CELLS};
pub use showing::{Ink, Picture, Showing};
