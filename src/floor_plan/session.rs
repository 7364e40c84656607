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

/// Pixels on a side of a canvas, at most: what all browsers can do; some stop at 8192.
const MOST_PIXELS: usize = 8192;
/// How far the pointer has to move to mean more than a click, CSS pixels.
const LEAST_DRAG_PX: f64 = 4.0;
/// Points closer than this are the same for a pointer, and for keys, CSS pixels.
const NEAR_PX: [f64; 2] = [7.0, 1.5];
/// How far a key moves the crosshair, and how far with shift, CSS pixels.
const NUDGE_PX: [f64; 2] = [12.0, 1.0];

/// What the pointer does until it is let go.
#[derive(Debug, Clone, Copy)]
struct DrawingGesture {
    /// Where it went down, and where it is, CSS pixels.
    from: Point,
    at: Point,
    has_moved: bool,
    /// Whether it draws a rectangle rather than moving the view.
    draws: bool,
}

/// A draft, and its canvas.
#[wasm_bindgen]
pub struct FloorPlanSession {
    board: Option<DrawingSession>,
    painter: FloorPlanPainter,
    viewport: Viewport,
    dark: bool,
    shown: ShownPlan,
    gesture: Option<DrawingGesture>,
    /// How long the sweep took to be planned, s.
    seconds: f64,
}

#[wasm_bindgen]
impl FloorPlanSession {
    /// Draws onto `canvas` from now on.
    #[wasm_bindgen(constructor)]
    pub fn new(canvas: OffscreenCanvas) -> Result<Self, JsValue> {
        let viewport = Viewport::new(1.0, 1.0, 1.0, 1.0, 1.0);
        let painter = FloorPlanPainter::new(canvas)?;
        let shown = ShownPlan::default();
        Ok(Self { board: None, painter, viewport, dark: false, shown, gesture: None, seconds: 0.0 })
    }

    /// Puts an array of `{ name, bytes }` that belong together on the board. Throws a message, and changes nothing, if they
    /// are no floor plan.
    pub fn open(&mut self, files: &Array) -> Result<(), JsValue> {
        let board = DrawingSession::open(&map_file::source_files(files)?).map_err(|e| e.to_string())?;
        let size = board.sheet().size;
        self.viewport.set_room(size.x, size.y);
        self.painter.take(&board)?;
        (self.board, self.shown, self.gesture) = (Some(board), ShownPlan::default(), None);
        Ok(())
    }

    /// What there is to be seen, as a plain object; nothing while the board is empty.
    #[wasm_bindgen(unchecked_return_type = "rust.FloorPlanView | undefined")]
    pub fn view(&self) -> Result<JsValue, JsValue> {
        let Some(board) = &self.board else { return Ok(JsValue::UNDEFINED) };
        to_js(&FloorPlanView {
            plan: board.view(),
            seconds: self.seconds,
            stage: self.shown.stage,
            slice: self.shown.slice.map_or(-1, |heading| heading as i32),
        })
    }

    /// Chooses all of what `view` has as settings.
    pub fn set(&mut self, settings: JsValue) -> Result<(), JsValue> {
        let settings: FloorPlanSettings = serde_wasm_bindgen::from_value(settings).map_err(|e| e.to_string())?;
        self.change(|board| board.set(settings))
    }

    /// Chooses what clicks mean: `view`, `scale`, `rectangle`, `polygon` or `room`.
    pub fn set_tool(&mut self, id: &str) {
        let tool = match id {
            "scale" => DrawingTool::Scale,
            "rectangle" => DrawingTool::Rectangle,
            "polygon" => DrawingTool::Polygon,
            "room" => DrawingTool::Room,
            _ => DrawingTool::View,
        };
        self.gesture = None;
        if let Some(board) = &mut self.board {
            board.hand.take(tool);
        }
    }

    /// Makes the distance between the two points that were set so many metres.
    pub fn scale_to(&mut self, metres: f64) -> Result<(), JsValue> {
        self.change(|board| board.scale_to(metres))
    }

    // ---- sweep

    /// Plans the sweep; `report` is called with the share done.
    pub fn sweep(&mut self, report: &Function) -> Result<(), JsValue> {
        let began = clock();
        let mut last = began;
        let mut observe = |share: f64| {
            if clock() - last > 50.0 {
                last = clock();
                // A page that doesn't listen is no reason to stop.
                let _ = report.call1(&JsValue::NULL, &share.into());
            }
            ControlFlow::Continue(())
        };
        self.shown.stage = 0;
        self.board.as_mut().ok_or("there is no floor plan yet")?.sweep(&mut observe)?;
        self.seconds = (clock() - began) / 1000.0;
        Ok(())
    }

    /// Plans a sweep of a tiny room: the browser compiles what it takes, and nobody has to wait for that later.
    pub fn warm_up() {
        robovac_app::floor_plan::warm_up();
    }

    /// Shows a stage of the sweep, 1 to 3, as far as `share`, 0 to 1; stage 0 for none.
    pub fn show_stage(&mut self, stage: u8, share: f64) {
        (self.shown.stage, self.shown.share) = (stage.min(3), share.clamp(0.0, 1.0));
    }

    /// Shows the slice of the obstacle map at a heading, counted from 0; below 0 for none. May take seconds.
    pub fn show_slice(&mut self, heading: i32) -> Result<(), JsValue> {
        self.shown.slice = None;
        let Ok(heading) = usize::try_from(heading) else { return Ok(()) };
        let board = self.board.as_mut().ok_or("there is no floor plan yet")?;
        let space = board.make_space()?;
        let heading = heading.min(space.headings.saturating_sub(1));
        let (slice, times) = coarse(space.slice(heading), MOST_PIXELS);
        self.painter.take_slice(&slice, space.cell * times as f64)?;
        self.shown.slice = Some(heading);
        Ok(())
    }

    // ---- out

    /// The room for `Playground.take_map`; `sweeps` also chooses the planner of the sweep.
    pub fn room(&self, sweeps: bool) -> Result<JsValue, JsValue> {
        map_file::import_to_js(self.board.as_ref().ok_or("there is no floor plan yet")?.import(sweeps)?)
    }

    /// The sweep as a file: `{ name, media, bytes }`.
    pub fn export(&self, format: &str) -> Result<JsValue, JsValue> {
        let format: PathFormat = serde_wasm_bindgen::from_value(format.into()).map_err(|e| e.to_string())?;
        let file = self.board.as_ref().ok_or("there is no floor plan yet")?.export(format)?;
        let object = js_sys::Object::new();
        Reflect::set(&object, &"name".into(), &file.name.into())?;
        Reflect::set(&object, &"media".into(), &file.kind.into())?;
        Reflect::set(&object, &"bytes".into(), &Uint8Array::from(file.bytes.as_slice()))?;
        Ok(object.into())
    }

    // ---- the hand

    /// The pointer at (`x`, `y`), CSS pixels: `down`, `move`, `up` or `cancel`. Says whether more than the picture changed.
    pub fn pointer(&mut self, kind: &str, x: f64, y: f64) -> bool {
        let at = Point::new(x, y);
        let Some(board) = &mut self.board else { return false };
        let tool = board.hand.tool;
        let place = board.sheet().unit(self.viewport.to_world(x, y));
        let near = NEAR_PX[0] / (self.viewport.scale * board.sheet().scale);
        board.hand.hover = (tool != DrawingTool::View && kind != "cancel").then_some(place);
        match (kind, &mut self.gesture) {
            ("down", _) => {
                board.hand.crosshair = None;
                let draws = tool == DrawingTool::Rectangle && board.hand.points.is_empty();
                if draws {
                    board.hand.click(place, near);
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
                    let part = board.hand.click(place, near);
                    self.mean(part);
                }
                true
            }
            ("cancel", gesture) => {
                // A pinch begins like a rectangle.
                if gesture.take().is_some_and(|gesture| gesture.draws) {
                    board.hand.points.clear();
                }
                true
            }
            _ => false,
        }
    }

    /// A key on the canvas: `left`, `right`, `up`, `down`, `apply` or `escape`, finer with shift. Says whether it was used.
    pub fn key(&mut self, action: &str, fine: bool) -> bool {
        let Some(board) = &mut self.board else { return false };
        if action == "escape" {
            return board.hand.escape();
        }
        if board.hand.tool == DrawingTool::View {
            return false;
        }
        let unit = self.viewport.scale * board.sheet().scale;
        if action == "apply" {
            let part = board.hand.apply(NEAR_PX[1] / unit);
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
        board.hand.nudge(by, board.sheet().unit(middle));
        // It stays in view.
        if let Some(at) = board.hand.crosshair {
            let seen = self.viewport.to_screen(board.sheet().place(at));
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

    /// Moves what is seen by CSS pixels.
    pub fn pan(&mut self, dx: f64, dy: f64) {
        self.viewport.pan(dx, dy);
    }

    /// Enlarges `factor` times around (`x`, `y`), CSS pixels.
    pub fn zoom(&mut self, x: f64, y: f64, factor: f64) {
        self.viewport.zoom_at(x, y, factor);
    }

    /// Shows all of it.
    pub fn fit(&mut self) {
        self.viewport.fit();
    }

    /// Draws. In a hurry, lines that take long to be drawn are only moved; says whether that was done, and they should be
    /// drawn again at rest.
    pub fn draw(&mut self, hurries: bool) -> Result<bool, JsValue> {
        self.painter.draw(self.board.as_ref(), &self.viewport, self.shown, self.dark, hurries)
    }
}

impl FloorPlanSession {
    /// Changes what is chosen; what was planned for something else is no longer shown.
    fn change(&mut self, what: impl FnOnce(&mut DrawingSession) -> Result<(), String>) -> Result<(), JsValue> {
        let board = self.board.as_mut().ok_or("there is no floor plan yet")?;
        what(board)?;
        if board.planned().is_none() {
            self.shown.stage = 0;
        }
        if board.space().is_none() {
            self.shown.slice = None;
        }
        Ok(())
    }

    fn mean(&mut self, part: Option<DrawingPart>) {
        if let Some(part) = part {
            // Choosing a part can't be refused.
            let _ = self.change(|board| board.set_part(part));
        }
    }
}
