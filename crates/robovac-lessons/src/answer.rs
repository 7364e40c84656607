//! What a learner hands in: settings, the numbers of the runs, and their digests.

use robovac_core::program::Program;
use robovac_sim::montecarlo::RunOutcome;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Version of the format.
const VERSION: u32 = 1;

/// An answer file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Answer {
    /// Version of the format; 1.
    pub robovac_answer: u32,
    /// Id of the lesson.
    pub lesson: String,
    /// [`digest`] of the lesson's text; empty if unknown.
    #[serde(default)]
    pub lesson_digest: String,
    /// Who hands it in; can be empty.
    #[serde(default)]
    pub name: String,
    /// Answers to goals, by the ids of these.
    #[serde(default)]
    pub goals: BTreeMap<String, GoalAnswer>,
    /// Answers to quizzes, by the ids of these.
    #[serde(default)]
    pub quizzes: BTreeMap<String, QuizAnswer>,
    /// Predictions, by the ids of these: the number of the option, from 0.
    #[serde(default)]
    pub predictions: BTreeMap<String, u32>,
}

/// The answer to a goal.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct GoalAnswer {
    /// The settings, as in links.
    pub link: String,
    /// The program, if the settings say that one drives or plans.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "types", ts(optional))]
    pub program: Option<Program>,
    /// The runs that the page made; grading makes them again.
    #[serde(default)]
    pub runs: Vec<RunRecord>,
}

/// The answers to the questions of a quiz.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct QuizAnswer {
    /// Seed and text of each answer.
    pub answers: Vec<(u32, String)>,
}

/// A run in an answer.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct RunRecord {
    /// Its seed.
    pub seed: u64,
    /// Swept share of the reachable floor, %.
    pub coverage_percent: f64,
    /// Simulated time, s.
    pub time_s: f64,
    /// Distance driven, m.
    pub distance_m: f64,
    /// Digest of its final state, hexadecimal.
    pub digest: String,
}

impl RunRecord {
    /// The record of an outcome.
    pub fn of(run: &RunOutcome) -> Self {
        Self {
            seed: run.seed,
            coverage_percent: 100.0 * run.coverage(),
            time_s: run.time_s,
            distance_m: run.distance_m,
            digest: format!("{:016x}", run.digest),
        }
    }
}

impl Answer {
    /// Reads an answer file. Errors are for users.
    pub fn parse(text: &str) -> Result<Self, String> {
        let answer: Self = serde_json::from_str(text)
            .map_err(|error| format!("it isn't an answer file: {error}; hand in the file that \"Hand in\" saves"))?;
        if answer.robovac_answer == VERSION {
            Ok(answer)
        } else {
            Err(format!("it has version {} of the format; this program reads version {VERSION}", answer.robovac_answer))
        }
    }
}

/// Digest of a lesson's text, hexadecimal: FNV-1a of 64 bits. It shows that a lesson was changed, and protects nothing.
pub fn digest(text: &str) -> String {
    let hash = text
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3));
    format!("{hash:016x}")
}
