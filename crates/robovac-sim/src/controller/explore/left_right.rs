//! Phase 2: rotations to the left and to the right (004, chapter 7).
//!
//! Krapinec 2025 adds a third option to phase 1: the rotation is to the left or to the right, by the same angle. Turns make
//! up two thirds of what it does, and half of them undo the other half. Figures, edges and the end are as in phase 1.
//!
//! ```
//! use robovac_sim::controller::*;
//! use robovac_core::{registry::Params, robot::*};
//! let info = find("explore_left_right").unwrap();
//! let (robot, params) = (model("roomba600").unwrap(), Params::defaults(info.params));
//! let mut explorer = info.build(&Setup { robot, params: &params, seed: 1 }).unwrap();
//! // It turns both ways, with wheels that follow commands exactly.
//! let (mut turned, mut rolled) = ([false; 2], [0.0; 2]);
//! for _ in 0..4000 {
//!     let [left_counts, right_counts] = rolled.map(|metres: f64| (metres * robot.counts_per_metre) as i64 as u16);
//!     let drive = explorer.step(&SensorReadings { left_counts, right_counts, ..SensorReadings::default() }, 0.015);
//!     rolled = [rolled[0] + 0.015 * drive.left, rolled[1] + 0.015 * drive.right];
//!     turned = [turned[0] | (drive.left < drive.right), turned[1] | (drive.left > drive.right)];
//! }
//! assert_eq!(turned, [true, true]);
//! ```

use super::{
    THESIS,
    options::{ANGLE, DISTANCE, Options, PUSHES, Rules},
};
use crate::controller::{BehaviourClaims, BehaviourInfo, BuildBehaviour, parts::Reactive};
use robovac_core::registry::{Example, Explainer};

pub(in crate::controller) const INFO: BehaviourInfo = BehaviourInfo {
    id: "explore_left_right",
    title: "Forward, left or right",
    summary: "Drives a fixed distance forward or rotates left or right by a fixed angle, at random, without sensing.",
    claims: BehaviourClaims { explores: true, ..BehaviourClaims::NONE },
    params: &[DISTANCE, ANGLE, PUSHES],
};

/// Its explanation.
pub(in crate::controller) const EXPLAINER: Explainer = Explainer {
    idea: "One of three motions is chosen at random: a fixed distance forward, or a fixed rotation to the left or \
        to the right. When it ends, the next one is chosen. Sensor readings don't influence the choice.",
    complexity: "O(1) time and memory per step; it stores at most the last contact.",
    use_when: "To see what a second direction of rotation changes: the heading wanders instead of always turning one \
               way.",
    shines: Example { room: "room12ft", why: "In a small room chance leads it to most walls in time." },
    fails: Example {
        room: "flat",
        why: "Two motions out of three are rotations, so it makes little progress: the next rooms stay unknown.",
    },
    source: "Krapinec 2025, Enhancing Robotic Vacuum Cleaner Performance through Improved Map Building, master's thesis, \
             FER Zagreb: chapter 7, phase 2",
    link: THESIS,
};

/// Phase 2.
const RULES: Rules = Rules { turns_right: true, looks_ahead: false, looks_aside: false };

pub(in crate::controller) const BUILD: BuildBehaviour = |setup| Reactive::boxed(setup, Options::new(setup, RULES));
