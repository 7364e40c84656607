//! The page's main object: a session, its canvas and pointer input.

mod choices;
mod hand;
mod objects;
mod planning;
mod pointer;
mod program;
mod saved;

use self::pointer::FloorGesture;
use js_sys::{Float64Array, JSON};
use robovac_app::{
    CarriedRobot, RobotView, Scene, Viewport,
    explore::{Catalogue, FloorTool, ObjectTool, PageView, RobotEntry, Session},
    export::RunBag,
};
use robovac_core::{floor_plan::Object, geometry::Vector, grid::Cell};
use robovac_playground::frame_clock::FrameClock;
use robovac_playground::{
    canvas::Canvas,
    wire::{clock, to_js, trajectory::trajectory_to_js},
};
use robovac_sim::controller;
use serde::Serialize;
use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;

/// A session shown on a canvas.
#[wasm_bindgen]
pub struct Playground {
    session: Session,
    object_tool: ObjectTool,
    /// Whether this is still the opening scene.
    is_opening: bool,
    canvas: Canvas,
    viewport: Viewport,
    tool: FloorTool,
    gesture: Option<FloorGesture>,
    /// The robot, if it is lifted.
    carried: Option<CarriedRobot>,
    /// Cell of the keyboard cursor.
    cursor: Option<Cell>,
    frame_clock: FrameClock,
    dark: bool,
    /// Start of a press of the view tool while it can be a click, CSS pixels.
    pressed: Option<(f64, f64)>,
    /// Name and size of the room that the viewport was fitted to.
    fitted: (String, f64, f64),
}

#[wasm_bindgen]
impl Playground {
    /// Opens on `canvas` with the furnished flat being cleaned, unless a link is restored.
    #[wasm_bindgen(constructor)]
    pub fn new(canvas: HtmlCanvasElement) -> Result<Self, JsValue> {
        Ok(Self {
            session: Session::with(controller::MAPLESS),
            object_tool: ObjectTool::new(),
            is_opening: true,
            canvas: Canvas::new(canvas)?,
            viewport: Viewport::new(1.0, 1.0, 1.0, 1.0, 1.0),
            tool: FloorTool::View,
            gesture: None,
            carried: None,
            cursor: None,
            frame_clock: FrameClock::default(),
            dark: false,
            pressed: None,
            fitted: Default::default(),
        })
    }

    /// The choices in menus, a [`Catalogue`].
    #[wasm_bindgen(unchecked_return_type = "rust.Catalogue")]
    pub fn catalogue() -> Result<JsValue, JsValue> {
        to_js(&Catalogue::all())
    }

    /// The present robot, a [`RobotEntry`]: also one that isn't in the catalogue.
    #[wasm_bindgen(unchecked_return_type = "rust.RobotEntry")]
    pub fn robot(&self) -> Result<JsValue, JsValue> {
        to_js(&RobotEntry::new(&self.session.settings().robot_model()))
    }

    /// Snapshot of the session in numbers and words.
    #[wasm_bindgen(unchecked_return_type = "rust.PageView")]
    pub fn view(&self) -> Result<JsValue, JsValue> {
        let driven = || self.session.recording().map(|recording| recording.run().pose());
        let robot = self.carried.map(|it| it.pose).or_else(driven).map(|pose| pose.position());
        to_js(&PageView {
            session: self.session.view(),
            tool: self.tool,
            objects: self.session.plan().objects.iter().map(Object::name).collect(),
            selected: self.object_tool.selected(&self.session).map_or(-1, |index| index as i32),
            placing: self.object_tool.kind.id(),
            is_carried: self.carried.is_some(),
            is_all_shown: self.viewport.is_fitted(),
            robot_spot: robot.map_or([1.0, 1.0], |at| {
                let (spot, size) = (self.viewport.to_screen(at), self.viewport.size);
                [spot.x / size.x, spot.y / size.y]
            }),
        })
    }

    /// One or two sentences that describe the picture.
    pub fn description(&self) -> String {
        self.session.description()
    }

    /// Advances by the time since the last call, and draws.
    pub fn frame(&mut self, now_ms: f64) -> Result<(), JsValue> {
        let (elapsed_s, deadline) = self.frame_clock.frame(now_ms);
        self.session.frame(elapsed_s, &mut || clock() < deadline);
        // Another run, or another time of it, in which the robot isn't lifted.
        self.carried = self.carried.filter(|_| self.session.is_lifted());
        self.draw()
    }

    /// Steps of the run at the displayed time.
    pub fn steps(&self) -> f64 {
        self.session.recording().map_or(0.0, |recording| recording.run().steps() as f64)
    }

    /// The picture's scale, CSS pixels per metre, and where the room's lower left corner is on it, CSS pixels from the
    /// left and from the top.
    pub fn floor_to_screen(&self) -> Vec<f64> {
        vec![self.viewport.scale, self.viewport.origin.x, self.viewport.origin.y]
    }

    // ---- time

    /// Starts or continues.
    pub fn play(&mut self) {
        self.session.play();
    }

    /// Pauses.
    pub fn pause(&mut self) {
        self.session.pause();
    }

    /// Advances by one move.
    pub fn step(&mut self) {
        self.session.step();
    }

    /// Returns to the start; what was swept before the room was changed isn't any more.
    pub fn reset(&mut self) {
        self.session.reset();
    }

    /// Sets the speed, times real time; 0 for as fast as possible.
    pub fn set_speed(&mut self, times: f64) {
        self.session.set_speed(times);
    }

    /// Seeks a time within the time simulated so far, s.
    pub fn seek(&mut self, time_s: f64) {
        self.session.seek(time_s);
    }

    /// Time (s) and coverage (0 to 1) of the whole run so far, in pairs.
    pub fn coverage_curve(&self) -> Float64Array {
        let pairs = self.session.recording().map_or(&[][..], |r| r.curve());
        let flat: Vec<f64> = pairs.iter().flat_map(|&(time, coverage)| [time, coverage]).collect();
        Float64Array::from(flat.as_slice())
    }

    /// Corners of the line that was planned, x and y in turn, m; none if there is no plan.
    pub fn corners(&self) -> Vec<f64> {
        self.session.planned().map_or(Vec::new(), |planned| planned.line.iter().flat_map(|p| [p.x, p.y]).collect())
    }

    /// The knots of its trajectory if it is driven smoothly, for `export_files` and `run_bag`; none with stops.
    pub fn knots(&self) -> Float64Array {
        let smooth = self.session.planned().and_then(|planned| planned.smooth.as_deref());
        smooth.map_or_else(|| Float64Array::new_with_length(0), trajectory_to_js)
    }

    /// A person's inputs of the run, for `run_bag`.
    pub fn inputs(&self) -> Vec<f64> {
        self.session.recording().map_or(Vec::new(), |recording| RunBag::inputs_to_numbers(recording.inputs()))
    }

    /// Pans by (`dx`, `dy`) CSS pixels.
    pub fn pan(&mut self, dx: f64, dy: f64) {
        self.viewport.pan(dx, dy);
    }

    /// Zooms by `factor` around (`x`, `y`), CSS pixels.
    pub fn zoom(&mut self, x: f64, y: f64, factor: f64) {
        self.viewport.zoom_at(x, y, factor);
    }

    /// Shows the whole room.
    pub fn fit(&mut self) {
        self.viewport.fit();
    }

    /// Undoes the last change of the room.
    pub fn undo(&mut self) {
        self.session.undo();
    }

    /// Redoes the last undone change.
    pub fn redo(&mut self) {
        self.session.redo();
    }

    /// Reports an error to the user.
    pub fn report_error(&mut self, message: &str) {
        self.session.report_error(message);
    }

    // ---- the picture

    /// The canvas is `width` x `height` CSS pixels on a screen with `ratio` device pixels each.
    pub fn resize(&mut self, width: f64, height: f64, ratio: f64) {
        self.viewport.resize(width, height, ratio);
    }

    /// Keeps the uppermost `height` CSS pixels of the canvas free of the room, for a message, its lower right corner of `right` x
    /// `low`, and its lower left one of `left` x `deep`, for the legend. If no tools float over it, `foot` is the height of what does
    /// at its bottom.
    pub fn keep_clear(&mut self, height: f64, foot: Option<f64>, right: f64, low: f64, left: f64, deep: f64) {
        self.viewport.keep_clear(height, foot, Vector::new(right, low), Vector::new(left, deep));
    }

    /// Dark or light colours.
    pub fn set_dark(&mut self, dark: bool) {
        self.dark = dark;
    }

    fn draw(&mut self) -> Result<(), JsValue> {
        let plan = self.session.plan();
        let now = (plan.name.clone(), plan.width_m(), plan.height_m());
        if now != self.fitted {
            self.viewport.set_room(now.1, now.2);
            self.fitted = now;
        }
        let dirty_rows = self.session.take_changed_rows();
        let dragged = match self.gesture {
            Some(FloorGesture::Start { pose, .. }) => Some(pose),
            _ => None,
        };
        let held = self.carried.map(|carried| carried.pose);
        let start = dragged.or(self.session.prepared().map(|p| p.floor.start));
        let in_hand = self.object_tool.in_hand(&self.session);
        let session = self.session.scene();
        let robot = session.robot.map(|robot| RobotView { pose: held.unwrap_or(robot.pose), ..robot });
        let scene = Scene {
            robot,
            start,
            dirty_rows,
            cursor: self.cursor,
            selected: self.object_tool.selected(&self.session),
            lifted: self.object_tool.lifted(),
            in_hand: &in_hand,
            dark: self.dark,
            ..session
        };
        self.canvas.draw(&scene, &self.viewport)
    }
}

/// A value as JSON. JavaScript writes it: Rust's writer would be some per cent of what opening the page loads.
fn json(value: &impl Serialize) -> Result<String, JsValue> {
    let text = JSON::stringify_with_replacer_and_space(&to_js(value)?, &JsValue::NULL, &1.into())?;
    Ok(String::from(text) + "\n")
}
