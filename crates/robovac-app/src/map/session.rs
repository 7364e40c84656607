//! Session of the Map tab: a room, a robot that maps it, and time.

use super::{
    CurveSample, Known, MapAction, MapErrorFigures, MapEstimate, MapGrid, MapPhase, MapSetup, RoomTruth,
    base::MapBase,
    program::{MARK, ProgramMark},
    stage::MapStage,
};
use crate::explore::Session;
use crate::frame_pacer::{FramePacer, LONGEST_FRAME};
use crate::program_run::LoggedProgram;
use robovac_core::{floor_plan::FloorPlan, geometry::Pose};
use robovac_sim::{
    Input, Run, STEP_S,
    controller::Intent,
    experiment::{SettingsError, planning::RoomSetup},
};
use std::sync::Arc;

/// Robot time of a single step, s.
const STEP_LENGTH_S: f64 = 5.0;
/// Least time that the robot is held when it is moved, s; the display is still meanwhile.
const IN_THE_AIR_S: f64 = 0.6;
/// Real time between two updates of the figures while playing, s.
const FIGURES_EVERY: f64 = 0.25;

/// State of the tab Map.
pub struct MapSession {
    pub(super) setup: MapSetup,
    pub(super) base: Option<MapBase>,
    pub(super) stage: Option<MapStage>,
    /// The map given to the robot.
    pub(super) known: Option<Known>,
    /// What drives the run if that is a user's program.
    pub(super) program: LoggedProgram,
    /// The program that a link was made with.
    pub(super) asked: Option<ProgramMark>,
    /// Where the robot is put down, and the step from which on: a program has to feel it in the air first.
    pub(super) landing: Option<(Pose, u64)>,
    pub(super) playing: bool,
    pub(super) pacer: FramePacer,
    /// Changes with every new run.
    pub(super) version: u32,
    /// Time since the figures were computed, s.
    stale_s: f64,
    /// Whether a restored run ended in another state.
    pub(super) has_strayed: bool,
}

impl MapSession {
    /// Without a room: see [`MapSession::take`].
    pub fn new() -> Self {
        Self {
            setup: MapSetup::new(),
            base: None,
            stage: None,
            known: None,
            program: LoggedProgram::default(),
            asked: None,
            landing: None,
            playing: false,
            pacer: FramePacer::default(),
            version: 0,
            stale_s: 0.0,
            has_strayed: false,
        }
    }

    // ---- choices

    /// Takes over room, robot, start, conditions and seed from the session; cheap if unchanged, and the run continues.
    pub fn take(&mut self, session: &Session) {
        if self.base.as_ref().is_some_and(|base| base.is_of(session)) {
            return;
        }
        let before = (self.recipe(), self.driver_name());
        let base = MapBase::of(session);
        let is_same = self.base.as_ref().is_some_and(|before| before.place == base.place);
        self.base = Some(base);
        if !is_same {
            // The map of another room is dropped.
            self.known = None;
            self.begin();
        } else if self.recipe() != before.0 {
            // Another program was run.
            if before.1.is_some() {
                self.asked = None;
            }
            self.begin();
        }
    }

    /// Sets one choice: see [`MapSetup::set`]. A choice that affects the run starts a new one.
    pub fn set(&mut self, key: &str, value: &str) -> Result<(), SettingsError> {
        let before = self.recipe();
        self.setup.set(key, value)?;
        self.pacer.restart();
        if self.recipe() != before {
            self.begin();
        }
        Ok(())
    }

    /// Shows or hides a layer of the picture.
    pub fn show(&mut self, layer: &str, on: bool) -> Result<(), SettingsError> {
        self.setup.layers.set(layer, on)
    }

    /// Takes the choices of a link. Changes nothing on an error.
    pub fn restore(&mut self, link: &str) -> Result<(), SettingsError> {
        let before = self.recipe();
        self.setup.restore(link)?;
        let mut pairs = link.trim_start_matches('#').split('&').filter_map(|pair| pair.split_once('='));
        self.asked = pairs.find(|(key, _)| *key == MARK).and_then(|(_, text)| ProgramMark::from_text(text));
        if self.recipe() != before {
            self.begin();
        }
        Ok(())
    }

    /// The choices.
    pub fn setup(&self) -> &MapSetup {
        &self.setup
    }

    /// Key of everything that determines the run; equal recipes give equal maps, also in other sessions.
    pub fn recipe(&self) -> String {
        self.recipe_on(self.known.as_ref())
    }

    /// The same for the run in which the robot makes its map itself.
    pub fn home(&self) -> String {
        self.recipe_on(None)
    }

    pub(super) fn recipe_on(&self, known: Option<&Known>) -> String {
        let place = self.base.as_ref().map_or("", |base| &base.place);
        let known = known.map_or(String::new(), |known| format!(" known={:016x}", known.digest()));
        format!("{place} {}{}{known}", self.setup.recipe().trim_end(), self.program_recipe())
    }

    /// Drops the map: the robot is at the start and knows nothing.
    pub fn forget(&mut self) {
        self.begin();
    }

    /// Puts the robot at the start, if it fits in.
    pub(super) fn begin(&mut self) {
        self.program.restart();
        self.landing = None;
        self.stage = self.new_stage(self.known.clone());
        if self.known.is_some() {
            self.lose();
        }
        self.playing = false;
        self.pacer.restart();
        self.version += 1;
        self.refresh();
    }

    /// A run from the start, with a given map or without; `None` if the robot doesn't fit.
    pub(super) fn new_stage(&self, known: Option<Known>) -> Option<MapStage> {
        let (run, truth) = self.base.as_ref()?.run(&self.setup, known.as_ref(), &self.program.log)?;
        Some(MapStage::new(run, truth, known))
    }

    // ---- time

    /// The phase of the run.
    pub fn phase(&self) -> MapPhase {
        let Some(stage) = &self.stage else { return MapPhase::Failed };
        let run = stage.run();
        match () {
            () if stage.returning.is_some() => MapPhase::Resuming,
            () if self.landing.is_some() || stage.recording.is_seeking() => MapPhase::Seeking,
            () if run.is_lifted() => MapPhase::Held,
            () if stage.recording.is_over() => MapPhase::Finished,
            () if self.playing => MapPhase::Playing,
            () if run.steps() == 0 && stage.recording.end_s() == 0.0 => MapPhase::Ready,
            () => MapPhase::Paused,
        }
    }

    /// Whether an action is allowed now.
    pub fn can(&self, deed: MapAction) -> bool {
        self.phase().allows(deed)
    }

    /// Advances by `elapsed_s` seconds, while `has_time` returns true.
    pub fn frame(&mut self, elapsed_s: f64, has_time: &mut dyn FnMut() -> bool) {
        let phase = self.phase();
        let elapsed = elapsed_s.clamp(0.0, LONGEST_FRAME);
        self.land(has_time);
        let Some(stage) = &mut self.stage else { return };
        match phase {
            MapPhase::Resuming => {
                if let Some(is_the_same) = stage.go_back(has_time) {
                    self.version += 1;
                    self.has_strayed = !is_the_same;
                }
            }
            MapPhase::Seeking => stage.recording.seek_on(has_time),
            MapPhase::Playing => {
                self.pacer.frame(elapsed_s, self.setup.speed, |steps| stage.advance(steps, has_time));
                if stage.recording.is_over() {
                    self.playing = false;
                }
            }
            _ => self.pacer.rest(),
        }
        self.stale_s += elapsed;
        if phase != MapPhase::Playing || self.stale_s > FIGURES_EVERY {
            self.refresh();
        }
    }

    /// Starts or continues.
    pub fn play(&mut self) {
        self.playing = self.can(MapAction::Play) || self.playing;
    }

    /// Pauses.
    pub fn pause(&mut self) {
        self.playing = false;
        if let Some(stage) = &mut self.stage {
            stage.recording.stop_seeking();
        }
        self.refresh();
    }

    /// Advances by five seconds.
    pub fn step(&mut self) {
        if !self.can(MapAction::Step) {
            return;
        }
        self.playing = false;
        if let Some(stage) = &mut self.stage {
            stage.advance((STEP_LENGTH_S / STEP_S) as u64, &mut || true);
        }
        self.refresh();
    }

    /// Seeks another time within the time simulated so far, s.
    pub fn seek(&mut self, time_s: f64) {
        if !self.can(MapAction::Seek) {
            return;
        }
        self.playing = false;
        self.landing = None;
        if let Some(stage) = &mut self.stage {
            stage.recording.seek(time_s);
            stage.recording.seek_on(&mut || false);
        }
        self.refresh();
    }

    /// Simulates the next `seconds` at once, without a frame.
    pub fn run_ahead(&mut self, seconds: f64) {
        if let Some(stage) = &mut self.stage {
            stage.advance((seconds / STEP_S) as u64, &mut || true);
        }
        self.refresh();
    }

    // ---- lifting

    /// Picks the robot up.
    pub fn lift(&mut self) {
        if self.can(MapAction::Lift) {
            self.input(Input::Lift);
        }
    }

    /// Puts the robot down at `pose`, or at the nearest place where it fits. It isn't informed of the pose, but has
    /// sensed wheel drops.
    pub fn put_down(&mut self, pose: Pose) {
        if self.can(MapAction::PutDown) {
            let now = self.run().map_or(0, Run::steps);
            self.landing = Some((pose, now + (IN_THE_AIR_S / STEP_S) as u64));
            self.land(&mut || true);
        }
    }

    /// Puts the robot down once its time in the air is over, or what drives it has ended.
    fn land(&mut self, has_time: &mut dyn FnMut() -> bool) {
        let (Some((pose, at)), Some(stage)) = (self.landing, &mut self.stage) else { return };
        stage.advance(at.saturating_sub(stage.run().steps()), has_time);
        if stage.run().steps() >= at || stage.run().is_finished() {
            self.landing = None;
            self.input(Input::PutDown(pose));
        }
    }

    /// Starts cleaning the remaining floor by the robot's map.
    pub fn clean(&mut self) {
        if self.can_clean() {
            self.input(Input::Clean(self.setup.planner.id));
            self.playing = true;
        }
    }

    /// Whether it can clean by a map, which must exist.
    pub fn can_clean(&self) -> bool {
        self.can(MapAction::Clean) && self.estimate().is_some_and(|estimate| estimate.map.bounds().is_some())
    }

    fn input(&mut self, input: Input) {
        let is_program = self.program_drives();
        if let Some(stage) = &mut self.stage {
            stage.input(input);
            if is_program {
                self.program.cut(stage.run().steps());
            }
        }
        self.refresh();
    }

    // ---- state

    /// The true room.
    pub fn plan(&self) -> Option<&Arc<FloorPlan>> {
        self.base.as_ref().map(|base| &base.plan)
    }

    /// Room and robot; `None` if the robot doesn't fit.
    pub fn prepared(&self) -> Option<&RoomSetup> {
        self.base.as_ref()?.prepared.as_ref().ok()
    }

    /// Why the robot can't be placed in the room, or the program can't drive it; empty if it can.
    pub fn complaint(&self) -> String {
        let fault = self.base.as_ref().and_then(|base| base.prepared.as_ref().err().cloned());
        fault.or_else(|| self.program_complaint()).unwrap_or_default()
    }

    /// The run at the displayed time.
    pub fn run(&self) -> Option<&Run> {
        self.stage.as_ref().map(MapStage::run)
    }

    /// Changes whenever another run, or another time of it, is displayed.
    pub fn version(&self) -> u64 {
        let moment = self.stage.as_ref().map_or(0, |stage| stage.recording.version());
        (u64::from(self.version) << 32) + moment
    }

    /// The ground truth.
    pub fn truth(&self) -> Option<&RoomTruth> {
        self.stage.as_ref().map(|stage| &stage.truth)
    }

    /// The robot's estimates.
    pub fn estimate(&self) -> Option<MapEstimate<'_>> {
        let stage = self.stage.as_ref()?;
        stage.left().or_else(|| stage.estimate())
    }

    /// The robot's current goal; `None` while a stored run is restored.
    pub fn intent(&self) -> Option<Intent<'_>> {
        let stage = self.stage.as_ref().filter(|stage| stage.returning.is_none())?;
        stage.run().intent()
    }

    /// Errors of the map on the chosen grid, and of a map by odometry alone.
    pub fn figures(&self) -> Option<[MapErrorFigures; 2]> {
        let stage = self.stage.as_ref().filter(|stage| stage.returning.is_none())?;
        let [own, odometry] = stage.figures;
        let thesis = stage.thesis.filter(|_| self.setup.grid == MapGrid::Thesis);
        Some([thesis.unwrap_or(own), odometry])
    }

    /// The errors over time.
    pub fn samples(&self) -> &[CurveSample] {
        self.stage.as_ref().map_or(&[], |stage| stage.curve.samples())
    }

    /// The errors over time of the map on the chosen grid.
    pub fn curve(&self) -> impl Iterator<Item = CurveSample> {
        self.samples().iter().map(|&sample| match sample.thesis {
            Some((boundary, position_m)) if self.setup.grid == MapGrid::Thesis => {
                CurveSample { boundary, position_m, ..sample }
            }
            _ => sample,
        })
    }

    /// Recomputes the errors if they are outdated.
    fn refresh(&mut self) {
        if let Some(stage) = &mut self.stage {
            self.stale_s = 0.0;
            stage.count();
        }
    }
}

impl Default for MapSession {
    fn default() -> Self {
        Self::new()
    }
}
