//! Messages of ROS 2 from robot vacuums, simulated and real, and MCAP bags of them.
//!
//! Nothing of ROS is required: messages are encoded here, in the Common Data Representation that ROS 2 uses.
//!
//! ```
//! use robovac_core::{floor_plan::room, registry::Params, robot::model};
//! use robovac_ros::{Bag, Pace, RunTopics, SourceMap};
//! use robovac_sim::{Conditions, controller, experiment::RoomSetup};
//! use std::io::Cursor;
//!
//! let plan = (room("bedroom").unwrap().build)();
//! let robot = model("roomba600").unwrap();
//! let setup = RoomSetup::new(&plan, robot, robot.default_cell, None).unwrap();
//! let behaviour = controller::find("random_walk").unwrap();
//! let params = Params::defaults(behaviour.params);
//! let mut run = setup.run_behaviour(behaviour, &params, Conditions::default(), 1).unwrap();
//!
//! let mut bag = Bag::new(Cursor::new(Vec::new()), "").unwrap();
//! let mut topics = RunTopics::new(&SourceMap { plan: &plan, robot, path: &[], smooth: None }, &run, Pace::FILE);
//! bag.put_all(topics.take()).unwrap();
//! while run.time_s() < 1.0 {
//!     run.step();
//!     topics.step(&run);
//!     bag.put_all(topics.take()).unwrap();
//! }
//! assert!(bag.finish().unwrap().into_inner().starts_with(b"\x89MCAP"));
//! ```
//!
//! - [`message`]: one function for each kind of message; [`Kind`]: their definitions; [`topic`]: names of topics
//! - [`RunTopics`], [`path_topics`]: the messages of a simulated run and of a path; the same for a bag and for a node
//! - [`Bag`]: an MCAP file

mod bag;
mod cdr;
mod frames;
mod kind;
pub mod message;
mod path;
mod run;
pub mod topic;

pub use bag::{Bag, BagError, file_of};
pub use cdr::{Cdr, nanos};
pub use frames::{BASE, LASER, MAP, ODOM, compose, frame_of, relative_to};
pub use kind::Kind;
pub use path::path_topics;
pub use run::{Pace, RunTopics, SourceMap};
pub use topic::{Stamped, Topic};
