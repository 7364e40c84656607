//! Areas that are painted dark: walls that are drawn as what they cover.

use super::{frame::RasterFrame, raster::RasterCanvas, solids::in_cells};
use crate::{AreaFill, Drawing, DrawingFlaw, Role};

/// Sets the cells of walls that are painted dark, and not covered by anything light. All strokes of an entity are one area. The
/// roles of light areas don't matter: rooms are often painted over walls; furniture isn't.
pub(super) fn paint_walls(
    canvas: &mut RasterCanvas,
    drawing: &Drawing,
    roles: &[Role],
    frame: &RasterFrame,
) -> Result<(), DrawingFlaw> {
    if !drawing.strokes.iter().any(|stroke| matches!(stroke.fill, AreaFill::Dark(_))) {
        return Ok(());
    }
    for area in drawing.strokes.chunk_by(|one, next| one.entity == next.entity && one.fill == next.fill) {
        let role = roles[area[0].layer as usize];
        let (rule, is_solid) = match area[0].fill {
            AreaFill::Dark(rule) if role == Role::Wall => (rule, true),
            AreaFill::Light(rule) if role != Role::Obstacle => (rule, false),
            _ => continue,
        };
        let outlines: Vec<_> = area.iter().map(|stroke| in_cells(drawing, stroke, frame)).collect();
        canvas.paint(&outlines, rule, is_solid)?;
    }
    Ok(())
}
