//! Which pieces of a path pass near a point.

use robovac_core::geometry::Point;

/// Side of a bucket, m.
const SIDE: f64 = 0.3;

/// Pieces of a path, by the number of their second corner, in the square buckets that they pass. It's rebuilt now and
/// then, and in between a little out of date.
#[derive(Debug, Clone, Default)]
pub(super) struct Nearby {
    low: Point,
    columns: usize,
    rows: usize,
    /// Start of each bucket's pieces in `members`.
    starts: Vec<u32>,
    members: Vec<u32>,
    entries: Vec<(u32, u32)>,
}

impl Nearby {
    /// Takes the pieces of a path.
    pub fn rebuild(&mut self, points: &[Point]) {
        let Some(&first) = points.first() else { return };
        let (low, high) = points.iter().fold((first, first), |(low, high), p| (low.inf(p), high.sup(p)));
        self.low = low;
        self.columns = ((high.x - low.x) / SIDE) as usize + 1;
        self.rows = ((high.y - low.y) / SIDE) as usize + 1;
        self.entries.clear();
        for (i, pair) in points.windows(2).enumerate() {
            let steps = ((pair[1] - pair[0]).norm() / (0.7 * SIDE)).ceil().max(1.0);
            let mut last = u32::MAX;
            for step in 0..=steps as u32 {
                let bucket = self.bucket(pair[0] + (pair[1] - pair[0]) * (f64::from(step) / steps)) as u32;
                if bucket != last {
                    self.entries.push((bucket, i as u32 + 1));
                    last = bucket;
                }
            }
        }
        // Counting sort.
        self.starts.clear();
        self.starts.resize(self.columns * self.rows + 1, 0);
        for &(bucket, _) in &self.entries {
            self.starts[bucket as usize + 1] += 1;
        }
        for bucket in 1..self.starts.len() {
            self.starts[bucket] += self.starts[bucket - 1];
        }
        self.members.clear();
        self.members.resize(self.entries.len(), 0);
        for &(bucket, piece) in self.entries.iter().rev() {
            let end = &mut self.starts[bucket as usize + 1];
            *end -= 1;
            self.members[*end as usize] = piece;
        }
        // Every start has moved one bucket on.
        self.starts.remove(0);
        self.starts.push(self.members.len() as u32);
    }

    fn bucket(&self, p: Point) -> usize {
        let x = (((p.x - self.low.x) / SIDE).max(0.0) as usize).min(self.columns - 1);
        let y = (((p.y - self.low.y) / SIDE).max(0.0) as usize).min(self.rows - 1);
        y * self.columns + x
    }

    /// Pieces that pass the bucket of a point.
    pub fn around(&self, p: Point) -> &[u32] {
        if self.starts.is_empty() {
            return &[];
        }
        let bucket = self.bucket(p);
        &self.members[self.starts[bucket] as usize..self.starts[bucket + 1] as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_are_found_along_their_whole_length() {
        let path = [Point::new(1.0, 1.0), Point::new(4.0, 1.0), Point::new(4.0, 1.4), Point::new(1.0, 3.0)];
        let mut nearby = Nearby::default();
        assert!(nearby.around(path[0]).is_empty());
        nearby.rebuild(&path);
        for (i, pair) in path.windows(2).enumerate() {
            for k in 0..=10 {
                let at = pair[0] + (pair[1] - pair[0]) * (f64::from(k) / 10.0);
                let found = nearby.around(at);
                assert!(found.contains(&(i as u32 + 1)) || i == 2, "{i} {at}: {found:?}");
            }
        }
        assert!(!nearby.around(Point::new(1.0, 1.0)).contains(&2));
    }
}
