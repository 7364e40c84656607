//! Roomba emulator: a simulated robot behind the Open Interface.
//!
//! It has no clock and does no I/O: the caller passes the elapsed time and moves the bytes. Transmission takes time: a
//! byte reaches the robot after its time on the line, and an answer is sent at the next refresh of the readings, every
//! 15 ms, byte by byte. So [`Emulator::receive`] has no effect before [`Emulator::advance`].
//!
//! The same seed and the same calls give the same bytes, natively and in the browser, however time is divided. The
//! source is the specification of 2016 and the project's fact sheet; undocumented details are decided in the respective
//! file: [modes and commands](Command), sleep, reset and BRC, the line, chargers, built-in programs. Deviations of real
//! robots are a [`Personality`].
//!
//! ```
//! use robovac_sim::{experiment::planning::{Placement, choose_robot}, Conditions};
//! use robovac_core::floor_plan::room;
//! use roomba_oi::Mode;
//! use robovac_link::emulator::{Emulator, personality};
//! let plan = (room("empty").unwrap().build)();
//! let (robot, cell_size) = choose_robot("roomba600", &plan, None).unwrap();
//! let prepared = Placement { plan, robot, cells: cell_size.into(), start: None, heading_deg: None }.prepare().unwrap();
//! let mut roomba = Emulator::new(&prepared.setup(Conditions::default(), 1), personality("model").unwrap());
//! // Start, Safe, then: which mode?
//! roomba.receive(&[128, 131, 142, 35], 115_200);
//! assert_eq!(roomba.mode(), Mode::Off);
//! roomba.advance(0.02);
//! assert_eq!(roomba.mode(), Mode::Safe);
//! let mut answer = Vec::new();
//! roomba.transmit(115_200, &mut answer);
//! assert_eq!(answer, [2]);
//! ```

mod builtin_program;
mod calendar;
mod charger;
mod clock;
mod commands;
mod lights;
mod line;
mod machine;
mod motion;
mod personality;
mod power;
mod report;
mod sound;
mod uart;
mod view;

pub use personality::{Banner, ChargingLogTimes, PERSONALITIES, Personality, personality};
pub use view::{PersonalityView, VirtualView};

use clock::{Nanos, SECOND};
use lights::Lights;
use machine::Machine;
use robovac_core::{
    geometry::Pose,
    robot::{RobotPort, SensorReadings},
};
use robovac_sim::{Input, Life, RunSetup, SimRobot, World};
use roomba_oi::{Buttons, CommandDecoder, Lamps, Mode, Motors, Note, ScheduleLamps, Weekdays, motion::WheelSpeeds};
use std::sync::Arc;

#[cfg(doc)]
use roomba_oi::Command;

/// Longest time advanced at once, s: a day.
const LONGEST: f64 = 86_400.0;
/// Most commands kept until they are fetched; the oldest are dropped first.
const MOST_HEARD: usize = 4096;

/// A robot that speaks the Open Interface.
pub struct Emulator {
    decoder: CommandDecoder,
    machine: Machine,
    /// Elapsed time beyond whole nanoseconds; negative if they were rounded up.
    rest: f64,
    heard: Option<Vec<ReceivedCommand>>,
}

/// Visible and audible state of the robot.
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
    /// Running brushes and vacuum.
    pub motors: Motors,
    /// Songs and beeps started since the last call, in order.
    pub tunes: Vec<Vec<Note>>,
}

/// A received command, or an invalid byte.
#[derive(Debug, Clone, PartialEq)]
pub struct ReceivedCommand {
    /// Arrival time of its last byte, s since the start.
    pub time_s: f64,
    /// Its bytes.
    pub bytes: Vec<u8>,
    /// Whether the robot executed it: its mode allowed it, and its values were valid.
    pub was_obeyed: bool,
}

impl Emulator {
    /// A robot at the start of a run.
    pub fn new(setup: &RunSetup, who: &Personality) -> Self {
        Self { decoder: CommandDecoder::default(), machine: Machine::new(setup, who), rest: 0.0, heard: None }
    }

    /// Takes bytes that a host starts to send now at `baud`, or after the earlier ones: see [`Self::room`].
    pub fn receive(&mut self, bytes: &[u8], baud: u32) {
        let machine = &mut self.machine;
        machine.line.receive(machine.now, bytes, baud);
    }

    /// Bytes that a host at `baud` should pass at most now. More are taken, but keep the line busy at that rate, whatever
    /// the host's next one is.
    pub fn room(&self, baud: u32) -> usize {
        self.machine.line.room(self.machine.now, baud)
    }

    /// Whether bytes from the host are still in transit, or answers to them. Frames of the stream aren't answers.
    pub fn is_answering(&self) -> bool {
        self.machine.is_answering()
    }

    /// Pulls the BRC wire low, or releases it.
    pub fn set_brc(&mut self, is_low: bool) {
        self.machine.set_brc(is_low);
    }

    /// Presses buttons of the robot for a moment.
    pub fn press(&mut self, buttons: Buttons) {
        self.machine.press(buttons);
    }

    /// Plugs a charger into the robot's jack, or unplugs it.
    pub fn plug_charger(&mut self, is_plugged: bool) {
        self.machine.charger.is_plugged = is_plugged;
    }

    /// Lifts the robot or puts it down. Joystick commands are for controllers and ignored here.
    pub fn apply(&mut self, input: Input) {
        self.machine.apply(input);
    }

    /// Advances the time, s; at most a day. Values that aren't positive are ignored.
    pub fn advance(&mut self, seconds: f64) {
        if seconds.is_nan() || seconds <= 0.0 {
            return;
        }
        let nanos = self.rest + seconds.min(LONGEST) * SECOND as f64;
        let whole = (nanos + 0.5) as Nanos;
        self.rest = nanos - whole as f64;
        let until = self.machine.now + whole;
        loop {
            let arrival = self.machine.line.next_arrival().unwrap_or(Nanos::MAX);
            let next = arrival.min(self.machine.next_step()).min(until);
            self.machine.now = self.machine.now.max(next);
            self.listen();
            if self.machine.next_step() <= next {
                self.machine.step();
            } else if next == until {
                break;
            }
        }
    }

    /// Processes the bytes received so far.
    fn listen(&mut self) {
        let machine = &mut self.machine;
        while let Some(byte) = machine.line.hear(machine.now) {
            if !machine.is_awake() {
                self.decoder.clear();
                continue;
            }
            let Some(received) = self.decoder.push(byte) else { continue };
            let was_obeyed = received.command.is_ok_and(|command| machine.obey(command));
            if let Some(heard) = &mut self.heard {
                if heard.len() == MOST_HEARD {
                    heard.remove(0);
                }
                let time_s = machine.now as f64 / SECOND as f64;
                heard.push(ReceivedCommand { time_s, bytes: received.bytes.to_vec(), was_obeyed });
            }
        }
        if !machine.is_awake() {
            self.decoder.clear();
        }
    }

    /// Appends the bytes sent so far to `out`, as received by a host at `baud`.
    pub fn transmit(&mut self, baud: u32, out: &mut Vec<u8>) {
        let machine = &mut self.machine;
        machine.line.transmit(machine.now, baud, out);
    }

    /// The commands received since the last call; recorded from the first call on.
    pub fn take_heard(&mut self) -> Vec<ReceivedCommand> {
        self.heard.replace(Vec::new()).unwrap_or_default()
    }

    /// Time since the start, s.
    pub fn time_s(&self) -> f64 {
        self.machine.now as f64 / SECOND as f64
    }

    /// Its mode.
    pub fn mode(&self) -> Mode {
        self.machine.mode
    }

    /// Whether it is awake.
    pub fn is_awake(&self) -> bool {
        self.machine.is_awake()
    }

    /// Its baud rate.
    pub fn baud(&self) -> u32 {
        self.machine.line.baud()
    }

    /// Wheel speeds commanded by the host at present; 0 in Off and Passive, where built-in programs drive.
    pub fn asked_speeds(&self) -> WheelSpeeds {
        self.machine.asked_speeds()
    }

    /// Whether a built-in program is running.
    pub fn runs_builtin_program(&self) -> bool {
        self.machine.builtin_program.as_ref().is_some_and(|builtin_program| !builtin_program.is_paused)
    }

    /// Its true pose.
    pub fn pose(&self) -> Pose {
        self.machine.robot.pose()
    }

    /// Its body and wheels.
    pub fn robot(&self) -> &SimRobot {
        &self.machine.robot
    }

    /// Its true sensor readings, whatever it reports.
    pub fn sensors(&self) -> &SensorReadings {
        self.machine.robot.sensors()
    }

    /// Moving and consumable objects around it.
    pub fn life(&self) -> &Life {
        &self.machine.life
    }

    /// What is around it.
    pub fn world(&self) -> &Arc<World> {
        &self.machine.world
    }

    /// Its display; takes the tunes.
    pub fn take_display(&mut self) -> Display {
        let machine = &mut self.machine;
        let tunes = core::mem::take(&mut machine.sound.tunes);
        let mut display = Display { motors: machine.running().motors(), tunes, ..Display::default() };
        let own = Lights::of(machine.condition());
        let lights = if machine.mode < Mode::Safe { &own } else { &machine.lights };
        lights.show(&mut display);
        display
    }
}
