//! Global localisation on a known map, for a kidnapped or lost robot.
//!
//! According to 004 (section 4.3), global localisation with a bumper and light sensors is unsolvable without the dock,
//! and so is the kidnapped robot problem. One reading carries almost no information, such as a wall close to the right.
//! But a robot that follows walls measures their lengths, corners and doors with its wheels, and the sequence is
//! different in every room. O'Kane & LaValle (Localization with limited sensing, IEEE Transactions on Robotics 23(4),
//! 2007) prove that contact and odometry suffice up to the symmetries of a room. [`Locator`] is a particle filter in
//! the line of Monte Carlo localisation (Dellaert, Fox, Burgard & Thrun 1999), with additions for such limited sensors:
//!
//! - It waits for the first wall, and then draws poses from its readings there (mixture MCL; Thrun, Fox, Burgard &
//!   Dellaert, Robust Monte Carlo localization for mobile robots, Artificial Intelligence 128, 2001): a wall on the
//!   right leaves a band around the walls instead of the whole floor.
//! - Echoes, missing echoes, contacts and free floor under the body all count, as the sum of many weak hints.
//! - The number of particles depends on the number of possible places (Fox, Adapting the sample size in particle
//!   filters through KLD-sampling, 2003).
//! - *Docks* whose places are known are landmarks. Their beams tell where around the dock the robot is and where it looks;
//!   on its contacts it knows its pose at once.
//! - A robot with a laser scanner searches the whole map for the poses at which a scan fits, and follows those.
//! - It draws new poses when readings fit the map worse than before (augmented MCL; Thrun, Burgard & Fox, Probabilistic
//!   Robotics, 2005, section 8.3.5), and starts over after wheel drops.

mod field;
mod landmark;
mod likelihood;
mod locator;
mod particles;
mod scan_reading;

pub use field::DistanceField;
pub use locator::{Locator, LocatorSetup};
