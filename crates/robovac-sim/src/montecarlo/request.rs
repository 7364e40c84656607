//! Run requests as plain values for a worker.

use super::{Lab, RunOutcome, Terms};
use crate::experiment::{BEHAVIOUR, Entrant, PLANNER, Settings, plan_of};
use coverage_planners::Observer;
use serde::{Deserialize, Serialize};

/// Runs of one algorithm for a worker.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RunsRequest {
    /// Number of the request.
    pub id: u32,
    /// Id of a built-in room; otherwise see `scenario`.
    pub room: Option<String>,
    /// The room as a scenario file, if it isn't built in.
    pub scenario: Option<String>,
    /// Robot, cell size, start and conditions, as [`Settings::take_link`] reads them, joined by `&`.
    pub settings: String,
    /// Simulated time of each run, s.
    pub duration_s: f64,
    /// Seed of plans.
    pub plan_seed: u64,
    /// Whether it is a behaviour; else a planner.
    pub behaves: bool,
    /// The algorithm with its parameters, as [`Entrant::parse`] reads it.
    pub entrant: String,
    /// The seeds of the runs.
    pub seeds: Vec<u64>,
    /// For a user's program: the job with which it makes its logs or its plan, as bytes.
    #[serde(default)]
    pub job: Option<Vec<u8>>,
    /// Key of everything but entrant and seeds: equal places have the same [`Lab`].
    pub place: String,
}

impl RunsRequest {
    /// The lab for the runs. Errors are for users.
    pub fn lab(&self) -> Result<Lab, String> {
        let plan = plan_of(self.room.as_deref(), self.scenario.as_deref())?;
        let settings = self.settings()?;
        let Settings { conditions, odometry, smooth, start, .. } = settings;
        let terms = Terms { conditions, odometry, smooth, duration_s: self.duration_s, plan_seed: self.plan_seed };
        Lab::new(&plan, &settings.robot_model(), settings.cells(), start, terms).map_err(|e| e.to_string())
    }

    /// Side of the planning cells, m. Errors are for users.
    pub fn cell_size(&self) -> Result<f64, String> {
        Ok(self.settings()?.cell_size)
    }

    fn settings(&self) -> Result<Settings, String> {
        let mut settings = Settings::new();
        for (key, value) in self.settings.split('&').filter_map(|pair| pair.split_once('=')) {
            settings.take_link(key, value).map_err(|e| e.to_string())?;
        }
        Ok(settings)
    }

    /// Makes the runs in `lab`. Errors are for users.
    pub fn run(&self, lab: &Lab, observer: Option<Observer<'_>>) -> Result<Vec<RunOutcome>, String> {
        lab.plan(&self.entrant()?, observer).map_err(|e| e.to_string())?;
        self.seeds.iter().map(|&seed| self.run_one(lab, seed)).collect()
    }

    /// Makes one run, in a lab in which [`RunsRequest::run`] was called for the same entrant. Errors are for users.
    pub fn run_one(&self, lab: &Lab, seed: u64) -> Result<RunOutcome, String> {
        lab.run(&self.entrant()?, seed).ok_or_else(|| "this algorithm can't be run".to_owned())
    }

    fn entrant(&self) -> Result<Entrant, String> {
        let kind = if self.behaves { BEHAVIOUR } else { PLANNER };
        Entrant::parse(kind, &self.entrant).map_err(|e| e.to_string())
    }
}
