//! Result of one run.

use crate::{Run, STEP_S};
use coverage_planners::lanes::MetricBound;
use robovac_core::{coverage::BoundaryTracker, robot::RobotModel};

/// Shares whose times are recorded: of the reachable floor, or of the boundary for exploring behaviours.
pub const GOALS: [f64; 2] = [0.9, 0.99];
/// Number of coverage samples, at equal intervals, in addition to the one at the start.
pub const SAMPLES: usize = 200;

/// Result of one run.
#[derive(Debug, Clone, PartialEq)]
pub struct RunOutcome {
    /// Seed of everything random in it.
    pub seed: u64,
    /// Swept share of the reachable floor, or detected share of the boundary, 0 to 1, at the start and at the end of
    /// each of [`SAMPLES`] equal parts of the time. After a run has ended by itself it stays constant.
    pub curve: Vec<f64>,
    /// Times at which the shares of [`GOALS`] were reached, s; infinite if they weren't.
    pub reached_s: [f64; GOALS.len()],
    /// Simulated time, s; shorter than the limit if the run ended by itself.
    pub time_s: f64,
    /// Distance driven, m.
    pub distance_m: f64,
    /// Number of bumps.
    pub bumps: u32,
    /// Number of falls down a drop-off.
    pub falls: u32,
    /// Remaining share of the dirt at the end, 0 to 1; `None` if there was none.
    pub dirt_left: Option<f64>,
    /// How far distance and time exceed the least of any run that sweeps as much floor, as shares of that. `None` if
    /// nothing was swept, and for a robot that fills a cell.
    pub excess: Option<[f64; 2]>,
    /// Digest of the final state, exact to the last bit.
    pub digest: u64,
}

/// Numbers before the curve in [`RunOutcome::to_numbers`].
const HEAD: usize = 11 + GOALS.len();

impl RunOutcome {
    /// Continues `run`, which was made with `seed`, until `duration_s` seconds from its start.
    pub fn of(run: Run, robot: &RobotModel, seed: u64, duration_s: f64) -> Self {
        Self::by(run, robot, seed, duration_s, Run::coverage)
    }

    /// The same for an exploring run, measured by the detected boundary.
    pub fn of_exploring(
        run: Run,
        robot: &RobotModel,
        seed: u64,
        duration_s: f64,
        mut tracker: BoundaryTracker,
    ) -> Self {
        Self::by(run, robot, seed, duration_s, |run| {
            tracker.update(run.pose(), run.sensors());
            tracker.share()
        })
    }

    /// Measured by `share`, which is called after each step.
    fn by(mut run: Run, robot: &RobotModel, seed: u64, duration_s: f64, mut share: impl FnMut(&Run) -> f64) -> Self {
        let mut meter = OutcomeMeter::new(&run, share(&run), duration_s);
        while !meter.is_full() && !run.is_finished() && !run.waits() {
            run.step();
            meter.note(&run, share(&run));
        }
        meter.outcome(&run, robot, seed)
    }

    /// Share at the end, 0 to 1.
    pub fn coverage(&self) -> f64 {
        self.curve.last().copied().unwrap_or(0.0)
    }

    /// All of it as numbers, for transfer to another thread of a browser.
    pub fn to_numbers(&self) -> impl Iterator<Item = f64> {
        let halves = [(self.digest >> 32) as u32, self.digest as u32].map(f64::from);
        let counts = [self.bumps, self.falls].map(f64::from);
        let dirt_left = self.dirt_left.unwrap_or(f64::NAN);
        let head = [self.curve.len() as f64, self.seed as f64, self.time_s, self.distance_m, dirt_left];
        let excess = self.excess.unwrap_or([f64::NAN; 2]);
        head.into_iter()
            .chain(excess)
            .chain(counts)
            .chain(halves)
            .chain(self.reached_s)
            .chain(self.curve.iter().copied())
    }

    /// The inverse of [`RunOutcome::to_numbers`] for several in sequence; incomplete ones are dropped.
    pub fn from_numbers(mut numbers: &[f64]) -> Vec<Self> {
        let mut outcomes = Vec::new();
        while let Some((head, rest)) = numbers.split_first_chunk::<HEAD>() {
            let &[length, seed, time_s, distance_m, dirt_left, above_m, above_s, bumps, falls, high, low, to_90, to_99] =
                head;
            let Some((curve, rest)) = rest.split_at_checked(length as usize) else { break };
            outcomes.push(Self {
                seed: seed as u64,
                curve: curve.to_vec(),
                reached_s: [to_90, to_99],
                time_s,
                distance_m,
                bumps: bumps as u32,
                falls: falls as u32,
                dirt_left: Some(dirt_left).filter(|left| !left.is_nan()),
                excess: Some([above_m, above_s]).filter(|above| !above[0].is_nan()),
                digest: (high as u64) << 32 | low as u64,
            });
            numbers = rest;
        }
        outcomes
    }
}

/// Measures a run while it is made.
#[derive(Debug, Clone)]
pub struct OutcomeMeter {
    /// Steps of a whole run, and those noted so far.
    steps: u64,
    noted: u64,
    /// Steps after which the next sample is due.
    due: u64,
    curve: Vec<f64>,
    /// The latest share.
    share: f64,
    reached_s: [f64; GOALS.len()],
    next: usize,
    has_dirt: bool,
}

impl OutcomeMeter {
    /// For a run of `duration_s` seconds that hasn't begun, with its share now.
    pub fn new(run: &Run, share: f64, duration_s: f64) -> Self {
        let steps = (duration_s / STEP_S).round() as u64;
        let mut meter = Self {
            steps,
            noted: 0,
            due: 0,
            curve: Vec::with_capacity(SAMPLES + 1),
            share,
            reached_s: [f64::INFINITY; GOALS.len()],
            next: 0,
            has_dirt: run.dirt_left() > 0.0,
        };
        meter.sample();
        meter
    }

    /// Whether the time is over.
    #[inline]
    pub fn is_full(&self) -> bool {
        self.noted >= self.steps
    }

    /// Steps that are left of a whole run.
    pub fn left(&self) -> u64 {
        self.steps - self.noted
    }

    /// Takes the share after a step.
    #[inline]
    pub fn note(&mut self, run: &Run, share: f64) {
        self.share = share;
        self.noted = run.steps();
        while GOALS.get(self.next).is_some_and(|&goal| share >= goal) {
            self.reached_s[self.next] = run.time_s();
            self.next += 1;
        }
        if self.noted >= self.due {
            self.sample();
        }
    }

    /// Takes the samples that are due.
    fn sample(&mut self) {
        while self.due <= self.noted && self.curve.len() <= SAMPLES {
            self.curve.push(self.share);
            self.due = self.steps * self.curve.len() as u64 / SAMPLES as u64;
        }
    }

    /// The result. After a run has ended by itself, its share stays as it is.
    pub fn outcome(mut self, run: &Run, robot: &RobotModel, seed: u64) -> RunOutcome {
        self.curve.resize(SAMPLES + 1, self.share);
        RunOutcome {
            seed,
            curve: self.curve,
            reached_s: self.reached_s,
            time_s: run.time_s(),
            distance_m: run.distance_m(),
            bumps: run.bumps(),
            falls: run.falls(),
            dirt_left: self.has_dirt.then(|| run.dirt_left()),
            excess: excess(run, robot),
            digest: run.digest(),
        }
    }
}

/// How far a run's distance and time exceed the [least](MetricBound::of_run) of any run that sweeps as much floor.
fn excess(run: &Run, robot: &RobotModel) -> Option<[f64; 2]> {
    let [least_m, least_s] = MetricBound::of_run(run.coverage() * run.floor().area(), robot)?;
    let above = |value: f64, least: f64| (value / least - 1.0).max(0.0);
    Some([above(run.distance_m(), least_m), above(run.time_s(), least_s)])
}
