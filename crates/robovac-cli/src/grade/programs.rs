//! Runs of learners' programs, in a sandbox, as they are strangers'.

use crate::{
    failure::Failure,
    run::{Language, Prints, ProgramProcess, Ready, Sandbox, drive, drive_framed, greet, plan},
};
use robovac_core::program::Program;
use robovac_lessons::Job;
use robovac_sim::{
    montecarlo::{Lab, ProgramRun, RunOutcome},
    program::{ProgramRoom, RobotFacts},
};
use std::{
    slice,
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
};

/// Memory of a program, MB, and its processor time in a run, s.
const MEMORY_MB: u64 = 1024;
const PROCESSOR_S: u64 = 60;

/// A program, ready to be run with any seed.
pub struct Pupil {
    language: Language,
    has_failed: AtomicBool,
    /// Whether its runs can't be made together.
    is_alone: AtomicBool,
}

/// Makes the runs of programs.
pub struct Programs {
    sandbox: Sandbox,
    end: Arc<AtomicBool>,
}

impl Programs {
    /// In a sandbox, or if the user says so without. They end when `end` becomes true.
    pub fn new(is_unconfined: bool, end: Arc<AtomicBool>) -> Result<Self, Failure> {
        let sandbox = if is_unconfined {
            Sandbox::limits_only()
        } else {
            Sandbox::probe().map_err(|why| {
                Failure::system(format!(
                    "the answers contain programs, which can't be kept from your files and the network here: {why}. On \
                     a disposable computer, such as one in a cloud, --unconfined runs them unprotected"
                ))
            })?
        };
        Ok(Self { sandbox, end })
    }

    /// How they are run, in words.
    pub fn words(&self) -> &'static str {
        self.sandbox.words()
    }

    /// Gets the program of a job ready. Errors are for users.
    pub fn pupil(job: &Job) -> Result<Pupil, String> {
        let Program { language, source, .. } =
            job.program.as_ref().ok_or("the answer names a program but contains none")?;
        let language = Language::of_text(*language, source).map_err(|error| error.to_string())?;
        Ok(Pupil { language, has_failed: AtomicBool::new(false), is_alone: AtomicBool::new(false) })
    }

    /// Runs with these seeds; after one that has failed, none of that pupil's. Errors are for users.
    pub fn run(&self, job: &Job, pupil: &Pupil, lab: &Lab, seeds: &[u64]) -> Vec<Result<RunOutcome, String>> {
        // What goes wrong together is told by the runs alone, which have all of their limits for themselves.
        if seeds.len() > 1 && job.request.behaves && !pupil.is_alone.load(Ordering::Relaxed) {
            match self.run_together(pupil, lab, seeds) {
                Ok(outcomes) => return outcomes.into_iter().map(Ok).collect(),
                Err(_) => pupil.is_alone.store(true, Ordering::Relaxed),
            }
        }
        seeds.iter().map(|&seed| self.run_alone(job, pupil, lab, seed)).collect()
    }

    fn run_alone(&self, job: &Job, pupil: &Pupil, lab: &Lab, seed: u64) -> Result<RunOutcome, String> {
        if pupil.has_failed.load(Ordering::Relaxed) {
            return Err(String::new());
        }
        let made = self.try_run(job, pupil, lab, seed).map_err(|fault| format!("seed {seed}: {fault}"));
        if made.is_err() {
            pupil.has_failed.store(true, Ordering::Relaxed);
        }
        made
    }

    fn start(&self, pupil: &Pupil, runs: u64) -> Result<ProgramProcess, String> {
        let command = self.sandbox.command(&pupil.language, MEMORY_MB, PROCESSOR_S * runs)?;
        ProgramProcess::start(command, MEMORY_MB, Arc::clone(&self.end))
    }

    /// Runs of a behaviour in one process, which takes a question for each at a time.
    fn run_together(&self, pupil: &Pupil, lab: &Lab, seeds: &[u64]) -> Result<Vec<RunOutcome>, String> {
        let mut process = self.start(pupil, seeds.len() as u64)?;
        if greet(&mut process, &RobotFacts::of(&lab.prepared().robot), seeds, &mut Prints::new())?
            != Ready::DrivesFramed
        {
            return Err("it takes no frames".to_owned());
        }
        let mut runs: Vec<ProgramRun> = seeds.iter().map(|&seed| ProgramRun::new(lab, seed)).collect();
        let mut prints = vec![Prints::new(); seeds.len()];
        drive_framed(&mut process, &mut runs, &mut prints).map_err(|(_, fault)| fault)?;
        Ok(runs.into_iter().map(ProgramRun::outcome).collect())
    }

    fn try_run(&self, job: &Job, pupil: &Pupil, lab: &Lab, seed: u64) -> Result<RunOutcome, String> {
        let mut process = self.start(pupil, 1)?;
        let request = &job.request;
        let mut prints = Prints::new();
        // A plan is the same for all seeds.
        let seed_of_program = if request.behaves { seed } else { request.plan_seed };
        let ready = greet(&mut process, &RobotFacts::of(&lab.prepared().robot), &[seed_of_program], &mut prints)?;
        match (ready, request.behaves) {
            (Ready::Plans, false) => {
                let room = ProgramRoom::of(&lab.prepared().job, request.cell_size()?);
                let cells = plan(&mut process, &room, &mut prints)?;
                lab.follow(&[seed], cells)?.pop().ok_or_else(|| "there is no run".to_owned())
            }
            (Ready::Plans, true) => Err("the program is a planner, but the answer names a behaviour".to_owned()),
            (_, false) => Err("the program is a behaviour, but the answer names a planner".to_owned()),
            (ready, true) => {
                let mut run = ProgramRun::new(lab, seed);
                if ready == Ready::DrivesFramed {
                    let driven = drive_framed(&mut process, slice::from_mut(&mut run), slice::from_mut(&mut prints));
                    driven.map_err(|(_, fault)| fault)?;
                } else {
                    drive(&mut process, &mut run, &mut prints)?;
                }
                Ok(run.outcome())
            }
        }
    }
}
