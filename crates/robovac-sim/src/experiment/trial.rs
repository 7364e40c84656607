//! A trial as plain values for a worker.

use super::{Arena, Entrant, PlanOutcome};
use crate::experiment::planning::{CELL_ROBOT, choose_robot};
use coverage_planners::Observer;
use robovac_core::{
    coverage::PlanningCells,
    floor_plan::{
        self, FloorPlan, SourceFile,
        generate::{FlatId, FlatIdError},
    },
    geometry::Pose,
    grid::Cell,
    robot::{CustomRobot, cell_robot},
};
use serde::{Deserialize, Serialize};

/// What stands in front of the name of a generated flat, as in `flat=7`, where the id of a built-in room can stand.
pub const GENERATED: &str = "flat=";

/// A trial for a worker.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TrialRequest {
    /// Number of the trial.
    pub id: u32,
    /// Id of a built-in room; otherwise see `scenario`.
    pub room: Option<String>,
    /// The room as a scenario file, if it isn't built in.
    pub scenario: Option<String>,
    /// Start of the robot if it isn't the room's: x, y in metres, heading in radians.
    pub start: Option<[f64; 3]>,
    /// Id of the robot.
    pub robot: String,
    /// What the user's own robot has in place of the model's.
    pub custom: Option<CustomRobot>,
    /// Side of the planning cells, m.
    pub cell_size: f64,
    /// How far they begin to the left of the room's lower-left corner and below it, m.
    #[serde(default)]
    pub cell_offset: [f64; 2],
    /// The planner with its parameters, as [`Entrant::parse`] reads it.
    pub entrant: String,
    /// Seed of its random numbers.
    pub seed: u64,
    /// For a user's program: the job with which it plans, as bytes.
    #[serde(default)]
    pub job: Option<Vec<u8>>,
    /// Whether corners are rounded.
    #[serde(default)]
    pub smooth: bool,
    /// Key of room, start, robot and cells: equal places have the same [`Arena`].
    pub place: String,
}

impl TrialRequest {
    /// The room laid out for the robot. Errors are for users.
    pub fn arena(&self) -> Result<Arena, String> {
        let plan = plan_of(self.room.as_deref(), self.scenario.as_deref())?;
        let robot = match &*self.robot {
            CELL_ROBOT => cell_robot(self.cell_size),
            id => choose_robot(id, &plan, None).ok_or_else(|| format!("there is no robot \"{id}\""))?.0,
        };
        let robot = self.custom.as_ref().map_or_else(|| robot.clone(), |custom| custom.of(&robot));
        let start = self.start.map(|[x, y, heading]| Pose::new(x, y, heading));
        let cells = PlanningCells { size: self.cell_size, offset: self.cell_offset };
        let arena = Arena::new(&plan, &robot, cells, start).map_err(|e| e.to_string())?;
        Ok(arena.smooth(self.smooth))
    }

    /// Runs the planner in `arena`. `clock` returns seconds since any moment. Errors are for users.
    pub fn run(
        &self,
        arena: &Arena,
        clock: impl Fn() -> f64,
        observer: Option<Observer<'_>>,
    ) -> Result<PlanOutcome, String> {
        let (entrant, planner) = Entrant::parse_planner(&self.entrant).map_err(|e| e.to_string())?;
        arena.run(planner, &entrant.params, self.seed, clock, observer).map_err(|e| e.to_string())
    }

    /// The result of a user's program that planned this walk, in `seconds`. Errors are for users.
    pub fn judge(&self, arena: &Arena, cells: Vec<Cell>, seconds: f64) -> Result<PlanOutcome, String> {
        arena.judge(cells, seconds).map_err(|e| e.to_string())
    }
}

/// The room with that id, or that of a scenario file. Errors are for users.
///
/// A generated flat is [`GENERATED`] with its name behind it.
pub fn plan_of(room: Option<&str>, scenario: Option<&str>) -> Result<FloorPlan, String> {
    match (room, scenario) {
        (Some(id), _) => {
            if let Some(flat) = id.strip_prefix(GENERATED) {
                let flat: FlatId = flat.parse().map_err(|e: FlatIdError| e.to_string())?;
                return Ok(flat.build());
            }
            let room = floor_plan::room(id).ok_or_else(|| format!("there is no room \"{id}\""))?;
            Ok((room.build)())
        }
        (None, Some(json)) => {
            let file = SourceFile { name: "room.json".to_owned(), bytes: json.as_bytes().to_vec() };
            floor_plan::load(&[file]).map_err(|e| e.to_string())
        }
        (None, None) => Err("there is no room".to_owned()),
    }
}
