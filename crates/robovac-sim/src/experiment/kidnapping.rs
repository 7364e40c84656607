//! Kidnapped robot trials: the time until a robot with a map relocalises.

use crate::{
    Conditions, Input, RandomStream, STEP_S,
    controller::BehaviourInfo,
    experiment::planning::RoomSetup,
    mapping::{
        OccupancyMap,
        locate::{Locator, LocatorSetup},
    },
};
use rand::RngExt;
use robovac_core::coverage::with_objects;
use robovac_core::{
    floor_plan::FloorPlan,
    geometry::{Point, Pose, difference},
    math,
    registry::Params,
    robot::{OdometryModel, RobotModel},
};

/// Steps before it is picked up, and for which it is held.
const BEFORE: u64 = 1000;
const IN_THE_AIR: u64 = 200;
/// Most places drawn until the robot can get there.
const MOST_DRAWS: u32 = 10_000;
/// An estimate is right if its error is smaller, m.
pub const RIGHT_M: f64 = 0.1;

/// Settings that all trials have in common.
#[derive(Debug, Clone)]
pub struct Kidnapping<'a> {
    /// The room, of which the robot has an exact map, furniture and docks included.
    pub plan: &'a FloorPlan,
    /// The room laid out for the robot.
    pub prepared: &'a RoomSetup,
    /// The robot.
    pub robot: &'a RobotModel,
    /// The behaviour that drives it.
    pub behaviour: &'static BehaviourInfo,
    /// Its parameters.
    pub params: &'a Params,
    /// Slip and noise.
    pub conditions: Conditions,
    /// How wheel counts are converted to motion.
    pub odometry: OdometryModel,
    /// Time after it was put down, s.
    pub duration_s: f64,
}

/// Result of a trial.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kidnapped {
    /// Seed of everything random in it.
    pub seed: u64,
    /// Time from being put down until it was first sure of the right place, s; `None` if never. What goes wrong later is a
    /// matter of tracking.
    pub first_s: Option<f64>,
    /// The same until it was so to the end.
    pub found_s: Option<f64>,
    /// Time for which it was sure of a wrong place, s.
    pub deluded_s: f64,
    /// Final error of its estimate, m and rad; `None` without an estimate.
    pub error: Option<(f64, f64)>,
    /// Whether it was sure at the end.
    pub is_sure: bool,
}

impl Kidnapping<'_> {
    /// Runs a trial; `None` if the behaviour isn't in the registry, or the room has no walls or no floor that the robot reaches.
    pub fn run(&self, seed: u64) -> Option<Kidnapped> {
        let map = OccupancyMap::of(&with_objects(self.plan));
        let setup = LocatorSetup { robot: self.robot.clone(), odometry: self.odometry, seed };
        let mut locator = Locator::new(&map, setup)?.knowing_docks(&self.prepared.world.docks);
        let mut rng = RandomStream::Kidnapping.seeded(seed);
        let places = locator.places();
        let floor = &self.prepared.floor;
        // Measured plans have pockets within their walls. At the edge of the floor, places are less exact than it is.
        let can_get_to = |&at: &Point| floor.cell_at(at).block().any(|cell| floor.standing.is_set(cell));
        let at = (0..MOST_DRAWS).map(|_| places[rng.random_range(0..places.len())]).find(can_get_to)?;
        let pose = Pose::new(at.x, at.y, rng.random_range(-math::PI..math::PI));
        let mut run = self.prepared.run_behaviour(self.behaviour, self.params, self.conditions, seed)?;
        let (mut first, mut found, mut deluded) = (None, None, 0_u64);
        let steps = (self.duration_s / STEP_S).round() as u64;
        for step in 0..BEFORE + IN_THE_AIR + steps {
            match step {
                BEFORE => run.apply(Input::Lift),
                _ if step == BEFORE + IN_THE_AIR => run.apply(Input::PutDown(pose)),
                _ => {}
            }
            run.step();
            locator.update(run.sensors());
            let Some(after) = step.checked_sub(BEFORE + IN_THE_AIR) else { continue };
            let off = locator.pose().map(|pose| (pose.position() - run.pose().position()).norm());
            match (locator.is_sure(), off) {
                (true, Some(off)) if off < RIGHT_M => {
                    first = first.or(Some(after));
                    found = found.or(Some(after));
                }
                (true, _) => (found, deluded) = (None, deluded + 1),
                _ => {}
            }
        }
        let error = locator.pose().map(|pose| {
            let off = (pose.position() - run.pose().position()).norm();
            (off, difference(run.pose().heading, pose.heading).abs())
        });
        let is_right = locator.is_sure() && error.is_some_and(|(off, _)| off < RIGHT_M);
        Some(Kidnapped {
            seed,
            first_s: first.map(|step| step as f64 * STEP_S),
            found_s: found.filter(|_| is_right).map(|step| step as f64 * STEP_S),
            deluded_s: deluded as f64 * STEP_S,
            error,
            is_sure: locator.is_sure(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Noise, NoiseLevel, SlipLevel, controller::find};
    use robovac_core::{floor_plan::room, robot::model};

    // slow: particle filter
    #[test]
    fn a_robot_that_knows_its_place_by_scans_keeps_it_along_a_corridor() {
        let (plan, info) = ((room("office").unwrap().build)(), find("wall_follow").unwrap());
        let robot = model("roomba600_lidar").unwrap();
        let (prepared, params) =
            (RoomSetup::new(&plan, robot, robot.default_cell, None).unwrap(), Params::defaults(info.params));
        let noise = Noise::all(NoiseLevel::Typical);
        let kidnapping = Kidnapping {
            plan: &plan,
            prepared: &prepared,
            robot,
            behaviour: info,
            params: &params,
            conditions: Conditions { slip: SlipLevel::Typical, noise, ..Conditions::default() },
            odometry: OdometryModel::Arc,
            duration_s: 60.0,
        };
        let trial = kidnapping.run(10).unwrap();
        assert!(trial.found_s.is_some_and(|found_s| found_s < 15.0), "{trial:?}");
    }
}
