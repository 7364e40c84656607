//! A few exact moves for calibration.

use robovac_core::{
    geometry::{Pose, difference},
    math,
    robot::{Drive, Odometry, OdometryModel, RobotModel, SensorReadings},
};
use robovac_sim::controller::Controller;

/// Fastest wheel speed of these moves, m/s: slow enough not to slip.
const MOST: f64 = 0.12;
/// Slowest, m/s; some robots don't move below it.
const LEAST: f64 = 0.03;
/// Wheel speed per remaining metre, 1/s.
const EASE: f64 = 2.0;
/// A wheel that advances less than this, m, in this time, s, is stuck or isn't counted.
const STUCK: (f64, f64) = (0.005, 2.0);
/// Activity text in that case.
pub(super) const STUCK_WORDS: &str = "stopped: the encoders don't count";
/// Pause between two moves, so that the robot stands still, s.
const PAUSE_S: f64 = 0.4;

/// A single move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum CalibrationMove {
    /// On the spot, rad, to the left.
    Turn(f64),
    /// Ahead, m.
    Go(f64),
}

/// A sequence of moves; ends early at an obstacle.
#[derive(Debug, Clone)]
pub(super) struct CalibrationMoves {
    list: Vec<CalibrationMove>,
    robot: RobotModel,
    odometry: Odometry,
    /// Pose of the last reading and progress of the present move, rad or m.
    last: Pose,
    done: f64,
    next: usize,
    pause_s: f64,
    is_blocked: bool,
    /// The remaining distance at the last progress, m, and the time since, s.
    still: (f64, f64),
    is_stuck: bool,
}

impl CalibrationMoves {
    pub fn new(robot: &RobotModel, list: Vec<CalibrationMove>) -> Self {
        let start = Pose::new(0.0, 0.0, 0.0);
        Self {
            list,
            odometry: Odometry::new(robot, OdometryModel::Arc, start),
            robot: robot.clone(),
            last: start,
            done: 0.0,
            next: 0,
            pause_s: 0.0,
            is_blocked: false,
            still: (f64::INFINITY, 0.0),
            is_stuck: false,
        }
    }
}

impl Controller for CalibrationMoves {
    fn step(&mut self, sensed: &SensorReadings, dt_s: f64) -> Drive {
        self.odometry.update(sensed);
        let pose = self.odometry.pose();
        let (turned, went) =
            (difference(self.last.heading, pose.heading), (pose.position() - self.last.position()).norm());
        self.last = pose;
        if sensed.bumped() || sensed.sees_cliff() || sensed.wheel_dropped() {
            self.is_blocked = true;
        }
        self.pause_s -= dt_s;
        if self.is_done() || self.pause_s > 0.0 {
            return Drive::STOP;
        }
        let Some(&step) = self.list.get(self.next) else { return Drive::STOP };
        let (left, spin) = match step {
            CalibrationMove::Turn(angle) => {
                // In either direction, as the encoders may be swapped.
                self.done += turned.abs();
                ((angle.abs() - self.done) * 0.5 * self.robot.wheel_base, angle.signum())
            }
            CalibrationMove::Go(way) => {
                self.done += went;
                (way - self.done, 0.0)
            }
        };
        // Distance rolled while the motors brake and the reading arrives: about two frames.
        if left < 0.5 * math::PI / self.robot.counts_per_metre + LEAST * 0.03 {
            (self.next, self.done, self.pause_s) = (self.next + 1, 0.0, PAUSE_S);
            self.still = (f64::INFINITY, 0.0);
            return Drive::STOP;
        }
        let (before, since) = self.still;
        self.still = if left < before - STUCK.0 { (left, 0.0) } else { (before, since + dt_s) };
        if self.still.1 > STUCK.1 {
            self.is_stuck = true;
            return Drive::STOP;
        }
        let speed = (EASE * left).clamp(LEAST, MOST);
        if spin == 0.0 { Drive::wheels(speed, speed) } else { Drive::wheels(-spin * speed, spin * speed) }
    }

    fn is_done(&self) -> bool {
        self.is_blocked || self.is_stuck || self.next >= self.list.len()
    }

    fn activity(&self) -> &'static str {
        match self.list.get(self.next) {
            _ if self.is_stuck => STUCK_WORDS,
            _ if self.is_blocked => "stopped: something is in the way",
            Some(CalibrationMove::Turn(_)) => "turning",
            Some(CalibrationMove::Go(_)) => "driving ahead",
            None => "standing still",
        }
    }

    fn boxed_clone(&self) -> Box<dyn Controller> {
        Box::new(self.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::model;

    #[test]
    fn a_robot_whose_encoders_do_not_count_does_not_push_for_ever() {
        for step in [CalibrationMove::Turn(math::PI), CalibrationMove::Go(1.0)] {
            let mut moves = CalibrationMoves::new(model("roomba600").unwrap(), vec![step]);
            let sensed = SensorReadings::default();
            let driven = (0..1000).take_while(|_| !moves.step(&sensed, 0.015).is_stop()).count();
            assert!((100..200).contains(&driven) && moves.is_done(), "{driven}");
            assert_eq!(moves.activity(), STUCK_WORDS);
        }
    }
}
