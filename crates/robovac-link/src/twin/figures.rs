//! All figures of a twin: found, or the model's with the reason.

use super::{
    counts_per_turn,
    light::{self, FittedLaw},
    log::{Measured, MotionLog},
    model_mm_per_count,
    turns::{self, FullTurn},
    wheels::{self, FittedResponse},
};
use robovac_core::{
    math::PI,
    robot::{LightBumper, LightLaw, RobotModel, Twin},
};
use robovac_sim::{
    NoiseLevel, SlipLevel,
    experiment::{TwinFigure, TwinFile},
};

/// Uncertainty of a metre that a person measured, m.
const BY_TAPE_M: f64 = 0.005;
/// Least mean of the distances that a robot reports for its own idea of a count to be read off them, mm, and their least
/// number.
const REPORTED: (f64, f64) = (20.0, 30.0);
/// Difference from the specification from which the robot's own idea of a count is that of other wheels.
const OTHER_WHEELS: f64 = 0.02;
/// Largest uncertainty of an acceleration that counts as known, as a share of it.
const VAGUE: f64 = 0.25;
/// Slip after a metre, m, between the simulator's levels of 0, 1 and 6 mm.
const SLIPS: [f64; 2] = [0.0005, 0.0025];
/// Scatter of counts in four readings by rounding alone.
const ROUNDING: f64 = 0.41;

/// What was found.
#[derive(Debug)]
pub(super) struct Found<'a> {
    robot: &'a RobotModel,
    /// Way for one count, mm, with its deviation and the reason.
    count: Option<(f64, f64, String)>,
    /// The robot's own idea of that, by its distance packets.
    claimed: Option<f64>,
    turn: Option<FullTurn>,
    response: Option<FittedResponse>,
    law: Option<FittedLaw>,
    light_noise: Option<NoiseLevel>,
}

impl<'a> Found<'a> {
    pub fn of(log: &MotionLog, robot: &'a RobotModel) -> Self {
        let claimed = claimed(log);
        let count = by_tape(log).or_else(|| {
            let mm = claimed.filter(|mm| (mm / model_mm_per_count() - 1.0).abs() > OTHER_WHEELS)?;
            let how = "The figure that the robot itself uses, from its distance packets; not measured.".to_owned();
            Some((mm, 0.01 * mm, how))
        });
        let mm = count.as_ref().map_or(model_mm_per_count(), |(mm, ..)| *mm);
        let turn = turns::measure(log);
        let scaled = RobotModel { counts_per_metre: 1000.0 / mm, ..robot.clone() };
        let light = robot.sensors.light_bumper;
        let law = light.and_then(|light| light::fit(&light::contacts(log, &scaled, &light), &light));
        let light_noise = light::idle(log).map(|(_, level)| level);
        Self { robot, count, claimed, turn, response: wheels::fit(log, robot), law, light_noise }
    }

    /// Whether nothing of the robot's own was found.
    pub fn is_nothing(&self) -> bool {
        self.count.is_none() && self.turn.is_none() && self.response.is_none() && self.law.is_none()
    }

    /// From a command to its effect in the readings, s.
    pub fn delay_s(&self) -> f64 {
        self.response.map_or(0.0, |fitted| fitted.response.delay_s)
    }

    /// The twin's file.
    pub fn file(&self) -> TwinFile {
        let mut figures = vec![self.count_figure(), self.base_figure()];
        figures.extend(self.response_figures());
        let (slip, slip_figure) = self.slip();
        figures.push(slip_figure);
        figures.extend(self.light_figures());
        let value = |index: usize| figures.get(index).filter(|f| f.uncertainty.is_some()).and_then(|f| f.value);
        let twin = Twin {
            mm_per_count: value(0),
            wheel_base_mm: value(1),
            speed_factor: value(2).map(|percent| percent / 100.0),
            acceleration_m_s2: value(3),
            light: self.law.filter(|fitted| fitted.is_better).map(|fitted| LightLaw {
                gain_m2: rounded(fitted.law.gain_m2, 3),
                offset_m: rounded(fitted.law.offset_m, 5),
            }),
        };
        let mut file = TwinFile::new(twin);
        (file.slip, file.light_noise, file.figures) = (slip, self.light_noise, figures);
        file.quantised = self.response.filter(|r| r.is_quantised_known).map(|r| r.response.is_quantised);
        file
    }

    fn mm(&self) -> f64 {
        self.count.as_ref().map_or(model_mm_per_count(), |(mm, ..)| *mm)
    }

    fn count_figure(&self) -> TwinFigure {
        let figure = TwinFigure { model: Some(model_mm_per_count()), ..named("Distance per count", "mm", 4) };
        if let Some((mm, deviation, how)) = &self.count {
            return TwinFigure { value: Some(*mm), uncertainty: Some(*deviation), how: how.clone(), ..figure }
                .rounded();
        }
        let own = match self.claimed {
            Some(mm) => format!(" Its distance packets count on {mm:.3} mm, which is a figure of its program."),
            None => String::new(),
        };
        figure.of_model(format!(
            "The model's: the robot regulates its speed by its own counts, so they don't show how large its wheels \
             are.{own} Let it drive a measured metre: Tools, Calibrate, Metre."
        ))
    }

    fn base_figure(&self) -> TwinFigure {
        let model = 1000.0 * self.robot.wheel_base;
        let figure = TwinFigure { model: Some(model), ..named("Wheel base", "mm", 1) };
        let Some(turn) = self.turn else {
            return figure.of_model(
                "The model's: no full turn was seen. Let it turn on the spot two to five times, a hand's breadth from a \
                 wall or a corner."
                    .to_owned(),
            );
        };
        let base = turn.counts * self.mm() / (2.0 * PI);
        let of_count = self.count.as_ref().map_or(0.0, |(mm, deviation, _)| deviation / mm);
        let deviation = base * (turn.deviation / turn.counts).hypot(of_count);
        let share = 100.0 * (turn.counts / counts_per_turn() - 1.0);
        let [seen, measured] = turn.turns;
        let mut from = Vec::new();
        if seen > 0 {
            from.push(format!("{} after which the light bumper read the same again", counted(seen, "full turn")));
        }
        if measured > 0 {
            from.push(format!("{} that you measured", counted(measured, "turn")));
        }
        let wheels = if self.count.is_some() { "" } else { " It is right for wheels of the model's size." };
        let how =
            format!("From {}: counts per turn differ from the model's by {share:+.1} %.{wheels}", from.join(" and "));
        TwinFigure { value: Some(base), uncertainty: Some(deviation), how, ..figure }.rounded()
    }

    fn response_figures(&self) -> [TwinFigure; 4] {
        let speed = TwinFigure { model: Some(100.0), ..named("Speed for a commanded speed", "%", 2) };
        let acceleration = TwinFigure { model: Some(self.robot.acceleration), ..named("Acceleration", "m/s²", 2) };
        let (delay, noise) = (named("Delay to a command", "ms", 0), named("Scatter of the counts", "counts", 2));
        let noise = TwinFigure { model: Some(ROUNDING), ..noise };
        let Some(fitted) = self.response else {
            let untold = "no command of wheel speeds drove it far enough. Drive it 30 cm or more by hand.";
            return [
                speed.of_model(format!("The model's: {untold}")),
                acceleration.of_model(format!("The model's: {untold}")),
                TwinFigure { how: format!("Not known: {untold}"), ..delay },
                TwinFigure { how: format!("Not known: {untold}"), ..noise },
            ];
        };
        let larger = self.mm() / model_mm_per_count();
        let response = fitted.response;
        let of_count = self.count.as_ref().map_or(0.0, |(mm, deviation, _)| deviation / mm);
        let factor = response.scale * larger;
        let steps = if response.is_quantised { " It keeps only some speeds, in steps of 28.5 mm/s." } else { "" };
        let speed = TwinFigure {
            value: Some(100.0 * factor),
            uncertainty: Some(100.0 * factor * (fitted.scale_deviation / response.scale).hypot(of_count)),
            how: format!(
                "Its wheels count {:.2} % of what commands ask for{}.{steps}",
                100.0 * response.scale,
                if self.count.is_some() { ", times the size of its wheels" } else { "" }
            ),
            ..speed
        };
        let share = fitted.acceleration_deviation / response.acceleration;
        let acceleration = if share < VAGUE {
            TwinFigure {
                value: Some(response.acceleration * factor),
                uncertainty: Some(response.acceleration * factor * share),
                how: "From how the counts rise and fall after commands.".to_owned(),
                ..acceleration
            }
            .rounded()
        } else {
            acceleration.of_model(
                "The model's: the speed never changed fast enough to tell. Start and stop it at half speed or more, a few \
                 times."
                    .to_owned(),
            )
        };
        let delay = TwinFigure {
            value: Some(1000.0 * response.delay_s),
            how: "From a command to its effect in the readings, line included. Not part of the simulated robot."
                .to_owned(),
            ..delay
        };
        let noise = TwinFigure {
            value: Some(fitted.noise_counts),
            how: format!(
                "Root mean square of the difference from the fitted wheels, over stretches of four readings. Rounding \
                 alone gives {ROUNDING}; the simulated encoders add nothing but rounding."
            ),
            ..noise
        };
        [speed.rounded(), acceleration, delay.rounded(), noise.rounded()]
    }

    fn slip(&self) -> (Option<SlipLevel>, TwinFigure) {
        let figure = named("Slip after one metre", "mm", 1);
        let Some((turn, slip_rad)) = self.turn.and_then(|turn| Some((turn, turn.slip_rad?))) else {
            let how = "Not known: it takes at least four full turns beside a wall in one place. The level of slip \
                       stays as set in Explore.";
            return (None, TwinFigure { how: how.to_owned(), ..figure });
        };
        // Of each wheel, whose ways differ in a turn: both err by slip · sqrt(way), and the way is π · base.
        let slip = slip_rad * (turn.counts * self.mm() / 1000.0 / (2.0 * PI) / (2.0 * PI)).sqrt();
        let level = match slip {
            slip if slip < SLIPS[0] => SlipLevel::None,
            slip if slip < SLIPS[1] => SlipLevel::Typical,
            _ => SlipLevel::Harsh,
        };
        let seen = turn.turns[0];
        let share = 1.0 / (2.0 * (seen as f64 - 1.0)).sqrt();
        let how = format!(
            "From how {seen} full turns differ: {:.1}° each. Nearest level: {}. This holds for the floor on which it \
             turned: no sensor shows slip on other floors or straight ahead.",
            slip_rad.to_degrees(),
            level.id()
        );
        let value = 1000.0 * slip;
        let figure = TwinFigure { value: Some(value), uncertainty: Some(value.max(0.3) * share), how, ..figure };
        (Some(level), figure.rounded())
    }

    fn light_figures(&self) -> [TwinFigure; 3] {
        let law = self.robot.sensors.light_bumper.map_or(LightLaw::CREATE_3, |LightBumper { law, .. }| law);
        let gain = TwinFigure { model: Some(law.gain_m2), ..named("Light bumper, gain", "m²", 2) };
        let offset = TwinFigure { model: Some(1000.0 * law.offset_m), ..named("Light bumper, offset", "mm", 1) };
        let how = match self.light_noise {
            Some(level) => format!("Level \"{}\", by the spread of its signals where nothing is near.", level.id()),
            None => "Not known: the readings lack its signals. The level stays as set in Explore.".to_owned(),
        };
        let noise = TwinFigure { how, ..named("Light bumper, noise", "", 0) };
        let Some(fitted) = self.law else {
            let why =
                "The model's: no wall was met head-on. Drive straight at a wall until the bumper touches, three times.";
            return [gain.of_model(why.to_owned()), offset.of_model(why.to_owned()), noise];
        };
        let met = counted(fitted.contacts, "wall");
        if !fitted.is_better {
            let why = format!("The model's, which explains {met} met head-on about as well as any.");
            return [gain.of_model(why.clone()), offset.of_model(why), noise];
        }
        [
            TwinFigure {
                value: Some(fitted.law.gain_m2),
                uncertainty: Some(fitted.gain_deviation),
                how: format!("From {met} met head-on. It includes how much light these walls reflect."),
                ..gain
            }
            .rounded(),
            TwinFigure {
                value: Some(1000.0 * fitted.law.offset_m),
                uncertainty: Some(1000.0 * fitted.offset_deviation),
                how: format!("From {met} met head-on."),
                ..offset
            }
            .rounded(),
            noise,
        ]
    }
}

/// The way for one count, mm, its deviation and a sentence, by metres that a person measured.
fn by_tape(log: &MotionLog) -> Option<(f64, f64, String)> {
    let ways = log.measured.iter().filter_map(|measured| match *measured {
        Measured::Way(counts, metres) => Some((1000.0 * metres / counts, BY_TAPE_M / metres)),
        Measured::Turn(..) => None,
    });
    let ways: Vec<(f64, f64)> = ways.collect();
    let number = ways.len() as f64;
    let mean = ways.iter().map(|(mm, _)| mm).sum::<f64>() / number;
    let tape = ways.iter().map(|(_, share)| share).sum::<f64>() / number;
    let scatter = ways.iter().map(|(mm, _)| (mm - mean).powi(2)).sum::<f64>() / (number - 1.0).max(1.0);
    let deviation = scatter.sqrt().max(tape * mean) / number.sqrt();
    let how = format!("From {} that you measured in the calibration.", counted(ways.len(), "way"));
    (!ways.is_empty()).then_some((mean, deviation, how))
}

/// The robot's own idea of the way for one count, mm. Its reports are cut to whole millimetres, half of one on average.
fn claimed(log: &MotionLog) -> Option<f64> {
    let [mm, reports, counts] = log.claims.distance;
    (reports >= REPORTED.1 && mm / reports >= REPORTED.0).then(|| (mm + 0.5 * reports) / counts)
}

fn named(name: &str, unit: &str, digits: u8) -> TwinFigure {
    TwinFigure {
        name: name.to_owned(),
        value: None,
        uncertainty: None,
        model: None,
        unit: unit.to_owned(),
        digits,
        how: String::new(),
    }
}

fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

fn rounded(value: f64, digits: i32) -> f64 {
    let unit = 10_f64.powi(digits);
    (value * unit).round() / unit
}

trait Shown {
    fn rounded(self) -> Self;
    fn of_model(self, how: String) -> Self;
}

impl Shown for TwinFigure {
    /// With one digit more than is shown: more would suggest more.
    fn rounded(self) -> Self {
        let digits = i32::from(self.digits) + 1;
        let round = |value: Option<f64>| value.map(|value| rounded(value, digits));
        Self { value: round(self.value), uncertainty: round(self.uncertainty), ..self }
    }

    /// The model's value, for this reason.
    fn of_model(self, how: String) -> Self {
        Self { value: self.model, uncertainty: None, how, ..self }
    }
}
