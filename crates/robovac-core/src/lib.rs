//! Foundations for floor-cleaning robots and coverage algorithms.
//!
//! Imports only point downwards in this list:
//!
//! - [`math`], [`rng`]: elementary functions and random numbers that agree bit for bit natively and in wasm
//! - [`geometry`]: points, angles, poses
//! - [`grid`]: rectangular grids, occupancy, clearance, reachability, `#.` pictures
//! - [`registry`]: shared by planners and behaviours: parameters, explanations
//! - [`floor_plan`]: built-in rooms, map files, scenarios
//! - [`robot`]: models, sensor readings, odometry
//! - [`coverage`]: which floor a robot can reach and what it has swept; the planning grid
//! - [`cspace`]: where a body of any outline fits: the configuration space over x, y and heading
//!
//! Everything is pure: no clock, no input or output, no global state, no panic on bad input.
//!
//! ```
//! use robovac_core::{floor_plan::room, robot::model};
//!
//! let plan = room("thesis8").unwrap().build();
//! let robot = model("roomba600").unwrap();
//! println!("{:.1} m by {:.1} m, for a {:.0} cm robot", plan.width_m(), plan.height_m(), 200.0 * robot.body_radius());
//! ```

pub mod coverage;
pub mod cspace;
pub mod floor_plan;
pub mod geometry;
pub mod grid;
pub mod math;
pub mod registry;
pub mod rng;
pub mod robot;
