//! Line drawings of floors: reads DXF, SVG and GeoJSON, traces rooms from them, and draws paths beside them.
//!
//! For programs that need a grid of free and occupied cells from a drawn floor plan.
//!
//! ```
//! use floor_drawing::{DrawingRegion, Role, Tracing, read, trace};
//! use robovac_core::floor_plan::SourceFile;
//!
//! let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="320" height="220">
//!     <path d="M10 10 H310 V210 H10 Z" fill="none" stroke="black"/></svg>"#;
//! let drawing = read(&SourceFile { name: "room.svg".into(), bytes: svg.into() }).unwrap();
//! // One unit is a centimetre, and all lines are walls.
//! let roles = vec![Role::Wall; drawing.layers.len()];
//! let tracing = Tracing { roles, metre: 0.01, gap: 0.1, resolution: 0.05, region: DrawingRegion::WHOLE };
//! let traced = trace(&drawing, &tracing).unwrap();
//! assert!(traced.plan.width_m() >= 3.0 && traced.plan.height_m() >= 2.0);
//! ```
//!
//! A [`Drawing`] is the content of a file, flattened to straight strokes on layers, in the file's own units. [`trace`]
//! makes a [`FloorPlan`](robovac_core::floor_plan::FloorPlan) of it once the user has chosen the roles of its layers,
//! its unit and its part. [`to_dxf`] draws lines, such as a sweeping path, beside a drawing.

mod colours;
mod direction;
mod dxf;
mod error;
mod flatten;
mod geojson;
mod lines;
mod model;
mod overlay;
mod picture;
mod read;
mod roles;
mod svg;
mod trace;
mod tracing;
mod write;

pub use direction::{dominant_direction, picture_direction};
pub use error::{DrawingError, DrawingFlaw};
pub use model::{AreaFill, Drawing, DrawingLayer, FillRule, MAX_COORDINATE, MAX_LAYERS, MAX_POINTS, Role, Stroke};
pub use overlay::Overlay;
pub use picture::{Picture, ShadeMethod, WallShades, suggest};
pub use read::{drawing_kind, is_drawing, is_dxf, read};
pub use trace::{OUTER_DOOR, trace, trace_picture};
pub use tracing::{DrawingRegion, FreeStandingBuilding, OutsideLeak, Traced, Tracing};
pub use write::{outlines, to_dxf};
