//! The user's settings.

mod error;
mod link;

pub use self::{error::SettingsError, link::KEPT_PATH};

use super::{Algorithm, Shows};
use crate::{
    Conditions, Noise, NoiseLevel, SensorKind, SlipLevel,
    controller::{self, Behaviours},
};
use robovac_core::{
    coverage::PlanningCells,
    geometry::{MetricPath, Pose},
    program::Program,
    registry::Params,
    robot::{Body, CustomRobot, OdometryModel, OwnRobot, RobotModel, TWIN_MODEL, Twin, WheelLayout, cell_robot, model},
};
use std::{collections::BTreeMap, sync::Arc};

/// Cell sizes in the menu, m.
pub const CELL_SIZES: [f64; 8] = [0.1, 0.12, 0.15, 0.2, 0.25, 0.3, 0.35, 0.5];
/// Speeds in the menu, times real time; 0 for as fast as possible.
pub const SPEEDS: [f64; 7] = [1.0, 4.0, 16.0, 64.0, 256.0, 1024.0, 0.0];

/// Default speed for watching, and for manual driving, times real time.
const DEFAULT_SPEED: f64 = 16.0;
const MANUAL_SPEED: f64 = 1.0;

/// Largest seed, which JavaScript can represent exactly.
const MAX_SEED: u64 = u32::MAX as u64;

/// Everything that determines a run, except for the room.
#[derive(Debug, Clone)]
pub struct Settings {
    /// Available behaviours, in addition to all planners.
    behaviours: Behaviours,
    /// The algorithm.
    pub algorithm: Algorithm,
    /// Its parameters.
    pub params: Params,
    /// Parameters of other algorithms, for when they are chosen again.
    left: BTreeMap<&'static str, Params>,
    /// The user's program, for when it is chosen.
    program: Option<Arc<Program>>,
    /// Id of the robot.
    pub robot: &'static str,
    /// What the user's own robot has in place of the model's.
    pub custom: Option<CustomRobot>,
    /// A path from elsewhere, which the robot drives in place of the planner's.
    pub path: Option<MetricPath>,
    /// Side of the planning cells, m.
    pub cell_size: f64,
    /// How far they begin to the left of the room's lower-left corner and below it, m; see [`Settings::cells`].
    cell_offset: [f64; 2],
    /// Seed of everything random.
    pub seed: u64,
    /// Slip, noise and battery.
    pub conditions: Conditions,
    /// How the follower computes its pose.
    pub odometry: OdometryModel,
    /// Whether the corners of plans are rounded.
    pub smooth: bool,
    /// Start chosen by the user, if not the room's own.
    pub start: Option<Pose>,
    /// Speed, times real time; 0 for as fast as possible.
    pub speed: f64,
    /// Speed before manual driving, for afterwards.
    left_speed: f64,
    /// Layers drawn on the floor.
    pub shows: Shows,
}

impl Settings {
    /// The defaults of the page.
    pub fn new() -> Self {
        Self::with(controller::ALL)
    }

    /// The same with only these behaviours available.
    pub fn with(behaviours: Behaviours) -> Self {
        let algorithm = Algorithm::Planner(coverage_planners::PLANNERS[0]);
        Self {
            behaviours,
            algorithm,
            params: Params::defaults(algorithm.params()),
            left: BTreeMap::new(),
            program: None,
            robot: TWIN_MODEL,
            custom: None,
            path: None,
            cell_size: 0.12,
            cell_offset: [0.0, 0.0],
            seed: 1,
            conditions: Conditions::default(),
            odometry: OdometryModel::Arc,
            smooth: false,
            start: None,
            speed: DEFAULT_SPEED,
            left_speed: DEFAULT_SPEED,
            shows: Shows::DEFAULT,
        }
    }

    /// The initial settings.
    pub fn defaults(&self) -> Self {
        Self::with(self.behaviours)
    }

    /// The available behaviours.
    pub fn behaviours(&self) -> Behaviours {
        self.behaviours
    }

    /// The planners and behaviours that can be chosen, the user's program last.
    fn algorithms(&self) -> impl Iterator<Item = Algorithm> + Clone + use<> {
        Algorithm::with(self.behaviours)
            .chain(self.program.as_deref().map(|program| Algorithm::of_program(program.kind)))
    }

    /// The user's program, whether it is chosen or not.
    pub fn program(&self) -> Option<&Arc<Program>> {
        self.program.as_ref()
    }

    /// The user's program, if it is chosen.
    pub fn chosen_program(&self) -> Option<&Arc<Program>> {
        self.program.as_ref().filter(|program| self.algorithm == Algorithm::of_program(program.kind))
    }

    /// Keeps a program, to be chosen by its id. If one is chosen, this one takes its place.
    pub fn keep_program(&mut self, program: Program) -> Result<(), SettingsError> {
        program.check()?;
        let was_chosen = self.algorithm.is_program();
        let algorithm = Algorithm::of_program(program.kind);
        self.program = Some(Arc::new(program));
        if was_chosen && self.algorithm != algorithm {
            self.select_algorithm(algorithm.id())?;
        }
        Ok(())
    }

    /// Keeps a program and chooses it.
    pub fn set_program(&mut self, program: Program) -> Result<(), SettingsError> {
        let id = Algorithm::of_program(program.kind).id();
        self.keep_program(program)?;
        self.select_algorithm(id)
    }

    /// Chooses a planner or behaviour, with the parameters that it had before.
    pub fn select_algorithm(&mut self, id: &str) -> Result<(), SettingsError> {
        if self.program.is_none() && Algorithm::is_program_id(id) {
            return Err(SettingsError::NoProgram);
        }
        let chosen = Algorithm::find("algorithm", id, self.algorithms())?;
        self.left.insert(self.algorithm.id(), self.params.clone());
        self.params = self.left.remove(chosen.id()).unwrap_or_else(|| Params::defaults(chosen.params()));
        match (self.is_manual(), is_manual(chosen)) {
            (false, true) => self.left_speed = std::mem::replace(&mut self.speed, MANUAL_SPEED),
            (true, false) => self.speed = self.left_speed,
            _ => {}
        }
        self.algorithm = chosen;
        self.path = None;
        Ok(())
    }

    /// Whether a person drives.
    pub fn is_manual(&self) -> bool {
        is_manual(self.algorithm)
    }

    /// Chooses a planner or behaviour with its default parameters, for links and scenarios.
    pub fn select_fresh_algorithm(&mut self, id: &str) -> Result<(), SettingsError> {
        self.select_algorithm(id)?;
        self.params = Params::defaults(self.algorithm.params());
        Ok(())
    }

    /// The same for a `planner` or a `behaviour`.
    pub fn select_fresh_of_kind(&mut self, kind: &'static str, id: &str) -> Result<(), SettingsError> {
        if self.program.is_some() || !Algorithm::is_program_id(id) {
            Algorithm::find(kind, id, self.algorithms().filter(|algorithm| algorithm.kind() == kind))?;
        }
        self.select_fresh_algorithm(id)
    }

    /// Chooses a robot, with its default cell size.
    pub fn select_robot(&mut self, id: &str) -> Result<(), SettingsError> {
        let known = || robovac_core::robot::MODELS.iter().map(|m| m.id).collect::<Vec<_>>().join(", ");
        let chosen =
            model(id).ok_or_else(|| SettingsError::Unknown { kind: "robot", id: id.into(), known: known() })?;
        let before = self.shape();
        self.robot = chosen.id;
        self.custom = None;
        (self.cell_size, self.cell_offset) = (chosen.default_cell, [0.0, 0.0]);
        self.keep_path(&before);
        Ok(())
    }

    /// What a path is planned for: body and wheels.
    fn shape(&self) -> (Body, f64, WheelLayout) {
        let robot = self.robot_model();
        (robot.body, robot.radius, robot.wheels)
    }

    /// Leaves the path out if the robot had another shape before.
    fn keep_path(&mut self, before: &(Body, f64, WheelLayout)) {
        if self.path.is_some() && self.shape() != *before {
            self.path = None;
        }
    }

    /// Chooses a twin, which was checked. The size of cells stays if the robot was of the same model.
    pub fn select_twin(&mut self, twin: Twin) {
        if self.robot != TWIN_MODEL {
            let _ = self.select_robot(TWIN_MODEL);
        }
        self.custom = Some(CustomRobot::Twin(twin));
    }

    /// Chooses the twin of a link or a scenario.
    pub fn set_twin(&mut self, twin: Twin) -> Result<(), SettingsError> {
        let custom = CustomRobot::Twin(twin);
        if let Some(model) = model(TWIN_MODEL) {
            custom.check(model)?;
        }
        self.select_twin(twin);
        Ok(())
    }

    /// Builds an own robot on the present model, with the size of cells that suits its tool.
    pub fn set_own_robot(&mut self, own: OwnRobot) -> Result<(), SettingsError> {
        let Some(model) = model(self.robot) else { return Ok(()) };
        let custom = CustomRobot::Own(own);
        custom.check(model)?;
        let before = self.shape();
        (self.cell_size, self.cell_offset) = (custom.of(model).default_cell, [0.0, 0.0]);
        self.custom = Some(custom);
        self.keep_path(&before);
        Ok(())
    }

    /// Chooses the side of the planning cells, m, which begin at the room's corner.
    pub fn set_cell_size(&mut self, metres: f64) -> Result<(), SettingsError> {
        if !(0.02..=2.0).contains(&metres) {
            let expected = "a length from 0.02 to 2 (metres)";
            return Err(SettingsError::Invalid { kind: "the cell size", value: metres.to_string(), expected });
        }
        (self.cell_size, self.cell_offset) = (metres, [0.0, 0.0]);
        Ok(())
    }

    /// Chooses how far the planning cells begin to the left of the room's lower-left corner and below it, m.
    pub fn set_cell_offset(&mut self, offset: [f64; 2]) -> Result<(), SettingsError> {
        if !offset.iter().all(|metres| (0.0..self.cell_size).contains(metres)) {
            let [x, y] = offset;
            return Err(SettingsError::Invalid {
                kind: "the cells' offset",
                value: format!("{x},{y}"),
                expected: "two lengths from 0 to less than a cell (metres)",
            });
        }
        self.cell_offset = offset;
        Ok(())
    }

    /// The planning cells. A robot that fills a cell has them from the room's corner.
    pub fn cells(&self) -> PlanningCells {
        let offset = if self.robot == "cell" { [0.0, 0.0] } else { self.cell_offset };
        PlanningCells { size: self.cell_size, offset }
    }

    /// Sets the seed of a link or a scenario, whose text is `text`.
    pub fn set_seed(&mut self, seed: Option<u64>, text: &str) -> Result<(), SettingsError> {
        self.seed = seed.filter(|&seed| seed <= MAX_SEED).ok_or_else(|| SettingsError::Invalid {
            kind: "the seed",
            value: text.to_owned(),
            expected: "a whole number from 0 to 4294967295",
        })?;
        Ok(())
    }

    /// Sets one parameter of the algorithm from the text of a form or a link.
    pub fn set_param(&mut self, id: &str, text: &str) -> Result<(), SettingsError> {
        Ok(self.params.set_text(self.algorithm.params(), id, text)?)
    }

    /// Chooses the level of wheel slip.
    pub fn set_slip(&mut self, id: &str) -> Result<(), SettingsError> {
        let known = || SlipLevel::ALL.map(|(_, name)| name).join(", ");
        self.conditions.slip = SlipLevel::parse(id).ok_or_else(|| SettingsError::Unknown {
            kind: "slip",
            id: id.into(),
            known: known(),
        })?;
        Ok(())
    }

    /// Chooses the level of noise: of all sensors, or of the kind `sensor`.
    pub fn set_noise(&mut self, sensor: Option<&str>, level: &str) -> Result<(), SettingsError> {
        let unknown = |kind, id: &str, known: Vec<&str>| SettingsError::Unknown {
            kind,
            id: id.to_owned(),
            known: known.join(", "),
        };
        let parsed = NoiseLevel::parse(level);
        let parsed =
            parsed.ok_or_else(|| unknown("noise level", level, NoiseLevel::ALL.map(|(_, name)| name).to_vec()))?;
        match sensor {
            None => self.conditions.noise = Noise::all(parsed),
            Some(name) => {
                let kind = SensorKind::parse(name)
                    .ok_or_else(|| unknown("sensor", name, SensorKind::ALL.map(|(_, name)| name).to_vec()))?;
                self.conditions.noise.set(kind, parsed);
            }
        }
        Ok(())
    }

    /// Sets the charge of the battery at the start, whose text is `text`.
    pub fn set_start_charge(&mut self, percent: Option<u64>, text: &str) -> Result<(), SettingsError> {
        let percent =
            percent.and_then(|percent| u8::try_from(percent).ok()).filter(|percent| (1..=100).contains(percent));
        self.conditions.start_charge_percent = percent.ok_or_else(|| SettingsError::Invalid {
            kind: "the start charge",
            value: text.to_owned(),
            expected: "a whole number from 1 to 100 (percent)",
        })?;
        Ok(())
    }

    /// Chooses how the follower computes its pose.
    pub fn set_odometry(&mut self, id: &str) -> Result<(), SettingsError> {
        let known = || OdometryModel::ALL.map(|(_, name)| name).join(", ");
        self.odometry = OdometryModel::parse(id).ok_or_else(|| SettingsError::Unknown {
            kind: "odometry model",
            id: id.into(),
            known: known(),
        })?;
        Ok(())
    }

    /// Whether `other` gives the same plan in the same room.
    pub fn plans_like(&self, other: &Self) -> bool {
        let plan = |it: &Self| (it.algorithm.id(), it.robot, it.cell_size, it.cell_offset, it.seed, it.smooth);
        plan(self) == plan(other)
            && self.params == other.params
            && self.custom == other.custom
            && self.path == other.path
            && self.chosen_program() == other.chosen_program()
    }

    /// Id of the robot; with what makes it another one, as in a link, if it isn't just the model.
    pub fn robot_name(&self) -> String {
        let custom = self.custom.as_ref().filter(|_| self.robot != "cell");
        custom.map_or_else(|| self.robot.to_owned(), |custom| format!("{} {}:{custom}", self.robot, custom.key()))
    }

    /// The robot, which for the idealised one depends on the size of a cell.
    pub fn robot_model(&self) -> RobotModel {
        match model(self.robot) {
            Some(robot) if robot.id != "cell" => {
                self.custom.as_ref().map_or_else(|| robot.clone(), |custom| custom.of(robot))
            }
            _ => cell_robot(self.cell_size),
        }
    }
}

/// Whether a person drives with this algorithm.
fn is_manual(algorithm: Algorithm) -> bool {
    algorithm.behaviour().is_some_and(|behaviour| behaviour.claims.manual)
}

impl Default for Settings {
    fn default() -> Self {
        Self::new()
    }
}
