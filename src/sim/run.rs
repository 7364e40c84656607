//! A whole run: one robot, one controller, one floor.

use super::{STEP_S, SimRobot, Slip, SlipLevel};
use crate::{
    controller::Controller,
    coverage::{CoverageTracker, ReachableFloor},
    geometry::{Point, Pose, difference},
    robot::{RobotModel, Sensors},
};
use std::sync::Arc;

/// Most points of the trail that are kept, and their distance, m.
const TRAIL: (usize, f64) = (600, 0.04);

/// What a run is made of.
#[derive(Debug, Clone)]
pub struct RunSetup {
    /// The floor, with the start.
    pub floor: Arc<ReachableFloor>,
    /// The robot.
    pub robot: RobotModel,
    /// How well its wheels hold.
    pub slip: SlipLevel,
    /// Seed of everything random.
    pub seed: u64,
}

/// The state of a run after a number of steps. Cloning it makes a key frame to come back to.
pub struct Run {
    floor: Arc<ReachableFloor>,
    robot: SimRobot,
    controller: Box<dyn Controller>,
    tracker: CoverageTracker,
    steps: u64,
    distance_m: f64,
    turning_rad: f64,
    bumps: u32,
    trail: Vec<Point>,
}

impl Run {
    /// A robot at the start, about to be driven by `controller`.
    pub fn new(setup: &RunSetup, controller: Box<dyn Controller>) -> Self {
        let floor = Arc::clone(&setup.floor);
        let mut tracker = CoverageTracker::new(&floor);
        tracker.sweep_to(&floor, floor.start.position());
        let robot = SimRobot::new(&setup.robot, floor.start, Slip::new(setup.slip, setup.seed));
        let trail = vec![floor.start.position()];
        Self { floor, robot, controller, tracker, steps: 0, distance_m: 0.0, turning_rad: 0.0, bumps: 0, trail }
    }

    /// Advances by [`STEP_S`]; does nothing once the controller is done and the robot at rest.
    pub fn step(&mut self) {
        if self.is_finished() {
            return;
        }
        let (before, was_bumped) = (self.robot.pose(), self.robot.sensors().bumped());
        let drive = self.controller.step(&self.robot.sensors(), STEP_S);
        self.robot.step(&self.floor.walls, drive);
        let pose = self.robot.pose();
        self.steps += 1;
        self.distance_m += (pose.position() - before.position()).norm();
        self.turning_rad += difference(before.heading, pose.heading).abs();
        self.bumps += u32::from(self.robot.sensors().bumped() && !was_bumped);
        self.tracker.sweep_to(&self.floor, pose.position());
        self.extend_trail(pose.position());
    }

    fn extend_trail(&mut self, at: Point) {
        if self.trail.last().is_none_or(|last| (at - last).norm_squared() > TRAIL.1 * TRAIL.1) {
            if self.trail.len() == TRAIL.0 {
                self.trail.drain(..TRAIL.0 / 4);
            }
            self.trail.push(at);
        }
    }

    /// Whether the controller is done and the robot at rest.
    #[inline]
    pub fn is_finished(&self) -> bool {
        let speed = self.robot.speed();
        self.controller.is_done() && speed.left == 0.0 && speed.right == 0.0
    }

    /// Steps taken.
    #[inline]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Simulated time, s.
    #[inline]
    pub fn time_s(&self) -> f64 {
        self.steps as f64 * STEP_S
    }

    /// Where the robot really is.
    pub fn pose(&self) -> Pose {
        self.robot.pose()
    }

    /// Where its controller believes it to be.
    pub fn estimate(&self) -> Option<Pose> {
        self.controller.estimate()
    }

    /// Index of the corner of its line that the controller drives to, if it follows one.
    pub fn corner(&self) -> Option<usize> {
        self.controller.corner()
    }

    /// Distance between where the robot is and where its controller believes it to be, m.
    pub fn pose_error_m(&self) -> Option<f64> {
        self.estimate().map(|estimate| (estimate.position() - self.pose().position()).norm())
    }

    /// The latest sensor reading.
    pub fn sensors(&self) -> Sensors {
        self.robot.sensors()
    }

    /// Distance driven, m.
    pub fn distance_m(&self) -> f64 {
        self.distance_m
    }

    /// Sum of all turning, rad.
    pub fn turning_rad(&self) -> f64 {
        self.turning_rad
    }

    /// How often the bumper was pressed.
    pub fn bumps(&self) -> u32 {
        self.bumps
    }

    /// Swept share of the reachable floor, 0 to 1.
    pub fn coverage(&self) -> f64 {
        self.tracker.coverage(&self.floor)
    }

    /// What has been swept.
    pub fn tracker(&self) -> &CoverageTracker {
        &self.tracker
    }

    /// What has been swept, to take what changed.
    pub fn tracker_mut(&mut self) -> &mut CoverageTracker {
        &mut self.tracker
    }

    /// The floor that the robot drives on.
    pub fn floor(&self) -> &Arc<ReachableFloor> {
        &self.floor
    }

    /// The last metres that the robot drove, oldest first, m.
    pub fn trail(&self) -> &[Point] {
        &self.trail
    }

    /// Roughly the memory that a clone takes, bytes.
    pub fn bytes(&self) -> usize {
        self.tracker.bytes() + TRAIL.0 * size_of::<Point>()
    }

    /// A number that two runs share only if they are in the same state, to the last bit (FNV-1a).
    pub fn digest(&self) -> u64 {
        let pose = self.robot.pose();
        let bits = [pose.x, pose.y, pose.heading, self.distance_m, self.turning_rad].map(f64::to_bits);
        let words = bits.into_iter().chain([self.steps, u64::from(self.bumps)]);
        let bytes = words.flat_map(u64::to_le_bytes).chain(self.tracker.visits().values().iter().copied());
        bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
    }
}

impl Clone for Run {
    fn clone(&self) -> Self {
        Self {
            floor: Arc::clone(&self.floor),
            robot: self.robot.clone(),
            controller: self.controller.boxed_clone(),
            tracker: self.tracker.clone(),
            trail: self.trail.clone(),
            ..*self
        }
    }
}
