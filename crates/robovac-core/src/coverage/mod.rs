//! One definition of coverage for planners, controllers, simulator and tables.
//!
//! A robot of radius `r` can stand wherever no obstacle is nearer to its centre than `r`. The **reachable floor** is
//! what its tool (a disc as wide as the strip it cleans) can sweep from all standing places that a path connects with
//! the start. **Coverage** is the share of the reachable floor that the tool has swept. So corners that a round robot
//! can't enter don't count against it, and a planner can't improve its result by leaving out difficult floor.
//!
//! Obstacles are walls on the plan's grid and the objects that stand in the room; stairs are no obstacle to a body, but
//! neither floor nor a place to stand.

mod boundary;
mod burn;
mod fits;
mod floor;
mod floor_error;
mod planning_cells;
mod planning_grid;
mod ray;
mod shapes;
mod stamp;
mod tracker;
mod walls;

pub use boundary::{Boundary, BoundaryTracker};
pub use burn::with_objects;
pub use floor::{ReachableFloor, fine_resolution};
pub use floor_error::FloorError;
pub use planning_cells::PlanningCells;
pub use planning_grid::PlanningGrid;
pub use ray::{RayHit, Surface};
pub use shapes::{DOCK_BACK, FENCE, HALO, LIGHTHOUSE_RADIUS, dock_back, drop_offs, obstacles};
pub use tracker::CoverageTracker;
pub use walls::{Obstacle, Walls};
