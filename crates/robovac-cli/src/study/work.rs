//! Makes shards on all cores.

use super::{Failure, Opened, Shards, load_with_image};
use robovac_core::floor_plan::FloorPlan;
use robovac_sim::{
    montecarlo::Lab,
    study::{StudyRow, StudyRun},
};
use std::{
    collections::VecDeque,
    io::{IsTerminal, Write, stderr},
    sync::{
        Arc, Mutex, OnceLock, PoisonError,
        atomic::{AtomicBool, AtomicUsize, Ordering},
    },
    thread,
    time::{Duration, Instant},
};

/// Least time between two lines of progress where they can't replace each other.
const QUIET: Duration = Duration::from_secs(10);

/// A lab, or the reason why there is none; made by the thread that needs it first.
type SharedLab = Arc<OnceLock<Result<Lab, String>>>;

/// The labs in use.
struct Labs<'a> {
    opened: &'a Opened,
    latest: Mutex<VecDeque<(u64, SharedLab)>>,
    most: usize,
}

/// Makes those shards of part `part` of `parts` that aren't there yet.
pub fn make_shards(opened: &Opened, shards: &Shards, (part, parts): (u64, u64), jobs: usize) -> Result<(), Failure> {
    let mine = (0..shards.count()).filter(|shard| shard % parts == part);
    let (there, missing): (Vec<u64>, Vec<u64>) = mine.partition(|&shard| shards.has(shard));
    let runs =
        |list: &[u64]| list.iter().map(|&shard| shards.runs(shard)).map(|runs| runs.end - runs.start).sum::<u64>();
    let progress = Mutex::new(Progress::new(runs(&there), runs(&missing)));
    if !there.is_empty() {
        let _ = writeln!(stderr(), "{} of {} shards are there already", there.len(), there.len() + missing.len());
    }
    let labs = Labs { opened, latest: Mutex::default(), most: jobs + 1 };
    let (next, stopped, failure) = (AtomicUsize::new(0), AtomicBool::new(false), Mutex::new(None));
    let work = || {
        while !stopped.load(Ordering::Relaxed) {
            let Some(&shard) = missing.get(next.fetch_add(1, Ordering::Relaxed)) else { break };
            let rows: Vec<StudyRow> = shards.runs(shard).filter_map(|number| labs.make(number)).collect();
            if let Err(error) = shards.store(shard, &rows) {
                stopped.store(true, Ordering::Relaxed);
                failure.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
            }
            progress.lock().unwrap_or_else(PoisonError::into_inner).add(rows.len() as u64);
        }
    };
    thread::scope(|scope| {
        for _ in 0..jobs.min(missing.len()) {
            scope.spawn(work);
        }
    });
    progress.into_inner().unwrap_or_else(PoisonError::into_inner).end();
    failure.into_inner().unwrap_or_else(PoisonError::into_inner).map_or(Ok(()), Err)
}

impl Labs<'_> {
    fn make(&self, number: u64) -> Option<StudyRow> {
        let study = &self.opened.study;
        let run = study.run(number)?;
        let lab = self.lab(&run);
        let load = |name: &str| self.load(name);
        Some(study.make(&run, lab.get_or_init(|| study.lab(&run, &load))))
    }

    /// The lab of a run; those that were used last are kept.
    fn lab(&self, run: &StudyRun<'_>) -> SharedLab {
        let mut latest = self.latest.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, lab)) = latest.iter().find(|(number, _)| *number == run.lab) {
            return Arc::clone(lab);
        }
        if latest.len() >= self.most {
            latest.pop_front();
        }
        let lab = SharedLab::default();
        latest.push_back((run.lab, Arc::clone(&lab)));
        lab
    }

    fn load(&self, name: &str) -> Result<FloorPlan, String> {
        load_with_image(&self.opened.folder.join(name)).map_err(|failure| failure.to_string())
    }
}

/// What was done, and how long the rest will take.
struct Progress {
    before: u64,
    all: u64,
    made: u64,
    begin: Instant,
    said: Option<Instant>,
    replaces: bool,
}

impl Progress {
    fn new(before: u64, missing: u64) -> Self {
        let replaces = stderr().is_terminal();
        Self { before, all: before + missing, made: 0, begin: Instant::now(), said: None, replaces }
    }

    fn add(&mut self, runs: u64) {
        self.made += runs;
        let is_due = self.replaces || self.said.unwrap_or(self.begin).elapsed() >= QUIET;
        if is_due {
            self.said = Some(Instant::now());
            let (start, end) = if self.replaces { ("\r", "   ") } else { ("", "\n") };
            let _ = write!(stderr(), "{start}{}{end}", self.text(self.begin.elapsed().as_secs_f64()));
        }
    }

    fn text(&self, elapsed_s: f64) -> String {
        let done = self.before + self.made;
        let left = elapsed_s / self.made.max(1) as f64 * (self.all - done) as f64;
        let percent = 100.0 * done as f64 / self.all.max(1) as f64;
        format!("{done} of {} runs, {percent:.1} %, {} left", self.all, time(left))
    }

    fn end(&self) {
        let elapsed = self.begin.elapsed().as_secs_f64();
        let (start, rate) = (if self.replaces { "\r" } else { "" }, self.made as f64 / elapsed.max(1e-9));
        let _ = writeln!(stderr(), "{start}{} runs in {}, {rate:.1} a second        ", self.made, time(elapsed));
    }
}

/// Hours, minutes and seconds.
fn time(seconds: f64) -> String {
    let seconds = seconds.ceil() as u64;
    let (hours, minutes, seconds) = (seconds / 3600, seconds / 60 % 60, seconds % 60);
    if hours > 0 { format!("{hours}:{minutes:02}:{seconds:02} h") } else { format!("{minutes}:{seconds:02} min") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn time_left_is_that_of_what_was_made_now() {
        let mut progress = Progress::new(100, 300);
        progress.made = 100;
        assert_eq!(progress.text(60.0), "200 of 400 runs, 50.0 %, 2:00 min left");
        assert_eq!(time(3661.0), "1:01:01 h");
    }
}
