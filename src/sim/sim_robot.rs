//! A simulated robot: body and wheels.

use super::{
    Conditions, Life, STEP_S, Slip, World, contact,
    senses::{Around, Carrier, Senses},
};
use crate::{
    coverage::Walls,
    geometry::{Pose, Vector},
    robot::{Drive, OdometryModel, RobotModel, Sensors, advance},
};

/// Body, wheels and sensors of one robot. It is told wheel speeds and reports what the Open Interface reports.
#[derive(Debug, Clone)]
pub struct SimRobot {
    model: RobotModel,
    pose: Pose,
    slip: Slip,
    /// Present wheel speeds, m/s.
    speed: Drive,
    /// What the wheels have rolled since the start: left, right, sideways, m.
    rolled: [f64; 3],
    is_lifted: bool,
    senses: Senses,
}

impl SimRobot {
    /// A robot at rest.
    pub fn new(model: &RobotModel, pose: Pose, conditions: Conditions, seed: u64) -> Self {
        Self {
            model: model.clone(),
            pose,
            slip: Slip::new(conditions.slip, seed),
            speed: Drive::STOP,
            rolled: [0.0; 3],
            is_lifted: false,
            senses: Senses::new(model, conditions, seed),
        }
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
    pub fn sensors(&self) -> &Sensors {
        self.senses.reading()
    }

    /// Whether its battery is empty: it doesn't move any more.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.senses.is_empty()
    }

    /// Whether somebody has picked it up.
    pub fn is_lifted(&self) -> bool {
        self.is_lifted
    }

    /// Picks it up.
    pub fn lift(&mut self) {
        self.is_lifted = true;
        self.speed = Drive::STOP;
    }

    /// Puts it down at `pose`, where it must fit.
    pub fn put_down(&mut self, pose: Pose) {
        self.is_lifted = false;
        self.pose = pose;
    }

    /// One step of [`STEP_S`] with the wheels told to turn at `drive`.
    pub fn step(&mut self, walls: &Walls, world: &World, life: &Life, drive: Drive) {
        let before = self.pose;
        let drive = if self.senses.is_empty() { Drive::STOP } else { drive };
        let touch = self.roll(walls, drive);
        let carrier = Carrier {
            pose: self.pose,
            touch,
            wanted: drive,
            speed: self.speed,
            rolled: self.rolled,
            moved: (self.pose.position() - before.position()).norm(),
            is_lifted: self.is_lifted,
            dropped: [false; 2],
            dirt: 0.0,
        };
        self.senses.read(Around { walls, world, life }, &carrier);
    }

    /// Turns the wheels and moves the body as far as the walls allow; returns the direction of what it touches.
    fn roll(&mut self, walls: &Walls, drive: Drive) -> Option<Vector> {
        let speed = Drive {
            left: self.approach(self.speed.left, drive.left),
            right: self.approach(self.speed.right, drive.right),
            lateral: 0.0,
        };
        // Mean speed of the step: exact for constant acceleration.
        let left = 0.5 * (self.speed.left + speed.left) * STEP_S;
        let right = 0.5 * (self.speed.right + speed.right) * STEP_S;
        self.speed = speed;
        self.rolled = [self.rolled[0] + left, self.rolled[1] + right, self.rolled[2]];
        if self.is_lifted {
            return None;
        }
        let (real_left, real_right) = self.slip.apply(left, right);
        let moved = advance(self.pose, real_left, real_right, self.model.wheel_base, OdometryModel::Arc);
        let contact = contact::resolve(walls, moved.position(), self.model.radius);
        self.pose = Pose { x: contact.position.x, y: contact.position.y, heading: moved.heading };
        contact.touch
    }

    /// The wheel speed one step later: towards `wanted`, within the motors' speed and acceleration.
    fn approach(&self, speed: f64, wanted: f64) -> f64 {
        let most = self.model.acceleration * STEP_S;
        let wanted = wanted.clamp(-self.model.max_wheel_speed, self.model.max_wheel_speed);
        speed + (wanted - speed).clamp(-most, most)
    }
}
