//! Trials of a comparison: pending, running and finished.

use super::RoomChoice;
use coverage_planners::metrics::PlanNumbers;
use std::collections::{BTreeMap, BTreeSet};

/// One planner in one room with one seed.
#[derive(Debug, Clone, PartialEq)]
pub struct Trial {
    /// The room.
    pub room: RoomChoice,
    /// Number of the planner in the registry.
    pub entrant: usize,
    /// Seed of its random numbers.
    pub seed: u64,
}

/// Key of everything that a result depends on: room, start, robot and cell size, planner with parameters, seed.
pub(super) type TrialKey = String;

/// Result of a trial: numbers, or a message.
pub(super) type TrialResult = Result<PlanNumbers, String>;

/// Progress of a planner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TrialProgress<'a> {
    /// It isn't included.
    Out,
    /// Share of its trials that is done; running ones count in part.
    Trying(f64),
    /// All its trials are done.
    Done,
    /// A trial failed, with a message.
    Failed(&'a str),
}

/// Queued, running and finished trials.
#[derive(Default)]
pub(super) struct Trials {
    wanted: Vec<(Trial, TrialKey)>,
    /// By the planners' numbers; planners beyond the end aren't included.
    tallies: Vec<TrialTally>,
    known: BTreeMap<TrialKey, TrialResult>,
    running: BTreeMap<u32, Running>,
    /// Number of the trial started last.
    last: u32,
    pub is_cancelled: bool,
}

/// A running trial.
struct Running {
    trial: Trial,
    key: TrialKey,
    /// Share that is done, 0 to 1.
    done: f64,
}

/// Trials of one planner, counted once per change, as every frame reads them.
#[derive(Clone, Default)]
struct TrialTally {
    all: usize,
    done: usize,
    failure: Option<String>,
}

impl Trials {
    /// Replaces the list of required trials. Others are ended, but their results are kept.
    pub fn want(&mut self, wanted: Vec<(Trial, TrialKey)>) {
        self.is_cancelled = false;
        self.wanted = wanted;
        let keys: BTreeSet<&TrialKey> = self.wanted.iter().map(|(_, key)| key).collect();
        self.running.retain(|_, running| keys.contains(&running.key));
        self.sum_up();
    }

    fn sum_up(&mut self) {
        self.tallies.clear();
        for (trial, key) in &self.wanted {
            if self.tallies.len() <= trial.entrant {
                self.tallies.resize(trial.entrant + 1, TrialTally::default());
            }
            let tally = &mut self.tallies[trial.entrant];
            tally.all += 1;
            if let Some(result) = self.known.get(key) {
                tally.done += 1;
                if let Err(message) = result {
                    tally.failure.get_or_insert_with(|| message.clone());
                }
            }
        }
    }

    /// Starts the first trial that is neither finished nor running; returns its number.
    pub fn begin(&mut self) -> Option<(u32, Trial)> {
        if self.is_cancelled {
            return None;
        }
        let is_new = |key: &TrialKey| !self.known.contains_key(key) && self.running.values().all(|r| r.key != *key);
        let (trial, key) = self.wanted.iter().find(|(_, key)| is_new(key))?.clone();
        self.last += 1;
        self.running.insert(self.last, Running { trial: trial.clone(), key, done: 0.0 });
        Some((self.last, trial))
    }

    /// Whether that trial is running.
    pub fn is_running(&self, id: u32) -> bool {
        self.running.contains_key(&id)
    }

    /// Sets the progress of a running trial, 0 to 1.
    pub fn report(&mut self, id: u32, done: f64) {
        if let Some(running) = self.running.get_mut(&id) {
            running.done = done;
        }
    }

    /// Ends a trial; `None` if it is no longer required.
    pub fn end(&mut self, id: u32) -> Option<(Trial, TrialKey)> {
        self.running.remove(&id).map(|running| (running.trial, running.key))
    }

    /// Ends all running trials.
    pub fn cancel(&mut self) {
        self.running.clear();
        self.is_cancelled = true;
    }

    /// Keeps a result.
    pub fn learn(&mut self, key: TrialKey, result: TrialResult) {
        self.known.insert(key, result);
        self.sum_up();
    }

    /// The result of a trial.
    pub fn result(&self, key: &TrialKey) -> Option<&TrialResult> {
        self.known.get(key)
    }

    /// Drops the results for which `is_kept` is false.
    pub fn retain(&mut self, mut is_kept: impl FnMut(&TrialKey) -> bool) {
        self.known.retain(|key, _| is_kept(key));
    }

    /// All finished trials among the required ones, in their order.
    pub fn results(&self) -> impl Iterator<Item = (&Trial, &TrialResult)> {
        self.wanted.iter().filter_map(|(trial, key)| Some((trial, self.known.get(key)?)))
    }

    /// Numbers of finished trials and of all trials.
    pub fn count(&self) -> (usize, usize) {
        self.tallies.iter().fold((0, 0), |(done, all), tally| (done + tally.done, all + tally.all))
    }

    /// Progress of a planner.
    pub fn progress(&self, entrant: usize) -> TrialProgress<'_> {
        match self.tallies.get(entrant) {
            None | Some(TrialTally { all: 0, .. }) => TrialProgress::Out,
            Some(TrialTally { failure: Some(message), .. }) => TrialProgress::Failed(message),
            Some(TrialTally { all, done, .. }) if done == all => TrialProgress::Done,
            Some(TrialTally { all, done, .. }) => {
                let under_way: f64 = self.running.values().filter(|r| r.trial.entrant == entrant).map(|r| r.done).sum();
                TrialProgress::Trying((*done as f64 + under_way) / *all as f64)
            }
        }
    }
}
