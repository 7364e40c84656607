//! Topics: names, kinds of messages, and what late subscribers get.

use super::{Cdr, Kind};

/// A topic.
#[derive(Debug, PartialEq, Eq)]
pub struct Topic {
    /// Its name, below the namespace.
    pub name: &'static str,
    /// What is published there.
    pub kind: Kind,
    /// Whether late subscribers get the last message (durability *transient local*).
    pub is_latched: bool,
}

/// An encoded message of a topic.
#[derive(Debug, Clone)]
pub struct Stamped {
    /// Its topic.
    pub topic: &'static Topic,
    /// Since the start of the run, s.
    pub time_s: f64,
    /// In the Common Data Representation, with its encapsulation.
    pub bytes: Vec<u8>,
}

impl Topic {
    /// Its full name in a namespace; "" for none. Events and clock are in one topic for all robots, as
    /// everywhere in ROS 2.
    pub fn in_namespace(&self, namespace: &str) -> String {
        let namespace = namespace.trim_matches('/');
        if namespace.is_empty() || matches!(self.kind, Kind::Log | Kind::Clock) {
            return format!("/{}", self.name);
        }
        format!("/{namespace}/{}", self.name)
    }

    /// A message of this topic.
    pub fn stamped(&'static self, time_s: f64, message: Cdr) -> Stamped {
        Stamped { topic: self, time_s, bytes: message.bytes() }
    }
}

macro_rules! topics {
    ($($(#[$about:meta])* $id:ident = $name:literal, $kind:ident, $latched:literal;)*) => {
        $($(#[$about])* pub static $id: Topic = Topic { name: $name, kind: Kind::$kind, is_latched: $latched };)*
    };
}

topics! {
    /// The robot's map; the room itself for a robot that makes none.
    MAP = "map", OccupancyGrid, true;
    /// The planned path.
    PLAN = "plan", Path, true;
    /// Pose and velocity by wheel encoders, from the start.
    ODOM = "odom", Odometry, false;
    /// Frames that move.
    TF = "tf", Transforms, false;
    /// Frames that don't.
    TF_STATIC = "tf_static", Transforms, true;
    /// The laser scanner.
    SCAN = "scan", LaserScan, false;
    /// Commanded speeds.
    CMD_VEL = "cmd_vel", Twist, false;
    /// Bumper and light bumper.
    BUMPER = "bumper", Bumper, false;
    /// Cliff sensors.
    CLIFF = "cliff", Cliff, false;
    /// Whether a wheel hangs down.
    WHEEL_DROP = "wheel_drop", Bool, false;
    /// The battery.
    BATTERY = "battery_state", Battery, false;
    /// The mode of a Roomba.
    MODE = "mode", Mode, false;
    /// Events in words.
    LOG = "rosout", Log, true;
    /// Simulated time.
    CLOCK = "clock", Clock, false;
    /// The true room, if the robot makes a map.
    TRUE_MAP = "ground_truth/map", OccupancyGrid, true;
    /// The true pose and velocity, which only a simulator knows.
    TRUE_POSE = "ground_truth/odom", Odometry, false;
}
