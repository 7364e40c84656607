//! Straight ahead until something is in the way, then off at a random angle: the baseline.

use super::{BehaviourInfo, Build, Claims, Controller, Setup};
use crate::{
    math,
    registry::{Example, Explainer},
    rng::{Rng, seeded},
    robot::{Drive, RobotModel, Sensors},
};
use rand::RngExt;

/// Stream of the behaviours' random numbers.
const STREAM: u64 = 3;

/// Where early Roombas began.
pub(super) const INFO: BehaviourInfo = BehaviourInfo {
    id: "bounce",
    title: "Bounce",
    summary: "Drives straight until it hits something, then turns away by chance",
    source: "Jones 2006, Robots at the Tipping Point: The Road to iRobot Roomba",
    link: "",
    explainer: Explainer {
        idea: "Drive straight until the bumper is hit. Turn away by a random angle. Do it again.",
        complexity: "O(1) a step, no memory of the room",
        use_when: "As the baseline that everything else must beat",
        shines: Example { room: "empty", why: "" },
        fails: Example { room: "maze", why: "" },
    },
    claims: Claims { ends: false, cleans: true, manual: false },
    params: &[],
};

pub(super) const BUILD: Build = |setup| Box::new(Bounce::new(setup));

#[derive(Clone)]
struct Bounce {
    robot: RobotModel,
    rng: Rng,
    back_s: f64,
    turn_s: f64,
    direction: f64,
}

impl Bounce {
    fn new(setup: &Setup<'_>) -> Self {
        Self { robot: setup.robot.clone(), rng: seeded(setup.seed, STREAM), back_s: 0.0, turn_s: 0.0, direction: 1.0 }
    }
}

impl Controller for Bounce {
    fn step(&mut self, sensed: &Sensors, dt_s: f64) -> Drive {
        let robot = &self.robot;
        if sensed.wheel_dropped() {
            return Drive::STOP;
        }
        if self.back_s <= 0.0 && self.turn_s <= 0.0 && (sensed.bumped() || sensed.sees_cliff() || sensed.virtual_wall) {
            self.back_s = 0.3;
            self.turn_s = self.rng.random_range(0.5 * math::FRAC_PI_2..math::PI) / robot.turn_rate();
            self.direction = if sensed.bump_right { 1.0 } else { -1.0 };
        }
        if self.back_s > 0.0 {
            self.back_s -= dt_s;
            return Drive::from_twist(-0.5 * robot.cruise_speed, 0.0, robot.wheel_base);
        }
        if self.turn_s > 0.0 {
            self.turn_s -= dt_s;
            return Drive::from_twist(0.0, self.direction * robot.turn_rate(), robot.wheel_base);
        }
        Drive::from_twist(robot.cruise_speed, 0.0, robot.wheel_base)
    }

    fn is_done(&self) -> bool {
        false
    }

    fn activity(&self) -> &'static str {
        match (self.back_s > 0.0, self.turn_s > 0.0) {
            (true, _) => "backing up",
            (_, true) => "turning away",
            _ => "driving straight",
        }
    }

    fn boxed_clone(&self) -> Box<dyn Controller> {
        Box::new(self.clone())
    }
}
