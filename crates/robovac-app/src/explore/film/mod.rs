//! Film of a search: the intermediate walks of a planner that improves its walk.

mod change;
mod showing;

use change::WalkDiff;
pub use showing::{FilmInk, Picture, Showing};
