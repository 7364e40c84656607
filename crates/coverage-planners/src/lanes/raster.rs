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
    /// Number of samples with count 0.
    unswept: i64,
    /// Indices of the samples on the floor.
    floor: Vec<u32>,
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
            floor: Vec::new(),
        };
        for index in 0..raster.counts.len() {
            if floor.floor.is_set(floor.cell_at(raster.sample(index))) {
                raster.counts[index] = 0;
                raster.floor.push(index as u32);
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
            self.change::<true>(row, run);
        }
    }

    /// Takes a stroke back.
    pub fn remove(&mut self, a: Point, b: Point) {
        let stroke = self.stroke(a, b);
        for row in stroke.rows.0..stroke.rows.1 {
            let run = stroke.run(row, self.width);
            self.change::<false>(row, run);
        }
    }

    /// Replaces a stroke by one nearby; only where they differ are samples visited.
    pub fn replace(&mut self, old: (Point, Point), new: (Point, Point)) {
        let (old, new) = (self.stroke(old.0, old.1), self.stroke(new.0, new.1));
        for row in old.rows.0.min(new.rows.0)..old.rows.1.max(new.rows.1) {
            let was = old.run_or_none(row, self.width);
            let is = new.run_or_none(row, self.width);
            if was.1 <= is.0 || is.1 <= was.0 {
                self.change::<true>(row, is);
                self.change::<false>(row, was);
            } else {
                self.change::<true>(row, (is.0, was.0));
                self.change::<true>(row, (was.1, is.1));
                self.change::<false>(row, (was.0, is.0));
                self.change::<false>(row, (is.1, was.1));
            }
        }
    }

    #[inline]
    fn change<const UP: bool>(&mut self, row: i32, (from, to): Run) {
        if from >= to {
            return;
        }
        let start = (row * self.width) as usize;
        let run = &mut self.counts[start + from as usize..start + to as usize];
        let mut zeros = 0_u32;
        if UP {
            for count in run {
                zeros += u32::from(*count == 0);
                *count = count.wrapping_add(1);
            }
            self.unswept -= i64::from(zeros);
        } else {
            for count in run {
                *count = count.wrapping_sub(1);
                zeros += u32::from(*count == 0);
            }
            self.unswept += i64::from(zeros);
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

/// A disc moved along a segment, in samples.
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
}

impl Stroke {
    #[inline]
    fn new(a: Vector, b: Vector, radius: f64, height: i32) -> Self {
        let (low, high) = if a.y <= b.y { (a, b) } else { (b, a) };
        let rows = (math::ceil(low.y - radius).max(0), (math::floor(high.y + radius) + 1).min(height));
        let length = (high - low).norm();
        let along = if length > 1e-9 { (high - low) / length } else { Vector::zeros() };
        let inverse = Vector::new(1.0 / along.x, 1.0 / along.y);
        Self { low, high, radius, rows, along, length, inverse, sides: (low.y + radius, high.y - radius) }
    }

    #[inline]
    fn run_or_none(&self, row: i32, width: i32) -> Run {
        if row < self.rows.0 || row >= self.rows.1 { (0, 0) } else { self.run(row, width) }
    }

    /// The samples of a row: convex, so the hull of what both discs and the rectangle between them sweep of it.
    #[inline]
    fn run(&self, row: i32, width: i32) -> Run {
        let y = f64::from(row);
        if y > self.sides.0 && y < self.sides.1 {
            let middle = self.low.x + self.along.x * (y - self.low.y) * self.inverse.y;
            let half = self.radius * self.inverse.y;
            return (math::ceil(middle - half).max(0), (math::floor(middle + half) + 1).min(width));
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
            raster.replace((a, b), (c, d));
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
