//! Robots: geometry, limits, sensors, drive commands, and odometry from encoder counts.

mod body;
mod custom;
mod distance_angle;
mod drive;
mod light_law;
mod model;
mod models;
mod odometry;
mod own;
mod own_form;
mod port;
mod sensor_readings;
mod twin;

pub use body::{
    Battery, Body, Bumper, Castor, Corners, Laser, LightBumper, MAX_CORNERS, SensorSuite, SideBrush, Tool, WheelLayout,
};
pub use custom::{CustomRobot, CustomRobotFault};
pub use distance_angle::{DistanceAngle, DistanceAngleMeter, READINGS_PER_DISTANCE_ANGLE};
pub use drive::Drive;
pub use light_law::{LightLaw, MOST_LIGHT};
pub use model::{PowerDraw, RobotModel};
pub use models::{MODELS, cell_robot, model};
pub use odometry::{Odometry, OdometryModel, RollingScale, advance, advance_sideways};
pub use own::{OwnRobot, OwnRobotFault, OwnSensor};
pub use own_form::{OwnFormFault, OwnRobotForm, OwnShape};
pub use port::RobotPort;
pub use sensor_readings::{BatteryReading, Infrared, Overcurrent, SensorReadings};
pub use twin::{TWIN_MODEL, Twin, TwinFault};
