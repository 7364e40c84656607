//! A simulation that a program drives step by step.

use super::{
    CommandLog, LogEnd, Logged, ProgramSenses, SharedLog,
    layout::{RobotFacts, readings_json, wheel_command},
};
use crate::{Conditions, Input, Run, experiment::RoomSetup};
use robovac_core::robot::{RobotModel, SensorReadings};

/// Most steps until a robot that got no more commands is at rest.
const COAST: u64 = 400;

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
    senses: ProgramSenses,
    /// A person's inputs, with the number of steps before each, and the number already applied.
    inputs: Vec<(u64, Input)>,
    applied: usize,
}

/// The state of a [`Lockstep`] at one moment.
pub struct LockstepFrame {
    run: Run,
    senses: ProgramSenses,
}

impl Lockstep {
    /// A robot at the start of a room, with a person's `inputs`, each with the number of steps before it.
    pub fn new(setup: &RoomSetup, conditions: Conditions, seed: u64, inputs: Vec<(u64, Input)>) -> Self {
        let log = SharedLog::default();
        let run = Run::new(&setup.setup(conditions, seed), Box::new(Logged::new(log.clone())));
        let senses = ProgramSenses::new(&setup.robot, setup.floor.start, run.sensors());
        Self { run, log, robot: setup.robot.clone(), senses, inputs, applied: 0 }
    }

    /// The readings, as [`SLOTS`](super::SLOTS) lists them, then the laser's ranges; never at another address.
    pub fn readings(&self) -> &[f64] {
        self.senses.numbers()
    }

    /// The readings as one line of JSON; see [`readings_json`].
    pub fn readings_json(&self, with_laser: bool) -> String {
        readings_json(self.senses.numbers(), with_laser)
    }

    /// Number of the latest scan of the laser; 0 before the first.
    pub fn scan(&self) -> u32 {
        self.senses.scan()
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
        while taken < most && self.take(command) {
            taken += 1;
        }
        self.tell(command);
        taken
    }

    /// A step; false once the run is over.
    #[inline]
    fn take(&mut self, command: [i16; 2]) -> bool {
        if self.log.get().end().is_some() {
            return false;
        }
        self.apply_inputs();
        if self.run.is_finished() {
            return false;
        }
        self.log.get_mut().push(command);
        self.run.step();
        self.senses.take(self.run.sensors());
        true
    }

    /// Writes the readings.
    fn tell(&mut self, command: [i16; 2]) {
        self.senses.command(command);
        self.senses.write(self.run.sensors());
    }

    /// The same, until contact with a thing or with the floor changes: bumper, cliff sensors, wheel drops. `watch` sees the run
    /// after each step.
    pub fn hold(&mut self, wheels_mm_s: [f64; 2], most: u32, mut watch: impl FnMut(&Run)) -> u32 {
        let felt = |run: &Run| {
            let SensorReadings { bump_left, bump_right, wheel_drop_left, wheel_drop_right, cliff, .. } = *run.sensors();
            ([bump_left, bump_right, wheel_drop_left, wheel_drop_right], cliff)
        };
        let command = wheels_mm_s.map(|speed| wheel_command(&self.robot, speed));
        let (before, mut taken) = (felt(&self.run), 0);
        while taken < most && felt(&self.run) == before && self.take(command) {
            watch(&self.run);
            taken += 1;
        }
        self.tell(command);
        taken
    }

    /// Ends the program here; the robot brakes until it is at rest.
    pub fn finish(&mut self, end: LogEnd) {
        self.finish_within(end, u64::MAX, |_| ());
    }

    /// The same for at most `most` steps; `watch` sees the run after each.
    pub fn finish_within(&mut self, end: LogEnd, most: u64, mut watch: impl FnMut(&Run)) {
        self.log.get_mut().finish(end);
        for _ in 0..most.min(COAST) {
            self.apply_inputs();
            if self.run.is_finished() {
                break;
            }
            self.run.step();
            watch(&self.run);
            self.senses.take(self.run.sensors());
        }
        self.tell([0; 2]);
    }

    /// Replaces a person's inputs. Those before the present step must be the same: go back first.
    pub fn set_inputs(&mut self, inputs: Vec<(u64, Input)>) {
        let now = self.run.steps();
        self.inputs = inputs;
        self.applied = self.inputs.partition_point(|&(step, _)| step < now);
    }

    /// The present state, to come back to.
    pub fn frame(&self) -> LockstepFrame {
        LockstepFrame { run: self.run.clone(), senses: self.senses.clone() }
    }

    /// Goes back to `frame`; the log after it is forgotten.
    pub fn restore(&mut self, frame: &LockstepFrame) {
        self.run = frame.run.clone();
        self.senses.restore(&frame.senses);
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
}

impl LockstepFrame {
    /// Steps taken.
    pub fn steps(&self) -> u64 {
        self.run.steps()
    }

    /// Approximate memory, bytes.
    pub fn bytes(&self) -> usize {
        self.run.bytes() + size_of_val(self.senses.numbers())
    }
}
