//! `--slip`, `--noise`, `--quantised`, `--charge`, `--odometry`: errors of wheels and sensors, and the battery.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use robovac_core::robot::OdometryModel;
use robovac_sim::{Conditions, Noise, NoiseLevel, SensorKind, SlipLevel};

/// Errors of wheels and sensors, and the battery.
#[derive(clap::Args)]
pub struct ConditionsArguments {
    /// Wheel slip: none, typical or harsh [default: none]
    #[arg(long, value_name = "LEVEL", hide_possible_values = true, value_parser = slip_parser())]
    slip: Option<SlipLevel>,
    /// Sensor noise: off, typical or harsh, or for one kind of sensor as in cliff=harsh; can be repeated [default: off]
    #[arg(long, value_name = "LEVEL", value_parser = parse_noise)]
    noise: Vec<(Option<SensorKind>, NoiseLevel)>,
    /// Round wheel speeds to the steps of the robot's motor controller
    #[arg(long)]
    quantised: bool,
    /// Battery charge at the start, percent [default: 100]
    #[arg(long, value_name = "PERCENT", value_parser = clap::value_parser!(u8).range(1..=100))]
    charge: Option<u8>,
    /// How odometry computes the pose from encoder counts
    #[arg(long, value_name = "MODEL", default_value = OdometryModel::Arc.id(), value_parser = odometry_parser())]
    pub odometry: OdometryModel,
}

impl ConditionsArguments {
    /// All of them but odometry.
    pub fn conditions(&self) -> Conditions {
        self.over(Conditions::default())
    }

    /// The same where they were given, and `otherwise`.
    pub fn over(&self, otherwise: Conditions) -> Conditions {
        let mut noise = otherwise.noise;
        for &(kind, level) in &self.noise {
            match kind {
                None => noise = Noise::all(level),
                Some(kind) => noise.set(kind, level),
            }
        }
        let (slip, quantised) = (self.slip.unwrap_or(otherwise.slip), self.quantised || otherwise.quantised);
        let start_charge_percent = self.charge.unwrap_or(otherwise.start_charge_percent);
        Conditions { slip, noise, quantised, start_charge_percent, ..otherwise }
    }
}

fn slip_parser() -> impl TypedValueParser<Value = SlipLevel> {
    let names = SlipLevel::ALL.map(|(_, name)| name);
    PossibleValuesParser::new(names).map(|name| SlipLevel::parse(&name).unwrap_or_default())
}

fn odometry_parser() -> impl TypedValueParser<Value = OdometryModel> {
    let names = OdometryModel::ALL.map(|(_, name)| name);
    PossibleValuesParser::new(names).map(|name| OdometryModel::parse(&name).unwrap_or_default())
}

fn parse_noise(text: &str) -> Result<(Option<SensorKind>, NoiseLevel), String> {
    let (kind, level) = text.split_once('=').map_or((None, text), |(kind, level)| (Some(kind), level));
    let known = |names: Vec<&str>| names.join(", ");
    let kind = kind.map(|name| {
        let all = || known(SensorKind::ALL.map(|(_, name)| name).to_vec());
        SensorKind::parse(name).ok_or_else(|| format!("there is no kind of sensor \"{name}\"; there are: {}", all()))
    });
    let all = || known(NoiseLevel::ALL.map(|(_, name)| name).to_vec());
    let level = NoiseLevel::parse(level).ok_or_else(|| format!("there is no level \"{level}\"; there are: {}", all()));
    Ok((kind.transpose()?, level?))
}
