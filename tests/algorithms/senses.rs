//! What simulated robots sense, by place, angle, robot and level of noise.

use proptest::prelude::*;
use robovac_core::{
    coverage::ReachableFloor,
    floor_plan::{FloorPlan, Object, Sketch},
    geometry::{Point, Pose},
    math,
    robot::{Drive, Infrared, MODELS, RobotModel, RobotPort, SensorReadings, model},
};
use robovac_sim::{Conditions, Life, Noise, NoiseLevel, SensorKind, SimRobot, World};
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

    fn step(&mut self, drive: Drive) -> &SensorReadings {
        self.robot.drive(drive);
        self.robot.step(&self.floor.walls, &self.world, &mut self.life);
        self.robot.sensors()
    }

    /// The reading at rest at a place, heading in degrees.
    fn at(&mut self, x: f64, y: f64, degrees: f64) -> &SensorReadings {
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

/// 002, section III.A: "The front bumper is 2cm above from the ground which means the robot can identify obstacle higher
/// than 2cm".
#[test]
fn obstacles_lower_than_2_cm_pass_under_dvr1s_bumper() {
    let felt = |id: &str, height: f64| {
        let corners = [(1.5, 1.0), (1.6, 1.0), (1.6, 2.0), (1.5, 2.0)].map(|(x, y)| Point::new(x, y));
        let plan = FloorPlan { objects: vec![Object::LowObstacle { outline: corners.to_vec(), height }], ..plan() };
        let mut scene = Scene::quiet(id, World::new(&plan));
        scene.floor = Arc::new(ReachableFloor::new(&plan, &scene.model, None).unwrap());
        scene.bump(1.25, 1.8, 0.0) != (false, false)
    };
    assert_eq!([0.001, 0.015, 0.0199].map(|height| felt("dvr1", height)), [false; 3]);
    assert_eq!([0.02, 0.0201, 0.1].map(|height| felt("dvr1", height)), [true; 3]);
    assert!(felt("roomba600", 0.015), "no source gives the height of its bumper");
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

// --- light bumper and wall sensor ---

#[test]
fn light_falls_with_distance_as_on_a_create_3() {
    // Means of seven sensors at a white baseboard, of a Create 3 (see `light.rs`), at distances from the bumper.
    let mut roomba = Scene::quiet("roomba600", World::default());
    let centre_left = 0.21_f64.to_degrees();
    let mut last = 4095;
    for (gap, measured) in [(0.015, 3545.0), (0.025, 2961.0), (0.05, 1291.0), (0.11, 359.0)] {
        // The beam at 12 degrees left of ahead looks straight at the wall at 2 m.
        let signal = roomba.at(2.0 - 0.174_25 - gap, 1.0, -centre_left).light_signal[2];
        assert!((f64::from(signal) / measured - 1.0).abs() < 0.17, "{gap} m: {signal}, measured {measured}");
        assert!(signal < last);
        last = signal;
    }
    assert_eq!(roomba.at(1.0, 1.0, 0.0).light_signal, [12; 6]);
}

#[test]
fn slanted_surfaces_send_less_light_back() {
    let mut roomba = Scene::quiet("roomba600", World::default());
    let mut signal = |degrees: f64, gap: f64| {
        // The start of the centre left beam is so far before the wall, along the beam.
        let beam = degrees.to_radians();
        let x = 2.0 - (0.174_25 + gap) * math::cos(beam);
        f64::from(roomba.at(x, 1.0, degrees - 0.21_f64.to_degrees()).light_signal[2]) - 12.0
    };
    let (straight, slanted) = (signal(0.0, 0.11), signal(45.0, 0.11));
    assert!((slanted / straight - 0.707).abs() < 0.02, "{slanted} of {straight}");
}

#[test]
fn light_bumper_tells_the_side() {
    let mut roomba = Scene::quiet("roomba600", World::default());
    // A wall on the right, 3 cm beside the body.
    let sensed = roomba.at(2.0 - 0.205, 1.0, 90.0).clone();
    assert_eq!(sensed.light_bumper, [false, false, false, false, false, true]);
    assert_eq!((sensed.wall, sensed.wall_signal), (true, sensed.light_signal[5] / 4));
    let sensed = roomba.at(2.0 - 0.205, 1.0, -90.0);
    assert!(sensed.light_bumper == [true, false, false, false, false, false] && !sensed.wall);
    let mut dvr1 = Scene::quiet("dvr1", World::default());
    assert_eq!(dvr1.at(2.0 - 0.15, 1.0, 0.0).light_signal, [0; 6]);
}

#[test]
fn idle_light_sensors_read_as_reported() {
    // Open Interface facts, section 6: idle light signals 2-32.
    let mut roomba = Scene::new("roomba600", World::default(), noisy(NoiseLevel::Typical));
    let mut seen = [u16::MAX, 0];
    for _ in 0..500 {
        for signal in roomba.at(1.0, 1.0, 0.0).light_signal {
            seen = [seen[0].min(signal), seen[1].max(signal)];
        }
    }
    assert_eq!(seen, [2, 32]);
}

#[test]
fn noise_of_light_grows_with_its_level() {
    let deviation = |level| {
        let mut roomba = Scene::new("roomba600", World::default(), noisy(level));
        let signals: Vec<f64> = (0..2000).map(|_| f64::from(roomba.at(1.77, 1.0, 0.0).light_signal[2])).collect();
        let mean = signals.iter().sum::<f64>() / 2000.0;
        (signals.iter().map(|s| (s - mean) * (s - mean)).sum::<f64>() / 2000.0).sqrt() / mean
    };
    let [off, typical, harsh] = NoiseLevel::ALL.map(|(level, _)| deviation(level));
    assert_eq!(off, 0.0);
    assert!((0.02..0.045).contains(&typical) && (0.1..0.2).contains(&harsh), "{typical} {harsh}");
}

// --- laser ---

#[test]
fn laser_measures_the_room() {
    let mut cbot = Scene::quiet("cbot", World::default());
    let laser = cbot.model.sensors.laser.unwrap();
    let scan = cbot.at(1.0, 1.0, 0.0).laser.clone().unwrap();
    assert_eq!(scan.len(), laser.beams);
    for (beam, &distance) in scan.iter().enumerate() {
        let angle = laser.first + laser.step * beam as f64;
        let (x, y) = (math::cos(angle), math::sin(angle));
        // Where the beam leaves the room, or meets the wall that ends at (2, 1.5).
        let from = (1.15, 1.0);
        let side = |from: f64, d: f64, end: f64| if d > 0.0 { (end - from) / d } else { -from / d };
        let mut expected = side(from.0, x, 4.0).min(side(from.1, y, 3.0));
        let to_wall = (2.0 - from.0) / x;
        if x > 0.0 && from.1 + y * to_wall < 1.5 {
            expected = expected.min(to_wall);
        }
        assert!((f64::from(distance) - expected).abs() < 1e-4, "beam {beam}: {distance} for {expected}");
    }
}

#[test]
fn laser_scans_ten_times_a_second() {
    let mut cbot = Scene::quiet("cbot", World::default());
    let mut scans = 0;
    let mut last = None;
    for _ in 0..200 {
        let scan = cbot.step(Drive::wheels(0.1, 0.1)).laser.clone().unwrap();
        scans += u32::from(!last.as_ref().is_some_and(|last| Arc::ptr_eq(last, &scan)));
        last = Some(scan);
    }
    assert_eq!(scans, 30, "in 3 s");
}

#[test]
fn laser_errs_as_its_data_sheet_says() {
    let exact = Scene::quiet("cbot", World::default()).at(0.5, 2.4, 0.0).laser.clone().unwrap();
    let errors = |level| {
        let mut cbot = Scene::new("cbot", World::default(), noisy(level));
        let (mut near, mut far, mut lost) = (Vec::new(), Vec::new(), 0);
        for _ in 0..700 {
            let scan = cbot.at(0.5, 2.4, 0.0).laser.clone().unwrap();
            for (&measured, &distance) in scan.iter().zip(exact.iter()) {
                let error = f64::from(measured - distance);
                match distance {
                    _ if measured.is_infinite() => lost += 1,
                    1.0.. => far.push(error / f64::from(distance)),
                    _ => near.push(error),
                }
            }
        }
        let deviation = |errors: Vec<f64>| (errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64).sqrt();
        (deviation(near), deviation(far), lost)
    };
    let [off, typical, harsh] = NoiseLevel::ALL.map(|(level, _)| errors(level));
    assert_eq!(off, (0.0, 0.0, 0));
    // 10 mm up to 1 m and 1 % beyond; 30 mm and 3 %.
    let is_near = |value: f64, expected: f64| (value / expected - 1.0).abs() < 0.05;
    assert!(is_near(typical.0, 0.01) && is_near(typical.1, 0.01) && typical.2 == 0, "{typical:?}");
    assert!(is_near(harsh.0, 0.03) && is_near(harsh.1, 0.03), "{harsh:?}");
    let share = f64::from(harsh.2) / (700.0 * exact.len() as f64);
    assert!((share - 0.02).abs() < 0.005, "{share} of the beams are lost");
}

// --- battery, dock and motors ---

#[test]
fn an_hour_of_driving_empties_the_dvr1() {
    // 002, section IV.E: 6 V, 4.5 Ah, "about an hour". Driving on the spot costs as much, and needs no hall.
    let mut dvr1 = Scene::quiet("dvr1", World::default());
    let speed = dvr1.model.max_wheel_speed;
    dvr1.at(1.0, 1.0, 0.0);
    let mut steps = 0;
    while !dvr1.robot.is_empty() {
        dvr1.step(Drive::wheels(speed, -speed));
        steps += 1;
        assert!(steps < 300_000, "never empty");
    }
    let minutes = f64::from(steps) * 0.015 / 60.0;
    assert!((minutes - 60.0).abs() < 1.0, "{minutes} min");
    // An empty robot stands.
    for _ in 0..100 {
        dvr1.step(Drive::wheels(speed, speed));
    }
    assert!(dvr1.robot.speed().is_stop());
    assert_eq!(dvr1.robot.sensors().battery.capacity_mah, 0, "it has no gauge");
}

#[test]
fn five_to_six_hours_on_the_dock_charge_the_dvr1() {
    // 002, section IV.E: "Charging time for the battery is about 5-6 hours". It has no gauge, so the charge of 6 minutes is
    // driven off again: an hour of driving takes a full battery.
    let conditions = Conditions { start_charge_percent: 0, ..Conditions::default() };
    let mut dvr1 = Scene::new("dvr1", dock(), conditions);
    let on_dock = 0.0203 + dvr1.model.radius;
    assert!(dvr1.at(on_dock, 1.5, 180.0).battery.on_dock);
    let charging = 6.0 * 60.0 / 0.015;
    for _ in 0..charging as u32 {
        dvr1.step(Drive::STOP);
    }
    let speed = dvr1.model.max_wheel_speed;
    dvr1.at(1.0, 1.0, 0.0);
    let mut driving = 0.0;
    while !dvr1.robot.is_empty() {
        dvr1.step(Drive::wheels(speed, -speed));
        driving += 1.0;
    }
    let hours = charging / driving;
    assert!((5.0..6.0).contains(&hours), "{hours} h for an hour of driving");
}

#[test]
fn roomba_reports_what_its_owners_read() {
    // Open Interface facts, section 6: capacity 2696 mAh; 13.9 V at 14 %, 16.0 V at 91 %.
    for (percent, millivolts) in [(14, 13_900), (91, 16_000)] {
        let conditions = Conditions { start_charge_percent: percent, ..Conditions::default() };
        let battery = Scene::new("roomba600", World::default(), conditions).at(1.0, 1.0, 0.0).battery;
        assert_eq!(battery.capacity_mah, 2696);
        assert!(battery.voltage_mv.abs_diff(millivolts) <= 2, "{} mV", battery.voltage_mv);
        assert!((battery.share() - f64::from(percent) / 100.0).abs() < 1e-3);
    }
}

#[test]
fn current_is_power_over_voltage() {
    let mut roomba = Scene::quiet("roomba600", World::default());
    roomba.at(0.5, 2.0, 0.0);
    for _ in 0..100 {
        roomba.step(Drive::wheels(0.3, 0.3));
    }
    let battery = roomba.robot.sensors().battery;
    let watts = -f64::from(battery.current_ma) * f64::from(battery.voltage_mv) * 1e-6;
    assert!((watts - 26.0).abs() < 0.1, "{watts} W");
}

/// A Roomba that faces the dock at the left wall, as near as the dock's back lets it.
fn docked(y: f64, degrees: f64) -> SensorReadings {
    let conditions = Conditions { start_charge_percent: 50, ..Conditions::default() };
    Scene::new("roomba600", dock(), conditions).at(0.205, y, degrees).clone()
}

#[test]
fn a_docked_robot_is_charged_and_sees_no_floor() {
    let sensed = docked(1.5, 180.0);
    assert!(sensed.battery.on_dock);
    // Open Interface facts, section 6: +1232 mA at 14.4 V nominal; all four cliff sensors read 0 and report a cliff.
    let expected = 1232.0 * 14.4 / (1e-3 * f64::from(sensed.battery.voltage_mv));
    assert!((f64::from(sensed.battery.current_ma) - expected).abs() < 2.0, "{} mA", sensed.battery.current_ma);
    assert_eq!((sensed.cliff, sensed.cliff_signal), ([true; 4], [0; 4]));
    for (y, degrees) in [(1.54, 180.0), (1.46, 180.0), (1.5, 165.0), (1.5, 0.0)] {
        let sensed = docked(y, degrees);
        assert!(!sensed.battery.on_dock && !sensed.sees_cliff() && sensed.battery.current_ma < 0, "{y} {degrees}");
    }
}

#[test]
fn an_hour_on_the_dock_gives_what_the_charger_gives() {
    let conditions = Conditions { start_charge_percent: 10, ..Conditions::default() };
    let mut roomba = Scene::new("roomba600", dock(), conditions);
    let before = roomba.at(0.205, 1.5, 180.0).battery.charge_mah;
    for _ in 0..240_000 {
        roomba.step(Drive::STOP);
    }
    let after = roomba.robot.sensors().battery.charge_mah;
    assert!((after - before).abs_diff(1232) <= 2, "{before} to {after}");
}

#[test]
fn wheels_that_push_in_vain_draw_too_much() {
    let mut roomba = Scene::quiet("roomba600", World::default());
    roomba.at(1.8, 1.0, 0.0);
    let mut push = |steps: u32, drive: Drive| {
        (0..steps).for_each(|_| drop(roomba.step(drive).clone()));
        let sensed = roomba.robot.sensors();
        (sensed.overcurrent.left_wheel, sensed.overcurrent.right_wheel, sensed.stasis)
    };
    assert_eq!(push(15, Drive::wheels(0.3, 0.3)), (false, false, true));
    assert_eq!(push(40, Drive::wheels(0.3, 0.3)), (true, true, false));
    // Backing off and turning on the spot are no progress, but nothing is stuck.
    assert_eq!(push(50, Drive::wheels(-0.3, -0.3)), (false, false, false));
    assert_eq!(push(50, Drive::wheels(-0.2, 0.2)), (false, false, false));
    assert_eq!(push(50, Drive::wheels(-0.2, -0.2)), (false, false, false));
    assert_eq!(push(50, Drive::wheels(0.1, 0.1)), (false, false, true));
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

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Whatever the place, readings lie in the ranges of the Open Interface, and what a robot lacks stays silent.
    #[test]
    fn readings_stay_in_range(
        x in 0.25_f64..3.75, y in 0.25_f64..2.75, degrees in -180.0_f64..180.0,
        robot in 0..MODELS.len(), level in 0_usize..3, charge in 0_u8..=100,
    ) {
        let world = World { drop_offs: stairs().drop_offs, virtual_walls: lighthouse().virtual_walls, ..dock() };
        let conditions = Conditions { start_charge_percent: charge, ..noisy(NoiseLevel::ALL[level].0) };
        let mut scene = Scene::new(MODELS[robot].id, world, conditions);
        let suite = scene.model.sensors;
        for _ in 0..20 {
            scene.at(x, y, degrees);
            let sensed = scene.step(Drive::wheels(0.2, 0.1)).clone();
            prop_assert!(sensed.cliff_signal.iter().all(|&s| s <= 4095));
            prop_assert!(sensed.light_signal.iter().all(|&s| s <= 4095) && sensed.wall_signal <= 1023);
            prop_assert!([0, 162, 161, 164, 165, 168, 169, 172, 173].contains(&sensed.infrared.omni));
            for character in [sensed.infrared.left, sensed.infrared.right] {
                prop_assert!([0, 161, 164, 165, 168, 169, 172, 173].contains(&character));
            }
            prop_assert!(sensed.battery.charge_mah <= sensed.battery.capacity_mah);
            prop_assert!(suite.light_bumper.is_some() || sensed.light_signal == [0; 6]);
            prop_assert!(suite.infrared || (sensed.infrared == Infrared::default() && !sensed.virtual_wall));
            prop_assert!(suite.wheel_drops || !sensed.wheel_dropped());
            prop_assert_eq!(suite.laser.is_some(), sensed.laser.is_some());
            prop_assert_eq!(scene.model.battery.has_gauge, sensed.battery.capacity_mah > 0);
        }
    }
}
