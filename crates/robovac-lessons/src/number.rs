//! Numbers of a run that goals and measurements are about, in the units of the page.

use robovac_sim::montecarlo::RunOutcome;
use serde::Serialize;

/// A number of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Number {
    /// Swept share of the reachable floor at the end, %.
    Coverage,
    /// Simulated time until the run ended by itself or by its limit, min.
    Time,
    /// Time to 90 % of the floor, min; none if the run didn't get there.
    TimeTo90,
    /// Time to 99 % of the floor, min; none if the run didn't get there.
    TimeTo99,
    /// Distance driven, m.
    Distance,
    /// How often the bumper was pressed.
    Bumps,
    /// Falls down a drop-off.
    Falls,
    /// Share of the dirt that is left, %; none in rooms without dirt.
    DirtLeft,
    /// Distance above the least for the floor that was swept, %.
    ExcessDistance,
    /// Time above the least for the floor that was swept, %.
    ExcessTime,
}

impl Number {
    /// All of them.
    pub const ALL: [Self; 10] = [
        Self::Coverage,
        Self::Time,
        Self::TimeTo90,
        Self::TimeTo99,
        Self::Distance,
        Self::Bumps,
        Self::Falls,
        Self::DirtLeft,
        Self::ExcessDistance,
        Self::ExcessTime,
    ];

    /// Its name in lessons.
    pub fn id(self) -> &'static str {
        match self {
            Self::Coverage => "coverage",
            Self::Time => "time",
            Self::TimeTo90 => "time to 90 %",
            Self::TimeTo99 => "time to 99 %",
            Self::Distance => "distance",
            Self::Bumps => "bumps",
            Self::Falls => "falls",
            Self::DirtLeft => "dirt left",
            Self::ExcessDistance => "excess distance",
            Self::ExcessTime => "excess time",
        }
    }

    /// Its unit; empty for counts.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Coverage | Self::DirtLeft | Self::ExcessDistance | Self::ExcessTime => "%",
            Self::Time | Self::TimeTo90 | Self::TimeTo99 => "min",
            Self::Distance => "m",
            Self::Bumps | Self::Falls => "",
        }
    }

    /// The number with that name.
    pub fn parse(text: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|number| number.id() == text)
    }

    /// All names, for messages.
    pub fn names() -> String {
        Self::ALL.map(Self::id).join(", ")
    }

    /// Its value in a run; `None` if the run has none.
    pub fn of(self, run: &RunOutcome) -> Option<f64> {
        let minutes = |seconds: f64| Some(seconds / 60.0).filter(|minutes| minutes.is_finite());
        match self {
            Self::Coverage => Some(100.0 * run.coverage()),
            Self::Time => minutes(run.time_s),
            Self::TimeTo90 => minutes(run.reached_s[0]),
            Self::TimeTo99 => minutes(run.reached_s[1]),
            Self::Distance => Some(run.distance_m),
            Self::Bumps => Some(f64::from(run.bumps)),
            Self::Falls => Some(f64::from(run.falls)),
            Self::DirtLeft => run.dirt_left.map(|share| 100.0 * share),
            Self::ExcessDistance => run.excess.map(|[metres, _]| 100.0 * metres),
            Self::ExcessTime => run.excess.map(|[_, seconds]| 100.0 * seconds),
        }
    }
}
