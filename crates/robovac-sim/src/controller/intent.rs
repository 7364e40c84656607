//! A controller's current goal, for display.

use crate::mapping::{Mark, Marks, TiledLayer, locate::Locator};
use robovac_core::geometry::Point;

/// What a controller that drives by a map of its own is going for, in the frame of that map.
#[derive(Debug, Clone, Copy, Default)]
pub struct Intent<'a> {
    /// Corners that it will drive to, the next one first, m; empty if it doesn't follow a line.
    pub route: &'a [Point],
    /// Where what it knows ends and it could go: the ends of each piece, m.
    pub frontiers: &'a [[Point; 2]],
    /// Cells of the map that its tool can get to, as it last thought; `None` if it doesn't care.
    pub reach: Option<&'a TiledLayer<bool>>,
    /// What looks for it on its map while it is lost.
    pub locator: Option<&'a Locator>,
}

impl Intent<'_> {
    /// Floor that the tool can get to and that it believes to have swept, and all that it can get to, m².
    pub fn swept(&self, marks: &Marks) -> Option<[f64; 2]> {
        let side = marks.resolution();
        let (mut all, mut swept) = (0_u32, 0_u32);
        for (cell, _) in self.reach?.iter() {
            all += 1;
            swept += u32::from(marks.has(cell, Mark::Cleaned));
        }
        Some([swept, all].map(|cells| f64::from(cells) * side * side))
    }
}
