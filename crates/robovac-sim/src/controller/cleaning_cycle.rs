//! Cleaning cycle: random walk, spiral, S-shaped path and wall follow in turn (002, section IV.A, "Cleaning Cycle").
//!
//! Hasan, Al-Nahid & Reza 2014: the robot executes its four algorithms one after another "until the whole surface area is fully
//! cleaned"; how long each of them runs is set by the user, or else at random. Figure 18 shows that the cycle covers a room
//! of 12 ft x 12 ft sooner than each of the four alone.
//!
//! # Where the paper is silent
//!
//! - *When the floor is clean* the robot can't know: it has no map. It goes on until a time that can be set, or for ever.
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
//!     cycle.step(&Sensors::default(), 0.015);
//!     seen.push(cycle.activity());
//! }
//! seen.dedup();
//! assert_eq!(&seen[..3], ["driving straight", "looking whether there is room", "driving a lane"]);
//! ```

use super::{
    BehaviourInfo, Build, Claims, Setup,
    parts::{By, Driven, GO_HOME, Habit, Hit, LEAVE_HOME, Pilot},
    random_walk::RandomWalk,
    s_path::SPath,
    spiral::{After, Spiral},
    wall_follow::WallFollow,
};
use rand::RngExt;
use robovac_core::{
    registry::{Example, Explainer, ParamKind, ParamSpec},
    robot::{Drive, Sensors},
};

/// A time for one of the four, s.
const fn seconds(id: &'static str, label: &'static str, help: &'static str, default: f64) -> ParamSpec {
    ParamSpec { id, label, help, kind: ParamKind::Number { min: 0.0, max: 600.0, step: 5.0, default, unit: "s" } }
}

pub(super) const INFO: BehaviourInfo = BehaviourInfo {
    id: "cleaning_cycle",
    title: "Cleaning cycle",
    summary: "Walks at random, spirals, drives lanes and follows walls in turn, for a time each.",
    source: "Hasan, Al-Nahid & Reza 2014, Path planning algorithm development for autonomous vacuum cleaner robots, ICIEV: \
             section IV.A, Cleaning Cycle",
    link: "https://ieeexplore.ieee.org/document/6850799",
    explainer: Explainer {
        idea: "Random walk, spiral, S-shaped path and wall follow take turns, each for a time that is set or drawn at random. \
               Where one is bad another is good: lanes and spirals clean open floor fast, walls bring it into corners, and chance into the next room. \
               As the robot can't know when the floor is clean, it goes on until it is stopped.",
        complexity: "O(1) time and memory a step.",
        use_when: "When nothing is known of the room. It is seldom the best, and never the worst.",
        shines: Example {
            room: "thesis226",
            why: "One room with blocks in it, where each of the four finds something to do.",
        },
        fails: Example {
            room: "clutter",
            why: "Three of the four can do nothing among so many things, and take their time all the same.",
        },
    },
    claims: Claims { ends: false, cleans: true, manual: false, explores: false },
    params: &[
        ParamSpec {
            id: "durations",
            label: "Times",
            help: "Whether the time of each is drawn at random, as in the paper if nothing is set, or as set below.",
            kind: ParamKind::Choice { options: &[("random", "at random"), ("set", "as set")] },
        },
        seconds("shortest", "Shortest", "At random: shortest time of each.", 20.0),
        seconds("longest", "Longest", "At random: longest time of each.", 90.0),
        seconds("random_walk", "Random walk", "As set: how long it walks at random; 0 to leave it out.", 60.0),
        seconds("spiral", "Spiral", "As set: how long a spiral takes at most; 0 to leave it out.", 60.0),
        seconds("s_path", "S-shaped path", "As set: how long it drives lanes; 0 to leave it out.", 60.0),
        seconds("wall_follow", "Wall follow", "As set: how long it follows walls; 0 to leave it out.", 60.0),
        ParamSpec {
            id: "minutes",
            label: "Ends after",
            help: "Time after which it stops; 0 for never.",
            kind: ParamKind::Number { min: 0.0, max: 600.0, step: 1.0, default: 0.0, unit: "min" },
        },
        GO_HOME,
        LEAVE_HOME,
    ],
};

pub(super) const BUILD: Build = |setup| Driven::boxed(setup, CleaningCycle::new(setup));

/// The habit.
struct CleaningCycle {
    parts: [Box<dyn Habit>; 4],
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
            // Nobody can take no time at all in turn for ever.
            let shortest = number("shortest").max(1.0);
            Times::Random(shortest, number("longest").max(shortest))
        };
        let minutes = number("minutes");
        Self {
            parts: [
                Box::new(RandomWalk::with(setup, (1.0, 1.0), 0.03)),
                Box::new(Spiral::new(setup, 0.85, After::End)),
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

impl Habit for CleaningCycle {
    fn begin(&mut self, pilot: &mut Pilot) {
        self.start(pilot);
    }

    fn watch(&mut self, _: &Sensors, dt_s: f64) {
        self.left -= dt_s;
        self.left_in_all -= dt_s;
    }

    fn roam(&mut self, pilot: &mut Pilot, sensed: &Sensors, dt_s: f64) -> Drive {
        if self.left <= 0.0 || self.parts[self.present].is_done() {
            self.present = (self.present + 1) % self.parts.len();
            self.start(pilot);
        }
        self.parts[self.present].roam(pilot, sensed, dt_s)
    }

    fn hit(&mut self, pilot: &mut Pilot, hit: Hit) {
        self.parts[self.present].hit(pilot, hit);
    }

    fn is_done(&self) -> bool {
        self.left_in_all <= 0.0
    }

    fn activity(&self) -> &'static str {
        if self.is_done() { "done" } else { self.parts[self.present].activity() }
    }

    fn boxed_clone(&self) -> Box<dyn Habit> {
        let parts = [0, 1, 2, 3].map(|i| self.parts[i].boxed_clone());
        Box::new(Self { parts, ..*self })
    }
}
