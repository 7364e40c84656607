//! Coordinate frames of REP 105, and poses relative to others.

use robovac_core::geometry::{Point, Pose, difference};

/// The frame of the map that a room came from; its lower left corner for other rooms.
pub const MAP: &str = "map";
/// The frame of odometry: where the robot started.
pub const ODOM: &str = "odom";
/// The robot's frame: the middle between its wheels, x ahead.
pub const BASE: &str = "base_link";
/// The frame of a laser scanner.
pub const LASER: &str = "laser";

/// The pose `local`, given in the frame at `frame`, in the frame that `frame` is given in.
pub fn compose(frame: Pose, local: Pose) -> Pose {
    let at = frame.to_world(local.position());
    Pose::new(at.x, at.y, frame.heading + local.heading)
}

/// The frame in which `pose` appears as `local`.
pub fn frame_of(pose: Pose, local: Pose) -> Pose {
    let turned = Pose::new(0.0, 0.0, difference(local.heading, pose.heading));
    let shift = turned.to_world(Point::new(local.x, local.y));
    Pose::new(pose.x - shift.x, pose.y - shift.y, turned.heading)
}

/// The pose `pose` in the frame at `frame`, both given in a third one: inverts [`compose`].
pub fn relative_to(frame: Pose, pose: Pose) -> Pose {
    let back = Pose::new(0.0, 0.0, -frame.heading);
    let at = back.to_world(Point::new(pose.x - frame.x, pose.y - frame.y));
    Pose::new(at.x, at.y, difference(frame.heading, pose.heading))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_inverted() {
        let (frame, local) = (Pose::new(3.0, -1.0, 2.5), Pose::new(-0.4, 7.0, 1.9));
        let found = frame_of(compose(frame, local), local);
        assert!((found.position() - frame.position()).norm() < 1e-12, "{found}");
        assert!(difference(found.heading, frame.heading).abs() < 1e-12, "{found}");
        let found = relative_to(frame, compose(frame, local));
        assert!((found.position() - local.position()).norm() < 1e-12, "{found}");
        assert!(difference(found.heading, local.heading).abs() < 1e-12, "{found}");
    }
}
