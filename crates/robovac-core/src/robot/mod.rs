//! Robots: geometry, limits, sensors, drive commands, and odometry from encoder counts.

mod body;
mod drive;
mod light_law;
mod model;
mod models;
mod moved;
mod odometry;
mod port;
mod sensors;

pub use body::{Battery, Body, Bumper, Laser, LightBumper, SensorSuite, SideBrush, Wheels};
pub use drive::Drive;
pub use light_law::{MOST_LIGHT, apparent_distance, distance_of_light, light_at};
pub use model::{Power, RobotModel};
pub use models::{MODELS, cell_robot, model};
pub use moved::{Moved, MovedMeter, READINGS_PER_MOVED};
pub use odometry::{Odometry, OdometryModel, RollingScale, advance, advance_sideways};
pub use port::RobotPort;
pub use sensors::{BatteryReading, Infrared, Overcurrent, Sensors};
