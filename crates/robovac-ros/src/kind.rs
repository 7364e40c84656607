//! Kinds of messages and their definitions.
//!
//! Standard messages are of `common_interfaces`, `rcl_interfaces` and `tf2_msgs`; bumper, cliffs and mode are those of
//! `create_msgs`, the messages of the ROS driver of these robots (`AutonomyLab/create_robot`), which the viewers of its
//! users know.

/// A kind of message.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// `nav_msgs/OccupancyGrid`
    OccupancyGrid,
    /// `nav_msgs/Path`
    Path,
    /// `nav_msgs/Odometry`
    Odometry,
    /// `tf2_msgs/TFMessage`
    Transforms,
    /// `sensor_msgs/LaserScan`
    LaserScan,
    /// `sensor_msgs/BatteryState`
    Battery,
    /// `geometry_msgs/Twist`
    Twist,
    /// `create_msgs/Bumper`
    Bumper,
    /// `create_msgs/Cliff`
    Cliff,
    /// `create_msgs/Mode`
    Mode,
    /// `std_msgs/Bool`
    Bool,
    /// `rcl_interfaces/Log`
    Log,
    /// `rosgraph_msgs/Clock`
    Clock,
}

/// Definitions by package and name.
const DEFINITIONS: &[(&str, &str, &str)] = &[
    ("builtin_interfaces", "Time", "int32 sec\nuint32 nanosec\n"),
    ("std_msgs", "Header", "builtin_interfaces/Time stamp\nstring frame_id\n"),
    ("std_msgs", "Bool", "bool data\n"),
    ("geometry_msgs", "Vector3", "float64 x\nfloat64 y\nfloat64 z\n"),
    ("geometry_msgs", "Point", "float64 x\nfloat64 y\nfloat64 z\n"),
    ("geometry_msgs", "Quaternion", "float64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n"),
    ("geometry_msgs", "Pose", "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"),
    ("geometry_msgs", "PoseStamped", "std_msgs/Header header\ngeometry_msgs/Pose pose\n"),
    ("geometry_msgs", "PoseWithCovariance", "geometry_msgs/Pose pose\nfloat64[36] covariance\n"),
    ("geometry_msgs", "Twist", "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n"),
    ("geometry_msgs", "TwistWithCovariance", "geometry_msgs/Twist twist\nfloat64[36] covariance\n"),
    ("geometry_msgs", "Transform", "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n"),
    (
        "geometry_msgs",
        "TransformStamped",
        "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n",
    ),
    (
        "nav_msgs",
        "MapMetaData",
        "builtin_interfaces/Time map_load_time\nfloat32 resolution\nuint32 width\nuint32 height\n\
         geometry_msgs/Pose origin\n",
    ),
    ("nav_msgs", "OccupancyGrid", "std_msgs/Header header\nnav_msgs/MapMetaData info\nint8[] data\n"),
    ("nav_msgs", "Path", "std_msgs/Header header\ngeometry_msgs/PoseStamped[] poses\n"),
    (
        "nav_msgs",
        "Odometry",
        "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\n\
         geometry_msgs/TwistWithCovariance twist\n",
    ),
    ("tf2_msgs", "TFMessage", "geometry_msgs/TransformStamped[] transforms\n"),
    (
        "sensor_msgs",
        "LaserScan",
        "std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\n\
         float32 time_increment\nfloat32 scan_time\nfloat32 range_min\nfloat32 range_max\nfloat32[] ranges\n\
         float32[] intensities\n",
    ),
    (
        "sensor_msgs",
        "BatteryState",
        "uint8 POWER_SUPPLY_STATUS_UNKNOWN=0\nuint8 POWER_SUPPLY_STATUS_CHARGING=1\n\
         uint8 POWER_SUPPLY_STATUS_DISCHARGING=2\nuint8 POWER_SUPPLY_STATUS_NOT_CHARGING=3\n\
         uint8 POWER_SUPPLY_STATUS_FULL=4\nstd_msgs/Header header\nfloat32 voltage\nfloat32 temperature\n\
         float32 current\nfloat32 charge\nfloat32 capacity\nfloat32 design_capacity\nfloat32 percentage\n\
         uint8 power_supply_status\nuint8 power_supply_health\nuint8 power_supply_technology\nbool present\n\
         float32[] cell_voltage\nfloat32[] cell_temperature\nstring location\nstring serial_number\n",
    ),
    (
        "create_msgs",
        "Bumper",
        "std_msgs/Header header\nbool is_left_pressed\nbool is_right_pressed\nbool is_light_left\n\
         bool is_light_front_left\nbool is_light_center_left\nbool is_light_center_right\n\
         bool is_light_front_right\nbool is_light_right\nuint16 light_signal_left\n\
         uint16 light_signal_front_left\nuint16 light_signal_center_left\nuint16 light_signal_center_right\n\
         uint16 light_signal_front_right\nuint16 light_signal_right\n",
    ),
    (
        "create_msgs",
        "Cliff",
        "std_msgs/Header header\nbool is_cliff_left\nbool is_cliff_front_left\nbool is_cliff_right\n\
         bool is_cliff_front_right\n",
    ),
    (
        "create_msgs",
        "Mode",
        "uint8 MODE_OFF=0\nuint8 MODE_PASSIVE=1\nuint8 MODE_SAFE=2\nuint8 MODE_FULL=3\nstd_msgs/Header header\n\
         uint8 mode\n",
    ),
    (
        "rcl_interfaces",
        "Log",
        "byte DEBUG=10\nbyte INFO=20\nbyte WARN=30\nbyte ERROR=40\nbyte FATAL=50\nbuiltin_interfaces/Time stamp\n\
         uint8 level\nstring name\nstring msg\nstring file\nstring function\nuint32 line\n",
    ),
    ("rosgraph_msgs", "Clock", "builtin_interfaces/Time clock\n"),
];

impl Kind {
    /// Package and name.
    pub fn name(self) -> (&'static str, &'static str) {
        match self {
            Self::OccupancyGrid => ("nav_msgs", "OccupancyGrid"),
            Self::Path => ("nav_msgs", "Path"),
            Self::Odometry => ("nav_msgs", "Odometry"),
            Self::Transforms => ("tf2_msgs", "TFMessage"),
            Self::LaserScan => ("sensor_msgs", "LaserScan"),
            Self::Battery => ("sensor_msgs", "BatteryState"),
            Self::Twist => ("geometry_msgs", "Twist"),
            Self::Bumper => ("create_msgs", "Bumper"),
            Self::Cliff => ("create_msgs", "Cliff"),
            Self::Mode => ("create_msgs", "Mode"),
            Self::Bool => ("std_msgs", "Bool"),
            Self::Log => ("rcl_interfaces", "Log"),
            Self::Clock => ("rosgraph_msgs", "Clock"),
        }
    }

    /// The definition (`ros2msg`), followed by those of all types in it.
    pub fn definition(self) -> String {
        let (package, name) = self.name();
        let mut text = fields(package, name).to_owned();
        let mut named: Vec<(&str, &str)> = types_in(fields(package, name)).filter_map(known).collect();
        let mut next = 0;
        while let Some(&(package, name)) = named.get(next) {
            next += 1;
            let fields = fields(package, name);
            text.push_str(&"=".repeat(80));
            text.extend(["\nMSG: ", package, "/", name, "\n", fields]);
            for found in types_in(fields).filter_map(known) {
                if !named.contains(&found) {
                    named.push(found);
                }
            }
        }
        text
    }
}

fn fields(package: &str, name: &str) -> &'static str {
    DEFINITIONS.iter().find(|known| (known.0, known.1) == (package, name)).map_or("", |known| known.2)
}

fn known(path: &str) -> Option<(&'static str, &'static str)> {
    let (package, name) = path.split_once('/')?;
    DEFINITIONS.iter().find(|known| (known.0, known.1) == (package, name)).map(|known| (known.0, known.1))
}

/// Types other than built-in ones in a definition's fields.
fn types_in(fields: &str) -> impl Iterator<Item = &str> {
    let types = fields.lines().filter_map(|line| line.split_whitespace().next());
    types.map(|text| text.split('[').next().unwrap_or_default()).filter(|text| text.contains('/'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_type_in_a_definition_is_defined() {
        for &(package, name, text) in DEFINITIONS {
            for inner in types_in(text) {
                assert!(known(inner).is_some(), "{package}/{name} has a {inner}");
            }
        }
    }

    #[test]
    fn types_of_types_follow_once() {
        let text = Kind::Path.definition();
        let named: Vec<&str> = text.lines().filter_map(|line| line.strip_prefix("MSG: ")).collect();
        let expected =
            ["std_msgs/Header", "geometry_msgs/PoseStamped", "builtin_interfaces/Time", "geometry_msgs/Pose"];
        assert_eq!(named[..4], expected);
        assert_eq!(named[4..], ["geometry_msgs/Point", "geometry_msgs/Quaternion"]);
    }
}
