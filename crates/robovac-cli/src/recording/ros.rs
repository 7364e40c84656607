//! Messages of ROS 2: their definitions, and a robot's readings in them.
//!
//! Standard messages are of `common_interfaces` and `rcl_interfaces`; bumper, cliffs and mode are those of `create_msgs`,
//! the messages of the ROS driver of these robots (`AutonomyLab/create_robot`).

use super::cdr::Cdr;
use robovac_core::{
    geometry::{Pose, difference},
    math,
};
use robovac_link::recording::{RecordedReading, TimelineEntry};
use roomba_oi::{
    ChargingState, Mode,
    motion::{WHEEL_BASE_MM, WheelSpeeds},
};

/// Frames of REP 105.
const ODOM: &str = "odom";
const BASE: &str = "base_link";
/// Longest motion between two readings, m: beyond it, the pose was set.
const JUMP_M: f64 = 0.1;

/// A topic with the type of its messages.
pub struct Topic {
    pub name: &'static str,
    pub schema: &'static str,
    /// Definition, with those of the types in it.
    pub definition: &'static str,
}

macro_rules! definitions {
    ($own:expr $(, $name:literal: $text:expr)*) => {
        concat!($own $(, "================================================================================\nMSG: ", $name, "\n", $text)*)
    };
}
macro_rules! header {
    () => {
        "builtin_interfaces/Time stamp\nstring frame_id\n"
    };
}
macro_rules! time {
    () => {
        "int32 sec\nuint32 nanosec\n"
    };
}
macro_rules! vector {
    () => {
        "float64 x\nfloat64 y\nfloat64 z\n"
    };
}
macro_rules! twist {
    () => {
        "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n"
    };
}

/// All topics, in the order of [`Message`].
pub const TOPICS: [Topic; 8] = [
    Topic {
        name: "/odom",
        schema: "nav_msgs/msg/Odometry",
        definition: definitions!(
            "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\n\
             geometry_msgs/TwistWithCovariance twist\n",
            "std_msgs/Header": header!(),
            "builtin_interfaces/Time": time!(),
            "geometry_msgs/PoseWithCovariance": "geometry_msgs/Pose pose\nfloat64[36] covariance\n",
            "geometry_msgs/Pose": "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n",
            "geometry_msgs/Point": vector!(),
            "geometry_msgs/Quaternion": "float64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n",
            "geometry_msgs/TwistWithCovariance": "geometry_msgs/Twist twist\nfloat64[36] covariance\n",
            "geometry_msgs/Twist": twist!(),
            "geometry_msgs/Vector3": vector!()
        ),
    },
    Topic {
        name: "/battery_state",
        schema: "sensor_msgs/msg/BatteryState",
        definition: definitions!(
            "uint8 POWER_SUPPLY_STATUS_UNKNOWN=0\nuint8 POWER_SUPPLY_STATUS_CHARGING=1\n\
             uint8 POWER_SUPPLY_STATUS_DISCHARGING=2\nuint8 POWER_SUPPLY_STATUS_NOT_CHARGING=3\n\
             uint8 POWER_SUPPLY_STATUS_FULL=4\nstd_msgs/Header header\nfloat32 voltage\nfloat32 temperature\n\
             float32 current\nfloat32 charge\nfloat32 capacity\nfloat32 design_capacity\nfloat32 percentage\n\
             uint8 power_supply_status\nuint8 power_supply_health\nuint8 power_supply_technology\nbool present\n\
             float32[] cell_voltage\nfloat32[] cell_temperature\nstring location\nstring serial_number\n",
            "std_msgs/Header": header!(),
            "builtin_interfaces/Time": time!()
        ),
    },
    Topic {
        name: "/cmd_vel",
        schema: "geometry_msgs/msg/Twist",
        definition: definitions!(twist!(), "geometry_msgs/Vector3": vector!()),
    },
    Topic {
        name: "/bumper",
        schema: "create_msgs/msg/Bumper",
        definition: definitions!(
            "std_msgs/Header header\nbool is_left_pressed\nbool is_right_pressed\nbool is_light_left\n\
             bool is_light_front_left\nbool is_light_center_left\nbool is_light_center_right\n\
             bool is_light_front_right\nbool is_light_right\nuint16 light_signal_left\n\
             uint16 light_signal_front_left\nuint16 light_signal_center_left\nuint16 light_signal_center_right\n\
             uint16 light_signal_front_right\nuint16 light_signal_right\n",
            "std_msgs/Header": header!(),
            "builtin_interfaces/Time": time!()
        ),
    },
    Topic {
        name: "/cliff",
        schema: "create_msgs/msg/Cliff",
        definition: definitions!(
            "std_msgs/Header header\nbool is_cliff_left\nbool is_cliff_front_left\nbool is_cliff_right\n\
             bool is_cliff_front_right\n",
            "std_msgs/Header": header!(),
            "builtin_interfaces/Time": time!()
        ),
    },
    Topic { name: "/wheel_drop", schema: "std_msgs/msg/Bool", definition: "bool data\n" },
    Topic {
        name: "/mode",
        schema: "create_msgs/msg/Mode",
        definition: definitions!(
            "uint8 MODE_OFF=0\nuint8 MODE_PASSIVE=1\nuint8 MODE_SAFE=2\nuint8 MODE_FULL=3\nstd_msgs/Header header\n\
             uint8 mode\n",
            "std_msgs/Header": header!(),
            "builtin_interfaces/Time": time!()
        ),
    },
    Topic {
        name: "/rosout",
        schema: "rcl_interfaces/msg/Log",
        definition: definitions!(
            "byte DEBUG=10\nbyte INFO=20\nbyte WARN=30\nbyte ERROR=40\nbyte FATAL=50\nbuiltin_interfaces/Time stamp\n\
             uint8 level\nstring name\nstring msg\nstring file\nstring function\nuint32 line\n",
            "builtin_interfaces/Time": time!()
        ),
    },
];

/// A kind of message.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Message {
    Odometry,
    Battery,
    Command,
    Bumper,
    Cliff,
    WheelDrop,
    Mode,
    Log,
}

/// Pose by odometry. The covariance is 0: it isn't known.
pub fn odometry(time_s: f64, before: Option<Pose>, reading: &RecordedReading) -> Cdr {
    let pose = reading.pose;
    let mut cdr = Cdr::new();
    cdr.header(time_s, ODOM);
    cdr.string(BASE);
    let half = 0.5 * pose.heading;
    cdr.doubles(&[pose.x, pose.y, 0.0, 0.0, 0.0, math::sin(half), math::cos(half)]);
    cdr.doubles(&[0.0; 36]);
    let [speed, rate] = before.map_or([0.0; 2], |before| velocity(before, pose, reading.dt_s));
    cdr.doubles(&[speed, 0.0, 0.0, 0.0, 0.0, rate]);
    cdr.doubles(&[0.0; 36]);
    cdr
}

/// Speed ahead, m/s, and turn rate, rad/s.
fn velocity(before: Pose, now: Pose, dt_s: f64) -> [f64; 2] {
    let moved = now.position() - before.position();
    if dt_s <= 0.0 || moved.norm() > JUMP_M {
        return [0.0; 2];
    }
    [moved.dot(&now.direction()) / dt_s, difference(before.heading, now.heading) / dt_s]
}

/// The battery. A Roomba knows neither its design capacity nor its cells.
pub fn battery(time_s: f64, reading: &RecordedReading) -> Cdr {
    let readings = &reading.readings;
    let thousandth = |value: f32| value / 1000.0;
    let (charge, capacity) = (f32::from(readings.charge_left_mah()), f32::from(readings.capacity_mah));
    let mut cdr = Cdr::new();
    cdr.header(time_s, BASE);
    cdr.single(thousandth(readings.voltage_mv.into()));
    cdr.single(readings.temperature_c.into());
    cdr.single(thousandth(readings.current_ma.into()));
    cdr.single(thousandth(charge));
    cdr.single(thousandth(capacity));
    cdr.single(f32::NAN);
    cdr.single(if capacity > 0.0 { charge / capacity } else { f32::NAN });
    let status = match readings.charging {
        ChargingState::Reconditioning | ChargingState::Full | ChargingState::Trickle => 1,
        ChargingState::None => 2,
        ChargingState::Waiting | ChargingState::Fault => 3,
        ChargingState::Other(_) => 0,
    };
    // Health and technology aren't known.
    for value in [status, 0, 0] {
        cdr.byte(value);
    }
    cdr.flags(&[true]);
    cdr.word(0);
    cdr.word(0);
    cdr.string("");
    cdr.string("");
    cdr
}

/// Commanded wheel speeds as speed and turn rate.
pub fn command(wheels: WheelSpeeds) -> Cdr {
    let speed = 0.5e-3 * (wheels.right + wheels.left);
    let mut cdr = Cdr::new();
    cdr.doubles(&[speed, 0.0, 0.0, 0.0, 0.0, (wheels.right - wheels.left) / WHEEL_BASE_MM]);
    cdr
}

/// Bumper and light bumper.
pub fn bumper(time_s: f64, reading: &RecordedReading) -> Cdr {
    let (bumps, light) = (reading.readings.bumps, reading.readings.light_bumper);
    let mut cdr = Cdr::new();
    cdr.header(time_s, BASE);
    cdr.flags(&[bumps.bump_left, bumps.bump_right]);
    cdr.flags(&[light.left, light.front_left, light.centre_left]);
    cdr.flags(&[light.centre_right, light.front_right, light.right]);
    for signal in reading.readings.light_signal {
        cdr.short(signal);
    }
    cdr
}

/// Cliff sensors. In the definition, right comes before front right.
pub fn cliff(time_s: f64, reading: &RecordedReading) -> Cdr {
    let [left, front_left, front_right, right] = reading.readings.cliff;
    let mut cdr = Cdr::new();
    cdr.header(time_s, BASE);
    cdr.flags(&[left, front_left, right, front_right]);
    cdr
}

/// Whether a wheel hangs down.
pub fn wheel_drop(has_dropped: bool) -> Cdr {
    let mut cdr = Cdr::new();
    cdr.flags(&[has_dropped]);
    cdr
}

/// The mode.
pub fn mode(time_s: f64, mode: Mode) -> Cdr {
    let mut cdr = Cdr::new();
    cdr.header(time_s, BASE);
    cdr.byte(mode as u8);
    cdr
}

/// An entry of the timeline: INFO, or WARN for a fault.
pub fn log(entry: &TimelineEntry) -> Cdr {
    let mut cdr = Cdr::new();
    cdr.time(entry.time_s);
    cdr.byte(if entry.is_fault { 30 } else { 20 });
    cdr.string("recording");
    cdr.string(&entry.text);
    cdr.string("");
    cdr.string("");
    cdr.word(0);
    cdr
}
