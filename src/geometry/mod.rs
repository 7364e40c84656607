//! Points, angles and poses in the plane.
//!
//! SI units, x right, y up, headings counter-clockwise from +x (ROS REP 103).

mod angle;
mod pose;

pub use angle::{difference, normalize};
pub use pose::Pose;

/// A point in metres.
pub type Point = nalgebra::Point2<f64>;
/// A displacement in metres.
pub type Vector = nalgebra::Vector2<f64>;
