//! Random walk with the corner-escape turn (002, section IV.A.i).
//!
//! Hasan, Al-Nahid & Reza 2014: the robot drives ahead until it senses an obstacle, stops, and turns on the spot, away from
//! the side of the bumper that was hit. It turns for R theta / (720 r N) seconds, which is half of the angle theta that its
//! bumper spans, and for a random time between nothing and as much again. Less, and it could swing to and fro in a corner,
//! touching one wall and the other: "corner escape angle".
//!
//! # Where the paper is silent, or not of one mind
//!
//! - *Backing up.* Section III.A has the robot back up before it turns, section IV.A.i doesn't. A round robot can turn
//!   where it is; one with corners can't. Here it backs up a little, and not at all if the parameter is 0.
//! - *Hit straight ahead*, on both switches: it turns to a random side.
//! - *The printed figure.* R = 12 cm, r = 4 cm, N = 1.2, theta = 120 degrees give 0.4167 s; "0.41" is cut, not rounded.
//! - *Motors* need time to get to speed. A command of T seconds still turns by the formula's angle: the wheels roll on
//!   after it by as much as is missing at the start, and the robot waits for that. Where T is too short to get to
//!   speed, it lasts as long as that angle takes (see [`Timing`]).
//! - *Cliffs* are obstacles, and the robot always backs away from them: on the spot, its wheels could get over the edge.
//!
//! ```
//! use robovac_sim::controller::*;
//! use robovac_core::{registry::Params, robot::*};
//! let info = find("random_walk").unwrap();
//! let (robot, params) = (model("roomba600").unwrap(), Params::defaults(info.params));
//! let mut walker = info.build(&Setup { robot, params: &params, seed: 1 }).unwrap();
//! let ahead = walker.step(&SensorReadings::default(), 0.015);
//! assert!(ahead.left > 0.0 && ahead.left == ahead.right);
//! let bump = SensorReadings { bump_left: true, ..SensorReadings::default() };
//! assert!((0..100).any(|_| { let drive = walker.step(&bump, 0.015); drive.left > 0.0 && drive.right < 0.0 }));
//! assert_eq!(walker.activity(), "turning right");
//! ```

use super::{
    BehaviourClaims, BehaviourInfo, BuildBehaviour, Setup, Timing,
    parts::{Behaviour, By, GO_HOME, LEAVE_HOME, Move, Obstruction, Pilot, Reactive},
};
use rand::RngExt;
use robovac_core::{
    registry::{Example, Explainer, ParamKind, ParamSpec},
    robot::{Drive, SensorReadings},
};

pub(super) const INFO: BehaviourInfo = BehaviourInfo {
    id: "random_walk",
    title: "Random walk",
    summary: "Drives straight until it hits something, then turns far enough to escape any corner, plus a random part.",
    claims: BehaviourClaims { cleans: true, ..BehaviourClaims::NONE },
    params: &[
        ParamSpec {
            id: "least",
            label: "Minimum turn",
            help: "As a multiple of half the angle that the bumper spans, the paper's least turn.",
            kind: ParamKind::Number { min: 0.0, max: 3.0, step: 0.1, default: 1.0, unit: "× paper's" },
        },
        ParamSpec {
            id: "random",
            label: "Random turn",
            help: "Largest random addition, as a multiple of the same angle.",
            kind: ParamKind::Number { min: 0.0, max: 5.0, step: 0.1, default: 1.0, unit: "× paper's" },
        },
        ParamSpec {
            id: "back",
            label: "Back up",
            help: "Distance it backs up before turning; at cliffs always far enough to turn safely.",
            kind: ParamKind::Number { min: 0.0, max: 20.0, step: 0.5, default: 3.0, unit: "cm" },
        },
        GO_HOME,
        LEAVE_HOME,
    ],
};

/// Its explanation.
pub(super) const EXPLAINER: Explainer = Explainer {
    idea: "The robot drives straight until its bumper is pressed or a cliff sensor triggers. Then it turns away \
           from the side of the contact, by at least half of the angle that its bumper spans, so that no corner \
           can trap it. A random extra turn of up to the same size spreads it over the whole floor in time.",
    complexity: "O(1) time and memory per step; no map.",
    use_when: "With the cheapest sensors, when time doesn't matter. It needs no map and never gets stuck, but the \
               last tenth of the floor takes as long as all the rest.",
    shines: Example {
        room: "living",
        why: "It soon reaches every nook of one furnished room: after 20 minutes it is among the best.",
    },
    fails: Example { room: "maze", why: "It passes a doorway only by chance: most of the maze is never reached." },
    source: "Hasan, Al-Nahid & Reza 2014, Path planning algorithm development for autonomous vacuum cleaner robots, ICIEV: \
             section IV.A.i",
    link: "https://ieeexplore.ieee.org/document/6850799",
};

pub(super) const BUILD: BuildBehaviour =
    |setup| Reactive::boxed(setup, RandomWalk::new(setup, setup.params.number("back") / 100.0));

/// The behaviour.
#[derive(Debug, Clone)]
pub(super) struct RandomWalk {
    /// Wheel speed of turns, m/s.
    speed: f64,
    /// Minimum turn, and most that is added at random, rad.
    turn: (f64, f64),
    back: f64,
}

impl RandomWalk {
    /// With the parameters `least` and `random` of `setup`, and `back` metres to back up.
    pub(super) fn new(setup: &Setup<'_>, back: f64) -> Self {
        Self::with(setup, (setup.params.number("least"), setup.params.number("random")), back)
    }

    /// As in the paper, but with these `shares` of the least and the random turn.
    pub(super) fn with(setup: &Setup<'_>, shares: (f64, f64), back: f64) -> Self {
        let speed = setup.robot.cruise_speed;
        let theta_deg = 2.0 * setup.robot.sensors.bumper.map_or(90.0, |bumper| bumper.half_arc.to_degrees());
        let seconds = Timing::of(setup.robot).corner_escape_s(theta_deg);
        let angle = seconds * 2.0 * speed / setup.robot.wheel_base;
        Self { speed, turn: (angle * shares.0, angle * shares.1), back }
    }
}

impl Behaviour for RandomWalk {
    fn begin(&mut self, pilot: &mut Pilot) {
        pilot.turn_speed = self.speed;
        pilot.by = By::Time;
    }

    fn roam(&mut self, pilot: &mut Pilot, _: &SensorReadings, _: f64) -> Drive {
        pilot.straight()
    }

    fn on_obstruction(&mut self, pilot: &mut Pilot, obstruction: Obstruction) {
        let turn = self.turn.0 + self.turn.1 * pilot.rng.random_range(0.0..1.0);
        let way = pilot.away_from(obstruction);
        pilot.answer(obstruction, self.back, &[Move::Turn(way * turn)]);
    }

    fn activity(&self) -> &'static str {
        "driving straight"
    }

    fn boxed_clone(&self) -> Box<dyn Behaviour> {
        Box::new(self.clone())
    }
}
