//! What a ruler and a protractor on the floor would say of a virtual robot that is calibrated.

use super::Calibration;
use robovac_core::geometry::{Pose, difference};

/// A motion from its beginning.
#[derive(Debug, Clone, Copy)]
struct MeasuredMotion {
    began: Pose,
    now: Pose,
    /// Sum of its turns, rad, counter-clockwise.
    turned: f64,
}

impl MeasuredMotion {
    fn new(began: Pose) -> Self {
        Self { began, now: began, turned: 0.0 }
    }

    fn go_on(&mut self, pose: Pose) {
        self.turned += difference(self.now.heading, pose.heading);
        self.now = pose;
    }

    /// Seen from where it began: m ahead, m to the left, and rad to the left, -π to π.
    fn end(&self) -> [f64; 3] {
        let (sin, cos) = (self.began.direction().y, self.began.direction().x);
        let moved = self.now.position() - self.began.position();
        let turned = difference(self.began.heading, self.now.heading);
        [cos * moved.x + sin * moved.y, cos * moved.y - sin * moved.x, turned]
    }
}

/// The true and the estimated motion since a calibration began.
#[derive(Debug, Clone, Copy)]
pub(super) struct FloorMeasure {
    truth: MeasuredMotion,
    estimate: MeasuredMotion,
    is_over: bool,
}

impl FloorMeasure {
    /// Begins with the true and the estimated pose.
    pub fn new(truth: Pose, estimate: Pose) -> Self {
        Self { truth: MeasuredMotion::new(truth), estimate: MeasuredMotion::new(estimate), is_over: false }
    }

    /// The robot is there now.
    pub fn go_on(&mut self, truth: Pose, estimate: Pose) {
        if !self.is_over {
            self.truth.go_on(truth);
            self.estimate.go_on(estimate);
        }
    }

    /// A hand moves the robot: what was measured before stays.
    pub fn end(&mut self) {
        self.is_over = true;
    }

    /// A sentence on what matters for this calibration.
    pub fn words(&self, what: Calibration) -> String {
        let [x, y, heading] = self.truth.end();
        let said = match what {
            Calibration::Nudge | Calibration::Spin => format!("turned {}°", signed(self.truth.turned.to_degrees(), 1)),
            Calibration::Metre => format!("{} m from where it began", signed(x.hypot(y), 3)),
            Calibration::Square | Calibration::SquareRight => {
                let off = [0, 1, 2].map(|i| self.truth.end()[i] - self.estimate.end()[i]);
                format!(
                    "{} m from where it began (x {} m ahead, y {} m to the left), turned {}°. \
                     True minus estimated: x {} m, y {} m, {}°",
                    signed(x.hypot(y), 3),
                    signed(x, 3),
                    signed(y, 3),
                    signed(heading.to_degrees(), 1),
                    signed(off[0], 3),
                    signed(off[1], 3),
                    signed(difference(0.0, off[2]).to_degrees(), 1),
                )
            }
        };
        format!("Measured on the virtual floor: {said}.")
    }
}

/// A number with so many decimals, and a minus sign instead of a hyphen.
fn signed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.bytes().all(|b| matches!(b, b'0' | b'.')) => digits.to_owned(),
        Some(digits) => format!("−{digits}"),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::math::{FRAC_PI_2, PI};

    #[test]
    fn it_measures_from_where_the_robot_began_and_faced() {
        // Facing up: ahead is y, and the left is -x.
        let mut measure = FloorMeasure::new(Pose::new(2.0, 1.0, FRAC_PI_2), Pose::new(0.0, 0.0, 0.0));
        for quarter in 1..=4 {
            let turn = f64::from(quarter) * FRAC_PI_2;
            measure.go_on(Pose::new(1.97, 1.04, FRAC_PI_2 + turn), Pose::new(0.01, 0.0, turn));
        }
        let square = measure.words(Calibration::Square);
        assert!(
            square.contains("0.050 m from where it began (x 0.040 m ahead, y 0.030 m to the left), turned 0.0°"),
            "{square}"
        );
        assert!(square.ends_with("True minus estimated: x 0.030 m, y 0.030 m, 0.0°."), "{square}");
        assert!(measure.words(Calibration::Spin).contains("turned 360.0°"));
        measure.end();
        measure.go_on(Pose::new(9.0, 9.0, PI), Pose::new(0.0, 0.0, 0.0));
        assert_eq!(measure.words(Calibration::Square), square, "a hand has moved it since");
    }
}
