//! Remembered cliffs, so that a turn on the spot puts no wheel over an edge.

use super::obstruction::ObstructionSide;
use robovac_core::{
    geometry::{Point, Pose},
    robot::{Odometry, OdometryModel, RobotModel, SensorReadings},
};
use std::collections::VecDeque;

/// Most remembered places, and their least distance, m.
const KEPT: (usize, f64) = (24, 0.015);
/// Floor that must be left around the circle on which the wheels turn, m.
const MARGIN: f64 = 0.012;
/// Distance ahead of the wheels' axis at which a place is behind, m.
const AHEAD: f64 = 0.01;

/// The last places without floor, by dead reckoning: accurate for the next decimetres.
#[derive(Debug, Clone)]
pub(super) struct Voids {
    odometry: Odometry,
    places: VecDeque<Point>,
    circle: f64,
}

impl Voids {
    pub(super) fn new(robot: &RobotModel) -> Self {
        let odometry = Odometry::new(robot, OdometryModel::Arc, Pose::new(0.0, 0.0, 0.0));
        Self { odometry, places: VecDeque::new(), circle: 0.5 * robot.wheel_base + MARGIN }
    }

    /// Takes the next reading of the cliff sensors at `sensors`.
    pub(super) fn update(&mut self, sensed: &SensorReadings, sensors: &[Option<[f64; 2]>; 4]) {
        self.odometry.update(sensed);
        if !sensed.sees_cliff() || sensed.battery.on_dock {
            return;
        }
        for (place, _) in sensors.iter().zip(sensed.cliff).filter(|(_, cliff)| *cliff) {
            let Some([x, y]) = *place else { continue };
            let place = self.odometry.pose().to_world(Point::new(x, y));
            if self.places.iter().any(|known| (known - place).norm_squared() < KEPT.1 * KEPT.1) {
                continue;
            }
            if self.places.len() == KEPT.0 {
                self.places.pop_front();
            }
            self.places.push_back(place);
        }
    }

    /// Forgets all places: the robot was kidnapped.
    pub(super) fn clear(&mut self) {
        self.places.clear();
    }

    /// The side of a place within the wheels' circle that driving ahead brings nearer.
    ///
    /// The inner wheel of an arc can pass corners that the sensors have passed.
    pub(super) fn ahead(&self) -> Option<ObstructionSide> {
        let pose = self.odometry.pose();
        let ways = self.places.iter().map(|place| place - pose.position());
        let near = ways.filter(|way| way.norm_squared() < self.circle * self.circle);
        let direction = pose.direction();
        let ahead = near.filter(|way| direction.dot(way) > AHEAD).min_by(|a, b| a.norm().total_cmp(&b.norm()));
        ahead.map(|way| if direction.perp(&way) > 0.0 { ObstructionSide::Left } else { ObstructionSide::Right })
    }

    /// Whether one of them is within the circle on which the wheels turn.
    pub(super) fn are_near(&self) -> bool {
        let here = self.odometry.pose().position();
        self.places.iter().any(|place| (place - here).norm_squared() < self.circle * self.circle)
    }
}
