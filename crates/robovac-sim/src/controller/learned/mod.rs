//! A small network that has learnt to clean in generated flats.
//!
//! The robot keeps a map of what it has swept and of what was in its way, in the frame of its estimated pose. Four times a
//! second it looks along 16 directions. For each of them the network gets a few values (`inputs.rs`): how much new floor lies
//! there near and far, how far the way is open, whether the lanes beside it are swept, how far it has to turn, what the light
//! bumper sees, how often it has been there, and whether the way to the nearest floor that it hasn't swept leads there. It
//! answers with a score and a speed. The robot turns to the direction with the best score. One network serves all directions,
//! so that a few hundred weights are enough. Training began with a rule that was set by hand
//! (generation 0 of `docs/learned/curve.csv`).
//!
//! `crates/robovac-sim/examples/learn_to_clean.rs` trains it: an evolution strategy (Wierstra, Schaul, Glasmachers, Sun, Peters
//! & Schmidhuber, Natural evolution strategies, Journal of Machine Learning Research 15, 2014: the separable variant) raises
//! the swept share of the floor after 20 minutes in flats that are generated from seeds. `weights.txt` is what came of it.
//!
//! Not learnt are the reflexes that all behaviours share: backing off from obstacles, edges and virtual walls.
//!
//! ```
//! use robovac_sim::controller::*;
//! use robovac_core::{registry::Params, robot::*};
//! let info = find("learned").unwrap();
//! let (robot, params) = (model("roomba600").unwrap(), Params::defaults(info.params));
//! let mut learned = info.build(&Setup { robot, params: &params, seed: 1 }).unwrap();
//! learned.step(&SensorReadings::default(), 0.015);
//! assert_eq!(learned.activity(), "sweeping as its network steers");
//! ```

mod inputs;
mod network;
mod swept_map;
mod way;

pub use network::{Network, NetworkError};

use super::{
    BehaviourClaims, BehaviourInfo, BuildBehaviour, Controller, Intent, Setup,
    parts::{
        Behaviour, GO_HOME, LEAVE_HOME, Move, Obstruction, ObstructionKind, ObstructionSide, Pilot, Reactive,
        RelocaliseSearch, Searched, TRACKING, chosen_tracking,
    },
};
use crate::mapping::{
    Mapper, MapperSetup,
    observation::{IDLE, REFLECTED},
};
use inputs::{DIRECTIONS, INPUTS, Vicinity, angle};
use rand::RngExt;
use robovac_core::{
    geometry::{Point, Pose, difference},
    math,
    registry::{Example, Explainer},
    robot::{Body, Drive, OdometryModel, RobotModel, SensorReadings, Tool},
};
use std::sync::Arc;
use swept_map::{SweptMap, block_of};
use way::Way;

/// Sizes of the layers that a network for it has: the values of a direction, hidden neurons, score and speed.
pub const LAYERS: [usize; 3] = [INPUTS, 8, 2];
/// The weights that it has learnt.
const WEIGHTS: &str = include_str!("weights.txt");

/// Time between two decisions, s.
const DECIDE_S: f64 = 0.24;
/// Decisions after which it looks again for the nearest floor that isn't swept.
const SEARCH: u32 = 4;
/// Way between two marks on its map, m.
const SPACING: f64 = 0.025;
/// Radius in which something keeps its middle away, as a share of the body's; and in which its middle shows that nothing does.
const BLOCKED: f64 = 0.95;
const FREE_M: f64 = 0.06;
/// How far inside an obstacle its mark lies, m.
const INSIDE: f64 = 0.02;
/// Distance up to which echoes of the light bumper are marked, m.
const NEAR_M: f64 = 0.16;
/// Direction of a contact on one side, rad.
const SIDE: f64 = 0.95;
/// Way back from obstacles, m.
const BACK: f64 = 0.03;
/// Turn beyond which it turns on the spot until it is less off than the second, rad.
const ON_THE_SPOT: (f64, f64) = (0.7, 0.3);
/// Turn rate for each radian that it is off its direction, 1/s, and the largest while it drives, rad/s.
const STEER: (f64, f64) = (4.0, 1.5);
/// Angle from a contact within which it doesn't turn at once, rad.
const CONTACT: f64 = 0.6;
/// Signal of a front sensor at which it decides at once: a usual wall at 12 cm; and the time that it waits after a decision, s.
const AHEAD: u16 = 300;
const AT_ONCE_S: f64 = 0.09;
/// Least share of its speed.
const SLOWEST: f64 = 0.3;
/// Obstructions in a row within this distance, m, after which it turns by chance.
const STUCK: (u32, f64) = (4, 0.1);
/// Turns by chance, rad.
const BY_CHANCE: std::ops::Range<f64> = 0.8..2.6;
/// Distance within which time spent on the way to a place counts as trying to get there, m.
const TRYING_M: f64 = 1.0;

pub(super) const INFO: BehaviourInfo = BehaviourInfo {
    id: "learned",
    title: "Learned",
    summary: "Steers by a small neural network that was trained in generated flats.",
    claims: BehaviourClaims { cleans: true, ..BehaviourClaims::NONE },
    params: &[TRACKING, GO_HOME, LEAVE_HOME],
};

/// Its explanation.
pub(super) const EXPLAINER: Explainer = Explainer {
    idea: "A neural network chooses the direction. It sees the robot's own map: new floor, obstacles and swept lanes \
           around it. Training began with a simple rule; evolution kept the weights with which more floor was swept.",
    complexity: "O(1) time per step for the network; O(n) for the nearest new floor on a map of n cells.",
    use_when: "In furnished flats that nobody has mapped, on a robot with a light bumper.",
    shines: Example { room: "flat", why: "It is much like the flats that it was trained in." },
    fails: Example { room: "hall20", why: "In a large hall without furniture, plain straight drives sweep as much." },
    source: "Ours; trained by a natural evolution strategy: Wierstra et al. 2014, JMLR 15",
    link: "https://jmlr.org/papers/v15/wierstra14a.html",
};

pub(super) const BUILD: BuildBehaviour = |setup| {
    // The tests read the file.
    let network = Network::parse(WEIGHTS).unwrap_or_else(|_| Network::zero(&LAYERS));
    drive_by(setup, Arc::new(network))
};

/// The behaviour with another network, whose layers are [`LAYERS`]; `setup` has the parameters of `learned`.
pub fn drive_by(setup: &Setup<'_>, network: Arc<Network>) -> Box<dyn Controller> {
    Reactive::boxed(setup, Learned::new(setup, network))
}

/// The behaviour.
#[derive(Clone)]
struct Learned {
    network: Arc<Network>,
    mapper: Mapper,
    map: SweptMap,
    way: Way,
    /// Radius of the tool and its place on the robot.
    tool: (f64, [f64; 2]),
    /// Echo of the light bumper that is marked.
    near_echo: f64,
    /// Where its map was marked last.
    marked: Option<Point>,
    /// Heading that it wants, rad, and its speed as a share.
    wanted: Option<(f64, f64)>,
    /// Time since the last decision and since the last obstruction, s; decisions so far.
    since_s: f64,
    untouched_s: f64,
    decisions: u32,
    is_turning: bool,
    /// Where it was obstructed last, and how often in a row there.
    stuck: (Point, u32),
    is_lifted: bool,
    is_searching: bool,
    search: RelocaliseSearch,
}

impl Learned {
    fn new(setup: &Setup<'_>, network: Arc<Network>) -> Self {
        let mapper = MapperSetup {
            robot: setup.robot.clone(),
            start: Pose::new(0.0, 0.0, 0.0),
            tracking: chosen_tracking(setup),
            odometry: OdometryModel::default(),
            seed: setup.seed,
        };
        let tool = match setup.robot.tool {
            Tool::Disc(at) => (0.5 * setup.robot.tool_width, at),
            Tool::Body => (setup.robot.radius, [0.0, 0.0]),
        };
        Self {
            network,
            mapper: Mapper::new(mapper),
            map: SweptMap::new(),
            way: Way::default(),
            tool,
            near_echo: setup
                .robot
                .sensors
                .light_bumper
                .map_or(f64::INFINITY, |light| light.light_at(NEAR_M, REFLECTED)),
            marked: None,
            wanted: None,
            since_s: 0.0,
            untouched_s: 0.0,
            decisions: 0,
            is_turning: false,
            stuck: (Point::origin(), 0),
            is_lifted: false,
            is_searching: false,
            search: RelocaliseSearch::new(setup),
        }
    }

    /// Begins a new map at a pose.
    fn forget(&mut self, start: Pose) {
        self.mapper = Mapper::new(MapperSetup { start, ..self.mapper.setup().clone() });
        self.map = SweptMap::new();
        self.way = Way::default();
        self.marked = None;
    }

    /// Marks the floor that it has swept since the last mark.
    fn mark(&mut self) {
        let pose = self.mapper.pose();
        let here = pose.position();
        if self.marked.is_some_and(|last| (here - last).norm_squared() < SPACING * SPACING) {
            return;
        }
        self.marked = Some(here);
        self.map.sweep(pose.to_world(Point::from(self.tool.1)), self.tool.0);
        self.map.clear(here, FREE_M);
    }

    /// Marks something at an angle to the left of straight ahead, so far beyond the body, m.
    fn mark_obstacle(&mut self, robot: &RobotModel, angle: f64, beyond: f64) {
        let distance = robot.body.reach(robot.radius, angle) + beyond + INSIDE;
        let (sin, cos) = math::sin_cos(angle);
        let at = self.mapper.pose().to_world(Point::new(distance * cos, distance * sin));
        self.map.block(at, BLOCKED * robot.radius);
    }

    /// Marks what the light bumper sees.
    fn look(&mut self, robot: &RobotModel, sensed: &SensorReadings) {
        let Some(light) = robot.sensors.light_bumper else { return };
        for (angle, &signal) in light.angles.into_iter().zip(&sensed.light_signal) {
            let echo = f64::from(signal) - IDLE;
            if echo > self.near_echo {
                self.mark_obstacle(robot, angle, light.distance_of_light(echo, REFLECTED));
            }
        }
    }

    /// Chooses a turn, not within [`CONTACT`] of `touched`, and a share of the speed.
    fn decide(&mut self, pilot: &Pilot, sensed: &SensorReadings, touched: Option<f64>) -> f64 {
        self.look(&pilot.robot, sensed);
        let pose = self.mapper.pose();
        let here = pose.position();
        self.map.visit(block_of(here));
        let is_reached = self.way.goal().is_none_or(|goal| !self.map.is_goal(goal));
        if is_reached || self.decisions.is_multiple_of(SEARCH) {
            self.way.search(&self.map, here);
        }
        self.decisions = self.decisions.wrapping_add(1);
        if let Some(goal) = self.way.goal().filter(|_| self.way.length_m() < TRYING_M) {
            self.map.try_for(goal);
        }
        let light = pilot.robot.sensors.light_bumper;
        let around = Vicinity { map: &self.map, way: &self.way, pose, light, sensed, untouched_s: self.untouched_s };
        let mut best = (f32::NEG_INFINITY, 0.0, 0.0);
        for (direction, inputs) in around.inputs().iter().enumerate().take(DIRECTIONS) {
            let turn = angle(direction);
            if touched.is_some_and(|touched| difference(touched, turn).abs() < CONTACT) {
                continue;
            }
            let [score, speed] = self.network.outputs(inputs);
            if score > best.0 {
                best = (score, turn, speed);
            }
        }
        let (_, turn, speed) = best;
        let share = 0.5 * (1.0 + f64::from(speed / (1.0 + speed.abs())));
        self.since_s = 0.0;
        self.is_turning = turn.abs() > ON_THE_SPOT.0;
        self.wanted = Some((pose.heading + turn, SLOWEST + (1.0 - SLOWEST) * share));
        turn
    }

    /// Drives towards the heading that it wants.
    fn steer(&mut self, pilot: &Pilot) -> Drive {
        let Some((heading, share)) = self.wanted else { return Drive::STOP };
        let off = difference(self.mapper.pose().heading, heading);
        self.is_turning &= off.abs() > ON_THE_SPOT.1;
        if self.is_turning {
            let speed = pilot.turn_speed.copysign(off);
            return Drive::wheels(-speed, speed);
        }
        pilot.twist(share * pilot.speed, (STEER.0 * off).clamp(-STEER.1, STEER.1))
    }

    /// Whether something lies close ahead by the light bumper.
    fn sees_ahead(sensed: &SensorReadings) -> bool {
        sensed.light_signal[1..5].iter().any(|&signal| signal > AHEAD)
    }
}

impl Behaviour for Learned {
    fn begin(&mut self, pilot: &mut Pilot) {
        self.wanted = None;
        if !std::mem::take(&mut self.is_lifted) {
            return;
        }
        self.is_searching = self.mapper.is_lost() && self.search.begin(pilot, &self.mapper);
        if !self.is_searching {
            self.forget(self.mapper.pose());
        }
    }

    fn watch(&mut self, sensed: &SensorReadings, dt_s: f64) {
        self.since_s += dt_s;
        self.untouched_s += dt_s;
        self.is_lifted |= sensed.wheel_drop_left && sensed.wheel_drop_right;
        self.mapper.update(sensed);
        if self.is_searching {
            match self.search.watch(&mut self.mapper, sensed, dt_s) {
                Searched::Looking => {}
                Searched::Found => self.is_searching = false,
                Searched::InVain => {
                    self.is_searching = false;
                    self.forget(self.mapper.pose());
                }
            }
        } else if !sensed.wheel_dropped() {
            self.mark();
        }
    }

    fn roam(&mut self, pilot: &mut Pilot, sensed: &SensorReadings, dt_s: f64) -> Drive {
        if self.is_searching {
            return self.search.roam(pilot, sensed, dt_s);
        }
        let is_urgent = self.since_s >= AT_ONCE_S && Self::sees_ahead(sensed);
        let is_due = self.since_s >= DECIDE_S || is_urgent;
        if self.wanted.is_none() || (is_due && !self.is_turning) {
            self.decide(pilot, sensed, None);
        }
        self.steer(pilot)
    }

    fn on_obstruction(&mut self, pilot: &mut Pilot, obstruction: Obstruction) {
        if self.is_searching {
            return self.search.on_obstruction(pilot, obstruction);
        }
        let robot = pilot.robot.clone();
        let angle = match obstruction.side {
            ObstructionSide::Left => SIDE,
            ObstructionSide::Front => 0.0,
            ObstructionSide::Right => -SIDE,
        };
        // The sides of edges tell little.
        let angle = if obstruction.kind == ObstructionKind::Bump { angle } else { 0.5 * angle };
        self.mark_obstacle(&robot, angle, 0.0);
        self.wanted = None;
        self.untouched_s = 0.0;
        let here = self.mapper.pose().position();
        let is_again = (here - self.stuck.0).norm() < STUCK.1;
        self.stuck = (here, if is_again { self.stuck.1 + 1 } else { 0 });
        if self.stuck.1 < STUCK.0 {
            let is_bump = obstruction.kind == ObstructionKind::Bump;
            let is_round = robot.body == Body::Round;
            let turn = self.decide(pilot, &SensorReadings::default(), Some(angle));
            self.wanted = None;
            pilot.answer(obstruction, if is_bump && is_round { 0.0 } else { BACK }, &[Move::Turn(turn)]);
        } else {
            let turn = pilot.away_from(obstruction) * pilot.rng.random_range(BY_CHANCE);
            pilot.answer(obstruction, BACK, &[Move::Turn(turn), Move::Ahead(2.0 * STUCK.1)]);
        }
    }

    fn activity(&self) -> &'static str {
        if self.is_searching { "relocalising on its map" } else { "sweeping as its network steers" }
    }

    fn mapper(&self) -> Option<&Mapper> {
        Some(&self.mapper)
    }

    fn intent(&self) -> Option<Intent<'_>> {
        let locator = self.search.locator().filter(|_| self.is_searching);
        Some(Intent { locator, ..Intent::default() })
    }

    fn start_at(&mut self, start: Pose) {
        self.forget(start);
    }

    fn boxed_clone(&self) -> Box<dyn Behaviour> {
        Box::new(self.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_weights_fit() {
        let network = Network::parse(WEIGHTS).unwrap();
        assert_eq!(network.sizes(), LAYERS);
        assert!(WEIGHTS.len() < 100_000);
    }
}
