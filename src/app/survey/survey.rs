//! A room, a robot that explores and maps it, and time.

use super::{
    Belief, Deed, Figures, Known, OpenError, Phase, Sample, StoreError, Stored, SurveySetup, Truth, curve::Curve,
    numbers::digest, store::Still,
};
use crate::{
    app::{Prepared, Recording, Session, SettingsError},
    controller::Setup,
    coverage::ReachableFloor,
    floorplan::{FloorPlan, Scenario},
    geometry::Pose,
    mapping::{Mapper, MapperSetup, Tracking},
    math,
    rng::seeded,
    sim::{Conditions, Input, Run, STEP_S},
};
use rand::RngExt;
use std::sync::Arc;

/// Longest time between two frames that is made up for, s.
const LONGEST_FRAME: f64 = 0.1;
/// Robot time of a single step, s.
const STEP_LENGTH_S: f64 = 5.0;
/// Time on the wall between two looks at the figures while time goes on, s.
const FIGURES_EVERY: f64 = 0.25;

/// Stream of the places where a robot is put down that is to find itself.
const STREAM: u64 = 14;

/// Everything that the place Map has.
pub struct Survey {
    pub(super) setup: SurveySetup,
    pub(super) base: Option<Base>,
    pub(super) stage: Option<Stage>,
    /// The map that the robot has been given.
    pub(super) known: Option<Known>,
    pub(super) playing: bool,
    due: f64,
    pub(super) speed_factor: f64,
    /// Grows with every run that is made.
    version: u32,
    /// Time since the figures were worked out, s.
    stale_s: f64,
    /// Whether the way back to a survey that was left has led elsewhere.
    has_strayed: bool,
}

/// What is taken over from the session.
pub(super) struct Base {
    pub plan: Arc<FloorPlan>,
    pub title: String,
    prepared: Result<Prepared, String>,
    conditions: Conditions,
    seed: u64,
    /// Tells room, start, robot, conditions and seed from others, also tomorrow.
    place: String,
    link: String,
    plan_version: u64,
}

impl Base {
    /// How true wheels and sensors are in Explore.
    pub fn conditions(&self) -> Conditions {
        self.conditions
    }
}

/// A run under way, and what is known of it.
pub(super) struct Stage {
    pub recording: Recording,
    pub truth: Truth,
    /// The map that the robot has been given.
    pub known: Option<Known>,
    pub curve: Curve,
    /// Figures of the map, and of one by odometry alone, after so many steps.
    pub figures: [Figures; 2],
    counted: Option<u64>,
    /// What was stored, while the run is driven again up to there.
    pub returning: Option<Return>,
}

/// The way back to where a survey was left.
pub(super) struct Return {
    pub still: Still,
    end: u64,
    shown: u64,
    digest: u64,
    is_seeking: bool,
}

impl Survey {
    /// Nothing yet: see [`Survey::take`].
    pub fn new() -> Self {
        Self {
            setup: SurveySetup::new(),
            base: None,
            stage: None,
            known: None,
            playing: false,
            due: 0.0,
            speed_factor: 0.0,
            version: 0,
            stale_s: 0.0,
            has_strayed: false,
        }
    }

    // ---- choices

    /// Takes room, robot, start, conditions and seed over from the session; cheap if they are the same. A survey of them
    /// that is under way goes on.
    pub fn take(&mut self, session: &Session) {
        let link = session.link();
        let version = session.plan_version();
        if self.base.as_ref().is_some_and(|base| base.link == link && base.plan_version == version) {
            return;
        }
        let place = place_of(session);
        let is_same = self.base.as_ref().is_some_and(|base| base.place == place);
        let settings = session.settings();
        let prepared = session.prepared().cloned().ok_or_else(|| session.view().message);
        self.base = Some(Base {
            plan: Arc::clone(session.plan()),
            title: session.room_title(),
            prepared,
            conditions: settings.conditions,
            seed: settings.seed,
            place,
            link,
            plan_version: version,
        });
        if !is_same {
            // A map of another room is of no use here.
            self.known = None;
            self.begin();
        }
    }

    /// Sets one choice: see [`SurveySetup::set`]. A choice that another run comes of begins one.
    pub fn set(&mut self, key: &str, value: &str) -> Result<(), SettingsError> {
        let before = self.recipe();
        self.setup.set(key, value)?;
        self.due = 0.0;
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
    pub fn setup(&self) -> &SurveySetup {
        &self.setup
    }

    /// Everything that determines the run: the same recipe makes the same map, tomorrow too.
    pub fn recipe(&self) -> String {
        let place = self.base.as_ref().map_or("", |base| &base.place);
        let known = self.known.as_ref().map_or(String::new(), |known| format!(" known={:016x}", known.digest()));
        format!("{place} {}{known}", self.setup.recipe().trim_end())
    }

    /// Forgets the map: the robot stands at the start again, and knows nothing.
    pub fn forget(&mut self) {
        self.begin();
    }

    /// Puts the robot at the start, if it fits in.
    fn begin(&mut self) {
        self.stage = self.new_run().map(|(run, truth)| Stage::new(run, truth, self.known.clone()));
        if let (Some(stage), Some(base)) = (&mut self.stage, &self.base)
            && stage.known.is_some()
        {
            // Nobody tells it where.
            let place = anywhere(stage.run().floor(), base.seed);
            stage.recording.input(Input::Lift);
            stage.recording.input(Input::PutDown(place.unwrap_or(stage.run().pose())));
        }
        self.playing = false;
        self.due = 0.0;
        self.version += 1;
        self.refresh();
    }

    fn new_run(&self) -> Option<(Run, Truth)> {
        let base = self.base.as_ref()?;
        let prepared = base.prepared.as_ref().ok()?;
        let setup = &self.setup;
        let conditions = setup.conditions(base.conditions);
        let robot = &prepared.robot;
        let controller = setup.behaviour.build(&Setup { robot, params: &setup.params, seed: base.seed })?;
        let start = prepared.floor.start;
        let mapper = |tracking| {
            Mapper::new(MapperSetup {
                robot: robot.clone(),
                start,
                tracking,
                odometry: setup.odometry,
                seed: base.seed,
            })
        };
        let run = Run::new(&prepared.setup(conditions, base.seed), controller);
        // A controller that makes a map of its own acts by that.
        let run = if run.mapper().is_none() { run.with_mapper(mapper(setup.tracking)) } else { run };
        let run = run.with_baseline(mapper(Tracking::Odometry));
        let run = match &self.known {
            Some(known) => run.with_locator(known.locator(robot, setup.odometry, base.seed)?),
            None => run,
        };
        let resolution = run.mapper()?.map().resolution();
        let truth = Truth::new(&prepared.floor, robot.radius, resolution);
        Some((run, truth))
    }

    // ---- time

    /// What the survey is doing.
    pub fn phase(&self) -> Phase {
        let Some(stage) = &self.stage else { return Phase::Failed };
        let run = stage.run();
        match () {
            () if stage.returning.is_some() => Phase::Resuming,
            () if stage.recording.is_seeking() => Phase::Seeking,
            () if run.is_lifted() => Phase::Held,
            () if run.is_finished() => Phase::Finished,
            () if self.playing => Phase::Playing,
            () if run.steps() == 0 && stage.recording.end_s() == 0.0 => Phase::Ready,
            () => Phase::Paused,
        }
    }

    /// Whether that may be done now.
    pub fn can(&self, deed: Deed) -> bool {
        self.phase().allows(deed)
    }

    /// Lets `elapsed_s` seconds pass, as long as `has_time` says so.
    pub fn frame(&mut self, elapsed_s: f64, has_time: &mut dyn FnMut() -> bool) {
        let phase = self.phase();
        let elapsed = elapsed_s.clamp(0.0, LONGEST_FRAME);
        let Some(stage) = &mut self.stage else { return };
        match phase {
            Phase::Resuming => {
                if let Some(is_the_same) = stage.go_back(has_time) {
                    self.version += 1;
                    self.has_strayed = !is_the_same;
                }
            }
            Phase::Seeking => stage.recording.seek_on(has_time),
            Phase::Playing => {
                let speed = self.setup.speed;
                self.due += elapsed * speed / STEP_S;
                let wanted = if speed == 0.0 { u64::MAX } else { self.due as u64 };
                let taken = stage.advance(wanted, has_time);
                // What couldn't be done in time isn't made up for: the achieved speed says so instead.
                self.due = if taken == wanted { self.due.fract() } else { 0.0 };
                if elapsed > 0.0 {
                    let factor = taken as f64 * STEP_S / elapsed;
                    let weight = if self.speed_factor > 0.0 { 0.1 } else { 1.0 };
                    self.speed_factor += weight * (factor - self.speed_factor);
                }
                if stage.run().is_finished() {
                    self.playing = false;
                }
            }
            _ => self.speed_factor = 0.0,
        }
        self.stale_s += elapsed;
        if phase != Phase::Playing || self.stale_s > FIGURES_EVERY {
            self.refresh();
        }
    }

    /// Lets time go on.
    pub fn play(&mut self) {
        self.playing = self.can(Deed::Play) || self.playing;
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
        if !self.can(Deed::Step) {
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
        if !self.can(Deed::Seek) {
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
        if self.can(Deed::Lift) {
            self.input(Input::Lift);
        }
    }

    /// Puts a robot that was picked up down at `pose`, or at the nearest place where it fits. It isn't told.
    pub fn put_down(&mut self, pose: Pose) {
        if self.can(Deed::PutDown) {
            self.input(Input::PutDown(pose));
        }
    }

    fn input(&mut self, input: Input) {
        if let Some(stage) = &mut self.stage {
            stage.recording.input(input);
            let run = stage.recording.run();
            stage.curve.cut(run.steps(), run.time_s());
            // Nothing was driven, and yet it may be elsewhere.
            stage.counted = None;
        }
        self.refresh();
    }

    // ---- what is shown

    /// The room as it really is.
    pub fn plan(&self) -> Option<&Arc<FloorPlan>> {
        self.base.as_ref().map(|base| &base.plan)
    }

    /// Room and robot; `None` if it doesn't fit in.
    pub fn prepared(&self) -> Option<&Prepared> {
        self.base.as_ref()?.prepared.as_ref().ok()
    }

    /// Why the robot can't be put into the room; empty if it can.
    pub fn complaint(&self) -> &str {
        let fault = self.base.as_ref().and_then(|base| base.prepared.as_ref().err());
        fault.map_or("", String::as_str)
    }

    /// The run at the moment that is shown.
    pub fn run(&self) -> Option<&Run> {
        self.stage.as_ref().map(Stage::run)
    }

    /// Changes whenever another run, or another moment of it, is shown.
    pub fn version(&self) -> u64 {
        let moment = self.stage.as_ref().map_or(0, |stage| stage.recording.version());
        (u64::from(self.version) << 32) + moment
    }

    /// What is really there.
    pub fn truth(&self) -> Option<&Truth> {
        self.stage.as_ref().map(|stage| &stage.truth)
    }

    /// What the robot believes.
    pub fn belief(&self) -> Option<Belief<'_>> {
        let stage = self.stage.as_ref()?;
        stage.returning.as_ref().map(|way| Belief::left(&way.still)).or_else(|| stage.belief())
    }

    /// Figures of the map, and of one by odometry alone.
    pub fn figures(&self) -> Option<[Figures; 2]> {
        self.stage.as_ref().filter(|stage| stage.returning.is_none()).map(|stage| stage.figures)
    }

    /// The figures over time.
    pub fn samples(&self) -> &[Sample] {
        self.stage.as_ref().map_or(&[], |stage| stage.curve.samples())
    }

    /// Works the figures out if they aren't those of what is shown.
    fn refresh(&mut self) {
        if let Some(stage) = &mut self.stage {
            self.stale_s = 0.0;
            stage.count();
        }
    }

    // ---- a map that it knows

    /// Gives the robot a map, and puts it down anywhere in the room: it has to find out where. On an error everything stays
    /// as it was.
    pub fn open(&mut self, plan: &FloorPlan) -> Result<(), OpenError> {
        let (Some(base), Some(prepared), Some(truth)) = (&self.base, self.prepared(), self.truth()) else {
            return Err(OpenError::NoRoom);
        };
        let known = Known::new(plan, base.plan.origin, truth.resolution(), &prepared.robot)?;
        self.lose(known)
    }

    /// The same with the map that it has made.
    pub fn open_own(&mut self) -> Result<(), OpenError> {
        let (Some(belief), Some(prepared)) = (self.belief(), self.prepared()) else { return Err(OpenError::NoRoom) };
        let known = Known::of(belief.map.clone(), "its own map".to_owned(), &prepared.robot)?;
        self.lose(known)
    }

    fn lose(&mut self, known: Known) -> Result<(), OpenError> {
        self.known = Some(known);
        self.begin();
        Ok(())
    }

    /// Takes the map away that it was given: it explores and maps again.
    pub fn close_map(&mut self) {
        if self.known.take().is_some() {
            self.begin();
        }
    }

    // ---- what is kept

    /// The survey as text, to be brought back by [`Survey::resume`]; `None` while there is nothing worth it.
    pub fn store(&self) -> Option<String> {
        let stage = self.stage.as_ref().filter(|stage| stage.returning.is_none() && stage.known.is_none())?;
        let run = stage.run();
        let end = (stage.recording.end_s() / STEP_S).round() as u64;
        let belief = self.belief().filter(|_| end > 0)?;
        let stored = Stored {
            recipe: self.recipe(),
            title: self.base.as_ref().map_or(String::new(), |base| base.title.clone()),
            end,
            shown: run.steps(),
            digest: run.digest(),
            inputs: stage.recording.inputs().to_vec(),
            pose: belief.pose()?,
            map: belief.map.clone(),
            marks: belief.marks.clone(),
        };
        Some(stored.to_text())
    }

    /// Goes back to where a survey was left that [`Survey::store`] has stored: its map is there at once; the robot is driven
    /// again, by the frames that follow, through all that it did. On an error everything stays as it was.
    pub fn resume(&mut self, text: &str) -> Result<(), StoreError> {
        let stored = Stored::from_text(text)?;
        if stored.recipe != self.recipe() {
            return Err(StoreError::Another { title: stored.title });
        }
        let Some((run, truth)) = self.new_run() else { return Ok(()) };
        let Stored { end, shown, digest, inputs, .. } = stored;
        let mut stage = Stage::new(run, truth, None);
        stage.recording = stage.recording.with_inputs(inputs);
        let still = Still { map: stored.map, marks: stored.marks, pose: stored.pose };
        stage.returning = Some(Return { still, end, shown, digest, is_seeking: false });
        self.stage = Some(stage);
        self.playing = false;
        self.version += 1;
        Ok(())
    }

    /// Whether the last way back to where a survey was left has led elsewhere, once: programs of other versions drive
    /// otherwise. What was stored is still right in itself.
    pub fn take_strayed(&mut self) -> bool {
        std::mem::take(&mut self.has_strayed)
    }

    /// How far the way back to where a survey was left is done, 0 to 1; `None` if there is none.
    pub fn returned(&self) -> Option<f64> {
        let stage = self.stage.as_ref()?;
        let Return { end, .. } = stage.returning.as_ref()?;
        Some(stage.run().steps() as f64 / (*end).max(1) as f64)
    }
}

impl Stage {
    fn new(run: Run, truth: Truth, known: Option<Known>) -> Self {
        let mut stage = Self {
            recording: Recording::new(run),
            truth,
            known,
            curve: Curve::new(),
            figures: [Figures::default(); 2],
            counted: None,
            returning: None,
        };
        stage.sample();
        stage
    }

    pub fn run(&self) -> &Run {
        self.recording.run()
    }

    /// What the robot believes.
    fn belief(&self) -> Option<Belief<'_>> {
        match (&self.known, self.run().locator()) {
            (Some(known), Some(locator)) => Some(Belief::on(known, locator)),
            _ => self.run().mapper().map(Belief::of),
        }
    }

    /// Up to `steps` steps, with a look at the figures now and then; returns how many were taken.
    fn advance(&mut self, steps: u64, has_time: &mut dyn FnMut() -> bool) -> u64 {
        let mut taken = 0;
        while taken < steps && has_time() {
            let now = self.run().steps();
            let due = self.curve.due();
            let piece = if due > now { due - now } else { u64::MAX };
            let done = self.recording.advance(piece.min(steps - taken), has_time);
            taken += done;
            if self.run().steps() == due {
                self.sample();
            }
            if done == 0 {
                break;
            }
        }
        taken
    }

    fn sample(&mut self) {
        self.count();
        let (steps, time_s) = (self.run().steps(), self.run().time_s());
        let [Figures { boundary, position_m, .. }, Figures { position_m: odometry_m, .. }] = self.figures;
        self.curve.add(steps, Sample { time_s, boundary, position_m, odometry_m });
    }

    /// Works the figures out, unless they are those of this moment.
    fn count(&mut self) {
        let run = self.recording.run();
        let now = (self.recording.version() << 40) + run.steps();
        if self.counted == Some(now) {
            return;
        }
        self.counted = Some(now);
        let of = |map, believed| Figures::of(map, believed, run.pose(), &self.truth);
        let here = self.belief().map(|belief| of(belief.map, belief.pose()));
        let odometry = run.baseline().map(|mapper| of(mapper.map(), Some(mapper.pose())));
        self.figures = [here, odometry].map(Option::unwrap_or_default);
    }

    /// Drives on to where the survey was left. Once there, says whether everything is as it was then.
    fn go_back(&mut self, has_time: &mut dyn FnMut() -> bool) -> Option<bool> {
        let &Return { end, shown, digest, is_seeking, .. } = self.returning.as_ref()?;
        if !is_seeking {
            self.advance(end.saturating_sub(self.run().steps()), has_time);
            if self.run().steps() < end && !self.run().is_finished() {
                return None;
            }
            self.recording.seek(shown as f64 * STEP_S);
            if let Some(way) = &mut self.returning {
                way.is_seeking = true;
            }
        }
        self.recording.seek_on(has_time);
        if self.recording.is_seeking() {
            return None;
        }
        self.returning = None;
        Some(self.run().digest() == digest)
    }
}

impl Default for Survey {
    fn default() -> Self {
        Self::new()
    }
}

/// A place where the robot can stand.
fn anywhere(floor: &ReachableFloor, seed: u64) -> Option<Pose> {
    let mut rng = seeded(seed, STREAM);
    let places = floor.standing.count();
    let chosen = (places > 0).then(|| rng.random_range(0..places))?;
    let (cell, _) = floor.standing.iter().filter(|(_, stands)| **stands).nth(chosen)?;
    let place = floor.standing_place(cell);
    Some(Pose::new(place.x, place.y, rng.random_range(-math::PI..math::PI)))
}

/// Tells room, start, robot, conditions and seed of a session from others, also tomorrow.
fn place_of(session: &Session) -> String {
    let link = session.link();
    let kept = link.split('&').filter(|pair| {
        let key = pair.split('=').next().unwrap_or("");
        ["room", "robot", "cell", "seed", "slip", "quantised", "start"].contains(&key) || key.starts_with("noise.")
    });
    let kept: Vec<&str> = kept.collect();
    let is_own = session.room().is_none();
    let walls = is_own.then(|| format!(" {:016x}", digest(&Scenario::of(session.plan()).to_json())));
    format!("{}{}", kept.join(" "), walls.unwrap_or_default())
}
