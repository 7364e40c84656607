//! Pose estimate from encoder counts, or from distance and angle packets (004, section 4.2).

use super::{RobotModel, SensorReadings};
use crate::{
    geometry::{Point, Pose},
    math,
};
use serde::{Deserialize, Serialize};

/// Models that convert the rolling of wheels to a change of pose: the source of the measurement, and the assumed line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum OdometryModel {
    /// The robot moved on a circular arc: exact while both wheel speeds are constant.
    #[default]
    Arc,
    /// The robot moved straight along its old heading, then turned: good for small steps only.
    Straight,
    /// The same as [`Arc`](Self::Arc), from distance and angle in whole millimetres and degrees (packets 19 and 20).
    PacketArc,
    /// The same as [`Straight`](Self::Straight), from these.
    PacketStraight,
}

impl OdometryModel {
    /// All models, with their names in links and on the command line.
    pub const ALL: [(Self, &'static str); 4] = [
        (Self::Arc, "arc"),
        (Self::Straight, "straight"),
        (Self::PacketArc, "packet_arc"),
        (Self::PacketStraight, "packet_straight"),
    ];

    /// Whether it uses distance and angle instead of counts.
    pub fn is_by_packets(self) -> bool {
        matches!(self, Self::PacketArc | Self::PacketStraight)
    }

    /// Distances rolled by its measurement: left, right, sideways, m. `since` are counts since the last reading.
    pub fn rolled(self, sensed: &SensorReadings, since: [i16; 3], robot: RollingScale) -> [f64; 3] {
        let metres = since.map(|counts| f64::from(counts) * robot.metres_per_count);
        if !self.is_by_packets() {
            return metres;
        }
        // No packet reports sideways motion.
        let [left, right] = sensed.moved.map_or([0.0; 2], |moved| moved.rolled(robot.wheel_base));
        [left, right, metres[2]]
    }

    /// The model of that name.
    pub fn parse(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(_, n)| *n == name).map(|(model, _)| model)
    }

    /// Name in links and on the command line.
    pub fn id(self) -> &'static str {
        Self::ALL[self as usize].1
    }
}

/// Conversion of counts and angles to distances.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingScale {
    /// Distance per count, m.
    pub metres_per_count: f64,
    /// Distance between the wheels, m.
    pub wheel_base: f64,
}

impl RollingScale {
    /// The scale of a robot.
    pub fn of(robot: &RobotModel) -> Self {
        Self { metres_per_count: 1.0 / robot.counts_per_metre, wheel_base: robot.wheel_base }
    }
}

/// Dead reckoning: sums the motion of the wheels since the start.
#[derive(Debug, Clone, PartialEq)]
pub struct Odometry {
    model: OdometryModel,
    scale: RollingScale,
    /// Counts of the last reading: left, right, sideways.
    last: Option<[u16; 3]>,
    pose: Pose,
}

impl Odometry {
    /// An estimate that starts at `pose`; the first reading only sets the counters.
    pub fn new(robot: &RobotModel, model: OdometryModel, pose: Pose) -> Self {
        Self { model, scale: RollingScale::of(robot), last: None, pose }
    }

    /// The estimate.
    pub fn pose(&self) -> Pose {
        self.pose
    }

    /// Takes the next reading. Counters may wrap, but not by half their range (14.6 m) at once; packets of the first
    /// reading are ignored, as they cover earlier motion.
    pub fn update(&mut self, sensed: &SensorReadings) {
        let counts = [sensed.left_counts, sensed.right_counts, sensed.lateral_counts];
        let Some(last) = self.last.replace(counts) else { return };
        let since = [0, 1, 2].map(|i| counts[i].wrapping_sub(last[i]) as i16);
        let rolled @ [left, right, lateral] = self.model.rolled(sensed, since, self.scale);
        if rolled == [0.0; 3] {
            return;
        }
        let base = self.scale.wheel_base;
        self.pose = match self.model {
            OdometryModel::Arc | OdometryModel::PacketArc => advance_sideways(self.pose, rolled, base),
            OdometryModel::Straight | OdometryModel::PacketStraight => {
                let along = self.pose.to_world(Point::new(0.0, lateral));
                let shifted = Pose { x: along.x, y: along.y, ..self.pose };
                advance(shifted, left, right, base, OdometryModel::Straight)
            }
        };
    }
}

/// The pose after the wheels rolled these distances at constant speeds: left, right, and to the left for an
/// omnidirectional robot, m. Exact, like [`OdometryModel::Arc`].
pub fn advance_sideways(pose: Pose, [left, right, lateral]: [f64; 3], wheel_base: f64) -> Pose {
    let distance = 0.5 * (left + right);
    let turn = (right - left) / wheel_base;
    // The chord of the arc leaves at half the turn and is shorter than it by sin(t/2) / (t/2).
    let half = 0.5 * turn;
    let square = half * half;
    // For the small turns of one step, the series is exact to the last bit but one, and needs no sine.
    let chord = if square < 2.5e-3 {
        1.0 - square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0))
    } else {
        math::sin(half) / half
    };
    let (sin, cos) = math::sin_cos(pose.heading + half);
    let (sin, cos) = (chord * sin, chord * cos);
    Pose::new(pose.x + distance * cos - lateral * sin, pose.y + distance * sin + lateral * cos, pose.heading + turn)
}

/// The pose after the wheels rolled `left` and `right` metres.
///
/// The heading grows by (right - left) / wheel base: counter-clockwise positive, as in the driver code that 004
/// quotes; the sign in its text is the other way round.
pub fn advance(pose: Pose, left: f64, right: f64, wheel_base: f64, model: OdometryModel) -> Pose {
    match model {
        OdometryModel::Arc | OdometryModel::PacketArc => advance_sideways(pose, [left, right, 0.0], wheel_base),
        OdometryModel::Straight | OdometryModel::PacketStraight => {
            let (distance, turn) = (0.5 * (left + right), (right - left) / wheel_base);
            let along = pose.direction() * distance;
            Pose::new(pose.x + along.x, pose.y + along.y, pose.heading + turn)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        math::{FRAC_PI_2, PI},
        robot::model,
    };

    #[test]
    fn arc_model_is_exact_on_a_quarter_circle() {
        let base = 0.235;
        let (left, right) = ((1.0 - base / 2.0) * FRAC_PI_2, (1.0 + base / 2.0) * FRAC_PI_2);
        let end = advance(Pose::new(0.0, 0.0, 0.0), left, right, base, OdometryModel::Arc);
        assert!((end.x - 1.0).abs() < 1e-12 && (end.y - 1.0).abs() < 1e-12, "{end}");
        assert!((end.heading - FRAC_PI_2).abs() < 1e-12);
        let straight = advance(Pose::new(0.0, 0.0, 0.0), left, right, base, OdometryModel::Straight);
        assert!((straight.x - FRAC_PI_2).abs() < 1e-12 && straight.y == 0.0);
    }

    /// The thesis' code for the arc (004, section 6.1), with y counted to the left as in REP 103.
    #[test]
    fn arc_model_agrees_with_the_radius_form_of_the_thesis() {
        let (yaw, left, right, base) = (0.7, 0.11, 0.16, 0.235);
        let turn: f64 = (right - left) / base;
        let radius = base / 2.0 * (left + right) / (right - left);
        let (dx, dy) =
            (radius * (math::sin(yaw + turn) - math::sin(yaw)), -radius * (math::cos(yaw + turn) - math::cos(yaw)));
        let end = advance(Pose::new(0.0, 0.0, yaw), left, right, base, OdometryModel::Arc);
        assert!((end.x - dx).abs() < 1e-12 && (end.y - dy).abs() < 1e-12);
    }

    #[test]
    fn counters_wrap_both_ways() {
        let robot = model("roomba600").unwrap();
        let mut odometry = Odometry::new(robot, OdometryModel::Arc, Pose::new(0.0, 0.0, 0.0));
        let reading =
            |counts: u16| SensorReadings { left_counts: counts, right_counts: counts, ..SensorReadings::default() };
        for counts in [65_530, 10, 65_530] {
            odometry.update(&reading(counts));
        }
        assert!(odometry.pose().x.abs() < 1e-12);
        odometry.update(&reading(65_530_u16.wrapping_add(2249)));
        assert!((odometry.pose().x - 1.0).abs() < 1e-3, "{}", odometry.pose());
    }

    #[test]
    fn heading_stays_normalised() {
        let end = advance(Pose::new(0.0, 0.0, 3.0), -0.1, 0.1, 0.235, OdometryModel::Arc);
        assert!(end.heading > -PI && end.heading <= PI);
    }
}
