//! The same controllers on the simulated robot and on the other end of a line.

use super::wire::{Wire, flat, hall, roomba, setup_in};
use robovac_core::{
    floor_plan::{FloorPlan, generate::random_flat},
    geometry::{Point, difference, nearest_on_segment},
    registry::Params,
    robot::OdometryModel,
};
use robovac_sim::{
    Conditions, Run,
    controller::{BEHAVIOURS, FollowPath, Setup},
    experiment::planning::{PlanRequest, Planned, RoomSetup},
    program::{Piloted, RemotePilot},
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
    // At most 3 % more. It is 3.5 % less: over so short a line, one second less at its ends.
    let ratio = took / run.time_s();
    assert!((0.95..1.03).contains(&ratio), "{took} s instead of {} s", run.time_s());
    let [x, y, _] = wire.view().pose;
    assert!((Point::new(x, y) - here.position()).norm() < 0.01, "odometry {x} {y}, truth {here}");
}

#[test]
fn a_program_that_no_longer_answers_has_ended_and_is_not_done() {
    let setup = setup_in(&hall(), Conditions::default(), 1);
    let mut wire = Wire::new(&setup, "model");
    wire.connect();
    wire.arm();
    let start = setup.floor.start;
    let ride = |wire: &mut Wire, pilot: &RemotePilot| {
        let controller = Box::new(Piloted::new(pilot.clone(), &setup.robot, start));
        wire.link.ride(wire.now, "Your program", controller, start, false).unwrap();
        wire.pass(0.1);
        pilot.answer(Some([200.0, 200.0]));
        wire.pass(0.1);
        assert!(wire.is_rolling());
    };
    let silent = RemotePilot::default();
    ride(&mut wire, &silent);
    wire.pass(1.0);
    assert!(silent.has_missed() && !wire.is_rolling());
    let doing = wire.view().doing;
    assert_eq!(doing.title, "Your program: ended");
    assert_eq!(doing.note, "Stopped: its program didn't answer within 200 ms; the computer may be busy.");
    let done = RemotePilot::default();
    ride(&mut wire, &done);
    done.answer(None);
    wire.pass(0.5);
    assert_eq!(wire.view().doing.title, "Your program: done");
}

#[test]
fn every_behaviour_rides_as_far_as_in_the_simulator() {
    for info in BEHAVIOURS.iter().filter(|info| info.claims.cleans && !info.claims.needs_laser) {
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

/// Drives a plan with rounded corners over the line, and compares it with the simulator. Returns both times, s.
fn smooth_over_the_line(plan: &FloorPlan, planner: &str) -> [f64; 2] {
    let robot = roomba();
    let prepared = RoomSetup::new(plan, &robot, 0.15, None).unwrap();
    let planner = coverage_planners::find(planner).unwrap();
    let params = Params::defaults(planner.params);
    let request = PlanRequest { id: 1, planner, params, seed: 1, job: prepared.job.clone().rounded(true) };
    let answer = request.serve(|| 0.0, None).unwrap();
    let planned = Planned::new(&prepared, &answer).unwrap().rounded(&prepared, &request.smooth_setup()).unwrap();
    let trajectory = planned.smooth.clone().unwrap();
    let points = trajectory.points();
    let mut run = planned.run(&prepared, Conditions::default(), OdometryModel::Arc, 1);
    while !run.is_finished() {
        run.step();
        assert!(run.time_s() < 1800.0);
    }
    let setup = prepared.setup(Conditions { spare_batteries: true, ..Conditions::default() }, 1);
    let mut wire = Wire::new(&setup, "model");
    wire.connect();
    wire.arm();
    let follower = prepared.follower(&robot, &planned.line, OdometryModel::Arc).carefully();
    let controller = Box::new(planned.driven().follower(&robot, follower));
    wire.link.ride(wire.now, "Smooth", controller, prepared.floor.start, true).unwrap();
    let mut farthest: f64 = 0.0;
    let took = wire.pass_until(1800.0, |wire| {
        let view = wire.view();
        let [x, y, _] = view.pose;
        let here = Point::new(x, y);
        let beside = points.windows(2).map(|pair| (nearest_on_segment(pair[0], pair[1], here) - here).norm());
        farthest = farthest.max(beside.fold(f64::MAX, f64::min));
        view.ride.unwrap().done
    });
    assert!(farthest < 0.03, "{farthest} m from the plan, by its estimate");
    let (there, here) = (run.pose(), wire.pose());
    assert!((there.position() - here.position()).norm() < 0.05, "{there} {here}");
    [took, run.time_s()]
}

// slow: a room, byte by byte
#[test]
fn rounded_corners_take_as_long_over_the_line_as_in_the_simulator() {
    let plan = random_flat(1, 1, 1);
    let [took, simulated] = smooth_over_the_line(&plan, "boustrophedon");
    assert!(took < 1.03 * simulated, "{took} s instead of {simulated} s");
}

// slow: a whole flat, byte by byte
#[test]
fn lanes_of_the_flat_take_as_long_over_the_line_as_in_the_simulator() {
    let [took, simulated] = smooth_over_the_line(&flat(), "lanes");
    println!("{took:.1} s over the line, {simulated:.1} s in the simulator");
    assert!(took < 1.03 * simulated, "{took} s instead of {simulated} s");
}

// slow: a whole flat, byte by byte
#[test]
fn a_planned_path_cleans_the_flat_over_the_line() {
    let plan = flat();
    let prepared = RoomSetup::new(&plan, &roomba(), 0.25, None).unwrap();
    let planner = coverage_planners::find("boustrophedon").unwrap();
    let params = Params::defaults(planner.params);
    let request = PlanRequest { id: 1, planner, params, seed: 1, job: prepared.job.clone() };
    let answer = request.serve(|| 0.0, None).unwrap();
    let planned = Planned::new(&prepared, &answer).unwrap();
    let setup = prepared.setup(Conditions { spare_batteries: true, ..Conditions::default() }, 1);
    let mut wire = Wire::new(&setup, "model");
    wire.connect();
    wire.arm();
    let follower = prepared.follower(&prepared.robot, &planned.line, OdometryModel::Arc).carefully();
    wire.link.ride(wire.now, "Boustrophedon", Box::new(follower), prepared.floor.start, true).unwrap();
    let mut tracker = robovac_core::coverage::CoverageTracker::new(&prepared.floor);
    tracker.sweep_to(&prepared.floor, wire.pose());
    let took = wire.pass_until(7200.0, |wire| {
        tracker.sweep_to(&prepared.floor, wire.robot.pose());
        wire.view().ride.unwrap().done
    });
    let mut run = planned.run(&prepared, Conditions::default(), OdometryModel::Arc, 1);
    while !run.is_finished() {
        run.step();
        assert!(run.time_s() < 7200.0);
    }
    assert!((0.97..1.03).contains(&(took / run.time_s())), "{took} s instead of {} s", run.time_s());
    let coverage = tracker.coverage(&prepared.floor);
    assert!(coverage > planned.drive.coverage - 0.03, "{coverage} instead of {}", planned.drive.coverage);
}
