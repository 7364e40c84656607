//! Lower bounds over time.

#![allow(missing_docs, reason = "the macros make functions without any")]

use coverage_planners::{Bounds, CoverageJob, Objective, Relaxation};
use criterion::{Criterion, criterion_group, criterion_main};
use robovac_app::bench::hall;
use robovac_core::grid::{Cell, Direction, from_picture};
use std::{
    fs,
    hint::black_box,
    path::{Path, PathBuf},
    time::{Duration, Instant},
};

/// Seconds at which the bounds of the shared rooms are reported.
const TIMES: [f64; 5] = [0.2, 1.0, 3.0, 10.0, 30.0];
/// Work between two checks of the clock, in cells.
const CELLS: usize = 200_000;

fn at_once(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("bounds at once");
    group.sample_size(10).measurement_time(Duration::from_secs(3));
    for side in [100, 1000] {
        let Some(job) = hall(side) else { continue };
        group.bench_function(format!("hall {side} x {side}"), |b| b.iter(|| Bounds::of(black_box(&job))));
    }
}

/// One pass over the cells by each of the two methods for whole rooms.
fn work(criterion: &mut Criterion) {
    let Some(job) = hall(100) else { return };
    let mut group = criterion.benchmark_group("work at a bound, hall 100 x 100");
    group.sample_size(10).measurement_time(Duration::from_secs(3));
    for rounds in [100, 800] {
        group.bench_function(format!("{rounds} rounds"), |b| {
            b.iter(|| {
                let mut relaxation = Relaxation::new(black_box(&job), Objective::open(1, 2));
                (0..rounds).for_each(|_| _ = relaxation.improve(job.cells()));
                relaxation.bound()
            });
        });
    }
}

/// Prints what is reached in the shared rooms, where they are: grids by open walks of steps + 2 x quarter turns, those of
/// turn costs by closed tours of steps + 50 x quarter turns.
fn reached(_: &mut Criterion) {
    // Tests run benchmarks too, once, and have no minutes for this.
    if !std::env::args().any(|argument| argument == "--bench") {
        return;
    }
    println!("bounds after {TIMES:?} s");
    for (folder, objective) in [("grids", Objective::open(1, 2)), ("turncost", Objective::closed(1, 50))] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/maps").join(folder);
        let mut files: Vec<PathBuf> =
            fs::read_dir(folder).into_iter().flatten().filter_map(|entry| Some(entry.ok()?.path())).collect();
        files.sort();
        for file in files {
            let Some(job) = job(&file) else { continue };
            let begun = Instant::now();
            let mut relaxation = Relaxation::new(&job, objective);
            let mut goes_on = true;
            let bounds = TIMES.map(|time| {
                while goes_on && begun.elapsed().as_secs_f64() < time {
                    goes_on = relaxation.improve(CELLS);
                }
                format!("{:>7}", relaxation.bound())
            });
            let name = file.file_stem().unwrap_or_default().to_string_lossy();
            println!("{name:>32} {:>7} cells {}", job.cells(), bounds.join(" "));
        }
    }
}

fn job(file: &Path) -> Option<CoverageJob> {
    let text = fs::read_to_string(file).ok()?;
    let rows: Vec<&str> = text.lines().filter(|line| !line.starts_with(';') && !line.is_empty()).collect();
    let glyphs = from_picture(&rows.join("\n"), |c| c)?;
    let start = glyphs.iter().find(|&(_, &c)| c == 'S').or_else(|| glyphs.iter().find(|&(_, &c)| c != '#'));
    let start: Cell = start?.0;
    CoverageJob::new(&glyphs.map(|&c| c != '#'), start, Direction::Right)
}

criterion_group!(benches, at_once, work, reached);
criterion_main!(benches);
