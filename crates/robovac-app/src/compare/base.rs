//! The settings that comparisons take from the session.

use super::{RaceSetup, RoomChoice};
use crate::{
    ScenarioChoices,
    explore::{ProgramJob, Session, SessionSnapshot},
};
use robovac_core::{
    coverage::PlanningCells,
    floor_plan::{FloorPlan, Scenario},
    geometry::Pose,
    program::Program,
    robot::CustomRobot,
};
use robovac_sim::experiment::planning::RoomSetup;
use std::sync::Arc;

/// The session's room, robot, start and seed at one moment.
pub(super) struct ComparisonBase {
    pub plan: Arc<FloorPlan>,
    /// Name of the room.
    pub title: String,
    room: Option<&'static str>,
    pub prepared: Option<RoomSetup>,
    start: Option<Pose>,
    pub robot: &'static str,
    /// Name of the robot in exports.
    pub robot_name: String,
    pub custom: Option<CustomRobot>,
    pub cells: PlanningCells,
    pub seed: u64,
    pub setup: RaceSetup,
    /// The user's program.
    pub program: Option<Arc<Program>>,
    /// Snapshot of the session.
    snapshot: SessionSnapshot,
}

/// Initial speed of a race, times real time: cleaning a flat takes most of an hour.
pub(super) const SPEED: f64 = 64.0;

/// Prefix of the names of rooms that aren't built in.
pub(super) const OWN: &str = "own";

impl ComparisonBase {
    /// The session's settings; races run at `speed`.
    pub fn of(session: &Session, speed: f64) -> Self {
        let settings = session.settings();
        Self {
            plan: Arc::clone(session.plan()),
            title: session.room_title(),
            room: session.room(),
            prepared: session.planning_room(),
            start: session.start(),
            robot: settings.robot,
            robot_name: settings.robot_name(),
            custom: settings.custom.clone(),
            cells: settings.cells(),
            seed: settings.seed,
            setup: RaceSetup {
                conditions: settings.conditions,
                odometry: settings.odometry,
                smooth: settings.smooth,
                seed: settings.seed,
                speed,
            },
            program: settings.program().cloned(),
            snapshot: session.snapshot(),
        }
    }

    /// Whether the session is unchanged.
    pub fn is_of(&self, session: &Session) -> bool {
        self.snapshot == session.snapshot() && self.program.as_ref() == session.settings().program()
    }

    /// The job of the user's program in a room, with that seed.
    pub fn job_in(&self, room: RoomChoice, seed: u64) -> ProgramJob {
        let (shipped, own) = match room {
            RoomChoice::Shipped(id) => (Some(id.to_owned()), None),
            RoomChoice::Own => (None, Some(Scenario::of(&self.plan))),
        };
        let choices = ScenarioChoices { seed: Some(seed.to_string()), program: None, ..self.snapshot.choices.clone() };
        let place =
            SessionSnapshot { room: shipped, own, start: self.start_in(room), choices, ..self.snapshot.clone() };
        ProgramJob { place, inputs: Vec::new(), version: 0 }
    }

    /// The session's room.
    pub fn here(&self) -> RoomChoice {
        self.room.map_or(RoomChoice::Own, RoomChoice::Shipped)
    }

    /// The start if it differs from the room's: x, y in metres, heading in radians.
    pub fn start_in(&self, room: RoomChoice) -> Option<[f64; 3]> {
        self.start.filter(|_| room == self.here()).map(|s| [s.x, s.y, s.heading])
    }

    /// Key of room, start, robot and cells.
    pub fn place(&self, room: RoomChoice) -> String {
        let start = self.start_in(room);
        let room = match room {
            RoomChoice::Shipped(id) => id.to_owned(),
            RoomChoice::Own => format!("{OWN}{}", self.snapshot.room_version),
        };
        let custom = self.custom.as_ref().map(|custom| format!(" {}:{custom}", custom.key())).unwrap_or_default();
        let smooth = if self.setup.smooth { " smooth" } else { "" };
        let PlanningCells { size, offset } = self.cells;
        format!("{room} {start:?} {} {size} {offset:?}{custom}{smooth}", self.robot)
    }
}
