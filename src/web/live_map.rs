//! What the page shows of a robot on its way: the room, where it believes to be, what it has swept and felt.

use super::{canvas::Canvas, guest::Guest};
use crate::app::{Scene, Viewport};
use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;

/// A robot on its way, drawn on a canvas.
#[wasm_bindgen]
pub struct LiveMap {
    canvas: Canvas,
}

#[wasm_bindgen]
impl LiveMap {
    /// On that canvas.
    #[wasm_bindgen(constructor)]
    pub fn new(element: HtmlCanvasElement) -> Result<Self, JsValue> {
        Ok(Self { canvas: Canvas::new(element)? })
    }

    /// Draws the room that `guest` shows.
    pub fn draw(&mut self, guest: &Guest) -> Result<(), JsValue> {
        let plan = guest.session().plan();
        self.canvas.draw(&Scene::empty(plan), &Viewport::bare())
    }
}
