//! How often each sample of the floor is swept, counted up and down while a path changes.

use super::scan::rotation;
use robovac_core::{
    coverage::ReachableFloor,
    geometry::{Point, Vector},
    math,
};

/// Angle of the raster to the floor plan, rad: neither walls nor lanes are parallel to it, so that what is missed between two
/// lanes can't hide between two rows of samples.
const ANGLE: f64 = 0.417;
/// Samples across the tool.
const ACROSS: f64 = 10.0;
/// Samples along a side of a block, as a power of two.
const BLOCK: i32 = 4;
/// Most samples.
const MOST_SAMPLES: f64 = 12e6;

/// Samples of the floor at a spacing of about a tenth of the tool's width, and how often each is swept.
#[derive(Debug, Clone)]
pub(super) struct SweptRaster {
    /// Metres between samples.
    pub spacing: f64,
    /// Cosine and sine of the raster's angle.
    turn: Vector,
    /// Position of the first sample in the turned frame, m.
    origin: Vector,
    width: i32,
    height: i32,
    /// Radius of the tool, in samples.
    radius: f64,
    /// Strokes over each sample, modulo 256; those off the floor begin at 1.
    counts: Vec<u8>,
    /// Number of samples with count 0: all, and in each square block.
    unswept: i64,
    blocks: Vec<u16>,
    blocks_across: i32,
    /// Indices of the samples on the floor.
    floor: Vec<u32>,
    /// Strokes of an exchange with +1 if new and -1 if old, and where they begin and end in a row; kept for their memory.
    strokes: Vec<(Stroke, i32)>,
    ends: Vec<(i32, i32)>,
}

/// The range of samples of a row that a stroke sweeps.
type Run = (i32, i32);

impl SweptRaster {
    pub fn new(floor: &ReachableFloor) -> Self {
        let (width, height) = (floor.floor.width() as f64, floor.floor.height() as f64);
        let size = Vector::new(width, height) * floor.resolution;
        let turn = rotation(ANGLE);
        let corners = [[0.0, 0.0], [size.x, 0.0], [0.0, size.y], [size.x, size.y]];
        let corners = corners.map(|[x, y]| into_frame(turn, Point::new(x, y)));
        let low = corners.iter().fold(corners[0], |low, c| low.inf(c));
        let high = corners.iter().fold(corners[0], |high, c| high.sup(c));
        let extent = high - low;
        let least = (extent.x * extent.y / MOST_SAMPLES).sqrt();
        let spacing = (2.0 * floor.tool_radius / ACROSS).max(least);
        let count = |metres: f64| (metres / spacing) as i32 + 1;
        let (width, height) = (count(extent.x), count(extent.y));
        let mut raster = Self {
            spacing,
            turn,
            origin: low,
            width,
            height,
            radius: floor.tool_radius / spacing,
            counts: vec![1; (width * height) as usize],
            unswept: 0,
            blocks: vec![0; (((width >> BLOCK) + 1) * ((height >> BLOCK) + 1)) as usize],
            blocks_across: (width >> BLOCK) + 1,
            floor: Vec::new(),
            strokes: Vec::new(),
            ends: Vec::new(),
        };
        for index in 0..raster.counts.len() {
            if floor.floor.is_set(floor.cell_at(raster.sample(index))) {
                raster.counts[index] = 0;
                raster.floor.push(index as u32);
                let (row, column) = (index as i32 / width, index as i32 % width);
                let block = raster.block(row, column);
                raster.blocks[block] += 1;
            }
        }
        raster.unswept = raster.floor.len() as i64;
        raster
    }

    /// Position of a sample.
    pub fn sample(&self, index: usize) -> Point {
        let (x, y) = ((index % self.width as usize) as f64, (index / self.width as usize) as f64);
        let at = self.origin + Vector::new(x, y) * self.spacing;
        Point::new(self.turn.x * at.x - self.turn.y * at.y, self.turn.y * at.x + self.turn.x * at.y)
    }

    /// Indices of the samples on the floor.
    pub fn floor(&self) -> &[u32] {
        &self.floor
    }

    /// Whether a sample isn't swept.
    #[inline]
    pub fn is_unswept(&self, index: u32) -> bool {
        self.counts[index as usize] == 0
    }

    /// Floor that isn't swept, m².
    #[inline]
    pub fn unswept_area(&self) -> f64 {
        self.unswept as f64 * self.spacing * self.spacing
    }

    /// Area of the floor by samples, m².
    pub fn floor_area(&self) -> f64 {
        self.floor.len() as f64 * self.spacing * self.spacing
    }

    /// Floor that a path would leave unswept, m². Nothing must have been counted.
    pub fn left_by(&mut self, path: &[Point]) -> f64 {
        path.windows(2).for_each(|pair| self.add(pair[0], pair[1]));
        let left = self.unswept_area();
        path.windows(2).for_each(|pair| self.remove(pair[0], pair[1]));
        left
    }

    /// Counts a stroke of the tool from `a` to `b`.
    pub fn add(&mut self, a: Point, b: Point) {
        let stroke = self.stroke(a, b);
        for row in stroke.rows.0..stroke.rows.1 {
            let run = stroke.run(row, self.width);
            self.change(row, run, 1);
        }
    }

    /// Takes a stroke back.
    pub fn remove(&mut self, a: Point, b: Point) {
        let stroke = self.stroke(a, b);
        for row in stroke.rows.0..stroke.rows.1 {
            let run = stroke.run(row, self.width);
            self.change(row, run, -1);
        }
    }

    /// How much more floor would stay unswept if the strokes `new` took the place of `old`, m²; infinite if more than `most`
    /// is lost, whatever is won.
    pub fn missed_by(&mut self, old: &[(Point, Point)], new: &[(Point, Point)], most: f64) -> f64 {
        let area = self.spacing * self.spacing;
        let (mut won, mut lost, most) = (0_u32, 0_u32, most / area);
        let mut ends = std::mem::take(&mut self.ends);
        let rows = self.begin_exchange(old, new);
        for row in rows.0..rows.1 {
            self.ends_in_row(row, &mut ends);
            let line = &self.counts[(row * self.width) as usize..][..self.width as usize];
            each_run(&ends, |(from, to), by| {
                let run = &line[from as usize..to as usize];
                // Nobody but the old strokes sweeps what they count alone.
                let sought = if by < 0 { by.unsigned_abs() as u8 } else { 0 };
                let found = run.iter().map(|&count| u32::from(count == sought)).sum::<u32>();
                *if by < 0 { &mut lost } else { &mut won } += found;
            });
            if f64::from(lost) > most {
                break;
            }
        }
        self.ends = ends;
        if f64::from(lost) > most { f64::INFINITY } else { (f64::from(lost) - f64::from(won)) * area }
    }

    /// No more floor than this, m², could the strokes `new` sweep anew, other than those that are among `old`.
    pub fn could_win(&self, old: &[(Point, Point)], new: &[(Point, Point)]) -> f64 {
        let mut samples = 0_u32;
        for &(a, b) in new.iter().filter(|piece| !old.contains(piece)) {
            let Stroke { low, high, rows, slope, radius, .. } = self.stroke(a, b);
            let (left, right) = (low.x.min(high.x), low.x.max(high.x));
            // A piece that nobody has checked can lie off the map.
            if rows.0 >= rows.1 {
                continue;
            }
            for block_row in rows.0 >> BLOCK..=(rows.1 - 1) >> BLOCK {
                // The part of the segment that is no farther from these rows than the tool reaches.
                let bottom = f64::from(block_row << BLOCK) - radius;
                let top = f64::from((block_row + 1) << BLOCK) + radius;
                let at = |y: f64| low.x + slope * (y.clamp(low.y, high.y) - low.y);
                let (mut from, mut to) = (left, right);
                if slope.is_finite() {
                    let ends = (at(bottom), at(top));
                    (from, to) = (ends.0.min(ends.1), ends.0.max(ends.1));
                }
                let first = math::floor(from - radius).clamp(0, self.width - 1) >> BLOCK;
                let last = math::ceil(to + radius).clamp(0, self.width - 1) >> BLOCK;
                let start = block_row * self.blocks_across;
                let blocks = &self.blocks[(start + first) as usize..=(start + last) as usize];
                samples += blocks.iter().map(|&count| u32::from(count)).sum::<u32>();
            }
        }
        f64::from(samples) * self.spacing * self.spacing
    }

    #[inline]
    fn block(&self, row: i32, column: i32) -> usize {
        ((row >> BLOCK) * self.blocks_across + (column >> BLOCK)) as usize
    }

    /// Counts the strokes `new` instead of `old`; only where they differ are samples visited.
    pub fn exchange(&mut self, old: &[(Point, Point)], new: &[(Point, Point)]) {
        let mut ends = std::mem::take(&mut self.ends);
        let rows = self.begin_exchange(old, new);
        for row in rows.0..rows.1 {
            self.ends_in_row(row, &mut ends);
            each_run(&ends, |run, by| self.change(row, run, by));
        }
        self.ends = ends;
    }

    /// Takes the strokes in which `old` and `new` differ; returns the rows that they meet.
    fn begin_exchange(&mut self, old: &[(Point, Point)], new: &[(Point, Point)]) -> (i32, i32) {
        let mut strokes = std::mem::take(&mut self.strokes);
        strokes.clear();
        for (these, others, by) in [(old, new, -1), (new, old, 1)] {
            let different = these.iter().filter(|piece| !others.contains(piece));
            strokes.extend(different.map(|&(a, b)| (self.stroke(a, b), by)));
        }
        let rows = strokes
            .iter()
            .fold((i32::MAX, i32::MIN), |rows, (stroke, _)| (rows.0.min(stroke.rows.0), rows.1.max(stroke.rows.1)));
        self.strokes = strokes;
        rows
    }

    /// Where the strokes of the exchange begin and end in a row, sorted, with the change of the count there.
    #[inline]
    fn ends_in_row(&self, row: i32, ends: &mut Vec<(i32, i32)>) {
        ends.clear();
        for (stroke, by) in &self.strokes {
            if row < stroke.rows.0 || row >= stroke.rows.1 {
                continue;
            }
            let (from, to) = stroke.run(row, self.width);
            if from < to {
                for end in [(from, *by), (to, -by)] {
                    ends.push(end);
                    let mut i = ends.len() - 1;
                    while i > 0 && ends[i - 1].0 > end.0 {
                        ends[i] = ends[i - 1];
                        i -= 1;
                    }
                    ends[i] = end;
                }
            }
        }
    }

    /// Adds to the counts of a run.
    fn change(&mut self, row: i32, (from, to): Run, by: i32) {
        let start = (row * self.width) as usize;
        let mut from = from;
        while from < to {
            let end = to.min(((from >> BLOCK) + 1) << BLOCK);
            let (mut before, mut after) = (0_u16, 0_u16);
            for count in &mut self.counts[start + from as usize..start + end as usize] {
                before += u16::from(*count == 0);
                *count = count.wrapping_add(by as u8);
                after += u16::from(*count == 0);
            }
            if before != after {
                let block = self.block(row, from);
                self.blocks[block] = self.blocks[block] + after - before;
                self.unswept += i64::from(after) - i64::from(before);
            }
            from = end;
        }
    }

    fn stroke(&self, a: Point, b: Point) -> Stroke {
        let local = |p: Point| (into_frame(self.turn, p) - self.origin) / self.spacing;
        Stroke::new(local(a), local(b), self.radius, self.height)
    }
}

fn into_frame(turn: Vector, p: Point) -> Vector {
    Vector::new(turn.x * p.x + turn.y * p.y, turn.x * p.y - turn.y * p.x)
}

/// Calls `each` with every run between two ends in which the count changes, and by how much.
#[inline]
fn each_run(ends: &[(i32, i32)], mut each: impl FnMut(Run, i32)) {
    let mut by = 0;
    for pair in ends.windows(2) {
        by += pair[0].1;
        if by != 0 && pair[0].0 < pair[1].0 {
            each((pair[0].0, pair[1].0), by);
        }
    }
}

/// A disc moved along a segment, in samples.
#[derive(Debug, Clone)]
struct Stroke {
    /// The lower and the upper end.
    low: Vector,
    high: Vector,
    radius: f64,
    /// First row, and the one after the last.
    rows: (i32, i32),
    /// Direction from the lower to the upper end, of length 1; zero for a point.
    along: Vector,
    length: f64,
    /// 1 over its components.
    inverse: Vector,
    /// Between these heights a row meets neither disc, only the two long sides.
    sides: (f64, f64),
    /// There: columns from one row to the next, and half the width.
    slope: f64,
    half: f64,
}

impl Stroke {
    #[inline]
    fn new(a: Vector, b: Vector, radius: f64, height: i32) -> Self {
        let (low, high) = if a.y <= b.y { (a, b) } else { (b, a) };
        let rows = (math::ceil(low.y - radius).max(0), (math::floor(high.y + radius) + 1).min(height));
        let length = (high - low).norm();
        let along = if length > 1e-9 { (high - low) / length } else { Vector::zeros() };
        let inverse = Vector::new(1.0 / along.x, 1.0 / along.y);
        let sides = (low.y + radius, high.y - radius);
        let (slope, half) = (along.x * inverse.y, radius * inverse.y);
        Self { low, high, radius, rows, along, length, inverse, sides, slope, half }
    }

    /// The samples of a row: convex, so the hull of what both discs and the rectangle between them sweep of it.
    #[inline]
    fn run(&self, row: i32, width: i32) -> Run {
        let y = f64::from(row);
        if y > self.sides.0 && y < self.sides.1 {
            let middle = self.low.x + self.slope * (y - self.low.y);
            return (math::ceil(middle - self.half).max(0), (math::floor(middle + self.half) + 1).min(width));
        }
        let (mut left, mut right) = (f64::MAX, f64::MIN);
        for end in [self.low, self.high] {
            let dy = y - end.y;
            let square = self.radius * self.radius - dy * dy;
            if square >= 0.0 {
                let half = square.sqrt();
                left = left.min(end.x - half);
                right = right.max(end.x + half);
            }
        }
        if self.length > 1e-9 {
            // With x from the lower end: |along.x dy - along.y x| <= radius, 0 <= along.x x + along.y dy <= length.
            let dy = y - self.low.y;
            let (mut from, mut to) = (f64::MIN, f64::MAX);
            if self.along.y > 1e-9 {
                let middle = self.along.x * dy * self.inverse.y;
                let half = self.radius * self.inverse.y;
                (from, to) = (middle - half, middle + half);
            } else if dy.abs() > self.radius {
                (from, to) = (1.0, 0.0);
            }
            if self.along.x.abs() > 1e-9 {
                let one = -self.along.y * dy * self.inverse.x;
                let other = one + self.length * self.inverse.x;
                from = from.max(one.min(other));
                to = to.min(one.max(other));
            }
            if from <= to {
                left = left.min(self.low.x + from);
                right = right.max(self.low.x + to);
            }
        }
        if left > right {
            return (0, 0);
        }
        (math::ceil(left).max(0), (math::floor(right) + 1).min(width))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::RngExt;
    use robovac_core::{floor_plan::Sketch, geometry::nearest_on_segment, rng::seeded, robot::model};

    #[test]
    fn counts_are_those_of_every_sample_and_return_to_what_they_were() {
        let plan = Sketch::open(2.0, 1.5, 0.05).fill(&[[0.9, 0.6, 1.1, 0.8]]).finish("", "");
        let floor = ReachableFloor::new(&plan, model("roomba600").unwrap(), None).unwrap();
        let mut raster = SweptRaster::new(&floor);
        let mut rng = seeded(5, 0);
        let mut at = || Point::new(rng.random_range(0.1..1.9), rng.random_range(0.1..1.4));
        let all = raster.unswept;
        for _ in 0..200 {
            let (a, b, c, d) = (at(), at(), at(), at());
            raster.add(a, b);
            let could = raster.could_win(&[(a, b)], &[(c, d)]);
            let lone = raster.unswept_area();
            let missed = raster.missed_by(&[(a, b)], &[(c, d)], 1e9);
            let before = raster.unswept_area();
            raster.exchange(&[(a, b)], &[(c, d)]);
            assert!((raster.unswept_area() - before - missed).abs() < 1e-9);
            raster.add(a, b);
            assert!(lone - raster.unswept_area() <= could + 1e-9);
            raster.remove(a, b);
            assert_eq!(raster.blocks.iter().map(|&count| i64::from(count)).sum::<i64>(), raster.unswept);
            let near = |p: Point| (nearest_on_segment(c, d, p) - p).norm() < floor.tool_radius;
            let left = raster.floor.iter().filter(|&&i| !near(raster.sample(i as usize))).count() as i64;
            // A sample at the very edge may be rounded either way.
            assert!((raster.unswept - left).abs() <= 1, "{} {left}", raster.unswept);
            assert_eq!(raster.floor.iter().filter(|&&i| raster.is_unswept(i)).count() as i64, raster.unswept);
            raster.remove(c, d);
            assert_eq!(raster.unswept, all);
        }
    }
}
