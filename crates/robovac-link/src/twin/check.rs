//! How well a twin predicts a recording that it wasn't fitted to, beside its model.

use super::{
    counts_per_turn, light,
    log::{Measured, MotionLog},
    model_mm_per_count, turns,
    wheels::{self, Response},
};
use robovac_core::robot::{LightBumper, RobotModel};
use robovac_sim::experiment::TwinFile;
use serde::Serialize;

/// Readings that are predicted at once: a second.
const TOGETHER: usize = 66;

/// How far a twin's and its model's predictions are off.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Prediction {
    /// What is predicted.
    pub what: String,
    /// Unit of the errors.
    pub unit: String,
    /// Digits after the point.
    pub digits: u8,
    /// Error of the twin.
    pub twin: f64,
    /// Error of the model.
    pub model: f64,
    /// From what: a sentence.
    pub how: String,
}

/// All that can be predicted in a recording.
pub(super) fn predict(log: &MotionLog, file: &TwinFile, delay_s: f64, robot: &RobotModel) -> Vec<Prediction> {
    let twin = file.twin.of(robot);
    let mm = 1000.0 / twin.counts_per_metre;
    let mut predictions = Vec::new();
    let stretches = wheels::stretches(log, TOGETHER);
    let larger = mm / model_mm_per_count();
    let scale = file.twin.speed_factor.unwrap_or(larger) / larger;
    let own = Response {
        scale,
        acceleration: twin.acceleration / (scale * larger),
        delay_s,
        is_quantised: file.quantised.unwrap_or(false),
    };
    let error = |response: &Response| {
        let compared = wheels::compare(log, robot, response, &stretches);
        let moving = compared.iter().filter(|c| c.counted.abs().max(c.predicted.abs()) > 1.5);
        let errors: Vec<f64> = moving.map(|c| (c.counted - response.scale * c.predicted).powi(2)).collect();
        (!errors.is_empty()).then(|| ((errors.iter().sum::<f64>() / errors.len() as f64).sqrt(), errors.len()))
    };
    if let (Some((twin, number)), Some((model, _))) = (error(&own), error(&Response::of(robot, delay_s))) {
        predictions.push(Prediction {
            what: "Counts of a wheel after a second".to_owned(),
            unit: "counts".to_owned(),
            digits: 1,
            twin,
            model,
            how: format!(
                "Root mean square over {number} stretches of one second, each of one wheel, predicted from the \
                 commands alone."
            ),
        });
    }
    if let Some(turn) = turns::measure(log) {
        let off = |counts: f64| (360.0 * (turn.counts / counts - 1.0)).abs();
        let of_twin = counts_per_turn() * (twin.wheel_base / robot.wheel_base) / larger;
        let [seen, measured] = turn.turns;
        predictions.push(Prediction {
            what: "Heading after a full turn".to_owned(),
            unit: "°".to_owned(),
            digits: 1,
            twin: off(of_twin),
            model: off(counts_per_turn()),
            how: format!(
                "By {} full turns seen by the light bumper and {measured} measured; those are accurate to {:.1}°.",
                seen,
                360.0 * turn.deviation / turn.counts
            ),
        });
    }
    let ways: Vec<f64> = log
        .measured
        .iter()
        .filter_map(|measured| match *measured {
            Measured::Way(counts, metres) => Some(1000.0 * metres / counts),
            Measured::Turn(..) => None,
        })
        .collect();
    if !ways.is_empty() {
        let off = |mm: f64| {
            let errors = ways.iter().map(|way| (1000.0 * (mm / way - 1.0)).powi(2));
            (errors.sum::<f64>() / ways.len() as f64).sqrt()
        };
        predictions.push(Prediction {
            what: "Distance after a metre".to_owned(),
            unit: "mm".to_owned(),
            digits: 0,
            twin: off(mm),
            model: off(model_mm_per_count()),
            how: format!("By {} measured in calibrations.", ways.len()),
        });
    }
    let lights = [twin.sensors.light_bumper, robot.sensors.light_bumper];
    if let [Some(of_twin), Some(of_model)] = lights {
        let contacts = light::contacts(log, &twin, &of_model);
        let error = |light: &LightBumper| light::misfit(&contacts, light).map(|error| 100.0 * (error.exp() - 1.0));
        if let (Some(twin), Some(model)) = (error(&of_twin), error(&of_model)) {
            predictions.push(Prediction {
                what: "Light signal of a wall ahead".to_owned(),
                unit: "%".to_owned(),
                digits: 0,
                twin,
                model,
                how: format!("Root mean square on the way to {} walls.", contacts.len()),
            });
        }
    }
    predictions
}
