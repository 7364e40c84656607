//! `virtual-roomba`: a simulated Roomba on a serial line, in real time, for any Roomba software.

mod control;
mod diary;
mod floor;
mod line;
#[cfg(unix)]
mod pty;
mod tcp;

use super::{failure::Failure, signals::end_requested};
use clap::builder::PossibleValuesParser;
use control::{Control, Order};
use diary::Diary;
use line::{HostLine, StandardStreams};
use robovac_core::{floor_plan::ScenarioPose, geometry::Pose};
use robovac_link::emulator::{Emulator, PERSONALITIES, personality};
use robovac_sim::{Conditions, Input};
use serde::Serialize;
use std::{
    io::Write,
    path::PathBuf,
    sync::atomic::{AtomicBool, Ordering},
    thread,
    time::{Duration, Instant},
};

/// Time between two looks at the line: less than a byte at 4800 baud, a seventh of the robot's own refresh.
const LOOK: Duration = Duration::from_millis(2);
/// Time for which it still sends when a host has said all that it will and has its answers.
const LAST_WORDS: Duration = Duration::from_millis(250);
/// Longest time that is made up for after the machine was busy or asleep.
const MOST_LAG: Duration = Duration::from_secs(2);

/// Simulate a Roomba on a serial line, for any Roomba software. Prints "ready" and the address once it listens
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    end: ProgramEnd,
    #[command(flatten)]
    floor: floor::FloorArguments,
    /// Personality, see "robovac personalities"
    #[arg(long, value_name = "ID", default_value = "model", value_parser = personalities())]
    personality: String,
    /// Random seed
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    /// Initial battery charge, percent
    #[arg(long, value_name = "PERCENT", default_value_t = 80, value_parser = clap::value_parser!(u8).range(0..=100))]
    charge: u8,
    /// Round wheel speeds to the steps of a Create 2's motor controller
    #[arg(long)]
    quantised: bool,
    /// Baud rate of the host, for --tcp and --stdio; a pseudo-terminal has its own
    #[arg(long, value_name = "N", default_value_t = 115_200, value_parser = clap::value_parser!(u32).range(300..=3_000_000))]
    baud: u32,
    /// Read control commands from standard input, one per line: press clean (spot, dock), lift, drop, plug, unplug,
    /// unplug-line, replug-line, brc low, brc high, state, quit. End of input means quit
    #[arg(long, conflicts_with = "stdio")]
    control: bool,
    /// Log every received command and every wheel change to this file: seconds since ready, clock in milliseconds,
    /// event
    #[arg(long, value_name = "FILE")]
    log: Option<PathBuf>,
}

/// One of the three must be given.
#[derive(clap::Args)]
#[group(required = true, multiple = false)]
struct ProgramEnd {
    /// Pseudo-terminal; LINK is a symbolic link to it. What the robot sends while no program has it open is lost
    #[arg(long, value_name = "LINK")]
    pty: Option<PathBuf>,
    /// Standard input and output; messages go to standard error
    #[arg(long)]
    stdio: bool,
    /// TCP port, such as 127.0.0.1:4000, carrying raw bytes; one client at a time. A client that has closed its half of the
    /// connection still gets its answers
    #[arg(long, value_name = "ADDR")]
    tcp: Option<String>,
}

/// Output of `state`.
#[expect(clippy::struct_excessive_bools)]
#[derive(Serialize)]
struct ProgramState {
    /// Since ready, s.
    time_s: f64,
    /// Whether a program has the line open.
    connected: bool,
    /// Where it really is.
    pose: ScenarioPose,
    mode: String,
    awake: bool,
    /// Whether it cleans or looks for its dock by itself.
    runs_builtin_program: bool,
    lifted: bool,
    fallen: bool,
    bumped: bool,
    baud: u32,
    /// Wheel speeds commanded by the host, and actual ones, mm/s.
    asked: WheelState,
    speed: WheelState,
    /// When the last motion command arrived that the robot obeyed, s since ready.
    last_motion_s: Option<f64>,
    /// Commands that arrived.
    commands: u64,
}

#[derive(Serialize, PartialEq, Clone, Copy)]
struct WheelState {
    left: f64,
    right: f64,
}

fn personalities() -> PossibleValuesParser {
    PossibleValuesParser::new(PERSONALITIES.iter().map(|who| who.id))
}

pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let who = personality(&arguments.personality)
        .ok_or_else(|| Failure::unknown("personality", &arguments.personality, "personalities"))?;
    let conditions =
        Conditions { quantised: arguments.quantised, start_charge_percent: arguments.charge, ..Conditions::default() };
    let robot = Emulator::new(&arguments.floor.setup(conditions, arguments.seed)?, who);
    let is_over = end_requested()?;
    let diary = Diary::create(arguments.log.as_deref())?;
    let line = arguments.end.open(arguments.baud)?;
    let control = Control::new(arguments.control);
    let mut messages: Box<dyn Write> =
        if arguments.end.stdio { Box::new(std::io::stderr()) } else { Box::new(std::io::stdout()) };
    tell(&mut messages, format_args!("ready {}", line.name()));
    Host { robot, line, control, diary, messages, last_motion_s: None, commands: 0, was: None }.run(&is_over)?;
    Ok(String::new())
}

impl ProgramEnd {
    fn open(&self, baud: u32) -> Result<Box<dyn HostLine>, Failure> {
        match (&self.pty, &self.tcp) {
            #[cfg(unix)]
            (Some(link), _) => Ok(Box::new(pty::Pty::open(link)?)),
            #[cfg(not(unix))]
            (Some(_), _) => {
                Err(Failure::usage("this system has no pseudo-terminals; use --tcp ADDR or --stdio instead".to_owned()))
            }
            (None, Some(address)) => Ok(Box::new(tcp::TcpLine::listen(address, baud)?)),
            (None, None) => Ok(Box::new(StandardStreams::new(baud))),
        }
    }
}

/// Writes a line; ignores errors, as there is nowhere to report them.
fn tell(to: &mut dyn Write, text: std::fmt::Arguments<'_>) {
    let _ = writeln!(to, "{text}").and_then(|()| to.flush());
}

/// The robot on its line.
struct Host {
    robot: Emulator,
    line: Box<dyn HostLine>,
    control: Control,
    diary: Diary,
    messages: Box<dyn Write>,
    last_motion_s: Option<f64>,
    commands: u64,
    /// The last commanded wheel speeds, and whether the wheels turned.
    was: Option<(WheelState, bool)>,
}

impl Host {
    fn run(mut self, is_over: &AtomicBool) -> Result<(), Failure> {
        let mut last = Instant::now();
        let (mut incoming, mut outgoing, mut said_all) = (Vec::new(), Vec::new(), None);
        // Starts to record received commands.
        self.robot.take_heard();
        while !is_over.load(Ordering::Relaxed) {
            let now = Instant::now();
            self.robot.advance((now - last).min(MOST_LAG).as_secs_f64());
            last = now;
            self.write_down();
            while let Some(order) = self.control.next() {
                match order {
                    Ok(Order::Quit) => return Ok(()),
                    Ok(order) => self.obey(order)?,
                    Err(why) => tell(&mut self.messages, format_args!("error {why}")),
                }
            }
            let baud = self.line.baud();
            outgoing.clear();
            self.robot.transmit(baud, &mut outgoing);
            self.line.write(&outgoing)?;
            incoming.clear();
            let room = self.robot.room(baud);
            if room == 0 || self.line.read(room, &mut incoming)? || self.robot.is_answering() {
                said_all = None;
            } else if now - *said_all.get_or_insert(now) > LAST_WORDS && !self.line.next_host() {
                return Ok(());
            }
            self.robot.receive(&incoming, baud);
            thread::sleep(LOOK);
        }
        Ok(())
    }

    fn obey(&mut self, order: Order) -> Result<(), Failure> {
        match order {
            Order::Press(buttons) => self.robot.press(buttons),
            Order::Lift => self.robot.apply(Input::Lift),
            Order::Drop => {
                let pose = self.robot.pose();
                self.robot.apply(Input::PutDown(Pose::new(pose.x, pose.y, pose.heading)));
            }
            Order::Plug(is_plugged) => self.robot.plug_charger(is_plugged),
            Order::Brc(is_low) => self.robot.set_brc(is_low),
            Order::Cable(is_plugged) => {
                if !self.line.plug(is_plugged)? {
                    tell(&mut self.messages, format_args!("error only a --pty line can be unplugged"));
                }
            }
            Order::State => {
                let state = serde_json::to_string(&self.state()).unwrap_or_default();
                tell(&mut self.messages, format_args!("{state}"));
            }
            Order::Quit => {}
        }
        Ok(())
    }

    /// Logs received commands and changes of the wheels.
    fn write_down(&mut self) {
        for heard in self.robot.take_heard() {
            self.commands += 1;
            if heard.was_obeyed && diary::moves(&heard.bytes) {
                self.last_motion_s = Some(heard.time_s);
            }
            self.diary.command(&heard);
        }
        let (time_s, (asked, speed)) = (self.robot.time_s(), self.wheels());
        let is = (asked, speed.left != 0.0 || speed.right != 0.0);
        if self.was != Some(is) {
            self.was = Some(is);
            let (moves, WheelState { left, right }) = (if is.1 { "turning" } else { "at rest" }, asked);
            self.diary.note(time_s, format_args!("wheels commanded left {left:.0} right {right:.0} mm/s, {moves}"));
        }
    }

    fn wheels(&self) -> (WheelState, WheelState) {
        let (asked, speed) = (self.robot.asked_speeds(), self.robot.robot().speed());
        let asked = WheelState { left: asked.left, right: asked.right };
        (asked, WheelState { left: 1000.0 * speed.left, right: 1000.0 * speed.right })
    }

    fn state(&self) -> ProgramState {
        let (robot, (asked, speed)) = (&self.robot, self.wheels());
        ProgramState {
            time_s: robot.time_s(),
            connected: self.line.has_host(),
            pose: robot.pose().into(),
            mode: robot.mode().to_string(),
            awake: robot.is_awake(),
            runs_builtin_program: robot.runs_builtin_program(),
            lifted: robot.robot().is_lifted(),
            fallen: robot.robot().has_fallen(),
            bumped: robot.sensors().bumped(),
            baud: robot.baud(),
            asked,
            speed,
            last_motion_s: self.last_motion_s,
            commands: self.commands,
        }
    }
}
