//! A user's program that drives the mapping robot: in a sandbox, from which its log comes.

use super::{MapSession, base::MapBase};
use crate::{
    ScenarioChoices,
    explore::{ProgramJob, Session},
    export::RunBag,
};
use robovac_core::program::{Program, ProgramKind};
use robovac_sim::{Input, program::LogError};
use serde::Serialize;
use std::sync::Arc;

/// Name of the program's mark in links.
pub(super) const MARK: &str = "program";

/// The program that is chosen as method.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct MapProgramView {
    /// Its name; empty while there is none.
    pub name: String,
    /// Changes when it has to be run again: from the start, or from a person's last input on.
    pub version: u32,
    /// Steps for which its commands are known.
    pub reach_steps: u32,
    /// Whether it drives: the robot fits in, and doesn't clean by its map.
    pub drives: bool,
    /// Which program of a link is missing, as sentences for users; empty if none is.
    pub missing: String,
}

/// The program that a link was made with.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct ProgramMark {
    fingerprint: u64,
    name: String,
}

impl ProgramMark {
    /// The mark of a program.
    pub fn of(program: &Program) -> Self {
        Self { fingerprint: program.fingerprint(), name: program.name.clone() }
    }

    /// For links: letters and digits stay, all else is in hexadecimal.
    pub fn to_text(&self) -> String {
        let letter = |byte: u8| {
            let is_plain = byte.is_ascii_alphanumeric();
            if is_plain { char::from(byte).to_string() } else { format!("%{byte:02X}") }
        };
        format!("{:016x}.{}", self.fingerprint, self.name.bytes().map(letter).collect::<String>())
    }

    /// The inverse of [`ProgramMark::to_text`]; `None` for other texts.
    pub fn from_text(text: &str) -> Option<Self> {
        let (fingerprint, name) = text.split_once('.')?;
        let mut bytes = name.bytes();
        let mut plain = Vec::new();
        while let Some(byte) = bytes.next() {
            let is_plain = byte != b'%';
            plain.push(if is_plain { byte } else { hexadecimal([bytes.next()?, bytes.next()?])? });
        }
        Some(Self { fingerprint: u64::from_str_radix(fingerprint, 16).ok()?, name: String::from_utf8(plain).ok()? })
    }
}

fn hexadecimal(digits: [u8; 2]) -> Option<u8> {
    u8::from_str_radix(std::str::from_utf8(&digits).ok()?, 16).ok()
}

impl MapBase {
    /// The user's program, if it drives.
    pub fn driver(&self) -> Option<&Arc<Program>> {
        self.program.as_ref().filter(|program| program.kind == ProgramKind::Behaviour)
    }
}

impl MapSession {
    /// The chosen program, if it is there and drives.
    fn driver(&self) -> Option<&Arc<Program>> {
        self.base.as_ref()?.driver().filter(|_| self.setup.is_program())
    }

    /// Its name.
    pub(super) fn driver_name(&self) -> Option<String> {
        self.driver().map(|program| program.name.clone())
    }

    /// The program's part of the recipe; empty for other methods.
    pub(super) fn program_recipe(&self) -> String {
        if !self.setup.is_program() {
            return String::new();
        }
        self.driver().map_or(" program=none".to_owned(), |program| format!(" program={:016x}", program.fingerprint()))
    }

    /// The choices as the part of a link after the session's, with the mark of the program.
    pub fn link(&self) -> String {
        let mark =
            self.driver().map_or(String::new(), |program| format!("&{MARK}={}", ProgramMark::of(program).to_text()));
        self.setup.to_link() + &mark
    }

    /// Whether a program drives at the displayed time.
    pub(super) fn program_drives(&self) -> bool {
        self.driver().is_some()
            && self.stage.as_ref().is_some_and(|stage| {
                let now = stage.run().steps();
                !stage.recording.inputs().iter().any(|(step, input)| *step <= now && matches!(input, Input::Clean(_)))
            })
    }

    /// What the program needs to drive a simulation of its own, with `session` as it was taken last; `None` unless one
    /// drives.
    pub fn program_job(&self, session: &Session) -> Option<ProgramJob> {
        let (base, stage) = (self.base.as_ref()?, self.stage.as_ref()?);
        self.driver()?;
        let mut settings = session.settings().clone();
        settings.conditions = self.setup.conditions(base.conditions);
        let ScenarioChoices { slip, noise, .. } = ScenarioChoices::of_settings(&settings);
        let mut job = session.job_beside(ProgramKind::Behaviour)?;
        (job.place.choices.slip, job.place.choices.noise) = (slip, noise);
        // From then on, the robot drives by its map.
        let inputs = stage.recording.inputs();
        let own = inputs.iter().position(|(_, input)| matches!(input, Input::Clean(_))).unwrap_or(inputs.len());
        Some(ProgramJob { inputs: RunBag::inputs_to_numbers(&inputs[..own]), version: self.program.version, ..job })
    }

    /// Takes a part of the log of the program of that [version](MapProgramView::version); of an older one, it is left out
    /// and the result is false.
    pub fn extend_program(&mut self, version: u32, part: &[u8]) -> Result<bool, LogError> {
        let Some(stage) = self.stage.as_ref().filter(|_| self.setup.is_program()) else { return Ok(false) };
        // What the robot drives by its map isn't in the log.
        let shown = if self.program_drives() { stage.recording.end_steps() } else { 0 };
        self.program.extend(version, shown, part)
    }

    /// The program of that version is heard no more: it has failed, and the robot stops where its log ends.
    pub fn fail_program(&mut self, version: u32) {
        self.program.fail(version);
    }

    /// [Version](MapProgramView::version) of the program's run.
    pub fn program_version(&self) -> u32 {
        self.program.version
    }

    /// The whole log of the program, as bytes; `None` unless one is the method.
    pub fn program_log(&self) -> Option<Vec<u8>> {
        self.driver().map(|_| self.program.log.get().to_bytes())
    }

    /// The program in the view.
    pub(super) fn program_view(&self) -> Option<MapProgramView> {
        self.setup.is_program().then(|| MapProgramView {
            name: self.driver_name().unwrap_or_default(),
            version: self.program.version,
            reach_steps: self.program.log.get().until(),
            drives: self.program_drives(),
            missing: self.missing_program().unwrap_or_default(),
        })
    }

    /// Which program of a link is missing.
    fn missing_program(&self) -> Option<String> {
        let asked = self.asked.as_ref()?;
        let here = self.driver()?;
        if asked.fingerprint == here.fingerprint() {
            return None;
        }
        Some(if asked.name == here.name {
            format!("The link was made with another version of “{}”: this run differs from the one shared.", here.name)
        } else {
            format!(
                "The link was made with the program “{}”, which isn't here, so “{}” drives. Open “{}” in the tab \
                 Program, or ask for a link made with Copy link: it contains the program.",
                asked.name, here.name, asked.name
            )
        })
    }

    /// Why the chosen program can't drive, as a sentence for users.
    pub(super) fn program_complaint(&self) -> Option<String> {
        let program = self.base.as_ref()?.program.as_ref().filter(|_| self.setup.is_program())?;
        (program.kind == ProgramKind::Planner).then(|| {
            format!(
                "“{}” plans but doesn't drive: run a program with step or run in the tab Program, or choose another \
                 method.",
                program.name
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::{MapAction, MapPhase, StoreError};
    use robovac_core::{geometry::Pose, program::ProgramLanguage};
    use robovac_sim::program::{Lockstep, LogEnd};

    /// Explore with the same conditions as Map.
    const LINK: &str = "room=bedroom&slip=typical&noise=typical&seed=5&start=1.2,1.3,40&behaviour=bounce";

    fn program(name: &str) -> Program {
        Program {
            name: name.into(),
            language: ProgramLanguage::Python,
            kind: ProgramKind::Behaviour,
            source: format!("def step(robot): pass # {name}"),
        }
    }

    /// Explore, which keeps a program, and Map with it as method.
    fn both() -> (Session, MapSession) {
        let mut session = Session::new();
        session.restore(LINK).unwrap();
        session.set_program(program("Näher & näher"), false).unwrap();
        let mut mapping = MapSession::new();
        mapping.take(&session);
        mapping.set("explorer", "program").unwrap();
        (session, mapping)
    }

    fn lockstep(job: &ProgramJob) -> Lockstep {
        let job = ProgramJob::from_bytes(&job.to_bytes()).unwrap().lay_out().unwrap();
        Lockstep::new(&job.room, job.conditions, job.seed, job.inputs)
    }

    /// A program that drives straight, and turns for a while when it bumps or is in the air.
    fn drive(lockstep: &mut Lockstep, until: u64) {
        while lockstep.run().steps() < until {
            let sensed = lockstep.run().sensors();
            let is_startled = sensed.bumped() || sensed.wheel_drop_left || sensed.light_signal[2] > 700;
            if lockstep
                .steps(if is_startled { [-120.0, 100.0] } else { [280.0, 300.0] }, if is_startled { 40 } else { 1 })
                == 0
            {
                break;
            }
        }
    }

    fn version(mapping: &MapSession) -> u32 {
        mapping.view().program.unwrap().version
    }

    fn state(mapping: &MapSession) -> (u64, u64) {
        let run = mapping.run().unwrap();
        (run.steps(), run.digest())
    }

    #[test]
    fn a_program_maps_and_drives_as_it_does_in_explore() {
        let (mut session, mut mapping) = both();
        assert_eq!((mapping.phase(), mapping.view().activity), (MapPhase::Ready, "waiting for the program"));
        mapping.run_ahead(5.0);
        assert_eq!(mapping.run().unwrap().steps(), 0, "nothing was commanded yet");
        let mut sandbox = lockstep(&mapping.program_job(&session).unwrap());
        drive(&mut sandbox, 3000);
        assert!(mapping.extend_program(version(&mapping), &sandbox.log_bytes(0)).unwrap());
        mapping.run_ahead(1e4);
        assert_eq!(state(&mapping), (sandbox.run().steps(), sandbox.digest()));
        let view = mapping.view();
        assert!(view.figures.unwrap().boundary > 0.05 && view.program.unwrap().drives, "{:?}", view.figures);
        // Explore, with the program chosen.
        session.set_program(program("Näher & näher"), true).unwrap();
        assert!(session.extend_program(session.program_version(), &sandbox.log_bytes(0)).unwrap());
        session.run_ahead(1e4);
        assert_eq!(session.recording().unwrap().run().digest(), sandbox.digest());
    }

    #[test]
    fn a_program_feels_that_it_is_carried_and_goes_on_from_there() {
        let (session, mut mapping) = both();
        let mut sandbox = lockstep(&mapping.program_job(&session).unwrap());
        drive(&mut sandbox, 2000);
        mapping.extend_program(version(&mapping), &sandbox.log_bytes(0)).unwrap();
        mapping.run_ahead(1e4);
        mapping.seek(15.0);
        mapping.frame(0.0, &mut || true);
        assert_eq!((mapping.run().unwrap().steps(), mapping.phase()), (1000, MapPhase::Paused));
        let before = version(&mapping);
        mapping.lift();
        assert_ne!(version(&mapping), before);
        assert!(!mapping.extend_program(before, &sandbox.log_bytes(0)).unwrap(), "it knows nothing of the lifting");
        // It is put down before the sandbox knows that it was lifted, and stays in the air until then.
        mapping.put_down(Pose::new(1.5, 1.0, 2.0));
        assert!(mapping.phase() == MapPhase::Seeking && !mapping.can(MapAction::PutDown));
        let mut sandbox = lockstep(&mapping.program_job(&session).unwrap());
        drive(&mut sandbox, 1500);
        mapping.extend_program(version(&mapping), &sandbox.log_bytes(1000)).unwrap();
        mapping.frame(0.0, &mut || true);
        assert_eq!((mapping.run().unwrap().steps(), mapping.phase()), (1040, MapPhase::Paused));
        // Now it is put down, and runs again from there.
        let mut sandbox = lockstep(&mapping.program_job(&session).unwrap());
        drive(&mut sandbox, 2500);
        sandbox.finish(LogEnd::Done);
        mapping.extend_program(version(&mapping), &sandbox.log_bytes(1040)).unwrap();
        mapping.run_ahead(1e4);
        assert_eq!((state(&mapping), mapping.phase()), ((sandbox.run().steps(), sandbox.digest()), MapPhase::Finished));
        // Back and forth through key frames.
        mapping.seek(20.0);
        mapping.seek(1e9);
        mapping.frame(0.0, &mut || true);
        assert_eq!(mapping.run().unwrap().digest(), sandbox.digest());
        // By its map, it needs no program.
        mapping.clean();
        mapping.run_ahead(3.0);
        assert!(!mapping.view().program.unwrap().drives && mapping.run().unwrap().steps() > sandbox.run().steps());
        let now = version(&mapping);
        mapping.lift();
        assert_eq!((version(&mapping), mapping.program_job(&session).unwrap().inputs.len()), (now, 10));
    }

    #[test]
    fn a_stored_run_is_repeated_by_its_program_and_says_when_that_is_missing() {
        let (mut session, mut mapping) = both();
        let mut sandbox = lockstep(&mapping.program_job(&session).unwrap());
        drive(&mut sandbox, 1500);
        mapping.extend_program(version(&mapping), &sandbox.log_bytes(0)).unwrap();
        mapping.run_ahead(1e4);
        let (stored, link) = (mapping.store().unwrap(), mapping.link());
        let mut other = MapSession::new();
        other.take(&session);
        other.restore(&link).unwrap();
        assert_eq!((other.link(), other.recipe()), (link.clone(), mapping.recipe()));
        other.resume(&stored).unwrap();
        other.frame(0.0, &mut || true);
        assert_eq!(other.phase(), MapPhase::Resuming, "the program runs first");
        other.extend_program(version(&other), &sandbox.log_bytes(0)).unwrap();
        while other.phase() == MapPhase::Resuming {
            other.frame(0.0, &mut || true);
        }
        assert_eq!((state(&other), other.take_strayed()), (state(&mapping), false));
        // One that fails this time leaves the stored map, and says so.
        other.resume(&stored).unwrap();
        other.fail_program(version(&other));
        while other.phase() == MapPhase::Resuming {
            other.frame(0.0, &mut || true);
        }
        assert!(other.take_strayed());
        // Elsewhere there is another program.
        session.set_program(program("Far"), false).unwrap();
        let mut elsewhere = MapSession::new();
        elsewhere.take(&session);
        elsewhere.restore(&link).unwrap();
        assert_ne!(elsewhere.recipe(), mapping.recipe());
        let missing = elsewhere.view().program.unwrap().missing;
        assert!(missing.contains("“Näher & näher”, which isn't here, so “Far” drives"), "{missing}");
        assert_eq!(elsewhere.resume(&stored), Err(StoreError::Program { name: "Näher & näher".into() }));
        // Another one is run on purpose.
        session.set_program(program("Farther"), false).unwrap();
        elsewhere.take(&session);
        assert_eq!(elsewhere.view().program.unwrap().missing, "");
        let mut planner = program("Rows");
        planner.kind = ProgramKind::Planner;
        session.set_program(planner, false).unwrap();
        elsewhere.take(&session);
        assert!(
            elsewhere.phase() == MapPhase::Failed && elsewhere.complaint().contains("“Rows” plans but doesn't drive")
        );
    }
}
