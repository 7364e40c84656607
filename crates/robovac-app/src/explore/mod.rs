//! The tab Explore: one room, one algorithm.

mod diary;
mod editor;
mod film;
mod furnisher;
mod objects;
pub mod opening;
mod search;
mod session;
mod state;
mod view;

pub use diary::{Entry, diary, diary_version};
pub use editor::{Brush, Editor};
pub use film::{Ink, Picture, Showing};
pub use furnisher::Furnisher;
pub use objects::{Kind, handles, in_words};
pub use search::Search;
pub use session::{LoadError, Session};
pub use state::{Action, State};
pub use view::View;
