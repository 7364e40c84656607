//! A controller's current goal, for display.

use crate::mapping::{CellMark, Marks, TiledLayer, locate::Locator};
use robovac_core::geometry::Point;

/// The goal of a controller that drives by a map of its own, in the frame of that map.
#[derive(Debug, Clone, Copy, Default)]
pub struct Intent<'a> {
    /// Corners of its route, the next one first, m; empty without a route.
    pub route: &'a [Point],
    /// Frontiers: the ends of each piece, m.
    pub frontiers: &'a [[Point; 2]],
    /// Cells of the map that its tool can reach, at the last decision; `None` if unused.
    pub reach: Option<&'a TiledLayer<bool>>,
    /// The locator while it relocalises.
    pub locator: Option<&'a Locator>,
}

impl Intent<'_> {
    /// Reachable floor that is swept by its estimate, and all reachable floor, m².
    pub fn swept(&self, marks: &Marks) -> Option<[f64; 2]> {
        let side = marks.resolution();
        let (mut all, mut swept) = (0_u32, 0_u32);
        for (cell, _) in self.reach?.iter() {
            all += 1;
            swept += u32::from(marks.has(cell, CellMark::Cleaned));
        }
        Some([swept, all].map(|cells| f64::from(cells) * side * side))
    }
}
