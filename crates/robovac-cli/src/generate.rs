//! `generate`: a furnished flat from a seed.

use super::{convert::Output, failure::Failure};
use robovac_core::{
    coverage::with_objects,
    floor_plan::{
        OccupancyMode,
        generate::{FlatSpec, FlatSpecError, generate_flat},
        to_ascii,
    },
};
use std::path::PathBuf;

/// Generate a furnished flat: as a picture of # and ., or in a file as "convert" writes it
#[derive(clap::Args)]
pub struct Arguments {
    /// Seed of the flat; the same seed gives the same flat
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Area between the outer walls in m², from 25 to 120: a number, or the least and the greatest as in 60..80
    #[arg(long, value_name = "AREA", value_parser = parse_area, allow_hyphen_values = true)]
    area: Option<[f64; 2]>,
    /// Amount of furniture, from 0 (empty) to 1 (crammed)
    #[arg(long, value_name = "SHARE", default_value_t = FlatSpec::default().furniture, allow_hyphen_values = true)]
    furniture: f64,
    /// Leave rugs out
    #[arg(long)]
    no_rugs: bool,
    /// Output file: a scenario with all objects (.json), or text, ROS map or drawing as for "convert"
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

/// Writes the flat, or returns its picture.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let default = FlatSpec::default();
    let area_m2 = arguments.area.unwrap_or(default.area_m2);
    let spec = FlatSpec { area_m2, furniture: arguments.furniture, rugs: !arguments.no_rugs };
    spec.check()?;
    let out = arguments.out.as_deref().map(Output::of).transpose()?;
    let plan = generate_flat(arguments.seed, &spec);
    match out {
        Some(out) => out.write(&plan, OccupancyMode::default(), false).map(|()| String::new()),
        None => Ok(to_ascii(&with_objects(&plan))),
    }
}

fn parse_area(text: &str) -> Result<[f64; 2], String> {
    let (low, high) = text.split_once("..").unwrap_or((text, text));
    let area = low.trim().parse().and_then(|low| Ok([low, high.trim().parse()?]));
    area.map_err(|_| "give an area in m² as in 70, or the least and the greatest as in 60..80".to_owned())
}

impl From<FlatSpecError> for Failure {
    fn from(error: FlatSpecError) -> Self {
        Self::usage(error.to_string())
    }
}
