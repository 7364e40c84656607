//! The control loop of every robot, simulated or real.

use super::Controller;
use robovac_core::robot::{Drive, RobotPort};

/// One iteration: senses, decides, drives, `dt_s` seconds after the last one. Returns whether to continue: if `ends`
/// returns true after the controller's decision, the robot gets no new speeds.
#[inline]
pub fn drive_on(
    port: &mut impl RobotPort,
    controller: &mut dyn Controller,
    dt_s: f64,
    ends: impl FnOnce(&dyn Controller, Drive) -> bool,
) -> bool {
    let drive = controller.step(port.sensors(), dt_s);
    if ends(controller, drive) {
        return false;
    }
    port.drive(drive);
    true
}
