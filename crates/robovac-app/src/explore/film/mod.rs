//! Film of a search: the intermediate walks of a planner that improves its walk.

mod change;
mod showing;

use change::Change;
pub use showing::{Ink, Picture, Showing};
