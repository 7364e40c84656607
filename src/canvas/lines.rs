//! Lines over the floor, in the world's units and in those of the screen.

use robovac_app::{Palette, Scene, Viewport};
use robovac_core::geometry::Point;
use wasm_bindgen::JsValue;
use web_sys::{CanvasRenderingContext2d, OffscreenCanvasRenderingContext2d, Path2d};

/// Corners in view above which the planned line isn't drawn: it would only be a grey veil.
const MOST_PLANNED: usize = 60_000;
/// Pieces of different strength in the trail.
const TRAIL_PIECES: usize = 16;

/// One unit is `unit` metres from now on, y up.
pub fn to_world(context: &OffscreenCanvasRenderingContext2d, viewport: &Viewport, unit: f64) -> Result<(), JsValue> {
    let ratio = viewport.pixel_ratio;
    let scale = viewport.scale * ratio * unit;
    context.set_transform(scale, 0.0, 0.0, -scale, viewport.origin.x * ratio, viewport.origin.y * ratio)
}

/// One unit is a CSS pixel from now on, y down.
pub fn to_css(context: &OffscreenCanvasRenderingContext2d, viewport: &Viewport) -> Result<(), JsValue> {
    let ratio = viewport.pixel_ratio;
    context.set_transform(ratio, 0.0, 0.0, ratio, 0.0, 0.0)
}

/// Slanted lines over the cells of `path`, always as far apart on the screen.
pub fn hatch(
    context: &OffscreenCanvasRenderingContext2d,
    path: &Path2d,
    viewport: &Viewport,
    resolution: f64,
    palette: &Palette,
) -> Result<(), JsValue> {
    context.save();
    to_world(context, viewport, resolution)?;
    context.clip_with_path_2d(path);
    to_css(context, viewport)?;
    let (width, height) = (viewport.size.x, viewport.size.y);
    // Fixed to the floor, so that the pattern moves with it.
    let spacing = 7.0;
    let shift = (viewport.origin.x + viewport.origin.y).rem_euclid(spacing);
    context.begin_path();
    let mut at = shift;
    while at < width + height {
        context.move_to(at, 0.0);
        context.line_to(at - height, height);
        at += spacing;
    }
    context.set_line_width(1.0);
    context.set_stroke_style_str(palette.hatch);
    context.stroke();
    context.restore();
    Ok(())
}

/// Lines between the map's cells, where they are in view; one unit is a metre.
pub fn grid_lines(
    context: &OffscreenCanvasRenderingContext2d,
    viewport: &Viewport,
    scene: &Scene<'_>,
    palette: &Palette,
) {
    let (low, high) = viewport.bounds();
    let (cell, width, height) = (scene.plan.resolution, scene.plan.width_m(), scene.plan.height_m());
    let range =
        |from: f64, to: f64, most: f64| (from.max(0.0) / cell).floor() as i32..=(to.min(most) / cell).ceil() as i32;
    context.begin_path();
    for x in range(low.x, high.x, width) {
        context.move_to(f64::from(x) * cell, low.y.max(0.0));
        context.line_to(f64::from(x) * cell, high.y.min(height));
    }
    for y in range(low.y, high.y, height) {
        context.move_to(low.x.max(0.0), f64::from(y) * cell);
        context.line_to(high.x.min(width), f64::from(y) * cell);
    }
    context.set_line_width(1.0 / viewport.scale);
    context.set_stroke_style_str(palette.grid);
    context.stroke();
}

/// The pieces of a line that are in view; one unit is a CSS pixel.
pub fn line(
    context: &OffscreenCanvasRenderingContext2d,
    viewport: &Viewport,
    points: &[Point],
    colour: &str,
    width: f64,
) {
    let (low, high) = viewport.bounds();
    let is_seen = |a: &Point, b: &Point| {
        a.x.max(b.x) >= low.x && a.x.min(b.x) <= high.x && a.y.max(b.y) >= low.y && a.y.min(b.y) <= high.y
    };
    if points.windows(2).filter(|w| is_seen(&w[0], &w[1])).count() > MOST_PLANNED {
        return;
    }
    context.begin_path();
    let mut is_drawing = false;
    for pair in points.windows(2) {
        if !is_seen(&pair[0], &pair[1]) {
            is_drawing = false;
            continue;
        }
        let (from, to) = (viewport.to_screen(pair[0]), viewport.to_screen(pair[1]));
        if !is_drawing {
            context.move_to(from.x, from.y);
        }
        context.line_to(to.x, to.y);
        is_drawing = true;
    }
    context.set_line_join("round");
    context.set_line_cap("round");
    context.set_line_width(width);
    context.set_stroke_style_str(colour);
    context.stroke();
}

/// The robot's recent trail, fading out.
pub fn trail(context: &CanvasRenderingContext2d, viewport: &Viewport, points: &[Point], colour: &str) {
    if points.len() < 2 {
        return;
    }
    context.set_line_width((0.035 * viewport.scale).clamp(2.0, 5.0));
    context.set_line_join("round");
    context.set_line_cap("butt");
    context.set_stroke_style_str(colour);
    let piece = points.len().div_ceil(TRAIL_PIECES).max(1);
    let pieces = points.len().div_ceil(piece);
    for i in 0..pieces {
        let part = &points[i * piece..(i * piece + piece + 1).min(points.len())];
        context.set_global_alpha((i + 1) as f64 / pieces as f64);
        context.begin_path();
        for (j, &point) in part.iter().enumerate() {
            let at = viewport.to_screen(point);
            if j == 0 { context.move_to(at.x, at.y) } else { context.line_to(at.x, at.y) }
        }
        context.stroke();
    }
    context.set_global_alpha(1.0);
}
