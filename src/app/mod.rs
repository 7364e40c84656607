//! What happens between the algorithms and the page or the command line: pure, so that all of it is tested natively.

mod algorithm;
pub mod bench;
pub mod compare;
mod editor;
mod import;
pub mod montecarlo;
pub mod opening;
mod outline;
mod palette;
pub mod planning;
mod recording;
mod scene;
mod search;
mod session;
mod settings;
mod state;
mod view;
mod viewport;

pub use algorithm::Algorithm;
pub use editor::{Brush, Editor};
pub use import::{Choices, Import};
pub use outline::outlines;
pub use palette::Palette;
pub use planning::{Answer, MOST_SEARCH_CELLS, PlanRequest, Planned, Prepared};
pub use recording::Recording;
pub use scene::{RobotView, Scene, SearchScene};
pub use search::Search;
pub use session::{LoadError, ScenarioError, Session};
pub use settings::{CELL_SIZES, SPEEDS, Settings, SettingsError};
pub use state::{Action, State};
pub use view::View;
pub use viewport::Viewport;
