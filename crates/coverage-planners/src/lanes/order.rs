//! Orders lanes and links them to one path.

use super::{
    free_space::FreeSpace,
    lattice::{Lattice, pull_tight},
    layout::Lane,
};
use robovac_core::geometry::Point;

/// Ends of lanes are compared up to so many times the distance of the nearest, and so many metres more.
const FARTHER: (f32, f32) = (1.4, 0.15);
/// Metres that a lane at a right angle to the one before counts as farther.
const TURN: f64 = 0.25;
/// Most corners to go back where no way leads on: a lane can lead through a gap that the lattice doesn't.
const MOST_BACK: usize = 8;

/// A path from `start` over all lanes that can be reached: always on to the nearest end of a lane that is left, with a
/// preference for lanes parallel to the last one.
pub(super) fn in_order(space: &FreeSpace, lattice: &mut Lattice, start: Point, lanes: &[Lane]) -> Vec<Point> {
    let mut ends: Vec<Vec<(u32, bool)>> = vec![Vec::new(); lattice.len()];
    for (number, &(a, b)) in lanes.iter().enumerate() {
        for (end, is_second) in [(a, false), (b, true)] {
            for port in lattice.ports(space, end) {
                ends[port].push((number as u32, is_second));
            }
        }
    }
    // Most cells have none: a bit for each stays in the cache, where the lists don't.
    let mut has_ends = vec![0_u64; lattice.len().div_ceil(64)];
    for cell in (0..lattice.len()).filter(|&cell| !ends[cell].is_empty()) {
        has_ends[cell / 64] |= 1 << (cell % 64);
    }
    let mut is_done = vec![false; lanes.len()];
    let mut path = vec![start];
    // Corners before this one were gone back over, to the second, since the last lane.
    let mut back: Option<(usize, usize)> = None;
    let mut left = lanes.len();
    while left > 0 {
        let at = path[path.len() - 1];
        let before = path.len().checked_sub(2).map(|i| at - path[i]);
        let mut best: Option<(f64, u32, bool, usize)> = None;
        let mut limit = f32::MAX;
        lattice.search(space, at, |cell, distance| {
            if distance > limit {
                return Some(());
            }
            if has_ends[cell / 64] & (1 << (cell % 64)) == 0 {
                return None;
            }
            ends[cell].retain(|&(number, _)| !is_done[number as usize]);
            if ends[cell].is_empty() {
                has_ends[cell / 64] &= !(1 << (cell % 64));
            }
            for &(number, is_second) in &ends[cell] {
                let (a, b) = lanes[number as usize];
                let (from, to) = if is_second { (b, a) } else { (a, b) };
                // The straight distance, where that's the way; it isn't known yet.
                let way = f64::from(distance).min((from - at).norm() + 0.02);
                let aside = before.map_or(0.0, |before| {
                    let (one, other) = (before, to - from);
                    let scale = one.norm() * other.norm();
                    if scale > 0.0 { (one.perp(&other) / scale).abs() } else { 0.0 }
                });
                let cost = way + TURN * aside;
                if best.is_none_or(|(least, ..)| cost < least) {
                    best = Some((cost, number, is_second, cell));
                }
                limit = limit.min(distance * FARTHER.0 + FARTHER.1);
            }
            None
        });
        let Some((_, number, is_second, cell)) = best else {
            let (end, to) = back.unwrap_or((path.len(), path.len() - 1));
            if to == 0 || end - to > MOST_BACK {
                path.truncate(end);
                break;
            }
            path.push(path[to - 1]);
            back = Some((end, to - 1));
            continue;
        };
        (back, left) = (None, left - 1);
        is_done[number as usize] = true;
        let (a, b) = lanes[number as usize];
        let (from, to) = if is_second { (b, a) } else { (a, b) };
        let mut way = vec![at];
        way.extend(lattice.way_to(cell));
        way.push(from);
        path.extend(pull_tight(space, &way).into_iter().skip(1));
        path.push(to);
    }
    path
}

#[cfg(test)]
mod tests {
    use super::{
        super::{free_space, layout::Directions, layout::RoomLayout, swept_share},
        *,
    };
    use robovac_core::{coverage::ReachableFloor, floor_plan::generate::FlatId, robot::model};

    #[test]
    fn a_lane_through_a_gap_that_the_lattice_misses_is_no_dead_end() {
        // Three of its layouts have such a lane, after which one left out a fifth of the flat.
        let plan = "1".parse::<FlatId>().unwrap().build();
        let floor = ReachableFloor::new(&plan, model("roomba600").unwrap(), None).unwrap();
        let (space, _) = free_space(&floor, 0.003);
        let layout = RoomLayout::new(&floor, &space);
        let mut lattice = Lattice::new(&floor, &space);
        for directions in [Directions::Both, Directions::First, Directions::Second, Directions::Fewest] {
            let lanes = layout.lanes(&space, directions);
            let path = in_order(&space, &mut lattice, floor.start.position(), &lanes);
            assert!(path.windows(2).all(|pair| space.is_free(pair[0], pair[1])));
            let share = swept_share(&floor, &path);
            assert!(share > 0.99, "{directions:?}: {share}");
        }
    }
}
