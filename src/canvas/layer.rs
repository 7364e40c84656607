//! Cached layers: drawn once, shown often.

use robovac_app::Palette;
use robovac_core::coverage::CoverageTracker;
use robovac_core::grid::Grid;
use wasm_bindgen::{Clamped, JsCast, JsValue};
use web_sys::{ImageData, OffscreenCanvas, OffscreenCanvasRenderingContext2d};

/// A canvas that isn't in the document.
#[derive(Debug)]
pub struct OffscreenLayer {
    /// Itself, to be drawn elsewhere.
    pub canvas: OffscreenCanvas,
    /// To draw on it.
    pub context: OffscreenCanvasRenderingContext2d,
}

impl OffscreenLayer {
    /// A transparent canvas of `width` x `height` pixels.
    pub fn new(width: u32, height: u32) -> Result<Self, JsValue> {
        let canvas = OffscreenCanvas::new(width.max(1), height.max(1))?;
        let context = canvas.get_context("2d")?.ok_or("no off-screen canvas; use a current browser")?;
        Ok(Self { canvas, context: context.unchecked_into() })
    }

    /// Wipes the canvas and gives it that size; drawing starts afresh, without transformation.
    pub fn clear(&self, width: u32, height: u32) {
        // Setting a size clears, even if it is the same.
        self.canvas.set_width(width.max(1));
        self.canvas.set_height(height.max(1));
    }

    /// Puts rows of pixels (4 bytes each) at row `top`, counted from the upper edge.
    pub fn put_rows(&self, pixels: &[u8], width: u32, top: usize) -> Result<(), JsValue> {
        let image = ImageData::new_with_u8_clamped_array(Clamped(pixels), width)?;
        self.context.put_image_data(&image, 0.0, top as f64)
    }
}

/// One pixel for each cell of a grid; row 0 of the grid is the lowest.
pub fn cell_picture<T>(grid: &Grid<T>, colour: impl Fn(&T) -> [u8; 4]) -> Result<OffscreenLayer, JsValue> {
    let (width, height) = (grid.width() as u32, grid.height() as u32);
    let layer = OffscreenLayer::new(width, height)?;
    let rows = grid.values().chunks(grid.width()).rev();
    let pixels: Vec<u8> = rows.flatten().flat_map(colour).collect();
    layer.put_rows(&pixels, width, 0)?;
    Ok(layer)
}

/// The swept floor, one pixel for each fine cell.
#[derive(Debug)]
pub struct VisitsPicture {
    /// The picture.
    pub layer: OffscreenLayer,
    colours: [[u8; 4]; 256],
    pixels: Vec<u8>,
}

impl VisitsPicture {
    /// The picture of all that has been swept so far.
    pub fn new(tracker: &CoverageTracker, palette: &Palette) -> Result<Self, JsValue> {
        let visits = tracker.visits();
        let layer = OffscreenLayer::new(visits.width() as u32, visits.height() as u32)?;
        let mut picture = Self { layer, colours: palette.visits(), pixels: Vec::new() };
        picture.update(tracker, (0, visits.height() - 1))?;
        Ok(picture)
    }

    /// Draws the rows from the first to the last again.
    pub fn update(&mut self, tracker: &CoverageTracker, (first, last): (usize, usize)) -> Result<(), JsValue> {
        let visits = tracker.visits();
        let (width, last) = (visits.width(), last.min(visits.height() - 1));
        if first > last {
            return Ok(());
        }
        let rows = visits.values()[first * width..(last + 1) * width].chunks(width).rev();
        self.pixels.clear();
        self.pixels.extend(rows.flatten().flat_map(|&count| self.colours[usize::from(count)]));
        self.layer.put_rows(&self.pixels, width as u32, visits.height() - 1 - last)
    }
}
