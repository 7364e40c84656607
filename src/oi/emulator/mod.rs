//! A Roomba on the other end of the line: the simulated robot behind Open Interface bytes.
//!
//! It has no clock and does no I/O: whoever has it says how much time passes, brings bytes and takes bytes.

mod personality;

pub use personality::{PERSONALITIES, Personality, personality};

use super::{
    Mode,
    bits::{Buttons, Lamps, Motors, ScheduleLamps, Weekdays},
    command::Note,
};
use crate::{
    geometry::Pose,
    robot::{RobotPort, Sensors},
    sim::{Input, Life, RunSetup, SimRobot, World},
};
use std::sync::Arc;

/// A robot that speaks the Open Interface.
pub struct Emulator {
    robot: SimRobot,
    life: Life,
    world: Arc<World>,
}

/// What can be seen and heard of it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Display {
    /// Lights around the Clean button.
    pub lamps: Lamps,
    /// Colour of the Clean button, 0 green to 255 red, and its brightness, 0 to 255.
    pub clean_light: [u8; 2],
    /// The four digits.
    pub digits: [u8; 4],
    /// Lights of the weekdays.
    pub weekdays: Weekdays,
    /// Lights of the schedule.
    pub schedule: ScheduleLamps,
    /// Brushes and vacuum that run.
    pub motors: Motors,
    /// Songs and beeps that began to sound since this was last asked for, one after the other.
    pub tunes: Vec<Vec<Note>>,
}

impl Emulator {
    /// A robot at the start of a floor.
    pub fn new(setup: &RunSetup, _: &Personality) -> Self {
        let world = Arc::clone(&setup.world);
        let life = Life::new(&world, &setup.floor, setup.seed);
        let robot = SimRobot::new(&setup.robot, setup.floor.start, setup.conditions, setup.seed);
        Self { robot, life, world }
    }

    /// Takes bytes as they arrive at the robot's receiver, from a host that sends at `baud`.
    pub fn receive(&mut self, _: &[u8], _: u32) {}

    /// Pulls the BRC wire low, or lets it go.
    pub fn set_brc(&mut self, _: bool) {}

    /// Presses buttons on the robot for a moment.
    pub fn press(&mut self, _: Buttons) {}

    /// Plugs a charger into the robot's jack, or pulls it out.
    pub fn plug_charger(&mut self, _: bool) {}

    /// Lets a hand pick it up or put it down. Commands of a joystick are for controllers and ignored here.
    pub fn apply(&mut self, _: Input) {}

    /// Lets time pass.
    pub fn advance(&mut self, _: f64) {}

    /// Appends what it has sent by now to `out`, as a host hears it that listens at `baud`.
    pub fn transmit(&mut self, _: u32, _: &mut Vec<u8>) {}

    /// Its mode.
    pub fn mode(&self) -> Mode {
        Mode::Off
    }

    /// Whether it listens at all.
    pub fn is_awake(&self) -> bool {
        true
    }

    /// Where it really is.
    pub fn pose(&self) -> Pose {
        self.robot.pose()
    }

    /// Its body and wheels.
    pub fn robot(&self) -> &SimRobot {
        &self.robot
    }

    /// What it really senses, whatever it says.
    pub fn sensors(&self) -> &Sensors {
        self.robot.sensors()
    }

    /// What moves and is used up around it.
    pub fn life(&self) -> &Life {
        &self.life
    }

    /// What is around it.
    pub fn world(&self) -> &Arc<World> {
        &self.world
    }

    /// What it shows; takes the tunes.
    pub fn take_display(&mut self) -> Display {
        Display::default()
    }
}
