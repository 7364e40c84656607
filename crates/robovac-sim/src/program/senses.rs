//! The readings of a program, kept up to date from those of its robot, simulated or real.

use super::layout::{LASER, Reckoned, write_readings};
use robovac_core::{
    geometry::Pose,
    robot::{Odometry, OdometryModel, RobotModel, SensorReadings},
};
use std::sync::Arc;

/// Readings as numbers, with what is added up from them: pose, distance, angle, number of scans.
#[derive(Debug, Clone)]
pub struct ProgramSenses {
    counts_per_metre: f64,
    wheel_base: f64,
    odometry: Odometry,
    reckoned: Reckoned,
    /// Encoder counts of the last reading.
    counts: Option<[u16; 2]>,
    /// The last scan, and the number of the one in `numbers`.
    laser: Option<Arc<[f32]>>,
    written: u32,
    numbers: Vec<f64>,
}

impl ProgramSenses {
    /// Those of a robot that stands at `start`, before its first step.
    pub fn new(robot: &RobotModel, start: Pose, sensed: &SensorReadings) -> Self {
        let beams = robot.sensors.laser.map_or(0, |laser| laser.beams);
        let mut senses = Self {
            counts_per_metre: robot.counts_per_metre,
            wheel_base: robot.wheel_base,
            odometry: Odometry::new(robot, OdometryModel::Arc, start),
            reckoned: Reckoned::default(),
            counts: None,
            laser: None,
            written: 0,
            numbers: vec![f64::INFINITY; LASER + beams],
        };
        senses.write(sensed);
        senses
    }

    /// Takes the readings after a step.
    pub fn take(&mut self, sensed: &SensorReadings) {
        self.reckoned.steps += 1;
        self.odometry.update(sensed);
        let counts = [sensed.left_counts, sensed.right_counts];
        // The first reading only sets the counters, as in odometry.
        if let Some(last) = self.counts.replace(counts) {
            let [left, right] =
                [0, 1].map(|i| f64::from(counts[i].wrapping_sub(last[i]) as i16) / self.counts_per_metre);
            self.reckoned.driven[0] += 0.5 * (left + right);
            self.reckoned.driven[1] += (right - left) / self.wheel_base;
        }
        let is_same = match (&self.laser, &sensed.laser) {
            (Some(before), Some(now)) => Arc::ptr_eq(before, now),
            (before, now) => before.is_none() && now.is_none(),
        };
        if !is_same {
            self.laser.clone_from(&sensed.laser);
            self.reckoned.scan += 1;
        }
    }

    /// Speeds that the wheels were last commanded, left and right, mm/s.
    pub fn command(&mut self, wheels_mm_s: [i16; 2]) {
        self.reckoned.command = wheels_mm_s.map(|speed| f64::from(speed) / 1000.0);
    }

    /// Writes all of it into [`ProgramSenses::numbers`].
    pub fn write(&mut self, sensed: &SensorReadings) {
        let pose = self.odometry.pose();
        self.reckoned.pose = [pose.x, pose.y, pose.heading];
        let (fixed, ranges) = self.numbers.split_at_mut(LASER);
        write_readings(fixed, sensed, &self.reckoned);
        if self.written != self.reckoned.scan {
            self.written = self.reckoned.scan;
            for (place, &range) in ranges.iter_mut().zip(self.laser.iter().flat_map(|laser| laser.iter())) {
                *place = range.into();
            }
        }
    }

    /// The readings, as [`SLOTS`](super::SLOTS) lists them, then the laser's ranges; never at another address.
    pub fn numbers(&self) -> &[f64] {
        &self.numbers
    }

    /// Number of the latest scan of the laser; 0 before the first.
    pub fn scan(&self) -> u32 {
        self.reckoned.scan
    }

    /// Goes back to `earlier`. The numbers stay where they are.
    pub fn restore(&mut self, earlier: &Self) {
        self.numbers.copy_from_slice(&earlier.numbers);
        self.odometry.clone_from(&earlier.odometry);
        self.reckoned = earlier.reckoned;
        self.counts = earlier.counts;
        self.laser.clone_from(&earlier.laser);
        self.written = earlier.written;
    }
}
