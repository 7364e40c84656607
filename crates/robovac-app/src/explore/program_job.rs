//! What a program needs to drive a simulation of its own: the job that the page hands to its sandbox.

use super::{FollowError, Session, SessionSnapshot};
use crate::export::RunBag;
use robovac_core::{program::ProgramKind, robot::OdometryModel};
use robovac_sim::{
    Conditions, Input,
    experiment::{RoomSetup, Settings},
};
use serde::{Deserialize, Serialize};

/// Room, robot, conditions, seed, and a person's inputs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ProgramJob {
    /// Room and settings. The session's algorithm doesn't matter.
    pub place: SessionSnapshot,
    /// A person's inputs, as [`RunBag::inputs_to_numbers`] writes them.
    pub inputs: Vec<f64>,
    /// [Version](super::ProgramView::version) of the run that waits for it.
    pub version: u32,
}

/// A job laid out.
#[derive(Debug, Clone)]
pub struct LaidOutJob {
    /// The room.
    pub room: RoomSetup,
    /// Slip, noise and battery.
    pub conditions: Conditions,
    /// Seed of everything random.
    pub seed: u64,
    /// Side of the planning cells, m.
    pub cell_size: f64,
    /// How followers of plans compute their poses.
    pub odometry: OdometryModel,
    /// Whether corners of plans are rounded.
    pub smooth: bool,
    /// A person's inputs, with the number of steps before each.
    pub inputs: Vec<(u64, Input)>,
}

/// Reasons why a job can't be done.
#[derive(Debug, thiserror::Error)]
pub enum JobError {
    /// The bytes aren't one.
    #[error("this isn't the job of a program: {0}")]
    Unreadable(#[from] serde_json::Error),
    /// The room or a choice.
    #[error(transparent)]
    Place(#[from] FollowError),
}

impl ProgramJob {
    /// The job as bytes.
    pub fn to_bytes(&self) -> Vec<u8> {
        // Strings, numbers and lists can always be serialised.
        serde_json::to_vec(self).unwrap_or_default()
    }

    /// The inverse of [`ProgramJob::to_bytes`].
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, JobError> {
        Ok(serde_json::from_slice(bytes)?)
    }

    /// A person's inputs, with the number of steps before each.
    pub fn inputs(&self) -> Vec<(u64, Input)> {
        RunBag::inputs_from_numbers(&self.inputs)
    }

    /// The room laid out for the robot.
    pub fn lay_out(&self) -> Result<LaidOutJob, JobError> {
        let (room, settings) = self.place.lay_out_for_program()?;
        let Settings { conditions, seed, cell_size, odometry, smooth, .. } = settings;
        Ok(LaidOutJob { room, conditions, seed, cell_size, odometry, smooth, inputs: self.inputs() })
    }
}

impl Session {
    /// The job of a run beside this one, without a person's inputs; `None` without a program of that kind.
    pub(crate) fn job_beside(&self, kind: ProgramKind) -> Option<ProgramJob> {
        self.settings().program().filter(|program| program.kind == kind)?;
        let mut place = self.whole_snapshot();
        place.choices.program = None;
        Some(ProgramJob { place, inputs: Vec::new(), version: 0 })
    }

    /// The job of the user's program: for the run that waits for it, or to try it beside another algorithm.
    pub fn program_job(&self) -> ProgramJob {
        let mut place = self.whole_snapshot();
        // The sandbox has the program already.
        place.choices.program = None;
        let inputs = self.recording().filter(|_| self.program_drives()).map_or(&[][..], |r| r.inputs());
        ProgramJob { place, inputs: RunBag::inputs_to_numbers(inputs), version: self.program_version() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::{
        geometry::Pose,
        program::{Program, ProgramKind, ProgramLanguage},
    };
    use robovac_sim::program::{Lockstep, LogEnd};

    fn program(kind: ProgramKind) -> Program {
        Program { name: "mine".into(), language: ProgramLanguage::Python, kind, source: "def step(robot): ...".into() }
    }

    /// A program that drives straight, and turns for a while when it bumps.
    fn drive(lockstep: &mut Lockstep, until: u64) {
        while lockstep.run().steps() < until {
            let bumped = lockstep.run().sensors().bumped() || lockstep.run().sensors().light_signal[2] > 700;
            let speeds = if bumped { [-120.0, 100.0] } else { [280.0, 300.0] };
            if lockstep.steps(speeds, if bumped { 40 } else { 1 }) == 0 {
                break;
            }
        }
    }

    fn lockstep(session: &Session) -> Lockstep {
        let job = ProgramJob::from_bytes(&session.program_job().to_bytes()).unwrap().lay_out().unwrap();
        Lockstep::new(&job.room, job.conditions, job.seed, job.inputs)
    }

    fn version(session: &Session) -> u32 {
        session.view().program.unwrap().version
    }

    const LINK: &str = "room=bedroom&slip=typical&noise=typical&seed=5&start=1.2,1.3,40&robot=roomba600_lidar";

    #[test]
    fn page_and_sandbox_are_in_the_same_state_with_a_persons_inputs() {
        let mut session = Session::new();
        session.restore(LINK).unwrap();
        session.set_program(program(ProgramKind::Behaviour), true).unwrap();
        assert!(session.view().program.unwrap().waits, "nothing was commanded yet");
        let mut sandbox = lockstep(&session);
        drive(&mut sandbox, 900);
        let frame = sandbox.frame();
        drive(&mut sandbox, 2000);
        assert!(session.extend_program(version(&session), &sandbox.log_bytes(0)).unwrap());
        session.run_ahead(1e4);
        let run = session.recording().unwrap().run();
        assert_eq!((run.steps(), run.digest()), (sandbox.run().steps(), sandbox.digest()));
        // The robot is carried away at 15 s, which was shown before.
        session.seek(15.0);
        session.frame(0.0, &mut || true);
        assert_eq!(session.recording().unwrap().run().steps(), 1000);
        let before = version(&session);
        session.lift();
        session.put_down(Pose::new(1.5, 1.0, 2.0));
        assert_ne!(version(&session), before);
        assert!(!session.extend_program(before, &sandbox.log_bytes(0)).unwrap(), "it knows nothing of the carrying");
        let job = ProgramJob::from_bytes(&session.program_job().to_bytes()).unwrap().lay_out().unwrap();
        assert_eq!(job.inputs.len(), 2);
        sandbox.restore(&frame);
        sandbox.set_inputs(job.inputs);
        drive(&mut sandbox, 2500);
        sandbox.finish(LogEnd::Done);
        let mut other = lockstep(&session);
        other.steps([-100.0, 100.0], 1200);
        assert!(session.extend_program(version(&session), &other.log_bytes(0)).is_err(), "the past isn't changed");
        assert!(session.extend_program(version(&session), &sandbox.log_bytes(900)).unwrap(), "it may be repeated");
        session.run_ahead(1e4);
        let run = session.recording().unwrap().run();
        assert!(run.is_finished());
        assert_eq!((run.steps(), run.digest()), (sandbox.run().steps(), sandbox.digest()));
        // Scrubbing goes through key frames of the log.
        session.seek(20.0);
        session.seek(1e9);
        session.frame(0.0, &mut || true);
        assert_eq!(session.recording().unwrap().run().digest(), sandbox.digest());
    }

    #[test]
    fn scenario_and_snapshot_carry_the_program_and_links_name_it() {
        for kind in [ProgramKind::Behaviour, ProgramKind::Planner] {
            let mut session = Session::new();
            session.restore("room=bedroom").unwrap();
            session.set_program(program(kind), true).unwrap();
            let mut other = Session::new();
            let file = robovac_core::floor_plan::SourceFile {
                name: "a.json".into(),
                bytes: session.scenario_json().into_bytes(),
            };
            other.load(&[file]).unwrap();
            assert_eq!(other.settings().chosen_program().map(|p| &**p), Some(&program(kind)));
            let mut mirror = Session::new();
            mirror.follow(&session.snapshot()).unwrap();
            assert_eq!(mirror.settings().chosen_program(), session.settings().chosen_program());
            // A link names it; its text is put into the link by the page.
            let mut linked = Session::new();
            let error = linked.restore(&session.link()).unwrap_err();
            assert!(error.to_string().contains("program"), "{error}");
            linked.set_program(program(kind), false).unwrap();
            linked.restore(&session.link()).unwrap();
            assert_eq!(linked.link(), session.link());
        }
    }

    #[test]
    fn a_planners_walk_is_checked_in_words() {
        use coverage_planners::CoveragePath;
        use robovac_core::grid::Cell;
        use robovac_sim::experiment::PlanAnswer;

        let mut session = Session::new();
        session.restore("room=bedroom&robot=cell&cell=0.5").unwrap();
        session.set_program(program(ProgramKind::Planner), true).unwrap();
        let mut tell = |change: &dyn Fn(&mut Vec<Cell>)| {
            // Another plan is asked for.
            let seed = session.settings().seed + 1;
            session.configure(|settings| settings.set_seed(Some(seed), "")).unwrap();
            let request = session.take_plan_request().unwrap();
            let planner = coverage_planners::find("boustrophedon").unwrap();
            let good = robovac_sim::experiment::PlanRequest { planner, ..request.clone() };
            let mut cells = good.serve(|| 0.0, None).unwrap().path.cells;
            change(&mut cells);
            let path = CoveragePath::walk(cells);
            session.plan_finished(request.id, PlanAnswer { path, seconds: 0.0, proof: None, trace: Vec::new() });
            (session.view().message, session.recording().is_some())
        };
        assert_eq!(tell(&|_| ()), (String::new(), true));
        let (text, runs) = tell(&|cells| cells.truncate(3));
        assert!(text.starts_with("The walk misses ") && text.contains(" cells, the first at (") && runs, "{text}");
        let (text, runs) = tell(&|cells| {
            cells.remove(2);
        });
        assert!(text.starts_with("The program's plan can't be driven: step 2 jumps from (") && !runs, "{text}");
    }
}
