//! The simulated robot: walls hold, odometry is right, plans get driven, runs repeat.

use coverage_planners::{CoveragePath, metrics::DriveMetrics};
use robovac_core::{
    coverage::{PlanningGrid, ReachableFloor},
    floor_plan::FloorPlan,
    geometry::{Point, Pose, Vector},
    grid::{Cell, Grid, Occupancy, from_picture},
    math,
    rng::{Rng, seeded},
    robot::{Drive, OdometryModel, SensorReadings, model},
};
use robovac_sim::{
    Conditions, Run, RunSetup, STEP_S, SlipLevel,
    controller::{Controller, FollowPath},
};
use std::sync::Arc;

/// 4 m x 3 m with a block and a thin wall, 5 cm cells.
fn room() -> FloorPlan {
    let mut occupancy = from_picture(&format!("{}\n", ".".repeat(80)).repeat(60), |_| Occupancy::Free).unwrap();
    for (x0, y0, x1, y1) in [(30, 20, 42, 30), (60, 0, 61, 40)] {
        for y in y0..y1 {
            for x in x0..x1 {
                occupancy[Cell::new(x, y)] = Occupancy::Occupied;
            }
        }
    }
    FloorPlan {
        name: "test".into(),
        note: String::new(),
        resolution: 0.05,
        occupancy,
        objects: Vec::new(),
        start: Some(Pose::new(0.3, 0.3, 0.0)),
        origin: Pose::new(0.0, 0.0, 0.0),
    }
}

fn setup(slip: SlipLevel, seed: u64) -> RunSetup {
    let robot = model("roomba600").unwrap().clone();
    let floor = Arc::new(ReachableFloor::new(&room(), &robot, None).unwrap());
    RunSetup { floor, world: Arc::default(), robot, conditions: Conditions { slip, ..Conditions::default() }, seed }
}

/// Full speed, new direction every now and then: what a wall has to stand.
#[derive(Clone)]
struct Reckless {
    rng: Rng,
    drive: Drive,
    countdown: u32,
}

impl Controller for Reckless {
    fn step(&mut self, _: &SensorReadings, _: f64) -> Drive {
        use rand::RngExt;
        if self.countdown == 0 {
            self.countdown = self.rng.random_range(20..200);
            self.drive = Drive::wheels(self.rng.random_range(-9.0..9.0), self.rng.random_range(-9.0..9.0));
        }
        self.countdown -= 1;
        self.drive
    }
    fn is_done(&self) -> bool {
        false
    }
    fn estimate(&self) -> Option<Pose> {
        None
    }
    fn boxed_clone(&self) -> Box<dyn Controller> {
        Box::new(self.clone())
    }
}

/// Distance from `at` to the nearest wall of `plan`, by looking at all of them.
fn room_around(plan: &FloorPlan, at: Point) -> f64 {
    let outside = at.x.min(at.y).min(plan.width_m() - at.x).min(plan.height_m() - at.y);
    let walls = plan.occupancy.iter().filter(|(_, o)| !o.is_free()).map(|(cell, _)| {
        let (x, y) = (f64::from(cell.x) * 0.05, f64::from(cell.y) * 0.05);
        math::hypot(at.x - at.x.clamp(x, x + 0.05), at.y - at.y.clamp(y, y + 0.05))
    });
    walls.fold(outside, f64::min)
}

#[test]
fn reckless_driver_never_enters_a_wall() {
    let plan = room();
    let setup = setup(SlipLevel::Harsh, 3);
    let driver = Reckless { rng: seeded(5, 9), drive: Drive::STOP, countdown: 0 };
    let mut run = Run::new(&setup, Box::new(driver));
    for step in 0..40_000 {
        run.step();
        if step % 7 == 0 {
            let room = room_around(&plan, run.pose().position());
            assert!(room > setup.robot.radius - 1e-6, "step {step}: {room} m at {}", run.pose());
        }
    }
    assert!(run.bumps() > 20, "only {} bumps: the test drove nowhere", run.bumps());
}

#[test]
fn bumper_tells_left_from_right() {
    // Drive along +x into the wall at x = 3 m, with the heading turned so that the wall is to one side.
    for (heading, expected) in [(0.0, (true, true)), (0.9, (false, true)), (-0.9, (true, false))] {
        let setup = setup(SlipLevel::None, 0);
        let mut floor = (*setup.floor).clone();
        floor.start = Pose::new(2.6, 0.9, heading);
        let line = vec![floor.start.position(), floor.start.to_world(Point::new(3.0, 0.0))];
        let setup = RunSetup { floor: Arc::new(floor), ..setup };
        let follower = FollowPath::new(&setup.robot, OdometryModel::Arc, setup.floor.start, line.into());
        let mut run = Run::new(&setup, Box::new(follower));
        while run.bumps() == 0 && run.steps() < 2000 {
            run.step();
        }
        assert_eq!((run.sensors().bump_left, run.sensors().bump_right), expected, "heading {heading}");
    }
}

#[test]
fn a_corner_that_stands_twice_is_driven_once() {
    let setup = setup(SlipLevel::None, 0);
    let mut floor = (*setup.floor).clone();
    floor.start = Pose::new(0.5, 0.5, 0.0);
    let [a, b, c] = [(0.5, 0.5), (1.2, 0.5), (1.2, 0.8)].map(|(x, y)| Point::new(x, y));
    let setup = RunSetup { floor: Arc::new(floor), ..setup };
    let drive = |line: &[Point]| {
        let follower = FollowPath::new(&setup.robot, OdometryModel::Arc, setup.floor.start, line.into());
        let mut run = Run::new(&setup, Box::new(follower));
        while !run.is_finished() && run.steps() < 4000 {
            run.step();
        }
        (run.is_finished(), run.digest())
    };
    let once = drive(&[a, b, c]);
    assert!(once.0);
    assert_eq!(drive(&[a, a, b, b, b, c, c]), once);
    let path = CoveragePath::in_metres(vec![a, a, b, b, b, c, c]);
    assert_eq!(path.line, [a, b, c]);
}

#[test]
fn a_speed_that_is_not_a_number_stops_the_robot() {
    #[derive(Clone)]
    struct Broken;
    impl Controller for Broken {
        fn step(&mut self, _: &SensorReadings, _: f64) -> Drive {
            Drive::wheels(f64::NAN, f64::INFINITY)
        }
        fn is_done(&self) -> bool {
            false
        }
        fn boxed_clone(&self) -> Box<dyn Controller> {
            Box::new(self.clone())
        }
    }
    let mut run = Run::new(&setup(SlipLevel::None, 0), Box::new(Broken));
    let before = run.pose();
    for _ in 0..20 {
        run.step();
    }
    assert_eq!(run.pose(), before);
}

/// A lawn-mower path below the block, to the left of the thin wall.
fn mowing(planning_grid: &PlanningGrid) -> CoveragePath {
    let mut cells = Vec::new();
    for y in 1..5 {
        let mut row: Vec<Cell> = (2..16).map(|x| Cell::new(x, y)).filter(|&c| planning_grid.free.is_set(c)).collect();
        if y % 2 == 0 {
            row.reverse();
        }
        cells.extend(row);
    }
    CoveragePath::walk(cells)
}

fn follow(setup: &RunSetup, planning_grid: &PlanningGrid, path: &CoveragePath) -> Run {
    let line = planning_grid.polyline(&setup.floor, &path.cells);
    let follower = FollowPath::new(&setup.robot, OdometryModel::Arc, setup.floor.start, line.into());
    let mut run = Run::new(setup, Box::new(follower));
    while !run.is_finished() {
        run.step();
        assert!(run.time_s() < 7200.0, "the run doesn't end");
    }
    run
}

#[test]
fn driving_a_plan_takes_as_long_and_covers_as_much_as_the_metrics_say() {
    let setup = setup(SlipLevel::None, 0);
    let planning_grid = PlanningGrid::new(&setup.floor, 0.15);
    let path = mowing(&planning_grid);
    let expected = DriveMetrics::of(&setup.floor, &setup.robot, &planning_grid.polyline(&setup.floor, &path.cells));
    let run = follow(&setup, &planning_grid, &path);
    let duration = run.time_s() / expected.duration_s;
    assert!((0.97..1.15).contains(&duration), "{} s driven, {} s expected", run.time_s(), expected.duration_s);
    assert!((run.distance_m() / expected.length_m - 1.0).abs() < 0.02);
    assert!((run.coverage() - expected.coverage).abs() < 0.01, "{} {}", run.coverage(), expected.coverage);
    assert_eq!(run.bumps(), 0);
    let drift = (run.estimate().unwrap().position() - run.pose().position()).norm();
    assert!(drift < 0.03, "odometry without slip drifted {drift} m");
}

#[test]
fn slip_makes_odometry_drift_and_the_run_still_ends() {
    let drift = |slip| {
        let setup = setup(slip, 11);
        let planning_grid = PlanningGrid::new(&setup.floor, 0.15);
        let run = follow(&setup, &planning_grid, &mowing(&planning_grid));
        (run.estimate().unwrap().position() - run.pose().position()).norm()
    };
    let (none, harsh) = (drift(SlipLevel::None), drift(SlipLevel::Harsh));
    assert!(harsh > 3.0 * none, "{none} m without slip, {harsh} m with harsh slip");
}

#[test]
fn same_seed_same_run_other_seed_other_run() {
    let run = |seed| {
        let setup = setup(SlipLevel::Typical, seed);
        let planning_grid = PlanningGrid::new(&setup.floor, 0.3);
        follow(&setup, &planning_grid, &mowing(&planning_grid)).digest()
    };
    assert_eq!(run(1), run(1));
    assert_ne!(run(1), run(2));
}

#[test]
fn clone_of_a_run_goes_on_the_same_way() {
    let setup = setup(SlipLevel::Typical, 4);
    let planning_grid = PlanningGrid::new(&setup.floor, 0.3);
    let line = planning_grid.polyline(&setup.floor, &mowing(&planning_grid).cells);
    let mut run =
        Run::new(&setup, Box::new(FollowPath::new(&setup.robot, OdometryModel::Arc, setup.floor.start, line.into())));
    for _ in 0..3000 {
        run.step();
    }
    let mut copy = run.clone();
    for _ in 0..3000 {
        run.step();
        copy.step();
    }
    assert_eq!(run.digest(), copy.digest());
}

/// Borenstein & Feng's square of 4 m, in a hall with nothing in it: how far the robot stops from where it began, m.
fn square_error(slip: SlipLevel, seed: u64) -> f64 {
    let robot = model("roomba600").unwrap().clone();
    let plan = FloorPlan {
        resolution: 0.5,
        occupancy: Grid::filled(20, 20, Occupancy::Free),
        start: Some(Pose::new(3.0, 3.0, 0.0)),
        ..room()
    };
    let floor = Arc::new(ReachableFloor::new(&plan, &robot, None).unwrap());
    let conditions = Conditions { slip, ..Conditions::default() };
    let setup = RunSetup { floor, world: Arc::default(), robot, conditions, seed };
    let mut line = vec![[3.0, 3.0], [7.0, 3.0], [7.0, 7.0], [3.0, 7.0], [3.0, 3.0]];
    if seed % 2 == 1 {
        line.reverse();
    }
    let line: Vec<Point> = line.into_iter().map(|[x, y]| Point::new(x, y)).collect();
    let follower = FollowPath::new(&setup.robot, OdometryModel::Arc, setup.floor.start, line.into());
    let mut run = Run::new(&setup, Box::new(follower));
    while !run.is_finished() {
        run.step();
        assert!(run.time_s() < 600.0, "the run doesn't end");
    }
    (run.pose().position() - Point::new(3.0, 3.0)).norm()
}

// slow: a mean of sixteen runs; fewer scatter beyond the limits
#[test]
fn slip_costs_on_the_square_of_four_metres_what_its_levels_say() {
    let mean = |slip| (0..16).map(|seed| square_error(slip, seed)).sum::<f64>() / 16.0;
    let (none, typical, harsh) = (mean(SlipLevel::None), mean(SlipLevel::Typical), mean(SlipLevel::Harsh));
    assert!(none < 0.02, "none {none}");
    assert!((0.1..0.3).contains(&typical), "typical {typical}");
    assert!((0.6..1.5).contains(&harsh), "harsh {harsh}");
}

#[test]
fn quantised_wheels_keep_to_their_speeds() {
    for (is_quantised, expected) in [(false, 0.3), (true, 0.011 + 11.0 * 0.0285)] {
        let mut setup = setup(SlipLevel::None, 0);
        setup.conditions.quantised = is_quantised;
        let line = vec![setup.floor.start.position(), Point::new(2.5, 0.3)];
        let follower = FollowPath::new(&setup.robot, OdometryModel::Arc, setup.floor.start, line.into());
        let mut run = Run::new(&setup, Box::new(follower));
        for _ in 0..200 {
            run.step();
        }
        let before = run.distance_m();
        run.step();
        let speed = (run.distance_m() - before) / STEP_S;
        assert!((speed - expected).abs() < 1e-6, "{speed}");
        while !run.is_finished() {
            run.step();
            assert!(run.time_s() < 100.0, "the run doesn't end");
        }
        let off = (run.pose().position() - Point::new(2.5, 0.3)).norm();
        assert!(off < 0.02, "{off} m off its goal");
    }
}

#[test]
fn omnidirectional_robot_follows_a_line_without_turning() {
    let robot = model("octagon").unwrap().clone();
    let floor = Arc::new(ReachableFloor::new(&room(), &robot, Some(Pose::new(0.4, 0.4, 0.3))).unwrap());
    let line: Vec<Point> = [[0.4, 0.4], [2.5, 0.5], [2.4, 2.4], [0.5, 1.5]].map(|[x, y]| Point::new(x, y)).to_vec();
    let setup = RunSetup { floor, world: Arc::default(), robot, conditions: Conditions::default(), seed: 0 };
    let follower = FollowPath::new(&setup.robot, OdometryModel::Arc, setup.floor.start, line.clone().into());
    let mut run = Run::new(&setup, Box::new(follower));
    let mut before = (Point::new(0.4, 0.4), Vector::zeros());
    let mut nearest = vec![f64::MAX; line.len()];
    while !run.is_finished() {
        run.step();
        let at = run.pose().position();
        let velocity = (at - before.0) / STEP_S;
        // Forward and sideways motion are limited one by one.
        let gain = (velocity - before.1).norm() / STEP_S;
        assert!(gain < 1.5 * setup.robot.acceleration, "{gain} m/s²");
        before = (at, velocity);
        nearest.iter_mut().zip(&line).for_each(|(n, corner)| *n = n.min((corner - at).norm()));
        assert!(run.time_s() < 100.0, "the run doesn't end");
    }
    assert!(nearest.iter().all(|&n| n < 0.01), "{nearest:?}");
    assert!(run.turning_rad() < 0.1 && run.bumps() == 0, "turned by {}", run.turning_rad());
    let drift = (run.estimate().unwrap().position() - run.pose().position()).norm();
    assert!(drift < 0.01, "odometry drifted {drift} m");
}
