//! Foundations for floor-cleaning robots and coverage algorithms: rooms, robots, grids, and reachable floor.
//!
//! For programs that plan, simulate or measure the cleaning of floors; `coverage-planners` and the simulator build on it.
//! Imports only point downwards in this list:
//!
//! - [`math`], [`rng`]: elementary functions and random numbers that agree bit for bit natively and in wasm
//! - [`geometry`]: points, angles, poses
//! - [`grid`]: rectangular grids, occupancy, clearance, reachability, `#.` pictures
//! - [`registry`]: shared by planners and behaviours: parameters, explanations
//! - [`program`]: the text of a user's program
//! - [`floor_plan`]: built-in rooms; with the feature `files`, map files and scenarios
//! - [`robot`]: models, sensor readings, odometry
//! - [`coverage`]: reachable and swept floor; the planning grid
//! - [`trajectory`]: rounded corners, and the fastest speeds along a path within the wheels' limits
//! - [`cspace`]: the configuration space of a body of any outline, over x, y and heading
//!
//! Everything is pure: no clock, no input or output, no global state, no panic on bad input.
//!
//! ```
//! use robovac_core::{coverage::ReachableFloor, floor_plan::Sketch, robot::model};
//!
//! // A room of 3 m x 2 m with a table of 1 m x 1 m in a corner; the robot starts at (0.5, 0.5), looking right.
//! let plan = Sketch::open(3.0, 2.0, 0.05).fill(&[[2.0, 1.0, 3.0, 2.0]]).start(0.5, 0.5, 0.0).finish("Study", "");
//! let roomba = model("roomba600").unwrap();
//! let floor = ReachableFloor::new(&plan, roomba, None).unwrap();
//! assert!(floor.area() > 3.0);
//! ```

pub mod coverage;
pub mod cspace;
pub mod floor_plan;
pub mod geometry;
pub mod grid;
pub mod math;
pub mod program;
pub mod registry;
pub mod rng;
pub mod robot;
pub mod trajectory;
