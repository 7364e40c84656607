//! Phase 3: looking before moving (004, chapter 7).
//!
//! Krapinec 2025 has the robot read its sensors before it moves forward. With an obstacle directly ahead it stays and draws
//! again from the three options of phase 2, so that odometry is no longer misled by walls.
//!
//! # Where the thesis is silent
//!
//! - *Directly ahead*: one of the two middle light sensors reports something, or the bumper does.
//! - *A contact on the way* (a leg between two beams, or a robot without a light bumper) ends the motion. The robot backs up
//!   by 2 cm, and the contact counts as an obstacle ahead until it has turned away from it by 45 degrees (ours).
//! - Figures, edges and the end are as in phase 1.
//!
//! ```
//! use robovac_sim::controller::*;
//! use robovac_core::{registry::Params, robot::*};
//! let info = find("explore_look_ahead").unwrap();
//! let (robot, params) = (model("roomba600").unwrap(), Params::defaults(info.params));
//! let mut explorer = info.build(&Setup { robot, params: &params, seed: 1 }).unwrap();
//! // With a wall ahead it never drives forward.
//! let wall = SensorReadings { light_bumper: [false, true, true, true, true, false], ..SensorReadings::default() };
//! for counts in 0..2000_u16 {
//!     let drive = explorer.step(&SensorReadings { left_counts: counts, ..wall.clone() }, 0.015);
//!     assert!(drive.left + drive.right <= 0.0);
//! }
//! ```

use super::{
    THESIS,
    options::{ANGLE, DISTANCE, Options, Rules},
};
use crate::controller::{BehaviourClaims, BehaviourInfo, BuildBehaviour, parts::Reactive};
use robovac_core::registry::{Example, Explainer};

pub(in crate::controller) const INFO: BehaviourInfo = BehaviourInfo {
    id: "explore_look_ahead",
    title: "Look before moving",
    summary: "Moves forward, left or right at random, but not forward when something is directly ahead.",
    claims: BehaviourClaims { explores: true, ..BehaviourClaims::NONE },
    params: &[DISTANCE, ANGLE],
};

/// Its explanation.
pub(in crate::controller) const EXPLAINER: Explainer = Explainer {
    idea: "One of three motions is chosen at random: a fixed distance forward, or a fixed rotation to the left or \
        to the right. Before driving forward, the robot checks its sensors. If something is directly ahead, it \
        chooses again.",
    complexity: "O(1) time and memory per step; it stores at most the last contact.",
    use_when: "To see the effect of checking ahead: walls no longer corrupt odometry, but a random walk is slow.",
    shines: Example {
        room: "kitchen",
        why: "In a single furnished room, chance leads it to more than half of the walls and furniture.",
    },
    fails: Example { room: "flat", why: "It is still a random walk: the next rooms stay unknown." },
    source: "Krapinec 2025, Enhancing Robotic Vacuum Cleaner Performance through Improved Map Building, master's thesis, \
             FER Zagreb: chapter 7, phase 3",
    link: THESIS,
};

/// Phase 3.
const RULES: Rules = Rules { turns_right: true, looks_ahead: true, looks_aside: false };

pub(in crate::controller) const BUILD: BuildBehaviour = |setup| Reactive::boxed(setup, Options::new(setup, RULES));
