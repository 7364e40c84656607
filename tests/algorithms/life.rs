//! What stands, lies and moves in a room: furniture, stairs, people, dirt.

use coverage_planners::{self, CoverageJob, PlanContext};
use robovac_core::{
    coverage::{PlanningGrid, ReachableFloor},
    floor_plan::{FloorPlan, Object, Who},
    geometry::{Point, Pose},
    grid::{Grid, Occupancy},
    registry::Params,
    robot::{Drive, OdometryModel, RobotModel, SensorReadings, model},
};
use robovac_sim::{
    Conditions, Input, Run, RunSetup, SlipLevel, What, World,
    controller::{Controller, FollowPath},
};
use std::sync::Arc;

fn points(corners: &[[f64; 2]]) -> Vec<Point> {
    corners.iter().map(|&[x, y]| Point::new(x, y)).collect()
}

/// An empty room of 5 m x 4 m with `objects`.
fn room(objects: Vec<Object>) -> FloorPlan {
    FloorPlan {
        name: "test".into(),
        note: String::new(),
        resolution: 0.05,
        occupancy: Grid::filled(100, 80, Occupancy::Free),
        objects,
        start: Some(Pose::new(0.4, 0.4, 0.0)),
        origin: Pose::new(0.0, 0.0, 0.0),
    }
}

fn setup(plan: &FloorPlan, robot: &RobotModel, start: Option<Pose>, seed: u64) -> RunSetup {
    RunSetup {
        floor: Arc::new(ReachableFloor::new(plan, robot, start).unwrap()),
        world: Arc::new(World::new(plan)),
        robot: robot.clone(),
        conditions: Conditions::default(),
        seed,
    }
}

/// Drives on and on the same way.
#[derive(Clone)]
pub struct Steady(pub Drive);

impl Controller for Steady {
    fn step(&mut self, _: &SensorReadings, _: f64) -> Drive {
        self.0
    }
    fn is_done(&self) -> bool {
        false
    }
    fn boxed_clone(&self) -> Box<dyn Controller> {
        Box::new(self.clone())
    }
}

fn drive(setup: &RunSetup, speed: f64) -> Run {
    Run::new(setup, Box::new(Steady(Drive::wheels(speed, speed))))
}

/// A sofa with a corner, a slanted cupboard, four thin legs of a table, and stairs.
fn furnished() -> FloorPlan {
    let mut objects = vec![
        Object::Furniture {
            outline: points(&[[3.0, 2.4], [4.6, 2.4], [4.6, 3.6], [4.0, 3.6], [4.0, 3.0], [3.0, 3.0]]),
        },
        Object::Furniture { outline: points(&[[0.6, 2.5], [1.4, 2.9], [1.2, 3.3], [0.4, 2.9]]) },
        Object::DropOff { outline: points(&[[4.0, 0.0], [5.0, 0.0], [5.0, 1.2], [4.0, 1.2]]) },
    ];
    for (x, y) in [(1.8, 1.0), (2.6, 1.0), (2.6, 1.7), (1.8, 1.7)] {
        objects.push(Object::Leg { at: Point::new(x, y), radius: 0.01 });
    }
    room(objects)
}

#[test]
fn planned_paths_get_round_furniture_legs_and_stairs() {
    let plan = furnished();
    for (id, robot) in [("boustrophedon", "roomba600"), ("contour", "roomba600"), ("boustrophedon", "octagon")] {
        let robot = model(robot).unwrap();
        let setup = setup(&plan, robot, None, 3);
        let planning_grid = PlanningGrid::new(&setup.floor, robot.default_cell);
        let job = CoverageJob::on_planning_grid(&planning_grid, &setup.floor, robot);
        let info = coverage_planners::find(id).unwrap();
        let path = info.build(&Params::defaults(info.params)).plan(&job, &mut PlanContext::new(1)).unwrap();
        let line = planning_grid.polyline(&setup.floor, &path.cells);
        for corner in &line {
            assert!(setup.floor.limits().has_room(*corner, robot.radius), "{id}: {corner}");
        }
        let follower = FollowPath::new(robot, OdometryModel::Arc, setup.floor.start, line.into());
        let mut run = Run::new(&setup, Box::new(follower));
        while !run.is_finished() {
            run.step();
            assert!(run.time_s() < 7200.0, "the run doesn't end");
        }
        let name = format!("{id} with {}", robot.id);
        assert!(run.coverage() > 0.9, "{name}: {}", run.coverage());
        assert!(run.bumps() <= 3, "{name}: {} bumps", run.bumps());
        assert_eq!(run.falls(), 0, "{name}");
    }
}

#[test]
fn floor_ends_at_furniture_and_stairs() {
    let plan = furnished();
    let floor = ReachableFloor::new(&plan, model("roomba600").unwrap(), None).unwrap();
    for (x, y, is_floor) in
        [(3.5, 2.7, false), (4.5, 0.6, false), (2.2, 1.3, true), (3.6, 3.4, true), (3.85, 0.5, true)]
    {
        assert_eq!(floor.floor.is_set(floor.cell_at(Point::new(x, y))), is_floor, "({x}, {y})");
    }
    // Between the legs of the table there is room, at the edge of the stairs there is none.
    assert!(floor.standing.is_set(floor.cell_at(Point::new(2.2, 1.35))));
    assert!(!floor.standing.is_set(floor.cell_at(Point::new(3.9, 0.5))));
    // Contact is with furniture only.
    assert!(floor.walls.has_room(Point::new(4.0, 0.6), 0.17) && !floor.limits().has_room(Point::new(4.0, 0.6), 0.17));
    let on_stairs = ReachableFloor::new(&plan, model("roomba600").unwrap(), Some(Pose::new(4.5, 0.5, 0.0)));
    assert!(on_stairs.unwrap_err().to_string().contains("obstacle"));
}

#[test]
fn reckless_driver_falls_and_stays_there_until_it_is_picked_up() {
    let plan = furnished();
    let setup = setup(&plan, model("roomba600").unwrap(), Some(Pose::new(3.4, 0.6, 0.0)), 1);
    let mut run = drive(&setup, 0.5);
    for _ in 0..400 {
        run.step();
    }
    assert!(run.has_fallen() && run.falls() == 1, "{}", run.pose());
    assert!((run.pose().x - 4.0).abs() < 0.02, "it falls when its wheels have lost the floor: {}", run.pose());
    assert!(run.events().iter().any(|event| event.what == What::Fell));
    assert!(run.sensors().wheel_drop_left && run.sensors().wheel_drop_right);
    run.apply(Input::Lift);
    run.step();
    run.apply(Input::PutDown(Pose::new(1.0, 1.0, 3.0)));
    run.step();
    assert!(!run.has_fallen() && !run.sensors().wheel_dropped());
    assert!((run.pose().position() - Point::new(1.0, 1.0)).norm() < 0.01);
}

#[test]
fn one_wheel_over_the_edge_drops_alone() {
    let plan = room(vec![Object::DropOff { outline: points(&[[0.0, 2.0], [5.0, 2.0], [5.0, 3.0], [0.0, 3.0]]) }]);
    let setup = setup(&plan, model("roomba600").unwrap(), None, 1);
    let mut floor = (*setup.floor).clone();
    // The left wheel is 117.5 mm to the left of the middle.
    floor.start = Pose::new(1.0, 1.9, 0.0);
    let mut run = drive(&RunSetup { floor: Arc::new(floor), ..setup }, 0.0);
    run.step();
    assert_eq!((run.sensors().wheel_drop_left, run.sensors().wheel_drop_right), (true, false));
    assert!(!run.has_fallen());
}

/// Deepest overlap of the robot with a mover, m.
fn overlap(run: &Run, radius: f64) -> f64 {
    let at = run.pose().position();
    run.life().movers().iter().map(|(mover, r)| r + radius - (at - mover).norm()).fold(f64::MIN, f64::max)
}

#[test]
fn people_and_pets_walk_wait_and_are_bumped_into() {
    let crossing = points(&[[2.0, 0.5], [2.0, 3.5], [3.0, 3.5]]);
    let pet = points(&[[3.0, 3.0], [1.2, 0.4]]);
    let plan =
        room(vec![Object::Mover { who: Who::Person, path: crossing }, Object::Mover { who: Who::Pet, path: pet }]);
    let robot = model("roomba600").unwrap();
    let setup = setup(&plan, robot, Some(Pose::new(0.5, 1.5, 0.0)), 8);
    // To and fro through their ways.
    let mut run = drive(&setup, 0.3);
    let mut seen = [(f64::MAX, f64::MIN); 2];
    for step in 0..40_000 {
        if step % 1000 == 999 {
            run.apply(Input::Lift);
            run.step();
            // Right where the person is, so that the place must be another.
            let (person, _) = run.life().movers()[0];
            run.apply(Input::PutDown(Pose::new(person.x, person.y, f64::from(step) * 0.01)));
        }
        run.step();
        if !run.is_lifted() {
            assert!(overlap(&run, robot.radius) < 0.001, "step {step}: {} m deep", overlap(&run, robot.radius));
        }
        for (seen, (at, _)) in seen.iter_mut().zip(run.life().movers()) {
            *seen = (seen.0.min(at.y), seen.1.max(at.y));
        }
    }
    assert!(run.bumps() > 20, "{} bumps", run.bumps());
    assert!(seen.iter().all(|(low, high)| high - low > 2.0), "they walk their whole line: {seen:?}");
    // A person stands in the way: the robot must not get past.
    let still = room(vec![Object::Mover { who: Who::Person, path: points(&[[2.0, 1.5]]) }]);
    let mut run = drive(&RunSetup { world: Arc::new(World::new(&still)), ..setup }, 0.3);
    for _ in 0..600 {
        run.step();
        assert!(overlap(&run, robot.radius) < 0.001);
    }
    assert!(run.pose().x < 2.0 - 0.3 && run.sensors().bumped(), "{}", run.pose());
}

#[test]
fn dirt_is_picked_up_under_the_tool_and_beside_it_by_the_side_brush() {
    let plan = room(vec![Object::Dirt { at: Point::new(1.5, 1.5), radius: 0.3 }]);
    let left_after = |side_brushes| {
        let robot = RobotModel { side_brushes, ..model("roomba600").unwrap().clone() };
        let setup = setup(&plan, &robot, Some(Pose::new(0.5, 1.5, 0.0)), 2);
        let mut run = drive(&setup, 0.3);
        assert!((run.dirt_left() - 1.0).abs() < 1e-12);
        let mut felt = 0;
        while run.pose().x < 2.5 {
            run.step();
            felt = felt.max(run.sensors().dirt);
        }
        assert!(felt > 100, "the dirt sensor read {felt} at most");
        run.dirt_left()
    };
    // A strip of 17 cm through the middle of a disc of 60 cm holds 36 % of it.
    let without = left_after(&[]);
    assert!((without - 0.64).abs() < 0.05, "{without}");
    let with = left_after(model("roomba600").unwrap().side_brushes);
    assert!(with < without - 0.1, "{with} with side brush, {without} without");
}

#[test]
fn carpet_slows_a_slipping_robot() {
    let driven = |objects| {
        let plan = room(objects);
        let setup = setup(&plan, model("roomba600").unwrap(), Some(Pose::new(0.4, 2.0, 0.0)), 2);
        let conditions = Conditions { slip: SlipLevel::Harsh, ..Conditions::default() };
        let mut run = drive(&RunSetup { conditions, ..setup }, 0.3);
        for _ in 0..800 {
            run.step();
        }
        run.distance_m()
    };
    let carpet = Object::Carpet { outline: points(&[[0.0, 0.0], [5.0, 0.0], [5.0, 4.0], [0.0, 4.0]]) };
    let (bare, soft) = (driven(Vec::new()), driven(vec![carpet]));
    assert!((0.85..0.95).contains(&(soft / bare)), "{soft} m on carpet, {bare} m without");
}

#[test]
fn seed_decides_over_everything_that_lives() {
    let mut plan = furnished();
    plan.objects.push(Object::Mover { who: Who::Pet, path: points(&[[0.5, 2.0], [3.5, 2.0]]) });
    plan.objects.push(Object::Dirt { at: Point::new(1.0, 1.0), radius: 0.3 });
    let digest = |seed| {
        let mut run = drive(&setup(&plan, model("roomba600").unwrap(), None, seed), 0.2);
        for _ in 0..2000 {
            run.step();
        }
        let copy = run.clone();
        assert_eq!(run.digest(), copy.digest());
        run.digest()
    };
    assert_eq!(digest(1), digest(1));
    assert_ne!(digest(1), digest(2));
}
