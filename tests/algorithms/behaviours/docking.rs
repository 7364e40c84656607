//! Home by the beams.

use super::support::{conditions, lay_out, lay_out_from, run, run_with, starting_from};
use coverage_planners::smooth::SmoothSetup;
use rand::RngExt;
use robovac_core::{
    coverage::with_objects,
    floor_plan::{FloorPlan, Object, ROOMS, RoomKind, Sketch},
    geometry::{Point, Pose, difference},
    math,
    registry::{ParamValue, Params},
    rng::seeded,
    robot::{OdometryModel, model},
};
use robovac_sim::{
    Conditions, Input, NoiseLevel, Run, RunSetup, World, berth,
    controller::{self, BehaviourInfo, Recharge},
    experiment::planning::{PathToDrive, RoomSetup},
};
use std::sync::Arc;

/// A furnished room of 4 m x 3 m with a dock in the middle of its lower wall.
pub fn room_with_dock() -> FloorPlan {
    let sketch = Sketch::open(4.0, 3.0, 0.05).fill(&[[0.0, 2.2, 0.9, 3.0], [3.4, 0.0, 4.0, 0.8]]).disc(2.6, 2.2, 0.2);
    let mut plan = sketch.start(1.0, 1.5, 0.0).finish("dock", "");
    plan.objects.push(Object::Dock { pose: Pose::new(1.8, 0.0, math::FRAC_PI_2) });
    plan
}

fn behaviour(id: &str) -> &'static BehaviourInfo {
    controller::find(id).expect("it is in the registry")
}

/// From a random place in that room, seconds to the dock; `None` if it takes more than `minutes`.
fn seconds_home(plan: &FloorPlan, laid_out: &RunSetup, seed: u64, minutes: f64) -> Option<f64> {
    let mut rng = seeded(seed, 77);
    let mut random = |most: f64| rng.random_range(0.0..most);
    let pose = Pose::new(random(plan.width_m()), random(plan.height_m()), random(math::TAU));
    let setup = starting_from(laid_out, pose);
    let info = behaviour("dock");
    let mut run = run_with(&setup, info, &Params::defaults(info.params), seed);
    while !run.is_finished() && run.time_s() < 60.0 * minutes {
        run.step();
    }
    assert!(!run.is_finished() || run.sensors().battery.on_dock, "done without being charged");
    run.is_finished().then(|| run.time_s())
}

#[test]
fn most_robots_come_home_within_a_quarter_of_an_hour() {
    let (plan, robot) = (room_with_dock(), model("roomba600").expect("it ships"));
    for (level, least) in [(NoiseLevel::Off, 36), (NoiseLevel::Typical, 36), (NoiseLevel::Harsh, 32)] {
        let laid_out = lay_out(&plan, robot, conditions(level)).expect("it fits");
        let mut seconds: Vec<f64> = (0..40).filter_map(|seed| seconds_home(&plan, &laid_out, seed, 15.0)).collect();
        seconds.sort_by(f64::total_cmp);
        let median = seconds.get(seconds.len() / 2);
        println!("{level:?}: {} of 40 home, median {median:?} s, last {:?} s", seconds.len(), seconds.last());
        assert!(seconds.len() >= least, "{level:?}: {} of 40 home", seconds.len());
    }
}

fn low_battery(plan: &FloorPlan, percent: u8) -> RunSetup {
    let conditions = Conditions { start_charge_percent: percent, ..conditions(NoiseLevel::Typical) };
    lay_out(plan, model("roomba600").expect("it ships"), conditions).expect("it fits")
}

fn step_until(run: &mut Run, minutes: f64, mut is_so: impl FnMut(&Run) -> bool) -> bool {
    let end = run.time_s() + 60.0 * minutes;
    while run.time_s() < end && !run.is_finished() {
        run.step();
        if is_so(run) {
            return true;
        }
    }
    false
}

#[test]
fn cleaning_robots_go_home_are_charged_and_go_on() {
    for id in ["random_walk", "cleaning_cycle"] {
        let info = behaviour(id);
        let given = [("home_at", ParamValue::Number(15.0)), ("leave_at", ParamValue::Number(20.0))];
        let params = Params::checked(info.params, given).expect("they are in range");
        let mut run = run_with(&low_battery(&room_with_dock(), 17), info, &params, 3);
        assert!(step_until(&mut run, 5.0, |run| run.activity() == "searching for the dock"), "{id} cleans on");
        assert!(step_until(&mut run, 15.0, |run| run.activity() == "charging"), "{id} doesn't get home");
        let place = run.pose().position();
        assert!(step_until(&mut run, 60.0, |run| run.activity() == "leaving the dock"), "{id} stays at home");
        assert!((run.pose().position() - place).norm() < 0.02, "{id} doesn't stand still on its dock");
        assert!(run.sensors().battery.share() >= 0.199);
        let distance = run.distance_m();
        step_until(&mut run, 2.0, |_| false);
        assert!(run.distance_m() > distance + 5.0 && !run.sensors().battery.on_dock, "{id} doesn't go on");
    }
}

#[test]
fn nobody_goes_home_who_is_told_not_to() {
    let info = behaviour("random_walk");
    let params = Params::checked(info.params, [("home_at", ParamValue::Number(0.0))]).expect("it is in range");
    let mut run = run_with(&low_battery(&room_with_dock(), 10), info, &params, 3);
    assert!(!step_until(&mut run, 2.0, |run| run.activity() == "searching for the dock"));
}

#[test]
fn every_furnished_room_has_a_dock_that_charges() {
    for info in ROOMS.iter().filter(|info| info.kind == RoomKind::Cluttered) {
        let plan = (info.build)();
        let docks = World::new(&plan).docks;
        let [dock] = docks[..] else { panic!("{} has {} docks", info.id, docks.len()) };
        // Rooms keep their floor: the docks of those with nothing else in them are recessed.
        if plan.objects.len() == 1 {
            assert_eq!(with_objects(&plan).occupancy, plan.occupancy, "{}", info.id);
        }
        let (robot, level) = (model("roomba600").expect("it ships"), NoiseLevel::Typical);
        let at = dock.to_world(Point::new(0.75, 0.05));
        let start = Pose::new(at.x, at.y, dock.heading + math::PI);
        let setup = lay_out_from(&plan, robot, conditions(level), start).expect("it fits");
        assert!((setup.floor.start.position() - at).norm() < 0.1, "{}: no floor before the dock", info.id);
        let mut run = run(&setup, behaviour("dock"), 1);
        assert!(step_until(&mut run, 1.0, |run| run.sensors().battery.on_dock), "{}: it isn't charged", info.id);
        assert!((run.pose().position() - berth(dock, robot).position()).norm() < 0.03, "{}", info.id);
    }
}

/// Lanes 0.4 m apart over the right half of the room, and a Roomba that follows them and recharges below `low` percent up
/// to a little more.
fn planned(start_charge_percent: u8, low: f64, level: NoiseLevel, seed: u64) -> (RoomSetup, Run) {
    follows(false, start_charge_percent, low, level, seed)
}

/// The same, with its corners rounded if it `is_smooth`.
fn follows(is_smooth: bool, start_charge_percent: u8, low: f64, level: NoiseLevel, seed: u64) -> (RoomSetup, Run) {
    let robot = model("roomba600").expect("it ships");
    let prepared = RoomSetup::new(&room_with_dock(), robot, 0.15, None).expect("it fits");
    let line = [(1.0, 1.5), (3.0, 1.5), (3.0, 1.1), (1.2, 1.1), (1.2, 0.6), (3.0, 0.6), (3.0, 1.8), (1.2, 1.8)];
    let line: Arc<[Point]> = line.map(|(x, y)| Point::new(x, y)).into();
    let rounded = is_smooth.then(|| prepared.smooth(&line, &SmoothSetup::default(), false).expect("it has two wheels"));
    let smooth = rounded.map(|path| Arc::new(path.trajectory));
    let driven = PathToDrive { line: Arc::clone(&line), smooth };
    let follower = driven.follower(robot, prepared.follower(robot, &line, OdometryModel::Arc));
    let docks = &prepared.world.docks;
    let recharge = Recharge::new(&follower, &prepared.floor, docks, seed).expect("it can dock").between(low, low + 2.0);
    let conditions = Conditions { start_charge_percent, ..conditions(level) };
    let run = Run::new(&prepared.setup(conditions, seed), Box::new(recharge));
    (prepared, run)
}

#[test]
fn a_planned_run_goes_home_is_charged_and_goes_on_where_it_stopped() {
    for seed in 0..4 {
        // With stops at its corners, and smoothly.
        let is_smooth = seed % 2 == 1;
        let (_, mut run) = follows(is_smooth, 50, 49.8, NoiseLevel::Typical, seed);
        assert!(step_until(&mut run, 2.0, |run| run.activity() == "driving back to its dock"), "it doesn't go home");
        let (left, corner) = (run.pose(), run.corner());
        assert!(step_until(&mut run, 5.0, |run| run.activity() == "charging"), "{seed}: it doesn't get home");
        assert!(run.sensors().battery.on_dock);
        assert!(step_until(&mut run, 10.0, |run| run.activity() == "driving back to its path"), "it stays at home");
        assert!(run.sensors().battery.share() >= 0.517, "{seed}: it leaves too soon");
        assert!(step_until(&mut run, 2.0, |run| run.activity().is_empty()), "{seed}: it doesn't come back");
        let off = (run.pose().position() - left.position()).norm();
        assert!(off < 0.15, "{seed}: it goes on {off} m from where it stopped");
        assert_eq!(run.corner(), corner, "{seed}");
        step_until(&mut run, 5.0, |_| false);
        assert!(run.is_finished() && !run.sensors().battery.on_dock, "{seed}: it isn't done");
        let off = (run.pose().position() - Point::new(1.2, 1.8)).norm();
        assert!(off < 0.25, "{seed}: it ends {off} m off");
    }
}

#[test]
fn a_planned_run_with_charge_left_is_the_same_as_without_a_dock() {
    let (prepared, mut run) = planned(100, 15.0, NoiseLevel::Off, 1);
    let line: Arc<[Point]> = [Point::new(1.0, 1.5), Point::new(3.0, 1.5)].into();
    let follower = prepared.follower(&prepared.robot, &line, OdometryModel::Arc);
    let mut bare = Run::new(&prepared.setup(Conditions::default(), 1), Box::new(follower));
    step_until(&mut run, 0.1, |_| false);
    step_until(&mut bare, 0.1, |_| false);
    assert_eq!(run.digest(), bare.digest());
}

#[test]
fn a_kidnapped_planned_run_relocalises_at_the_dock() {
    let mut home = 0;
    for seed in 0..4 {
        let (_, mut run) = planned(90, 15.0, NoiseLevel::Typical, seed);
        step_until(&mut run, 0.3, |_| false);
        run.apply(Input::Lift);
        step_until(&mut run, 0.05, |_| false);
        run.apply(Input::PutDown(Pose::new(2.4, 1.4, 2.0)));
        step_until(&mut run, 0.1, |_| false);
        assert!(run.pose_error_m() > Some(0.3), "{seed}: it can't know yet");
        if step_until(&mut run, 12.0, |run| run.activity() == "driving back to its path") {
            home += 1;
            let (estimate, pose) = (run.estimate().expect("it has one"), run.pose());
            assert!((estimate.position() - pose.position()).norm() < 0.04, "{seed}: {estimate}, {pose}");
            assert!(difference(estimate.heading, pose.heading).abs() < 0.16, "{seed}");
            step_until(&mut run, 5.0, |_| false);
            assert!(run.is_finished(), "{seed}: it doesn't go on");
        }
    }
    assert!(home >= 3, "{home} of 4 find their dock");
}
