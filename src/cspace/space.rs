//! The configuration space.

use super::{CspaceError, HAIR, Outline, bits::Bits, outline::bounds, sum::Sum};
use crate::{
    coverage::{drop_offs, obstacles},
    floorplan::FloorPlan,
    geometry::{Point, Shape},
    grid::{Cell, Grid},
    math,
};

/// Most memory that a configuration space takes, bytes.
pub const MAX_BYTES: usize = 256 << 20;
/// Most cells of a slice, which is handed out with a byte a cell.
const MAX_SLICE: usize = 1 << 26;

/// Cells FREE or FULL over x, y and heading, bit by bit.
///
/// A cell is FULL if the body, its origin at the cell's centre and turned by the cell's heading, overlaps - by more than a
/// nanometre, so touching is no overlap - a cell of the plan that isn't known to be free, an object that stands in the way (the
/// same shapes as for [`crate::coverage::ReachableFloor`], drop-offs among them) or the outside. Exact for convex outlines and for
/// others, which are cut into convex pieces.
#[derive(Debug, Clone)]
pub struct ConfigurationSpace {
    /// Side of a cell, m.
    pub cell: f64,
    /// Number of headings, spread evenly over the full circle; the first is 0.
    pub headings: usize,
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// FULL cells of every heading; of one if all are the same.
    layers: Vec<Bits>,
}

impl ConfigurationSpace {
    /// The configuration space of a body in a room. O(obstacles x rows that each takes) for every heading.
    pub fn new(plan: &FloorPlan, outline: &Outline, cell: f64, headings: usize) -> Result<Self, CspaceError> {
        outline.check()?;
        if !(cell.is_finite() && cell > 0.0) {
            return Err(CspaceError::Cell(cell));
        }
        let headings = headings.max(1);
        let cells = |length: f64| ((length / cell - 1e-6).ceil() as usize).max(1);
        let (width, height) = (cells(plan.width_m()), cells(plan.height_m()));
        // A circle is the same at every heading.
        let layers = if matches!(outline, Outline::Circle { .. }) { 1 } else { headings };
        let bytes = Bits::words(width, height).saturating_mul(8).saturating_mul(layers);
        if bytes > MAX_BYTES || width.saturating_mul(height) > MAX_SLICE {
            return Err(CspaceError::TooLarge { width, height, headings });
        }
        let scene = Scene::of(plan);
        let layer = |heading: usize| {
            let mut canvas = Canvas { bits: Bits::new(width, height), cell, width, height };
            canvas.draw(&scene, outline, heading as f64 * (math::TAU / headings as f64));
            canvas.bits
        };
        Ok(Self { cell, headings, width, height, layers: (0..layers).map(layer).collect() })
    }

    /// Whether the body fits with its origin in the centre of `cell` at heading number `heading`, counted round the circle.
    #[inline]
    pub fn is_free(&self, cell: Cell, heading: usize) -> bool {
        let is_inside = (0..self.width as i32).contains(&cell.x) && (0..self.height as i32).contains(&cell.y);
        is_inside && !self.layers[heading % self.layers.len()].get(cell.x as usize, cell.y as usize)
    }

    /// The slice of one heading: which cells are FREE.
    pub fn slice(&self, heading: usize) -> Grid<bool> {
        let mut slice = Grid::filled(self.width, self.height, false);
        let layer = &self.layers[heading % self.layers.len()];
        for (y, row) in slice.values_mut().chunks_mut(self.width).enumerate() {
            for (x, is_free) in row.iter_mut().enumerate() {
                *is_free = !layer.get(x, y);
            }
        }
        slice
    }

    /// Memory taken, bytes.
    pub fn bytes(&self) -> usize {
        8 * Bits::words(self.width, self.height) * self.layers.len()
    }
}

/// What a body can't go through.
struct Scene {
    /// Side of the plan's cells, m.
    resolution: f64,
    /// Width and height, m.
    size: (f64, f64),
    /// Left and right end of every run of cells that aren't free, m, row by row from the bottom.
    rows: Vec<Vec<(f64, f64)>>,
    shapes: Vec<Shape>,
}

impl Scene {
    fn of(plan: &FloorPlan) -> Self {
        let resolution = plan.resolution;
        let columns = plan.occupancy.width();
        let rows = plan.occupancy.values().chunks(columns).map(|row| {
            let (mut runs, mut x) = (Vec::new(), 0);
            while x < columns {
                let is_free = row[x].is_free();
                let end = row[x..].iter().position(|o| o.is_free() != is_free).map_or(columns, |run| x + run);
                if !is_free {
                    runs.push((x as f64 * resolution, end as f64 * resolution));
                }
                x = end;
            }
            runs
        });
        let mut shapes = obstacles(plan);
        shapes.extend(drop_offs(plan));
        Self { resolution, size: (plan.width_m(), plan.height_m()), rows: rows.collect(), shapes }
    }
}

/// A slice in the making.
struct Canvas {
    bits: Bits,
    cell: f64,
    width: usize,
    height: usize,
}

impl Canvas {
    fn draw(&mut self, scene: &Scene, outline: &Outline, heading: f64) {
        let pieces = outline.pieces(heading);
        let reach = match outline {
            Outline::Circle { .. } => outline.bounds(),
            Outline::Polygon(_) => bounds(&pieces.concat()),
        };
        self.draw_outside(scene, reach);
        // Where the outline overlaps an upright line as high as a cell of the plan, at the origin.
        let line = [Point::origin(), Point::new(0.0, scene.resolution)];
        match outline {
            Outline::Circle { radius } => {
                self.draw_runs(scene, &Sum::of_round(&line, *radius));
                for shape in &scene.shapes {
                    self.draw_sum(&match shape {
                        Shape::Disc { centre, radius: own } => Sum::of_round(&[*centre], radius + own),
                        Shape::Convex(corners) => Sum::of_round(corners, *radius),
                    });
                }
            }
            Outline::Polygon(_) => {
                for piece in &pieces {
                    self.draw_runs(scene, &Sum::of_polygons(&line, piece));
                    for shape in &scene.shapes {
                        self.draw_sum(&match shape {
                            Shape::Disc { centre, radius } => Sum::of_disc(*centre, *radius, piece),
                            Shape::Convex(corners) => Sum::of_polygons(corners, piece),
                        });
                    }
                }
            }
        }
    }

    /// Columns or rows whose centres lie between two places, ends left out by a hair; may be outside.
    #[inline]
    fn between(&self, low: f64, high: f64) -> (i32, i32) {
        (math::ceil(low / self.cell - 0.5), math::floor(high / self.cell - 0.5))
    }

    /// The rows among them that there are.
    fn rows(&self, (low, high): (f64, f64)) -> std::ops::RangeInclusive<i32> {
        let (first, last) = self.between(low, high);
        first.max(0)..=last.min(self.height as i32 - 1)
    }

    fn centre(&self, row: i32) -> f64 {
        (f64::from(row) + 0.5) * self.cell
    }

    #[inline]
    fn fill(&mut self, row: i32, low: f64, high: f64) {
        let (first, last) = self.between(low, high);
        let (first, last) = (first.max(0), last.min(self.width as i32 - 1));
        if first <= last {
            self.bits.set(row as usize, first as usize, last as usize);
        }
    }

    /// Makes FULL what is too near to the edge of the plan for an outline that reaches from `low` to `high`.
    fn draw_outside(&mut self, scene: &Scene, (low, high): (Point, Point)) {
        let inside = self.rows((-low.y - HAIR, scene.size.1 - high.y + HAIR));
        let (first, last) = self.between(-low.x - HAIR, scene.size.0 - high.x + HAIR);
        let columns = self.width as i32;
        for row in 0..self.height as i32 {
            if !inside.contains(&row) || first > last {
                self.bits.set(row as usize, 0, self.width - 1);
                continue;
            }
            if first > 0 {
                self.bits.set(row as usize, 0, (first.min(columns) - 1) as usize);
            }
            if last + 1 < columns {
                self.bits.set(row as usize, (last + 1).max(0) as usize, self.width - 1);
            }
        }
    }

    /// Makes FULL what overlaps the cells of the plan. `sum` is that of an upright line at the origin: what it says of a row holds for
    /// every run of cells, its left end for their left and its right end for their right.
    fn draw_runs(&mut self, scene: &Scene, sum: &Sum) {
        let (low, high) = sum.rows();
        for (runs, number) in scene.rows.iter().zip(0..) {
            if runs.is_empty() {
                continue;
            }
            let bottom = f64::from(number) * scene.resolution;
            for row in self.rows((bottom + low, bottom + high)) {
                let (left, right) = sum.across(self.centre(row) - bottom);
                if left == f64::MAX {
                    continue;
                }
                for &(from, to) in runs {
                    self.fill(row, from + left, to + right);
                }
            }
        }
    }

    fn draw_sum(&mut self, sum: &Sum) {
        for row in self.rows(sum.rows()) {
            let (low, high) = sum.across(self.centre(row));
            self.fill(row, low, high);
        }
    }
}
