//! Calibration of one robot: encoder sides, wheel diameter, wheel base.

use super::{
    Calibration, CalibrationView,
    floor_measure::FloorMeasure,
    moves::{CalibrationMove, CalibrationMoves},
};
use robovac_core::{
    math::{FRAC_PI_2, PI},
    robot::RobotModel,
};
use roomba_oi::motion::encoder_delta;

/// Plausible factors; others are a mistake, or another robot.
const FACTORS: std::ops::RangeInclusive<f64> = 0.8..=1.25;
/// Least counts of a nudge that was measured: half of what ten degrees take.
const LEAST_COUNTS: i32 = 20;

/// Text for encoders that don't count.
pub(super) const UNCOUNTED: &str = "The encoders hardly counted. Is the robot on the floor, and are its wheels free?";

/// Result of a robot's calibrations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Calibrated {
    /// Packets 43 and 44 are swapped.
    pub swapped: bool,
    /// True distance over what encoders say.
    pub distance_factor: f64,
    /// True wheel base over that of the model.
    pub base_factor: f64,
}

impl Default for Calibrated {
    fn default() -> Self {
        Self { swapped: false, distance_factor: 1.0, base_factor: 1.0 }
    }
}

impl Calibrated {
    /// The robot model with the calibrated values.
    pub fn apply(&self, model: &RobotModel) -> RobotModel {
        RobotModel {
            counts_per_metre: model.counts_per_metre / self.distance_factor,
            wheel_base: model.wheel_base * self.base_factor,
            ..model.clone()
        }
    }

    /// Whether all values are plausible.
    pub fn is_sound(&self) -> bool {
        FACTORS.contains(&self.distance_factor) && FACTORS.contains(&self.base_factor)
    }
}

/// Stage of a calibration.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum CalibrationStage {
    Moving,
    Asking,
    Done,
    Failed,
}

/// A calibration in progress.
#[derive(Debug, Clone)]
pub(super) struct Calibrating {
    what: Calibration,
    stage: CalibrationStage,
    text: String,
    /// Encoder packets 43 and 44 at its start.
    began: [u16; 2],
    swapped: Option<bool>,
    /// For a virtual robot.
    measure: Option<FloorMeasure>,
}

impl Calibration {
    /// Name in requests and views.
    pub(super) fn id(self) -> &'static str {
        match self {
            Self::Nudge => "nudge",
            Self::Spin => "spin",
            Self::Metre => "metre",
            Self::Square => "square",
            Self::SquareRight => "square_right",
        }
    }

    /// Title of its moves.
    pub(super) fn title(self) -> &'static str {
        match self {
            Self::Nudge => "Nudge",
            Self::Spin => "Spin",
            Self::Metre => "One metre",
            Self::Square => "Square",
            Self::SquareRight => "Square to the right",
        }
    }

    /// The controller for its moves.
    pub(super) fn controller(self, robot: &RobotModel) -> CalibrationMoves {
        let list = match self {
            Self::Nudge => vec![CalibrationMove::Turn(PI / 18.0)],
            Self::Spin => vec![CalibrationMove::Turn(2.0 * PI)],
            Self::Metre => vec![CalibrationMove::Go(1.0)],
            Self::Square => [CalibrationMove::Go(1.0), CalibrationMove::Turn(FRAC_PI_2)].repeat(4),
            Self::SquareRight => [CalibrationMove::Go(1.0), CalibrationMove::Turn(-FRAC_PI_2)].repeat(4),
        };
        CalibrationMoves::new(robot, list)
    }
}

impl Calibrating {
    /// Starts with the current encoder values.
    pub fn new(what: Calibration, began: [u16; 2], measure: Option<FloorMeasure>) -> Self {
        let text = match what {
            Calibration::Nudge => "The robot turns ten degrees. Watch which way it turns.",
            Calibration::Spin => "The robot turns once around, to the left. Remember which way it faces.",
            Calibration::Metre => "The robot drives one metre ahead. Mark where it starts.",
            Calibration::Square => "The robot drives a 1 m square, turning left. Mark where it starts.",
            Calibration::SquareRight => "The robot drives a 1 m square, turning right. Mark where it starts.",
        };
        Self { what, stage: CalibrationStage::Moving, text: text.to_owned(), began, swapped: None, measure }
    }

    /// Whether it moves.
    pub fn is_moving(&self) -> bool {
        self.stage == CalibrationStage::Moving
    }

    /// Whether it waits for an answer of the user.
    pub fn is_asking(&self) -> bool {
        self.stage == CalibrationStage::Asking
    }

    /// Measures a virtual robot on its floor, if it is one.
    pub fn measure(&mut self) -> Option<&mut FloorMeasure> {
        self.measure.as_mut().filter(|_| matches!(self.stage, CalibrationStage::Moving | CalibrationStage::Asking))
    }

    /// The moves were ended early.
    pub fn fail(&mut self, why: &str) {
        (self.stage, self.text) = (CalibrationStage::Failed, why.to_owned());
    }

    /// The moves are done, with the encoder values at their end.
    pub fn stopped(&mut self, now: [u16; 2]) {
        let [first, second] = [0, 1].map(|i| i32::from(encoder_delta(self.began[i], now[i])));
        self.stage = CalibrationStage::Asking;
        self.text = match self.what {
            Calibration::Nudge if first.abs() < LEAST_COUNTS || second.abs() < LEAST_COUNTS => {
                self.fail(UNCOUNTED);
                return;
            }
            Calibration::Nudge if (first > 0) == (second > 0) => {
                self.fail(
                    "Both encoders count in the same direction while turning: they are unreliable on this robot.",
                );
                return;
            }
            Calibration::Nudge => {
                self.swapped = Some(first > 0);
                "Did it turn left (counter-clockwise seen from above)?".to_owned()
            }
            Calibration::Spin => {
                "How far did it turn, in degrees? Once around is 360; less if it stopped short, more if it overshot."
                    .to_owned()
            }
            Calibration::Metre => "How far did it drive, in metres? Measure from front to front.".to_owned(),
            Calibration::Square | Calibration::SquareRight => {
                "How far is it from its starting point, in metres?".to_owned()
            }
        };
    }

    /// Takes the answer to its question; returns the reason if it is refused.
    pub fn answer(&mut self, value: f64, known: &mut Calibrated) -> Result<(), String> {
        let factor = |factor: f64, what: &str| {
            if FACTORS.contains(&factor) {
                Ok(factor)
            } else {
                Err(format!(
                    "{value} can't be right: the {what} would differ by more than 20 % from the model's. Measure again."
                ))
            }
        };
        match self.what {
            Calibration::Nudge if !(0.5..=1.0).contains(&value) => {
                self.fail("Then this robot turns opposite to the specification. Don't drive it from here.");
                return Ok(());
            }
            Calibration::Nudge => {
                known.swapped = self.swapped.unwrap_or(known.swapped);
                self.text = if known.swapped {
                    "Encoder packets 43 and 44 are swapped on this robot; this is now corrected.".to_owned()
                } else {
                    "Packet 43 is the left encoder and 44 the right one, as specified.".to_owned()
                };
            }
            Calibration::Spin => {
                known.base_factor = factor(known.base_factor * 360.0 / value, "wheel base")?;
                self.text = format!("Wheel base {:.1} mm.", 235.0 * known.base_factor);
            }
            Calibration::Metre => {
                let distance = factor(known.distance_factor * value, "wheels")?;
                // Turns are right by now and stay so, as they depend on the ratio of both.
                let base = known.base_factor * distance / known.distance_factor;
                known.base_factor = base.clamp(*FACTORS.start(), *FACTORS.end());
                known.distance_factor = distance;
                self.text = format!("Wheel diameter {:.2} mm.", 72.0 * known.distance_factor);
            }
            Calibration::Square | Calibration::SquareRight if !(0.0..=4.0).contains(&value) => {
                return Err(format!(
                    "{value} m can't be right: the square itself is only one metre wide. Measure again."
                ));
            }
            Calibration::Square | Calibration::SquareRight => {
                self.text = format!(
                    "{:.0} cm off after 4 m and a full turn: {:.1} % of the distance. Usually most of it comes from \
                     turning; Spin corrects that.",
                    100.0 * value,
                    25.0 * value
                );
            }
        }
        self.stage = CalibrationStage::Done;
        Ok(())
    }

    /// View of a calibration, or of none.
    pub fn view(this: Option<&Self>, known: &Calibrated) -> CalibrationView {
        let Calibrated { swapped, distance_factor, base_factor } = *known;
        let mut view =
            CalibrationView { step: "none", swapped, distance_factor, base_factor, ..CalibrationView::default() };
        if let Some(calibrating) = this {
            calibrating.show_on(&mut view);
        }
        view
    }

    fn show_on(&self, view: &mut CalibrationView) {
        let step = match self.stage {
            CalibrationStage::Moving => "moving",
            CalibrationStage::Asking => "asking",
            CalibrationStage::Done => "done",
            CalibrationStage::Failed => "failed",
        };
        let (asks, suggestion) = match self.what {
            _ if self.stage != CalibrationStage::Asking => ("", 0.0),
            Calibration::Nudge => ("yes", 1.0),
            Calibration::Spin => ("deg", 360.0),
            Calibration::Metre => ("m", 1.0),
            Calibration::Square | Calibration::SquareRight => ("m", 0.0),
        };
        (view.what, view.step, view.asks, view.suggestion) = (self.what.id(), step, asks, suggestion);
        view.text.clone_from(&self.text);
        let measure = self.measure.filter(|_| self.stage == CalibrationStage::Asking);
        view.measured = measure.map_or(String::new(), |measure| measure.words(self.what));
    }
}
