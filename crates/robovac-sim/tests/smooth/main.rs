//! Smooth driving: rounded corners touch nothing and leave out no more floor than they may; the follower drives them in the
//! time that was planned.

use coverage_planners::{
    find,
    lanes::swept_share,
    metrics::DriveMetrics,
    smooth::{SmoothError, SmoothPath, SmoothSetup},
};
use robovac_core::{
    floor_plan::{generate::random_flat, room},
    geometry::{Point, nearest_on_segment},
    registry::{ParamValue, Params},
    robot::{MODELS, OdometryModel, WheelLayout, model},
    trajectory::{DriveLimits, Trajectory},
};
use robovac_sim::{
    Conditions, Run, SlipLevel,
    experiment::planning::{PathToDrive, PlanRequest, Planned, RoomSetup},
};
use std::sync::Arc;

/// Rooms by seed, with the planners that walk them.
const CASES: [(u64, &str); 4] =
    [(0, "boustrophedon"), (1, "contour"), (2, "backtracking_spiral"), (3, "wavefront_path")];

fn planned(room: &RoomSetup, planner: &str) -> Planned {
    let planner = find(planner).unwrap();
    let params = Params::defaults(planner.params);
    let request = PlanRequest { id: 0, planner, params, seed: 1, job: room.job.clone() };
    Planned::new(room, &request.serve(|| 0.0, None).unwrap()).unwrap()
}

fn room_of(seed: u64, robot: &str) -> RoomSetup {
    let robot = model(robot).unwrap();
    RoomSetup::new(&random_flat(1, 1, seed), robot, robot.default_cell, None).unwrap()
}

fn smooth(room: &RoomSetup, line: &[Point]) -> SmoothPath {
    room.smooth(line, &SmoothSetup::default(), false).unwrap()
}

/// Distance of a point from a line, m.
fn beside(points: &[Point], at: Point) -> f64 {
    let distances = points.windows(2).map(|pair| (nearest_on_segment(pair[0], pair[1], at) - at).norm());
    distances.fold(f64::MAX, f64::min)
}

/// Drives to the end; returns the farthest that the robot's estimate was from the trajectory, m.
fn drive(run: &mut Run, trajectory: &Trajectory) -> f64 {
    let points = trajectory.points();
    let mut farthest: f64 = 0.0;
    while !run.is_finished() {
        run.step();
        assert!(run.time_s() < 7200.0, "it gets to the end");
        if run.steps().is_multiple_of(5) {
            farthest = farthest.max(beside(&points, run.estimate().unwrap().position()));
        }
    }
    farthest
}

// slow: rooms with plans, and the exact measure of what they sweep
#[test]
fn rounded_corners_touch_nothing_and_keep_the_floor_swept() {
    for (seed, planner) in CASES {
        for robot in ["roomba600", "cbot"] {
            let room = room_of(seed, robot);
            let plan = planned(&room, planner);
            let setup = SmoothSetup::default();
            let path = smooth(&room, &plan.line);
            let points = path.trajectory.points();
            let name = format!("{planner} by {robot}, seed {seed}");
            assert!(path.trajectory.duration_s() < plan.drive.duration_s, "{name}");
            assert!(path.rounded > 0, "{name}");
            let swept = [&points[..], &plan.line].map(|line| swept_share(&room.floor, line));
            assert!(swept[0] >= swept[1] - setup.loss - 2e-4, "{name}: {swept:?}");
            let limits = room.floor.limits();
            for knots in path.trajectory.knots().windows(2) {
                let at = knots[0].pose.position();
                let cut = beside(&plan.line, at);
                assert!(cut <= setup.cut + 1e-6, "{name}: {cut} m from the line");
                if knots[0].curvature != 0.0 {
                    let reach = limits.body_radius + setup.clearance - 1e-3;
                    assert!(limits.nearest(at, reach).is_none(), "{name}: less than 2 mm of room at {at}");
                }
            }
            for &corner in plan.line.iter() {
                assert!(beside(&points, corner) <= setup.cut + 1e-6, "{name}: corner at {corner}");
            }
        }
    }
}

/// Lanes for a robot that rounds corners beat lanes for one that stops there and whose corners are rounded afterwards.
// slow: four searches, as long as the page takes
#[test]
fn lanes_that_expect_curves_are_faster_and_sweep_what_was_asked() {
    let planner = find("lanes").unwrap();
    for seed in [1, 2] {
        let room = room_of(seed, "roomba600");
        let [afterwards, expected] = [false, true].map(|is_rounded| {
            let params = Params::checked(
                planner.params,
                [("coverage", ParamValue::Number(97.0)), ("effort", ParamValue::Number(1.0))],
            )
            .unwrap();
            let job = room.job.clone().rounded(is_rounded);
            let request = PlanRequest { id: 0, planner, params, seed: 1, job };
            let plan = Planned::new(&room, &request.serve(|| 0.0, None).unwrap()).unwrap();
            let path = room.smooth(&plan.line, &request.smooth_setup(), false).unwrap();
            let swept = swept_share(&room.floor, &path.trajectory.points());
            let least = if is_rounded { 0.97 } else { 0.97 - SmoothSetup::default().loss };
            assert!(swept >= least - 2e-4, "seed {seed}, expected {is_rounded}: {swept}");
            let touched = path.trajectory.knots().iter().find(|knot| {
                room.floor.limits().nearest(knot.pose.position(), room.floor.limits().body_radius + 1e-3).is_some()
            });
            assert!(touched.is_none(), "seed {seed}, expected {is_rounded}: less than 1 mm of room at {touched:?}");
            path.trajectory.duration_s()
        });
        assert!(expected < 0.98 * afterwards, "seed {seed}: {expected} s, not less than {afterwards} s");
    }
}

// slow: whole runs
#[test]
fn a_run_takes_the_planned_time_and_keeps_to_the_path() {
    for (seed, planner) in CASES {
        let room = room_of(seed, "roomba600");
        let plan = planned(&room, planner).rounded(&room, &SmoothSetup::default()).unwrap();
        let trajectory = plan.smooth.clone().unwrap();
        let mut run = plan.run(&room, Conditions::default(), OdometryModel::Arc, 1);
        let farthest = drive(&mut run, &trajectory);
        let ratio = run.time_s() / plan.drive.duration_s;
        assert!((ratio - 1.0).abs() < 0.01, "{planner}: {ratio}");
        assert!(farthest < 0.005 && run.bumps() == 0, "{planner}: {farthest} m, {} bumps", run.bumps());
        assert!(run.coverage() > plan.drive.coverage - 0.002, "{planner}: {} {}", run.coverage(), plan.drive.coverage);
    }
}

// slow: whole runs
#[test]
fn slipping_and_quantised_wheels_keep_to_the_path_by_the_estimate() {
    let room = room_of(1, "roomba600");
    let plan = planned(&room, "boustrophedon").rounded(&room, &SmoothSetup::default()).unwrap();
    let trajectory = plan.smooth.clone().unwrap();
    for (slip, quantised) in [(SlipLevel::Typical, false), (SlipLevel::None, true)] {
        let conditions = Conditions { slip, quantised, ..Conditions::default() };
        let mut stopping = room.run_along(&plan.line, conditions, OdometryModel::Arc, 5);
        while !stopping.is_finished() {
            stopping.step();
        }
        let mut run = plan.run(&room, conditions, OdometryModel::Arc, 5);
        let farthest = drive(&mut run, &trajectory);
        // Slip ends in bumps, and after a bump it is led past the obstacle by stops and turns.
        assert!(run.bumps() > 0 || farthest < 0.03, "{slip:?} {quantised}: {farthest} m");
        assert!(run.coverage() > stopping.coverage() - 0.05, "{} {}", run.coverage(), stopping.coverage());
    }
}

#[test]
fn stairs_are_as_safe_as_with_stops() {
    let robot = model("roomba600").unwrap();
    let plan = (room("stairs").unwrap().build)();
    let room = RoomSetup::new(&plan, robot, 0.2, None).unwrap();
    let plan = planned(&room, "boustrophedon").rounded(&room, &SmoothSetup::default()).unwrap();
    for seed in 0..3 {
        let conditions = Conditions { slip: SlipLevel::Harsh, ..Conditions::default() };
        let mut run = plan.run(&room, conditions, OdometryModel::Arc, seed);
        while !run.is_finished() {
            run.step();
            assert!(run.time_s() < 7200.0, "seed {seed}: it gets to the end");
        }
        assert_eq!(run.falls(), 0, "seed {seed}");
    }
}

#[test]
fn only_differential_drives_round_corners() {
    for robot in MODELS.iter().filter(|robot| !robot.fills_cell) {
        let room = RoomSetup::new(&random_flat(1, 1, 1), robot, robot.default_cell, None).unwrap();
        let start = room.floor.start.position();
        let result = room.smooth(
            &[start, start + robovac_core::geometry::Vector::new(0.1, 0.0)],
            &SmoothSetup::default(),
            false,
        );
        match robot.wheels {
            WheelLayout::Differential => assert!(result.is_ok() && DriveLimits::of(robot).is_some()),
            WheelLayout::Omnidirectional => {
                assert_eq!(result.unwrap_err(), SmoothError::NotDifferential(robot.title));
            }
        }
    }
}

/// A line of which nothing can be rounded is driven as it is.
#[test]
fn there_and_back_is_turned_on_the_spot() {
    let room = room_of(1, "roomba600");
    let start = room.floor.start.position();
    let ahead = start + room.floor.start.direction() * 0.2;
    let line: Arc<[Point]> = [start, ahead, start, ahead].into();
    let path = smooth(&room, &line);
    assert_eq!((path.corners, path.rounded), (2, 0));
    assert!(path.trajectory.duration_s() < DriveMetrics::of(&room.floor, &room.robot, &line).duration_s);
    let driven = PathToDrive { line, smooth: Some(Arc::new(path.trajectory.clone())) };
    let mut run = room.run_driven(&driven, Conditions::default(), OdometryModel::Arc, 1);
    assert!(drive(&mut run, &path.trajectory) < 0.005);
    assert!((run.time_s() / path.trajectory.duration_s() - 1.0).abs() < 0.05, "{}", run.time_s());
    assert!((run.pose().position() - ahead).norm() < 0.005);
}
