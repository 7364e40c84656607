//! Cleaning cycle: random walk, spiral, S-shaped path and wall follow in turn (002, section IV.A, "Cleaning Cycle").
//!
//! Hasan, Al-Nahid & Reza 2014: the robot executes its four algorithms one after another "until the whole surface area is fully
//! cleaned"; how long each of them runs is set by the user, or else at random. Figure 18 shows that the cycle covers a room
//! of 12 ft x 12 ft sooner than each of the four alone.
//!
//! # Where the paper is silent
//!
//! - *When the floor is clean* is unknown to a robot without a map. It continues for a time that can be set, or for
//!   ever.
//! - *How long at random*: each time, the time is drawn between two limits, which can be set as well.
//! - *A spiral that ends* at an obstacle hands over before its time is up.
//! - *Handing over* waits until the robot is done with turning away from something.
//!
//! ```
//! use robovac_sim::controller::*;
//! use robovac_core::{registry::Params, robot::*};
//! let info = find("cleaning_cycle").unwrap();
//! let (robot, params) = (model("roomba600").unwrap(), Params::defaults(info.params));
//! let mut cycle = info.build(&Setup { robot, params: &params, seed: 1 }).unwrap();
//! let mut seen = Vec::new();
//! for _ in 0..20_000 {
//!     cycle.step(&SensorReadings::default(), 0.015);
//!     seen.push(cycle.activity());
//! }
//! seen.dedup();
//! assert_eq!(&seen[..3], ["driving straight", "checking for free space", "driving a lane"]);
//! ```

use super::{
    BehaviourClaims, BehaviourInfo, BuildBehaviour, Setup,
    parts::{Behaviour, By, GO_HOME, LEAVE_HOME, Obstruction, Pilot, Reactive},
    random_walk::RandomWalk,
    s_path::SPath,
    spiral::{After, SpiralBehaviour},
    wall_follow::WallFollow,
};
use rand::RngExt;
use robovac_core::{
    registry::{Example, Explainer, ParamKind, ParamSpec},
    robot::{Drive, SensorReadings},
};

/// A time for one of the four, s.
const fn seconds(id: &'static str, label: &'static str, help: &'static str, default: f64) -> ParamSpec {
    ParamSpec { id, label, help, kind: ParamKind::Number { min: 0.0, max: 600.0, step: 5.0, default, unit: "s" } }
}

pub(super) const INFO: BehaviourInfo = BehaviourInfo {
    id: "cleaning_cycle",
    title: "Cleaning cycle",
    summary: "Alternates between random walk, spiral, S-shaped path and wall following, each for a limited time.",
    claims: BehaviourClaims { cleans: true, ..BehaviourClaims::NONE },
    params: &[
        ParamSpec {
            id: "durations",
            label: "Times",
            help: "Random durations, as in the paper by default, or the durations set below.",
            kind: ParamKind::Choice { options: &[("random", "at random"), ("set", "as set")] },
        },
        seconds("shortest", "Shortest", "Random: shortest duration of each.", 20.0),
        seconds("longest", "Longest", "Random: longest duration of each.", 90.0),
        seconds("random_walk", "Random walk", "As set: duration of the random walk; 0 skips it.", 60.0),
        seconds("spiral", "Spiral", "As set: longest duration of a spiral; 0 skips it.", 60.0),
        seconds("s_path", "S-shaped path", "As set: duration of the S-shaped path; 0 skips it.", 60.0),
        seconds("wall_follow", "Wall follow", "As set: duration of wall following; 0 skips it.", 60.0),
        ParamSpec {
            id: "minutes",
            label: "Ends after",
            help: "Total running time; 0 for no limit.",
            kind: ParamKind::Number { min: 0.0, max: 600.0, step: 1.0, default: 0.0, unit: "min" },
        },
        GO_HOME,
        LEAVE_HOME,
    ],
};

/// Its explanation.
pub(super) const EXPLAINER: Explainer = Explainer {
    idea: "Random walk, spiral, S-shaped path and wall following alternate, each for a fixed or random time. They \
           complement each other: lanes and spirals clean open floor fast, wall following reaches corners, and the \
           random walk finds the next room. The robot can't know when the floor is clean, so it runs until it is \
           stopped.",
    complexity: "O(1) time and memory per step.",
    use_when: "When nothing is known about the room: in most rooms it cleans as much as the best of the four, or more.",
    shines: Example {
        room: "bedroom",
        why: "Wall following leads it round the furniture, and the others clean what lies between.",
    },
    fails: Example {
        room: "maze",
        why: "In narrow passages only wall following makes progress, and it is just one of the four.",
    },
    source: "Hasan, Al-Nahid & Reza 2014, Path planning algorithm development for autonomous vacuum cleaner robots, ICIEV: \
             section IV.A, Cleaning Cycle",
    link: "https://ieeexplore.ieee.org/document/6850799",
};

pub(super) const BUILD: BuildBehaviour = |setup| Reactive::boxed(setup, CleaningCycle::new(setup));

/// The behaviour.
struct CleaningCycle {
    parts: [Box<dyn Behaviour>; 4],
    times: Times,
    present: usize,
    /// Time left for the present one and for all, s.
    left: f64,
    left_in_all: f64,
}

#[derive(Debug, Clone, Copy)]
enum Times {
    /// Between these, s.
    Random(f64, f64),
    Set([f64; 4]),
}

impl CleaningCycle {
    fn new(setup: &Setup<'_>) -> Self {
        let number = |id| setup.params.number(id);
        let set = ["random_walk", "spiral", "s_path", "wall_follow"].map(number);
        let times = if setup.params.choice("durations") == "set" && set.iter().any(|&time| time > 0.0) {
            Times::Set(set)
        } else {
            // At least a second, as turns of 0 s would never end.
            let shortest = number("shortest").max(1.0);
            Times::Random(shortest, number("longest").max(shortest))
        };
        let minutes = number("minutes");
        Self {
            parts: [
                Box::new(RandomWalk::with(setup, (1.0, 1.0), 0.03)),
                Box::new(SpiralBehaviour::new(setup, 0.85, After::End)),
                Box::new(SPath::new(setup, 1.0, By::Time, 4)),
                Box::new(WallFollow::usual(setup)),
            ],
            times,
            present: 0,
            left: 0.0,
            left_in_all: if minutes > 0.0 { 60.0 * minutes } else { f64::INFINITY },
        }
    }

    fn start(&mut self, pilot: &mut Pilot) {
        for _ in 0..self.parts.len() {
            self.left = match self.times {
                Times::Random(shortest, longest) => shortest + (longest - shortest) * pilot.rng.random_range(0.0..1.0),
                Times::Set(times) => times[self.present],
            };
            if self.left > 0.0 {
                break;
            }
            self.present = (self.present + 1) % self.parts.len();
        }
        self.parts[self.present].begin(pilot);
    }
}

impl Behaviour for CleaningCycle {
    fn begin(&mut self, pilot: &mut Pilot) {
        self.start(pilot);
    }

    fn watch(&mut self, _: &SensorReadings, dt_s: f64) {
        self.left -= dt_s;
        self.left_in_all -= dt_s;
    }

    fn roam(&mut self, pilot: &mut Pilot, sensed: &SensorReadings, dt_s: f64) -> Drive {
        if self.left <= 0.0 || self.parts[self.present].is_done() {
            self.present = (self.present + 1) % self.parts.len();
            self.start(pilot);
        }
        self.parts[self.present].roam(pilot, sensed, dt_s)
    }

    fn on_obstruction(&mut self, pilot: &mut Pilot, obstruction: Obstruction) {
        self.parts[self.present].on_obstruction(pilot, obstruction);
    }

    fn is_done(&self) -> bool {
        self.left_in_all <= 0.0
    }

    fn activity(&self) -> &'static str {
        if self.is_done() { "done" } else { self.parts[self.present].activity() }
    }

    fn boxed_clone(&self) -> Box<dyn Behaviour> {
        let parts = [0, 1, 2, 3].map(|i| self.parts[i].boxed_clone());
        Box::new(Self { parts, ..*self })
    }
}
