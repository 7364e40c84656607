//! One user's session: a room, a robot, a planner, a run.

mod objects;
mod planning;
mod program;
mod search;
mod snapshot;

use self::program::ProgramRun;
use crate::explore::{Action, Brush, Editor, PlanSearch, SessionState, Showing};
use crate::frame_pacer::{FramePacer, LONGEST_FRAME};
use crate::{Import, ImportError, ScenarioChoices, ScenarioError};
use coverage_planners::{CoveragePath, Film, Proof};
use robovac_core::{
    floor_plan::{self, FloorPlan, RoomInfo, Scenario, SourceFile},
    geometry::{Point, Pose},
    registry::Params,
    robot::CustomRobot,
};
use robovac_sim::{
    Input, Run, RunRecording, STEP_S,
    controller::{self, Behaviours, Joystick},
    experiment::{
        KEPT_PATH, Settings, SettingsError,
        planning::{PlanRequest, Planned, RoomSetup},
    },
};
use std::{collections::BTreeMap, sync::Arc};

/// Message for a robot that was put down elsewhere and can't sense that.
const CARRIED: &str = "The robot follows its plan by odometry and can't detect that it was kidnapped.";
/// Least distance from its estimated position at which a robot is put down for that message, m.
const CARRIED_M: f64 = 0.1;

/// Name in links of a room that was drawn or loaded: it is kept.
const OWN_ROOM: &str = "own";
/// Key in links of whether the search is shown.
const SEARCH: &str = "search";

/// Room, settings, plan and run, with all actions on them.
///
/// The session has no clock and no thread: [`Session::frame`] receives the elapsed time and a callback that limits its
/// work; planning happens wherever [`Session::take_plan_request`] is served.
#[expect(clippy::struct_excessive_bools)]
pub struct Session {
    settings: Settings,
    editor: Editor,
    prepared: Option<RoomSetup>,
    planning: Option<Planning>,
    planned: Option<Planned>,
    recording: Option<RunRecording>,
    /// What drives the run if that is a user's program.
    program: ProgramRun,
    /// The run before the room was changed; what it has swept stays swept.
    before: Option<Run>,
    /// Number of runs begun.
    runs: u32,
    playing: bool,
    pacer: FramePacer,
    requests: u32,
    /// Whether this is still the unchanged opening scene, whose plan is precomputed.
    is_opening: bool,
    /// Number of walks reported by planners, intermediate and final.
    previews: u64,
    message: Option<Message>,
    /// Whether the planner's decisions are shown, and the decisions, once known.
    shows_search: bool,
    search: Option<PlanSearch>,
    /// The film of the plan, if there is one, and whether films wait for the user.
    film: Option<Showing>,
    holds_films: bool,
    /// The picture of it that was shown last.
    film_at: Option<usize>,
}

/// Reasons why files can't be loaded.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LoadError {
    /// They aren't a map.
    #[error(transparent)]
    Import(#[from] ImportError),
    /// They are a scenario that can't be run.
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
}

/// A planner running elsewhere.
struct Planning {
    request: Option<PlanRequest>,
    id: u32,
    progress: f64,
    /// The best path so far, and its line.
    path: CoveragePath,
    preview: Vec<Point>,
    /// Its proof.
    proof: Option<Proof>,
    /// The walks so far.
    film: Film,
}

/// A message for the user.
#[derive(Debug, Clone)]
struct Message {
    kind: &'static str,
    text: String,
}

impl Session {
    /// The opening scene: the furnished flat before cleaning.
    pub fn new() -> Self {
        Self::with(controller::ALL)
    }

    /// The same with only these behaviours available.
    pub fn with(behaviours: Behaviours) -> Self {
        let room = &floor_plan::ROOMS[0];
        let mut session = Self {
            settings: Settings::with(behaviours),
            editor: Editor::new((room.build)(), Some(room.id)),
            prepared: None,
            planning: None,
            planned: None,
            recording: None,
            program: ProgramRun::default(),
            before: None,
            runs: 0,
            playing: true,
            pacer: FramePacer::default(),
            requests: 0,
            is_opening: true,
            previews: 0,
            message: None,
            shows_search: false,
            search: None,
            film: None,
            holds_films: false,
            film_at: None,
        };
        session.prepare();
        session
    }

    // ---- state

    /// What the session is doing.
    pub fn state(&self) -> SessionState {
        if self.planning.is_some() {
            return SessionState::Planning;
        }
        let Some(recording) = &self.recording else { return SessionState::Failed };
        match recording.run() {
            _ if recording.is_seeking() => SessionState::Seeking,
            run if run.is_finished() => SessionState::Finished,
            _ if self.playing => SessionState::Playing,
            run if run.steps() == 0 => SessionState::Ready,
            _ => SessionState::Paused,
        }
    }

    /// The room with its current walls.
    pub fn plan(&self) -> &Arc<FloorPlan> {
        self.editor.plan()
    }

    /// Id of the room if it is built in and unchanged.
    pub fn room(&self) -> Option<&'static str> {
        self.editor.room()
    }

    /// Name of the room, with a remark if a built-in one was changed.
    pub fn room_title(&self) -> String {
        let name = &self.plan().name;
        let is_changed = self.room().is_none() && floor_plan::ROOMS.iter().any(|room| room.title == name);
        if is_changed { format!("{name} (changed)") } else { name.clone() }
    }

    /// The start set by the user, if any.
    pub fn start(&self) -> Option<Pose> {
        self.editor.start()
    }

    /// Changes with every change of walls.
    pub fn plan_version(&self) -> u64 {
        self.editor.version()
    }

    /// The room laid out for the robot; `None` if it doesn't fit.
    pub fn prepared(&self) -> Option<&RoomSetup> {
        self.prepared.as_ref()
    }

    /// The plan, once there is one.
    pub fn planned(&self) -> Option<&Planned> {
        self.planned.as_ref()
    }

    /// The line of the best walk so far while a planner is running.
    pub fn preview(&self) -> &[Point] {
        self.planning.as_ref().map_or(&[], |p| &p.preview)
    }

    /// The run.
    pub fn recording(&self) -> Option<&RunRecording> {
        self.recording.as_ref()
    }

    /// Rows of the fine grid that were swept since the last call, lowest and highest.
    pub fn take_changed_rows(&mut self) -> Option<(usize, usize)> {
        self.recording.as_mut()?.run_mut().tracker_mut().take_dirty_rows()
    }

    /// Everything chosen but the room.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    // ---- time

    /// Advances by `elapsed_s` seconds, while `has_time` returns true.
    pub fn frame(&mut self, elapsed_s: f64, has_time: &mut dyn FnMut() -> bool) {
        self.film_goes_on(elapsed_s.clamp(0.0, LONGEST_FRAME));
        let state = self.state();
        let Some(recording) = &mut self.recording else { return };
        match state {
            SessionState::Seeking => recording.seek_on(has_time),
            SessionState::Playing => {
                self.pacer.frame(elapsed_s, self.settings.speed, |steps| recording.advance(steps, has_time));
                if recording.run().is_finished() {
                    self.playing = false;
                }
            }
            _ => self.pacer.rest(),
        }
    }

    /// Simulates the next `seconds` at once, without a frame.
    pub fn run_ahead(&mut self, seconds: f64) {
        if let Some(recording) = &mut self.recording {
            recording.advance((seconds / STEP_S) as u64, &mut || true);
        }
    }

    /// Starts or continues; from the start if the run was over, with a new plan if there is none.
    pub fn play(&mut self) {
        let state = self.state();
        if state == SessionState::Finished {
            self.reset();
        }
        self.playing = true;
        self.message = None;
        if state == SessionState::Failed {
            self.prepare_changed();
        }
    }

    /// Pauses.
    pub fn pause(&mut self) {
        self.playing = false;
        if let Some(recording) = &mut self.recording {
            recording.stop_seeking();
        }
    }

    /// Advances by one move: one planning cell or one turn, at most five seconds.
    pub fn step(&mut self) {
        let allowed = self.state().allows(Action::Step);
        self.pause();
        let Some(recording) = self.recording.as_mut().filter(|_| allowed) else { return };
        let goal = recording.run().distance_m() + self.settings.cell_size;
        let turning = recording.run().turning_rad();
        for _ in 0..(5.0 / STEP_S) as u32 {
            recording.step();
            let run = recording.run();
            if run.is_finished() || run.distance_m() >= goal || run.turning_rad() - turning > 1.5 {
                break;
            }
        }
    }

    /// Returns to the start and pauses. What was swept before the room was changed isn't any more.
    pub fn reset(&mut self) {
        self.pause();
        match self.before.take().and_then(|_| self.fresh_run()) {
            Some(run) => self.record(run),
            None => self.seek(0.0),
        }
    }

    /// Seeks another time within the time simulated so far, s.
    pub fn seek(&mut self, time_s: f64) {
        self.message.take_if(|message| message.text == CARRIED);
        if let Some(recording) = &mut self.recording {
            recording.seek(time_s);
            // A key frame's state, such as the start, is there at once; the rest follows with the frames.
            recording.seek_on(&mut || false);
        }
    }

    // ---- lifting and driving

    /// Moves the joystick; ignored by robots that drive by themselves.
    pub fn command(&mut self, command: Joystick) {
        self.input(Input::Command(command));
    }

    /// Picks the robot up.
    pub fn lift(&mut self) {
        if !self.is_lifted() {
            self.input(Input::Lift);
        }
    }

    /// Puts a robot that was picked up down at `pose`, or at the nearest place where it fits.
    pub fn put_down(&mut self, pose: Pose) {
        if !self.is_lifted() {
            return;
        }
        let believed = self.recording.as_ref().and_then(|recording| recording.run().estimate());
        let is_elsewhere = believed.is_some_and(|at| (at.position() - pose.position()).norm() > CARRIED_M);
        self.input(Input::PutDown(rounded(pose)));
        if is_elsewhere && self.settings.algorithm.planner().is_some() {
            self.say("notice", CARRIED.into());
        }
    }

    /// Whether the robot is held.
    pub fn is_lifted(&self) -> bool {
        self.recording.as_ref().is_some_and(|recording| recording.run().is_lifted())
    }

    fn input(&mut self, input: Input) {
        let is_program = self.program_drives();
        if let Some(recording) = &mut self.recording {
            recording.input(input);
            if is_program {
                self.program.cut(recording.run().steps());
            }
        }
    }

    // ---- choices

    /// Chooses a room that ships.
    pub fn select_room(&mut self, id: &str) -> Result<(), SettingsError> {
        let room = known_room(id)?;
        self.message = None;
        self.editor.replace((room.build)(), Some(room.id), None);
        self.prepare();
        Ok(())
    }

    /// Changes the settings; if `change` fails, everything stays as it was.
    pub fn configure(
        &mut self,
        change: impl FnOnce(&mut Settings) -> Result<(), SettingsError>,
    ) -> Result<(), SettingsError> {
        let mut settings = self.settings.clone();
        change(&mut settings)?;
        self.settings = settings;
        self.message = None;
        self.prepare();
        Ok(())
    }

    /// Shows or hides a layer of the picture.
    pub fn show(&mut self, layer: &str, on: bool) -> Result<(), SettingsError> {
        self.settings.shows.set(layer, on)
    }

    /// Sets the speed, times real time; 0 for as fast as possible.
    pub fn set_speed(&mut self, times: f64) {
        self.settings.speed = if times.is_finite() { times.max(0.0) } else { 0.0 };
        self.pacer.restart();
    }

    /// Loads a map or scenario from files that belong together. Changes nothing on an error.
    pub fn load(&mut self, files: &[SourceFile]) -> Result<(), LoadError> {
        Ok(self.take_import(Import::read(files)?)?)
    }

    /// Takes the result of reading files. Changes nothing on an error.
    pub fn take_import(&mut self, import: Import) -> Result<(), ScenarioError> {
        if let Some(choices) = &import.choices {
            self.settings = choices.settings(&self.settings)?;
        }
        self.message = None;
        // A sweep of a room that ships brings that room back: with its name, all of it fits into a link.
        let swept = self.settings.path.as_ref().and_then(|_| {
            floor_plan::ROOMS.iter().find(|room| room.title == import.plan.name && (room.build)() == import.plan)
        });
        self.editor.replace(import.plan, swept.map(|room| room.id), None);
        self.prepare();
        Ok(())
    }

    /// Takes a link's `key=value` pairs, joined by `&`. Changes nothing on an error.
    pub fn restore(&mut self, link: &str) -> Result<(), SettingsError> {
        let mut settings = self.settings.clone();
        let mut room = None;
        let mut shows_search = None;
        let pairs = link.trim_start_matches('#').split('&').filter(|p| !p.is_empty());
        let pairs = pairs.map(|p| p.split_once('=').unwrap_or((p, "")));
        // Robot and planner bring defaults of their own, which must not override the link's other values.
        let (first, others): (Vec<_>, Vec<_>) =
            pairs.partition(|(key, _)| matches!(*key, "robot" | "planner" | "behaviour"));
        for (key, value) in first.into_iter().chain(others) {
            if key == "room" {
                room = Some(value);
            } else if key == "path" && value == KEPT_PATH {
                // It came with the room.
                settings.path = Some(self.settings.path.clone().ok_or(SettingsError::FarPath)?);
            } else if key == SEARCH {
                shows_search = Some(value == "1");
            } else {
                settings.take_link(key, value)?;
            }
        }
        let room = room.filter(|&id| id != OWN_ROOM).map(known_room).transpose()?;
        let start = settings.start.take();
        self.shows_search = shows_search.unwrap_or(self.shows_search);
        self.replace(settings, room.map(|room| ((room.build)(), Some(room.id))), start);
        Ok(())
    }

    /// Applies settings, another room if there is one, and a start in it, as one undoable change.
    pub(super) fn replace(
        &mut self,
        settings: Settings,
        room: Option<(FloorPlan, Option<&'static str>)>,
        start: Option<Pose>,
    ) {
        self.settings = settings;
        self.message = None;
        match room {
            Some((plan, id)) => self.editor.replace(plan, id, start),
            None if start.is_some() => self.editor.set_start(start),
            None => {}
        }
        self.prepare();
    }

    /// Room and settings as a scenario file that [`Session::load`] reads.
    pub fn scenario_json(&self) -> String {
        self.scenario().to_json()
    }

    /// Room and settings as a scenario.
    pub fn scenario(&self) -> Scenario {
        let settings = &self.settings;
        let defaults = Params::defaults(settings.algorithm.params());
        let changed = settings.params.iter().filter(|&(id, value)| defaults.get(id) != Some(value));
        let params = changed.filter_map(|(id, value)| Some((id.to_owned(), serde_json::to_value(value).ok()?)));
        let choices = ScenarioChoices::of_settings(settings);
        let mut scenario = self.own_room();
        scenario.robot = choices.robot;
        scenario.twin = settings.custom.as_ref().and_then(CustomRobot::twin);
        scenario.own_robot = settings.custom.as_ref().and_then(CustomRobot::own).cloned();
        scenario.path.clone_from(&settings.path);
        scenario.planner = choices.planner;
        scenario.behaviour = choices.behaviour;
        scenario.program = choices.program;
        scenario.params.extend(params);
        scenario.cell_size = choices.cell_size;
        scenario.seed = Some(settings.seed);
        scenario.slip = choices.slip;
        scenario.noise = choices.noise.map(|levels| {
            let mut by_kind = BTreeMap::new();
            by_kind.extend(levels);
            by_kind
        });
        scenario.quantised = choices.quantised;
        scenario.start_charge_percent = choices.start_charge_percent;
        scenario.odometry = choices.odometry;
        scenario.smooth = choices.smooth;
        scenario
    }

    /// The room and the robot's start in it.
    pub fn own_room(&self) -> Scenario {
        let mut scenario = Scenario::of(self.plan());
        // A start inside a wall would be refused, and is of no use.
        let start = self.editor.start().or(self.plan().start);
        scenario.start = start.filter(|_| self.prepared.is_some()).map(Into::into);
        scenario
    }

    /// The session as a link's `key=value` pairs. A room that was drawn or loaded isn't in it: see [`Session::scenario_json`].
    pub fn link(&self) -> String {
        self.link_pairs().map(|(key, value)| format!("{key}={value}")).collect::<Vec<_>>().join("&")
    }

    /// Keys and values of [`Session::link`].
    pub fn link_pairs(&self) -> impl Iterator<Item = (String, String)> + use<> {
        let mut settings = self.settings.clone();
        settings.start = self.editor.start();
        // A path that is too long for a link is kept with the room.
        let is_linked = settings.path_link().is_none_or(|path| path != KEPT_PATH);
        let room = self.editor.room().filter(|_| is_linked).unwrap_or(OWN_ROOM);
        let room = ("room".to_owned(), room.to_owned());
        let search = self.shows_search.then(|| (SEARCH.to_owned(), "1".to_owned()));
        std::iter::once(room).chain(settings.to_link()).chain(search)
    }

    // ---- drawing

    /// Begins to draw or erase walls at a point in metres.
    pub fn begin_stroke(&mut self, brush: Brush, at: Point) {
        self.editor.begin(brush, at);
    }

    /// Goes on drawing to a point in metres.
    pub fn go_on_stroke(&mut self, at: Point) {
        self.editor.go_on(at);
    }

    /// Cancels the current stroke.
    pub fn abandon_stroke(&mut self) {
        self.editor.abandon();
    }

    /// Ends drawing and plans again; walls can't replace floor needed by objects.
    pub fn end_stroke(&mut self) {
        if let Err(refusal) = self.plan().check_objects(None) {
            self.editor.abandon();
            self.say("error", sentence(&refusal.fault.to_string()));
        }
        if self.editor.end() {
            self.message = None;
            self.prepare_changed();
        }
    }

    /// Moves the start; if the robot can't stand there, reports that and leaves it.
    pub fn move_start(&mut self, to: Pose) {
        if let Err(refusal) = self.plan().check_objects(Some(to)) {
            self.say("error", sentence(&refusal.fault.to_string()));
            return;
        }
        if self.settings.path.is_some() {
            self.say("error", "The path begins here. Choose a planner to start elsewhere.".to_owned());
            return;
        }
        let robot = self.settings.robot_model();
        match RoomSetup::new(self.editor.plan(), &robot, self.settings.cell_size, Some(to)) {
            Ok(prepared) => {
                self.message = None;
                self.editor.set_start(Some(rounded(prepared.floor.start)));
                self.prepare_changed();
            }
            Err(error) => self.say("error", sentence(&error.to_string())),
        }
    }

    /// Undoes the last change of the room.
    pub fn undo(&mut self) {
        let lineage = self.editor.lineage();
        if self.editor.undo() {
            self.message = None;
            self.prepare_if_same(lineage);
        }
    }

    /// Redoes the last undone change.
    pub fn redo(&mut self) {
        let lineage = self.editor.lineage();
        if self.editor.redo() {
            self.message = None;
            self.prepare_if_same(lineage);
        }
    }

    fn prepare_if_same(&mut self, lineage: u32) {
        if self.editor.lineage() == lineage { self.prepare_changed() } else { self.prepare() }
    }

    /// A number that changes with the room, but not with changes of it.
    pub fn room_lineage(&self) -> u32 {
        self.editor.lineage()
    }

    /// Renames the room, which is then an own one.
    pub fn rename_room(&mut self, name: &str) {
        self.editor.rename(name);
    }

    /// Clears the undo and redo history.
    pub fn forget_changes(&mut self) {
        self.editor.forget();
    }

    /// Reports an error from outside to the user.
    pub fn report_error(&mut self, text: &str) {
        self.say("error", sentence(text));
    }

    fn say(&mut self, kind: &'static str, text: String) {
        self.message = Some(Message { kind, text });
    }
}

impl Default for Session {
    fn default() -> Self {
        Self::new()
    }
}

/// The built-in room with that id.
pub(super) fn known_room(id: &str) -> Result<&'static RoomInfo, SettingsError> {
    floor_plan::room(id).ok_or_else(|| {
        let known = floor_plan::ROOMS.iter().map(|r| r.id).collect::<Vec<_>>().join(", ");
        SettingsError::Unknown { kind: "room", id: id.to_owned(), known }
    })
}

/// Rounded to millimetres and tenths of a degree, as in links: a link must reproduce exactly the same run.
fn rounded(pose: Pose) -> Pose {
    let round = |value: f64, unit: f64| (value / unit).round() * unit;
    let heading = round(pose.heading.to_degrees(), 0.1).to_radians();
    Pose::new(round(pose.x, 0.001), round(pose.y, 0.001), heading)
}

/// An error's text as a sentence.
fn sentence(text: &str) -> String {
    let mut chars = text.chars();
    let first = chars.next().map(|c| c.to_ascii_uppercase().to_string()).unwrap_or_default();
    let rest: String = chars.collect();
    let stop = if rest.ends_with(['.', '!', '?']) { "" } else { "." };
    format!("{first}{rest}{stop}")
}
