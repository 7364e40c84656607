//! Mapping and pose estimation from a Roomba's sensors: bumper, six short-range light sensors, and encoder counts.
//!
//! [`Mapper`] is the entry point: it takes readings and has a map, a pose and its covariance. Its map is an
//! [`OccupancyMap`] in log odds, which grows as the robot drives; [`Marks`] record what the robot has cleaned and where
//! it found dirt. Everything is in the frame of the pose that it started from (REP 103). [`MapTruth`] measures a map.
//!
//! # How the pose is corrected
//!
//! The limits of such sensors are known: O'Kane & LaValle (Localization with limited sensing, IEEE Transactions on
//! Robotics 23(4), 2007) show that a contact sensor suffices with a compass but not with an angular odometer. Straight
//! walls are the compass here. Tribelhorn & Dodds (Evaluating the Roomba, ICRA 2007) run Monte Carlo localisation and
//! FastSLAM on one. Beevers & Huang (SLAM with sparse sensing, ICRA 2006) gather readings over a stretch into a
//! multiscan before they use them, and let walls be at right angles (Inferring and enforcing relative constraints in
//! SLAM, WAFR 2006), in a particle filter with a map for each particle. This module uses multiscans and right angles,
//! but not the particles:
//!
//! - The *state* is the pose, the two errors of the wheels that Borenstein & Feng found to matter (they make most of
//!   the drift, and are constant for a robot, so that they can be learnt), and the direction of the room's walls: six
//!   numbers, nearly linear over a stretch of half a metre. One extended Kalman filter tracks them with their
//!   correlations; a particle filter must draw them. With 10 particles, each such a filter with a map of its own that
//!   parts of its uncertainty were drawn from, errors over runs in the furnished flat were up to half as large again,
//!   at ten times the cost (ours, 20 seeds). That agrees with Gutmann, Burgard, Fox & Konolige (An experimental
//!   comparison of localization methods, IROS 1998): scan matching with a Kalman filter is the more accurate, Markov
//!   localisation the more robust way. For robots that are lost there is [`locate`].
//! - A *stretch* ends after half a metre, a quarter turn or a contact. Echoes on it are sorted into straight lines and
//!   the rest and matched to the boundary found so far, which is kept finer than in cells: a mean place and a normal
//!   for each 5 cm, so that a point of a wall corrects the pose across the wall only. Points of one wall share most of
//!   their error. Patches added on the last few metres share the error of the present pose and can't correct it, so
//!   they count little.
//! - *Own error*: the filter's covariance is that of the place on the map. The map itself is as wrong as the pose was when it
//!   was mapped. What the pose's error in the room is then is tracked beside it: it is what the mapper reports, and corrects
//!   nothing. It still assumes a hard floor.
//! - *Right angles*: a wall that is nearly parallel or perpendicular to the others is taken to be so, with a
//!   probability that is learnt from the walls met so far. Where most aren't, as in an attic, this stops by itself.
//! - *Reprocessing*: after 10, 25 and 60 m, when the wheels are known better, all readings so far are processed again,
//!   as everything depends on what is mapped first.
//! - The *dock*, if the robot began there, is an absolute reference. A robot that is lost knows its place on a dock where
//!   it has been before.

mod boundary;
mod contact_lines;
mod gaps;
mod layer;
pub mod locate;
mod mapper;
mod marks;
mod memo;
mod multiscan;
mod normal_equations;
pub mod observation;
mod observer;
mod occupancy_map;
mod paint;
mod pose_covariance;
mod pose_ekf;
mod quality;
mod reckoning;
mod scan;
mod seen_boundary;
mod thesis_grid;
mod thesis_map;

pub use gaps::close_gaps;
pub use layer::TiledLayer;
pub use mapper::{Mapper, MapperSetup, RESOLUTION, Tracking};
pub use marks::{CellMark, Marks};
pub use observer::MapObserver;
pub use occupancy_map::OccupancyMap;
pub use pose_covariance::PoseCovariance;
pub use quality::{MapQuality, MapTruth};
pub use seen_boundary::SeenBoundary;
pub use thesis_grid::{CellStatus, ThesisGrid};
pub use thesis_map::ThesisMap;
