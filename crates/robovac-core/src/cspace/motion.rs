//! A body that moves through a room without turning, to the nanometre.

use super::{
    CspaceError, HAIR, Outline,
    scene::{ObstacleScene, Sums},
};
use crate::{floor_plan::FloorPlan, geometry::Point};

/// Motion of a body at heading 0: where it is stopped on a line along x, and whether a straight way is free. Obstacles
/// are those of [`super::ConfigurationSpace`].
#[derive(Debug, Clone)]
pub struct Motion {
    scene: ObstacleScene,
    sums: Sums,
}

impl Motion {
    /// For `outline` in `plan`.
    pub fn new(plan: &FloorPlan, outline: &Outline) -> Result<Self, CspaceError> {
        outline.check()?;
        let scene = ObstacleScene::of(plan);
        let sums = scene.sums(outline, 0.0);
        Ok(Self { scene, sums })
    }

    /// The parts of the line at height `y` on which the body's origin can't be, from left to right, apart from each
    /// other; the first comes from -∞, the last goes to ∞.
    pub fn blocked(&self, y: f64) -> Vec<(f64, f64)> {
        let (low, high) = self.sums.reach;
        let (width, height) = self.scene.size;
        if y + low.y < -HAIR || y + high.y > height + HAIR || width + HAIR < high.x - low.x {
            return vec![(f64::NEG_INFINITY, f64::INFINITY)];
        }
        let mut parts = vec![(f64::NEG_INFINITY, -low.x - HAIR), (width - high.x + HAIR, f64::INFINITY)];
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
        let (low, high) = self.sums.reach;
        let (left, right) = (from.x.min(to.x), from.x.max(to.x));
        let (bottom, top) = (from.y.min(to.y), from.y.max(to.y));
        let (width, height) = self.scene.size;
        let is_inside = left + low.x >= -HAIR
            && right + high.x <= width + HAIR
            && bottom + low.y >= -HAIR
            && top + high.y <= height + HAIR;
        let is_near = |&(from, to): &(f64, f64)| from - high.x < right && to - low.x > left;
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
        let rows = self.scene.rows.iter().enumerate().take(last + 1).skip(first);
        rows.map(move |(row, runs)| (row as f64 * side, runs.as_slice())).filter(move |(base, runs)| {
            !runs.is_empty() && base + reach.0 < top.max(bottom + 1e-15) && base + reach.1 > bottom
        })
    }
}
