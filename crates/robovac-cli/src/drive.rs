//! `drive`: a user's program or a behaviour drives a real robot on a serial port, or a virtual one.
//!
//! Neither ever has the line. The driver has it: it drives in Safe mode, limits the speeds, and stops the wheels when
//! they aren't renewed for 200 ms, as when the program misses a step.

use super::{
    bridge::cannot_open,
    failure::Failure,
    output::say,
    run::{Language, ProgramProcess, Reply, Task, Words, hello},
    signals::end_requested,
    simulate::parse_seconds,
};
use robovac_core::{
    geometry::Pose,
    registry::Params,
    robot::{Drive, RobotModel, SensorReadings, model},
};
use robovac_link::{
    driver::{Driver, LineRequest},
    sensors::to_sensors,
};
use robovac_sim::{
    controller::{self, Controller, Setup},
    program::{ProgramSenses, RobotFacts, readings_json, wheel_command},
};
use roomba_oi::Mode;
use serialport::{ClearBuffer, SerialPort};
use std::{
    io::{self, ErrorKind, Write},
    path::{Path, PathBuf},
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
        mpsc::{Receiver, Sender, channel},
    },
    thread::{self, JoinHandle},
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
    /// Behaviour that drives in its place, see "robovac behaviours"
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

/// Who drives.
enum Pilot {
    Program(Box<ProgramPilot>),
    Behaviour(Box<dyn Controller>),
}

/// What a pilot wants.
enum Wish {
    /// Speeds, or with `None` no new ones: those before go on for 200 ms.
    Drive(Option<Drive>),
    Done,
}

/// The program in a thread of its own: a slow one must not delay the driver.
struct ProgramPilot {
    name: String,
    lines: Sender<String>,
    answers: Receiver<Result<Reply, String>>,
    thread: JoinHandle<()>,
    /// Whether an answer is on its way.
    is_asked: bool,
    senses: Option<ProgramSenses>,
}

/// The robot's end.
struct Line<'a> {
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
    let mut pilot = match (&arguments.program, &arguments.behaviour) {
        (Some(program), _) => Pilot::Program(Box::new(ProgramPilot::start(program, arguments, &robot, &end)?)),
        (None, id) => Pilot::Behaviour(behaviour(id.as_deref().unwrap_or_default(), &robot, arguments.seed)?),
    };
    let mut line = Line::open(&arguments.port, Arc::clone(&end))?;
    let driven = line.drive(arguments, &robot, &mut pilot);
    // In every case the robot is stopped and released, and the program ended.
    let released = line.release();
    end.store(true, Ordering::Relaxed);
    if let Pilot::Program(program) = pilot {
        program.finish();
    }
    let said = driven?;
    released?;
    Ok(said)
}

/// The behaviour with that id and its own parameters. It drives no faster than the robot's wheels may turn.
fn behaviour(id: &str, robot: &RobotModel, seed: u64) -> Result<Box<dyn Controller>, Failure> {
    let info = controller::find(id).ok_or_else(|| Failure::unknown("behaviour", id, "behaviours"))?;
    if info.claims.manual {
        return Err(Failure::usage(format!("behaviour \"{id}\" is driven by hand; use it on the page")));
    }
    let speed = robot.cruise_speed.min(robot.max_wheel_speed);
    let robot =
        RobotModel { cruise_speed: speed, turn_wheel_speed: robot.turn_wheel_speed.min(speed), ..robot.clone() };
    let params = Params::defaults(info.params);
    info.build(&Setup { robot: &robot, params: &params, seed })
        .ok_or_else(|| Failure::unknown("behaviour", id, "behaviours"))
}

impl Pilot {
    /// Takes a reading, `dt_s` seconds after the last one.
    fn sense(&mut self, robot: &RobotModel, sensed: &SensorReadings, dt_s: f64) -> Wish {
        match self {
            Self::Program(program) => {
                program.sense(robot, sensed);
                Wish::Drive(None)
            }
            Self::Behaviour(controller) => {
                let Drive { left, right, .. } = controller.step(sensed, dt_s);
                if controller.is_done() {
                    return Wish::Done;
                }
                // As one of the pair may be limited, the other keeps its share, and with it the way's curvature.
                let most = left.abs().max(right.abs());
                let share = if most > robot.max_wheel_speed { robot.max_wheel_speed / most } else { 1.0 };
                Wish::Drive(Some(Drive::wheels(share * left, share * right)))
            }
        }
    }

    /// The answer to an earlier reading, if it is there by `now`; it has driven since `began`.
    fn answer(&mut self, robot: &RobotModel, now: f64, began: f64) -> Result<Wish, Failure> {
        match self {
            Self::Program(program) => program.answer(robot, now, began),
            Self::Behaviour(_) => Ok(Wish::Drive(None)),
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
        let ready = process.ask(&greeting, Task::Start).map_err(fault)?.ready;
        if ready.as_deref() != Some("behaviour") {
            return Err(fault("only a behaviour drives a robot; a planner needs the grid of a room".to_owned()));
        }
        let (lines, asked) = channel::<String>();
        let (answer, answers) = channel();
        let thread = thread::spawn(move || {
            while let Ok(line) = asked.recv() {
                let reply = process.ask(&line, Task::Step);
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

    fn answer(&mut self, robot: &RobotModel, now: f64, began: f64) -> Result<Wish, Failure> {
        let Ok(answer) = self.answers.try_recv() else { return Ok(Wish::Drive(None)) };
        self.is_asked = false;
        let reply =
            answer.map_err(|fault| Failure::planner(format!("{}, at {:.2} s: {fault}", self.name, now - began)))?;
        for text in &reply.print {
            say(&format!("{now:8.2} s  {}", Words::of(text.as_bytes())));
        }
        if reply.done {
            return Ok(Wish::Done);
        }
        let wheels = [reply.left, reply.right].map(|speed| wheel_command(robot, speed.unwrap_or(0.0)));
        let [left, right] = wheels.map(|speed| f64::from(speed) / 1000.0);
        if let Some(senses) = &mut self.senses {
            senses.command(wheels);
        }
        Ok(Wish::Drive(Some(Drive::wheels(left, right))))
    }

    /// Waits until the program has ended.
    fn finish(self) {
        drop(self.lines);
        let _ = self.thread.join();
    }
}

impl<'a> Line<'a> {
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
    fn drive(&mut self, arguments: &Arguments, robot: &RobotModel, pilot: &mut Pilot) -> Result<String, Failure> {
        self.until(|driver| driver.readings().is_some())?;
        let now = self.now();
        self.driver.put_in(now, Mode::Safe);
        self.until(Driver::is_armed)?;
        say(&format!("{now:8.2} s  in Safe mode, at most {} m/s; Ctrl-C stops the robot", arguments.speed));
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
            let mut wish = Wish::Drive(None);
            if let Some(dt_s) = since
                && let Some(readings) = self.driver.readings()
            {
                wish = pilot.sense(robot, &to_sensors(readings), dt_s);
            }
            if matches!(wish, Wish::Drive(None)) {
                wish = pilot.answer(robot, now, began)?;
            }
            match wish {
                Wish::Done => return Ok(format!("{now:8.2} s  done\n")),
                // It holds for 200 ms unless it is renewed.
                Wish::Drive(Some(drive)) => self.driver.drive(now, drive),
                Wish::Drive(None) => {}
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
        self.driver.stop(now);
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
