//! The Map tab: a mapping session, its canvas and pointer input.

mod hand;
mod ink;
mod marks;
mod paint;
mod picture;

use self::{hand::RobotHand, paint::MapPainter};
use super::session_mirror::SessionMirror;
use js_sys::{Array, Float64Array, Reflect, Uint8Array};
use robovac_app::{
    CatalogueEntry, Import, Viewport,
    export::ExportFile,
    map::{self, MapView},
};
use robovac_core::floor_plan::{FloorPlan, MapImage, OccupancyMode, to_ros_map};
use robovac_core::geometry::Vector;
use robovac_playground::frame_clock::FrameClock;
use robovac_playground::wire::message;
use robovac_playground::wire::{clock, map_file, to_js};
use robovac_sim::experiment::Algorithm;
use robovac_sim::mapping::close_gaps;
use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;

/// Time for simulation in a frame while a stored run is restored, when only its progress changes on the page.
const RETURN_BUDGET_MS: f64 = 40.0;

/// A robot that makes a map of the playground's room.
#[wasm_bindgen]
pub struct MapSession {
    state: map::MapSession,
    painter: MapPainter,
    viewport: Viewport,
    hand: RobotHand,
    frame_clock: FrameClock,
    dark: bool,
    /// Size of the room that the viewport was fitted to, m.
    fitted: (f64, f64),
}

#[wasm_bindgen]
impl MapSession {
    /// Draws on that canvas.
    #[wasm_bindgen(constructor)]
    pub fn new(canvas: HtmlCanvasElement) -> Result<Self, JsValue> {
        Ok(Self {
            state: map::MapSession::new(),
            painter: MapPainter::new(canvas)?,
            viewport: Viewport::new(1.0, 1.0, 1.0, 1.0, 1.0),
            hand: RobotHand::default(),
            frame_clock: FrameClock::default(),
            dark: false,
            fitted: (0.0, 0.0),
        })
    }

    /// Behaviours for mapping and the user's program, in the form of the catalogue.
    #[wasm_bindgen(unchecked_return_type = "rust.CatalogueEntry[]")]
    pub fn explorers() -> Result<JsValue, JsValue> {
        let entries = map::methods().map(|info| CatalogueEntry::new(Algorithm::Behaviour(info)));
        to_js(&entries.collect::<Vec<_>>())
    }

    /// Takes over room, robot, start, conditions and seed from the mirror of the playground; cheap if unchanged.
    pub fn take(&mut self, mirror: &SessionMirror) {
        self.state.take(mirror.session());
    }

    // ---- choices; each throws a message and changes nothing if the choice isn't possible

    /// Sets one choice by its name in links.
    pub fn set(&mut self, key: &str, value: &str) -> Result<(), JsValue> {
        self.state.set(key, value).map_err(message)
    }

    /// Shows or hides a layer of the picture.
    pub fn show(&mut self, layer: &str, on: bool) -> Result<(), JsValue> {
        self.state.show(layer, on).map_err(message)
    }

    /// The choices as the part of a link after the playground's.
    pub fn link(&self) -> String {
        self.state.link()
    }

    /// Restores the result of `link`.
    pub fn restore(&mut self, link: &str) -> Result<(), JsValue> {
        self.state.restore(link).map_err(message)
    }

    /// Key of everything that determines the run, under which it is stored.
    pub fn recipe(&self) -> String {
        self.state.recipe()
    }

    /// The same for a run in which the robot makes its map itself.
    pub fn home(&self) -> String {
        self.state.home()
    }

    // ---- time

    /// Advances by the time since the last call, and draws.
    pub fn frame(&mut self, now_ms: f64) -> Result<(), JsValue> {
        let (elapsed_s, deadline) = self.frame_clock.frame(now_ms);
        let deadline = if self.state.returned().is_some() { clock() + RETURN_BUDGET_MS } else { deadline };
        self.state.frame(elapsed_s, &mut || clock() < deadline);
        self.hand.keep(&self.state);
        self.draw()
    }

    /// Drops the time since the last call, while the tab isn't shown.
    pub fn rest(&mut self) {
        self.frame_clock.rest();
    }

    /// Starts or continues.
    pub fn play(&mut self) {
        self.state.play();
    }

    /// Pauses.
    pub fn pause(&mut self) {
        self.state.pause();
    }

    /// Advances by five seconds.
    pub fn step(&mut self) {
        self.state.step();
    }

    /// Seeks another time within the time simulated so far, s.
    pub fn seek(&mut self, time_s: f64) {
        self.state.seek(time_s);
    }

    /// Starts cleaning the remaining floor by the robot's map.
    pub fn clean(&mut self) {
        self.state.clean();
    }

    /// Planners for the remaining floor: `[id, title]` each.
    pub fn cleaners() -> Result<JsValue, JsValue> {
        to_js(&map::cleaners().map(|info| [info.id, info.title]).collect::<Vec<_>>())
    }

    /// Drops the map.
    pub fn forget(&mut self) {
        self.state.forget();
    }

    // ---- state

    /// Snapshot in numbers and words.
    #[wasm_bindgen(unchecked_return_type = "rust.MapView")]
    pub fn view(&self) -> Result<JsValue, JsValue> {
        to_js(&MapView { is_carried: self.hand.holds(), ..self.state.view() })
    }

    /// One or two sentences that describe the picture.
    pub fn description(&self) -> String {
        self.state.description()
    }

    /// The errors over time: seconds, share of the boundary mapped, pose error and that of odometry alone (m, NaN while
    /// there is none), in turn.
    pub fn curve(&self) -> Float64Array {
        let metres = |error: Option<f64>| error.unwrap_or(f64::NAN);
        let numbers = |s: map::CurveSample| [s.time_s, s.boundary, metres(s.position_m), metres(s.odometry_m)];
        let curve: Vec<f64> = self.state.curve().flat_map(numbers).collect();
        Float64Array::from(curve.as_slice())
    }

    // ---- the user's program, if that is the method

    /// What it needs to drive a simulation of its own, for `ProgramRunner`; `undefined` unless it drives.
    pub fn program_job(&self, mirror: &SessionMirror) -> Option<Vec<u8>> {
        self.state.program_job(mirror.session()).map(|job| job.to_bytes())
    }

    /// Takes a part of its log, of that `version` of the view; of an older one, it is left out and the result is false.
    /// Throws a message if it doesn't continue the log.
    pub fn extend_program(&mut self, version: u32, part: &[u8]) -> Result<bool, JsValue> {
        self.state.extend_program(version, part).map_err(message)
    }

    /// The program of that `version` is heard no more: the robot stops where its log ends.
    pub fn fail_program(&mut self, version: u32) {
        self.state.fail_program(version);
    }

    /// The whole log, for `map_bag`; `undefined` for other methods.
    pub fn program_log(&self) -> Option<Vec<u8>> {
        self.state.program_log()
    }

    // ---- storage

    /// The session as text; `undefined` if there is nothing worth storing.
    pub fn store(&self) -> Option<String> {
        self.state.store()
    }

    /// Restores a stored session. Throws a sentence for users and changes nothing if that isn't possible.
    pub fn resume(&mut self, text: &str) -> Result<(), JsValue> {
        Ok(self.state.resume(text).map_err(|e| e.to_string())?)
    }

    /// Whether the last restored run ended in another state, reported once: the stored map should be kept.
    pub fn take_strayed(&mut self) -> bool {
        self.state.take_strayed()
    }

    // ---- use of the map

    /// The map as a room for `Playground.take_map`: gaps between lanes are floor, as for a robot that cleans with it. Throws a
    /// sentence for users if there is none.
    pub fn room(&self) -> Result<Vec<u8>, JsValue> {
        let mut plan = self.mapped()?;
        close_gaps(&mut plan.occupancy, plan.resolution);
        map_file::import_to_bytes(Import { plan, choices: None })
    }

    /// The map as a ROS map: `{ name, bytes, kind }` of its image and its description, named `stem`.
    pub fn ros_map(&self, stem: &str) -> Result<Array, JsValue> {
        ros_map(&self.mapped()?, stem)
    }

    /// Gives the robot a map read by a worker, and kidnaps it to a random place. Throws a sentence for users and
    /// changes nothing if that isn't possible.
    pub fn open(&mut self, map: &[u8]) -> Result<(), JsValue> {
        let import = map_file::import_from_bytes(map)?;
        Ok(self.state.open(&import.plan).map_err(|e| e.to_string())?)
    }

    /// The same with the map that it made.
    pub fn open_own(&mut self) -> Result<(), JsValue> {
        Ok(self.state.open_own().map_err(|e| e.to_string())?)
    }

    /// Removes the given map.
    pub fn close_map(&mut self) {
        self.state.close_map();
    }

    // ---- the view

    /// The canvas is `width` x `height` CSS pixels on a screen with `ratio` device pixels each.
    pub fn resize(&mut self, width: f64, height: f64, ratio: f64) {
        self.viewport.resize(width, height, ratio);
    }

    /// Pans by CSS pixels.
    pub fn pan(&mut self, dx: f64, dy: f64) {
        self.viewport.pan(dx, dy);
    }

    /// Zooms by `factor` around (`x`, `y`), CSS pixels.
    pub fn zoom(&mut self, x: f64, y: f64, factor: f64) {
        self.viewport.zoom_at(x, y, factor);
    }

    /// Keeps the uppermost `told` CSS pixels free while all of the room is shown, and `right` x `low` of the lower right corner. If
    /// neither legend nor zoom floats over it, `foot` is the height of what does at its bottom.
    pub fn keep_clear(&mut self, told: f64, foot: Option<f64>, right: f64, low: f64) {
        self.viewport.keep_clear(told, foot, Vector::new(right, low), Vector::zeros());
    }

    /// Shows all of the room.
    pub fn fit(&mut self) {
        self.viewport.fit();
    }

    /// Dark or light colours.
    pub fn set_dark(&mut self, dark: bool) {
        self.dark = dark;
    }
}

impl MapSession {
    fn draw(&mut self) -> Result<(), JsValue> {
        let Some(plan) = self.state.plan() else { return Ok(()) };
        let size = (plan.width_m(), plan.height_m());
        if size != self.fitted {
            self.viewport.set_room(size.0, size.1);
            self.fitted = size;
        }
        self.painter.draw(&self.state, &self.viewport, self.hand.pose(), self.dark)
    }

    fn mapped(&self) -> Result<FloorPlan, JsValue> {
        self.state.estimate().ok_or("there is no map: the robot doesn't fit into this room")?;
        let title = self.state.plan().map_or("room", |plan| &plan.name);
        with_floor(self.state.to_plan(&format!("{title}, as mapped")))
    }
}

/// The map in a text of `MapSession.store`, in the form of `MapSession.ros_map`. For runs that can't be restored, such
/// as those of another version. Throws a sentence for users.
#[wasm_bindgen]
pub fn stored_ros_map(text: &str, stem: &str) -> Result<Array, JsValue> {
    let stored = map::Stored::from_text(text).map_err(|e| e.to_string())?;
    ros_map(&with_floor(stored.map.to_plan(&stored.title))?, stem)
}

/// A map that is of use.
fn with_floor(plan: Option<FloorPlan>) -> Result<FloorPlan, JsValue> {
    let plan = plan.ok_or("the map is still empty; let the robot explore first")?;
    if plan.occupancy.values().iter().any(|cell| cell.is_free()) {
        Ok(plan)
    } else {
        Err("the map has no floor yet; let the robot explore first".into())
    }
}

fn ros_map(plan: &FloorPlan, stem: &str) -> Result<Array, JsValue> {
    let map = to_ros_map(plan, stem, MapImage::Pgm, OccupancyMode::Trinary, false).map_err(|e| e.to_string())?;
    let yaml = ExportFile { name: format!("{stem}.yaml"), kind: "application/yaml", bytes: map.yaml.into_bytes() };
    let image = ExportFile { name: map.image_name, kind: "image/x-portable-graymap", bytes: map.image };
    let files = [image, yaml].into_iter().map(|file| {
        let object = js_sys::Object::new();
        Reflect::set(&object, &"name".into(), &file.name.into())?;
        Reflect::set(&object, &"kind".into(), &file.kind.into())?;
        Reflect::set(&object, &"bytes".into(), &Uint8Array::from(file.bytes.as_slice()))?;
        Ok(JsValue::from(object))
    });
    files.collect::<Result<Array, JsValue>>()
}
