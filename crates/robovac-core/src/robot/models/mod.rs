//! The available robots, one per file, with a source for every value.

mod cbot;
mod cell;
mod dvr1;
mod octagon;
mod roomba600;
mod roomba600_lidar;

pub use cell::cell_robot;

use super::RobotModel;

/// The built-in robots.
pub const MODELS: &[&RobotModel] = &[
    // In the order of the menus.
    &roomba600::ROOMBA_600,
    &roomba600_lidar::ROOMBA_600_LIDAR,
    &dvr1::DVR_1,
    &cbot::CBOT,
    &octagon::OCTAGON,
    &cell::CELL_20,
];

/// The model with that id.
pub fn model(id: &str) -> Option<&'static RobotModel> {
    MODELS.iter().copied().find(|m| m.id == id)
}
