//! The Floor plan tab: a drawing is viewed, scaled, traced and swept before it becomes the room.
//!
//! [`DrawingSession`] holds the loaded files and their settings; [`DrawingView`] is its snapshot for the page.
//! `web::FloorPlanSession` draws it, in a worker.

mod assumed;
mod body;
mod coarse;
mod colour;
mod cut;
mod doors;
mod export;
mod hand;
mod overlay;
mod session;
mod settings;
mod sheet;
mod source;
mod unit;
mod view;

pub use body::{BodyChoice, BodyError};
pub use coarse::coarse;
pub use colour::seen_on;
pub use cut::cut_off;
pub use doors::Doors;
pub use hand::{DrawingHand, DrawingTool};
pub use overlay::{overlays, sweep_dxf};
pub use session::{DrawingSession, FaultMark, PLANNER, warm_up};
pub use settings::{CELLS, DrawingPart, FloorPlanSettings};
pub use sheet::Sheet;
pub use source::DrawingSource;
pub use unit::{UNITS, Unit, paper_units, size_in_words};
pub use view::{DrawingView, FloorPlanView, LayerView, SweepView, TracedRoomView, UnitView};
