//! Where the floor was seen to end, so that a turn on the spot near there gets no wheel over the edge.

use crate::{
    geometry::{Point, Pose},
    robot::{Odometry, OdometryModel, RobotModel, Sensors},
};
use std::collections::VecDeque;

/// Most places that are kept, and their least distance, m.
const KEPT: (usize, f64) = (24, 0.015);
/// Floor that must be left around the circle on which the wheels turn, m.
const MARGIN: f64 = 0.012;

/// The last places without floor, as dead reckoning has them: good for the next decimetres.
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
    pub(super) fn update(&mut self, sensed: &Sensors, sensors: &[Option<[f64; 2]>; 4]) {
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

    /// Forgets them: the robot was carried elsewhere.
    pub(super) fn clear(&mut self) {
        self.places.clear();
    }

    /// Whether one of them is within the circle on which the wheels turn.
    pub(super) fn are_near(&self) -> bool {
        let here = self.odometry.pose().position();
        self.places.iter().any(|place| (place - here).norm_squared() < self.circle * self.circle)
    }
}
