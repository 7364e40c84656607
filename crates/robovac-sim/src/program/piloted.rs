//! The controller that asks a program elsewhere: for a robot that doesn't wait.

use super::{ProgramSenses, wheel_command};
use crate::controller::Controller;
use robovac_core::{
    geometry::Pose,
    robot::{Drive, RobotModel, SensorReadings},
};
use std::{cell::RefCell, rc::Rc};

/// Steps of 15 ms that an answer holds for: 200 ms, as the driver's commands do. Then the robot is stopped.
const HOLD: u64 = 13;
/// Steps that the first answer is waited for; the robot stands meanwhile.
const FIRST: u64 = 200;

/// What goes to and fro between a [`Piloted`] robot and its program.
#[derive(Debug, Clone, Default)]
pub struct RemotePilot(Rc<RefCell<Mailbox>>);

#[derive(Debug, Default)]
struct Mailbox {
    /// The latest readings, unless they were taken.
    asked: Option<Vec<f64>>,
    /// Steps when the last answer came, and what it was.
    answered: Option<(u64, [f64; 2])>,
    /// Steps so far.
    steps: u64,
    is_done: bool,
    has_missed: bool,
}

impl RemotePilot {
    /// The latest readings, as [`SLOTS`](super::SLOTS) lists them, once.
    pub fn take_readings(&self) -> Option<Vec<f64>> {
        self.0.borrow_mut().asked.take()
    }

    /// The program's answer: speeds of the left and the right wheel, mm/s; `None` if it is done.
    pub fn answer(&self, wheels_mm_s: Option<[f64; 2]>) {
        let mut exchange = self.0.borrow_mut();
        match wheels_mm_s {
            Some(wheels) => exchange.answered = Some((exchange.steps, wheels)),
            None => exchange.is_done = true,
        }
    }

    /// Whether the robot was stopped because answers failed to come.
    pub fn has_missed(&self) -> bool {
        self.0.borrow().has_missed
    }
}

/// Drives as a program elsewhere answers to the readings of each step. An answer holds for 200 ms; without another the
/// robot is stopped for good.
pub struct Piloted {
    pilot: RemotePilot,
    senses: ProgramSenses,
    robot: RobotModel,
    is_first: bool,
}

impl Piloted {
    /// A `robot` that stands at `start`.
    pub fn new(pilot: RemotePilot, robot: &RobotModel, start: Pose) -> Self {
        let senses = ProgramSenses::new(robot, start, &SensorReadings::default());
        Self { pilot, senses, robot: robot.clone(), is_first: true }
    }
}

impl Controller for Piloted {
    fn step(&mut self, sensed: &SensorReadings, _: f64) -> Drive {
        if !std::mem::take(&mut self.is_first) {
            self.senses.take(sensed);
        }
        self.senses.write(sensed);
        let mut exchange = self.pilot.0.borrow_mut();
        exchange.asked = Some(self.senses.numbers().to_vec());
        exchange.steps += 1;
        let (last, patience) = exchange.answered.map_or((0, FIRST), |(step, _)| (step, HOLD));
        if exchange.steps > last + patience && !exchange.is_done {
            (exchange.is_done, exchange.has_missed) = (true, true);
        }
        let wheels = match exchange.answered {
            Some((_, wheels)) if !exchange.is_done => wheels.map(|speed| wheel_command(&self.robot, speed)),
            _ => [0; 2],
        };
        self.senses.command(wheels);
        let [left, right] = wheels.map(|speed| f64::from(speed) / 1000.0);
        Drive::wheels(left, right)
    }

    fn is_done(&self) -> bool {
        self.pilot.0.borrow().is_done
    }

    fn activity(&self) -> &'static str {
        if self.pilot.has_missed() {
            "stopped: its program didn't answer within 200 ms; the computer may be busy"
        } else {
            "following its program"
        }
    }

    fn boxed_clone(&self) -> Box<dyn Controller> {
        Box::new(Self {
            pilot: self.pilot.clone(),
            senses: self.senses.clone(),
            robot: self.robot.clone(),
            is_first: self.is_first,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::model;

    fn piloted() -> (RemotePilot, Piloted) {
        let pilot = RemotePilot::default();
        (pilot.clone(), Piloted::new(pilot, model("roomba600").unwrap(), Pose::new(1.0, 2.0, 0.0)))
    }

    #[test]
    fn an_answer_drives_until_the_next_and_is_limited() {
        let (pilot, mut robot) = piloted();
        let sensed = SensorReadings::default();
        assert_eq!(robot.step(&sensed, 0.015), Drive::STOP, "nothing was answered yet");
        let readings = pilot.take_readings().unwrap();
        assert_eq!((readings[2], readings[3]), (1.0, 2.0));
        assert!(pilot.take_readings().is_none());
        pilot.answer(Some([200.4, -9000.0]));
        assert_eq!(robot.step(&sensed, 0.015), Drive::wheels(0.2, -0.5));
        assert_eq!(pilot.take_readings().unwrap()[0], 1.0);
        pilot.answer(None);
        assert_eq!((robot.step(&sensed, 0.015), robot.is_done()), (Drive::STOP, true));
        assert!(!pilot.has_missed());
    }

    #[test]
    fn a_program_that_no_longer_answers_is_stopped_after_200_ms() {
        let (pilot, mut robot) = piloted();
        let sensed = SensorReadings::default();
        robot.step(&sensed, 0.015);
        pilot.answer(Some([200.0, 200.0]));
        let driven = (0..100).take_while(|_| robot.step(&sensed, 0.015) != Drive::STOP).count();
        assert_eq!(driven as u64, HOLD);
        assert!(robot.is_done() && pilot.has_missed());
        pilot.answer(Some([200.0, 200.0]));
        assert_eq!(robot.step(&sensed, 0.015), Drive::STOP, "a late answer doesn't start it again");
    }
}
