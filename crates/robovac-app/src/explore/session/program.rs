//! A user's program in a session: its log, and where the run waits for it.

use super::{Session, sentence};
use crate::explore::view::ProgramView;
use coverage_planners::CoveragePath;
use robovac_core::program::Program;
use robovac_sim::{
    Run, RunRecording,
    experiment::{RoomSetup, SettingsError},
    program::{LogEnd, LogError, Logged, MissedCells, check_walk},
};

impl Session {
    /// Keeps a user's program and chooses it, or keeps it only. Changes nothing if it isn't accepted.
    pub fn set_program(&mut self, program: Program, is_chosen: bool) -> Result<(), SettingsError> {
        if is_chosen {
            return self.configure(|settings| settings.set_program(program));
        }
        let mut settings = self.settings.clone();
        settings.keep_program(program)?;
        let is_other = !settings.plans_like(&self.settings);
        self.settings = settings;
        if is_other {
            self.message = None;
            self.prepare();
        }
        Ok(())
    }

    /// [Version](ProgramView::version) of the program's run.
    pub fn program_version(&self) -> u32 {
        self.program.version
    }

    /// Whether a user's program drives the run.
    pub fn program_drives(&self) -> bool {
        self.settings.path.is_none()
            && self.settings.algorithm.is_program()
            && self.settings.algorithm.behaviour().is_some()
    }

    /// Takes a part of the log of the program with that [version](ProgramView::version); of an older one, it is left out
    /// and the result is false.
    pub fn extend_program(&mut self, version: u32, part: &[u8]) -> Result<bool, LogError> {
        if !self.program_drives() {
            return Ok(false);
        }
        let shown = self.recording.as_ref().map_or(0, RunRecording::end_steps);
        self.program.extend(version, shown, part)
    }

    /// The whole log of the program, as bytes; `None` unless one drives.
    pub fn program_log(&self) -> Option<Vec<u8>> {
        self.program_drives().then(|| self.program.log.get().to_bytes())
    }

    /// The run of a program from the start.
    pub(super) fn program_run(&self, prepared: &RoomSetup) -> Run {
        let setup = prepared.setup(self.settings.conditions, self.settings.seed);
        Run::new(&setup, Box::new(Logged::new(self.program.log.clone())))
    }

    /// The program in the view, if it is chosen.
    pub(super) fn program_view(&self) -> Option<ProgramView> {
        let program = self.settings.chosen_program()?;
        let log = self.program.log.get();
        Some(ProgramView {
            name: program.name.clone(),
            language: program.language,
            kind: program.kind,
            version: self.program.version,
            reach_steps: self.program_drives().then(|| log.until()),
            end: log.end().map(|end| match end {
                LogEnd::Done => "done",
                LogEnd::Failed => "failed",
            }),
            waits: self.recording.as_ref().is_some_and(|recording| recording.run().waits() && !recording.is_over()),
            input: self.recording.as_ref().and_then(|r| r.inputs().last()).map(|&(step, _)| step),
        })
    }

    /// Checks the walk of a user's planner; errors are told, and whether it can be driven is returned.
    pub(super) fn program_plans(
        &mut self,
        prepared: &RoomSetup,
        path: &CoveragePath,
    ) -> Result<Option<MissedCells>, ()> {
        check_walk(&prepared.job, &path.cells).map_err(|fault| {
            self.say("error", format!("The program's plan can't be driven: {fault}."));
        })
    }

    /// Tells which cells the walk of a user's planner misses.
    pub(super) fn tell_missed(&mut self, missed: Option<MissedCells>) {
        if let Some(missed) = missed {
            self.say("notice", sentence(&format!("{missed} (column and row, counted from 0 at the lower left)")));
        }
    }
}
