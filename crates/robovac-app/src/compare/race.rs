//! Several robots in copies of the same room, under one clock.

use crate::{RobotView, Scene, explore::SessionState, frame_pacer::FramePacer};
use coverage_planners::CoveragePath;
use robovac_core::{floor_plan::FloorPlan, geometry::Point, robot::OdometryModel, trajectory::Trajectory};
use robovac_sim::{
    Conditions, Run, RunRecording, STEP_S, SlipLevel,
    experiment::{
        Entrant,
        planning::{PathToDrive, RoomSetup},
    },
    program::{Logged, SharedLog},
};
use std::sync::Arc;

/// Most robots in a race.
pub const MOST_LANES: usize = 9;
/// Share of the floor that must be swept for an arrival to count.
const CLEAN: f64 = 0.95;
/// Robot time of a single step, s; less would hardly be visible in small pictures.
const STEP_LENGTH_S: f64 = 5.0;
/// Behaviours that don't end by themselves drive for so much longer than the slowest plan takes, or for so long if
/// nobody has a plan, s.
const LONGER: f64 = 1.5;
const UNPLANNED_S: f64 = 3600.0;
/// Memory for the key frames of all lanes, bytes.
const KEY_FRAME_BUDGET: usize = 96 << 20;
/// Steps that every lane takes between two checks of the clock: the lanes stay together to within a second of robot
/// time.
const CHUNK: u64 = 64;

/// Settings of a race's runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RaceSetup {
    /// Slip and noise.
    pub conditions: Conditions,
    /// How the followers estimate their poses.
    pub odometry: OdometryModel,
    /// Whether corners are rounded.
    pub smooth: bool,
    /// Seed of the slip.
    pub seed: u64,
    /// Speed, times real time; 0 for as fast as possible.
    pub speed: f64,
}

/// A participant.
#[derive(Debug, Clone, PartialEq)]
pub struct Racer {
    /// Its number among the entrants.
    pub entrant: usize,
    /// Duration of its plan, s; `None` for a behaviour.
    pub planned_s: Option<f64>,
    /// Key of what it drives.
    pub key: String,
}

/// One robot of a race.
pub struct RaceLane {
    /// The participant in this lane.
    pub racer: Racer,
    recording: RunRecording,
    line: Arc<[Point]>,
    /// What a user's program has commanded so far, if one drives.
    log: Option<SharedLog>,
}

/// Robots that drive different plans over the same floor, each in a room of its own.
///
/// All have taken the same number of simulation steps, except for those that have arrived.
pub struct Race {
    prepared: RoomSetup,
    plan: Arc<FloorPlan>,
    setup: RaceSetup,
    lanes: Vec<RaceLane>,
    /// Number of the race.
    number: u32,
    /// Steps on the clock, and the most so far.
    now: u64,
    end: u64,
    playing: bool,
    goal: Option<u64>,
    pacer: FramePacer,
}

impl Race {
    /// A race without robots in `plan`, laid out as `prepared`; `number` distinguishes it from others.
    pub fn new(number: u32, plan: Arc<FloorPlan>, prepared: RoomSetup, setup: RaceSetup) -> Self {
        Self {
            prepared,
            plan,
            setup,
            lanes: Vec::new(),
            number,
            now: 0,
            end: 0,
            playing: false,
            goal: None,
            pacer: FramePacer::default(),
        }
    }

    /// Adds a robot that drives `path`, or along `smooth`, the same with rounded corners; a walk that can't be driven is skipped. To be called before the start.
    pub fn enter(&mut self, racer: Racer, path: &CoveragePath, smooth: Option<Arc<Trajectory>>) {
        if self.lanes.len() >= MOST_LANES {
            return;
        }
        let Some(line) = self.line(path) else { return };
        let RaceSetup { conditions, odometry, seed, .. } = self.setup;
        let driven = PathToDrive { line: Arc::clone(&line), smooth };
        let run = self.prepared.run_driven(&driven, conditions, odometry, seed);
        self.add(racer, run, line, None);
    }

    fn add(&mut self, racer: Racer, run: Run, line: Arc<[Point]>, log: Option<SharedLog>) {
        let recording = RunRecording::within(run, KEY_FRAME_BUDGET / MOST_LANES);
        self.lanes.push(RaceLane { racer, recording, line, log });
    }

    /// Adds a robot that is driven by a user's program, whose log grows. To be called before the start.
    pub fn enter_program(&mut self, racer: Racer, log: SharedLog) {
        if self.lanes.len() < MOST_LANES {
            let setup = self.prepared.setup(self.setup.conditions, self.setup.seed);
            let run = Run::new(&setup, Box::new(Logged::new(log.clone())));
            self.add(racer, run, Arc::new([]), Some(log));
        }
    }

    /// Adds a robot that is driven by a behaviour; nothing happens for any other algorithm. To be called before the
    /// start.
    pub fn enter_behaviour(&mut self, racer: Racer, entrant: &Entrant) {
        let RaceSetup { conditions, seed, .. } = self.setup;
        let behaviour = entrant.algorithm.behaviour();
        let run = behaviour.and_then(|info| self.prepared.run_behaviour(info, &entrant.params, conditions, seed));
        let Some(run) = run.filter(|_| self.lanes.len() < MOST_LANES) else { return };
        self.add(racer, run, Arc::new([]), None);
    }

    /// Ranks of the robots, from 1, in the order of [`Race::lanes`]: first those that have swept at least 95 % of the
    /// floor and arrived, if they end at all, by time; then the others by swept floor.
    pub fn places(&self) -> Vec<usize> {
        let won: Vec<Option<f64>> = self.lanes.iter().map(RaceLane::won_s).collect();
        let lanes = || self.lanes.iter().zip(&won);
        let is_ahead =
            |(a, a_won): (&RaceLane, &Option<f64>), (b, b_won): (&RaceLane, &Option<f64>)| match (a_won, b_won) {
                (Some(a), Some(b)) => a < b,
                (None, None) => a.run().coverage() > b.run().coverage(),
                (won, _) => won.is_some(),
            };
        lanes().map(|lane| 1 + lanes().filter(|&other| is_ahead(other, lane)).count()).collect()
    }

    /// Whether it has exactly these racers and this setup.
    pub fn is_of(&self, setup: RaceSetup, racers: &[Racer]) -> bool {
        self.setup == setup && self.lanes.iter().map(|lane| &lane.racer).eq(racers)
    }

    /// The robots, in the order in which they entered.
    pub fn lanes(&self) -> &[RaceLane] {
        &self.lanes
    }

    /// Rows of a lane's fine grid that were swept since the last call, lowest and highest.
    pub fn take_changed_rows(&mut self, lane: usize) -> Option<(usize, usize)> {
        self.lanes.get_mut(lane)?.recording.run_mut().tracker_mut().take_dirty_rows()
    }

    /// The state of the race.
    pub fn state(&self) -> SessionState {
        match () {
            () if self.lanes.is_empty() => SessionState::Failed,
            () if self.goal.is_some() => SessionState::Seeking,
            () if self.is_over() => SessionState::Finished,
            () if self.playing => SessionState::Playing,
            () if self.now == 0 => SessionState::Ready,
            () => SessionState::Paused,
        }
    }

    fn is_over(&self) -> bool {
        let limit = self.limit();
        self.lanes.iter().all(|lane| lane.is_done(limit))
    }

    /// Whether all robots wait for a user's program, which hasn't got farther yet.
    pub fn waits(&self) -> bool {
        !self.is_over() && self.reach(self.limit()) <= self.now
    }

    /// Steps for which all commands are known.
    fn reach(&self, limit: u64) -> u64 {
        let driving = self.lanes.iter().filter(|lane| !lane.is_done(limit));
        driving.map(RaceLane::reach).min().unwrap_or(u64::MAX)
    }

    /// Steps after which robots without a plan stop.
    fn limit(&self) -> u64 {
        (self.limit_s() / STEP_S).round() as u64
    }

    fn limit_s(&self) -> f64 {
        let slowest = self.lanes.iter().filter_map(|lane| lane.racer.planned_s).reduce(f64::max);
        slowest.map_or(UNPLANNED_S, |planned| LONGER * planned)
    }

    /// Time on the clock, s.
    pub fn time_s(&self) -> f64 {
        self.now as f64 * STEP_S
    }

    /// The furthest time on the clock so far, s.
    pub fn end_s(&self) -> f64 {
        self.end as f64 * STEP_S
    }

    /// Duration of the slowest plan, s, or of the race if a robot has none.
    pub fn planned_s(&self) -> f64 {
        let limit = self.limit_s();
        self.lanes.iter().map(|lane| lane.racer.planned_s.unwrap_or(limit)).fold(0.0, f64::max)
    }

    /// Speed, times real time; 0 for as fast as possible.
    pub fn speed(&self) -> f64 {
        self.setup.speed
    }

    /// Sets the speed, times real time; 0 for as fast as possible.
    pub fn set_speed(&mut self, times: f64) {
        self.setup.speed = if times.is_finite() { times.max(0.0) } else { 0.0 };
        self.pacer.restart();
    }

    /// Starts or continues the race, from the start if it is over.
    pub fn play(&mut self) {
        if self.state() == SessionState::Finished {
            self.seek(0.0);
        }
        self.playing = true;
    }

    /// Pauses the race. A seek in progress is completed first, as the robots aren't in step during it.
    pub fn pause(&mut self) {
        self.playing = false;
    }

    /// Advances by five seconds.
    pub fn step(&mut self) {
        self.pause();
        if self.goal.is_none() {
            self.advance((STEP_LENGTH_S / STEP_S) as u64, &mut || true);
        }
    }

    /// Seeks another time, s, at most the end of the slowest plan.
    pub fn seek(&mut self, time_s: f64) {
        self.playing = false;
        let goal = (time_s.clamp(0.0, self.planned_s().max(self.end_s())) / STEP_S).round() as u64;
        for lane in &mut self.lanes {
            lane.recording.seek(goal as f64 * STEP_S);
        }
        self.goal = Some(goal);
        self.seek_on(&mut || false);
    }

    fn seek_on(&mut self, has_time: &mut dyn FnMut() -> bool) {
        let Some(goal) = self.goal else { return };
        let limit = self.limit();
        for lane in &mut self.lanes {
            lane.recording.seek_on(has_time);
            // Steps that aren't simulated yet, as for a lane added late.
            let left = if lane.is_done(limit) { 0 } else { goal.saturating_sub(lane.run().steps()) };
            if !lane.recording.is_seeking() {
                lane.recording.advance(left, has_time);
            }
        }
        if self.lanes.iter().all(|lane| lane.run().steps() >= goal || lane.is_done(limit)) {
            self.now = self.lanes.iter().map(|lane| lane.run().steps()).max().unwrap_or(0);
            self.end = self.end.max(self.now);
            self.goal = None;
        }
    }

    /// Continues from the time of `earlier`: robots in both keep their runs, others catch up.
    pub fn follow(&mut self, earlier: Self) {
        if earlier.setup != self.setup || !Arc::ptr_eq(&earlier.prepared.floor, &self.prepared.floor) {
            return;
        }
        let is_playing = earlier.playing;
        let now = earlier.goal.unwrap_or(earlier.now);
        self.end = earlier.end;
        let mut lanes = earlier.lanes;
        for lane in &mut self.lanes {
            if let Some(index) = lanes.iter().position(|old| old.racer == lane.racer) {
                *lane = lanes.swap_remove(index);
            }
        }
        if now > 0 {
            self.seek(now as f64 * STEP_S);
        }
        self.playing = is_playing;
    }

    /// Advances all robots by `elapsed_s` seconds, while `has_time` returns true.
    pub fn frame(&mut self, elapsed_s: f64, has_time: &mut dyn FnMut() -> bool) {
        match self.state() {
            SessionState::Seeking => self.seek_on(has_time),
            SessionState::Playing => {
                let mut pacer = self.pacer;
                pacer.frame(elapsed_s, self.setup.speed, |steps| self.advance(steps, has_time));
                self.pacer = pacer;
                if self.is_over() {
                    self.playing = false;
                }
            }
            _ => {}
        }
    }

    /// Up to `steps` steps of every robot; returns how many the clock has advanced.
    fn advance(&mut self, steps: u64, has_time: &mut dyn FnMut() -> bool) -> u64 {
        let before = self.now;
        while self.now - before < steps && !self.is_over() && has_time() {
            let limit = self.limit();
            let chunk = CHUNK.min(steps - (self.now - before)).min(self.reach(limit).saturating_sub(self.now));
            if chunk == 0 {
                break;
            }
            for lane in self.lanes.iter_mut().filter(|lane| !lane.is_done(limit)) {
                lane.recording.advance(chunk, &mut || true);
            }
            // The clock stops with the last robot.
            self.now = self.lanes.iter().map(|lane| lane.run().steps()).max().unwrap_or(0);
            self.end = self.end.max(self.now);
        }
        self.now - before
    }

    /// The scene of a lane.
    pub fn scene<'a>(&'a self, lane: &'a RaceLane) -> Scene<'a> {
        let run = lane.recording.run();
        Scene {
            tracker: Some(run.tracker()),
            run_version: (u64::from(self.number) << 32) + lane.recording.version(),
            trail: run.trail(),
            life: Some(run.life()),
            steps: run.steps(),
            robot: Some(RobotView::of(run, &self.prepared.robot, self.setup.conditions.slip != SlipLevel::None)),
            ..self.planned_scene(&lane.line)
        }
    }

    /// The scene of a plan without a robot.
    pub fn planned_scene<'a>(&'a self, line: &'a [Point]) -> Scene<'a> {
        Scene {
            plan_version: u64::from(self.number),
            floor: Some(&self.prepared.floor),
            planned_version: u64::from(self.number),
            planned: line,
            start: Some(self.prepared.floor.start),
            start_radius: self.prepared.robot.radius,
            start_body: self.prepared.robot.body,
            ..Scene::empty(&self.plan)
        }
    }

    /// The line of a path; `None` if it can't be driven.
    pub fn line(&self, path: &CoveragePath) -> Option<Arc<[Point]>> {
        self.prepared.line(path).ok()
    }
}

impl RaceLane {
    /// The run at the displayed time.
    pub fn run(&self) -> &Run {
        self.recording.run()
    }

    /// Steps for which its commands are known.
    fn reach(&self) -> u64 {
        let log = self.log.as_ref().map(SharedLog::get).filter(|log| log.end().is_none());
        log.map_or(u64::MAX, |log| log.until().into())
    }

    /// Whether it stands for good; robots without a plan after `limit` steps.
    fn is_done(&self, limit: u64) -> bool {
        self.run().is_finished() || (self.racer.planned_s.is_none() && self.run().steps() >= limit)
    }

    /// When it had swept enough and, if it follows a plan, arrived, s; `None` if it hasn't by now.
    pub fn won_s(&self) -> Option<f64> {
        let run = self.run();
        if self.racer.planned_s.is_some() {
            return (run.is_finished() && run.coverage() >= CLEAN).then(|| run.time_s());
        }
        self.curve().iter().find(|&&(time, coverage)| coverage >= CLEAN && time <= run.time_s()).map(|&(time, _)| time)
    }

    /// Time (s) and coverage (0 to 1) of the whole run so far.
    pub fn curve(&self) -> &[(f64, f64)] {
        self.recording.curve()
    }
}
