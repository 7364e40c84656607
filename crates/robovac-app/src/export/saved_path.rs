//! A path with the way in which it is driven, to be saved.

use coverage_planners::sweep::{Waypoint, in_frame, waypoints, waypoints_along};
use robovac_core::{
    geometry::{Point, Pose},
    robot::RobotModel,
    trajectory::Trajectory,
};
use std::borrow::Cow;

/// A path to be saved, in the room.
#[derive(Debug, Clone, Copy)]
pub struct SavedPath<'a> {
    /// Its corners, m.
    pub corners: &'a [Point],
    /// Heading of the robot at its start, rad.
    pub heading: f64,
    /// How it is driven smoothly; `None` with a stop at each corner.
    pub smooth: Option<&'a Trajectory>,
}

impl<'a> SavedPath<'a> {
    /// A path with a stop at each corner.
    pub fn with_stops(corners: &'a [Point], heading: f64) -> Self {
        Self { corners, heading, smooth: None }
    }

    /// The line that is driven, m: the corners, or points on the curves that are nearer to each other than 4 mm.
    pub fn line(&self) -> Cow<'a, [Point]> {
        self.smooth.map_or(Cow::Borrowed(self.corners), |trajectory| trajectory.points().into())
    }

    /// The robot's places and times, in the frame of the map that the room came from, in which the room's origin is at `origin`:
    /// all stops, or places along the trajectory.
    pub fn places(&self, origin: Pose, robot: &RobotModel) -> Vec<Waypoint> {
        if let Some(trajectory) = self.smooth {
            return waypoints_along(&trajectory.in_frame(origin), robot);
        }
        let (path, heading) = in_frame(self.corners, self.heading, origin);
        waypoints(&path, heading, robot)
    }
}
