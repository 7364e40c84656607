//! Catalogue of algorithms, rooms and robots, for menus and forms.

use crate::CatalogueEntry;
use coverage_planners::{
    PLANNERS,
    metrics::{METRICS, MetricInfo},
};
use robovac_core::{
    floor_plan::ROOMS,
    robot::{Body, MODELS, RobotModel, WheelLayout},
};
use robovac_sim::{
    SensorKind,
    controller::MAPLESS,
    experiment::{Algorithm, CELL_SIZES, SPEEDS},
};
use serde::Serialize;

/// The choices in menus and forms: rooms, planners, behaviours, robots, sensors with noise, cell sizes and speeds.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Catalogue {
    rooms: Vec<RoomEntry>,
    planners: Vec<CatalogueEntry>,
    behaviours: Vec<CatalogueEntry>,
    robots: Vec<RobotEntry>,
    /// Ids and labels.
    sensors: [(&'static str, &'static str); SensorKind::ALL.len()],
    /// Numbers of plans, as in tables.
    metrics: &'static [MetricInfo],
    cell_sizes_m: [f64; CELL_SIZES.len()],
    speeds: [f64; SPEEDS.len()],
}

#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
struct RoomEntry {
    id: &'static str,
    title: &'static str,
    note: &'static str,
}

/// A robot, for its portrait and its dashboard.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[expect(clippy::struct_excessive_bools)]
pub struct RobotEntry {
    id: &'static str,
    title: &'static str,
    summary: &'static str,
    default_cell_m: f64,
    tool_width_m: f64,
    /// Speed along paths, and turn rate on the spot.
    speed_m_s: f64,
    turn_deg_s: f64,
    /// Radius of the smallest circle around the body; all other lengths are in units of it, x ahead and y to the left.
    radius_m: f64,
    /// Corners of a body that isn't round.
    body: Vec<[f64; 2]>,
    wheel_base: f64,
    wheel_radius: f64,
    /// Half the angle that the bumper spans, rad; 0 for none.
    bumper: f64,
    /// Left, front left, front right, right; `null` where there is none.
    cliffs: [Option<[f64; 2]>; 4],
    /// Directions of the light bumper's beams, rad; empty for none.
    light: Vec<f64>,
    infrared: bool,
    wheel_drops: bool,
    gauge: bool,
    lateral: bool,
    /// First direction and step (rad), range and place (m) of the laser scanner; empty for none.
    laser: Vec<f64>,
}

impl Catalogue {
    /// The whole catalogue.
    pub fn all() -> Self {
        Self {
            rooms: ROOMS.iter().map(|r| RoomEntry { id: r.id, title: r.title, note: r.note }).collect(),
            planners: PLANNERS.iter().map(|info| CatalogueEntry::new(Algorithm::Planner(info))).collect(),
            behaviours: MAPLESS.infos().map(|info| CatalogueEntry::new(Algorithm::Behaviour(info))).collect(),
            robots: MODELS.iter().copied().map(RobotEntry::new).collect(),
            sensors: SensorKind::ALL.map(|(kind, name)| (name, kind.label())),
            metrics: METRICS,
            cell_sizes_m: CELL_SIZES,
            speeds: SPEEDS,
        }
    }
}

impl RobotEntry {
    /// The entry of a robot.
    pub fn new(model: &RobotModel) -> Self {
        let unit = 1.0 / model.radius;
        let scaled = |[x, y]: [f64; 2]| [unit * x, unit * y];
        let sensors = &model.sensors;
        Self {
            id: model.id,
            title: model.title,
            summary: model.summary,
            default_cell_m: model.default_cell,
            tool_width_m: model.tool_width,
            speed_m_s: model.cruise_speed,
            turn_deg_s: model.turn_rate().to_degrees(),
            radius_m: model.radius,
            body: match model.body {
                Body::Round => Vec::new(),
                Body::Polygon(corners) => corners.iter().copied().map(scaled).collect(),
            },
            wheel_base: unit * model.wheel_base,
            wheel_radius: unit * model.wheel_radius,
            bumper: sensors.bumper.map_or(0.0, |bumper| bumper.half_arc),
            cliffs: sensors.cliffs.map(|cliff| cliff.map(scaled)),
            light: sensors.light_bumper.map_or(Vec::new(), |light| light.angles.to_vec()),
            infrared: sensors.infrared,
            wheel_drops: sensors.wheel_drops,
            gauge: model.battery.has_gauge,
            lateral: model.wheels == WheelLayout::Omnidirectional,
            laser: sensors
                .laser
                .map_or(Vec::new(), |laser| vec![laser.first, laser.step, laser.range[1], laser.at[0], laser.at[1]]),
        }
    }
}
