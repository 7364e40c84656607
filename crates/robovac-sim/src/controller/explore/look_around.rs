//! Phase 4: looking after every option is drawn (004, chapter 7).
//!
//! Krapinec 2025 has the robot process what it senses after selecting any option: if an obstacle is detected solely on the
//! side that it is to rotate to, it doesn't rotate; with obstacles on both sides it rotates as selected.
//!
//! # Where the thesis is silent
//!
//! - *The sides*: the two outer light sensors of a side, or a contact there. The rest is as in phase 3.
//!
//! ```
//! use robovac_sim::controller::*;
//! use robovac_core::{registry::Params, robot::*};
//! let info = find("explore_look_around").unwrap();
//! let (robot, params) = (model("roomba600").unwrap(), Params::defaults(info.params));
//! let mut explorer = info.build(&Setup { robot, params: &params, seed: 1 }).unwrap();
//! // With a wall on the left alone it turns right.
//! let wall = SensorReadings { light_bumper: [true, true, true, false, false, false], ..SensorReadings::default() };
//! for counts in 0..2000_u16 {
//!     let drive = explorer.step(&SensorReadings { left_counts: counts, ..wall.clone() }, 0.015);
//!     assert!(drive.left >= drive.right);
//! }
//! ```

use super::{
    THESIS,
    options::{ANGLE, DISTANCE, Options, Rules},
};
use crate::controller::{BehaviourClaims, BehaviourInfo, BuildBehaviour, parts::Reactive};
use robovac_core::registry::{Example, Explainer};

pub(in crate::controller) const INFO: BehaviourInfo = BehaviourInfo {
    id: "explore_look_around",
    title: "Look around",
    summary: "Moves forward, left or right at random, but never towards an obstacle.",
    claims: BehaviourClaims { explores: true, ..BehaviourClaims::NONE },
    params: &[DISTANCE, ANGLE],
};

/// Its explanation.
pub(in crate::controller) const EXPLAINER: Explainer = Explainer {
    idea: "One of three motions is chosen at random: a fixed distance forward, or a fixed rotation to the left or to \
           the right. The robot doesn't drive forward if something is ahead, nor turn towards a side if something is \
           detected on that side only. In these cases it chooses again.",
    complexity: "O(1) time and memory per step; it stores at most the last contact.",
    use_when: "To see the effect of checking the sides: the robot leaves walls sooner, but still moves at random.",
    shines: Example { room: "kitchen", why: "It turns away from obstacles beside it and soon leaves corners." },
    fails: Example { room: "flat", why: "It is still a random walk: the next rooms stay unknown." },
    source: "Krapinec 2025, Enhancing Robotic Vacuum Cleaner Performance through Improved Map Building, master's thesis, \
             FER Zagreb: chapter 7, phase 4",
    link: THESIS,
};

/// Phase 4.
const RULES: Rules = Rules { turns_right: true, looks_ahead: true, looks_aside: true };

pub(in crate::controller) const BUILD: BuildBehaviour = |setup| Reactive::boxed(setup, Options::new(setup, RULES));
