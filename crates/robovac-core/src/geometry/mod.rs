//! Points, angles, poses, polygons and discs in the plane.
//!
//! SI units, x right, y up, headings counter-clockwise from +x (ROS REP 103).

mod angle;
mod hull;
mod metric_path;
mod polygon;
mod pose;
mod shape;

pub use angle::{difference, normalize};
pub use hull::convex_hull;
pub use metric_path::{MAX_PATH_CORNERS, MetricPath, PathFault};
pub use polygon::{contains, convex_pieces, edges, nearest_on_segment, outward, signed_area};
pub use pose::Pose;
pub use shape::{Shape, nearest_on_convex, nearest_on_disc, overlap, overlap_box, overlap_disc};

/// A point in metres.
pub type Point = nalgebra::Point2<f64>;
/// A displacement in metres.
pub type Vector = nalgebra::Vector2<f64>;
