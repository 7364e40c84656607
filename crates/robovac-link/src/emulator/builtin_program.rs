//! Built-in programs: Clean, Spot, Max and Seek Dock, using the project's own behaviours.
//!
//! The maker's algorithm isn't published. Here Clean is the cleaning cycle for 45 minutes, followed by the return to
//! the dock if it began there; Spot is the growing spiral for 75 seconds; Max is the random walk until the battery is
//! low; Dock is the return to the dock. The times are ours.

use robovac_core::{
    registry::Params,
    robot::{Drive, RobotModel, RobotPort},
};
use robovac_sim::{
    SimRobot,
    controller::{self, Controller, Setup},
};

/// A program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Chore {
    Clean,
    Spot,
    Max,
    Dock,
}

/// A program in progress.
pub(super) struct BuiltinProgram {
    pub chore: Chore,
    controller: Box<dyn Controller>,
    /// Time left, s.
    left: f64,
    pub is_paused: bool,
    /// Whether the robot returns to its dock afterwards.
    pub goes_home: bool,
}

impl Clone for BuiltinProgram {
    fn clone(&self) -> Self {
        Self { controller: self.controller.boxed_clone(), ..*self }
    }
}

impl BuiltinProgram {
    /// Starts a program; `None` only if its behaviour isn't in the registry.
    pub fn new(chore: Chore, robot: &RobotModel, seed: u64, on_dock: bool) -> Option<Self> {
        let (id, left) = match chore {
            Chore::Clean => ("cleaning_cycle", 45.0 * 60.0),
            Chore::Spot => ("spiral_out", 75.0),
            Chore::Max => ("random_walk", f64::INFINITY),
            Chore::Dock => ("dock", f64::INFINITY),
        };
        let info = controller::find(id)?;
        let params = Params::defaults(info.params);
        let controller = info.build(&Setup { robot, params: &params, seed })?;
        Some(Self { chore, controller, left, is_paused: false, goes_home: on_dock && chore == Chore::Clean })
    }

    /// Whether brushes and vacuum run.
    pub fn cleans(&self) -> bool {
        self.chore != Chore::Dock && !self.is_paused
    }

    /// Drives until the next reading.
    pub fn drive_on(&mut self, robot: &mut SimRobot, dt_s: f64) {
        if self.is_paused {
            return robot.drive(Drive::STOP);
        }
        self.left -= dt_s;
        controller::drive_on(robot, &mut *self.controller, dt_s, |_, _| false);
    }

    /// Whether it is done.
    pub fn is_done(&self) -> bool {
        self.left <= 0.0 || self.controller.is_done()
    }
}
