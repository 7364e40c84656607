//! How wheels follow commands: speed, acceleration, delay.
//!
//! A Roomba regulates the speed of its wheels by their encoders, so that commands and counts together tell how many
//! counts the robot takes for a millimetre, how fast its speed changes, and how late it obeys; but not the size of its
//! wheels.

use super::log::{CommandedSpeeds, MotionLog, Sample};
use robovac_core::robot::RobotModel;
use robovac_sim::kept_speed;

/// Readings whose counts are compared together: fewer would be hidden by rounding, more would hide acceleration.
const TOGETHER: usize = 4;
/// Time after which the speed that a command gave no longer matters, s.
const SETTLED_S: f64 = 0.5;
/// Most stretches on which a fit is based: eight minutes of driving.
const MOST: usize = 8000;
/// Least counts of a wheel on which a fit is based: 30 cm.
const LEAST_COUNTS: f64 = 700.0;
/// Tried accelerations, m/s², and delays, s.
const ACCELERATIONS: [f64; 14] = [0.2, 0.3, 0.4, 0.55, 0.7, 0.9, 1.1, 1.4, 1.8, 2.3, 2.9, 3.7, 4.7, 6.0];
const DELAYS: [f64; 9] = [0.0, 0.01, 0.02, 0.03, 0.045, 0.06, 0.08, 0.1, 0.14];
/// Least improvement that makes wheels of fixed speeds credible.
const CLEARLY: f64 = 0.7;

/// How wheels follow commands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Response {
    /// Counts for a commanded millimetre, as a share of the model's.
    pub scale: f64,
    /// Acceleration if the model's wheels rolled, m/s².
    pub acceleration: f64,
    /// From a command to its effect in the readings, s.
    pub delay_s: f64,
    /// Whether the wheels turn only at the speeds that the motor controller keeps.
    pub is_quantised: bool,
}

impl Response {
    /// The model's wheels.
    pub fn of(robot: &RobotModel, delay_s: f64) -> Self {
        Self { scale: 1.0, acceleration: robot.acceleration, delay_s, is_quantised: false }
    }
}

/// A response fitted to a recording, with standard deviations.
#[derive(Debug, Clone, Copy)]
pub(super) struct FittedResponse {
    pub response: Response,
    pub scale_deviation: f64,
    pub acceleration_deviation: f64,
    /// Difference from the recorded counts in four readings, root mean square.
    pub noise_counts: f64,
    /// Whether wheels of fixed speeds could be told from others.
    pub is_quantised_known: bool,
}

/// A stretch of readings: what was counted, and what the model's count would be.
#[derive(Debug, Clone, Copy)]
pub(super) struct Compared {
    /// Counted by the robot.
    pub counted: f64,
    /// Predicted with a scale of one.
    pub predicted: f64,
}

/// Stretches of `together` readings in which nothing but commands moved the wheels: their first and last readings.
pub(super) fn stretches(log: &MotionLog, together: usize) -> Vec<[usize; 2]> {
    let mut found = Vec::new();
    let mut told = log.told.iter().peekable();
    let (mut is_known, mut blind_until, mut from) = (true, f64::NEG_INFINITY, 0);
    for (index, now) in log.samples.iter().enumerate() {
        while let Some(next) = told.next_if(|told| told.at < now.at) {
            is_known = next.speeds.is_some();
        }
        if now.is_after_gap || !is_known || !now.obeys || now.bumps != [false; 2] {
            blind_until = now.at + SETTLED_S;
        }
        if now.at < blind_until {
            from = index;
        } else if index - from == together {
            found.push([from, index]);
            from = index;
        }
    }
    found
}

/// Compares the counts of stretches with those that a response predicts, for each wheel.
pub(super) fn compare(
    log: &MotionLog,
    robot: &RobotModel,
    response: &Response,
    stretches: &[[usize; 2]],
) -> Vec<Compared> {
    let counts_per_mm = robot.counts_per_metre / 1000.0;
    let mut compared = Vec::with_capacity(2 * stretches.len());
    for wheel in 0..2 {
        let mut follower = LaggingWheel::new(&log.told, robot, response, wheel);
        let mut stretches = stretches.iter().peekable();
        let (mut way, mut from) = (0.0, 0.0);
        for (index, pair) in log.samples.windows(2).enumerate() {
            let ([before, now], Some(_)) = (pair, stretches.peek()) else { break };
            if stretches.peek().is_some_and(|[first, _]| *first == index) {
                from = way;
            }
            way += follower.advance(before, now);
            if let Some([first, last]) = stretches.next_if(|[_, last]| *last == index + 1) {
                let counted = log.samples[*last].counts[wheel] - log.samples[*first].counts[wheel];
                compared.push(Compared { counted, predicted: (way - from) * counts_per_mm });
            }
        }
    }
    compared
}

/// Finds the response that explains the counts best; `None` if the robot wasn't driven far enough by commands.
pub(super) fn fit(log: &MotionLog, robot: &RobotModel) -> Option<FittedResponse> {
    let stretches = moving(log, stretches(log, TOGETHER));
    let drive = ComparedDrive { log, robot, stretches: &stretches };
    let way: f64 = drive.compare(&Response::of(robot, 0.0)).iter().map(|c| c.counted.abs()).sum();
    if way < 2.0 * LEAST_COUNTS {
        return None;
    }
    let [free, quantised] = [false, true].map(|is_quantised| drive.best(is_quantised));
    let is_quantised = quantised.1 < CLEARLY * free.1;
    let (response, squares) = if is_quantised { quantised } else { free };
    let (less, more) = (free.1.min(quantised.1), free.1.max(quantised.1));
    let base = drive.residuals(&response);
    let moving = drive.compare(&response).iter().filter(|c| c.counted.abs().max(c.predicted.abs()) > 1.5).count();
    let number = moving.max(4) as f64;
    let variance = squares / (number - 3.0).max(1.0);
    // The Jacobian, by differences.
    let step = [1e-4, 0.02 * response.acceleration, 0.002];
    let moved = [
        Response { scale: response.scale + step[0], ..response },
        Response { acceleration: response.acceleration + step[1], ..response },
        Response { delay_s: response.delay_s + step[2], ..response },
    ];
    let columns: Vec<Vec<f64>> = moved
        .iter()
        .zip(step)
        .map(|(other, step)| drive.residuals(other).iter().zip(&base).map(|(a, b)| (a - b) / step).collect())
        .collect();
    let product = |i: usize, j: usize| columns[i].iter().zip(&columns[j]).map(|(a, b)| a * b).sum::<f64>();
    let deviations = inverse_diagonal([0, 1, 2].map(|i| [0, 1, 2].map(|j| product(i, j))))
        .map(|diagonal| (variance * diagonal).max(0.0).sqrt());
    Some(FittedResponse {
        response,
        scale_deviation: deviations[0],
        acceleration_deviation: deviations[1],
        noise_counts: (squares / number).sqrt(),
        is_quantised_known: less < CLEARLY * more,
    })
}

/// The first [`MOST`] stretches at which the wheels turned, or just before or after.
fn moving(log: &MotionLog, mut stretches: Vec<[usize; 2]>) -> Vec<[usize; 2]> {
    let has_turned = |&[first, last]: &[usize; 2]| log.samples[first].counts != log.samples[last].counts;
    let turned: Vec<bool> = stretches.iter().map(has_turned).collect();
    let mut index = 0;
    stretches.retain(|_| {
        index += 1;
        turned.iter().take(index + 1).skip(index.saturating_sub(2)).any(|&turned| turned)
    });
    stretches.truncate(MOST);
    stretches
}

/// Readings to compare with predictions.
struct ComparedDrive<'a> {
    log: &'a MotionLog,
    robot: &'a RobotModel,
    stretches: &'a [[usize; 2]],
}

impl ComparedDrive<'_> {
    fn compare(&self, response: &Response) -> Vec<Compared> {
        compare(self.log, self.robot, response, self.stretches)
    }

    fn residuals(&self, response: &Response) -> Vec<f64> {
        self.compare(response).iter().map(|c| c.counted - response.scale * c.predicted).collect()
    }

    /// The best response with or without fixed speeds, and its sum of squares.
    fn best(&self, is_quantised: bool) -> (Response, f64) {
        let tried = |acceleration: f64, delay_s: f64| {
            let response = Response { scale: 1.0, acceleration, delay_s, is_quantised };
            let compared = self.compare(&response);
            let sum = |f: fn(&Compared) -> f64| compared.iter().map(f).sum::<f64>();
            let squares = sum(|c| c.predicted * c.predicted);
            let scale = if squares > 0.0 { sum(|c| c.predicted * c.counted) / squares } else { 1.0 };
            let left: f64 = compared.iter().map(|c| (c.counted - scale * c.predicted).powi(2)).sum();
            (Response { scale, ..response }, left)
        };
        let grid = ACCELERATIONS.iter().flat_map(|&a| DELAYS.iter().map(move |&d| (a, d)));
        let start = grid.map(|(a, d)| tried(a, d)).min_by(|a, b| a.1.total_cmp(&b.1));
        let Some(mut best) = start else { return (Response::of(self.robot, 0.0), f64::INFINITY) };
        let mut step = (1.25_f64, 0.008);
        for _ in 0..9 {
            let Response { acceleration, delay_s, .. } = best.0;
            let around = [
                (acceleration * step.0, delay_s),
                (acceleration / step.0, delay_s),
                (acceleration, delay_s + step.1),
                (acceleration, (delay_s - step.1).max(0.0)),
                (acceleration * step.0, delay_s + step.1),
                (acceleration / step.0, (delay_s - step.1).max(0.0)),
            ];
            let better = around.into_iter().map(|(a, d)| tried(a, d)).min_by(|a, b| a.1.total_cmp(&b.1));
            match better.filter(|better| better.1 < best.1) {
                Some(better) => best = better,
                None => step = (step.0.sqrt(), 0.5 * step.1),
            }
        }
        best
    }
}

/// Diagonal of the inverse of a symmetric matrix; infinite where it has none.
fn inverse_diagonal(m: [[f64; 3]; 3]) -> [f64; 3] {
    let minor = |i: usize, j: usize| m[i][i] * m[j][j] - m[i][j] * m[j][i];
    let determinant = m[0][0] * minor(1, 2) - m[0][1] * (m[0][1] * m[2][2] - m[1][2] * m[0][2])
        + m[0][2] * (m[0][1] * m[1][2] - m[1][1] * m[0][2]);
    let scale = m[0][0] * m[1][1] * m[2][2];
    if determinant.is_nan() || determinant <= 1e-9 * scale {
        return [f64::INFINITY; 3];
    }
    [minor(1, 2) / determinant, minor(0, 2) / determinant, minor(0, 1) / determinant]
}

/// A wheel that follows commands.
struct LaggingWheel<'a> {
    told: std::iter::Peekable<std::slice::Iter<'a, CommandedSpeeds>>,
    response: Response,
    steps: [f64; 2],
    wheel: usize,
    /// Acceleration, mm/s².
    acceleration: f64,
    /// Speeds, mm/s: the wanted one, and the present one.
    wanted: f64,
    speed: f64,
}

impl<'a> LaggingWheel<'a> {
    fn new(told: &'a [CommandedSpeeds], robot: &RobotModel, response: &Response, wheel: usize) -> Self {
        Self {
            told: told.iter().peekable(),
            response: *response,
            steps: robot.speed_steps,
            wheel,
            acceleration: 1000.0 * response.acceleration,
            wanted: 0.0,
            speed: 0.0,
        }
    }

    /// The way, mm, from one reading to the next.
    fn advance(&mut self, before: &Sample, now: &Sample) -> f64 {
        let (mut at, mut way) = (before.at, 0.0);
        while let Some(told) = self.told.next_if(|told| told.at + self.response.delay_s < now.at) {
            let then = (told.at + self.response.delay_s).max(at);
            way += self.roll(then - at);
            at = then;
            let speed = told.speeds.map_or(0.0, |speeds| speeds[self.wheel].clamp(-500.0, 500.0));
            let is_quantised = self.response.is_quantised;
            self.wanted = if is_quantised { 1000.0 * kept_speed(speed / 1000.0, self.steps) } else { speed };
        }
        if !now.obeys {
            // It stopped by itself, or one of its own programs drives it.
            (self.wanted, self.speed) = (0.0, 0.0);
        }
        way + self.roll(now.at - at)
    }

    fn roll(&mut self, time: f64) -> f64 {
        let (before, wanted) = (self.speed, self.wanted);
        let ramp = ((wanted - before).abs() / self.acceleration).min(time);
        self.speed = if ramp < time { wanted } else { before + (wanted - before).signum() * self.acceleration * time };
        0.5 * (before + self.speed) * ramp + wanted * (time - ramp)
    }
}
