//! The list of all metrics in tables of the page, CSV files and the command line.

use super::{DriveMetrics, MetricExcess, SweepBound, WalkMetrics};
use crate::bounds::{Bounds, TURN_STEPS};
use serde::{Deserialize, Serialize};

/// All measurements of a plan.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PlanNumbers {
    /// Numbers of the walk on the planning grid; `None` for a path in metres.
    pub walk: Option<WalkMetrics>,
    /// Numbers of the line that the robot drives.
    pub drive: DriveMetrics,
    /// Planning time, s.
    pub planning_s: f64,
    /// Lower bounds of the job, if they have been computed.
    pub bounds: Option<Bounds>,
    /// The line above the bounds of any path, if that has been computed and the tool is a disc.
    pub excess: Option<MetricExcess>,
    /// Bounds of any path that sweeps 99 % of the floor, in the same cases.
    pub least: Option<SweepBound>,
}

/// Which values of a metric are better.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Better {
    /// Lower values.
    Lower,
    /// Higher values.
    Higher,
}

/// How values are rounded to the shown digits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum RoundingMode {
    /// Down, so that only all of a whole is 100 %.
    Down,
    /// To the nearest.
    Nearest,
    /// Up, so that only nothing is 0.
    Up,
}

/// A column of a table of plans.
#[derive(Debug, Clone, Copy, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct MetricInfo {
    /// Name in files and on the command line.
    pub id: &'static str,
    /// Name in tables.
    pub label: &'static str,
    /// Unit of the value; empty for counts.
    pub unit: &'static str,
    /// Definition, in one or two sentences.
    pub definition: &'static str,
    /// Which values are better.
    pub better: Better,
    /// Digits shown after the decimal point.
    pub decimals: u8,
    /// How the value is rounded to them.
    pub rounding: RoundingMode,
    #[serde(skip)]
    value: fn(&PlanNumbers) -> Option<f64>,
}

impl MetricInfo {
    /// Its value in `numbers`, in its unit; `None` if it hasn't been computed, or isn't defined for a path in metres.
    pub fn value(&self, numbers: &PlanNumbers) -> Option<f64> {
        (self.value)(numbers)
    }

    /// `value` rounded to the shown digits; differences below them don't count.
    pub fn rounded(&self, value: f64) -> f64 {
        let unit = 10f64.powi(i32::from(self.decimals));
        let scaled = value * unit;
        // What is whole but for an error of computing stays so.
        let whole = match self.rounding {
            RoundingMode::Down => (scaled + ROUNDING_ERROR).floor(),
            RoundingMode::Nearest => scaled.round(),
            RoundingMode::Up => (scaled - ROUNDING_ERROR).ceil(),
        };
        whole / unit
    }
}

/// In the last shown digit.
const ROUNDING_ERROR: f64 = 1e-6;

impl PlanNumbers {
    /// Cost of the walk (steps + 2 x quarter turns) above the lower bound, % of the bound; 0 if no walk is better.
    /// `None` if the bound hasn't been computed, or if the walk misses cells or is none and so isn't subject to it.
    pub fn above_bound_percent(&self) -> Option<f64> {
        let walk = self.walk.filter(WalkMetrics::is_complete)?;
        let (cost, least) = (walk.cost() as f64, self.bounds?.cost as f64);
        Some(if least > 0.0 { 100.0 * (cost - least) / least } else { 0.0 })
    }
}

const fn lower(
    id: &'static str,
    label: &'static str,
    (unit, decimals): (&'static str, u8),
    definition: &'static str,
    value: fn(&PlanNumbers) -> Option<f64>,
) -> MetricInfo {
    MetricInfo { id, label, unit, definition, better: Better::Lower, decimals, rounding: RoundingMode::Nearest, value }
}

/// Every number of a plan, in the order of tables.
pub const METRICS: &[MetricInfo] = &[
    MetricInfo {
        id: "coverage",
        label: "Coverage",
        unit: "%",
        definition: "Swept share of the floor that the robot's tool can reach from the start.",
        better: Better::Higher,
        decimals: 1,
        rounding: RoundingMode::Down,
        value: |n| Some(100.0 * n.drive.coverage),
    },
    MetricInfo {
        rounding: RoundingMode::Up,
        ..lower(
            "above_minimum",
            "Above the minimum",
            ("%", 1),
            "Excess of steps + 2 × quarter turns over a proven lower bound for all walks over these cells. 0 means \
             optimal; often no walk reaches the bound.",
            PlanNumbers::above_bound_percent,
        )
    },
    lower("length", "Distance", ("m", 1), "Length of the path that the robot drives.", |n| Some(n.drive.length_m)),
    lower(
        "duration",
        "Time",
        ("s", 0),
        "Driving time from start to standstill, by the robot's speeds and accelerations; it stops for every turn.",
        |n| Some(n.drive.duration_s),
    ),
    MetricInfo {
        rounding: RoundingMode::Up,
        ..lower(
            "excess_length",
            "Excess distance",
            ("%", 1),
            "Excess distance over the proven minimum for sweeping as much floor; known for round tools.",
            |n| Some(100.0 * n.excess?.above[0].max(0.0)),
        )
    },
    MetricInfo {
        rounding: RoundingMode::Up,
        ..lower(
            "excess_time",
            "Excess time",
            ("%", 1),
            "Excess time over the proven minimum for sweeping as much floor; known for round tools.",
            |n| Some(100.0 * n.excess?.above[1].max(0.0)),
        )
    },
    lower(
        "energy",
        "Energy",
        ("Wh", 1),
        "Battery energy used: power while driving straight and while turning, each multiplied by its time.",
        |n| Some(n.drive.energy_wh),
    ),
    lower(
        "turns",
        "Quarter turns",
        ("", 0),
        "Turns by 90° between steps of the walk; a reversal counts as two. The turn before the first step isn't \
         counted.",
        |n| Some(n.walk?.turns as f64),
    ),
    lower(
        "direction_changes",
        "Direction changes",
        ("", 0),
        "Steps of the walk that lead in another direction than the one before. A reversal counts as one, as in Emu & \
         Obaida's thesis.",
        |n| Some(n.walk?.direction_changes as f64),
    ),
    lower(
        "turning",
        "Turned in all",
        ("turns", 1),
        "Sum of all turning angles along the path, including the turn at the start, in full turns of 360°.",
        |n| Some(n.drive.turning_deg / 360.0),
    ),
    lower("steps", "Steps", ("", 0), "Steps of the walk between planning cells.", |n| Some(n.walk?.steps as f64)),
    lower(
        "revisits",
        "Revisits",
        ("", 0),
        "Visits to cells beyond the first visit to each: driving that cleans nothing new.",
        |n| Some(n.walk?.revisits as f64),
    ),
    lower("revisited_cells", "Revisited cells", ("", 0), "Cells visited more than once.", |n| {
        Some(n.walk?.revisited_cells as f64)
    }),
    lower(
        "swept_again",
        "Swept again",
        ("%", 1),
        "Repeated passes, as a share of the floor swept: at 30 %, three tenths of it were swept a second time. A tool \
         wider than a planning cell also overlaps the neighbouring lane.",
        |n| Some(100.0 * n.drive.overlap),
    ),
    lower(
        "area_swept_again",
        "Area swept again",
        ("m²", 2),
        "Floor area swept again after the tool had left it; floor swept three times counts twice.",
        |n| Some(n.drive.overlap_m2),
    ),
    lower("planning", "Planning", ("s", 3), "Computing time of the planner on this machine.", |n| Some(n.planning_s)),
];

// The definition above names the weight.
const _: () = assert!(TURN_STEPS == 2);

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn only_all_is_100_percent_and_only_nothing_is_0() {
        let of = |id: &str| METRICS.iter().find(|metric| metric.id == id).unwrap();
        assert_eq!(
            [0.9999, 0.99951, 1.0 - 1e-12].map(|share| of("coverage").rounded(100.0 * share)),
            [99.9, 99.9, 100.0]
        );
        assert_eq!([0.0001, 1e-9, 5.11].map(|excess| of("above_minimum").rounded(excess)), [0.1, 0.0, 5.2]);
        assert_eq!(of("length").rounded(425.25), 425.3);
    }

    #[test]
    fn entries_are_told_apart_and_explained() {
        let ids: HashSet<_> = METRICS.iter().map(|m| m.id).collect();
        let labels: HashSet<_> = METRICS.iter().map(|m| m.label).collect();
        assert_eq!((ids.len(), labels.len()), (METRICS.len(), METRICS.len()), "two have the same id, or label");
        for metric in METRICS {
            let sentences = metric.definition.matches(['.', '!']).count();
            assert!(
                metric.definition.ends_with('.') && sentences <= 2,
                "{}: `definition` must be one or two sentences; every full stop counts",
                metric.id
            );
        }
    }
}
