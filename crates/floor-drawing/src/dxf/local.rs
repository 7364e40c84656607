//! Blocks and model space in their own coordinates, before blocks are inserted.

use crate::{DrawingFlaw, model::MAX_POINTS};
use robovac_core::geometry::{Point, Vector};
use std::ops::Range;

/// Most inserts of a drawing, nested ones included (ours): one for every corner that it can have.
pub(super) const MAX_INSERTS: usize = MAX_POINTS;

/// The origin of an entity, for messages and for [`crate::Stroke::entity`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct EntitySource {
    /// Its number in its block or in model space, counted from 1.
    pub number: u32,
    /// Index of its layer.
    pub layer: u32,
    /// Line or byte at which it begins.
    pub at: usize,
    /// Index of the body that contains it, see [`DxfContent::bodies`].
    pub body: usize,
}

/// A refused entity and its flaw.
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
    /// Displacement from one column and one row to the next.
    pub step: [Vector; 2],
}

/// Model space or a block.
pub(super) struct DxfBlock {
    pub name: String,
    pub base: Point,
    pub strokes: Range<usize>,
    pub inserts: Range<usize>,
}

/// The drawn content of a file. The first body is model space.
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

    /// Adds a polyline, if its length isn't 0. All parts of a body must be added consecutively.
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

/// An affine map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Affine {
    /// Image of (1, 0), less the displacement.
    pub x: Vector,
    /// Image of (0, 1), less the displacement.
    pub y: Vector,
    /// Image of the origin.
    pub origin: Vector,
}

impl Affine {
    pub const IDENTITY: Self =
        Self { x: Vector::new(1.0, 0.0), y: Vector::new(0.0, 1.0), origin: Vector::new(0.0, 0.0) };

    /// Image of a displacement.
    pub fn turn(&self, v: Vector) -> Vector {
        self.x * v.x + self.y * v.y
    }

    /// Image of a point.
    pub fn apply(&self, point: Point) -> Point {
        Point::from(self.turn(point.coords) + self.origin)
    }

    /// The composition: first `inner`, then this map.
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
