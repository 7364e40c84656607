//! Near-optimal.

mod focus;
mod frontier;
mod improver;
mod linker;
mod region;
mod tour;
mod ways;

use super::{CoverageJob, Finish, Objective, Relaxation};
use crate::{grid::Cell, rng::seeded};
use improver::Improver;
use region::Ground;
use tour::Tour;

#[doc(hidden)]
pub fn experiment(
    job: &CoverageJob,
    objective: Objective,
    walk: &[Cell],
    rounds: usize,
    mut say: impl FnMut(&str, u64, u64, usize),
) -> Vec<Cell> {
    let env = |name: &str, or: f64| std::env::var(name).ok().and_then(|s| s.parse().ok()).unwrap_or(or);
    let mut relaxation = Relaxation::new(job, objective);
    relaxation.improve((job.cells() * env("R", 400.0) as usize).min(100_000_000));
    let numbers = {
        let mut count = 0;
        job.free.map(|&free| {
            let n = if free { count } else { u32::MAX };
            count += u32::from(free);
            n
        })
    };
    let cells: Vec<Cell> = job.free.iter().filter(|&(_, &f)| f).map(|(c, _)| c).collect();
    let is_closed = objective.finish == Finish::Start;
    let mut list: Vec<u32> = walk.iter().map(|&c| numbers[c]).collect();
    if is_closed {
        list.pop();
    }
    let tour = Tour::new(cells.len(), list, is_closed);
    let ground = Ground {
        graph: &relaxation.graph,
        prices: &relaxation.prices,
        numbers: &numbers,
        heading: job.heading as usize,
        counts_first_turn: objective.counts_first_turn,
    };
    let unit = u64::from(relaxation.prices.unit as u32);
    let cost = objective.of_walk(job, walk) * unit;
    let mut improver = Improver::new(ground, cells, tour, cost as i64, seeded(1, 0));
    say("relaxed", cost / unit, relaxation.bound(), 0);
    for (side, states) in [(6, 200), (8, 500), (10, 1000), (12, 1000)] {
        if side > env("TOP", 12.0) as usize {
            break;
        }
        improver.settle(side, states, |_, _| Ok::<(), ()>(())).unwrap();
        say("settled", improver.cost as u64 / unit, side as u64, improver.work);
    }
    for round in 0..rounds {
        improver.shake(env("N", 0.02), env("L", 10.0) as i32, env("S", 500.0) as usize);
        if round % (rounds / 10).max(1) == 0 {
            say("shaken", improver.cost as u64 / unit, round as u64, improver.work);
        }
    }
    improver.walk()
}
