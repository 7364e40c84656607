//! The configuration space.

use super::{
    CspaceError, HAIR, Outline,
    bits::Bits,
    canvas::BitCanvas,
    scene::{ObstacleScene, Sums},
    sum::Sum,
};
use crate::{
    floor_plan::FloorPlan,
    geometry::{Point, Vector},
    grid::{Cell, Grid},
    math,
};

/// Largest size of a configuration space, bytes.
pub const MAX_BYTES: usize = 256 << 20;
/// Most cells of a slice, which is returned with a byte per cell.
const MAX_SLICE: usize = 1 << 26;

/// Cells FREE or FULL over x, y and heading, bit by bit.
///
/// A cell is FULL if the body, its origin at the cell's centre and turned by the cell's heading, overlaps - by more
/// than a nanometre, so touching is no overlap - a cell of the plan that isn't known to be free, an object that
/// stands in the way (the same shapes as for [`crate::coverage::ReachableFloor`], drop-offs among them) or the
/// outside. Exact for convex outlines and for others, which are cut into convex pieces.
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
    /// FULL cells of every heading; a single layer if all are the same.
    layers: Vec<Bits>,
}

impl ConfigurationSpace {
    /// The configuration space of a body in a room. O(obstacles x rows that each takes) for every heading.
    pub fn new(plan: &FloorPlan, outline: &Outline, cell: f64, headings: usize) -> Result<Self, CspaceError> {
        outline.check()?;
        let headings = headings.max(1);
        // A circle is the same at every heading.
        let layers = if matches!(outline, Outline::Circle { .. }) { 1 } else { headings };
        let (width, height) = size(plan.width_m(), plan.height_m(), cell, headings, layers)?;
        let scene = ObstacleScene::of(plan);
        let layer = |heading: usize| {
            let mut slice = Slice { canvas: BitCanvas::new(width, height, cell) };
            let heading = heading as f64 * (math::TAU / headings as f64);
            let sums = scene.sums(outline, heading, Vector::zeros(), -HAIR);
            slice.draw_walls(&scene, &sums, -HAIR);
            slice.draw_obstacles(&scene, &sums);
            slice.canvas.bits
        };
        Ok(Self { cell, headings, width, height, layers: (0..layers).map(layer).collect() })
    }

    /// Whether the body fits with its origin in the centre of `cell` at heading number `heading`, counted round the
    /// circle.
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
}

/// Columns and rows of a map of a room of that size, m, unless they are too many.
pub(super) fn size(
    width_m: f64,
    height_m: f64,
    cell: f64,
    headings: usize,
    layers: usize,
) -> Result<(usize, usize), CspaceError> {
    if !(cell.is_finite() && cell > 0.0) {
        return Err(CspaceError::Cell(cell));
    }
    let cells = |length: f64| ((length / cell - 1e-6).ceil() as usize).max(1);
    let (width, height) = (cells(width_m), cells(height_m));
    let bytes = Bits::words(width, height).saturating_mul(8).saturating_mul(layers);
    if bytes > MAX_BYTES || width.saturating_mul(height) > MAX_SLICE {
        return Err(CspaceError::TooLarge { width, height, headings });
    }
    Ok((width, height))
}

/// A slice under construction.
pub(super) struct Slice {
    /// What is FULL so far.
    pub canvas: BitCanvas,
}

impl Slice {
    /// Makes cells FULL where the outline would leave the plan or overlap its walls; `margin` is that of the sums.
    pub fn draw_walls(&mut self, scene: &ObstacleScene, sums: &Sums, margin: f64) {
        self.draw_outside(scene, sums.reach, margin);
        sums.line.iter().for_each(|sum| self.draw_runs(scene, &scene.rows[0], sum));
    }

    /// Makes cells FULL where the outline would overlap obstacles.
    pub fn draw_obstacles(&mut self, scene: &ObstacleScene, sums: &Sums) {
        sums.line.iter().for_each(|sum| self.draw_runs(scene, &scene.rows[1], sum));
        sums.shapes.iter().for_each(|sum| self.canvas.draw(sum));
    }

    /// Makes cells FULL that are too near to the edge of the plan for an outline that reaches from `low` to `high`.
    fn draw_outside(&mut self, scene: &ObstacleScene, (low, high): (Point, Point), margin: f64) {
        let canvas = &mut self.canvas;
        let inside = canvas.rows((-low.y + margin, scene.size.1 - high.y - margin));
        let (first, last) = canvas.between(-low.x + margin, scene.size.0 - high.x - margin);
        let columns = canvas.width as i32;
        for row in 0..canvas.height as i32 {
            if !inside.contains(&row) || first > last {
                canvas.bits.set(row as usize, 0, canvas.width - 1);
                continue;
            }
            if first > 0 {
                canvas.bits.set(row as usize, 0, (first.min(columns) - 1) as usize);
            }
            if last + 1 < columns {
                canvas.bits.set(row as usize, (last + 1).max(0) as usize, canvas.width - 1);
            }
        }
    }

    /// Makes cells FULL that overlap the cells of the plan. `sum` is that of a vertical line at the origin: its extent
    /// in a row holds for every run of cells, its left end for their left and its right end for their right.
    fn draw_runs(&mut self, scene: &ObstacleScene, rows: &[Vec<(f64, f64)>], sum: &Sum) {
        let canvas = &mut self.canvas;
        let (low, high) = sum.rows();
        for (runs, number) in rows.iter().zip(0..) {
            if runs.is_empty() {
                continue;
            }
            let bottom = f64::from(number) * scene.resolution;
            for row in canvas.rows((bottom + low, bottom + high)) {
                let (left, right) = sum.across(canvas.centre(row) - bottom);
                if left == f64::MAX {
                    continue;
                }
                // Runs that merge are filled at once.
                let mut all = (f64::MAX, f64::MIN);
                for &(from, to) in runs {
                    let (from, to) = (from + left, to + right);
                    if from > all.1 {
                        canvas.fill(row, all.0, all.1);
                        all.0 = from;
                    }
                    all.1 = to;
                }
                canvas.fill(row, all.0, all.1);
            }
        }
    }
}
