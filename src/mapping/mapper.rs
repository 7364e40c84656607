//! What makes the map and keeps track of the robot on it.

use super::{Mark, Marks, OccupancyMap, Spread};
use crate::{
    geometry::{Point, Pose},
    robot::{Odometry, OdometryModel, RobotModel, Sensors},
};

/// Side of the map's cells, m (ours: half of the thesis', which are as wide as a shoe).
pub const RESOLUTION: f64 = 0.05;

/// How a mapper keeps track of the robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Tracking {
    /// By wheel counts alone.
    Odometry,
    /// By wheel counts, corrected by what bumper and light bumper meet.
    #[default]
    Corrected,
}

impl Tracking {
    /// All ways, with their names in links and on the command line.
    pub const ALL: [(Self, &'static str); 2] = [(Self::Odometry, "odometry"), (Self::Corrected, "corrected")];

    /// The way of that name.
    pub fn parse(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(_, n)| *n == name).map(|(way, _)| way)
    }

    /// Name in links and on the command line.
    pub fn id(self) -> &'static str {
        Self::ALL[self as usize].1
    }
}

/// What a mapper is made from.
#[derive(Debug, Clone)]
pub struct MapperSetup {
    /// The robot that carries it.
    pub robot: RobotModel,
    /// Where it stands, in the frame that the map is to have.
    pub start: Pose,
    /// How it keeps track.
    pub tracking: Tracking,
    /// How wheel counts become motion.
    pub odometry: OdometryModel,
    /// Seed of its random numbers.
    pub seed: u64,
}

/// Makes a map of what a robot meets, and keeps track of the robot on it.
#[derive(Debug, Clone)]
pub struct Mapper {
    setup: MapperSetup,
    odometry: Odometry,
    map: OccupancyMap,
    marks: Marks,
}

impl Mapper {
    /// Nothing known but where it starts.
    pub fn new(setup: MapperSetup) -> Self {
        let odometry = Odometry::new(&setup.robot, setup.odometry, setup.start);
        Self { odometry, map: OccupancyMap::new(RESOLUTION), marks: Marks::new(RESOLUTION), setup }
    }

    /// Takes the next reading.
    pub fn update(&mut self, sensed: &Sensors) {
        self.odometry.update(sensed);
        let pose = self.odometry.pose();
        let radius = self.setup.robot.radius;
        // The floor that the body covers is free.
        let reach = (radius / RESOLUTION).ceil() as i32;
        let middle = self.map.cell_at(pose.position());
        for y in middle.y - reach..=middle.y + reach {
            for x in middle.x - reach..=middle.x + reach {
                let cell = crate::grid::Cell::new(x, y);
                if (self.map.centre(cell) - pose.position()).norm() < radius {
                    self.map.add(cell, -0.3);
                }
            }
        }
        if sensed.bumped() {
            let aside = 0.6 * (f64::from(sensed.bump_left) - f64::from(sensed.bump_right));
            let (sin, cos) = crate::math::sin_cos(aside);
            let contact = pose.to_world(Point::new((radius + 0.02) * cos, (radius + 0.02) * sin));
            self.map.add(self.map.cell_at(contact), 1.5);
        }
        self.marks.note(pose.position(), 0.5 * self.setup.robot.tool_width, Mark::Cleaned);
        if sensed.dirt > 0 {
            self.marks.note(pose.position(), 0.5 * self.setup.robot.tool_width, Mark::Dirty);
        }
    }

    /// What it is made from.
    pub fn setup(&self) -> &MapperSetup {
        &self.setup
    }

    /// Where it believes to be.
    pub fn pose(&self) -> Pose {
        self.odometry.pose()
    }

    /// How sure it is of that.
    pub fn spread(&self) -> Spread {
        Spread::default()
    }

    /// Poses that it holds possible, with their weights, which add up to 1.
    pub fn particles(&self) -> Vec<(Pose, f64)> {
        vec![(self.pose(), 1.0)]
    }

    /// The map so far.
    pub fn map(&self) -> &OccupancyMap {
        &self.map
    }

    /// What was cleaned, and where dirt was found.
    pub fn marks(&self) -> &Marks {
        &self.marks
    }

    /// Roughly the memory that it takes, bytes.
    pub fn bytes(&self) -> usize {
        self.map.bytes() + self.marks.bytes()
    }
}
