//! Phase 4: looking after every option (004, chapter 7).
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
//! let wall = Sensors { light_bumper: [true, true, true, false, false, false], ..Sensors::default() };
//! for counts in 0..2000_u16 {
//!     let drive = explorer.step(&Sensors { left_counts: counts, ..wall.clone() }, 0.015);
//!     assert!(drive.left >= drive.right);
//! }
//! ```

use super::{
    THESIS,
    options::{ANGLE, DISTANCE, Options, Rules},
};
use crate::controller::{BehaviourInfo, Build, Claims, parts::Driven};
use robovac_core::registry::{Example, Explainer};

pub(in crate::controller) const INFO: BehaviourInfo = BehaviourInfo {
    id: "explore_look_around",
    title: "Look around",
    summary: "Draws a motion forward, to the left or to the right, and leaves out what leads to an obstacle.",
    source: "Krapinec 2025, Enhancing Robotic Vacuum Cleaner Performance through Improved Map Building, master's thesis, \
             FER Zagreb: chapter 7, phase 4",
    link: THESIS,
    explainer: Explainer {
        idea: "One of three motions is drawn by chance: a fixed way forward, or a fixed rotation to the left or to the right. If something is ahead it doesn't drive forward, and if something is on one side alone it doesn't turn to that side. Then it draws again.",
        complexity: "O(1) time and memory a step: it remembers at most the last contact.",
        use_when: "To see what a look to the sides adds: the robot turns away from walls sooner, and still goes where chance leads.",
        shines: Example { room: "kitchen", why: "It turns away from what is beside it and soon gets out of corners." },
        fails: Example { room: "flat", why: "It still draws its way by chance: the rooms next door stay unknown." },
    },
    claims: Claims { ends: false, cleans: false, manual: false, explores: true },
    params: &[DISTANCE, ANGLE],
};

/// Phase 4.
const RULES: Rules = Rules { turns_right: true, looks_ahead: true, looks_aside: true };

pub(in crate::controller) const BUILD: Build = |setup| Driven::boxed(setup, Options::new(setup, RULES));
