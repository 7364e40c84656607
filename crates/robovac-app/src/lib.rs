//! View models of the Robovac Playground, one folder per tab: the displayed state and the allowed actions.
//!
//! For the page; the boundary to JavaScript only passes on the results. All code is pure, so it is tested natively.
//!
//! ```
//! use robovac_app::Viewport;
//!
//! // A room of 6 m x 4 m on a canvas of 800 x 600 pixels: its middle is in the middle.
//! let view = Viewport::new(6.0, 4.0, 800.0, 600.0, 1.0);
//! let middle = view.to_world(400.0, 300.0);
//! assert!((middle.x - 3.0).abs() < 0.5 && (middle.y - 2.0).abs() < 0.5);
//! ```
//!
//! - [`explore`], [`compare`], [`map`], [`floor_plan`]: the tabs
//! - [`export`]: files to download; [`mod@bench`]: the benchmark of the command line and the page

mod amount;
pub mod bench;
mod carried;
pub mod compare;
pub mod connection;
mod entry;
mod explainer_entry;
pub mod explore;
pub mod export;
pub mod floor_plan;
mod frame_pacer;
mod import;
pub mod map;
mod mark;
mod pack;
mod palette;
mod param;
mod program_run;
mod scene;
#[cfg(feature = "types")]
pub mod types;
mod viewport;

pub use carried::{CarriedRobot, CarryStep};
pub use entry::CatalogueEntry;
pub use explainer_entry::ExplainerEntry;
pub use import::{Import, ImportError, ScenarioChoices, ScenarioError};
pub use mark::Mark;
pub use pack::{pack, unpack};
pub use palette::Palette;
pub use param::{Param, params};
pub use scene::{FilmScene, RobotView, Scene, SearchScene, SensedFloor};
pub use viewport::Viewport;
