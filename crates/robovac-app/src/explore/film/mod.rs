//! How a walk came to be: what a planner that improves its walk had on its way, to be watched afterwards.

mod change;
mod showing;

use change::Change;
pub use showing::{Ink, Picture, Showing};
