//! The tool's disc as runs of cells.

use crate::math;
use std::ops::Range;

/// A disc to be stamped onto a grid of `width` x `height` cells.
#[derive(Debug, Clone, Copy)]
pub(super) struct DiscStamp {
    /// Radius in cells.
    pub radius: f64,
    /// Columns of the grid.
    pub width: usize,
    /// Rows of the grid.
    pub height: usize,
}

impl DiscStamp {
    /// Calls `visit` with the range of indices of every row in which cells have their centre in the disc around
    /// (`x`, `y`), both in cells.
    #[inline]
    pub fn rows(&self, x: f64, y: f64, mut visit: impl FnMut(Range<usize>)) {
        // Half a thousandth more, for discs whose edge passes through a centre but for rounding.
        let radius = self.radius + 5e-4;
        let first = math::ceil(y - 0.5 - radius).max(0);
        let last = math::floor(y - 0.5 + radius).min(self.height as i32 - 1);
        for row in first..=last {
            let dy = f64::from(row) + 0.5 - y;
            let half = (radius * radius - dy * dy).max(0.0).sqrt();
            let left = math::ceil(x - 0.5 - half).max(0);
            let right = math::floor(x - 0.5 + half).min(self.width as i32 - 1);
            if left <= right {
                let start = row as usize * self.width + left as usize;
                visit(start..start + (right - left + 1) as usize);
            }
        }
    }
}
