//! Walls, unknown and unreachable floor, as outlines or pictures of cells.

use super::{
    layer::{OffscreenLayer, cell_picture},
    lines::{to_css, to_world},
};
use robovac_app::{Palette, Scene, Viewport};
use robovac_core::{
    geometry::Point,
    grid::{Grid, Occupancy, outlines},
};
use wasm_bindgen::JsValue;
use web_sys::{OffscreenCanvasRenderingContext2d, Path2d};

/// Corners above which shapes are drawn as pictures of cells.
const MOST_CORNERS: usize = 40_000;

/// Cells in a form that can be filled.
#[derive(Debug)]
pub enum FillShape {
    Path(Path2d),
    Picture(OffscreenLayer),
}

/// Shapes made from one version of the plan.
#[derive(Debug)]
pub struct Shapes {
    pub version: (u64, bool),
    pub walls: FillShape,
    pub unknown: FillShape,
    pub unreachable: Option<FillShape>,
}

impl Shapes {
    /// Those of the scene's room.
    pub fn new(scene: &Scene<'_>, palette: &Palette) -> Result<Self, JsValue> {
        let occupancy = &scene.plan.occupancy;
        let unreachable = scene.floor.map(|floor| {
            let mut left_out = floor.floor.map(|&reached| !reached);
            for (index, value) in left_out.values_mut().iter_mut().enumerate() {
                let fine = floor.floor.cell(index);
                *value &= occupancy.get(scene.plan.cell_at(floor.centre(fine))).is_some_and(|o| o.is_free());
            }
            FillShape::new(&left_out, palette.unreachable)
        });
        Ok(Self {
            version: (scene.plan_version, scene.dark),
            // Single cells have no edge, so a picture has the edge's colour.
            walls: FillShape::new(&occupancy.map(|&o| o == Occupancy::Occupied), palette.wall_line)?,
            unknown: FillShape::new(&occupancy.map(|&o| o == Occupancy::Unknown), palette.unknown)?,
            unreachable: unreachable.transpose()?,
        })
    }
}

impl FillShape {
    /// The set cells, as a path in units of cells if that isn't too long.
    pub fn new(cells: &Grid<bool>, colour: &str) -> Result<Self, JsValue> {
        let Some(loops) = outlines(cells, MOST_CORNERS) else {
            let colour = parse_colour(colour);
            return Ok(Self::Picture(cell_picture(cells, |&is_set| if is_set { colour } else { [0; 4] })?));
        };
        let path = Path2d::new()?;
        for corners in &loops {
            for (i, corner) in corners.iter().enumerate() {
                let (x, y) = (f64::from(corner.x), f64::from(corner.y));
                if i == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
            }
            path.close_path();
        }
        Ok(Self::Path(path))
    }

    /// Draws the edges of the cells, if they are known as a path.
    pub fn edge(
        &self,
        context: &OffscreenCanvasRenderingContext2d,
        viewport: &Viewport,
        resolution: f64,
        colour: &str,
    ) -> Result<(), JsValue> {
        if let Self::Path(path) = self {
            to_world(context, viewport, resolution)?;
            context.set_line_width(1.25 / (viewport.scale * resolution));
            context.set_line_join("miter");
            context.set_stroke_style_str(colour);
            context.stroke_with_path(path);
        }
        Ok(())
    }

    /// Fills the cells, each `resolution` metres wide, of a grid with `rows` rows.
    pub fn fill(
        &self,
        context: &OffscreenCanvasRenderingContext2d,
        viewport: &Viewport,
        resolution: f64,
        rows: usize,
        colour: &str,
    ) -> Result<(), JsValue> {
        match self {
            Self::Path(path) => {
                to_world(context, viewport, resolution)?;
                context.set_fill_style_str(colour);
                context.fill_with_path_2d(path);
            }
            Self::Picture(layer) => {
                to_css(context, viewport)?;
                let top_left = viewport.to_screen(Point::new(0.0, rows as f64 * resolution));
                let size = resolution * viewport.scale;
                let (width, height) = (f64::from(layer.canvas.width()) * size, f64::from(layer.canvas.height()) * size);
                // Crisp cells once they are larger than pixels.
                context.set_image_smoothing_enabled(size < 2.0);
                context.draw_image_with_offscreen_canvas_and_dw_and_dh(
                    &layer.canvas,
                    top_left.x,
                    top_left.y,
                    width,
                    height,
                )?;
            }
        }
        Ok(())
    }
}

/// Red, green, blue and opacity of the palette's own notations: `#rrggbb` and `rgb(r g b / opacity)`.
fn parse_colour(css: &str) -> [u8; 4] {
    if let Some(hex) = css.strip_prefix('#') {
        let byte = |i: usize| hex.get(i..i + 2).and_then(|h| u8::from_str_radix(h, 16).ok()).unwrap_or(0);
        return [byte(0), byte(2), byte(4), 255];
    }
    let numbers: Vec<f64> =
        css.split(|c: char| !c.is_ascii_digit() && c != '.').filter_map(|n| n.parse().ok()).collect();
    let part = |i: usize| numbers.get(i).copied().unwrap_or(1.0);
    [part(0) as u8, part(1) as u8, part(2) as u8, (255.0 * part(3)) as u8]
}
