//! View model of a comparison: entrants, rooms, finished and open trials.

use super::{
    ComparisonTable, PrintedRow, Race, RaceSetup, Record, RoomChoice, RoomSet, Row, Trial, TrialProgress,
    base::{ComparisonBase, OWN},
    race::{MOST_LANES, Racer},
    trials::{TrialKey, Trials},
};
use crate::explore::{ProgramJob, Session};
use coverage_planners::{CoveragePath, PLANNERS, PlannerInfo, metrics::PlanNumbers};
use robovac_core::{
    floor_plan::{ROOMS, Scenario},
    program::{Program, ProgramKind},
    trajectory::Trajectory,
};
use robovac_sim::{
    experiment::{Algorithm, BEHAVIOUR, Entrant, PLANNER, PlanOutcome, SettingsError, TrialRequest},
    program::{LogError, LogPart, SharedLog},
};
use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

/// Most seeds for planners that use random numbers.
pub const MOST_SEEDS: u32 = 20;
/// Most copies of entrants.
const MOST_COPIES: usize = 16;
/// Planners that are selected at first.
const FIRST: [&str; 4] = ["boustrophedon", "snake", "spiral_stc", "wavefront_path"];
/// Most cells of all paths kept for the race together, 8 bytes each.
const MOST_KEPT_CELLS: usize = 8_000_000;

/// The entrants of a comparison and their results.
pub struct Comparison {
    base: Option<ComparisonBase>,
    /// One for each planner of the registry and each behaviour that cleans by itself, in their order; those of the user's
    /// program, as a planner and as a behaviour; then copies with other parameters.
    entrants: Vec<Entrant>,
    /// Number of those before the copies.
    originals: usize,
    /// Copies that were removed; their numbers are used again.
    removed: BTreeSet<usize>,
    /// In the order in which they were chosen.
    chosen: Vec<usize>,
    /// Those of them that were taken out of the race.
    benched: BTreeSet<usize>,
    set: RoomSet,
    seeds: u32,
    trials: Trials,
    /// Walks for the race.
    paths: BTreeMap<TrialKey, CoveragePath>,
    /// The same with rounded corners, if they are.
    smooth: BTreeMap<TrialKey, Arc<Trajectory>>,
    race: Option<Race>,
    races: u32,
    /// What the user's program does in the race.
    race_log: RaceLog,
    version: u32,
}

/// The log of a program in a race.
#[derive(Default)]
struct RaceLog {
    /// Key of what it depends on.
    key: String,
    log: SharedLog,
    /// Number of the log.
    number: u32,
    /// Whether its job was handed out.
    is_taken: bool,
}

impl Comparison {
    /// A comparison of some planners in the session's room.
    pub fn new() -> Self {
        let planners = PLANNERS.iter().map(|planner| Algorithm::Planner(planner));
        let cleans =
            |algorithm: &Algorithm| algorithm.behaviour().is_some_and(|info| info.claims.cleans && !info.claims.manual);
        let programs = [ProgramKind::Planner, ProgramKind::Behaviour].map(Algorithm::of_program);
        let all = planners.chain(Algorithm::all().filter(cleans)).chain(programs);
        let entrants: Vec<Entrant> = all.map(Entrant::new).collect();
        let chosen = (0..PLANNERS.len()).filter(|&i| FIRST.contains(&entrants[i].id())).collect();
        let mut comparison = Self {
            base: None,
            originals: entrants.len(),
            entrants,
            removed: BTreeSet::new(),
            chosen,
            benched: BTreeSet::new(),
            set: RoomSet::This,
            seeds: 1,
            trials: Trials::default(),
            paths: BTreeMap::new(),
            smooth: BTreeMap::new(),
            race: None,
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
        self.base = Some(ComparisonBase::of(session, self.race.as_ref().map(Race::speed)));
        // Earlier states of an own room aren't kept.
        let here = self.place(self.here());
        self.trials.retain(|key| !key.starts_with(OWN) || key.starts_with(&here));
        self.paths.retain(|key, _| self.trials.result(key).is_some());
        self.smooth.retain(|key, _| self.paths.contains_key(key));
        self.changed();
    }

    /// Includes a planner, or excludes it.
    pub fn choose(&mut self, id: &str, takes_part: bool) -> Result<(), SettingsError> {
        self.choose_entrant(Self::index(id)?, takes_part);
        Ok(())
    }

    /// Includes an entrant by its number, or excludes it.
    pub fn choose_entrant(&mut self, entrant: usize, takes_part: bool) {
        self.chosen.retain(|&other| other != entrant);
        self.benched.remove(&entrant);
        if takes_part && entrant < self.entrants.len() && !self.removed.contains(&entrant) {
            self.chosen.push(entrant);
        }
        self.changed();
    }

    /// Sets a parameter of a planner from the text of a form.
    pub fn set_param(&mut self, planner: &str, id: &str, text: &str) -> Result<(), SettingsError> {
        self.set_entrant_param(Self::index(planner)?, id, text)
    }

    /// Sets a parameter of an entrant by its number.
    pub fn set_entrant_param(&mut self, entrant: usize, id: &str, text: &str) -> Result<(), SettingsError> {
        if let Some(entrant) = self.entrants.get_mut(entrant) {
            entrant.set(id, text)?;
            self.changed();
        }
        Ok(())
    }

    /// Includes an entrant once more, to be given other parameters. Does nothing beyond the largest number of copies.
    pub fn copy(&mut self, entrant: usize) {
        let original = self.entrants.get(entrant).filter(|entrant| !entrant.algorithm.is_program()).cloned();
        let Some(original) = original else { return };
        if let Some(index) = self.add_copy(original) {
            self.chosen.push(index);
            self.changed();
        }
    }

    fn add_copy(&mut self, original: Entrant) -> Option<usize> {
        if let Some(index) = self.removed.pop_first() {
            self.entrants[index] = original;
            return Some(index);
        }
        (self.entrants.len() < self.originals + MOST_COPIES).then(|| {
            self.entrants.push(original);
            self.entrants.len() - 1
        })
    }

    /// Removes a copy.
    pub fn remove_copy(&mut self, entrant: usize) {
        if self.copy_number(entrant) > 1 {
            self.removed.insert(entrant);
            self.choose_entrant(entrant, false);
        }
    }

    /// Whether an entrant can take part: the user's program only if there is one of its kind.
    fn is_there(&self, entrant: usize) -> bool {
        let Some(entrant) = self.entrants.get(entrant) else { return false };
        !entrant.algorithm.is_program() || self.program_of(entrant).is_some()
    }

    /// The user's program that an entrant stands for.
    fn program_of(&self, entrant: &Entrant) -> Option<&Arc<Program>> {
        let program = self.base.as_ref()?.program.as_ref()?;
        Some(program).filter(|program| entrant.algorithm == Algorithm::of_program(program.kind))
    }

    /// Name of an entrant in keys of results: a program's changes with its text.
    fn name(&self, entrant: usize) -> String {
        let entrant = &self.entrants[entrant];
        let text = self.program_of(entrant).map(|program| format!("#{:x}", program.fingerprint())).unwrap_or_default();
        format!("{entrant}{text}")
    }

    /// 1 for an original, 2 and up for its copies; 0 for one that was removed, and for a program that isn't there.
    pub fn copy_number(&self, entrant: usize) -> usize {
        if self.removed.contains(&entrant) || !self.is_there(entrant) {
            return 0;
        }
        if entrant < self.originals {
            return 1;
        }
        let is_same = |&index: &usize| {
            let (one, other) = (self.entrants[index].algorithm, self.entrants[entrant].algorithm);
            (one.kind(), one.id()) == (other.kind(), other.id()) && !self.removed.contains(&index)
        };
        2 + (self.originals..entrant).filter(is_same).count()
    }

    /// Lets a chosen entrant race, or takes it out of the race. With [`MOST_LANES`] in it, the last of them leaves.
    pub fn set_racing(&mut self, entrant: usize, races: bool) {
        if !self.chosen.contains(&entrant) {
            return;
        }
        if races {
            self.benched.remove(&entrant);
            self.chosen.retain(|&other| other != entrant);
            let racing = self.chosen.iter().enumerate().filter(|(_, other)| !self.benched.contains(other));
            let last = racing.map(|(place, _)| place).nth(MOST_LANES - 1).unwrap_or(self.chosen.len());
            self.chosen.insert(last, entrant);
        } else {
            self.benched.insert(entrant);
        }
        self.changed();
    }

    /// The chosen entrants that race, in their lanes' order.
    fn racing(&self) -> impl Iterator<Item = usize> {
        self.chosen.iter().copied().filter(|&entrant| !self.benched.contains(&entrant) && self.is_there(entrant))
    }

    /// The chosen entrants that don't race: taken out of the race, or without a lane.
    pub fn waiting(&self) -> Vec<usize> {
        let Some(race) = &self.race else { return Vec::new() };
        let races = |entrant: usize| race.lanes().iter().any(|lane| lane.racer.entrant == entrant);
        let here = self.place(self.here());
        let seed = self.base.as_ref().map_or(0, |base| base.seed);
        let could = |&entrant: &usize| {
            let name = self.name(entrant);
            self.is_behaviour(entrant) || matches!(self.trials.result(&key(&here, &name, seed)), Some(Ok(_)))
        };
        self.chosen.iter().copied().filter(|&entrant| !races(entrant) && self.is_there(entrant)).filter(could).collect()
    }

    fn is_behaviour(&self, entrant: usize) -> bool {
        self.entrants[entrant].algorithm.behaviour().is_some()
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

    fn index(id: &str) -> Result<usize, SettingsError> {
        let of_planner = |info: &PlannerInfo| PLANNERS.iter().position(|other| other.id == info.id);
        Entrant::parse_planner(id).map(|(_, info)| of_planner(info).unwrap_or(0))
    }

    /// The choices have changed.
    fn changed(&mut self) {
        self.version += 1;
        self.trials.want(self.wanted());
        self.enter_race();
    }

    /// The choices as `key=value` pairs for a link.
    pub fn to_link(&self) -> String {
        let names = |behaves: bool| {
            let chosen = self.chosen.iter().filter(|&&i| self.is_behaviour(i) == behaves);
            chosen.map(|&i| self.entrants[i].to_string()).collect::<Vec<_>>().join(",")
        };
        let behaviours = names(true);
        let behaviours = if behaviours.is_empty() { behaviours } else { format!("&behaviours={behaviours}") };
        format!("vs={}{behaviours}&rooms={}&seeds={}", names(false), self.set.id(), self.seeds)
    }

    /// Reads the pairs that [`Comparison::to_link`] wrote, among others, joined by `&`. Changes nothing on an error.
    pub fn restore(&mut self, link: &str) -> Result<(), SettingsError> {
        let mut next = Self { entrants: self.entrants.clone(), removed: self.removed.clone(), ..Self::new() };
        (next.chosen, next.set, next.seeds) = (self.chosen.clone(), self.set, self.seeds);
        next.benched.clone_from(&self.benched);
        let pairs = || link.trim_start_matches('#').split('&').filter_map(|pair| pair.split_once('='));
        if pairs().any(|(key, _)| key == "vs" || key == "behaviours") {
            next.chosen.clear();
            next.benched.clear();
            next.removed = (next.originals..next.entrants.len()).collect();
        }
        for (key, value) in pairs() {
            match key {
                "vs" => next.choose_also(PLANNER, value)?,
                "behaviours" => next.choose_also(BEHAVIOUR, value)?,
                "rooms" => next.set = RoomSet::parse(value)?,
                "seeds" => next.seeds = seeds(value)?,
                _ => {}
            }
        }
        (self.entrants, self.chosen, self.set, self.seeds) = (next.entrants, next.chosen, next.set, next.seeds);
        (self.removed, self.benched) = (next.removed, next.benched);
        self.changed();
        Ok(())
    }

    /// Includes the algorithms of a link; one that is there already, as a copy.
    fn choose_also(&mut self, kind: &'static str, link: &str) -> Result<(), SettingsError> {
        for entrant in link.split(',').filter(|name| !name.is_empty()) {
            let entrant = Entrant::parse(kind, entrant)?;
            let is_it = |e: &Entrant| e.algorithm.kind() == kind && e.id() == entrant.id();
            let Some(index) = self.entrants[..self.originals].iter().position(is_it) else { continue };
            if self.chosen.contains(&index) {
                let copy = self.add_copy(entrant);
                self.chosen.extend(copy);
            } else {
                self.entrants[index] = entrant;
                self.chosen.push(index);
            }
        }
        Ok(())
    }

    // ---- trials

    /// All required trials, room by room.
    fn wanted(&self) -> Vec<(Trial, TrialKey)> {
        let first = self.base.as_ref().map_or(0, |base| base.seed);
        let planners = self.planners();
        let names: Vec<(usize, String)> = planners.into_iter().map(|i| (i, self.name(i))).collect();
        let mut trials = Vec::new();
        for room in self.rooms() {
            let place = self.place(room);
            for &(entrant, ref name) in &names {
                let seeds = if self.entrants[entrant].is_deterministic() { 1 } else { self.seeds };
                for seed in first..first.saturating_add(u64::from(seeds)) {
                    trials.push((Trial { room, entrant, seed }, key(&place, name, seed)));
                }
            }
        }
        trials
    }

    /// The chosen planners that can take part, in the order of the registry.
    fn planners(&self) -> Vec<usize> {
        let is_planner = |&entrant: &usize| !self.is_behaviour(entrant) && self.is_there(entrant);
        let mut planners: Vec<usize> = self.chosen.iter().copied().filter(is_planner).collect();
        planners.sort_unstable();
        planners
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
        let job =
            self.program_of(&self.entrants[trial.entrant]).map(|_| base.job_in(trial.room, trial.seed).to_bytes());
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
            cell_size: base.cell_size,
            entrant: self.entrants[trial.entrant].to_string(),
            seed: trial.seed,
            smooth: self.base.as_ref().is_some_and(|base| base.setup.smooth),
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
                self.keep(&key, path, smooth);
            }
            numbers
        });
        self.trials.learn(key, result);
        self.version += 1;
        self.enter_race();
    }

    /// Keeps a path for the race.
    fn keep(&mut self, key: &TrialKey, path: CoveragePath, smooth: Option<Arc<Trajectory>>) {
        let kept =
            |it: &Self| it.paths.values().map(size).sum::<usize>() + it.smooth.values().map(smooth_size).sum::<usize>();
        let own = size(&path) + smooth.as_ref().map_or(0, smooth_size);
        if kept(self) + own > MOST_KEPT_CELLS {
            // For other rooms the walk is planned again if needed.
            let here = self.place(self.here());
            self.trials.retain(|key| key.starts_with(&here) || !self.paths.contains_key(key));
            self.paths.retain(|key, _| key.starts_with(&here));
            self.smooth.retain(|key, _| key.starts_with(&here));
        }
        if kept(self) + own <= MOST_KEPT_CELLS {
            self.paths.insert(key.clone(), path);
            if let Some(smooth) = smooth {
                self.smooth.insert(key.clone(), smooth);
            }
        }
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
        &self.entrants
    }

    /// Whether an entrant is included.
    pub fn is_chosen(&self, entrant: usize) -> bool {
        self.chosen.contains(&entrant)
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
        let rows = self.planners().into_iter().map(|entrant| {
            let results = |&room: &RoomChoice| {
                let trials = self.trials.results().filter(|(t, _)| t.entrant == entrant && t.room == room);
                trials.map(|(_, result)| result.clone()).collect()
            };
            let row = Row::new(self.entrants[entrant].clone(), entrant, &rooms.iter().map(results).collect::<Vec<_>>());
            Row { printed: self.printed(entrant, &rooms), ..row }
        });
        ComparisonTable::new(rows.collect())
    }

    /// What a paper prints for a planner, if these rooms are its only one.
    fn printed(&self, entrant: usize, rooms: &[RoomChoice]) -> Option<&'static PrintedRow> {
        let (base, &[room]) = (self.base.as_ref()?, rooms) else { return None };
        PrintedRow::find(self.entrants[entrant].id(), room, base.cell_size)
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
            robot: base.robot,
            cell_size: base.cell_size,
            entrant: &self.entrants[t.entrant],
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

    /// The race, mutably.
    pub fn race_mut(&mut self) -> Option<&mut Race> {
        self.race.as_mut()
    }

    /// The walk of a planner in the session's room, if it is known; there can be more walks than lanes in the race.
    pub fn path(&self, entrant: usize) -> Option<&CoveragePath> {
        let seed = self.base.as_ref()?.seed;
        self.paths.get(&key(&self.place(self.here()), &self.name(entrant), seed))
    }

    /// Sets the race up again if its robots have changed.
    fn enter_race(&mut self) {
        let Some(base) = &self.base else { return };
        let here = self.place(self.here());
        let racers: Vec<Racer> = self
            .racing()
            .map(|entrant| {
                let kind = if self.is_behaviour(entrant) { BEHAVIOUR } else { "" };
                (entrant, key(&format!("{here}{kind}"), &self.name(entrant), base.seed))
            })
            .filter(|(_, key)| !matches!(self.trials.result(key), Some(Err(_))))
            // Before filtering by finished plans, so that the racers don't depend on the order of planning.
            .take(MOST_LANES)
            .filter_map(|(entrant, key)| {
                if self.is_behaviour(entrant) {
                    return Some(Racer { entrant, planned_s: None, key });
                }
                let planned_s = Some(self.trials.result(&key)?.as_ref().ok()?.drive.duration_s);
                self.paths.contains_key(&key).then_some(Racer { entrant, planned_s, key })
            })
            .collect();
        let setup = RaceSetup { speed: self.race.as_ref().map_or(base.setup.speed, Race::speed), ..base.setup };
        if self.race.as_ref().is_some_and(|race| race.is_of(setup, &racers)) {
            return;
        }
        let Some(prepared) = &base.prepared else { return self.race = None };
        self.races += 1;
        let mut race = Race::new(self.races, Arc::clone(&base.plan), prepared.clone(), setup);
        for racer in racers {
            match (self.paths.get(&racer.key), &self.entrants[racer.entrant]) {
                (Some(path), _) => {
                    let smooth = self.smooth.get(&racer.key).cloned();
                    race.enter(racer, path, smooth);
                }
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
}

impl Comparison {
    /// The job of the user's program in the race, returned once, with the number of its log.
    pub fn take_race_job(&mut self) -> Option<ProgramJob> {
        let program = ProgramKind::Behaviour;
        let races = self.racing().any(|entrant| self.entrants[entrant].algorithm == Algorithm::of_program(program));
        if !races || self.race_log.is_taken || self.race_log.number == 0 {
            return None;
        }
        self.race_log.is_taken = true;
        let base = self.base.as_ref()?;
        Some(ProgramJob { version: self.race_log.number, ..base.job_in(base.here(), base.seed) })
    }

    /// Takes a part of the log with that number; of an older one, it is left out and the result is false.
    pub fn extend_race(&mut self, number: u32, part: &[u8]) -> Result<bool, LogError> {
        if number != self.race_log.number {
            return Ok(false);
        }
        self.race_log.log.get_mut().extend(LogPart::from_bytes(part)?)?;
        Ok(true)
    }
}

impl RaceLog {
    /// The log for what has that key; a new one if that is another than before.
    fn of(&mut self, key: &str) -> SharedLog {
        if self.key != key {
            *self = Self { key: key.to_owned(), number: self.number + 1, ..Self::default() };
        }
        self.log.clone()
    }
}

/// Length of a path in cells of as much memory.
fn size(path: &CoveragePath) -> usize {
    path.cells.len() + 2 * path.line.len()
}

/// The same for a trajectory.
fn smooth_size(trajectory: &Arc<Trajectory>) -> usize {
    size_of_val(trajectory.knots()) / 8
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

impl Default for Comparison {
    fn default() -> Self {
        Self::new()
    }
}
