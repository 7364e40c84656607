//! Film of a search: the improvements of an anytime planner's walk.

mod change;
mod showing;

use change::WalkDiff;
pub use showing::{FilmInk, FilmPicture, Showing};
