//! Many runs of a user's program: repeated from its logs, so that the numbers are the simulator's own.

use crate::explore::{LaidOutJob, ProgramJob};
use robovac_core::grid::Cell;
use robovac_sim::{
    montecarlo::{Lab, RunOutcome, Terms},
    program::CommandLog,
};

/// The runs of a program in one room.
pub struct ProgramRuns(Lab);

impl ProgramRuns {
    /// Runs of `duration_s` seconds for the job of a [`RunsRequest`](robovac_sim::montecarlo::RunsRequest). Errors are for
    /// users.
    pub fn new(job: &[u8], duration_s: f64) -> Result<Self, String> {
        let job = ProgramJob::from_bytes(job).map_err(|error| error.to_string())?;
        let LaidOutJob { room, conditions, odometry, smooth, seed, .. } =
            job.lay_out().map_err(|error| error.to_string())?;
        Ok(Self(Lab::on(room, Terms { conditions, odometry, smooth, duration_s, plan_seed: seed })))
    }

    /// The run that made `log` with that seed. One whose log ends too early ends there.
    pub fn behave(&self, seed: u64, log: &[u8]) -> Result<RunOutcome, String> {
        Ok(self.0.repeat(CommandLog::from_bytes(log).map_err(|error| error.to_string())?, seed))
    }

    /// Runs along a walk that a program has planned.
    pub fn follow(&self, seeds: &[u64], cells: Vec<Cell>) -> Result<Vec<RunOutcome>, String> {
        self.0.follow(seeds, cells)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        compare::{Comparison, ComparisonView, ManyRuns, ManyRunsView},
        explore::Session,
    };
    use robovac_core::{
        program::{Program, ProgramKind, ProgramLanguage},
        registry::Params,
    };
    use robovac_sim::{
        STEP_S,
        experiment::{Algorithm, Entrant},
        montecarlo::RunsRequest,
        program::{Lockstep, LogEnd},
    };

    fn session(kind: ProgramKind) -> Session {
        let mut session = Session::new();
        session.restore("room=bedroom&slip=typical&seed=3&behaviour=bounce").unwrap();
        let program = Program {
            name: "mine".into(),
            language: ProgramLanguage::JavaScript,
            kind,
            source: "function step(robot) {}".into(),
        };
        // Beside what Explore shows.
        session.set_program(program, false).unwrap();
        session
    }

    /// What a sandbox does with a job.
    fn drive(job: &[u8], seed: Option<u64>, duration_s: f64) -> Lockstep {
        let job = ProgramJob::from_bytes(job).unwrap().lay_out().unwrap();
        let mut lockstep = Lockstep::new(&job.room, job.conditions, seed.unwrap_or(job.seed), job.inputs);
        let steps = (duration_s / STEP_S).round() as u64;
        while lockstep.run().steps() < steps {
            let is_near = lockstep.run().sensors().bumped();
            let most = if is_near { 60.min(steps - lockstep.run().steps()) } else { 1 };
            lockstep.steps(if is_near { [-200.0, 0.0] } else { [300.0, 290.0] }, most as u32);
        }
        lockstep
    }

    fn number(entrants: &[Entrant], kind: ProgramKind) -> usize {
        entrants.iter().position(|entrant| entrant.algorithm == Algorithm::of_program(kind)).unwrap()
    }

    #[test]
    fn many_runs_of_a_program_are_repeated_from_its_logs() {
        let mut many = ManyRuns::new();
        let program = number(many.entrants(), ProgramKind::Behaviour);
        many.take(&Session::new());
        assert!(!many.is_there(program) && !many.to_link().contains("program"));
        many.take(&session(ProgramKind::Behaviour));
        assert!(many.is_there(program) && !many.is_there(number(many.entrants(), ProgramKind::Planner)));
        many.choose_only("behaviour", "program").unwrap();
        many.set_seeds(2);
        many.set_minutes(1);
        many.run();
        let request = many.take_batch().unwrap();
        let job = request.job.clone().unwrap();
        assert!(request.behaves && request.seeds == [3, 4]);
        let runs = ProgramRuns::new(&job, request.duration_s).unwrap();
        let mut digests = Vec::new();
        let mut make = |&seed: &u64| {
            let lockstep = drive(&job, Some(seed), request.duration_s);
            digests.push(lockstep.digest());
            runs.behave(seed, &lockstep.log_bytes(0)).unwrap()
        };
        let outcomes: Vec<RunOutcome> = request.seeds.iter().map(&mut make).collect();
        assert_eq!(outcomes.iter().map(|outcome| outcome.digest).collect::<Vec<_>>(), digests);
        assert_ne!(digests[0], digests[1]);
        many.batch_finished(request.id, Ok(outcomes));
        assert!(many.summary(program).is_some() && !many.is_running());
        assert!(runs.behave(3, b"no log").is_err());
        // A log that is too short doesn't wait for ever.
        assert_eq!(runs.behave(3, &drive(&job, Some(3), 1.5).log_bytes(0)).unwrap().time_s, 100.0 * STEP_S);
    }

    #[test]
    fn the_race_waits_for_a_program_and_repeats_it() {
        let mut comparison = Comparison::new();
        let session = session(ProgramKind::Behaviour);
        comparison.take(&session);
        comparison.restore("vs=&behaviours=bounce").unwrap();
        let program = number(comparison.entrants(), ProgramKind::Behaviour);
        assert_eq!(comparison.copy_number(program), 1);
        comparison.choose(program, true);
        let job = comparison.take_race_job().unwrap();
        assert!(comparison.take_race_job().is_none(), "once");
        let race = comparison.race_mut().unwrap();
        race.play();
        race.set_speed(0.0);
        race.frame(1.0, &mut || true);
        assert!(race.waits() && race.time_s() == 0.0);
        let lockstep = drive(&job.to_bytes(), None, 20.0);
        assert!(!comparison.extend_race(job.version + 1, &lockstep.log_bytes(0)).unwrap());
        assert!(comparison.extend_race(job.version, &lockstep.log_bytes(0)).unwrap());
        let race = comparison.race_mut().unwrap();
        race.frame(1.0, &mut || true);
        let of_program = |comparison: &Comparison| {
            let lanes = comparison.race().unwrap().lanes();
            lanes.iter().find(|lane| lane.racer.entrant == program).map(|lane| lane.run().digest()).unwrap()
        };
        assert_eq!(of_program(&comparison), lockstep.digest());
        // Both robots have stopped at the end of the log.
        assert_eq!(comparison.race().unwrap().time_s(), lockstep.run().time_s());
        let mut done = drive(&job.to_bytes(), None, 20.0);
        done.finish(LogEnd::Done);
        assert!(comparison.extend_race(job.version, &done.log_bytes(1300)).unwrap());
        comparison.race_mut().unwrap().frame(1.0, &mut || true);
        assert_eq!(of_program(&comparison), done.digest());
        assert!(comparison.race().unwrap().time_s() > 30.0, "the other one goes on");
    }

    #[test]
    fn a_planner_program_is_in_the_table() {
        let mut comparison = Comparison::new();
        comparison.take(&session(ProgramKind::Planner));
        comparison.restore("vs=").unwrap();
        let program = number(comparison.entrants(), ProgramKind::Planner);
        comparison.choose(program, true);
        let request = comparison.take_trial().unwrap();
        assert!(request.job.is_some());
        let arena = request.arena().unwrap();
        let job = ProgramJob::from_bytes(request.job.as_ref().unwrap()).unwrap().lay_out().unwrap().room.job;
        let jump = request.judge(&arena, vec![job.start, Cell::new(-1, -1)], 0.0).unwrap_err();
        assert!(jump.contains("step 1 leaves the grid: (-1, -1)"), "{jump}");
        let planner = coverage_planners::find("boustrophedon").unwrap();
        let path = planner.build(&Params::default()).plan(&job, &mut coverage_planners::PlanContext::new(0)).unwrap();
        let outcome = request.judge(&arena, path.cells, 0.5).unwrap();
        comparison.trial_finished(request.id, Ok(outcome));
        assert_eq!(comparison.table(None).rows[0].trials, 1);
        assert!(comparison.race().unwrap().lanes().iter().any(|lane| lane.racer.entrant == program));
    }

    #[test]
    fn a_program_that_fails_in_a_race_stops_there_and_says_why() {
        let mut comparison = Comparison::new();
        let session = session(ProgramKind::Behaviour);
        comparison.take(&session);
        comparison.restore("vs=&behaviours=bounce,program").unwrap();
        let view = |comparison: &Comparison| serde_json::to_value(ComparisonView::new(comparison)).unwrap();
        let program = number(comparison.entrants(), ProgramKind::Behaviour);
        assert_eq!(view(&comparison)["entrants"][program]["title"], "Your program: mine");
        let job = comparison.take_race_job().unwrap();
        let mut failed = drive(&job.to_bytes(), None, 5.0);
        failed.finish(LogEnd::Failed);
        assert!(comparison.extend_race(job.version, &failed.log_bytes(0)).unwrap());
        comparison.race_failed(job.version + 1, "of another race");
        assert_eq!(view(&comparison)["race"]["failure"], "");
        comparison.race_failed(job.version, "The program failed in line 3.");
        assert_eq!(view(&comparison)["race"]["failure"], "The program failed in line 3.");
        let race = comparison.race_mut().unwrap();
        race.play();
        race.set_speed(0.0);
        race.frame(1.0, &mut || true);
        assert!(!race.waits());
        for lane in race.lanes() {
            let is_program = lane.racer.entrant == program;
            assert_eq!((lane.run().is_finished(), lane.run().time_s() > 30.0), (is_program, !is_program));
        }
        // Without the program there is nothing to say.
        comparison.choose(program, false);
        assert_eq!(view(&comparison)["race"]["failure"], "");
    }

    #[test]
    fn a_program_that_fails_in_many_runs_says_why_and_the_others_go_on() {
        let mut many = ManyRuns::new();
        many.take(&session(ProgramKind::Behaviour));
        many.choose_only("behaviour", "program").unwrap();
        let program = number(many.entrants(), ProgramKind::Behaviour);
        let bounce = many.entrants().iter().position(|entrant| entrant.id() == "bounce").unwrap();
        many.choose(bounce, true);
        many.set_seeds(3);
        many.set_minutes(1);
        many.run();
        let requests: Vec<RunsRequest> = std::iter::from_fn(|| many.take_batch()).collect();
        let asked = requests.iter().find(|request| request.job.is_some()).unwrap();
        let job = asked.job.as_ref().unwrap();
        let log = drive(job, Some(3), asked.duration_s).log_bytes(0);
        let outcome = ProgramRuns::new(job, asked.duration_s).unwrap().behave(3, &log).unwrap();
        for request in &requests {
            let result = match request.job {
                Some(_) => Err("the program failed in line 3".to_owned()),
                // Whatever they did, they are counted.
                None => Ok(request.seeds.iter().map(|&seed| RunOutcome { seed, ..outcome.clone() }).collect()),
            };
            many.batch_finished(request.id, result);
        }
        assert_eq!((many.failure(program), many.failure(bounce)), (Some("the program failed in line 3"), None));
        assert_eq!((many.runs(program).len(), many.runs(bounce).len()), (0, 3));
        assert!(!many.is_running() && many.summary(bounce).is_some() && many.summary(program).is_none());
        let view = serde_json::to_value(ManyRunsView::new(&many)).unwrap();
        assert_eq!(view["entrants"][program]["title"], "Your program: mine");
        assert_eq!(view["entrants"][program]["failure"], "the program failed in line 3");
    }
}
