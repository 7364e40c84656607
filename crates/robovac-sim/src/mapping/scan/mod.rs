//! Mapping with a laser scanner: scan matching and loop closure.
//!
//! The choice, from the literature:
//!
//! - *Matching.* Scans are matched to surfaces, with the distance of a point from the line through its neighbours as
//!   the error (Censi, An ICP variant using a point-to-line metric, ICRA 2008): it converges quadratically, and a wall
//!   corrects the pose across it only, so that a corridor claims little about the way along it; what it still claims is
//!   ignored. Hector SLAM (Kohlbrecher et al. 2011) follows the gradient of an occupancy grid instead, whose cells
//!   limit the accuracy. The match is one update of the same iterated extended Kalman filter that serves robots without
//!   a laser ([`PoseEkf`](super::pose_ekf::PoseEkf)), which has the wheels' motion as its prediction.
//! - *Searching.* Such a match finds the nearest minimum only. Where the pose is uncertain, all poses of a window are
//!   compared on a grid (Olson, Real-time correlative scan matching, ICRA 2009) with branch and bound (Hess, Kohler,
//!   Rapp & Andor, Real-time loop closure in 2D LIDAR SLAM, ICRA 2016), which can't miss the best.
//! - *Contact.* What the wheels tell is wrong across the wall that a body slides along, and right along it ([`holds`]): where scans
//!   tell little of the way, in corridors, contact costs nothing. A body that isn't round also pushes itself off walls that no switch
//!   feels, when it turns; so where a scan contradicts the prediction (a test of the innovation; Bar-Shalom, Li & Kirubarajan,
//!   Estimation with applications to tracking and navigation, 2001, section 5.4), the wheels count little.
//! - *Reference.* A scan is matched to key frames within a few metres by the graph's edges, as in Karto (Konolige,
//!   Grisetti, Kümmerle, Burgard, Limketkai & Vincent, Efficient sparse pose adjustment for 2D mapping, IROS 2010): these
//!   agree with each other. Key frames that are near on the map but far by edges are candidates for a loop closure.
//! - *Loop closure.* A key frame that matches such old ones gets an edge to them; then the poses of all key frames are
//!   adjusted (Lu & Milios, Globally consistent range scan alignment, Autonomous Robots 4, 1997), edges in contradiction
//!   to the rest counting little (Agarwal, Tipaldi, Spinello, Stachniss & Burgard, Robust map optimization using dynamic
//!   covariance scaling, ICRA 2013). The map is painted again from the stored scans.
//! - *Headings.* Walls of a building are mostly parallel or at right angles. Those around a key frame tell its heading ([`axes`]),
//!   which drifts else where no loop closes; the graph takes it as known to a third of a degree. But not before neighbouring key
//!   frames have shown that the building is straight: there the heading hardly drifts, so what differs are the walls.
//! - Where the robot has been before, nothing is added: the graph grows with the floor and not with time.

mod axes;
mod correlation;
mod frames;
mod graph;
mod holds;
mod outline;
mod paint;
mod points;
mod surfaces;

pub(super) use correlation::{CorrelationGrid, Match, SearchWindow};
pub(super) use frames::{ScanMapper, paint_place};
pub(super) use holds::Holds;
pub(super) use outline::outline;
pub(super) use points::{ScanPoint, ScanSensor};
pub(super) use surfaces::{ScanFit, SurfaceMap};
