//! How many steps a second the simulator makes.

#![allow(missing_docs, reason = "the macros make functions without any")]

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use robovac_playground::{
    app::bench::opening_run,
    controller::{self, Setup},
    coverage::ReachableFloor,
    floorplan::{FloorPlan, room},
    registry::Params,
    robot::model,
    sim::{Conditions, Noise, NoiseLevel, Run, RunSetup, World},
};
use std::{sync::Arc, time::Duration};

/// Steps from the start: five minutes of robot time, with straight pieces, turns and furniture.
const STEPS: u32 = 20_000;

fn simulator(criterion: &mut Criterion) {
    let Some(start) = opening_run() else { return };
    let mut group = criterion.benchmark_group("simulator");
    group.throughput(Throughput::Elements(u64::from(STEPS))).measurement_time(Duration::from_secs(3));
    let simulate = |mut run: Run| {
        for _ in 0..STEPS {
            run.step();
        }
        run
    };
    group.bench_function(format!("{STEPS} steps in the furnished flat"), |b| {
        b.iter_batched(|| start.clone(), simulate, BatchSize::LargeInput);
    });
    group.finish();
    all_sensors(criterion);
}

/// A Roomba that drives about by its sensors in the furnished flat, all of which err as good ones do.
fn all_sensors(criterion: &mut Criterion) {
    let Some(flat) = room("flat") else { return };
    let plan = (flat.build)();
    let mut group = criterion.benchmark_group("roomba_all_sensors");
    group.throughput(Throughput::Elements(u64::from(STEPS))).measurement_time(Duration::from_secs(3));
    for (level, name) in NoiseLevel::ALL {
        let Some(run) = bouncing(&plan, "roomba600", level) else { return };
        let simulate = |mut run: Run| {
            for _ in 0..STEPS {
                run.step();
            }
            run
        };
        group.bench_function(format!("roomba_all_sensors_{name}"), |b| {
            b.iter_batched(|| run.clone(), simulate, BatchSize::LargeInput);
        });
    }
    group.finish();
}

/// A robot that bounces through a room.
fn bouncing(plan: &FloorPlan, id: &str, level: NoiseLevel) -> Option<Run> {
    let robot = model(id)?.clone();
    let floor = Arc::new(ReachableFloor::new(plan, &robot, None).ok()?);
    let conditions = Conditions { noise: Noise::all(level), ..Conditions::default() };
    let info = controller::find("bounce")?;
    let params = Params::defaults(info.params);
    let behaviour = info.build(&Setup { robot: &robot, params: &params, seed: 1 })?;
    let world = Arc::new(World::new(plan));
    Some(Run::new(&RunSetup { floor, world, robot, conditions, seed: 1 }, behaviour))
}

criterion_group!(benches, simulator);
criterion_main!(benches);
