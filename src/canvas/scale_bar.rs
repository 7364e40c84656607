//! The scale bar in a corner of a drawing.

use robovac_app::{Palette, Viewport};
use wasm_bindgen::JsValue;
use web_sys::OffscreenCanvasRenderingContext2d as Context;

/// Lengths that it can have, m.
const LENGTHS: [f64; 16] =
    [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0];
/// Least length on the screen, CSS pixels.
const LEAST: f64 = 48.0;

/// A scale bar in the lower right corner of the floor.
pub fn draw(context: &Context, viewport: &Viewport, palette: &Palette) -> Result<(), JsValue> {
    let Some([to_right, to_bottom]) = viewport.scale_bar() else { return Ok(()) };
    let Some(bar) = Bar::of(viewport.scale) else { return Ok(()) };
    bar.draw(context, viewport.size.x - to_right - bar.length, viewport.size.y - to_bottom, palette)
}

/// A scale bar of a round length.
pub struct Bar {
    metres: f64,
    /// CSS pixels.
    length: f64,
}

impl Bar {
    /// The shortest that can be read with so many CSS pixels per metre; `None` if a kilometre is too short.
    pub fn of(per_metre: f64) -> Option<Self> {
        let metres = LENGTHS.into_iter().find(|metres| metres * per_metre >= LEAST)?;
        Some(Self { metres, length: metres * per_metre })
    }

    /// Draws it with its lower left end at (`left`, `bottom`), CSS pixels, so that what lies behind stays visible.
    pub fn draw(&self, context: &Context, left: f64, bottom: f64, palette: &Palette) -> Result<(), JsValue> {
        let right = left + self.length;
        context.begin_path();
        context.move_to(left, bottom - 5.0);
        context.line_to(left, bottom);
        context.line_to(right, bottom);
        context.line_to(right, bottom - 5.0);
        context.set_font("12px -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif");
        context.set_text_align("center");
        context.set_text_baseline("alphabetic");
        context.set_line_join("round");
        let label =
            if self.metres < 1.0 { format!("{:.0} cm", self.metres * 100.0) } else { format!("{} m", self.metres) };
        let (x, y) = (left + 0.5 * self.length, bottom - 6.0);
        // A halo: the room may lie behind it.
        context.set_stroke_style_str(palette.outside);
        context.set_line_width(4.5);
        context.stroke();
        context.stroke_text(&label, x, y)?;
        context.set_stroke_style_str(palette.text);
        context.set_line_width(1.5);
        context.stroke();
        context.set_fill_style_str(palette.text);
        context.fill_text(&label, x, y)
    }
}
