//! Smooth driving: from a line of corners to the poses and speeds of a differential drive, in the least time.
//!
//! 1. [`RoundedLine`]: each corner is replaced by two clothoids, along which the curvature rises from 0 and falls back to
//!    0 in proportion to the way (the CC turns of Fraichard & Scheuer, From Reeds and Shepp's to continuous-curvature paths, IEEE
//!    Transactions on Robotics 2004, without their circular part). Two corners in the same sense with a short piece between them
//!    become one U-turn. A corner can also stay what it is: the robot stops and turns on the spot.
//! 2. [`Trajectory`]: the fastest speed everywhere within the limits of both wheels ([`DriveLimits`]), by one pass from the
//!    end and one from the start (Pham & Pham, A new approach to time-optimal path parameterization based on reachability
//!    analysis, IEEE Transactions on Robotics 2018). As the curvature is linear between two knots and the square of the speed
//!    is, too, limits that hold at both ends of a stretch hold between them.
//!
//! What corners are rounded, and how far, is the caller's decision: it knows walls and the tool.

mod clothoid;
mod limits;
mod moment;
mod profile;
mod round;
mod timed;

pub use limits::DriveLimits;
pub use moment::PlannedMoment;
pub use round::{CornerShape, RoundedLine, Rounding, Stretch};
pub use timed::{Knot, Trajectory};
