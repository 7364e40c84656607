//! How close `near_optimal` comes to the best possible, and how soon: `cargo run --release --example near_optimal_table -- [SECONDS [SEED [WORD...]]]`
//! on the benchmark rooms in `../shared/maps` whose names contain a word, where they exist: steps + 2 x quarter turns of open walks in `grids`, steps + 50 x
//! quarter turns of closed tours in `turncost`. Its effort is the largest, and it's stopped after that many seconds (10): on
//! Linux, seconds of processor time, as other programs may run.

mod processor_clock;

use coverage_planners::{CoverageJob, CoveragePath, Objective, PlanContext, PlanError, ProgressReport, Proof, find};
use processor_clock::Clock;
use robovac_core::{
    grid::{Cell, Direction, from_picture},
    registry::{ParamValue, Params},
};
use std::{error::Error, fs, ops::ControlFlow, path::Path};

/// A room, and the best known value in its header, if any.
fn read(path: &Path) -> Result<(CoverageJob, Option<f64>), Box<dyn Error>> {
    let text = fs::read_to_string(path)?;
    let picture: Vec<&str> = text.lines().filter(|line| !line.starts_with(';')).collect();
    let glyphs = from_picture(&picture.join("\n"), |glyph| glyph).ok_or("no rectangle")?;
    let free = glyphs.map(|&glyph| glyph != '#');
    let marked = glyphs.iter().find(|&(_, &glyph)| glyph == 'S');
    let (start, _) = marked.or_else(|| glyphs.iter().find(|&(_, &glyph)| glyph != '#')).ok_or("no free cell")?;
    let number = |name: &str| text.split(name).nth(1)?.split_whitespace().next()?.parse().ok();
    let known = number("best_ip ");
    Ok((CoverageJob::new(&free, start, Direction::Right).ok_or("the start isn't free")?, known))
}

fn main() -> Result<(), Box<dyn Error>> {
    let seconds: f64 = std::env::args().nth(1).map_or(Ok(10.0), |text| text.parse())?;
    let seed: u64 = std::env::args().nth(2).map_or(Ok(0), |text| text.parse())?;
    let words: Vec<String> = std::env::args().skip(3).collect();
    let info = find("near_optimal").ok_or("not in the registry")?;
    println!(
        "| room | cells | first walk | after, s | best walk | our bound | gap | best known | gap to best known | found after, s |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    for (folder, is_closed) in [("grids", false), ("turncost", true)] {
        let Ok(entries) = fs::read_dir(Path::new("../shared/maps").join(folder)) else { continue };
        let mut paths: Vec<_> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
        paths.sort();
        for path in paths {
            let name = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
            if !words.is_empty() && !words.iter().any(|word| name.contains(word)) {
                continue;
            }
            let (job, known) = read(&path)?;
            let objective = if is_closed { Objective::closed(1, 50) } else { Objective::open(1, 2) };
            let mut params = Params::defaults(info.params);
            params.set(info.params, "effort", ParamValue::Number(100.0))?;
            params.set(info.params, "turn", ParamValue::Number(f64::from(objective.turn)))?;
            params.set(
                info.params,
                "finish",
                ParamValue::Choice(if is_closed { "start" } else { "anywhere" }.into()),
            )?;
            let clock = Clock::start();
            let (mut first, mut best) = (None, Best { walk: Vec::new(), proof: None, cost: u64::MAX, after: 0.0 });
            let mut observe = |report: ProgressReport<'_>| {
                let now = clock.seconds();
                let is_whole = !is_closed || report.walk.first() == report.walk.last();
                if is_whole && (first.is_some() || missed(&job, report.walk) == 0) {
                    best.take(&job, objective, report.walk, now);
                    best.proof = report.proof;
                    first.get_or_insert((best.cost, now));
                }
                if now < seconds { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
            };
            let mut ctx = PlanContext::observed(seed, &mut observe);
            let result = info.build(&params).plan(&job, &mut ctx);
            let proof = ctx.proof;
            match result {
                Ok(path) => {
                    best.take(&job, objective, &path.cells, clock.seconds());
                    best.proof = proof;
                }
                Err(PlanError::Cancelled) => {}
                Err(error) => return Err(error.into()),
            }
            best.check(&job)?;
            // Walks are priced in sixteenths of a step.
            let bound = best.proof.map_or(0, |proof| proof.bound).div_ceil(16);
            let above = |low: f64| 100.0 * (best.cost as f64 / low - 1.0);
            let (value, over) = known.map_or((String::new(), String::new()), |value: f64| {
                (value.to_string(), format!("{:.2} %", above(value)))
            });
            let (start, after) = first.unwrap_or((0, 0.0));
            println!(
                "| {name} | {} | {start} | {after:.2} | {} | {bound} | {:.2} % | {value} | {over} | {:.1} |",
                job.cells(),
                best.cost,
                above(bound as f64),
                best.after
            );
        }
    }
    Ok(())
}

/// The best walk so far.
struct Best {
    walk: Vec<Cell>,
    proof: Option<Proof>,
    cost: u64,
    /// Time at which it was found, s.
    after: f64,
}

impl Best {
    fn take(&mut self, job: &CoverageJob, objective: Objective, walk: &[Cell], now: f64) {
        let cost = objective.of_walk(job, walk);
        if cost < self.cost {
            *self = Self { walk: walk.to_vec(), proof: self.proof, cost, after: now };
        }
    }

    /// Checks that it's a walk over all cells.
    fn check(&self, job: &CoverageJob) -> Result<(), Box<dyn Error>> {
        CoveragePath::walk(self.walk.clone()).check(job)?;
        let missed = missed(job, &self.walk);
        if missed > 0 { Err(format!("{missed} cells are missed").into()) } else { Ok(()) }
    }
}

/// How many cells a walk misses.
fn missed(job: &CoverageJob, walk: &[Cell]) -> usize {
    let mut left = job.free.clone();
    for &cell in walk {
        left[cell] = false;
    }
    left.count()
}
