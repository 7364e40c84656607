//! What follows a planned line: with a stop at each corner, or smoothly.

use super::{Controller, FollowPath, FollowSmoothly};
use robovac_core::{
    geometry::Pose,
    robot::{Drive, SensorReadings},
};

/// A follower of a planned line.
#[derive(Debug, Clone)]
pub enum Follower {
    /// Stops at each corner.
    Stopping(FollowPath),
    /// Rounds corners.
    Smooth(FollowSmoothly),
}

impl Follower {
    /// The line, and where the robot is.
    pub(super) fn path(&self) -> &FollowPath {
        match self {
            Self::Stopping(path) => path,
            Self::Smooth(smooth) => smooth.path(),
        }
    }

    /// The same, to be changed.
    pub(super) fn path_mut(&mut self) -> &mut FollowPath {
        match self {
            Self::Stopping(path) => path,
            Self::Smooth(smooth) => smooth.path_mut(),
        }
    }

    /// Something else drives from now on, until [`FollowPath::resume`].
    pub(super) fn pause(&mut self) {
        if let Self::Smooth(smooth) = self {
            smooth.pause();
        }
    }

    fn controller(&self) -> &dyn Controller {
        match self {
            Self::Stopping(path) => path,
            Self::Smooth(smooth) => smooth,
        }
    }
}

impl From<FollowPath> for Follower {
    fn from(path: FollowPath) -> Self {
        Self::Stopping(path)
    }
}

impl Controller for Follower {
    fn step(&mut self, sensed: &SensorReadings, dt_s: f64) -> Drive {
        match self {
            Self::Stopping(path) => path.step(sensed, dt_s),
            Self::Smooth(smooth) => smooth.step(sensed, dt_s),
        }
    }

    fn is_done(&self) -> bool {
        self.path().is_done()
    }

    fn estimate(&self) -> Option<Pose> {
        self.path().estimate()
    }

    fn activity(&self) -> &'static str {
        self.controller().activity()
    }

    fn corner(&self) -> Option<usize> {
        self.controller().corner()
    }

    fn boxed_clone(&self) -> Box<dyn Controller> {
        Box::new(self.clone())
    }
}
