//! What simulated robots sense, by place, angle, robot and level of noise.

use robovac_playground::{
    coverage::ReachableFloor,
    floorplan::{FloorPlan, Sketch},
    geometry::{Point, Pose},
    math,
    robot::{Drive, MODELS, RobotModel, Sensors, model},
    sim::{Conditions, Life, Noise, NoiseLevel, SensorKind, SimRobot, World},
};
use std::sync::Arc;

/// A robot in a room of 4 m x 3 m with a wall from (2, 0) to (2.05, 1.5).
struct Scene {
    floor: Arc<ReachableFloor>,
    world: World,
    life: Life,
    robot: SimRobot,
    model: RobotModel,
}

fn plan() -> FloorPlan {
    Sketch::open(4.0, 3.0, 0.05).fill(&[[2.0, 0.0, 2.05, 1.5]]).start(0.5, 0.5, 0.0).finish("", "")
}

impl Scene {
    fn new(id: &str, world: World, conditions: Conditions) -> Self {
        let model = model(id).unwrap().clone();
        let floor = Arc::new(ReachableFloor::new(&plan(), &model, None).unwrap());
        let life = Life::new(&world, &floor, 1);
        let robot = SimRobot::new(&model, floor.start, conditions, 1);
        Self { floor, world, life, robot, model }
    }

    fn quiet(id: &str, world: World) -> Self {
        Self::new(id, world, Conditions::default())
    }

    fn step(&mut self, drive: Drive) -> &Sensors {
        self.robot.step(&self.floor.walls, &self.world, &mut self.life, drive);
        self.robot.sensors()
    }

    /// What it senses at rest at a place, heading in degrees.
    fn at(&mut self, x: f64, y: f64, degrees: f64) -> &Sensors {
        self.robot.put_down(Pose::new(x, y, degrees.to_radians()));
        self.step(Drive::STOP)
    }

    /// Drives straight on until something is touched or two seconds have passed.
    fn bump(&mut self, x: f64, y: f64, degrees: f64) -> (bool, bool) {
        self.at(x, y, degrees);
        let speed = self.model.cruise_speed;
        for _ in 0..134 {
            let sensed = self.step(Drive::wheels(speed, speed));
            if sensed.bumped() {
                return (sensed.bump_left, sensed.bump_right);
            }
        }
        (false, false)
    }
}

fn noisy(level: NoiseLevel) -> Conditions {
    Conditions { noise: Noise::all(level), ..Conditions::default() }
}

/// Stairs down in the upper right corner: everything beyond (3, 2).
fn stairs() -> World {
    let corners = [(3.0, 2.0), (4.0, 2.0), (4.0, 3.0), (3.0, 3.0)];
    World { drop_offs: vec![corners.map(|(x, y)| Point::new(x, y)).to_vec()], ..World::default() }
}

fn dock() -> World {
    World { docks: vec![Pose::new(0.0, 1.5, 0.0)], ..World::default() }
}

fn lighthouse() -> World {
    World { virtual_walls: vec![(Pose::new(0.0, 1.5, 0.0), 1.8)], ..World::default() }
}

// --- bumper ---

#[test]
fn bumps_tell_the_side_of_the_contact() {
    let mut roomba = Scene::quiet("roomba600", World::default());
    assert_eq!(roomba.bump(1.7, 1.0, 0.0), (true, true));
    // The wall ahead is turned away to the right, or to the left.
    assert_eq!(roomba.bump(1.7, 1.0, 45.0), (false, true));
    assert_eq!(roomba.bump(1.7, 1.0, -45.0), (true, false));
}

#[test]
fn dvr1_feels_120_degrees_only() {
    // 002, figure 5: the front bumper makes an angle of 120 degrees with the centre.
    let mut dvr1 = Scene::quiet("dvr1", World::default());
    assert_eq!(dvr1.bump(1.75, 1.0, 55.0), (false, true));
    assert_eq!(dvr1.bump(1.75, 1.0, -55.0), (true, false));
    assert_eq!(dvr1.bump(1.75, 0.5, 65.0), (false, false));
    assert_eq!(Scene::quiet("roomba600", World::default()).bump(1.75, 0.5, 65.0), (false, true));
}

#[test]
fn a_contact_behind_presses_nothing() {
    for id in ["roomba600", "dvr1", "cbot"] {
        let mut scene = Scene::quiet(id, World::default());
        scene.at(1.7, 1.0, 180.0);
        for _ in 0..134 {
            assert!(!scene.step(Drive::wheels(-0.2, -0.2)).bumped(), "{id}");
        }
    }
}

#[test]
fn a_stiff_bumper_is_late_but_not_deaf() {
    let delay = |level| {
        let mut steps = 0;
        for seed in 0..50 {
            let mut scene = Scene::new("roomba600", World::default(), noisy(level));
            scene.robot = SimRobot::new(&scene.model, scene.floor.start, noisy(level), seed);
            scene.at(1.8, 1.0, 0.0);
            while !scene.step(Drive::wheels(0.3, 0.3)).bumped() {
                steps += 1;
                assert!(steps < 3000, "never felt");
            }
        }
        steps
    };
    let [off, typical, harsh] = NoiseLevel::ALL.map(|(level, _)| delay(level));
    assert!(off <= typical && typical < harsh, "{off} {typical} {harsh}");
    assert!(harsh - off < 50 * 4);
}

// --- cliffs and wheel drops ---

#[test]
fn each_cliff_sensor_sees_the_edge_where_it_sits() {
    let mut roomba = Scene::quiet("roomba600", stairs());
    // Open Interface facts, section 6: front sensors (154, ±42) mm, side sensors (63, ±148) mm.
    for (x, expected) in [
        (2.5, [false; 4]),
        (3.0 - 0.155, [false; 4]),
        (3.0 - 0.153, [false, true, true, false]),
        (3.0 - 0.064, [false, true, true, false]),
        (3.0 - 0.062, [true; 4]),
    ] {
        assert_eq!(roomba.at(x, 2.5, 0.0).cliff, expected, "at {x}");
    }
    // Along the edge, which lies on the left.
    assert_eq!(roomba.at(3.4, 2.0 - 0.149, 0.0).cliff, [false; 4]);
    assert_eq!(roomba.at(3.4, 2.0 - 0.147, 0.0).cliff, [true, false, false, false]);
    assert_eq!(roomba.at(3.4, 2.0 - 0.041, 0.0).cliff, [true, true, false, false]);
    assert_eq!(roomba.at(3.4, 2.0 - 0.147, 180.0).cliff, [false, false, false, true]);
}

#[test]
fn dvr1_has_three_cliff_sensors() {
    // 002, figure 15 and Table II: left, front, right. The front one stands for both front ones of the interface.
    let mut dvr1 = Scene::quiet("dvr1", stairs());
    let places: Vec<_> = dvr1.model.sensors.cliffs.iter().flatten().copied().collect();
    let mut distinct = places.clone();
    distinct.dedup();
    assert_eq!((places.len(), distinct.len()), (4, 3));
    assert_eq!(dvr1.at(3.0 - 0.136, 2.5, 0.0).cliff, [false; 4]);
    assert_eq!(dvr1.at(3.0 - 0.134, 2.5, 0.0).cliff, [false, true, true, false]);
    assert_eq!(dvr1.at(3.4, 2.0 - 0.116, 0.0).cliff, [true, false, false, false]);
}

#[test]
fn floor_reads_as_measured_and_a_drop_off_as_nothing() {
    // Open Interface facts, section 6: floor cliff signal 2500-2680.
    let mut roomba = Scene::new("roomba600", stairs(), noisy(NoiseLevel::Typical));
    for _ in 0..1000 {
        for signal in roomba.at(1.0, 1.0, 0.0).cliff_signal {
            assert!((2500..=2680).contains(&signal), "{signal}");
        }
    }
    assert_eq!(roomba.at(3.4, 2.4, 0.0).cliff_signal, [0; 4]);
}

#[test]
fn dark_floor_reads_as_a_cliff_only_where_noise_is_harsh() {
    let false_alarms = |level| {
        let mut roomba = Scene::new("roomba600", World::default(), noisy(level));
        let places =
            (0..80).flat_map(|i| (0..50).map(move |j| (0.2 + 0.045 * f64::from(i), 0.2 + 0.05 * f64::from(j))));
        places.filter(|&(x, y)| roomba.at(x, y, 0.0).sees_cliff()).count()
    };
    assert_eq!(false_alarms(NoiseLevel::Off), 0);
    assert_eq!(false_alarms(NoiseLevel::Typical), 0);
    // One tile in 256 is dark, and four sensors look at one each.
    let harsh = false_alarms(NoiseLevel::Harsh);
    assert!((10..200).contains(&harsh), "{harsh}");
}

#[test]
fn a_lifted_robot_sees_no_floor_and_feels_its_wheels_drop() {
    for robot in MODELS {
        let mut scene = Scene::quiet(robot.id, World::default());
        assert!(!scene.at(1.0, 1.0, 0.0).wheel_dropped() && !scene.robot.sensors().sees_cliff());
        scene.robot.lift();
        let sensed = scene.step(Drive::wheels(0.1, 0.1));
        assert_eq!(sensed.wheel_dropped(), robot.sensors.wheel_drops, "{}", robot.id);
        assert_eq!(sensed.cliff, [true; 4], "{}", robot.id);
        assert!(!scene.at(1.0, 1.0, 0.0).wheel_dropped());
    }
}

// --- virtual walls and docks ---

#[test]
fn a_virtual_wall_is_seen_in_its_beam_and_around_its_lighthouse() {
    let mut roomba = Scene::quiet("roomba600", lighthouse());
    // The receiver is 153 mm ahead of the middle.
    for (x, y, degrees, expected) in [
        (1.0, 1.4, 90.0, true),
        (1.0, 1.0, 90.0, false),
        // 1.2 m from the lighthouse, the beam is 2 + 10.5 cm to either side.
        (1.2, 1.5 - 0.12 - 0.153, 90.0, true),
        (1.2, 1.5 - 0.13 - 0.153, 90.0, false),
        (1.2, 1.5 + 0.12 + 0.153, -90.0, true),
        // Beyond its end.
        (1.7, 1.5, 0.0, false),
        // In the halo.
        (0.18, 1.35, 0.0, true),
        (0.2, 0.9, 0.0, false),
    ] {
        let sensed = roomba.at(x, y, degrees);
        assert_eq!((sensed.virtual_wall, sensed.infrared.omni == 162), (expected, expected), "at {x} {y} {degrees}");
    }
    let mut dvr1 = Scene::quiet("dvr1", lighthouse());
    assert!(!dvr1.at(1.0, 1.5, 90.0).virtual_wall, "DVR-1 has no receiver");
}

#[test]
fn walls_stop_the_beams() {
    let fence = World { virtual_walls: vec![(Pose::new(1.0, 0.7, 0.0), 2.5)], ..World::default() };
    let mut roomba = Scene::quiet("roomba600", fence);
    assert!(roomba.at(1.7, 0.7, 180.0).virtual_wall);
    assert!(!roomba.at(2.5, 0.7, 180.0).virtual_wall);
    let dock = World { docks: vec![Pose::new(1.0, 0.7, 0.0)], ..World::default() };
    let mut roomba = Scene::quiet("roomba600", dock);
    assert_ne!(roomba.at(1.7, 0.7, 180.0).infrared.omni, 0);
    assert_eq!(roomba.at(2.5, 0.7, 180.0).infrared.omni, 0);
}

#[test]
fn a_robot_that_faces_the_dock_has_green_on_its_left() {
    let mut roomba = Scene::quiet("roomba600", dock());
    // Heading to the dock at the left wall: its left is below. 160 reserved, 1 force field, 4 green, 8 red.
    let mut omni = |x, y| roomba.at(x, y, 180.0).infrared.omni;
    assert_eq!(omni(1.5, 1.5), 172);
    assert_eq!(omni(1.5, 1.1), 164);
    assert_eq!(omni(1.5, 1.9), 168);
    assert_eq!(omni(0.6, 1.5), 173);
    assert_eq!(omni(0.6, 1.4), 165);
    assert_eq!(omni(0.6, 1.6), 169);
    // Beside the beams, but in the force field.
    assert_eq!(omni(0.4, 1.1), 161);
    assert_eq!(omni(3.0, 1.5), 0);
}

#[test]
fn front_receivers_tell_where_the_dock_is() {
    let mut roomba = Scene::quiet("roomba600", dock());
    let mut seen = |degrees| {
        let infrared = roomba.at(1.4, 1.5, degrees).infrared;
        (infrared.left != 0, infrared.right != 0)
    };
    assert_eq!(seen(180.0), (true, true));
    assert_eq!(seen(140.0), (true, false));
    assert_eq!(seen(-140.0), (false, true));
    assert_eq!(seen(0.0), (false, false));
}

#[test]
fn dazzled_receivers_miss_characters() {
    let seen = |level| {
        let mut roomba = Scene::new("roomba600", dock(), noisy(level));
        (0..1000).filter(|_| roomba.at(1.0, 1.5, 180.0).infrared.omni != 0).count()
    };
    let [off, typical, harsh] = NoiseLevel::ALL.map(|(level, _)| seen(level));
    assert_eq!(off, 1000);
    assert!((920..980).contains(&typical) && (600..740).contains(&harsh), "{typical} {harsh}");
}

// --- all ---

#[test]
fn the_level_of_one_sensor_changes_nothing_for_the_others() {
    let mut only_light = Noise::default();
    only_light.set(SensorKind::Light, NoiseLevel::Typical);
    let mut more = only_light;
    more.set(SensorKind::Cliff, NoiseLevel::Harsh);
    more.set(SensorKind::Battery, NoiseLevel::Harsh);
    let [mut a, mut b] =
        [only_light, more].map(|noise| Scene::new("roomba600", dock(), Conditions { noise, ..Conditions::default() }));
    for i in 0..200 {
        let y = 0.3 + 0.01 * f64::from(i);
        assert_eq!(a.at(1.75, y, 10.0).light_signal, b.at(1.75, y, 10.0).light_signal);
    }
}

#[test]
fn the_same_seed_gives_the_same_readings() {
    let readings = |seed| {
        let conditions = noisy(NoiseLevel::Harsh);
        let mut scene = Scene::new("roomba600", dock(), conditions);
        scene.robot = SimRobot::new(&scene.model, scene.floor.start, conditions, seed);
        (0..300)
            .map(|i| scene.step(Drive::wheels(0.3, 0.3 * math::cos(0.01 * f64::from(i)))).clone())
            .collect::<Vec<_>>()
    };
    assert_eq!(readings(5), readings(5));
    assert_ne!(readings(5), readings(6));
}
