//! Maps and poses of robots with a laser scanner.

use proptest::prelude::*;
use robovac_core::{
    floor_plan::{FloorPlan, SourceFile, load, room},
    geometry::{Pose, difference},
    registry::Params,
    robot::{MODELS, OdometryModel, RobotModel, SensorReadings, model},
};
use robovac_sim::{
    Conditions, Noise, NoiseLevel, SlipLevel,
    controller::{self, BehaviourInfo},
    experiment::{RoomSetup, kidnapping::Kidnapping},
    mapping::{MapTruth, Mapper, MapperSetup, RESOLUTION, SeenBoundary, Tracking},
    montecarlo::quantile,
};
use std::{ops::RangeInclusive, path::PathBuf, sync::Arc};

const ROBOTS: [&str; 2] = ["cbot", "roomba600_lidar"];

fn typical() -> Conditions {
    let noise = Noise::all(NoiseLevel::Typical);
    Conditions { slip: SlipLevel::Typical, noise, ..Conditions::default() }
}

fn behaviour(id: &str) -> (&'static BehaviourInfo, Params) {
    let info = controller::find(id).unwrap();
    (info, Params::defaults(info.params))
}

fn mapper(robot: &RobotModel, start: Pose) -> Mapper {
    let (tracking, odometry) = (Tracking::Corrected, OdometryModel::Arc);
    Mapper::new(MapperSetup { robot: robot.clone(), start, tracking, odometry, seed: 1 })
}

/// Errors of a run's pose at its end, m and degrees, the same as medians over the run, and the shares of the map's cells
/// that are right and of the seen boundary that is on it, in percent.
fn outcome(plan: &FloorPlan, robot_id: &str, behaviour_id: &str, seed: u64, minutes: f64) -> [f64; 6] {
    let robot = model(robot_id).unwrap();
    let setup = RoomSetup::new(plan, robot, robot.default_cell, None).unwrap();
    let (info, params) = behaviour(behaviour_id);
    let mut run = setup.run_behaviour(info, &params, typical(), seed).unwrap();
    let mut mapper = mapper(robot, run.pose());
    let (laser, mut seen) = (robot.sensors.laser.unwrap(), SeenBoundary::default());
    let (mut metres, mut degrees) = (Vec::new(), Vec::new());
    while !run.is_finished() && run.time_s() < 60.0 * minutes {
        run.step();
        mapper.update(run.sensors());
        if run.steps().is_multiple_of(20) {
            seen.look(&run.floor().walls, &laser, run.pose(), RESOLUTION);
        }
        if run.steps().is_multiple_of(67) {
            metres.push((mapper.pose().position() - run.pose().position()).norm());
            degrees.push(difference(mapper.pose().heading, run.pose().heading).abs().to_degrees());
        }
    }
    let truth = MapTruth::of(run.floor(), RESOLUTION);
    let quality = truth.quality(mapper.map());
    let end = [*metres.last().unwrap(), *degrees.last().unwrap()];
    let [m, d] = [metres, degrees].map(median);
    [end[0], end[1], m, d, 100.0 * quality.right, 100.0 * seen.mapped(&truth, mapper.map())]
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    quantile(&values, 0.5).unwrap()
}

#[test]
fn a_laser_keeps_the_pose_within_centimetres_and_maps_what_it_sees() {
    let plan = (room("bedroom").unwrap().build)();
    for robot in ROBOTS {
        let [metres, degrees, .., right, seen] = outcome(&plan, robot, "bounce", 1, 3.0);
        assert!(metres < 0.05 && degrees < 2.0, "{robot}: {metres} m, {degrees} degrees");
        assert!(right > 99.0 && seen > 97.0, "{robot}: {right} % right, {seen} % of the boundary");
    }
}

/// The tables of docs/maps.md, for rooms that ship and five real plans in the folder FLOORPLANS, or ../shared/maps/floorplans, if
/// they are there:
/// `cargo test --release --test algorithms -- --ignored --nocapture twenty_seeds_by_laser`, or with `ONLY="cbot flat"` one row, and
/// with `SEEDS=201-204` those seeds.
#[test]
#[ignore = "soak: over three hundred runs of twenty minutes"]
fn twenty_seeds_by_laser() {
    let mut plans: Vec<(String, FloorPlan)> =
        ["flat", "kitchen", "office"].map(|id| (id.to_owned(), (room(id).unwrap().build)())).into();
    let floorplans = concat!(env!("CARGO_MANIFEST_DIR"), "/../shared/maps/floorplans").to_owned();
    let folder = PathBuf::from(std::env::var("FLOORPLANS").unwrap_or(floorplans));
    for name in ["lab_ipa_furnitures", "Freiburg52_scan_furnitures", "office_b_furnitures", "lab_ipa", "lab_d_scan"] {
        let file = format!("{name}.png");
        if let Ok(bytes) = std::fs::read(folder.join(&file)) {
            plans.push((name.to_owned(), load(&[SourceFile { name: file, bytes }]).unwrap()));
        }
    }
    let only = std::env::var("ONLY").unwrap_or_default();
    let seeds = std::env::var("SEEDS").unwrap_or("101-120".to_owned());
    let (first, last) = seeds.split_once('-').unwrap_or((&seeds, &seeds));
    let seeds: RangeInclusive<u64> = first.parse().unwrap()..=last.parse().unwrap();
    // The snake in an unknown room sees each place for longer.
    let slow =
        [("cbot", "Freiburg52_scan_furnitures", "online_snake"), ("cbot", "office_b_furnitures", "online_snake")];
    let walls = ROBOTS.into_iter().flat_map(|robot| plans.iter().map(move |(name, _)| (robot, &**name, "wall_follow")));
    for (robot, name, behaviour) in walls.chain(slow) {
        let row = format!("{robot} {name} {behaviour}");
        for (_, plan) in plans.iter().filter(|(of, _)| of == name && row.contains(&only)) {
            let run = |seed| {
                let run = outcome(plan, robot, behaviour, seed, 20.0);
                println!("{row} {seed}: {run:.3?}");
                run
            };
            let runs: Vec<[f64; 6]> = seeds.clone().map(run).collect();
            let column = |i: usize| median(runs.iter().map(|run| run[i]).collect());
            let [metres, degrees, m, d, right, seen] = std::array::from_fn(column);
            println!(
                "| {robot} | {name} | {behaviour} | {:.1} cm, {degrees:.1}° | {:.1} cm, {d:.1}° | {right:.1} % | {seen:.1} % |",
                100.0 * metres,
                100.0 * m
            );
            // Along the walls of larger buildings the pose drifts until a loop closes; docs/maps.md says by how much.
            if ["flat", "kitchen", "office"].contains(&name) || behaviour == "online_snake" {
                assert!(metres <= 0.03 && degrees <= 1.0 && right >= 99.0 && seen >= 97.0, "{row}");
            }
        }
    }
}

#[test]
fn a_kidnapped_robot_relocalises_by_scans() {
    let (plan, (info, params)) = ((room("flat").unwrap().build)(), behaviour("wall_follow"));
    for robot in ROBOTS.map(|id| model(id).unwrap()) {
        let prepared = RoomSetup::new(&plan, robot, robot.default_cell, None).unwrap();
        let (conditions, odometry, duration_s) = (typical(), OdometryModel::Arc, 60.0);
        let kidnapping = Kidnapping {
            plan: &plan,
            prepared: &prepared,
            robot,
            behaviour: info,
            params: &params,
            conditions,
            odometry,
            duration_s,
        };
        for seed in 1..=2 {
            let trial = kidnapping.run(seed).unwrap();
            assert!(trial.found_s.is_some(), "{}: {trial:?}", robot.id);
        }
    }
}

/// A scan from the middle of a room of 4 m x 3 m, with the robot turned by `heading`.
fn scan_of_a_room(robot: &RobotModel, heading: f64) -> Arc<[f32]> {
    scan_between_walls(robot, heading, [2.0, 1.5])
}

/// A scan from the middle of a room whose walls are so far away, m.
fn scan_between_walls(robot: &RobotModel, heading: f64, [x, y]: [f64; 2]) -> Arc<[f32]> {
    let laser = robot.sensors.laser.unwrap();
    let beam = |beam: usize| {
        let angle = heading + laser.first + laser.step * beam as f64;
        let (sin, cos) = (angle.sin(), angle.cos());
        (x / cos.abs()).min(y / sin.abs()) as f32
    };
    (0..laser.beams).map(beam).collect()
}

#[test]
fn a_room_that_is_new_is_not_taken_for_another_place_of_the_map() {
    let robot = model("roomba600_lidar").unwrap();
    let mut mapper = mapper(robot, Pose::new(0.0, 0.0, 0.0));
    let mut sensed = SensorReadings { laser: Some(scan_of_a_room(robot, 0.0)), ..SensorReadings::default() };
    mapper.update(&sensed);
    for step in 0..60_u16 {
        // Nothing of it is known.
        sensed.laser = Some(scan_between_walls(robot, 0.0, [3.7, 3.1]));
        let counts = (0.015 * robot.counts_per_metre) as u16;
        sensed.left_counts = sensed.left_counts.wrapping_add(counts);
        sensed.right_counts = sensed.right_counts.wrapping_add(counts);
        mapper.update(&sensed);
        assert!(!mapper.is_lost(), "step {step}");
    }
}

#[test]
fn wheels_that_spin_while_the_body_is_wedged_do_not_turn_the_pose() {
    let robot = model("roomba600_lidar").unwrap();
    let mut mapper = mapper(robot, Pose::new(0.0, 0.0, 0.0));
    let mut sensed = SensorReadings::default();
    for step in 0..400_u16 {
        if step.is_multiple_of(7) {
            sensed.laser = Some(scan_of_a_room(robot, 0.0));
        }
        sensed.left_counts = sensed.left_counts.wrapping_sub(6);
        sensed.right_counts = sensed.right_counts.wrapping_add(6);
        mapper.update(&sensed);
        if step > 50 {
            let off = mapper.pose().heading.abs().to_degrees();
            assert!(off < 1.0, "step {step}: turned by {off} degrees");
        }
    }
    let by_odometry = 2.0 * 400.0 * 6.0 / robot.counts_per_metre / robot.wheel_base;
    assert!(by_odometry > 6.0, "more than a full turn by the wheels");
}

#[test]
fn counts_that_come_one_after_the_other_in_a_turn_on_the_spot_are_no_way() {
    let robot = model("cbot").unwrap();
    let mut mapper = mapper(robot, Pose::new(0.0, 0.0, 0.0));
    let mut sensed = SensorReadings::default();
    mapper.update(&sensed);
    // No scan arrives, so the wheels alone tell the pose; four and a half turns, as errors of full turns cancel.
    sensed.laser = Some([].into());
    let steps = (4.5 * std::f64::consts::PI * robot.wheel_base * robot.counts_per_metre) as u32;
    for step in 0..2 * steps {
        if step.is_multiple_of(2) {
            sensed.right_counts = sensed.right_counts.wrapping_add(1);
        } else {
            sensed.left_counts = sensed.left_counts.wrapping_sub(1);
        }
        mapper.update(&sensed);
    }
    let off = mapper.pose().position().coords.norm();
    assert!(off < 0.005, "{off} m");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// Whatever a broken scanner reports, there is a pose and a map.
    #[test]
    fn no_scan_upsets_it(
        scans in prop::collection::vec((any::<[u16; 2]>(), prop::collection::vec(any::<f32>(), 0..200)), 1..40),
        is_near in any::<bool>(),
        robot in 0..MODELS.len(),
    ) {
        let mut mapper = mapper(MODELS[robot], Pose::new(0.0, 0.0, 0.0));
        let mut sensed = SensorReadings::default();
        for (jumps, scan) in scans {
            sensed.left_counts = sensed.left_counts.wrapping_add(jumps[0] % 512);
            sensed.right_counts = sensed.right_counts.wrapping_add(jumps[1] % 512);
            let ranges = scan.into_iter().map(|range| if is_near { range.abs() % 6.0 } else { range });
            sensed.laser = Some(ranges.collect());
            mapper.update(&sensed);
            let (pose, spread) = (mapper.pose(), mapper.pose_covariance());
            prop_assert!([pose.x, pose.y, pose.heading].iter().all(|value| value.is_finite()));
            prop_assert!(spread.position.iter().all(|value| value.is_finite()) && spread.heading.is_finite());
        }
    }
}
