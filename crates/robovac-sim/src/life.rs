//! Changes in the world during a run: movers and dirt.

use super::{RandomStream, STEP_S, World, dirt::Spot, mover::Mover};
use robovac_core::{
    coverage::ReachableFloor,
    geometry::{Point, Pose},
    robot::RobotModel,
};

/// The changing part of a world: positions of movers, and remaining dirt.
#[derive(Debug, Clone, Default)]
pub struct Life {
    movers: Vec<Mover>,
    /// Positions and radii of the movers, m.
    discs: Vec<(Point, f64)>,
    spots: Vec<Spot>,
    /// Initial and remaining dirt, m² of a spot.
    dirt: [f64; 2],
}

impl Life {
    /// The world at the start of a run; `seed` determines everything random. Movers that would stand at the robot's
    /// start begin elsewhere.
    pub fn new(world: &World, floor: &ReachableFloor, seed: u64) -> Self {
        let mut rng = RandomStream::Life.seeded(seed);
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
                Mover::new(*who, path, RandomStream::Life.seeded_for(number, seed), start, radius)
            })
            .collect();
        let discs = movers.iter().map(Mover::disc).collect();
        Self { movers, discs, spots, dirt: [dirt; 2] }
    }

    /// The same with the dirt that was left in `earlier`, where a spot is as it was.
    pub fn after(world: &World, floor: &ReachableFloor, seed: u64, earlier: &Self) -> Self {
        let mut life = Self::new(world, floor, seed);
        life.take_over(earlier);
        life
    }

    /// Advances by one simulation step. `is_taken` returns whether a disc would touch the robot, which movers avoid.
    pub(crate) fn step(&mut self, world: &World, mut is_taken: impl FnMut(Point, f64) -> bool) {
        for ((mover, disc), (_, path)) in self.movers.iter_mut().zip(&mut self.discs).zip(&world.movers) {
            mover.step(path, STEP_S, &mut is_taken);
            *disc = mover.disc();
        }
    }

    /// Positions and radii of the movers, m; in the order of [`World::movers`].
    #[inline]
    pub fn movers(&self) -> &[(Point, f64)] {
        &self.discs
    }

    /// Picks up the dirt under the tool and the side brushes of a robot at `pose`, in one step; returns the amount in
    /// m² of a spot.
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

    /// Remaining share of the dirt, 0 to 1; 0 if there was none.
    pub fn dirt_left(&self) -> f64 {
        if self.dirt[0] > 0.0 { (self.dirt[1] / self.dirt[0]).clamp(0.0, 1.0) } else { 0.0 }
    }

    /// Takes over what is left of spots that were there before.
    pub(crate) fn take_over(&mut self, earlier: &Self) {
        for spot in &mut self.spots {
            let is_it = |old: &&Spot| (old.centre, old.radius) == (spot.centre, spot.radius);
            if let Some(old) = earlier.spots.iter().find(is_it) {
                spot.clone_from(old);
            }
        }
        self.dirt[1] = self.spots.iter().map(Spot::amount).sum();
    }

    /// The spots of dirt, with their remaining amounts.
    pub fn spots(&self) -> &[Spot] {
        &self.spots
    }

    /// Bits of the state, for the digest.
    pub(super) fn words(&self) -> impl Iterator<Item = u64> {
        let places = self.discs.iter().flat_map(|(at, _)| [at.x.to_bits(), at.y.to_bits()]);
        places.chain([self.dirt[1].to_bits()])
    }

    /// Approximate memory of a clone, bytes.
    pub fn bytes(&self) -> usize {
        size_of::<Self>() + self.movers.len() * size_of::<Mover>() + self.spots.iter().map(Spot::bytes).sum::<usize>()
    }
}
