//! Session of the Map tab: a room, a robot that maps it, and time.

use super::{
    CurveSample, Known, MapAction, MapErrorFigures, MapEstimate, MapPhase, MapSetup, RoomTruth, base::MapBase,
    stage::MapStage,
};
use crate::explore::Session;
use crate::frame_pacer::{FramePacer, LONGEST_FRAME};
use robovac_core::{floor_plan::FloorPlan, geometry::Pose};
use robovac_sim::{
    Input, Run, STEP_S,
    controller::Intent,
    experiment::{SettingsError, planning::RoomSetup},
};
use std::sync::Arc;

/// Robot time of a single step, s.
const STEP_LENGTH_S: f64 = 5.0;
/// Time in the air that a hand takes at least, s: what is shown meanwhile stands still.
const IN_THE_AIR_S: f64 = 0.6;
/// Time on the wall between two looks at the figures while time goes on, s.
const FIGURES_EVERY: f64 = 0.25;

/// Everything that the place Map has.
pub struct MapSession {
    pub(super) setup: MapSetup,
    pub(super) base: Option<MapBase>,
    pub(super) stage: Option<MapStage>,
    /// The map that the robot has been given.
    pub(super) known: Option<Known>,
    pub(super) playing: bool,
    pub(super) pacer: FramePacer,
    /// Grows with every run that is made.
    pub(super) version: u32,
    /// Time since the figures were worked out, s.
    stale_s: f64,
    /// Whether the way back to a survey that was left has led elsewhere.
    pub(super) has_strayed: bool,
}

impl MapSession {
    /// Nothing yet: see [`MapSession::take`].
    pub fn new() -> Self {
        Self {
            setup: MapSetup::new(),
            base: None,
            stage: None,
            known: None,
            playing: false,
            pacer: FramePacer::default(),
            version: 0,
            stale_s: 0.0,
            has_strayed: false,
        }
    }

    // ---- choices

    /// Takes room, robot, start, conditions and seed over from the session; cheap if they are the same. A survey of them
    /// that is under way goes on.
    pub fn take(&mut self, session: &Session) {
        if self.base.as_ref().is_some_and(|base| base.is_of(session)) {
            return;
        }
        let base = MapBase::of(session);
        let is_same = self.base.as_ref().is_some_and(|before| before.place == base.place);
        self.base = Some(base);
        if !is_same {
            // A map of another room is of no use here.
            self.known = None;
            self.begin();
        }
    }

    /// Sets one choice: see [`MapSetup::set`]. A choice that another run comes of begins one.
    pub fn set(&mut self, key: &str, value: &str) -> Result<(), SettingsError> {
        let before = self.recipe();
        self.setup.set(key, value)?;
        self.pacer.restart();
        if self.recipe() != before {
            self.begin();
        }
        Ok(())
    }

    /// Shows a layer of the picture, or no longer.
    pub fn show(&mut self, layer: &str, on: bool) -> Result<(), SettingsError> {
        self.setup.layers.set(layer, on)
    }

    /// Takes the choices of a link. On an error everything stays as it was.
    pub fn restore(&mut self, link: &str) -> Result<(), SettingsError> {
        let before = self.recipe();
        self.setup.restore(link)?;
        if self.recipe() != before {
            self.begin();
        }
        Ok(())
    }

    /// What is chosen.
    pub fn setup(&self) -> &MapSetup {
        &self.setup
    }

    /// Everything that determines the run: the same recipe makes the same map, tomorrow too.
    pub fn recipe(&self) -> String {
        self.recipe_on(self.known.as_ref())
    }

    /// The same of a run on which the robot makes its map itself.
    pub fn home(&self) -> String {
        self.recipe_on(None)
    }

    pub(super) fn recipe_on(&self, known: Option<&Known>) -> String {
        let place = self.base.as_ref().map_or("", |base| &base.place);
        let known = known.map_or(String::new(), |known| format!(" known={:016x}", known.digest()));
        format!("{place} {}{known}", self.setup.recipe().trim_end())
    }

    /// Forgets the map: the robot stands at the start again, and knows nothing.
    pub fn forget(&mut self) {
        self.begin();
    }

    /// Puts the robot at the start, if it fits in.
    pub(super) fn begin(&mut self) {
        self.stage = self.new_stage(self.known.clone());
        if self.known.is_some() {
            self.lose();
        }
        self.playing = false;
        self.pacer.restart();
        self.version += 1;
        self.refresh();
    }

    /// A run from the start, on a map that it knows or without one; `None` if the robot doesn't fit in.
    pub(super) fn new_stage(&self, known: Option<Known>) -> Option<MapStage> {
        let (run, truth) = self.base.as_ref()?.run(&self.setup, known.as_ref())?;
        Some(MapStage::new(run, truth, known))
    }

    // ---- time

    /// What the survey is doing.
    pub fn phase(&self) -> MapPhase {
        let Some(stage) = &self.stage else { return MapPhase::Failed };
        let run = stage.run();
        match () {
            () if stage.returning.is_some() => MapPhase::Resuming,
            () if stage.recording.is_seeking() => MapPhase::Seeking,
            () if run.is_lifted() => MapPhase::Held,
            () if stage.recording.is_over() => MapPhase::Finished,
            () if self.playing => MapPhase::Playing,
            () if run.steps() == 0 && stage.recording.end_s() == 0.0 => MapPhase::Ready,
            () => MapPhase::Paused,
        }
    }

    /// Whether that may be done now.
    pub fn can(&self, deed: MapAction) -> bool {
        self.phase().allows(deed)
    }

    /// Lets `elapsed_s` seconds pass, as long as `has_time` says so.
    pub fn frame(&mut self, elapsed_s: f64, has_time: &mut dyn FnMut() -> bool) {
        let phase = self.phase();
        let elapsed = elapsed_s.clamp(0.0, LONGEST_FRAME);
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

    /// Lets time go on.
    pub fn play(&mut self) {
        self.playing = self.can(MapAction::Play) || self.playing;
    }

    /// Stops time.
    pub fn pause(&mut self) {
        self.playing = false;
        if let Some(stage) = &mut self.stage {
            stage.recording.stop_seeking();
        }
        self.refresh();
    }

    /// Goes on by five seconds.
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

    /// Goes to another point of the time simulated so far, s.
    pub fn seek(&mut self, time_s: f64) {
        if !self.can(MapAction::Seek) {
            return;
        }
        self.playing = false;
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

    // ---- the hand on the robot

    /// Picks the robot up.
    pub fn lift(&mut self) {
        if self.can(MapAction::Lift) {
            self.input(Input::Lift);
        }
    }

    /// Puts a robot that was picked up down at `pose`, or at the nearest place where it fits. It isn't told where, but it has felt
    /// its wheels hang down for a moment.
    pub fn put_down(&mut self, pose: Pose) {
        if self.can(MapAction::PutDown) {
            if let Some(stage) = &mut self.stage {
                stage.advance((IN_THE_AIR_S / STEP_S) as u64, &mut || true);
            }
            self.input(Input::PutDown(pose));
        }
    }

    /// Tells the robot to clean what is left by the map that it has, and lets time go on.
    pub fn clean(&mut self) {
        if self.can_clean() {
            self.input(Input::Clean(self.setup.planner.id));
            self.playing = true;
        }
    }

    /// Whether it can be told so: it needs a map.
    pub fn can_clean(&self) -> bool {
        self.can(MapAction::Clean) && self.estimate().is_some_and(|estimate| estimate.map.bounds().is_some())
    }

    fn input(&mut self, input: Input) {
        if let Some(stage) = &mut self.stage {
            stage.input(input);
        }
        self.refresh();
    }

    // ---- what is shown

    /// The room as it really is.
    pub fn plan(&self) -> Option<&Arc<FloorPlan>> {
        self.base.as_ref().map(|base| &base.plan)
    }

    /// Room and robot; `None` if it doesn't fit in.
    pub fn prepared(&self) -> Option<&RoomSetup> {
        self.base.as_ref()?.prepared.as_ref().ok()
    }

    /// Why the robot can't be put into the room; empty if it can.
    pub fn complaint(&self) -> &str {
        let fault = self.base.as_ref().and_then(|base| base.prepared.as_ref().err());
        fault.map_or("", String::as_str)
    }

    /// The run at the moment that is shown.
    pub fn run(&self) -> Option<&Run> {
        self.stage.as_ref().map(MapStage::run)
    }

    /// Changes whenever another run, or another moment of it, is shown.
    pub fn version(&self) -> u64 {
        let moment = self.stage.as_ref().map_or(0, |stage| stage.recording.version());
        (u64::from(self.version) << 32) + moment
    }

    /// What is really there.
    pub fn truth(&self) -> Option<&RoomTruth> {
        self.stage.as_ref().map(|stage| &stage.truth)
    }

    /// The robot's estimates.
    pub fn estimate(&self) -> Option<MapEstimate<'_>> {
        let stage = self.stage.as_ref()?;
        stage.left().or_else(|| stage.estimate())
    }

    /// What the robot is going for; nothing while it is driven back to where it was left.
    pub fn intent(&self) -> Option<Intent<'_>> {
        let stage = self.stage.as_ref().filter(|stage| stage.returning.is_none())?;
        stage.run().intent()
    }

    /// Figures of the map, and of one by odometry alone.
    pub fn figures(&self) -> Option<[MapErrorFigures; 2]> {
        self.stage.as_ref().filter(|stage| stage.returning.is_none()).map(|stage| stage.figures)
    }

    /// The figures over time.
    pub fn samples(&self) -> &[CurveSample] {
        self.stage.as_ref().map_or(&[], |stage| stage.curve.samples())
    }

    /// Works the figures out if they aren't those of what is shown.
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
