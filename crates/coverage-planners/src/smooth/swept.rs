//! How often every part of the floor is swept, on samples.

use crate::lanes::{ToolPlace, across};
use robovac_core::{
    coverage::ReachableFloor,
    geometry::{Point, Vector},
    math,
};

/// Distance of samples, m, and the most of them.
const SPACING: f64 = 0.005;
const MOST: f64 = 1.6e7;
/// Angle of their rows to the floor plan, rad. Curves are chosen by the samples that they leave out: between rows parallel to a
/// wall, they would leave out all that lies between.
const ANGLE: f64 = 0.61;

/// Samples in a row from the first to before the last: row, first, last.
pub(super) type Runs = Vec<(u32, u32, u32)>;

/// Counts of passes on a square raster of samples, askew to the plan.
pub(super) struct SweptCounts<'a> {
    floor: &'a ReachableFloor,
    tool: ToolPlace,
    /// Direction of the rows, and the corner where the raster begins.
    along: Vector,
    low: Vector,
    spacing: f64,
    columns: usize,
    rows: usize,
    counts: Vec<u16>,
}

impl<'a> SweptCounts<'a> {
    pub fn new(floor: &'a ReachableFloor) -> Self {
        let (width, height) = (floor.floor.width() as f64, floor.floor.height() as f64);
        let [width, height] = [width, height].map(|cells| cells * floor.resolution);
        let (sin, cos) = math::sin_cos(ANGLE);
        // The box around the turned plan.
        let (low, size) =
            (Vector::new(0.0, -sin * width), Vector::new(cos * width + sin * height, sin * width + cos * height));
        let spacing = SPACING.max((size.x * size.y / MOST).sqrt());
        let [columns, rows] = [size.x, size.y].map(|metres| (metres / spacing) as usize + 1);
        let (tool, along) = (ToolPlace::of(floor), Vector::new(cos, sin));
        Self { floor, tool, along, low, spacing, columns, rows, counts: vec![0; columns * rows] }
    }

    /// A point of the plan in the raster.
    fn turned(&self, at: Point) -> Vector {
        let (cos, sin) = (self.along.x, self.along.y);
        Vector::new(cos * at.x + sin * at.y, cos * at.y - sin * at.x) - self.low
    }

    /// The inverse.
    fn on_plan(&self, at: Vector) -> Point {
        let (cos, sin, at) = (self.along.x, self.along.y, at + self.low);
        Point::new(cos * at.x - sin * at.y, sin * at.x + cos * at.y)
    }

    /// Area that a sample stands for, m².
    pub fn area_of_sample(&self) -> f64 {
        self.spacing * self.spacing
    }

    /// The samples that the tool sweeps along `points`, each once.
    pub fn runs(&self, points: &[Point]) -> Runs {
        let radius = self.floor.tool_radius;
        let turned = |(a, b)| [self.turned(a), self.turned(b)];
        let strokes: Vec<[Vector; 2]> =
            points.windows(2).map(|pair| turned(self.tool.stroke(pair[0], pair[1]))).collect();
        let ends = || strokes.as_flattened().iter();
        let low = ends().fold(f64::MAX, |low, p| low.min(p.y)) - radius;
        let high = ends().fold(f64::MIN, |high, p| high.max(p.y)) + radius;
        let row = |y: f64| ((y / self.spacing - 0.5).max(0.0) as usize).min(self.rows);
        let mut found = Vec::new();
        let mut across_row: Vec<(f64, f64)> = Vec::new();
        for row in row(low)..(row(high) + 2).min(self.rows) {
            let y = (row as f64 + 0.5) * self.spacing;
            across_row.clear();
            across_row.extend(strokes.iter().filter_map(|&[a, b]| across(a, b, radius, y)));
            across_row.sort_by(|a, b| a.0.total_cmp(&b.0));
            let sample = |x: f64| ((x / self.spacing + 0.5).max(0.0) as usize).min(self.columns) as u32;
            let mut end = 0;
            for &(from, to) in &across_row {
                let (first, last) = (sample(from).max(end), sample(to));
                if first < last {
                    found.push((row as u32, first, last));
                    end = last;
                }
            }
        }
        found
    }

    /// Adds a pass over samples.
    pub fn add(&mut self, runs: &Runs) {
        for run in runs {
            let range = self.range(run);
            self.counts[range].iter_mut().for_each(|count| *count = count.saturating_add(1));
        }
    }

    /// Takes a pass away.
    pub fn take(&mut self, runs: &Runs) {
        for run in runs {
            let range = self.range(run);
            self.counts[range].iter_mut().for_each(|count| *count = count.saturating_sub(1));
        }
    }

    /// How many samples of `runs` lie on the floor and have just `count` passes.
    pub fn with(&self, runs: &Runs, count: u16) -> i64 {
        let mut found = 0;
        for &(row, first, last) in runs {
            for column in first..last {
                if self.counts[row as usize * self.columns + column as usize] == count {
                    let at = Vector::new(f64::from(column) + 0.5, f64::from(row) + 0.5) * self.spacing;
                    found += i64::from(self.floor.floor.is_set(self.floor.cell_at(self.on_plan(at))));
                }
            }
        }
        found
    }

    fn range(&self, &(row, first, last): &(u32, u32, u32)) -> std::ops::Range<usize> {
        let start = row as usize * self.columns;
        start + first as usize..start + last as usize
    }
}
