//! Many runs as plain objects.

use super::{MINUTES, ManyRuns, SEEDS};
use crate::{
    Mark,
    param::{Param, params},
};
use robovac_core::registry::Params;
use robovac_sim::{Conditions, montecarlo::RunsHeader};
use serde::Serialize;

/// The choices available for many runs.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct ManyRunsOffer {
    entrants: Vec<ManyRunsEntrant>,
    seeds: [u32; SEEDS.len()],
    minutes: [u32; MINUTES.len()],
}

#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
struct ManyRunsEntrant {
    id: &'static str,
    title: &'static str,
    summary: &'static str,
    /// `planner` or `behaviour`.
    #[cfg_attr(feature = "types", ts(type = "\"planner\" | \"behaviour\""))]
    kind: &'static str,
    /// Whether it is measured by the boundary that it has met rather than by clean floor.
    explores: bool,
    mark: Mark,
    params: Vec<Param>,
}

/// Snapshot of many runs, one per frame.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct ManyRunsView<'a> {
    version: u32,
    running: bool,
    done: usize,
    total: usize,
    seeds: u32,
    minutes: u32,
    entrants: Vec<ManyRunsEntrantView<'a>>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
struct ManyRunsEntrantView<'a> {
    /// That of the user's program has its name.
    title: String,
    chosen: bool,
    /// Whether it can take part: the user's program only if there is one of its kind.
    offered: bool,
    /// What the robot lacks for it; it then doesn't take part.
    lacks: &'static str,
    params: &'a Params,
    /// Finished runs among the required ones.
    runs: usize,
    failure: &'a str,
}

/// Place and conditions of all runs, in words.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct ManyRunsPlace<'a> {
    room: &'a str,
    robot: &'a str,
    slip: &'static str,
    noise: String,
    quantised: bool,
    start_charge_percent: u8,
}

impl ManyRunsOffer {
    /// All algorithms available in `many`, in the order of the view's list, and the numbers in its menus.
    pub fn new(many: &ManyRuns) -> Self {
        let entrants = many.entrants().iter().map(|entrant| {
            let algorithm = entrant.algorithm;
            ManyRunsEntrant {
                id: algorithm.id(),
                title: algorithm.title(),
                summary: algorithm
                    .planner()
                    .map_or_else(|| algorithm.behaviour().map_or("", |info| info.summary), |info| info.summary),
                kind: algorithm.kind(),
                explores: entrant.explores(),
                mark: Mark::of(algorithm),
                params: params(algorithm.params()),
            }
        });
        Self { entrants: entrants.collect(), seeds: SEEDS, minutes: MINUTES }
    }
}

impl<'a> ManyRunsView<'a> {
    /// Choices and progress of `many`.
    pub fn new(many: &'a ManyRuns) -> Self {
        let (done, total) = many.count();
        let entrants = many.entrants().iter().enumerate().map(|(index, entrant)| ManyRunsEntrantView {
            title: many.title(entrant),
            chosen: many.is_chosen(index) && many.is_there(index) && many.lacks(index).is_empty(),
            offered: many.is_there(index),
            lacks: many.lacks(index),
            params: &entrant.params,
            runs: many.runs(index).len(),
            failure: many.failure(index).unwrap_or(""),
        });
        Self {
            version: many.version(),
            running: many.is_running(),
            done,
            total,
            seeds: many.seeds(),
            minutes: many.minutes(),
            entrants: entrants.collect(),
        }
    }
}

impl<'a> ManyRunsPlace<'a> {
    /// The place of `many`; `None` before it has a room.
    pub fn new(many: &'a ManyRuns) -> Option<Self> {
        let (RunsHeader { room, conditions, .. }, _) = many.export()?;
        let robot = many.robot()?.title;
        let (slip, noise) = (conditions.slip.id(), conditions.noise.to_string());
        let Conditions { quantised, start_charge_percent, .. } = conditions;
        Some(Self { room, robot, slip, noise, quantised, start_charge_percent })
    }
}
