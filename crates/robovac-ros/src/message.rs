//! Messages of ROS 2: one function for each kind. Times are seconds since the start of a run, poses those of REP 103.

use super::{
    cdr::Cdr,
    frames::{BASE, LASER, MAP},
};
use robovac_core::{
    floor_plan::FloorPlan,
    geometry::{Pose, difference},
    grid::Occupancy,
    math,
    robot::{Drive, Laser, SensorReadings},
};

/// Longest motion between two poses, m: beyond it, the pose was set.
const JUMP_M: f64 = 0.1;
/// Power supply states of `sensor_msgs/BatteryState`.
const UNKNOWN: u8 = 0;
const CHARGING: u8 = 1;
const DISCHARGING: u8 = 2;
const NOT_CHARGING: u8 = 3;

/// Speed ahead and to the left, m/s, and turn rate, rad/s.
pub type Velocity = [f64; 3];

/// What a battery does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BatteryActivity {
    /// It isn't known.
    Unknown,
    /// It charges.
    Charging,
    /// It discharges.
    Discharging,
    /// It could charge, and doesn't.
    NotCharging,
}

/// Readings of a battery.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BatteryState {
    /// Voltage, V.
    pub voltage_v: f32,
    /// Current, A, negative while it discharges.
    pub current_a: f32,
    /// Temperature, °C.
    pub temperature_c: f32,
    /// Charge, Ah.
    pub charge_ah: f32,
    /// Capacity, Ah; 0 if it isn't known.
    pub capacity_ah: f32,
    /// What it does.
    pub supply: BatteryActivity,
}

/// Bumper and light bumper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BumperState {
    /// Pressed on the left, on the right.
    pub pressed: [bool; 2],
    /// Detections of the light bumper, from left to right.
    pub light: [bool; 6],
    /// Strengths of its signals, 0 to 4095.
    pub signal: [u16; 6],
}

impl BumperState {
    /// The bumper in a reading.
    pub fn of(sensed: &SensorReadings) -> Self {
        let pressed = [sensed.bump_left, sensed.bump_right];
        Self { pressed, light: sensed.light_bumper, signal: sensed.light_signal }
    }
}

impl BatteryState {
    /// The battery in a reading; `None` for a robot that can't read its battery.
    pub fn of(sensed: &SensorReadings) -> Option<Self> {
        let battery = sensed.battery;
        let thousandth = |value: f32| value / 1000.0;
        (battery.capacity_mah > 0).then(|| Self {
            voltage_v: thousandth(battery.voltage_mv.into()),
            current_a: thousandth(battery.current_ma.into()),
            temperature_c: battery.temperature_c.into(),
            charge_ah: thousandth(battery.charge_mah.into()),
            capacity_ah: thousandth(battery.capacity_mah.into()),
            supply: match battery.on_dock {
                true if battery.current_ma > 0 => BatteryActivity::Charging,
                true => BatteryActivity::NotCharging,
                false => BatteryActivity::Discharging,
            },
        })
    }
}

/// Velocity of a robot that moved between two poses, `dt_s` seconds apart; 0 if its pose was set meanwhile.
pub fn velocity(before: Pose, now: Pose, dt_s: f64) -> Velocity {
    let moved = now.position() - before.position();
    if dt_s <= 0.0 || moved.norm() > JUMP_M {
        return [0.0; 3];
    }
    let ahead = now.direction();
    let left = -ahead.y * moved.x + ahead.x * moved.y;
    [moved.dot(&ahead) / dt_s, left / dt_s, difference(before.heading, now.heading) / dt_s]
}

/// Speed and turn rate of wheel speeds, as a velocity.
pub fn velocity_of(drive: Drive, wheel_base: f64) -> Velocity {
    [0.5 * (drive.left + drive.right), drive.lateral, (drive.right - drive.left) / wheel_base]
}

/// `nav_msgs/Odometry`: pose of the robot in `frame`, and its velocity. The covariances are 0: they aren't known.
pub fn odometry(time_s: f64, frame: &str, pose: Pose, velocity: Velocity) -> Cdr {
    let mut cdr = Cdr::new();
    cdr.header(time_s, frame);
    cdr.string(BASE);
    put_pose(&mut cdr, pose);
    cdr.doubles(&[0.0; 36]);
    put_velocity(&mut cdr, velocity);
    cdr.doubles(&[0.0; 36]);
    cdr
}

/// `geometry_msgs/Twist`: commanded velocity.
pub fn twist(velocity: Velocity) -> Cdr {
    let mut cdr = Cdr::new();
    put_velocity(&mut cdr, velocity);
    cdr
}

/// `tf2_msgs/TFMessage`: the poses of frames in others, as (frame, frame in it, pose).
pub fn transforms(time_s: f64, all: &[(&str, &str, Pose)]) -> Cdr {
    let mut cdr = Cdr::new();
    cdr.word(all.len() as u32);
    for &(frame, child, pose) in all {
        cdr.header(time_s, frame);
        cdr.string(child);
        // A translation has the form of a point.
        put_pose(&mut cdr, pose);
    }
    cdr
}

/// `nav_msgs/OccupancyGrid` of a room whose map lies at `origin` in the frame of the map: -1 unknown, 0 free, 100
/// occupied. Objects aren't in it: see [`robovac_core::coverage::with_objects`].
pub fn occupancy_grid(time_s: f64, plan: &FloorPlan, origin: Pose) -> Cdr {
    let cells = &plan.occupancy;
    let mut cdr = Cdr::new();
    cdr.header(time_s, MAP);
    cdr.time(time_s);
    cdr.single(plan.resolution as f32);
    cdr.word(cells.width() as u32);
    cdr.word(cells.height() as u32);
    put_pose(&mut cdr, origin);
    cdr.word(cells.len() as u32);
    for cell in cells.values() {
        cdr.byte(match cell {
            // -1, signed.
            Occupancy::Unknown => 0xFF,
            Occupancy::Free => 0,
            Occupancy::Occupied => 100,
        });
    }
    cdr
}

/// `nav_msgs/Path` in the frame of the map: poses with the times at which the robot should be there, s.
pub fn path(time_s: f64, poses: &[(f64, Pose)]) -> Cdr {
    let mut cdr = Cdr::new();
    cdr.header(time_s, MAP);
    cdr.word(poses.len() as u32);
    for &(at_s, pose) in poses {
        cdr.header(at_s, MAP);
        put_pose(&mut cdr, pose);
    }
    cdr
}

/// `sensor_msgs/LaserScan`; beyond the range, distances are infinite (REP 117).
pub fn laser_scan(time_s: f64, laser: &Laser, ranges: &[f32]) -> Cdr {
    let turn_s = 1.0 / laser.rate_hz;
    let last = laser.first + laser.step * laser.beams.saturating_sub(1) as f64;
    let mut cdr = Cdr::new();
    cdr.header(time_s, LASER);
    for value in [laser.first, last, laser.step, turn_s / laser.beams.max(1) as f64, turn_s] {
        cdr.single(value as f32);
    }
    for limit in laser.range {
        cdr.single(limit as f32);
    }
    cdr.word(ranges.len() as u32);
    for &range in ranges {
        cdr.single(range);
    }
    // Intensities aren't measured.
    cdr.word(0);
    cdr
}

/// `sensor_msgs/BatteryState`. Robots know neither its design capacity nor its cells.
pub fn battery(time_s: f64, state: &BatteryState) -> Cdr {
    let mut cdr = Cdr::new();
    cdr.header(time_s, BASE);
    for value in [state.voltage_v, state.temperature_c, state.current_a, state.charge_ah, state.capacity_ah] {
        cdr.single(value);
    }
    cdr.single(f32::NAN);
    cdr.single(if state.capacity_ah > 0.0 { state.charge_ah / state.capacity_ah } else { f32::NAN });
    let supply = match state.supply {
        BatteryActivity::Unknown => UNKNOWN,
        BatteryActivity::Charging => CHARGING,
        BatteryActivity::Discharging => DISCHARGING,
        BatteryActivity::NotCharging => NOT_CHARGING,
    };
    // Health and technology aren't known.
    for value in [supply, 0, 0] {
        cdr.byte(value);
    }
    cdr.flags(&[true]);
    cdr.word(0);
    cdr.word(0);
    cdr.string("");
    cdr.string("");
    cdr
}

/// `create_msgs/Bumper`.
pub fn bumper(time_s: f64, state: &BumperState) -> Cdr {
    let mut cdr = Cdr::new();
    cdr.header(time_s, BASE);
    cdr.flags(&state.pressed);
    cdr.flags(&state.light);
    for signal in state.signal {
        cdr.short(signal);
    }
    cdr
}

/// `create_msgs/Cliff`: no floor at left, front left, front right and right. In the definition, right comes before front
/// right.
pub fn cliff(time_s: f64, [left, front_left, front_right, right]: [bool; 4]) -> Cdr {
    let mut cdr = Cdr::new();
    cdr.header(time_s, BASE);
    cdr.flags(&[left, front_left, right, front_right]);
    cdr
}

/// `std_msgs/Bool`.
pub fn flag(value: bool) -> Cdr {
    let mut cdr = Cdr::new();
    cdr.flags(&[value]);
    cdr
}

/// `create_msgs/Mode`: 0 off, 1 passive, 2 safe, 3 full.
pub fn mode(time_s: f64, mode: u8) -> Cdr {
    let mut cdr = Cdr::new();
    cdr.header(time_s, BASE);
    cdr.byte(mode);
    cdr
}

/// `rcl_interfaces/Log` of `source`: INFO, or WARN for a fault.
pub fn log(time_s: f64, source: &str, text: &str, is_fault: bool) -> Cdr {
    let mut cdr = Cdr::new();
    cdr.time(time_s);
    cdr.byte(if is_fault { 30 } else { 20 });
    cdr.string(source);
    cdr.string(text);
    cdr.string("");
    cdr.string("");
    cdr.word(0);
    cdr
}

/// `rosgraph_msgs/Clock`.
pub fn clock(time_s: f64) -> Cdr {
    let mut cdr = Cdr::new();
    cdr.time(time_s);
    cdr
}

/// Position and orientation of `geometry_msgs/Pose`, and of `geometry_msgs/Transform`.
fn put_pose(cdr: &mut Cdr, pose: Pose) {
    let (sin, cos) = math::sin_cos(0.5 * pose.heading);
    cdr.doubles(&[pose.x, pose.y, 0.0, 0.0, 0.0, sin, cos]);
}

fn put_velocity(cdr: &mut Cdr, [ahead, left, turn]: Velocity) {
    cdr.doubles(&[ahead, left, 0.0, 0.0, 0.0, turn]);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn velocity_is_seen_from_the_robot() {
        // Looks up, moves up and to the left.
        let before = Pose::new(1.0, 1.0, math::FRAC_PI_2);
        let now = Pose::new(0.98, 1.04, math::FRAC_PI_2);
        let [ahead, left, turn] = velocity(before, now, 0.1);
        assert!((ahead - 0.4).abs() < 1e-9 && (left - 0.2).abs() < 1e-9 && turn == 0.0, "{ahead} {left} {turn}");
        assert_eq!(velocity(before, Pose::new(5.0, 1.0, 0.0), 0.1), [0.0; 3]);
    }

    #[test]
    fn unknown_floor_is_minus_one() {
        let plan = FloorPlan {
            name: String::new(),
            note: String::new(),
            resolution: 0.5,
            occupancy: robovac_core::grid::Grid::from_rows(
                3,
                vec![Occupancy::Unknown, Occupancy::Free, Occupancy::Occupied],
            )
            .unwrap(),
            objects: Vec::new(),
            start: None,
            origin: Pose::new(0.0, 0.0, 0.0),
        };
        let bytes = occupancy_grid(1.5, &plan, plan.origin).bytes();
        assert_eq!(bytes[bytes.len() - 7..], [3, 0, 0, 0, 0xFF, 0, 100]);
    }
}
