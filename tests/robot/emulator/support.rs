//! A robot in the middle of a bare room, and a host at the other end of its line.

use robovac_core::{
    floor_plan::{FloorPlan, Object, Sketch},
    geometry::Point,
    robot::model,
};
use robovac_link::emulator::{Emulator, personality};
use robovac_sim::{
    Conditions, RunSetup,
    experiment::planning::{Placement, choose_robot},
};
use roomba_oi::{Command, MAX_WRITTEN, Mode, PacketId, Readings};

pub const BAUD: u32 = 115_200;

/// Six by four metres; the robot starts a metre from the left wall and looks to the right.
pub fn plan() -> FloorPlan {
    Sketch::open(6.0, 4.0, 0.05).start(1.0, 2.0, 0.0).finish("Hall", "")
}

/// The same with no floor from `ahead` metres before the robot's middle on.
pub fn plan_with_drop_off(ahead: f64) -> FloorPlan {
    let x = 1.0 + ahead;
    let corner = |x, y| Point::new(x, y);
    let outline = vec![corner(x, 0.2), corner(x + 1.0, 0.2), corner(x + 1.0, 3.8), corner(x, 3.8)];
    FloorPlan { objects: vec![Object::DropOff { outline }], ..plan() }
}

pub fn setup(plan: FloorPlan, conditions: Conditions, seed: u64) -> RunSetup {
    let (robot, cell_size) = choose_robot("roomba600", &plan, None).unwrap();
    assert_eq!(robot.id, model("roomba600").unwrap().id);
    let placement = Placement { plan, robot, cells: cell_size.into(), start: None, heading_deg: None };
    placement.prepare().unwrap().setup(conditions, seed)
}

/// Robot and host.
pub struct Lab {
    pub robot: Emulator,
    /// Bytes received by the host.
    pub heard: Vec<u8>,
    pub baud: u32,
}

impl Lab {
    pub fn new(who: &str) -> Self {
        Self::in_room(plan(), who, Conditions::default())
    }

    pub fn in_room(plan: FloorPlan, who: &str, conditions: Conditions) -> Self {
        let robot = Emulator::new(&setup(plan, conditions, 7), personality(who).unwrap());
        Self { robot, heard: Vec::new(), baud: BAUD }
    }

    /// A robot in that mode, as its commands bring it there.
    pub fn in_mode(mode: Mode) -> Self {
        let mut lab = Self::new("model");
        lab.go(mode);
        lab
    }

    pub fn go(&mut self, mode: Mode) {
        match mode {
            Mode::Off => {}
            Mode::Passive => self.send(&[128]),
            Mode::Safe => self.send(&[128, 131]),
            Mode::Full => self.send(&[128, 132]),
        }
        self.wait(0.03);
        assert_eq!(self.robot.mode(), mode);
        self.robot.take_display();
        self.heard.clear();
    }

    /// Sends bytes, and waits until the line has carried them.
    pub fn send(&mut self, bytes: &[u8]) {
        self.robot.receive(bytes, self.baud);
        self.wait(bytes.len() as f64 * 10.0 / f64::from(self.baud) + 1e-5);
    }

    pub fn command(&mut self, command: Command<'_>) {
        let mut buffer = [0; MAX_WRITTEN];
        let bytes = command.encode(&mut buffer).unwrap().to_vec();
        self.send(&bytes);
    }

    pub fn wait(&mut self, seconds: f64) {
        self.robot.advance(seconds);
        self.robot.transmit(self.baud, &mut self.heard);
    }

    /// Bytes received since the last call.
    pub fn take(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.heard)
    }

    /// The bytes that answer a question for a packet; none if no answer comes.
    pub fn ask(&mut self, packet: u8) -> Vec<u8> {
        self.take();
        self.send(&[142, packet]);
        self.wait(0.03);
        self.take()
    }

    /// The number that a packet has.
    pub fn value(&mut self, packet: u8) -> i32 {
        let answer = self.ask(packet);
        let packet = roomba_oi::Packet::from_byte(packet).unwrap();
        assert_eq!(answer.len(), packet.format().size(), "{packet}: {answer:?}");
        packet.value(packet.read(&answer).unwrap())
    }

    /// All packets.
    pub fn readings(&mut self) -> Readings {
        let answer = self.ask(100);
        let mut readings = Readings::default();
        readings.read(PacketId::from_byte(100).unwrap(), &answer).unwrap();
        readings
    }

    /// How far it has come from its start in the direction in which it looked, m.
    pub fn ahead(&self) -> f64 {
        self.robot.pose().x - 1.0
    }

    pub fn speed(&self) -> f64 {
        let speed = self.robot.robot().speed();
        speed.left.abs().max(speed.right.abs())
    }
}
