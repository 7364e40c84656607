//! A Roomba 600 or Create 2 with a laser scanner on top.

use super::{cbot::URG_04LX, roomba600::ROOMBA_600};
use crate::robot::{
    RobotModel,
    body::{Laser, SensorSuite},
    model::PowerDraw,
};

/// A Roomba 600 or Create 2 that carries the `CBot`'s scanner, as people add one to it. Its place above the middle between
/// the wheels is ours, as is the assumption that nothing of the robot is in its way. Everything else is the Roomba's;
/// the scanner's 2.5 W (500 mA at 5 V, its data sheet) are added to the power that is drawn all the time.
pub(super) const ROOMBA_600_LIDAR: RobotModel = RobotModel {
    id: "roomba600_lidar",
    title: "Roomba 600 with laser",
    summary: "Roomba 600 with a laser scanner on top, as builders add one",
    sensors: SensorSuite { laser: Some(Laser { at: [0.0, 0.0], ..URG_04LX }), ..ROOMBA_600.sensors },
    power: PowerDraw { standing: ROOMBA_600.power.standing + 2.5, ..ROOMBA_600.power },
    ..ROOMBA_600
};
