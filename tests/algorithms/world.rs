//! Bodies against obstacles: nothing overlaps, nothing tunnels, whatever stands in the room and however it is driven.

use super::life::Steady;
use rand::RngExt;
use robovac_core::{
    coverage::ReachableFloor,
    floor_plan::{FloorPlan, Object},
    geometry::{Point, Pose, Vector},
    grid::{Cell, Grid, Occupancy},
    math,
    rng::{Rng, seeded},
    robot::{Body, Corners, Drive, RobotModel, SensorReadings, WheelLayout, model},
};
use robovac_sim::{Conditions, Run, RunSetup, SlipLevel, controller::Controller};
use std::sync::Arc;

/// Deepest overlap that is allowed, m.
const ALLOWED: f64 = 0.001;
/// Side of a room's cells, m.
const CELL: f64 = 0.1;

/// Rectangle of 0.4 m x 0.2 m that drives lengthwise.
const RECTANGLE: &[[f64; 2]] = &[[0.2, 0.1], [-0.2, 0.1], [-0.2, -0.1], [0.2, -0.1]];
/// The same with its wheels near its rear.
const REAR_DRIVEN: &[[f64; 2]] = &[[0.32, 0.1], [-0.08, 0.1], [-0.08, -0.1], [0.32, -0.1]];
const OCTAGON: &[[f64; 2]] = &[
    [0.18, 0.075],
    [0.075, 0.18],
    [-0.075, 0.18],
    [-0.18, 0.075],
    [-0.18, -0.075],
    [-0.075, -0.18],
    [0.075, -0.18],
    [0.18, -0.075],
];

/// Bodies that aren't convex: one with a notch ahead, and one with four thin points.
const FORK: &[[f64; 2]] =
    &[[-0.15, -0.2], [0.2, -0.2], [0.2, -0.1], [0.05, -0.1], [0.05, 0.1], [0.2, 0.1], [0.2, 0.2], [-0.15, 0.2]];
const STAR: &[[f64; 2]] =
    &[[0.25, 0.0], [0.06, 0.06], [0.0, 0.25], [-0.06, 0.06], [-0.25, 0.0], [-0.06, -0.06], [0.0, -0.25], [0.06, -0.06]];

/// A Roomba with another body.
fn robot(body: &Body, wheels: WheelLayout) -> RobotModel {
    let roomba = model("roomba600").unwrap();
    let radius = match body {
        Body::Round => roomba.radius,
        Body::Polygon(corners) => corners.iter().map(|c| math::hypot(c[0], c[1])).fold(0.0, f64::max),
    };
    RobotModel { body: *body, wheels, radius, ..roomba.clone() }
}

fn robots() -> Vec<RobotModel> {
    let mut robots = vec![
        robot(&Body::Round, WheelLayout::Differential),
        robot(&Body::Polygon(Corners::of(RECTANGLE)), WheelLayout::Differential),
        robot(&Body::Polygon(Corners::of(REAR_DRIVEN)), WheelLayout::Differential),
        robot(&Body::Polygon(Corners::of(OCTAGON)), WheelLayout::Omnidirectional),
    ];
    // A small round robot, a rectangle and a star that are much too fast.
    let fast = |robot: RobotModel| RobotModel { max_wheel_speed: 1.5, acceleration: 20.0, ..robot };
    robots.push(fast(RobotModel { radius: 0.05, ..robot(&Body::Round, WheelLayout::Differential) }));
    robots.push(fast(robot(&Body::Polygon(Corners::of(RECTANGLE)), WheelLayout::Differential)));
    robots.push(robot(&Body::Polygon(Corners::of(FORK)), WheelLayout::Differential));
    robots.push(fast(robot(&Body::Polygon(Corners::of(STAR)), WheelLayout::Omnidirectional)));
    robots
}

/// Full speed, new direction every now and then.
#[derive(Clone)]
struct Reckless {
    rng: Rng,
    drive: Drive,
    countdown: u32,
}

impl Reckless {
    fn new(seed: u64) -> Self {
        Self { rng: seeded(seed, 9), drive: Drive::STOP, countdown: 0 }
    }
}

impl Controller for Reckless {
    fn step(&mut self, _: &SensorReadings, _: f64) -> Drive {
        if self.countdown == 0 {
            self.countdown = self.rng.random_range(5..80);
            let mut speed = || self.rng.random_range(-4.0..4.0);
            self.drive = Drive { left: speed(), right: speed(), lateral: speed() };
        }
        self.countdown -= 1;
        self.drive
    }
    fn is_done(&self) -> bool {
        false
    }
    fn boxed_clone(&self) -> Box<dyn Controller> {
        Box::new(self.clone())
    }
}

fn plan(width: usize, height: usize, objects: Vec<Object>) -> FloorPlan {
    FloorPlan {
        name: "test".into(),
        note: String::new(),
        resolution: CELL,
        occupancy: Grid::filled(width, height, Occupancy::Free),
        objects,
        start: None,
        origin: Pose::new(0.0, 0.0, 0.0),
    }
}

/// Walls here and there, furniture that may have dents, thin and thick legs.
fn random_room(rng: &mut Rng) -> FloorPlan {
    let (width, height) = (rng.random_range(12..20), rng.random_range(10..16));
    let mut plan = plan(width, height, Vec::new());
    let walls = rng.random_range(0..10);
    for _ in 0..walls {
        let cell = Cell::new(rng.random_range(0..width as i32), rng.random_range(0..height as i32));
        plan.occupancy[cell] = Occupancy::Occupied;
    }
    let (width, height) = (plan.width_m(), plan.height_m());
    for _ in 0..rng.random_range(0..3) {
        let centre = Point::new(rng.random_range(0.0..width), rng.random_range(0.0..height));
        let corners = rng.random_range(3..8);
        let outline = (0..corners).map(|i| {
            let angle = math::TAU * f64::from(i) / f64::from(corners);
            centre + Vector::new(math::cos(angle), math::sin(angle)) * rng.random_range(0.05..0.4)
        });
        plan.objects.push(Object::Furniture { outline: outline.collect() });
    }
    for _ in 0..rng.random_range(0..5) {
        let at = Point::new(rng.random_range(0.0..width), rng.random_range(0.0..height));
        let radius = if rng.random_bool(0.5) { 0.0025 } else { rng.random_range(0.0025..0.08) };
        plan.objects.push(Object::Leg { at, radius });
    }
    plan
}

/// Distance from a point to the nearest point of a polygon's outline, and whether it lies inside.
fn to_outline(outline: &[Point], p: Point) -> (f64, bool) {
    let nearest = sides(outline).map(|(a, b)| {
        let t = ((p - a).dot(&(b - a)) / (b - a).norm_squared()).clamp(0.0, 1.0);
        (a + (b - a) * t - p).norm()
    });
    (nearest.fold(f64::MAX, f64::min), is_in(outline, p))
}

fn sides(outline: &[Point]) -> impl Iterator<Item = (Point, Point)> {
    outline.iter().enumerate().map(|(i, &a)| (a, outline[(i + 1) % outline.len()]))
}

/// Whether a ray to the right crosses the outline an odd number of times.
fn is_in(outline: &[Point], p: Point) -> bool {
    let is_crossed =
        |&(a, b): &(Point, Point)| (a.y > p.y) != (b.y > p.y) && ((b - a).perp(&(p - a)) > 0.0) == (b.y > a.y);
    sides(outline).filter(is_crossed).count() % 2 == 1
}

fn is_solid(plan: &FloorPlan, p: Point) -> bool {
    plan.occupancy.get(plan.cell_at(p)).is_none_or(|o| !o.is_free())
        || plan.objects.iter().any(|object| match object {
            Object::Furniture { outline } => is_in(outline, p),
            Object::Leg { at, radius } => (at - p).norm_squared() < radius * radius,
            _ => false,
        })
}

/// Whether all of the disc around a point is inside obstacles.
fn is_deep(plan: &FloorPlan, p: Point) -> bool {
    let around = (0..12).map(|i| {
        let angle = math::TAU * f64::from(i) / 12.0;
        p + Vector::new(math::cos(angle), math::sin(angle)) * (1.05 * ALLOWED)
    });
    is_solid(plan, p) && around.into_iter().all(|q| is_solid(plan, q))
}

/// Whether a body overlaps an obstacle by more than a millimetre: looked for the slow way, point by point.
fn overlaps(plan: &FloorPlan, robot: &RobotModel, pose: Pose) -> Option<String> {
    let outline: Vec<Point> = match robot.body {
        Body::Round => (0..64)
            .map(|i| {
                let angle = math::TAU * f64::from(i) / 64.0;
                pose.to_world(Point::new(robot.radius * math::cos(angle), robot.radius * math::sin(angle)))
            })
            .collect(),
        Body::Polygon(corners) => corners.iter().map(|&[x, y]| pose.to_world(Point::new(x, y))).collect(),
    };
    for (i, a) in outline.iter().enumerate() {
        let b = outline[(i + 1) % outline.len()];
        let samples = ((b - a).norm() / 0.01).ceil().max(1.0);
        for k in 0..samples as u32 {
            let p = a + (b - a) * (f64::from(k) / samples);
            if is_deep(plan, p) {
                return Some(format!("the edge of the body is in an obstacle at {p}"));
            }
        }
    }
    // How deep a point is in the body, m; negative outside.
    let depth = |p: Point| {
        if robot.body == Body::Round {
            return robot.radius - (p - pose.position()).norm();
        }
        let (distance, is_inside) = to_outline(&outline, p);
        if is_inside { distance } else { -distance }
    };
    for object in &plan.objects {
        let deepest = match object {
            Object::Furniture { outline } => outline.iter().map(|&p| depth(p)).fold(f64::MIN, f64::max),
            Object::Leg { at, radius } => depth(*at) + radius,
            _ => continue,
        };
        if deepest > ALLOWED {
            return Some(format!("{object:?} is {deepest} m in the body"));
        }
    }
    for (cell, _) in plan.occupancy.iter().filter(|(_, o)| !o.is_free()) {
        for (dx, dy) in [(0, 0), (1, 0), (1, 1), (0, 1)] {
            let corner = Point::new(f64::from(cell.x + dx) * CELL, f64::from(cell.y + dy) * CELL);
            // A corner between two walls side by side is no corner.
            if depth(corner) > ALLOWED {
                return Some(format!("the corner of a wall is {} m in the body at {corner}", depth(corner)));
            }
        }
    }
    None
}

/// Rooms `first` and every `stride`-th after it, each with all robots; returns how many were driven in.
fn drive_in_rooms(first: u64, stride: usize, rooms: u64) -> (usize, u32) {
    let robots = robots();
    let (mut driven, mut bumps) = (0, 0);
    for seed in (first..rooms).step_by(stride) {
        let mut rng = seeded(seed, 77);
        let plan = random_room(&mut rng);
        for (number, robot) in robots.iter().enumerate() {
            let start = Pose::new(
                rng.random_range(0.0..plan.width_m()),
                rng.random_range(0.0..plan.height_m()),
                rng.random_range(-3.0..3.0),
            );
            let Ok(floor) = ReachableFloor::new(&plan, robot, Some(start)) else { continue };
            let conditions = Conditions { slip: SlipLevel::Harsh, quantised: seed % 2 == 0, ..Conditions::default() };
            let setup =
                RunSetup { floor: Arc::new(floor), world: Arc::default(), robot: robot.clone(), conditions, seed };
            let mut run = Run::new(&setup, Box::new(Reckless::new(seed)));
            for step in 0..200 {
                run.step();
                if step % 10 == 0 || (run.sensors().bumped() && step % 3 == 0) {
                    let found = overlaps(&plan, robot, run.pose());
                    assert_eq!(found, None, "room {seed}, robot {number}, step {step} at {:?}", run.pose());
                }
            }
            driven += 1;
            bumps += run.bumps();
        }
    }
    (driven, bumps)
}

fn drive_everywhere(rooms: u64) {
    let threads: Vec<_> = (0..2).map(|first| std::thread::spawn(move || drive_in_rooms(first, 2, rooms))).collect();
    let (mut driven, mut bumps) = (0, 0);
    for thread in threads {
        let (d, b) = thread.join().expect("no overlap");
        driven += d;
        bumps += b;
    }
    assert!(driven as u64 >= 4 * rooms, "only {driven} runs");
    assert!(bumps as usize > driven, "only {bumps} bumps in {driven} runs: nothing was put to the test");
}

// slow: overlaps are rare; more rooms are the soak's
#[test]
fn no_body_ever_overlaps_an_obstacle() {
    drive_everywhere(300);
}

#[test]
#[ignore = "soak: ten thousand runs"]
fn no_body_ever_overlaps_an_obstacle_in_thousands_of_rooms() {
    drive_everywhere(2200);
}

/// Every kind of robot drives straight at a leg of 5 mm, at every speed, on every line: it must end up before the leg or
/// beside it, never with the leg behind it on a line that the leg blocks.
#[test]
fn thin_leg_stops_a_robot_at_full_speed() {
    let leg = Point::new(1.5, 0.75);
    let plan = plan(30, 15, vec![Object::Leg { at: leg, radius: 0.0025 }]);
    for robot in robots() {
        for line in [-0.03, 0.0, 0.01] {
            let robot = RobotModel { max_wheel_speed: robot.max_wheel_speed.max(0.5), ..robot.clone() };
            let start = Pose::new(0.6, leg.y + line, 0.0);
            let floor = Arc::new(ReachableFloor::new(&plan, &robot, Some(start)).unwrap());
            assert_eq!(floor.start, start);
            let setup = RunSetup {
                floor,
                world: Arc::default(),
                robot: robot.clone(),
                conditions: Conditions::default(),
                seed: 1,
            };
            let mut run = Run::new(&setup, Box::new(Steady(Drive::wheels(9.0, 9.0))));
            let mut touched = false;
            for step in 0..1000 {
                run.step();
                touched |= run.sensors().bumped();
                let what = overlaps(&plan, &robot, run.pose());
                assert_eq!(what, None, "step {step} at {}", run.pose());
                // A flat front stays on the leg; others slide round it, and then have moved aside.
                let is_past = run.pose().x > leg.x;
                let aside = (run.pose().y - leg.y).abs();
                let has_slid = aside > 0.95 * robot.radius;
                assert!(!is_past || has_slid, "tunnelled: {}", run.pose());
            }
            assert!(touched);
        }
    }
}

#[test]
fn rectangle_in_a_corridor_can_drive_but_not_turn() {
    // 0.3 m wide, between two walls; the diagonal of the body is 0.45 m.
    let mut plan = plan(30, 5, Vec::new());
    for x in 8..22 {
        plan.occupancy[Cell::new(x, 0)] = Occupancy::Occupied;
        plan.occupancy[Cell::new(x, 4)] = Occupancy::Occupied;
    }
    let robot = robot(&Body::Polygon(Corners::of(RECTANGLE)), WheelLayout::Differential);
    let floor = Arc::new(ReachableFloor::new(&plan, &robot, Some(Pose::new(0.4, 0.25, 0.0))).unwrap());
    let setup =
        RunSetup { floor, world: Arc::default(), robot: robot.clone(), conditions: Conditions::default(), seed: 1 };
    let mut run = Run::new(&setup, Box::new(Steady(Drive::wheels(0.3, 0.3))));
    for _ in 0..250 {
        run.step();
    }
    assert!((1.2..2.0).contains(&run.pose().x) && run.bumps() == 0, "{}", run.pose());
    let mut floor = (*setup.floor).clone();
    floor.start = run.pose();
    let setup = RunSetup { floor: Arc::new(floor), ..setup };
    let mut run = Run::new(&setup, Box::new(Steady(Drive::wheels(-0.2, 0.2))));
    for step in 0..400 {
        run.step();
        assert_eq!(overlaps(&plan, &robot, run.pose()), None, "step {step} at {}", run.pose());
    }
    let turned = run.pose().heading.abs();
    assert!((0.1..0.8).contains(&turned), "turned by {turned}");
    assert!(run.sensors().bump_left || run.sensors().bump_right);
}
