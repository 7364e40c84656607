//! The loop that drives every robot, simulated or real.

use super::Controller;
use robovac_core::robot::{Drive, RobotPort};

/// One turn of the loop: senses, decides, drives, `dt_s` seconds after the last turn. Returns whether it drives on: `ends`
/// has the last word, once the controller has decided, and then the robot gets no new speeds.
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
