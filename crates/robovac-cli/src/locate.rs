//! `locate`: how well a kidnapped robot relocalises on a known map.

use super::{
    conditions::ConditionsArguments,
    failure::Failure,
    output,
    parallel::{in_parallel, jobs},
    simulate::DEFAULT_ROBOT,
    task::{ParamArguments, PlacementArguments},
};
use robovac_sim::{
    controller,
    experiment::kidnapping::{Kidnapped, Kidnapping, RIGHT_M},
    montecarlo::quantile,
};
use serde::Serialize;
use std::{fmt::Write, time::Instant};

/// Relocalise a kidnapped robot on a known map
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    placement: PlacementArguments,
    /// Driving behaviour, see "robovac behaviours"
    #[arg(long, value_name = "ID", default_value = "wall_follow")]
    behaviour: String,
    #[command(flatten)]
    params: ParamArguments,
    #[command(flatten)]
    conditions: ConditionsArguments,
    /// Number of trials, each with its own pose and seed
    #[arg(long, value_name = "N", default_value_t = 50, value_parser = clap::value_parser!(u64).range(1..=10_000))]
    trials: u64,
    /// Simulated time after kidnapping
    #[arg(long, value_name = "MINUTES", default_value_t = 5.0)]
    minutes: f64,
    /// Write all trials as JSON instead of a summary
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct LocateTrial {
    seed: u64,
    first_s: Option<f64>,
    found_s: Option<f64>,
    deluded_s: f64,
    error_m: Option<f64>,
    error_deg: Option<f64>,
    sure: bool,
}

/// Makes the trials and returns the output.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let placement = arguments.placement.placement(DEFAULT_ROBOT)?;
    let id = arguments.behaviour.as_str();
    let behaviour = controller::find(id).ok_or_else(|| Failure::unknown("behaviour", id, "behaviours"))?;
    let params = arguments.params.checked(behaviour.params)?;
    let prepared = placement.prepare()?;
    let kidnapping = Kidnapping {
        plan: &placement.plan,
        prepared: &prepared,
        robot: &placement.robot,
        behaviour,
        params: &params,
        conditions: arguments.conditions.conditions(),
        odometry: arguments.conditions.odometry,
        duration_s: 60.0 * arguments.minutes.clamp(0.1, 600.0),
    };
    let began = Instant::now();
    let first = arguments.params.seed;
    let seeds: Vec<u64> = (first..first.saturating_add(arguments.trials)).collect();
    let trials = in_parallel(&seeds, jobs(None), |&seed| kidnapping.run(seed));
    let trials: Vec<Kidnapped> = trials.into_iter().flatten().collect();
    let took_s = began.elapsed().as_secs_f64();
    if arguments.json {
        let trials: Vec<LocateTrial> = trials.iter().map(LocateTrial::of).collect();
        return Ok(output::json(&trials));
    }
    let mut text = String::new();
    let found = sorted(trials.iter().filter_map(|t| t.found_s));
    let share = 100.0 * found.len() as f64 / trials.len().max(1) as f64;
    let deluded = trials.iter().filter(|t| t.is_sure && t.found_s.is_none()).count();
    // Writing to a string can't fail.
    let _ = writeln!(
        text,
        "{} of {} relocalised within {} min ({share:.0} %): confident and within {:.0} cm from then on",
        found.len(),
        trials.len(),
        arguments.minutes,
        100.0 * RIGHT_M
    );
    if let Some((half, most)) = quantile(&found, 0.5).zip(quantile(&found, 0.9)) {
        let _ = writeln!(text, "relocalised after {half:.0} s (median), {most:.0} s (90 %)");
    }
    let first = sorted(trials.iter().filter_map(|t| t.first_s));
    if let Some((half, most)) = quantile(&first, 0.5).zip(quantile(&first, 0.9)) {
        let deluded_s: f64 = trials.iter().map(|t| t.deluded_s).sum();
        let _ = writeln!(
            text,
            "{} for the first time after {half:.0} s (median), {most:.0} s (90 %); confident but wrong for {deluded_s:.1} s of all trials",
            first.len(),
        );
    }
    let errors = sorted(trials.iter().filter(|t| t.found_s.is_some()).filter_map(|t| t.error).map(|e| 100.0 * e.0));
    if let Some((half, most)) = quantile(&errors, 0.5).zip(quantile(&errors, 0.9)) {
        let _ = writeln!(text, "final error {half:.1} cm (median), {most:.1} cm (90 %)");
    }
    let unsure = trials.len() - found.len() - deluded;
    let _ = writeln!(text, "at the end: {deluded} confident but wrong, {unsure} uncertain");
    let simulated = trials.len() as f64 * kidnapping.duration_s;
    let _ = writeln!(text, "{:.0} s simulated, {:.0} x real time on all cores", simulated, simulated / took_s);
    Ok(text)
}

fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values
}

impl LocateTrial {
    fn of(trial: &Kidnapped) -> Self {
        Self {
            seed: trial.seed,
            first_s: trial.first_s,
            found_s: trial.found_s,
            deluded_s: trial.deluded_s,
            error_m: trial.error.map(|e| e.0),
            error_deg: trial.error.map(|e| e.1.to_degrees()),
            sure: trial.is_sure,
        }
    }
}
