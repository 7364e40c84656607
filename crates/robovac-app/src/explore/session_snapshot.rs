//! Room and settings of a session, for the other tabs.

use super::{Session, session::known_room};
use crate::{ScenarioChoices, ScenarioError};
use robovac_core::{
    floor_plan::{MapError, Scenario},
    geometry::Pose,
};
use robovac_sim::experiment::{Algorithm, SettingsError};
use serde::{Deserialize, Serialize};

/// The model of robots that can be connected.
const CONNECTED: &str = "roomba600";

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
}

impl SessionSnapshot {
    /// The same for a connected robot driven by `algorithm`; with default parameters if it is another algorithm.
    pub fn for_connection(mut self, algorithm: &str) -> Result<Self, SettingsError> {
        let choices = &mut self.choices;
        // A connected robot is itself, with its own calibration.
        choices.twin = None;
        if choices.robot.as_deref() != Some(CONNECTED) {
            // Cell sizes of another robot don't fit this one.
            (choices.robot, choices.cell_size) = (Some(CONNECTED.to_owned()), None);
        }
        if choices.algorithm() != Some(algorithm) {
            choices.params.clear();
            let id = Some(algorithm.to_owned());
            (choices.planner, choices.behaviour) = match Algorithm::find("algorithm", algorithm, Algorithm::all())? {
                Algorithm::Planner(_) => (id, None),
                Algorithm::Behaviour(_) => (None, id),
            };
        }
        (choices.quantised, choices.start_charge_percent) = (None, None);
        Ok(self)
    }
}

impl Session {
    /// The settings for other tabs, without an own room: see [`Session::own_room`].
    pub fn snapshot(&self) -> SessionSnapshot {
        SessionSnapshot {
            room: self.room().map(str::to_owned),
            room_version: self.plan_version(),
            own: None,
            start: self.start().map(|start| [start.x, start.y, start.heading]),
            choices: ScenarioChoices::of_settings(self.settings()),
        }
    }

    /// Takes over the state of `snapshot`. Changes nothing on an error.
    pub fn follow(&mut self, snapshot: &SessionSnapshot) -> Result<(), FollowError> {
        let settings = snapshot.choices.settings(&self.settings().defaults())?;
        let start = snapshot.start.map(|[x, y, heading]| Pose::new(x, y, heading));
        let room = match (&snapshot.room, &snapshot.own) {
            (Some(id), _) => {
                let room = known_room(id)?;
                Some(((room.build)(), Some(room.id)))
            }
            (None, Some(own)) => Some((own.plan("the room")?, None)),
            (None, None) => None,
        };
        self.replace(settings, room, start);
        Ok(())
    }
}
