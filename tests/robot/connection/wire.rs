//! A line between a link and an emulated robot, with time that the test lets pass.

use robovac_core::{
    coverage::ReachableFloor,
    floor_plan::{FloorPlan, Sketch, room},
    geometry::Pose,
    robot::{RobotModel, model},
};
use robovac_link::{
    connection::{Connection, ConnectionView, Request},
    driver::LineRequest,
    emulator::{Emulator, Personality, personality},
};
use robovac_sim::{Conditions, RunSetup, World};
use roomba_oi::{Command, CommandDecoder, Mode};
use std::sync::Arc;

/// Time between two looks at the line, s: the serial port of a computer hands bytes over about as often.
pub const LOOK_S: f64 = 0.005;
/// Looks between two ticks.
const TICK: u64 = 2;
/// Looks between two beats.
const BEAT: u64 = 8;

pub fn roomba() -> RobotModel {
    model("roomba600").unwrap().clone()
}

pub fn setup_in(plan: &FloorPlan, conditions: Conditions, seed: u64) -> RunSetup {
    let robot = roomba();
    let floor = Arc::new(ReachableFloor::new(plan, &robot, None).unwrap());
    RunSetup { floor, world: Arc::new(World::new(plan)), robot, conditions, seed }
}

/// 6 m x 5 m without anything in it; the robot in the middle.
pub fn hall() -> FloorPlan {
    Sketch::open(6.0, 5.0, 0.05).start(3.0, 2.5, 0.0).finish("Hall", "")
}

pub fn flat() -> FloorPlan {
    (room("flat").unwrap().build)()
}

/// Changes bytes on their way to the host.
pub type Fault = Box<dyn FnMut(Vec<u8>) -> Vec<u8>>;

pub struct Wire {
    pub link: Connection,
    pub robot: Emulator,
    pub now: f64,
    looks: u64,
    baud: u32,
    /// Whether the page lives, and the cable is plugged in.
    pub page_lives: bool,
    pub is_plugged: bool,
    pub fault: Option<Fault>,
    decoder: CommandDecoder,
    /// Commands that reached the robot, with their time.
    pub commands: Vec<(f64, Vec<u8>)>,
    /// How often the bridge was told to stop the robot.
    pub stops: u32,
}

impl Wire {
    pub fn new(setup: &RunSetup, personality_id: &str) -> Self {
        Self::with(setup, personality(personality_id).unwrap())
    }

    pub fn with(setup: &RunSetup, who: &Personality) -> Self {
        let robot = Emulator::new(setup, who);
        let mut wire = Self {
            link: Connection::new(),
            robot,
            now: 100.0,
            looks: 0,
            baud: 115_200,
            page_lives: true,
            is_plugged: true,
            fault: None,
            decoder: CommandDecoder::default(),
            commands: Vec::new(),
            stops: 0,
        };
        // Robots have stood around for a while.
        wire.robot.advance(10.0);
        let mut old = Vec::new();
        wire.robot.transmit(115_200, &mut old);
        wire
    }

    /// A robot in the middle of the hall, connected.
    pub fn connected() -> Self {
        let mut wire = Self::new(&setup_in(&hall(), Conditions::default(), 1), "model");
        wire.connect();
        wire
    }

    /// And under control.
    pub fn armed() -> Self {
        let mut wire = Self::connected();
        wire.arm();
        wire
    }

    pub fn connect(&mut self) {
        self.link.opened(self.now);
        self.pass_until(30.0, |wire| wire.view().phase == "connected");
    }

    pub fn arm(&mut self) {
        self.ask(Request::Arm { full: false });
        self.pass_until(2.0, |wire| wire.view().can.drive);
    }

    pub fn ask(&mut self, request: Request) {
        self.link.request(self.now, request).unwrap();
    }

    pub fn view(&mut self) -> ConnectionView {
        self.link.view(self.now)
    }

    pub fn pose(&self) -> Pose {
        self.robot.pose()
    }

    /// Drives ahead by hand for a time, as a held stick does.
    pub fn hold_ahead(&mut self, seconds: f64) {
        let end = self.now + seconds;
        while self.now < end {
            self.ask(Request::Drive { forward: 1.0, left: 0.0 });
            self.pass(0.04);
        }
    }

    pub fn is_rolling(&self) -> bool {
        !self.robot.robot().speed().is_stop()
    }

    pub fn pass(&mut self, seconds: f64) {
        let end = self.now + seconds - 1e-9;
        while self.now < end {
            self.look();
        }
    }

    /// Lets time pass until something holds; fails if it takes longer than `most` seconds.
    pub fn pass_until(&mut self, most: f64, mut holds: impl FnMut(&mut Self) -> bool) -> f64 {
        let began = self.now;
        while !holds(self) {
            assert!(self.now - began < most, "it took longer than {most} s: {:?}", self.view());
            self.pass(0.02);
        }
        self.now - began
    }

    /// Nothing runs on this computer for a time; what arrives is lost, and a tick comes first.
    pub fn stand_still(&mut self, seconds: f64) {
        self.now += seconds;
        self.robot.advance(seconds);
        self.robot.transmit(self.baud, &mut Vec::new());
        self.link.tick(self.now);
        self.flush();
    }

    fn look(&mut self) {
        self.now += LOOK_S;
        self.looks += 1;
        self.robot.advance(LOOK_S);
        let mut bytes = Vec::new();
        self.robot.transmit(self.baud, &mut bytes);
        if let Some(fault) = &mut self.fault {
            bytes = fault(bytes);
        }
        if self.is_plugged && !bytes.is_empty() {
            self.link.feed(self.now, &bytes);
        }
        if self.page_lives && self.looks.is_multiple_of(BEAT) {
            self.link.beat(self.now);
        }
        if self.looks.is_multiple_of(TICK) {
            self.link.know_truth(Some(self.robot.pose()));
            self.link.tick(self.now);
        }
        self.flush();
    }

    pub fn flush(&mut self) {
        while let Some(request) = self.link.take_line() {
            match request {
                LineRequest::Baud(baud) => self.baud = baud,
                LineRequest::Brc(is_low) => self.robot.set_brc(is_low),
                LineRequest::Stop => self.stops += 1,
            }
        }
        let bytes = self.link.take_tx();
        if self.is_plugged && !bytes.is_empty() {
            for &byte in &bytes {
                if let Some(received) = self.decoder.push(byte) {
                    self.commands.push((self.now, received.bytes.to_vec()));
                }
            }
            self.robot.receive(&bytes, self.baud);
        }
    }

    /// When the latest command that moves was sent.
    pub fn last_motion(&self) -> Option<f64> {
        self.commands.iter().rev().find(|(_, bytes)| moves(bytes)).map(|(at, _)| *at)
    }

    pub fn is_safe(&self) -> bool {
        self.robot.mode() == Mode::Safe
    }

    pub fn bumped(&self) -> bool {
        self.robot.sensors().bumped()
    }

    pub fn wheels(&self) -> (f64, f64) {
        let speed = self.robot.robot().speed();
        (speed.left, speed.right)
    }
}

/// Whether a command lets a robot move, or clean or look for its dock by itself.
pub fn moves(bytes: &[u8]) -> bool {
    match Command::parse(bytes) {
        Ok(Command::DriveDirect { right, left } | Command::DrivePwm { right, left }) => (right, left) != (0, 0),
        Ok(Command::Drive { velocity, .. }) => velocity != 0,
        Ok(Command::Clean | Command::Spot | Command::Max | Command::SeekDock) => true,
        _ => false,
    }
}
