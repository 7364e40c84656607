//! A simulated robot with two driven wheels.

use super::{STEP_S, Slip, contact};
use crate::{
    coverage::Walls,
    geometry::{Pose, Vector, difference},
    math,
    robot::{Drive, OdometryModel, RobotModel, Sensors, advance},
};

/// A contact this far off the heading or less presses both halves of the bumper, rad.
const BOTH_BUMPERS: f64 = 0.35;

/// Body, wheels and sensors of one robot. It is told wheel speeds and reports what the Open Interface reports.
#[derive(Debug, Clone)]
pub struct SimRobot {
    model: RobotModel,
    pose: Pose,
    slip: Slip,
    /// Present wheel speeds, m/s.
    speed: Drive,
    /// What the wheels have rolled since the start, m.
    rolled: (f64, f64),
    sensors: Sensors,
}

impl SimRobot {
    /// A robot at rest.
    pub fn new(model: &RobotModel, pose: Pose, slip: Slip) -> Self {
        Self { model: model.clone(), pose, slip, speed: Drive::STOP, rolled: (0.0, 0.0), sensors: Sensors::default() }
    }

    /// Where the robot really is. No controller gets to see this.
    #[inline]
    pub fn pose(&self) -> Pose {
        self.pose
    }

    /// Present wheel speeds.
    #[inline]
    pub fn speed(&self) -> Drive {
        self.speed
    }

    /// The latest sensor reading.
    #[inline]
    pub fn sensors(&self) -> Sensors {
        self.sensors
    }

    /// One step of [`STEP_S`] with the wheels told to turn at `drive`.
    pub fn step(&mut self, walls: &Walls, drive: Drive) {
        let speed = Drive {
            left: self.approach(self.speed.left, drive.left),
            right: self.approach(self.speed.right, drive.right),
        };
        // Mean speed of the step: exact for constant acceleration.
        let left = 0.5 * (self.speed.left + speed.left) * STEP_S;
        let right = 0.5 * (self.speed.right + speed.right) * STEP_S;
        self.speed = speed;
        self.rolled = (self.rolled.0 + left, self.rolled.1 + right);

        let (real_left, real_right) = self.slip.apply(left, right);
        let moved = advance(self.pose, real_left, real_right, self.model.wheel_base, OdometryModel::Arc);
        let contact = contact::resolve(walls, moved.position(), self.model.radius);
        self.pose = Pose { x: contact.position.x, y: contact.position.y, heading: moved.heading };
        (self.sensors.bump_left, self.sensors.bump_right) = self.bumper(contact.touch);
        self.sensors.left_counts = self.counts(self.rolled.0);
        self.sensors.right_counts = self.counts(self.rolled.1);
    }

    /// The wheel speed one step later: towards `wanted`, within the motors' speed and acceleration.
    fn approach(&self, speed: f64, wanted: f64) -> f64 {
        let most = self.model.acceleration * STEP_S;
        let wanted = wanted.clamp(-self.model.max_wheel_speed, self.model.max_wheel_speed);
        speed + (wanted - speed).clamp(-most, most)
    }

    /// Which halves of the bumper a wall in direction `touch` presses; it spans the front half of the body.
    fn bumper(&self, touch: Option<Vector>) -> (bool, bool) {
        let Some(touch) = touch else { return (false, false) };
        let angle = difference(self.pose.heading, math::atan2(touch.y, touch.x));
        if angle.abs() > math::FRAC_PI_2 {
            return (false, false);
        }
        (angle > -BOTH_BUMPERS, angle < BOTH_BUMPERS)
    }

    /// The encoder's counter: it wraps.
    fn counts(&self, rolled: f64) -> u16 {
        ((rolled * self.model.counts_per_metre).floor() as i64) as u16
    }
}
