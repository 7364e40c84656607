//! The Floor plan tab: a drawing is viewed, scaled, traced and swept before it becomes the room.
//!
//! [`Board`] holds what files are and what was chosen for them; [`DraftView`] is what the page shows of it. `web::Drafting`
//! draws it, in a worker.

mod board;
mod body;
mod coarse;
mod colour;
mod doors;
mod export;
mod hand;
mod overlay;
mod settings;
mod sheet;
mod source;
mod unit;
mod view;

pub use board::{Board, PLANNER, warm_up};
pub use body::{BodyChoice, BodyError};
pub use coarse::coarse;
pub use colour::seen_on;
pub use doors::Doors;
pub use export::Format;
pub use hand::{Hand, Tool};
pub use overlay::{overlays, sweep_dxf};
pub use settings::{CELLS, Part, Settings};
pub use sheet::Sheet;
pub use source::Source;
pub use unit::{UNITS, Unit, size_in_words};
pub use view::{DraftView, LayerView, RoomView, SweepView, UnitView};
