//! Tests of the frontier explorer with kidnapping, reading by reading.

use super::frontier::{DriveGoal, ExplorePhase, Frontier};
use crate::{
    controller::{
        Controller, Setup, find,
        parts::{Behaviour, Pilot, Reactive, Route},
    },
    mapping::{Mapper, MapperSetup, Marks, OccupancyMap, Tracking},
};
use robovac_core::{
    floor_plan::room,
    geometry::{Point, Pose},
    registry::Params,
    robot::{OdometryModel, RobotModel, SensorReadings, model},
};

const DT_S: f64 = 0.015;

fn mapper(robot: &RobotModel) -> Mapper {
    let (start, odometry) = (Pose::new(0.0, 0.0, 0.0), OdometryModel::Arc);
    Mapper::new(MapperSetup { robot: robot.clone(), start, tracking: Tracking::Corrected, odometry, seed: 1 })
}

/// With a robot, and an explorer's parameters.
fn with_setup(test: impl FnOnce(&Setup<'_>)) {
    let (robot, info) = (model("roomba600").unwrap(), find("explore_frontier").unwrap());
    test(&Setup { robot, params: &Params::defaults(info.params), seed: 1 });
}

#[test]
fn one_wheel_that_drops_does_not_start_the_search_anew() {
    with_setup(|setup| {
        let map = OccupancyMap::of(&(room("room12ft").unwrap().build)());
        let known = mapper(setup.robot).knowing(map, Marks::new(0.05));
        let mut explorer = Reactive::boxed(setup, Frontier::new(setup, known));
        let possible = |explorer: &dyn Controller| {
            explorer.intent().and_then(|intent| intent.locator).map(|locator| locator.particles().len())
        };
        // It drives along and meets something now and then.
        let mut sensed = SensorReadings::default();
        for step in 0..100_u16 {
            sensed =
                SensorReadings { left_counts: step * 20, right_counts: step * 20, bump_left: step % 10 == 9, ..sensed };
            explorer.step(&sensed, DT_S);
        }
        sensed.bump_left = false;
        let before = possible(&*explorer);
        assert!(before > Some(0), "it has an idea: {before:?}");
        for dropped in [true, false] {
            explorer.step(&SensorReadings { wheel_drop_left: dropped, ..sensed.clone() }, DT_S);
        }
        assert_eq!(possible(&*explorer), before, "it was driven over something, and keeps what it has found out");
        for dropped in [true, false] {
            explorer
                .step(&SensorReadings { wheel_drop_left: dropped, wheel_drop_right: dropped, ..sensed.clone() }, DT_S);
        }
        assert_eq!(possible(&*explorer), Some(0), "it was carried, and may be anywhere");
    });
}

#[test]
fn a_wall_that_goes_on_is_returned_to_after_a_kidnapping() {
    with_setup(|setup| {
        let end = Pose::new(2.0, 1.0, 0.5);
        let route = || Route::new(Point::origin(), vec![end.position()]);
        let follow = |has_met| ExplorePhase::Follow { began: 0.0, felt: 0.0, has_met };
        let drive = |to| ExplorePhase::Drive { route: route(), patience: 9.0, to, place: end.position() };
        let start = Pose::new(0.0, 0.0, 0.0);
        for (phase, ends) in [
            (follow(true), vec![start]),
            (follow(false), vec![]),
            (drive(DriveGoal::Wall(end)), vec![end]),
            (drive(DriveGoal::Floor), vec![]),
        ] {
            let (mut explorer, mut pilot) = (Frontier::new(setup, mapper(setup.robot)), Pilot::new(setup));
            explorer.phase = phase;
            for held in [false, true, false] {
                let sensed =
                    SensorReadings { wheel_drop_left: held, wheel_drop_right: held, ..SensorReadings::default() };
                explorer.watch(&sensed, DT_S);
            }
            explorer.begin(&mut pilot);
            assert_eq!(explorer.ends, ends);
            assert!(explorer.activity().contains("too empty to relocalise"), "{}", explorer.activity());
        }
    });
}
