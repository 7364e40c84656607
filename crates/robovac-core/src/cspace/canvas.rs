//! Rasterisation: sets cells whose centres are covered.

use super::{bits::Bits, sum::Sum};
use crate::math;

/// A grid of bits in metres: cell (0, 0) has its lower left corner at the origin.
#[derive(Debug, Clone)]
pub(super) struct BitCanvas {
    /// The cells that are set.
    pub bits: Bits,
    /// Side of a cell, m.
    pub cell: f64,
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
}

impl BitCanvas {
    /// Nothing set.
    pub fn new(width: usize, height: usize, cell: f64) -> Self {
        Self { bits: Bits::new(width, height), cell, width, height }
    }

    /// Columns or rows whose centres lie between two places; can be outside.
    #[inline]
    pub fn between(&self, low: f64, high: f64) -> (i32, i32) {
        (math::ceil(low / self.cell - 0.5), math::floor(high / self.cell - 0.5))
    }

    /// The rows among them that exist.
    pub fn rows(&self, (low, high): (f64, f64)) -> std::ops::RangeInclusive<i32> {
        let (first, last) = self.between(low, high);
        first.max(0)..=last.min(self.height as i32 - 1)
    }

    /// Height of a row's centres, m.
    pub fn centre(&self, row: i32) -> f64 {
        (f64::from(row) + 0.5) * self.cell
    }

    /// Sets the cells of a row whose centres lie between two places.
    #[inline]
    pub fn fill(&mut self, row: i32, low: f64, high: f64) {
        let (first, last) = self.between(low, high);
        let (first, last) = (first.max(0), last.min(self.width as i32 - 1));
        if first <= last {
            self.bits.set(row as usize, first as usize, last as usize);
        }
    }

    /// Sets the cells whose centres lie in a region.
    pub fn draw(&mut self, sum: &Sum) {
        for row in self.rows(sum.rows()) {
            let (low, high) = sum.across(self.centre(row));
            self.fill(row, low, high);
        }
    }
}
