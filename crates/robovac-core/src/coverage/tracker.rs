//! Counts how often each part of the floor has been swept.

use super::{ReachableFloor, stamp::DiscStamp};
use crate::{geometry::Point, grid::Grid};

/// Counts passes of the tool over every fine cell.
///
/// A cell counts as visited again when the tool comes back to it after it had travelled more than its own diameter
/// since it last touched the cell; so neither standing still nor turning on the spot counts.
#[derive(Debug, Clone)]
pub struct CoverageTracker {
    stamp: DiscStamp,
    resolution: f64,
    /// Passes per fine cell, at most 255.
    visits: Grid<u8>,
    /// Number of the last stamp that touched the cell, 0 for none.
    touched: Vec<u32>,
    /// Number of the last stamp; starts above `memory`, as if all cells had been left long ago.
    stamps: u32,
    /// Stamps after which a touched cell counts as left.
    memory: u32,
    last: Option<Point>,
    covered: usize,
    passes: u64,
    /// Cells in the lowest and highest row that changed since they were last taken.
    dirty: Option<(usize, usize)>,
}

impl CoverageTracker {
    /// A tracker for a floor on which nothing has been swept.
    pub fn new(floor: &ReachableFloor) -> Self {
        let grid = &floor.floor;
        let radius = floor.tool_radius / floor.resolution;
        // Stamps are half a cell apart: 4 radii of them are a diameter.
        let memory = (4.0 * radius).ceil() as u32 + 1;
        Self {
            stamp: DiscStamp { radius, width: grid.width(), height: grid.height() },
            resolution: floor.resolution,
            visits: Grid::filled(grid.width(), grid.height(), 0),
            touched: vec![0; grid.len()],
            stamps: memory,
            memory,
            last: None,
            covered: 0,
            passes: 0,
            dirty: None,
        }
    }

    /// Sweeps with the tool from its last place to `point` in a straight line, or sets it down there.
    #[inline]
    pub fn sweep_to(&mut self, floor: &ReachableFloor, point: Point) {
        let Some(last) = self.last else {
            self.put_down(floor, point);
            return;
        };
        let spacing = 0.5 * self.resolution;
        let distance_squared = (point - last).norm_squared();
        if distance_squared < spacing * spacing {
            return;
        }
        let steps = (distance_squared.sqrt() / spacing).floor();
        let stride = (point - last) * (spacing / distance_squared.sqrt());
        let mut at = last;
        for _ in 0..steps as u32 {
            at += stride;
            self.put_down(floor, at);
        }
    }

    /// Takes over what was swept before, where it is reachable here: passes of an earlier tracker over the same grid.
    /// Does nothing if the grids differ.
    pub fn take_over(&mut self, floor: &ReachableFloor, earlier: &Self) {
        let Self { visits, covered, passes, dirty, .. } = self;
        let is_same = (visits.width(), visits.height()) == (earlier.visits.width(), earlier.visits.height());
        if !is_same || self.resolution.to_bits() != earlier.resolution.to_bits() {
            return;
        }
        let cells = visits.values_mut().iter_mut().zip(floor.floor.values()).zip(earlier.visits.values());
        for ((count, &is_reachable), &before) in cells {
            if is_reachable && before > 0 {
                *covered += usize::from(*count == 0);
                *count = count.saturating_add(before);
                *passes += u64::from(before);
            }
        }
        *dirty = Some((0, visits.len().saturating_sub(1)));
    }

    /// Lifts the tool: at the next place it is set down instead of sweeping there.
    pub fn lift(&mut self) {
        self.last = None;
    }

    fn put_down(&mut self, floor: &ReachableFloor, at: Point) {
        self.last = Some(at);
        self.stamps += 1;
        let Self { stamp, resolution, visits, touched, stamps, memory, covered, passes, dirty, .. } = self;
        let (now, reachable, counts) = (*stamps, floor.floor.values(), visits.values_mut());
        stamp.rows(at.x / *resolution, at.y / *resolution, |range| {
            let (low, high) = dirty.unwrap_or((range.start, range.start));
            *dirty = Some((low.min(range.start), high.max(range.start)));
            let cells = reachable[range.clone()].iter().zip(&mut touched[range.clone()]).zip(&mut counts[range]);
            for ((&is_reachable, touched), count) in cells {
                let is_new_pass = is_reachable && now - *touched > *memory;
                *touched = now;
                if is_new_pass {
                    *covered += usize::from(*count == 0);
                    *count = count.saturating_add(1);
                    *passes += 1;
                }
            }
        });
    }

    /// Swept share of the reachable floor, 0 to 1.
    pub fn coverage(&self, floor: &ReachableFloor) -> f64 {
        self.covered as f64 / floor.floor_cells as f64
    }

    /// Passes beyond the first, as a share of the swept floor: 0.3 means that 30 % were swept twice on average.
    pub fn overlap(&self) -> f64 {
        if self.covered == 0 { 0.0 } else { (self.passes - self.covered as u64) as f64 / self.covered as f64 }
    }

    /// Passes per fine cell, at most 255.
    pub fn visits(&self) -> &Grid<u8> {
        &self.visits
    }

    /// Memory size, bytes.
    pub fn bytes(&self) -> usize {
        self.touched.len() * (size_of::<u8>() + size_of::<u32>())
    }

    /// The lowest and highest row that changed since the last call.
    pub fn take_dirty_rows(&mut self) -> Option<(usize, usize)> {
        self.dirty.take().map(|(low, high)| (low / self.stamp.width, high / self.stamp.width))
    }
}
