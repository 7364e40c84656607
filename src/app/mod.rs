//! View models between the algorithms and the page or the command line: pure, so that all of it is tested natively.

mod algorithm;
pub mod bench;
pub mod compare;
mod diary;
#[cfg(feature = "draft")]
pub mod draft;
mod editor;
pub mod export;
mod film;
mod furnisher;
mod import;
#[cfg(feature = "mapping")]
pub mod kidnapping;
pub mod link;
pub mod montecarlo;
mod objects;
pub mod opening;
mod pack;
mod palette;
pub mod planning;
mod readings;
mod recording;
mod scene;
mod search;
mod session;
mod settings;
mod shows;
mod state;
#[cfg(feature = "survey")]
pub mod survey;
pub mod sweep;
mod view;
mod viewport;

pub use algorithm::Algorithm;
pub use diary::{Entry, diary, diary_version};
pub use editor::{Brush, Editor};
pub use film::{Film, Frame, Ink, MOST_FILMED_CELLS, Picture, Showing};
pub use furnisher::Furnisher;
pub use import::{Choices, Import, ScenarioError};
pub use objects::{Kind, handles, in_words};
pub use pack::{pack, unpack};
pub use palette::Palette;
pub use planning::{Answer, MOST_SEARCH_CELLS, PlanRequest, Planned, Prepared};
pub use readings::{READINGS, readings};
pub use recording::Recording;
pub use scene::{FilmScene, RobotView, Scene, SearchScene, Sensed};
pub use search::Search;
pub use session::{LoadError, Session};
pub use settings::{CELL_SIZES, SPEEDS, Settings, SettingsError};
pub use shows::Shows;
pub use state::{Action, State};
pub use view::View;
pub use viewport::Viewport;
