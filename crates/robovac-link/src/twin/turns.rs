//! Full turns: beside something that reflects light, the light bumper sees the same again after exactly 360 degrees.
//!
//! This needs no tape: the room itself tells when a turn is complete. With the counts between, it gives the ratio of wheel
//! base and wheel size, which is all that a heading by counts depends on. How much one turn differs from the next tells
//! how much the wheels slip.

use super::{
    counts_per_turn,
    log::{Measured, MotionLog, Sample},
};
use robovac_core::math::PI;

/// Channels of the light bumper.
const CHANNELS: usize = 6;
/// Distance of points on a turn, counts (right less left): about a degree.
const STEP: f64 = 9.0;
/// Most points of a turn on the spot: about fifty full turns.
const MOST_POINTS: usize = 20_000;
/// Readings that are looked at together to see whether the robot turns, and their least counts.
const TOGETHER: usize = 8;
const LEAST: f64 = 8.0;
/// Motion ahead during a turn on the spot: as a share of the turn, and in all, counts (sum of both wheels).
const AHEAD: (f64, f64) = (0.25, 130.0);
/// Shortest and longest full turns that are tried, as shares of the model's.
const TRIED: [f64; 2] = [0.8, 1.25];
/// Least part of a turn that is seen twice.
const OVERLAP: f64 = 0.15;
/// Largest difference between two turns, as a share of that between any two directions (ours).
const ALIKE: f64 = 0.35;
/// Least variance of two parts that are compared, as a share of the whole turn's: empty floor is like empty floor.
const VARIED: f64 = 0.4;
/// Share of the model's turn around which single turns are compared.
const NEAR: f64 = 0.04;
/// Uncertainty of an angle that a person measured, degrees.
const BY_EYE_DEG: f64 = 2.0;
/// Least uncertainty of a turn by light, as a share: the robot's place moves a little, too.
const LEAST_SHARE: f64 = 0.0007;
/// Least number of turns that tell slip.
const FOR_SLIP: usize = 4;

/// Counts of a full turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FullTurn {
    /// Counts, right less left.
    pub counts: f64,
    /// Its standard deviation.
    pub deviation: f64,
    /// Turns compared by light, and turns measured by a person.
    pub turns: [usize; 2],
    /// Standard deviation of a single turn due to slip, rad; `None` with too few turns.
    pub slip_rad: Option<f64>,
}

/// The full turns of a recording, by light and by a person.
pub(super) fn measure(log: &MotionLog) -> Option<FullTurn> {
    let single: Vec<(f64, f64)> = spins(&log.samples).iter().flat_map(Spin::turns).collect();
    let by_eye = log.measured.iter().filter_map(|measured| match *measured {
        Measured::Turn(counts, degrees) => {
            Some((counts * 360.0 / degrees, counts * 360.0 / degrees * BY_EYE_DEG / degrees))
        }
        Measured::Way(..) => None,
    });
    let by_eye: Vec<(f64, f64)> = by_eye.collect();
    let mut slip_rad = None;
    let by_light = (!single.is_empty()).then(|| {
        let slip = slip_variance(&single);
        let (mean, deviation) = mean(&single, slip);
        if single.len() >= FOR_SLIP {
            slip_rad = Some(slip.sqrt() / mean * 2.0 * PI);
        }
        (mean, deviation.max(LEAST_SHARE * mean))
    });
    let turns = [single.len(), by_eye.len()];
    let weighed: Vec<(f64, f64)> = by_light.into_iter().chain(by_eye).collect();
    let weight: f64 = weighed.iter().map(|(_, deviation)| deviation.powi(-2)).sum();
    (weight > 0.0).then(|| FullTurn {
        counts: weighed.iter().map(|(counts, deviation)| counts * deviation.powi(-2)).sum::<f64>() / weight,
        deviation: weight.powf(-0.5),
        turns,
        slip_rad,
    })
}

/// Weighed mean of values with their deviations and a variance that all have beside, and its deviation.
fn mean(values: &[(f64, f64)], common: f64) -> (f64, f64) {
    let weight = |deviation: f64| 1.0 / (deviation * deviation + common).max(f64::MIN_POSITIVE);
    let sum: f64 = values.iter().map(|(_, deviation)| weight(*deviation)).sum();
    (values.iter().map(|(value, deviation)| value * weight(*deviation)).sum::<f64>() / sum, sum.powf(-0.5))
}

/// The variance that values have beyond that of their deviations (`DerSimonian` & Laird, Meta-analysis in clinical trials,
/// Controlled Clinical Trials 7, 1986).
fn slip_variance(values: &[(f64, f64)]) -> f64 {
    let (mean, _) = mean(values, 0.0);
    let (mut sum, mut squares, mut excess) = (0.0, 0.0, 1.0 - values.len() as f64);
    for (value, deviation) in values {
        let weight = deviation.powi(-2);
        sum += weight;
        squares += weight * weight;
        excess += weight * (value - mean).powi(2);
    }
    let freedom = sum - squares / sum;
    if freedom > 0.0 { (excess / freedom).max(0.0) } else { 0.0 }
}

/// A turn on the spot: square roots of the light signals at even distances of counts.
struct Spin {
    points: Vec<[f64; CHANNELS]>,
    /// Points for each reading: those between two readings have no noise of their own.
    per_reading: f64,
}

/// The turns on the spot that are longer than a full one.
fn spins(samples: &[Sample]) -> Vec<Spin> {
    let (mut spins, mut spin, mut sign, mut ahead) = (Vec::new(), Vec::<Sample>::new(), 0.0, 0.0);
    let mut end = |spin: &mut Vec<Sample>| spins.extend(Spin::of(&std::mem::take(spin)));
    for block in samples.chunks(TOGETHER) {
        let ([first, .., last], false) = (block, block.iter().any(|s| s.is_after_gap || s.light.is_none())) else {
            end(&mut spin);
            continue;
        };
        // From the end of the block before, so that no count is missed.
        let first = spin.last().unwrap_or(first);
        let [left, right] = [0, 1].map(|wheel| last.counts[wheel] - first.counts[wheel]);
        let (turned, went) = (right - left, right + left);
        let is_still = turned.abs() < LEAST && went.abs() < LEAST;
        let is_turning = turned.abs() >= LEAST && went.abs() <= AHEAD.0 * turned.abs();
        let goes_on = is_turning && (sign == 0.0 || turned.signum() == sign) && (ahead + went).abs() <= AHEAD.1;
        if !is_still && !goes_on {
            end(&mut spin);
            (sign, ahead) = (0.0, 0.0);
            if !is_turning {
                continue;
            }
        }
        if is_turning {
            sign = turned.signum();
        }
        ahead += went;
        spin.extend(block);
    }
    end(&mut spin);
    spins
}

impl Spin {
    fn of(samples: &[Sample]) -> Option<Self> {
        let (first, last) = (samples.first()?, samples.last()?);
        let at = |sample: &Sample| ((sample.counts[1] - first.counts[1]) - (sample.counts[0] - first.counts[0])).abs();
        if at(last) < (TRIED[0] + OVERLAP) * counts_per_turn() {
            return None;
        }
        let roots = |sample: &Sample| sample.light.unwrap_or_default().map(|signal| f64::from(signal).sqrt());
        let mut points = Vec::new();
        // Between two readings, the signal is taken to change evenly. A wheel that jitters back is left out.
        let mut before = (at(first), roots(first));
        for sample in samples {
            let now = (at(sample), roots(sample));
            while now.0 > before.0 && points.len() < MOST_POINTS && points.len() as f64 * STEP <= now.0 {
                let share = ((points.len() as f64 * STEP - before.0) / (now.0 - before.0)).clamp(0.0, 1.0);
                points.push(std::array::from_fn(|k| before.1[k] + share * (now.1[k] - before.1[k])));
            }
            if now.0 >= before.0 {
                before = now;
            }
        }
        let per_reading = (points.len() as f64 / samples.len() as f64).max(1.0);
        Some(Self { points, per_reading })
    }

    /// Each full turn that is seen, counts, with its standard deviation.
    fn turns(&self) -> Vec<(f64, f64)> {
        let model = counts_per_turn() / STEP;
        let end = self.points.len() as f64;
        let most = (TRIED[1] * model).min(end - OVERLAP * model);
        let whole = |period: f64| self.unlikeness(0.0, end - period, period);
        let Some((about, _)) = lowest(TRIED[0] * model, most, 1.0, whole) else { return Vec::new() };
        let mut turns = Vec::new();
        let mut from = 0.0;
        // Turn by turn; the last one may be a part.
        while end - from - about >= OVERLAP * model {
            let until = (from + about).min(end - about * (1.0 + NEAR)).max(from + OVERLAP * model - 2.0);
            let near = [about * (1.0 - NEAR), (about * (1.0 + NEAR)).min(end - until)];
            let each = |period: f64| self.unlikeness(from, until, period);
            if let Some((period, unlikeness)) = lowest(near[0], near[1], 0.25, each) {
                let (slopes, difference) = (self.slopes(from, until), self.difference(from, until, period));
                if unlikeness < ALIKE && slopes > 0.0 {
                    let deviation = (self.per_reading * difference / CHANNELS as f64 / slopes).sqrt();
                    turns.push((period * STEP, deviation * STEP));
                }
            }
            from += about;
        }
        turns
    }

    /// How little the points from `from` to `until` are like those a period later: 0 for the same, 1 for any others.
    /// Infinite where there is nothing to compare.
    fn unlikeness(&self, from: f64, until: f64, period: f64) -> f64 {
        let varied = self.variance(from, until) + self.variance(from + period, until + period);
        if varied < VARIED * self.variance(0.0, self.points.len() as f64) {
            return f64::INFINITY;
        }
        self.difference(from, until, period) / varied
    }

    /// Mean square difference between the points from `from` to `until` and those a period later, all channels together.
    fn difference(&self, from: f64, until: f64, period: f64) -> f64 {
        let (whole, part) = (period.floor(), period.fract());
        let (mut sum, mut number) = (0.0, 0.0);
        for index in from.max(0.0) as usize..until.max(0.0) as usize {
            let later = index + whole as usize;
            let (Some(here), Some(there), Some(next)) =
                (self.points.get(index), self.points.get(later), self.points.get(later + 1))
            else {
                break;
            };
            for k in 0..CHANNELS {
                let value = there[k] + part * (next[k] - there[k]);
                sum += (value - here[k]).powi(2);
            }
            number += 1.0;
        }
        if number > 0.0 { sum / number } else { f64::INFINITY }
    }

    /// Sum of the squared slopes, all channels together, per square of a step.
    fn slopes(&self, from: f64, until: f64) -> f64 {
        // Over some steps, so that noise doesn't count as a slope.
        const APART: usize = 6;
        let between = |pair: &[[f64; CHANNELS]]| match pair {
            [before, .., after] => (0..CHANNELS).map(|k| ((after[k] - before[k]) / APART as f64).powi(2)).sum(),
            _ => 0.0,
        };
        self.part(from, until).windows(APART + 1).map(between).sum()
    }

    fn part(&self, from: f64, until: f64) -> &[[f64; CHANNELS]] {
        let index = |at: f64| (at.max(0.0) as usize).min(self.points.len());
        self.points.get(index(from)..index(until)).unwrap_or_default()
    }

    /// Variance of the points from `from` to `until`, all channels together.
    fn variance(&self, from: f64, until: f64) -> f64 {
        let part = self.part(from, until);
        let number = part.len().max(1) as f64;
        let (mut sum, mut squares) = ([0.0; CHANNELS], 0.0);
        for point in part {
            for k in 0..CHANNELS {
                sum[k] += point[k];
                squares += point[k] * point[k];
            }
        }
        (squares - sum.iter().map(|sum| sum * sum).sum::<f64>() / number) / number
    }
}

/// The place between two bounds, not at them, where a function is lowest, refined by a parabola; and the value there.
fn lowest(from: f64, to: f64, step: f64, value: impl Fn(f64) -> f64) -> Option<(f64, f64)> {
    let number = ((to - from) / step).max(0.0) as usize;
    let at = |index: usize| from + step * index as f64;
    let values: Vec<f64> = (0..=number).map(|index| value(at(index))).collect();
    let best = (0..values.len()).min_by(|&a, &b| values[a].total_cmp(&values[b]))?;
    let (Some(before), Some(after)) = (best.checked_sub(1).and_then(|i| values.get(i)), values.get(best + 1)) else {
        return None;
    };
    let bend = before - 2.0 * values[best] + after;
    let aside = if bend > 0.0 { (0.5 * (before - after) / bend).clamp(-0.5, 0.5) } else { 0.0 };
    Some((at(best) + aside * step, values[best]))
}
