//! Changes in the world during a run: movers and dirt.

use super::{STEP_S, World, dirt::Spot, mover::Mover};
use robovac_core::{
    coverage::ReachableFloor,
    geometry::{Point, Pose},
    rng::seeded,
    robot::RobotModel,
};

/// Stream of the random numbers.
const STREAM: u64 = 5;

/// The changing part of a world: where its movers are and which dirt is left.
#[derive(Debug, Clone, Default)]
pub struct Life {
    movers: Vec<Mover>,
    /// Where the movers are, and their radii, m.
    discs: Vec<(Point, f64)>,
    spots: Vec<Spot>,
    /// All the dirt that there was, and what is left of it, m² of a spot.
    dirt: [f64; 2],
}

impl Life {
    /// The world when the run begins; `seed` decides over everything random. Movers that would stand where the robot starts
    /// begin elsewhere.
    pub fn new(world: &World, floor: &ReachableFloor, seed: u64) -> Self {
        let mut rng = seeded(seed, STREAM);
        let spots: Vec<Spot> = world
            .dirt
            .iter()
            .map(|&(centre, radius)| {
                Spot::new(centre, radius, floor.resolution, &mut rng, |p| !floor.limits().contains(p))
            })
            .collect();
        let dirt = spots.iter().map(Spot::amount).sum();
        let (start, radius) = (floor.start.position(), floor.walls.body_radius);
        let movers: Vec<Mover> = world
            .movers
            .iter()
            .enumerate()
            .map(|(number, (who, path))| {
                Mover::new(*who, path, seeded(seed, STREAM + ((number as u64 + 1) << 8)), start, radius)
            })
            .collect();
        let discs = movers.iter().map(Mover::disc).collect();
        Self { movers, discs, spots, dirt: [dirt; 2] }
    }

    /// Lets one step of simulation pass. `is_taken` says whether a disc would touch the robot: nobody walks into it.
    pub fn step(&mut self, world: &World, mut is_taken: impl FnMut(Point, f64) -> bool) {
        for ((mover, disc), (_, path)) in self.movers.iter_mut().zip(&mut self.discs).zip(&world.movers) {
            mover.step(path, STEP_S, &mut is_taken);
            *disc = mover.disc();
        }
    }

    /// Where the movers are, and their radii, m; in the order of [`World::movers`].
    #[inline]
    pub fn movers(&self) -> &[(Point, f64)] {
        &self.discs
    }

    /// Picks up what lies under the tool and within reach of the side brushes of a robot at `pose`, in one step: as much as
    /// lies on so many m² of a spot.
    #[inline]
    pub fn sweep(&mut self, robot: &RobotModel, pose: Pose) -> f64 {
        let mut picked = 0.0;
        for spot in &mut self.spots {
            if spot.is_near(pose.position(), robot.radius + 0.1) {
                picked += spot.sweep(robot, pose);
            }
        }
        self.dirt[1] -= picked;
        picked
    }

    /// Share of the dirt that is left, 0 to 1; 0 where there was none.
    pub fn dirt_left(&self) -> f64 {
        if self.dirt[0] > 0.0 { (self.dirt[1] / self.dirt[0]).clamp(0.0, 1.0) } else { 0.0 }
    }

    /// The spots of dirt, with what is left of them.
    pub fn spots(&self) -> &[Spot] {
        &self.spots
    }

    /// Bits that tell two states apart.
    pub(super) fn words(&self) -> impl Iterator<Item = u64> {
        let places = self.discs.iter().flat_map(|(at, _)| [at.x.to_bits(), at.y.to_bits()]);
        places.chain([self.dirt[1].to_bits()])
    }

    /// Roughly the memory that a clone takes, bytes.
    pub fn bytes(&self) -> usize {
        size_of::<Self>() + self.movers.len() * size_of::<Mover>() + self.spots.iter().map(Spot::bytes).sum::<usize>()
    }
}
