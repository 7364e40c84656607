//! Stage: shortcuts past cells that the walk cleans at another time anyway.

use super::{
    cost::Costs,
    transit::{Transit, TransitEnd},
};
use crate::{CoverageJob, PlanError};
use robovac_core::grid::{Cell, Direction, Grid};

/// Replaces stretches of `walk` whose cells it visits elsewhere too by cheaper ways; covers what it covered before.
///
/// A stretch begins where the one before ended, so one call is a single pass in O(length) searches of the way between
/// two cells; another call may find more. Returns whether anything changed. `report` receives the share of the walk
/// that is done every two thousand cells.
pub fn shortcut(
    job: &CoverageJob,
    costs: Costs,
    transit: &mut Transit,
    walk: &mut Vec<Cell>,
    mut report: impl FnMut(f64) -> Result<(), PlanError>,
) -> Result<bool, PlanError> {
    let mut visits = Grid::filled(job.free.width(), job.free.height(), 0_u32);
    for &cell in walk.iter() {
        visits[cell] += 1;
    }
    let mut result = Vec::with_capacity(walk.len());
    result.push(walk[0]);
    let mut start = 0;
    let mut way = Vec::new();
    let mut next_report = 0;
    while start + 1 < walk.len() {
        if start >= next_report {
            report(start as f64 / walk.len() as f64)?;
            next_report = start + REPORT_EVERY;
        }
        let mut end = start + 1;
        if visits[walk[end]] == 1 {
            // Most cells are visited only once and stay.
            result.push(walk[end]);
            start = end;
            continue;
        }
        // The stretch: as many cells after `start` as can be dropped.
        while end < walk.len() && visits[walk[end]] > 1 {
            visits[walk[end]] -= 1;
            end += 1;
        }
        if end == walk.len() {
            // The rest has been visited: the walk ends here.
            break;
        }
        let kept = &walk[start..=end];
        way.clear();
        if end > start + 1 && shorten(job, costs, transit, &result, kept, walk.get(end + 1), &mut way) {
            for &cell in &way {
                visits[cell] += 1;
            }
            visits[walk[end]] -= 1;
            result.append(&mut way);
        } else {
            for &cell in &kept[1..kept.len() - 1] {
                visits[cell] += 1;
            }
            result.extend_from_slice(&kept[1..]);
        }
        start = end;
    }
    let is_changed = result != *walk;
    *walk = result;
    Ok(is_changed)
}

/// Cells between two reports: every other one may take a search.
const REPORT_EVERY: usize = 2_048;

/// Searches for a cheaper way than `kept` between its ends; returns whether there is one.
fn shorten(
    job: &CoverageJob,
    costs: Costs,
    transit: &mut Transit,
    done: &[Cell],
    kept: &[Cell],
    after: Option<&Cell>,
    way: &mut Vec<Cell>,
) -> bool {
    let (from, to) = (kept[0], kept[kept.len() - 1]);
    let arrived = if let [.., before, last] = done { before.direction_to(*last) } else { None };
    let arrived = arrived.unwrap_or(job.heading);
    let leaving = after.and_then(|&next| to.direction_to(next));
    let cost = costs.of_walk(arrived, kept) + u64::from(turn_at_end(costs, kept, leaving));
    let cost = u32::try_from(cost).unwrap_or(u32::MAX);
    if costs.at_least(from, Some(arrived), to, leaving) >= cost {
        return false;
    }
    let (from, to) = (TransitEnd { cell: from, heading: Some(arrived) }, TransitEnd { cell: to, heading: leaving });
    transit.append_way(from, to, cost, way).is_some()
}

fn turn_at_end(costs: Costs, kept: &[Cell], leaving: Option<Direction>) -> u32 {
    let [.., before, last] = kept else { return 0 };
    before.direction_to(*last).zip(leaving).map_or(0, |(came, leaves)| came.quarter_turns(leaves) * costs.turn)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn detours_and_the_way_home_go() {
        let free = Grid::filled(4, 2, true);
        let job = CoverageJob::new(&free, Cell::new(0, 0), Direction::Right).unwrap();
        let costs = Costs::of(&job);
        let cells = |list: &[(i32, i32)]| -> Vec<Cell> { list.iter().map(|&(x, y)| Cell::new(x, y)).collect() };
        let to_and_fro =
            [(0, 0), (0, 1), (0, 0), (1, 0), (2, 0), (3, 0), (3, 1), (3, 0), (3, 1), (2, 1), (1, 1), (0, 1), (0, 0)];
        let mut walk = cells(&to_and_fro);
        let mut transit = Transit::new(&free, costs);
        assert_eq!(shortcut(&job, costs, &mut transit, &mut walk, |_| Ok(())), Ok(true));
        assert_eq!(shortcut(&job, costs, &mut transit, &mut walk, |_| Ok(())), Ok(false));
        assert_eq!(walk, cells(&[(0, 0), (1, 0), (2, 0), (3, 0), (3, 1), (2, 1), (1, 1), (0, 1)]));
    }
}
