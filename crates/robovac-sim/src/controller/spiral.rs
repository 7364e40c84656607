//! Spiral: circles that grow until something is in the way (002, section IV.A.ii).
//!
//! Hasan, Al-Nahid & Reza 2014: the robot first checks for enough room. If there is, it spirals to the left with a
//! growing radius: the right wheel runs at full speed, the left wheel's speed rises with time. When an obstacle is
//! sensed, the spiral is over.
//!
//! # Where the paper is silent
//!
//! - *How it checks for room*: its flowchart is lost, and a bumper can't look ahead. Here the first round, about the left
//!   wheel, is the check: if nothing is hit until the robot has turned by 360 degrees, there is room. A robot with a light
//!   bumper doesn't even begin where it sees something near.
//! - *How fast the left wheel's speed rises.* If it rose evenly, the circles would lie farther and farther apart. Here it
//!   starts from rest and rises ever more slowly, so that each circle lies the same distance outside the last one.
//! - *What comes after.* The cleaning cycle hands over to the next behaviour. Alone, the robot turns away as in the random
//!   walk, drives a random distance, and tries again.
//!
//! ```
//! use robovac_sim::controller::*;
//! use robovac_core::{registry::Params, robot::*};
//! let info = find("spiral_out").unwrap();
//! let (robot, params) = (model("roomba600").unwrap(), Params::defaults(info.params));
//! let mut spiral = info.build(&Setup { robot, params: &params, seed: 1 }).unwrap();
//! spiral.step(&SensorReadings::default(), 0.015);
//! assert_eq!(spiral.activity(), "checking for free space");
//! // The encoders of a robot that turns round and round about its left wheel.
//! let reading = |step: u16| SensorReadings { right_counts: step.wrapping_mul(10), ..SensorReadings::default() };
//! let check = spiral.step(&reading(1), 0.015);
//! let later = (2..2000).map(|step| spiral.step(&reading(step), 0.015)).last().unwrap();
//! assert_eq!(spiral.activity(), "spiralling out");
//! assert!(check.left == 0.0 && later.left > 0.05 && check.right == later.right);
//! ```

use super::{
    BehaviourClaims, BehaviourInfo, BuildBehaviour, Setup,
    parts::{Behaviour, GO_HOME, LEAVE_HOME, Obstruction, Pilot, Reactive},
    random_walk::RandomWalk,
};
use rand::RngExt;
use robovac_core::{
    math,
    registry::{Example, Explainer, ParamKind, ParamSpec},
    robot::{Drive, SensorReadings},
};

pub(super) const INFO: BehaviourInfo = BehaviourInfo {
    id: "spiral_out",
    title: "Spiral",
    summary: "Drives growing circles to the left until it hits something, then moves on and starts again.",
    claims: BehaviourClaims { cleans: true, ..BehaviourClaims::NONE },
    params: &[
        ParamSpec {
            id: "pitch",
            label: "Circle spacing",
            help: "Distance between circles, relative to the width that one pass cleans.",
            kind: ParamKind::Number { min: 20.0, max: 200.0, step: 5.0, default: 85.0, unit: "%" },
        },
        ParamSpec {
            id: "way",
            label: "Distance between spirals",
            help: "Longest drive before the next spiral; the distance is random.",
            kind: ParamKind::Number { min: 0.5, max: 10.0, step: 0.5, default: 4.0, unit: "m" },
        },
        GO_HOME,
        LEAVE_HOME,
    ],
};

/// Its explanation.
pub(super) const EXPLAINER: Explainer = Explainer {
    idea: "The right wheel runs at full speed and the left one gradually speeds up, so that the robot drives \
           growing circles. Each circle lies just outside the last one, so no floor is cleaned twice until an \
           obstacle is hit. Then the robot moves on in a random direction and starts again where there is room.",
    complexity: "O(1) time and memory per step; no map.",
    use_when: "On open floor, or to clean one spot thoroughly. Among furniture its circles end almost at once.",
    shines: Example { room: "empty", why: "Without obstacles, circles grow until they reach the walls." },
    fails: Example { room: "clutter", why: "No circle closes before a collision." },
    source: "Hasan, Al-Nahid & Reza 2014, Path planning algorithm development for autonomous vacuum cleaner robots, ICIEV: \
             section IV.A.ii",
    link: "https://ieeexplore.ieee.org/document/6850799",
};

pub(super) const BUILD: BuildBehaviour = |setup| {
    let (pitch, way) = (setup.params.number("pitch") / 100.0, setup.params.number("way"));
    Reactive::boxed(setup, SpiralBehaviour::new(setup, pitch, After::MoveOn(way)))
};

/// What follows a spiral.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum After {
    /// Another one, at most so many metres away.
    MoveOn(f64),
    /// Nothing: it is done.
    End,
}

/// The behaviour.
#[derive(Debug, Clone)]
pub(super) struct SpiralBehaviour {
    walk: RandomWalk,
    after: After,
    /// By how much the radius grows for each radian that is turned, m.
    growth: f64,
    phase: SpiralPhase,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum SpiralPhase {
    /// The first circle, about the left wheel, since this heading, rad.
    Check {
        from: f64,
    },
    /// Circles around a point so far to the left of the middle between the wheels, m.
    Circle {
        radius: f64,
    },
    /// Drives on until it is so far ahead, m.
    MoveOn {
        until: f64,
    },
    /// About to begin.
    Begin,
    Done,
}

impl SpiralBehaviour {
    /// With circles that lie `pitch` times the tool's width apart.
    pub(super) fn new(setup: &Setup<'_>, pitch: f64, after: After) -> Self {
        let growth = pitch * setup.robot.tool_width / math::TAU;
        Self { walk: RandomWalk::with(setup, (1.0, 1.0), 0.03), after, growth, phase: SpiralPhase::Begin }
    }

    fn move_on(&mut self, pilot: &mut Pilot) {
        self.phase = match self.after {
            After::MoveOn(way) => {
                SpiralPhase::MoveOn { until: pilot.ahead() + pilot.rng.random_range(0.3..way.max(0.4)) }
            }
            After::End => SpiralPhase::Done,
        };
    }
}

impl Behaviour for SpiralBehaviour {
    fn begin(&mut self, pilot: &mut Pilot) {
        self.walk.begin(pilot);
        self.phase = SpiralPhase::Begin;
    }

    fn roam(&mut self, pilot: &mut Pilot, sensed: &SensorReadings, dt_s: f64) -> Drive {
        let half_base = 0.5 * pilot.robot.wheel_base;
        match self.phase {
            SpiralPhase::Begin => {
                if sensed.light_bumper.contains(&true) {
                    self.move_on(pilot);
                } else {
                    self.phase = SpiralPhase::Check { from: pilot.turned() };
                }
                Drive::STOP
            }
            SpiralPhase::Check { from } => {
                if pilot.turned() - from > math::TAU {
                    self.phase = SpiralPhase::Circle { radius: half_base };
                }
                Drive::wheels(0.0, pilot.speed)
            }
            SpiralPhase::Circle { radius } => {
                let turn_rate = pilot.speed / (radius + half_base);
                self.phase = SpiralPhase::Circle { radius: radius + self.growth * turn_rate * dt_s };
                Drive::wheels(turn_rate * (radius - half_base), pilot.speed)
            }
            SpiralPhase::MoveOn { until } if pilot.ahead() < until => pilot.straight(),
            SpiralPhase::MoveOn { .. } => {
                self.phase = SpiralPhase::Begin;
                Drive::STOP
            }
            SpiralPhase::Done => Drive::STOP,
        }
    }

    fn on_obstruction(&mut self, pilot: &mut Pilot, obstruction: Obstruction) {
        if !matches!(self.phase, SpiralPhase::MoveOn { .. }) {
            self.move_on(pilot);
        }
        self.walk.on_obstruction(pilot, obstruction);
    }

    fn is_done(&self) -> bool {
        self.phase == SpiralPhase::Done
    }

    fn activity(&self) -> &'static str {
        match self.phase {
            SpiralPhase::Circle { .. } => "spiralling out",
            SpiralPhase::MoveOn { .. } => "moving on",
            SpiralPhase::Begin | SpiralPhase::Check { .. } => "checking for free space",
            SpiralPhase::Done => "done",
        }
    }

    fn boxed_clone(&self) -> Box<dyn Behaviour> {
        Box::new(self.clone())
    }
}
