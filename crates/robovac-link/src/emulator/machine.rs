//! The robot behind the interface: its parts and its time step.

use super::{
    builtin_program::BuiltinProgram,
    calendar::Calendar,
    charger::Charger,
    clock::{Nanos, SECOND, STEP},
    lights::{Condition, Lights},
    line::SerialLine,
    motion::{Brushes, DistanceAngleSum, Told, to_drive},
    personality::{ChargingLogTimes, Personality},
    power::{Brc, PowerState, SLEEPS_AFTER},
    report::Stream,
    sound::Sound,
};
use robovac_core::{
    coverage::{DOCK_BACK, ReachableFloor},
    geometry::{Point, Pose},
    math,
    robot::{RobotModel, RobotPort, TWIN_MODEL, model},
};
use robovac_sim::{Input, Life, RunSetup, STEP_S, SimRobot, World};
use roomba_oi::{Buttons, ChargingState, Hazard, Mode, motion::WheelSpeeds};
use std::sync::Arc;

/// Duration of a button press by opcode 165 or by hand: 1/6 s.
const PRESS: Nanos = SECOND / 6;
/// Share of the charge below which a battery is low (ours).
const LOW: f64 = 0.1;
/// Gap between a robot on its dock and the dock's back, m: its contacts touch.
const DOCK_GAP: f64 = 0.003;

/// Body, electronics and interface of one robot.
pub(super) struct Machine {
    pub who: Personality,
    /// Offsets of the counts of the left and right wheel, which start at the personality's values after every boot.
    pub counts_offset: [u16; 2],
    pub now: Nanos,
    /// Time of the next step.
    next_step: Nanos,
    model: RobotModel,
    /// Speed over the floor divided by the commanded one: firmware regulates speeds by the counts of its encoders and
    /// takes the wheels for those of the specification.
    speed_factor: f64,
    seed: u64,
    pub robot: SimRobot,
    pub life: Life,
    pub world: Arc<World>,
    floor: Arc<ReachableFloor>,
    pub line: SerialLine,
    pub mode: Mode,
    pub power: PowerState,
    pub powered_on: Nanos,
    pub brc: Brc,
    /// Time of the last activity.
    pub active: Nanos,
    /// Pending queries: numbers of packets and groups.
    pub asked: Vec<u8>,
    pub stream: Stream,
    pub told: Told,
    pub travel: DistanceAngleSum,
    pub brushes: Brushes,
    pub lights: Lights,
    pub sound: Sound,
    pub charger: Charger,
    pub builtin_program: Option<BuiltinProgram>,
    /// Number of built-in programs so far: each has its own random numbers.
    pub builtin_programs: u64,
    pub is_in_trouble: bool,
    /// Pressed buttons, and until when.
    pub pressed: (Buttons, Nanos),
    pub calendar: Calendar,
    /// Time of the next line of the log, and start of the log.
    log: (Nanos, Nanos),
}

impl Machine {
    pub fn new(setup: &RunSetup, who: &Personality) -> Self {
        let (world, start) = placed(setup, who);
        let life = Life::new(&world, &setup.floor, setup.seed);
        let specified = model(TWIN_MODEL).map_or(setup.robot.counts_per_metre, |model| model.counts_per_metre);
        let speed_factor = specified / setup.robot.counts_per_metre;
        let body = RobotModel {
            acceleration: who.acceleration,
            max_wheel_speed: speed_factor * setup.robot.max_wheel_speed,
            ..setup.robot.clone()
        };
        let robot = SimRobot::new(&body, start, setup.conditions, setup.seed);
        Self {
            who: who.clone(),
            counts_offset: who.first_counts,
            now: 0,
            next_step: STEP,
            model: setup.robot.clone(),
            speed_factor,
            seed: setup.seed,
            robot,
            life,
            world,
            floor: Arc::clone(&setup.floor),
            line: SerialLine::new(who, setup.seed),
            mode: Mode::Off,
            power: if who.starts_asleep { PowerState::Asleep(0) } else { PowerState::Awake },
            powered_on: 0,
            brc: Brc::default(),
            active: 0,
            asked: Vec::new(),
            stream: Stream::default(),
            told: Told::default(),
            travel: DistanceAngleSum::default(),
            brushes: Brushes::default(),
            lights: Lights::default(),
            sound: Sound::default(),
            charger: Charger::default(),
            builtin_program: None,
            builtin_programs: 0,
            is_in_trouble: false,
            pressed: (Buttons::default(), 0),
            calendar: Calendar::default(),
            log: (SECOND, 0),
        }
    }

    /// Whether it is awake.
    pub fn is_awake(&self) -> bool {
        self.power == PowerState::Awake
    }

    /// Whether bytes from the host are still in transit, or answers to them. Frames of the stream aren't answers.
    pub fn is_answering(&self) -> bool {
        let [hears, sends] = self.line.is_busy();
        hears || !self.asked.is_empty() || (sends && !self.stream.is_on())
    }

    /// Time of the next step.
    pub fn next_step(&self) -> Nanos {
        self.next_step
    }

    /// Pressed buttons (packet 18).
    pub fn buttons(&self) -> Buttons {
        if self.now < self.pressed.1 { self.pressed.0 } else { Buttons::default() }
    }

    /// Presses buttons for a moment.
    pub fn hold(&mut self, buttons: Buttons) {
        self.pressed = (Buttons::from_byte(self.buttons().byte() | buttons.byte()), self.now + PRESS);
    }

    /// Wheel speeds commanded at present by a host or a program, mm/s.
    pub fn asked_speeds(&self) -> WheelSpeeds {
        if self.mode >= Mode::Safe { self.told.speeds(self.is_on_carpet()) } else { WheelSpeeds::default() }
    }

    /// One step: moves, senses, reacts, reports.
    pub fn step(&mut self) {
        self.next_step += STEP;
        self.drive();
        let Self { life, robot, world, floor, .. } = self;
        robot.step(&floor.walls, world, life);
        self.travel.count(self.robot.sensors());
        self.supply();
        self.look_out();
        self.live();
        self.say();
    }

    /// Lifts the robot or puts it down.
    pub fn apply(&mut self, input: Input) {
        match input {
            Input::Lift => self.robot.lift(),
            Input::PutDown(pose) => {
                let (movers, body) = (self.life.movers(), self.floor.walls.body_radius);
                let is_free = |at: Point| movers.iter().all(|&(centre, radius)| (at - centre).norm() > radius + body);
                self.robot.put_down(self.floor.place_for(pose, is_free));
            }
            // Its controller is at the other end of the line.
            Input::Command(_) | Input::Clean(_) => {}
        }
    }

    /// Sets the wheel speeds until the next step.
    fn drive(&mut self) {
        let (is_awake, asked) = (self.is_awake(), self.asked_speeds());
        match &mut self.builtin_program {
            _ if is_awake && self.mode >= Mode::Safe => self.robot.drive(to_drive(asked).times(self.speed_factor)),
            Some(builtin_program) if is_awake => builtin_program.drive_on(&mut self.robot, STEP_S),
            // Nothing drives it. A command to stand still, above, is a speed like any other.
            _ => self.robot.brake(),
        }
        let brushes = self.running();
        // Vacuum and side brush alone leave dirt where it is.
        self.robot.set_sweeping(brushes.main > 0.0);
    }

    /// The brushes and the vacuum.
    pub fn running(&self) -> Brushes {
        match &self.builtin_program {
            _ if !self.is_awake() => Brushes::default(),
            Some(builtin_program) if self.mode < Mode::Safe && builtin_program.cleans() => Brushes::CLEANING,
            _ => self.brushes,
        }
    }

    /// Draws from the battery, or charges it.
    fn supply(&mut self) {
        let (battery, loads) = (self.robot.sensors().battery, self.running().loads());
        let may_charge = self.mode <= Mode::Passive;
        let supply = self.charger.step(self.now, battery, may_charge, self.is_awake(), loads);
        self.robot.supply(supply);
        match (self.robot.is_empty(), self.power) {
            (true, PowerState::Flat)
            | (
                false,
                PowerState::Awake | PowerState::Asleep(_) | PowerState::Booting(..) | PowerState::BootLoader(_),
            ) => {}
            (true, _) => {
                self.go_down();
                self.power = PowerState::Flat;
            }
            (false, PowerState::Flat) => self.boot(),
        }
    }

    /// Reacts to sensors: the safety features, and the ends of programs.
    fn look_out(&mut self) {
        let sensed = self.robot.sensors();
        let has_dropped = sensed.wheel_dropped();
        let told = self.asked_speeds();
        let hazards = [
            Hazard::of_cliff(told).filter(|_| sensed.sees_cliff()),
            has_dropped.then_some(Hazard::WheelDrop),
            self.charger.is_connected().then_some(Hazard::Charger),
            sensed.bumped().then_some(Hazard::Bumper),
            sensed.light_bumper.contains(&true).then_some(Hazard::LightBumper),
            sensed.virtual_wall.then_some(Hazard::VirtualWall),
        ];
        for hazard in hazards.into_iter().flatten() {
            let reaction = self.mode.after_hazard(hazard);
            if reaction.mode != self.mode {
                self.enter(reaction.mode);
            }
        }
        if has_dropped && self.builtin_program.take().is_some() {
            self.trouble();
        }
        if self.charger.is_plugged {
            self.builtin_program = None;
        }
    }

    /// Background activities: programs, schedule, sleep, boot, log.
    fn live(&mut self) {
        if self.is_awake() {
            self.go_on();
            if self.mode <= Mode::Passive && self.calendar.is_due(self.now) {
                self.begin(super::builtin_program::Chore::Clean);
            }
            let idle = self.now - self.active;
            let dozes = |after: f64| {
                let on_dock = self.charger.connected_for(self.now).unwrap_or(0);
                self.mode <= Mode::Passive && on_dock.min(idle) as f64 >= after * SECOND as f64
            };
            if self.mode == Mode::Passive && idle >= SLEEPS_AFTER || self.who.silent_on_dock_s.is_some_and(dozes) {
                self.fall_asleep();
            }
        } else {
            self.go_up();
        }
    }

    /// Sends answers, the stream and the log.
    fn say(&mut self) {
        if !self.is_awake() {
            return;
        }
        if !self.line.is_changing(self.now) {
            self.report();
        }
        let is_logging = match self.who.log {
            ChargingLogTimes::Never => false,
            ChargingLogTimes::Charging => self.charger.state != ChargingState::None,
            ChargingLogTimes::Always => true,
        };
        if !is_logging {
            self.log = (self.now + SECOND, self.now);
        } else if self.now >= self.log.0 {
            let line = self.log_line(self.now - self.log.1);
            self.line.send(self.now, line.as_bytes());
            self.log.0 += SECOND;
        }
    }

    /// State for the robot's own lights.
    pub fn condition(&self) -> Condition {
        Condition {
            is_awake: self.is_awake(),
            is_charging: self.charger.state.is_charging(),
            is_low: self.robot.sensors().battery.share() < LOW,
            is_in_trouble: self.is_in_trouble,
            chore: self.builtin_program.as_ref().map(|builtin_program| builtin_program.chore),
        }
    }

    /// Parameters of a built-in program: the robot, and a seed.
    pub fn builtin_program_setup(&self) -> (&RobotModel, u64) {
        (&self.model, self.seed.wrapping_add(self.builtin_programs.wrapping_mul(0x9e37_79b9_7f4a_7c15)))
    }

    fn is_on_carpet(&self) -> bool {
        self.world.is_on_carpet(self.robot.pose().position())
    }
}

/// The world, and the robot's pose at the start: on a dock, if required.
fn placed(setup: &RunSetup, who: &Personality) -> (Arc<World>, Pose) {
    let (world, start) = (Arc::clone(&setup.world), setup.floor.start);
    if !who.starts_docked {
        return (world, start);
    }
    let away = setup.robot.radius + DOCK_BACK[1] + DOCK_GAP;
    let along = |pose: Pose, distance: f64, heading: f64| {
        let at = pose.position() + pose.direction() * distance;
        Pose::new(at.x, at.y, heading)
    };
    if let Some(&dock) = world.docks.first() {
        return (world, along(dock, away, dock.heading + math::PI));
    }
    let mut with_dock = (*world).clone();
    with_dock.docks.push(along(start, away, start.heading + math::PI));
    (Arc::new(with_dock), start)
}
