//! The light bumper's law: its signals on the way to a wall that the bumper then touches.
//!
//! At the contact the distance is known: none. Before, it is what the wheels rolled. So each wall that is met head-on
//! gives a curve of signal against distance. How much light the wall itself reflects isn't known, so the gain found is that
//! of the sensor times the reflectance of the walls met.

use super::log::{MotionLog, Sample};
use robovac_core::{
    math,
    robot::{LightBumper, LightLaw, RobotModel},
};
use robovac_sim::NoiseLevel;

/// The two beams beside the middle.
const MIDDLE: [usize; 2] = [2, 3];
/// Way before a contact that is looked at, m, and the least way of which something must be seen.
const BEFORE_M: f64 = 0.16;
const LEAST_M: f64 = 0.03;
/// Largest turn on it, rad.
const STRAIGHT: f64 = 0.035;
/// Largest difference between the two beams' signals, as a natural logarithm: a wall that isn't straight ahead.
const ALIKE: f64 = 0.3;
/// Signals above the idle value that are used: less is noise, more is saturated.
const USED: [f64; 2] = [60.0, 3700.0];
/// Least number of readings of all contacts.
const LEAST_POINTS: usize = 12;
/// Largest error of a law that is clearly better than the model's, as a share of the model's (ours).
const CLEARLY: f64 = 0.8;
/// Tried offsets, mm.
const OFFSETS_MM: std::ops::RangeInclusive<u32> = 2..=60;
/// Spreads of idle signals, between the lower fifth percent and the median, above which noise is typical and harsh: in
/// the simulator they are 0, 14 and 71.
const NOISY: [f64; 2] = [4.0, 35.0];

/// A law fitted to contacts, with standard deviations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FittedLaw {
    pub law: LightLaw,
    pub gain_deviation: f64,
    pub offset_deviation: f64,
    /// Walls that were met.
    pub contacts: usize,
    /// Whether it explains them clearly better than the model's law.
    pub is_better: bool,
}

/// Signals of the two middle beams at a distance of a wall ahead.
#[derive(Debug, Clone, Copy)]
pub(super) struct WallSignals {
    /// Distance along the beams from the body's edge, m.
    distance: f64,
    /// Signal above the idle value.
    light: f64,
}

/// Idle signal of a sensor, and the noise level that its spread suggests.
pub(super) fn idle(log: &MotionLog) -> Option<(f64, NoiseLevel)> {
    let signals = log.samples.iter().filter_map(|sample| sample.light);
    let mut middle: Vec<f64> = signals.flat_map(|light| MIDDLE.map(|beam| f64::from(light[beam]))).collect();
    if middle.len() < 200 {
        return None;
    }
    middle.sort_by(f64::total_cmp);
    let part = |share: f64| middle[(share * (middle.len() - 1) as f64) as usize];
    let spread = part(0.5) - part(0.05);
    let level = match spread {
        spread if spread < NOISY[0] => NoiseLevel::Off,
        spread if spread < NOISY[1] => NoiseLevel::Typical,
        _ => NoiseLevel::Harsh,
    };
    Some((part(0.35), level))
}

/// The points before each head-on contact. `robot` converts counts.
pub(super) fn contacts(log: &MotionLog, robot: &RobotModel, light: &LightBumper) -> Vec<Vec<WallSignals>> {
    let Some((idle, _)) = idle(log) else { return Vec::new() };
    let mut found = Vec::new();
    for (index, pair) in log.samples.windows(2).enumerate() {
        let [before, now] = pair else { continue };
        if before.bumps == [false; 2] && now.bumps == [true; 2] && !now.is_after_gap {
            let points = approach(&log.samples[..=index + 1], robot, light, idle);
            if points.iter().map(|p| p.distance).fold(0.0, f64::max) > LEAST_M {
                found.push(points);
            }
        }
    }
    found
}

/// The points on the way to the contact at the last sample; none if it wasn't straight and head-on.
fn approach(samples: &[Sample], robot: &RobotModel, light: &LightBumper, idle: f64) -> Vec<WallSignals> {
    let (mut points, mut unlike) = (Vec::new(), Vec::new());
    let Some((contact, earlier)) = samples.split_last() else { return points };
    let cosine = math::cos(light.angles[MIDDLE[0]]);
    for sample in earlier.iter().rev() {
        let [left, right] = [0, 1].map(|wheel| (contact.counts[wheel] - sample.counts[wheel]) / robot.counts_per_metre);
        let (gap, turn) = (0.5 * (left + right), (right - left) / robot.wheel_base);
        if gap > BEFORE_M || sample.is_after_gap || sample.bumps != [false; 2] {
            break;
        }
        if turn.abs() > STRAIGHT || gap < 0.0 {
            return Vec::new();
        }
        let Some(signals) = sample.light else { continue };
        let [one, other] = MIDDLE.map(|beam| f64::from(signals[beam]) - idle);
        if one.min(other) < USED[0] || one.max(other) > USED[1] {
            continue;
        }
        unlike.push((one / other).ln().abs());
        points
            .push(WallSignals { distance: (robot.radius + gap) / cosine - robot.radius, light: (one * other).sqrt() });
    }
    if unlike.iter().sum::<f64>() > ALIKE * unlike.len() as f64 {
        return Vec::new();
    }
    points
}

/// Fits the law to contacts; `None` without enough of them.
pub(super) fn fit(contacts: &[Vec<WallSignals>], light: &LightBumper) -> Option<FittedLaw> {
    let points: Vec<WallSignals> = contacts.iter().flatten().copied().collect();
    if points.len() < LEAST_POINTS {
        return None;
    }
    let cosine = math::cos(light.angles[MIDDLE[0]]);
    let errors = |law: LightLaw| -> Vec<f64> {
        let light = LightBumper { law, ..*light };
        points.iter().map(|p| (p.light / light.light_at(p.distance, cosine).max(1e-3)).ln()).collect()
    };
    let squares = |law: LightLaw| errors(law).iter().map(|e| e * e).sum::<f64>();
    let with_gain = |offset_m: f64| {
        // The gain that takes the mean error away; saturation bends it, so a few times.
        let mut law = LightLaw { offset_m, ..light.law };
        for _ in 0..6 {
            let mean = errors(law).iter().sum::<f64>() / points.len() as f64;
            law.gain_m2 = (law.gain_m2 * mean.exp()).clamp(0.05, 200.0);
        }
        law
    };
    let tried = OFFSETS_MM.map(|mm| with_gain(f64::from(mm) / 1000.0));
    let mut best = tried.min_by(|a, b| squares(*a).total_cmp(&squares(*b)))?;
    for part in [0.5, 0.25, 0.1_f64] {
        for sign in [-1.0, 1.0] {
            let other = with_gain((best.offset_m + sign * part / 1000.0).max(0.0));
            if squares(other) < squares(best) {
                best = other;
            }
        }
    }
    let law = best;
    // Readings of one contact err together: a contact is late by up to a reading. So contacts count, not readings.
    let number = points.len() as f64;
    let variance = squares(law) / (number - 2.0).max(1.0) * (number / contacts.len() as f64).max(1.0);
    let base = errors(law);
    let steps = [0.001_f64, 0.0005];
    let moved = [
        errors(LightLaw { gain_m2: law.gain_m2 * steps[0].exp(), ..law }),
        errors(LightLaw { offset_m: law.offset_m + steps[1], ..law }),
    ];
    let slope = |column: usize, row: usize| (moved[column][row] - base[row]) / steps[column];
    let product = |i: usize, j: usize| (0..base.len()).map(|row| slope(i, row) * slope(j, row)).sum::<f64>();
    let determinant = product(0, 0) * product(1, 1) - product(0, 1) * product(0, 1);
    if determinant.is_nan() || determinant <= 0.0 {
        return None;
    }
    let [of_gain, of_offset] = [product(1, 1), product(0, 0)].map(|minor| (variance * minor / determinant).sqrt());
    Some(FittedLaw {
        law,
        gain_deviation: law.gain_m2 * of_gain,
        offset_deviation: of_offset,
        contacts: contacts.len(),
        is_better: squares(law) < CLEARLY * CLEARLY * squares(light.law),
    })
}

/// Root mean square of the logarithm of measured over predicted signals.
pub(super) fn misfit(contacts: &[Vec<WallSignals>], light: &LightBumper) -> Option<f64> {
    let cosine = math::cos(light.angles[MIDDLE[0]]);
    let errors: Vec<f64> =
        contacts.iter().flatten().map(|p| (p.light / light.light_at(p.distance, cosine).max(1e-3)).ln()).collect();
    let mean = errors.iter().map(|e| e * e).sum::<f64>() / errors.len().max(1) as f64;
    (errors.len() >= LEAST_POINTS).then(|| mean.sqrt())
}
