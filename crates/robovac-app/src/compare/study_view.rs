//! Monte Carlo studies as plain objects.

use super::{MINUTES, SEEDS, Study};
use crate::{
    Mark,
    param::{Param, params},
};
use robovac_core::registry::Params;
use robovac_sim::{Conditions, montecarlo::StudyHeader};
use serde::Serialize;

/// The choices available for a study.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct StudyOffer {
    entrants: Vec<StudyEntrant>,
    seeds: [u32; SEEDS.len()],
    minutes: [u32; MINUTES.len()],
}

#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
struct StudyEntrant {
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

/// Snapshot of a study, one per frame.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct StudyView<'a> {
    version: u32,
    running: bool,
    done: usize,
    total: usize,
    seeds: u32,
    minutes: u32,
    entrants: Vec<StudyEntrantView<'a>>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
struct StudyEntrantView<'a> {
    chosen: bool,
    /// Whether it can take part: the user's program only if there is one of its kind.
    offered: bool,
    params: &'a Params,
    /// Finished runs among the required ones.
    runs: usize,
    failure: &'a str,
}

/// Place and conditions of all runs, in words.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct StudyPlace<'a> {
    room: &'a str,
    robot: &'a str,
    slip: &'static str,
    noise: String,
    quantised: bool,
    start_charge_percent: u8,
}

impl StudyOffer {
    /// All algorithms available in `study`, in the order of the view's list, and the numbers in its menus.
    pub fn new(study: &Study) -> Self {
        let entrants = study.entrants().iter().map(|entrant| {
            let algorithm = entrant.algorithm;
            StudyEntrant {
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

impl<'a> StudyView<'a> {
    /// Choices and progress of `study`.
    pub fn new(study: &'a Study) -> Self {
        let (done, total) = study.count();
        let entrants = study.entrants().iter().enumerate().map(|(index, entrant)| StudyEntrantView {
            chosen: study.is_chosen(index) && study.is_there(index),
            offered: study.is_there(index),
            params: &entrant.params,
            runs: study.runs(index).len(),
            failure: study.failure(index).unwrap_or(""),
        });
        Self {
            version: study.version(),
            running: study.is_running(),
            done,
            total,
            seeds: study.seeds(),
            minutes: study.minutes(),
            entrants: entrants.collect(),
        }
    }
}

impl<'a> StudyPlace<'a> {
    /// The place of `study`'s runs; `None` before it has a room.
    pub fn new(study: &'a Study) -> Option<Self> {
        let (StudyHeader { room, robot, conditions, .. }, _) = study.export()?;
        let (slip, noise) = (conditions.slip.id(), conditions.noise.to_string());
        let Conditions { quantised, start_charge_percent, .. } = conditions;
        Some(Self { room, robot, slip, noise, quantised, start_charge_percent })
    }
}
