//! S-shaped pathway: lane beside lane, by the clock (002, section IV.A.iii).
//!
//! Hasan, Al-Nahid & Reza 2014: after every collision the robot goes back by L / 3, turns by 90 degrees, goes on by L, and turns
//! by 90 degrees the same way; the sides alternate. All of it is timed: back L / (6 pi r N), turn R / (4 r N), go L / (2 pi r N)
//! seconds, for the DVR-1 0.16 s, 0.625 s and 0.48 s (see [`Timing`] for L).
//!
//! # Where the paper is silent, or not of one mind
//!
//! - *"90° turn (right/left), go, 90° turn (left/right)"* could be read as a step aside that ends in the old direction. It
//!   would run into the same wall again; the figure's parallel lanes and the alternating sides ask for both turns to one side.
//! - *A collision on the short way aside*, in a corner: taken like any other, with the sides alternating, the robot
//!   would turn back into the corner, hit it, turn again, and never leave it. Here it turns to the same side as
//!   before, so that the lanes then run along the wall that was met.
//! - *Round in circles.* Wheels that err, as all real ones do, make every lane a little different; in a simulation without
//!   slip the robot would drive the same lanes for ever. After a number of collisions without a lane longer than three L
//!   between them, or once the lanes have been turned several times, it turns by a random angle and goes on from there.
//! - *Motors* need time to get to speed; see [`random_walk`](super::random_walk). For the Roomba, 0.16 s would be half of the
//!   time that it takes to get to full speed; it backs up for as long as L / 3 takes.
//!
//! ```
//! use robovac_sim::controller::*;
//! use robovac_core::{registry::Params, robot::*};
//! let info = find("s_path").unwrap();
//! let (robot, params) = (model("roomba600").unwrap(), Params::defaults(info.params));
//! let mut lanes = info.build(&Setup { robot, params: &params, seed: 1 }).unwrap();
//! assert_eq!(lanes.activity(), "driving a lane");
//! lanes.step(&SensorReadings { bump_right: true, ..SensorReadings::default() }, 0.015);
//! assert_eq!(lanes.activity(), "backing up");
//! ```

use super::{
    BehaviourClaims, BehaviourInfo, BuildBehaviour, Setup, Timing,
    parts::{Behaviour, By, GO_HOME, LEAVE_HOME, Move, Obstruction, Pilot, Reactive},
};
use rand::RngExt;
use robovac_core::{
    math,
    registry::{Example, Explainer, ParamKind, ParamSpec},
    robot::{Drive, SensorReadings},
};

/// Collisions in a row without a lane between them after which the robot turns by a random angle.
const MOST_SHORT: u32 = 5;
/// A lane is longer than so many L.
const LANE: f64 = 3.0;

pub(super) const INFO: BehaviourInfo = BehaviourInfo {
    id: "s_path",
    title: "S-shaped path",
    summary: "Drives parallel lanes: at every collision it backs up, turns, shifts by one lane, and turns again.",
    claims: BehaviourClaims { cleans: true, ..BehaviourClaims::NONE },
    params: &[
        ParamSpec {
            id: "lane",
            label: "Lane spacing",
            help: "Distance between lanes, relative to L, the width that one pass cleans.",
            kind: ParamKind::Number { min: 20.0, max: 300.0, step: 5.0, default: 100.0, unit: "%" },
        },
        ParamSpec {
            id: "by",
            label: "Measure moves",
            help: "Measure turns and distances by time, by the wheel encoders, or by the paper's times, which ignore \
                   the time that motors need to get up to speed.",
            kind: ParamKind::Choice {
                options: &[("time", "by time"), ("encoder", "by encoders"), ("printed", "printed times")],
            },
        },
        ParamSpec {
            id: "again",
            label: "Change direction",
            help: "Each corner turns the lanes by a right angle; after this many corners the turn is random.",
            kind: ParamKind::Number { min: 1.0, max: 20.0, step: 1.0, default: 4.0, unit: "" },
        },
        GO_HOME,
        LEAVE_HOME,
    ],
};

/// Its explanation.
pub(super) const EXPLAINER: Explainer = Explainer {
    idea: "The robot drives straight until it hits something, backs up a little, and returns one lane further. \
           Left and right turns alternate, so that the path looks like the letter S. In a corner it continues \
           along the other wall.",
    complexity: "O(1) time and memory per step; it stores only the direction of its last turn.",
    use_when: "In rooms with few, straight obstacles, where hardly any floor is cleaned twice. Wheel slip bends \
               the lanes, and floor behind furniture may stay uncovered for long.",
    shines: Example { room: "empty", why: "Parallel lanes from wall to wall, with hardly any floor cleaned twice." },
    fails: Example { room: "clutter", why: "Lanes end almost at once, and every collision costs four motions." },
    source: "Hasan, Al-Nahid & Reza 2014, Path planning algorithm development for autonomous vacuum cleaner robots, ICIEV: \
             section IV.A.iii",
    link: "https://ieeexplore.ieee.org/document/6850799",
};

pub(super) const BUILD: BuildBehaviour = |setup| {
    let by = if setup.params.choice("by") == "encoder" { By::Counts } else { By::Time };
    let share = setup.params.number("lane") / 100.0;
    let path = SPath::new(setup, share, by, setup.params.number("again") as u32);
    let is_printed = setup.params.choice("by") == "printed";
    let printed = is_printed.then(|| PrintedTimes::of(&Timing::of(setup.robot), share));
    Reactive::boxed(setup, SPath { printed, ..path })
};

/// The printed times of the motions after a bump, s.
#[derive(Debug, Clone, Copy)]
struct PrintedTimes {
    back: f64,
    turn: f64,
    go: f64,
}

impl PrintedTimes {
    /// With lanes `share` of L apart.
    fn of(timing: &Timing, share: f64) -> Self {
        Self { back: timing.back_s(), turn: timing.turn_s(), go: share * timing.go_s() }
    }
}

/// The behaviour.
#[derive(Debug, Clone)]
pub(super) struct SPath {
    by: By,
    /// If the moves after a bump last as printed.
    printed: Option<PrintedTimes>,
    turn_speed: f64,
    /// Distances back, and from lane to lane, m.
    back: f64,
    go: f64,
    /// Corners before it turns by a random angle.
    most_corners: u32,
    corners: u32,
    /// Next direction of turn: 1 for left, -1 for right.
    side: f64,
    /// Start of the lane, m ahead; `None` during the move to the next lane.
    lane_from: Option<f64>,
    short: u32,
}

impl SPath {
    /// With lanes `share` of L apart.
    pub(super) fn new(setup: &Setup<'_>, share: f64, by: By, most_corners: u32) -> Self {
        let lane = Timing::of(setup.robot).lane;
        Self {
            by,
            printed: None,
            turn_speed: setup.robot.cruise_speed,
            back: lane / 3.0,
            go: share * lane,
            most_corners,
            corners: 0,
            side: 1.0,
            lane_from: Some(0.0),
            short: 0,
        }
    }
}

impl Behaviour for SPath {
    fn begin(&mut self, pilot: &mut Pilot) {
        pilot.turn_speed = self.turn_speed;
        pilot.by = self.by;
        self.lane_from = Some(pilot.ahead());
        (self.corners, self.short) = (0, 0);
    }

    fn roam(&mut self, pilot: &mut Pilot, _: &SensorReadings, _: f64) -> Drive {
        if self.lane_from.is_none() {
            self.lane_from = Some(pilot.ahead());
            self.side = -self.side;
        }
        pilot.straight()
    }

    fn on_obstruction(&mut self, pilot: &mut Pilot, obstruction: Obstruction) {
        let lane = self.lane_from.take().map(|from| pilot.ahead() - from);
        self.short = if lane.is_some_and(|length| length > LANE * self.go) { 0 } else { self.short + 1 };
        self.corners += u32::from(lane.is_none());
        let turn = if self.short >= MOST_SHORT || self.corners > self.most_corners {
            (self.short, self.corners) = (0, 0);
            let angle = pilot.rng.random_range(0.5..1.5) * math::FRAC_PI_2;
            self.lane_from = Some(pilot.ahead());
            pilot.answer(obstruction, self.back, &[Move::Turn(self.side * angle)]);
            return;
        } else {
            Move::Turn(self.side * math::FRAC_PI_2)
        };
        let moves = [turn, Move::Ahead(self.go), turn];
        let Some(times) = self.printed else { return pilot.answer(obstruction, self.back, &moves) };
        let (ahead, aside) = (Drive::wheels(pilot.speed, pilot.speed), self.side * self.turn_speed);
        let turn = Move::Timed(Drive::wheels(-aside, aside), times.turn);
        let timed = [Move::Timed(ahead.times(-1.0), times.back), turn, Move::Timed(ahead, times.go), turn];
        pilot.answer_timed(obstruction, &timed, self.back, &moves);
    }

    fn activity(&self) -> &'static str {
        "driving a lane"
    }

    fn boxed_clone(&self) -> Box<dyn Behaviour> {
        Box::new(self.clone())
    }
}
