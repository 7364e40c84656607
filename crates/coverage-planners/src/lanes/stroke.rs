//! The samples of each row that a stroke of the tool sweeps.

use robovac_core::{geometry::Vector, math};

/// Parts of a column in which the sides of strokes are computed.
const PART_BITS: u32 = 24;
const PARTS: f64 = (1 << PART_BITS) as f64;

/// The range of samples of a row that a stroke sweeps.
pub(super) type SampleRun = (i32, i32);

/// The nearest whole number, of a small number; faster than a cast, which takes care of large ones.
#[inline]
fn nearest(x: f64) -> i32 {
    (x + 1.5 * (1_u64 << 52) as f64).to_bits() as i32
}

/// A disc moved along a segment, in samples.
#[derive(Debug, Clone)]
pub(super) struct SweptDisc {
    /// The lower and the upper end.
    pub low: Vector,
    pub high: Vector,
    pub radius: f64,
    /// First row, and the one after the last.
    pub rows: (i32, i32),
    /// Height over an end at which the left side touches its disc.
    tilt: f64,
    /// Columns from the middle to a side, not finite for one row.
    half: f64,
    /// From the first of these rows to before the second, a row meets neither disc, only the two long sides.
    middle: (i32, i32),
    /// There: left and right side at the first of the rows, and columns from one row to the next, in parts of a column.
    sides: (i64, i64),
    step: i64,
    /// Columns from one row to the next, not finite for one row.
    pub slope: f64,
}

impl SweptDisc {
    #[inline]
    pub fn new(a: Vector, b: Vector, radius: f64, height: i32) -> Self {
        let (low, high) = if a.y <= b.y { (a, b) } else { (b, a) };
        let rows = (math::ceil(low.y - radius).max(0), (math::floor(high.y + radius) + 1).min(height));
        let length = (high - low).norm();
        let along = if length > 1e-9 { (high - low) / length } else { Vector::zeros() };
        let slope = along.x / along.y;
        let half = radius / along.y;
        let tilt = radius * along.x;
        let mut stroke = Self { low, high, radius, rows, tilt, half, middle: (0, 0), sides: (0, 0), step: 0, slope };
        let middle = (math::floor(low.y + radius) + 1, math::ceil(high.y - radius));
        if middle.0 < middle.1 {
            let at = low.x + slope * (f64::from(middle.0) - low.y);
            let parts = |columns: f64| (columns * PARTS) as i64;
            stroke.middle = middle;
            stroke.sides = (parts(at - half), parts(at + half));
            stroke.step = parts(slope);
        }
        stroke
    }

    /// Appends the samples of every row.
    #[inline]
    pub fn push_runs(&self, width: i32, runs: &mut Vec<SampleRun>) {
        let middle = (self.middle.0.clamp(self.rows.0, self.rows.1), self.middle.1.clamp(self.rows.0, self.rows.1));
        let middle = if middle.0 < middle.1 { middle } else { (self.rows.1, self.rows.1) };
        runs.extend((self.rows.0..middle.0).map(|row| self.run_at_end(row, width)));
        runs.extend((middle.0..middle.1).map(|row| {
            let by = self.step * i64::from(row - self.middle.0);
            let (left, right) = (self.sides.0 + by, self.sides.1 + by);
            let from = (left + PARTS as i64 - 1) >> PART_BITS;
            let to = (right >> PART_BITS) + 1;
            (from.max(0) as i32, to.clamp(0, i64::from(width)) as i32)
        }));
        runs.extend((middle.1..self.rows.1).map(|row| self.run_at_end(row, width)));
    }

    /// Where a disc bounds the row, or one of the long sides.
    #[inline]
    fn run_at_end(&self, row: i32, width: i32) -> SampleRun {
        let y = f64::from(row);
        let (low, high) = (y - self.low.y, y - self.high.y);
        let half = |dy: f64| (self.radius * self.radius - dy * dy).max(0.0).sqrt();
        let middle = || self.low.x + self.slope * low;
        // The sides end where they touch the discs.
        let left = if low <= self.tilt {
            self.low.x - half(low)
        } else if high < self.tilt {
            middle() - self.half
        } else {
            self.high.x - half(high)
        };
        let right = if low <= -self.tilt {
            self.low.x + half(low)
        } else if high < -self.tilt {
            middle() + self.half
        } else {
            self.high.x + half(high)
        };
        (nearest(left + 0.5).max(0), nearest(right + 0.5).min(width))
    }
}
