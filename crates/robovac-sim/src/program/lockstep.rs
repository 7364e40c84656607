//! A simulation that a program drives step by step.

use super::{
    CommandLog, LASER, LogEnd, Logged, SharedLog,
    layout::{Reckoned, RobotFacts, wheel_command, write_readings},
};
use crate::{Conditions, Input, Run, experiment::RoomSetup};
use robovac_core::robot::RobotModel;
use std::sync::Arc;

/// Most steps until a robot that got no more commands is at rest.
const COAST: u32 = 400;

/// One robot in one room, for a program that senses and drives in turn. It keeps the log, so that a [`Run`] with
/// [`Logged`] repeats it to the last bit.
///
/// ```
/// use robovac_core::{floor_plan::room, robot::model};
/// use robovac_sim::{Conditions, Run, experiment::RoomSetup, program::{LogEnd, Lockstep, Logged, SharedLog}};
///
/// let (plan, robot) = ((room("bedroom").unwrap().build)(), model("roomba600").unwrap());
/// let setup = RoomSetup::new(&plan, robot, robot.default_cell, None).unwrap();
/// let mut lockstep = Lockstep::new(&setup, Conditions::default(), 7, Vec::new());
/// for _ in 0..400 {
///     let bumped = lockstep.run().sensors().bumped();
///     lockstep.step(if bumped { [-100.0, 100.0] } else { [300.0, 300.0] });
/// }
/// lockstep.finish(LogEnd::Done);
///
/// let log = SharedLog::new(lockstep.log());
/// let mut run = Run::new(&setup.setup(Conditions::default(), 7), Box::new(Logged::new(log)));
/// while !run.is_finished() {
///     run.step();
/// }
/// assert_eq!(run.digest(), lockstep.digest());
/// ```
pub struct Lockstep {
    run: Run,
    log: SharedLog,
    robot: RobotModel,
    /// A person's inputs, with the number of steps before each, and the number already applied.
    inputs: Vec<(u64, Input)>,
    applied: usize,
    reckoned: Reckoned,
    /// Encoder counts of the last reading.
    counts: Option<[u16; 2]>,
    /// The last scan.
    laser: Option<Arc<[f32]>>,
    readings: Vec<f64>,
}

/// The state of a [`Lockstep`] at one moment.
pub struct LockstepFrame {
    run: Run,
    reckoned: Reckoned,
    counts: Option<[u16; 2]>,
    laser: Option<Arc<[f32]>>,
    readings: Vec<f64>,
}

impl Lockstep {
    /// A robot at the start of a room, with a person's `inputs`, each with the number of steps before it.
    pub fn new(setup: &RoomSetup, conditions: Conditions, seed: u64, inputs: Vec<(u64, Input)>) -> Self {
        let log = SharedLog::default();
        let run = Run::new(&setup.setup(conditions, seed), Box::new(Logged::new(log.clone())));
        let beams = setup.robot.sensors.laser.map_or(0, |laser| laser.beams);
        let mut lockstep = Self {
            run,
            log,
            robot: setup.robot.clone(),
            inputs,
            applied: 0,
            reckoned: Reckoned::default(),
            counts: None,
            laser: None,
            readings: vec![f64::INFINITY; LASER + beams],
        };
        lockstep.sense();
        lockstep
    }

    /// The readings, as [`SLOTS`](super::SLOTS) lists them, then the laser's ranges.
    pub fn readings(&self) -> &[f64] {
        &self.readings
    }

    /// Number of the latest scan of the laser; 0 before the first.
    pub fn scan(&self) -> u32 {
        self.reckoned.scan
    }

    /// Facts about the robot.
    pub fn facts(&self) -> RobotFacts {
        RobotFacts::of(&self.robot)
    }

    /// The run so far.
    pub fn run(&self) -> &Run {
        &self.run
    }

    /// What was commanded so far.
    pub fn log(&self) -> CommandLog {
        self.log.get().clone()
    }

    /// Number of steps for which the program has commanded.
    pub fn log_until(&self) -> u32 {
        self.log.get().until()
    }

    /// The commands from that step on, as bytes.
    pub fn log_bytes(&self, from: u32) -> Vec<u8> {
        self.log.get().to_bytes_from(from)
    }

    /// Digest of the present state; see [`Run::digest`].
    pub fn digest(&self) -> u64 {
        self.run.digest()
    }

    /// Drives for a step with these speeds of the left and the right wheel, mm/s. False once the run is over: the
    /// battery is empty, or the program has ended.
    pub fn step(&mut self, wheels_mm_s: [f64; 2]) -> bool {
        self.steps(wheels_mm_s, 1) == 1
    }

    /// Up to `most` steps with the same speeds; returns the number taken.
    pub fn steps(&mut self, wheels_mm_s: [f64; 2], most: u32) -> u32 {
        let command = wheels_mm_s.map(|speed| wheel_command(&self.robot, speed));
        let mut taken = 0;
        while taken < most && self.log.get().end().is_none() {
            self.apply_inputs();
            if self.run.is_finished() {
                break;
            }
            self.log.get_mut().push(command);
            self.run.step();
            self.reckon();
            taken += 1;
        }
        self.reckoned.command = command.map(|speed| f64::from(speed) / 1000.0);
        self.sense();
        taken
    }

    /// Ends the program here; the robot brakes until it is at rest.
    pub fn finish(&mut self, end: LogEnd) {
        self.log.get_mut().finish(end);
        for _ in 0..COAST {
            self.apply_inputs();
            if self.run.is_finished() {
                break;
            }
            self.run.step();
            self.reckon();
        }
        self.reckoned.command = [0.0; 2];
        self.sense();
    }

    /// Replaces a person's inputs. Those before the present step must be the same: go back first.
    pub fn set_inputs(&mut self, inputs: Vec<(u64, Input)>) {
        let now = self.run.steps();
        self.inputs = inputs;
        self.applied = self.inputs.partition_point(|&(step, _)| step < now);
    }

    /// The present state, to come back to.
    pub fn frame(&self) -> LockstepFrame {
        LockstepFrame {
            run: self.run.clone(),
            reckoned: self.reckoned,
            counts: self.counts,
            laser: self.laser.clone(),
            readings: self.readings.clone(),
        }
    }

    /// Goes back to `frame`; the log after it is forgotten.
    pub fn restore(&mut self, frame: &LockstepFrame) {
        self.run = frame.run.clone();
        self.reckoned = frame.reckoned;
        self.counts = frame.counts;
        self.laser.clone_from(&frame.laser);
        self.readings.clone_from(&frame.readings);
        let now = self.run.steps();
        self.log.get_mut().truncate(now as u32);
        // A frame is taken right after its step, before any input there.
        self.applied = self.inputs.partition_point(|&(step, _)| step < now);
    }

    fn apply_inputs(&mut self) {
        while let Some(&(_, input)) = self.inputs.get(self.applied).filter(|(step, _)| *step <= self.run.steps()) {
            self.run.apply(input);
            self.applied += 1;
        }
    }

    /// Adds up what the wheels have rolled; the first reading only sets the counters, as in odometry.
    fn reckon(&mut self) {
        let sensed = self.run.sensors();
        let counts = [sensed.left_counts, sensed.right_counts];
        if let Some(last) = self.counts.replace(counts) {
            let [left, right] =
                [0, 1].map(|i| f64::from(counts[i].wrapping_sub(last[i]) as i16) / self.robot.counts_per_metre);
            self.reckoned.driven[0] += 0.5 * (left + right);
            self.reckoned.driven[1] += (right - left) / self.robot.wheel_base;
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

    fn sense(&mut self) {
        let start = self.run.floor().start;
        let pose = self.run.estimate().unwrap_or(start);
        self.reckoned.steps = self.run.steps();
        self.reckoned.pose = [pose.x, pose.y, pose.heading];
        let seen = self.readings[LASER - 1];
        write_readings(&mut self.readings[..LASER], self.run.sensors(), &self.reckoned);
        if seen != f64::from(self.reckoned.scan)
            && let Some(laser) = &self.laser
        {
            for (place, &range) in self.readings[LASER..].iter_mut().zip(laser.iter()) {
                *place = range.into();
            }
        }
    }
}

impl LockstepFrame {
    /// Steps taken.
    pub fn steps(&self) -> u64 {
        self.run.steps()
    }

    /// Approximate memory, bytes.
    pub fn bytes(&self) -> usize {
        self.run.bytes() + size_of_val(&*self.readings)
    }
}
