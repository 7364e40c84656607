//! Return to the dock by its infrared beams.
//!
//! A Roomba's dock sends a green and a red beam that overlap in front of its middle, and a force field around it (Open
//! Interface specification, infrared characters 160 to 173). A robot that faces the dock has the green beam on its left
//! and the red one on its right. The specification defines the characters; the Roomba's algorithm isn't published, and
//! the following is ours:
//!
//! 1. *Search.* Random walk and wall follow in turn until a beam is seen. The force field alone doesn't give a
//!    direction.
//! 2. *Cross.* In one beam alone the robot is off the middle: it keeps the dock on that side where it would pass the middle,
//!    and drives until it sees both beams.
//! 3. *Approach.* Seeing both, it drives to where both of its front receivers see the dock, slowly within the force field.
//!    Losing one beam, it steers back towards it: the overlap narrows to a centimetre where the contacts are.
//! 4. *Retry.* If it bumps into something and isn't charged, it goes back the way it came, turns a little, and tries again.
//!    After some attempts it searches again, to approach from another side.
//!
//! ```
//! use robovac_sim::controller::*;
//! use robovac_core::{registry::Params, robot::*};
//! let info = find("dock").unwrap();
//! let (robot, params) = (model("roomba600").unwrap(), Params::defaults(info.params));
//! let mut dock = info.build(&Setup { robot, params: &params, seed: 1 }).unwrap();
//! let seen = |omni| SensorReadings { infrared: Infrared { omni, left: omni, right: omni }, ..SensorReadings::default() };
//! dock.step(&seen(172), 0.015);
//! assert_eq!(dock.activity(), "driving to the dock");
//! let battery = BatteryReading { on_dock: true, ..BatteryReading::default() };
//! let on_dock = SensorReadings { battery, ..SensorReadings::default() };
//! assert!((0..40).all(|_| dock.step(&on_dock, 0.015).is_stop()) && dock.is_done());
//! ```

use super::{
    BehaviourClaims, BehaviourInfo, BuildBehaviour, Setup,
    parts::{Beacon, Behaviour, By, Move, Obstruction, ObstructionKind, Pilot, Reactive},
    random_walk::RandomWalk,
    wall_follow::WallFollow,
};
use rand::RngExt;
use robovac_core::{
    registry::{Example, Explainer},
    robot::{Drive, SensorReadings},
};

/// Speeds, m/s: to the dock from afar, and within its force field.
const SPEED: (f64, f64) = (0.2, 0.07);
/// Turn rates, rad/s: on the spot to find it, along an arc from afar, and close to it.
const TURN: (f64, f64, f64) = (0.8, 0.5, 0.3);
/// Time without beams after which they are lost, s.
const LOST_S: f64 = 4.0;
/// Way back for another try, m.
const BACK: f64 = 0.45;
/// Tries before another search.
const TRIES: u32 = 4;
/// Durations of random walk and wall follow during the search, s.
const SEARCH_S: (f64, f64) = (60.0, 60.0);
/// Time on the contacts after which the robot is docked, s.
const RESTS_S: f64 = 0.5;
/// Time at the start of another search in which beams are ignored, s: the robot must move away first.
const BLIND_S: f64 = 8.0;

pub(super) const INFO: BehaviourInfo = BehaviourInfo {
    id: "dock",
    title: "Return to dock",
    summary: "Searches for the dock's infrared beams and drives in between them to charge.",
    claims: BehaviourClaims { ends: true, ..BehaviourClaims::NONE },
    params: &[],
};

/// Its explanation.
pub(super) const EXPLAINER: Explainer = Explainer {
    idea: "The robot combines random driving and wall following until it detects a beam of its dock. The dock \
           sends a green beam to one side of its centre line and a red one to the other; both are visible on the \
           line. The robot steers towards whichever beam it loses, slowing down as it gets closer, until its \
           contacts touch.",
    complexity: "O(1) time and memory per step.",
    use_when: "When the battery runs low. It needs infrared receivers; in large or winding rooms the search is \
        slow.",
    shines: Example { room: "bedroom", why: "In a single room the beams are found quickly." },
    fails: Example {
        room: "flat",
        why: "From other rooms the robot sees no beam, so it must first find the right door by chance.",
    },
    source: "iRobot Create 2 Open Interface specification: packets 17, 52 and 53, infrared characters; the driving \
        strategy is ours",
    link: "https://edu.irobot.com/learning-library/create-2-oi-spec",
};

pub(super) const BUILD: BuildBehaviour = |setup| Reactive::boxed(setup, Dock::new(setup));

/// The behaviour.
#[derive(Debug, Clone)]
pub(super) struct Dock {
    walk: RandomWalk,
    walls: WallFollow,
    beacon: Beacon,
    phase: DockPhase,
    tries: u32,
    /// Whether it searches along walls only.
    keeps_to_walls: bool,
    /// Whether the robot has receivers and contacts.
    is_able: bool,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum DockPhase {
    /// Searches for so long, s, along walls or at random; ignores beams for so long, s.
    Search { left: f64, along_walls: bool, blind: f64 },
    /// Drives by the beams, without them for so long, s; when last seen, the dock was on the left.
    Home { unseen: f64, was_left: bool },
    /// On the contacts for so long, s.
    Docked { since: f64 },
}

const START: DockPhase = DockPhase::Search { left: SEARCH_S.0, along_walls: false, blind: 0.0 };

impl Dock {
    pub(super) fn new(setup: &Setup<'_>) -> Self {
        Self {
            walk: RandomWalk::with(setup, (1.0, 1.0), 0.03),
            walls: WallFollow::usual(setup),
            beacon: Beacon::default(),
            phase: START,
            tries: 0,
            keeps_to_walls: false,
            is_able: setup.robot.sensors.infrared && setup.robot.battery.charge_ma > 0.0,
        }
    }

    /// Starts a search along walls that never changes to a random walk; `heeds_beams` is whether it goes to a dock that
    /// it sees.
    pub(super) fn follow_walls(&mut self, pilot: &mut Pilot, heeds_beams: bool) {
        self.keeps_to_walls = true;
        self.search(pilot, true, if heeds_beams { 0.0 } else { f64::INFINITY });
    }

    fn search(&mut self, pilot: &mut Pilot, along_walls: bool, blind: f64) {
        let along_walls = along_walls || self.keeps_to_walls;
        let left = match along_walls {
            _ if self.keeps_to_walls => f64::INFINITY,
            true => SEARCH_S.1,
            false => SEARCH_S.0,
        };
        self.phase = DockPhase::Search { left, along_walls, blind };
        self.tries = 0;
        if along_walls { self.walls.begin(pilot) } else { self.walk.begin(pilot) }
    }

    /// Drives by the beams, with the side on which the dock was last seen.
    fn by_beams(&self, pilot: &Pilot, was_left: bool) -> Drive {
        let is_near = self.beacon.is_near();
        let speed = if is_near { SPEED.1 } else { SPEED.0 }.min(pilot.speed);
        let rate = if is_near { TURN.2 } else { TURN.1 };
        let arc = |left: bool| pilot.twist(speed, if left { rate } else { -rate });
        let spin = |left: bool| pilot.twist(0.0, if left { TURN.0 } else { -TURN.0 });
        match (self.beacon.beams(), self.beacon.sides()) {
            // In the middle: keep the dock ahead.
            ((true, true), (left, right)) if left != right => arc(left),
            // On the left of the middle, go right, with the dock a little to the left; and the other way round.
            ((true, true), (true, true)) | ((true, false), (true, false)) | ((false, true), (false, true)) => {
                pilot.twist(speed, 0.0)
            }
            ((true, false), (true, true)) => arc(false),
            ((false, true), (true, true)) => arc(true),
            ((true, false), (false, true)) => spin(false),
            ((false, true), (true, false)) => spin(true),
            _ => spin(was_left),
        }
    }
}

impl Behaviour for Dock {
    fn begin(&mut self, pilot: &mut Pilot) {
        self.search(pilot, false, 0.0);
    }

    fn watch(&mut self, sensed: &SensorReadings, dt_s: f64) {
        self.beacon.update(sensed, dt_s);
        match &mut self.phase {
            DockPhase::Docked { since } if sensed.battery.on_dock => *since += dt_s,
            // Has rolled over the contacts.
            DockPhase::Docked { .. } => self.phase = DockPhase::Home { unseen: 0.0, was_left: false },
            phase if sensed.battery.on_dock => *phase = DockPhase::Docked { since: 0.0 },
            DockPhase::Search { left, blind, .. } => {
                *left -= dt_s;
                *blind -= dt_s;
            }
            DockPhase::Home { unseen, was_left } => {
                *unseen = if self.beacon.beams() == (false, false) { *unseen + dt_s } else { 0.0 };
                *was_left = match self.beacon.sides() {
                    (true, false) => true,
                    (false, true) => false,
                    _ => *was_left,
                };
            }
        }
    }

    fn roam(&mut self, pilot: &mut Pilot, sensed: &SensorReadings, dt_s: f64) -> Drive {
        match self.phase {
            DockPhase::Search { blind, .. } if blind <= 0.0 && self.beacon.beams() != (false, false) => {
                self.phase = DockPhase::Home { unseen: 0.0, was_left: self.beacon.sides().0 };
                pilot.turn_speed = pilot.robot.turn_wheel_speed;
                pilot.by = By::Counts;
                self.by_beams(pilot, self.beacon.sides().0)
            }
            DockPhase::Search { left, along_walls, .. } => {
                if left <= 0.0 {
                    self.search(pilot, !along_walls, 0.0);
                }
                if along_walls { self.walls.roam(pilot, sensed, dt_s) } else { self.walk.roam(pilot, sensed, dt_s) }
            }
            DockPhase::Home { unseen, .. } if unseen > LOST_S => {
                self.search(pilot, false, 0.0);
                Drive::STOP
            }
            DockPhase::Home { was_left, .. } => self.by_beams(pilot, was_left),
            DockPhase::Docked { .. } => Drive::STOP,
        }
    }

    fn on_obstruction(&mut self, pilot: &mut Pilot, obstruction: Obstruction) {
        match self.phase {
            DockPhase::Docked { .. } => {}
            DockPhase::Search { along_walls: true, .. } => self.walls.on_obstruction(pilot, obstruction),
            DockPhase::Home { .. } if obstruction.kind == ObstructionKind::Bump && self.tries < TRIES => {
                self.tries += 1;
                let turn = pilot.rng.random_range(-0.4..0.4);
                pilot.answer(obstruction, BACK, &[Move::Turn(turn)]);
            }
            DockPhase::Home { .. } => {
                self.search(pilot, false, BLIND_S);
                self.on_obstruction(pilot, obstruction);
            }
            DockPhase::Search { .. } => self.walk.on_obstruction(pilot, obstruction),
        }
    }

    fn is_done(&self) -> bool {
        matches!(self.phase, DockPhase::Docked { since } if since > RESTS_S) || !self.is_able
    }

    fn activity(&self) -> &'static str {
        match self.phase {
            _ if !self.is_able => "no infrared receivers for the dock's beams",
            DockPhase::Search { .. } => "searching for the dock",
            DockPhase::Home { .. } => "driving to the dock",
            DockPhase::Docked { .. } => "docked",
        }
    }

    fn boxed_clone(&self) -> Box<dyn Behaviour> {
        Box::new(self.clone())
    }
}
