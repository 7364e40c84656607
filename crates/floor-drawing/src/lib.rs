//! Line drawings of floors: CAD drawings (DXF) and other vector files in, and the rooms that are traced from them.
//!
//! A [`Drawing`] is what a file shows, flattened to straight strokes on layers, in the file's own units. [`trace`] makes a
//! [`FloorPlan`](robovac_core::floor_plan::FloorPlan) of it once the user has chosen the roles of its layers, its unit and
//! which part is meant. [`to_dxf`] draws lines, such as a sweeping path, beside a drawing.

mod colours;
mod dxf;
mod error;
mod flatten;
mod geojson;
mod model;
mod overlay;
mod read;
mod roles;
mod svg;
mod trace;
mod tracing;
mod write;

pub use error::{DrawingError, DrawingFlaw};
pub use model::{Drawing, DrawingLayer, MAX_COORDINATE, MAX_LAYERS, MAX_POINTS, Role, Stroke};
pub use overlay::Overlay;
pub use read::{drawing_kind, is_drawing, is_dxf, read};
pub use trace::trace;
pub use tracing::{DrawingRegion, Traced, Tracing};
pub use write::{outlines, to_dxf};
