//! Positions of obstacles, finer than cells: boundary patches.

use super::TiledLayer;
use robovac_core::{
    geometry::{Point, Vector},
    grid::Cell,
};

/// Side of the cells that hold one patch each, m.
const SIDE: f64 = 0.05;
/// Cosine between normals of patches that count as one surface.
const SAME: f64 = 0.8;
/// Points after which a patch doesn't move any more: earlier observations have less drift (ours).
const MOST: f32 = 40.0;

/// A few centimetres of a surface, assumed flat.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct BoundaryPatch {
    /// Points that it is the mean of; 0 for none.
    weight: f32,
    /// Position relative to the centre of its cell, m.
    offset: [f32; 2],
    /// Outward normal, towards free floor; a unit vector.
    normal: [f32; 2],
    /// Distance driven when it was found, m.
    found: f32,
}

/// Patches of boundary, one a cell.
#[derive(Debug, Clone)]
pub(super) struct BoundaryPatches(TiledLayer<BoundaryPatch>);

/// A patch in the form for the filter.
#[derive(Debug, Clone, Copy)]
pub(super) struct FlatPatch {
    pub point: Point,
    pub normal: Vector,
    /// Distance driven when it was found, m.
    pub found: f64,
}

impl BoundaryPatches {
    pub fn new() -> Self {
        Self(TiledLayer::new())
    }

    /// Adds a point with its normal, found after a distance in metres.
    pub fn add(&mut self, point: Point, normal: Vector, way: f64) {
        let cell = Cell::at(point, SIDE);
        let offset = point - cell.centre(SIDE);
        let (offset, normal) = ([offset.x as f32, offset.y as f32], [normal.x as f32, normal.y as f32]);
        let (weight, found) = (1.0, way as f32);
        self.0.update(cell, |old| {
            let fresh = BoundaryPatch { weight, offset, normal, found };
            if old.weight == 0.0 {
                return fresh;
            }
            let agree = f64::from(old.normal[0] * normal[0] + old.normal[1] * normal[1]);
            if agree < SAME {
                // An edge of an object: the better known patch is kept.
                let weaker = BoundaryPatch { weight: old.weight - 0.5 * weight, ..old };
                return if weaker.weight > 0.0 { weaker } else { fresh };
            }
            let sum = old.weight + weight;
            let mean = |a: [f32; 2], b: [f32; 2]| [0, 1].map(|i| (a[i] * old.weight + b[i] * weight) / sum);
            let blend = mean(old.normal, normal);
            let length = (blend[0] * blend[0] + blend[1] * blend[1]).sqrt().max(1e-6);
            BoundaryPatch {
                weight: sum.min(MOST),
                offset: mean(old.offset, offset),
                normal: blend.map(|v| v / length),
                ..old
            }
        });
    }

    /// The best patch for an observed point within `reach` cells: the one with the nearest surface, among those beside
    /// the point rather than along the surface from it. `facing` is the point's normal, or about the direction from
    /// which it was observed; only patches whose normal is within that cosine of it are considered.
    pub fn nearest(&self, point: Point, facing: Vector, cosine: f64, reach: i32) -> Option<FlatPatch> {
        let cell = Cell::at(point, SIDE);
        let mut best: Option<(f64, FlatPatch)> = None;
        for y in cell.y - reach..=cell.y + reach {
            for x in cell.x - reach..=cell.x + reach {
                let at = Cell::new(x, y);
                let patch = self.0.get(at);
                if patch.weight == 0.0 {
                    continue;
                }
                let normal = Vector::new(f64::from(patch.normal[0]), f64::from(patch.normal[1]));
                if normal.dot(&facing) < cosine {
                    continue;
                }
                let centre = at.centre(SIDE);
                let surface = Point::new(centre.x + f64::from(patch.offset[0]), centre.y + f64::from(patch.offset[1]));
                let off = point - surface;
                let (height, aside) = (normal.dot(&off), normal.perp(&off));
                if aside.abs() > 1.5 * SIDE {
                    continue;
                }
                let distance = height * height + 0.5 * aside * aside;
                if best.is_none_or(|(least, _)| distance < least) {
                    best = Some((distance, FlatPatch { point: surface, normal, found: f64::from(patch.found) }));
                }
            }
        }
        best.map(|(_, surface)| surface)
    }

    /// Approximate memory, bytes.
    pub fn bytes(&self) -> usize {
        self.0.bytes()
    }
}
