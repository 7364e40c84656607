//! What happens between the algorithms and the page or the command line: pure, so that all of it is tested natively.

pub mod bench;
mod editor;
pub mod planning;
mod prepare;
mod recording;
mod session;
mod settings;
mod state;
mod view;

pub use editor::{Brush, Editor};
pub use prepare::{PlanRequest, Planned, Prepared};
pub use recording::Recording;
pub use session::Session;
pub use settings::{CELL_SIZES, SPEEDS, Settings, SettingsError};
pub use state::{Action, State};
pub use view::View;
