//! Geometry of docks: the light around them, and the pose of a robot on their contacts.
//!
//! A dock sends a green and a red beam, each 30 of 50 degrees wide, which overlap in the middle, and a force field of 2
//! feet around it, as in iRobot's own simulation of the Create 3 (`create3_sim`, `gazebo_ros_ir_opcode.hpp`: docking
//! buoys of 50 degrees of which either takes 0.6, halo of 0.6096 m). Seen by a robot that faces the dock, the green beam is on
//! its left and the red one on its right (Open Interface specification). There the beams end at 1.5 m; here they reach
//! 2.5 m, which is ours: docks are found from across a room.
//!
//! The receiver all around is 153 mm ahead of the Roomba's middle (Create 3's place, at the front edge), and so are the
//! two front receivers, which look 35 degrees to their side and see 45 degrees to either side of that (ours).

use robovac_core::{
    coverage::DOCK_BACK,
    geometry::{Point, Pose, Vector},
    math,
    robot::RobotModel,
};

/// Largest distance of the robot's front from the dock's solid back while charging, m, largest offset from the dock's
/// middle, m, and sine of the largest angle. The dock's contacts are strips that meet those of the robot, 47 mm behind
/// its front and 44 mm to either side (Open Interface facts, section 6); their size is ours.
pub(crate) const CONTACT: (f64, f64, f64) = (0.015, 0.025, 0.15);
/// Length of a dock's beams, m.
pub(crate) const BEAMS: f64 = 2.5;
/// Tangents of the angles at which a beam ends, on its own side of the middle and on the other: 25 and 5 degrees.
const BEAM: (f64, f64) = (0.466_307_658_154_999, 0.087_488_663_525_924);
/// Radius of a dock's force field, m.
const FORCE_FIELD: f64 = 0.6096;
/// Depth in a wall at which emitters still work, m.
pub(crate) const SLACK: f64 = 0.05;
/// Place of the receivers ahead of the origin, as a share of the body's radius.
pub(crate) const RECEIVERS: f64 = 0.878;
/// Direction of the left front receiver, (ahead, left): cosine and sine of 35 degrees.
const LOOKS: [f64; 2] = [0.819_152_044_288_992, 0.573_576_436_351_046];
/// Cosine of half the field of view of a front receiver.
const FIELD: f64 = core::f64::consts::FRAC_1_SQRT_2;

/// The light of `dock` at a point, if nothing is in between: force field, green and red beam.
pub(crate) fn light_at(dock: Pose, point: Point) -> [bool; 3] {
    let way = point - dock.position();
    let distance_squared = way.norm_squared();
    if distance_squared > BEAMS * BEAMS {
        return [false; 3];
    }
    let (ahead, left) = resolve(way, dock);
    // The dock's left is the right of a robot that faces it.
    let is_green = -left < ahead * BEAM.0 && left < ahead * BEAM.1;
    let is_red = left < ahead * BEAM.0 && -left < ahead * BEAM.1;
    [distance_squared < FORCE_FIELD * FORCE_FIELD, is_green, is_red]
}

/// Whether the left and the right front receiver see a place that is `way` from them, on a robot heading `ahead`.
pub(crate) fn front_sees(way: Vector, ahead: Vector) -> [bool; 2] {
    let left = Vector::new(-ahead.y, ahead.x);
    [1.0, -1.0].map(|side| {
        let looks = ahead * LOOKS[0] + left * (side * LOOKS[1]);
        way.dot(&looks) >= FIELD * way.norm()
    })
}

/// A displacement in an emitter's frame: ahead of it, and to its left.
pub(crate) fn resolve(way: Vector, emitter: Pose) -> (f64, f64) {
    let looks = emitter.direction();
    (looks.dot(&way), looks.perp(&way))
}

/// The pose of `robot` on `dock`, with its contacts touching.
pub fn berth(dock: Pose, robot: &RobotModel) -> Pose {
    let at = dock.to_world(Point::new(robot.radius + DOCK_BACK[1], 0.0));
    Pose::new(at.x, at.y, dock.heading + math::PI)
}

/// The dock on whose contacts `robot` stands at `berth`.
pub fn dock_at(berth: Pose, robot: &RobotModel) -> Pose {
    let at = berth.to_world(Point::new(robot.radius + DOCK_BACK[1], 0.0));
    Pose::new(at.x, at.y, berth.heading + math::PI)
}

/// Whether the contacts touch at `pose`, for a robot whose pose on the dock is `berth`.
pub(crate) fn could_touch(berth: Pose, pose: Pose) -> bool {
    let (ahead, left) = resolve(pose.position() - berth.position(), berth);
    let turn = berth.direction().perp(&pose.direction());
    ahead.abs() < CONTACT.0
        && left.abs() < CONTACT.1
        && turn.abs() < CONTACT.2
        && berth.direction().dot(&pose.direction()) > 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::{geometry::difference, robot::model};

    #[test]
    fn who_stands_on_a_dock_is_ahead_of_it_and_faces_it() {
        let (dock, robot) = (Pose::new(1.0, 2.0, 0.5), model("roomba600").unwrap());
        let berth = berth(dock, robot);
        assert!((resolve(berth.position() - dock.position(), dock).0 - robot.radius - 0.02).abs() < 1e-12);
        assert!(difference(berth.heading, 0.5 + math::PI).abs() < 1e-12);
        let back = dock_at(berth, robot);
        assert!((back.position() - dock.position()).norm() < 1e-12);
        assert!(difference(back.heading, dock.heading).abs() < 1e-12);
    }

    #[test]
    fn beams_overlap_in_the_middle() {
        let dock = Pose::new(0.0, 0.0, 0.0);
        assert_eq!(light_at(dock, Point::new(1.0, 0.0)), [false, true, true]);
        assert_eq!(light_at(dock, Point::new(0.5, -0.1)), [true, true, false]);
        assert_eq!(light_at(dock, Point::new(1.0, 0.2)), [false, false, true]);
        assert_eq!(light_at(dock, Point::new(-1.0, 0.0)), [false; 3]);
        assert_eq!(light_at(dock, Point::new(2.6, 0.0)), [false; 3]);
    }
}
