//! Room and settings of a session, for the other tabs.

use super::{Session, session::known_room};
use crate::{ScenarioChoices, ScenarioError};
use robovac_core::{
    coverage::FloorError,
    cspace::Outline,
    floor_plan::{FloorPlan, MapError, Scenario},
    geometry::Pose,
    program::{Program, ProgramKind},
    robot::model,
};
use robovac_sim::{
    controller::Behaviours,
    experiment::{Algorithm, Settings, SettingsError, planning::RoomSetup},
};
use serde::{Deserialize, Serialize};

/// The model of robots that can be connected.
const CONNECTED: &str = "roomba600";
/// Stands for the path of a session in place of an algorithm.
const PATH: &str = "path";

/// Everything that determines a session's plan and runs. Equal snapshots mean equal sessions.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(default)]
pub struct SessionSnapshot {
    /// Id of the room if it is built in and unchanged.
    pub room: Option<String>,
    /// Changes with every change of the room.
    pub room_version: u64,
    /// An own room, for receivers that don't have this version of it.
    #[cfg_attr(feature = "types", ts(type = "object | null"))]
    pub own: Option<Scenario>,
    /// Start chosen by the user: x, y in m, heading in rad.
    pub start: Option<[f64; 3]>,
    /// Robot, algorithm, seed and conditions; missing ones have their defaults.
    pub choices: ScenarioChoices,
}

/// Reasons why a snapshot can't be followed.
#[derive(Debug, thiserror::Error)]
pub enum FollowError {
    /// No such room.
    #[error(transparent)]
    Room(#[from] SettingsError),
    /// The own room is invalid.
    #[error(transparent)]
    Own(#[from] MapError),
    /// A choice doesn't exist.
    #[error(transparent)]
    Choice(#[from] ScenarioError),
    /// There is no room.
    #[error("there is no room")]
    NoRoom,
    /// The robot can't be placed in the room.
    #[error(transparent)]
    Floor(#[from] FloorError),
}

impl SessionSnapshot {
    /// The room laid out for the robot, as the session has it, and the settings.
    pub fn lay_out(&self) -> Result<(RoomSetup, Settings), FollowError> {
        let settings = self.choices.settings(&Settings::default())?;
        let (plan, _) = self.room()?.ok_or(FollowError::NoRoom)?;
        Ok((RoomSetup::new(&plan, &settings.robot_model(), settings.cells(), self.start())?, settings))
    }

    /// The same for a program's own simulation, whatever algorithm the session has; needs the code of none.
    pub fn lay_out_for_program(&self) -> Result<(RoomSetup, Settings), FollowError> {
        let choices = ScenarioChoices {
            planner: None,
            behaviour: None,
            params: Vec::new(),
            path: None,
            program: None,
            ..self.choices.clone()
        };
        let settings = choices.settings(&Settings::with(Behaviours::NONE))?;
        let (plan, _) = self.room()?.ok_or(FollowError::NoRoom)?;
        Ok((RoomSetup::new(&plan, &settings.robot_model(), settings.cells(), self.start())?, settings))
    }

    /// The room, with its id if it is built in; `None` if the snapshot leaves it out.
    fn room(&self) -> Result<Option<(FloorPlan, Option<&'static str>)>, FollowError> {
        Ok(match (&self.room, &self.own) {
            (Some(id), _) => {
                let room = known_room(id)?;
                Some(((room.build)(), Some(room.id)))
            }
            (None, Some(own)) => Some((own.plan("the room")?, None)),
            (None, None) => None,
        })
    }

    fn start(&self) -> Option<Pose> {
        self.start.map(|[x, y, heading]| Pose::new(x, y, heading))
    }

    /// The same for a connected robot driven by `algorithm`; with default parameters if it is another algorithm.
    pub fn for_connection(mut self, algorithm: &str) -> Result<Self, SettingsError> {
        let choices = &mut self.choices;
        let rides_path = algorithm == PATH;
        choices.path = choices.path.take().filter(|_| rides_path);
        // A connected robot is itself, with its own calibration.
        (choices.twin, choices.own_robot) = (None, None);
        if choices.robot.as_deref() != Some(CONNECTED) {
            // Cell sizes of another robot don't fit this one.
            (choices.robot, choices.cell_size, choices.cell_offset) = (Some(CONNECTED.to_owned()), None, None);
        }
        if choices.algorithm() != Some(algorithm) && !rides_path {
            choices.params.clear();
            let id = Some(algorithm.to_owned());
            let programs = [ProgramKind::Behaviour, ProgramKind::Planner].map(Algorithm::of_program);
            let all = Algorithm::all().chain(programs);
            (choices.planner, choices.behaviour) = match Algorithm::find("algorithm", algorithm, all)? {
                Algorithm::Planner(_) => (id, None),
                Algorithm::Behaviour(_) => (None, id),
            };
        }
        (choices.quantised, choices.start_charge_percent) = (None, None);
        Ok(self)
    }

    /// Why a connected robot can't ride the path of this snapshot, as a sentence for users; `None` if it can, or if there is
    /// none: its body must fit into the one that the path was planned for.
    pub fn path_refusal(&self) -> Option<String> {
        let planned = self.choices.settings(&Settings::default()).map(|settings| settings.robot_model());
        let (planned, connected, _) = (planned.ok()?, model(CONNECTED)?, self.choices.path.as_ref()?);
        let (has, needs) = (planned.body.inner_radius(planned.radius), connected.radius);
        if has >= needs - 1e-9 {
            return None;
        }
        Some(format!(
            "This path was planned for {}, which a Roomba doesn't fit into: it is {:.3} m wide, and would touch. Plan the \
             path for the Roomba, or for an outline that holds a circle of {needs:.3} m radius.",
            Outline::of(&planned),
            2.0 * needs
        ))
    }
}

impl Session {
    /// The settings for other tabs, without an own room: see [`Session::own_room`].
    pub fn snapshot(&self) -> SessionSnapshot {
        let mut choices = ScenarioChoices::of_settings(self.settings());
        // Other tabs offer the program whatever is chosen here.
        choices.program = self.settings().program().map(|program| Program::clone(program));
        SessionSnapshot {
            room: self.room().map(str::to_owned),
            room_version: self.plan_version(),
            own: None,
            start: self.start().map(|start| [start.x, start.y, start.heading]),
            choices,
        }
    }

    /// The same with an own room.
    pub fn whole_snapshot(&self) -> SessionSnapshot {
        let own = self.room().is_none().then(|| self.own_room());
        SessionSnapshot { own, ..self.snapshot() }
    }

    /// Takes over the state of `snapshot`. Changes nothing on an error.
    pub fn follow(&mut self, snapshot: &SessionSnapshot) -> Result<(), FollowError> {
        let settings = snapshot.choices.settings(&self.settings().defaults())?;
        self.replace(settings, snapshot.room()?, snapshot.start());
        Ok(())
    }
}
