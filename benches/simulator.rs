//! How many steps a second the simulator makes.

#![allow(missing_docs, reason = "the macros make functions without any")]

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use robovac_playground::{
    app::bench::opening_run,
    controller::{self, Setup},
    coverage::ReachableFloor,
    floorplan::{FloorPlan, Object, Who, room},
    geometry::{Point, Pose},
    registry::Params,
    robot::model,
    sim::{Conditions, Noise, NoiseLevel, Run, RunSetup, SlipLevel, World},
};
use std::{sync::Arc, time::Duration};

/// Steps from the start: five minutes of robot time, with straight pieces, turns and furniture.
const STEPS: u32 = 20_000;

/// The furnished flat with everything that can lie, stand and move in it, and a robot that bounces about: far more contact
/// than planned paths have.
fn lively_run(id: &str) -> Option<Run> {
    let mut plan = (room("flat")?.build)();
    let (width, height) = (plan.width_m(), plan.height_m());
    let at = |x: f64, y: f64| Point::new(x * width, y * height);
    for (x, y) in [(0.2, 0.2), (0.26, 0.2), (0.2, 0.3), (0.26, 0.3), (0.6, 0.7), (0.7, 0.4)] {
        plan.objects.push(Object::Leg { at: at(x, y), radius: 0.015 });
    }
    plan.objects.push(Object::Furniture { outline: vec![at(0.4, 0.4), at(0.5, 0.42), at(0.46, 0.5)] });
    plan.objects.push(Object::Carpet { outline: vec![at(0.1, 0.1), at(0.4, 0.1), at(0.4, 0.4), at(0.1, 0.4)] });
    plan.objects.push(Object::Dirt { at: at(0.3, 0.6), radius: 0.4 });
    plan.objects.push(Object::Mover { who: Who::Person, path: vec![at(0.15, 0.5), at(0.85, 0.5)] });
    plan.objects.push(Object::Mover { who: Who::Pet, path: vec![at(0.2, 0.8), at(0.8, 0.2)] });
    let robot = model(id)?.clone();
    let floor = Arc::new(ReachableFloor::new(&plan, &robot, plan.start.map(|s| Pose { heading: 0.7, ..s })).ok()?);
    let behaviour = controller::find("bounce")?;
    let params = Params::defaults(behaviour.params);
    let controller = behaviour.build(&Setup { robot: &robot, params: &params, seed: 1 })?;
    let conditions = Conditions { slip: SlipLevel::Typical, ..Conditions::default() };
    Some(Run::new(&RunSetup { floor, world: Arc::new(World::new(&plan)), robot, conditions, seed: 1 }, controller))
}

fn simulator(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("simulator");
    group.throughput(Throughput::Elements(u64::from(STEPS))).measurement_time(Duration::from_secs(3));
    let simulate = |mut run: Run| {
        for _ in 0..STEPS {
            run.step();
        }
        run
    };
    let cases = [
        ("in the furnished flat", opening_run()),
        ("bouncing there with objects and movers", lively_run("roomba600")),
        ("the same with an octagonal body", lively_run("octagon")),
    ];
    for (name, start) in cases {
        let Some(start) = start else { continue };
        group.bench_function(format!("{STEPS} steps {name}"), |b| {
            b.iter_batched(|| start.clone(), simulate, BatchSize::LargeInput);
        });
    }
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
