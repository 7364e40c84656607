//! The simulated robot: walls hold, odometry is right, plans get driven, runs repeat.

use robovac_playground::{
    controller::{Controller, FollowPath},
    coverage::{Lattice, ReachableFloor},
    floorplan::FloorPlan,
    geometry::{Point, Pose},
    grid::{Cell, Occupancy, from_picture},
    math,
    metrics::DriveMetrics,
    planner::CoveragePath,
    rng::{Rng, seeded},
    robot::{Drive, OdometryModel, Sensors, model},
    sim::{Conditions, Run, RunSetup, SlipLevel},
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
    fn step(&mut self, _: &Sensors, _: f64) -> Drive {
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

/// A lawn-mower path below the block, to the left of the thin wall.
fn mowing(lattice: &Lattice) -> CoveragePath {
    let mut cells = Vec::new();
    for y in 1..5 {
        let mut row: Vec<Cell> = (2..16).map(|x| Cell::new(x, y)).filter(|&c| lattice.free.is_set(c)).collect();
        if y % 2 == 0 {
            row.reverse();
        }
        cells.extend(row);
    }
    CoveragePath { cells }
}

fn follow(setup: &RunSetup, lattice: &Lattice, path: &CoveragePath) -> Run {
    let line = lattice.polyline(&setup.floor, &path.cells);
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
    let lattice = Lattice::new(&setup.floor, 0.15);
    let path = mowing(&lattice);
    let expected = DriveMetrics::of(&setup.floor, &setup.robot, &lattice.polyline(&setup.floor, &path.cells));
    let run = follow(&setup, &lattice, &path);
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
        let lattice = Lattice::new(&setup.floor, 0.15);
        let run = follow(&setup, &lattice, &mowing(&lattice));
        (run.estimate().unwrap().position() - run.pose().position()).norm()
    };
    let (none, harsh) = (drift(SlipLevel::None), drift(SlipLevel::Harsh));
    assert!(harsh > 3.0 * none, "{none} m without slip, {harsh} m with harsh slip");
}

#[test]
fn same_seed_same_run_other_seed_other_run() {
    let run = |seed| {
        let setup = setup(SlipLevel::Typical, seed);
        let lattice = Lattice::new(&setup.floor, 0.3);
        follow(&setup, &lattice, &mowing(&lattice)).digest()
    };
    assert_eq!(run(1), run(1));
    assert_ne!(run(1), run(2));
}

#[test]
fn clone_of_a_run_goes_on_the_same_way() {
    let setup = setup(SlipLevel::Typical, 4);
    let lattice = Lattice::new(&setup.floor, 0.3);
    let line = lattice.polyline(&setup.floor, &mowing(&lattice).cells);
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
