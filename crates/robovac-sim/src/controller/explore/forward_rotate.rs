//! Phase 1: forward or rotate, at random (004, chapter 7).
//!
//! Krapinec 2025 begins with two options, a fixed way forward and a fixed rotation; one of them is drawn when the last
//! one is done. There is no rule for obstacles: the wheels roll their distance even where a wall holds the robot, which
//! misleads odometry, as the thesis says. It likens the strategy to bogosort.
//!
//! # Where the thesis is silent
//!
//! - *Figures*: no distance and no angle are printed. 20 cm and 30 degrees are ours, as are the robot's own speeds.
//! - *The way it rotates*: counter-clockwise; only phase 2 adds rotations to the right.
//! - *The end*: "until a comprehensive map is generated", but no rule defines that. It continues.
//! - *Edges of the floor and virtual walls* end a motion: the robot backs off and turns away by a random angle. After
//!   the first edge it no longer pushes walls: pushing causes slip, after which the way back isn't known.
//!
//! ```
//! use robovac_sim::controller::*;
//! use robovac_core::{registry::Params, robot::*};
//! let info = find("explore_forward_rotate").unwrap();
//! let (robot, params) = (model("roomba600").unwrap(), Params::defaults(info.params));
//! let mut explorer = info.build(&Setup { robot, params: &params, seed: 1 }).unwrap();
//! // It takes no notice of a wall: sooner or later the wheels roll ahead with the bumper pressed.
//! let wall = SensorReadings { bump_left: true, bump_right: true, ..SensorReadings::default() };
//! assert!((0..1000).any(|_| { let drive = explorer.step(&wall, 0.015); drive.left > 0.0 && drive.right > 0.0 }));
//! ```

use super::{
    THESIS,
    options::{ANGLE, DISTANCE, Options, PUSHES, Rules},
};
use crate::controller::{BehaviourClaims, BehaviourInfo, BuildBehaviour, parts::Reactive};
use robovac_core::registry::{Example, Explainer};

pub(in crate::controller) const INFO: BehaviourInfo = BehaviourInfo {
    id: "explore_forward_rotate",
    title: "Forward or rotate",
    summary: "Drives a fixed distance forward or rotates by a fixed angle, at random, without sensing.",
    claims: BehaviourClaims { explores: true, ..BehaviourClaims::NONE },
    params: &[DISTANCE, ANGLE, PUSHES],
};

/// Its explanation.
pub(in crate::controller) const EXPLAINER: Explainer = Explainer {
    idea: "One of two motions is chosen at random: a fixed distance forward, or a fixed rotation to the left. When \
        it ends, the next one is chosen. Sensor readings don't influence the choice.",
    complexity: "O(1) time and memory per step; it stores at most the last contact.",
    use_when: "As a baseline for sensing behaviours, and to see how walls corrupt odometry: the wheels keep \
        rolling while the robot is blocked.",
    shines: Example { room: "room12ft", why: "In a small room chance leads it to most walls in time." },
    fails: Example { room: "flat", why: "It keeps revisiting the same floor and passes doorways only by chance." },
    source: "Krapinec 2025, Enhancing Robotic Vacuum Cleaner Performance through Improved Map Building, master's thesis, \
             FER Zagreb: chapter 7, phase 1",
    link: THESIS,
};

/// Phase 1.
const RULES: Rules = Rules { turns_right: false, looks_ahead: false, looks_aside: false };

pub(in crate::controller) const BUILD: BuildBehaviour = |setup| Reactive::boxed(setup, Options::new(setup, RULES));
