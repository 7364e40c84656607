//! View model of a comparison: entrants, rooms, finished and open trials.

use super::{
    ComparisonTable, PrintedRow, Race, RaceSetup, Record, RoomChoice, RoomSet, Row, Trial, TrialProgress,
    base::{ComparisonBase, OWN, SPEED},
    entrants::Entrants,
    kept_paths::{KeptPath, KeptPaths},
    race::{MOST_LANES, Racer},
    race_log::RaceLog,
    trials::{TrialKey, Trials},
};
use crate::explore::{ProgramJob, Session};
use coverage_planners::{CoveragePath, metrics::PlanNumbers};
use robovac_core::{
    floor_plan::{ROOMS, Scenario},
    program::ProgramKind,
};
use robovac_sim::{
    experiment::{Algorithm, BEHAVIOUR, Entrant, PlanOutcome, SettingsError, TrialRequest},
    program::LogError,
};
use std::sync::Arc;

/// Most seeds for planners that use random numbers.
pub const MOST_SEEDS: u32 = 20;
/// The entrants of a comparison and their results.
pub struct Comparison {
    base: Option<ComparisonBase>,
    entrants: Entrants,
    set: RoomSet,
    seeds: u32,
    trials: Trials,
    paths: KeptPaths,
    race: Option<Race>,
    /// How fast it runs, times real time; 0 for as fast as possible.
    speed: f64,
    races: u32,
    race_log: RaceLog,
    version: u32,
}

impl Comparison {
    /// A comparison of some planners in the session's room.
    pub fn new() -> Self {
        let mut comparison = Self {
            base: None,
            entrants: Entrants::new(),
            set: RoomSet::This,
            seeds: 1,
            trials: Trials::default(),
            paths: KeptPaths::default(),
            race: None,
            speed: SPEED,
            races: 0,
            race_log: RaceLog::default(),
            version: 0,
        };
        comparison.changed();
        comparison
    }

    // ---- choices

    /// Takes over room, robot, start and seed from the session. Results that don't depend on changed settings are kept.
    pub fn take(&mut self, session: &Session) {
        if self.base.as_ref().is_some_and(|base| base.is_of(session)) {
            return;
        }
        self.base = Some(ComparisonBase::of(session, self.speed));
        self.entrants.set_program(session.settings().program().cloned());
        self.entrants.set_robot(session.settings().robot_model());
        // Earlier states of an own room aren't kept.
        let here = self.place(self.here());
        self.trials.retain(|key| !key.starts_with(OWN) || key.starts_with(&here));
        self.paths.retain(|key| self.trials.result(key).is_some());
        self.changed();
    }

    /// Includes an entrant by its number, or excludes it.
    pub fn choose(&mut self, entrant: usize, takes_part: bool) {
        self.entrants.choose(entrant, takes_part);
        self.changed();
    }

    /// Sets a parameter of an entrant from the text of a form.
    pub fn set_param(&mut self, entrant: usize, id: &str, text: &str) -> Result<(), SettingsError> {
        self.entrants.set_param(entrant, id, text)?;
        self.changed();
        Ok(())
    }

    /// Includes an entrant once more, to be given other parameters. Does nothing beyond the largest number of copies.
    pub fn copy(&mut self, entrant: usize) {
        self.entrants.copy(entrant);
        self.changed();
    }

    /// Removes a copy.
    pub fn remove_copy(&mut self, entrant: usize) {
        self.entrants.remove_copy(entrant);
        self.changed();
    }

    /// 1 for an original, 2 and up for its copies; 0 for one that was removed, and for a program that isn't there.
    pub fn copy_number(&self, entrant: usize) -> usize {
        self.entrants.copy_number(entrant)
    }

    /// What tells an entrant from its copies; empty if it has none.
    pub fn distinction(&self, entrant: usize) -> String {
        self.entrants.distinction(entrant)
    }

    /// What the robot lacks for an entrant to do anything; it then doesn't take part. Empty if nothing.
    pub fn lacks(&self, entrant: usize) -> &'static str {
        self.entrants.lacks(entrant)
    }

    /// Name of an entrant for users, without what tells it from its copies.
    pub fn title(&self, entrant: &Entrant) -> String {
        self.entrants.title(entrant)
    }

    /// Lets a chosen entrant race, or takes it out of the race. With [`MOST_LANES`] in it, the last of them leaves.
    pub fn set_racing(&mut self, entrant: usize, races: bool) {
        self.entrants.set_racing(entrant, races);
        self.changed();
    }

    /// Who leaves the race if another joins: the last of [`MOST_LANES`].
    pub fn leaves(&self) -> Option<usize> {
        self.race.as_ref()?.lanes().get(MOST_LANES - 1).map(|lane| lane.racer.entrant)
    }

    /// The chosen entrants that don't race: taken out of the race, or without a lane.
    pub fn waiting(&self) -> Vec<usize> {
        let Some(race) = &self.race else { return Vec::new() };
        let races = |entrant: usize| race.lanes().iter().any(|lane| lane.racer.entrant == entrant);
        let here = self.place(self.here());
        let seed = self.base.as_ref().map_or(0, |base| base.seed);
        let could = |&entrant: &usize| {
            let name = self.entrants.name(entrant);
            self.entrants.is_behaviour(entrant) || matches!(self.trials.result(&key(&here, &name, seed)), Some(Ok(_)))
        };
        self.entrants.taking_part().filter(|&entrant| !races(entrant)).filter(could).collect()
    }

    /// Chooses the rooms.
    pub fn set_rooms(&mut self, id: &str) -> Result<(), SettingsError> {
        self.set = RoomSet::parse(id)?;
        self.changed();
        Ok(())
    }

    /// Sets the number of seeds for planners that use random numbers, 1 to [`MOST_SEEDS`].
    pub fn set_seeds(&mut self, seeds: u32) {
        self.seeds = seeds.clamp(1, MOST_SEEDS);
        self.changed();
    }

    /// The choices have changed.
    fn changed(&mut self) {
        self.version += 1;
        self.trials.want(self.wanted());
        self.enter_race();
    }

    /// The choices as `key=value` pairs for a link.
    pub fn to_link(&self) -> String {
        let behaviours = self.entrants.to_link(true);
        let behaviours = if behaviours.is_empty() { behaviours } else { format!("&behaviours={behaviours}") };
        let pace = if self.speed == SPEED { String::new() } else { format!("&pace={}", self.speed) };
        let bench = self.entrants.bench_to_link(&self.waiting());
        let bench = if bench.is_empty() { bench } else { format!("&bench={bench}") };
        let planners = self.entrants.to_link(false);
        format!("vs={planners}{behaviours}{bench}&rooms={}&seeds={}{pace}", self.set.id(), self.seeds)
    }

    /// Reads the pairs that [`Comparison::to_link`] wrote, among others, joined by `&`. Changes nothing on an error.
    pub fn restore(&mut self, link: &str) -> Result<(), SettingsError> {
        let (mut entrants, mut set, mut number, mut speed) = (self.entrants.clone(), self.set, self.seeds, self.speed);
        let pairs = || link.trim_start_matches('#').split('&').filter_map(|pair| pair.split_once('='));
        if pairs().any(|(key, _)| key == "vs" || key == "behaviours") {
            entrants.clear();
            speed = SPEED;
        }
        for (key, value) in pairs() {
            match key {
                "vs" => entrants.choose_planners(value)?,
                "behaviours" => entrants.choose_behaviours(value)?,
                "rooms" => set = RoomSet::parse(value)?,
                "seeds" => number = seeds(value)?,
                "pace" => speed = pace(value)?,
                _ => {}
            }
        }
        if let Some((_, places)) = pairs().find(|&(key, _)| key == "bench") {
            entrants.bench(places);
        }
        (self.entrants, self.set, self.seeds) = (entrants, set, number);
        self.set_speed(speed);
        self.changed();
        Ok(())
    }

    // ---- trials

    /// All required trials, room by room.
    fn wanted(&self) -> Vec<(Trial, TrialKey)> {
        let first = self.base.as_ref().map_or(0, |base| base.seed);
        let planners = self.entrants.planners();
        let names: Vec<(usize, String)> = planners.into_iter().map(|i| (i, self.entrants.name(i))).collect();
        let mut trials = Vec::new();
        for room in self.rooms() {
            let place = self.place(room);
            for &(entrant, ref name) in &names {
                let seeds = if self.entrants.get(entrant).is_deterministic() { 1 } else { self.seeds };
                for seed in first..first.saturating_add(u64::from(seeds)) {
                    trials.push((Trial { room, entrant, seed }, key(&place, name, seed)));
                }
            }
        }
        trials
    }

    /// The rooms of the comparison.
    pub fn rooms(&self) -> Vec<RoomChoice> {
        self.set.rooms(self.here())
    }

    /// The session's room.
    pub fn here(&self) -> RoomChoice {
        self.base.as_ref().map_or(RoomChoice::Own, ComparisonBase::here)
    }

    fn place(&self, room: RoomChoice) -> String {
        self.base.as_ref().map_or_else(String::new, |base| base.place(room))
    }

    /// The next trial for an idle worker.
    pub fn take_trial(&mut self) -> Option<TrialRequest> {
        let base = self.base.as_ref()?;
        let (id, trial) = self.trials.begin()?;
        let entrant = self.entrants.get(trial.entrant);
        let job = self.entrants.program_of(entrant).map(|_| base.job_in(trial.room, trial.seed).to_bytes());
        Some(TrialRequest {
            id,
            job,
            room: match trial.room {
                RoomChoice::Shipped(id) => Some(id.to_owned()),
                RoomChoice::Own => None,
            },
            scenario: (trial.room == RoomChoice::Own).then(|| Scenario::of(&base.plan).to_json()),
            start: base.start_in(trial.room),
            robot: base.robot.to_owned(),
            custom: base.custom.clone(),
            cell_size: base.cells.size,
            cell_offset: base.cells.offset,
            entrant: entrant.to_string(),
            seed: trial.seed,
            smooth: base.setup.smooth,
            place: self.place(trial.room),
        })
    }

    /// Whether that trial is still required; otherwise its worker should be ended.
    pub fn is_wanted(&self, id: u32) -> bool {
        self.trials.is_running(id)
    }

    /// A worker reports the share done, 0 to 1.
    pub fn trial_progress(&mut self, id: u32, done: f64) {
        self.trials.report(id, done);
    }

    /// A worker is done.
    pub fn trial_finished(&mut self, id: u32, result: Result<PlanOutcome, String>) {
        let Some((trial, key)) = self.trials.end(id) else { return };
        let result = result.map(|PlanOutcome { numbers, path, smooth }| {
            if self.base.as_ref().is_some_and(|base| base.seed == trial.seed) {
                self.keep(&key, KeptPath { path, smooth });
            }
            numbers
        });
        self.trials.learn(key, result);
        self.version += 1;
        self.enter_race();
    }

    /// Keeps a path for the race.
    fn keep(&mut self, key: &TrialKey, path: KeptPath) {
        if !self.paths.has_room_for(&path) {
            // For other rooms the walk is planned again if needed.
            let here = self.place(self.here());
            self.trials.retain(|key| key.starts_with(&here) || self.paths.get(key).is_none());
            self.paths.retain(|key| key.starts_with(&here));
        }
        self.paths.keep(key.clone(), path);
    }

    /// Cancels the remaining trials; results are kept.
    pub fn cancel(&mut self) {
        self.trials.cancel();
        self.version += 1;
    }

    /// Continues after [`Comparison::cancel`].
    pub fn resume(&mut self) {
        self.trials.is_cancelled = false;
    }

    /// Whether it was cancelled with trials left.
    pub fn is_cancelled(&self) -> bool {
        self.trials.is_cancelled
    }

    /// Numbers of finished trials and of all trials.
    pub fn count(&self) -> (usize, usize) {
        self.trials.count()
    }

    /// Progress of a planner.
    pub fn progress(&self, entrant: usize) -> TrialProgress<'_> {
        self.trials.progress(entrant)
    }

    // ---- results

    /// Changes with the content of [`Comparison::table`].
    pub fn version(&self) -> u32 {
        self.version
    }

    /// All planners in the order of the registry, all behaviours that clean, and copies; those with the
    /// [`copy_number`](Self::copy_number) 0 were removed.
    pub fn entrants(&self) -> &[Entrant] {
        self.entrants.all()
    }

    /// Whether an entrant is included.
    pub fn is_chosen(&self, entrant: usize) -> bool {
        self.entrants.is_chosen(entrant)
    }

    /// The rooms chosen.
    pub fn set(&self) -> RoomSet {
        self.set
    }

    /// Number of seeds for planners that use chance.
    pub fn seeds(&self) -> u32 {
        self.seeds
    }

    /// The table of one room, or of all rooms together.
    pub fn table(&self, room: Option<RoomChoice>) -> ComparisonTable {
        let rooms = room.map_or_else(|| self.rooms(), |room| vec![room]);
        let rows = self.entrants.planners().into_iter().map(|entrant| {
            let results = |&room: &RoomChoice| {
                let trials = self.trials.results().filter(|(t, _)| t.entrant == entrant && t.room == room);
                trials.map(|(_, result)| result.clone()).collect()
            };
            let row =
                Row::new(self.entrants.get(entrant).clone(), entrant, &rooms.iter().map(results).collect::<Vec<_>>());
            Row { printed: self.printed(entrant, &rooms), ..row }
        });
        ComparisonTable::new(rows.collect())
    }

    /// What a paper prints for a planner, if these rooms are its only one.
    fn printed(&self, entrant: usize, rooms: &[RoomChoice]) -> Option<&'static PrintedRow> {
        let (base, &[room]) = (self.base.as_ref()?, rooms) else { return None };
        // Papers' cells begin in the corner.
        let is_theirs = base.cells.offset == [0.0; 2];
        PrintedRow::find(self.entrants.get(entrant).id(), room, base.cells.size).filter(|_| is_theirs)
    }

    /// The numbers of any plan for a room, once there is one; its bounds are those of all others.
    pub fn numbers(&self, room: RoomChoice) -> Option<&PlanNumbers> {
        let mut results = self.trials.results().filter(|(trial, _)| trial.room == room);
        results.find_map(|(_, result)| result.as_ref().ok())
    }

    /// All results, for export.
    pub fn records(&self) -> Vec<Record<'_>> {
        let Some(base) = &self.base else { return Vec::new() };
        let record = |(t, result): (&Trial, _)| Record {
            room: self.room_name(t.room),
            robot: &base.robot_name,
            cells: base.cells,
            entrant: self.entrants.get(t.entrant),
            seed: t.seed,
            result,
        };
        self.trials.results().map(record).collect()
    }

    /// Name of a room.
    pub fn room_name(&self, room: RoomChoice) -> &str {
        match room {
            RoomChoice::Shipped(id) => ROOMS.iter().find(|r| r.id == id).map_or(id, |r| r.title),
            RoomChoice::Own => self.base.as_ref().map_or("", |base| &base.title),
        }
    }

    // ---- race

    /// The race in the session's room, once there is a plan.
    pub fn race(&self) -> Option<&Race> {
        self.race.as_ref()
    }

    /// Sets the speed of races, times real time; 0 for as fast as possible.
    pub fn set_speed(&mut self, times: f64) {
        self.speed = if times.is_finite() { times.max(0.0) } else { 0.0 };
        if let Some(race) = &mut self.race {
            race.set_speed(self.speed);
        }
    }

    /// The race, mutably.
    pub fn race_mut(&mut self) -> Option<&mut Race> {
        self.race.as_mut()
    }

    /// The walk of a planner in the session's room, if it is known; there can be more walks than lanes in the race.
    pub fn path(&self, entrant: usize) -> Option<&CoveragePath> {
        let seed = self.base.as_ref()?.seed;
        self.paths.get(&key(&self.place(self.here()), &self.entrants.name(entrant), seed)).map(|kept| &kept.path)
    }

    /// Sets the race up again if its robots have changed.
    fn enter_race(&mut self) {
        let Some(base) = &self.base else { return };
        let here = self.place(self.here());
        let racers: Vec<Racer> = self
            .entrants
            .racing()
            .map(|entrant| {
                let kind = if self.entrants.is_behaviour(entrant) { BEHAVIOUR } else { "" };
                (entrant, key(&format!("{here}{kind}"), &self.entrants.name(entrant), base.seed))
            })
            .filter(|(_, key)| !matches!(self.trials.result(key), Some(Err(_))))
            // Before filtering by finished plans, so that the racers don't depend on the order of planning.
            .take(MOST_LANES)
            .filter_map(|(entrant, key)| {
                if self.entrants.is_behaviour(entrant) {
                    return Some(Racer { entrant, planned_s: None, key });
                }
                let planned_s = Some(self.trials.result(&key)?.as_ref().ok()?.drive.duration_s);
                self.paths.get(&key).map(|_| Racer { entrant, planned_s, key })
            })
            .collect();
        let setup = RaceSetup { speed: self.race.as_ref().map_or(self.speed, Race::speed), ..base.setup };
        if self.race.as_ref().is_some_and(|race| race.is_of(setup, &racers)) {
            return;
        }
        let Some(prepared) = &base.prepared else { return self.race = None };
        self.races += 1;
        let mut race = Race::new(self.races, Arc::clone(&base.plan), prepared.clone(), setup);
        for racer in racers {
            match (self.paths.get(&racer.key), self.entrants.get(racer.entrant)) {
                (Some(KeptPath { path, smooth }), _) => race.enter(racer, path, smooth.clone()),
                (None, entrant) if entrant.algorithm.is_program() => {
                    let log = self.race_log.of(&format!("{} {:?}", racer.key, setup.conditions));
                    race.enter_program(racer, log);
                }
                (None, entrant) => race.enter_behaviour(racer, entrant),
            }
        }
        if let Some(earlier) = self.race.take() {
            race.follow(earlier);
        }
        self.race = Some(race);
    }

    /// The job of the user's program in the race, returned once, with the number of its log.
    pub fn take_race_job(&mut self) -> Option<ProgramJob> {
        let program = Algorithm::of_program(ProgramKind::Behaviour);
        let base = self.base.as_ref()?;
        let races = self.entrants.racing().any(|entrant| self.entrants.get(entrant).algorithm == program);
        let version = races.then(|| self.race_log.take()).flatten()?;
        Some(ProgramJob { version, ..base.job_in(base.here(), base.seed) })
    }

    /// Takes a part of the log with that number; of an older one, it is left out and the result is false.
    pub fn extend_race(&mut self, number: u32, part: &[u8]) -> Result<bool, LogError> {
        self.race_log.extend(number, part)
    }

    /// The program that makes the log with that number has failed: `message` says why to users.
    pub fn race_failed(&mut self, number: u32, message: &str) {
        self.race_log.fail(number, message);
    }

    /// Why the user's program failed in the race, for users; empty if it didn't, or doesn't race.
    pub fn race_failure(&self) -> &str {
        let races = self.race.iter().flat_map(Race::lanes).any(|lane| {
            let algorithm = self.entrants.get(lane.racer.entrant).algorithm;
            algorithm == Algorithm::of_program(ProgramKind::Behaviour)
        });
        if races { self.race_log.failure() } else { "" }
    }
}

fn key(place: &str, entrant: &str, seed: u64) -> TrialKey {
    format!("{place} {entrant} {seed}")
}

/// A number of seeds in a link.
fn seeds(text: &str) -> Result<u32, SettingsError> {
    text.parse().ok().filter(|seeds| (1..=MOST_SEEDS).contains(seeds)).ok_or_else(|| SettingsError::Invalid {
        kind: "the number of seeds",
        value: text.to_owned(),
        expected: "a whole number from 1 to 20",
    })
}

/// The speed of races in a link.
fn pace(text: &str) -> Result<f64, SettingsError> {
    text.parse().ok().filter(|times: &f64| times.is_finite() && *times >= 0.0).ok_or_else(|| SettingsError::Invalid {
        kind: "the speed of the race",
        value: text.to_owned(),
        expected: "a number, 0 for as fast as possible",
    })
}

impl Default for Comparison {
    fn default() -> Self {
        Self::new()
    }
}
