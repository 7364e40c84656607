//! The benchmark that runs natively (`robovac bench`) and in the browser (`bench.html`), so that both can be compared.

mod floor_plan;
mod mapping;
mod planning;
mod program;
mod streaming;

pub use floor_plan::{floor_plan, office_drawing};
pub use mapping::{MappingCase, mapping};
pub use planning::{cycle, hall, opening_run, planning};
pub use program::programs;
pub use streaming::{stream, streaming};

use serde::Serialize;
use std::array;

/// Samples of each case except long ones; the median is reported.
const SAMPLES: usize = 5;
/// Shortest sample, s: a browser's clock is coarse, and it optimises code only after it has run for a while. Shorter
/// cases are repeated.
const LEAST_S: f64 = 0.05;
/// A case that takes longer is measured once, s.
const LONG_S: f64 = 0.5;
/// Most repetitions, whatever the clock says.
const MOST_REPEATS: u32 = 1024;

/// One case's result.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct BenchResult {
    /// Name of the case.
    pub name: String,
    /// Median time of one run, ms.
    pub ms: f64,
    /// Speed relative to real time, for simulations.
    pub times_real_time: Option<f64>,
    /// Peak memory of the program so far, MB (10^6 bytes); `None` if unknown.
    pub memory_mb: Option<f64>,
}

/// Measures cases one after the other.
pub struct Bench<'a> {
    clock: &'a dyn Fn() -> f64,
    memory: &'a dyn Fn() -> Option<usize>,
    report: &'a mut dyn FnMut(&BenchResult),
    /// Only cases whose names contain it are run.
    only: &'a str,
    /// Each case runs once.
    once: bool,
    results: Vec<BenchResult>,
}

impl<'a> Bench<'a> {
    /// `clock` returns seconds, `memory` the program's memory in bytes, if known; `report` receives each result.
    pub fn new(
        clock: &'a dyn Fn() -> f64,
        memory: &'a dyn Fn() -> Option<usize>,
        report: &'a mut dyn FnMut(&BenchResult),
    ) -> Self {
        Self { clock, memory, report, only: "", once: false, results: Vec::new() }
    }

    /// Leaves out cases whose names don't contain `text`.
    #[must_use]
    pub fn only(self, text: &'a str) -> Self {
        Self { only: text, ..self }
    }

    /// Runs each case a single time and most of them on less, if `once`: enough to see that it works, too little for a
    /// measurement.
    #[must_use]
    pub fn once_each(self, once: bool) -> Self {
        Self { once, ..self }
    }

    /// `whole`, or `small` if each case runs only once.
    fn size(&self, whole: usize, small: usize) -> usize {
        if self.once { small } else { whole }
    }

    /// The results.
    pub fn into_results(self) -> Vec<BenchResult> {
        self.results
    }

    /// Measures a case, which simulates `simulated` seconds if it is a simulation. It runs at least twice, so that a
    /// browser has optimised it.
    pub fn take(&mut self, name: &str, case: &mut dyn FnMut(), simulated: Option<f64>) {
        if !name.contains(self.only) {
            return;
        }
        let clock = self.clock;
        let mut sample = |repeats: u32| {
            let began = clock();
            (0..repeats).for_each(|_| case());
            clock() - began
        };
        let (mut repeats, mut seconds) = (1, sample(1));
        while !self.once && seconds < LEAST_S && repeats < MOST_REPEATS {
            repeats *= 2;
            seconds = sample(repeats);
        }
        if !self.once && seconds < LONG_S {
            let mut times: [f64; SAMPLES] = array::from_fn(|_| sample(repeats) / f64::from(repeats));
            times.sort_by(f64::total_cmp);
            seconds = times[SAMPLES / 2];
        }
        self.tell(name, seconds, simulated);
    }

    /// Measures the first run of a case, before freshly loaded code is optimised.
    pub fn once(&mut self, name: &str, case: impl FnOnce()) {
        if !name.contains(self.only) {
            return;
        }
        let began = (self.clock)();
        case();
        self.tell(name, (self.clock)() - began, None);
    }

    fn tell(&mut self, name: &str, seconds: f64, simulated: Option<f64>) {
        let result = BenchResult {
            name: name.to_owned(),
            ms: 1000.0 * seconds,
            times_real_time: simulated.map(|s| s / seconds),
            memory_mb: (self.memory)().map(|bytes| bytes as f64 / 1e6),
        };
        (self.report)(&result);
        self.results.push(result);
    }
}
