//! A run that a user's program drives and that is measured meanwhile.

use super::{Lab, OutcomeMeter, RunOutcome};
use crate::{
    Run,
    program::{Lockstep, LogEnd},
};
use robovac_core::robot::RobotModel;

/// A run of a program in a [`Lab`], for as long as its terms say. Its result is that of [`Lab::repeat`], without a second
/// simulation.
pub struct ProgramRun {
    lockstep: Lockstep,
    meter: OutcomeMeter,
    robot: RobotModel,
    seed: u64,
}

impl ProgramRun {
    /// A robot at the start.
    pub fn new(lab: &Lab, seed: u64) -> Self {
        let lockstep = Lockstep::new(lab.prepared(), lab.terms().conditions, seed, Vec::new());
        let meter = OutcomeMeter::new(lockstep.run(), lockstep.run().coverage(), lab.terms().duration_s);
        Self { lockstep, meter, robot: lab.prepared().robot.clone(), seed }
    }

    /// The simulation.
    pub fn lockstep(&self) -> &Lockstep {
        &self.lockstep
    }

    /// Whether its time is over.
    pub fn is_over(&self) -> bool {
        self.meter.is_full()
    }

    /// Drives as [`Lockstep::hold`] does, within the time. Returns the number of steps taken; 0 once the run is over.
    pub fn hold(&mut self, wheels_mm_s: [f64; 2], most: u32) -> u32 {
        let Self { lockstep, meter, .. } = self;
        let most = u64::from(most).min(meter.left()) as u32;
        lockstep.hold(wheels_mm_s, most, |run| Self::note(meter, run))
    }

    /// Ends the program: the robot brakes until it is at rest.
    pub fn finish(&mut self, end: LogEnd) {
        let Self { lockstep, meter, .. } = self;
        lockstep.finish_within(end, meter.left(), |run| Self::note(meter, run));
    }

    fn note(meter: &mut OutcomeMeter, run: &Run) {
        meter.note(run, run.coverage());
    }

    /// The result.
    pub fn outcome(self) -> RunOutcome {
        self.meter.outcome(self.lockstep.run(), &self.robot, self.seed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Conditions, Noise, NoiseLevel, SlipLevel, montecarlo::Terms};
    use robovac_core::{
        floor_plan::room,
        robot::{OdometryModel, model},
    };

    /// Drives straight and turns a little after a bump, in motions of many steps, until `done`.
    fn drive(lab: &Lab, done: u64) -> ProgramRun {
        let mut run = ProgramRun::new(lab, 5);
        while !run.is_over() {
            if run.lockstep().run().steps() >= done {
                run.finish(LogEnd::Done);
                break;
            }
            let is_blocked = run.lockstep().run().sensors().bumped();
            if run.hold(if is_blocked { [-100.0, 100.0] } else { [300.0, 280.0] }, 40) == 0 {
                break;
            }
        }
        run
    }

    #[test]
    fn a_measured_run_has_the_numbers_of_its_repetition() {
        let plan = (room("bedroom").unwrap().build)();
        let noise = Noise::all(NoiseLevel::Typical);
        let conditions = Conditions { slip: SlipLevel::Typical, noise, ..Conditions::default() };
        let (odometry, smooth, plan_seed) = (OdometryModel::Arc, false, 1);
        // The last one ends while it brakes.
        for (duration_s, done, robot) in [
            (20.0, u64::MAX, "roomba600"),
            (60.0, 900, "roomba600_lidar"),
            (1.0, u64::MAX, "roomba600"),
            (15.03, 1000, "roomba600"),
        ] {
            let robot = model(robot).unwrap();
            let terms = Terms { conditions, odometry, smooth, duration_s, plan_seed };
            let lab = Lab::new(&plan, robot, robot.default_cell, None, terms).unwrap();
            let run = drive(&lab, done);
            let log = run.lockstep().log();
            assert_eq!(run.outcome(), lab.repeat(log, 5), "{duration_s} s");
        }
    }
}
