//! The scale bar in a corner of the floor.

use robovac_app::{Palette, Viewport};
use wasm_bindgen::JsValue;
use web_sys::CanvasRenderingContext2d;

/// Width of the canvas below which there is no room for it between legend and zoom, CSS pixels. It stands above the zoom
/// then, if the canvas is at least so large.
const BESIDE_ZOOM: f64 = 626.0;
const LEAST: [f64; 2] = [240.0, 160.0];

/// Draws one of a round length.
pub fn draw(context: &CanvasRenderingContext2d, viewport: &Viewport, palette: &Palette) -> Result<(), JsValue> {
    if viewport.size.x < LEAST[0] || viewport.size.y < LEAST[1] {
        return Ok(());
    }
    let [to_right, to_bottom] = if viewport.size.x < BESIDE_ZOOM { [20.0, 72.0] } else { [204.0, 24.0] };
    let lengths = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0];
    let metres = lengths.into_iter().find(|m| m * viewport.scale >= 48.0).unwrap_or(100.0);
    let (length, right, bottom) = (metres * viewport.scale, viewport.size.x - to_right, viewport.size.y - to_bottom);
    // With a background, in case the room lies behind it.
    context.set_fill_style_str(palette.outside);
    context.set_global_alpha(0.8);
    context.fill_rect(right - length - 6.0, bottom - 20.0, length + 12.0, 26.0);
    context.set_global_alpha(1.0);
    context.set_stroke_style_str(palette.text);
    context.set_line_width(1.5);
    context.begin_path();
    context.move_to(right - length, bottom - 5.0);
    context.line_to(right - length, bottom);
    context.line_to(right, bottom);
    context.line_to(right, bottom - 5.0);
    context.stroke();
    context.set_fill_style_str(palette.text);
    context.set_font("12px -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif");
    context.set_text_align("center");
    context.set_text_baseline("alphabetic");
    let label = if metres < 1.0 { format!("{} cm", metres * 100.0) } else { format!("{metres} m") };
    context.fill_text(&label, right - 0.5 * length, bottom - 6.0)
}
