//! The Compare tab: settings, trials, and the race on up to nine canvases.

use super::session_mirror::SessionMirror;
use coverage_planners::metrics::PlanNumbers;
use js_sys::Float64Array;
use robovac_app::{
    Scene, Viewport,
    compare::{self, ComparisonView, MOST_LANES, RoomChoice, TableView},
};
use robovac_playground::frame_clock::FrameClock;
use robovac_playground::wire::message;
use robovac_playground::{
    canvas::Canvas,
    wire::{clock, to_js, trajectory::trajectory_from_js, walk},
};
use robovac_sim::experiment::PlanOutcome;
use std::sync::Arc;
use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;

/// A comparison of planners in the playground's room.
#[wasm_bindgen]
pub struct Comparison {
    state: compare::Comparison,
    panes: Vec<Pane>,
    frame_clock: FrameClock,
    dark: bool,
}

/// A canvas with its content.
struct Pane {
    canvas: Canvas,
    viewport: Viewport,
    room: (f64, f64),
}

impl Pane {
    fn new(canvas: HtmlCanvasElement) -> Result<Self, JsValue> {
        Ok(Self { canvas: Canvas::new(canvas)?, viewport: Viewport::bare(), room: (0.0, 0.0) })
    }

    fn draw(&mut self, scene: &Scene<'_>) -> Result<(), JsValue> {
        let room = (scene.plan.width_m(), scene.plan.height_m());
        if room != self.room {
            self.viewport.set_room(room.0, room.1);
            self.room = room;
        }
        self.canvas.draw(scene, &self.viewport)
    }
}

#[wasm_bindgen]
impl Comparison {
    /// A comparison of some planners.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self { state: compare::Comparison::new(), panes: Vec::new(), frame_clock: FrameClock::default(), dark: false }
    }

    /// Takes over room, robot, start and seed from the mirror of the playground; cheap if unchanged.
    pub fn take(&mut self, mirror: &SessionMirror) {
        self.state.take(mirror.session());
    }

    // ---- choices; each throws a message and changes nothing if the choice isn't possible

    /// Includes one of the view's entrants, or excludes it.
    pub fn choose(&mut self, entrant: usize, takes_part: bool) {
        self.state.choose(entrant, takes_part);
    }

    /// Sets a parameter of one of the view's entrants from the text of a form.
    pub fn set_param(&mut self, entrant: usize, id: &str, text: &str) -> Result<(), JsValue> {
        self.state.set_param(entrant, id, text).map_err(message)
    }

    /// Includes one of the view's entrants once more, to be given other parameters.
    pub fn copy(&mut self, entrant: usize) {
        self.state.copy(entrant);
    }

    /// Removes a copy.
    pub fn remove_copy(&mut self, entrant: usize) {
        self.state.remove_copy(entrant);
    }

    /// Lets a chosen entrant race, or takes it out of the race.
    pub fn set_racing(&mut self, entrant: usize, races: bool) {
        self.state.set_racing(entrant, races);
    }

    /// Chooses the rooms, by the id of one of the view's `sets`.
    pub fn set_rooms(&mut self, id: &str) -> Result<(), JsValue> {
        self.state.set_rooms(id).map_err(message)
    }

    /// Number of seeds for planners that use random numbers.
    pub fn set_seeds(&mut self, seeds: u32) {
        self.state.set_seeds(seeds);
    }

    /// The choices as the part of a link after the playground's.
    pub fn link(&self) -> String {
        self.state.to_link()
    }

    /// Restores the result of `link`.
    pub fn restore(&mut self, link: &str) -> Result<(), JsValue> {
        self.state.restore(link).map_err(message)
    }

    // ---- trials

    /// A trial to be run, if any; pass it to `TrialRunner.run` in a worker.
    #[wasm_bindgen(unchecked_return_type = "{ id: number } | undefined")]
    pub fn take_trial(&mut self) -> Result<JsValue, JsValue> {
        self.state.take_trial().map_or(Ok(JsValue::UNDEFINED), |request| to_js(&request))
    }

    /// Whether a running trial is still required.
    pub fn is_wanted(&self, id: u32) -> bool {
        self.state.is_wanted(id)
    }

    /// Progress of a worker.
    pub fn trial_progress(&mut self, id: u32, done: f64) {
        self.state.trial_progress(id, done);
    }

    /// A worker has finished.
    pub fn trial_finished(
        &mut self,
        id: u32,
        path: &JsValue,
        numbers: JsValue,
        knots: Option<Vec<f64>>,
    ) -> Result<(), JsValue> {
        let numbers: PlanNumbers = serde_wasm_bindgen::from_value(numbers).map_err(|e| e.to_string())?;
        let path = walk::path_from_js(path);
        let smooth = knots.map(|knots| Arc::new(trajectory_from_js(&knots)));
        self.state.trial_finished(id, Ok(PlanOutcome { numbers, path, smooth }));
        Ok(())
    }

    /// A worker has failed.
    pub fn trial_failed(&mut self, id: u32, message: &str) {
        self.state.trial_finished(id, Err(message.to_owned()));
    }

    /// Cancels the remaining trials.
    pub fn cancel(&mut self) {
        self.state.cancel();
    }

    /// Continues after `cancel`.
    pub fn resume(&mut self) {
        self.state.resume();
    }

    /// The job of the user's program in the race, returned once, for `ProgramRunner`; its version is the number of its
    /// log.
    pub fn take_race_job(&mut self) -> Option<Vec<u8>> {
        self.state.take_race_job().map(|job| job.to_bytes())
    }

    /// Takes a part of the log with that number; of an older one, it is left out and the result is false.
    pub fn extend_race(&mut self, number: u32, part: &[u8]) -> Result<bool, JsValue> {
        self.state.extend_race(number, part).map_err(message)
    }

    /// The program that makes the log with that number has failed; why, for users.
    pub fn race_failed(&mut self, number: u32, why: &str) {
        self.state.race_failed(number, why);
    }

    // ---- results

    /// Snapshot for every frame: choices, progress, race.
    #[wasm_bindgen(unchecked_return_type = "rust.ComparisonView")]
    pub fn view(&self) -> Result<JsValue, JsValue> {
        to_js(&ComparisonView::new(&self.state))
    }

    /// The table of a room by its index in the view's list, or of all rooms together; changes with the view's
    /// `version`.
    #[wasm_bindgen(unchecked_return_type = "rust.TableView")]
    pub fn table(&self, room: Option<usize>) -> Result<JsValue, JsValue> {
        let room: Option<RoomChoice> = room.and_then(|index| self.state.rooms().get(index).copied());
        to_js(&TableView::new(&self.state.table(room), room.and_then(|room| self.state.numbers(room))))
    }

    /// All trials as CSV.
    pub fn csv(&self) -> String {
        compare::to_csv(&self.state.records())
    }

    /// All trials as JSON.
    pub fn json(&self) -> String {
        compare::to_json(&self.state.records())
    }

    // ---- race

    /// Advances by the time since the last call, and draws.
    pub fn frame(&mut self, now_ms: f64) -> Result<(), JsValue> {
        let (elapsed_s, deadline) = self.frame_clock.frame(now_ms);
        let Some(race) = self.state.race_mut() else { return Ok(()) };
        race.frame(elapsed_s, &mut || clock() < deadline);
        for (index, pane) in self.panes.iter_mut().enumerate() {
            let dirty_rows = race.take_changed_rows(index);
            if let Some(lane) = race.lanes().get(index) {
                pane.draw(&Scene { dirty_rows, dark: self.dark, ..race.scene(lane) })?;
            }
        }
        Ok(())
    }

    /// The canvases of the race, one per lane, in the order of the view's lanes.
    pub fn set_panes(&mut self, canvases: Vec<HtmlCanvasElement>) -> Result<(), JsValue> {
        self.panes = canvases.into_iter().take(MOST_LANES).map(Pane::new).collect::<Result<_, _>>()?;
        Ok(())
    }

    /// Every canvas of the race is `width` x `height` CSS pixels on a screen with `ratio` device pixels each.
    pub fn resize(&mut self, width: f64, height: f64, ratio: f64) {
        for pane in &mut self.panes {
            pane.viewport.resize(width, height, ratio);
            pane.viewport.fit();
        }
    }

    /// Draws the whole walk of a planner, by its number in the view's list, onto a canvas of that size.
    pub fn draw_path(
        &mut self,
        entrant: usize,
        canvas: HtmlCanvasElement,
        width: f64,
        height: f64,
        ratio: f64,
    ) -> Result<bool, JsValue> {
        let (Some(race), Some(path)) = (self.state.race(), self.state.path(entrant)) else { return Ok(false) };
        let Some(line) = race.line(path) else { return Ok(false) };
        let mut pane = Pane::new(canvas)?;
        pane.viewport.resize(width, height, ratio);
        pane.draw(&Scene { dark: self.dark, ..race.planned_scene(&line) })?;
        Ok(true)
    }

    /// Dark or light colours.
    pub fn set_dark(&mut self, dark: bool) {
        self.dark = dark;
    }

    /// Time (s) and coverage (0 to 1) of a lane so far, in pairs.
    pub fn coverage_curve(&self, lane: usize) -> Float64Array {
        let pairs = self.state.race().and_then(|r| r.lanes().get(lane)).map_or(&[][..], |lane| lane.curve());
        let flat: Vec<f64> = pairs.iter().flat_map(|&(time, coverage)| [time, coverage]).collect();
        Float64Array::from(flat.as_slice())
    }

    /// Starts or continues the race.
    pub fn play(&mut self) {
        self.race(compare::Race::play);
    }

    /// Pauses the race.
    pub fn pause(&mut self) {
        self.race(compare::Race::pause);
    }

    /// Advances by one step.
    pub fn step(&mut self) {
        self.race(compare::Race::step);
    }

    /// Seeks a time within the time simulated so far, s.
    pub fn seek(&mut self, time_s: f64) {
        self.race(|race| race.seek(time_s));
    }

    /// Sets the speed, times real time; 0 for as fast as possible.
    pub fn set_speed(&mut self, times: f64) {
        self.state.set_speed(times);
    }

    fn race(&mut self, what: impl FnOnce(&mut compare::Race)) {
        if let Some(race) = self.state.race_mut() {
            what(race);
        }
    }
}

impl Default for Comparison {
    fn default() -> Self {
        Self::new()
    }
}
