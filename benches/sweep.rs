//! The obstacle map and the sweeping planner of 001.

#![allow(missing_docs, reason = "the macros make functions without any")]

use coverage_planners::sweep::{SweepSetup, sweep};
use criterion::{Criterion, criterion_group, criterion_main};
use robovac_core::{
    cspace::{ConfigurationSpace, Outline},
    floor_plan::{FloorPlan, Sketch, room},
    robot::model,
};
use std::{hint::black_box, ops::ControlFlow, time::Duration};

/// A floor of 100 x 75 m in cells of 2.5 cm, 4000 x 3000: corridors every 12 m, rooms of 5 x 5 m with doors of 1 m,
/// in each a desk, a shelf and a column.
fn office() -> FloorPlan {
    let mut sketch = Sketch::open(100.0, 75.0, 0.025);
    for band in 0..6 {
        let bottom = 12.0 * f64::from(band);
        for column in 0..20 {
            let left = 5.0 * f64::from(column);
            for (low, door) in [(bottom, bottom + 4.9), (bottom + 7.0, bottom + 6.9)] {
                sketch = sketch
                    .fill(&[[left, low, left + 0.1, low + 5.0], [left, door, left + 5.0, door + 0.1]])
                    .carve(&[[left + 2.0, door, left + 3.0, door + 0.1]])
                    .fill(&[
                        [left + 0.8, low + 2.8, left + 2.4, low + 3.6],
                        [left + 3.4, low + 0.9, left + 4.9, low + 1.3],
                    ])
                    .fill(&[[left + 3.6, low + 2.7, left + 3.9, low + 3.0]]);
            }
        }
    }
    sketch.finish("Office", "")
}

fn setup(outline: Outline, cell: f64) -> SweepSetup {
    SweepSetup::new(outline, cell)
}

fn sweeps(criterion: &mut Criterion) {
    let Some(hall) = room("hall20").map(|info| (info.build)()) else { return };
    let (Some(octagon), Some(roomba)) = (model("octagon"), model("roomba600")) else { return };
    let octagon = Outline::of(octagon);
    let mut group = criterion.benchmark_group("sweep");
    group.sample_size(10).measurement_time(Duration::from_secs(3));
    for (name, plan, setup) in [
        ("paper's case, 20 m x 20 m, cells of 0.1 m", &hall, setup(octagon.clone(), 0.1)),
        ("paper's case, 20 m x 20 m, cells of 0.05 m", &hall, setup(octagon.clone(), 0.05)),
        ("office of 4000 x 3000 cells", &office(), setup(octagon.clone(), 0.025)),
        ("office of 4000 x 3000 cells, Roomba", &office(), setup(Outline::of(roomba), 0.025)),
    ] {
        group.bench_function(name, |b| b.iter(|| sweep(black_box(plan), &setup, &mut |_| ControlFlow::Continue(()))));
    }
    group.finish();
    let mut group = criterion.benchmark_group("configuration space, 1000 x 1000 x 72");
    group.sample_size(10).measurement_time(Duration::from_secs(3));
    for (name, outline) in [("octagon", octagon), ("circle", Outline::of(roomba))] {
        group.bench_function(name, |b| b.iter(|| ConfigurationSpace::new(black_box(&hall), &outline, 0.02, 72)));
    }
    group.finish();
}

criterion_group!(benches, sweeps);
criterion_main!(benches);
