//! Parameters of a mapper.

use robovac_core::{
    geometry::Pose,
    robot::{OdometryModel, RobotModel},
};

/// How a mapper tracks the robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Tracking {
    /// By wheel counts alone.
    Odometry,
    /// By wheel counts, corrected by contacts and the light bumper.
    #[default]
    Corrected,
}

impl Tracking {
    /// All kinds, with their names in links and on the command line.
    pub const ALL: [(Self, &'static str); 2] = [(Self::Odometry, "odometry"), (Self::Corrected, "corrected")];

    /// The kind of that name.
    pub fn parse(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(_, n)| *n == name).map(|(way, _)| way)
    }

    /// Name in links and on the command line.
    pub fn id(self) -> &'static str {
        Self::ALL[self as usize].1
    }
}

/// Parameters of a mapper.
#[derive(Debug, Clone)]
pub struct MapperSetup {
    /// The robot.
    pub robot: RobotModel,
    /// Its start, in the frame that the map is to have.
    pub start: Pose,
    /// How it tracks the robot.
    pub tracking: Tracking,
    /// How wheel counts are converted to motion.
    pub odometry: OdometryModel,
    /// Seed of its random numbers.
    pub seed: u64,
}
