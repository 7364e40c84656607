//! Which pieces and corners of a path are near a point.

use robovac_core::geometry::Point;

/// Side of a bucket, m.
const SIDE: f64 = 0.3;

/// The name of a corner, and where it was in the path.
pub(super) type Named = (u32, u32);

/// Members of square buckets.
#[derive(Debug, Clone, Default)]
struct Buckets {
    /// Start of each bucket's members.
    starts: Vec<u32>,
    members: Vec<Named>,
    /// Bucket and member, in any order.
    entries: Vec<(u32, Named)>,
}

/// Pieces of a path, by their second corners, in the square buckets that they pass, and corners in theirs. It's rebuilt now
/// and then, and in between a little out of date.
#[derive(Debug, Clone, Default)]
pub(super) struct Nearby {
    low: Point,
    columns: usize,
    rows: usize,
    pieces: Buckets,
    corners: Buckets,
}

impl Buckets {
    /// Sorts the entries into `count` buckets by counting.
    fn sort(&mut self, count: usize) {
        self.starts.clear();
        self.starts.resize(count + 1, 0);
        for &(bucket, _) in &self.entries {
            self.starts[bucket as usize] += 1;
        }
        let mut end = 0;
        for start in &mut self.starts {
            end += *start;
            *start = end;
        }
        self.members.clear();
        self.members.resize(self.entries.len(), (0, 0));
        for &(bucket, member) in self.entries.iter().rev() {
            let start = &mut self.starts[bucket as usize];
            *start -= 1;
            self.members[*start as usize] = member;
        }
        self.entries.clear();
    }

    fn of(&self, bucket: usize) -> &[Named] {
        match self.starts.get(bucket..bucket + 2) {
            Some(range) => &self.members[range[0] as usize..range[1] as usize],
            None => &[],
        }
    }
}

impl Nearby {
    /// Takes the pieces and corners of a path.
    pub fn rebuild(&mut self, points: &[Point], names: &[u32]) {
        let Some(&first) = points.first() else { return };
        let (low, high) = points.iter().fold((first, first), |(low, high), p| (low.inf(p), high.sup(p)));
        self.low = low;
        self.columns = ((high.x - low.x) / SIDE) as usize + 1;
        self.rows = ((high.y - low.y) / SIDE) as usize + 1;
        for (i, pair) in points.windows(2).enumerate() {
            let corner = (names[i + 1], i as u32 + 1);
            let steps = ((pair[1] - pair[0]).norm() / (0.7 * SIDE)).ceil().max(1.0);
            let mut last = u32::MAX;
            for step in 0..=steps as u32 {
                let bucket = self.bucket(pair[0] + (pair[1] - pair[0]) * (f64::from(step) / steps)) as u32;
                if bucket != last {
                    self.pieces.entries.push((bucket, corner));
                    last = bucket;
                }
            }
            self.corners.entries.push((last, corner));
        }
        self.pieces.sort(self.columns * self.rows);
        self.corners.sort(self.columns * self.rows);
    }

    fn bucket(&self, p: Point) -> usize {
        let x = (((p.x - self.low.x) / SIDE).max(0.0) as usize).min(self.columns.saturating_sub(1));
        let y = (((p.y - self.low.y) / SIDE).max(0.0) as usize).min(self.rows.saturating_sub(1));
        y * self.columns + x
    }

    /// Pieces that pass the bucket of a point, by their second corners.
    pub fn around(&self, p: Point) -> &[Named] {
        self.pieces.of(self.bucket(p))
    }

    /// Corners in the bucket of a point, without the path's first.
    pub fn corners(&self, p: Point) -> &[Named] {
        self.corners.of(self.bucket(p))
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
        nearby.rebuild(&path, &[7, 8, 9, 10]);
        for (i, pair) in path.windows(2).enumerate() {
            for k in 0..=10 {
                let at = pair[0] + (pair[1] - pair[0]) * (f64::from(k) / 10.0);
                let found = nearby.around(at);
                assert!(found.contains(&(i as u32 + 8, i as u32 + 1)) || i == 2, "{i} {at}: {found:?}");
            }
        }
        assert!(!nearby.around(Point::new(1.0, 1.0)).contains(&(9, 2)));
    }
}
