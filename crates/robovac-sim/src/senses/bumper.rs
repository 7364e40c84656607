//! Bumper switches.
//!
//! Noise: a switch bounces when it closes, so that it can read open for a while (002, section III.A, finds that its
//! switches need no filter: at "typical" it is one reading in four, in the first 15 ms only). At "harsh" the bumper is
//! stiff: each half reads open every other time during the first 60 ms. The figures are ours.

use super::{Carrier, Noisy};
use crate::SensorKind;
use robovac_core::{geometry::difference, math, robot::RobotModel};

/// How long each half of the bumper has been pressed, steps: left, right.
#[derive(Debug, Clone, Default)]
pub(super) struct Switches([u8; 2]);

impl Switches {
    /// Which halves read as pressed: left, right.
    pub fn pressed(&mut self, model: &RobotModel, carrier: &Carrier, noise: &Noisy<'_>) -> (bool, bool) {
        let halves = touched(model, carrier);
        for (steps, touched) in self.0.iter_mut().zip(halves) {
            *steps = if touched { steps.saturating_add(1) } else { 0 };
        }
        if halves == [false; 2] {
            return (false, false);
        }
        let (unsure, probability) = noise.pick(SensorKind::Bumper, [(0, 0.0), (1, 0.25), (4, 0.5)]);
        let closed = |half: usize| {
            let bounces = self.0[half] <= unsure && noise.happens(SensorKind::Bumper, half, probability);
            halves[half] && !bounces
        };
        (closed(0), closed(1))
    }
}

/// The touched halves of the bumper. Contacts outside its arc press nothing.
fn touched(model: &RobotModel, carrier: &Carrier) -> [bool; 2] {
    let mut halves = [false; 2];
    let Some(bumper) = model.sensors.bumper else { return halves };
    for touch in carrier.touch.iter() {
        let angle = difference(carrier.pose.heading, math::atan2(touch.y, touch.x));
        if angle.abs() <= bumper.half_arc {
            halves[0] |= angle >= -bumper.both_within;
            halves[1] |= angle <= bumper.both_within;
        }
    }
    halves
}
