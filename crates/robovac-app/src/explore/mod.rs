//! The Explore tab: one room, one algorithm.

mod catalogue;
mod diary;
mod editor;
mod film;
mod object_tool;
mod objects;
pub mod opening;
mod program_job;
mod search;
mod session;
mod session_snapshot;
mod state;
mod view;

pub use catalogue::{Catalogue, RobotEntry};
pub use diary::{DiaryEntry, diary, diary_version};
pub use editor::{Brush, Editor};
pub use film::{FilmInk, FilmPicture, Showing, pictures};
pub use object_tool::ObjectTool;
pub use objects::{PlaceableKind, handles, in_words};
pub use program_job::{JobError, LaidOutJob, ProgramJob};
pub use search::PlanSearch;
pub use session::{LinkOutline, LoadError, Session};
pub use session_snapshot::{FollowError, SessionSnapshot};
pub use state::{Action, SessionState};
pub use view::{FloorTool, PageView, ProgramView, SessionView};
