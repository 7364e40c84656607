//! Phase 5: forward until an obstacle, then rotate (004, chapter 7).
//!
//! Krapinec 2025 drops chance: the robot drives forward until it detects an obstacle in its path, then rotates in one
//! direction until none is in front of it. The thesis' Image 7.1 (lost) shows a room in which that goes round for ever;
//! `tests/algorithms/behaviours/exploring.rs` has such a room, in which the motion becomes periodic.
//!
//! # Where the thesis is silent
//!
//! - *In its path*: one of the four light sensors in front reports something.
//! - *The direction*: "one direction", always the same one; a parameter says which.
//! - *A contact* that the light bumper missed, as all are for a robot without a light bumper: the robot backs up and rotates by
//!   a fixed angle (ours).
//! - *Edges of the floor and virtual walls*: the robot backs off and turns away by a random angle.
//!
//! ```
//! use robovac_sim::controller::*;
//! use robovac_core::{registry::Params, robot::*};
//! let info = find("explore_until_obstacle").unwrap();
//! let (robot, params) = (model("roomba600").unwrap(), Params::defaults(info.params));
//! let mut explorer = info.build(&Setup { robot, params: &params, seed: 1 }).unwrap();
//! let ahead = explorer.step(&SensorReadings::default(), 0.015);
//! assert!(ahead.left > 0.0 && ahead.left == ahead.right);
//! let wall = SensorReadings { light_bumper: [false, false, false, true, true, false], ..SensorReadings::default() };
//! let turning = explorer.step(&wall, 0.015);
//! assert!(turning.left < 0.0 && turning.right > 0.0);
//! ```

use super::{THESIS, obstacles::SensedObstacles, turn_back};
use crate::controller::{
    BehaviourClaims, BehaviourInfo, BuildBehaviour,
    parts::{Behaviour, By, Move, Obstruction, ObstructionKind, Pilot, Reactive},
};
use robovac_core::{
    registry::{Example, Explainer, ParamKind, ParamSpec},
    robot::{Drive, SensorReadings},
};

/// Way back after a contact, m.
const BACK: f64 = 0.02;

pub(in crate::controller) const INFO: BehaviourInfo = BehaviourInfo {
    id: "explore_until_obstacle",
    title: "Until an obstacle",
    summary: "Drives forward until something is in its path, then rotates in one direction until the path is clear.",
    claims: BehaviourClaims { explores: true, ..BehaviourClaims::NONE },
    params: &[
        ParamSpec {
            id: "direction",
            label: "Rotates",
            help: "Direction in which it rotates away from obstacles.",
            kind: ParamKind::Choice { options: &[("left", "to the left"), ("right", "to the right")] },
        },
        ParamSpec {
            id: "angle",
            label: "After a contact",
            help: "Angle by which it rotates away from an obstacle that only the bumper detected.",
            kind: ParamKind::Number { min: 5.0, max: 180.0, step: 5.0, default: 30.0, unit: "°" },
        },
    ],
};

/// Its explanation.
pub(in crate::controller) const EXPLAINER: Explainer = Explainer {
    idea: "The robot drives straight until something is in its path. It rotates, always in the same direction, \
           until nothing is in front, and drives on. So it circulates along whatever encloses it.",
    complexity: "O(1) time and memory per step; no map.",
    use_when: "To see why a rule without randomness or memory isn't enough: it can repeat the same loop for ever.",
    shines: Example { room: "room12ft", why: "In a small room, furniture keeps changing its course." },
    fails: Example { room: "flat", why: "It circles the same few pieces of furniture and misses every door." },
    source: "Krapinec 2025, Enhancing Robotic Vacuum Cleaner Performance through Improved Map Building, master's thesis, \
             FER Zagreb: chapter 7, phase 5",
    link: THESIS,
};

pub(in crate::controller) const BUILD: BuildBehaviour = |setup| {
    let way = if setup.params.choice("direction") == "right" { -1.0 } else { 1.0 };
    Reactive::boxed(setup, UntilObstacle { way, angle: setup.params.number("angle").to_radians(), is_turning: false })
};

/// The behaviour.
#[derive(Debug, Clone)]
struct UntilObstacle {
    /// 1 to rotate counter-clockwise, -1 for clockwise.
    way: f64,
    /// Rotation after a contact, rad.
    angle: f64,
    is_turning: bool,
}

impl Behaviour for UntilObstacle {
    fn begin(&mut self, pilot: &mut Pilot) {
        pilot.turn_speed = pilot.robot.turn_wheel_speed;
        pilot.by = By::Counts;
    }

    fn roam(&mut self, pilot: &mut Pilot, sensed: &SensorReadings, _: f64) -> Drive {
        self.is_turning = SensedObstacles::of(sensed, None).in_path;
        if self.is_turning { pilot.twist(0.0, self.way * pilot.robot.turn_rate()) } else { pilot.straight() }
    }

    fn on_obstruction(&mut self, pilot: &mut Pilot, obstruction: Obstruction) {
        if obstruction.kind == ObstructionKind::Bump {
            pilot.answer(obstruction, BACK, &[Move::Turn(self.way * self.angle)]);
        } else {
            turn_back(pilot, obstruction);
        }
    }

    fn activity(&self) -> &'static str {
        if self.is_turning { "turning until the path is clear" } else { "driving straight" }
    }

    fn boxed_clone(&self) -> Box<dyn Behaviour> {
        Box::new(self.clone())
    }
}
