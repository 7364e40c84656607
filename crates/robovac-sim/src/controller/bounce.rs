//! Straight ahead until a contact, then a turn by a random angle: the baseline, and the main behaviour of early
//! Roombas.
//!
//! Jones 2006 describes why the Roomba used it: no map, no localisation, and yet all of the floor in the end. The
//! patent of its modes (Jones & Mass 2004, US 6,809,490: random bounce, spiral, obstacle following) has the robot turn away
//! from where it bumped, by a random angle, until the way is free.
//!
//! # Where the sources are silent, and what is ours
//!
//! - *The angle* is drawn between a quarter and half a turn by default, away from the side that was hit.
//! - *Backing up* by 3 cm before turning: for robots that aren't round.
//! - *Cliffs and beams* are answered like bumps; from a cliff the robot first backs off over known ground.
//!
//! ```
//! use robovac_sim::controller::*;
//! use robovac_core::{registry::Params, robot::*};
//! let info = find("bounce").unwrap();
//! let (robot, params) = (model("roomba600").unwrap(), Params::defaults(info.params));
//! let mut bounce = info.build(&Setup { robot, params: &params, seed: 1 }).unwrap();
//! assert_eq!(bounce.activity(), "driving straight");
//! let cliff = SensorReadings { cliff: [false, false, true, true], ..SensorReadings::default() };
//! assert!((0..100).any(|_| { let drive = bounce.step(&cliff, 0.015); drive.left < 0.0 && drive.right > 0.0 }));
//! ```

use super::{
    BehaviourClaims, BehaviourInfo, BuildBehaviour,
    parts::{Behaviour, By, GO_HOME, LEAVE_HOME, Move, Obstruction, Pilot, Reactive},
};
use rand::RngExt;
use robovac_core::{
    registry::{Example, Explainer, ParamKind, ParamSpec},
    robot::{Drive, SensorReadings},
};

/// Way back before turning, m.
const BACK: f64 = 0.03;

pub(super) const INFO: BehaviourInfo = BehaviourInfo {
    id: "bounce",
    title: "Bounce",
    summary: "Drives straight until it hits something, then turns away by a random angle.",
    claims: BehaviourClaims { cleans: true, ..BehaviourClaims::NONE },
    params: &[
        ParamSpec {
            id: "least",
            label: "Smallest turn",
            help: "Smallest turning angle.",
            kind: ParamKind::Number { min: 0.0, max: 180.0, step: 5.0, default: 90.0, unit: "°" },
        },
        ParamSpec {
            id: "most",
            label: "Largest turn",
            help: "Largest turning angle; at least the smallest one is used.",
            kind: ParamKind::Number { min: 5.0, max: 360.0, step: 5.0, default: 180.0, unit: "°" },
        },
        GO_HOME,
        LEAVE_HOME,
    ],
};

/// Its explanation.
pub(super) const EXPLAINER: Explainer = Explainer {
    idea: "The robot drives straight until its bumper is pressed or a cliff sensor triggers. It turns away by a \
           random angle and continues. Coverage is purely random: some areas are cleaned often, others late.",
    complexity: "O(1) time and memory per step; no map.",
    use_when: "As a baseline for all other behaviours, and for robots with nothing but a bumper.",
    shines: Example {
        room: "thesis226",
        why: "One room with a few obstacles: after 20 minutes nearly everything is covered.",
    },
    fails: Example { room: "maze", why: "It passes a doorway only by chance." },
    source: "Jones 2006, Robots at the Tipping Point: The Road to iRobot Roomba, IEEE Robotics & Automation Magazine 13(1); \
             Jones & Mass 2004, US 6,809,490, Method and system for multi-mode coverage for an autonomous robot",
    link: "https://patents.google.com/patent/US6809490B2/en",
};

pub(super) const BUILD: BuildBehaviour = |setup| {
    let least = setup.params.number("least").to_radians();
    let most = setup.params.number("most").to_radians().max(least);
    Reactive::boxed(setup, Bounce { least, most })
};

#[derive(Debug, Clone)]
struct Bounce {
    /// Limits of the angle, rad.
    least: f64,
    most: f64,
}

impl Behaviour for Bounce {
    fn begin(&mut self, pilot: &mut Pilot) {
        pilot.turn_speed = pilot.robot.turn_wheel_speed;
        pilot.by = By::Counts;
    }

    fn roam(&mut self, pilot: &mut Pilot, _: &SensorReadings, _: f64) -> Drive {
        pilot.straight()
    }

    fn on_obstruction(&mut self, pilot: &mut Pilot, obstruction: Obstruction) {
        let turn = self.least + (self.most - self.least) * pilot.rng.random_range(0.0..1.0);
        let way = pilot.away_from(obstruction);
        pilot.answer(obstruction, BACK, &[Move::Turn(way * turn)]);
    }

    fn activity(&self) -> &'static str {
        "driving straight"
    }

    fn boxed_clone(&self) -> Box<dyn Behaviour> {
        Box::new(self.clone())
    }
}
