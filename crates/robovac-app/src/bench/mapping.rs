//! Benchmark of mapping with drift correction.

use super::Bench;
use robovac_core::{
    coverage::ReachableFloor,
    floor_plan::room,
    registry::Params,
    robot::{OdometryModel, SensorReadings, model},
};
use robovac_sim::{
    Conditions, Noise, NoiseLevel, Run, RunSetup, STEP_S, SlipLevel, World,
    controller::{self, Setup},
    mapping::{MapTruth, Mapper, MapperSetup, RESOLUTION, Tracking},
};
use std::{iter::repeat_with, sync::Arc};

/// Readings of five minutes.
const READINGS: usize = 20_000;

/// Recorded readings of a drive, and a mapper to process them.
pub struct MappingCase {
    /// Readings of a robot that follows the walls of the furnished flat, with typical slip and noise.
    pub readings: Vec<SensorReadings>,
    /// The mapper before the drive, with drift correction.
    pub mapper: Mapper,
    /// The true map of the flat.
    pub truth: MapTruth,
}

impl MappingCase {
    /// `None` if something is missing from a registry.
    pub fn new() -> Option<Self> {
        let (plan, robot) = (room("flat").map(|info| (info.build)())?, model("roomba600")?.clone());
        let floor = Arc::new(ReachableFloor::new(&plan, &robot, None).ok()?);
        let info = controller::find("wall_follow")?;
        let params = Params::defaults(info.params);
        let behaviour = info.build(&Setup { robot: &robot, params: &params, seed: 1 })?;
        let noise = Noise::all(NoiseLevel::Typical);
        let conditions = Conditions { slip: SlipLevel::Typical, noise, ..Conditions::default() };
        let truth = MapTruth::of(&floor, RESOLUTION);
        let mapper = Mapper::new(MapperSetup {
            robot: robot.clone(),
            start: floor.start,
            tracking: Tracking::Corrected,
            odometry: OdometryModel::Arc,
            seed: 1,
        });
        let world = Arc::new(World::new(&plan));
        let mut run = Run::new(&RunSetup { floor, world, robot, conditions, seed: 1 }, behaviour);
        let readings = repeat_with(|| {
            run.step();
            run.sensors().clone()
        });
        Some(Self { readings: readings.take(READINGS).collect(), mapper, truth })
    }

    /// The mapper after the drive.
    pub fn map(&self, mut mapper: Mapper) -> Mapper {
        for sensed in &self.readings {
            mapper.update(sensed);
        }
        mapper
    }
}

/// Five minutes of mapping with drift correction, without the simulation.
pub fn mapping(bench: &mut Bench<'_>) {
    let Some(case) = MappingCase::new() else { return };
    let mut map = || drop(case.map(case.mapper.clone()));
    bench.take("map the furnished flat, drift corrected", &mut map, Some(READINGS as f64 * STEP_S));
}
