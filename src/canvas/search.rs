//! Draws a planner's decision: the compared sides and values.

use robovac_app::{Palette, SearchScene, Viewport};
use robovac_core::{
    floor_plan::FloorPlan,
    geometry::{Point, Vector},
    grid::{Cell, Direction},
};
use std::f64::consts::TAU;
use wasm_bindgen::JsValue;
use web_sys::CanvasRenderingContext2d;

/// Least distance of a mark from the edge of the robot, CSS pixels.
const CLEAR: f64 = 11.0;
/// Cells between the robot and the count of a side.
const COUNT_AT: f64 = 2.5;
/// Least and largest size of the numbers, CSS pixels.
const FONT: (f64, f64) = (11.0, 15.0);

/// Tints the sides that are compared; one unit is a CSS pixel.
pub fn draw_sides(
    context: &CanvasRenderingContext2d,
    palette: &Palette,
    search: &SearchScene<'_>,
    room: &FloorPlan,
    viewport: &Viewport,
) {
    let at = search.step.at;
    let (width, height) = (room.width_m(), room.height_m());
    let corner = |x: i32, y: i32| search.cells.corner(Cell::new(x, y));
    let (here, next) = (corner(at.x, at.y), corner(at.x + 1, at.y + 1));
    for (side, _) in search.step.sides.into_iter().flatten() {
        let (mut low, mut high) = (Point::new(0.0, 0.0), Point::new(width, height));
        match side {
            Direction::Right => low.x = next.x.min(width),
            Direction::Up => low.y = next.y.min(height),
            Direction::Left => high.x = here.x.min(width),
            Direction::Down => high.y = here.y.min(height),
        }
        let (left_bottom, right_top) = (viewport.to_screen(low), viewport.to_screen(high));
        context.set_fill_style_str(palette.sides[usize::from(side != search.step.towards)]);
        let size = Vector::new(right_top.x - left_bottom.x, left_bottom.y - right_top.y);
        context.fill_rect(left_bottom.x, right_top.y, size.x, size.y);
    }
}

/// Writes the values into their cells, and the counts of the sides beyond them; one unit is a CSS pixel.
pub fn draw_marks(
    context: &CanvasRenderingContext2d,
    palette: &Palette,
    search: &SearchScene<'_>,
    robot_radius: f64,
    viewport: &Viewport,
) -> Result<(), JsValue> {
    let step = search.step;
    let cell = search.cells.size * viewport.scale;
    let size = (0.6 * cell).clamp(FONT.0, FONT.1);
    context.set_font(&format!("600 {size}px -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif"));
    context.set_text_align("center");
    context.set_text_baseline("middle");
    let centre = |cell: Cell| viewport.to_screen(search.cells.centre(cell));
    let here = centre(step.at);
    // The robot hides its neighbours if it's larger than a cell: numbers keep clear of it.
    let least = robot_radius * viewport.scale + CLEAR;
    let label = |offset: Vector, nearest: f64, value: u32, is_chosen: bool| {
        let distance = offset.norm().max(1e-9);
        let at = here + offset * (distance.max(nearest) / distance);
        let text = value.to_string();
        let half = (0.3 * size * text.len() as f64 + 4.0).max(0.65 * size);
        context.begin_path();
        context.ellipse(at.x, at.y, half, 0.65 * size, 0.0, 0.0, TAU)?;
        context.set_fill_style_str(if is_chosen { palette.accent } else { palette.outside });
        context.fill();
        context.set_line_width(1.0);
        context.set_stroke_style_str(palette.start);
        context.stroke();
        context.set_fill_style_str(if is_chosen { palette.outside } else { palette.start });
        context.fill_text(&text, at.x, at.y)
    };
    for &(cell, value) in &step.marks {
        label(centre(cell) - here, least, value, cell == step.at.step(step.towards))?;
    }
    for (side, count) in step.sides.into_iter().flatten() {
        let (x, y) = side.offset();
        // Screens have y down.
        let offset = Vector::new(f64::from(x), -f64::from(y)) * (COUNT_AT * cell);
        label(offset, least + 2.5 * size, count, side == step.towards)?;
    }
    Ok(())
}
