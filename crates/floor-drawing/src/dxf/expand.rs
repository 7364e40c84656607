//! Inserts blocks into model space.

use super::{
    local::{Affine, DxfContent, EntitySource, Insert, MAX_INSERTS, RefusedEntity},
    scan::{Scanned, Stopped},
};
use crate::{
    DrawingFlaw,
    model::{Builder, MAX_POINTS},
};
use std::collections::BTreeMap;

/// Deepest nesting of blocks.
const MAX_DEPTH: usize = 64;

/// Draws model space with everything inserted into it. The size is checked before anything is drawn.
pub(super) fn expand(scanned: &mut Scanned) -> Result<(), Stopped> {
    let Scanned { content, builder, is_text, .. } = scanned;
    let mut by_name = BTreeMap::new();
    for (index, body) in content.bodies.iter().enumerate().skip(1) {
        by_name.entry(body.name.to_uppercase()).or_insert(index);
    }
    let mut count = Count { content, by_name, sizes: vec![None; content.bodies.len()], path: Vec::new() };
    let stop = |builder: &Builder, (source, flaw): RefusedEntity| (content.place(&source, builder, *is_text), flaw);
    count.body(0).map_err(|refused| stop(builder, refused))?;
    let Count { by_name, sizes, .. } = count;
    let zero = builder.layer("0").map_err(|flaw| (String::new(), flaw))?;
    let mut draw = BlockExpander { content, by_name: &by_name, sizes: &sizes, builder, zero, missing: 0 };
    let drawn = draw.body(0, &Affine::IDENTITY, None);
    let missing = draw.missing;
    drawn.map_err(|refused| stop(builder, refused))?;
    builder.leave_out("inserts of blocks that aren't in the file", missing);
    Ok(())
}

/// The size of a body with everything inserted into it.
#[derive(Clone, Copy)]
struct Size {
    corners: u64,
    /// Inserts visited to draw it.
    inserts: u64,
}

struct Count<'a> {
    content: &'a DxfContent,
    by_name: BTreeMap<String, usize>,
    sizes: Vec<Option<Size>>,
    /// Bodies that are being counted, outermost first.
    path: Vec<usize>,
}

impl Count<'_> {
    fn body(&mut self, index: usize) -> Result<Size, RefusedEntity> {
        if let Some(size) = self.sizes[index] {
            return Ok(size);
        }
        let body = &self.content.bodies[index];
        let own: usize = self.content.strokes[body.strokes.clone()].iter().map(|stroke| stroke.points.len()).sum();
        let mut size = Size { corners: own as u64, inserts: body.inserts.len() as u64 };
        self.path.push(index);
        for insert in &self.content.inserts[body.inserts.clone()] {
            let Some(&inserted) = self.by_name.get(&insert.block.to_uppercase()) else { continue };
            let name = || self.content.bodies[inserted].name.clone();
            if let Some(place) = self.path.iter().position(|&outer| outer == inserted) {
                let through = self.path[place + 1..].iter().map(|&body| self.content.bodies[body].name.clone());
                return Err((insert.source, DrawingFlaw::Cycle { block: name(), through: through.collect() }));
            }
            if self.path.len() > MAX_DEPTH {
                return Err((insert.source, DrawingFlaw::Depth { block: name(), most: MAX_DEPTH }));
            }
            let [columns, rows] = insert.count.map(u64::from);
            let each = self.body(inserted)?;
            // Rows and columns of nothing are still nothing.
            if each.corners == 0 {
                continue;
            }
            size.corners = size.corners.saturating_add(each.corners.saturating_mul(columns * rows));
            size.inserts = size.inserts.saturating_add((each.inserts + 1).saturating_mul(columns * rows) - 1);
            let refused = if size.corners > MAX_POINTS as u64 {
                DrawingFlaw::TooMany { what: "corners", most: MAX_POINTS }
            } else if size.inserts > MAX_INSERTS as u64 {
                DrawingFlaw::TooMany { what: "inserts", most: MAX_INSERTS }
            } else {
                continue;
            };
            return Err((insert.source, refused));
        }
        self.path.pop();
        self.sizes[index] = Some(size);
        Ok(size)
    }
}

struct BlockExpander<'a> {
    content: &'a DxfContent,
    by_name: &'a BTreeMap<String, usize>,
    sizes: &'a [Option<Size>],
    builder: &'a mut Builder,
    /// Index of layer 0, whose entities take the insert's layer.
    zero: u32,
    missing: usize,
}

impl BlockExpander<'_> {
    /// Draws a body; `from` is the insert of model space that it comes from, with the layer that replaces layer 0.
    fn body(&mut self, index: usize, map: &Affine, from: Option<EntitySource>) -> Result<(), RefusedEntity> {
        let body = &self.content.bodies[index];
        for stroke in &self.content.strokes[body.strokes.clone()] {
            let source = self.seen_as(stroke.source, from);
            let points = self.content.points[stroke.points.clone()].iter().map(|&point| map.apply(point));
            self.builder
                .stroke(source.layer, source.number, stroke.is_closed, points)
                .map_err(|flaw| (stroke.source, flaw))?;
        }
        for insert in &self.content.inserts[body.inserts.clone()] {
            self.insert(insert, map, self.seen_as(insert.source, from))?;
        }
        Ok(())
    }

    fn seen_as(&self, source: EntitySource, from: Option<EntitySource>) -> EntitySource {
        match from {
            Some(from) => {
                EntitySource { layer: if source.layer == self.zero { from.layer } else { source.layer }, ..from }
            }
            None => source,
        }
    }

    fn insert(&mut self, insert: &Insert, map: &Affine, source: EntitySource) -> Result<(), RefusedEntity> {
        let Some(&inserted) = self.by_name.get(&insert.block.to_uppercase()) else {
            self.missing += 1;
            return Ok(());
        };
        if self.sizes[inserted].is_none_or(|size| size.corners == 0) {
            return Ok(());
        }
        let base = self.content.bodies[inserted].base.coords;
        let moved = insert.map.moved(-insert.map.turn(base));
        for row in 0..insert.count[1] {
            for column in 0..insert.count[0] {
                let step = insert.step[0] * f64::from(column) + insert.step[1] * f64::from(row);
                self.body(inserted, &map.after(&moved.moved(step)), Some(source))?;
            }
        }
        Ok(())
    }
}
