//! Bumper switches.

use super::Carrier;
use crate::{geometry::difference, math, robot::RobotModel};

/// Which halves of the bumper are pressed.
pub(super) fn pressed(model: &RobotModel, carrier: &Carrier) -> (bool, bool) {
    let (Some(touch), Some(bumper)) = (carrier.touch, model.sensors.bumper) else { return (false, false) };
    let angle = difference(carrier.pose.heading, math::atan2(touch.y, touch.x));
    if angle.abs() > bumper.half_arc {
        return (false, false);
    }
    (angle > -bumper.both_within, angle < bumper.both_within)
}
