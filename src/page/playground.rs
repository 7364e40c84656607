//! The page's main object: a session, its canvas and pointer input.

mod hand;

use self::hand::Carried;
use coverage_planners::{ProgressReport, TraceStep};
use js_sys::{Array, Float64Array, JSON};
use robovac_app::{
    RobotView, Scene, Viewport,
    explore::{Brush, Catalogue, FloorTool, ObjectTool, PageView, RobotEntry, Session},
    export::RunBag,
};
use robovac_core::{
    floor_plan::Object,
    geometry::{Point, Pose, Vector},
    grid::Cell,
    program::{Program, ProgramKind, ProgramLanguage},
};
use robovac_playground::wire::message;
use robovac_playground::{
    canvas::Canvas,
    wire::{
        clock, frames::frames_from_js, map_file, proof::proof_from_js, request, to_js, trajectory::trajectory_from_js,
        walk,
    },
};
use robovac_sim::{
    controller,
    experiment::{SettingsError, planning::PlanAnswer},
};
use serde::Serialize;
use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;

/// Time for simulation in a frame, ms; the rest of 16.7 ms is for drawing and the browser.
const FRAME_BUDGET_MS: f64 = 8.0;
/// Simulated time of the opening scene at its start, s, so that there is something to see at once.
const OPENING_S: f64 = 600.0;

/// Least distance from the robot's centre at which the pointer grips it, CSS pixels.
const LEAST_GRIP_PX: f64 = 16.0;
/// Distance of the pointer at which a robot is picked up, CSS pixels; a click does nothing.
const LEAST_LIFT_PX: f64 = 4.0;

/// A gesture between pointer down and up.
#[derive(Clone, Copy, PartialEq)]
enum FloorGesture {
    Pan {
        x: f64,
        y: f64,
    },
    Paint,
    /// Drags an object.
    Object,
    /// Places the start here on release; dragging turns it if `turns`, else moves it.
    Start {
        pose: Pose,
        turns: bool,
    },
    /// Grips a running robot, whose centre is `grip` from the pointer that went down at (`x`, `y`).
    Grip {
        x: f64,
        y: f64,
        grip: Vector,
    },
    /// Carries it.
    Carry {
        grip: Vector,
    },
}

/// A session shown on a canvas.
#[wasm_bindgen]
pub struct Playground {
    pub(super) session: Session,
    pub(super) furnisher: ObjectTool,
    /// Whether this is still the opening scene.
    is_opening: bool,
    canvas: Canvas,
    pub(super) viewport: Viewport,
    tool: FloorTool,
    gesture: Option<FloorGesture>,
    /// The robot, if it is lifted.
    carried: Option<Carried>,
    /// Cell of the keyboard cursor.
    cursor: Option<Cell>,
    last_frame_ms: Option<f64>,
    dark: bool,
    /// Start of a press of the view tool while it can be a click, CSS pixels.
    pub(super) pressed: Option<(f64, f64)>,
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
            furnisher: ObjectTool::new(),
            is_opening: true,
            canvas: Canvas::new(canvas)?,
            viewport: Viewport::new(1.0, 1.0, 1.0, 1.0, 1.0),
            tool: FloorTool::View,
            gesture: None,
            carried: None,
            cursor: None,
            last_frame_ms: None,
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
        // The robot's message must not hide it.
        let is_held_high =
            self.carried.is_some_and(|it| self.viewport.to_screen(it.pose.position()).y < 0.5 * self.viewport.size.y);
        to_js(&PageView {
            session: self.session.view(),
            tool: self.tool,
            objects: self.session.plan().objects.iter().map(Object::name).collect(),
            selected: self.furnisher.selected(&self.session).map_or(-1, |index| index as i32),
            placing: self.furnisher.kind.id(),
            is_carried: self.carried.is_some(),
            is_held_high,
        })
    }

    /// One or two sentences that describe the picture.
    pub fn description(&self) -> String {
        self.session.description()
    }

    /// Advances by the time since the last call, and draws.
    pub fn frame(&mut self, now_ms: f64) -> Result<(), JsValue> {
        let elapsed_s = self.last_frame_ms.replace(now_ms).map_or(0.0, |last| (now_ms - last) / 1000.0);
        let deadline = clock() + FRAME_BUDGET_MS;
        self.session.frame(elapsed_s, &mut || clock() < deadline);
        // Another run, or another time of it, in which the robot isn't lifted.
        self.carried = self.carried.filter(|_| self.session.is_lifted());
        self.draw()
    }

    // ---- planning

    /// The pending planning request, returned once; pass it to `plan` in a worker. To be called in every frame.
    #[wasm_bindgen(unchecked_return_type = "{ id: number } | undefined")]
    pub fn take_plan_request(&mut self) -> Result<JsValue, JsValue> {
        let request = self.session.take_plan_request();
        // A changed opening scene starts at its beginning.
        if std::mem::take(&mut self.is_opening) && request.is_none() {
            self.session.run_ahead(OPENING_S);
        }
        request.map_or(Ok(JsValue::UNDEFINED), |request| request::request_to_js(&request))
    }

    /// Progress of the worker: the share done, its best path so far, the path's proof (cost and bound), and new film
    /// frames.
    pub fn plan_progress(
        &mut self,
        id: u32,
        done: f64,
        path: &JsValue,
        proof: Option<Vec<f64>>,
        film: &Array,
    ) -> Result<(), JsValue> {
        let proof = proof_from_js(proof);
        self.session.plan_filmed(id, frames_from_js(film)?);
        let path = walk::path_from_js(path);
        self.session.plan_progress(id, ProgressReport { done, walk: &path.cells, line: &path.line, proof });
        Ok(())
    }

    /// The worker has finished.
    pub fn plan_finished(
        &mut self,
        id: u32,
        path: &JsValue,
        seconds: f64,
        trace: JsValue,
        proof: Option<Vec<f64>>,
    ) -> Result<(), JsValue> {
        let trace: Vec<TraceStep> = serde_wasm_bindgen::from_value(trace).map_err(|e| e.to_string())?;
        let path = walk::path_from_js(path);
        let proof = proof_from_js(proof);
        self.session.plan_finished(id, PlanAnswer { path, seconds, proof, trace });
        Ok(())
    }

    /// The worker has rounded the corners of its plan; see `smooth`.
    pub fn plan_smoothed(&mut self, id: u32, knots: &[f64]) {
        self.session.plan_smoothed(id, trajectory_from_js(knots));
    }

    /// The worker has proven bounds of its plan: its cost and the least, and the least length, m, and time, s.
    pub fn plan_proven(&mut self, id: u32, proof: Option<Vec<f64>>, least: Option<Vec<f64>>) {
        let least = least.and_then(|least| least.try_into().ok());
        self.session.plan_proven(id, proof_from_js(proof), least);
    }

    /// The worker has failed.
    pub fn plan_failed(&mut self, id: u32, message: &str) {
        self.session.plan_failed(id, message);
    }

    /// Cancels planning. The page must end the worker.
    pub fn cancel_plan(&mut self) {
        self.session.cancel_plan();
    }

    /// Ends planning with the best walk so far, `seconds` after the worker began. The page must end the worker.
    pub fn keep_plan(&mut self, seconds: f64) {
        self.session.keep_plan(seconds);
    }

    // ---- choices; each throws a message and changes nothing if the choice isn't possible

    /// Chooses a built-in room.
    pub fn select_room(&mut self, id: &str) -> Result<(), JsValue> {
        self.session.select_room(id).map_err(message)
    }

    /// Chooses a planner or behaviour.
    pub fn select_algorithm(&mut self, id: &str) -> Result<(), JsValue> {
        self.session.configure(|s| s.select_algorithm(id)).map_err(message)
    }

    /// Chooses a robot.
    pub fn select_robot(&mut self, id: &str) -> Result<(), JsValue> {
        self.session.configure(|s| s.select_robot(id)).map_err(message)
    }

    /// Chooses the side of the planning cells, m.
    pub fn set_cell_size(&mut self, metres: f64) -> Result<(), JsValue> {
        self.session.configure(|s| s.set_cell_size(metres)).map_err(message)
    }

    /// Shows or hides the planner's decisions.
    pub fn show_search(&mut self, on: bool) {
        self.session.show_search(on);
    }

    /// Makes films wait for [`Playground::turn_film`].
    pub fn hold_films(&mut self) {
        self.session.hold_films();
    }

    /// Shows the film's next or previous picture.
    pub fn turn_film(&mut self, forward: bool) {
        self.session.turn_film(forward);
    }

    /// Holds the film, or continues it.
    pub fn hold_film(&mut self, is_held: bool) {
        self.session.hold_film(is_held);
    }

    /// Sets a parameter of the planner from the text of a form.
    pub fn set_param(&mut self, id: &str, text: &str) -> Result<(), JsValue> {
        self.session.configure(|s| s.set_param(id, text)).map_err(message)
    }

    /// Sets the seed of everything random.
    pub fn set_seed(&mut self, seed: u32) -> Result<(), JsValue> {
        let set = |s: &mut robovac_sim::experiment::Settings| {
            s.seed = u64::from(seed);
            Ok::<(), SettingsError>(())
        };
        self.session.configure(set).map_err(message)
    }

    /// Chooses the level of wheel slip: `none`, `typical` or `harsh`.
    pub fn set_slip(&mut self, id: &str) -> Result<(), JsValue> {
        self.session.configure(|s| s.set_slip(id)).map_err(message)
    }

    /// Chooses the level of noise, `off`, `typical` or `harsh`, of one kind of the catalogue's `sensors`, or of `all`.
    pub fn set_noise(&mut self, sensor: &str, level: &str) -> Result<(), JsValue> {
        self.session.configure(|s| s.set_noise(Some(sensor).filter(|&name| name != "all"), level)).map_err(message)
    }

    /// Limits wheel speeds to those that the motor controller can keep, or not.
    pub fn set_quantised(&mut self, on: bool) -> Result<(), JsValue> {
        let set = |s: &mut robovac_sim::experiment::Settings| {
            s.conditions.quantised = on;
            Ok::<(), SettingsError>(())
        };
        self.session.configure(set).map_err(message)
    }

    /// Rounds the corners of plans, or not.
    pub fn set_smooth(&mut self, on: bool) -> Result<(), JsValue> {
        let set = |s: &mut robovac_sim::experiment::Settings| {
            s.smooth = on;
            Ok::<(), SettingsError>(())
        };
        self.session.configure(set).map_err(message)
    }

    /// Sets the charge of the battery at the start from the text of a form, percent.
    pub fn set_start_charge(&mut self, text: &str) -> Result<(), JsValue> {
        self.session.configure(|s| s.set_start_charge(text.trim().parse().ok(), text)).map_err(message)
    }

    /// Shows or hides a layer of the picture: `coverage`, `dirt`, `sensors` or `estimate`.
    pub fn show(&mut self, layer: &str, on: bool) -> Result<(), JsValue> {
        self.session.show(layer, on).map_err(message)
    }

    /// Chooses how the follower computes its pose: `arc` or `straight`.
    pub fn set_odometry(&mut self, id: &str) -> Result<(), JsValue> {
        self.session.configure(|s| s.set_odometry(id)).map_err(message)
    }

    /// Takes a map or scenario read by `read_map` in a worker.
    pub fn take_map(&mut self, read: &JsValue) -> Result<(), JsValue> {
        let import = map_file::import_from_js(read)?;
        self.session.take_import(import).map_err(|e| JsValue::from(e.to_string()))
    }

    /// The room and the settings as a scenario file.
    pub fn scenario_json(&self) -> Result<String, JsValue> {
        json(&self.session.scenario())
    }

    /// Restores the result of `link`. Throws a message and changes nothing if that isn't possible.
    pub fn restore(&mut self, link: &str) -> Result<(), JsValue> {
        self.session.restore(link).map_err(message)?;
        // A page that opens by a link begins there.
        if std::mem::take(&mut self.is_opening) {
            self.session.forget_changes();
        }
        Ok(())
    }

    /// The session as the part of a link behind `#`.
    pub fn link(&self) -> String {
        self.session.link()
    }

    /// Changes whenever the room does.
    pub fn room_version(&self) -> f64 {
        self.session.plan_version() as f64
    }

    /// A number that changes with the room, but not with changes of it: undo brings it back.
    pub fn room_lineage(&self) -> u32 {
        self.session.room_lineage()
    }

    /// Renames the room, which is then an own one.
    pub fn rename_room(&mut self, name: &str) {
        self.session.rename_room(name);
    }

    /// Room and settings for `SessionMirror.follow`, without an own room whose version is `known`.
    #[wasm_bindgen(unchecked_return_type = "rust.SessionSnapshot")]
    pub fn snapshot(&self, known: Option<f64>) -> Result<JsValue, JsValue> {
        let mut snapshot = self.session.snapshot();
        if snapshot.room.is_none() && known != Some(snapshot.room_version as f64) {
            snapshot.own = Some(self.session.own_room());
        }
        to_js(&snapshot)
    }

    // ---- the user's program

    /// Keeps a user's program, `language` `python` or `javascript`, `kind` `behaviour` or `planner`, and chooses it if
    /// `is_chosen`. Throws a message and changes nothing if it isn't accepted.
    pub fn set_program(
        &mut self,
        name: String,
        language: &str,
        kind: &str,
        source: String,
        is_chosen: bool,
    ) -> Result<(), JsValue> {
        let (language, kind) =
            ProgramLanguage::parse(language).zip(ProgramKind::parse(kind)).ok_or("unknown kind of program")?;
        self.session.set_program(Program { name, language, kind, source }, is_chosen).map_err(message)
    }

    /// The program that is kept; `undefined` without one.
    #[wasm_bindgen(unchecked_return_type = "rust.Program | undefined")]
    pub fn program(&self) -> Result<JsValue, JsValue> {
        self.session.settings().program().map_or(Ok(JsValue::UNDEFINED), |program| to_js(&**program))
    }

    /// What the program needs to drive a simulation of its own, for `ProgramRunner`.
    pub fn program_job(&self) -> Result<Vec<u8>, JsValue> {
        Ok(json(&self.session.program_job())?.into_bytes())
    }

    /// Takes a part of the log of the program with that `version` of the view; of an older one, it is left out and the
    /// result is false. Throws a message if it doesn't continue the log.
    pub fn extend_program(&mut self, version: u32, part: &[u8]) -> Result<bool, JsValue> {
        self.session.extend_program(version, part).map_err(message)
    }

    /// The whole log of the program, for `run_bag`; `undefined` unless one drives.
    pub fn program_log(&self) -> Option<Vec<u8>> {
        self.session.program_log()
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

    /// A person's inputs of the run, for `run_bag`.
    pub fn inputs(&self) -> Vec<f64> {
        self.session.recording().map_or(Vec::new(), |recording| RunBag::inputs_to_numbers(recording.inputs()))
    }

    // ---- pointer and keys

    /// Selects the pointer's tool: `view`, `wall`, `erase`, `start` or `place`.
    pub fn set_tool(&mut self, id: &str) {
        self.tool = match id {
            "wall" => FloorTool::Wall,
            "erase" => FloorTool::Erase,
            "start" => FloorTool::Start,
            "place" => FloorTool::Place,
            _ => FloorTool::View,
        };
        self.cursor = None;
        self.end_gesture();
    }

    /// The pointer at (`x`, `y`), CSS pixels on the canvas: `down`, `move`, `up` or `cancel`.
    pub fn pointer(&mut self, kind: &str, x: f64, y: f64) {
        let at = self.viewport.to_world(x, y);
        if self.tool == FloorTool::View {
            self.watch_for_click(kind, x, y);
        }
        match (kind, self.gesture) {
            ("down", _) => self.press(at, x, y),
            ("move", Some(FloorGesture::Pan { x: from_x, y: from_y })) => {
                self.viewport.pan(x - from_x, y - from_y);
                self.gesture = Some(FloorGesture::Pan { x, y });
            }
            ("move", Some(FloorGesture::Paint)) => self.session.go_on_stroke(at),
            ("move", Some(FloorGesture::Object)) => self.furnisher.go_on(at),
            ("move", Some(FloorGesture::Start { pose, turns: true })) => {
                let aim = at - pose.position();
                if aim.norm() > 0.1 {
                    let heading = robovac_core::math::atan2(aim.y, aim.x);
                    self.gesture = Some(FloorGesture::Start { pose: Pose::new(pose.x, pose.y, heading), turns: true });
                }
            }
            ("move", Some(FloorGesture::Start { pose, turns: false })) => {
                self.gesture = Some(FloorGesture::Start { pose: Pose::new(at.x, at.y, pose.heading), turns: false });
            }
            ("move", Some(FloorGesture::Grip { x: from_x, y: from_y, grip }))
                if (x - from_x).abs().max((y - from_y).abs()) >= LEAST_LIFT_PX =>
            {
                self.take_robot();
                self.gesture = Some(FloorGesture::Carry { grip });
                self.carry_to(at, grip);
            }
            ("move", Some(FloorGesture::Carry { grip })) => self.carry_to(at, grip),
            // Picked up by its button, it is where the pointer is.
            ("move", None) => self.carry_to(at, Vector::zeros()),
            ("cancel", Some(FloorGesture::Carry { .. })) => {
                self.put_back();
                self.gesture = None;
            }
            ("cancel", Some(FloorGesture::Start { .. })) => self.gesture = None,
            ("cancel", Some(FloorGesture::Object)) => {
                self.furnisher.let_go();
                self.gesture = None;
            }
            ("cancel", Some(FloorGesture::Paint)) => {
                self.session.abandon_stroke();
                self.gesture = None;
            }
            ("up" | "cancel", _) => self.end_gesture(),
            _ => {}
        }
    }

    fn press(&mut self, at: Point, x: f64, y: f64) {
        self.cursor = None;
        let heading = self.session.prepared().map_or(0.0, |p| p.floor.start.heading);
        let tool = self.tool;
        self.gesture = Some(match tool {
            FloorTool::Wall | FloorTool::Erase => {
                let brush = if self.tool == FloorTool::Wall { Brush::Wall } else { Brush::Erase };
                self.session.begin_stroke(brush, at);
                FloorGesture::Paint
            }
            FloorTool::Start => FloorGesture::Start { pose: Pose::new(at.x, at.y, heading), turns: true },
            // A click puts down a lifted robot; see `watch_for_click`.
            FloorTool::View if self.carried.is_some() && !self.is_on_robot(at) => FloorGesture::Pan { x, y },
            FloorTool::View | FloorTool::Place if self.takes_selected(at) => FloorGesture::Object,
            FloorTool::Place => {
                self.furnisher.begin(at);
                FloorGesture::Object
            }
            FloorTool::View if self.is_on_robot(at) && (self.carried.is_some() || self.may_lift()) => {
                self.grip(at, x, y)
            }
            FloorTool::View if self.is_on_robot(at) => {
                FloorGesture::Start { pose: Pose::new(at.x, at.y, heading), turns: false }
            }
            FloorTool::View if self.takes_object(at) => FloorGesture::Object,
            FloorTool::View => FloorGesture::Pan { x, y },
        });
    }

    fn end_gesture(&mut self) {
        match self.gesture.take() {
            Some(FloorGesture::Paint) => self.session.end_stroke(),
            Some(FloorGesture::Start { pose, .. }) => self.session.move_start(pose),
            Some(FloorGesture::Object) => self.furnisher.release(&mut self.session),
            Some(FloorGesture::Carry { .. }) if self.carried.is_some() => self.pick_up(),
            _ => {}
        }
    }

    /// Grips the robot at `at`, which is (`x`, `y`) on the screen.
    fn grip(&self, at: Point, x: f64, y: f64) -> FloorGesture {
        let pose = self.carried.map(|c| c.pose).or(self.session.recording().map(|r| r.run().pose()));
        let grip = pose.map_or(Vector::zeros(), |pose| pose.position() - at);
        if self.carried.is_some() { FloorGesture::Carry { grip } } else { FloorGesture::Grip { x, y, grip } }
    }

    fn is_on_robot(&self, at: Point) -> bool {
        // No grip during a film.
        if self.session.picture().is_some() {
            return false;
        }
        let radius = self.session.settings().robot_model().radius;
        let robot = self.carried.map(|c| c.pose).or(self.session.recording().map(|r| r.run().pose()));
        let reach = radius.max(LEAST_GRIP_PX / self.viewport.scale);
        robot.is_some_and(|pose| (pose.position() - at).norm() < reach)
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

    /// Drawing by keyboard: `left`, `right`, `up`, `down` move a cursor by a planning cell, `apply` draws there.
    pub fn key_edit(&mut self, action: &str) {
        let plan = self.session.plan();
        let stride = (self.session.settings().cell_size / plan.resolution).round().max(1.0) as i32;
        let (width, height) = (plan.occupancy.width() as i32, plan.occupancy.height() as i32);
        let cursor = self.cursor.unwrap_or(Cell::new(width / 2, height / 2));
        let (dx, dy) = match action {
            "left" => (-stride, 0),
            "right" => (stride, 0),
            "up" => (0, stride),
            "down" => (0, -stride),
            _ => (0, 0),
        };
        let at = Cell::new((cursor.x + dx).clamp(0, width - 1), (cursor.y + dy).clamp(0, height - 1));
        if action == "apply" {
            let point = plan.centre(at);
            let heading = self.session.prepared().map_or(0.0, |p| p.floor.start.heading);
            match self.tool {
                FloorTool::Wall => self.session.begin_stroke(Brush::Wall, point),
                FloorTool::Erase => self.session.begin_stroke(Brush::Erase, point),
                FloorTool::Start => self.session.move_start(Pose::new(point.x, point.y, heading)),
                FloorTool::Place => {
                    self.furnisher.begin(point);
                    self.furnisher.release(&mut self.session);
                }
                FloorTool::View => {}
            }
            self.session.end_stroke();
        }
        self.cursor = Some(at);
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

    /// Keeps the uppermost `told` CSS pixels of the canvas free of the room, for a message.
    pub fn keep_clear(&mut self, told: f64) {
        self.viewport.keep_clear(told);
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
        let in_hand = self.furnisher.in_hand(&self.session);
        let session = self.session.scene();
        let robot = session.robot.map(|robot| RobotView { pose: held.unwrap_or(robot.pose), ..robot });
        let scene = Scene {
            robot,
            start,
            dirty_rows,
            cursor: self.cursor,
            selected: self.furnisher.selected(&self.session),
            lifted: self.furnisher.lifted(),
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
