//! Near-optimal.

mod frontier;
mod region;
mod tour;
mod ways;

use super::{
    Build, Claims, CoverageJob, CoveragePath, Example, Explainer, Finish, Objective, ParamKind, ParamSpec, PlanContext, PlanError,
    Planner, PlannerInfo, Proof, Relaxation,
    stage::Costs,
};
use crate::{grid::{Cell, Direction, Grid}, planner::Params, rng::{Rng, seeded}};
use frontier::Search;
use region::{Ground, Region, Window};
use tour::Tour;
use ways::Ways;
use rand::RngExt;

#[doc(hidden)]
pub fn experiment(job: &CoverageJob, objective: Objective, walk: &[Cell], rounds: usize, mut say: impl FnMut(usize, u64, u64)) -> Vec<Cell> {
    let mut relaxation = Relaxation::new(job, objective);
    relaxation.improve(6_000_000.max(job.cells() * 400));
    let numbers = {
        let mut count = 0;
        job.free.map(|&free| { let n = if free { count } else { u32::MAX }; count += u32::from(free); n })
    };
    let cells: Vec<Cell> = job.free.iter().filter(|&(_, &f)| f).map(|(c, _)| c).collect();
    let is_closed = objective.finish == Finish::Start;
    let mut list: Vec<u32> = walk.iter().map(|&c| numbers[c]).collect();
    if is_closed { list.pop(); }
    let mut tour = Tour::new(&relaxation.graph, list, is_closed);
    let ways = Ways::new(2);
    let mut rng = seeded(1, 0);
    let mut site_of = vec![u32::MAX; cells.len()];
    let ground = Ground { graph: &relaxation.graph, prices: &relaxation.prices, numbers: &numbers, heading: job.heading as usize, counts_first_turn: objective.counts_first_turn };
    let costs = (relaxation.prices.step, relaxation.prices.turn);
    let unit = i64::from(relaxation.prices.unit);
    let mut cost = objective.of_walk(job, walk) as i64 * unit;
    say(0, cost as u64 / unit as u64, relaxation.bound());
    let side_x: usize = std::env::var("W").ok().and_then(|s| s.parse().ok()).unwrap_or(8);
    let side_y: usize = std::env::var("H").ok().and_then(|s| s.parse().ok()).unwrap_or(8);
    let most: usize = std::env::var("S").ok().and_then(|s| s.parse().ok()).unwrap_or(1000);
    let noise: f64 = std::env::var("N").ok().and_then(|s| s.parse().ok()).unwrap_or(0.0);
    let mut best = (cost, tour.cells.clone());
    for round in 1..=rounds {
        let center = cells[rng.random_range(0..cells.len())];
        let (w, h) = if rng.random() { (side_x, side_y) } else { (side_y, side_x) };
        let window = Window { corner: Cell::new(center.x - w as i32 / 2, center.y - h as i32 / 2), width: w, height: h };
        if let Some(region) = Region::new(&ground, &tour, window, &mut site_of) {
            let amplitude = (noise * unit as f64 * (1.0 - round as f64 / rounds as f64)) as i32;
            let limit = region.cost + if amplitude > 0 { unit * 4 } else { 0 };
            let found = region.search(costs, &ways, Search { limit, most_states: most, noise: (amplitude > 0).then_some((amplitude, &mut rng)) });
            if !found.ways.is_empty() {
                if let Some(new) = region.walk(&tour, &found.ways) {
                    tour.replace(new);
                    cost += found.cost - region.cost;
                    if cost < best.0 { best = (cost, tour.cells.clone()); }
                } else { say(usize::MAX, 0, 0); }
            }
        }
        if round % 1000 == 0 { say(round, cost as u64 / unit as u64, best.0 as u64 / unit as u64); }
    }
    let mut walk: Vec<Cell> = best.1.iter().map(|&n| cells[n as usize]).collect();
    if is_closed {
        let at = walk.iter().position(|&c| c == job.start).unwrap_or(0);
        walk.rotate_left(at);
        walk.push(job.start);
    }
    walk
}
