//! The map that a robot keeps by itself, from wheel counts, bumper, light bumper and cliff sensors.
//!
//! It drifts as the robot's odometry does. Swept floor is a disc of the tool's width along the way; an obstacle is marked where
//! the bumper's switches, a bright echo of the light bumper or a cliff sensor put it.

use super::{EgoMap, PatchMark};
use crate::mapping::observation::{IDLE, LEAST, REFLECTED};
use robovac_core::{
    geometry::{Point, Pose, Vector},
    math,
    robot::{Odometry, OdometryModel, RobotModel, SensorReadings},
};

/// Way between two marks of the tool, m.
const SPACING: f64 = 0.025;
/// Distance up to which echoes are marked, m: farther away they tell too little.
const NEAR: f64 = 0.08;
/// How far inside an obstacle its mark lies, m: half a cell.
const INSIDE: f64 = 0.025;

/// The map with the robot's estimated pose. Its frame begins at the origin, heading along x.
#[derive(Debug, Clone)]
pub struct OwnMap {
    odometry: Odometry,
    /// What the wheels rolled without moving the robot, m.
    pushed: Vector,
    map: EgoMap,
    last: Option<Point>,
}

impl OwnMap {
    /// An unknown map for rooms up to `extent_m` metres wide.
    pub fn new(robot: &RobotModel, extent_m: f64) -> Self {
        let odometry = Odometry::new(robot, OdometryModel::Arc, Pose::new(0.0, 0.0, 0.0));
        Self { odometry, pushed: Vector::zeros(), map: EgoMap::new(extent_m), last: None }
    }

    /// Takes every reading.
    #[inline]
    pub fn update(&mut self, robot: &RobotModel, sensed: &SensorReadings) {
        let before = self.odometry.pose().position();
        self.odometry.update(sensed);
        // Against a wall the castor stands still while the wheels slip.
        if sensed.bumped() && !sensed.stasis {
            self.pushed += self.odometry.pose().position() - before;
        }
        let pose = self.pose();
        let moved = self.last.is_none_or(|last| (pose.position() - last).norm_squared() > SPACING * SPACING);
        if moved && !sensed.wheel_dropped() {
            self.last = Some(pose.position());
            self.map.mark_disc(pose.position(), 0.5 * robot.tool_width, PatchMark::Swept);
        }
        if sensed.bumped() {
            self.touch(robot, sensed, pose);
        }
    }

    /// Marks where the bumper was pressed: ahead, or in the middle of its left or right part.
    fn touch(&mut self, robot: &RobotModel, sensed: &SensorReadings, pose: Pose) {
        let Some(bumper) = robot.sensors.bumper else { return };
        let aside = f64::midpoint(bumper.half_arc, bumper.both_within);
        let direction = match (sensed.bump_left, sensed.bump_right) {
            (true, false) => aside,
            (false, true) => -aside,
            _ => 0.0,
        };
        self.mark_at(pose, direction, robot.body.reach(robot.radius, direction) + INSIDE);
    }

    /// Marks what light bumper and cliff sensors see; once for each observation is enough.
    pub fn look(&mut self, robot: &RobotModel, sensed: &SensorReadings) {
        let pose = self.pose();
        if let Some(light) = robot.sensors.light_bumper {
            for (angle, &signal) in light.angles.into_iter().zip(&sensed.light_signal) {
                let echo = f64::from(signal) - IDLE;
                if echo > LEAST {
                    let distance = light.distance_of_light(echo, REFLECTED);
                    if distance < NEAR {
                        self.mark_at(pose, angle, robot.body.reach(robot.radius, angle) + distance + INSIDE);
                    }
                }
            }
        }
        for (place, sees_void) in robot.sensors.cliffs.iter().zip(sensed.cliff) {
            if let Some(place) = place.filter(|_| sees_void) {
                self.map.mark(pose.to_world(Point::from(place)), PatchMark::Obstacle);
            }
        }
    }

    fn mark_at(&mut self, pose: Pose, direction: f64, distance: f64) {
        let (sin, cos) = math::sin_cos(direction);
        self.map.mark(pose.to_world(Point::new(distance * cos, distance * sin)), PatchMark::Obstacle);
    }

    /// Writes the patches around the robot, see [`EgoMap::patches`].
    pub fn patches(&self, out: &mut [u8]) {
        self.map.patches(self.pose(), out);
    }

    /// The estimated pose in the map's frame.
    pub fn pose(&self) -> Pose {
        let Pose { x, y, heading } = self.odometry.pose();
        Pose { x: x - self.pushed.x, y: y - self.pushed.y, heading }
    }

    /// The map.
    pub fn map(&self) -> &EgoMap {
        &self.map
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::model;

    #[test]
    fn the_way_is_swept_and_contacts_are_obstacles() {
        let robot = model("roomba600").unwrap();
        let mut map = OwnMap::new(robot, 5.0);
        let mut sensed = SensorReadings::default();
        map.update(robot, &sensed);
        for _ in 0..100 {
            let counts = (0.01 * robot.counts_per_metre) as u16;
            sensed.left_counts = sensed.left_counts.wrapping_add(counts);
            sensed.right_counts = sensed.right_counts.wrapping_add(counts);
            map.update(robot, &sensed);
        }
        let x = map.pose().x;
        assert!((x - 1.0).abs() < 0.05, "{x}");
        sensed.bump_left = true;
        sensed.bump_right = true;
        map.update(robot, &sensed);
        let at = |x: f64, y: f64| map.map().at(Point::new(x, y));
        assert_eq!(
            [at(0.5, 0.0), at(0.5, 0.04), at(0.5, 0.2)],
            [PatchMark::Swept, PatchMark::Swept, PatchMark::Unknown]
        );
        assert_eq!(at(x + robot.radius + INSIDE, 0.01), PatchMark::Obstacle);
    }
}
