//! Who drives a robot on a serial port: a user's program, or a behaviour.

use super::Arguments;
use crate::{
    failure::Failure,
    output::say,
    run::{Language, ProgramProcess, Reply, WaitFor, Words, hello},
    simulate::autonomous,
};
use robovac_core::{
    geometry::Pose,
    registry::Params,
    robot::{Drive, RobotModel, SensorReadings},
};
use robovac_sim::{
    controller::{Controller, Setup},
    program::{ProgramSenses, RobotFacts, readings_json, wheel_command},
};
use std::{
    path::Path,
    sync::{
        Arc,
        atomic::AtomicBool,
        mpsc::{Receiver, Sender, channel},
    },
    thread::{self, JoinHandle},
};

/// Who drives.
pub enum SerialPilot {
    Program(Box<ProgramPilot>),
    Behaviour { controller: Box<dyn Controller>, cleans: bool },
}

/// What a pilot wants.
pub enum WantedMotion {
    /// No new speeds: those before go on for 200 ms.
    Nothing,
    Drive(Drive),
    Done,
}

/// The program in a thread of its own: a slow one must not delay the driver.
pub struct ProgramPilot {
    name: String,
    lines: Sender<String>,
    answers: Receiver<Result<Reply, String>>,
    thread: JoinHandle<()>,
    /// Whether an answer is on its way.
    is_asked: bool,
    senses: Option<ProgramSenses>,
}

/// The behaviour with that id and its own parameters. It drives no faster than the robot's wheels may turn.
fn behaviour(id: &str, robot: &RobotModel, seed: u64) -> Result<SerialPilot, Failure> {
    let info = autonomous(id)?;
    let speed = robot.cruise_speed.min(robot.max_wheel_speed);
    let robot =
        RobotModel { cruise_speed: speed, turn_wheel_speed: robot.turn_wheel_speed.min(speed), ..robot.clone() };
    let params = Params::defaults(info.params);
    let controller = info
        .build(&Setup { robot: &robot, params: &params, seed })
        .ok_or_else(|| Failure::unknown("behaviour", id, "behaviours"))?;
    Ok(SerialPilot::Behaviour { controller, cleans: info.claims.cleans })
}

impl SerialPilot {
    /// The program or the behaviour that is to drive, ready to do so.
    pub fn new(arguments: &Arguments, robot: &RobotModel, end: &Arc<AtomicBool>) -> Result<Self, Failure> {
        if let Some(program) = &arguments.program {
            return Ok(Self::Program(Box::new(ProgramPilot::start(program, arguments, robot, end)?)));
        }
        let id = arguments.behaviour.as_deref().unwrap_or_default();
        behaviour(id, robot, arguments.seed)
    }

    /// Whether it is a behaviour that cleans.
    pub fn cleans(&self) -> bool {
        matches!(self, Self::Behaviour { cleans: true, .. })
    }

    /// Takes a reading, `dt_s` seconds after the last one.
    pub fn sense(&mut self, robot: &RobotModel, sensed: &SensorReadings, dt_s: f64) -> WantedMotion {
        match self {
            Self::Program(program) => {
                program.sense(robot, sensed);
                WantedMotion::Nothing
            }
            Self::Behaviour { controller, .. } => {
                let Drive { left, right, .. } = controller.step(sensed, dt_s);
                if controller.is_done() {
                    return WantedMotion::Done;
                }
                // Both wheels are slowed alike, so that the way keeps its curvature.
                let most = left.abs().max(right.abs());
                let share = if most > robot.max_wheel_speed { robot.max_wheel_speed / most } else { 1.0 };
                WantedMotion::Drive(Drive::wheels(share * left, share * right))
            }
        }
    }

    /// The answer to an earlier reading, if it is there by `now`; it has driven since `began`.
    pub fn answer(&mut self, robot: &RobotModel, now: f64, began: f64) -> Result<WantedMotion, Failure> {
        match self {
            Self::Program(program) => program.answer(robot, now, began),
            Self::Behaviour { .. } => Ok(WantedMotion::Nothing),
        }
    }

    /// Waits until a program has ended.
    pub fn finish(self) {
        if let Self::Program(program) = self {
            program.finish();
        }
    }
}

impl ProgramPilot {
    fn start(
        program: &Path,
        arguments: &Arguments,
        robot: &RobotModel,
        end: &Arc<AtomicBool>,
    ) -> Result<Self, Failure> {
        let name = program.display().to_string();
        std::fs::metadata(program).map_err(|error| Failure::io(program.display(), &error))?;
        let language = Language::of(program, arguments.command.as_deref())?;
        let fault = |fault: String| Failure::planner(format!("{name}: {fault}"));
        let mut process =
            ProgramProcess::start(language.command(), arguments.memory, Arc::clone(end)).map_err(fault)?;
        let greeting = hello(&RobotFacts::of(robot), arguments.seed, false);
        let ready = process.ask(&greeting, WaitFor::Start).map_err(fault)?.ready;
        if ready.as_deref() != Some("behaviour") {
            return Err(fault("only a behaviour drives a robot; a planner needs the grid of a room".to_owned()));
        }
        let (lines, asked) = channel::<String>();
        let (answer, answers) = channel();
        let thread = thread::spawn(move || {
            while let Ok(line) = asked.recv() {
                let reply = process.ask(&line, WaitFor::Step);
                let is_over = reply.is_err();
                if answer.send(reply).is_err() || is_over {
                    break;
                }
            }
        });
        Ok(Self { name, lines, answers, thread, is_asked: false, senses: None })
    }

    fn sense(&mut self, robot: &RobotModel, sensed: &SensorReadings) {
        let start = Pose::new(0.0, 0.0, 0.0);
        let senses = self.senses.get_or_insert_with(|| ProgramSenses::new(robot, start, sensed));
        senses.take(sensed);
        if !self.is_asked {
            senses.write(sensed);
            self.is_asked = self.lines.send(readings_json(senses.numbers(), false)).is_ok();
        }
    }

    fn answer(&mut self, robot: &RobotModel, now: f64, began: f64) -> Result<WantedMotion, Failure> {
        let Ok(answer) = self.answers.try_recv() else { return Ok(WantedMotion::Nothing) };
        self.is_asked = false;
        let reply =
            answer.map_err(|fault| Failure::planner(format!("{}, at {:.2} s: {fault}", self.name, now - began)))?;
        for text in &reply.print {
            say(&format!("{now:8.2} s  {}", Words::of(text.as_bytes())));
        }
        if reply.done {
            return Ok(WantedMotion::Done);
        }
        let wheels = [reply.left, reply.right].map(|speed| wheel_command(robot, speed.unwrap_or(0.0)));
        let [left, right] = wheels.map(|speed| f64::from(speed) / 1000.0);
        if let Some(senses) = &mut self.senses {
            senses.command(wheels);
        }
        Ok(WantedMotion::Drive(Drive::wheels(left, right)))
    }

    /// Waits until the program has ended.
    fn finish(self) {
        drop(self.lines);
        let _ = self.thread.join();
    }
}
