//! View model of many runs: entrants, number of runs, missing runs, results.

use super::entrants::{lacking, titled};
use crate::explore::{ProgramJob, Session, SessionSnapshot};
use robovac_core::{
    floor_plan::{FloorPlan, Scenario},
    program::{Program, ProgramKind},
    robot::RobotModel,
};
use robovac_sim::{
    experiment::{Algorithm, BEHAVIOUR, Entrant, PLANNER, Settings, SettingsError},
    montecarlo::{EntrantRuns, RunOutcome, RunTally, RunsHeader, RunsRequest, Summary},
};
use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

/// Numbers of seeds in the menu.
pub const SEEDS: [u32; 3] = [10, 30, 100];
/// Most seeds.
pub const MOST_SEEDS: u32 = 1000;
/// Simulated times in the menu, min.
pub const MINUTES: [u32; 4] = [10, 30, 60, 120];
/// Usual time of a run, as a multiple of the least that sweeping the room once takes: by then behaviours differ (ours).
const USUAL: f64 = 5.0;
/// Longest simulated time of a run, min.
pub const MOST_MINUTES: u32 = 600;
/// Simulated time per request, min, unless a single run is longer: more would take longer to transfer than the tenth of
/// a second that its runs take.
const BATCH_MINUTES: u32 = 30;

/// The same experiment over many seeds: entrants, settings and results.
///
/// Runs are kept when choices change: adding an algorithm or more seeds requires only the new runs.
pub struct ManyRuns {
    base: Option<StudyBase>,
    /// All available algorithms, in the order of the registries.
    entrants: Vec<Entrant>,
    chosen: BTreeSet<usize>,
    seeds: u32,
    minutes: u32,
    /// Whether the time was chosen, and doesn't follow from the room.
    are_minutes_chosen: bool,
    tallies: BTreeMap<OutcomeKey, RunTally>,
    failures: BTreeMap<OutcomeKey, String>,
    under_way: BTreeMap<u32, RunBatch>,
    /// Number of the last request.
    last: u32,
    is_running: bool,
    version: u32,
}

/// Key of everything except the seed that outcomes depend on.
type OutcomeKey = String;

/// Runs in progress.
struct RunBatch {
    key: OutcomeKey,
    seeds: Vec<u64>,
}

/// The settings that it takes over from the session.
struct StudyBase {
    plan: Arc<FloorPlan>,
    title: String,
    /// Name of the robot in exports.
    robot: String,
    room: Option<&'static str>,
    settings: Settings,
    /// The settings that runs depend on, as in a link.
    place: String,
    /// The job of the user's program, if there is one.
    job: Option<ProgramJob>,
    /// Snapshot of the session.
    snapshot: SessionSnapshot,
}

impl StudyBase {
    fn of(session: &Session) -> Self {
        let mut settings = session.settings().clone();
        settings.start = session.start();
        let room = session.room();
        let is_about_place =
            |key: &str| !matches!(key, "planner" | "behaviour" | "seed" | "speed" | "show" | "odometry");
        let pairs = settings.to_link().into_iter();
        let place = pairs
            .filter(|(key, _)| is_about_place(key) && !key.starts_with("p."))
            .fold(format!("odometry={}", settings.odometry.id()), |place, (key, value)| {
                format!("{place}&{key}={value}")
            });
        Self {
            plan: Arc::clone(session.plan()),
            title: session.room_title(),
            robot: settings.robot_name(),
            room,
            job: settings.program().and_then(|program| session.job_beside(program.kind)),
            settings,
            place,
            snapshot: session.snapshot(),
        }
    }

    /// Key of room and settings; those of rooms that aren't built in end in a number.
    fn key(&self) -> String {
        match self.room {
            Some(id) => format!("{id} {}", self.place),
            None => format!("{} {}", self.snapshot.room_version, self.place),
        }
    }
}

impl ManyRuns {
    /// The behaviours that clean, not started.
    pub fn new() -> Self {
        let takes_part = |algorithm: &Algorithm| {
            algorithm.behaviour().is_none_or(|info| (info.claims.cleans || info.claims.explores) && !info.claims.manual)
        };
        let programs = [ProgramKind::Planner, ProgramKind::Behaviour].map(Algorithm::of_program);
        let entrants: Vec<Entrant> = Algorithm::all().filter(takes_part).chain(programs).map(Entrant::new).collect();
        // The user's program takes part as soon as there is one.
        let behaves = |&index: &usize| entrants[index].algorithm.behaviour().is_some_and(|info| info.claims.cleans);
        let chosen = (0..entrants.len()).filter(behaves).collect();
        Self {
            base: None,
            entrants,
            chosen,
            seeds: SEEDS[1],
            minutes: MINUTES[1],
            are_minutes_chosen: false,
            tallies: BTreeMap::new(),
            failures: BTreeMap::new(),
            under_way: BTreeMap::new(),
            last: 0,
            is_running: false,
            version: 0,
        }
    }

    // ---- choices

    /// Takes over room, robot, start, conditions and seed from the session; cheap if unchanged.
    pub fn take(&mut self, session: &Session) {
        if self.base.as_ref().is_some_and(|base| base.snapshot == session.snapshot()) {
            return;
        }
        let base = StudyBase::of(session);
        if self.base.as_ref().is_none_or(|old| old.key() != base.key()) {
            // Earlier states of an own room aren't kept.
            let (own, here) = (|key: &OutcomeKey| key.starts_with(|c: char| c.is_ascii_digit()), base.key());
            self.tallies.retain(|key, _| !own(key) || key.starts_with(&here));
            // A change of place stops the remaining runs.
            self.is_running = false;
        }
        self.base = Some(base);
        if let Some(prepared) = session.prepared().filter(|_| !self.are_minutes_chosen) {
            let robot = session.settings().robot_model();
            let once_s = prepared.floor.area() / (robot.tool_width * robot.cruise_speed);
            let enough = |&minutes: &u32| 60.0 * f64::from(minutes) >= USUAL * once_s;
            self.minutes = MINUTES.into_iter().find(enough).unwrap_or(MINUTES[MINUTES.len() - 1]);
        }
        self.changed();
    }

    /// Includes an algorithm, or excludes it, by its number in [`ManyRuns::entrants`].
    pub fn choose(&mut self, entrant: usize, takes_part: bool) {
        if takes_part && entrant < self.entrants.len() {
            self.chosen.insert(entrant)
        } else {
            self.chosen.remove(&entrant)
        };
        self.changed();
    }

    /// Of the `planner`s or the `behaviour`s, includes only these, joined by commas, with their parameters.
    pub fn choose_only(&mut self, kind: &'static str, names: &str) -> Result<(), SettingsError> {
        let mut wanted = Vec::new();
        for name in names.split(',').filter(|name| !name.is_empty()) {
            let entrant = Entrant::parse(kind, name)?;
            wanted.push((self.index(entrant.algorithm)?, entrant));
        }
        self.chosen.retain(|&index| self.entrants[index].algorithm.kind() != kind);
        for (index, entrant) in wanted {
            self.entrants[index] = entrant;
            self.chosen.insert(index);
        }
        self.changed();
        Ok(())
    }

    /// Sets a parameter of an algorithm from the text of a form.
    pub fn set_param(&mut self, entrant: usize, id: &str, text: &str) -> Result<(), SettingsError> {
        if let Some(entrant) = self.entrants.get_mut(entrant) {
            entrant.set(id, text)?;
            self.changed();
        }
        Ok(())
    }

    /// Number of runs of each algorithm, 1 to 1000.
    pub fn set_seeds(&mut self, seeds: u32) {
        self.seeds = seeds.clamp(1, MOST_SEEDS);
        self.changed();
    }

    /// Simulated time of each run, 1 to [`MOST_MINUTES`] min.
    pub fn set_minutes(&mut self, minutes: u32) {
        self.minutes = minutes.clamp(1, MOST_MINUTES);
        self.are_minutes_chosen = true;
        self.changed();
    }

    /// Whether an algorithm can take part: the user's program only if there is one of its kind.
    pub fn is_there(&self, entrant: usize) -> bool {
        let Some(entrant) = self.entrants.get(entrant) else { return false };
        !entrant.algorithm.is_program() || self.program_of(entrant).is_some()
    }

    /// The robot of all runs, once there is one.
    pub fn robot(&self) -> Option<RobotModel> {
        self.base.as_ref().map(|base| base.settings.robot_model())
    }

    /// What the robot lacks for an algorithm to do anything; empty if nothing.
    pub fn lacks(&self, entrant: usize) -> &'static str {
        let robot = self.robot();
        let algorithm = self.entrants.get(entrant).map(|entrant| entrant.algorithm);
        algorithm.zip(robot).map_or("", |(algorithm, robot)| lacking(algorithm, &robot))
    }

    /// Name of an algorithm for users.
    pub fn title(&self, entrant: &Entrant) -> String {
        titled(entrant.algorithm, self.program_of(entrant).map(Arc::as_ref))
    }

    /// The user's program that an entrant stands for.
    fn program_of(&self, entrant: &Entrant) -> Option<&Arc<Program>> {
        let program = self.base.as_ref()?.settings.program()?;
        Some(program).filter(|program| entrant.algorithm == Algorithm::of_program(program.kind))
    }

    /// The included algorithms that can take part.
    fn taking_part(&self) -> impl Iterator<Item = usize> {
        self.chosen.iter().copied().filter(|&entrant| self.is_there(entrant) && self.lacks(entrant).is_empty())
    }

    fn index(&self, wanted: Algorithm) -> Result<usize, SettingsError> {
        let is_wanted = |e: &Entrant| e.algorithm.kind() == wanted.kind() && e.id() == wanted.id();
        self.entrants.iter().position(is_wanted).ok_or_else(|| SettingsError::Unknown {
            kind: "autonomous cleaning or exploring algorithm",
            id: wanted.id().to_owned(),
            known: self.entrants.iter().map(Entrant::id).collect::<Vec<_>>().join(", "),
        })
    }

    /// The choices as `key=value` pairs for a link.
    pub fn to_link(&self) -> String {
        let of = |kind: &str| {
            let chosen = self.chosen.iter().map(|&index| &self.entrants[index]);
            // A program that isn't there would ask for one in the link.
            let is_there = |e: &&Entrant| !e.algorithm.is_program() || self.program_of(e).is_some();
            chosen
                .filter(|e| e.algorithm.kind() == kind)
                .filter(is_there)
                .map(Entrant::to_string)
                .collect::<Vec<_>>()
                .join(",")
        };
        format!("runs={}&paths={}&times={}&minutes={}", of(BEHAVIOUR), of(PLANNER), self.seeds, self.minutes)
    }

    /// Reads the pairs that [`ManyRuns::to_link`] wrote, among others, joined by `&`. Changes nothing on an error.
    pub fn restore(&mut self, link: &str) -> Result<(), SettingsError> {
        let mut next = Self { entrants: self.entrants.clone(), chosen: self.chosen.clone(), ..Self::new() };
        (next.seeds, next.minutes) = (self.seeds, self.minutes);
        next.are_minutes_chosen = self.are_minutes_chosen;
        for (key, value) in link.trim_start_matches('#').split('&').filter_map(|pair| pair.split_once('=')) {
            match key {
                "runs" => next.choose_only(BEHAVIOUR, value)?,
                "paths" => next.choose_only(PLANNER, value)?,
                "times" => {
                    next.seeds = whole(value, MOST_SEEDS, "the number of runs", "a whole number from 1 to 1000")?;
                }
                "minutes" => {
                    next.are_minutes_chosen = true;
                    next.minutes = whole(value, MOST_MINUTES, "the duration of a run", "whole minutes from 1 to 600")?;
                }
                _ => {}
            }
        }
        (self.entrants, self.chosen, self.seeds, self.minutes) = (next.entrants, next.chosen, next.seeds, next.minutes);
        self.are_minutes_chosen = next.are_minutes_chosen;
        self.changed();
        Ok(())
    }

    /// The choices have changed: requests that are no longer required are dropped.
    fn changed(&mut self) {
        self.version += 1;
        let wanted: BTreeSet<OutcomeKey> = self.taking_part().filter_map(|index| self.key(index)).collect();
        self.under_way.retain(|_, batch| wanted.contains(&batch.key));
        self.rest();
    }

    // ---- runs

    /// Starts the missing runs; failed ones are tried again.
    pub fn run(&mut self) {
        self.failures.clear();
        self.is_running = true;
        self.version += 1;
        self.rest();
    }

    /// Cancels the remaining runs; results are kept.
    pub fn cancel(&mut self) {
        self.under_way.clear();
        self.is_running = false;
        self.version += 1;
    }

    /// Whether runs are in progress.
    pub fn is_running(&self) -> bool {
        self.is_running
    }

    fn rest(&mut self) {
        let (done, all) = self.count();
        self.is_running &= done < all;
    }

    /// The next runs for an idle worker: round by round, so that all algorithms progress together.
    pub fn take_batch(&mut self) -> Option<RunsRequest> {
        let base = self.base.as_ref().filter(|_| self.is_running)?;
        let size = u64::from((BATCH_MINUTES / self.minutes).max(1));
        let (first, count) = (base.settings.seed, u64::from(self.seeds));
        let (entrant, key, seeds) = (0..count.div_ceil(size)).find_map(|round| {
            let seeds = first + round * size..first + ((round + 1) * size).min(count);
            self.taking_part().find_map(|entrant| {
                let key = self.key(entrant).filter(|key| !self.failures.contains_key(key))?;
                let missing: Vec<u64> = seeds.clone().filter(|&seed| !self.has_begun(&key, seed)).collect();
                (!missing.is_empty()).then_some((entrant, key, missing))
            })
        })?;
        self.last += 1;
        let job = self.program_of(&self.entrants[entrant]).and(base.job.as_ref()).map(ProgramJob::to_bytes);
        let request = RunsRequest {
            job,
            id: self.last,
            room: base.room.map(str::to_owned),
            scenario: base.room.is_none().then(|| Scenario::of(&base.plan).to_json()),
            settings: base.place.clone(),
            duration_s: 60.0 * f64::from(self.minutes),
            plan_seed: first,
            behaves: self.entrants[entrant].algorithm.behaviour().is_some(),
            entrant: self.entrants[entrant].to_string(),
            seeds: seeds.clone(),
            place: format!("{} {first} {}", base.key(), self.minutes),
        };
        self.under_way.insert(self.last, RunBatch { key, seeds });
        Some(request)
    }

    fn has_begun(&self, key: &OutcomeKey, seed: u64) -> bool {
        self.tallies.get(key).is_some_and(|tally| tally.has(seed))
            || self.under_way.values().any(|batch| batch.key == *key && batch.seeds.contains(&seed))
    }

    /// Whether those runs are still required; otherwise their worker should be ended.
    pub fn is_wanted(&self, id: u32) -> bool {
        self.under_way.contains_key(&id)
    }

    /// A worker has finished, or failed with a message.
    pub fn batch_finished(&mut self, id: u32, result: Result<Vec<RunOutcome>, String>) {
        let Some(RunBatch { key, .. }) = self.under_way.remove(&id) else { return };
        match result {
            Ok(outcomes) => {
                let tally = self.tallies.entry(key).or_default();
                for outcome in outcomes {
                    tally.add(outcome);
                }
            }
            Err(message) => {
                self.failures.insert(key, message);
            }
        }
        self.version += 1;
        self.rest();
    }

    /// Numbers of finished or failed runs and of all chosen runs.
    pub fn count(&self) -> (usize, usize) {
        let done =
            |index: usize| if self.failure(index).is_some() { self.seeds as usize } else { self.runs(index).len() };
        (self.taking_part().map(done).sum(), self.taking_part().count() * self.seeds as usize)
    }

    // ---- results

    fn key(&self, entrant: usize) -> Option<OutcomeKey> {
        let base = self.base.as_ref()?;
        let entrant = &self.entrants[entrant];
        let planned = entrant.algorithm.planner().map_or(String::new(), |_| base.settings.seed.to_string());
        let text = self.program_of(entrant).map(|program| format!("#{:x}", program.fingerprint())).unwrap_or_default();
        Some(format!("{} {} {} {entrant}{text} {planned}", base.key(), self.minutes, entrant.algorithm.kind()))
    }

    /// The finished runs of an algorithm that are required, by seed.
    pub fn runs(&self, entrant: usize) -> Vec<&RunOutcome> {
        let known = || Some((self.base.as_ref()?.settings.seed, self.tallies.get(&self.key(entrant)?)?));
        known().map(|(first, tally)| tally.runs(first, u64::from(self.seeds))).unwrap_or_default()
    }

    /// Summary of an algorithm's runs; `None` without any.
    pub fn summary(&self, entrant: usize) -> Option<Summary> {
        Summary::of(&self.runs(entrant))
    }

    /// Why an algorithm can't be run, if so.
    pub fn failure(&self, entrant: usize) -> Option<&str> {
        self.failures.get(&self.key(entrant)?).map(String::as_str)
    }

    /// Changes with every change of choices and results.
    pub fn version(&self) -> u32 {
        self.version
    }

    /// All available algorithms, in the order of the registries.
    pub fn entrants(&self) -> &[Entrant] {
        &self.entrants
    }

    /// Whether an algorithm is included.
    pub fn is_chosen(&self, entrant: usize) -> bool {
        self.chosen.contains(&entrant)
    }

    /// Number of runs of each algorithm.
    pub fn seeds(&self) -> u32 {
        self.seeds
    }

    /// Simulated time of each run, min.
    pub fn minutes(&self) -> u32 {
        self.minutes
    }

    /// The header of an export, and the included algorithms with their runs.
    pub fn export(&self) -> Option<(RunsHeader<'_>, Vec<EntrantRuns<'_>>)> {
        let base = self.base.as_ref()?;
        let head = RunsHeader {
            room: &base.title,
            robot: &base.robot,
            cell_size_m: base.settings.cell_size,
            conditions: base.settings.conditions,
            odometry: base.settings.odometry,
            smooth: base.settings.smooth,
            minutes: f64::from(self.minutes),
        };
        let runs = |index: usize| {
            let result = self.failure(index).map_or_else(|| Ok(self.runs(index)), Err);
            (&self.entrants[index], result)
        };
        Some((head, self.taking_part().map(runs).collect()))
    }
}

/// A number in a link.
fn whole(text: &str, most: u32, kind: &'static str, expected: &'static str) -> Result<u32, SettingsError> {
    let wrong = || SettingsError::Invalid { kind, value: text.to_owned(), expected };
    text.parse().ok().filter(|number| (1..=most).contains(number)).ok_or_else(wrong)
}

impl Default for ManyRuns {
    fn default() -> Self {
        Self::new()
    }
}
