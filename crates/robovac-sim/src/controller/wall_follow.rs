//! Wall following: along walls and around furniture, with the wall on the right (002, section IV.A.iv).
//!
//! Hasan, Al-Nahid & Reza 2014 want it for corners and edges, where the side brush takes the dirt, and show a robot that goes
//! along the border of a room; the flowchart is lost. Two ways to do it, by what the robot has:
//!
//! - *By the bumper* (DVR-1): the robot drives an arc into the wall until it bumps, backs off a little, turns away a little,
//!   and drives the next arc. Where the wall ends, the arc leads round the corner.
//! - *By light* (Roomba): the signal of the light bumper's rightmost sensor grows as the wall comes nearer. A controller keeps
//!   it at a set value by steering: proportional to how far it is off, and to how fast that changes. The front sensors
//!   make it turn before a corner. Where the wall ends, it drives an arc to the right as well.
//!
//! # Where the paper is silent
//!
//! - *How far to turn away*: a wall at less than 30 degrees to the heading doesn't press a bumper of 120 degrees. A robot that
//!   turned away less would rub along the wall unawares for most of the way, and its odometry would lead into the wall. It
//!   turns so far that its arc meets the wall at that angle again.
//! - *Finding a wall*: straight ahead until something is there.
//! - *Furniture that stands alone* would be gone round for ever. A robot that has turned right by 360 degrees more than
//!   left since it met its wall has gone round something; it leaves after a number of rounds, at a right angle. Around a
//!   room it turns left, and goes on.
//! - *A wall that isn't there*: after a circle and a half without meeting it again, it looks for another one.
//! - *The edge of stairs* is no wall. On an arc around its corner the inner wheel would run inside the track of the cliff
//!   sensors and get over the edge unseen. The robot turns away and looks for another wall; so it does at a virtual wall.
//!
//! ```
//! use robovac_sim::controller::*;
//! use robovac_core::{registry::Params, robot::*};
//! let info = find("wall_follow").unwrap();
//! let (robot, params) = (model("roomba600").unwrap(), Params::defaults(info.params));
//! let mut follower = info.build(&Setup { robot, params: &params, seed: 1 }).unwrap();
//! assert_eq!(follower.activity(), "searching for a wall");
//! follower.step(&SensorReadings { bump_right: true, ..SensorReadings::default() }, 0.015);
//! assert_eq!(follower.activity(), "backing up");
//! assert!((0..400).any(|_| { follower.step(&SensorReadings::default(), 0.015); follower.activity() == "following the wall" }));
//! ```

use super::{
    BehaviourClaims, BehaviourInfo, BuildBehaviour, Setup,
    parts::{Behaviour, By, GO_HOME, LEAVE_HOME, Move, Obstruction, ObstructionKind, ObstructionSide, Pilot, Reactive},
};
use rand::RngExt;
use robovac_core::{
    math,
    registry::{Example, Explainer, ParamKind, ParamSpec},
    robot::{Drive, SensorReadings},
};

/// Signal to keep: about 3 cm from a light wall, within the side brush's reach.
const SIGNAL: f64 = 1000.0;
/// Way back from a wall that was bumped into, m.
const BACK: f64 = 0.015;
/// Turns away from a contact, rad: on the right, straight ahead, on the left.
const AWAY: [f64; 3] = [0.35, 0.9, 1.6];
/// Turn away from obstructions that aren't walls, rad, drawn from this range.
const LEAVE: (f64, f64) = (1.6, 2.6);
/// Turn, rad, after which a wall that wasn't met again is lost: a circle and a half.
const LOST: f64 = 1.5 * math::TAU;
/// Steering by light: turn rate for a signal error of all of its set value, and for a change by that much in a second
/// (rad/s, rad).
const GAINS: (f64, f64) = (1.2, 0.4);
/// Fastest steering, rad/s.
const STEER: f64 = 1.4;
/// Signals are smoothed over about this time, s: dazzled sensors jump.
const SMOOTH_S: f64 = 0.06;
/// Signal of a front sensor at which it turns away: about 8 cm from a wall ahead, enough to stop.
const AHEAD: f64 = 600.0;
/// Share of the set signal below which there is no wall.
const NOTHING: f64 = 0.2;
/// Share of the speed while steering by light along a wall.
const PACE: f64 = 0.8;

pub(super) const INFO: BehaviourInfo = BehaviourInfo {
    id: "wall_follow",
    title: "Wall follow",
    summary: "Follows the wall on its right, by repeated contact or by its light bumper.",
    claims: BehaviourClaims { cleans: true, walls_only: true, ..BehaviourClaims::NONE },
    params: &[
        ParamSpec {
            id: "on",
            label: "Wall sensing",
            help: "By bumper or by light bumper; automatic uses the light bumper if the robot has one.",
            kind: ParamKind::Choice {
                options: &[("auto", "automatic"), ("bumper", "by bumper"), ("light", "by light")],
            },
        },
        ParamSpec {
            id: "rounds",
            label: "Rounds around furniture",
            help: "Rounds around a free-standing obstacle before it leaves; 0 for no limit.",
            kind: ParamKind::Number { min: 0.0, max: 10.0, step: 1.0, default: 1.0, unit: "" },
        },
        ParamSpec {
            id: "arc",
            label: "Arc",
            help: "Extra radius of the arcs driven towards the wall, beyond the robot's own.",
            kind: ParamKind::Number { min: 0.0, max: 50.0, step: 1.0, default: 8.0, unit: "cm" },
        },
        ParamSpec {
            id: "signal",
            label: "Target signal",
            help: "By light: target strength of the rightmost light bumper signal; higher is closer to the wall.",
            kind: ParamKind::Number { min: 200.0, max: 3000.0, step: 50.0, default: SIGNAL, unit: "" },
        },
        GO_HOME,
        LEAVE_HOME,
    ],
};

/// Its explanation.
pub(super) const EXPLAINER: Explainer = Explainer {
    idea: "The robot searches for a wall and follows it on its right. With only a bumper it drives an arc into the \
           wall, backs off, turns away a little and repeats; with a light bumper it keeps a constant distance. It \
           leaves free-standing obstacles after one round, but follows the border of the room for ever.",
    complexity: "O(1) time and memory per step; it stores how far it has turned along this wall.",
    use_when: "For edges and corners, which other behaviours clean last. Alone it never cleans the middle of the \
        room.",
    shines: Example {
        room: "maze",
        why: "A maze is all walls: it follows them through the whole maze, where random behaviours get stuck.",
    },
    fails: Example { room: "empty", why: "It cleans the border again and again and never the middle." },
    source: "Hasan, Al-Nahid & Reza 2014, Path planning algorithm development for autonomous vacuum cleaner robots, ICIEV: \
             section IV.A.iv",
    link: "https://ieeexplore.ieee.org/document/6850799",
};

pub(super) const BUILD: BuildBehaviour = |setup| {
    let number = |id| setup.params.number(id);
    let by_light = match setup.params.choice("on") {
        "bumper" => false,
        "light" => true,
        _ => setup.robot.sensors.light_bumper.is_some(),
    };
    let light = by_light.then(|| number("signal"));
    Reactive::boxed(setup, WallFollow::new(setup, light, number("rounds") as u32, number("arc") / 100.0))
};

/// The behaviour.
#[derive(Debug, Clone)]
pub(super) struct WallFollow {
    /// Signal to keep; `None` to follow by the bumper.
    light: Option<f64>,
    rounds: u32,
    /// Radius of the arcs, m.
    arc: f64,
    /// Turn away from a contact on the right, rad.
    away: f64,
    phase: WallPhase,
    /// Smoothed signal, as a share of the set one.
    last: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum WallPhase {
    Seek,
    /// Follows a wall; total turn when it was met, and at the last detection, rad.
    Follow {
        met: f64,
        felt: f64,
    },
}

impl WallFollow {
    /// By light at that signal or by the bumper; leaves what stands alone after so many rounds; arcs so much wider than the
    /// robot, m.
    pub(super) fn new(setup: &Setup<'_>, light: Option<f64>, rounds: u32, wider: f64) -> Self {
        let light = light.filter(|_| setup.robot.sensors.light_bumper.is_some());
        // Nearer to parallel than that, a wall on the right doesn't press the bumper.
        let unfelt = setup.robot.sensors.bumper.map_or(0.0, |bumper| math::FRAC_PI_2 - bumper.half_arc);
        let away = AWAY[0].max(2.0 * unfelt);
        Self { light, rounds, arc: setup.robot.radius + wider, away, phase: WallPhase::Seek, last: 0.0 }
    }

    /// With the default parameters.
    pub(super) fn usual(setup: &Setup<'_>) -> Self {
        Self::new(setup, Some(SIGNAL), 1, 0.08)
    }

    /// Follows any wall without leaving it.
    pub(super) fn endless(setup: &Setup<'_>) -> Self {
        Self::new(setup, Some(SIGNAL), 0, 0.08)
    }

    /// Whether it has a wall to follow.
    pub(super) fn has_wall(&self) -> bool {
        self.phase != WallPhase::Seek
    }

    fn feel(&mut self, turned: f64) {
        let met = if let WallPhase::Follow { met, .. } = self.phase { met } else { turned };
        self.phase = WallPhase::Follow { met, felt: turned };
    }

    /// Steers by the light reflected by the wall; `None` without a wall.
    fn by_light(&mut self, pilot: &Pilot, sensed: &SensorReadings, set: f64, dt_s: f64) -> Option<Drive> {
        let [_, front_left, left, right, front_right, side] = sensed.light_signal.map(f64::from);
        let before = self.last;
        self.last += (side / set - before) * dt_s / SMOOTH_S;
        let (side, change) = (self.last, (self.last - before) / dt_s);
        if left.max(right).max(front_left).max(0.5 * front_right) > AHEAD {
            return Some(pilot.twist(0.0, pilot.robot.turn_rate()));
        }
        if side < NOTHING {
            return None;
        }
        let steer = GAINS.0 * (side - 1.0) + GAINS.1 * change;
        Some(pilot.twist(PACE * pilot.speed, steer.clamp(-STEER, STEER)))
    }
}

impl Behaviour for WallFollow {
    fn begin(&mut self, pilot: &mut Pilot) {
        pilot.turn_speed = pilot.robot.turn_wheel_speed;
        pilot.by = By::Counts;
        self.phase = WallPhase::Seek;
    }

    fn roam(&mut self, pilot: &mut Pilot, sensed: &SensorReadings, dt_s: f64) -> Drive {
        let turned = pilot.turned();
        let steered = self.light.and_then(|set| self.by_light(pilot, sensed, set, dt_s));
        if steered.is_some() {
            self.feel(turned);
        }
        let WallPhase::Follow { met, felt } = self.phase else { return pilot.straight() };
        if self.rounds > 0 && turned - met < -math::TAU * f64::from(self.rounds) {
            self.phase = WallPhase::Seek;
            pilot.go(&[Move::Turn(math::FRAC_PI_2)]);
            return Drive::STOP;
        }
        if turned - felt < -LOST {
            self.phase = WallPhase::Seek;
        }
        // The right wheel goes the shorter way round.
        steered.unwrap_or_else(|| pilot.twist(PACE * pilot.speed, -PACE * pilot.speed / self.arc))
    }

    fn on_obstruction(&mut self, pilot: &mut Pilot, obstruction: Obstruction) {
        if obstruction.kind != ObstructionKind::Bump {
            self.phase = WallPhase::Seek;
            let turn = pilot.away_from(obstruction) * pilot.rng.random_range(LEAVE.0..LEAVE.1);
            pilot.answer(obstruction, BACK, &[Move::Turn(turn)]);
            return;
        }
        self.feel(pilot.turned());
        let turn = match obstruction.side {
            ObstructionSide::Right => self.away,
            ObstructionSide::Front => AWAY[1],
            ObstructionSide::Left => AWAY[2],
        };
        pilot.answer(obstruction, BACK, &[Move::Turn(turn)]);
    }

    fn activity(&self) -> &'static str {
        match self.phase {
            WallPhase::Seek => "searching for a wall",
            WallPhase::Follow { .. } => "following the wall",
        }
    }

    fn boxed_clone(&self) -> Box<dyn Behaviour> {
        Box::new(self.clone())
    }
}
