//! Film of a search: the improvements of a planner's path.
//!
//! The worker that plans makes its pictures, so that the page has no code for them but what shows one after the other.

mod line_diff;
mod picture;
mod pictures;
mod showing;
mod walk_diff;

pub use picture::{FilmInk, FilmPicture};
pub use pictures::pictures;
pub use showing::Showing;
