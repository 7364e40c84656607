//! Steps of the simulator per second.

#![allow(missing_docs, reason = "the macros make functions without any")]

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use robovac_app::bench::opening_run;
use robovac_core::{
    coverage::ReachableFloor,
    floor_plan::{FloorPlan, Object, Who, room},
    geometry::{Point, Pose},
    registry::Params,
    robot::model,
};
use robovac_sim::{
    Conditions, Noise, NoiseLevel, Run, RunSetup, SlipLevel, World,
    controller::{self, Setup},
};
use std::{sync::Arc, time::Duration};

/// Steps from the start: five minutes of robot time, with straight pieces, turns and furniture.
const STEPS: u32 = 20_000;

fn simulator(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("simulator");
    group.throughput(Throughput::Elements(u64::from(STEPS))).measurement_time(Duration::from_secs(3));
    let Some(flat) = room("flat").map(|info| (info.build)()) else { return };
    let noisy = |level| Conditions { noise: Noise::all(level), ..Conditions::default() };
    let slipping = Conditions { slip: SlipLevel::Typical, ..Conditions::default() };
    let cases = vec![
        ("in the furnished flat", opening_run()),
        ("there by the bumper alone", bouncing(&flat, "roomba600", noisy(NoiseLevel::Off)).map(Run::without_sight)),
        ("there by the sensors", bouncing(&flat, "roomba600", noisy(NoiseLevel::Off))),
        ("there by sensors with typical noise", bouncing(&flat, "roomba600", noisy(NoiseLevel::Typical))),
        ("there by sensors with harsh noise", bouncing(&flat, "roomba600", noisy(NoiseLevel::Harsh))),
        ("among objects and movers", bouncing(&lively(flat.clone()), "roomba600", slipping)),
        ("the same with an octagonal body", bouncing(&lively(flat.clone()), "octagon", slipping)),
    ];
    for (name, start) in cases {
        let Some(start) = start else { continue };
        let simulate = |mut run: Run| {
            for _ in 0..STEPS {
                run.step();
            }
            run
        };
        group.bench_function(format!("{STEPS} steps {name}"), |b| {
            b.iter_batched(|| start.clone(), simulate, BatchSize::LargeInput);
        });
    }
    group.finish();
}

/// A robot that bounces about: far more contact than planned paths have.
fn bouncing(plan: &FloorPlan, id: &str, conditions: Conditions) -> Option<Run> {
    let robot = model(id)?.clone();
    let start = plan.start.map(|start| Pose { heading: 0.7, ..start });
    let floor = Arc::new(ReachableFloor::new(plan, &robot, start).ok()?);
    let info = controller::find("bounce")?;
    let params = Params::defaults(info.params);
    let behaviour = info.build(&Setup { robot: &robot, params: &params, seed: 1 })?;
    let world = Arc::new(World::new(plan));
    Some(Run::new(&RunSetup { floor, world, robot, conditions, seed: 1 }, behaviour))
}

/// The room with everything in it that can lie, stand and move there.
fn lively(mut plan: FloorPlan) -> FloorPlan {
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
    plan
}

criterion_group!(benches, simulator);
criterion_main!(benches);
