//! The Floor plan tab: runs in a worker, with its canvas.

mod marks;
mod paint;
mod sweeping;

use js_sys::{Array, Function, Reflect, Uint8Array};
use paint::{FloorPlanPainter, ShownPlan};
use robovac_app::{
    Viewport,
    export::PathFormat,
    floor_plan::{DrawingPart, DrawingSession, DrawingTool, FloorPlanSettings, FloorPlanView, coarse},
};
use robovac_core::geometry::{Point, Vector};
use robovac_playground::wire::{clock, map_file, to_js};
use std::ops::ControlFlow;
use wasm_bindgen::prelude::*;
use web_sys::OffscreenCanvas;

/// Most pixels on a side of a canvas: all browsers support this; some stop at 8192.
const MOST_PIXELS: usize = 8192;
/// Least distance of the pointer that counts as dragging, CSS pixels.
const LEAST_DRAG_PX: f64 = 4.0;
/// Distance within which points are the same, for the pointer and for keys, CSS pixels.
const NEAR_PX: [f64; 2] = [7.0, 1.5];
/// Step of the crosshair per key press, and with shift, CSS pixels.
const NUDGE_PX: [f64; 2] = [12.0, 1.0];

/// A gesture between pointer down and up.
#[derive(Debug, Clone, Copy)]
struct DrawingGesture {
    /// Its first and its present point, CSS pixels.
    from: Point,
    at: Point,
    has_moved: bool,
    /// Whether it draws a rectangle rather than panning.
    draws: bool,
}

/// A drawing session and its canvas.
#[wasm_bindgen]
pub struct FloorPlanSession {
    session: Option<DrawingSession>,
    painter: FloorPlanPainter,
    viewport: Viewport,
    dark: bool,
    shown: ShownPlan,
    gesture: Option<DrawingGesture>,
    /// Time taken to plan the sweep, s.
    seconds: f64,
}

#[wasm_bindgen]
impl FloorPlanSession {
    /// A session without a file that draws onto `canvas`.
    #[wasm_bindgen(constructor)]
    pub fn new(canvas: OffscreenCanvas) -> Result<Self, JsValue> {
        let viewport = Viewport::new(1.0, 1.0, 1.0, 1.0, 1.0);
        let painter = FloorPlanPainter::new(canvas)?;
        let shown = ShownPlan::default();
        Ok(Self { session: None, painter, viewport, dark: false, shown, gesture: None, seconds: 0.0 })
    }

    /// Opens an array of `{ name, bytes }` that belong together. Throws a message, and changes nothing, if they aren't
    /// a floor plan; with the accepted formats if they are new rather than restored.
    pub fn open(&mut self, files: &Array, is_new: bool) -> Result<(), JsValue> {
        let session = DrawingSession::open(&map_file::source_files(files)?)
            .map_err(|error| if is_new { error.with_formats() } else { error.to_string() })?;
        let size = session.sheet().size;
        self.viewport.set_room(size.x, size.y);
        self.painter.take(&session)?;
        (self.session, self.shown, self.gesture) = (Some(session), ShownPlan::default(), None);
        Ok(())
    }

    /// The snapshot, a `FloorPlanView`; `undefined` without a file.
    #[wasm_bindgen(unchecked_return_type = "rust.FloorPlanView | undefined")]
    pub fn view(&self) -> Result<JsValue, JsValue> {
        let Some(session) = &self.session else { return Ok(JsValue::UNDEFINED) };
        to_js(&FloorPlanView {
            plan: session.view(),
            seconds: self.seconds,
            stage: self.shown.stage,
            slice: self.shown.slice.map_or(-1, |heading| heading as i32),
        })
    }

    /// Sets all settings, in the form of the view's `settings`.
    pub fn set(&mut self, settings: JsValue) -> Result<(), JsValue> {
        let settings: FloorPlanSettings = serde_wasm_bindgen::from_value(settings).map_err(|e| e.to_string())?;
        self.change(|session| session.set(settings))
    }

    /// Selects the tool for clicks: `view`, `scale`, `rectangle`, `polygon` or `room`.
    pub fn set_tool(&mut self, id: &str) {
        let tool = match id {
            "scale" => DrawingTool::Scale,
            "rectangle" => DrawingTool::Rectangle,
            "polygon" => DrawingTool::Polygon,
            "room" => DrawingTool::Room,
            _ => DrawingTool::View,
        };
        self.gesture = None;
        if let Some(session) = &mut self.session {
            session.hand.take(tool);
        }
    }

    /// Turns the file to `degrees` counter-clockwise from how it was, and the part to be traced with it.
    pub fn turn_to(&mut self, degrees: f64) -> Result<(), JsValue> {
        self.change(|session| session.turn_to(degrees))
    }

    /// Scales the drawing so that the two scale points are `metres` apart.
    pub fn scale_to(&mut self, metres: f64) -> Result<(), JsValue> {
        self.change(|session| session.scale_to(metres))
    }

    // ---- sweep

    /// Plans the sweep; `report` is called with the share done.
    pub fn sweep(&mut self, report: &Function) -> Result<(), JsValue> {
        let began = clock();
        let mut last = began;
        let mut observe = |share: f64| {
            if clock() - last > 50.0 {
                last = clock();
                // Errors of the listener don't stop the sweep.
                let _ = report.call1(&JsValue::NULL, &share.into());
            }
            ControlFlow::Continue(())
        };
        self.shown.stage = 0;
        self.session.as_mut().ok_or("there is no floor plan yet")?.sweep(&mut observe)?;
        self.seconds = (clock() - began) / 1000.0;
        Ok(())
    }

    /// Plans a sweep of a tiny room, so that the browser compiles the code in advance.
    pub fn warm_up() {
        robovac_app::floor_plan::warm_up();
    }

    /// Shows a stage of the sweep, 1 to 4, as far as `share`, 0 to 1; stage 0 for none.
    pub fn show_stage(&mut self, stage: u8, share: f64) {
        (self.shown.stage, self.shown.share) = (stage.min(4), share.clamp(0.0, 1.0));
    }

    /// Shows the slice of the obstacle map at a heading, counted from 0; below 0 for none. May take seconds.
    pub fn show_slice(&mut self, heading: i32) -> Result<(), JsValue> {
        self.shown.slice = None;
        let Ok(heading) = usize::try_from(heading) else { return Ok(()) };
        let session = self.session.as_mut().ok_or("there is no floor plan yet")?;
        let space = session.make_space()?;
        let heading = heading.min(space.headings.saturating_sub(1));
        let (slice, times) = coarse(space.slice(heading), MOST_PIXELS);
        self.painter.take_slice(&slice, space.cell * times as f64)?;
        self.shown.slice = Some(heading);
        Ok(())
    }

    // ---- export

    /// The room for `Playground.take_map`; `sweeps` also chooses the planner of the sweep.
    pub fn room(&self, sweeps: bool) -> Result<Vec<u8>, JsValue> {
        map_file::import_to_bytes(self.session.as_ref().ok_or("there is no floor plan yet")?.import(sweeps)?)
    }

    /// The sweep as a file: `{ name, media, bytes }`.
    pub fn export(&self, format: &str) -> Result<JsValue, JsValue> {
        let format: PathFormat = serde_wasm_bindgen::from_value(format.into()).map_err(|e| e.to_string())?;
        let file = self.session.as_ref().ok_or("there is no floor plan yet")?.export(format)?;
        let object = js_sys::Object::new();
        Reflect::set(&object, &"name".into(), &file.name.into())?;
        Reflect::set(&object, &"media".into(), &file.kind.into())?;
        Reflect::set(&object, &"bytes".into(), &Uint8Array::from(file.bytes.as_slice()))?;
        Ok(object.into())
    }

    // ---- pointer and keys

    /// The pointer at (`x`, `y`), CSS pixels: `down`, `move`, `up` or `cancel`. Returns whether more than the picture
    /// changed.
    pub fn pointer(&mut self, kind: &str, x: f64, y: f64) -> bool {
        let at = Point::new(x, y);
        let Some(session) = &mut self.session else { return false };
        let tool = session.hand.tool;
        let place = session.sheet().unit(self.viewport.to_world(x, y));
        let near = NEAR_PX[0] / (self.viewport.scale * session.sheet().scale);
        session.hand.hover = (tool != DrawingTool::View && kind != "cancel").then_some(place);
        match (kind, &mut self.gesture) {
            ("down", _) => {
                session.hand.crosshair = None;
                let draws = tool == DrawingTool::Rectangle && session.hand.points.is_empty();
                if draws {
                    session.hand.click(place, near);
                }
                self.gesture = Some(DrawingGesture { from: at, at, has_moved: false, draws });
                draws
            }
            ("move", Some(gesture)) => {
                gesture.has_moved |= tool == DrawingTool::View || (at - gesture.from).norm() >= LEAST_DRAG_PX;
                if gesture.has_moved && !gesture.draws {
                    let by = at - gesture.at;
                    self.viewport.pan(by.x, by.y);
                }
                if gesture.has_moved {
                    gesture.at = at;
                }
                false
            }
            ("up", Some(gesture)) => {
                let gesture = *gesture;
                self.gesture = None;
                // A rectangle that isn't dragged takes a second click.
                if gesture.has_moved == gesture.draws && tool != DrawingTool::View {
                    let part = session.hand.click(place, near);
                    self.mean(part);
                }
                true
            }
            ("cancel", gesture) => {
                // A pinch begins like a rectangle.
                if gesture.take().is_some_and(|gesture| gesture.draws) {
                    session.hand.points.clear();
                }
                true
            }
            _ => false,
        }
    }

    /// A key on the canvas: `left`, `right`, `up`, `down`, `apply` or `escape`, finer with shift. Returns whether it
    /// was used.
    pub fn key(&mut self, action: &str, fine: bool) -> bool {
        let Some(session) = &mut self.session else { return false };
        if action == "escape" {
            return session.hand.escape();
        }
        if session.hand.tool == DrawingTool::View {
            return false;
        }
        let unit = self.viewport.scale * session.sheet().scale;
        if action == "apply" {
            let part = session.hand.apply(NEAR_PX[1] / unit);
            self.mean(part);
            return true;
        }
        let step = NUDGE_PX[usize::from(fine)] / unit;
        let by = match action {
            "left" => Vector::new(-step, 0.0),
            "right" => Vector::new(step, 0.0),
            "up" => Vector::new(0.0, step),
            "down" => Vector::new(0.0, -step),
            _ => return false,
        };
        let middle = self.viewport.to_world(0.5 * self.viewport.size.x, 0.5 * self.viewport.size.y);
        session.hand.nudge(by, session.sheet().unit(middle));
        // It stays in view.
        if let Some(at) = session.hand.crosshair {
            let seen = self.viewport.to_screen(session.sheet().place(at));
            let inside = Point::new(
                seen.x.clamp(20.0, self.viewport.size.x - 20.0),
                seen.y.clamp(20.0, self.viewport.size.y - 20.0),
            );
            self.viewport.pan(inside.x - seen.x, inside.y - seen.y);
        }
        true
    }

    // ---- the picture

    /// The canvas is `width` x `height` CSS pixels on a screen with `ratio` device pixels each.
    pub fn resize(&mut self, width: f64, height: f64, ratio: f64) {
        self.viewport.resize(width, height, ratio);
    }

    /// Dark or light colours.
    pub fn set_dark(&mut self, dark: bool) {
        self.dark = dark;
    }

    /// Pans by CSS pixels.
    pub fn pan(&mut self, dx: f64, dy: f64) {
        self.viewport.pan(dx, dy);
    }

    /// Zooms by `factor` around (`x`, `y`), CSS pixels.
    pub fn zoom(&mut self, x: f64, y: f64, factor: f64) {
        self.viewport.zoom_at(x, y, factor);
    }

    /// Shows all of it.
    pub fn fit(&mut self) {
        self.viewport.fit();
    }

    /// Keeps the uppermost `height` CSS pixels free when all of it is shown.
    pub fn keep_clear(&mut self, height: f64) {
        self.viewport.keep_clear(height, None, Vector::zeros(), Vector::zeros());
    }

    /// Draws. If `hurries` is set, slow lines are only moved; returns whether they were, and so should be drawn again
    /// at rest.
    pub fn draw(&mut self, hurries: bool) -> Result<bool, JsValue> {
        self.painter.draw(self.session.as_ref(), &self.viewport, self.shown, self.dark, hurries)
    }
}

impl FloorPlanSession {
    /// Changes the settings; a sweep that is no longer valid is hidden.
    fn change(&mut self, what: impl FnOnce(&mut DrawingSession) -> Result<(), String>) -> Result<(), JsValue> {
        let session = self.session.as_mut().ok_or("there is no floor plan yet")?;
        let before = *session.sheet();
        what(session)?;
        if *session.sheet() != before {
            // It was turned.
            let size = session.sheet().size;
            self.viewport.set_room(size.x, size.y);
            self.painter.take(session)?;
            self.gesture = None;
        }
        if session.planned().is_none() {
            self.shown.stage = 0;
        }
        if session.space().is_none() {
            self.shown.slice = None;
        }
        Ok(())
    }

    fn mean(&mut self, part: Option<DrawingPart>) {
        if let Some(part) = part {
            // Choosing a part can't be refused.
            let _ = self.change(|session| session.set_part(part));
        }
    }
}
