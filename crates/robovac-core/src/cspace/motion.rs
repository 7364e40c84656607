//! A body that moves through a room without turning, to the nanometre.

use super::{
    CspaceError, FreeSteps, HAIR, Outline,
    scene::{ObstacleScene, Sums},
};
use crate::{
    floor_plan::FloorPlan,
    geometry::{Point, Vector},
};

/// Motion of a body at heading 0: where it is stopped on a line along x, and whether a straight way is free. Obstacles
/// are those of [`super::ConfigurationSpace`].
#[derive(Debug, Clone)]
pub struct Motion {
    scene: ObstacleScene,
    outline: Outline,
    sums: Sums,
    /// The distance that it keeps, m; below 0 it may overlap as much.
    margin: f64,
}

impl Motion {
    /// For `outline` in `plan`. `clearance` is the distance that it keeps from everything, m; with 0 it may touch, and
    /// an overlap up to a nanometre counts as touching.
    pub fn new(plan: &FloorPlan, outline: &Outline, clearance: f64) -> Result<Self, CspaceError> {
        outline.check()?;
        let scene = ObstacleScene::of(plan);
        let margin = if clearance > 0.0 { clearance } else { -HAIR };
        let sums = scene.sums(outline, 0.0, Vector::zeros(), margin);
        Ok(Self { scene, outline: outline.clone(), sums, margin })
    }

    /// The body.
    pub fn outline(&self) -> &Outline {
        &self.outline
    }

    /// The cells of `cell` metres in whose centres the body fits, with the steps between them. O(obstacles x rows that
    /// each takes).
    pub fn steps(&self, cell: f64) -> Result<FreeSteps, CspaceError> {
        FreeSteps::new(&self.scene, &self.outline, cell, self.margin)
    }

    /// The parts of the line at height `y` on which the body's origin can't be, from left to right, apart from each
    /// other; the first comes from -∞, the last goes to ∞.
    pub fn blocked(&self, y: f64) -> Vec<(f64, f64)> {
        let ((low, high), margin) = (self.sums.reach, self.margin);
        let (width, height) = self.scene.size;
        if y + low.y < margin || y + high.y > height - margin || width - margin < high.x - low.x {
            return vec![(f64::NEG_INFINITY, f64::INFINITY)];
        }
        let mut parts = vec![(f64::NEG_INFINITY, -low.x + margin), (width - high.x - margin, f64::INFINITY)];
        for sum in &self.sums.line {
            for (bottom, runs) in self.rows_near(sum.rows(), (y, y)) {
                let (left, right) = sum.across(y - bottom);
                parts.extend(runs.iter().map(|&(from, to)| (from + left, to + right)));
            }
        }
        for sum in &self.sums.shapes {
            let (bottom, top) = sum.rows();
            if bottom < y && y < top {
                parts.push(sum.across(y));
            }
        }
        parts.retain(|part| part.0 < part.1);
        parts.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        parts.dedup_by(|next, last| {
            let is_one = next.0 <= last.1;
            if is_one {
                last.1 = last.1.max(next.1);
            }
            is_one
        });
        parts
    }

    /// Whether the body can move straight from `from` to `to`.
    pub fn is_free(&self, from: Point, to: Point) -> bool {
        let ((low, high), margin) = (self.sums.reach, self.margin);
        let (left, right) = (from.x.min(to.x), from.x.max(to.x));
        let (bottom, top) = (from.y.min(to.y), from.y.max(to.y));
        let (width, height) = self.scene.size;
        let is_inside = left + low.x >= margin
            && right + high.x <= width - margin
            && bottom + low.y >= margin
            && top + high.y <= height - margin;
        let is_near = |&(from, to): &(f64, f64)| from - high.x - margin < right && to - low.x + margin > left;
        let meets_run = self.sums.line.iter().any(|sum| {
            self.rows_near(sum.rows(), (bottom, top)).any(|(base, runs)| {
                let (from, to) = (Point::new(from.x, from.y - base), Point::new(to.x, to.y - base));
                runs.iter().filter(|run| is_near(run)).any(|&run| sum.meets(from, to, run))
            })
        });
        let meets_shape = || {
            let is_level = |rows: (f64, f64)| rows.0 < top && rows.1 > bottom;
            self.sums.shapes.iter().any(|sum| is_level(sum.rows()) && sum.meets(from, to, (0.0, 0.0)))
        };
        is_inside && !meets_run && !meets_shape()
    }

    /// Rows of the plan that a body between two heights can touch, by the height of their lower edge; `reach` is the
    /// region in which it touches a row at the origin.
    fn rows_near(&self, reach: (f64, f64), (bottom, top): (f64, f64)) -> impl Iterator<Item = (f64, &[(f64, f64)])> {
        let side = self.scene.resolution;
        let first = ((bottom - reach.1) / side).floor().max(0.0) as usize;
        let last = ((top - reach.0) / side).ceil().max(0.0) as usize;
        let rows = self.scene.rows.iter().flat_map(move |rows| rows.iter().enumerate().take(last + 1).skip(first));
        rows.map(move |(row, runs)| (row as f64 * side, runs.as_slice())).filter(move |(base, runs)| {
            !runs.is_empty() && base + reach.0 < top.max(bottom + 1e-15) && base + reach.1 > bottom
        })
    }
}
