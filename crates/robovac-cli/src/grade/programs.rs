//! Runs of learners' programs: strangers', so they run within walls.

use crate::{
    failure::Failure,
    run::{Language, ProgramProcess, Walls, drive, greet, plan},
};
use robovac_core::program::Program;
use robovac_lessons::Job;
use robovac_sim::{
    STEP_S,
    montecarlo::{Lab, RunOutcome},
    program::{Lockstep, ProgramRoom},
};
use std::sync::{
    Arc,
    atomic::{AtomicBool, Ordering},
};

/// Memory of a program, MB, and its processor time in a run, s.
const MEMORY_MB: u64 = 1024;
const PROCESSOR_S: u64 = 60;

/// A program, ready to be run with any seed.
pub struct Pupil {
    language: Language,
    has_failed: AtomicBool,
}

/// Makes the runs of programs.
pub struct Programs {
    walls: Walls,
    end: Arc<AtomicBool>,
}

impl Programs {
    /// Within walls, or if the user says so without. They end when `end` becomes true.
    pub fn new(is_unconfined: bool, end: Arc<AtomicBool>) -> Result<Self, Failure> {
        let walls = if is_unconfined {
            Walls::limits_only()
        } else {
            Walls::probe().map_err(|why| {
                Failure::system(format!(
                    "the answers have programs, and these can't be kept from your files and the network here: {why}. On a computer \
                     that may be lost, such as one in a cloud, --unconfined runs them without"
                ))
            })?
        };
        Ok(Self { walls, end })
    }

    /// How they are run, in words.
    pub fn words(&self) -> &'static str {
        self.walls.words()
    }

    /// Gets the program of a job ready. Errors are for users.
    pub fn pupil(job: &Job) -> Result<Pupil, String> {
        let Program { language, source, .. } =
            job.program.as_ref().ok_or("the answer says that a program drives, and has none")?;
        let language = Language::of_text(*language, source).map_err(|error| error.to_string())?;
        Ok(Pupil { language, has_failed: AtomicBool::new(false) })
    }

    /// A run; after one that has failed, none of that pupil's. Errors are for users.
    pub fn run(&self, job: &Job, pupil: &Pupil, lab: &Lab, seed: u64) -> Result<RunOutcome, String> {
        if pupil.has_failed.load(Ordering::Relaxed) {
            return Err(String::new());
        }
        let made = self.try_run(job, pupil, lab, seed).map_err(|fault| format!("seed {seed}: {fault}"));
        if made.is_err() {
            pupil.has_failed.store(true, Ordering::Relaxed);
        }
        made
    }

    fn try_run(&self, job: &Job, pupil: &Pupil, lab: &Lab, seed: u64) -> Result<RunOutcome, String> {
        let command = self.walls.command(&pupil.language, MEMORY_MB, PROCESSOR_S)?;
        let mut process = ProgramProcess::start(command, MEMORY_MB, Arc::clone(&self.end))?;
        let request = &job.request;
        let mut prints = Vec::new();
        let mut lockstep = Lockstep::new(lab.prepared(), lab.terms().conditions, seed, Vec::new());
        // A plan is the same for all seeds.
        let seed_of_program = if request.behaves { seed } else { request.plan_seed };
        let drives = greet(&mut process, &lockstep.facts(), seed_of_program)?;
        match (drives, request.behaves) {
            (true, true) => {
                let steps = (request.duration_s / STEP_S).round() as u64;
                drive(&mut process, &mut lockstep, steps, &mut prints)?;
                Ok(lab.repeat(lockstep.log(), seed))
            }
            (false, false) => {
                let room = ProgramRoom::of(&lab.prepared().job, request.cell_size()?);
                let cells = plan(&mut process, &room, &mut prints)?;
                lab.follow(&[seed], cells)?.pop().ok_or_else(|| "there is no run".to_owned())
            }
            (true, false) => Err("the program drives, and the answer says that it plans".to_owned()),
            (false, true) => Err("the program plans, and the answer says that it drives".to_owned()),
        }
    }
}
