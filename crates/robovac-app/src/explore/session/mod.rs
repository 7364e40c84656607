//! One user's session: a room, a robot, a planner, a run.

mod editing;
mod moment;
mod objects;
mod parted;
mod planning;
mod program;
mod saved;
mod search;
mod snapshot;

pub use self::saved::{LinkOutline, LoadError};

pub(super) use self::saved::known_room;
use self::{moment::Moment, parted::PartedPath};
use crate::explore::{Action, Editor, PlanSearch, SessionState, Showing};
use crate::frame_pacer::{FramePacer, LONGEST_FRAME};
use crate::program_run::LoggedProgram;
use coverage_planners::{CoveragePath, Proof};
use robovac_core::{
    floor_plan::{self, FloorPlan},
    geometry::{Point, Pose},
};
use robovac_sim::{
    Input, Life, Run, RunRecording, STEP_S,
    controller::{self, Behaviours, Joystick, LIFTED},
    experiment::{
        Settings, SettingsError,
        planning::{PlanRequest, Planned, RoomSetup},
    },
};
use std::sync::Arc;

/// Message for a robot that was put down elsewhere and can't sense that.
const CARRIED: &str = "The robot follows its plan by odometry and can't detect that it was kidnapped.";
/// The same for one that senses that it was lifted.
const LOST: &str = "The robot senses that it was lifted, but not where it is. It searches for its dock, whose place it knows, and then \
    continues its plan.";
/// Least distance from its estimated position at which a robot is put down for that message, m.
const CARRIED_M: f64 = 0.1;

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
    program: LoggedProgram,
    /// The run before the room was changed; what it has swept stays swept.
    before: Option<Run>,
    /// The share of the floor that it has swept.
    swept_before: f64,
    /// The dirt that it has left, and where people and pets are, until the next run.
    life_before: Option<Life>,
    /// Number of runs begun.
    runs: u32,
    playing: bool,
    /// The moment that a link leads to, until the user goes elsewhere.
    awaited: Option<Moment>,
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
    /// A path that stayed with its room when another one was chosen.
    parted: Option<PartedPath>,
    /// The film of the plan, if there is one, and whether films wait for the user.
    film: Option<Showing>,
    holds_films: bool,
    /// The picture of it that was shown last.
    film_at: Option<usize>,
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
            program: LoggedProgram::default(),
            before: None,
            swept_before: 0.0,
            life_before: None,
            runs: 0,
            playing: true,
            awaited: None,
            pacer: FramePacer::default(),
            requests: 0,
            is_opening: true,
            previews: 0,
            message: None,
            shows_search: false,
            search: None,
            parted: None,
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
        if self.is_changed_room() { format!("{name} (changed)") } else { name.clone() }
    }

    /// Whether the room is a built-in one that was changed: what is said about that one needn't hold.
    fn is_changed_room(&self) -> bool {
        self.room().is_none() && floor_plan::ROOMS.iter().any(|room| room.title == self.plan().name)
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
                // Whoever holds the robot isn't faster than real time: meanwhile its battery would run down.
                let speed = if recording.run().is_lifted() { 1.0 } else { self.settings.speed };
                self.pacer.frame(elapsed_s, speed, |steps| recording.advance(steps, has_time));
                if recording.run().is_finished() {
                    self.playing = false;
                    self.message.take_if(|message| message.text == CARRIED || message.text == LOST);
                    // The end is shown, not the film that the drive cut short.
                    self.film.iter_mut().for_each(Showing::skip);
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
        self.awaited = None;
        if let Some(recording) = &mut self.recording {
            recording.stop_seeking();
        }
    }

    /// Advances by one move: one planning cell or one turn, at most five seconds. A user's program advances by one of its
    /// steps.
    pub fn step(&mut self) {
        let allowed = self.state().allows(Action::Step);
        self.pause();
        let is_program = self.program_drives();
        let Some(recording) = self.recording.as_mut().filter(|_| allowed) else { return };
        if is_program {
            return recording.step();
        }
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
        (self.swept_before, self.life_before) = (0.0, None);
        match self.before.take().and_then(|_| self.fresh_run()) {
            Some(run) => self.record(run),
            None => self.seek(0.0),
        }
    }

    /// Seeks another time within the time simulated so far, s.
    pub fn seek(&mut self, time_s: f64) {
        self.message.take_if(|message| message.text == CARRIED || message.text == LOST);
        self.awaited = None;
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
        let run = self.recording.as_ref().map(RunRecording::run);
        let searches = run.is_some_and(|run| run.activity() == LIFTED);
        let estimate = run.and_then(Run::estimate);
        let is_elsewhere = estimate.is_some_and(|at| (at.position() - pose.position()).norm() > CARRIED_M);
        self.input(Input::PutDown(rounded(pose)));
        if is_elsewhere && self.settings.algorithm.planner().is_some() {
            self.say("notice", if searches { LOST } else { CARRIED }.into());
        }
    }

    /// Whether the robot is held.
    pub fn is_lifted(&self) -> bool {
        self.recording.as_ref().is_some_and(|recording| recording.run().is_lifted())
    }

    fn input(&mut self, input: Input) {
        let is_program = self.program_drives();
        self.awaited = None;
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
        let parted = self.part_with_path(&(room.build)());
        self.editor.replace((room.build)(), Some(room.id), None);
        self.prepare();
        self.tell_parted(parted);
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
