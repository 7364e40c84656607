//! The same controllers on the simulated robot and on the other end of a line.

use super::wire::{Wire, flat, hall, roomba, setup_in};
use robovac_core::{
    geometry::{Point, difference},
    registry::Params,
    robot::OdometryModel,
};
use robovac_sim::{
    Conditions, Run,
    controller::{BEHAVIOURS, FollowPath, Setup},
    experiment::planning::RoomSetup,
};
use std::sync::Arc;

#[test]
fn a_line_is_driven_alike_by_the_simulator_and_over_the_line() {
    let setup = setup_in(&hall(), Conditions::default(), 1);
    let start = setup.floor.start;
    let corners = [(3.0, 2.5), (4.5, 2.5), (4.5, 3.5), (2.0, 3.5), (2.0, 2.5), (3.0, 2.5)];
    let line: Arc<[Point]> = corners.iter().map(|&(x, y)| Point::new(x, y)).collect();
    let follower = || Box::new(FollowPath::new(&setup.robot, OdometryModel::Arc, start, Arc::clone(&line)));
    let mut run = Run::new(&setup, follower());
    while !run.is_finished() {
        run.step();
        assert!(run.time_s() < 300.0);
    }
    let mut wire = Wire::new(&setup, "model");
    wire.connect();
    wire.arm();
    wire.link.ride(wire.now, "Line", follower(), start, false).unwrap();
    let took = wire.pass_until(300.0, |wire| wire.view().ride.unwrap().done);
    wire.pass(0.5);
    let (there, here) = (run.pose(), wire.pose());
    // An encoder count is 0.44 mm, a command a whole mm/s, and it comes two frames later: 9 mm at 0.3 m/s a corner.
    assert!((there.position() - here.position()).norm() < 0.03, "{there} {here}");
    assert!(difference(there.heading, here.heading).abs() < 0.06, "{there} {here}");
    assert!((took - run.time_s()).abs() < 0.05 * run.time_s(), "{took} {}", run.time_s());
    let [x, y, _] = wire.view().pose;
    assert!((Point::new(x, y) - here.position()).norm() < 0.01, "odometry {x} {y}, truth {here}");
}

#[test]
fn every_behaviour_rides_as_far_as_in_the_simulator() {
    for info in BEHAVIOURS.iter().filter(|info| info.claims.cleans) {
        let setup = setup_in(&flat(), Conditions::default(), 1);
        let params = Params::defaults(info.params);
        let controller = || info.build(&Setup { robot: &setup.robot, params: &params, seed: 1 }).unwrap();
        let mut run = Run::new(&setup, controller());
        while run.time_s() < 120.0 && !run.is_finished() {
            run.step();
        }
        let mut wire = Wire::new(&setup, "model");
        wire.connect();
        wire.arm();
        wire.link.ride(wire.now, info.title, controller(), setup.floor.start, false).unwrap();
        wire.pass(120.0);
        let view = wire.view();
        assert!(view.drop.is_none(), "{}: {:?}", info.id, view.drop);
        let ratio = view.distance_m / run.distance_m();
        assert!((0.85..1.15).contains(&ratio), "{}: {} m instead of {} m", info.id, view.distance_m, run.distance_m());
        assert!(view.ride.is_some_and(|ride| !ride.done || run.is_finished()), "{}", info.id);
    }
}

// slow: a whole flat, byte by byte
#[test]
fn a_planned_path_cleans_the_flat_over_the_line() {
    let plan = flat();
    let prepared = RoomSetup::new(&plan, &roomba(), 0.25, None).unwrap();
    let planner = coverage_planners::find("boustrophedon").unwrap();
    let params = Params::defaults(planner.params);
    let request =
        robovac_sim::experiment::planning::PlanRequest { id: 1, planner, params, seed: 1, job: prepared.job.clone() };
    let answer = request.serve(|| 0.0, None).unwrap();
    let planned = robovac_sim::experiment::planning::Planned::new(&prepared, &answer).unwrap();
    let setup = prepared.setup(Conditions { spare_batteries: true, ..Conditions::default() }, 1);
    let mut wire = Wire::new(&setup, "model");
    wire.connect();
    wire.arm();
    let follower = prepared.follower(&prepared.robot, &planned.line, OdometryModel::Arc).carefully();
    wire.link.ride(wire.now, "Boustrophedon", Box::new(follower), prepared.floor.start, true).unwrap();
    let mut tracker = robovac_core::coverage::CoverageTracker::new(&prepared.floor);
    tracker.sweep_to(&prepared.floor, wire.pose());
    wire.pass_until(7200.0, |wire| {
        tracker.sweep_to(&prepared.floor, wire.robot.pose());
        wire.view().ride.unwrap().done
    });
    let coverage = tracker.coverage(&prepared.floor);
    assert!(coverage > planned.drive.coverage - 0.03, "{coverage} instead of {}", planned.drive.coverage);
}
