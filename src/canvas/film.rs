//! Draws a picture of a search film.

use crate::canvas::lines::line;
use robovac_app::{FilmScene, Palette, Viewport, explore::FilmInk};
use robovac_core::geometry::Point;
use web_sys::OffscreenCanvasRenderingContext2d;

/// Draws the cells that change and the lines above them; one unit is a CSS pixel.
pub fn draw(context: &OffscreenCanvasRenderingContext2d, film: &FilmScene<'_>, viewport: &Viewport, palette: &Palette) {
    // One path, so that neighbours have no seam between them.
    context.begin_path();
    let side = film.cells.size * viewport.scale;
    for cell in &film.picture.tinted {
        let corner = viewport.to_screen(film.cells.corner(*cell));
        context.rect(corner.x, corner.y - side, side, side);
    }
    context.set_fill_style_str(palette.tint);
    context.fill();
    for (ink, points) in &film.picture.lines {
        let (colour, width) = match ink {
            FilmInk::Path => (palette.preview, 1.75),
            FilmInk::Part(number) => (palette.parts[number % palette.parts.len()], 3.0),
            FilmInk::New => (palette.link, 3.0),
        };
        line(context, viewport, points, colour, width);
        if let (FilmInk::Part(_), Some(first), Some(last)) = (ink, points.first(), points.last()) {
            ends(context, viewport, [first, last], colour);
        }
    }
}

/// Marks where a part was cut off.
fn ends(context: &OffscreenCanvasRenderingContext2d, viewport: &Viewport, ends: [&Point; 2], colour: &str) {
    context.set_fill_style_str(colour);
    for end in ends {
        let at = viewport.to_screen(*end);
        context.fill_rect(at.x - 3.0, at.y - 3.0, 6.0, 6.0);
    }
}
