//! What there is: planners, behaviours, rooms, robots, metrics.

use coverage_planners::{PLANNERS, metrics::METRICS};
use pyo3::prelude::*;
use robovac_core::{
    floor_plan::ROOMS,
    registry::{ParamKind, ParamSpec},
    robot::MODELS,
};
use robovac_sim::{controller::BEHAVIOURS, learning};
use serde_json::{Value, json};

/// Planners as JSON.
#[pyfunction]
pub fn planners() -> String {
    let entry = |info: &&coverage_planners::PlannerInfo| {
        json!({
            "id": info.id, "title": info.title, "summary": info.summary,
            "complete": info.claims.complete, "deterministic": info.claims.deterministic, "fast": info.claims.fast,
            "in_metres": info.is_in_metres(), "params": params(info.params),
        })
    };
    PLANNERS.iter().map(entry).collect::<Value>().to_string()
}

/// Behaviours as JSON.
#[pyfunction]
pub fn behaviours() -> String {
    let entry = |info: &&robovac_sim::controller::BehaviourInfo| {
        json!({
            "id": info.id, "title": info.title, "summary": info.summary,
            "ends": info.claims.ends, "cleans": info.claims.cleans, "explores": info.claims.explores,
            "needs_laser": info.claims.needs_laser, "params": params(info.params),
        })
    };
    let autonomous = BEHAVIOURS.iter().filter(|info| !info.claims.manual);
    autonomous.map(entry).collect::<Value>().to_string()
}

/// Shipped rooms as JSON.
#[pyfunction]
pub fn rooms() -> String {
    ROOMS
        .iter()
        .map(|info| json!({ "id": info.id, "title": info.title, "note": info.note }))
        .collect::<Value>()
        .to_string()
}

/// Robots as JSON.
#[pyfunction]
pub fn robots() -> String {
    let entry = |robot: &&robovac_core::robot::RobotModel| {
        json!({
            "id": robot.id, "title": robot.title, "summary": robot.summary, "radius_m": robot.radius,
            "tool_width_m": robot.tool_width, "wheel_base_m": robot.wheel_base,
            "max_wheel_speed_mps": robot.max_wheel_speed, "cell_m": robot.default_cell,
            "has_laser": robot.sensors.laser.is_some(),
        })
    };
    MODELS.iter().map(entry).collect::<Value>().to_string()
}

/// Metrics of plans as JSON.
#[pyfunction]
pub fn metrics() -> String {
    let entry = |metric: &coverage_planners::metrics::MetricInfo| json!({ "id": metric.id, "label": metric.label, "unit": metric.unit, "definition": metric.definition });
    METRICS.iter().map(entry).collect::<Value>().to_string()
}

/// Names of the values of the observation "oi".
#[pyfunction]
pub fn reading_names() -> Vec<&'static str> {
    learning::READING_NAMES.to_vec()
}

/// Names of the values of the observation "truth".
#[pyfunction]
pub fn truth_names() -> Vec<String> {
    let rays = (0..learning::truth::RAYS).map(|ray| format!("distance_{ray}_m"));
    learning::truth::NAMES.iter().map(ToString::to_string).chain(rays).collect()
}

fn params(specs: &[ParamSpec]) -> Value {
    let entry = |spec: &ParamSpec| {
        let mut value =
            json!({ "id": spec.id, "label": spec.label, "help": spec.help, "values": spec.kind.to_string() });
        value["default"] = match spec.kind {
            ParamKind::Number { default, .. } => json!(default),
            ParamKind::Choice { options } => json!(options.first().map(|option| option.0)),
            ParamKind::Flag { default } => json!(default),
        };
        value
    };
    specs.iter().map(entry).collect()
}
