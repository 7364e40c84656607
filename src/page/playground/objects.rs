//! Object editing on the page.

use super::Playground;
use robovac_app::explore::PlaceableKind;
use robovac_core::geometry::Point;
use wasm_bindgen::prelude::*;

/// Distance within which the pointer takes hold of small things, CSS pixels.
const GRIP_PX: f64 = 12.0;
/// Presses that don't move farther than this are clicks, CSS pixels.
const CLICK_PX: f64 = 4.0;

#[wasm_bindgen]
impl Playground {
    /// Chooses what the tool `place` places: `furniture`, `table`, `stairs`, `carpet`, `dirt`, `dock`, `virtual_wall`,
    /// `person` or `pet`.
    pub fn set_placing(&mut self, kind: &str) {
        if let Some(kind) = PlaceableKind::parse(kind) {
            self.object_tool.kind = kind;
        }
    }

    /// Edits the selected object: `left`, `right`, `up` or `down` move it by a step, `turn_left` and `turn_right` by 15
    /// degrees, `larger` and `smaller` by a tenth; `delete`. Returns whether an object is selected.
    pub fn edit_selected(&mut self, action: &str) -> bool {
        self.object_tool.edit(&mut self.session, action)
    }

    /// Selects an object by its index; none if the index is invalid.
    pub fn select_object(&mut self, index: Option<usize>) {
        self.object_tool.select(&self.session, index);
    }

    /// Selects the object after the selected one, or the first.
    pub fn select_next(&mut self) {
        self.object_tool.select_next(&self.session);
    }
}

impl Playground {
    /// Starts dragging the selected object, or one of its handles.
    pub(super) fn takes_selected(&mut self, at: Point) -> bool {
        let selected = self.object_tool.selected(&self.session);
        let reach = GRIP_PX / self.viewport.scale;
        selected.is_some_and(|index| self.object_tool.take_selected(&self.session, index, at, reach))
    }

    /// Starts dragging an object.
    pub(super) fn takes_object(&mut self, at: Point) -> bool {
        let reach = GRIP_PX / self.viewport.scale;
        self.object_tool.take_any(&self.session, at, reach)
    }

    /// Starts dragging an object like those that are being placed.
    pub(super) fn takes_alike(&mut self, at: Point) -> bool {
        let reach = GRIP_PX / self.viewport.scale;
        self.object_tool.take_alike(&self.session, at, reach)
    }

    /// Selects the object clicked on with the view tool; a robot that is held is put down there.
    pub(super) fn watch_for_click(&mut self, kind: &str, x: f64, y: f64) {
        let is_near = |(from_x, from_y): (f64, f64)| (x - from_x).abs().max((y - from_y).abs()) < CLICK_PX;
        match kind {
            "down" => self.pressed = Some((x, y)),
            "move" => self.pressed = self.pressed.filter(|&from| is_near(from)),
            "up" => {
                if self.pressed.take().is_some_and(is_near) {
                    let at = self.viewport.to_world(x, y);
                    if self.put_down_at(at) {
                        return;
                    }
                    self.object_tool.click(&self.session, at, GRIP_PX / self.viewport.scale);
                }
            }
            _ => self.pressed = None,
        }
    }
}
