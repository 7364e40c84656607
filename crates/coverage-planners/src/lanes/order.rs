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
    for _ in 0..lanes.len() {
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
        let Some((_, number, is_second, cell)) = best else { break };
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
