//! What it takes to make a map and to judge it.

#![allow(missing_docs, reason = "the macros make functions without any")]

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use robovac_playground::{
    controller::{self, Setup},
    coverage::ReachableFloor,
    floorplan::room,
    mapping::{Mapper, MapperSetup, RESOLUTION, Tracking, Truth},
    registry::Params,
    robot::{OdometryModel, Sensors, model},
    sim::{Conditions, Noise, NoiseLevel, Run, RunSetup, SlipLevel, World},
};
use std::{sync::Arc, time::Duration};

/// Readings of five minutes.
const READINGS: usize = 20_000;

/// What a robot reads that follows the walls of the furnished flat, and a mapper that is about to hear it.
fn drive() -> Option<(Vec<Sensors>, Mapper, Truth)> {
    let (plan, robot) = (room("flat").map(|info| (info.build)())?, model("roomba600")?.clone());
    let floor = Arc::new(ReachableFloor::new(&plan, &robot, None).ok()?);
    let info = controller::find("wall_follow")?;
    let params = Params::defaults(info.params);
    let behaviour = info.build(&Setup { robot: &robot, params: &params, seed: 1 })?;
    let noise = Noise::all(NoiseLevel::Typical);
    let conditions = Conditions { slip: SlipLevel::Typical, noise, ..Conditions::default() };
    let truth = Truth::of(&floor, RESOLUTION);
    let setup = MapperSetup {
        robot: robot.clone(),
        start: floor.start,
        tracking: Tracking::Corrected,
        odometry: OdometryModel::Arc,
        seed: 1,
    };
    let world = Arc::new(World::new(&plan));
    let mut run = Run::new(&RunSetup { floor, world, robot, conditions, seed: 1 }, behaviour);
    let readings = std::iter::repeat_with(|| {
        run.step();
        run.sensors().clone()
    });
    Some((readings.take(READINGS).collect(), Mapper::new(setup), truth))
}

fn mapping(criterion: &mut Criterion) {
    let Some((readings, mapper, truth)) = drive() else { return };
    let mut group = criterion.benchmark_group("mapping");
    group.measurement_time(Duration::from_secs(3));
    let map = |mut mapper: Mapper| {
        for sensed in &readings {
            mapper.update(sensed);
        }
        mapper
    };
    group.throughput(Throughput::Elements(READINGS as u64));
    group.bench_function(format!("{READINGS} readings in the furnished flat"), |b| {
        b.iter_batched(|| mapper.clone(), map, BatchSize::LargeInput);
    });
    let done = map(mapper.clone());
    group.throughput(Throughput::Elements(1));
    group.bench_function("quality of that map", |b| b.iter(|| truth.quality(done.map())));
    group.bench_function("a copy of the mapper", |b| b.iter(|| done.clone()));
    group.finish();
}

criterion_group!(benches, mapping);
criterion_main!(benches);
