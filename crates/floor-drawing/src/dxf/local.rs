//! Blocks and model space in their own coordinates, before blocks are inserted.

use crate::{DrawingFlaw, model::MAX_POINTS};
use robovac_core::geometry::{Point, Vector};
use std::ops::Range;

/// Most inserts of a drawing, those that inserted blocks bring along too (ours): one for every corner that it can have.
pub(super) const MAX_INSERTS: usize = MAX_POINTS;

/// Where an entity comes from, for messages and for [`crate::Stroke::entity`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct EntitySource {
    /// Its number in its block or in model space, counted from 1.
    pub number: u32,
    /// Index of its layer.
    pub layer: u32,
    /// Line or byte at which it begins.
    pub at: usize,
    /// Index of what holds it, see [`DxfContent::bodies`].
    pub body: usize,
}

/// What is wrong with an entity.
pub(super) type RefusedEntity = (EntitySource, DrawingFlaw);

/// A polyline of a block.
pub(super) struct LocalStroke {
    pub source: EntitySource,
    pub is_closed: bool,
    pub points: Range<usize>,
}

/// A block inserted into another one or into model space.
pub(super) struct Insert {
    pub source: EntitySource,
    /// Name of the block, in upper case.
    pub block: String,
    pub map: Affine,
    /// Columns and rows.
    pub count: [u32; 2],
    /// From one column and one row to the next.
    pub step: [Vector; 2],
}

/// Model space or a block.
pub(super) struct DxfBlock {
    pub name: String,
    pub base: Point,
    pub strokes: Range<usize>,
    pub inserts: Range<usize>,
}

/// All that is drawn in a file. The first body is model space.
pub(super) struct DxfContent {
    pub bodies: Vec<DxfBlock>,
    pub strokes: Vec<LocalStroke>,
    pub inserts: Vec<Insert>,
    pub points: Vec<Point>,
}

impl DxfContent {
    pub fn new() -> Self {
        let model = DxfBlock { name: String::new(), base: Point::origin(), strokes: 0..0, inserts: 0..0 };
        Self { bodies: vec![model], strokes: Vec::new(), inserts: Vec::new(), points: Vec::new() }
    }

    /// Adds a polyline, if it has a length. What one body holds must come in one go.
    pub fn stroke(
        &mut self,
        source: EntitySource,
        is_closed: bool,
        points: impl IntoIterator<Item = Point>,
    ) -> Result<(), DrawingFlaw> {
        let start = self.points.len();
        self.points.extend(points);
        if self.points.len() > MAX_POINTS {
            return Err(DrawingFlaw::TooMany { what: "corners", most: MAX_POINTS });
        }
        if self.points.len() < start + 2 {
            self.points.truncate(start);
            return Ok(());
        }
        self.strokes.push(LocalStroke { source, is_closed, points: start..self.points.len() });
        let end = self.strokes.len();
        let range = &mut self.bodies[source.body].strokes;
        *range = if range.start == range.end { end - 1..end } else { range.start..end };
        Ok(())
    }

    /// Adds an insert.
    pub fn insert(&mut self, insert: Insert) -> Result<(), DrawingFlaw> {
        if self.inserts.len() >= MAX_INSERTS {
            return Err(DrawingFlaw::TooMany { what: "inserts", most: MAX_INSERTS });
        }
        let body = insert.source.body;
        self.inserts.push(insert);
        let end = self.inserts.len();
        let range = &mut self.bodies[body].inserts;
        *range = if range.start == range.end { end - 1..end } else { range.start..end };
        Ok(())
    }
}

/// A linear map and a displacement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Affine {
    /// Where (1, 0) goes, less the displacement.
    pub x: Vector,
    /// Where (0, 1) goes, less the displacement.
    pub y: Vector,
    /// Where the origin goes.
    pub origin: Vector,
}

impl Affine {
    pub const IDENTITY: Self =
        Self { x: Vector::new(1.0, 0.0), y: Vector::new(0.0, 1.0), origin: Vector::new(0.0, 0.0) };

    /// Where a displacement goes.
    pub fn turn(&self, v: Vector) -> Vector {
        self.x * v.x + self.y * v.y
    }

    /// Where a point goes.
    pub fn apply(&self, point: Point) -> Point {
        Point::from(self.turn(point.coords) + self.origin)
    }

    /// First `inner`, then this one.
    pub fn after(&self, inner: &Self) -> Self {
        Self { x: self.turn(inner.x), y: self.turn(inner.y), origin: self.turn(inner.origin) + self.origin }
    }

    /// The same, moved by `step`.
    pub fn moved(&self, step: Vector) -> Self {
        Self { origin: self.origin + step, ..*self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entities_that_draw_nothing_do_not_pile_up() {
        let source = EntitySource { number: 1, layer: 0, at: 1, body: 0 };
        let mut content = DxfContent::new();
        assert!(content.stroke(source, true, []).is_ok() && content.stroke(source, false, [Point::origin()]).is_ok());
        assert!(content.strokes.is_empty() && content.points.is_empty());
        let mut insert = || {
            let (map, step) = (Affine::IDENTITY, [Vector::zeros(); 2]);
            content.insert(Insert { source, block: String::new(), map, count: [1; 2], step })
        };
        assert!((0..MAX_INSERTS).all(|_| insert().is_ok()));
        assert!(matches!(insert(), Err(DrawingFlaw::TooMany { what: "inserts", .. })));
    }
}
