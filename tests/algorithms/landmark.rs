//! The dock as a landmark: a robot that is lost and finds its dock knows its place (004, section 4.3).

use super::behaviours::room_with_dock;
use robovac_core::{
    coverage::with_objects,
    floor_plan::{FloorPlan, Object, Sketch},
    geometry::{Pose, difference},
    math,
    registry::Params,
    robot::{BatteryReading, OdometryModel, SensorReadings, model},
};
use robovac_sim::{
    Conditions, Noise, NoiseLevel, Run, SlipLevel,
    controller::{self, clean_by_map},
    experiment::{
        kidnapping::{Kidnapped, Kidnapping},
        planning::RoomSetup,
    },
    mapping::{Mapper, MapperSetup, Marks, OccupancyMap, Tracking},
};

fn typical() -> Conditions {
    let noise = Noise::all(NoiseLevel::Typical);
    Conditions { slip: SlipLevel::Typical, noise, ..Conditions::default() }
}

/// Trials of a kidnapped Roomba that follows walls for a minute.
fn kidnapped(plan: &FloorPlan) -> Vec<Kidnapped> {
    let (robot, info) = (model("roomba600").unwrap(), controller::find("wall_follow").unwrap());
    let (prepared, params) = (RoomSetup::new(plan, robot, 0.12, None).unwrap(), Params::defaults(info.params));
    let kidnapping = Kidnapping {
        plan,
        prepared: &prepared,
        robot,
        behaviour: info,
        params: &params,
        conditions: typical(),
        odometry: OdometryModel::Arc,
        duration_s: 60.0,
    };
    (1..=4).map(|seed| kidnapping.run(seed).unwrap()).collect()
}

// slow: particle filters
/// A bare room looks the same from opposite corners; only the dock tells them apart.
#[test]
fn beams_tell_two_ends_of_a_symmetric_room_apart() {
    let found = |trials: &[Kidnapped]| trials.iter().filter(|trial| trial.found_s.is_some()).count();
    let sketch = Sketch::solid(4.2, 3.2, 0.05).carve(&[[0.1, 0.1, 4.1, 3.1]]);
    let mut plan = sketch.start(1.0, 1.0, 0.0).finish("bare", "");
    let without = kidnapped(&plan);
    plan.objects.push(Object::Dock { pose: Pose::new(0.1, 1.6, 0.0) });
    let with = kidnapped(&plan);
    println!("{} of 4 without a dock, {} with", found(&without), found(&with));
    assert!(found(&without) <= 1, "{without:?}");
    assert!(found(&with) >= 3, "{with:?}");
}

fn mapper() -> Mapper {
    let (robot, start) = (model("roomba600").unwrap().clone(), Pose::new(0.0, 0.0, 0.0));
    let (tracking, odometry) = (Tracking::Corrected, OdometryModel::Arc);
    Mapper::new(MapperSetup { robot, start, tracking, odometry, seed: 1 })
}

fn reading(counts: u16, on_dock: bool) -> SensorReadings {
    let battery = BatteryReading { on_dock, ..BatteryReading::default() };
    SensorReadings { left_counts: counts, right_counts: counts, battery, ..SensorReadings::default() }
}

fn carry(mapper: &mut Mapper, counts: u16) {
    let lifted = SensorReadings { wheel_drop_left: true, wheel_drop_right: true, ..reading(counts, false) };
    mapper.update(&lifted);
    mapper.update(&reading(counts, false));
    assert!(mapper.is_lost());
}

#[test]
fn a_lost_mapper_knows_its_place_on_the_dock_where_it_began() {
    let mut mapper = mapper();
    mapper.update(&reading(0, true));
    for counts in (0..3000).step_by(20) {
        mapper.update(&reading(counts, false));
    }
    assert!(mapper.pose().x > 1.2);
    carry(&mut mapper, 3000);
    mapper.update(&reading(3000, true));
    assert!(!mapper.is_lost() && mapper.pose().position().coords.norm() < 0.01, "{}", mapper.pose());
    assert!(mapper.pose_covariance().heading < 0.05);
}

#[test]
fn a_lost_mapper_knows_its_place_on_a_dock_where_it_has_been() {
    let mut mapper = mapper();
    for counts in (0..3000).step_by(20) {
        mapper.update(&reading(counts, false));
    }
    mapper.update(&reading(3000, true));
    let there = mapper.pose();
    mapper.update(&reading(3000, false));
    carry(&mut mapper, 3000);
    mapper.update(&reading(3000, true));
    assert!(!mapper.is_lost() && (mapper.pose().position() - there.position()).norm() < 0.01);
}

#[test]
fn who_has_never_been_on_a_dock_stays_lost_there() {
    let mut mapper = mapper();
    mapper.update(&reading(0, false));
    carry(&mut mapper, 0);
    mapper.update(&reading(0, true));
    assert!(mapper.is_lost());
}

/// A robot that cleans by a map with its dock, and is put down within sight of it, drives there before it goes on.
#[test]
fn who_is_lost_on_a_known_map_goes_to_the_dock_and_then_cleans() {
    let (plan, robot) = (room_with_dock(), model("roomba600").unwrap());
    let dock = Pose::new(1.8, 0.0, math::FRAC_PI_2);
    for seed in 1..=3 {
        let start = Pose::new(2.0, 1.4, -1.0);
        let prepared = RoomSetup::new(&plan, robot, 0.12, Some(start)).unwrap();
        let map = OccupancyMap::of(&with_objects(&plan));
        let marks = Marks::new(map.resolution());
        let lost = mapper().knowing(map, marks).knowing_dock(dock);
        let mut run = Run::new(&prepared.setup(typical(), seed), clean_by_map(lost, "boustrophedon"));
        let is_lost = |run: &Run| run.mapper().unwrap().is_lost();
        assert!(is_lost(&run));
        while is_lost(&run) && run.time_s() < 60.0 {
            run.step();
        }
        let (estimate, pose) = (run.estimate().unwrap(), run.pose());
        assert!(run.sensors().battery.on_dock, "{seed}: after {:.0} s, {}", run.time_s(), run.activity());
        assert!((estimate.position() - pose.position()).norm() < 0.03, "{seed}: {estimate}, {pose}");
        assert!(difference(estimate.heading, pose.heading).abs() < 0.16, "{seed}: {estimate}, {pose}");
        while run.time_s() < 180.0 {
            run.step();
        }
        assert!(run.distance_m() > 5.0 && run.activity() == "cleaning by its map", "{seed}: {}", run.activity());
    }
}
