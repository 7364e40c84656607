//! `drive`: a user's program or a behaviour drives a real robot on a serial port, or a virtual one.
//!
//! Neither ever has the line. The driver has it: it drives in Safe mode, limits the speeds, and stops the wheels when
//! they aren't renewed for 200 ms, as when the program misses a step.

mod pilot;

use super::{bridge::cannot_open, failure::Failure, output::say, signals::end_requested, simulate::parse_seconds};
use pilot::{SerialPilot, WantedMotion};
use robovac_core::robot::{RobotModel, model};
use robovac_link::{
    driver::{CLEANING_MOTORS, Driver, LineRequest},
    sensors::to_sensors,
};
use roomba_oi::{Command, Mode};
use serialport::{ClearBuffer, SerialPort};
use std::{
    io::{self, ErrorKind, Write},
    path::PathBuf,
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
    time::{Duration, Instant},
};

/// Baud rate that every connection begins with.
const BAUD: u32 = 115_200;
/// Time that a read waits for bytes, and interval of the driver's ticks.
const LOOK: Duration = Duration::from_millis(5);
/// Time for identifying the robot and for taking control, s.
const PATIENCE_S: f64 = 20.0;
/// Time in which a robot stops and is released, s.
const FAREWELL_S: f64 = 0.3;
/// The robot that can be connected.
const ROBOT: &str = "roomba600";

/// Let your own program, or a behaviour, drive a robot on a serial port, in Safe mode. Clear the way, and stay beside the robot
#[derive(clap::Args)]
pub struct Arguments {
    /// Your program: a file that ends in .py (run by python3) or .js (by node), or any with --command
    #[arg(required_unless_present = "behaviour", conflicts_with = "behaviour")]
    program: Option<PathBuf>,
    /// Behaviour that drives instead of a program, see "robovac behaviours"
    #[arg(long, value_name = "ID", conflicts_with_all = ["command", "memory"])]
    behaviour: Option<String>,
    /// Serial port, such as /dev/ttyUSB0 or COM3; "robovac monitor list" lists the ports
    #[arg(long, value_name = "PORT")]
    port: String,
    /// What runs the program, which gets the file as its last argument
    #[arg(long, value_name = "COMMAND")]
    command: Option<String>,
    /// Highest speed of a wheel, m/s
    #[arg(long, value_name = "M/S", default_value_t = 0.3, value_parser = parse_speed)]
    speed: f64,
    /// Main brush, side brush and vacuum [default: on for a behaviour that cleans, otherwise off]
    #[arg(long, value_name = "on|off", value_parser = ["on", "off"])]
    brushes: Option<String>,
    /// Seconds to drive [default: until the program is done, or Ctrl-C]
    #[arg(long, value_name = "S", value_parser = parse_seconds, allow_hyphen_values = true)]
    seconds: Option<f64>,
    /// Random seed of the program or behaviour
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Memory that the program may use
    #[arg(long, value_name = "MB", default_value_t = 1024, value_parser = clap::value_parser!(u64).range(32..=1_000_000))]
    memory: u64,
}

/// The robot's end.
struct RobotLine<'a> {
    driver: Driver,
    port: Box<dyn SerialPort>,
    name: &'a str,
    began: Instant,
    end: Arc<AtomicBool>,
}

pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let robot = model(ROBOT).ok_or_else(|| Failure::unknown("robot", ROBOT, "robots"))?;
    let robot = RobotModel { max_wheel_speed: arguments.speed, ..robot.clone() };
    let end = end_requested()?;
    // The pilot first: one with a fault must not touch the robot.
    let mut pilot = SerialPilot::new(arguments, &robot, &end)?;
    let mut line = RobotLine::open(&arguments.port, Arc::clone(&end))?;
    let driven = line.drive(arguments, &robot, &mut pilot);
    // In every case the robot is stopped and released, and the program ended.
    let released = line.release();
    end.store(true, Ordering::Relaxed);
    pilot.finish();
    let said = driven?;
    released?;
    Ok(said)
}

impl<'a> RobotLine<'a> {
    fn open(name: &'a str, end: Arc<AtomicBool>) -> Result<Self, Failure> {
        let port = serialport::new(name, BAUD).timeout(LOOK).open().map_err(|e| cannot_open(name, &e))?;
        let mut line = Self { driver: Driver::new(), port, name, began: Instant::now(), end };
        // Opening can have pulled the wake-up wire low: release it.
        let port = &mut line.port;
        let _ =
            (port.write_request_to_send(false), port.write_data_terminal_ready(false), port.clear(ClearBuffer::Input));
        line.driver.open(0.0);
        Ok(line)
    }

    fn now(&self) -> f64 {
        self.began.elapsed().as_secs_f64()
    }

    /// Identifies the robot, takes control, and lets the program drive.
    fn drive(&mut self, arguments: &Arguments, robot: &RobotModel, pilot: &mut SerialPilot) -> Result<String, Failure> {
        self.until(|driver| driver.readings().is_some())?;
        let now = self.now();
        self.driver.put_in(now, Mode::Safe);
        self.until(Driver::is_armed)?;
        let brushes = arguments.brushes.as_ref().map_or(pilot.cleans(), |switch| switch == "on");
        if brushes {
            let sent = self.driver.send(now, Command::Motors(CLEANING_MOTORS));
            sent.map_err(|refusal| Failure::system(refusal.to_string()))?;
        }
        let told = if brushes { ", brushes and vacuum on" } else { "" };
        say(&format!("{now:8.2} s  in Safe mode, at most {} m/s{told}; Ctrl-C stops the robot", arguments.speed));
        let began = self.now();
        loop {
            let since = self.turn()?;
            let now = self.now();
            let is_over = arguments.seconds.is_some_and(|seconds| now - began >= seconds);
            if is_over || self.end.load(Ordering::Relaxed) {
                return Ok(format!("{now:8.2} s  stopped\n"));
            }
            if !self.driver.is_armed() {
                let why = self.driver.dropped().map(|loss| format!("{loss} {}", loss.remedy()));
                return Err(Failure::system(why.unwrap_or_else(|| "the connection was lost".to_owned())));
            }
            let mut wish = WantedMotion::Nothing;
            if let Some(dt_s) = since
                && let Some(readings) = self.driver.readings()
            {
                wish = pilot.sense(robot, &to_sensors(readings), dt_s);
            }
            if matches!(wish, WantedMotion::Nothing) {
                wish = pilot.answer(robot, now, began)?;
            }
            match wish {
                WantedMotion::Done => return Ok(format!("{now:8.2} s  done\n")),
                // It holds for 200 ms unless it is renewed.
                WantedMotion::Drive(drive) => self.driver.drive(now, drive),
                WantedMotion::Nothing => {}
            }
        }
    }

    /// Exchanges bytes until `is_there` holds.
    fn until(&mut self, is_there: impl Fn(&Driver) -> bool) -> Result<(), Failure> {
        let began = self.now();
        while !is_there(&self.driver) {
            self.turn()?;
            if self.end.load(Ordering::Relaxed) {
                return Err(Failure::system("interrupted".to_owned()));
            }
            if self.now() > began + PATIENCE_S {
                let finding = self.driver.diagnosis().finding;
                let remedy = self.driver.dropped().map_or(finding.remedy(), |lost| lost.remedy());
                return Err(Failure::system(format!("{}: {} {remedy}", self.name, finding.text())));
            }
        }
        Ok(())
    }

    /// Sends and receives once. Returns the seconds since the last reading if there is a new one.
    fn turn(&mut self) -> Result<Option<f64>, Failure> {
        let name = self.name;
        self.exchange().map_err(|error| Failure::io(name, &error))
    }

    fn exchange(&mut self) -> io::Result<Option<f64>> {
        let now = self.now();
        self.driver.tick(now);
        while let Some(request) = self.driver.take_line() {
            match request {
                LineRequest::Baud(baud) => self.port.set_baud_rate(baud)?,
                // A terminal without that wire is no reason to stop: the next thing is tried.
                LineRequest::Brc(is_low) => drop(self.port.write_request_to_send(is_low)),
                // For bridges only.
                LineRequest::Stop => {}
            }
        }
        self.port.write_all(&self.driver.take_tx())?;
        let mut buffer = [0; 4096];
        let count = match self.port.read(&mut buffer) {
            Ok(count) => count,
            Err(error) if matches!(error.kind(), ErrorKind::TimedOut | ErrorKind::Interrupted) => 0,
            Err(error) => return Err(error),
        };
        let (mut rest, now) = (buffer.get(..count).unwrap_or_default(), self.now());
        let mut since: Option<f64> = None;
        while !rest.is_empty() {
            rest = rest.get(self.driver.feed(now, rest)..).unwrap_or_default();
            if let Some(dt_s) = self.driver.take_reading() {
                since = Some(since.unwrap_or(0.0) + dt_s);
            }
        }
        Ok(since)
    }

    /// Stops the robot and ends the interface.
    fn release(&mut self) -> Result<(), Failure> {
        let now = self.now();
        self.driver.halt(now);
        while self.now() < now + FAREWELL_S {
            self.turn()?;
        }
        let now = self.now();
        self.driver.leave(now);
        self.turn().map(drop)
    }
}

fn parse_speed(text: &str) -> Result<f64, String> {
    let speed = text.parse().ok().filter(|speed| (0.02..=0.5).contains(speed));
    speed.ok_or_else(|| "give a speed from 0.02 to 0.5 (m/s), e.g. 0.2".to_owned())
}
