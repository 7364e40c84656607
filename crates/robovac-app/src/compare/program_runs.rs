//! Runs of a user's program for a study: repeated from its logs, so that the numbers are the simulator's own.

use crate::explore::{LaidOutJob, ProgramJob};
use robovac_core::{grid::Cell, robot::OdometryModel};
use robovac_sim::{
    Run,
    experiment::{PlanAnswer, Planned},
    montecarlo::RunOutcome,
    program::{CommandLog, Logged, SharedLog, check_walk},
};

/// The runs of a program in one room.
pub struct ProgramRuns {
    job: LaidOutJob,
    odometry: OdometryModel,
    duration_s: f64,
}

impl ProgramRuns {
    /// Runs of `duration_s` seconds for the job of a [`RunsRequest`](robovac_sim::montecarlo::RunsRequest). Errors are for
    /// users.
    pub fn new(job: &[u8], duration_s: f64) -> Result<Self, String> {
        let job = ProgramJob::from_bytes(job).map_err(|error| error.to_string())?;
        let job = job.lay_out().map_err(|error| error.to_string())?;
        Ok(Self { odometry: job.odometry, job, duration_s })
    }

    /// The run that made `log` with that seed. One whose log ends too early ends there.
    pub fn behave(&self, seed: u64, log: &[u8]) -> Result<RunOutcome, String> {
        let log = SharedLog::new(CommandLog::from_bytes(log).map_err(|error| error.to_string())?);
        let setup = self.job.room.setup(self.job.conditions, seed);
        Ok(self.outcome(Run::new(&setup, Box::new(Logged::new(log))), seed))
    }

    /// Runs along a walk that a program has planned.
    pub fn follow(&self, seeds: &[u64], cells: Vec<Cell>) -> Result<Vec<RunOutcome>, String> {
        let room = &self.job.room;
        check_walk(&room.job, &cells).map_err(|fault| format!("the plan can't be driven: {fault}"))?;
        let path = coverage_planners::CoveragePath::walk(cells);
        let answer = PlanAnswer { path, seconds: 0.0, proof: None, trace: Vec::new() };
        let planned = Planned::new(room, &answer).map_err(|error| error.to_string())?;
        let run = |&seed: &u64| self.outcome(planned.run(room, self.job.conditions, self.odometry, seed), seed);
        Ok(seeds.iter().map(run).collect())
    }

    fn outcome(&self, run: Run, seed: u64) -> RunOutcome {
        RunOutcome::of(run, &self.job.room.robot, seed, self.duration_s)
    }
}
