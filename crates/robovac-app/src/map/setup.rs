//! Settings of the Map tab and their form in a link.

use super::{Layers, MapGrid};
use coverage_planners::{self, PLANNERS, PlannerInfo};
use robovac_core::{registry::Params, robot::OdometryModel};
use robovac_sim::{
    Conditions, Noise, NoiseLevel, SlipLevel,
    controller::{self, BEHAVIOURS, BehaviourInfo},
    experiment::SettingsError,
    mapping::Tracking,
    program::BEHAVIOUR_PROGRAM,
};
use std::collections::BTreeMap;

/// Behaviours that aren't made for exploring but cover enough ground for it.
const ROVERS: [&str; 5] = ["online_snake", "learned", "wall_follow", "bounce", "random_walk"];
/// The default behaviour, if it is in the registry.
const FIRST: &str = "explore_frontier";
/// The default planner.
const FIRST_CLEANER: &str = "boustrophedon_cells";
/// The default speed, times real time: mapping a flat takes twenty minutes.
const SPEED: f64 = 64.0;

/// Names of choices in links; the behaviour's parameters begin with `x.`.
const KEYS: [&str; 9] = ["explorer", "track", "counts", "wheels", "senses", "grid", "layers", "pace", "clean"];

/// Behaviours for mapping, those made for exploring first.
pub fn explorers() -> impl Iterator<Item = &'static BehaviourInfo> {
    let made_for_it = BEHAVIOURS.iter().copied().filter(|b| b.claims.explores);
    made_for_it.chain(ROVERS.into_iter().filter_map(controller::find))
}

/// All that can drive the robot: behaviours for mapping, and the user's program.
pub fn methods() -> impl Iterator<Item = &'static BehaviourInfo> {
    explorers().chain([&BEHAVIOUR_PROGRAM])
}

/// Planners for the remaining floor: complete and quick ones, as the robot waits.
pub fn cleaners() -> impl Iterator<Item = &'static PlannerInfo> {
    PLANNERS.iter().copied().filter(|info| info.claims.complete && info.claims.fast)
}

/// Settings of the tab Map; room, robot, start and seed are Explore's.
#[derive(Debug, Clone)]
pub struct MapSetup {
    /// The exploring behaviour.
    pub behaviour: &'static BehaviourInfo,
    /// Its parameters.
    pub params: Params,
    /// Parameters of other behaviours, for when they are chosen again.
    left: BTreeMap<&'static str, Params>,
    /// How the robot estimates its pose.
    pub tracking: Tracking,
    /// How wheel counts are converted to motion.
    pub odometry: OdometryModel,
    /// Level of wheel slip, if it differs from Explore.
    pub slip: Option<SlipLevel>,
    /// Level of sensor noise, if it differs from Explore.
    pub noise: Option<NoiseLevel>,
    /// Planner for cleaning the remaining floor.
    pub planner: &'static PlannerInfo,
    /// The grid that is shown, measured and exported.
    pub grid: MapGrid,
    /// Layers that are drawn.
    pub layers: Layers,
    /// Speed, times real time; 0 for as fast as possible.
    pub speed: f64,
}

impl MapSetup {
    /// The defaults.
    pub fn new() -> Self {
        let behaviour = controller::find(FIRST).or_else(|| explorers().next()).unwrap_or(BEHAVIOURS[0]);
        Self {
            behaviour,
            params: Params::defaults(behaviour.params),
            left: BTreeMap::new(),
            tracking: Tracking::Corrected,
            odometry: OdometryModel::Arc,
            slip: None,
            noise: None,
            planner: coverage_planners::find(FIRST_CLEANER).or_else(|| cleaners().next()).unwrap_or(PLANNERS[0]),
            grid: MapGrid::default(),
            layers: Layers::default(),
            speed: SPEED,
        }
    }

    /// Whether the user's program drives.
    pub fn is_program(&self) -> bool {
        self.behaviour.id == BEHAVIOUR_PROGRAM.id
    }

    /// Chooses a behaviour, with the parameters that it had before.
    pub fn choose_behaviour(&mut self, id: &str) -> Result<(), SettingsError> {
        let chosen = methods().find(|b| b.id == id).ok_or_else(|| SettingsError::Unknown {
            kind: "exploring behaviour",
            id: id.to_owned(),
            known: methods().map(|b| b.id).collect::<Vec<_>>().join(", "),
        })?;
        self.left.insert(self.behaviour.id, self.params.clone());
        self.params = self.left.remove(chosen.id).unwrap_or_else(|| Params::defaults(chosen.params));
        self.behaviour = chosen;
        Ok(())
    }

    /// Sets one choice from the text of a form or a link: see [`MapSetup::to_link`] for the names.
    pub fn set(&mut self, key: &str, value: &str) -> Result<(), SettingsError> {
        let unknown =
            |kind, known: &[&str]| SettingsError::Unknown { kind, id: value.to_owned(), known: known.join(", ") };
        match key {
            "explorer" => self.choose_behaviour(value)?,
            "track" => {
                let known = Tracking::ALL.map(|(_, name)| name);
                self.tracking = Tracking::parse(value).ok_or_else(|| unknown("localisation method", &known))?;
            }
            "counts" => {
                let known = OdometryModel::ALL.map(|(_, name)| name);
                self.odometry = OdometryModel::parse(value).ok_or_else(|| unknown("odometry model", &known))?;
            }
            "wheels" => {
                let known = SlipLevel::ALL.map(|(_, name)| name);
                self.slip = Some(SlipLevel::parse(value).ok_or_else(|| unknown("wheel slip", &known))?);
            }
            "senses" => {
                let known = NoiseLevel::ALL.map(|(_, name)| name);
                self.noise = Some(NoiseLevel::parse(value).ok_or_else(|| unknown("noise level", &known))?);
            }
            "clean" => {
                self.planner = cleaners().find(|info| info.id == value).ok_or_else(|| {
                    unknown("fast and complete planner", &cleaners().map(|info| info.id).collect::<Vec<_>>())
                })?;
            }
            "grid" => {
                let known = MapGrid::ALL.map(|(_, name)| name);
                self.grid = MapGrid::parse(value).ok_or_else(|| unknown("grid", &known))?;
            }
            "layers" => self.layers = Layers::from_link(value)?,
            "pace" => {
                let speed = value.parse::<f64>().ok().filter(|speed| speed.is_finite() && *speed >= 0.0);
                self.speed = speed.ok_or_else(|| SettingsError::Invalid {
                    kind: "the speed",
                    value: value.to_owned(),
                    expected: "a number, 0 for as fast as possible",
                })?;
            }
            _ => {
                if let Some(id) = key.strip_prefix("x.") {
                    self.params.set_text(self.behaviour.params, id, value)?;
                }
            }
        }
        Ok(())
    }

    /// Parameters for the behaviour. One with a map of its own has a parameter for the tracking chosen here.
    pub fn driving_params(&self) -> Params {
        let mut params = self.params.clone();
        for (id, value) in [("tracking", self.tracking.id()), ("odometry", self.odometry.id())] {
            // Other behaviours don't have this parameter.
            let _ = params.set_text(self.behaviour.params, id, value);
        }
        params
    }

    /// Conditions of this tab, where Explore has `there`. Mapping with perfect wheels and sensors would be pointless,
    /// so by default those that are perfect there are typical here.
    pub fn conditions(&self, there: Conditions) -> Conditions {
        let slip = self.slip.unwrap_or(match there.slip {
            SlipLevel::None => SlipLevel::Typical,
            level => level,
        });
        let noise = match self.noise {
            Some(level) => Noise::all(level),
            None if there.noise == Noise::default() => Noise::all(NoiseLevel::Typical),
            None => there.noise,
        };
        Conditions { slip, noise, ..there }
    }

    /// Key of everything that determines a run: setups with the same text make the same map.
    pub fn recipe(&self) -> String {
        self.pairs()
            .into_iter()
            .filter(|(key, _)| !["grid", "layers", "pace", "clean"].contains(&key.as_str()))
            .fold(String::new(), |text, (key, value)| format!("{text}{key}={value} "))
    }

    /// The choices as `key=value` pairs for a link.
    pub fn to_link(&self) -> String {
        self.pairs().into_iter().map(|(key, value)| format!("{key}={value}")).collect::<Vec<_>>().join("&")
    }

    fn pairs(&self) -> Vec<(String, String)> {
        let first = Self::new();
        let mut pairs = vec![("explorer".to_owned(), self.behaviour.id.to_owned())];
        let mut push = |key: &str, value: String| pairs.push((key.to_owned(), value));
        let defaults = Params::defaults(self.behaviour.params);
        for (id, value) in self.params.iter().filter(|&(id, value)| defaults.get(id) != Some(value)) {
            push(&format!("x.{id}"), value.to_string());
        }
        if self.tracking != first.tracking {
            push("track", self.tracking.id().to_owned());
        }
        if self.odometry != first.odometry {
            push("counts", self.odometry.id().to_owned());
        }
        if let Some(slip) = self.slip {
            push("wheels", slip.id().to_owned());
        }
        if let Some(noise) = self.noise {
            push("senses", noise.id().to_owned());
        }
        if self.planner.id != first.planner.id {
            push("clean", self.planner.id.to_owned());
        }
        if self.grid != first.grid {
            push("grid", self.grid.id().to_owned());
        }
        if self.layers != first.layers {
            push("layers", self.layers.to_link());
        }
        if self.speed != first.speed {
            push("pace", self.speed.to_string());
        }
        pairs
    }

    /// Reads the pairs that [`MapSetup::to_link`] wrote, among others, joined by `&`. Changes nothing on an error.
    pub fn restore(&mut self, link: &str) -> Result<(), SettingsError> {
        let mut next = Self { left: self.left.clone(), ..Self::new() };
        let mut pairs: Vec<_> =
            link.trim_start_matches('#').split('&').filter_map(|pair| pair.split_once('=')).collect();
        // A link without choices of this tab changes nothing.
        let is_ours = |key: &str| KEYS.contains(&key) || key.starts_with("x.");
        if !pairs.iter().any(|(key, _)| is_ours(key)) {
            return Ok(());
        }
        // The behaviour first, as parameters belong to it.
        pairs.sort_by_key(|(key, _)| *key != "explorer");
        for (key, value) in pairs {
            next.set(key, value)?;
        }
        *self = next;
        Ok(())
    }
}

impl Default for MapSetup {
    fn default() -> Self {
        Self::new()
    }
}
